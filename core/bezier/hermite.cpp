// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/bezier/hermite.hpp>

namespace seamwright {

Poles polesFrom(const CurveDerivatives& derivatives, int degree) {
  const auto count = derivatives.rows();
  Poles differences = derivatives;
  double factor = 1;
  for (Eigen::Index k = 1; k < count; ++k) {
    factor *= degree - static_cast<double>(k) + 1;
    differences.row(k) /= factor;
  }
  // Column of differences to poles: the poles are the sums of the difference table.
  for (Eigen::Index k = count - 1; k > 0; --k)
    for (Eigen::Index i = k; i < count; ++i) differences.row(i) += differences.row(i - 1);
  return differences;
}

}  // namespace seamwright
