// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/nearest_chain.hpp>
#include <seamwright/core/planar/point_pieces.hpp>
#include <seamwright/core/planar/tangent_chain.hpp>
#include <seamwright/core/planar/touch_point.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// The vertex so many after the first one, in a circle.
const Vector2d& vertexAt(const SampledPolygon& polygon, int i) {
  const auto n = static_cast<int>(polygon.vertices.size());
  return polygon.vertices[static_cast<std::size_t>((i + n) % n)];
}

/// The lines and circles of the pieces as arcs from midway between the pieces to midway between
/// them; they need not join.
std::vector<PlanarArc> arcsOf(const std::vector<PointPiece>& pieces,
                              const SampledPolygon& polygon) {
  std::vector<PlanarArc> arcs;
  for (const PointPiece& piece : pieces) {
    const bool is_begin = !polygon.closed && &piece == &pieces.front(),
               is_end = !polygon.closed && &piece == &pieces.back();
    const Vector2d &first = vertexAt(polygon, piece.first), &last = vertexAt(polygon, piece.last);
    const Vector2d begin = is_begin ? first : (first + vertexAt(polygon, piece.first - 1)) / 2;
    const Vector2d end = is_end ? last : (last + vertexAt(polygon, piece.last + 1)) / 2;
    const TouchPoint start = piece.circle.beside(begin);
    arcs.push_back(start.arc(lengthBetween(start, start.beside(end))));
  }
  return arcs;
}

/// Arcs that join, with the vertex after the start of each one.
struct VertexArcs {
  std::vector<PlanarArc> arcs;
  std::vector<int> starts;
};

std::optional<VertexArcs> vertexArcs(const std::vector<PointPiece>& pieces,
                                     const SampledPolygon& polygon) {
  std::vector<Vector2d> points;
  VertexArcs result;
  std::vector<int> starts;
  for (const PointPiece& piece : pieces) {
    starts.push_back(static_cast<int>(points.size()));
    result.starts.push_back(piece.first);
    for (int i = piece.first; i <= piece.last; ++i) points.push_back(vertexAt(polygon, i));
  }
  auto arcs = nearestChain({.points = points, .starts = starts, .closed = polygon.closed},
                           arcsOf(pieces, polygon));
  if (!arcs) return std::nullopt;
  result.arcs = *std::move(arcs);
  // The first vertex ahead of the start of an arc.
  for (std::size_t i = polygon.closed ? 0 : 1; i < pieces.size(); ++i) {
    const TouchPoint start = touchPointOf(result.arcs[i]);
    const auto isAhead = [&](int at) {
      return (vertexAt(polygon, at) - start.point).dot(start.tangent()) >= 0;
    };
    int& vertex = result.starts[i];
    const int n = static_cast<int>(points.size());
    const PointPiece& before = pieces[i > 0 ? i - 1 : pieces.size() - 1];
    const int least = (before.first + before.last) / 2 + 1 - (i > 0 ? 0 : n),
              most = (pieces[i].first + pieces[i].last) / 2;
    while (vertex < most && !isAhead(vertex)) ++vertex;
    while (vertex > least && isAhead(vertex - 1)) --vertex;
  }
  return result;
}

/// From the first vertex of the polygon on, beside which an arc is divided. Where it is beside a
/// joint, up to the noise, none is.
PlacedArcs fromFirstVertex(const SampledPolygon& polygon, const VertexArcs& found,
                           double noise_mm) {
  const int n = static_cast<int>(polygon.vertices.size());
  const int m = static_cast<int>(found.arcs.size());
  // The vertices of the polygon at which arcs start, each above the one before.
  const auto startOf = [&](int i) { return found.starts[i % m] + (i / m - 2) * n; };
  int first = 0;
  while (startOf(first) <= 0) ++first;
  const PlanarArc& divided = found.arcs[(first - 1) % m];
  const TouchPoint beside = touchPointOf(divided).beside(polygon.vertices.front());
  const double head_mm = lengthBetween(touchPointOf(divided), beside);
  const double tail_mm = divided.length_mm - head_mm;
  PlacedArcs result;
  const auto append = [&](const PlanarArc& arc, int i) {
    if (!result.arcs.empty()) {
      const double vertex = polygon.begin + startOf(i);
      result.ends.push_back({vertex - 1, vertex});
    }
    result.arcs.push_back(arc);
  };
  if (head_mm <= noise_mm) {
    append(divided, first - 1);
  } else if (tail_mm > noise_mm) {
    append(beside.arc(tail_mm), first - 1);
  }
  for (int i = first; i < first + m - 1; ++i) append(found.arcs[i % m], i);
  if (head_mm > noise_mm) {
    PlanarArc last = divided;
    if (tail_mm > noise_mm) last.length_mm = head_mm;
    append(last, first + m - 1);
  }
  result.ends.push_back({polygon.begin + n, polygon.begin + n});
  return result;
}

/// From beside the first vertex around; nothing if the piece is a line.
std::optional<PlacedArcs> circleOf(const PointPiece& piece, const SampledPolygon& polygon) {
  if (piece.isLine()) return std::nullopt;
  const double length_mm = 2 * std::numbers::pi / std::abs(piece.circle.curvature_per_mm);
  const double end = polygon.begin + static_cast<double>(polygon.vertices.size());
  return PlacedArcs{.arcs = {piece.circle.beside(polygon.vertices.front()).arc(length_mm)},
                    .ends = {{end, end}}};
}

/// Whether the pieces have the vertices they need: three of an arc, two of a line, six of two
/// neighbours. Pieces of a chain that are found in fewer could be of any curve.
bool haveEnoughVertices(const std::vector<PointPiece>& pieces, bool closed) {
  constexpr int of_arc = 3, of_line = 2, of_two = 6;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const int count = pieces[i].count();
    if (count < (pieces[i].isLine() ? of_line : of_arc)) return false;
    if (pieces.size() > 1 && (closed || i + 1 < pieces.size()) &&
        count + pieces[(i + 1) % pieces.size()].count() < of_two)
      return false;
  }
  return true;
}

}  // namespace

std::optional<PlacedArcs> tangentChain(const SampledPolygon& polygon,
                                       const TangentChainOptions& options) {
  // A choice: the work grows with the cube of their number.
  constexpr int most_pieces = 60;
  const int n = static_cast<int>(polygon.vertices.size());
  const std::vector<PointPiece> pieces =
      pointPieces(polygon.vertices, {.closed = polygon.closed,
                                     .noise_mm = options.noise_mm,
                                     .line_mm = options.line_mm,
                                     .fewer_than = std::min(options.fewer_than, most_pieces)});
  if (pieces.empty()) return std::nullopt;
  if (!haveEnoughVertices(pieces, polygon.closed)) return std::nullopt;
  if (polygon.closed && pieces.size() == 1) return circleOf(pieces.front(), polygon);
  const auto found = vertexArcs(pieces, polygon);
  if (!found) return std::nullopt;
  if (polygon.closed) return fromFirstVertex(polygon, *found, options.noise_mm);
  PlacedArcs result{.arcs = found->arcs, .ends = {}};
  for (std::size_t i = 1; i < found->arcs.size(); ++i) {
    const double vertex = polygon.begin + found->starts[i];
    result.ends.push_back({vertex - 1, vertex});
  }
  const double last = polygon.begin + n - 1;
  result.ends.push_back({last, last});
  return result;
}

}  // namespace seamwright
