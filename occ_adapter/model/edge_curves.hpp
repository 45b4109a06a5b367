// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

/// Edges that have paths on their faces alone; not a public header.
namespace seamwright::occ {

/// Whether each edge that is not degenerated has a curve in space. OpenCASCADE reads an edge
/// without one where the curve in a file is refused (knots that do not increase, say), and its
/// distances of shapes crash on it.
inline bool allEdgesHaveCurves(const TopoDS_Shape& shape) {
  for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    double first = 0, last = 0;
    if (!BRep_Tool::Degenerated(edge) && BRep_Tool::Curve(edge, first, last).IsNull()) return false;
  }
  return true;
}

}  // namespace seamwright::occ
