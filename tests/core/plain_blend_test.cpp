// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <limits>
#include <seamwright/core/blend/plain_blend.hpp>

#include "blends.hpp"
#include "splines.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using test::CurveKind;
using test::Vec;
using Case = PlainBlendCase;

/// The curve with its last legs along a direction: the lengths of the last one and of the one
/// before it.
BezierCurve endingAlong(const BezierCurve& curve, const Vec& along, double last, double before) {
  Poles poles = curve.poles();
  const Eigen::Index m = poles.rows() - 1;
  poles.row(m - 1) = poles.row(m) - last * along.transpose();
  if (before > 0) poles.row(m - 2) = poles.row(m - 1) - before * along.transpose();
  return BezierCurve(poles);
}

struct Pair {
  JointFrame first, second;
};

/// Two frames for which linear blending keeps the order for this reason.
Pair pairFor(Case kind, int order, std::mt19937_64& random) {
  const int m = 3 + test::wholeNumber(0, 2, random), mb = 3 + test::wholeNumber(0, 2, random);
  const Vec along = test::randomVector(random).normalized();
  const auto curve = [&] {
    const BezierCurve a = test::randomCurve(m, CurveKind::Space, true, 1, random);
    if (kind == Case::EqualBetas || kind == Case::None) return a;
    return endingAlong(a, along, test::logUniform(random, -0.5, 0.5),
                       kind == Case::Straight ? test::logUniform(random, -0.5, 0.5) : 0);
  };
  Eigen::VectorXd one = test::randomBeta(order, random), two = test::randomBeta(order, random);
  if (kind == Case::EqualBetas) two = one;
  if (kind == Case::EqualBeta1) two(0) = one(0);
  const BezierCurve a = curve(), b = curve();
  return {test::frameFrom(a, one, mb, CurveKind::Space, random),
          test::frameFrom(b, two, mb, CurveKind::Space, random)};
}

double defectAt(const Pair& pair, int order, double omega) {
  return test::largestOf(fitBeta(test::blended(pair.first.a, pair.second.a, omega),
                                 test::blended(pair.first.b, pair.second.b, omega), order)
                             .defects);
}

constexpr std::array kinds_of_g1 = {Case::EqualBetas, Case::ParallelTangents};
constexpr std::array kinds_of_g2 = {Case::EqualBetas, Case::EqualBeta1, Case::Straight};

TEST(PlainBlend, Identity1ZeroVectorsAreAlwaysFound) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 5000; ++i) {
    const Vec u = test::logUniform(random, -8, 8) * test::randomVector(random);
    const double factor = i % 10 == 0 ? 0 : test::logUniform(random, -4, 4);
    const Vec v = -factor * u;
    const ShortestBlend found = shortestBlend(u, v);
    EXPECT_TRUE(found.vanishes()) << i << ' ' << found.length_mm << ' ' << found.rounding_mm;
    EXPECT_NEAR(found.omega, 1 / (1 + factor), 1e-12);
    const Vec other = v + 1e-9 * std::max(u.norm(), v.norm()) * u.unitOrthogonal();
    if (factor > 1e-3) {
      EXPECT_FALSE(shortestBlend(u, other).vanishes()) << i;
    }
    EXPECT_FALSE(shortestBlend(u, (factor + 1e-3) * u).vanishes());
  }
}

/// Against the smallest of many omegas.
TEST(PlainBlend, TheShortestBlendIsShortest) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const Vec u = test::randomVector(random), v = test::randomVector(random);
    const ShortestBlend found = shortestBlend(u, v);
    EXPECT_NEAR(((1 - found.omega) * u + found.omega * v).norm(), found.length_mm, 1e-14);
    for (int k = 0; k <= 100; ++k)
      EXPECT_GE(((1 - k / 100.0) * u + k / 100.0 * v).norm(), found.length_mm - 1e-14);
  }
}

TEST(PlainBlend, Identity2ConditionsKeepTheOrder) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 600; ++i) {
    const int order = 1 + i % 2;
    const Case kind = order == 1 ? kinds_of_g1[i / 2 % 2] : kinds_of_g2[i / 2 % 3];
    const Pair pair = pairFor(kind, order, random);
    const PlainBlend found = plainBlend(pair.first, pair.second, order);
    EXPECT_EQ(found.kind, kind) << i << ' ' << found.betas_defect << ' ' << found.beta1_defect
                                << ' ' << found.angle_rad << ' ' << found.bend;
    EXPECT_TRUE(found.keeps());
    for (const double omega : {0.1, 0.5, 0.83}) EXPECT_LT(defectAt(pair, order, omega), 1e-9) << i;
  }
}

TEST(PlainBlend, Identity3OtherwiseTheOrderIsLost) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 400; ++i) {
    const int order = 1 + i % 2;
    const Pair pair = pairFor(Case::None, order, random);
    const PlainBlend found = plainBlend(pair.first, pair.second, order);
    EXPECT_EQ(found.kind, Case::None);
    EXPECT_GT(found.betas_defect, 1e-6);
    EXPECT_GT(found.angle_rad, 1e-6);
    EXPECT_GT(std::max({defectAt(pair, order, 0.2), defectAt(pair, order, 0.5),
                        defectAt(pair, order, 0.7)}),
              1e-7)
        << i;
  }
}

