// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <vector>

#include <seamwright/occ_adapter/topology/common_edge.hpp>
#include <seamwright/occ_adapter/topology/sew_reasons.hpp>

/// Finds where edges must be cut so that pieces of two edges can become one. Not a public header.
namespace seamwright::occ {

/// The interval of a matched seam as pieces of its two edges.
struct SewnInterval {
  std::size_t seam = 0;
  std::array<int, 2> edges{};
  std::array<int, 2> pieces{};  ///< from 0, in the direction of each edge's curve
  std::array<ParameterRange, 2> ranges{};
  bool reversed() const { return ranges[1][0] > ranges[1][1]; }
};

/// Edges cut into pieces, and the pieces that become one.
struct SewnIntervals {
  std::vector<SewnInterval> intervals;
  /// By edge: parameters of the cuts, from 0 to 1, both included.
  std::map<int, std::vector<double>> cuts;
  SewReasons refused;
};

/// Cuts nearer than \p gap_mm to each other, or to an end of the edge, become one.
SewnIntervals sewnIntervals(const std::vector<Seam>& seams, const std::vector<std::size_t>& chosen,
                            double gap_mm);

}  // namespace seamwright::occ
