// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/bezier/curve.hpp>

namespace seamwright {

/// A (rational) B-spline curve with clamped ends, stored by its homogeneous poles.
///
/// Knots are flat: each repeated by its multiplicity, degree + 1 times at both ends. The numbers
/// are plain; requireValid() says whether they make a curve.
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

/// Degrees are 1 to 25; inner knots have multiplicity at most the degree, so the curve is
/// continuous.
/// \throws std::invalid_argument if counts and knots do not fit, knots decrease or are not clamped,
/// a number or the range of the knots is not finite, or a weight is not positive; with the index
/// and the value.
void requireValid(const BSplineCurve& curve);

/// The same curve with knots 0 and 1.
BSplineCurve splineCurve(const BezierCurve& curve);

/// Point and derivatives to that order, (order + 1) by 3. At a knot they are those of the side of
/// greater parameters, at the end of the range those from inside; beyond the range the outermost
/// polynomials go on. Identities (each has a test of its number):
///   (1) Of splineCurve(curve) it is curve.derivatives().
///   (2) Within a span row k + 1 is the derivative of row k.
/// O(poles): the whole curve is checked. Where a value is beyond what a double holds, those of a
/// rational curve from its order on are not numbers.
/// \throws std::invalid_argument as requireValid() does, for a parameter that is not finite and for
/// a negative order.
CurveDerivatives derivatives(const BSplineCurve& curve, double t, int order);

}  // namespace seamwright
