// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <utility>

#include <seamwright/core/bernstein/interval.hpp>
#include <seamwright/core/bernstein/polynomial.hpp>

namespace seamwright {

/// A real polynomial f(u, v) = sum_ij c_ij B_i^m(u) B_j^n(v) on [0, 1]^2, known up to rounding.
///
/// Padding has the same meaning as for BernsteinPolynomial: each true coefficient lies within it of
/// the stored one, and each operation adds its own rounding. The bounds are those given there, in
/// the direction of the operation (degree m in u, n in v), except:
///
///   f g            k = (min(m_f, m_g) + 1) (min(n_f, n_g) + 1) + 6 + the r of all six binomials
///   restriction    that of u, then that of v
///   evaluate       radius e + gamma_(3m+3n+1) sum_ij |c_ij| B_i^m(u) B_j^n(v) + 4 (m + n) eta
///   composition    m + n steps (1 - w) a + w b with w = u(t) or v(t)
///
/// A step of the composition takes the padding e of its operands to e (1 + 2 x + 2 e_w) + e_w max|b
/// - a| + gamma_(k+4) (M_(1-w) M_a + M_w M_b) + 2 eta, with k as in a product, and x how far the
/// coefficients of w leave [0, 1]. As long as these are exact and stay inside, paddings add up and
/// do not multiply.
///
/// Identities, true within the padding (each has a test of its number):
///   (1) All coefficients 1: f(u, v) = 1.
///   (2) (f g)(u, v) = f(u, v) g(u, v), (f + g)(u, v) = f(u, v) + g(u, v).
///   (3) (f g)_u = f_u g + f g_u, the same in v; f_uv = f_vu.
///   (4) Elevation changes no value.
///   (5) The pieces of a split and the restriction to a box take the values of f.
///   (6) range() contains all values. Its excess shrinks by a factor of 4 when both sides of the
///       square are halved.
///   (7) The curve at an edge takes the values of f there.
///   (8) f.composed(u, v)(t) = f(u(t), v(t)).
///
/// Limits, overflow and rounding modes are those of BernsteinPolynomial.
/// Source: docs/theory/enclosures.md E1.1 to E1.4, E4.1.
class BernsteinTensor {
 public:
  /// An edge of the square, named by the parameter that is constant on it.
  enum class Edge { U0, U1, V0, V1 };

  /// \param coefficients (m+1) by (n+1), rows in u. \param padding not negative.
  /// \throws std::invalid_argument as BernsteinPolynomial does, with row and column of the invalid
  /// coefficient.
  explicit BernsteinTensor(Eigen::MatrixXd coefficients, double padding = 0);

  int degreeU() const { return static_cast<int>(coefficients_.rows()) - 1; }
  int degreeV() const { return static_cast<int>(coefficients_.cols()) - 1; }
  const Eigen::MatrixXd& coefficients() const { return coefficients_; }
  double padding() const { return padding_; }

  /// An interval that contains f(u, v). \throws std::invalid_argument if u or v is not in [0, 1].
  Interval evaluate(double u, double v) const;
  /// The derivative by u, of degree m - 1 in u; that of a function of v alone (degree 0 in u) is 0.
  BernsteinTensor partialU() const;
  BernsteinTensor partialV() const;
  /// The same polynomial written in degrees m + by_u, n + by_v.
  /// \throws std::invalid_argument if by_u or by_v is negative, or if the new degrees add up to
  /// more than 800.
  BernsteinTensor elevated(int by_u, int by_v) const;
  /// The pieces over u in [0, t] and [t, 1], each reparametrised to [0, 1]^2.
  /// \throws std::invalid_argument if t is not in [0, 1].
  std::pair<BernsteinTensor, BernsteinTensor> splitU(double t) const;
  std::pair<BernsteinTensor, BernsteinTensor> splitV(double t) const;
  /// The piece over a box within [0, 1]^2, reparametrised to [0, 1]^2; the box may be flat.
  /// \throws std::invalid_argument if one of the intervals is not in [0, 1] or is reversed.
  BernsteinTensor restricted(const Interval& u, const Interval& v) const;
  /// f along an edge, as a polynomial of the other parameter.
  BernsteinPolynomial edge(Edge edge) const;
  /// f(v, u).
  BernsteinTensor transposed() const;

  /// An interval that contains f(u, v) for all (u, v) in [0, 1]^2: the hull of the coefficients,
  /// widened by the padding.
  Interval range() const;
  /// f along the parameter curve (u(t), v(t)), by de Casteljau's algorithm with polynomials as
  /// parameters. The degree is k m + l n for u of degree k and v of degree l. The result holds for
  /// any u and v. Its padding stays small if the coefficients of u and v lie in [0, 1]; where only
  /// the values of the curve lie there, splitting the curve brings the coefficients into [0, 1].
  BernsteinPolynomial composed(const BernsteinPolynomial& u, const BernsteinPolynomial& v) const;

  BernsteinTensor operator-() const;
  bool operator==(const BernsteinTensor& other) const;

 private:
  Eigen::MatrixXd coefficients_;
  double padding_;
};

/// Sum, difference and product; the degrees may differ.
/// \throws std::invalid_argument if the degrees of the product in u and v add up to more than 800.
BernsteinTensor operator+(const BernsteinTensor& f, const BernsteinTensor& g);
BernsteinTensor operator-(const BernsteinTensor& f, const BernsteinTensor& g);
BernsteinTensor operator*(const BernsteinTensor& f, const BernsteinTensor& g);
/// \throws std::invalid_argument if the factor is not finite.
BernsteinTensor operator*(double factor, const BernsteinTensor& f);

}  // namespace seamwright
