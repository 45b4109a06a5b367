// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include <Eigen/LU>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/point_corners.hpp>
#include <seamwright/core/planar/sampled_chain.hpp>
#include <seamwright/core/planar/tangent_chain.hpp>
#include <seamwright/core/planar/touch_point.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// Choices. Points of lines and arcs show corners that those of other curves do not: with a corner
/// at a smaller turn there are fewer pieces, or it is none. Pieces between such corners have more
/// points than the chords of an arc.
constexpr std::array corner_angles_deg = {60.0, 12.0};
constexpr std::array<std::size_t, 2> least_points_between = {2, 4};

/// An upper bound, which is the distance up to rounding for points near the arc.
double distance_mm(const PlanarArc& arc, const Vector2d& point) {
  const double s = touchPointOf(arc).lengthTo_mm(point), k = arc.curvature_per_mm;
  double result = (arc.point(std::clamp(s, 0.0, arc.length_mm)) - point).norm();
  if (k == 0) return result;
  const double once_around = s + 2 * std::numbers::pi / std::abs(k);
  return std::min(result, (arc.point(std::clamp(once_around, 0.0, arc.length_mm)) - point).norm());
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
bool runsFromPointToPoint(const SampledChain& chain, const std::vector<Vector2d>& points) {
  constexpr double longer = 1.1;
  double length_mm = 0, polygon_mm = 0;
  if (chain.closed) polygon_mm = (points.front() - points.back()).norm();
  for (const PlanarArc& arc : chain.arcs) length_mm += arc.length_mm;
  for (std::size_t v = 1; v < points.size(); ++v) polygon_mm += (points[v] - points[v - 1]).norm();
  return length_mm <= longer * polygon_mm;
}

/// Whether each arc begins where the one before ends, up to rounding.
bool joins(const SampledChain& chain) {
  constexpr double roundings = 1024;
  for (std::size_t i = chain.closed ? 0 : 1; i < chain.arcs.size(); ++i) {
    const PlanarArc& before = chain.arcs[i > 0 ? i - 1 : chain.arcs.size() - 1];
    const double size_mm = before.start.norm() + before.length_mm + chain.arcs[i].start.norm();
    if ((before.end() - chain.arcs[i].start).norm() > roundings * machine_epsilon * size_mm)
      return false;
  }
  return true;
}

/// Where two circles or lines cross beside a point; nothing if they do not cross there.
std::optional<Vector2d> crossingNear(const TouchPoint& a, const TouchPoint& b, Vector2d point) {
  constexpr int newton_steps = 20;
  Vector2d step = Vector2d::Zero();
  for (int i = 0; i < newton_steps; ++i) {
    Eigen::Matrix2d normals;
    normals << a.beside(point).normal().transpose(), b.beside(point).normal().transpose();
    step = normals.inverse() * Vector2d(a.distance_mm(point), b.distance_mm(point));
    point -= step;
    if (!point.allFinite()) return std::nullopt;
  }
  constexpr double roundings = 64;
  const double size_mm = point.norm() + (a.point - point).norm() + (b.point - point).norm();
  if (step.norm() > roundings * machine_epsilon * size_mm) return std::nullopt;
  return point;
}

/// Lets an arc end, and the next one begin, where both cross no further from a corner than the
/// tolerance. Returns whether they do.
bool meetAtCorner(PlanarArc& before, PlanarArc& after, const Vector2d& corner,
                  double tolerance_mm) {
  const TouchPoint end = touchPointOf(before).after(before.length_mm), start = touchPointOf(after);
  const std::optional<Vector2d> crossing = crossingNear(end, start, corner);
  if (!crossing || (*crossing - corner).norm() > tolerance_mm) return false;
  before.length_mm += end.lengthTo_mm(*crossing);
  const double ahead_mm = start.lengthTo_mm(*crossing);
  const TouchPoint begin = start.after(ahead_mm);
  after = begin.arc(after.length_mm - ahead_mm);
  return before.length_mm > 0 && after.length_mm > 0;
}

/// The points of a curve, and what is asked for.
struct SampledPoints {
  const PlanarPoints& points;
  bool closed = false;
  double tolerance_mm = 0;

  std::vector<Vector2d> at(const std::vector<Eigen::Index>& indices) const {
    std::vector<Vector2d> result;
    for (const Eigen::Index i : indices) result.emplace_back(points.row(i).transpose());
    return result;
  }
};

/// Without corners.
std::optional<SampledChain> smoothChain(const std::vector<Vector2d>& points, bool closed,
                                        double noise_mm, int fewer_than) {
  const auto placed = tangentChain({.vertices = points, .closed = closed}, noise_mm, fewer_than);
  if (!placed) return std::nullopt;
  SampledChain chain{.arcs = placed->arcs,
                     .corners = {},
                     .closed = closed,
                     .distance_mm = largestDistance_mm(*placed, points)};
  const bool is_divided = chain.arcs.front().curvature_per_mm == chain.arcs.back().curvature_per_mm;
  if (!closed || !is_divided) return chain;
  // The arc beside the first point is divided there.
  const double tail_mm = chain.arcs.front().length_mm;
  chain.arcs.front() = chain.arcs.back();
  chain.arcs.front().length_mm += tail_mm;
  chain.arcs.pop_back();
  return chain;
}

/// From corner to corner.
std::optional<SampledChain> chainWithCorners(const SampledPoints& sampled,
                                             const std::vector<Eigen::Index>& corners,
                                             double noise_mm, int fewer_than) {
  SampledChain chain{.arcs = {}, .corners = {}, .closed = sampled.closed};
  std::vector<std::vector<Vector2d>> runs;
  for (const auto& run : runsBetween(sampled.points.rows(), corners, sampled.closed))
    runs.push_back(sampled.at(run));
  std::vector<PlacedArcs> placed;
  int count = 0;
  for (const std::vector<Vector2d>& run : runs) {
    auto arcs = tangentChain({.vertices = run}, noise_mm, fewer_than - count);
    if (!arcs) return std::nullopt;
    count += static_cast<int>(arcs->arcs.size());
    placed.push_back(*std::move(arcs));
  }
  for (std::size_t r = sampled.closed ? 0 : 1; r < runs.size(); ++r) {
    PlacedArcs& before = placed[r > 0 ? r - 1 : runs.size() - 1];
    if (!meetAtCorner(before.arcs.back(), placed[r].arcs.front(), runs[r].front(),
                      sampled.tolerance_mm))
      return std::nullopt;
  }
  for (std::size_t r = 0; r < runs.size(); ++r) {
    chain.distance_mm = std::max(chain.distance_mm, largestDistance_mm(placed[r], runs[r]));
    if (r > 0 || sampled.closed) chain.corners.push_back(static_cast<int>(chain.arcs.size()));
    chain.arcs.insert(chain.arcs.end(), placed[r].arcs.begin(), placed[r].arcs.end());
  }
  return chain;
}

}  // namespace

