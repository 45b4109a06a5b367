// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>

#include <seamwright/core/fair/curvature_profile.hpp>

#include "planar.hpp"

namespace seamwright {
namespace {

using test::number;
using test::uniform;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

BezierCurve planarCurve(const std::vector<Eigen::Vector2d>& poles,
                        const std::vector<double>& weights = {}) {
  Poles rows = Poles::Zero(static_cast<Eigen::Index>(poles.size()), 3);
  for (std::size_t i = 0; i < poles.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)).head<2>() = poles[i].transpose();
  if (weights.empty()) return BezierCurve(rows);
  return BezierCurve(rows, Eigen::VectorXd::Map(weights.data(), rows.rows()));
}

/// Poles along an axis with random heights, so that the curve does not stop.
BezierCurve randomPlanarCurve(std::mt19937_64& random, int degree, bool rational) {
  std::vector<Eigen::Vector2d> poles;
  std::vector<double> weights;
  for (int i = 0; i <= degree; ++i) {
    poles.emplace_back(i + uniform(random, -0.2, 0.2), uniform(random, -1, 1));
    if (rational) weights.push_back(uniform(random, 0.5, 2));
  }
  return planarCurve(poles, weights);
}

double signedCurvature(const BezierCurve& curve, double t) {
  const CurveDerivatives d = curve.derivatives(t, 2);
  return (d(1, 0) * d(2, 1) - d(1, 1) * d(2, 0)) / std::pow(d.row(1).norm(), 3);
}

std::vector<double> middles(const std::vector<CurvatureExtremum>& extrema) {
  std::vector<double> result;
  for (const CurvatureExtremum& extremum : extrema) result.push_back(extremum.parameters.middle());
  return result;
}

// Identity (1).
TEST(CurvatureProfile, AParabolaHasItsVertex) {
  // y = x^2 for x from -1 to 2: the vertex is at 1/3.
  const CurvatureProfile found = planarCurvatureProfile(planarCurve({{-1, 1}, {0.5, -2}, {2, 4}}));
  ASSERT_THAT(found.extrema, SizeIs(1));
  EXPECT_TRUE(found.extrema[0].parameters.contains(1.0 / 3));
  EXPECT_LT(found.extrema[0].parameters.width(), 1e-11);
  EXPECT_TRUE(found.extrema[0].maximum);
  EXPECT_NEAR(found.extrema[0].curvature_per_mm, 2, 1e-12);
  EXPECT_THAT(found.inflections, IsEmpty());
  EXPECT_THAT(found.undecided_extrema, IsEmpty());
  EXPECT_THAT(found.undecided_inflections, IsEmpty());
}

// Identity (1): the image of a quarter of a circle, from 45 to 135 degrees, scaled by 3 in x.
TEST(CurvatureProfile, AnEllipseHasItsVertex) {
  const double h = std::sqrt(0.5);
  const BezierCurve arc = planarCurve({{3 * h, h}, {0, 2 * h}, {-3 * h, h}}, {1, h, 1});
  const CurvatureProfile found = planarCurvatureProfile(arc);
  ASSERT_THAT(found.extrema, SizeIs(1));
  EXPECT_NEAR(found.extrema[0].parameters.middle(), 0.5, 1e-11);
  EXPECT_FALSE(found.extrema[0].maximum);
  EXPECT_NEAR(found.extrema[0].curvature_per_mm, 1.0 / 9, 1e-12);
}

TEST(CurvatureProfile, OfACircleAndALineIsUndecided) {
  const double h = std::sqrt(0.5);
  const CurvatureProfile circle =
      planarCurvatureProfile(planarCurve({{1, 0}, {1, 1}, {0, 1}}, {1, h, 1}));
  EXPECT_FALSE(circle.monotone());
  EXPECT_THAT(circle.extrema, IsEmpty());
  ASSERT_THAT(circle.undecided_extrema, SizeIs(1));
  EXPECT_EQ(circle.undecided_extrema[0].width(), 1);
  EXPECT_THAT(circle.undecided_inflections, IsEmpty());
  const CurvatureProfile line = planarCurvatureProfile(planarCurve({{0, 0}, {1, 1}, {3, 3}}));
  ASSERT_THAT(line.undecided_inflections, SizeIs(1));
  EXPECT_EQ(line.undecided_inflections[0].width(), 1);
}

TEST(CurvatureProfile, AgreesWithHighPrecision) {
  for (const nlohmann::json& entry : test::splineCases("curvature_profiles.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    std::vector<Eigen::Vector2d> poles;
    for (const nlohmann::json& pole : entry["in"]["P"]) poles.push_back(test::planarVector(pole));
    const CurvatureProfile found = planarCurvatureProfile(planarCurve(poles));
    const std::vector<double> extrema = test::numbers(entry["out"]["extrema"]);
    const std::vector<double> inflections = test::numbers(entry["out"]["inflections"]);
    EXPECT_THAT(middles(found.extrema), ::testing::Pointwise(::testing::DoubleNear(1e-9), extrema));
    ASSERT_EQ(found.inflections.size(), inflections.size());
    for (std::size_t i = 0; i < inflections.size(); ++i)
      EXPECT_NEAR(found.inflections[i].middle(), inflections[i], 1e-9);
    EXPECT_EQ(found.monotone(), entry["out"]["monotone"].get<bool>());
  }
}

// Identity (2).
TEST(CurvatureProfile, OfAReversedCurveIsMirrored) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const BezierCurve curve = randomPlanarCurve(random, 2 + i % 5, i % 2 == 1);
    const CurvatureProfile one = planarCurvatureProfile(curve);
    const CurvatureProfile other = planarCurvatureProfile(curve.reversed());
    const std::size_t n = one.extrema.size();
    ASSERT_EQ(other.extrema.size(), n);
    for (std::size_t k = 0; k < n; ++k) {
      const CurvatureExtremum &a = one.extrema[k], &b = other.extrema[n - 1 - k];
      EXPECT_NEAR(a.parameters.middle(), 1 - b.parameters.middle(), 1e-9);
      EXPECT_EQ(a.maximum, !b.maximum);
      EXPECT_NEAR(a.curvature_per_mm, -b.curvature_per_mm,
                  1e-9 * (1 + std::abs(a.curvature_per_mm)));
    }
  }
}

