// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bspline/curve.hpp>
#include <vector>

#include "planar.hpp"

/// B-spline curves that are not fair.
namespace seamwright::test {

inline BSplineCurve splineOf(int degree, const std::vector<double>& knots, const Poles& poles) {
  BSplineCurve curve{degree, knots, HomogeneousPoles(poles.rows(), 4)};
  curve.poles << poles, Eigen::VectorXd::Ones(poles.rows());
  return curve;
}

inline std::vector<double> randomKnots(int degree, int count, std::mt19937_64& random) {
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  double at = 0;
  for (int i = 0; i < count - degree - 1; ++i) knots.push_back(at += uniform(random, 0.5, 1.5));
  at += 1;
  for (int i = 0; i <= degree; ++i) knots.push_back(at);
  return knots;
}

/// A helix, or an arm of a spiral in the plane, with noise at its poles.
inline BSplineCurve noisyCurve(int degree, int count, bool planar, double noise_mm,
                               std::mt19937_64& random) {
  const std::vector<double> knots = randomKnots(degree, count, random);
  Poles poles(count, 3);
  for (int i = 0; i < count; ++i) {
    // The Greville abscissa, so that without noise the speed is even.
    double greville = 0;
    for (int k = 1; k <= degree; ++k) greville += knots[i + k] / degree;
    const double t = 4 * greville / knots.back();
    poles.row(i) << (5 + t) * std::cos(t) + uniform(random, -noise_mm, noise_mm),
        (5 + t) * std::sin(t) + uniform(random, -noise_mm, noise_mm),
        planar ? 0 : t + uniform(random, -noise_mm, noise_mm);
  }
  return splineOf(degree, knots, poles);
}

inline double largestDistance_mm(const BSplineCurve& a, const BSplineCurve& b, int samples = 1000) {
  double largest = 0;
  for (int i = 0; i <= samples; ++i) {
    const double t = a.knots.front() + (a.knots.back() - a.knots.front()) * i / samples;
    largest = std::max(largest, (derivatives(a, t, 0) - derivatives(b, t, 0)).norm());
  }
  return largest;
}

}  // namespace seamwright::test
