// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>

/// Numbers with a separate exponent: powers of a high degree, and parameters near an end, exceed
/// the range of a double. Not a public header.
namespace seamwright {

/// The number mantissa 2^exponent.
struct GradedTerm {
  int exponent = 0;
  double mantissa = 0;

  explicit GradedTerm(double value, int shift = 0) {
    mantissa = std::frexp(value, &exponent);
    exponent += shift;
  }
  GradedTerm times(double factor) const { return GradedTerm(mantissa * factor, exponent); }
  GradedTerm times(const GradedTerm& other) const {
    return GradedTerm(mantissa * other.mantissa, exponent + other.exponent);
  }
  GradedTerm over(const GradedTerm& other) const {
    return GradedTerm(mantissa / other.mantissa, exponent - other.exponent);
  }
  bool exceeds(const GradedTerm& other) const {
    if (mantissa == 0 || other.mantissa == 0) return mantissa != 0;
    if (exponent != other.exponent) return exponent > other.exponent;
    return std::abs(mantissa) > std::abs(other.mantissa);
  }
  /// The number divided by 2^unit; 0 if it is far below the range of a double.
  double overPowerOf2(int unit) const { return std::ldexp(mantissa, exponent - unit); }
};

/// The exponent that stands for a parameter of 0. It is so small that, for any weights, only the
/// first terms of each order count.
constexpr int graded_end_exponent = -(1 << 14);

inline GradedTerm gradedParameter(double t) {
  return t == 0 ? GradedTerm(1, graded_end_exponent) : GradedTerm(t);
}

/// The index of the term of largest absolute value.
inline std::size_t largestTerm(const std::vector<GradedTerm>& terms) {
  std::size_t largest = 0;
  for (std::size_t i = 1; i < terms.size(); ++i)
    if (terms[i].exceeds(terms[largest])) largest = i;
  return largest;
}

/// The poles poles 2^exponent; all entries of \p poles are below 1.
struct LocalPoles {
  Poles poles;
  int exponent = 0;
};

/// The affine poles relative to the pole with index \p pivot. \throws std::invalid_argument if a
/// distance is not finite.
LocalPoles localPoles(const HomogeneousPoles& poles, Eigen::Index pivot);

}  // namespace seamwright
