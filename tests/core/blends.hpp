// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <seamwright/core/blend/joint_blend.hpp>
#include <string>
#include <vector>

#include "curve_joins.hpp"

/// Random joints for tests of blending.
namespace seamwright::test {

/// The curve and one that continues it with these betas.
inline JointFrame frameFrom(const BezierCurve& a, const Eigen::VectorXd& beta, int degree_b,
                            CurveKind kind, std::mt19937_64& random) {
  const BezierCurve b = randomCurve(degree_b, kind, false, 1, random);
  CurveJoinRule rule{beta, 1, 1, {}};
  return {a, gentlyJoined(a, b, rule, false)};
}

/// A random joint that is G^n with these betas. The curves are about as long as their degrees.
inline JointFrame frameWith(const Eigen::VectorXd& beta, int degree_a, int degree_b, CurveKind kind,
                            std::mt19937_64& random) {
  return frameFrom(randomCurve(degree_a, kind, true, 1, random), beta, degree_b, kind, random);
}

inline JointFrame randomFrame(int order, int degree_a, int degree_b, std::mt19937_64& random,
                              CurveKind kind = CurveKind::Space) {
  return frameWith(randomBeta(order, random), degree_a, degree_b, kind, random);
}

inline double largestOf(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// The largest defect up to the order, as fitBeta() measures it.
inline double worstOf(const BlendedJoint& joint) {
  return largestOf(fitBeta(joint.a, joint.b, joint.order).defects);
}

inline BezierCurve blended(const BezierCurve& x, const BezierCurve& y, double omega) {
  return BezierCurve::fromHomogeneous((1 - omega) * x.homogeneousPoles() +
                                      omega * y.homogeneousPoles());
}

inline double farthest(const BezierCurve& x, const BezierCurve& y) {
  return (x.poles() - y.poles()).rowwise().norm().maxCoeff();
}

/// What rounding of the poles alone adds to the defects, from moves of each pole.
inline double defectOfRounding(const BezierCurve& a, const BezierCurve& b, int order) {
  constexpr double move = 1e-9;
  const double length = fitBeta(a, b, 1).length_mm;
  const double size = std::max(a.poles().cwiseAbs().maxCoeff(), b.poles().cwiseAbs().maxCoeff());
  const auto defect = [&](const BezierCurve& x, const BezierCurve& y) {
    const CurveJoint joint = measureJoint(x, y, order);
    double worst = 0;
    for (int k = 0; k <= order; ++k)
      worst = std::max(worst, joint.differences[k] * std::pow(length, k - 1));
    return worst;
  };
  double sum = 0;
  for (int k = 0; k <= order; ++k) {
    Poles of_a = a.poles(), of_b = b.poles();
    of_a.row(a.degree() - k).array() += move;
    of_b.row(k).array() += move;
    sum += defect(BezierCurve(of_a, a.weights()), b) + defect(a, BezierCurve(of_b, b.weights()));
  }
  return sum / move * size * 0x1p-52;
}

}  // namespace seamwright::test
