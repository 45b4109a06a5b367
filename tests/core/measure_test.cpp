// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <limits>
#include <numbers>
#include <seamwright/core/seam/measure.hpp>

#include "support/random.hpp"
#include "surfaces.hpp"

namespace seamwright {
namespace {

using test::Vec;

constexpr int cases = 500;

PairMeasure measure(const SurfaceJet& a, const SurfaceJet& b) {
  return measurePair({a, {}}, {b, {}});
}

Eigen::Matrix3d rotationAbout(const Vec& axis, double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, axis.normalized()).toRotationMatrix();
}

/// Two random surface points that meet at a small angle about a common tangent.
std::pair<SurfaceJet, SurfaceJet> randomPair(std::mt19937_64& random) {
  const Vec k = test::randomVector(random), q = test::randomVector(random);
  SurfaceJet a = test::quadric(k.x(), k.y(), k.z());
  SurfaceJet b = test::quadric(q.x(), q.y(), q.z());
  b = test::mapped(b, rotationAbout({0.6, 0.8, 0}, 0.3 * test::randomVector(random).x()),
                   1e-3 * test::randomVector(random));
  return {test::reparametrised(a, test::randomJacobian(random), random),
          test::reparametrised(b, test::randomJacobian(random), random)};
}

void expectSameFigures(const PairMeasure& x, const PairMeasure& y, double tolerance, int i) {
  ASSERT_TRUE(x.angle_rad && y.angle_rad && x.curvature && y.curvature && x.gap_mm && y.gap_mm)
      << i;
  EXPECT_NEAR(*x.gap_mm, *y.gap_mm, tolerance) << i;
  EXPECT_NEAR(*x.angle_rad, *y.angle_rad, tolerance) << i;
  EXPECT_NEAR(x.curvature->difference_per_mm, y.curvature->difference_per_mm, 10 * tolerance) << i;
}

TEST(MeasurePair, Identity1SwappingTheSidesChangesNothing) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const auto [a, b] = randomPair(random);
    expectSameFigures(measure(a, b), measure(b, a), 1e-10, i);
    EXPECT_NEAR(measure(a, b).curvature->norm_a_per_mm, measure(b, a).curvature->norm_b_per_mm,
                1e-10);
  }
}

TEST(MeasurePair, Identity2ReversingANormalChangesNothing) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const auto [a, b] = randomPair(random);
    const PairMeasure plain = measure(a, b);
    expectSameFigures(plain, measure(test::flipped(a), b), 1e-11, i);
    expectSameFigures(plain, measure(a, test::flipped(b)), 1e-11, i);
    expectSameFigures(plain, measure(test::flipped(a), test::flipped(b)), 1e-11, i);
  }
}

TEST(MeasurePair, Identity3RigidMotionMirrorAndScale) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const auto [a, b] = randomPair(random);
    Eigen::Matrix3d R = test::randomRotation(random);
    if (i % 2 == 1) R.col(0) = -R.col(0);
    const Vec t = test::randomVector(random);
    const PairMeasure plain = measure(a, b);
    expectSameFigures(plain, measure(test::mapped(a, R, t), test::mapped(b, R, t)), 1e-10, i);
    const double s = test::logUniform(random, -4, 4);
    const Eigen::Matrix3d S = s * Eigen::Matrix3d::Identity();
    const PairMeasure scaled = measure(test::mapped(a, S), test::mapped(b, S));
    EXPECT_NEAR(*scaled.gap_mm / s, *plain.gap_mm, 1e-12);
    EXPECT_NEAR(*scaled.angle_rad, *plain.angle_rad, 1e-12);
    EXPECT_NEAR(scaled.curvature->difference_per_mm * s, plain.curvature->difference_per_mm, 1e-9);
  }
}

TEST(MeasurePair, Identity4ReparametrisationChangesNothing) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const auto [a, b] = randomPair(random);
    const SurfaceJet c = test::reparametrised(b, test::randomJacobian(random), random);
    expectSameFigures(measure(a, b), measure(a, c), 1e-8, i);
  }
}

