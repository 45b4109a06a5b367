// SPDX-License-Identifier: LGPL-2.1-or-later
// Nearest joins of curves at the limits: far apart, backwards, straight, of any size; and what is
// refused.
#include <gmock/gmock.h>

#include <seamwright/core/join/curve/beta.hpp>
#include <seamwright/core/join/curve/nearest_curve.hpp>

#include "nearest_curves.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using namespace test::near_curves;
using test::Vec;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(NearestCurve, FarApartIsHonest) {
  std::mt19937_64 random(testSeed());
  int solved = 0;
  for (int i = 0; i < 1440; ++i) {
    const Pair pair = pairOf(i, 2, random);
    const int n = pair.options.order;
    const Join join = nearestJoin(pair.a, pair.b, pair.options);
    if (join.status == NearestCurveStatus::Infeasible) {
      EXPECT_EQ(join.a, pair.a);
      EXPECT_EQ(join.b, pair.b);
      EXPECT_FALSE(join.reason.empty());
      continue;
    }
    EXPECT_LT(worstDefect(join.a, join.b, n), 1e-5 * bend(join.a, join.b, n)) << i;
    EXPECT_EQ(join.status == NearestCurveStatus::Solved, join.reason.empty()) << join.reason;
    solved += join.status == NearestCurveStatus::Solved;
  }
  EXPECT_GT(solved, 500);
}

TEST(NearestCurve, BackwardsHasNoNearestJoin) {
  const Pair pair = kinked(std::acos(-1));
  const Join join = nearestJoin(pair.a, pair.b, pair.options);
  EXPECT_NE(join.status, NearestCurveStatus::Solved);
  EXPECT_FALSE(join.reason.empty());
}

TEST(NearestCurve, ResidualIsThatOfFitBeta) {
  Poles a(4, 3), b(4, 3);
  b << 0.01, 0, 0, -3, -1.9, 0, -5, -4, 0, -9, -4, 0;
  for (const double gap : {0.0, 1e-14, 1e-10, 1.0}) {
    a << gap, 0, 0, 3, -2, 0, 3, 2, 0, 0, 0, 0;
    const Join join = nearestJoin(BezierCurve(a), BezierCurve(b), optionsOf(2));
    const BetaFit before = fitBeta(BezierCurve(a), BezierCurve(b), 2),
                  after = fitBeta(join.a, join.b, 2, before.length_mm);
    EXPECT_NEAR(join.residual, *std::max_element(after.defects.begin(), after.defects.end()),
                1e-9 * (1 + 1 / before.length_mm))
        << gap;
    if (join.status != NearestCurveStatus::Infeasible) continue;
    EXPECT_NEAR(join.residual / worstDefect(BezierCurve(a), BezierCurve(b), 2), 1, 1e-9) << gap;
  }
}

TEST(NearestCurve, ParallelLinesAreJoined) {
  Poles a(3, 3), b(3, 3);
  a << -2, 0, 0, -1, 0, 0, 0, 0, 0;
  b << 0, 0.1, 0, 1, 0.1, 0, 2, 0.1, 0;
  const Join join = nearestJoin(BezierCurve(a), BezierCurve(b), optionsOf(2));
  EXPECT_EQ(join.status, NearestCurveStatus::Solved) << join.reason;
  EXPECT_LT(worstDefect(join.a, join.b, 2), 1e-13);
  EXPECT_LT(join.largest_move_mm, 0.1);
}

TEST(NearestCurve, ResultsScaleWithTheCurves) {
  for (const double scale : {1e-100, 1e-12, 1e12, 1e100}) {
    const Pair pair = kinked(0.4);
    const auto scaled = [&](const BezierCurve& curve) {
      return BezierCurve(scale * curve.poles());
    };
    const Join plain = nearestJoin(pair.a, pair.b, pair.options);
    const Join join = nearestJoin(scaled(pair.a), scaled(pair.b), pair.options);
    EXPECT_EQ(join.status, NearestCurveStatus::Solved) << join.reason;
    EXPECT_NEAR(join.largest_move_mm / scale, plain.largest_move_mm, 1e-14);
    EXPECT_NEAR(join.beta(0), plain.beta(0), 1e-13);
  }
}

