// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <limits>
#include <seamwright/core/blend/balance.hpp>
#include <seamwright/core/join/curve/beta.hpp>

#include "blends.hpp"
#include "splines.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using Kind = BalanceFault::Kind;
using test::expectRefused;

/// Rows -n..n beside a joint, for a case of the data.
Poles middleOf(const json& poles, int degree_a, int order) {
  return test::points(poles).middleRows(degree_a - order, 2 * order + 1);
}

Poles besides(const JointFrame& frame, int order) {
  Poles result(2 * order + 1, 3);
  result << frame.a.poles().bottomRows(order + 1), frame.b.poles().middleRows(1, order);
  return result;
}

Eigen::VectorXd vectorOf(const json& values) {
  const std::vector<double> numbers = test::numbers(values);
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

void expectRatios(const BalanceRatios& ratios, const json& expected) {
  ASSERT_TRUE(ratios.canSolve());
  for (std::size_t k = 0; k < expected.size(); ++k)
    for (std::size_t j = 0; j <= k; ++j) {
      const double delta = test::number(expected[k][j]);
      EXPECT_NEAR(ratios.delta(k, j), delta, 1e-12 * std::max(1.0, std::abs(delta)))
          << k << ' ' << j;
    }
}

TEST(Balance, RatiosAndPointsAreThoseOfTheData) {
  const auto cases = test::splineCases("shape_blends.json");
  ASSERT_EQ(cases.size(), 24u);
  for (const json& entry : cases) {
    const json &in = entry["in"], &out = entry["out"];
    SCOPED_TRACE(entry["name"]);
    const int n = in["n"], m = in["m"], mb = in["mb"];
    const double omega = in["omega"];
    Eigen::MatrixXd blended = Eigen::MatrixXd::Zero(n + 1, 3);
    for (int i = 0; i < 2; ++i) {
      const json& frame = in["frames"][i];
      const BalanceRatios ratios = balanceRatios(vectorOf(frame["alpha"]), m, mb);
      expectRatios(ratios, out["frames"][i]["delta"]);
      const AuxiliaryPoints found = auxiliaryPoints(ratios, middleOf(frame["P"], m, n));
      const Poles points = test::points(out["frames"][i]["T"]);
      const double size = points.cwiseAbs().maxCoeff();
      EXPECT_LT((found.points - points).cwiseAbs().maxCoeff(), 1e-11 * size);
      EXPECT_LT(found.residual, 1e-13 * size);
      blended += (i == 0 ? 1 - omega : omega) * found.points;
    }
    const BalanceRatios ratios = balanceRatios(vectorOf(out["alpha_w"]), m, mb);
    expectRatios(ratios, out["delta_w"]);
    const Poles poles = middleOf(out["P_w"], m, n);
    EXPECT_LT((balancedPoles(ratios, blended) - poles).cwiseAbs().maxCoeff(),
              1e-11 * std::max(1.0, blended.cwiseAbs().maxCoeff()));
  }
}

TEST(Balance, Identities1And2RelationsAddUpToZeroAndHold) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 500; ++i) {
    const int n = 1 + i % 6, m = n + i % 3, mb = n + i / 3 % 3;
    const Eigen::VectorXd beta = test::randomBeta(n, random);
    const Eigen::MatrixXd g = balanceRelations(beta, m, mb);
    const double size = g.cwiseAbs().maxCoeff();
    EXPECT_LT(g.rowwise().sum().cwiseAbs().maxCoeff(), 1e-13 * size);
    const JointFrame frame = test::frameWith(beta, m, mb, test::CurveKind::Space, random);
    const Poles poles = besides(frame, n);
    EXPECT_LT((g * poles).cwiseAbs().maxCoeff(), 1e-13 * size * poles.cwiseAbs().maxCoeff());
  }
}

