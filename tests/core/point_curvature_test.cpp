// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/planar/point_curvature.hpp>

#include "planar.hpp"

namespace seamwright {
namespace {

using std::numbers::pi;
using test::number;
using test::planarPoints;
using test::uniform;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

/// Points of an ellipse, counter-clockwise, with uneven spacing.
PlanarPoints ellipse(double a, double b, Eigen::Index count, std::mt19937_64& random,
                     double spread = 0.3) {
  PlanarPoints points(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double angle =
        2 * pi * (static_cast<double>(i) + uniform(random, -spread, spread)) / double(count);
    points.row(i) << a * std::cos(angle), b * std::sin(angle);
  }
  return points;
}

// Identities (1) and (4).
TEST(PointCurvature, CirclesHaveOneCurvature) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 50; ++i) {
    const double radius = std::exp(uniform(random, -5, 5));
    PlanarPoints points = ellipse(radius, radius, 5 + Eigen::Index(random() % 60), random);
    points.rowwise() += Eigen::RowVector2d(uniform(random, -9, 9), uniform(random, -9, 9));
    for (const bool closed : {true, false}) {
      const Eigen::VectorXd found = pointCurvatures_per_mm(points, closed);
      EXPECT_EQ(found.size(), points.rows() - (closed ? 0 : 2));
      EXPECT_LT((found.array() * radius - 1).abs().maxCoeff(), 1e-8);
      const PointFairness fairness = fairnessOf(points, closed);
      EXPECT_THAT(fairness.extrema, IsEmpty());
      EXPECT_THAT(fairness.inflections, IsEmpty());
      EXPECT_LE(fairness.energy_per_mm3, fairness.rounding_per_mm3);
    }
  }
}

// Identity (2).
TEST(PointCurvature, FollowsMotionScaleAndReversal) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 50; ++i) {
    const PlanarPoints points = ellipse(uniform(random, 1, 5), 2, 20, random, 0.45);
    const Eigen::VectorXd curvatures = pointCurvatures_per_mm(points);
    const double angle = uniform(random, -3, 3), scale = std::exp(uniform(random, -3, 3));
    const PlanarPoints turned = scale * points * Eigen::Rotation2Dd(angle).toRotationMatrix();
    EXPECT_LT((pointCurvatures_per_mm(turned) * scale - curvatures).cwiseAbs().maxCoeff(), 1e-10);
    const PlanarPoints back = points.colwise().reverse();
    const Eigen::VectorXd opposite = -curvatures.reverse();
    EXPECT_LT((pointCurvatures_per_mm(back) - opposite).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(PointCurvature, AnEllipseHasFourExtremaAndASineWaveItsInflections) {
  std::mt19937_64 random(testSeed());
  EXPECT_EQ(fairnessOf(ellipse(3, 1, 200, random, 0), true).extrema.size(), 4u);
  // Half of it, from the end of one axis: the ends of a sequence are not extrema.
  const PlanarPoints half = ellipse(3, 1, 200, random, 0).topRows(101);
  EXPECT_THAT(fairnessOf(half).extrema, ElementsAre(50));
  PlanarPoints wave(401, 2);
  for (Eigen::Index i = 0; i <= 400; ++i) {
    const double x = (double(i) + 0.5) / 400 * 6 * pi;
    wave.row(i) << x, std::sin(x);
  }
  EXPECT_EQ(fairnessOf(wave).inflections.size(), 5u);
  EXPECT_EQ(fairnessOf(wave).extrema.size(), 6u);
  EXPECT_THAT(isolatedInflections(wave), IsEmpty());
}

TEST(PointCurvature, PointsOfALineHaveNeitherExtremaNorInflections) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    PlanarPoints points(40, 2);
    const Eigen::RowVector2d from(uniform(random, -50, 50), uniform(random, -50, 50));
    const Eigen::RowVector2d along(uniform(random, 1, 2), uniform(random, -2, 2));
    for (Eigen::Index k = 0; k < 40; ++k) points.row(k) = from + double(k) * 0.037 * along;
    const PointFairness fairness = fairnessOf(points);
    EXPECT_THAT(fairness.extrema, IsEmpty());
    EXPECT_THAT(fairness.inflections, IsEmpty());
  }
}

