// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc.hpp>
#include <seamwright/core/planar/free_arcs.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;
using FourPoints = std::array<Vector2d, 4>;

/// Covers rounding, as a factor of the tolerance.
constexpr double rounding_factor = 1 + 1e-6;

/// |a - c| - |b - c|, without cancellation far from the centre.
double radiusDifference(const Vector2d& a, const Vector2d& b, const Vector2d& centre) {
  const double sum = (a - centre).norm() + (b - centre).norm();
  return sum > 0 ? (a - b).dot((a - centre) + (b - centre)) / sum : 0;
}

double distanceFromCircle(const FourPointCircle& circle, const Vector2d& point,
                          const Vector2d& reference, double reference_mm) {
  if (!circle.normal.isZero(0))
    return std::abs(circle.normal.dot(point - reference) + reference_mm);
  return std::abs(radiusDifference(point, reference, circle.centre) + reference_mm);
}

/// The circle midway between those around one centre through a and b and through c and d.
void tryCircle(const FourPoints& p, const std::array<int, 4>& order, FourPointCircle& best) {
  const Vector2d &a = p[order[0]], &b = p[order[1]], &c = p[order[2]], &d = p[order[3]];
  const Vector2d first = b - a, second = d - c;
  const double determinant = cross(first, second);
  if (determinant == 0) return;
  // Both bisectors, from the point a.
  const double u = first.squaredNorm() / 2, v = second.dot((c + d) / 2 - a);
  const Vector2d centre =
      a + Vector2d(u * second.y() - v * first.y(), v * first.x() - u * second.x()) / determinant;
  if (!centre.allFinite()) return;
  const double distance_mm = std::abs(radiusDifference(a, c, centre)) / 2;
  if (distance_mm < best.distance_mm)
    best = {.distance_mm = distance_mm,
            .centre = centre,
            .radius_mm = ((a - centre).norm() + (c - centre).norm()) / 2};
}

/// The line midway between those along a direction that hold all points.
void tryLine(const FourPoints& p, const Vector2d& direction, FourPointCircle& best) {
  if (direction.isZero(0)) return;
  const Vector2d normal = Vector2d(-direction.y(), direction.x()).normalized();
  double low = 0, high = 0;
  for (const Vector2d& point : p) {
    low = std::min(low, normal.dot(point - p[0]));
    high = std::max(high, normal.dot(point - p[0]));
  }
  if ((high - low) / 2 < best.distance_mm)
    best = {.distance_mm = (high - low) / 2,
            .normal = normal,
            .radius_mm = normal.dot(p[0]) + (high + low) / 2};
}

/// Points that are to be on one arc.
struct PointWindow {
  const std::vector<Vector2d>& points;
  int first = 0, last = 0;
};

FourPoints pointsAt(const PointWindow& window, const std::array<int, 4>& at) {
  return {window.points[at[0]], window.points[at[1]], window.points[at[2]], window.points[at[3]]};
}

/// Four points that are far from every circle and line, with the circle near them.
struct FarFour {
  std::array<int, 4> chosen{};
  FourPointCircle circle;
  int furthest = 0;  ///< of all points from the circle
  double most_mm = 0;
};

FarFour farFour(const PointWindow& window, const std::array<int, 4>& chosen) {
  const FourPoints four = pointsAt(window, chosen);
  FarFour found{.chosen = chosen, .circle = circleOfFour(four), .furthest = window.first};
  const FourPointCircle& circle = found.circle;
  const double reference_mm = circle.normal.isZero(0)
                                  ? (four[0] - circle.centre).norm() - circle.radius_mm
                                  : circle.normal.dot(four[0]) - circle.radius_mm;
  for (int i = window.first; i <= window.last; ++i) {
    const double distance_mm = distanceFromCircle(circle, window.points[i], four[0], reference_mm);
    if (distance_mm > found.most_mm) {
      found.most_mm = distance_mm;
      found.furthest = i;
    }
  }
  return found;
}

/// The furthest point takes the place of the one of the four that makes their distance the largest.
/// Nothing if it is not more than before.
std::optional<FarFour> exchanged(const PointWindow& window, const FarFour& from) {
  std::array<int, 4> next = from.chosen;
  double next_mm = from.circle.distance_mm;
  for (int k = 0; k < 4; ++k) {
    std::array<int, 4> other = from.chosen;
    other[k] = from.furthest;
    std::ranges::sort(other);
    const double distance_mm = circleOfFour(pointsAt(window, other)).distance_mm;
    if (distance_mm > next_mm) {
      next_mm = distance_mm;
      next = other;
    }
  }
  return next == from.chosen ? std::nullopt : std::optional(farFour(window, next));
}

/// Four points by exchange, as for the best polynomial of degree 2. It stops when they are further
/// from every circle than one distance, or all points are within another one of their circle.
struct ExchangeStops {
  double far_mm = infinite;
  double near_mm = 0;
};

FarFour farFour(const PointWindow& window, const ExchangeStops& stops) {
  const int n = window.last - window.first;
  // The extrema of the Chebyshev polynomial of degree 3.
  FarFour now = farFour(window, std::array{window.first, window.first + std::max(1, n / 4),
                                           window.last - std::max(1, n / 4), window.last});
  // Each exchange brings the distance much closer to the best, so that few are enough.
  constexpr int exchanges = 12;
  for (int exchange = 0; exchange < exchanges; ++exchange) {
    if (now.circle.distance_mm > stops.far_mm || now.most_mm <= stops.near_mm) break;
    const auto next = exchanged(window, now);
    if (!next) break;
    now = *next;
  }
  return now;
}

