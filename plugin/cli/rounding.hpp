// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/plugin/cli/curve_methods.hpp>

namespace seamwright::cli {

/// Half of the last digit of each coordinate, which may be twice as large in a result.
double roundingOf_mm(const Eigen::VectorXd& largest_mm);

/// \param largest_mm the largest size of each coordinate. A tolerance of 0 asks for no distance.
/// \throws std::domain_error for a tolerance below eight times the rounding of the coordinates.
void requireAboveRounding(double tolerance_mm, const Eigen::VectorXd& largest_mm);

/// The same for points or poles.
void requireAboveRounding(double tolerance_mm, const GivenCurve& given);

}  // namespace seamwright::cli
