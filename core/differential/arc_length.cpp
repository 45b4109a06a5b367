// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <seamwright/core/differential/arc_length.hpp>

namespace seamwright {

namespace {

/// Taylor coefficients of X' in the parameter t |X'(0)|, from the derivatives of X by t.
CurveDerivatives unitVelocity(const CurveDerivatives& derivatives, double speed) {
  CurveDerivatives velocity = derivatives.bottomRows(derivatives.rows() - 1);
  double factorial = 1;
  for (Eigen::Index k = 0; k < velocity.rows(); ++k) {
    if (k > 0) factorial *= static_cast<double>(k);
    for (Eigen::Index i = 0; i <= k; ++i)
      velocity.row(k) /= speed;  // speed^(k+1) may exceed the range of a double
    velocity.row(k) /= factorial;
  }
  return velocity;
}

/// Taylor coefficients of (X'.X')^(-1/2). The coefficients of p = q^a follow from k q_0 p_k =
/// sum_{i=1..k} (i (a + 1) - k) q_i p_{k-i}.
Eigen::VectorXd inverseSpeed(const CurveDerivatives& velocity) {
  const Eigen::Index count = velocity.rows();
  Eigen::VectorXd square = Eigen::VectorXd::Zero(count);
  for (Eigen::Index k = 0; k < count; ++k)
    for (Eigen::Index i = 0; i <= k; ++i) square(k) += velocity.row(i).dot(velocity.row(k - i));
  Eigen::VectorXd inverse(count);
  inverse(0) = 1 / std::sqrt(square(0));
  for (Eigen::Index k = 1; k < count; ++k) {
    double sum = 0;
    for (Eigen::Index i = 1; i <= k; ++i)
      sum += (0.5 * static_cast<double>(i) - static_cast<double>(k)) * square(i) * inverse(k - i);
    inverse(k) = sum / (static_cast<double>(k) * square(0));
  }
  return inverse;
}

/// The product of two power series, with as many terms as the first.
CurveDerivatives vectorsTimes(const CurveDerivatives& vectors, const Eigen::VectorXd& scalars) {
  CurveDerivatives result = CurveDerivatives::Zero(vectors.rows(), 3);
  for (Eigen::Index k = 0; k < vectors.rows(); ++k)
    for (Eigen::Index i = 0; i <= k; ++i) result.row(k) += scalars(i) * vectors.row(k - i);
  return result;
}

CurveDerivatives differentiated(const CurveDerivatives& series) {
  CurveDerivatives result = series.bottomRows(series.rows() - 1);
  for (Eigen::Index k = 0; k < result.rows(); ++k) result.row(k) *= static_cast<double>(k + 1);
  return result;
}

}  // namespace

std::optional<CurveDerivatives> arcLengthDerivatives(const CurveDerivatives& derivatives,
                                                     double speed_noise) {
  if (derivatives.rows() == 0)
    throw std::invalid_argument("no derivatives: at least the point is needed");
  if (!derivatives.allFinite()) return std::nullopt;
  CurveDerivatives result = derivatives;
  if (derivatives.rows() == 1) return result;
  const double speed = derivatives.row(1).stableNorm();
  if (speed <= speed_noise) return std::nullopt;
  CurveDerivatives series = unitVelocity(derivatives, speed);
  const Eigen::VectorXd inverse_speed = inverseSpeed(series);
  for (Eigen::Index k = 1; k < derivatives.rows(); ++k) {
    if (k > 1) series = differentiated(series);
    series = vectorsTimes(series, inverse_speed);
    result.row(k) = series.row(0);
  }
  if (!result.allFinite()) return std::nullopt;
  return result;
}

}  // namespace seamwright
