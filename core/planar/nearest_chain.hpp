// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/planar/arc.hpp>

/// Not a public header.
namespace seamwright {

/// Points in order, and those that are beside each arc of a chain.
struct PointsOfArcs {
  const std::vector<Eigen::Vector2d>& points;
  std::vector<int> starts;  ///< the first point beside each arc, ascending from 0
  bool closed = false;      ///< the chain ends where and in the direction in which it begins
};

/// The G1 chain of lines and arcs with the least sum of squared distances of the points from the
/// circle or line of their arc. Arcs of curvature 0 stay lines. An open chain begins and ends
/// beside the first and the last point. \param near arcs near it, which need not join. Identities
/// (each has a test of its number):
///   (1) Points of a G1 chain give this chain.
///   (2) Chains near it have no smaller sum.
/// Nothing if an arc vanishes, or no such chain is found. Source: docs/theory/planar.md P9.6.
std::optional<std::vector<PlanarArc>> nearestChain(const PointsOfArcs& sampled,
                                                   const std::vector<PlanarArc>& near);

}  // namespace seamwright