// The energy approximates the integral of the squared derivative of the curvature by arc length.
TEST(PointCurvature, TheEnergyIsThatOfTheCurve) {
  const int count = 2000;
  PlanarPoints points(count, 2);
  double integral = 0;
  for (int i = 0; i < count; ++i) {
    const double t = 2 * pi * i / count, a = 3, b = 2;
    points.row(i) << a * std::cos(t), b * std::sin(t);
    // The speed v of the ellipse; k = a b / v^3.
    const double v = std::hypot(a * std::sin(t), b * std::cos(t));
    const double slope = -3 * a * b / std::pow(v, 5) * (a * a - b * b) * std::sin(t) * std::cos(t);
    integral += slope * slope / v * 2 * pi / count;
  }
  EXPECT_NEAR(fairnessOf(points, true).energy_per_mm3, integral, 1e-4 * integral);
}

// Identity (3).
TEST(PointCurvature, AMisreadPointIsFound) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 50; ++i) {
    PlanarPoints points = ellipse(3, 2, 40, random, 0.1);
    const Eigen::Index k = 2 + Eigen::Index(random() % 36);
    points.row(k) *= 0.93;  // the height over the chord of the neighbours is 0.5 to 2.5 %
    EXPECT_THAT(isolatedInflections(points, true), ElementsAre(k));
    EXPECT_THAT(isolatedInflections(points), ElementsAre(k));
  }
}

TEST(PointCurvature, AgreesWithHighPrecision) {
  for (const nlohmann::json& entry : test::splineCases("point_curvatures.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const PlanarPoints points = planarPoints(entry["in"]["P"]);
    const Eigen::VectorXd found = pointCurvatures_per_mm(points);
    ASSERT_EQ(found.size(), Eigen::Index(entry["out"]["kappa"].size()));
    for (Eigen::Index i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found(i), number(entry["out"]["kappa"][i]), 1e-13);
    EXPECT_EQ(isolatedInflections(points), entry["out"]["bad"].get<std::vector<Eigen::Index>>());
  }
}

TEST(PointCurvature, BadPointsAreRefusedWithTheirIndices) {
  PlanarPoints points(4, 2);
  points << 0, 0, 1, 0, 2, 1, 0, 1;
  const auto refused = [](const PlanarPoints& bad, bool closed, const char* text) {
    EXPECT_THAT([&] { fairnessOf(bad, closed); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
  };
  refused(points.topRows(2), false, "2 points: at least 3 are needed");
  PlanarPoints bad = points;
  bad(2, 1) = std::nan("");
  refused(bad, false, "point 2 is not finite");
  bad = points;
  bad.row(2) = bad.row(1);
  refused(bad, false, "points 1 and 2 are equal");
  bad = points;
  bad.row(2) = bad.row(0);  // there and back
  refused(bad, false, "points 0 and 2 are equal");
  bad = points;
  bad.row(3) = bad.row(0);
  refused(bad, true, "points 3 and 0 are equal");
  EXPECT_NO_THROW(fairnessOf(bad, false));
}

TEST(PointCurvature, SizesBeyondTheRangeAreRefused) {
  const PlanarPoints points = planarPoints({{0, 0}, {1, 0.25}, {2, 0}, {3, 0.5}});
  for (const double size : {1e-200, 1e-40, 1e40, 1e150, 1e200}) {
    const PlanarPoints scaled = size * points;
    EXPECT_THAT([&] { pointCurvatures_per_mm(scaled); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("points 0 and 1 are")));
    EXPECT_THAT([&] { fairnessOf(scaled); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("mm apart")));
  }
}

}  // namespace
}  // namespace seamwright