TEST(Balance, Identities3And4RatiosInClosedForm) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const int m = 2 + i % 5, mb = 2 + i / 5 % 5;
    const Eigen::VectorXd beta = test::randomBeta(2, random);
    const BalanceRatios ratios = balanceRatios(beta, m, mb);
    const double first = mb / (mb + m * beta(0));
    EXPECT_NEAR(ratios.delta(0, 0), first, 1e-14);
    const double M = m * (m - 1) * beta(0) * beta(0), N = mb * (mb - 1), q = m * beta(1);
    const double E = N - M - q;
    const double rest = M + q + E * (1 - first);
    if (!ratios.canCut()) continue;
    const double second = rest / (M + rest), third = N / (2 * N - E * first);
    EXPECT_NEAR(ratios.delta(1, 0), second, 1e-9 * std::max(1.0, second * second));
    EXPECT_NEAR(ratios.delta(1, 1), third, 1e-9 * std::max(1.0, third * third));
  }
}

TEST(Balance, Identity5ReversalMirrorsTheRatios) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const int n = 1 + i % 5, m = n + i % 3, mb = n + i / 3 % 4;
    const Eigen::VectorXd beta = test::randomBeta(n, random);
    const BalanceRatios ratios = balanceRatios(beta, m, mb);
    const BalanceRatios mirrored = balanceRatios(reversedBeta(beta), mb, m);
    if (ratios.least_pivot < 1e-3 || mirrored.least_pivot < 1e-3) continue;
    for (int k = 0; k < n; ++k)
      for (int j = 0; j <= k; ++j)
        EXPECT_NEAR(mirrored.delta(k, j), 1 - ratios.delta(k, k - j),
                    1e-8 * std::max(1.0, ratios.delta.cwiseAbs().maxCoeff()))
            << i << ' ' << k << ' ' << j;
  }
}

TEST(Balance, Identity6HighDegreesMakeConvexRatios) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const int n = 2 + i % 3;
    const BalanceRatios ratios = balanceRatios(test::randomBeta(n, random), 100, 100);
    ASSERT_TRUE(ratios.canSolve());
    for (int k = 0; k < n; ++k) {
      EXPECT_GT(ratios.delta.row(k).head(k + 1).minCoeff(), 0) << i;
      EXPECT_LT(ratios.delta.row(k).head(k + 1).maxCoeff(), 1) << i;
    }
  }
}

TEST(Balance, Identities7And8PointsAndPolesAreInverse) {
  std::mt19937_64 random(testSeed());
  int solved = 0;
  for (int i = 0; i < 600; ++i) {
    const int n = 1 + i % 6, m = n + i % 4, mb = n + i / 4 % 4;
    const Eigen::VectorXd beta = test::randomBeta(n, random);
    const BalanceRatios ratios = balanceRatios(beta, m, mb);
    if (!ratios.canSolve()) continue;
    const JointFrame frame = test::frameWith(beta, m, mb, test::CurveKind::Space, random);
    const Poles poles = besides(frame, n);
    const AuxiliaryPoints found = auxiliaryPoints(ratios, poles);
    const double size = found.points.cwiseAbs().maxCoeff() + poles.cwiseAbs().maxCoeff();
    // Ratios near 0 and 1 multiply the rounding of each level.
    const double condition = std::pow(1 / ratios.least_pivot, n > 1 ? 1 : 0);
    if (condition > 1e4) continue;
    ++solved;
    const Eigen::MatrixXd back = balancedPoles(ratios, found.points);
    EXPECT_LT((back - poles).cwiseAbs().maxCoeff(), 1e-10 * size * condition) << i;
    // Any points result in a joint.
    Poles points(n + 1, 3);
    for (int j = 0; j <= n; ++j) points.row(j) = test::randomVector(random).transpose();
    const Eigen::MatrixXd made = balancedPoles(ratios, points);
    const Eigen::MatrixXd g = balanceRelations(beta, m, mb);
    EXPECT_LT((g * made).cwiseAbs().maxCoeff(),
              1e-12 * condition * g.cwiseAbs().maxCoeff() * made.cwiseAbs().maxCoeff())
        << i;
  }
  EXPECT_GT(solved, 400);
}

