// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

/// Replaces surfaces of a shape's faces. Not a public header.
namespace seamwright::occ {

/// A new surface of a face. It is given in the frame of the shape (locations applied) and has the
/// parameters of the old surface.
struct FaceChange {
  int face = 0;  ///< from 1, in the order of TopExp::MapShapes
  opencascade::handle<Geom_Surface> surface;
  double largest_move_mm = 0;  ///< no point of the face moves further
};

/// A new pcurve of an edge on a face. It has the ends and the range of the old pcurve.
struct PathChange {
  int edge = 0;  ///< from 1, in the order of TopExp::MapShapes
  int face = 0;
  opencascade::handle<Geom2d_Curve> path;
  double largest_move_mm = 0;  ///< largest move of a point of the edge
};

/// Copies the shape and gives these faces their new surfaces. The copy has the same faces, edges
/// and vertices in the same order, with the same orientations and locations. Parts that do not
/// depend on a changed face are shared with the given shape.
///
/// Edges keep their pcurves, except those in \p paths. The curve in space of an edge is rebuilt
/// where a face beside the edge or a pcurve changed. It runs halfway between both sides. Vertices
/// move to where their edges end. Tolerances are the distances as measured. Where nothing moved by
/// more than a thousandth of \p gap_mm, a tolerance is not below its old value. A face, edge or
/// vertex that one part of an assembly contains several times becomes several parts:
/// withOwnParts().
/// \param jobs threads; 0: one for each processor.
/// \throws std::invalid_argument if a face number is not in the shape or is given twice, or if a
/// face, edge or vertex still occurs in the shape more than once (in a part with several
/// instances); GeometryError if a curve can't be built; Standard_Failure.
TopoDS_Shape withChanges(const TopoDS_Shape& shape, const std::vector<FaceChange>& changes,
                         double gap_mm, const std::vector<PathChange>& paths = {}, int jobs = 1);

}  // namespace seamwright::occ
