// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <vector>

#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

#include "shapes.hpp"

/// Seams of faces that share no edge, and what is measured of them.
namespace seamwright::test {

inline occ::SeamGraph matched(const TopoDS_Shape& shape, double match_mm = 0.01) {
  occ::SeamGraph graph = occ::findSeams(shape);
  occ::matchFreeEdges({.match_mm = match_mm}, graph);
  return graph;
}

inline occ::Report analyzedMatched(const TopoDS_Shape& shape, double match_mm = 0.01) {
  occ::AnalyzeOptions options;
  options.match_mm = match_mm;
  return analyzed(shape, options);
}

/// Of the matched seams, in ascending order.
inline std::vector<double> lengths(const occ::Report& report) {
  std::vector<double> lengths;
  for (const occ::SeamResult& seam : report.seams)
    if (seam.kind == occ::SeamKind::Matched) lengths.push_back(seam.length_mm);
  std::ranges::sort(lengths);
  return lengths;
}

inline double gap(const occ::SeamResult& seam) {
  return seam.figures.gap_mm.value().lower;
}

}  // namespace seamwright::test
