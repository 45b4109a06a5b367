// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

/// Edges that have pcurves only. Not a public header.
namespace seamwright::occ {

/// Whether each edge that is not degenerated has a curve in space. OpenCASCADE reads an edge
/// without one if it refuses the curve in a file, for example because its knots do not increase.
/// Its distance of shapes crashes on such an edge.
inline bool allEdgesHaveCurves(const TopoDS_Shape& shape) {
  for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    double first = 0, last = 0;
    if (!BRep_Tool::Degenerated(edge) && BRep_Tool::Curve(edge, first, last).IsNull()) return false;
  }
  return true;
}

}  // namespace seamwright::occ
