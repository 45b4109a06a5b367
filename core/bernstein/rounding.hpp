// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <limits>

#include <seamwright/core/bernstein/interval.hpp>

/// Upper bounds of rounding errors; shared by the Bernstein forms, not a public header.
///
/// The bounds hold in every IEEE rounding mode, with or without fused products. They do not hold
/// with -ffast-math, nor with denormals flushed to zero. Bounds are computed in double and rounded
/// upwards by std::nextafter, which is independent of the rounding mode.
namespace seamwright::rounding {

/// Largest relative error of one operation in any rounding mode. For round-to-nearest half of it is
/// enough.
inline constexpr double kUnit = std::numeric_limits<double>::epsilon();
/// Largest absolute error of a product or a quotient that underflows. Sums and differences are
/// exact there.
inline constexpr double kUnderflow = std::numeric_limits<double>::denorm_min();
/// Coefficients and paddings stay below this, so that no convex combination of them overflows.
inline constexpr double kLimit = 0x1p1023;

inline double up(double x) {
  return std::nextafter(x, std::numeric_limits<double>::infinity());
}

/// Upper bound of a + b for a, b >= 0; exact if one of them is 0.
inline double sumUp(double a, double b) {
  if (a == 0) return b;
  return b == 0 ? a : up(a + b);
}
template <class... More>
double sumUp(double a, double b, More... more) {
  return sumUp(sumUp(a, b), more...);
}

/// Upper bound of a b for a, b >= 0; 0 if one of them is 0.
inline double productUp(double a, double b) {
  return a == 0 || b == 0 ? 0 : up(a * b);
}

/// Upper bound of gamma_k = k u / (1 - k u). gamma_k bounds |theta| in 1 + theta = product of k
/// factors (1 + d)^(+-1), |d| <= u (Higham, Accuracy and Stability of Numerical Algorithms, lemma
/// 3.1).
/// \pre 0 <= k < 2^26. There gamma_k <= gamma_(k+1) (1 - gamma_k), so a computed value can stand
/// for an exact one.
inline double gamma(int k) {
  const double relative = k * kUnit;
  return k == 0 ? 0 : up(relative / (1 - relative));
}

/// The numbers from lower - radius to upper + radius. \pre |lower|, |upper|, radius < kLimit.
inline Interval widened(const Interval& interval, double radius) {
  if (radius == 0) return interval;
  return {-up(radius - interval.lower), up(interval.upper + radius)};
}

}  // namespace seamwright::rounding
