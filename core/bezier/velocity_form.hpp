// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <utility>

#include <seamwright/core/bernstein/polynomial.hpp>
#include <seamwright/core/bezier/curve.hpp>

/// Bernstein forms of what a curve's velocity and curvature vanish with, rounding included; shared
/// by degeneracies and lengths, not a public header.
namespace seamwright {

using VectorForm = std::array<BernsteinPolynomial, 3>;

/// X' = unit_mm velocity / divisor.
///
/// With X = A / w, A = (1 - t) A_0 + t A_1 and the same for w (A_0 has the first n poles, A_1 the
/// last n), X' = n (A_1 w_0 - A_0 w_1) / w^2: degree 2 n - 2, divisor w^2. A polynomial curve has
/// degree n - 1, and a constant for divisor.
/// Source: docs/theory/curves.md C1.4, C1.5.
struct VelocityForm {
  VectorForm velocity;
  BernsteinPolynomial divisor;
  double least_divisor;  ///< over the whole curve, positive
  double unit_mm;        ///< a power of two; 1 unless numbers are extreme

  /// Contains the divisor over this piece, and is positive.
  Interval divisorRange() const;
  std::pair<VelocityForm, VelocityForm> halves() const;
  VelocityForm restricted(const Interval& domain) const;
};

VelocityForm velocityForm(const BezierCurve& curve);

/// X' x X'' up to a positive factor.
///
/// With A_0, A_1, A_2 of the poles without the last two, without the ends, without the first two,
/// it is (w_0 A_1 x A_2 + w_1 A_2 x A_0 + w_2 A_0 x A_1) / w^3 times n^2 (n - 1): degree 3 n - 6. A
/// polynomial curve has degree 2 n - 4.
/// Source: docs/theory/curves.md C1.4.
VectorForm curvatureForm(const BezierCurve& curve);

std::pair<VectorForm, VectorForm> halves(const VectorForm& form);
/// Bound of how far the true coefficients are from those stored.
double padding(const VectorForm& form);
/// The largest stored coefficient.
double largestNorm(const VectorForm& form);
/// A lower bound of the norm over [0, 1], by the coefficients along their mean; 0 if none is seen.
double lowerNorm(const VectorForm& form);
BernsteinPolynomial squaredNorm(const VectorForm& form);

}  // namespace seamwright
