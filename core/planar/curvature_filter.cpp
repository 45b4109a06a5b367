// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/fair_points.hpp>
#include <seamwright/core/planar/point_move.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

/// A segment between two points with tangents.
struct FilterSegment {
  double length_mm = 0, alpha_rad = 0, beta_rad = 0;

  bool convex() const { return alpha_rad * beta_rad > 0; }
};

std::vector<FilterSegment> segmentsOf(const PlanarPoints& points,
                                      const std::vector<double>& directions_rad, bool closed) {
  std::vector<FilterSegment> segments;
  const Index n = points.rows();
  for (Index s = 0; s < n - (closed ? 0 : 1); ++s) {
    const Index next = (s + 1) % n;
    const Eigen::Vector2d chord = (points.row(next) - points.row(s)).transpose();
    const double direction_rad = directionOf(chord);
    segments.push_back({.length_mm = chord.norm(),
                        .alpha_rad = wrapped(direction_rad - directions_rad[s]),
                        .beta_rad = wrapped(directions_rad[next] - direction_rad)});
  }
  return segments;
}

/// The angle of the tangent against the chord at the start of a segment that gives it the mean
/// curvature.
double filteredAngle(const FilterSegment& before, const FilterSegment& own,
                     const FilterSegment& after, double strength) {
  const bool convex = before.convex() && own.convex() && after.convex();
  const auto weight = [&](const FilterSegment& other) {
    const double lengths = own.length_mm / other.length_mm;
    if (!convex) return lengths;
    return lengths * (other.alpha_rad + other.beta_rad) * own.beta_rad /
           ((own.alpha_rad + own.beta_rad) * other.beta_rad);
  };
  return own.alpha_rad + strength / 2 *
                             (weight(before) * before.alpha_rad + weight(after) * after.alpha_rad -
                              2 * own.alpha_rad);
}

/// The point at \p way along the normal, or the nearest one to it within the tolerance.
Eigen::RowVector2d within(const Eigen::RowVector2d& point, const Eigen::RowVector2d& original,
                          const Eigen::RowVector2d& normal, double way_mm, double tolerance_mm) {
  const Eigen::RowVector2d apart = point - original;
  const double along = apart.dot(normal);
  const double square = along * along - apart.squaredNorm() + tolerance_mm * tolerance_mm;
  const double root = std::sqrt(std::max(square, 0.0));
  const double move_mm = std::clamp(way_mm, -along - root, -along + root);
  return withinDistance(point + move_mm * normal, original, tolerance_mm);
}

PlanarPoints reversedPoints(const PlanarPoints& points) {
  return points.colwise().reverse();
}

}  // namespace

PlanarPoints curvatureFilterPass(const PlanarPoints& points, const PlanarPoints& original,
                                 const std::vector<double>& directions_rad, double strength,
                                 double tolerance_mm, bool closed) {
  // Near a right angle the move has no bound.
  constexpr double largest_rad = std::numbers::pi / 2 - 1e-3;
  const std::vector<FilterSegment> segments = segmentsOf(points, directions_rad, closed);
  const std::size_t count = segments.size();
  PlanarPoints result = points;
  for (std::size_t s = closed ? 0 : 1; s < count - (closed ? 0 : 1); ++s) {
    const FilterSegment& own = segments[s];
    const double angle_rad =
        filteredAngle(segments[(s + count - 1) % count], own, segments[(s + 1) % count], strength);
    if (!(std::abs(angle_rad) < largest_rad)) continue;
    const double way_mm =
        own.length_mm * (std::sin(own.alpha_rad) - std::cos(own.alpha_rad) * std::tan(angle_rad));
    const Eigen::RowVector2d normal(-std::sin(directions_rad[s]), std::cos(directions_rad[s]));
    const auto i = static_cast<Index>(s);
    result.row(i) = within(points.row(i), original.row(i), normal, way_mm, tolerance_mm);
  }
  return result;
}

FairedPoints filterCurvature(const PlanarPoints& points, double tolerance_mm,
                             const CurvatureFilterOptions& options, const Progress& progress) {
  FairedPoints result;
  result.points = points;
  result.before = fairnessOf(points, options.closed);
  if (!(tolerance_mm >= 0) || tolerance_mm == infinite)
    refuse(fmt::format("the tolerance is {} mm: it must be at least 0 and finite", tolerance_mm));
  if (!(options.strength > 0 && options.strength <= 0.25))
    refuse(fmt::format("the strength is {}: it must be above 0 and at most 1/4", options.strength));
  PlanarPoints original = points;
  const auto pass = [&] {
    const Tangents tangents = tangentsAt(result.points, {.closed = options.closed});
    result.points = curvatureFilterPass(result.points, original, tangents.directions_rad,
                                        options.strength, tolerance_mm, options.closed);
    result.points = reversedPoints(result.points);
    original = reversedPoints(original);
  };
  if (tolerance_mm == 0) result.status = PointFairingStatus::Converged;
  result.after = result.before;
  while (result.status == PointFairingStatus::NotConverged && result.steps < options.max_passes) {
    checkProgress(progress, static_cast<double>(result.steps) / options.max_passes);
    const PlanarPoints before = result.points;
    pass();
    pass();
    const PointFairness fairness = fairnessOf(result.points, options.closed);
    const bool still = (result.points - before).rowwise().norm().maxCoeff() < 1e-3 * tolerance_mm;
    if (still) result.status = PointFairingStatus::Converged;
    if (!(fairness.energy_per_mm3 < result.after.energy_per_mm3)) {
      result.points = before;
      if (!still) result.status = PointFairingStatus::EnergyGrows;
      break;
    }
    ++result.steps;
    result.after = fairness;
  }
  result.moved_mm = (result.points - points).rowwise().norm().maxCoeff(&result.most_moved);
  return result;
}

}  // namespace seamwright
