// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/free_arcs.hpp>
#include <seamwright/core/planar/tangent_chain.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// A point of a circle or line with its direction and curvature.
struct TouchPoint {
  Vector2d point = Vector2d::Zero();
  double direction_rad = 0, curvature_per_mm = 0;

  Vector2d normal() const { return {-std::sin(direction_rad), std::cos(direction_rad)}; }
  TouchPoint after(double length_mm) const {
    const PlanarArc arc{.start = point,
                        .direction_rad = direction_rad,
                        .curvature_per_mm = curvature_per_mm,
                        .length_mm = length_mm};
    return {.point = arc.end(),
            .direction_rad = arc.endDirection_rad(),
            .curvature_per_mm = curvature_per_mm};
  }
  /// The point of the circle beside another one.
  TouchPoint beside(const Vector2d& other) const {
    const Vector2d away = other - point;
    const double along = away.dot(unitVector(direction_rad)), left = away.dot(normal());
    const double k = curvature_per_mm;
    return after(k == 0 ? along : std::atan2(k * along, 1 - k * left) / k);
  }
  double distance_mm(const Vector2d& other) const { return (beside(other).point - other).norm(); }
};

/// The circle that leaves a point in its direction and touches a circle or line so that it
/// continues in the same sense.
TouchPoint touching(const TouchPoint& from, const TouchPoint& to) {
  const Vector2d away = from.point - to.point, normal = to.normal();
  const double k = to.curvature_per_mm;
  const double curvature = 2 * (1 - from.normal().dot(normal) + k * away.dot(from.normal())) /
                           (2 * away.dot(normal) - k * away.squaredNorm());
  return {.point = from.point,
          .direction_rad = from.direction_rad,
          .curvature_per_mm = std::isfinite(curvature) ? curvature : 0};
}

/// Where a circle that touches another circle or line does so, as a point of the other.
TouchPoint touchPoint(const TouchPoint& circle, const TouchPoint& to) {
  // The centres and the point are on one line; from the larger circle or the line it is seen best.
  if (std::abs(to.curvature_per_mm) > std::abs(circle.curvature_per_mm)) {
    const TouchPoint other = touchPoint(to, circle);
    return to.beside(other.point);
  }
  const Vector2d centre = circle.point + circle.normal() / circle.curvature_per_mm;
  return to.beside(centre);
}

/// Vertices of one circle or line.
struct TangentPiece {
  int first = 0, last = 0;
  int middle() const { return (first + last) / 2; }
};

/// How far an arc advances between points of its circle.
double lengthBetween(const TouchPoint& from, const TouchPoint& to) {
  const double k = from.curvature_per_mm;
  if (k == 0) return (to.point - from.point).dot(unitVector(from.direction_rad));
  double turn_rad = wrapped(to.direction_rad - from.direction_rad);
  // Less than it is the rounding of an arc that vanishes.
  constexpr double nothing_rad = 1e-9;
  if (turn_rad * k < 0 && std::abs(turn_rad) > nothing_rad)
    turn_rad += std::copysign(2 * std::numbers::pi, k);
  return turn_rad / k;
}

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

  /// The circle between two others that is nearest to the vertices of a piece.
  TouchPoint between(const TouchPoint& from, const TangentPiece& piece,
                     const TouchPoint& to) const {
    const TouchPoint start = from.beside(points_[piece.first]);
    const double reach_mm = (points_[piece.last] - points_[piece.first]).norm() / 2;
    const auto candidate = [&](double u) { return touching(start.after(u), to); };
    const auto off_mm = [&](double u) {
      const TouchPoint circle = candidate(u);
      double largest = 0;
      constexpr int looks = 16;
      const int length = piece.last - piece.first;
      for (int k = 2; k <= looks - 2; ++k)
        largest = std::max(largest, circle.distance_mm(points_[piece.first + length * k / looks]));
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

 private:
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
    result.arcs.push_back({.start = from.point,
                           .direction_rad = from.direction_rad,
                           .curvature_per_mm = from.curvature_per_mm,
                           .length_mm = length_mm});
    const Vector2d tangent = unitVector(from.direction_rad);
    const int n = static_cast<int>(chain.points().size()) - 1;
    const int begin = i > 0 ? pieces[i - 1].middle() : pieces[m - 1].middle() - n;
    int vertex = begin + 1;
    const auto ahead = [&](int at) {
      return (chain.points()[(at + n) % n] - from.point).dot(tangent) >= 0;
    };
    while (vertex < pieces[i].middle() && !ahead(vertex)) ++vertex;
    result.starts.push_back(vertex);
  }
  return result;
}

