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

namespace {

/// The unit principal direction of largest absolute curvature, and the sign of that curvature.
struct Principal {
  explicit Principal(const Tensor& k) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(matrixOf(k));
    const int which = std::abs(eigen.eigenvalues()[0]) > std::abs(eigen.eigenvalues()[2]) ? 0 : 2;
    direction = eigen.eigenvectors().col(which);
    sign = eigen.eigenvalues()[which] < 0 ? -1 : 1;
  }
  Eigen::Vector3d direction;
  double sign = 1;
};

/// v.K v for the principal direction in the middle.
ChebyshevModel alongOne(const SymmetricModel& tensor, const Principal& middle) {
  const Eigen::Vector3d& v = middle.direction;
  const double sign = middle.sign * (1 - short_rounding);
  return combination({sign * v[0] * v[0], sign * v[1] * v[1], sign * v[2] * v[2]},
                     {&tensor[0], &tensor[1], &tensor[2]}) +
         combination({2 * sign * v[0] * v[1], 2 * sign * v[1] * v[2], 2 * sign * v[2] * v[0]},
                     {&tensor[3], &tensor[4], &tensor[5]});
}

/// v.K v for a v that turns with the principal direction: the parabola through those at both ends
/// and in the middle. As 1/q >= 2 - q for q = v.v > 0, v.K v (2 - q) is nowhere above the norm. q
/// is below 2, since the parabola through three unit vectors is nowhere longer than 5/4.
ChebyshevModel alongTurning(const SymmetricModel& tensor, const Principal& middle) {
  std::array<Eigen::Vector3d, 2> ends;
  for (const int end : {0, 1}) {
    ends[end] = Principal(seriesValue(tensor, 2 * end - 1)).direction;
    if (ends[end].dot(middle.direction) < 0) ends[end] = -ends[end];
  }
  const Eigen::Vector3d odd = 0.5 * (ends[1] - ends[0]);
  const Eigen::Vector3d even = 0.5 * (ends[1] + ends[0]) - middle.direction;
  VectorModel v;
  for (int d = 0; d < 3; ++d) {
    const double series[] = {middle.direction[d] + 0.5 * even[d], odd[d], 0.5 * even[d]};
    v[d] = ChebyshevModel::series(series, 0);
  }
  const ChebyshevModel along = middle.sign * dot(v, tensor * v);
  return along * (ChebyshevModel(2) - dot(v, v));
}

}  // namespace

TensorNorm normOf(const SymmetricModel& tensor) {
  TensorNorm norm;
  // The norm of Frobenius, in which entries off the diagonal count twice.
  double square = 0;
  for (int k = 0; k < 6; ++k) {
    const double magnitude = tensor[k].magnitude();
    square += (k < 3 ? 1 : 2) * magnitude * magnitude;
  }
  norm.at_most = std::sqrt(square) * (1 + short_rounding);
  if (norm.at_most == 0) return norm;
  const Principal middle(seriesValue(tensor, 0));
  norm.below = alongOne(tensor, middle);
  norm.at_least = std::max(0.0, norm.below.range().lower);
  // A choice: a direction that loses less at the ends of the piece narrows no bound.
  constexpr double share = 0.998;
  const auto loses = [&](double end) {
    return norm.below.seriesAt(end) < share * spectralNorm(seriesValue(tensor, end));
  };
  if (!std::isfinite(norm.at_most) || (!loses(-1) && !loses(1))) return norm;
  const ChebyshevModel turning = alongTurning(tensor, middle);
  const double at_least = turning.range().lower;
  if (at_least > norm.at_least) norm.below = turning, norm.at_least = at_least;
  return norm;
}

}  // namespace seamwright::enclosure
