// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/differential/frenet.hpp>

namespace seamwright {

namespace {

using Eigen::Vector3d;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

void requireUsable(const CurveDerivatives& derivatives, double speed_noise, double acceleration_noise) {
  if (derivatives.rows() < 2)
    throw std::invalid_argument("derivatives have " + std::to_string(derivatives.rows()) +
                                " rows: at least point and first derivative are needed");
  for (Eigen::Index k = 0; k < derivatives.rows(); ++k)
    for (int i = 0; i < 3; ++i)
      if (!std::isfinite(derivatives(k, i)))
        throw std::invalid_argument("coordinate " + std::to_string(i) + " of derivative " +
                                    std::to_string(k) + " is " + bernstein::text(derivatives(k, i)) +
                                    ": it must be finite");
  for (const double noise : {speed_noise, acceleration_noise})
    if (!(noise >= 0) || !std::isfinite(noise))
      throw std::invalid_argument("noise is " + bernstein::text(noise) + ": it must be finite and not negative");
}

/// At a cusp: X(t + h) - X(t) begins with the first derivative that is not zero.
void setLeavingTangent(const CurveDerivatives& derivatives, double noise, FrenetFrame& frame) {
  frame.kind = CurvePoint::Point;
  for (Eigen::Index k = 2; k < derivatives.rows(); ++k) {
    const Vector3d derivative = derivatives.row(k);
    if (derivative.stableNorm() <= noise) continue;
    frame.kind = CurvePoint::Cusp;
    frame.tangent = derivative.stableNormalized();
    return;
  }
}

/// \pre X' is not zero. The parameter is scaled to unit speed, so that no power of the speed is needed.
void setCurvature(const CurveDerivatives& derivatives, double speed_noise, double acceleration_noise,
                  FrenetFrame& frame) {
  const double speed = frame.speed;
  const Vector3d T = *frame.tangent;
  const Vector3d d2 = derivatives.row(2).transpose() / speed / speed;
  const Vector3d bend = T.cross(d2);
  const double kappa = bend.stableNorm(), size = d2.stableNorm();
  const double noise =
      (speed_noise / speed + 4 * epsilon) * size + acceleration_noise / speed / speed;
  if (kappa <= noise) {
    frame.kind = CurvePoint::Inflection;
    frame.curvature_per_mm = 0;
    return;
  }
  const Vector3d B = bend / kappa;
  frame.curvature_per_mm = kappa;
  frame.binormal = B;
  frame.normal = B.cross(T);
  if (derivatives.rows() < 4) return;
  const Vector3d d3 = derivatives.row(3).transpose() / speed / speed / speed;
  frame.torsion_per_mm = B.dot(d3) / kappa;
  frame.curvature_change_per_mm2 = B.dot(T.cross(d3)) - 3 * kappa * T.dot(d2);
}

struct EvaluationNoise {
  double speed, acceleration;
};

/// What rounding may add to X' and X'' of BezierCurve::derivatives. De Casteljau's triangle of the k-th
/// differences of homogeneous poles of size a is off by at most 2 (n + 4) eps 2^k n! / (n - k)! a; the errors
/// then go through the quotient rule.
EvaluationNoise evaluationNoise(const BezierCurve& curve, const CurveDerivatives& x, double t) {
  const HomogeneousPoles& poles = curve.homogeneousPoles();
  const int n = curve.degree();
  const double size = poles.leftCols<3>().rowwise().norm().maxCoeff(), weight = poles.col(3).maxCoeff();
  const double outside = std::abs(t) + std::abs(1 - t);
  std::array<double, 3> error{};
  double factor = 2 * (n + 4) * epsilon * std::pow(outside, n);
  for (int k = 0; k < 3; ++k) {
    error[k] = factor;
    factor *= 2.0 * std::max(0, n - k);
  }
  Eigen::Matrix<double, 3, 1> w;
  const auto weights = casteljauWeights(poles, t);
  w << weights[0], weights[1], weights[2];
  const double size_1 = x.row(1).norm(), size_0 = x.row(0).norm(), size_2 = x.row(2).norm();
  const double at = w(0);
  const double of_0 = error[0] * (size + size_0 * weight) / at;
  const double of_1 =
      (error[1] * (size + size_0 * weight) + std::abs(w(1)) * of_0 + error[0] * weight * size_1) / at;
  const double of_2 = (error[2] * (size + size_0 * weight) + std::abs(w(2)) * of_0 +
                       2 * error[1] * weight * size_1 + 2 * std::abs(w(1)) * of_1 + error[0] * weight * size_2) /
                      at;
  return {of_1, of_2};
}

}  // namespace

}  // namespace seamwright
