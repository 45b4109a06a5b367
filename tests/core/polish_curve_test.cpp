// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <seamwright/core/fair/curvature_variation.hpp>
#include <seamwright/core/fair/polish_curve.hpp>

#include "dense_variation.hpp"
#include "noisy_curves.hpp"

namespace seamwright {
namespace {

using std::numbers::pi;
using test::largestDistance_mm;
using test::noisyCurve;
using test::splineOf;
using test::uniform;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// The vector k N from first and second derivatives.
Eigen::RowVector3d curvatureVector(const CurveDerivatives& at) {
  const Eigen::RowVector3d first = at.row(1), second = at.row(2);
  return (second - first.dot(second) / first.squaredNorm() * first) / first.squaredNorm();
}

/// The variation by differences of the curvature vector on a dense sample, span by span.
double sampledVariation(const BSplineCurve& curve, int samples = 4000) {
  double sum = 0;
  for (std::size_t span = 0; span + 1 < curve.knots.size(); ++span) {
    const double from = curve.knots[span], width = curve.knots[span + 1] - from;
    if (!(width > 0)) continue;
    // Just inside, because at a knot the derivatives are those of the span after it.
    const auto at = [&](int i) {
      const double share = std::clamp(static_cast<double>(i) / samples, 1e-12, 1 - 1e-12);
      return derivatives(curve, from + width * share, 2);
    };
    CurveDerivatives before = at(0);
    for (int i = 1; i <= samples; ++i) {
      const CurveDerivatives after = at(i);
      const Eigen::RowVector3d tangent = (before.row(1) + after.row(1)).normalized();
      const double length = (after.row(0) - before.row(0)).norm();
      const Eigen::RowVector3d change = curvatureVector(after) - curvatureVector(before);
      sum += (change - change.dot(tangent) * tangent).squaredNorm() / length;
      before = after;
    }
  }
  return sum;
}

// Identities (1) to (3).
TEST(PolishCurve, MovesWithinTheToleranceAndVariesLess) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 16; ++i) {
    const int degree = 3 + i % 3;
    const bool planar = i % 2 == 0;
    const BSplineCurve curve =
        noisyCurve(degree, degree + 6 + static_cast<int>(random() % 12), planar, 0.02, random);
    const int held = i % 4;
    const CurveFairingOptions options{.ends = static_cast<HeldEnds>(held)};
    const double tolerance = 0.03;
    const PolishedCurve found = polishCurve(curve, tolerance, options);
    EXPECT_LE(found.moved_mm, tolerance);
    EXPECT_LE(largestDistance_mm(curve, found.curve), found.moved_mm * (1 + 1e-9));
    EXPECT_LT(found.variation_after_per_mm3, found.variation_before_per_mm3);
    EXPECT_EQ(found.curve.knots, curve.knots);
    EXPECT_EQ(found.curve.poles.topRows(held), curve.poles.topRows(held));
    EXPECT_EQ(found.curve.poles.bottomRows(held), curve.poles.bottomRows(held));
    EXPECT_TRUE(!planar || (found.curve.poles.col(2).array() == 0).all());
    const PolishedCurve same = polishCurve(curve, 0, options);
    EXPECT_EQ(same.curve, curve);
    EXPECT_EQ(same.variation_after_per_mm3, same.variation_before_per_mm3);
    EXPECT_EQ(same.moved_mm, 0);
  }
}

TEST(PolishCurve, TheVariationIsThatOfASample) {
  std::mt19937_64 random(testSeed());
  for (const bool planar : {true, false}) {
    const BSplineCurve curve = noisyCurve(4, 16, planar, 0.01, random);
    const PolishedCurve found = polishCurve(curve, 0.02);
    const double before = sampledVariation(curve), after = sampledVariation(found.curve);
    EXPECT_NEAR(found.variation_before_per_mm3, before, 0.01 * before);
    EXPECT_NEAR(found.variation_after_per_mm3, after, 0.01 * after);
    EXPECT_NEAR(variationOf(bezierSpline(found.curve)).energy_per_mm3,
                found.variation_after_per_mm3, 1e-9 * before);
    EXPECT_EQ(found.after.extrema, fairnessOf(found.curve).extrema);
    EXPECT_LE(found.after.extrema, found.before.extrema);
  }
}

