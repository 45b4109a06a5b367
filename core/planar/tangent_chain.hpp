// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <seamwright/core/planar/arc_search.hpp>

/// Lines and arcs of which points are samples. Not a public header.
namespace seamwright {

/// Choices: the noise that is tried, as shares of a tolerance. With less noise the joints are known
/// better.
inline constexpr std::array noise_shares = {1e-3, 3e-3, 0.01, 0.03, 0.07, 0.15, 0.3, 0.6};

/// A polygon whose vertices are to be samples. Vertex i has the parameter begin + i.
struct SampledPolygon {
  std::vector<Eigen::Vector2d> vertices;  ///< of a closed polygon the first one is not repeated
  double begin = 0;
  bool closed = false;
};

/// The G1 chain of lines and arcs whose samples the vertices are up to a noise, as of points with
/// few digits: each second piece is the circle or line near its vertices, and the pieces between
/// touch both neighbours. A closed chain begins beside the first vertex, so that the arc there is
/// divided if it does not begin or end there. An open one ends beside its first and last vertices.
/// Nothing is said about the distance. Nothing if there are no such pieces, or not fewer than \p
/// fewer_than. Source: docs/theory/planar.md P9.6.
std::optional<PlacedArcs> tangentChain(const SampledPolygon& polygon, double noise_mm,
                                       int fewer_than);

}  // namespace seamwright