TEST(Balance, DefectsOfTheJointRemainInTheResidual) {
  std::mt19937_64 random(testSeed());
  const Eigen::VectorXd beta = Eigen::Vector3d(1.2, 0.1, 0.2);
  const BalanceRatios ratios = balanceRatios(beta, 4, 4);
  Poles poles = besides(test::frameWith(beta, 4, 4, test::CurveKind::Space, random), 3);
  EXPECT_LT(auxiliaryPoints(ratios, poles).residual, 1e-13);
  poles.row(0) += Eigen::RowVector3d(0, 0, 1e-3);
  const double residual = auxiliaryPoints(ratios, poles).residual;
  EXPECT_GT(residual, 1e-6);
  EXPECT_LT(residual, 1e-3);
}

/// For n = 2 the lines P_-2 P_-1 and P_1 P_2 are parallel if M + q + E (1 - delta_00) = 0: then
/// delta_10 = 0.
TEST(Balance, FaultsCarryLevelIndexAndValue) {
  const double q = -2.0 - 2.0;  // m = m' = 2, beta_1 = 1: M = N = 2, E = -q, M + q - q / 2 = 0
  const BalanceRatios far = balanceRatios(Eigen::Vector2d(1, q / 2), 2, 2);
  ASSERT_FALSE(far.faults.empty());
  EXPECT_TRUE(far.canCut());
  EXPECT_FALSE(far.canSolve());
  EXPECT_EQ(far.faults[0].kind, Kind::FarPoint);
  EXPECT_EQ(far.faults[0].level, 1);
  EXPECT_EQ(far.faults[0].index, 0);
  EXPECT_NEAR(far.faults[0].value, 0, 1e-15);
  expectRefused([&] { auxiliaryPoints(far, Poles::Zero(5, 3)); }, "ratio (1, 0)");

  // 2 M + q + E (1 - delta_00) = 4 + q / 2 = 0: the denominator of delta_10 vanishes.
  const BalanceRatios none = balanceRatios(Eigen::Vector2d(1, -4), 2, 2);
  ASSERT_FALSE(none.faults.empty());
  EXPECT_FALSE(none.canCut());
  EXPECT_EQ(none.faults[0], (BalanceFault{Kind::NoRatio, 1, 0, none.faults[0].value}));
  EXPECT_LT(none.faults[0].value, 1e-9);
  expectRefused([&] { balancedPoles(none, Poles::Zero(3, 3)); }, "ratio (1, 0) is missing");

  const BalanceRatios back = balanceRatios(Eigen::Vector2d(-0.5, 0), 2, 2);
  ASSERT_EQ(back.faults.size(), 1u);
  EXPECT_EQ(back.faults[0], (BalanceFault{Kind::NegativeBeta, 0, 0, -0.5}));
}

TEST(Balance, BadNumbersAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expectRefused([&] { balanceRatios(Eigen::Vector2d(1, nan), 2, 2); }, "beta_2 is nan");
  expectRefused([&] { balanceRatios(Eigen::VectorXd(), 2, 2); }, "0 betas");
  expectRefused([&] { balanceRatios(Eigen::Vector2d(1, 0), 1, 2); }, "degree 1");
  expectRefused([&] { balanceRatios(Eigen::Vector2d(1, 0), 2, 101); }, "degree 101");
  expectRefused([&] { balanceRelations(Eigen::Vector2d(-1, 0), 2, 2); }, "beta_1 is -1");
  const BalanceRatios ratios = balanceRatios(Eigen::Vector2d(1, 0), 2, 2);
  Poles poles = Poles::Zero(5, 3);
  poles(3, 1) = nan;
  expectRefused([&] { auxiliaryPoints(ratios, poles); }, "pole 3 is not finite");
  expectRefused([&] { auxiliaryPoints(ratios, Poles::Zero(4, 3)); }, "poles 4: 5 are needed");
  expectRefused([&] { balancedPoles(ratios, Poles::Zero(2, 3)); }, "points 2: 3 are needed");
  for (const BalanceGuards& guards :
       {BalanceGuards{.least_pivot = 0}, BalanceGuards{.least_ratio = nan},
        BalanceGuards{.most_ratio = 1}})
    EXPECT_THROW(balanceRatios(Eigen::Vector2d(1, 0), 2, 2, guards), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
