// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>
#include <stdexcept>
#include <string>

namespace seamwright {

/// The distance from 1 to the next double, 2^-52: twice the largest relative error of one rounding.
inline constexpr double machine_epsilon = std::numeric_limits<double>::epsilon();

inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// The highest degree of splines, as in OpenCASCADE.
inline constexpr int max_spline_degree = 25;

/// Throws std::invalid_argument with this text.
[[noreturn]] inline void refuse(const std::string& text) {
  throw std::invalid_argument(text);
}

}  // namespace seamwright
