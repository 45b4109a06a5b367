// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

/// Not a public header.
namespace seamwright {

/// The point, or one on the way back to \p original that is certainly not further away than the
/// tolerance: rounding of large coordinates can exceed it.
inline Eigen::RowVector2d withinDistance(Eigen::RowVector2d point,
                                         const Eigen::RowVector2d& original, double tolerance_mm) {
  for (double back = 0x1p-50; (point - original).norm() > tolerance_mm && back < 1; back *= 2)
    point = original + (1 - back) * (point - original);
  return (point - original).norm() <= tolerance_mm ? point : original;
}

/// \throws std::invalid_argument unless there is a tolerance for each point, at least 0 and finite.
void requireTolerances(const Eigen::VectorXd& tolerances_mm, Eigen::Index count);

}  // namespace seamwright
