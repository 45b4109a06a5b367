// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/planar/clothoid.hpp>

namespace seamwright {

/// The Euler arc spline between two ends: \p count arcs of one length, joined G1, whose curvatures
/// grow by a constant difference from arc to arc. For many arcs it approaches the clothoid, with
/// an error of order 1 / count^2. Identities (each has a test of its number):
///   (1) The arcs meet both ends with their directions, have one length, and their curvatures are
///   an
///       arithmetic progression.
/// \param count at least 2; 1 if the ends lie on a circle.
/// \throws std::invalid_argument as chordAngles() does, and for a count below 1. Throws
/// std::domain_error if no such arcs exist near the clothoid, and as clothoid() does.
/// Source: docs/theory/planar.md P5.1.
std::vector<PlanarArc> eulerArcs(const HermiteEnds& ends, int count);

/// A piece of a logarithmic spiral. The radius of curvature is radius_mm e^(growth u) after the
/// tangent has turned by u; with growth 0 it is an arc of a circle.
/// Source: docs/theory/planar.md P6.1.
struct LogSpiral {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  double direction_rad = 0;  ///< of the tangent at the start
  double radius_mm = 0;      ///< at the start; above 0: turns to the left
  double growth = 0;         ///< change of the logarithm of the radius, per radian of turn
  double turn_rad = 0;       ///< angle by which the tangent turns; above 0

  /// The point where the tangent has turned by \p u_rad.
  Eigen::Vector2d point(double u_rad) const;
  Eigen::Vector2d end() const { return point(turn_rad); }
  double radiusAt_mm(double u_rad) const;
  /// Of the tangent, not reduced by multiples of 2 pi.
  double directionAt_rad(double u_rad) const;
  double length_mm() const;
  /// The point around which the spiral turns. For growth 0 it is the centre of the circle.
  Eigen::Vector2d pole() const;
  bool operator==(const LogSpiral& other) const = default;
};

/// The logarithmic spiral between two ends that form a C-shape: alpha beta > 0 with |alpha + beta|
/// <= pi (see ChordAngles). It exists for all these ends and is unique.
///   (2) The spiral meets both ends with their directions.
///   (3) alpha = beta gives the arc of a circle.
///   (4) The angle from the tangent to the direction to the pole is constant; its cotangent is
///       -growth if the spiral turns to the left.
/// \throws std::invalid_argument as chordAngles() does. Throws std::domain_error for ends of
/// another shape (a clothoid or a biarc joins these), for turns above pi (a point has to be
/// inserted), and if the radii at the ends differ by more than the factor 1e12. Source:
/// docs/theory/planar.md P6.2; [Yang2014].
LogSpiral logSpiral(const HermiteEnds& ends);

/// The smallest number of arcs of logArcs(): floor((alpha + beta) / (2 min(alpha, beta))) + 1.
/// \throws as logSpiral() does.
int leastLogArcs(const HermiteEnds& ends);

/// The logarithmic arc spline between two ends: \p count arcs of one sweep, joined G1, whose radii
/// grow by a constant factor from arc to arc. It is unique.
///   (5) The arcs meet both ends with their directions, have one sweep, and their radii are a
///       geometric progression.
/// \throws as logSpiral() does, and std::domain_error for a count below leastLogArcs().
/// Source: docs/theory/planar.md P6.3; [Yang2014].
std::vector<PlanarArc> logArcs(const HermiteEnds& ends, int count);

/// The spiral as quintic segments, each the Hermite interpolant by the turned angle.
///   (6) No point is further than distance_mm <= tolerance_mm from the point of the same turn.
/// The spline is C2 by the turned angle, hence G2.
/// \throws std::invalid_argument for a tolerance that is not positive and finite. Throws
/// std::domain_error if more than 100,000 segments are needed.
/// Source: docs/theory/planar.md P6.4.
SplineWithin bezierSpline(const LogSpiral& spiral, double tolerance_mm);

}  // namespace seamwright
