// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <seamwright/core/bezier/patch.hpp>

#include "support/random.hpp"
#include "surfaces.hpp"

namespace seamwright {
namespace {

using test::Vec;
using testing::AllOf;
using testing::HasSubstr;

Poles randomPoles(int count, std::mt19937_64& random) {
  Poles poles(count, 3);
  for (int i = 0; i < count; ++i) poles.row(i) = test::randomVector(random).transpose();
  return poles;
}

Eigen::VectorXd randomWeights(int count, std::mt19937_64& random) {
  Eigen::VectorXd weights(count);
  for (int i = 0; i < count; ++i) weights(i) = test::logUniform(random, -0.5, 0.5);
  return weights;
}

/// k-th derivative of the Bernstein polynomial B_i^n at t, from its power form: an oracle without
/// de Casteljau.
long double bernstein(int n, int i, int k, long double t) {
  const auto binomial = [](int a, int b) {
    return std::round(
        std::exp(std::lgamma(a + 1.0L) - std::lgamma(b + 1.0L) - std::lgamma(a - b + 1.0L)));
  };
  long double sum = 0;
  for (int p = i; p <= n; ++p) {
    if (p < k) continue;
    long double factor = binomial(n, p) * binomial(p, i) * ((p - i) % 2 ? -1 : 1);
    for (int d = 0; d < k; ++d) factor *= p - d;
    sum += factor * std::pow(t, static_cast<long double>(p - k));
  }
  return sum;
}

Vec polynomialDerivative(const Poles& poles, int k, double t) {
  Vec sum = Vec::Zero();
  const int n = static_cast<int>(poles.rows()) - 1;
  for (int i = 0; i <= n; ++i)
    sum += static_cast<double>(bernstein(n, i, k, t)) * poles.row(i).transpose();
  return sum;
}

TEST(BezierCurve, HomogeneousPolesAreTakenOverBitByBit) {
  std::mt19937_64 random(testSeed());
  HomogeneousPoles poles(4, 4);
  poles << randomPoles(4, random), randomWeights(4, random);
  EXPECT_EQ(BezierCurve::fromHomogeneous(poles).homogeneousPoles(), poles);
  poles(2, 3) = -0.25;
  EXPECT_THAT([&] { BezierCurve::fromHomogeneous(poles); },
              testing::ThrowsMessage<std::invalid_argument>(
                  AllOf(HasSubstr("weight 2"), HasSubstr("-0.25"))));
  EXPECT_THROW(BezierCurve::fromHomogeneous(HomogeneousPoles(0, 4)), std::invalid_argument);
}

TEST(BezierCurve, PolynomialJetsEqualThePowerForm) {
  std::mt19937_64 random(testSeed());
  for (int degree = 0; degree <= 9; ++degree)
    for (const double t : {0.0, 0.1, 0.5, 0.77, 1.0}) {
      const Poles poles = randomPoles(degree + 1, random);
      const CurveJet jet = BezierCurve(poles).jet(t);
      const double tolerance = 1e-11 * std::pow(degree + 1, 3);
      EXPECT_LT((jet.p - polynomialDerivative(poles, 0, t)).norm(), tolerance);
      EXPECT_LT((jet.d1 - polynomialDerivative(poles, 1, t)).norm(), tolerance);
      EXPECT_LT((jet.d2 - polynomialDerivative(poles, 2, t)).norm(), tolerance);
      EXPECT_LT((jet.d3 - polynomialDerivative(poles, 3, t)).norm(), 10 * tolerance);
      EXPECT_EQ(BezierCurve(poles).point(t), jet.p);
    }
}

TEST(BezierCurve, DerivativesOfAnyOrderEqualThePowerForm) {
  std::mt19937_64 random(testSeed());
  for (int degree = 0; degree <= 9; ++degree) {
    const Poles poles = randomPoles(degree + 1, random);
    const int order = degree + 2;
    const CurveDerivatives x = BezierCurve(poles).derivatives(0.3, order);
    ASSERT_EQ(x.rows(), order + 1);
    for (int k = 0; k <= order; ++k) {
      const Vec wanted = polynomialDerivative(poles, k, 0.3);
      EXPECT_LT((x.row(k).transpose() - wanted).norm(), 1e-8 * (1 + wanted.norm()))
          << degree << ' ' << k;
    }
  }
}

TEST(BezierCurve, FirstDerivativeKeepsWithinItsNoise) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const int degree = 1 + i % 7;
    const Poles poles =
        test::logUniform(random, -3, 4) * (randomPoles(degree + 1, random).array() + 100).matrix();
    Eigen::Matrix<long double, 3, 1> exact = Eigen::Matrix<long double, 3, 1>::Zero();
    for (int k = 0; k <= degree; ++k)
      exact += bernstein(degree, k, 1, 0.37) * poles.row(k).transpose().cast<long double>();
    const BezierCurve curve(poles);
    EXPECT_LE((curve.jet(0.37).d1.cast<long double>() - exact).norm(), curve.noise());
  }
}

