// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/bezier/curve.hpp>

namespace seamwright {

/// The length of a curve. It certainly lies between lower and upper, rounding included.
struct ArcLength {
  double lower_mm = 0, upper_mm = 0;
  double value_mm = 0;  ///< the best estimate, within the bounds
  bool reached = true;  ///< upper - lower is at most the given tolerance
};

/// The length of the control polygon, an upper bound of the length of the curve.
double polygonLength(const BezierCurve& curve);

/// The length over [first, last]. The result has upper - lower <= tolerance_mm if rounding allows
/// it. In general there is no closed form, and lines are the only rational curves of unit speed.
///
/// On each piece chord <= length <= polygon, and pieces are halved. For a rational curve chord and
/// polygon are those of the numerator of the velocity, divided by bounds of the denominator. Where
/// the speed has a positive lower bound, Gauss' quadrature with 7 nodes replaces them. Let g be the
/// polynomial through the speeds at the nodes and v / d the velocity. Then
/// |v| / d - g = (v.v - (g d)^2) / ((|v| + g d) d) has bounds by Bernstein forms, rounding
/// included. So the bracket narrows with the seventh power of the length of the pieces. The value
/// is far more accurate, but that is not proved. Rounding limits the bracket to 1e-13 to 1e-11 of
/// the length, growing with the degree and the ratio of weights. At most 2^14 halvings are made.
///
/// Identities (each has a test of its number):
///   (1) A line: the value is its length, and the bracket is rounding only. (2) A rational quarter
///       circle: pi r / 2.
///   (3) The length is the sum of the lengths of the parts. Reversal, elevation and rigid motion
///       change only rounding; a scale multiplies the length.
///   (4) With a cusp inside, the bracket contains the length of both branches.
/// \throws std::invalid_argument for a tolerance that is not positive and finite, a range outside 0
/// <= first <= last <= 1, or a degree above 401 (polynomial curve) or 197 (rational curve).
/// Source: docs/theory/curves.md C1.5; [Gravesen1997].
ArcLength arcLength(const BezierCurve& curve, double tolerance_mm, double first = 0,
                    double last = 1);

/// The length from t = 0 to t.
struct LengthMark {
  double t = 0, length_mm = 0;
};

/// The ends of the pieces into which arcLength() divides a curve, from t = 0 to 1. Within a piece
/// arcLength() divides no further for this tolerance, so that many lengths of one curve are quick.
///   (6) The last mark has the length arcLength(curve, tolerance_mm).value_mm, but for rounding.
/// \throws as arcLength() does.
std::vector<LengthMark> lengthMarks(const BezierCurve& curve, double tolerance_mm);

/// The parameter t of [first, last] at which the length from \p first is \p length_mm, by Newton's
/// method between bounds.
///   (5) arcLength(curve, tolerance_mm / 4, first, t).value_mm is within tolerance_mm / 2 of it.
///       So if that arcLength() reached its tolerance, the true length at t is within tolerance_mm
///       of length_mm. Otherwise the error is limited by its bounds, which weights of very
///       different size widen. If no t has such a value, the result is, except for rounding, the t
///       that came nearest.
/// \throws std::invalid_argument for a length outside 0 .. that of the range (with both numbers),
/// and as arcLength() does.
double parameterAtLength(const BezierCurve& curve, double length_mm, double tolerance_mm,
                         double first = 0, double last = 1);

}  // namespace seamwright