/// Whether four of the points are further than the tolerance from every circle and line.
bool isMoreThanAnArc(const PointWindow& window, double tolerance_mm) {
  if (window.last - window.first < 3) return false;
  const double most_mm = rounding_factor * tolerance_mm;
  return farFour(window, ExchangeStops{.far_mm = most_mm, .near_mm = most_mm}).circle.distance_mm >
         most_mm;
}

/// The last point that can be on an arc from the first one on.
int freeArcEnd(const std::vector<Vector2d>& points, int first, int guess, double tolerance_mm) {
  const int last = static_cast<int>(points.size()) - 1;
  const auto isTooFar = [&](int to) {
    return isMoreThanAnArc({.points = points, .first = first, .last = to}, tolerance_mm);
  };
  int reach = first, step = std::max(guess, 3), fails = last + 1;
  while (reach < last) {
    const int to = std::min(reach + step, last);
    if (isTooFar(to)) {
      fails = to;
      break;
    }
    reach = to;
    step *= 2;
  }
  while (fails - reach > 1) {
    const int middle = reach + (fails - reach) / 2;
    (isTooFar(middle) ? fails : reach) = middle;
  }
  return reach;
}

/// The middle of the signed distances of points from a flat circle through another one. \param
/// normal there, towards the centre: the side of the distances above 0.
double middleOf(const std::vector<Vector2d>& points, const Vector2d& through,
                const Vector2d& normal, double curvature_per_mm) {
  double low_mm = infinite, high_mm = -infinite;
  for (const Vector2d& point : points) {
    const Vector2d away = point - through;
    const double twice_mm = 2 * away.dot(normal) - curvature_per_mm * away.squaredNorm();
    const double left_mm = twice_mm / (1 + std::sqrt(1 - curvature_per_mm * twice_mm));
    low_mm = std::min(low_mm, left_mm);
    high_mm = std::max(high_mm, left_mm);
  }
  return (low_mm + high_mm) / 2;
}

}  // namespace

FourPointCircle circleOfFour(const FourPoints& points) {
  FourPointCircle best{.distance_mm = infinite};
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) tryLine(points, points[j] - points[i], best);
  for (const std::array<int, 4>& order :
       {std::array{0, 2, 1, 3}, std::array{0, 1, 2, 3}, std::array{0, 3, 1, 2}})
    tryCircle(points, order, best);
  return best;
}

std::vector<int> freeArcEnds(const std::vector<Vector2d>& points, double tolerance_mm) {
  std::vector<int> ends;
  const int last = static_cast<int>(points.size()) - 1;
  int guess = 8;
  for (int first = 0; first <= last;) {
    const int end = freeArcEnd(points, first, guess, tolerance_mm);
    ends.push_back(end);
    guess = end - first;
    first = end + 1;
  }
  return ends;
}

LocalPoint localPoint(const Vector2d& point, const Vector2d& start, const Vector2d& tangent) {
  const Vector2d p = point - start;
  return {.along = p.dot(tangent), .left = cross(tangent, p)};
}

CurvatureRange curvaturesNear(const LocalPoint& point, double tolerance_mm) {
  const double square =
      point.along * point.along + point.left * point.left - tolerance_mm * tolerance_mm;
  if (!(square > 0)) return {};
  return {.lower = 2 * (point.left - tolerance_mm) / square,
          .upper = 2 * (point.left + tolerance_mm) / square};
}

ArcStart nearestCircle(const std::vector<Vector2d>& points, const Vector2d& beside) {
  const Vector2d chord = points.back() - points.front();
  if (points.size() < 4) return {.point = beside, .direction_rad = directionOf(chord)};
  const int last = static_cast<int>(points.size()) - 1;
  const FourPointCircle circle =
      farFour({.points = points, .first = 0, .last = last}, ExchangeStops{}).circle;
  Vector2d normal = circle.normal;
  double curvature_per_mm = 0;
  if (normal.isZero(0)) {
    curvature_per_mm = 1 / circle.radius_mm;
    normal = (circle.centre - beside).normalized();
  }
  double farthest_mm = 0;
  for (const Vector2d& point : points) farthest_mm = std::max(farthest_mm, (point - beside).norm());
  // The centre of a flat circle is known to few digits.
  constexpr double flat_rad = 0.1;
  const double left_mm = farthest_mm * curvature_per_mm < flat_rad
                             ? middleOf(points, beside, normal, curvature_per_mm)
                             : (circle.centre - beside).norm() - circle.radius_mm;
  const Vector2d tangent(normal.y(), -normal.x());
  const double turned = tangent.dot(chord) < 0 ? -1 : 1;
  return {.point = beside + left_mm * normal,
          .direction_rad = directionOf(turned * tangent),
          .curvature_per_mm = turned * curvature_per_mm};
}

int pointsBeside(const std::vector<Vector2d>& points, const ArcStart& start, double tolerance_mm) {
  const Vector2d tangent = unitVector(start.direction_rad);
  CurvatureRange range;
  int count = 0;
  for (const Vector2d& point : points) {
    const CurvatureRange near =
        curvaturesNear(localPoint(point, start.point, tangent), rounding_factor * tolerance_mm);
    range.lower = std::max(range.lower, near.lower);
    range.upper = std::min(range.upper, near.upper);
    if (range.isEmpty()) break;
    ++count;
  }
  return count;
}

}  // namespace seamwright
