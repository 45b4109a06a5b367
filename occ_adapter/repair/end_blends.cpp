// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Core>
#include <vector>

#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/occ_adapter/repair/end_blends.hpp>

namespace seamwright::occ {

Blends blendsAt(double distance, double span) {
  constexpr int degree = 5, functions = 3;
  static const std::vector<double> knots = {0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4, 4, 4};
  const double x = distance / span;
  if (x >= functions) return {};
  const int at = bspline::spanOf(degree, knots, x);
  const Eigen::MatrixXd basis = bspline::basisDerivatives(degree, knots, at, x, 1);
  Eigen::Matrix<double, 2, functions> first = Eigen::Matrix<double, 2, functions>::Zero();
  for (int k = at - degree; k < functions; ++k) first.col(k) = basis.col(k - at + degree);
  Eigen::Matrix3d factors;
  factors << 1, 0, 0,      //
      1, 1.0 / degree, 0,  //
      1, 3.0 / degree, 2.0 / (degree * (degree - 1));
  const Eigen::Matrix<double, 2, 3> all = first * factors;
  return {all(0, 0), span * all(0, 1), span * span * all(0, 2),   all(1, 0) / span,
          all(1, 1), span * all(1, 2), first(0, 0) + first(0, 1), span * first(0, 1) / degree};
}

}  // namespace seamwright::occ
