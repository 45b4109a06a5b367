// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/planar/touch_point.hpp>

#include <cmath>
#include <numbers>

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

TouchPoint touching(const TouchPoint& from, const TouchPoint& to) {
  const Vector2d away = from.point - to.point, normal = to.normal();
  const double k = to.curvature_per_mm;
  const double curvature = 2 * (1 - from.normal().dot(normal) + k * away.dot(from.normal())) /
                           (2 * away.dot(normal) - k * away.squaredNorm());
  return {.point = from.point,
          .direction_rad = from.direction_rad,
          .curvature_per_mm = std::isfinite(curvature) ? curvature : 0};
}

TouchPoint touchPoint(const TouchPoint& circle, const TouchPoint& to) {
  // The centres and the point are on one line; from the larger circle or the line it is seen best.
  if (std::abs(to.curvature_per_mm) > std::abs(circle.curvature_per_mm)) {
    const TouchPoint other = touchPoint(to, circle);
    return to.beside(other.point);
  }
  const Vector2d centre = circle.point + circle.normal() / circle.curvature_per_mm;
  return to.beside(centre);
}

}  // namespace seamwright
