// SPDX-License-Identifier: LGPL-2.1-or-later
#include <map>

#include <seamwright/core/planar/fair_points.hpp>

#include "planar.hpp"

namespace seamwright {
namespace {

using std::numbers::pi;
using test::number;
using test::planarPoints;
using test::uniform;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// Points of a spiral arm, moved by up to \p noise_mm in each coordinate.
PlanarPoints noisyArm(Eigen::Index count, double noise_mm, std::mt19937_64& random) {
  PlanarPoints points(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double t = 2.5 * (double(i) + uniform(random, -0.2, 0.2)) / double(count - 1);
    points.row(i) << (5 + 2 * t) * std::cos(t) + uniform(random, -noise_mm, noise_mm),
        (5 + 2 * t) * std::sin(t) + uniform(random, -noise_mm, noise_mm);
  }
  return points;
}

PlanarPoints noisyRing(Eigen::Index count, double noise_mm, std::mt19937_64& random) {
  PlanarPoints points(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double t = 2 * pi * (double(i) + uniform(random, -0.2, 0.2)) / double(count);
    points.row(i) << 5 * std::cos(t) + uniform(random, -noise_mm, noise_mm),
        3 * std::sin(t) + uniform(random, -noise_mm, noise_mm);
  }
  return points;
}

// Identities (1) and (2).
TEST(FairPoints, StayWithinTheTolerancesAndAreFairer) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 30; ++i) {
    const bool closed = i % 2 == 0;
    const Eigen::Index count = 12 + Eigen::Index(random() % 80);
    const double noise_mm = 0.02;
    const PlanarPoints points =
        closed ? noisyRing(count, noise_mm, random) : noisyArm(count, noise_mm, random);
    Eigen::VectorXd tolerances(count);
    for (double& tolerance : tolerances)
      tolerance = random() % 5 == 0 ? 0 : uniform(random, 0.5, 2) * noise_mm;
    const FairedPoints found =
        fairPoints(points, tolerances, {.closed = closed, .ends_fixed = i % 3 == 0});
    EXPECT_EQ(found.status, PointFairingStatus::Converged) << found.steps;
    EXPECT_LT(found.steps, 60);
    const Eigen::VectorXd moves = (found.points - points).rowwise().norm();
    for (Eigen::Index k = 0; k < count; ++k) {
      EXPECT_LE(moves(k), tolerances(k)) << k;
      if (tolerances(k) > 0) continue;
      EXPECT_EQ(found.points.row(k), points.row(k)) << k;
    }
    EXPECT_EQ(found.moved_mm, moves.maxCoeff());
    EXPECT_EQ(moves(found.most_moved), found.moved_mm);
    EXPECT_LT(found.after.energy_per_mm3, found.before.energy_per_mm3);
  }
}

TEST(FairPoints, OfACurveLoseTheWavesOfTheirNoise) {
  std::mt19937_64 random(testSeed());
  const PlanarPoints arm = noisyArm(200, 0.003, random);
  const FairedPoints found = fairPoints(arm, Eigen::VectorXd::Constant(200, 0.006));
  EXPECT_GT(found.before.extrema.size(), 50u);
  EXPECT_LT(found.after.extrema.size(), 6u);
  EXPECT_TRUE(found.after.inflections.empty());
  EXPECT_LT(found.after.energy_per_mm3, 1e-5 * found.before.energy_per_mm3);
}

