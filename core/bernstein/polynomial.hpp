// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <utility>

#include <seamwright/core/bernstein/interval.hpp>

namespace seamwright {

/// A real polynomial p(t) = sum_i c_i B_i^n(t) on [0, 1], known up to rounding.
///
/// The class stores n + 1 coefficients and one number, the padding. Each true coefficient, and
/// hence p(t) for all t, is within the padding of the stored one. Given doubles have padding 0.
/// That of a result covers those of the operands and the rounding of the operation, in every
/// rounding mode of IEEE doubles, denormals included, but not under -ffast-math.
/// docs/theory/enclosures.md E1.2 bounds it.
///
///     const BernsteinPolynomial p(Eigen::Vector3d(1, -2, 1));  // 1 - 6 t + 6 t^2
///     const Interval range = (p * p.derivative()).range(1e-6);
///
/// evaluate(t) has the radius e + gamma_(3n+1) sum_i |c_i| B_i^n(t) + 4 n eta (only e at 0 and 1),
/// with e the padding, u = 2^-52, gamma_k = k u / (1 - k u) and eta = 2^-1074.
///
/// Identities, true within the padding (each has a test of its number):
///   (1) All coefficients 1: p(t) = 1 (partition of unity).
///   (2) (p q)(t) = p(t) q(t), (p + q)(t) = p(t) + q(t).
///   (3) (p q)' = p' q + p q'.
///   (4) Elevation changes no value.
///   (5) The pieces of a split take the values of p: left(s) = p(t s), right(s) = p(t + (1 - t) s);
///       restricted({a, b})(s) = p(a + (b - a) s).
///   (6) range() contains p(t) for all t in [0, 1]. Its excess shrinks by a factor of 4 when the
///       interval is halved.
///   (7) The ends are known as well as the coefficients: evaluate(0) is c_0 and evaluate(1) is c_n,
///       within e.
///
/// Coefficients and padding are below 2^1023 in size. An operation whose result exceeds that throws
/// std::overflow_error. No result is ever NaN or infinite, except that a bound of an interval may
/// be infinite.
/// Source: docs/theory/enclosures.md E1.1 to E1.3, E4.1; [FaroukiRajan1987].
class BernsteinPolynomial {
 public:
  /// \param coefficients n + 1 >= 1 numbers. \param padding not negative.
  /// \throws std::invalid_argument if there is no coefficient, if a coefficient is not finite or
  /// not below 2^1023 in size (the message has its index and value), or if the padding is out of
  /// range.
  explicit BernsteinPolynomial(Eigen::VectorXd coefficients, double padding = 0);

  int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
  const Eigen::VectorXd& coefficients() const { return coefficients_; }
  double padding() const { return padding_; }

  /// An interval that contains p(t). \throws std::invalid_argument if t is not in [0, 1].
  Interval evaluate(double t) const;
  /// The derivative, of degree n - 1; that of a constant is the constant 0.
  BernsteinPolynomial derivative() const;
  /// The same polynomial written in degree n + by. The end coefficients are kept, or change by a
  /// rounding within the padding.
  /// \throws std::invalid_argument if by < 0 or n + by > 800.
  BernsteinPolynomial elevated(int by) const;
  /// The pieces over [0, t] and [t, 1], each reparametrised to [0, 1]. At t = 0 or 1 one of them is
  /// a constant.
  /// \throws std::invalid_argument if t is not in [0, 1].
  std::pair<BernsteinPolynomial, BernsteinPolynomial> split(double t) const;
  /// The piece over an interval within [0, 1], reparametrised to [0, 1]; over a point it is a
  /// constant.
  /// \throws std::invalid_argument if the interval is not in [0, 1] or is reversed.
  BernsteinPolynomial restricted(const Interval& domain) const;

  /// An interval that contains p(t) for all t in [0, 1]: the hull of the coefficients, widened by
  /// the padding.
  Interval range() const;
  /// The same by subdivision, until the interval exceeds the true range by at most \p tolerance.
  /// The padding may prevent that. Then each end is off by at most 3 times the padding of the piece
  /// [a, b] that gives it. The padding of that piece is the padding of p plus log2(1 / (b - a))
  /// times what a split adds.
  /// \param tolerance not negative, in the unit of p; 0 asks for the best range that the padding
  /// allows.
  /// \throws std::invalid_argument if the tolerance is negative or NaN.
  Interval range(double tolerance) const;

  BernsteinPolynomial operator-() const;
  bool operator==(const BernsteinPolynomial& other) const;

 private:
  Eigen::VectorXd coefficients_;
  double padding_;
};

/// Sum, difference and product; the degrees may differ.
/// \throws std::invalid_argument if the degree of the product is above 800 (its binomials would
/// leave the range of a double).
BernsteinPolynomial operator+(const BernsteinPolynomial& p, const BernsteinPolynomial& q);
BernsteinPolynomial operator-(const BernsteinPolynomial& p, const BernsteinPolynomial& q);
BernsteinPolynomial operator*(const BernsteinPolynomial& p, const BernsteinPolynomial& q);
/// \throws std::invalid_argument if the factor is not finite.
BernsteinPolynomial operator*(double factor, const BernsteinPolynomial& p);

}  // namespace seamwright
