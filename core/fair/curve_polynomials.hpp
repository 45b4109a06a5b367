// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include <seamwright/core/bernstein/polynomial.hpp>
#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/bezier/stopped_ends.hpp>

namespace seamwright {

using PolynomialVector = std::array<BernsteinPolynomial, 3>;

/// A curve as polynomials whose padding covers all rounding. With the point p from a given origin,
/// in a given unit: p = point / weight, and p' = t^a (1 - t)^b velocity / weight^2, with the
/// stopped ends a and b. A polynomial curve has a weight of degree 0.
struct CurvePolynomials {
  BernsteinPolynomial weight;
  PolynomialVector point;
  PolynomialVector velocity;
  StoppedEnds stops;
};

/// \param unit a power of 2, so that the division is exact.
/// Source: docs/theory/planar.md P8.2, P8.7.
CurvePolynomials curvePolynomials(const BezierCurve& curve, const Eigen::RowVector3d& origin,
                                  double unit = 1);

}  // namespace seamwright