// Identity (3): the derivative by differences.
TEST(FairPoints, NoMoveWithinTheTolerancesIsFairer) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 20; ++i) {
    const bool closed = i % 2 == 0;
    const Eigen::Index count = 10 + Eigen::Index(random() % 10);
    const PlanarPoints points =
        closed ? noisyRing(count, 0.05, random) : noisyArm(count, 0.05, random);
    const double tolerance = 0.04;
    const FairedPoints found = fairPoints(points, Eigen::VectorXd::Constant(count, tolerance),
                                          {.closed = closed, .ends_fixed = false});
    ASSERT_EQ(found.status, PointFairingStatus::Converged);
    const double energy = found.after.energy_per_mm3;
    for (Eigen::Index k = 0; k < count; ++k) {
      const Eigen::Index before =
          closed ? (k + count - 1) % count : std::max<Eigen::Index>(k - 1, 0);
      const Eigen::Index after = closed ? (k + 1) % count : std::min(k + 1, count - 1);
      const Eigen::RowVector2d chord = (points.row(after) - points.row(before)).normalized();
      const Eigen::RowVector2d normal(-chord.y(), chord.x());
      const double share = (found.points.row(k) - points.row(k)).dot(normal) / tolerance;
      for (const double step : {-0.01, 0.01}) {
        if (std::abs(share + step) > 1) continue;
        PlanarPoints other = found.points;
        other.row(k) += step * tolerance * normal;
        EXPECT_GT(fairnessOf(other, closed).energy_per_mm3, energy * (1 - 1e-5))
            << k << ": " << share;
      }
    }
  }
}

// Identity (3), by Newton's method with an active set.
TEST(FairPoints, AgreeWithHighPrecision) {
  for (const nlohmann::json& entry : test::splineCases("fair_points.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const PlanarPoints points = planarPoints(entry["in"]["P"]);
    const std::vector<double> tol = test::numbers(entry["in"]["tol"]);
    const Eigen::VectorXd tolerances = Eigen::VectorXd::Map(tol.data(), std::ssize(tol));
    const FairedPoints found =
        fairPoints(points, tolerances, {.closed = entry["in"]["closed"] == 1, .ends_fixed = false});
    EXPECT_EQ(found.status, PointFairingStatus::Converged);
    const double least = number(entry["out"]["energy"]);
    EXPECT_GT(found.after.energy_per_mm3, least * (1 - 1e-10));
    EXPECT_LT(found.after.energy_per_mm3, least * (1 + 1e-5));
    const PlanarPoints wanted = planarPoints(entry["out"]["P_new"]);
    const Eigen::ArrayXd apart = (found.points - wanted).rowwise().norm();
    EXPECT_LT((apart - 0.01 * tolerances.array()).maxCoeff(), 1e-15);
  }
}

// Points of a curve of known energy, moved across it by more than their distances.
TEST(FairPoints, OfACrowdedCurveAreAsFairAsTheCurve) {
  std::mt19937_64 random(testSeed());
  for (const bool closed : {false, true}) {
    constexpr Eigen::Index count = 3000;
    const double tolerance = 0.03, noise_mm = 0.025;
    PlanarPoints exact(count, 2), points(count, 2);
    for (Eigen::Index i = 0; i < count; ++i) {
      const double t = 2 * pi * double(i) / double(closed ? count : count - 1);
      exact.row(i) << 5 * std::cos(t), 3 * std::sin(t);
      const Eigen::RowVector2d normal(3 * std::cos(t), 5 * std::sin(t));
      points.row(i) = exact.row(i) + uniform(random, -noise_mm, noise_mm) * normal.normalized();
    }
    const FairedPoints found = fairPoints(points, Eigen::VectorXd::Constant(count, tolerance),
                                          {.closed = closed, .ends_fixed = false});
    EXPECT_EQ(found.status, PointFairingStatus::Converged);
    EXPECT_LT(found.steps, 80);
    EXPECT_LE((found.points - points).rowwise().norm().maxCoeff(), tolerance);
    EXPECT_LT(found.after.energy_per_mm3, fairnessOf(exact, closed).energy_per_mm3);
    EXPECT_LE(found.after.extrema.size(), closed ? 4u : 5u);
    EXPECT_TRUE(found.after.inflections.empty());
  }
}

TEST(FairPoints, SayIfTheStepsRanOut) {
  std::mt19937_64 random(testSeed());
  const PlanarPoints points = noisyArm(50, 0.02, random);
  const Eigen::VectorXd tolerances = Eigen::VectorXd::Constant(50, 0.02);
  const FairedPoints found = fairPoints(points, tolerances, {.max_steps = 3});
  EXPECT_EQ(found.status, PointFairingStatus::NotConverged);
  EXPECT_EQ(found.steps, 3);
  EXPECT_LT(found.after.energy_per_mm3, found.before.energy_per_mm3);
}

// Identity (2).
TEST(FairPoints, OfACircleStay) {
  std::mt19937_64 random(testSeed());
  for (const bool closed : {true, false}) {
    PlanarPoints points(30, 2);
    for (Eigen::Index i = 0; i < 30; ++i)
      points.row(i) =
          7 * unitVector(2 * pi * (double(i) + uniform(random, -0.3, 0.3)) / 30).transpose();
    const FairedPoints found =
        fairPoints(points, Eigen::VectorXd::Constant(30, 0.1), {.closed = closed});
    EXPECT_EQ(found.points, points);
    EXPECT_EQ(found.status, PointFairingStatus::Converged);
  }
}

TEST(FairPoints, WithoutToleranceAreTheInput) {
  std::mt19937_64 random(testSeed());
  const PlanarPoints points = noisyArm(20, 0.1, random);
  EXPECT_EQ(fairPoints(points, Eigen::VectorXd::Zero(20)).points, points);
  EXPECT_EQ(filterCurvature(points, 0).points, points);
}

// Identity (4).
TEST(FairPoints, FollowMotionScaleAndReversal) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 10; ++i) {
    const PlanarPoints points = noisyArm(30, 0.02, random);
    const Eigen::VectorXd tolerances = Eigen::VectorXd::Constant(30, 0.015);
    const PlanarPoints fair = fairPoints(points, tolerances).points;
    const double scale = std::exp(uniform(random, -2, 2));
    const Eigen::Matrix2d motion =
        scale * Eigen::Rotation2Dd(uniform(random, -3, 3)).toRotationMatrix();
    const PlanarPoints other = fairPoints(points * motion, tolerances * scale).points;
    EXPECT_LT((other - fair * motion).rowwise().norm().maxCoeff(), 0.01 * 0.015 * scale);
    const PlanarPoints back = fairPoints(points.colwise().reverse(), tolerances).points;
    EXPECT_LT((back.colwise().reverse() - fair).rowwise().norm().maxCoeff(), 0.01 * 0.015);
  }
}

