// SPDX-License-Identifier: LGPL-2.1-or-later
// Betas against matrices known to 60 digits, closed forms and each other.
#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <limits>
#include <seamwright/core/join/curve/beta.hpp>

#include "curve_joins.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr double eps = std::numeric_limits<double>::epsilon();

Eigen::VectorXd numbersOf(const json& values) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(values.size()));
  for (Eigen::Index i = 0; i < result.size(); ++i) result(i) = test::number(values[i]);
  return result;
}

/// Largest difference, relative to the largest entry of the row.
double difference(const Eigen::MatrixXd& x, const Eigen::MatrixXd& y) {
  const Eigen::ArrayXd size = x.cwiseAbs().rowwise().maxCoeff().array().max(1e-300);
  return ((x - y).cwiseAbs().rowwise().maxCoeff().array() / size).maxCoeff();
}

/// How much the product of two matrices may cancel: the condition of its rows.
double condition(const Eigen::MatrixXd& x, const Eigen::MatrixXd& y) {
  const Eigen::ArrayXd terms = (x.cwiseAbs() * y.cwiseAbs()).rowwise().maxCoeff();
  return (terms / (x * y).cwiseAbs().rowwise().maxCoeff().array()).maxCoeff();
}

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Beta, MatricesOfSixtyDigits) {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/beta_matrices.json");
  const json data = json::parse(file);
  ASSERT_EQ(data["cases"].size(), 8u);
  for (const json& entry : data["cases"]) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const Eigen::VectorXd beta = numbersOf(entry["in"]["beta"]),
                          inverse = numbersOf(entry["out"]["beta_inv"]);
    const auto matrixOf = [&](const char* name) {
      Eigen::MatrixXd result(beta.size() + 1, beta.size() + 1);
      for (Eigen::Index k = 0; k <= beta.size(); ++k)
        result.row(k) = numbersOf(entry["out"][name][k]).transpose();
      return result;
    };
    EXPECT_LE(difference(matrixOf("B"), betaMatrix(beta)), 1e-14);
    const double loss = condition(matrixOf("Binv"), matrixOf("B"));
    EXPECT_LE(difference(inverse, inverseBeta(beta)), 4 * eps * loss);
    EXPECT_LE(difference(matrixOf("Binv"), betaMatrix(inverseBeta(beta))), 1e-12 + 16 * eps * loss);
  }
}

/// The rows that C2.1 of docs/theory/curves.md writes out.
TEST(Beta, FirstRowsWrittenOut) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 100; ++run) {
    const Eigen::VectorXd b = test::randomBeta(4, random);
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(5, 5);
    B(0, 0) = 1;
    B.row(1).segment(1, 1) << b(0);
    B.row(2).segment(1, 2) << b(1), b(0) * b(0);
    B.row(3).segment(1, 3) << b(2), 3 * b(0) * b(1), b(0) * b(0) * b(0);
    B.row(4).segment(1, 4) << b(3), 4 * b(0) * b(2) + 3 * b(1) * b(1), 6 * b(0) * b(0) * b(1),
        std::pow(b(0), 4);
    EXPECT_LE(difference(B, betaMatrix(b)), 8 * eps);
  }
}

TEST(Beta, Identity1ComposedIsTheProduct) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 2000; ++run) {
    const int order = run % 9;
    const Eigen::VectorXd b = test::randomBeta(order, random), c = test::randomBeta(order, random);
    const Eigen::MatrixXd product = betaMatrix(b) * betaMatrix(c);
    EXPECT_LE(difference(product, betaMatrix(composedBeta(b, c))),
              100 * eps * condition(betaMatrix(b), betaMatrix(c)))
        << run;
  }
  const Eigen::VectorXd b = Eigen::Vector2d(2, 3), c = Eigen::Vector2d(5, 7);
  EXPECT_EQ(composedBeta(b, c), Eigen::Vector2d(10, 3 * 5 + 4 * 7)) << "c is applied first";
}

TEST(Beta, Identity2InverseIsTheInverseMatrix) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 2000; ++run) {
    const int order = run % 9;
    const Eigen::VectorXd b = test::randomBeta(order, random), inverse = inverseBeta(b);
    const Eigen::MatrixXd B = betaMatrix(b), inverse_B = betaMatrix(inverse);
    EXPECT_LE(difference(Eigen::MatrixXd::Identity(order + 1, order + 1), B * inverse_B),
              200 * eps * condition(B, inverse_B))
        << run;
  }
}

