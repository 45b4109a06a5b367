// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>

#include <seamwright/core/bezier/homogeneous.hpp>

namespace seamwright {

namespace {

/// A partial of X, from Leibniz' rule on A = w X: w X_kl = A_kl - sum_{(i,j) != (0,0)} C(k,i)
/// C(l,j) w_ij X_{k-i,l-j}.
Eigen::Vector3d rationalPartial(const HomogeneousPartials& h, int k, int l,
                                const std::array<std::array<Eigen::Vector3d, 4>, 4>& lower) {
  static constexpr double binomial[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
  Eigen::Vector3d sum = h[k][l].head<3>();
  for (int i = 0; i <= k; ++i)
    for (int j = 0; j <= l; ++j)
      if (i + j > 0) sum -= binomial[k][i] * binomial[l][j] * h[i][j](3) * lower[k - i][l - j];
  return sum / h[0][0](3);
}

}  // namespace

/// A fused product rounds A - w X only once.
HomogeneousPoles about(const HomogeneousPoles& poles, const Eigen::Vector3d& origin) {
  HomogeneousPoles result = poles;
  for (Eigen::Index i = 0; i < poles.rows(); ++i)
    for (int k = 0; k < 3; ++k) result(i, k) = std::fma(-poles(i, 3), origin(k), poles(i, k));
  return result;
}

SurfaceJet affineJet(const HomogeneousPartials& h) {
  std::array<std::array<Eigen::Vector3d, 4>, 4> x;
  for (int order = 0; order < 4; ++order)
    for (int k = order; k >= 0; --k) x[k][order - k] = rationalPartial(h, k, order - k, x);
  return {x[0][0], x[1][0], x[0][1], x[2][0], x[1][1], x[0][2], x[3][0], x[2][1], x[1][2], x[0][3]};
}

}  // namespace seamwright
