// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <seamwright/core/numeric.hpp>
#include <seamwright/plugin/cli/rounding.hpp>
#include <stdexcept>

namespace seamwright::cli {

double roundingOf_mm(const Eigen::VectorXd& largest_mm) {
  return machine_epsilon * largest_mm.lpNorm<1>();
}

void requireAboveRounding(double tolerance_mm, const Eigen::VectorXd& largest_mm) {
  // As for curves far from the origin: below it the rounding would take more than an eighth.
  constexpr double least_ratio = 8;
  const double rounding_mm = roundingOf_mm(largest_mm);
  if (tolerance_mm == 0 || tolerance_mm >= least_ratio * rounding_mm) return;
  throw std::domain_error(
      fmt::format("the tolerance {:.3g} mm is too small for coordinates of {:.3g} mm, which are "
                  "rounded by {:.3g} mm: give at least {:.3g} mm",
                  tolerance_mm, largest_mm.maxCoeff(), rounding_mm, least_ratio * rounding_mm));
}

void requireAboveRounding(double tolerance_mm, const GivenCurve& given) {
  Eigen::Vector2d largest_mm = Eigen::Vector2d::Zero();
  if (given.points.rows() > 0) largest_mm = given.points.cwiseAbs().colwise().maxCoeff();
  for (const ChainCurve& curve : given.chain.curves)
    for (const BezierCurve& one : bezierCurves(curve))
      largest_mm = largest_mm.cwiseMax(
          one.poles().leftCols<2>().cwiseAbs().colwise().maxCoeff().transpose());
  requireAboveRounding(tolerance_mm, Eigen::VectorXd(largest_mm));
}

}  // namespace seamwright::cli