std::optional<SampledChain> sampledChain(const PlanarPoints& points,
                                         const SampledChainOptions& options) {
  const SampledPoints sampled{
      .points = points, .closed = options.closed, .tolerance_mm = options.tolerance_mm};
  std::vector<Eigen::Index> indices(static_cast<std::size_t>(points.rows()));
  std::iota(indices.begin(), indices.end(), Eigen::Index{0});
  const std::vector<Vector2d> all = sampled.at(indices);
  std::optional<SampledChain> best;
  constexpr Eigen::Index least_points = 3;
  if (points.rows() < least_points) return best;
  for (const double share : noise_shares) {
    const double noise_mm = share * options.tolerance_mm;
    std::vector<Eigen::Index> tried = {-1};
    for (std::size_t k = 0; k < corner_angles_deg.size(); ++k) {
      const std::vector<Eigen::Index> corners =
          pointCorners(points, {.closed = options.closed,
                                .corner_rad = corner_angles_deg[k] * radians_per_degree,
                                .error_mm = noise_mm});
      if (corners == tried) continue;
      tried = corners;
      const auto hasFew = [&](const auto& run) { return run.size() < least_points_between[k]; };
      if (std::ranges::any_of(runsBetween(points.rows(), corners, options.closed), hasFew))
        continue;
      const int fewer_than = static_cast<int>(best ? best->arcs.size() : all.size());
      auto chain = corners.empty() ? smoothChain(all, options.closed, noise_mm, fewer_than)
                                   : chainWithCorners(sampled, corners, noise_mm, fewer_than);
      if (!chain || !(chain->distance_mm <= options.tolerance_mm)) continue;
      if (joins(*chain) && runsFromPointToPoint(*chain, all)) best = std::move(chain);
    }
  }
  return best;
}

}  // namespace seamwright
