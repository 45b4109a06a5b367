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

/// A corner, if the turns beside it show so.
struct SharpTurn {
  Index at = 0;
  double turn_rad = 0, beside_rad = 0;
};

/// Without those that errors beside a corner make.
std::vector<SharpTurn> sharpest(const TurningPolygon& polygon, const std::vector<double>& turns,
                                const std::vector<SharpTurn>& corners, double distance_mm) {
  // Both corners of a blunt end turn by much the same.
  constexpr double least = 0.75;
  const auto count = std::ssize(corners);
  const auto cornerAt = [&](std::ptrdiff_t k) {
    return corners[static_cast<std::size_t>((k + count) % count)].at;
  };
  // Of the next corners in a direction that are so near, one is sharper.
  const auto isBesideSharper = [&](std::ptrdiff_t k, std::ptrdiff_t direction) {
    for (std::ptrdiff_t steps = 1; steps < count; ++steps) {
      const std::ptrdiff_t next = k + steps * direction;
      if (!polygon.closed && (next < 0 || next >= count)) return false;
      if (polygon.vector(cornerAt(k), cornerAt(next)).norm() > distance_mm) return false;
      if (turns[static_cast<std::size_t>(cornerAt(k))] <
          least * turns[static_cast<std::size_t>(cornerAt(next))])
        return true;
    }
    return false;
  };
  std::vector<SharpTurn> result;
  for (std::ptrdiff_t k = 0; k < count; ++k)
    if (!isBesideSharper(k, -1) && !isBesideSharper(k, 1))
      result.push_back(corners[static_cast<std::size_t>(k)]);
  return result;
}

/// Choices. A nose of which one point and its neighbours are known turns by up to four times as
/// much as its neighbours; a bend of few points by up to seven times.
constexpr double least_times = 5, least_times_of_few = 8;

/// Without those that can be bends of a curve of few points.
std::vector<Index> clearCorners(const std::vector<SharpTurn>& found, Index points, bool closed) {
  constexpr std::size_t few = 5;  // three turns that are far smaller are no chance
  std::vector<Index> corners;
  for (const SharpTurn& turn : found) corners.push_back(turn.at);
  if (corners.empty()) return corners;
  const std::vector<std::vector<Index>> runs = runsBetween(points, corners, closed);
  std::vector<Index> result;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const std::size_t before = closed ? (k + runs.size() - 1) % runs.size() : k,
                      after = closed ? k : k + 1;
    const bool has_few = std::max(runs[before].size(), runs[after].size()) < few;
    if (!has_few || found[k].turn_rad > least_times_of_few * found[k].beside_rad)
      result.push_back(found[k].at);
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
  std::vector<SharpTurn> found;
  for (Index i = 0; i < n; ++i) {
    const double wide_rad = wide_turns[static_cast<std::size_t>(i)];
    if (!(turns[static_cast<std::size_t>(i)] > options.corner_rad)) continue;
    if (!(wide_rad > options.corner_rad)) continue;
    const auto beside = [&](Index direction) {
      return smoothTurn(polygon, wide_turns, i, direction, 2 * away_mm, options.corner_rad);
    };
    const auto before = beside(-1), after = beside(1);
    if (before && after && wide_rad > least_times * std::max(*before, *after))
      found.push_back({i, wide_rad, std::max(*before, *after)});
  }
  return clearCorners(sharpest(polygon, turns, found, away_mm), n, options.closed);
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
