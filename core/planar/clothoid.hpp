// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/planar/biarc.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

/// A piece of a clothoid (Euler spiral): its curvature is linear in the arc length. Arcs and lines
/// are the cases with a constant curvature.
///
/// Points are integrals of the direction, computed by Gauss' quadrature to a few roundings of the
/// length. The closed form with Fresnel integrals loses all digits as the curvature becomes
/// constant. Source: docs/theory/planar.md P4.1.
struct Clothoid {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  double direction_rad = 0;            ///< of the tangent at the start
  double curvature_per_mm = 0;         ///< at the start; above 0: turns to the left
  double curvature_slope_per_mm2 = 0;  ///< change of the curvature by arc length
  double length_mm = 0;

  double curvatureAt_per_mm(double s_mm) const {
    return curvature_per_mm + curvature_slope_per_mm2 * s_mm;
  }
  double directionAt_rad(double s_mm) const {
    return direction_rad + s_mm * (curvature_per_mm + curvature_slope_per_mm2 * s_mm / 2);
  }
  Eigen::Vector2d point(double s_mm) const;
  Eigen::Vector2d end() const { return point(length_mm); }
  bool operator==(const Clothoid& other) const = default;
};

/// The same points in the other direction.
Clothoid reversed(const Clothoid& clothoid);

/// The clothoid between two points with given tangents. Of all clothoids between the ends it is the
/// one whose directions stay nearest to that of the chord; it is unique. It is not the curve of
/// least change of curvature between the ends. Identities (each has a test of its number):
///   (1) The clothoid ends at the given point with the given direction.
///   (2) Ends on a circle give its arc, ends on a line the line.
///   (3) Reversed ends give the reversed clothoid, mirrored ends the mirrored one; rigid motion and
///       scaling move it along.
///   (4) Vogt: with the angles a = -alpha and b = beta of the tangents against the chord, a + b has
///       the sign of the change of the curvature.
/// Accuracy: the end is met to 2e-15 times the square of the length over the chord.
/// \throws std::invalid_argument as chordAngles() does. Throws std::domain_error if both tangents
/// point against the chord so closely that the length has no bound: |alpha + beta| near 2 pi, with
/// a length of more than 1e8 chords.
/// Source: docs/theory/planar.md P4.2; [BertolazziFrego2015].
Clothoid clothoid(const HermiteEnds& ends);

/// A spline that approximates a chain of curves, and the proven distance.
struct SplineWithin {
  BezierSpline curve;
  /// Upper bound of the distance between points of both curves at the same arc length.
  double distance_mm = 0;
};

/// A chain of clothoids as quintic segments, each the Hermite interpolant by arc length of
/// position, tangent and curvature at its ends. The spline is C2 by arc length within each
/// clothoid, and G2 where neighbours agree in their curvature.
///   (5) No point is further than distance_mm <= tolerance_mm from the point of the same arc
///   length.
/// \param gap_mm largest distance between the end of one clothoid and the start of the next.
/// \throws std::invalid_argument for an empty chain, a tolerance that is not positive and finite,
/// and gaps. Throws std::domain_error if a clothoid needs more than 100,000 segments.
/// Source: docs/theory/planar.md P4.3.
SplineWithin bezierSpline(const std::vector<Clothoid>& chain, double tolerance_mm, bool closed,
                          double gap_mm);

}  // namespace seamwright