TEST(MeasurePair, Identity5CrossedCylindersInAnyOrientation) {
  std::mt19937_64 random(testSeed());
  const double R = 10;
  const SurfaceJet first = test::cylinder(R, 0.4, 2);
  const Vec normal = first.u.cross(first.v).normalized();
  for (int degrees = 0; degrees <= 180; degrees += 15) {
    const double phi = degrees * std::numbers::pi / 180;
    SurfaceJet second = test::mapped(first, rotationAbout(normal, phi));
    second.p = first.p;
    for (int i = 0; i < 50; ++i) {
      const Eigen::Matrix3d turn = test::randomRotation(random);
      const PairMeasure pair = measure(test::mapped(first, turn),
                                       test::mapped(i % 2 ? second : test::flipped(second), turn));
      EXPECT_NEAR(pair.curvature->difference_per_mm, std::sin(phi) / R, 1e-15) << degrees;
      EXPECT_NEAR(pair.curvature->norm_a_per_mm, 1 / R, 1e-15);
      EXPECT_NEAR(relativeDifference(*pair.curvature, 1e5), std::sin(phi), 1e-13) << degrees;
      EXPECT_LT(*pair.angle_rad, 1e-14);
    }
  }
}

TEST(MeasurePair, Identity6TouchingSpheres) {
  for (const double R : {10.0, 10.001, 20.0, 1e4}) {
    const SurfaceJet small = test::sphere(10, 0.4, 0.3);
    SurfaceJet large = test::sphere(R, 0.4, 0.3);
    large.p = small.p;
    EXPECT_NEAR(measure(small, large).curvature->difference_per_mm, std::abs(0.1 - 1 / R), 1e-15);
    // Touching from outside, one against the other: the curvatures have opposite signs.
    SurfaceJet outside = test::mapped(large, -Eigen::Matrix3d::Identity());
    outside.p = small.p;
    EXPECT_NEAR(measure(small, outside).curvature->difference_per_mm, 0.1 + 1 / R, 1e-15);
  }
}

/// Sides of a seam along x whose graphs over their tangent planes have random curvature and change
/// of curvature; the planes meet at a small angle about x.
struct ThirdOrderPair {
  SidePoint a, b;
  double change_a, change_b;  ///< f_bbb in the direction +y
};

ThirdOrderPair randomThirdOrderPair(std::mt19937_64& random) {
  const auto side = [&](double& change) {
    const Vec k = test::randomVector(random);
    const Vec c = test::randomVector(random);
    change = test::randomVector(random).x();
    SidePoint point;
    point.jet = test::withCubic(test::quadric(k.x(), k.y(), k.z()), {c.x(), c.y(), c.z(), change});
    point.jet = test::reparametrised(point.jet, test::randomJacobian(random), random);
    point.tangent = {test::logUniform(random, -3, 3), 0, 0};
    point.third_order = true;
    return point;
  };
  ThirdOrderPair pair{};
  pair.a = side(pair.change_a);
  pair.b = side(pair.change_b);
  pair.b.jet =
      test::mapped(pair.b.jet, rotationAbout({1, 0, 0}, 0.1 * test::randomVector(random).x()));
  return pair;
}

SidePoint mapped(SidePoint point, const Eigen::Matrix3d& map,
                 const Vec& translation = Vec::Zero()) {
  point.jet = test::mapped(point.jet, map, translation);
  point.tangent = map * point.tangent;
  return point;
}

SidePoint flipped(SidePoint point) {
  point.jet = test::flipped(point.jet);
  point.face_on_left = !point.face_on_left;
  return point;
}

SidePoint reversed(SidePoint point) {
  point.tangent = -point.tangent;
  point.face_on_left = !point.face_on_left;
  return point;
}

void expectChange(const PairMeasure& pair, double difference, double change_a, double change_b,
                  double noise, int i) {
  ASSERT_TRUE(pair.curvature_change) << i;
  EXPECT_NEAR(pair.curvature_change->difference_per_mm2, std::abs(difference), noise) << i;
  EXPECT_NEAR(pair.curvature_change->change_a_per_mm2, std::abs(change_a), noise) << i;
  EXPECT_NEAR(pair.curvature_change->change_b_per_mm2, std::abs(change_b), noise) << i;
}

constexpr double change_noise = 1e-6;  // parameters of condition 100 enter in third power

TEST(CurvatureChangeOfAPair, Identities1And2SwapReversalAndFlips) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const auto [a, b, change_a, change_b] = randomThirdOrderPair(random);
    const double difference = change_b - change_a;
    expectChange(measurePair(a, b), difference, change_a, change_b, change_noise, i);
    expectChange(measurePair(b, a), difference, change_b, change_a, change_noise, i);
    expectChange(measurePair(reversed(a), reversed(b)), difference, change_a, change_b,
                 change_noise, i);
    expectChange(measurePair(flipped(a), b), difference, change_a, change_b, change_noise, i);
    expectChange(measurePair(a, flipped(b)), difference, change_a, change_b, change_noise, i);
    expectChange(measurePair(flipped(a), flipped(b)), difference, change_a, change_b, change_noise,
                 i);
  }
}

