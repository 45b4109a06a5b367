// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <seamwright/plugin/cli/point_curves.hpp>

namespace seamwright::cli {

namespace {

using Eigen::Vector2d;

/// The tangent at the first point of the circle through three points; nothing if they turn too far
/// to be of one circle.
std::optional<double> circleDirection_rad(const Vector2d& first, const Vector2d& second,
                                          const Vector2d& third) {
  // A choice: 115 degrees between equal chords, more than samples of a curve turn.
  constexpr double largest_rad = 1;
  const double angle_rad = angleFromTo(first - third, second - third);
  if (std::abs(angle_rad) > largest_rad) return std::nullopt;
  return directionOf(second - first) - angle_rad;
}

}  // namespace

BiarcSpline biarcsOf(const PlanarPoints& points, bool closed) {
  TangentOptions options;
  options.closed = closed;
  const Eigen::Index n = points.rows();
  if (!closed && n > 2) {
    const auto at = [&](Eigen::Index i) -> Vector2d { return points.row(i).transpose(); };
    options.start_direction_rad = circleDirection_rad(at(0), at(1), at(2));
    options.end_direction_rad = circleDirection_rad(at(n - 1), at(n - 2), at(n - 3));
    if (options.end_direction_rad) *options.end_direction_rad += std::numbers::pi;
  }
  return biarcSpline(points, options);
}

ClothoidSpline clothoidsOf(const PlanarPoints& points, bool closed, const Progress& progress) {
  ClothoidSplineOptions options;
  options.closed = closed;
  options.start.arc = options.end.arc = !closed && points.rows() > 2;
  return clothoidSpline(points, options, progress);
}

std::string crowdedPoints(const GivenCurve& given) {
  // A choice: samples of a curve do not become that much denser from one chord to the next.
  constexpr double least_ratio = 1e-3;
  const Eigen::Index n = given.points.rows(), chords = given.record.closed ? n : n - 1;
  const auto chord_mm = [&](Eigen::Index i) {
    const Eigen::Index from = (i + chords) % chords;
    return (given.points.row((from + 1) % n) - given.points.row(from)).norm();
  };
  for (Eigen::Index i = 0; chords > 1 && i < chords; ++i) {
    const double length_mm = chord_mm(i);
    const bool has_before = given.record.closed || i > 0,
               has_after = given.record.closed || i + 1 < chords;
    if ((!has_before || length_mm < least_ratio * chord_mm(i - 1)) &&
        (!has_after || length_mm < least_ratio * chord_mm(i + 1)))
      return fmt::format("the points of lines {} and {} are only {:.3g} mm apart: remove one",
                         given.lines[static_cast<std::size_t>(i)],
                         given.lines[static_cast<std::size_t>((i + 1) % n)], length_mm);
  }
  return "";
}

}  // namespace seamwright::cli
