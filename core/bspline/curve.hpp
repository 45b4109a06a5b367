// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/bezier/curve.hpp>

namespace seamwright {

/// A (rational) B-spline curve with clamped ends, stored by its homogeneous poles.
///
/// Knots are flat: each is repeated by its multiplicity, degree + 1 times at both ends. The struct
/// does not check its numbers; requireValid() tells whether they make a curve.
struct BSplineCurve {
  int degree = 0;
  std::vector<double> knots;
  HomogeneousPoles poles;

  int count() const { return static_cast<int>(knots.size()) - degree - 1; }

  bool operator==(const BSplineCurve& other) const {
    return degree == other.degree && knots == other.knots && poles.rows() == other.poles.rows() &&
           poles == other.poles;
  }
};

/// Requires a valid curve: a degree of 1 to 25, and inner knots of multiplicity at most the degree,
/// so that the curve is continuous.
/// \throws std::invalid_argument, with the index and the value, if counts and knots do not match,
/// if knots decrease or are not clamped, if a number or the range of the knots is not finite, or if
/// a weight is not positive.
void requireValid(const BSplineCurve& curve);

/// The Bézier curve as a B-spline curve with knots 0 and 1.
BSplineCurve splineCurve(const BezierCurve& curve);

/// Point and derivatives up to \p order, (order + 1) by 3. At a knot they are those of the side of
/// larger parameters; at the end of the range, those from inside. Beyond the range the outermost
/// polynomials continue. Identities (each has a test of its number):
///   (1) For splineCurve(curve) the result is curve.derivatives().
///   (2) Within a span row k + 1 is the derivative of row k.
/// The cost is O(poles), because the whole curve is checked. Where a value exceeds the range of a
/// double, the derivatives of a rational curve from that order on are not finite.
/// \throws std::invalid_argument as requireValid() does, and for a parameter that is not finite or
/// a negative order.
CurveDerivatives derivatives(const BSplineCurve& curve, double t, int order);

}  // namespace seamwright