TEST(FairPoints, RefuseInvalidTolerances) {
  std::mt19937_64 random(testSeed());
  const PlanarPoints points = noisyArm(10, 0.1, random);
  const auto refused = [&](const Eigen::VectorXd& tolerances, const char* text) {
    EXPECT_THAT([&] { fairPoints(points, tolerances); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
  };
  refused(Eigen::VectorXd::Zero(9), "9 tolerances for 10 points");
  Eigen::VectorXd bad = Eigen::VectorXd::Constant(10, 0.1);
  for (const double value : {-0.1, std::nan(""), HUGE_VAL}) {
    bad(3) = value;
    refused(bad, "the tolerance of point 3 is");
  }
}

TEST(CurvatureFilter, APassAgreesWithHighPrecision) {
  int stay = 0;
  for (const nlohmann::json& entry : test::splineCases("curvature_filter.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const nlohmann::json &in = entry["in"], &out = entry["out"];
    const PlanarPoints points = planarPoints(in["P"]), original = planarPoints(in["P_orig"]);
    std::vector<double> directions;
    for (const nlohmann::json& theta : in["theta"]) directions.push_back(number(theta));
    const PlanarPoints found =
        curvatureFilterPass(points, original, directions, number(in["mu"]), number(in["tol"]));
    const PlanarPoints wanted = planarPoints(out["P_new"]);
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
      const bool inner = k > 0 && k < points.rows() - 2;
      if (inner && std::abs(number(out["alpha_bar"][k - 1])) > 1.569) {
        EXPECT_EQ(found.row(k), points.row(k));
        ++stay;
      } else {
        EXPECT_LT((found.row(k) - wanted.row(k)).norm(), 1e-13) << k;
      }
    }
  }
  EXPECT_GT(stay, 0);
}

// Identity (5).
TEST(CurvatureFilter, SmoothsWithinTheTolerance) {
  std::mt19937_64 random(testSeed());
  double before = 0, after = 0;
  for (int i = 0; i < 40; ++i) {
    const bool closed = i % 2 == 0;
    const PlanarPoints points = closed ? noisyRing(60, 0.01, random) : noisyArm(60, 0.01, random);
    const FairedPoints found = filterCurvature(points, 0.02, {.closed = closed});
    EXPECT_LE((found.points - points).rowwise().norm().maxCoeff(), 0.02);
    EXPECT_LE(found.after.energy_per_mm3, found.before.energy_per_mm3);
    before += found.before.energy_per_mm3;
    after += found.after.energy_per_mm3;
    const FairedPoints fairer =
        fairPoints(points, Eigen::VectorXd::Constant(60, 0.02), {.closed = closed});
    EXPECT_LT(fairer.after.energy_per_mm3, found.after.energy_per_mm3);
  }
  EXPECT_LT(after, 0.5 * before);
}

TEST(CurvatureFilter, SaysWhyItEnded) {
  std::mt19937_64 random(testSeed());
  std::map<PointFairingStatus, int> ends;
  for (int i = 0; i < 30; ++i) {
    const PlanarPoints points = noisyArm(60, 0.01, random);
    const FairedPoints found = filterCurvature(points, 0.02);
    ++ends[found.status];
    if (found.status != PointFairingStatus::EnergyGrows) continue;
    // One pass more than was taken is one too many.
    const FairedPoints same = filterCurvature(points, 0.02, {.max_passes = found.steps});
    EXPECT_EQ(same.points, found.points);
    EXPECT_EQ(same.status, PointFairingStatus::NotConverged);
  }
  EXPECT_GT(ends[PointFairingStatus::EnergyGrows], 0);
}

// Identity (7), far from the ends.
TEST(CurvatureFilter, ExtinguishesZigzags) {
  for (const double strength : {0.1, 0.25, 0.5}) {
    const double height = 1e-6;
    PlanarPoints points(201, 2);
    for (Eigen::Index i = 0; i < 201; ++i)
      points.row(i) << double(i), height * (i % 2 == 0 ? 1 : -1);
    const PlanarPoints found =
        curvatureFilterPass(points, points, tangentsAt(points).directions_rad, strength, 1);
    for (Eigen::Index i = 90; i < 110; ++i)
      EXPECT_NEAR(found(i, 1) / points(i, 1), 1 - 4 * strength, 1e-5);
  }
}

// Identity (6).
TEST(CurvatureFilter, PointsOfACircleStay) {
  PlanarPoints points(24, 2);
  for (Eigen::Index i = 0; i < 24; ++i)
    points.row(i) = 7 * unitVector(2 * pi * double(i) / 24).transpose();
  const FairedPoints found = filterCurvature(points, 0.5, {.closed = true});
  EXPECT_LT((found.points - points).rowwise().norm().maxCoeff(), 1e-13);
  EXPECT_EQ(found.status, PointFairingStatus::Converged);
}

TEST(CurvatureFilter, RefusesInvalidNumbers) {
  std::mt19937_64 random(testSeed());
  const PlanarPoints points = noisyArm(10, 0.1, random);
  EXPECT_THAT([&] { filterCurvature(points, -1); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("the tolerance is -1 mm")));
  EXPECT_THAT([&] { filterCurvature(points, 1, {.strength = 0.6}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("the strength is 0.6")));
}

}  // namespace
}  // namespace seamwright
