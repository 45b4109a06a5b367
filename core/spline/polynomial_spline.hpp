// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

/// A polynomial spline near a rational one.
struct PolynomialSpline {
  BezierSpline spline;  ///< all weights 1
  /// Bound of |X(t) - Y(t)| for all t, rounding of the bound included, so of the distance of the
  /// curves in both directions.
  double distance_mm = 0;
  int added_joints = 0;
};

/// Rational segments become Hermite interpolants of degree 2 n + 1 that have the derivatives 0..n
/// of the segment at both ends; they are halved until the bound is within the tolerance. The other
/// segments stay, except for the degree. So a joint that is G^n stays G^n with the same betas, and
/// added joints are C^n. A closed spline stays closed.
///
/// The bound is that of (A - w Y) / w in Bernstein form, where A / w is the segment and Y its
/// interpolant. It decreases with the power 2 n + 2 of the length of the segments.
///
/// Identities (each has a test of its number):
///   (1) A polynomial spline is returned as it is, bitwise.
///   (2) The bound holds: samples of a circle are nearer than it.
///   (3) Derivatives 0..n at the joints of the spline are those of its segments.
/// \param order n, 1 to 6
/// \throws std::invalid_argument, with the value, as requireValid(), for another order, and for a
/// tolerance that is not positive and finite; std::domain_error, with segment and bound, if a
/// segment of 2^-20 of the length is still beyond the tolerance.
/// Source: docs/theory/curves.md C10.3.
PolynomialSpline polynomialSpline(const BezierSpline& spline, int order, double tolerance_mm);

}  // namespace seamwright
