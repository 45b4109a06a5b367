// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <memory>
#include <set>
#include <vector>

#include <seamwright/occ_adapter/seams/edge_interval.hpp>

namespace seamwright::occ {

/// The paths of the free edges; null for an edge without one.
using EdgePaths = std::vector<std::unique_ptr<EdgePath>>;

struct Settled {
  std::vector<EdgeInterval> intervals;
  std::map<std::size_t, std::set<int>>
      crowded;  ///< paths where three or more faces meet, and these faces
};

/// The intervals that count by the rules of matchFreeEdges(): long enough, and nearer than all
/// rivals.
Settled settleRivals(const std::vector<EdgeInterval>& intervals, const EdgePaths& paths,
                     double match_mm);

}  // namespace seamwright::occ
