// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc.hpp>
#include <seamwright/core/planar/point_corners.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

/// A polygon whose turns are looked at.
struct TurningPolygon {
  const PlanarPoints& points;
  bool closed = false;

  Index count() const { return points.rows(); }
  /// The point so many steps away; nothing beyond an open end, or once around.
  std::optional<Index> at(Index i, Index steps) const {
    if (!closed && (i + steps < 0 || i + steps >= count())) return std::nullopt;
    if (std::abs(steps) >= count()) return std::nullopt;
    return (i + steps + count()) % count();
  }
  Eigen::Vector2d vector(Index from, Index to) const {
    return (points.row(to) - points.row(from)).transpose();
  }
  double turn_rad(Index i) const {
    const auto before = at(i, -1), after = at(i, 1);
    if (!before || !after) return 0;
    return std::abs(angleFromTo(vector(*before, i), vector(i, *after)));
  }
  /// The first point in a direction that is at least so far away, or the last one there.
  Index beyond(Index i, int direction, double distance_mm) const {
    Index found = i;
    for (Index steps = direction;; steps += direction) {
      const auto next = at(i, steps);
      if (!next) return found;
      found = *next;
      if (vector(i, found).norm() >= distance_mm) return found;
    }
  }
  /// The turn between points that are so far away.
  double wideTurn_rad(Index i, double distance_mm) const {
    const Index before = beyond(i, -1, distance_mm), after = beyond(i, 1, distance_mm);
    return std::abs(angleFromTo(vector(before, i), vector(i, after)));
  }
};

/// The turn at the nearest point in a direction that turns by no more than the angle.
std::optional<double> smoothTurn(const TurningPolygon& polygon, const std::vector<double>& turns,
                                 Index i, int direction, double most_rad) {
  for (Index steps = direction;; steps += direction) {
    const auto next = polygon.at(i, steps);
    if (!next) return std::nullopt;
    const double turn_rad = turns[static_cast<std::size_t>(*next)];
    if (turn_rad <= most_rad) return turn_rad;
  }
}

}  // namespace

std::vector<Index> pointCorners(const PlanarPoints& points, const PointCornerOptions& options) {
  const Index n = points.rows();
  if (n < 3) refuse(fmt::format("{} points: at least 3 are needed", n));
  for (Index i = options.closed ? 0 : 1; i < n; ++i)
    if (points.row(i) == points.row((i + n - 1) % n))
      refuse(fmt::format("points {} and {} are equal", (i + n - 1) % n, i));
  const TurningPolygon polygon{.points = points, .closed = options.closed};
  std::vector<double> turns;
  for (Index i = 0; i < n; ++i) turns.push_back(polygon.turn_rad(i));
  // Between the turns at a corner and those beside it, which samples of a smooth curve do not
  // reach: a nose that three points show turns by less than three times its neighbours.
  constexpr double times = 3, errors_away = 4;
  std::vector<Index> corners;
  for (Index i = 0; i < n; ++i) {
    const double turn_rad = turns[static_cast<std::size_t>(i)];
    if (!(turn_rad > options.corner_rad)) continue;
    const auto before = smoothTurn(polygon, turns, i, -1, options.corner_rad);
    const auto after = smoothTurn(polygon, turns, i, 1, options.corner_rad);
    if (!before || !after || turn_rad < times * std::max(*before, *after)) continue;
    if (options.error_mm > 0 &&
        polygon.wideTurn_rad(i, errors_away * options.error_mm) <= options.corner_rad)
      continue;
    corners.push_back(i);
  }
  return corners;
}

}  // namespace seamwright
