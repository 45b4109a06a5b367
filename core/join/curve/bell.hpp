// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <seamwright/core/bernstein/coefficients.hpp>

/// The chain rule for derivatives of all orders; not a public header.
namespace seamwright {

/// Partial Bell polynomials B_kj(beta), k, j = 0..n: B_kj = sum_i C(k-1, i-1) beta_i B_{k-i, j-1},
/// B_00 = 1. The derivatives of a(t(u)) by u are B times those of a by t; beta_k is the k-th
/// derivative of t by u.
/// \pre n <= 56.
/// Source: docs/theory/curves.md C2.1, C2.2.
template <class Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> bellMatrix(
    const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& beta) {
  using Eigen::Index;
  const Index order = beta.size();
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> matrix(order + 1, order + 1);
  for (Index k = 0; k <= order; ++k)
    for (Index j = 0; j <= order; ++j) {
      Scalar sum(k == 0 && j == 0 ? 1 : 0);
      for (Index i = 1; j > 0 && i <= k - j + 1; ++i)
        sum += Scalar(bernstein::binomials(k - 1)(i - 1)) * beta(i - 1) * matrix(k - i, j - 1);
      matrix(k, j) = sum;
    }
  return matrix;
}

/// Checks betas. \throws std::invalid_argument as betaMatrix() does.
void requireBeta(const Eigen::VectorXd& beta);

}  // namespace seamwright