BezierCurve quarterCircle() {
  Poles poles(3, 3);
  poles << 1, 0, 0, 1, 1, 0, 0, 1, 0;
  return {poles, Eigen::Vector3d(1, std::sqrt(0.5), 1)};
}

TEST(BezierCurve, RationalQuarterCircleStaysOnTheCircleToThirdOrder) {
  const BezierCurve circle = quarterCircle();
  EXPECT_TRUE(circle.isRational());
  for (double t = 0; t <= 1; t += 0.05) {
    const CurveJet x = circle.jet(t);
    EXPECT_NEAR(x.p.dot(x.p), 1, 1e-15);
    EXPECT_NEAR(x.p.dot(x.d1), 0, 1e-15);
    EXPECT_NEAR(x.p.dot(x.d2) + x.d1.dot(x.d1), 0, 1e-14);
    EXPECT_NEAR(x.p.dot(x.d3) + 3 * x.d1.dot(x.d2), 0, 1e-13);
  }
}

TEST(BezierCurve, RationalQuarterCircleStaysOnTheCircleToAnyOrder) {
  const CurveDerivatives x = quarterCircle().derivatives(0.35, 9);
  for (int k = 1; k <= 9; ++k) {
    double sum = 0, size = 0, binomial = 1;  // k-th derivative of X.X = 1 by Leibniz' rule
    for (int i = 0; i <= k; ++i) {
      sum += binomial * x.row(i).dot(x.row(k - i));
      size += binomial * x.row(i).norm() * x.row(k - i).norm();
      binomial *= static_cast<double>(k - i) / (i + 1);
    }
    EXPECT_NEAR(sum, 0, 1e-13 * size) << k;
  }
}

TEST(BezierCurve, SplitElevateReverseKeepTheShape) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 50; ++i) {
    const int degree = 1 + i % 6;
    const BezierCurve curve(randomPoles(degree + 1, random), randomWeights(degree + 1, random));
    const double cut = 0.1 + 0.8 * (i / 50.0);
    const auto [left, right] = curve.split(cut);
    for (const double t : {0.0, 0.3, 1.0}) {
      EXPECT_LT((left.point(t) - curve.point(cut * t)).norm(), 1e-13);
      EXPECT_LT((right.point(t) - curve.point(cut + (1 - cut) * t)).norm(), 1e-13);
      EXPECT_LT((curve.elevated().point(t) - curve.point(t)).norm(), 1e-13);
      EXPECT_LT((curve.reversed().point(t) - curve.point(1 - t)).norm(), 1e-13);
    }
    EXPECT_EQ(curve.elevated().degree(), degree + 1);
    EXPECT_EQ(curve.reversed().reversed(), curve);
  }
}

