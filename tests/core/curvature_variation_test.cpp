// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <seamwright/core/fair/curvature_variation.hpp>

#include "dense_variation.hpp"
#include "planar.hpp"

namespace seamwright {
namespace {

using test::denseVariation;
using test::uniform;

BezierCurve cubic(double x2, double y2) {
  Poles poles(4, 3);
  poles << 0, 0, 0, 10, 10, 0, x2, y2, 0, 10, 0, 0;
  return BezierCurve(poles);
}

BezierCurve randomCurve(int degree, bool planar, std::mt19937_64& random) {
  Poles poles(degree + 1, 3);
  for (int i = 0; i <= degree; ++i)
    poles.row(i) << uniform(random, 0, 10), uniform(random, 0, 10),
        planar ? 0 : uniform(random, 0, 10);
  return BezierCurve(poles);
}

double variation(const BezierCurve& curve) {
  return variationOf(bezierSpline({curve}, {0, 1})).energy_per_mm3;
}

// Identity (3): curves that nearly stop, so that eight nodes miss the peak or hit it.
TEST(CurvatureVariation, IsThatOfASampleNearCusps) {
  Poles arch(4, 3);
  arch << 0, 0, 0, 20, 30, 0, 30, 30, 0, 40, 0, 0;
  for (const BezierCurve& curve : {BezierCurve(arch), cubic(2, 10), cubic(1, 10), cubic(0.1, 10)}) {
    const double wanted = denseVariation(curve, 2'000'000);
    EXPECT_NEAR(variation(curve) / wanted, 1, 1e-6);
  }
  EXPECT_NEAR(variation(BezierCurve(arch)), 0.002286, 1e-6);
  EXPECT_NEAR(variation(cubic(2, 10)), 19541, 1);
  EXPECT_NEAR(variation(cubic(1, 10)), 1.1727e6, 100);
}

// Identity (3).
TEST(CurvatureVariation, IsThatOfASampleForRandomCurves) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 60; ++i) {
    const BezierCurve curve = randomCurve(2 + i % 6, i % 2 == 0, random);
    EXPECT_NEAR(variation(curve) / denseVariation(curve, 200'000), 1, 1e-5) << i;
  }
}

// Identities (2) and (4).
TEST(CurvatureVariation, DependsOnTheShapeAlone) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 60; ++i) {
    const BezierCurve curve = randomCurve(3 + i % 4, i % 2 == 0, random);
    const double wanted = variation(curve);
    EXPECT_NEAR(variation(curve.reversed()) / wanted, 1, 1e-6);
    EXPECT_NEAR(variation(curve.elevated()) / wanted, 1, 1e-6);
    const auto [left, right] = curve.split(uniform(random, 0.1, 0.9));
    EXPECT_NEAR((variation(left) + variation(right)) / wanted, 1, 1e-6);
    Eigen::VectorXd weights(curve.degree() + 1);
    const double ratio = uniform(random, 0.4, 2.5);
    for (int k = 0; k <= curve.degree(); ++k) weights(k) = std::pow(ratio, k);
    EXPECT_NEAR(variation(BezierCurve(curve.poles(), weights)) / wanted, 1, 1e-6);
    const Eigen::Matrix3d turn =
        2 * Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    const Poles moved = (curve.poles() * turn).rowwise() + Eigen::RowVector3d(3, -4, 5);
    EXPECT_NEAR(8 * variation(BezierCurve(moved)) / wanted, 1, 1e-6);
  }
}

// Identity (5).
TEST(CurvatureVariation, IsInfiniteWhereTheCurveStopsAndZeroForLines) {
  EXPECT_EQ(variation(cubic(0, 10)), HUGE_VAL);
  Poles poles(4, 3);
  poles << 1, 2, 3, 1, 2, 3, 2, 5, 3, 4, 5, 6;
  EXPECT_EQ(variation(BezierCurve(poles)), HUGE_VAL);  // it stops at its start
  EXPECT_EQ(variation(BezierCurve(poles, Eigen::Vector4d(1, 2, 1, 3))), HUGE_VAL);
  poles.rowwise() = Eigen::RowVector3d(1, 2, 3);
  EXPECT_THROW(variation(BezierCurve(poles)), std::invalid_argument);  // a point
  const Eigen::RowVector3d direction(1, 2, 3);
  poles << 0 * direction, 0 * direction, 1 * direction, 3 * direction;
  EXPECT_EQ(variation(BezierCurve(poles)), 0);
  EXPECT_EQ(variation(BezierCurve(poles, Eigen::Vector4d(1, 2, 1, 3))), 0);
  poles << 0 * direction, 2 * direction, 1 * direction, 3 * direction;
  EXPECT_LT(variation(BezierCurve(poles)), 1e-28);
  EXPECT_LT(variation(BezierCurve(poles.topRows(2))), 1e-28);
  // An arc of a quarter of a turn.
  Poles arc(3, 3);
  arc << 1, 0, 0, 1, 1, 0, 0, 1, 0;
  EXPECT_LT(variation(BezierCurve(arc, Eigen::Vector3d(1, std::sqrt(0.5), 1))), 1e-28);
}

}  // namespace
}  // namespace seamwright
