// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>

namespace seamwright {

/// An arc of a circle in the plane; a line segment if the curvature is 0.
///
/// The point at arc length s is start + s sinc(k s / 2) e(d + k s / 2), with the direction d at the
/// start, the curvature k, e(a) = (cos a, sin a) and sinc(x) = sin(x) / x. So lines and flat arcs
/// need no case of their own, and no digits are lost near them.
/// Source: docs/theory/planar.md P1.1.
struct PlanarArc {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  double direction_rad = 0;     ///< of the tangent at the start
  double curvature_per_mm = 0;  ///< above 0: turns to the left
  double length_mm = 0;

  /// Angle by which the tangent turns, with the sign of the curvature.
  double sweep_rad() const { return curvature_per_mm * length_mm; }
  /// Of the tangent, not reduced by multiples of 2 pi.
  double directionAt_rad(double s_mm) const { return direction_rad + curvature_per_mm * s_mm; }
  double endDirection_rad() const { return direction_rad + sweep_rad(); }
  /// The point at an arc length from the start. Beyond the ends the circle continues.
  Eigen::Vector2d point(double s_mm) const;
  Eigen::Vector2d end() const { return point(length_mm); }
  bool operator==(const PlanarArc& other) const = default;
};

/// sin(x) / x, and 1 at 0.
double sinc(double x);
/// The derivative of sinc, (x cos(x) - sin(x)) / x^2, and 0 at 0.
double sincSlope(double x);
/// The angle plus the multiple of 2 pi that brings it into [-pi, pi].
double wrapped(double angle_rad);
/// The angle of the vector against the first axis, in [-pi, pi].
double directionOf(const Eigen::Vector2d& vector);
/// The component of the cross product across the plane; above 0 if b is to the left of a.
double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b);
/// The angle from a to b, in [-pi, pi]; above 0 to the left.
double angleFromTo(const Eigen::Vector2d& a, const Eigen::Vector2d& b);
/// (cos a, sin a).
Eigen::Vector2d unitVector(double angle_rad);

/// The arc from a point with a direction there to another point. Its sweep lies in [-2 pi, 2 pi].
/// Identity (it has a test of its number):
///   (1) The end of the arc is \p end up to rounding.
/// \throws std::invalid_argument if a number is not finite or both points are equal.
/// Source: docs/theory/planar.md P1.2.
PlanarArc arcThrough(const Eigen::Vector2d& start, double direction_rad,
                     const Eigen::Vector2d& end);

/// The same points in the other direction.
PlanarArc reversed(const PlanarArc& arc);

/// The parallel arc at a distance to the left (below 0: to the right).
///   (2) Each point is the point of the arc at the same share of the length, moved along its
///   normal.
/// \throws std::domain_error if the offset reaches the centre: 1 - k d <= 0.
PlanarArc offset(const PlanarArc& arc, double distance_mm);

/// The arc as rational quadratic Bézier curves in the plane z = 0: one curve for each started
/// 2 pi / 3 of sweep, all of the same sweep. Neighbours share their pole bitwise; the first pole is
/// the start. A line is one curve with weights 1.
///   (3) Every point of the curves is at the distance 1 / |k| from the centre, up to rounding.
/// Source: docs/theory/planar.md P1.3.
std::vector<BezierCurve> bezierCurves(const PlanarArc& arc);

}  // namespace seamwright