// Identity (2).
TEST(CurvatureProfile, MovesAlongWithTheCurve) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const bool rational = i % 2 == 1;
    const BezierCurve curve = randomPlanarCurve(random, 2 + i % 5, rational);
    const double angle = uniform(random, -3, 3), scale = std::exp2(i % 21 - 10);
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn.topLeftCorner<2, 2>() << std::cos(angle), -std::sin(angle), std::sin(angle),
        std::cos(angle);
    const Eigen::RowVector3d move(uniform(random, -9, 9), uniform(random, -9, 9), 0);
    const Poles poles = scale * ((curve.poles() * turn.transpose()).rowwise() + move);
    const BezierCurve moved = BezierCurve(poles, curve.weights());
    const CurvatureProfile one = planarCurvatureProfile(curve);
    const CurvatureProfile other = planarCurvatureProfile(moved);
    // The rounding of the moved poles moves extrema that lie close together.
    EXPECT_THAT(middles(other.extrema),
                ::testing::Pointwise(::testing::DoubleNear(1e-6), middles(one.extrema)));
    EXPECT_EQ(one.inflections.size(), other.inflections.size());
  }
}

// Identity (3).
/// Curvatures of hugely scaled curves would be lost in the products of derivatives.
TEST(CurvatureProfile, OfAHugeOrTinyCurveIsThatOfItsShape) {
  std::mt19937_64 random(testSeed());
  for (const double size : {1e-150, 1e-100, 1e100, 1e150})
    for (const bool rational : {false, true}) {
      const BezierCurve curve = randomPlanarCurve(random, 4, rational);
      const HomogeneousPoles& given = curve.homogeneousPoles();
      const BezierCurve scaled(curve.poles() * size, given.col(3));
      for (const auto& profileOf : {planarCurvatureProfile, spaceCurvatureProfile}) {
        const CurvatureProfile wanted = profileOf(curve), found = profileOf(scaled);
        ASSERT_EQ(found.extrema.size(), wanted.extrema.size());
        EXPECT_EQ(found.inflections.size(), wanted.inflections.size());
        for (std::size_t i = 0; i < wanted.extrema.size(); ++i)
          EXPECT_NEAR(found.extrema[i].curvature_per_mm * size, wanted.extrema[i].curvature_per_mm,
                      1e-9 * (1 + std::abs(wanted.extrema[i].curvature_per_mm)));
      }
    }
}

