// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>

#include <seamwright/core/spline/band_factor.hpp>

#include "support/random.hpp"
#include "surfaces.hpp"

namespace seamwright {
namespace {

using Eigen::Index;
using Real = long double;
using Dense = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

Dense dense(const BandMatrix& m) {
  const Index n = m.diagonal.size();
  Dense a = Dense::Zero(n, n);
  for (Index i = 0; i < n; ++i) {
    a(i, i) += m.diagonal(i);
    if (m.closed || i > 0) a(i, (i + n - 1) % n) += m.lower(i);
    if (m.closed || i + 1 < n) a(i, (i + 1) % n) += m.upper(i);
  }
  return a;
}

BandMatrix randomBand(Index n, bool closed, double diagonal, std::mt19937_64& random) {
  std::uniform_real_distribution<double> entry(-1, 1);
  BandMatrix m{Eigen::VectorXd::NullaryExpr(n, [&] { return entry(random); }),
               Eigen::VectorXd::NullaryExpr(n, [&] { return diagonal + 0.2 * entry(random); }),
               Eigen::VectorXd::NullaryExpr(n, [&] { return entry(random); }),
               Eigen::VectorXd::Ones(n), closed};
  if (!closed) m.lower(0) = m.upper(n - 1) = 0;
  return m;
}

double rowNorm(const Dense& a) {
  return static_cast<double>(a.cwiseAbs().rowwise().sum().maxCoeff());
}

TEST(BandFactor, SolvesAsADenseEliminationDoes) {
  std::mt19937_64 random(testSeed());
  int pivoted = 0;
  for (int i = 0; i < 4000; ++i) {
    const Index n = 1 + i % 23;
    const bool closed = i % 2 == 0;
    const double diagonal =
        std::array<double, 4>{2.3, -2.3, 0.7, 0}[static_cast<std::size_t>(i / 2) % 4];
    const BandMatrix m = randomBand(n, closed, diagonal, random);
    const Dense a = dense(m);
    const Poles right = Poles::NullaryExpr(n, 3, [&] { return test::randomVector(random).x(); });
    const Dense inverse = a.fullPivLu().inverse();
    const double inverse_norm = rowNorm(inverse), condition = inverse_norm * rowNorm(a);
    if (condition > 0.1 / kSmallestCondition) continue;
    const BandSolution solution = solveBand(m, right);
    pivoted += solution.pivoted;
    const Dense expected = inverse * right.cast<Real>();
    const double error =
        static_cast<double>((solution.x.cast<Real>() - expected).cwiseAbs().maxCoeff());
    EXPECT_LE(error, 1e-14 * condition * (1 + static_cast<double>(expected.cwiseAbs().maxCoeff())))
        << i;
    if (std::abs(diagonal) > 2.2 && n > 2) {
      EXPECT_FALSE(solution.pivoted) << i;
      EXPECT_GE(solution.inverse_norm, inverse_norm * (1 - 1e-12)) << "a bound, " << i;
    } else if (solution.pivoted) {
      EXPECT_LE(solution.inverse_norm, inverse_norm * 1.001) << "an estimate from below, " << i;
      EXPECT_GE(solution.inverse_norm, 0.1 * inverse_norm) << i;
    }
  }
  EXPECT_GT(pivoted, 1500);
}

TEST(BandFactor, ARingIsSolvedWhereItsOpenPartIsSingular) {
  // Without the last unknown: diagonal 0, neighbours 1, an odd number of rows: singular.
  const Index n = 6;
  BandMatrix m{Eigen::VectorXd::Ones(n), Eigen::VectorXd::Zero(n), Eigen::VectorXd::Ones(n),
               Eigen::VectorXd::Ones(n), true};
  m.upper(n - 1) = 2;
  const Dense a = dense(m);
  EXPECT_LT(std::abs(static_cast<double>(a.topLeftCorner(n - 1, n - 1).determinant())), 1e-15);
  const Poles right = Poles::Random(n, 3);
  const Dense expected = a.fullPivLu().solve(Dense(right.cast<Real>()));
  EXPECT_LT(
      static_cast<double>((solveBand(m, right).x.cast<Real>() - expected).cwiseAbs().maxCoeff()),
      1e-14);
}

TEST(BandFactor, ComponentsOfVeryDifferentSizesKeepTheirDigits) {
  BandMatrix m{Eigen::Vector4d(0, 1e-300, 0.5, 1e-200), Eigen::Vector4d(1, 1, 2, 1),
               Eigen::Vector4d(0.3, 1e-300, 0.5, 0), Eigen::Vector4d::Ones(), false};
  Poles right = Poles::Zero(4, 3);
  right.col(0) << 1, 2e-300, 3, 5e-200;
  const BandSolution solution = solveBand(m, right);
  const Dense expected = dense(m).fullPivLu().solve(Dense(right.cast<Real>()));
  for (Index i = 0; i < 4; ++i)
    EXPECT_NEAR(solution.x(i, 0) / static_cast<double>(expected(i, 0)), 1, 1e-14) << i;
}

TEST(BandFactor, SingularEquationsAreToldWithPivotAndCondition) {
  using ::testing::ContainsRegex;
  const auto complaint = [](const BandMatrix& m) -> std::string {
    try {
      solveBand(m, Poles::Ones(m.diagonal.size(), 3));
    } catch (const std::domain_error& error) {
      return error.what();
    }
    return "accepted";
  };
  for (const Index n : {2, 4, 10, 1000}) {
    BandMatrix ring{Eigen::VectorXd::Constant(n, 0.5), Eigen::VectorXd::Ones(n),
                    Eigen::VectorXd::Constant(n, 0.5), Eigen::VectorXd::Ones(n), true};
    EXPECT_THAT(complaint(ring), ContainsRegex("the " + std::to_string(n) +
                                               " equations are singular: pivot [0-9]+ is "
                                               ".*, reciprocal condition "))
        << n;
    ring.diagonal(n / 2) += 0.1;
    EXPECT_EQ(complaint(ring), "accepted") << n;
    ring.diagonal(n / 2) = 1 + 1e-15;
    EXPECT_THAT(complaint(ring), ContainsRegex("singular")) << n;
  }
  for (const Index n : {3, 5, 999}) {
    const BandMatrix odd{Eigen::VectorXd::Constant(n, 0.5), Eigen::VectorXd::Ones(n),
                         Eigen::VectorXd::Constant(n, 0.5), Eigen::VectorXd::Ones(n), true};
    EXPECT_EQ(complaint(odd), "accepted") << n;
  }
  const BandMatrix zero{Eigen::VectorXd::Zero(1), Eigen::VectorXd::Zero(1),
                        Eigen::VectorXd::Zero(1), Eigen::VectorXd::Ones(1), false};
  EXPECT_THAT(complaint(zero), ContainsRegex("pivot 0 is 0"));
}

/// Rows that need no other order, of which the second of four all but vanishes.
TEST(BandFactor, TheSmallestPivotIsTold) {
  const BandMatrix m{Eigen::Vector4d::Zero(), Eigen::Vector4d(1, 1e-14, 1, 1),
                     Eigen::Vector4d::Zero(), Eigen::Vector4d::Ones(), false};
  try {
    solveBand(m, Poles::Ones(4, 3));
    ADD_FAILURE() << "accepted";
  } catch (const std::domain_error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("pivot 1 is 1e-14, reciprocal condition 1e-14"));
  }
}

}  // namespace
}  // namespace seamwright
