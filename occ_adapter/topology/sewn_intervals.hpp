// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/topology/common_edge.hpp>

/// Where edges have to be cut so that parts of them can become one; not a public header.
namespace seamwright::occ {

/// The interval of a matched seam as pieces of its two edges.
struct SewnInterval {
  std::size_t seam = 0;
  std::array<int, 2> edges{};
  std::array<int, 2> pieces{};  ///< from 0, in the sense of each edge's curve
  std::array<Places, 2> places{};
  bool reversed() const { return places[1][0] > places[1][1]; }
};

/// Edges cut into pieces, and the pieces that become one.
struct SewnIntervals {
  std::vector<SewnInterval> intervals;
  std::map<int, std::vector<double>> cuts;     ///< by edge: 0, places between, 1
  std::map<std::size_t, std::string> refused;  ///< seams, with the reason
};

/// Places nearer than \p gap_mm to one another, or to an end, are one.
SewnIntervals sewnIntervals(const std::vector<Seam>& seams, const std::vector<std::size_t>& chosen,
                            double gap_mm);

}  // namespace seamwright::occ
