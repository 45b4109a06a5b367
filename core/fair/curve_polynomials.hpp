// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include <seamwright/core/bernstein/polynomial.hpp>
#include <seamwright/core/bezier/curve.hpp>

namespace seamwright {

using PolynomialVector = std::array<BernsteinPolynomial, 3>;

/// A curve as polynomials whose padding covers all rounding. With the point p from a given origin,
/// in a given unit: p = point / weight, and p' = velocity / weight^2. A polynomial curve has a
/// weight of degree 0.
struct CurvePolynomials {
  BernsteinPolynomial weight;
  PolynomialVector point;
  PolynomialVector velocity;
};

/// \param unit a power of 2, so that the division is exact.
/// Source: docs/theory/planar.md P8.2.
CurvePolynomials curvePolynomials(const BezierCurve& curve, const Eigen::RowVector3d& origin,
                                  double unit = 1);

}  // namespace seamwright
