// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <span>
#include <utility>

#include <seamwright/core/bernstein/interval.hpp>

namespace seamwright {

/// A function on [-1, 1] that is known up to a radius: a Chebyshev series of degree at most 7, from
/// which the function is nowhere further than radius().
///
/// Sums and products of models, and the functions below, give models of the sum, the product and
/// the function: what a series of that degree cannot hold and what rounding may have changed is
/// added to the radius, so the function never leaves its model. On a shorter piece of a curve the
/// same computation gives a smaller radius: the part of a smooth function that is left over falls
/// with the eighth power of the length. An infinite radius says that nothing is known, for instance
/// after division by a function that may vanish.
///
/// Rounding: with u = 2^-53, a coefficient of a sum is off by u of its value. A coefficient of a
/// sum of products of models is a sum of at most 2 min(m, n) + 3 products of coefficients for each
/// product of models of degrees m and n, off by as many u times the sum of their absolute values.
/// As |T_k| <= 1, the radius grows by no more than these errors summed up. Radii are computed with
/// a relative surplus of 2^-48 in place of directed rounding.
///
/// Identities (each has a test of its number):
///   (1) The function of a sum, product, inverse, inverse square root, sine, cosine lies in the
///       model of it.
///   (2) range() contains every value; its excess falls with the square of the length of the piece.
///   (3) Halving the interval divides the radius of an analytic function by about 2^8.
///
/// Source: docs/theory/enclosures.md E2.1 to E2.3, E4.2; [BrisebarreJoldes2010]; [MakinoBerz2003].
class ChebyshevModel {
 public:
  static constexpr int max_degree = 7;
  static constexpr int size = max_degree + 1;
  /// Leading terms that sum up to less than this part of all terms but the constant go into the
  /// radius: short pieces need few.
  static constexpr double negligible = 0x1p-34;
  using Coefficients = std::array<double, size>;

  ChebyshevModel() = default;
  explicit ChebyshevModel(double constant) { coefficients_[0] = constant; }
  /// middle + half x, up to \p radius.
  static ChebyshevModel linear(double middle, double half, double radius);
  /// A series of any length, up to \p radius; the terms above max_degree go into the radius.
  static ChebyshevModel series(std::span<const double> coefficients, double radius);
  /// Nothing is known.
  static ChebyshevModel unknown();

  int degree() const { return degree_; }
  double coefficient(int k) const { return coefficients_[k]; }
  double radius() const { return radius_; }
  bool isKnown() const;
  /// The series at x in [-1, 1], rounded.
  double seriesAt(double x) const;
  /// A bound of the absolute value on [-1, 1].
  double magnitude() const;
  /// Contains all values on [-1, 1].
  Interval range() const;
  /// Coefficients of the series in Bernstein form of a degree that is not below its own; off by at
  /// most bernsteinRounding().
  Coefficients bernstein(int degree) const;
  double bernsteinRounding() const;

  ChebyshevModel& operator+=(const ChebyshevModel& other);
  ChebyshevModel& operator-=(const ChebyshevModel& other);
  ChebyshevModel& operator*=(double factor);
  ChebyshevModel operator-() const;
  void widen(double radius);

 private:
  friend class ProductSum;
  friend ChebyshevModel combination(const std::array<double, 3>& factors,
                                    const std::array<const ChebyshevModel*, 3>& models);
  void trim();

  Coefficients coefficients_{};
  double radius_ = 0;
  int degree_ = 0;
};

/// A sum of at most six products of models, cut to the degree of a model once at its end.
class ProductSum {
 public:
  ProductSum& add(const ChebyshevModel& a, const ChebyshevModel& b, double sign = 1);
  ChebyshevModel model() const;

 private:
  std::array<double, 2 * ChebyshevModel::size> twice_{};  ///< twice the coefficients
  double radius_ = 0;
  double absolute_ = 0;  ///< sum of the absolute values of all products
  int degree_ = 0;
  int terms_ = 0;  ///< in a coefficient, at most
};

inline ChebyshevModel operator+(ChebyshevModel a, const ChebyshevModel& b) {
  return a += b;
}
inline ChebyshevModel operator-(ChebyshevModel a, const ChebyshevModel& b) {
  return a -= b;
}
inline ChebyshevModel operator*(ChebyshevModel a, double factor) {
  return a *= factor;
}
inline ChebyshevModel operator*(double factor, ChebyshevModel a) {
  return a *= factor;
}
ChebyshevModel operator*(const ChebyshevModel& a, const ChebyshevModel& b);

/// The sum of three models times numbers.
ChebyshevModel combination(const std::array<double, 3>& factors,
                           const std::array<const ChebyshevModel*, 3>& models);

/// 1 / f; unknown if f may vanish.
ChebyshevModel inverse(const ChebyshevModel& f);
/// 1 / sqrt(f); unknown if f may fail to be positive.
ChebyshevModel inverseSqrt(const ChebyshevModel& f);
/// Cosine and sine of f; unknown if f varies by more than 4 on [-1, 1].
std::pair<ChebyshevModel, ChebyshevModel> cosSin(const ChebyshevModel& f);
/// Hyperbolic cosine and sine of f; unknown if f varies by more than 4 on [-1, 1].
std::pair<ChebyshevModel, ChebyshevModel> coshSinh(const ChebyshevModel& f);

}  // namespace seamwright
