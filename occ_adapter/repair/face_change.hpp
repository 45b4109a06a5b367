// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Face.hxx>
#include <map>
#include <set>
#include <vector>

#include <seamwright/occ_adapter/repair/repair.hpp>

/// Measures how a repair changed the surface of a face. Not a public header.
namespace seamwright::occ {

/// Lines and sample points on which a face is measured.
struct FaceGrid {
  int lines = 32;            ///< in each direction of the parameters, at least 1
  int samples_per_span = 6;  ///< on a line, in each knot span of the new surface, ...
  int least = 96;            ///< ... at least this many on a line,
  int most = 1024;           ///< ... and at most this many
};

/// Measures both surfaces over the part of the parameter plane that the face shows: inside the
/// polygons of its pcurves. The lines are equally spaced in the knot spans of the new surface, so
/// that inserted knots are seen. Both surfaces are sampled at the same parameters.
///
/// Extrema and inflections count beyond a noise: the visible curvature plus a twentieth of the
/// variation before.
///
/// \param face with the surface before.
/// \param after new surface, in the frame of the shape, with the parameters of the surface before.
/// \param visible_per_mm visible curvature, see SurfaceTolerance.
/// \param bound_mm upper bound of the move of any point: the largest move of a pole, in the new
/// knots. Points without a normal, as where a side collapses, have no curvature.
/// \throws Standard_Failure.
SurfaceChange measureChange(const TopoDS_Face& face,
                            const opencascade::handle<Geom_BSplineSurface>& after, double bound_mm,
                            double visible_per_mm, const FaceGrid& grid = {});

/// The total variation of the mean curvature along a line, averaged over all lines, on the part of
/// the surface that the face shows.
/// \throws Standard_Failure.
double variationOf_per_mm(const TopoDS_Face& face,
                          const opencascade::handle<Geom_BSplineSurface>& surface,
                          const FaceGrid& grid = {});

/// By face: the variation of the mean curvature that it needs to turn its tangent plane along its
/// treated seams by their angles, with least bending. The turn fades over the mean width of the
/// face beside the seam: its area divided by the seam's length; or over a given depth between half
/// of that width and all of it. With \p to_curvature it also needs the largest difference of the
/// curvatures along those seams.
/// Source: docs/theory/repair.md R1 and R5.
using NeededVariation = std::map<int, double>;
NeededVariation neededVariation(const TopoDS_Shape& shape, const std::vector<SeamResult>& seams,
                                const std::vector<bool>& treated,
                                std::optional<double> depth_mm = std::nullopt,
                                bool to_curvature = false);

/// The variation that is invisible on a face or that it needs: visibleVariation() of the accepted
/// angle over the diagonal of the face's box, plus fairness times the needed variation.
double allowedVariation(int number, const TopoDS_Face& face, const ContinuityTolerance& tolerance,
                        const NeededVariation& needed, double fairness);

/// The diagonal of a square with the face's ratio of area to perimeter, at most the diagonal of the
/// face's box. For a strip this is nearly three times its width. Where the face can't be integrated
/// it is the diagonal of the box.
double sizeOf_mm(const TopoDS_Face& face);

/// By face: how far its points may move, in mm.
using MoveLimits = std::map<int, double>;

/// The limit that the user gives. Without one it is a hundredth of the face's size plus twice the
/// largest gap of its treated seams.
/// \param may_move numbers of faces that can be computed with.
MoveLimits moveLimits(const TopoDS_Shape& shape, const std::vector<SeamResult>& seams,
                      const std::set<int>& may_move, const std::vector<bool>& treated,
                      const RepairOptions& options);

/// Measures and judges the change of a face. \param after see measureChange().
/// \throws Standard_Failure.
FaceMove judgedMove(int number, const TopoDS_Face& face,
                    const opencascade::handle<Geom_BSplineSurface>& after, double largest_move_mm,
                    const RepairOptions& options, const NeededVariation& needed);

}  // namespace seamwright::occ
