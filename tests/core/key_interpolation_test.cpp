// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <limits>
#include <seamwright/core/blend/key_interpolation.hpp>

#include "splines.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using Continuity = KeyInterpolation::Continuity;
constexpr std::array continuities = {Continuity::C0, Continuity::C1, Continuity::C2};

Eigen::VectorXd asVector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

TEST(KeyInterpolation, Identities1And2WeightsReproduceLines) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const std::vector<double> omegas = test::randomBreaks(1 + i % 6, 0.7, random);
    const KeyInterpolation in_omega(omegas, continuities[i % 3]);
    for (int k = 0; k < in_omega.keys(); ++k)
      EXPECT_EQ(in_omega.weights(omegas[k]), Eigen::VectorXd::Unit(in_omega.keys(), k));
    const double omega =
        std::uniform_real_distribution<double>(omegas.front(), omegas.back())(random);
    const Eigen::VectorXd weights = in_omega.weights(omega), at = asVector(omegas);
    EXPECT_NEAR(weights.sum(), 1, 1e-13);
    const double size = at.cwiseAbs().maxCoeff();
    EXPECT_NEAR(weights.dot(at), omega, 1e-13 * size);
    if (continuities[i % 3] == Continuity::C1 && in_omega.keys() > 2) {
      EXPECT_NEAR(weights.dot(at.cwiseAbs2()), omega * omega, 1e-12 * size * size);
    }
    if (continuities[i % 3] == Continuity::C0) {
      EXPECT_GE(weights.minCoeff(), 0);
    }
  }
}

TEST(KeyInterpolation, Identity3ReversalReversesTheWeights) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const std::vector<double> omegas = test::randomBreaks(1 + i % 5, 0.5, random);
    std::vector<double> back;
    for (auto at = omegas.rbegin(); at != omegas.rend(); ++at) back.push_back(-*at);
    const double omega =
        std::uniform_real_distribution<double>(omegas.front(), omegas.back())(random);
    const Eigen::VectorXd forth = KeyInterpolation(omegas, continuities[i % 3]).weights(omega),
                          reversed = KeyInterpolation(back, continuities[i % 3]).weights(-omega);
    EXPECT_LT((forth.reverse() - reversed).cwiseAbs().maxCoeff(), 1e-13);
  }
}

/// One-sided differences of the weights on both sides of the inner keys.
TEST(KeyInterpolation, DerivativesAreContinuous) {
  const std::vector<double> omegas = {0, 1, 1.5, 3, 3.8};
  constexpr double h = 1e-4;
  for (const Continuity continuity : {Continuity::C1, Continuity::C2}) {
    const KeyInterpolation in_omega(omegas, continuity);
    for (std::size_t i = 1; i + 1 < omegas.size(); ++i) {
      const auto slope = [&](double side) -> Eigen::VectorXd {
        return (-3 * in_omega.weights(omegas[i]) + 4 * in_omega.weights(omegas[i] + side * h) -
                in_omega.weights(omegas[i] + 2 * side * h)) /
               (2 * side * h);
      };
      const auto bend = [&](double side) -> Eigen::VectorXd {
        return (2 * in_omega.weights(omegas[i]) - 5 * in_omega.weights(omegas[i] + side * h) +
                4 * in_omega.weights(omegas[i] + 2 * side * h) -
                in_omega.weights(omegas[i] + 3 * side * h)) /
               (h * h);
      };
      EXPECT_LT((slope(1) - slope(-1)).cwiseAbs().maxCoeff(), 1e-5);
      const double jump = (bend(1) - bend(-1)).cwiseAbs().maxCoeff();
      EXPECT_EQ(jump < 1e-2, continuity == Continuity::C2) << jump;
    }
  }
}

TEST(KeyInterpolation, BadOmegasAreRefused) {
  const auto make = [](std::vector<double> omegas) {
    return KeyInterpolation(std::move(omegas), Continuity::C0);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  test::expectRefused([&] { make({0}); }, "omegas 1");
  test::expectRefused([&] { make({0, nan}); }, "omega 1 is nan");
  test::expectRefused([&] { make({0, 1, 1}); }, "omega 2 is 1");
  test::expectRefused([&] { make({0, 1}).weights(1.5); }, "omega is 1.5");
  test::expectRefused([&] { make({0, 1}).weights(nan); }, "omega is nan");
}

}  // namespace
}  // namespace seamwright
