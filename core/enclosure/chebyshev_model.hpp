// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <seamwright/core/bernstein/interval.hpp>

namespace seamwright {

/// A function on [-1, 1] that is known up to a radius: a Chebyshev series of degree at most 7. The
/// function is nowhere further from the series than radius().
///
/// Sums and products of models, and the functions below, give models of the sum, the product and
/// the function. The radius takes up what a series of that degree cannot hold and what rounding may
/// have changed, so the function never leaves its model. On a shorter piece of a curve the same
/// computation gives a smaller radius: the remainder of a smooth function falls with the eighth
/// power of the length. An infinite radius means that nothing is known, for instance after division
/// by a function that may vanish.
///
/// Rounding: let u = 2^-53. A coefficient of a sum is off by u times its value. A product of two
/// models of degrees m and n is summed up by itself before it is added to a sum of products. Its
/// coefficients are off by at most min(m, n) + 3 times u times the sum of the absolute values, and
/// each of the products that are added from then on adds u times the sum up to there. As
/// |T_k| <= 1, the radius grows by at most the sum of these errors.
/// Radii are computed with a relative surplus of 2^-48 instead of directed rounding.
///
/// Identities (each has a test of its number):
///   (1) The sum, product, inverse, inverse square root, sine or cosine of the functions lies in
///       the model that the operation returns.
///   (2) range() contains every value; its excess falls with the square of the length of the piece.
///   (3) Halving the interval divides the radius of an analytic function by about 2^8.
///
/// Source: docs/theory/enclosures.md E2.1 to E2.3, E4.2; [BrisebarreJoldes2010]; [MakinoBerz2003].
class ChebyshevModel {
 public:
  /// A choice: halving the interval then gains 2^8 (3), and a product of two models takes 64
  /// products of numbers.
  static constexpr int max_degree = 7;
  static constexpr int size = max_degree + 1;
  /// Leading terms whose sum is less than this share of all terms except the constant go into the
  /// radius. So short pieces need few terms.
  static constexpr double negligible = 0x1p-34;
  using Coefficients = std::array<double, size>;

  ChebyshevModel() = default;
  explicit ChebyshevModel(double constant) { coefficients_[0] = constant; }
  /// The function middle + half x, known up to \p radius.
  static ChebyshevModel linear(double middle, double half, double radius);
  /// A series of any length, known up to \p radius; the terms above max_degree go into the radius.
  static ChebyshevModel series(std::span<const double> coefficients, double radius);
  /// The model of a function of which nothing is known: its radius is infinite.
  static ChebyshevModel unknown();

  int degree() const { return degree_; }
  double coefficient(int k) const { return coefficients_[k]; }
  /// All coefficients; those above the degree are zero.
  const Coefficients& coefficients() const { return coefficients_; }
  double radius() const { return radius_; }
  bool isKnown() const;
  /// The value of the series at x in [-1, 1], with rounding.
  double seriesAt(double x) const;
  /// Upper bound of the absolute value on [-1, 1].
  double magnitude() const;
  /// An interval that contains all values on [-1, 1].
  Interval range() const;
  /// Coefficients of the series in Bernstein form of that degree, which is not below the degree of
  /// the series. They are off by at most bernsteinRounding().
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
  /// The sum of the absolute values of all coefficients, or a little more.
  double absoluteSum() const { return std::abs(coefficients_[0]) + variation_; }
  bool isZero() const { return degree_ == 0 && coefficients_[0] == 0 && radius_ == 0; }
  ChebyshevModel& summed(const ChebyshevModel& other);
  void sumUp();
  void trim();

  Coefficients coefficients_{};
  /// The sum of the absolute values of the coefficients except the constant, before the last ones
  /// went into the radius.
  double variation_ = 0;
  double radius_ = 0;
  int degree_ = 0;
};

/// A sum of at most nine products of models. The sum is cut to the degree of a model once, at its
/// end.
class ProductSum {
 public:
  ProductSum& add(const ChebyshevModel& a, const ChebyshevModel& b, double factor = 1);
  ChebyshevModel model() const;

 private:
  ChebyshevModel::Coefficients low_{};   ///< twice the coefficients
  ChebyshevModel::Coefficients high_{};  ///< the same of the terms above the degree of a model
  double radius_ = 0;
  double absolute_ = 0;  ///< sum of the absolute values of all products
  int degree_ = 0;
  double roundings_ = 0;  ///< the roundings of each term times its absolute value
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

/// The model of 1 / f; unknown if f may vanish.
ChebyshevModel inverse(const ChebyshevModel& f);
/// The model of 1 / sqrt(f); unknown if f may be zero or negative.
ChebyshevModel inverseSqrt(const ChebyshevModel& f);
/// Cosine and sine of f; unknown if f varies by more than 4 on [-1, 1].
std::pair<ChebyshevModel, ChebyshevModel> cosSin(const ChebyshevModel& f);
/// Hyperbolic cosine and sine of f; unknown if f varies by more than 4 on [-1, 1].
std::pair<ChebyshevModel, ChebyshevModel> coshSinh(const ChebyshevModel& f);

}  // namespace seamwright
