// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bezier/curve.hpp>

namespace seamwright {

/// The length of a curve: between lower and upper for certain, rounding included.
struct ArcLength {
  double lower_mm = 0, upper_mm = 0;
  double value_mm = 0;  ///< the best estimate, within both
  bool reached = true;  ///< upper - lower is within the tolerance asked
};

/// The length over [first, last], to upper - lower <= tolerance_mm if rounding allows. In general
/// there is no closed form, and no rational curve but a line has unit speed.
///
/// Chord <= length <= polygon on pieces by halving (rational curves: chord and polygon of the
/// velocity's numerator, over bounds of the denominator). Where the speed has a positive lower
/// bound Gauss' quadrature of 7 nodes takes over: with g the polynomial through the speeds at the
/// nodes, v / d the velocity,
/// |v| / d - g = (v.v - (g d)^2) / ((|v| + g d) d) has bounds by Bernstein forms, rounding
/// included. So the bracket narrows with the seventh power of the pieces' length; the value is
/// nearer by far, but that is not proved. Rounding ends that at a bracket of 1e-13 to 1e-11 of the
/// length, growing with the degree and the ratio of weights; and at most 2^14 halvings are made.
///
/// Identities (each has a test of its number):
///   (1) A line: its length, bracket of rounding. (2) A rational quarter circle: pi r / 2.
///   (3) Sum of the parts; reversal, elevation and rigid motion change nothing but rounding; scale
///       multiplies.
///   (4) A cusp inside: the bracket holds the length of both branches.
/// \throws std::invalid_argument for a tolerance that is not positive and finite, a range outside
/// 0 <= first <= last <= 1, or a degree above 401, of a rational curve 197.
/// Source: docs/theory/curves.md C1.5; [Gravesen1997].
ArcLength arcLength(const BezierCurve& curve, double tolerance_mm, double first = 0,
                    double last = 1);

/// The parameter t at which the length from t = 0 is \p length_mm, by Newton's method between
/// bounds.
///   (5) arcLength(curve, tolerance_mm / 4, 0, t).value_mm is within tolerance_mm / 2 of it. So
///       where that length is reached the true one is within tolerance_mm; else it is so near as
///       those bounds are, which weights of very different size widen. Where no t has such a value
///       it is the one that came nearest, but for rounding.
/// \throws std::invalid_argument for a length outside 0 .. the whole (with both numbers), else as
/// arcLength().
double parameterAtLength(const BezierCurve& curve, double length_mm, double tolerance_mm);

}  // namespace seamwright
