// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Face.hxx>
#include <map>
#include <set>
#include <vector>

#include <seamwright/occ_adapter/repair/repair.hpp>

/// What a repair made of the surface of a face; not a public header.
namespace seamwright::occ {

/// Lines and places where a face is looked at.
struct FaceGrid {
  int lines = 32;   ///< in each direction of the parameters, at least 1
  int places = 6;   ///< along a line in each knot span of the surface after, ...
  int least = 96;   ///< ... and at least so many on a line,
  int most = 1024;  ///< but no more
};

/// Both surfaces over the part of the parameter plane that the face shows: inside the polygons of
/// its paths. Lines are even in the knot spans of the surface after, so that what was inserted is
/// seen; both surfaces are looked at in the same places.
///
/// What is visible is the noise of extrema and inflections, with a twentieth of the variation
/// before.
///
/// \param face with the surface before. \param after in the frame of the shape, with the parameters
/// of the one before.
/// \param visible_per_mm of curvature, see SurfaceTolerance. \param bound_mm what no point moves
/// beyond: that of the poles, in the knots after. Places without a normal, as where a side
/// collapses, have no curvature.
/// \throws Standard_Failure.
SurfaceChange measureChange(const TopoDS_Face& face,
                            const opencascade::handle<Geom_BSplineSurface>& after, double bound_mm,
                            double visible_per_mm, const FaceGrid& grid = {});

/// The total variation of the mean curvature along a line, the mean of all lines, of the surface
/// over the part that the face shows.
/// \throws Standard_Failure.
double variationOf_per_mm(const TopoDS_Face& face,
                          const opencascade::handle<Geom_BSplineSurface>& surface,
                          const FaceGrid& grid = {});

/// By face: what the way of least bending to turn its tangent plane along its treated seams, by
/// their angles, costs in variation of the mean curvature. The turn fades over the mean width of
/// the face beside the seam: its area over the seam's length.
using NeededVariation = std::map<int, double>;
NeededVariation neededVariation(const TopoDS_Shape& shape, const std::vector<SeamResult>& seams,
                                const std::vector<bool>& treated);

/// What can't be seen on a face or is needed: visibleVariation() of the accepted angle over the
/// diagonal of its box, and fairness times what is needed.
double allowedVariation(int number, const TopoDS_Face& face, const ContinuityTolerance& tolerance,
                        const NeededVariation& needed, double fairness);

/// The diagonal of a square with the face's ratio of area to perimeter, at most that of its box: of
/// a strip nearly three times its width. The diagonal of the box where the face can't be
/// integrated.
double sizeOf_mm(const TopoDS_Face& face);

/// How far the points of faces may move, mm, by face.
using MoveLimits = std::map<int, double>;

/// What the user allows; where that is left open, a hundredth of the face's size and twice the
/// largest gap of its treated seams.
/// \param may_move faces, which can be computed with.
MoveLimits moveLimits(const TopoDS_Shape& shape, const std::vector<SeamResult>& seams,
                      const std::set<int>& may_move, const std::vector<bool>& treated,
                      const RepairOptions& options);

/// A face's change, measured and judged. \param after see measureChange(). \throws
/// Standard_Failure.
FaceMove judgedMove(int number, const TopoDS_Face& face,
                    const opencascade::handle<Geom_BSplineSurface>& after, double largest_move_mm,
                    const RepairOptions& options, const NeededVariation& needed);

}  // namespace seamwright::occ
