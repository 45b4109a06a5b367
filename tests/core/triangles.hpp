// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <random>
#include <seamwright/core/bezier/triangle.hpp>
#include <vector>

#include "surfaces.hpp"

/// Random Bézier triangles, and their values from the definition in long double, without de
/// Casteljau.
namespace seamwright::test {

using LongVec4 = Eigen::Matrix<long double, 4, 1>;

inline Poles randomNet(int degree, std::mt19937_64& random) {
  Poles poles(BezierTriangle::row(degree, degree, 0) + 1, 3);
  for (Eigen::Index i = 0; i < poles.rows(); ++i) poles.row(i) = randomVector(random).transpose();
  return poles;
}

inline Eigen::VectorXd randomNetWeights(int degree, std::mt19937_64& random) {
  Eigen::VectorXd weights(BezierTriangle::row(degree, degree, 0) + 1);
  for (double& w : weights) w = logUniform(random, -0.5, 0.5);
  return weights;
}

inline BezierTriangle randomTriangle(int degree, bool rational, std::mt19937_64& random) {
  const Poles poles = randomNet(degree, random);
  return rational ? BezierTriangle(poles, randomNetWeights(degree, random)) : BezierTriangle(poles);
}

/// A point inside the triangle.
inline Barycentric randomBarycentric(std::mt19937_64& random) {
  std::exponential_distribution<double> exponential;
  Barycentric l;
  for (double& c : l) c = exponential(random);
  return l / l.sum();
}

/// The d-th derivative of l^power: power (power - 1) ... l^(power - d).
inline long double fallingPower(long double l, int power, int d) {
  if (d > power) return 0;
  long double value = 1;
  for (int i = 0; i < d; ++i) value *= power - i;
  for (int i = d; i < power; ++i) value *= l;
  return value;
}

/// d^(a+b) / dl0^a dl1^b of l0^i l1^j (1 - l0 - l1)^k by Leibniz' rule.
inline long double monomialPartial(int i, int j, int k, int a, int b, long double l0,
                                   long double l1) {
  static constexpr int binomial[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
  long double sum = 0;
  for (int p = 0; p <= a; ++p)
    for (int q = 0; q <= b; ++q)
      sum += binomial[a][p] * binomial[b][q] * fallingPower(l0, i, a - p) *
             fallingPower(l1, j, b - q) * ((p + q) % 2 ? -1 : 1) *
             fallingPower(1 - l0 - l1, k, p + q);
  return sum;
}

/// Homogeneous partial at (l0, l1), summed as the definition says.
inline LongVec4 exactPartial(const BezierTriangle& triangle, int a, int b, long double l0,
                             long double l1) {
  const int n = triangle.degree();
  LongVec4 sum = LongVec4::Zero();
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const int k = n - i - j;
      const long double multinomial =
          std::round(std::exp(std::lgamma(n + 1.0L) - std::lgamma(i + 1.0L) -
                              std::lgamma(j + 1.0L) - std::lgamma(k + 1.0L)));
      sum += multinomial * monomialPartial(i, j, k, a, b, l0, l1) *
             triangle.homogeneousPoles()
                 .row(BezierTriangle::row(n, i, j))
                 .transpose()
                 .cast<long double>();
    }
  return sum;
}

inline Vec exactPoint(const BezierTriangle& triangle, const Barycentric& l) {
  const LongVec4 h = exactPartial(triangle, 0, 0, l(0), l(1));
  return (h.head<3>() / h(3)).cast<double>();
}

}  // namespace seamwright::test
