// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc.hpp>
#include <seamwright/core/planar/point_corners.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

/// Some points of a polygon in their order, to find those that are far away: a tree of boxes.
class FarPoints {
 public:
  /// \param indices ascending
  FarPoints(const PlanarPoints& points, std::vector<Index> indices, bool closed)
      : points_(points), indices_(std::move(indices)), closed_(closed) {
    while (leaves_ < indices_.size()) leaves_ *= 2;
    boxes_.resize(2 * leaves_);
    for (std::size_t k = 0; k < indices_.size(); ++k)
      boxes_[leaves_ + k].extend(points_.row(indices_[k]).transpose());
    for (std::size_t node = leaves_ - 1; node > 0; --node)
      boxes_[node] = boxes_[2 * node].merged(boxes_[2 * node + 1]);
  }

  /// The first one after a point of the polygon, or before it, that is at least so far away.
  std::optional<Index> next(Index i, bool forward, double distance_mm) const {
    const auto place = [&](Index index) {
      return static_cast<std::size_t>(std::ranges::lower_bound(indices_, index) - indices_.begin());
    };
    // Most are near in the order, where the tree only costs.
    constexpr int steps = 8;
    const auto count = std::ssize(indices_);
    auto k = static_cast<std::ptrdiff_t>(forward ? place(i + 1) : place(i)) - (forward ? 0 : 1);
    for (int step = 0; step < steps && 0 <= k && k < count; ++step, k += forward ? 1 : -1) {
      const Index index = indices_[static_cast<std::size_t>(k)];
      if ((points_.row(index) - points_.row(i)).norm() >= distance_mm) return index;
    }
    const Range before{.begin = 0, .end = place(i)},
        after{.begin = place(i + 1), .end = indices_.size()};
    const Search search{
        .point = points_.row(i).transpose(), .distance_mm = distance_mm, .forward = forward};
    const Range whole{.begin = 0, .end = leaves_};
    auto found = first(search, forward ? after : before, 1, whole);
    if (!found && closed_) found = first(search, forward ? before : after, 1, whole);
    return found;
  }

 private:
  struct Range {
    std::size_t begin = 0, end = 0;
  };
  struct Search {
    Eigen::Vector2d point;
    double distance_mm = 0;
    bool forward = true;
  };
  std::optional<Index> first(const Search& search, const Range& in, std::size_t node,
                             const Range& of_node) const {
    if (of_node.begin >= in.end || of_node.end <= in.begin || boxes_[node].isEmpty())
      return std::nullopt;
    const Eigen::Vector2d farthest = (search.point - boxes_[node].min())
                                         .cwiseAbs()
                                         .cwiseMax((search.point - boxes_[node].max()).cwiseAbs());
    if (farthest.norm() < search.distance_mm) return std::nullopt;
    if (node >= leaves_) return indices_[node - leaves_];
    const std::size_t middle = (of_node.begin + of_node.end) / 2;
    for (const bool is_left : {search.forward, !search.forward}) {
      const Range half = is_left ? Range{of_node.begin, middle} : Range{middle, of_node.end};
      if (const auto found = first(search, in, 2 * node + (is_left ? 0 : 1), half)) return found;
    }
    return std::nullopt;
  }

  const PlanarPoints& points_;
  std::vector<Index> indices_;
  bool closed_;
  std::size_t leaves_ = 1;
  std::vector<Eigen::AlignedBox2d> boxes_ = {};
};

/// A polygon whose turns are looked at.
struct TurningPolygon {
  const PlanarPoints& points;
  bool closed = false;

  Index count() const { return points.rows(); }
  Eigen::Vector2d vector(Index from, Index to) const {
    return (points.row(to) - points.row(from)).transpose();
  }
  /// The turns between points that are at least so far away, or the last ones there.
  std::vector<double> turns_rad(double distance_mm) const {
    const Index n = count();
    std::vector<Index> all(static_cast<std::size_t>(n));
    std::iota(all.begin(), all.end(), Index{0});
    const FarPoints far(points, std::move(all), closed);
    std::vector<double> turns(static_cast<std::size_t>(n), 0.0);
    for (Index i = closed ? 0 : 1; i < (closed ? n : n - 1); ++i) {
      const Index from = far.next(i, false, distance_mm).value_or(closed ? (i + 1) % n : 0),
                  to = far.next(i, true, distance_mm).value_or(closed ? (i + n - 1) % n : n - 1);
      turns[static_cast<std::size_t>(i)] = std::abs(angleFromTo(vector(from, i), vector(i, to)));
    }
    return turns;
  }
};

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
  const std::vector<double> turns = polygon.turns_rad(0);
  const std::vector<double> wide_turns = away_mm > 0 ? polygon.turns_rad(away_mm) : turns;
  std::vector<Index> smooth;
  for (Index i = 0; i < n; ++i)
    if (wide_turns[static_cast<std::size_t>(i)] <= options.corner_rad) smooth.push_back(i);
  const FarPoints smooth_points(points, std::move(smooth), options.closed);
  std::vector<SharpTurn> found;
  for (Index i = 0; i < n; ++i) {
    const double wide_rad = wide_turns[static_cast<std::size_t>(i)];
    if (!(turns[static_cast<std::size_t>(i)] > options.corner_rad)) continue;
    if (!(wide_rad > options.corner_rad)) continue;
    const auto before = smooth_points.next(i, false, 2 * away_mm),
               after = smooth_points.next(i, true, 2 * away_mm);
    if (!before || !after) continue;
    const double beside_rad = std::max(wide_turns[static_cast<std::size_t>(*before)],
                                       wide_turns[static_cast<std::size_t>(*after)]);
    if (wide_rad > least_times * beside_rad) found.push_back({i, wide_rad, beside_rad});
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
