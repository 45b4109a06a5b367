// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <vector>

#include <seamwright/occ_adapter/repair/changed_geometry.hpp>

/// Makes the edges of a shape whose surfaces or pcurves changed. Not a public header.
namespace seamwright::occ {

/// An edge with its geometry after a change, in the frame of the shape.
struct ChangedEdge {
  TopoDS_Edge bare;                       ///< new part, without location, orientation and vertices
  std::vector<EdgeSide> sides;            ///< after the change
  opencascade::handle<Geom_Curve> curve;  ///< null for a degenerated edge
  double first = 0, last = 0;
  double tolerance_mm = 0;
  bool moved = false;
};

/// By number: the edges of ChangedGeometry::edges().
/// \param jobs threads; 0: one for each processor.
/// \throws std::invalid_argument if one occurs in the shape several times; GeometryError if a curve
/// can't be built; Standard_Failure.
std::map<int, ChangedEdge> changedEdges(const ChangedGeometry& geometry, int jobs);

}  // namespace seamwright::occ