/// With a tolerance that does not bind, no small move of a pole lowers the variation.
TEST(PolishCurve, TheVariationIsLeast) {
  std::mt19937_64 random(testSeed());
  const BSplineCurve curve = noisyCurve(4, 12, true, 0.05, random);
  const CurveFairingOptions options{.ends = HeldEnds::Tangent};
  const PolishedCurve found = polishCurve(curve, 100, options);
  EXPECT_LT(found.variation_after_per_mm3, 0.1 * found.variation_before_per_mm3);
  for (int i = 2; i < 10; ++i) {
    for (int axis = 0; axis < 2; ++axis) {
      for (const double step : {-0.02, 0.02}) {
        BSplineCurve trial = found.curve;
        trial.poles(i, axis) += step;
        EXPECT_GT(variationOf(bezierSpline(trial)).energy_per_mm3,
                  found.variation_after_per_mm3 * (1 - 1e-4));
      }
    }
  }
}

// Identity (2): a near-cusp must not hide between the nodes of a quadrature.
TEST(PolishCurve, MakesNoCusp) {
  Poles poles(4, 3);
  poles << 9.29, 6.67, 0, 4.377, 0.733, 0, 7.217, 1.112, 0, 3.034, 2.806, 0;
  const BSplineCurve curve = splineOf(3, {0, 0, 0, 0, 1, 1, 1, 1}, poles);
  const PolishedCurve found = polishCurve(curve, 1.54);
  const auto dense = [](const BSplineCurve& of) {
    return test::denseVariation(bezierSpline(of), 2'000'000);
  };
  EXPECT_NEAR(found.variation_before_per_mm3, 26.71, 0.01);
  EXPECT_NEAR(found.variation_before_per_mm3 / dense(curve), 1, 1e-6);
  EXPECT_NEAR(found.variation_after_per_mm3 / dense(found.curve), 1, 1e-6);
  EXPECT_LT(found.variation_after_per_mm3, 1);
}

// Identity (2).
TEST(PolishCurve, TheVariationOfWildCurvesDoesNotGrow) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const int degree = i % 3 == 2 ? 5 : 3;
    const int count = degree + 1 + static_cast<int>(random() % (7 - degree));
    Poles poles(count, 3);
    for (int k = 0; k < count; ++k)
      poles.row(k) << uniform(random, 0, 10), uniform(random, 0, 10),
          i % 4 == 3 ? uniform(random, 0, 10) : 0;
    const BSplineCurve curve = splineOf(degree, test::randomKnots(degree, count, random), poles);
    const PolishedCurve found = polishCurve(curve, uniform(random, 0.05, 2));
    const double before = test::denseVariation(bezierSpline(curve), 100'000),
                 after = test::denseVariation(bezierSpline(found.curve), 100'000);
    EXPECT_LE(after, before) << i;
    EXPECT_NEAR(found.variation_before_per_mm3 / before, 1, 1e-5) << i;
    EXPECT_NEAR(found.variation_after_per_mm3 / after, 1, 1e-5) << i;
  }
}

// Identity (4).
TEST(PolishCurve, FollowsMotionAndScale) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 6; ++i) {
    const bool planar = i % 2 == 0;
    const BSplineCurve curve = noisyCurve(3, 16, planar, 0.05, random);
    const double scale = std::exp2(static_cast<int>(random() % 9) - 4);
    const Eigen::Vector3d axis =
        planar ? Eigen::Vector3d(0, 0, 1) : Eigen::Vector3d(1, 2, 3).normalized();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(uniform(random, -3, 3), axis).toRotationMatrix();
    const Eigen::RowVector3d shift(1, -2, planar ? 0 : 0.5);
    BSplineCurve other = curve;
    other.poles.leftCols<3>() = scale * curve.poles.leftCols<3>() * turn;
    other.poles.leftCols<3>().rowwise() += shift;
    const PolishedCurve one = polishCurve(curve, 0.04), two = polishCurve(other, 0.04 * scale);
    BSplineCurve wanted = one.curve;
    wanted.poles.leftCols<3>() = scale * wanted.poles.leftCols<3>() * turn;
    wanted.poles.leftCols<3>().rowwise() += shift;
    EXPECT_LT(largestDistance_mm(two.curve, wanted), 0.004 * scale);
    EXPECT_NEAR(two.variation_before_per_mm3 * std::pow(scale, 3), one.variation_before_per_mm3,
                1e-9 * one.variation_before_per_mm3);
  }
}