/// exp(u) - 1 and ln(1 + t) are inverse to each other; c u / (1 - d u) is a series with known
/// inverse.
TEST(Beta, Identity2InverseInClosedForm) {
  const int order = 12;
  Eigen::VectorXd exponential = Eigen::VectorXd::Ones(order), logarithm(order);
  for (int k = 1; k <= order; ++k) logarithm(k - 1) = (k % 2 == 1 ? 1 : -1) * std::tgamma(k);
  EXPECT_EQ(inverseBeta(exponential), logarithm) << "all numbers are whole";
  EXPECT_EQ(inverseBeta(logarithm), exponential);
  EXPECT_EQ(betaMatrix(exponential)(4, 2), 7) << "Stirling numbers of the second kind";
  EXPECT_EQ(betaMatrix(exponential)(10, 5), 42525);
  const double c = 1.7, d = -0.6;
  Eigen::VectorXd mobius(order), back(order);
  for (int k = 1; k <= order; ++k) {
    mobius(k - 1) = std::tgamma(k + 1) * c * std::pow(d, k - 1);
    back(k - 1) = std::tgamma(k + 1) * std::pow(-d, k - 1) / std::pow(c, k);
  }
  EXPECT_LE(difference(back, inverseBeta(mobius)),
            4 * eps * condition(betaMatrix(back), betaMatrix(mobius)));
}

/// The derivatives of a curve and of a reparametrisation of it, both run backwards and exchanged.
TEST(Beta, Identity3BackwardsAndExchanged) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 1000; ++run) {
    const int order = 1 + run % 7;
    const Eigen::VectorXd beta = test::randomBeta(order, random);
    const CurveDerivatives a = test::randomDerivatives(order, random);
    CurveDerivatives b = betaMatrix(beta) * a, backwards_a = a;
    const Eigen::VectorXd reversed = reversedBeta(beta), inverse = inverseBeta(beta);
    for (Eigen::Index k = 0; k < order; ++k)
      EXPECT_EQ(reversed(k), (k % 2 == 0 ? 1 : -1) * inverse(k));
    for (Eigen::Index k = 1; k <= order; k += 2) {
      b.row(k) *= -1;
      backwards_a.row(k) *= -1;
    }
    const Eigen::MatrixXd R = betaMatrix(reversed).cwiseAbs(), B = betaMatrix(beta).cwiseAbs();
    const Eigen::VectorXd terms = R * (B * (R * (B * a.rowwise().norm())));
    const CurveDerivatives found = betaMatrix(reversed) * b;
    for (int k = 0; k <= order; ++k)
      EXPECT_LE((found.row(k) - backwards_a.row(k)).norm(), 4 * eps * terms(k))
          << run << " order " << k;
  }
}

TEST(Beta, Identity4UnitMatrix) {
  for (int order = 0; order <= 30; ++order) {
    Eigen::VectorXd beta = Eigen::VectorXd::Zero(order);
    if (order > 0) beta(0) = 1;
    EXPECT_EQ(betaMatrix(beta), Eigen::MatrixXd::Identity(order + 1, order + 1));
    EXPECT_EQ(inverseBeta(beta), beta);
  }
}

/// The other convention: left_1 = p right_1, left_2 = p^2 right_2 + q right_1 is beta_1 = 1 / p,
/// beta_2 = -q / p^3 (C2.2 of docs/theory/curves.md). One cannot stand for the other.
TEST(Beta, TheTextsOtherConventionIsTheInverse) {
  const double p = 1.6, q = -0.7;
  const Eigen::VectorXd other = Eigen::Vector2d(p, q), beta = inverseBeta(other);
  EXPECT_NEAR(beta(0), 1 / p, 4 * eps);
  EXPECT_NEAR(beta(1), -q / (p * p * p), 4 * eps);
  EXPECT_GT((beta - other).norm(), 0.5);
}

TEST(Beta, RefusesWhatIsNoBeta) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  using Eigen::Vector3d;
  EXPECT_THAT(refusal([&] { betaMatrix(Vector3d(1, nan, 0)); }), HasSubstr("beta_2 is nan"));
  EXPECT_THAT(refusal([&] { betaMatrix(Vector3d(1, 0, -infinity)); }), HasSubstr("beta_3 is -inf"));
  EXPECT_THAT(refusal([&] { inverseBeta(Vector3d(0, 1, 1)); }),
              HasSubstr("beta_1 is 0: it must be positive"));
  EXPECT_THAT(refusal([&] { reversedBeta(Vector3d(-0.5, 1, 1)); }), HasSubstr("beta_1 is -0.5"));
  EXPECT_THAT(refusal([&] { composedBeta(Vector3d(1, 1, 1), Vector3d(-2, 1, 1)); }),
              HasSubstr("beta_1 is -2"));
  EXPECT_THAT(refusal([&] { composedBeta(Vector3d(1, 1, 1), Eigen::Vector2d(1, 1)); }),
              HasSubstr("betas 3 and 2"));
  EXPECT_THAT(refusal([&] { betaMatrix(Eigen::VectorXd::Ones(31)); }),
              HasSubstr("31 betas: at most 30"));
  EXPECT_NO_THROW(betaMatrix(Eigen::VectorXd::Ones(30)));
  EXPECT_THAT(refusal([&] { betaMatrix(Vector3d(1e200, 1e200, 1)); }),
              HasSubstr("entry (2, 2) is inf"));
}

}  // namespace
}  // namespace seamwright
