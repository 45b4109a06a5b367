// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <array>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/differential/arc_length.hpp>

#include "curves.hpp"
#include "support/random.hpp"
#include "surfaces.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::Vec;

constexpr int cases = 300;

CurveDerivatives byArcLength(const CurveDerivatives& derivatives) {
  const auto result = arcLengthDerivatives(derivatives);
  EXPECT_TRUE(result.has_value());
  return result.value_or(CurveDerivatives::Constant(derivatives.rows(), 3, std::nan("")));
}

double largestRelativeError(const CurveDerivatives& ours, const CurveDerivatives& wanted) {
  return (ours - wanted)
      .rowwise()
      .norm()
      .cwiseQuotient((wanted.rowwise().norm().array() + 1).matrix())
      .maxCoeff();
}

TEST(ArcLength, Identity1DerivativesOfCirclesTurnByRightAngles) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const double r = test::logUniform(random, -3, 4), start = i * 0.1;
    const CurveDerivatives circle = test::circle(r, start, 9);
    const CurveDerivatives other = test::reparametrised(circle, test::randomParameter(9, random));
    for (int k = 1; k <= 9; ++k) {
      // The k-th derivative of r (cos(s/r), sin(s/r)) is r^(1-k) times the point turned by k right
      // angles.
      const double angle = start + k * std::acos(0.0);
      const Vec wanted(std::cos(angle), std::sin(angle), 0);
      EXPECT_LT((std::pow(r, k - 1) * byArcLength(circle).row(k).transpose() - wanted).norm(),
                1e-15 * std::pow(4, k))
          << k;
      EXPECT_LT((std::pow(r, k - 1) * byArcLength(other).row(k).transpose() - wanted).norm(),
                1e-10 * std::pow(4, k))
          << k;
    }
  }
}

TEST(ArcLength, Identity2FrenetDataTo40Digits) {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/frenet.json");
  const json data = json::parse(file);
  ASSERT_EQ(data["cases"].size(), 8u);
  for (const json& entry : data["cases"]) {
    SCOPED_TRACE(entry["name"]);
    const json& out = entry["out"];
    const CurveDerivatives c =
        byArcLength(test::bezierCurve(entry["in"]["points"], entry["in"]["weights"])
                        .derivatives(entry["in"]["t"], 3));
    const Vec T = test::vector(out["T"]), N = test::vector(out["N"]), B = test::vector(out["B"]);
    const double kappa = out["kappa"], tau = out["tau"], kappa_s = out["dkappa_ds"];
    EXPECT_LT((c.row(1).transpose() - T).norm(), 1e-14);
    EXPECT_LT((c.row(2).transpose() - kappa * N).norm(), 1e-12 * (1 + kappa));
    const Vec c3 = -kappa * kappa * T + kappa_s * N + kappa * tau * B;
    EXPECT_LT((c.row(3).transpose() - c3).norm(), 1e-11 * (1 + c3.norm()));
  }
}

TEST(ArcLength, Identity3IndependentOfTheParameter) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const CurveDerivatives curve = test::randomDerivatives(6, random);
    const CurveDerivatives other = test::reparametrised(curve, test::randomParameter(6, random));
    EXPECT_LT(largestRelativeError(byArcLength(other), byArcLength(curve)), 1e-7) << i;
    CurveDerivatives backwards = curve, wanted = byArcLength(curve);
    for (int k = 1; k <= 6; k += 2) {
      backwards.row(k) *= -1;
      wanted.row(k) *= -1;
    }
    EXPECT_LT(largestRelativeError(byArcLength(backwards), wanted), 1e-14) << i;
  }
}

TEST(ArcLength, Identity4FollowsMotionAndScale) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const CurveDerivatives curve = test::randomDerivatives(6, random);
    const CurveDerivatives plain = byArcLength(curve);
    const Eigen::Matrix3d R = test::randomRotation(random);
    EXPECT_LT(largestRelativeError(byArcLength(curve * R.transpose()), plain * R.transpose()),
              1e-11)
        << i;
    const double s = test::logUniform(random, -4, 4);
    CurveDerivatives scaled = byArcLength(s * curve);
    for (int k = 0; k <= 6; ++k) scaled.row(k) *= std::pow(s, k - 1);
    EXPECT_LT(largestRelativeError(scaled, plain), 1e-11) << i;
  }
}

TEST(ArcLength, Identity5ItsOwnFixedPoint) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const CurveDerivatives once = byArcLength(test::randomDerivatives(6, random));
    EXPECT_LT(largestRelativeError(byArcLength(once), once), 1e-9) << i;
  }
}

TEST(ArcLength, ClothoidIsTakenAsItIs) {
  for (const double rate : {0.0, 0.02, -3.0}) {
    const CurveDerivatives clothoid = test::clothoid(0.4, rate, 8);
    EXPECT_LT(largestRelativeError(byArcLength(clothoid), clothoid), 1e-13);
    EXPECT_NEAR(clothoid.row(3).dot(Eigen::RowVector3d(0, 1, 0)), rate, 1e-15);
  }
}

TEST(ArcLength, SurvivesExtremeSpeeds) {
  const CurveDerivatives plain = test::circle(2, 0.3, 3);
  for (const double speed : {1e-100, 1e-30, 1e30, 1e100}) {
    CurveDerivatives fast = plain;
    for (int k = 1; k <= 3; ++k) fast.row(k) *= std::pow(speed, k);
    if (!fast.allFinite()) continue;
    EXPECT_LT(largestRelativeError(byArcLength(fast), byArcLength(plain)), 1e-13) << speed;
  }
}

TEST(ArcLength, DegenerateInputGivesNothing) {
  CurveDerivatives still = test::circle(2, 0.3, 4);
  still.row(1).setZero();
  EXPECT_FALSE(arcLengthDerivatives(still).has_value());
  still.row(1) << 1e-12, 0, 0;
  EXPECT_TRUE(arcLengthDerivatives(still).has_value());
  EXPECT_FALSE(arcLengthDerivatives(still, 1e-11).has_value());
  still.row(4) << 0, std::nan(""), 0;
  EXPECT_FALSE(arcLengthDerivatives(still).has_value());
  EXPECT_EQ(byArcLength(still.topRows(1)), still.topRows(1));
  EXPECT_THROW(arcLengthDerivatives(CurveDerivatives(0, 3)), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
