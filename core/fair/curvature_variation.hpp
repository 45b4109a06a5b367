// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

/// How much the curvature of a curve varies.
struct CurvatureVariation {
  /// Integral of |d(k N)/ds|^2 across the tangent by arc length, with the curvature k, the normal N
  /// and the torsion t: of (dk/ds)^2 + (k t)^2. It is 0 for arcs and lines.
  double energy_per_mm3 = 0;
  /// Extrema of the curvature and its changes of sign inside of the segments; extrema at joints,
  /// where its slope changes its sign.
  int extrema = 0, extrema_at_joints = 0, inflections = 0;
  /// Segments in which rounding hides a sign, or the curve may stop.
  int undecided_segments = 0;
};

/// The energy is Gauss' quadrature with 8 nodes on each segment. Curves with z = 0 have a signed
/// curvature. Identities (each has a test of its number):
///   (1) The energy of a clothoid with the slope c and the length L is c^2 L.
///   (2) Scaling by s divides the energy by s^3; rigid motion and reversal keep it.
/// \throws std::invalid_argument as requireValid(BezierSpline) does, and for a segment that is a
/// point, also one of degree 0, with its index.
/// Source: docs/theory/planar.md P13.4, P8.1 to P8.3.
CurvatureVariation variationOf(const BezierSpline& spline);

}  // namespace seamwright
