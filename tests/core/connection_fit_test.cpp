// SPDX-License-Identifier: LGPL-2.1-or-later
// ConnectionFunctions functions that come back from joins made with them.
#include <gmock/gmock.h>

#include "joins.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::beginningAtU0;
using test::endingAtU1;
using test::gentlePatch;
using test::Join;
using test::mapped;
using test::randomJoin;
using test::value;
using testing::HasSubstr;

/// Largest difference of two functions, of any degrees.
double apart(const Eigen::VectorXd& f, const Eigen::VectorXd& g) {
  double most = 0;
  for (int i = 0; i <= 10; ++i)
    most = std::max(most, std::abs(value(f, i / 10.0) - value(g, i / 10.0)));
  return most;
}

TEST(ConnectionFit, Identity1FunctionsComeBack) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 1500; ++run) {
    const Join join = randomJoin(run, random);
    const ConnectionFit fit = fitConnection(join.a, join.b, {.order = join.order});
    ASSERT_TRUE(fit.found) << run << " order " << join.order << ": " << fit.note << " residual "
                           << fit.residual << " noise " << fit.noise;
    const double allowed = 1e-11 * fit.condition;
    EXPECT_LE(apart(fit.connection.alpha, join.connection.alpha), allowed) << run;
    EXPECT_LE(apart(fit.connection.beta, join.connection.beta), allowed) << run;
    EXPECT_LE(apart(fit.connection.e0, join.connection.e0), allowed) << run;
    EXPECT_LE(apart(fit.connection.e1, join.connection.e1), allowed) << run;
    if (join.order < 2) continue;
    EXPECT_LE(apart(fit.connection.p, join.connection.p), 100 * allowed) << run;
    EXPECT_LE(apart(fit.connection.q, join.connection.q), 100 * allowed) << run;
    EXPECT_LE(apart(fit.connection.e2, join.connection.e2), 100 * allowed) << run;
    if (join.order < 3) continue;
    EXPECT_LE(apart(fit.connection.h, join.connection.h), 1e4 * allowed) << run;
    EXPECT_LE(apart(fit.connection.k, join.connection.k), 1e4 * allowed) << run;
    EXPECT_LE(apart(fit.connection.e3, join.connection.e3), 1e4 * allowed) << run;
  }
}

TEST(ConnectionFit, Identity2RationalAlphaIsSaid) {
  for (const json& entry : test::dataCases("tensor_joins.json", "test")) {
    if (entry["id"] != "g1_rational_alpha") continue;
    const ConnectionFit fit = fitConnection(endingAtU1(test::patch(entry["input"]["P"])),
                                            beginningAtU0(test::patch(entry["input"]["Q"])));
    EXPECT_FALSE(fit.found);
    EXPECT_THAT(fit.note, HasSubstr("the join is G1, but alpha and beta are not polynomials"));
    EXPECT_GT(fit.residual, 1e3 * fit.noise);
    return;
  }
  FAIL() << "the case is missing";
}

TEST(ConnectionFit, Identity3MotionsAndScales) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 200; ++run) {
    const Join join = randomJoin(run, random);
    const Eigen::Matrix3d linear = test::logUniform(random, -3, 3) * test::randomRotation(random);
    const Eigen::RowVector3d translation =
        10 * linear.col(0).norm() * test::randomVector(random).transpose();
    const ConnectionFit fit = fitConnection(join.a, join.b);
    const ConnectionFit moved =
        fitConnection(mapped(join.a, linear, translation), mapped(join.b, linear, translation));
    EXPECT_TRUE(moved.found) << run << moved.note;
    EXPECT_LE(apart(fit.connection.alpha, moved.connection.alpha), 1e-10 * fit.condition) << run;
    EXPECT_LE(apart(fit.connection.beta, moved.connection.beta), 1e-10 * fit.condition) << run;
  }
}

TEST(ConnectionFit, FunctionsThatVanishComeBack) {
  std::mt19937_64 random(testSeed());
  int tried = 0;
  for (int run = 0; run < 400; ++run) {
    const Ribbon a = endingAtU1(
        gentlePatch(test::whole(2, 6, random), test::whole(1, 6, random), run % 4 == 3, random));
    ConnectionFunctions made;
    if (run % 2) made.alpha(0) = test::uniform(0.5, 2, random);
    if (run % 3) made.beta(0) = test::uniform(-0.5, 0.5, random);
    const auto patch = test::built([&] { return continuation(a, made, 2, 3); });
    if (!patch) continue;
    ++tried;
    const ConnectionFit fit = fitConnection(a, beginningAtU0(*patch), {.order = 2});
    ASSERT_TRUE(fit.found) << run << ": " << fit.note << " residual " << fit.residual << " noise "
                           << fit.noise;
    EXPECT_LE(apart(fit.connection.p, made.p), 1e-9) << run;
    EXPECT_LE(apart(fit.connection.q, made.q), 1e-9) << run;
  }
  EXPECT_GT(tried, 200);
}

TEST(ConnectionFit, TheObstacleIsNamed) {
  std::mt19937_64 random(testSeed());
  const Ribbon a = endingAtU1(gentlePatch(3, 3, false, random));
  const Ribbon other = beginningAtU0(gentlePatch(3, 3, false, random));
  Ribbon flat = a;
  flat.first.setZero();
  EXPECT_THAT(fitConnection(a, other).note, HasSubstr("the edges do not coincide"));
  EXPECT_THAT(fitConnection(flat, beginningAtU0(continuation(a, {}, 1, 2))).note,
              HasSubstr("condition"));
  const ConnectionFunctions quadratic = test::randomConnection(2, 3, random);
  const ConnectionFit low = fitConnection(a, beginningAtU0(continuation(a, quadratic, 1, 2)),
                                          {.alpha_degree = 0, .beta_degree = 1});
  EXPECT_FALSE(low.found);
  EXPECT_THAT(low.note, HasSubstr("not polynomials of these degrees"));
  Ribbon back = beginningAtU0(continuation(a, quadratic, 1, 2));
  back.first = -back.first;
  const ConnectionFit fold = fitConnection(a, back);
  EXPECT_FALSE(fold.found);
  EXPECT_THAT(fold.note, HasSubstr("alpha is not positive everywhere: the join is fold"));
  EXPECT_LE(apart(fold.connection.alpha, -quadratic.alpha), 1e-9);
  for (const double tolerance : {-1.0, std::nan("")})
    EXPECT_THROW(fitConnection(a, other, {.tolerance = tolerance}), std::invalid_argument);
  EXPECT_THROW(fitConnection(a, other, {.order = 4}), std::invalid_argument);
  EXPECT_THROW(fitConnection(a, other, {.alpha_degree = -1}), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
