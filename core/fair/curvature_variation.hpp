// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

/// How much the curvature of a curve varies.
struct CurvatureVariation {
  /// Integral of |d(k N)/ds|^2 across the tangent by arc length, with the curvature k, the normal N
  /// and the torsion t: of (dk/ds)^2 + (k t)^2. It is 0 for arcs and lines up to rounding, and
  /// infinite if a segment may stop.
  double energy_per_mm3 = 0;
  /// Extrema of the curvature and its changes of sign inside of the segments; extrema at joints,
  /// where its slope changes its sign.
  int extrema = 0, extrema_at_joints = 0, inflections = 0;
  /// Segments in which rounding hides a sign, or the curve may stop.
  int undecided_segments = 0;
};

/// The energy is Gauss' quadrature on pieces of the segments, which are halved until the rules of 6
/// and 9 nodes agree. Curves with z = 0 have a signed curvature. Identities (each has a test of its
/// number):
///   (1) The energy of a clothoid with the slope c and the length L is c^2 L.
///   (2) Scaling by s divides the energy by s^3; rigid motion and reversal keep it.
///   (3) The rules agree on each piece up to 1e-6 of its energy, or up to rounding. The error is
///       that of the rule of more nodes and usually far less; no bound is proven.
///   (4) The energy depends on the shape alone: raising the degree, splitting a segment and weights
///       that change only the parametrisation keep it.
///   (5) It is infinite if the curve is at a place slower than about 2^-32 of its speed, as at a
///       cusp or where neighbouring poles at an end are equal. Straight segments
///       have 0 all the same, even if they stop or turn back.
/// The cost grows with the logarithm of the ratio of the speeds.
/// \throws std::invalid_argument as requireValid(BezierSpline) does, and for a segment that is a
/// point, also one of degree 0, with its index.
/// Source: docs/theory/planar.md P13.4, P13.6, P8.1 to P8.3.
CurvatureVariation variationOf(const BezierSpline& spline);

}  // namespace seamwright
