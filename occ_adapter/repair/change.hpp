// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

/// Faces of a shape with other surfaces; not a public header.
namespace seamwright::occ {

/// A face's new surface, in the frame of the shape (locations applied), with the parameters of the
/// old one.
struct FaceChange {
  int face = 0;  ///< from 1, order of TopExp::MapShapes
  opencascade::handle<Geom_Surface> surface;
  double largest_move_mm = 0;  ///< no point of the face moves further
};

/// Another path of an edge in the parameter plane of a face; from end to end of the old one over
/// the same range.
struct PathChange {
  int edge = 0;  ///< from 1, order of TopExp::MapShapes
  int face = 0;
  opencascade::handle<Geom2d_Curve> path;
  double largest_move_mm = 0;  ///< of a point of the edge
};

/// A copy of the shape in which these faces have their new surfaces: the same faces, edges,
/// vertices in the same order, orientations and locations; what does not depend on a changed face
/// is shared with the given shape. Edges keep their paths in the parameter planes but for those
/// given; their curves in space are made again where a face beside them or a path changed, halfway
/// between both sides; vertices are put where their edges end; tolerances are what is measured, and
/// not below those they had where nothing moved (by more than a thousandth of \p gap_mm). Parts
/// that stand in one part of an assembly several times become parts of their own: withOwnParts().
/// \param jobs threads; 0: one for each processor.
/// \throws std::invalid_argument for a face number that the shape does not have or that is given
/// twice, and for a face, edge or vertex that still stands in the shape more than once (of a part
/// with several instances); std::runtime_error where a curve can't be built; Standard_Failure.
TopoDS_Shape withChanges(const TopoDS_Shape& shape, const std::vector<FaceChange>& changes,
                         double gap_mm, const std::vector<PathChange>& paths = {}, int jobs = 1);

}  // namespace seamwright::occ