TEST(CurvatureProfile, DenseSamplesGrowAndFallAsItSays) {
  std::mt19937_64 random(testSeed());
  int extrema = 0;
  for (int i = 0; i < 100; ++i) {
    const BezierCurve curve = randomPlanarCurve(random, 2 + i % 5, i % 2 == 1);
    const CurvatureProfile found = planarCurvatureProfile(curve);
    std::vector<double> ends = middles(found.extrema);
    extrema += static_cast<int>(ends.size());
    ends.insert(ends.begin(), 0);
    ends.push_back(1);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const double whole = signedCurvature(curve, ends[k + 1]) - signedCurvature(curve, ends[k]);
      for (int j = 0; j < 40; ++j) {
        const double a = std::lerp(ends[k], ends[k + 1], j / 40.0);
        const double b = std::lerp(ends[k], ends[k + 1], (j + 1) / 40.0);
        const double step = signedCurvature(curve, b) - signedCurvature(curve, a);
        EXPECT_GE(step * (whole > 0 ? 1 : -1), -1e-9 * (1 + std::abs(whole)));
      }
    }
  }
  EXPECT_GT(extrema, 100);
}

// Identity (4): edges as of Farin's typical curves.
TEST(CurvatureProfile, TypicalCubicsAreMonotone) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const double angle = uniform(random, 0.05, 1), s = uniform(random, 1.01, 1.5) / std::cos(angle);
    std::vector<Eigen::Vector2d> poles = {Eigen::Vector2d(1, 2)};
    Eigen::Vector2d edge(0.3, 0.1);
    for (int k = 0; k < 3; ++k) {
      poles.push_back(poles.back() + edge);
      edge = s * (Eigen::Rotation2Dd(angle) * edge);
    }
    EXPECT_TRUE(planarCurvatureProfile(planarCurve(poles)).monotone()) << angle << ' ' << s;
  }
}

// Identity (5).
TEST(CurvatureProfile, InSpaceAgreesWithThePlane) {
  std::mt19937_64 random(testSeed());
  int compared = 0;
  for (int i = 0; i < 100; ++i) {
    const BezierCurve curve = randomPlanarCurve(random, 2 + i % 4, i % 2 == 1);
    const CurvatureProfile plane = planarCurvatureProfile(curve);
    if (!plane.inflections.empty() || !plane.undecided_inflections.empty()) continue;
    ++compared;
    const Eigen::Matrix3d turn = Eigen::Quaterniond(0.5, 0.1, -0.3, 0.8).normalized().matrix();
    const BezierCurve turned(Poles(curve.poles() * turn.transpose()), curve.weights());
    const CurvatureProfile space = spaceCurvatureProfile(turned);
    EXPECT_THAT(middles(space.extrema),
                ::testing::Pointwise(::testing::DoubleNear(1e-8), middles(plane.extrema)));
    const bool left = signedCurvature(curve, 0.5) > 0;
    ASSERT_EQ(space.extrema.size(), plane.extrema.size());
    for (std::size_t k = 0; k < space.extrema.size(); ++k)
      EXPECT_EQ(space.extrema[k].maximum, plane.extrema[k].maximum == left);
  }
  EXPECT_GT(compared, 20);
}

// With x = t^2 the squared curvature of (t, t^2, t^3) is 4 (1 + 9 x + 9 x^2) / (1 + 4 x + 9 x^2)^3.
// The numerator of its derivative by x is -3 - 108 x - 441 x^2 - 324 x^3: it falls from t = 0 on.
TEST(CurvatureProfile, TheTwistedCubicHasOneMaximum) {
  Poles poles(4, 3);
  poles << -1, 1, -1, -1.0 / 3, -1.0 / 3, 1, 1.0 / 3, -1.0 / 3, -1, 1, 1, 1;
  const CurvatureProfile found = spaceCurvatureProfile(BezierCurve(poles));
  ASSERT_THAT(found.extrema, SizeIs(1));
  EXPECT_NEAR(found.extrema[0].parameters.middle(), 0.5, 1e-10);
  EXPECT_TRUE(found.extrema[0].maximum);
  EXPECT_NEAR(found.extrema[0].curvature_per_mm, 2, 1e-12);
}

TEST(CurvatureProfile, InvalidCurvesAreNamed) {
  const auto message = [](const BezierCurve& curve) -> std::string {
    try {
      planarCurvatureProfile(curve);
      return "nothing";
    } catch (const std::exception& error) {
      return error.what();
    }
  };
  // A cusp at 1/2.
  EXPECT_THAT(message(planarCurve({{0, 0}, {1, 1}, {0, 1}, {1, 0}})),
              HasSubstr("may stop at the parameter 0.5"));
  EXPECT_THAT(message(planarCurve({{1, 1}, {1, 1}, {1, 1}})), HasSubstr("may stop"));
  EXPECT_THAT(message(planarCurve({{0, 0}})), HasSubstr("degree 0"));
  Poles outside = Poles::Zero(3, 3);
  outside(1, 2) = 0.5;
  EXPECT_THAT(message(BezierCurve(outside)), HasSubstr("pole 1 of the curve is outside"));
}

}  // namespace
}  // namespace seamwright
