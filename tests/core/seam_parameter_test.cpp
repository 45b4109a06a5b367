// SPDX-License-Identifier: LGPL-2.1-or-later
// The halves of a patch, one of them with another parameter along the seam: by weights, and by
// interpolation.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/join/condition/condition.hpp>
#include <seamwright/core/linear/dense.hpp>

#include "joins.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using test::beginningAtU0;
using test::endingAtU1;
using test::gentlePatch;
using test::uniform;

struct Halves {
  BezierPatch low, high;
};

Halves halvesOf(const BezierPatch& patch) {
  const auto [low, high] = patch.splitU(0.5);
  return {low, high};
}

/// The patch with c t / (1 - t + c t) in place of v: its weights change.
BezierPatch withWeights(const BezierPatch& patch, double c) {
  Eigen::VectorXd weights = patch.homogeneousPoles().col(3);
  for (Eigen::Index k = 0; k < weights.size(); ++k)
    weights(k) *= std::pow(c, k % (patch.degreeV() + 1));
  return {patch.degreeU(), patch.degreeV(), patch.poles(), weights};
}

/// The polynomial patch with tau(t), of that degree, in place of v: rows of poles by interpolation.
BezierPatch withPolynomial(const BezierPatch& patch, int degree,
                           const std::function<double(double)>& tau) {
  const int m = patch.degreeU(), n = patch.degreeV() * degree;
  const auto basis = [](int of, int i, double t) {
    return bernstein::binomials(of)(i) * std::pow(t, i) * std::pow(1 - t, of - i);
  };
  Eigen::MatrixXd matrix(n + 1, n + 1);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) matrix(i, j) = basis(n, j, (1 - std::cos(M_PI * i / n)) / 2);
  Poles poles((m + 1) * (n + 1), 3);
  for (int row = 0; row <= m; ++row) {
    Eigen::MatrixXd points = Eigen::MatrixXd::Zero(n + 1, 3);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= patch.degreeV(); ++j)
        points.row(i) += basis(patch.degreeV(), j, tau((1 - std::cos(M_PI * i / n)) / 2)) *
                         patch.poles().row(row * (patch.degreeV() + 1) + j);
    poles.middleRows(row * (n + 1), n + 1) = linear::PivotedQr(matrix).solve(points);
  }
  return {m, n, poles, Eigen::VectorXd::Ones(poles.rows())};
}

TEST(SeamParameter, LinearRationalMapsOfOneSideAreRecognised) {
  std::mt19937_64 random(testSeed());
  for (int k = 0; k < 60; ++k) {
    const bool rational = k % 2 == 1;
    const Halves halves = halvesOf(gentlePatch(3, 2 + k % 3, rational, random));
    const double c = std::exp(uniform(-1.2, 1.2, random));
    const Ribbon a = endingAtU1(halves.low), b = beginningAtU0(withWeights(halves.high, c));
    const JoinCondition join = joinCondition(a, b);
    EXPECT_EQ(join.verdict, JoinVerdict::G1) << k << " " << name(join.verdict);
    EXPECT_TRUE(join.g2()) << k;
    EXPECT_EQ(join.parametric_order, -1);
    EXPECT_LT(join.gap_bound_mm, 1e-11);
    EXPECT_LT(join.angle_bound_rad, 1e-7);
    ASSERT_TRUE(join.parameter) << k;
    for (const double t : {0.0, 0.2, 0.7, 1.0}) {
      const double there = join.parameter_of_a ? c : 1 / c;
      EXPECT_NEAR(join.parameter->at(t), there * t / (1 - t + there * t), 1e-12);
    }
    const ConnectionFit fit = fitConnection(a, b, {.order = 2});
    EXPECT_TRUE(fit.found) << k << " " << fit.note;
    EXPECT_TRUE(fit.parameter);
  }
}

