// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <seamwright/core/join/curve/beta.hpp>
#include <seamwright/core/join/curve/nearest_curve.hpp>
#include <seamwright/core/seam/curve_joint.hpp>

#include "curves.hpp"

/// Pairs of curves that nearly join, and what is wrong with a joint.
namespace seamwright::test::near_curves {

using Moves = NearestCurveJoinOptions::Moves;
using Join = NearestCurveJoin<BezierCurve>;

inline NearestCurveJoinOptions optionsOf(int order, Moves moves = Moves::Both) {
  NearestCurveJoinOptions options;
  options.order = order;
  options.moves = moves;
  return options;
}

struct Pair {
  BezierCurve a, b;
  NearestCurveJoinOptions options;
};

inline BezierCurve perturbed(const BezierCurve& curve, double by, std::mt19937_64& random) {
  Poles poles = curve.poles();
  for (Eigen::Index i = 0; i < poles.rows(); ++i)
    poles.row(i) += by * test::randomVector(random).transpose();
  return {poles, curve.weights()};
}

/// The halves of one curve, each moved by noise: of odd number rational; all orders to 4 and all
/// moves occur.
inline Pair pairOf(int i, double noise, std::mt19937_64& random) {
  const int order = 1 + i % 4, degree = order + i / 4 % 3;
  Poles poles(degree + 1, 3);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(degree + 1);
  for (int k = 0; k <= degree; ++k) {
    poles.row(k) = (Vec(2.0 * k, 0, 0) + test::randomVector(random)).transpose();
    if (i / 12 % 2 == 1) weights(k) = test::logUniform(random, -0.3, 0.3);
  }
  auto [a, b] = BezierCurve(poles, weights).split(0.3 + 0.4 * (i % 7) / 7);
  if (i % 5 == 0) b = b.elevated();
  Pair pair{perturbed(a, noise, random), perturbed(b, noise, random),
            optionsOf(order, static_cast<Moves>(i / 24 % 3))};
  if (i / 72 % 2 == 1) {
    pair.options.costs_a.resize(a.degree() + 1);
    pair.options.costs_b.resize(b.degree() + 1);
    for (double& cost : pair.options.costs_a) cost = test::logUniform(random, -1, 1);
    for (double& cost : pair.options.costs_b) cost = test::logUniform(random, -1, 1);
  }
  return pair;
}

inline double size(const BezierCurve& curve) {
  return curve.poles().cwiseAbs().maxCoeff();
}

inline double difference(const BezierCurve& x, const BezierCurve& y) {
  return (x.poles() - y.poles()).cwiseAbs().maxCoeff();
}

inline double worstDefect(const BezierCurve& a, const BezierCurve& b, int order) {
  const BetaFit fit = fitBeta(a, b, order);
  return *std::max_element(fit.defects.begin(), fit.defects.end());
}

/// c_k of the curve at the joint in units of fitBeta(), the condition of its defects.
inline double bend(const BezierCurve& a, const BezierCurve& b, int order) {
  const double length = fitBeta(a, b, 1).length_mm;
  const CurveJoint joint = measureJoint(a, b, order);
  double scale = 1;
  for (int k = 2; k <= order; ++k)
    scale = std::max(scale, std::pow(joint.sizes[k], 1.0 / (k - 1)) * length);
  return std::pow(scale, order - 1);
}

/// Cubics with a kink, a common point and tangents in the plane.
inline Pair kinked(double angle) {
  Poles a(4, 3), b(4, 3);
  a << -3, 1, 0, -2, 0.5, 0, -1, 0, 0, 0, 0, 0;
  const double c = std::cos(angle), s = std::sin(angle);
  b << 0, 0, 0, c, s, 0, 2 * c, 2 * s + 0.5, 0, 3, 1, 1;
  return {BezierCurve(a), BezierCurve(b), optionsOf(1)};
}

}  // namespace seamwright::test::near_curves
