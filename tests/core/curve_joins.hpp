// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <seamwright/core/join/curve/beta.hpp>
#include <stdexcept>

#include "curves.hpp"

/// Random curves, some of them degenerate, and random rules by which they go on.
namespace seamwright::test {

inline double uniformNumber(double low, double high, std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline int wholeNumber(int low, int high, std::mt19937_64& random) {
  return std::uniform_int_distribution<int>(low, high)(random);
}

enum class CurveKind { Space, Planar, Straight, Coincident, Rational };

/// About as long as its degree times the size. Coincident: the first two poles are one (the last
/// two unless
/// \p end), so that the curve has a tangent at one end only.
inline BezierCurve randomCurve(int degree, CurveKind kind, bool end, double size,
                               std::mt19937_64& random) {
  Poles poles(degree + 1, 3);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(degree + 1);
  const Vec along = randomVector(random).normalized();
  for (int i = 0; i <= degree; ++i) {
    if (kind == CurveKind::Straight) {
      poles.row(i) = (i + uniformNumber(-0.3, 0.3, random)) * along.transpose();
    } else {
      poles.row(i) << i, 0, 0;
      poles.row(i) += 0.4 * randomVector(random).transpose();
    }
    if (kind == CurveKind::Planar) poles(i, 2) = 0;
    if (kind == CurveKind::Rational) weights(i) = logUniform(random, -0.2, 0.2);
  }
  if (kind == CurveKind::Coincident && degree >= 2)
    poles.row(end ? 0 : degree) = poles.row(end ? 1 : degree - 1);
  return {size * poles, weights};
}

inline Eigen::VectorXd randomBeta(int order, std::mt19937_64& random) {
  Eigen::VectorXd beta(order);
  for (int k = 0; k < order; ++k) beta(k) = randomVector(random).x();
  if (order > 0) beta(0) = logUniform(random, -0.3, 0.3);
  return beta;
}

/// joinedCurve(), the curve made shorter in the common parameter until no weight comes out
/// negative.
inline BezierCurve gentlyJoined(const BezierCurve& a, const BezierCurve& b, CurveJoinRule& rule,
                                bool keep_end) {
  while (true) {
    try {
      return joinedCurve(a, b, rule, keep_end);
    } catch (const std::invalid_argument&) {
      rule.next_length /= 2;
      if (rule.next_length < 1e-3) throw;
    }
  }
}

/// n! / (n-k)!
inline double fallingFactorial(int n, int k) {
  double product = 1;
  for (int i = 0; i < k; ++i) product *= n - i;
  return product;
}

/// A pole moved.
inline BezierCurve withMove(const BezierCurve& curve, int pole, const Vec& move) {
  Poles poles = curve.poles();
  poles.row(pole) += move.transpose();
  return {poles, curve.weights()};
}

/// Some unit vector across.
inline Vec across(const Vec& direction) {
  return direction.unitOrthogonal();
}

}  // namespace seamwright::test
