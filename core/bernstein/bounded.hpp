// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <seamwright/core/bernstein/rounding.hpp>

namespace seamwright {

/// A computed number with a bound of its error; not a public header. The error is infinite where
/// nothing is known of the true number. The bounds hold under the conditions of rounding.hpp. Sums
/// with 0, differences of equal numbers and products with 0 or 1 are exact.
struct Bounded {
  double value = 0;
  double error = 0;

  Bounded() = default;
  /// The number is exact.
  explicit Bounded(double number) : value(number) {}
  /// A number that is not finite gets an infinite error.
  Bounded(double number, double radius) : value(number), error(radius) {
    if (!std::isfinite(number)) *this = unknown();
  }

  double size() const { return std::abs(value); }
  /// Upper and lower bound of the absolute value of the true number.
  double sizeUpper() const { return rounding::sumUp(size(), error); }
  double sizeLower() const { return size() > error ? -rounding::up(error - size()) : 0; }

  Bounded operator-() const { return {-value, error}; }
  Bounded& operator+=(const Bounded& other) { return *this = *this + other; }
  Bounded& operator-=(const Bounded& other) { return *this = *this + -other; }

  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    const double sum = a.value + b.value;
    const bool exact = a.value == 0 || b.value == 0;
    return {sum, rounding::sumUp(a.error, b.error, exact ? 0 : ofResult(sum))};
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) { return a + -b; }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    using rounding::productUp;
    const double product = a.value * b.value;
    const bool exact = a.value == 0 || b.value == 0 || a.value == 1 || b.value == 1;
    return {product, rounding::sumUp(productUp(a.size(), b.error), productUp(b.size(), a.error),
                                     productUp(a.error, b.error), exact ? 0 : ofResult(product),
                                     exact ? 0 : rounding::kUnderflow)};
  }
  /// |x / y - a / b| <= (|x - a| + |a / b| |y - b|) / |y|.
  friend Bounded operator/(const Bounded& a, const Bounded& b) {
    const double least = b.sizeLower();
    if (least == 0) return unknown();
    const double quotient = a.value / b.value;
    const bool exact = a.value == 0 || b.value == 1;
    const double larger = exact ? std::abs(quotient) : rounding::up(std::abs(quotient));
    const double inherited = rounding::sumUp(a.error, rounding::productUp(larger, b.error));
    return {quotient,
            rounding::sumUp(inherited == 0 ? 0 : rounding::up(inherited / least),
                            exact ? 0 : ofResult(quotient), exact ? 0 : rounding::kUnderflow)};
  }
  /// |sqrt(x) - sqrt(a)| is at most |x - a| / sqrt(a), and also at most sqrt(|x - a|).
  /// \pre the true number is not negative.
  friend Bounded sqrt(const Bounded& a) {
    const double root = std::sqrt(std::max(a.value, 0.0));
    double inherited = a.error == 0 ? 0 : rounding::up(std::sqrt(a.error));
    if (root > 0) inherited = std::min(inherited, rounding::up(a.error / std::nextafter(root, 0)));
    return {root, rounding::sumUp(inherited, ofResult(root))};
  }
  /// a 2^exponent.
  friend Bounded ldexp(const Bounded& a, int exponent) {
    const double result = std::ldexp(a.value, exponent);
    const bool exact = a.value == 0 || std::abs(result) >= std::numeric_limits<double>::min();
    return {result, rounding::sumUp(a.error == 0 ? 0 : rounding::up(std::ldexp(a.error, exponent)),
                                    exact ? 0 : rounding::kUnderflow)};
  }

 private:
  static Bounded unknown() { return {0, std::numeric_limits<double>::infinity()}; }
  static double ofResult(double result) {
    return rounding::productUp(rounding::kUnit, std::abs(result));
  }
};

}  // namespace seamwright