TEST(NearestCurve, CostlyPolesHardlyMove) {
  const Pair pair = kinked(0.4);
  NearestCurveJoinOptions options = pair.options;
  options.costs_a = Eigen::Vector4d::Constant(1e12);
  const Join costly = nearestJoin(pair.a, pair.b, options),
             held = nearestJoin(pair.a, pair.b, optionsOf(1, Moves::B));
  EXPECT_EQ(costly.status, NearestCurveStatus::Solved) << costly.reason;
  EXPECT_LT(difference(costly.a, pair.a), 1e-11);
  EXPECT_LT(difference(costly.b, held.b), 1e-11);
  EXPECT_NEAR(costly.cost, held.cost, 1e-11);
}

TEST(NearestCurve, OrdersUpToTenAreSolved) {
  std::mt19937_64 random(testSeed());
  for (int n = 5; n <= 10; ++n) {
    Poles poles(n + 3, 3);
    for (int k = 0; k < poles.rows(); ++k) poles.row(k) << 2 * k, 0.02 * k * k, 1e-3 * k * k * k;
    const auto [left, right] = BezierCurve(poles).split(0.4);
    const BezierCurve a = perturbed(left, 1e-6, random), b = perturbed(right, 1e-6, random);
    const Join join = nearestJoin(a, b, optionsOf(n));
    EXPECT_NE(join.status, NearestCurveStatus::Infeasible) << n << join.reason;
    EXPECT_LT(join.largest_move_mm, 1e-5) << n;
    EXPECT_LT(join.residual, 1e-7 * bend(join.a, join.b, n)) << n;
  }
}

template <typename Change>
std::string refusal(const Change& change) {
  Pair pair = kinked(0.3);
  pair.options.order = 2;
  change(pair);
  try {
    nearestJoin(pair.a, pair.b, pair.options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(NearestCurve, RefusesBadArguments) {
  using testing::HasSubstr;
  EXPECT_EQ(refusal([](Pair&) {}), "");
  for (const int order : {-1, 0, 11})
    EXPECT_THAT(refusal([&](Pair& p) { p.options.order = order; }),
                HasSubstr("order is " + std::to_string(order)));
  EXPECT_THAT(refusal([](Pair& p) { p.options.order = 4; }),
              HasSubstr("degree of a is 3, the order 4"));
  EXPECT_THAT(refusal([](Pair& p) { p.options.costs_a = Eigen::Vector3d::Ones(); }),
              HasSubstr("costs_a 3, poles 4"));
  for (const double cost : {0.0, -1.0, nan, -infinity})
    EXPECT_THAT(refusal([&](Pair& p) { p.options.costs_b = Eigen::Vector4d(1, 1, cost, 1); }),
                HasSubstr("costs_b[2] is "));
  EXPECT_THAT(refusal([](Pair& p) { p.options.beta = Eigen::Vector3d(1, 0, 0); }),
              HasSubstr("betas 3, order 2"));
  for (const double beta1 : {0.0, -1.0, nan, infinity})
    EXPECT_THAT(refusal([&](Pair& p) { p.options.beta = Eigen::Vector2d(beta1, 0); }),
                HasSubstr("beta_1 is "));
  EXPECT_THAT(refusal([](Pair& p) { p.options.beta = Eigen::Vector2d(1, nan); }),
              HasSubstr("beta_2 is nan"));
  for (const double least : {0.0, 1.5, nan})
    EXPECT_THAT(refusal([&](Pair& p) { p.options.least_beta1 = least; }),
                HasSubstr("least_beta1 is "));
  for (const double most : {0.5, nan, infinity})
    EXPECT_THAT(refusal([&](Pair& p) { p.options.most_beta1 = most; }),
                HasSubstr("most_beta1 is "));
  EXPECT_THAT(refusal([](Pair& p) { p.options.max_iterations = -1; }),
              HasSubstr("max_iterations is -1"));
  EXPECT_THAT(refusal([](Pair& p) {
                Poles poles = p.b.poles();
                poles.row(1) = poles.row(0);
                p.b = BezierCurve(poles);
              }),
              HasSubstr("curve b has no tangent at the joint"));
  EXPECT_THAT(refusal([](Pair& p) { p.a = BezierCurve(Poles::Zero(4, 3)); }),
              HasSubstr("curve a has no tangent at the joint"));
}

}  // namespace
}  // namespace seamwright
