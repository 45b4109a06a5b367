// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/casteljau.hpp>
#include <seamwright/core/differential/frenet.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using Eigen::Vector3d;

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
      throw std::invalid_argument("noise is " + bernstein::text(noise) +
                                  ": it must be finite and not negative");
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

std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
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
      (speed_noise / speed + 4 * machine_epsilon) * size + acceleration_noise / speed / speed;
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
  const Vector3d d3_by_kappa = derivatives.row(3).transpose() / speed / speed / (speed * kappa);
  frame.torsion_per_mm = finite(B.dot(d3_by_kappa));
  frame.curvature_change_per_mm2 = finite(kappa * (B.dot(T.cross(d3_by_kappa)) - 3 * T.dot(d2)));
}

struct EvaluationNoise {
  double speed, acceleration;
};

/// Largest rows of homogeneous poles, and of their differences.
struct Size {
  double pole, step;
};

Size sizeOf(const Eigen::MatrixXd& rows) {
  const Eigen::Index n = rows.rows() - 1;
  const double step = n == 0 ? 0 : (rows.bottomRows(n) - rows.topRows(n)).rowwise().stableNorm().maxCoeff();
  return {rows.rowwise().stableNorm().maxCoeff(), step};
}

/// Bounds of the rounding in A, A' and A'': de Casteljau's triangle of the k-th differences, of size
/// 2^(k-1) step, times n! / (n - k)!.
std::array<double, 3> derivativeNoise(const Size& size, int n, double t) {
  const double rounding = 2 * (n + 4) * machine_epsilon * std::pow(std::abs(t) + std::abs(1 - t), n);
  return {rounding * size.pole, rounding * n * size.step, rounding * n * std::max(0, n - 1) * 2 * size.step};
}

/// What rounding may have added to X' and X'' of BezierCurve::derivatives(): that of A and w, through Leibniz'
/// rule for A = w X.
EvaluationNoise evaluationNoise(const BezierCurve& curve, const CurveDerivatives& derivatives, double t) {
  const HomogeneousPoles& poles = curve.homogeneousPoles();
  const std::array<double, 3> of_a = derivativeNoise(sizeOf(poles.leftCols<3>()), curve.degree(), t),
                              of_w = derivativeNoise(sizeOf(poles.col(3)), curve.degree(), t);
  const Eigen::Vector3d w = casteljau::derivatives<4, 3>(poles, t).col(3).cwiseAbs();
  const Eigen::Vector3d x = derivatives.topRows<3>().rowwise().stableNorm();
  const double of_x = (of_a[0] + of_w[0] * x(0)) / w(0);
  const double of_speed = (of_a[1] + of_w[1] * x(0) + w(1) * of_x + of_w[0] * x(1)) / w(0);
  const double of_acceleration =
      (of_a[2] + of_w[2] * x(0) + w(2) * of_x + 2 * of_w[1] * x(1) + 2 * w(1) * of_speed + of_w[0] * x(2)) /
      w(0);
  return {of_speed, of_acceleration};
}

}  // namespace

FrenetFrame frenetFrame(const CurveDerivatives& derivatives, double speed_noise, double acceleration_noise) {
  requireUsable(derivatives, speed_noise, acceleration_noise);
  FrenetFrame frame;
  const Vector3d velocity = derivatives.row(1);
  frame.speed = velocity.stableNorm();
  if (frame.speed <= speed_noise) {
    setLeavingTangent(derivatives, acceleration_noise, frame);
    return frame;
  }
  frame.kind = CurvePoint::Regular;
  frame.tangent = velocity / frame.speed;
  if (derivatives.rows() > 2) setCurvature(derivatives, speed_noise, acceleration_noise, frame);
  return frame;
}

FrenetFrame frenetFrame(const BezierCurve& curve, double t) {
  if (!std::isfinite(t))
    throw std::invalid_argument("parameter is " + bernstein::text(t) + ": it must be finite");
  const CurveDerivatives derivatives = curve.derivatives(t, 3);
  const EvaluationNoise noise = evaluationNoise(curve, derivatives, t);
  FrenetFrame frame = frenetFrame(derivatives, noise.speed, noise.acceleration);
  for (int k = 4; frame.kind == CurvePoint::Point && k <= curve.degree(); ++k)
    frame = frenetFrame(curve.derivatives(t, k), noise.speed, noise.acceleration);
  return frame;
}

}  // namespace seamwright
