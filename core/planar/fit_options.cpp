// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/fit_options.hpp>

namespace seamwright {

void requireFitOptions(double tolerance_mm, double corner_rad) {
  if (!(tolerance_mm > 0 && std::isfinite(tolerance_mm)))
    refuse(fmt::format("the tolerance is {} mm: it must be positive and finite", tolerance_mm));
  if (!(corner_rad > 0 && corner_rad < std::numbers::pi))
    refuse(fmt::format("the corner angle is {} rad: it must be between 0 and pi", corner_rad));
}

}  // namespace seamwright
