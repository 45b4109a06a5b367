// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <seamwright/core/spline/polynomial_spline.hpp>

#include "splines.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using test::expectRefused;
using test::Vec;

/// A circle of that radius about a centre, of four rational quadratic quarters.
BezierSpline circle(double radius, const Eigen::Vector3d& centre) {
  std::vector<BezierCurve> quarters;
  const double x[] = {1, 0, -1, 0}, y[] = {0, 1, 0, -1};
  for (int k = 0; k < 4; ++k) {
    const int l = (k + 1) % 4;
    Poles poles(3, 3);
    poles << x[k], y[k], 0, x[k] + x[l], y[k] + y[l], 0, x[l], y[l], 0;
    poles *= radius;
    poles.rowwise() += centre.transpose();
    quarters.emplace_back(poles, Vec(1, std::numbers::sqrt2 / 2, 1));
  }
  return bezierSpline(quarters, {0, 1, 2, 3, 4}, true, 1e-12);
}

TEST(PolynomialSpline, Identity1APolynomialSplineStays) {
  std::mt19937_64 random(testSeed());
  const BezierSpline spline{3, {0, 1, 3}, test::randomPoles(7, false, random)};
  const PolynomialSpline result = polynomialSpline(spline, 2, 1e-6);
  EXPECT_EQ(result.spline, spline);
  EXPECT_EQ(result.distance_mm, 0);
  EXPECT_EQ(result.added_joints, 0);
}

TEST(PolynomialSpline, Identity2TheBoundHoldsOnACircle) {
  const Eigen::Vector3d centre(30, -20, 5);
  for (const int order : {1, 2, 3})
    for (const double tolerance_mm : {1e-2, 1e-5, 1e-8}) {
      const PolynomialSpline result = polynomialSpline(circle(10, centre), order, tolerance_mm);
      EXPECT_TRUE(result.spline.closed);
      EXPECT_LE(result.distance_mm, tolerance_mm);
      EXPECT_EQ(result.spline.degree, 2 * order + 1);
      double farthest_mm = 0;
      for (int i = 0; i < result.spline.segments(); ++i)
        for (int k = 0; k <= 16; ++k) {
          const double radius = (segment(result.spline, i).point(k / 16.0) - centre).norm();
          farthest_mm = std::max(farthest_mm, std::abs(radius - 10));
        }
      EXPECT_LE(farthest_mm, result.distance_mm);
    }
  // Halving divides the distance by 2^(2 n + 2) = 64, so a thousandth takes at most two of them.
  const auto segments = [&](double tolerance_mm) {
    return polynomialSpline(circle(10, centre), 2, tolerance_mm).spline.segments();
  };
  EXPECT_LE(segments(1e-8), 4 * segments(1e-5));
}

TEST(PolynomialSpline, Identity3DerivativesAtTheJointsStay) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 50; ++trial) {
    const BezierSpline spline{3, {0, 1, 3}, test::randomPoles(7, true, random)};
    const int order = 1 + trial % 3;
    const PolynomialSpline result = polynomialSpline(spline, order, 1e-3);
    for (const double knot : spline.knots) {
      const CurveDerivatives given = derivatives(spline, knot, order),
                             found = derivatives(result.spline, knot, order);
      for (int k = 0; k <= order; ++k)
        EXPECT_LT((given.row(k) - found.row(k)).norm(), 1e-7 * (1 + given.cwiseAbs().maxCoeff()))
            << trial << " knot " << knot << " order " << k;
    }
  }
}

TEST(PolynomialSpline, BadOptionsAreRefused) {
  const BezierSpline spline = circle(1, Eigen::Vector3d::Zero());
  expectRefused([&] { polynomialSpline(spline, 0, 1e-3); }, "order is 0");
  expectRefused([&] { polynomialSpline(spline, 7, 1e-3); }, "order is 7");
  for (const double tolerance : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity()})
    expectRefused([&] { polynomialSpline(spline, 2, tolerance); }, "the tolerance is");
  EXPECT_THROW(polynomialSpline(spline, 2, 1e-18), std::domain_error);
}

}  // namespace
}  // namespace seamwright
