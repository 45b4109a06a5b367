// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/free_arcs.hpp>
#include <seamwright/core/planar/tangent_chain.hpp>
#include <seamwright/core/planar/touch_point.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// Vertices of one circle or line.
struct TangentPiece {
  int first = 0, last = 0;
  int middle() const { return (first + last) / 2; }
};

/// The vertices from one on, in a circle if they are closed, and their pieces.
class ChainOfPieces {
 public:
  ChainOfPieces(const SampledPolygon& polygon, double noise_mm)
      : closed_(polygon.closed), noise_mm_(noise_mm) {
    points_ = polygon.vertices;
    if (closed_) {
      // From the end of a piece on, so that the first piece is whole.
      offset_ = freeArcEnds(points_, noise_mm).front() % count();
      std::rotate(points_.begin(), points_.begin() + offset_, points_.end());
      points_.push_back(points_.front());
    }
    int first = 0;
    for (const int end : freeArcEnds(points_, noise_mm)) {
      pieces_.push_back({.first = first, .last = end});
      first = end;
    }
    // Pieces reach beyond their ends as far as the noise allows. So the last one can be what the
    // piece before it did not reach; then their number is odd, and each second one has no partner.
    if (closed_ && pieces_.size() > 1 && pieces_.size() % 2 != 0) {
      pieces_.pop_back();
      pieces_.back().last = first;
    }
  }

  const std::vector<TangentPiece>& pieces() const { return pieces_; }
  const std::vector<Vector2d>& points() const { return points_; }
  int offset() const { return offset_; }

  TouchPoint nearCircle(const TangentPiece& piece) const {
    // Pieces reach beyond their ends as far as the noise allows.
    const int margin = (piece.last - piece.first) / 8;
    const std::vector<Vector2d> inside(points_.begin() + piece.first + margin,
                                       points_.begin() + piece.last + 1 - margin);
    const int middle = piece.middle();
    if (const auto line = lineBeside(inside, points_[middle])) return *line;
    const ArcStart found = nearestCircle(inside, points_[middle]);
    TouchPoint circle{.point = found.point,
                      .direction_rad = found.direction_rad,
                      .curvature_per_mm = found.curvature_per_mm};
    if (unitVector(circle.direction_rad).dot(points_[middle + 1] - points_[middle - 1]) < 0) {
      circle.direction_rad += std::numbers::pi;
      circle.curvature_per_mm = -circle.curvature_per_mm;
    }
    return circle;
  }

  /// Whether the vertices are near a line.
  bool isLine(const TangentPiece& piece) const {
    const std::vector<Vector2d> all(points_.begin() + piece.first,
                                    points_.begin() + piece.last + 1);
    return lineBeside(all, all.front()).has_value();
  }

  /// The circle between two others that is nearest to the vertices of a piece.
  TouchPoint between(const TouchPoint& from, const TangentPiece& piece,
                     const TouchPoint& to) const {
    const TouchPoint start = from.beside(points_[piece.first]);
    return nearest(piece, [&](double u) { return touching(start.after(u), to); });
  }

  /// The circle that touches its neighbour and ends beside the first or last vertex of its piece,
  /// nearest to the vertices; a line if these are near one.
  TouchPoint atEnd(const TangentPiece& piece, const TouchPoint& neighbour, bool at_begin) const {
    const Vector2d& end = points_[at_begin ? piece.first : piece.last];
    const TouchPoint start = neighbour.beside(points_[at_begin ? piece.last : piece.first]);
    const bool is_line = isLine(piece);
    return nearest(piece, [&](double u) {
      TouchPoint circle = start.after(u);
      circle.curvature_per_mm = 0;
      if (is_line) return circle;
      const Vector2d away = end - circle.point;
      circle.curvature_per_mm = 2 * away.dot(circle.normal()) / away.squaredNorm();
      return circle;
    });
  }