TEST(BezierPatch, PolynomialPartialsEqualThePowerForm) {
  std::mt19937_64 random(testSeed());
  for (const auto& degrees : {std::pair(0, 0), std::pair(1, 1), std::pair(2, 3), std::pair(3, 3),
                              std::pair(5, 2), std::pair(1, 7)}) {
    const int m = degrees.first, n = degrees.second;
    const Poles poles = randomPoles((m + 1) * (n + 1), random);
    const BezierPatch patch(m, n, poles);
    const double u = 0.3, v = 0.85;
    const auto partial = [&](int k, int l) {
      Vec sum = Vec::Zero();
      for (int i = 0; i <= m; ++i)
        for (int j = 0; j <= n; ++j)
          sum +=
              static_cast<double>(bernstein(m, i, k, u) * bernstein(n, j, l, v)) * patch.pole(i, j);
      return sum;
    };
    const SurfaceJet x = patch.jet(u, v);
    const std::array<std::pair<Vec, Vec>, 10> pairs = {{{x.p, partial(0, 0)},
                                                        {x.u, partial(1, 0)},
                                                        {x.v, partial(0, 1)},
                                                        {x.uu, partial(2, 0)},
                                                        {x.uv, partial(1, 1)},
                                                        {x.vv, partial(0, 2)},
                                                        {x.uuu, partial(3, 0)},
                                                        {x.uuv, partial(2, 1)},
                                                        {x.uvv, partial(1, 2)},
                                                        {x.vvv, partial(0, 3)}}};
    for (const auto& [ours, theirs] : pairs)
      EXPECT_LT((ours - theirs).norm(), 1e-10 * (1 + theirs.norm())) << m << ' ' << n;
    EXPECT_LT((patch.point(u, v) - x.p).norm(), 1e-14);
  }
}

/// Quarter of a torus, the product of two rational quarter circles.
BezierPatch quarterTorus(double R, double r) {
  const double w = std::sqrt(0.5);
  Poles poles(9, 3);
  Eigen::VectorXd weights(9);
  const double ring[3][3] = {{1, 0, 1}, {1, 1, w}, {0, 1, 1}};
  const double tube[3][3] = {{1, 0, 1}, {1, 1, w}, {0, 1, 1}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double distance = R + r * tube[j][0];
      poles.row(3 * i + j) << distance * ring[i][0], distance * ring[i][1], r * tube[j][1];
      weights(3 * i + j) = ring[i][2] * tube[j][2];
    }
  return {2, 2, poles, weights};
}

TEST(BezierPatch, HomogeneousPolesAreTakenOverBitByBit) {
  HomogeneousPoles poles(6, 4);
  for (int i = 0; i < 6; ++i) poles.row(i) << 0.1, 0.2, i / 7.0, 1 + i / 3.0;
  const BezierPatch patch = BezierPatch::fromHomogeneous(1, 2, poles);
  EXPECT_EQ(patch.homogeneousPoles(), poles);
  EXPECT_EQ(patch.degreeU(), 1);
  EXPECT_EQ(patch.degreeV(), 2);
  EXPECT_THROW(BezierPatch::fromHomogeneous(2, 2, poles), std::invalid_argument);
  poles(1, 3) = -2;
  EXPECT_THAT([&] { BezierPatch::fromHomogeneous(1, 2, poles); },
              testing::ThrowsMessage<std::invalid_argument>(HasSubstr("weight 1 is -2")));
}

TEST(BezierPatch, RationalTorusStaysOnTheTorusToThirdOrder) {
  // F = (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + y^2) vanishes along every line in the parameter plane,
  // with all derivatives.
  const double R = 3, r = 1;
  const BezierPatch torus = quarterTorus(R, r);
  for (const auto& [u, v] : {std::pair(0.2, 0.3), std::pair(0.5, 0.9), std::pair(1.0, 0.0)})
    for (const auto& [a, b] :
         {std::pair(1.0, 0.0), std::pair(0.0, 1.0), std::pair(0.6, -0.8), std::pair(1.0, 1.0)}) {
      const SurfaceJet x = torus.jet(u, v);
      // Taylor coefficients of the curve X(u + a h, v + b h) in h.
      const Vec c[4] = {
          x.p, a * x.u + b * x.v, 0.5 * (a * a * x.uu + 2 * a * b * x.uv + b * b * x.vv),
          (a * a * a * x.uuu + 3 * a * a * b * x.uuv + 3 * a * b * b * x.uvv + b * b * b * x.vvv) /
              6};
      double square[4] = {}, flat[4] = {};
      for (int i = 0; i < 4; ++i)
        for (int j = 0; i + j < 4; ++j) {
          square[i + j] += c[i].dot(c[j]);
          flat[i + j] += c[i].head<2>().dot(c[j].head<2>());
        }
      square[0] += R * R - r * r;
      for (int order = 0; order < 4; ++order) {
        double f = -4 * R * R * flat[order];
        for (int i = 0; i <= order; ++i) f += square[i] * square[order - i];
        EXPECT_NEAR(f, 0, 1e-11) << "order " << order;
      }
    }
}

