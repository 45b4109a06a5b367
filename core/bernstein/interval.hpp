// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>

namespace seamwright {

/// The numbers from lower to upper, both included. \pre lower <= upper.
struct Interval {
  double lower = 0;
  double upper = 0;

  bool contains(double value) const { return lower <= value && value <= upper; }
  bool contains(const Interval& other) const {
    return lower <= other.lower && other.upper <= upper;
  }
  double width() const { return upper - lower; }
  double middle() const { return 0.5 * (lower + upper); }
  /// Largest absolute value.
  double magnitude() const { return std::max(-lower, upper); }

  static Interval hull(const Interval& a, const Interval& b) {
    return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
  }
};

}  // namespace seamwright