// Identity (5): in the plane, and of a circle that is inclined in space.
TEST(PolishCurve, ANoisyArcBecomesTheArc) {
  std::mt19937_64 random(testSeed());
  const double radius_mm = 10;
  for (const bool planar : {true, false}) {
    const int count = 14, spans = count - 3;
    std::vector<double> knots(4, 0.0);
    for (int i = 1; i < spans; ++i) knots.push_back(i);
    knots.insert(knots.end(), 4, spans);
    std::vector<double> parameters;
    Poles points(400, 3);
    const Eigen::Matrix3d turn =
        planar ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
               : Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    for (int k = 0; k < 400; ++k) {
      const double share = k / 399.0, angle = 4 * share;
      parameters.push_back(spans * share);
      points.row(k) = radius_mm * Eigen::RowVector3d(std::cos(angle), std::sin(angle), 0) * turn;
    }
    const BSplineCurve arc = smoothingSpline(3, knots, parameters, points, 1e-9);
    BSplineCurve noisy = arc;
    for (int i = 2; i < count - 2; ++i)
      for (int axis = 0; axis < (planar ? 2 : 3); ++axis)
        noisy.poles(i, axis) += uniform(random, -0.1, 0.1);
    const PolishedCurve found = polishCurve(noisy, 1, {.ends = HeldEnds::Tangent});
    const auto away = [&](const BSplineCurve& curve) {
      double largest = 0;
      for (int k = 0; k <= 1000; ++k) {
        const CurveDerivatives at = derivatives(curve, spans * k / 1000.0, 0);
        const double above = at.row(0).dot(Eigen::RowVector3d(0, 0, 1) * turn);
        largest = std::max({largest, std::abs(at.row(0).norm() - radius_mm), std::abs(above)});
      }
      return largest;
    };
    EXPECT_GT(away(noisy), 0.05);
    EXPECT_LT(away(found.curve), 1);
    EXPECT_LT(found.variation_after_per_mm3, 3e-2 * found.variation_before_per_mm3);
    EXPECT_LE(found.variation_after_per_mm3, 1.001 * variationOf(bezierSpline(arc)).energy_per_mm3);
  }
}

TEST(PolishCurve, LinesAndHeldCurvesStay) {
  Poles poles(5, 3);
  poles << 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0;
  const BSplineCurve line = splineOf(4, {0, 0, 0, 0, 0, 1, 1, 1, 1, 1}, poles);
  EXPECT_EQ(polishCurve(line, 1).curve, line);
  poles(2, 1) = 1;
  const BSplineCurve curve = splineOf(4, line.knots, poles);
  const PolishedCurve found = polishCurve(curve, 1, {.ends = HeldEnds::Curvature});
  EXPECT_EQ(found.curve, curve);
  EXPECT_EQ(found.moved_mm, 0);
}

TEST(PolishCurve, InvalidInputIsNamed) {
  std::mt19937_64 random(testSeed());
  const BSplineCurve curve = noisyCurve(3, 8, true, 0.1, random);
  for (const double bad : {-1.0, std::nan(""), HUGE_VAL})
    EXPECT_THAT([&] { polishCurve(curve, bad); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("the tolerance is")));
  BSplineCurve rational = curve;
  rational.poles.row(2) *= 2;
  EXPECT_THAT([&] { polishCurve(rational, 1); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("rational")));
  EXPECT_THAT([&] { polishCurve(noisyCurve(2, 8, true, 0.1, random), 1); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("the degree is 2")));
  Poles poles(6, 3);
  poles << 0, 0, 0, 1, 1, 0, 2, 0, 0, 3, 1, 0, 4, 0, 0, 5, 1, 0;
  EXPECT_THAT(
      [&] {
        polishCurve(splineOf(3, {0, 0, 0, 0, 2, 2, 3, 3, 3, 3}, poles), 1);
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("knot 2, of a multiplicity above 1")));
  EXPECT_THAT(
      [&] {
        polishCurve(splineOf(3, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}, Poles::Zero(6, 3)), 1);
      },
      ThrowsMessage<std::domain_error>(HasSubstr("the curve stops")));
}

}  // namespace
}  // namespace seamwright
