// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/planar/touch_point.hpp>

#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include <seamwright/core/numeric.hpp>

namespace seamwright {

using Eigen::Vector2d;

Vector2d TouchPoint::normal() const {
  return {-std::sin(direction_rad), std::cos(direction_rad)};
}

PlanarArc TouchPoint::arc(double length_mm) const {
  return {.start = point,
          .direction_rad = direction_rad,
          .curvature_per_mm = curvature_per_mm,
          .length_mm = length_mm};
}

TouchPoint TouchPoint::after(double length_mm) const {
  const PlanarArc between = arc(length_mm);
  return {.point = between.end(),
          .direction_rad = between.endDirection_rad(),
          .curvature_per_mm = curvature_per_mm};
}

double TouchPoint::lengthTo_mm(const Vector2d& other) const {
  const Vector2d away = other - point;
  const double along = away.dot(tangent()), left = away.dot(normal()), k = curvature_per_mm;
  return k == 0 ? along : std::atan2(k * along, 1 - k * left) / k;
}

TouchPoint TouchPoint::beside(const Vector2d& other) const {
  return after(lengthTo_mm(other));
}

double TouchPoint::distance_mm(const Vector2d& other) const {
  const TouchPoint next = beside(other);
  return (other - next.point).dot(next.normal());
}

TouchPoint touchPointOf(const PlanarArc& arc) {
  return {.point = arc.start,
          .direction_rad = arc.direction_rad,
          .curvature_per_mm = arc.curvature_per_mm};
}

double lengthBetween(const TouchPoint& from, const TouchPoint& to) {
  const double k = from.curvature_per_mm, length_mm = from.lengthTo_mm(to.point);
  // Less than it is the rounding of an arc that vanishes.
  constexpr double nothing_rad = 1e-9;
  const bool is_behind = k != 0 && -length_mm * std::abs(k) > nothing_rad;
  return is_behind ? length_mm + 2 * std::numbers::pi / std::abs(k) : length_mm;
}

Vector2d touchPoint(const TouchPoint& a, const TouchPoint& b) {
  // The centres and the point are on one line; from the larger circle or the line it is seen best.
  const bool is_a_flatter = std::abs(a.curvature_per_mm) < std::abs(b.curvature_per_mm);
  const TouchPoint &flatter = is_a_flatter ? a : b, &other = is_a_flatter ? b : a;
  return flatter.beside(other.point + other.normal() / other.curvature_per_mm).point;
}

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

}  // namespace seamwright
