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
  /// The first point in a direction that is at least so far away, or the last one there.
  Index beyond(Index i, Index direction, double distance_mm) const {
    Index found = i;
    for (Index steps = direction;; steps += direction) {
      const auto next = at(i, steps);
      if (!next) return found;
      found = *next;
      if (vector(i, found).norm() >= distance_mm) return found;
    }
  }
  /// The turn between points that are at least so far away.
  double turn_rad(Index i, double distance_mm) const {
    if (!at(i, -1) || !at(i, 1)) return 0;
    return std::abs(
        angleFromTo(vector(beyond(i, -1, distance_mm), i), vector(i, beyond(i, 1, distance_mm))));
  }
};

/// The turn at the nearest point in a direction that is so far away and turns by no more than the
/// angle.
std::optional<double> smoothTurn(const TurningPolygon& polygon, const std::vector<double>& turns,
                                 Index i, Index direction, double distance_mm, double most_rad) {
  for (Index steps = direction;; steps += direction) {
    const auto next = polygon.at(i, steps);
    if (!next) return std::nullopt;
    const double turn_rad = turns[static_cast<std::size_t>(*next)];
    if (turn_rad <= most_rad && polygon.vector(i, *next).norm() >= distance_mm) return turn_rad;
  }
}

/// Without those that errors beside a corner make.
std::vector<Index> sharpest(const TurningPolygon& polygon, const std::vector<double>& turns,
                            const std::vector<Index>& corners, double distance_mm) {
  // Both corners of a blunt end turn by much the same.
  constexpr double least = 0.75;
  std::vector<Index> result;
  for (const Index i : corners) {
    const auto isSharper = [&](Index other) {
      return polygon.vector(i, other).norm() <= distance_mm &&
             turns[static_cast<std::size_t>(i)] < least * turns[static_cast<std::size_t>(other)];
    };
    if (std::ranges::none_of(corners, isSharper)) result.push_back(i);
  }
  return result;
}

}  // namespace

std::vector<Index> pointCorners(const PlanarPoints& points, const PointCornerOptions& options) {
  const Index n = points.rows();
  if (n < 3) refuse(fmt::format("{} points: at least 3 are needed", n));
  for (Index i = options.closed ? 0 : 1; i < n; ++i)
    if (points.row(i) == points.row((i + n - 1) % n))
      refuse(fmt::format("points {} and {} are equal", (i + n - 1) % n, i));
  const TurningPolygon polygon{.points = points, .closed = options.closed};
  // Secants of that length are turned by errors by no more than 30 degrees.
  constexpr double errors_away = 4;
  const double away_mm = errors_away * options.error_mm;
  std::vector<double> turns, wide_turns;
  for (Index i = 0; i < n; ++i) {
    turns.push_back(polygon.turn_rad(i, 0));
    wide_turns.push_back(away_mm > 0 ? polygon.turn_rad(i, away_mm) : turns.back());
  }
  // Between the turns at a corner and those beside it. A nose of which one point and its neighbours
  // are known turns by up to four times as much as its neighbours.
  constexpr double times = 5;
  std::vector<Index> corners;
  for (Index i = 0; i < n; ++i) {
    const double wide_rad = wide_turns[static_cast<std::size_t>(i)];
    if (!(turns[static_cast<std::size_t>(i)] > options.corner_rad)) continue;
    if (!(wide_rad > options.corner_rad)) continue;
    const auto beside = [&](Index direction) {
      return smoothTurn(polygon, wide_turns, i, direction, 2 * away_mm, options.corner_rad);
    };
    const auto before = beside(-1), after = beside(1);
    if (before && after && wide_rad > times * std::max(*before, *after)) corners.push_back(i);
  }
  return sharpest(polygon, turns, corners, away_mm);
}

std::vector<std::vector<Index>> runsBetween(Index points, const std::vector<Index>& corners,
                                            bool closed) {
  std::vector<Index> cuts = corners;
  if (!closed) {
    cuts.insert(cuts.begin(), 0);
    cuts.push_back(points - 1);
  } else if (!cuts.empty()) {
    cuts.push_back(cuts.front() + points);
  }
  std::vector<std::vector<Index>> runs;
  if (cuts.empty()) {
    runs.emplace_back();
    for (Index i = 0; i < points; ++i) runs.back().push_back(i);
  }
  for (std::size_t k = 1; k < cuts.size(); ++k) {
    runs.emplace_back();
    for (Index i = cuts[k - 1]; i <= cuts[k]; ++i) runs.back().push_back(i % points);
  }
  return runs;
}

}  // namespace seamwright
