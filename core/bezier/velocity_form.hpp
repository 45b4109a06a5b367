// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <utility>

#include <seamwright/core/bernstein/polynomial.hpp>
#include <seamwright/core/bezier/curve.hpp>

/// Bernstein forms that vanish where the velocity or the curvature of a curve vanishes, rounding
/// included; shared by degeneracies and lengths, not a public header.
namespace seamwright {

using VectorForm = std::array<BernsteinPolynomial, 3>;

/// The velocity of a curve: X' = unit_mm velocity / divisor.
///
/// Let X = A / w and A = (1 - t) A_0 + t A_1, and the same for w. A_0 has the first n poles, A_1
/// the last n. Then X' = n (A_1 w_0 - A_0 w_1) / w^2, of degree 2 n - 2 with the divisor w^2. For a
/// polynomial curve the degree is n - 1 and the divisor is constant.
/// Source: docs/theory/curves.md C1.4, C1.5.
struct VelocityForm {
  VectorForm velocity;
  BernsteinPolynomial divisor;
  double least_divisor;  ///< lower bound over the whole curve, positive
  double unit_mm;        ///< a power of two; 1 unless the numbers are extreme

  /// A positive interval that contains the divisor over this piece.
  Interval divisorRange() const;
  std::pair<VelocityForm, VelocityForm> halves() const;
  VelocityForm restricted(const Interval& domain) const;
};

VelocityForm velocityForm(const BezierCurve& curve);

/// The form of X' x X'', up to a positive factor.
///
/// Let A_0, A_1, A_2 have the poles without the last two, without both ends, and without the first
/// two. The product is (w_0 A_1 x A_2 + w_1 A_2 x A_0 + w_2 A_0 x A_1) / w^3 times n^2 (n - 1), of
/// degree 3 n - 6. For a polynomial curve the degree is 2 n - 4.
/// Source: docs/theory/curves.md C1.4.
VectorForm curvatureForm(const BezierCurve& curve);

std::pair<VectorForm, VectorForm> halves(const VectorForm& form);
/// Bound of the distance between the true coefficients and the stored ones.
double padding(const VectorForm& form);
/// The largest norm of a stored coefficient.
double largestNorm(const VectorForm& form);
/// A lower bound of the norm over [0, 1], from the components of the coefficients along their mean;
/// 0 if no positive bound is found.
double lowerNorm(const VectorForm& form);
BernsteinPolynomial squaredNorm(const VectorForm& form);

}  // namespace seamwright