TEST(BezierPatch, TransposeReverseSplitKeepTheShape) {
  std::mt19937_64 random(testSeed());
  const BezierPatch patch(2, 4, randomPoles(15, random), randomWeights(15, random));
  const auto [low, high] = patch.splitU(0.3);
  for (const double u : {0.0, 0.4, 1.0})
    for (const double v : {0.0, 0.7, 1.0}) {
      EXPECT_LT((patch.transposed().point(v, u) - patch.point(u, v)).norm(), 1e-14);
      EXPECT_LT((patch.reversedU().point(u, v) - patch.point(1 - u, v)).norm(), 1e-14);
      EXPECT_LT((low.point(u, v) - patch.point(0.3 * u, v)).norm(), 1e-14);
      EXPECT_LT((high.point(u, v) - patch.point(0.3 + 0.7 * u, v)).norm(), 1e-14);
      EXPECT_LT((patch.isoCurveU(u).point(v) - patch.point(u, v)).norm(), 1e-14);
    }
  EXPECT_EQ(patch.transposed().transposed(), patch);
}

TEST(BezierPatch, NoiseBoundsTheRoundingOfFirstPartials) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const int m = 1 + i % 5, n = 1 + i % 4;
    const Poles poles = test::logUniform(random, -3, 4) *
                        (randomPoles((m + 1) * (n + 1), random).array() + 100).matrix();
    const BezierPatch patch(m, n, poles);
    const double u = 0.37, v = 0.61;
    Eigen::Matrix<long double, 3, 1> exact = Eigen::Matrix<long double, 3, 1>::Zero();
    for (int a = 0; a <= m; ++a)
      for (int b = 0; b <= n; ++b)
        exact += bernstein(m, a, 1, u) * bernstein(n, b, 0, v) *
                 poles.row(a * (n + 1) + b).transpose().cast<long double>();
    EXPECT_LE((patch.jet(u, v).u.cast<long double>() - exact).norm(), patch.noise().u);
  }
}

std::string complaint(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Bezier, BadInputIsNamedByIndexAndValue) {
  const Poles four = Poles::Zero(4, 3);
  Poles holed = four;
  holed(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(complaint([&] { BezierCurve(Poles(0, 3)); }), HasSubstr("no poles"));
  EXPECT_THAT(complaint([&] { BezierCurve{holed}; }), HasSubstr("pole 2"));
  EXPECT_THAT(complaint([&] { BezierCurve(four, Eigen::Vector3d::Ones()); }),
              AllOf(HasSubstr("poles 4"), HasSubstr("weights 3")));
  EXPECT_THAT(complaint([&] { BezierCurve(four, Eigen::Vector4d(1, 1, 0, 1)); }),
              HasSubstr("weight 2 is 0"));
  EXPECT_THAT(complaint([&] { BezierCurve(four, Eigen::Vector4d(1, -2, 1, 1)); }),
              AllOf(HasSubstr("weight 1"), HasSubstr("-2")));
  EXPECT_THAT(complaint([&] { BezierCurve(four).derivatives(0, -2); }), HasSubstr("order -2"));
  EXPECT_THAT(complaint([&] { BezierPatch(1, 2, four); }),
              AllOf(HasSubstr("1 by 2"), HasSubstr("poles 4")));
  EXPECT_THAT(complaint([&] { BezierPatch(-1, 0, four); }), HasSubstr("-1"));
  EXPECT_THAT(complaint([&] { BezierPatch(1, 1, holed); }), HasSubstr("pole 2"));
}

}  // namespace
}  // namespace seamwright