TEST(SeamParameter, PolynomialsInPlaceOfTheParameterAreRecognised) {
  std::mt19937_64 random(testSeed());
  for (int k = 0; k < 40; ++k) {
    const int degree = 2 + k % 2;
    const double bend = uniform(-0.6, 0.6, random);
    const auto tau = [&](double t) { return t + bend * t * (1 - t) * (degree == 2 ? 1 : 0.4 + t); };
    const Halves halves = halvesOf(gentlePatch(3, 2 + k % 2, false, random));
    const BezierPatch other = withPolynomial(halves.high, degree, tau);
    const JoinCondition join = joinCondition(endingAtU1(halves.low), beginningAtU0(other));
    EXPECT_EQ(join.verdict, JoinVerdict::G1) << k << " " << name(join.verdict);
    EXPECT_TRUE(join.g2()) << k;
    ASSERT_TRUE(join.parameter) << k;
    EXPECT_TRUE(join.parameter_of_a);
    for (const double t : {0.0, 0.2, 0.7, 1.0}) EXPECT_NEAR(join.parameter->at(t), tau(t), 1e-11);
    // The other side may be the one with the higher degree.
    const JoinCondition swapped = joinCondition(endingAtU1(withPolynomial(halves.low, degree, tau)),
                                                beginningAtU0(halves.high));
    EXPECT_EQ(swapped.verdict, JoinVerdict::G1) << k;
    ASSERT_TRUE(swapped.parameter) << k;
    EXPECT_FALSE(swapped.parameter_of_a);
  }
}

TEST(SeamParameter, AMovedPoleIsSeenWithAnotherParameterToo) {
  std::mt19937_64 random(testSeed());
  for (int row = 0; row <= 2; ++row) {
    const Halves halves = halvesOf(gentlePatch(3, 3, false, random));
    const BezierPatch same = withWeights(halves.high, 1.7);
    Poles poles = same.poles();
    poles.row(row * 4 + 1) += Eigen::RowVector3d(0, 0, 1e-6);
    const BezierPatch moved(3, 3, poles, same.homogeneousPoles().col(3));
    const JoinCondition join = joinCondition(endingAtU1(halves.low), beginningAtU0(moved));
    EXPECT_EQ(join.verdict == JoinVerdict::G1, row == 2) << row;
    EXPECT_FALSE(join.g2()) << row;
  }
}

TEST(SeamParameter, TheSameParameterAndMapsOfAThirdSideHaveNone) {
  std::mt19937_64 random(testSeed());
  const Halves halves = halvesOf(gentlePatch(3, 2, false, random));
  EXPECT_FALSE(joinCondition(endingAtU1(halves.low), beginningAtU0(halves.high)).parameter);
  // Both are quadratic polynomials in place of v; one of the other is no quotient of polynomials.
  const auto bent = [](double bend) { return [bend](double t) { return t + bend * t * (1 - t); }; };
  const JoinCondition join =
      joinCondition(endingAtU1(withPolynomial(halves.low, 2, bent(0.5))),
                    beginningAtU0(withPolynomial(halves.high, 2, bent(-0.5))));
  EXPECT_FALSE(join.parameter);
  EXPECT_EQ(join.verdict, JoinVerdict::NotG1);
}

TEST(SeamParameter, Identity1PointsAndDerivativesAcrossAreThoseOfTheRibbon) {
  std::mt19937_64 random(testSeed());
  const Ribbon ribbon = beginningAtU0(gentlePatch(3, 3, true, random));
  const SeamParameter map{Eigen::Vector3d(0, 0.3, 1.4), Eigen::Vector3d(1, 0.8, 1.4)};
  const Ribbon changed = reparametrised(ribbon, map);
  EXPECT_EQ(changed.degree(), 6);
  const auto value = [](const HomogeneousPoles& part, double t) -> Eigen::RowVector4d {
    return bernstein::casteljau(part, bernstein::Step::at(t)).first.bottomRows<1>();
  };
  for (const double t : {0.0, 0.1, 0.5, 0.8, 1.0})
    for (std::size_t k = 0; k < 4; ++k) {
      const Eigen::RowVector4d old = value(*ribbon.parts()[k], map.at(t)),
                               now = value(*changed.parts()[k], t);
      const double scale = value(changed.position, t)[3] / value(ribbon.position, map.at(t))[3];
      EXPECT_LT((now - scale * old).norm(), 1e-11 * (1 + old.norm())) << t << " " << k;
    }
}

}  // namespace
}  // namespace seamwright
