// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include <seamwright/core/seam/model_norm.hpp>

namespace seamwright::enclosure {

namespace {

/// Distance of the cosine from 1 below which two eigenvalues count as nearly equal. A choice: a
/// smaller value loses digits (see norm_rounding), a larger one takes the slow solver more often.
constexpr double nearly_double = 1e-4;

}  // namespace

Eigen::Matrix3d matrixOf(const Tensor& k) {
  Eigen::Matrix3d matrix;
  matrix << k[0], k[3], k[5], k[3], k[1], k[4], k[5], k[4], k[2];
  return matrix;
}

double spectralNorm(const Tensor& k) {
  const double mean = (k[0] + k[1] + k[2]) / 3;
  const double x = k[0] - mean, y = k[1] - mean, z = k[2] - mean;
  const double off = k[3] * k[3] + k[4] * k[4] + k[5] * k[5];
  const double spread = std::sqrt((x * x + y * y + z * z + 2 * off) / 6);
  if (!(spread > 0)) return std::abs(mean);
  const double determinant =
      x * (y * z - k[4] * k[4]) - k[3] * (k[3] * z - k[4] * k[5]) + k[5] * (k[3] * k[4] - y * k[5]);
  const double cosine = std::clamp(determinant / (2 * spread * spread * spread), -1.0, 1.0);
  const double angle = std::acos(cosine) / 3;
  // The compiler takes both from one call; the third eigenvalue is at angle + 2 pi / 3.
  const double by_cosine = std::cos(angle), by_sine = std::numbers::sqrt3 * std::sin(angle);
  const double largest = mean + 2 * spread * by_cosine;
  const double smallest = mean - spread * (by_cosine + by_sine);
  const bool is_double = std::abs(cosine) > 1 - nearly_double && cosine * (largest + smallest) < 0;
  if (std::isfinite(cosine) && !is_double) return std::max(std::abs(largest), std::abs(smallest));
  // Near a double eigenvalue the angle is known to half the digits only, and cubes may exceed the
  // range of a double.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(matrixOf(k), Eigen::EigenvaluesOnly);
  return std::max(std::abs(eigen.eigenvalues()[0]), std::abs(eigen.eigenvalues()[2]));
}

TensorNorm normOf(const SymmetricModel& tensor) {
  TensorNorm norm;
  // The norm of Frobenius, in which entries off the diagonal count twice.
  double square = 0;
  for (int k = 0; k < 6; ++k) {
    const double magnitude = tensor[k].magnitude();
    square += (k < 3 ? 1 : 2) * magnitude * magnitude;
  }
  norm.at_most = std::sqrt(square) * (1 + short_rounding);
  // The function is v.K v. v is the principal direction of largest absolute curvature at the
  // middle.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(matrixOf(seriesValue(tensor, 0)));
  const int which = std::abs(eigen.eigenvalues()[0]) > std::abs(eigen.eigenvalues()[2]) ? 0 : 2;
  const Eigen::Vector3d v = eigen.eigenvectors().col(which);
  const double sign = (eigen.eigenvalues()[which] < 0 ? -1 : 1) * (1 - short_rounding);
  norm.below = combination({sign * v[0] * v[0], sign * v[1] * v[1], sign * v[2] * v[2]},
                           {&tensor[0], &tensor[1], &tensor[2]}) +
               combination({2 * sign * v[0] * v[1], 2 * sign * v[1] * v[2], 2 * sign * v[2] * v[0]},
                           {&tensor[3], &tensor[4], &tensor[5]});
  norm.at_least = std::max(0.0, norm.below.range().lower);
  return norm;
}

}  // namespace seamwright::enclosure