 private:
  /// The candidate nearest to the vertices of a piece, of those that leave a neighbour beside an
  /// end of the piece or some way from there.
  template <typename Candidate>
  TouchPoint nearest(const TangentPiece& piece, const Candidate& candidate) const {
    const double reach_mm = (points_[piece.last] - points_[piece.first]).norm() / 2;
    const auto off_mm = [&](double u) {
      const TouchPoint circle = candidate(u);
      double largest = 0;
      constexpr int looks = 16;
      const int length = piece.last - piece.first;
      for (int k = 2; k <= looks - 2; ++k)
        largest = std::max(largest,
                           std::abs(circle.distance_mm(points_[piece.first + length * k / looks])));
      return largest;
    };
    // The distance has one minimum near the true joint; a grid finds its basin, thirds narrow it.
    constexpr int grid = 32, narrowings = 80;
    double best = 0, best_mm = infinite;
    for (int k = -grid; k <= grid; ++k)
      if (const double u = reach_mm * k / grid; off_mm(u) < best_mm) {
        best = u;
        best_mm = off_mm(u);
      }
    double low = best - reach_mm / grid, high = best + reach_mm / grid;
    for (int i = 0; i < narrowings; ++i) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      (off_mm(a) < off_mm(b) ? high : low) = off_mm(a) < off_mm(b) ? b : a;
    }
    return candidate((low + high) / 2);
  }

  /// The line along the chord of points, next to another one; nothing if they are not near it.
  std::optional<TouchPoint> lineBeside(const std::vector<Vector2d>& points,
                                       const Vector2d& beside) const {
    TouchPoint line{.point = beside, .direction_rad = directionOf(points.back() - points.front())};
    const Vector2d normal = line.normal();
    double low_mm = 0, high_mm = 0;
    for (const Vector2d& point : points) {
      low_mm = std::min(low_mm, normal.dot(point - points.front()));
      high_mm = std::max(high_mm, normal.dot(point - points.front()));
    }
    // Each point of the piece, also its ends, can be off by the noise to both sides.
    if (high_mm - low_mm > 4 * noise_mm_) return std::nullopt;
    line.point -= normal * (normal.dot(beside - points.front()) - (low_mm + high_mm) / 2);
    return line;
  }

  int count() const { return static_cast<int>(points_.size()); }

  bool closed_;
  double noise_mm_;
  int offset_ = 0;
  std::vector<Vector2d> points_;
  std::vector<TangentPiece> pieces_;
};

/// The arcs of pieces with the vertex after the start of each one.
struct VertexArcs {
  std::vector<PlanarArc> arcs;
  std::vector<int> starts;
};

/// The first vertex from \p vertex on, and before \p end, that lies ahead of a point.
int vertexAhead(const ChainOfPieces& chain, const TouchPoint& from, int vertex, int end) {
  const int n = static_cast<int>(chain.points().size()) - 1;
  const auto isAhead = [&](int at) {
    return (chain.points()[(at + n) % n] - from.point).dot(from.tangent()) >= 0;
  };
  while (vertex < end && !isAhead(vertex)) ++vertex;
  return vertex;
}

/// The arcs of a closed chain, from the piece \p fixed on.
std::optional<VertexArcs> closedArcs(const ChainOfPieces& chain, int fixed) {
  const std::vector<TangentPiece>& pieces = chain.pieces();
  const int m = static_cast<int>(pieces.size());
  std::vector<TouchPoint> circles(m), joints(m + 1);
  for (int i = fixed; i < m; i += 2) circles[i] = chain.nearCircle(pieces[i]);
  for (int i = 1 - fixed; i < m; i += 2) {
    const TouchPoint &before = circles[(i + m - 1) % m], &after = circles[(i + 1) % m];
    circles[i] = chain.between(before, pieces[i], after);
    if (circles[i].curvature_per_mm == 0) return std::nullopt;
    joints[i] = circles[i];
    const TouchPoint touch = touchPoint(circles[i], after);
    joints[(i + 1) % m] = touch;
  }
  VertexArcs result;
  for (int i = 0; i < m; ++i) {
    TouchPoint from = joints[i], to = joints[(i + 1) % m];
    from.curvature_per_mm = circles[i].curvature_per_mm;
    const double length_mm = lengthBetween(from, to);
    if (!(length_mm > 0)) return std::nullopt;
    result.arcs.push_back(from.arc(length_mm));
    const int n = static_cast<int>(chain.points().size()) - 1;
    const int begin = i > 0 ? pieces[i - 1].middle() : pieces[m - 1].middle() - n;
    result.starts.push_back(vertexAhead(chain, from, begin + 1, pieces[i].middle()));
  }
  return result;
}

