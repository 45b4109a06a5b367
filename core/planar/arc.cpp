// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc.hpp>

namespace seamwright {

namespace {

using std::numbers::pi;

Eigen::RowVector3d inSpace(const Eigen::Vector2d& point) {
  return {point.x(), point.y(), 0};
}

}  // namespace

double sinc(double x) {
  // Below 2^-26 the series 1 - x^2 / 6 rounds to 1.
  return std::abs(x) < 0x1p-26 ? 1 : std::sin(x) / x;
}

double sincSlope(double x) {
  // Both terms cancel for small x. The series has an error below x^5 / 840.
  if (std::abs(x) < 1e-3) return -x / 3 + x * x * x / 30;
  return (x * std::cos(x) - std::sin(x)) / (x * x);
}

double wrapped(double angle_rad) {
  return std::remainder(angle_rad, 2 * pi);
}

double directionOf(const Eigen::Vector2d& vector) {
  return std::atan2(vector.y(), vector.x());
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double angleFromTo(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::atan2(cross(a, b), a.dot(b));
}

Eigen::Vector2d unitVector(double angle_rad) {
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

Eigen::Vector2d PlanarArc::point(double s_mm) const {
  const double half_turn_rad = curvature_per_mm * s_mm / 2;
  return start + s_mm * sinc(half_turn_rad) * unitVector(direction_rad + half_turn_rad);
}

PlanarArc arcThrough(const Eigen::Vector2d& start, double direction_rad,
                     const Eigen::Vector2d& end) {
  const Eigen::Vector2d chord = end - start;
  const double chord_mm = chord.norm();
  if (!std::isfinite(direction_rad) || !std::isfinite(chord_mm))
    refuse(
        fmt::format("an arc has a point or a direction that is not finite: from ({}, {}), {} rad,"
                    " to ({}, {})",
                    start.x(), start.y(), direction_rad, end.x(), end.y()));
  if (!(chord_mm > 0))
    refuse(fmt::format("an arc begins and ends at the same point ({}, {})", end.x(), end.y()));
  const double angle_rad = wrapped(directionOf(chord) - direction_rad);
  return {.start = start,
          .direction_rad = direction_rad,
          .curvature_per_mm = 2 * std::sin(angle_rad) / chord_mm,
          .length_mm = chord_mm / sinc(angle_rad)};
}

PlanarArc reversed(const PlanarArc& arc) {
  return {.start = arc.end(),
          .direction_rad = wrapped(arc.endDirection_rad() + pi),
          .curvature_per_mm = -arc.curvature_per_mm,
          .length_mm = arc.length_mm};
}

PlanarArc offset(const PlanarArc& arc, double distance_mm) {
  const double factor = 1 - arc.curvature_per_mm * distance_mm;
  if (!(factor > 0))
    throw std::domain_error(
        fmt::format("the offset by {} mm reaches the centre of an arc with the "
                    "radius {} mm",
                    distance_mm, 1 / arc.curvature_per_mm));
  return {.start = arc.start + distance_mm * unitVector(arc.direction_rad + pi / 2),
          .direction_rad = arc.direction_rad,
          .curvature_per_mm = arc.curvature_per_mm / factor,
          .length_mm = arc.length_mm * factor};
}

std::vector<BezierCurve> bezierCurves(const PlanarArc& arc) {
  const double largest_sweep_rad = 2 * pi / 3;
  const int count =
      std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep_rad()) / largest_sweep_rad)));
  const double half_rad = arc.sweep_rad() / (2 * count);
  const double chord_mm = arc.length_mm / count * sinc(half_rad);
  std::vector<BezierCurve> curves;
  Eigen::Vector2d from = arc.start;
  for (int i = 0; i < count; ++i) {
    const double chord_rad = arc.direction_rad + (2 * i + 1) * half_rad;
    const Eigen::Vector2d to = arc.point(arc.length_mm * (i + 1) / count);
    // The middle pole is where the end tangents meet.
    const double reach_mm = chord_mm / (2 * std::cos(half_rad));
    const Eigen::Vector2d middle = from + reach_mm * unitVector(chord_rad - half_rad);
    Poles poles(3, 3);
    poles << inSpace(from), inSpace(middle), inSpace(to);
    curves.emplace_back(poles, Eigen::Vector3d(1, std::cos(half_rad), 1));
    from = to;
  }
  return curves;
}

}  // namespace seamwright
