// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/clothoid_transition.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;
using std::numbers::pi;

/// A point of an oriented circle or line.
struct CirclePoint {
  Vector2d point;
  double direction_rad = 0, curvature_per_mm = 0;

  Vector2d tangent() const { return unitVector(direction_rad); }
  Vector2d left() const { return unitVector(direction_rad + pi / 2); }
};

CirclePoint circleAt(const PlanarArc& arc, double s_mm) {
  return {.point = arc.point(s_mm),
          .direction_rad = arc.directionAt_rad(s_mm),
          .curvature_per_mm = arc.curvature_per_mm};
}

CirclePoint circleAtEnd(const Clothoid& clothoid) {
  return {.point = clothoid.end(),
          .direction_rad = clothoid.directionAt_rad(clothoid.length_mm),
          .curvature_per_mm = clothoid.curvatureAt_per_mm(clothoid.length_mm)};
}

/// (D^2 - (1 / k_a - 1 / k_b)^2) k_a k_b for the distance D of the centres, in a form that holds
/// for lines as well. It has no unit and does not depend on the points of the circles: 0 for
/// circles that touch, below 0 for those that have a transition.
double circleSeparation(const CirclePoint& a, const CirclePoint& b) {
  const Vector2d way = b.point - a.point;
  const double turn = std::sin((b.direction_rad - a.direction_rad) / 2);
  const double ka = a.curvature_per_mm, kb = b.curvature_per_mm;
  return ka * kb * way.squaredNorm() + 4 * turn * turn - 2 * kb * way.dot(a.left()) +
         2 * ka * way.dot(b.left());
}

Clothoid clothoidFrom(const CirclePoint& from, double end_curvature_per_mm, double length_mm) {
  return {.start = from.point,
          .direction_rad = from.direction_rad,
          .curvature_per_mm = from.curvature_per_mm,
          .curvature_slope_per_mm2 = (end_curvature_per_mm - from.curvature_per_mm) / length_mm,
          .length_mm = length_mm};
}

/// The length for which the circles at both ends have this separation. Its root is nearly a
/// multiple of the length, so that the secant method needs a few steps.
double transitionLength(const CirclePoint& from, const CirclePoint& to, double separated) {
  const double change = std::abs(to.curvature_per_mm - from.curvature_per_mm);
  const double size = (std::abs(from.curvature_per_mm) + std::abs(to.curvature_per_mm)) / 2;
  const double wanted = std::sqrt(-separated);
  const auto missAt = [&](double length_mm) {
    if (!(size * length_mm <= pi))
      throw std::domain_error(fmt::format(
          "a clothoid from the curvature {} per mm to {} per mm would turn by more than {:.3g} rad "
          "to bridge the gap of the circles",
          from.curvature_per_mm, to.curvature_per_mm, pi));
    const Clothoid tried = clothoidFrom(from, to.curvature_per_mm, length_mm);
    return std::sqrt(std::max(0.0, -circleSeparation(from, circleAtEnd(tried)))) - wanted;
  };
  // Of circles with a small gap the separation is (k_b - k_a)^2 L^2 / 12.
  double before_mm = std::sqrt(12.0) * wanted / change, before = missAt(before_mm);
  double length_mm = before_mm * wanted / (wanted + before);
  if (before == 0 || !std::isfinite(length_mm)) return before_mm;
  // A choice that is far above what was ever needed.
  constexpr int most_steps = 30;
  double miss = missAt(length_mm);
  for (int step = 0; step < most_steps && std::abs(miss) < std::abs(before); ++step) {
    const double next_mm = length_mm - miss * (length_mm - before_mm) / (miss - before);
    before_mm = length_mm;
    before = miss;
    if (miss == 0 || next_mm == length_mm) break;
    length_mm = next_mm;
    miss = missAt(length_mm);
  }
  return before_mm;
}

/// The left normal at the place of the circle that is nearest to a point, times the share of the
/// radius at which the point is.
Vector2d scaledLeft(const CirclePoint& circle, const Vector2d& point) {
  return circle.left() - circle.curvature_per_mm * (point - circle.point);
}

/// Arc length from a point of a circle to another one, the shorter way.
double circleLengthTo(const CirclePoint& circle, const Vector2d& point) {
  const Vector2d chord = point - circle.point;
  const double angle_rad = angleFromTo(circle.tangent(), chord);
  if (std::abs(angle_rad) <= pi / 2) return chord.norm() / sinc(angle_rad);
  return -chord.norm() / sinc(wrapped(angle_rad - pi));
}

}  // namespace

ClothoidTransition clothoidTransition(const PlanarArc& from, const PlanarArc& to) {
  const CirclePoint joint = circleAt(from, from.length_mm), target = circleAt(to, 0);
  const double separated = circleSeparation(joint, target);
  if (!std::isfinite(separated)) refuse("an arc has a number that is not finite");
  const double change = to.curvature_per_mm - from.curvature_per_mm;
  if (change == 0 || !(separated < 0))
    throw std::domain_error(fmt::format(
        "no clothoid joins circles of the curvatures {} per mm and {} per mm that touch or cross",
        from.curvature_per_mm, to.curvature_per_mm));
  const double length_mm = transitionLength(joint, target, separated);
  // Moved along the first circle until the circle at its end is the second one: then it has the
  // direction of the second circle where it ends.
  ClothoidTransition result;
  double leaves_mm = from.length_mm - length_mm / 2, last_rad = infinite;
  // A choice that is far above what was ever needed.
  constexpr int most_steps = 50;
  for (int step = 0; step < most_steps; ++step) {
    const Clothoid placed = clothoidFrom(circleAt(from, leaves_mm), to.curvature_per_mm, length_mm);
    const CirclePoint end = circleAtEnd(placed);
    const Vector2d left = scaledLeft(target, end.point);
    const double off_rad = angleFromTo(left, end.left());
    if (!(std::abs(off_rad) < last_rad)) break;
    last_rad = std::abs(off_rad);
    result = {.clothoid = placed,
              .leaves_mm = leaves_mm,
              .arrives_mm = circleLengthTo(target, end.point)};
    // The end moves like a point that is fixed to the tangent of the first circle.
    const Vector2d way = end.point - placed.start;
    const Vector2d velocity =
        unitVector(placed.direction_rad) + from.curvature_per_mm * Vector2d(-way.y(), way.x());
    const double turned = cross(velocity, left) / left.squaredNorm();
    leaves_mm -= off_rad / (from.curvature_per_mm - to.curvature_per_mm * turned);
  }
  return result;
}

}  // namespace seamwright