/// The arcs of an open chain, from beside its first vertex to beside its last one.
std::optional<PlacedArcs> openArcs(const ChainOfPieces& chain, double begin, int fixed) {
  const std::vector<TangentPiece>& pieces = chain.pieces();
  const std::vector<Vector2d>& points = chain.points();
  const int m = static_cast<int>(pieces.size());
  std::vector<TouchPoint> circles(m), joints(m + 1);
  for (int i = fixed; i < m; i += 2) circles[i] = chain.nearCircle(pieces[i]);
  for (int i = 1 - fixed; i < m; i += 2) {
    if (i == 0) {
      circles[i] = chain.atEnd(pieces[i], circles[1], true);
    } else if (i == m - 1) {
      circles[i] = chain.atEnd(pieces[i], circles[i - 1], false);
    } else {
      circles[i] = chain.between(circles[i - 1], pieces[i], circles[i + 1]);
    }
    if (i > 0) joints[i] = circles[i];
    if (i == m - 1) continue;
    if (i > 0 && circles[i].curvature_per_mm == 0) return std::nullopt;
    joints[i + 1] = i == 0 ? circles[i] : touchPoint(circles[i], circles[i + 1]);
  }
  joints.front() = circles.front().beside(points.front());
  joints.back() = circles.back().beside(points.back());
  PlacedArcs result;
  for (int i = 0; i < m; ++i) {
    TouchPoint from = joints[i];
    from.curvature_per_mm = circles[i].curvature_per_mm;
    const double length_mm = lengthBetween(from, joints[i + 1]);
    if (!(length_mm > 0)) return std::nullopt;
    result.arcs.push_back(from.arc(length_mm));
    if (i == 0) continue;
    const double vertex =
        begin + vertexAhead(chain, from, pieces[i - 1].middle() + 1, pieces[i].middle());
    result.ends.push_back({vertex - 1, vertex});
  }
  const double last = begin + static_cast<double>(points.size()) - 1;
  result.ends.push_back({last, last});
  return result;
}

/// Whether each second piece from 0 or from 1 on has a circle of its own. Lines do, so that they
/// stay lines; of pieces without lines the longer ones, which are known better.
int fixedPieces(const ChainOfPieces& chain) {
  std::array<int, 2> lines = {};
  std::array<double, 2> lengths_mm = {};
  for (std::size_t i = 0; i < chain.pieces().size(); ++i) {
    const TangentPiece& piece = chain.pieces()[i];
    lengths_mm[i % 2] += (chain.points()[piece.last] - chain.points()[piece.first]).norm();
    if (chain.isLine(piece)) ++lines[i % 2];
  }
  if ((lines[0] == 0) != (lines[1] == 0)) return lines[0] > 0 ? 0 : 1;
  return lengths_mm[0] >= lengths_mm[1] ? 0 : 1;
}

/// From the first vertex of the polygon on, beside which an arc is divided. Where it is beside a
/// joint, up to the noise, none is.
PlacedArcs fromFirstVertex(const SampledPolygon& polygon, const ChainOfPieces& chain,
                           const VertexArcs& found, double noise_mm) {
  const int n = static_cast<int>(polygon.vertices.size());
  const int m = static_cast<int>(found.arcs.size());
  // The vertices of the polygon at which arcs start, each above the one before.
  const auto startOf = [&](int i) {
    return found.starts[i % m] + chain.offset() + (i / m - 2) * n;
  };
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

/// Whether the pieces have the vertices they need: a circle of its own five, a line three, and a
/// piece that touches its neighbours one between them.
bool haveEnoughVertices(const ChainOfPieces& chain, int fixed) {
  constexpr int of_circle = 4, of_others = 2;
  const auto& pieces = chain.pieces();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const int steps = pieces[i].last - pieces[i].first;
    const bool has_circle = static_cast<int>(i % 2) == fixed && !chain.isLine(pieces[i]);
    if (steps < (has_circle ? of_circle : of_others)) return false;
  }
  return true;
}

}  // namespace

std::optional<PlacedArcs> tangentChain(const SampledPolygon& polygon, double noise_mm,
                                       int fewer_than) {
  // Five points of each of two pieces: fewer are near any two arcs.
  constexpr std::size_t least_vertices = 10;
  if (polygon.closed && polygon.vertices.size() < least_vertices) return std::nullopt;
  const ChainOfPieces chain(polygon, noise_mm);
  const auto& pieces = chain.pieces();
  const int m = static_cast<int>(pieces.size());
  if (m >= fewer_than) return std::nullopt;
  if (!polygon.closed && m == 1)
    return chain.isLine(pieces.front()) || haveEnoughVertices(chain, 0)
               ? openArcs(chain, polygon.begin, 0)
               : std::nullopt;
  const int fixed = fixedPieces(chain);
  if (m < 2 || !haveEnoughVertices(chain, fixed)) return std::nullopt;
  if (!polygon.closed) return openArcs(chain, polygon.begin, fixed);
  if (m % 2 != 0) return std::nullopt;
  const auto arcs = closedArcs(chain, fixed);
  if (!arcs) return std::nullopt;
  return fromFirstVertex(polygon, chain, *arcs, noise_mm);
}

}  // namespace seamwright
