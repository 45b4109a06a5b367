// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/fair/fair_curve.hpp>

/// Polynomial curves whose poles move; not a public header.
namespace seamwright {

/// \throws std::invalid_argument as requireValid(BSplineCurve) does, for a rational curve and for a
/// degree of 1.
void requirePolynomial(const BSplineCurve& curve);

/// \throws std::invalid_argument for a tolerance that is negative or not finite.
void requireFairingTolerance(double tolerance_mm);

Poles polynomialPoles(const BSplineCurve& curve);
BSplineCurve withPoles(const BSplineCurve& curve, const Poles& poles);

/// The largest distance of a Bézier pole of the spline with these poles from the origin.
double largestPole_mm(const BSplineCurve& knots, const Poles& poles);

/// Bound of the distance of points of the same parameter of curves with the same knots and weights,
/// for poles as they are stored.
double boundOfMoves_mm(const BSplineCurve& given, const BSplineCurve& moved);

/// The poles that are free if the ends are held.
struct FreePoles {
  Eigen::Index first = 0, count = 0;

  FreePoles(Eigen::Index poles, HeldEnds ends);
};

}  // namespace seamwright
