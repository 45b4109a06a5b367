// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include <seamwright/core/linear/symmetric_band.hpp>

namespace seamwright::linear {

using Eigen::Index;

SymmetricBand SymmetricBand::block(Index first, Index count) const {
  SymmetricBand result;
  result.lower_ = lower_.middleCols(first, count);
  return result;
}

Eigen::MatrixXd SymmetricBand::times(const Eigen::MatrixXd& factor) const {
  Eigen::MatrixXd result = lower_.row(0).transpose().asDiagonal() * factor;
  for (Index k = 1; k <= std::min(width(), size() - 1); ++k) {
    const Index count = size() - k;
    const auto entries = lower_.row(k).head(count).transpose();
    result.bottomRows(count) += entries.asDiagonal() * factor.topRows(count);
    result.topRows(count) += entries.asDiagonal() * factor.bottomRows(count);
  }
  return result;
}

BandCholesky::BandCholesky(SymmetricBand matrix) : factor_(std::move(matrix)) {
  const Index size = factor_.size();
  for (Index j = 0; j < size; ++j) {
    const double pivot = factor_(j, j);
    if (!(pivot > 0)) {
      positive_ = false;
      return;
    }
    const Index last = std::min(factor_.width(), size - 1 - j);
    for (Index k = 1; k <= last; ++k) {
      const double share = factor_(j + k, j) / pivot;
      for (Index m = k; m <= last; ++m) factor_(j + m, j + k) -= share * factor_(j + m, j);
    }
    for (Index k = 1; k <= last; ++k) factor_(j + k, j) /= pivot;
  }
}

Eigen::MatrixXd BandCholesky::solve(Eigen::MatrixXd right) const {
  const Index size = factor_.size();
  for (Index column = 0; column < right.cols(); ++column) {
    double* x = right.col(column).data();
    for (Index j = 0; j < size; ++j)
      for (Index k = 1; k <= std::min(factor_.width(), size - 1 - j); ++k)
        x[j + k] -= factor_(j + k, j) * x[j];
    for (Index j = size; j-- > 0;) {
      x[j] /= factor_(j, j);
      for (Index k = 1; k <= std::min(factor_.width(), size - 1 - j); ++k)
        x[j] -= factor_(j + k, j) * x[j + k];
    }
  }
  return right;
}

}  // namespace seamwright::linear
