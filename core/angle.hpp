// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <numbers>

/// Angles are radians everywhere; degrees are read and shown at the border.
namespace seamwright {

inline constexpr double degrees_per_radian = 180 / std::numbers::pi;
inline constexpr double radians_per_degree = std::numbers::pi / 180;

}  // namespace seamwright