/// From the first vertex of the polygon on, beside which an arc is divided.
PlacedArcs fromFirstVertex(const SampledPolygon& polygon, const ChainOfPieces& chain,
                           const VertexArcs& found) {
  const int n = static_cast<int>(polygon.vertices.size());
  const int m = static_cast<int>(found.arcs.size());
  // The vertices of the polygon at which arcs start, each above the one before.
  const auto startOf = [&](int i) {
    return found.starts[i % m] + chain.offset() + (i / m - 2) * n;
  };
  int first = 0;
  while (startOf(first) <= 0) ++first;
  const PlanarArc& divided = found.arcs[(first - 1) % m];
  const TouchPoint start{.point = divided.start,
                         .direction_rad = divided.direction_rad,
                         .curvature_per_mm = divided.curvature_per_mm};
  const TouchPoint beside = start.beside(polygon.vertices.front());
  PlanarArc head = divided, tail = divided;
  head.length_mm = lengthBetween(start, beside);
  tail.start = beside.point;
  tail.direction_rad = beside.direction_rad;
  tail.length_mm = divided.length_mm - head.length_mm;
  PlacedArcs result{.arcs = {tail}, .ends = {}};
  for (int i = first; i < first + m - 1; ++i) {
    result.arcs.push_back(found.arcs[i % m]);
    const double vertex = polygon.begin + startOf(i);
    result.ends.push_back({vertex - 1, vertex});
  }
  result.arcs.push_back(head);
  const double vertex = polygon.begin + startOf(first + m - 1);
  result.ends.push_back({vertex - 1, vertex});
  result.ends.push_back({polygon.begin + n, polygon.begin + n});
  return result;
}

/// An upper bound, which is the distance up to rounding for points near the arc.
double distance_mm(const PlanarArc& arc, const Vector2d& point) {
  const Vector2d away = point - arc.start, tangent = unitVector(arc.direction_rad);
  const double along = away.dot(tangent), left = cross(tangent, away), k = arc.curvature_per_mm;
  const double s = k == 0 ? along : std::atan2(k * along, 1 - k * left) / k;
  const double once_around = k == 0 ? s : s + 2 * std::numbers::pi / std::abs(k);
  double result = infinite;
  for (const double at : {s, once_around})
    result = std::min(result, (arc.point(std::clamp(at, 0.0, arc.length_mm)) - point).norm());
  return result;
}

/// The largest distance of a point from the arcs beside which it lies.
double largestDistance_mm(const PlacedArcs& placed, const std::vector<Vector2d>& points) {
  double largest = 0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    double nearest = infinite;
    for (std::size_t i = 0; i < placed.arcs.size(); ++i) {
      const double begin = i > 0 ? placed.ends[i - 1].begin : 0, end = placed.ends[i].end;
      const auto at = static_cast<double>(v);
      if (begin <= at && at <= end)
        nearest = std::min(nearest, distance_mm(placed.arcs[i], points[v]));
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

/// Whether the chain is as long as arcs between neighbours are. A piece has four of them or more,
/// so those of half a circle are longer than their chords by 3 %.
bool runsFromPointToPoint(const PlacedArcs& placed, const std::vector<Vector2d>& points) {
  constexpr double longer = 1.1;
  double length_mm = 0, polygon_mm = (points.front() - points.back()).norm();
  for (const PlanarArc& arc : placed.arcs) length_mm += arc.length_mm;
  for (std::size_t v = 1; v < points.size(); ++v) polygon_mm += (points[v] - points[v - 1]).norm();
  return length_mm <= longer * polygon_mm;
}

}  // namespace

std::optional<PlacedArcs> tangentChain(const SampledPolygon& polygon, double noise_mm,
                                       int fewer_than) {
  // Five points of each of two pieces: fewer are near any two arcs.
  constexpr std::size_t least_vertices = 10;
  if (!polygon.closed || polygon.vertices.size() < least_vertices) return std::nullopt;
  const ChainOfPieces chain(polygon, noise_mm);
  const int m = static_cast<int>(chain.pieces().size());
  if (m < 2 || m % 2 != 0 || m >= fewer_than) return std::nullopt;
  // A piece of fewer vertices has no circle of its own.
  constexpr int least_steps = 4;
  for (const TangentPiece& piece : chain.pieces())
    if (piece.last - piece.first < least_steps) return std::nullopt;
  // The longer ones are known better, so the others are made to touch them.
  std::array<double, 2> lengths_mm = {};
  for (int i = 0; i < m; ++i) {
    const TangentPiece& piece = chain.pieces()[i];
    lengths_mm[i % 2] += (chain.points()[piece.last] - chain.points()[piece.first]).norm();
  }
  const auto arcs = closedArcs(chain, lengths_mm[0] >= lengths_mm[1] ? 0 : 1);
  if (!arcs) return std::nullopt;
  return fromFirstVertex(polygon, chain, *arcs);
}

std::optional<SampledChain> sampledChain(const std::vector<Vector2d>& points, double tolerance_mm) {
  std::optional<SampledChain> best;
  for (const double share : noise_shares) {
    const int fewer_than = static_cast<int>(best ? best->arcs.size() : points.size());
    const auto placed =
        tangentChain({.vertices = points, .closed = true}, share * tolerance_mm, fewer_than);
    if (!placed || !runsFromPointToPoint(*placed, points)) continue;
    SampledChain chain{.arcs = placed->arcs, .distance_mm = largestDistance_mm(*placed, points)};
    if (!(chain.distance_mm <= tolerance_mm)) continue;
    // The arc beside the first point is divided there.
    const double tail_mm = chain.arcs.front().length_mm;
    chain.arcs.front() = chain.arcs.back();
    chain.arcs.front().length_mm += tail_mm;
    chain.arcs.pop_back();
    best = std::move(chain);
  }
  return best;
}

}  // namespace seamwright
