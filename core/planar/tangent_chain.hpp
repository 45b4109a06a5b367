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
inline constexpr std::array noise_shares = {1e-3, 3e-3, 0.01, 0.03, 0.07, 0.15, 0.3, 0.6, 0.8, 1.0};

/// A polygon whose vertices are to be samples. Vertex i has the parameter begin + i.
struct SampledPolygon {
  std::vector<Eigen::Vector2d> vertices;  ///< of a closed polygon the first one is not repeated
  double begin = 0;
  bool closed = false;
};

struct TangentChainOptions {
  double noise_mm = 0;
  double line_mm = 0;  ///< vertices that are so near to a line, with the noise, are samples of one
  int fewer_than = 0;
};

/// The G1 chain of lines and arcs whose samples the vertices are up to a noise: the vertices are
/// divided into pieces, and of the chains with one line or arc for each piece this one has the
/// least sum of squared distances. A closed chain begins beside the first vertex, so that the arc
/// there is divided if it does not begin or end there. An open one ends beside its first and last
/// vertices. Nothing is said about the distance. Nothing if there are no such pieces, or not fewer
/// than asked for. Source: docs/theory/planar.md P9.6.
std::optional<PlacedArcs> tangentChain(const SampledPolygon& polygon,
                                       const TangentChainOptions& options);

}  // namespace seamwright