TEST(CurvatureChangeOfAPair, Identity3RigidMotionMirrorAndScale) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const auto [a, b, change_a, change_b] = randomThirdOrderPair(random);
    Eigen::Matrix3d R = test::randomRotation(random);
    if (i % 2 == 1) R.col(0) = -R.col(0);
    const double s = test::logUniform(random, -4, 4);
    const Vec t = test::randomVector(random);
    const PairMeasure pair = measurePair(mapped(a, s * R, t), mapped(b, s * R, t));
    ASSERT_TRUE(pair.curvature_change);
    EXPECT_NEAR(pair.curvature_change->difference_per_mm2 * s * s, std::abs(change_b - change_a),
                change_noise);
    const PairMeasure plain = measurePair(a, b);
    EXPECT_NEAR(relativeChange(*pair.curvature_change, *pair.curvature, 1e5 * s),
                relativeChange(*plain.curvature_change, *plain.curvature, 1e5), change_noise);
  }
}

TEST(CurvatureChangeOfAPair, Identity4ReparametrisationChangesNothing) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    auto [a, b, change_a, change_b] = randomThirdOrderPair(random);
    b.jet = test::reparametrised(b.jet, test::randomJacobian(random), random);
    expectChange(measurePair(a, b), change_b - change_a, change_a, change_b, 1e-4, i);
  }
}

TEST(CurvatureChangeOfAPair, NothingWithoutThirdPartialsOrWithoutADirection) {
  std::mt19937_64 random(testSeed());
  const ThirdOrderPair pair = randomThirdOrderPair(random);
  const auto spoilt = [&](auto spoil) {
    SidePoint b = pair.b;
    spoil(b);
    return measurePair(pair.a, b);
  };
  EXPECT_TRUE(spoilt([](SidePoint&) {}).curvature_change);
  EXPECT_FALSE(spoilt([](SidePoint& b) { b.third_order = false; }).curvature_change);
  EXPECT_FALSE(spoilt([](SidePoint& b) { b.tangent.setZero(); }).curvature_change);
  EXPECT_FALSE(spoilt([](SidePoint& b) { b.tangent = -b.tangent; }).curvature_change);
  const PairMeasure endless =
      spoilt([](SidePoint& b) { b.jet.vvv.z() = std::numeric_limits<double>::infinity(); });
  EXPECT_FALSE(endless.curvature_change);
  EXPECT_TRUE(endless.curvature);
}

TEST(MeasurePair, AngleIsAccurateFromRoundingToARightAngle) {
  const SurfaceJet flat = test::quadric(0, 0, 0);
  for (const double angle : {0.0, 1e-14, 1e-9, 1e-3, 0.5, 1.5, std::numbers::pi / 2}) {
    const SurfaceJet tilted = test::mapped(flat, rotationAbout({1, 0, 0}, angle));
    EXPECT_NEAR(*measure(flat, tilted).angle_rad, angle, 1e-15 + 1e-15 * angle);
  }
  const SurfaceJet beyond = test::mapped(flat, rotationAbout({1, 0, 0}, 2.0));
  EXPECT_NEAR(*measure(flat, beyond).angle_rad, std::numbers::pi - 2.0, 1e-15);
}

TEST(MeasurePair, TurningAboutTheSeamLeavesTheCurvatureDifference) {
  // Parabolic cylinder along the seam x; the other side is the same surface turned about x: no
  // curvature jump in x.
  const SurfaceJet a = test::quadric(0.3, 0, 0);
  for (const double angle : {0.0, 0.01, 0.05})
    EXPECT_NEAR(
        measure(a, test::mapped(a, rotationAbout({1, 0, 0}, angle))).curvature->difference_per_mm,
        0, 1e-15);
}

TEST(MeasurePair, FoldIsToldFromASmoothJoinInEveryOrientation) {
  std::mt19937_64 random(testSeed());
  const SurfaceJet flat = test::quadric(0, 0, 0);
  for (int i = 0; i < cases; ++i) {
    const Eigen::Matrix3d turn = test::randomRotation(random);
    const bool flip_a = i & 1, flip_b = i & 2, mirror = i & 4, backwards = i & 8;
    // Face a lies at y > 0; the seam runs along +x with it on the left. Flipping the normal
    // exchanges left and right.
    const Vec seam = backwards ? Vec(-1, 0, 0) : Vec(1, 0, 0);
    Eigen::Matrix3d map = turn;
    if (mirror) map.col(2) = -map.col(2);
    const auto side = [&](bool flip, bool above) {
      SidePoint point;
      point.jet = test::mapped(flip ? test::flipped(flat) : flat, map);
      point.tangent = map * seam * test::logUniform(random, -3, 3);
      const Vec normal = point.jet.u.cross(point.jet.v);
      const Vec inward = map * Vec(0, above ? 1 : -1, 0);
      point.face_on_left = normal.cross(point.tangent).dot(inward) > 0;
      return point;
    };
    EXPECT_FALSE(measurePair(side(flip_a, true), side(flip_b, false)).fold) << i;
    EXPECT_TRUE(measurePair(side(flip_a, true), side(flip_b, true)).fold) << i;
  }
}

