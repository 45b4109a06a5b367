// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <memory>
#include <set>
#include <vector>

#include <seamwright/occ_adapter/seams/edge_interval.hpp>

namespace seamwright::occ {

/// The paths of the free edges; empty where there is none.
using EdgePaths = std::vector<std::unique_ptr<EdgePath>>;

struct Settled {
  std::vector<EdgeInterval> intervals;
  std::map<std::size_t, std::set<int>>
      crowded;  ///< paths where three or more faces meet, and these faces
};

/// The intervals that are long enough and not contested, or won; for the rules see
/// matchFreeEdges().
Settled settleRivals(const std::vector<EdgeInterval>& intervals, const EdgePaths& paths,
                     double match_mm);

}  // namespace seamwright::occ