/// Parallel tangents and different beta_1 keep G2 of straight joints only.
TEST(PlainBlend, CurvedJointsWithParallelTangentsKeepG1Only) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const Pair pair = pairFor(Case::ParallelTangents, 2, random);
    EXPECT_EQ(plainBlend(pair.first, pair.second, 2).kind, Case::None);
    EXPECT_EQ(plainBlend(pair.first, pair.second, 1).kind, Case::ParallelTangents);
    EXPECT_GT(defectAt(pair, 2, 0.5), 1e-9);
  }
}

TEST(PlainBlend, Identity4BetasAreBlendedByTheRatio) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const int order = 1 + i % 2;
    const Pair pair =
        pairFor(order == 1 ? Case::ParallelTangents : Case::EqualBeta1, order, random);
    const PlainBlend found = plainBlend(pair.first, pair.second, order);
    const Eigen::VectorXd one = fitBeta(pair.first.a, pair.first.b, order).beta,
                          two = fitBeta(pair.second.a, pair.second.b, order).beta;
    const double omega = 0.3, share = found.ratio * omega / (1 - omega + found.ratio * omega);
    const Eigen::VectorXd beta = found.beta(omega), expected = (1 - share) * one + share * two;
    ASSERT_EQ(beta.size(), order);
    EXPECT_LT((beta - expected).cwiseAbs().maxCoeff(), 1e-10) << i;
  }
}

TEST(PlainBlend, Identity5ExchangedFramesReverseOmega) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const Pair pair = pairFor(kinds_of_g2[i % 3], 2, random);
    const PlainBlend forth = plainBlend(pair.first, pair.second, 2),
                     back = plainBlend(pair.second, pair.first, 2);
    EXPECT_EQ(forth.kind, back.kind);
    EXPECT_NEAR(forth.ratio * back.ratio, 1, 1e-12);
    EXPECT_LT((forth.beta(0.3) - back.beta(0.7)).norm(), 1e-10 * forth.beta(0.3).norm());
    EXPECT_NEAR(forth.tangent_a.length_mm, back.tangent_a.length_mm, 1e-13);
  }
}

/// Equal betas and opposite tangents: the condition holds, but there is a cusp between.
TEST(PlainBlend, VanishingTangentsAreAlwaysFound) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1000; ++i) {
    const int order = 1 + i % 2;
    const double size = test::logUniform(random, -3, 3), ratio = test::logUniform(random, -1, 1);
    const Vec along = test::randomVector(random).normalized();
    const auto curve = [&](double length) {
      const BezierCurve a = test::randomCurve(4, CurveKind::Space, true, 1, random);
      return BezierCurve(
          size * endingAlong(a, (length < 0 ? -1 : 1) * along, std::abs(length), 0).poles());
    };
    Eigen::VectorXd beta = test::randomBeta(order, random);
    const JointFrame first = test::frameFrom(curve(1), beta, 4, CurveKind::Space, random);
    const JointFrame second = test::frameFrom(curve(-ratio), beta, 4, CurveKind::Space, random);
    const PlainBlend found = plainBlend(first, second, order);
    EXPECT_EQ(found.kind, Case::None) << i;
    EXPECT_TRUE(found.tangent_a.vanishes()) << i << ' ' << found.tangent_a.length_mm;
    EXPECT_TRUE(found.tangent_b.vanishes()) << i << ' ' << found.tangent_b.length_mm;
    EXPECT_NEAR(found.tangent_a.omega, 1 / (1 + ratio), 1e-10);
  }
}

TEST(PlainBlend, BadInputIsRefused) {
  std::mt19937_64 random(testSeed());
  const JointFrame good = test::randomFrame(2, 3, 3, random);
  test::expectRefused([&] { plainBlend(good, good, 3); }, "order is 3");
  test::expectRefused([&] { plainBlend(good, good, 1, std::numeric_limits<double>::quiet_NaN()); },
                      "tolerance is nan");
  JointFrame apart = good;
  apart.b = test::withMove(good.b, 0, Vec(0, 0, 1e-3));
  test::expectRefused([&] { plainBlend(good, apart, 1); },
                      "the second frame: the curves are 0.001");
  JointFrame cusp = good;
  cusp.a = test::withMove(good.a, 2, (good.a.poles().row(3) - good.a.poles().row(2)).transpose());
  test::expectRefused([&] { plainBlend(cusp, good, 1); }, "the first frame has no tangent");
  const JointFrame rational = test::randomFrame(2, 3, 3, random, CurveKind::Rational);
  test::expectRefused([&] { plainBlend(good, rational, 1); }, "the second frame");
  test::expectRefused(
      [] { shortestBlend(Vec(std::numeric_limits<double>::infinity(), 0, 0), Vec::UnitX()); },
      "a coordinate is inf");
  test::expectRefused([] { shortestBlend(Vec::UnitY(), Vec::UnitX(), -1); }, "rounding_mm is -1");
}

}  // namespace
}  // namespace seamwright