TEST(MeasurePair, FoldIsNotClaimedWhereTangentsContradictOrAreMissing) {
  SidePoint a{test::quadric(0, 0, 0), {}, {1, 0, 0}, true};
  SidePoint b = a;
  EXPECT_TRUE(measurePair(a, b).fold);
  b.tangent = -a.tangent;
  EXPECT_FALSE(measurePair(a, b).fold);
  b.tangent = Vec::Zero();
  EXPECT_FALSE(measurePair(a, b).fold);
}

TEST(MeasurePair, DegenerateInputIsNamedAndNeverNaN) {
  const SurfaceJet good = test::cylinder(1, 0, 0);
  SurfaceJet pole = good;
  pole.u.setZero();
  const PairMeasure at_pole = measure(good, pole);
  EXPECT_EQ(at_pole.degenerate_a, Degeneracy::None);
  EXPECT_EQ(at_pole.degenerate_b, Degeneracy::VanishingNormal);
  EXPECT_FALSE(at_pole.angle_rad.has_value());
  EXPECT_FALSE(at_pole.curvature.has_value());
  EXPECT_EQ(at_pole.gap_mm, 0.0);
  SurfaceJet broken = good;
  broken.p.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(measure(broken, good).degenerate_a, Degeneracy::NotFinite);
  EXPECT_FALSE(measure(broken, good).gap_mm.has_value());
  SurfaceJet fast = test::quadric(1, 0, 0);
  fast.u.x() = 1e-160;
  EXPECT_FALSE(measure(fast, fast).curvature.has_value());
}

TEST(RelativeChange, IsAShareOfTheLargestChangeOrOfTheSquareOfTheCurvature) {
  const double flat_radius = 1e5;
  // A circular arc of radius 10, then a spiral: d(radius)/ds jumps by 0.3.
  EXPECT_DOUBLE_EQ(relativeChange({0.003, 0, 0.003}, {0, 0.1, 0.1}, flat_radius), 0.3);
  // A straight line, then a spiral.
  EXPECT_DOUBLE_EQ(relativeChange({0.003, 0, 0.003}, {0, 0, 0}, flat_radius), 1);
  EXPECT_DOUBLE_EQ(relativeChange({0.01, 0.05, 0.04}, {0, 0.1, 0.1}, flat_radius), 0.2);
  EXPECT_DOUBLE_EQ(relativeChange({0.09, 0.05, 0.04}, {0, 0.01, 0.1}, flat_radius), 1.8);
}

TEST(RelativeChange, IsZeroWhereBothSidesAreFlat) {
  const double flat_radius = 1e5;
  EXPECT_EQ(relativeChange({9e-9, 9e-9, 0}, {0, 0, 0}, flat_radius), 0);
  EXPECT_EQ(relativeChange({9e-9, 9e-9, 0}, {0, 2e-5, 2e-5}, flat_radius), 0);
  EXPECT_EQ(relativeChange({0, 0, 0}, {0, 0, 0}, flat_radius), 0);
  EXPECT_EQ(relativeChange({1.1e-8, 1.1e-8, 0}, {0, 0, 0}, flat_radius), 1);
  EXPECT_EQ(relativeChange({1.1e-8, 0, 1.1e-8}, {0, 2e-5, 2e-5}, flat_radius), 1);
}

TEST(RelativeDifference, IsZeroWhereBothSidesAreFlat) {
  const double flat_radius = 1000;
  EXPECT_EQ(relativeDifference({5e-4, 5e-4, 0}, flat_radius), 0);
  EXPECT_EQ(relativeDifference({0.002, 0.002, 0}, flat_radius), 1);
  EXPECT_DOUBLE_EQ(relativeDifference({0.001, 0.0015, 0.0005}, flat_radius), 2.0 / 3);
  EXPECT_DOUBLE_EQ(relativeDifference({1e-6, 0.001, 0.000999}, flat_radius), 0.001);
  EXPECT_DOUBLE_EQ(relativeDifference({0.001, 0.004, 0.005}, flat_radius), 0.2);
  EXPECT_DOUBLE_EQ(relativeDifference({0.009, 0.004, 0.005}, flat_radius), 1.8);
}

}  // namespace
}  // namespace seamwright
