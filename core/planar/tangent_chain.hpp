// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/planar/arc_search.hpp>

/// Lines and arcs of which points are samples. Not a public header.
namespace seamwright {

/// A polygon whose vertices are to be samples. Vertex i has the parameter begin + i.
struct SampledPolygon {
  std::vector<Eigen::Vector2d> vertices;  ///< of a closed polygon the first one is not repeated
  double begin = 0;
  bool closed = false;
};

/// The G1 chain of lines and arcs whose samples the vertices are up to a noise, as of points with
/// few digits: each second piece is the circle or line near its vertices, and the pieces between
/// touch both neighbours. A closed chain begins beside the first vertex, so that the arc there is
/// divided. Nothing is said about the distance. Nothing if there are no such pieces, or not fewer
/// than \p fewer_than. Source: docs/theory/planar.md P9.6.
std::optional<PlacedArcs> tangentChain(const SampledPolygon& polygon, double noise_mm,
                                       int fewer_than);

}  // namespace seamwright
