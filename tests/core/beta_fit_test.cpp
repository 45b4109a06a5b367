// SPDX-License-Identifier: LGPL-2.1-or-later
// fitBeta against figures known to 60 digits, against exact arithmetic and by its laws.
#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <limits>
#include <numbers>
#include <seamwright/core/join/curve/beta.hpp>

#include "curve_joins.hpp"
#include "exact.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::CurveKind;
using test::Dyadic;
using test::Vec;
using testing::HasSubstr;

BezierCurve mapped(const BezierCurve& curve, const Eigen::Matrix3d& map, const Vec& translation) {
  const Poles poles = (curve.poles() * map.transpose()).rowwise() + translation.transpose();
  return {poles, curve.weights()};
}

struct Pair {
  BezierCurve a, b;
  int order = 0;
};

/// Two curves that meet in a point, in some cases with the tangent or more.
Pair randomPair(int run, double size, std::mt19937_64& random) {
  const auto kind = static_cast<CurveKind>(run % 5);
  const int order = 1 + run % 6;
  const BezierCurve a = test::randomCurve(test::wholeNumber(1, 9, random), kind, true, size,
                                          random),
                    b = test::randomCurve(test::wholeNumber(1, 9, random), kind, false, size,
                                          random);
  CurveJoinRule rule;
  rule.beta = test::randomBeta(run % 4, random);
  return {a, test::gentlyJoined(a, b, rule, true), order};
}

/// How far rounding of the poles may move the defects, relative to them and 1: the largest
/// arc-length derivative, powers of the size by the length, and factorials.
double sensitivity(const Pair& pair, const BetaFit& fit) {
  const double size =
      std::max(pair.a.poles().cwiseAbs().maxCoeff(), pair.b.poles().cwiseAbs().maxCoeff());
  double result = 1;
  for (const CurveDerivatives& x : {CurveDerivatives(pair.a.derivatives(1, pair.order)),
                                    CurveDerivatives(pair.b.derivatives(0, pair.order))}) {
    double order_factor = 1;
    for (Eigen::Index k = 1; k <= pair.order; ++k) {
      order_factor *= static_cast<double>(k);
      const double turn = x.row(k).norm() * std::pow(fit.length_mm, static_cast<double>(k) - 1) /
                          std::pow(x.row(1).norm(), static_cast<double>(k));
      result = std::max(result, std::pow(2 + turn / order_factor, pair.order) * order_factor);
    }
    result = std::max(result, size / x.row(1).norm());
  }
  return result * std::max(1.0, size / fit.length_mm);
}

void expectSame(const BetaFit& x, const BetaFit& y, double noise, int run) {
  ASSERT_EQ(x.defects.size(), y.defects.size()) << run;
  for (std::size_t k = 0; k < x.defects.size(); ++k)
    EXPECT_NEAR(x.defects[k], y.defects[k], noise * (1 + y.defects[k])) << run << " order " << k;
}

TEST(BetaFit, FiguresOfSixtyDigits) {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/curve_joints.json");
  const json data = json::parse(file);
  int compared = 0;
  for (const json& entry : data["cases"]) {
    const json &in = entry["in"], &out = entry["out"];
    const std::string note = in["note"];
    SCOPED_TRACE(entry["name"].get<std::string>() + " " + note);
    if (!in["right_weights"].is_null() &&
        std::ranges::any_of(in["right_weights"],
                            [](const json& w) { return test::number(w) <= 0; }))
      continue;  // such curves are refused
    ++compared;
    const BezierCurve a = test::bezierCurve(in["left"], in["left_weights"]),
                      b = test::bezierCurve(in["right"], in["right_weights"]);
    const int order = in["nmax"];
    const BetaFit fit = fitBeta(a, b, order, test::number(in["L"]));
    const double loss = sensitivity({a, b, order}, fit);
    ASSERT_EQ(fit.defects.size(), out["defect"].size());
    for (std::size_t k = 0; k < fit.defects.size(); ++k) {
      const double wanted = test::number(out["defect"][k]);
      EXPECT_NEAR(fit.defects[k], wanted, 1e-15 * loss * (1 + wanted))
          << "order " << k << " loss " << loss;
      EXPECT_LE(fit.lower[k], fit.defects[k]);
      EXPECT_LE(fit.defects[k], fit.upper[k]);
      if (wanted < 1e-50) {
        EXPECT_LE(fit.upper[k], 1e-14 * loss);
      }
      if (wanted > 1e-8) {
        EXPECT_GT(fit.lower[k], 0.9 * wanted) << "order " << k << " is proved to be missed";
      }
    }
    if (note.find("cusp") != std::string::npos) {
      EXPECT_EQ(fit.beta.size(), 0) << "beta_1 is negative";
      EXPECT_LT(test::number(out["beta"][0]), 0);
      EXPECT_NEAR(fit.defects[1], 2, 1e-13);
      continue;
    }
    ASSERT_EQ(fit.beta.size(), order);
    double size = 1;
    for (int k = 0; k < order; ++k) {
      const double wanted = test::number(out["beta"][k]);
      size = std::max(size, std::abs(wanted));
      EXPECT_NEAR(fit.beta(k), wanted, 1e-11 * size) << "beta " << k + 1;
    }
  }
  EXPECT_EQ(compared, 19);
}

using DyadicRows = std::vector<std::array<Dyadic, 3>>;

Dyadic power(int exponent) {
  return {std::ldexp(1.0, exponent)};
}

Dyadic dot(const std::array<Dyadic, 3>& x, const std::array<Dyadic, 3>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/// Derivatives at t = 0, without rounding. \pre the first weight is 1.
DyadicRows exactDerivatives(const BezierCurve& curve, int order) {
  const HomogeneousPoles& poles = curve.homogeneousPoles();
  std::vector<std::array<Dyadic, 4>> h(order + 1);
  for (int k = 0; k <= std::min(order, curve.degree()); ++k) {
    const test::DyadicVector binomials = test::exactBinomials(k);
    for (int i = 0; i <= k; ++i)
      for (int c = 0; c < 4; ++c) {
        const Dyadic term =
            Dyadic(test::fallingFactorial(curve.degree(), k)) * binomials[i] * Dyadic(poles(i, c));
        h[k][c] = (k - i) % 2 == 0 ? h[k][c] + term : h[k][c] - term;
      }
  }
  DyadicRows x(order + 1);
  for (int k = 0; k <= order; ++k) {
    const test::DyadicVector binomials = test::exactBinomials(k);
    for (int c = 0; c < 3; ++c) {
      x[k][c] = h[k][c];
      for (int i = 1; i <= k; ++i) x[k][c] = x[k][c] - binomials[i] * h[i][3] * x[k - i][c];
    }
  }
  return x;
}

/// Derivatives by arc length as (1 / speed) d/dt, again and again; without rounding.
/// \pre the speed is 2^exponent.
DyadicRows exactArcLength(const DyadicRows& x, int exponent) {
  const int order = static_cast<int>(x.size()) - 1;
  std::vector<Dyadic> speed(order), inverse(order);
  for (int m = 0; m < order; ++m) {
    const test::DyadicVector binomials = test::exactBinomials(m);
    for (int i = 0; i <= m; ++i) speed[m] = speed[m] + binomials[i] * dot(x[i + 1], x[m - i + 1]);
    for (int i = 1; i < m; ++i) speed[m] = speed[m] - binomials[i] * speed[i] * speed[m - i];
    speed[m] = speed[m] * power(m == 0 ? -exponent : -exponent - 1);
    inverse[m] = m == 0 ? power(-exponent) : 0;
    for (int i = 1; i <= m; ++i)
      inverse[m] = inverse[m] - power(-exponent) * binomials[i] * speed[i] * inverse[m - i];
  }
  DyadicRows result = x, jet = x;
  for (int k = 1; k <= order; ++k) {
    DyadicRows next(jet.size() - 1);
    for (std::size_t m = 0; m < next.size(); ++m) {
      const test::DyadicVector binomials = test::exactBinomials(static_cast<int>(m));
      for (std::size_t i = 0; i <= m; ++i)
        for (int c = 0; c < 3; ++c)
          next[m][c] = next[m][c] + binomials[i] * inverse[i] * jet[m - i + 1][c];
    }
    jet = next;
    result[k] = jet[0];
  }
  return result;
}

/// A curve from the origin of speed 2^exponent, along +x, its degree a power of two.
BezierCurve dyadicCurve(bool rational, int exponent, std::mt19937_64& random) {
  const int degree = 1 << test::wholeNumber(0, 3, random);
  HomogeneousPoles poles(degree + 1, 4);
  for (int i = 0; i <= degree; ++i) {
    const double weight = rational && i > 0 ? test::logUniform(random, -0.2, 0.2) : 1;
    poles.row(i) << std::ldexp(1.0, exponent) * test::randomVector(random).transpose(), weight;
  }
  poles.row(0) << 0, 0, 0, 1;
  poles.row(1).head<3>() << std::ldexp(1.0, exponent) / degree, 0, 0;
  return BezierCurve::fromHomogeneous(poles);
}

TEST(BetaFit, BoundsHoldTheExactDefect) {
  std::mt19937_64 random(testSeed());
  double widest = 0;
  int proved = 0;
  for (int run = 0; run < 600; ++run) {
    const int order = 1 + run % 6, exponent_a = test::wholeNumber(-9, 9, random),
              exponent_b = exponent_a + run % 3;
    const BezierCurve left = dyadicCurve(run % 2 == 0, exponent_a, random);
    BezierCurve right = dyadicCurve(run % 4 < 2, exponent_b, random);
    if (run % 3 == 0) {  // nearly a continuation: G^1, the curvature moved by a hair
      HomogeneousPoles poles = left.homogeneousPoles();
      if (left.degree() >= 2)
        poles(2, 1) += std::ldexp(poles(2, 1), -test::wholeNumber(20, 50, random));
      right = BezierCurve::fromHomogeneous(poles);
    }
    const int speed = run % 3 == 0 ? exponent_a : exponent_b;
    const double length = std::ldexp(test::uniformNumber(1, 2, random), exponent_a);
    // a arrives along +x: the curve from the origin along +x, mirrored in space and run backwards.
    HomogeneousPoles mirrored = left.homogeneousPoles();
    for (int i = 0; i < mirrored.rows(); ++i) mirrored.row(i).head<3>() *= -1;
    const BetaFit fit =
        fitBeta(BezierCurve::fromHomogeneous(mirrored).reversed(), right, order, length);
    DyadicRows a = exactArcLength(exactDerivatives(left, order), exponent_a);
    const DyadicRows b = exactArcLength(exactDerivatives(right, order), speed);
    Dyadic scale = 1;
    double largest = 1;
    for (int k = 0; k <= order; ++k) {
      std::array<Dyadic, 3> d;  // c_k of X(-t) -> -X(-s): the sign of even orders changes
      for (int c = 0; c < 3; ++c) d[c] = k % 2 == 0 ? b[k][c] + a[k][c] : b[k][c] - a[k][c];
      const Dyadic square = dot(d, d) * scale;  // (defect L)^2 for k = 0, else defect^2
      const Dyadic factor = k == 0 ? Dyadic(length) * Dyadic(length) : Dyadic(1);
      const auto within = [&](double low, double high) {
        return Dyadic(low) * Dyadic(low) * factor <= square &&
               square <= Dyadic(high) * Dyadic(high) * factor;
      };
      EXPECT_TRUE(within(fit.lower[k], fit.upper[k])) << run << " order " << k;
      EXPECT_LE(fit.lower[k], fit.defects[k]);
      EXPECT_LE(fit.defects[k], fit.upper[k]);
      if (square.sign() > 0 && fit.lower[k] > 0) ++proved;
      const double size = static_cast<double>(std::sqrt((dot(a[k], a[k]) * scale).approximate()) +
                                              std::sqrt((dot(b[k], b[k]) * scale).approximate()));
      widest = std::max(widest, (fit.upper[k] - fit.lower[k]) / std::max(largest, size));
      largest = std::max(largest, size);
      if (k > 0) scale = scale * Dyadic(length) * Dyadic(length);
    }
  }
  EXPECT_LE(widest, 1e-9);
  EXPECT_GE(proved, 1000);
}

TEST(BetaFit, SizeBeyondPowersOfADouble) {
  Poles left(5, 3), right(5, 3);
  left << 0, 0, 0, 1, 0, 0, 2, 1, 0, 3, 1, 1, 4, 0, 0;
  right << 4, 0, 0, 5, -1, -1, 6, 0, 0, 7, 1, 1, 9, 0, 2;
  const BetaFit fit = fitBeta(BezierCurve(left), BezierCurve(right), 6);
  for (const double scale : {1e150, 1e-150}) {
    const BetaFit scaled = fitBeta(BezierCurve(scale * left), BezierCurve(scale * right), 6);
    for (std::size_t k = 0; k <= 6; ++k)
      EXPECT_NEAR(scaled.defects[k], fit.defects[k], 1e-11 * (1 + fit.defects[k]))
          << scale << " order " << k;
  }
}

TEST(BetaFit, Identity5Invariance) {
  std::mt19937_64 random(testSeed());
  double worst = 0;
  for (int run = 0; run < 1200; ++run) {
    const Pair pair = randomPair(run, 1, random);
    const int order = pair.order;
    const BetaFit fit = fitBeta(pair.a, pair.b, order);
    const double noise = 1e-13 * sensitivity(pair, fit);
    const Eigen::Matrix3d turn = test::randomRotation(random);
    const Vec move = test::randomVector(random);
    const BetaFit moved = fitBeta(mapped(pair.a, turn, move), mapped(pair.b, turn, move), order);
    expectSame(moved, fit, noise, run);
    EXPECT_NEAR(moved.length_mm, fit.length_mm, 1e-13 * (fit.length_mm + 10)) << run;
    const double s = test::logUniform(random, -6, 6);
    const Eigen::Matrix3d scale = s * Eigen::Matrix3d::Identity();
    const BetaFit scaled =
        fitBeta(mapped(pair.a, scale, s * move), mapped(pair.b, scale, s * move), order);
    expectSame(scaled, fit, noise, run);
    EXPECT_NEAR(scaled.length_mm, s * fit.length_mm, 1e-13 * s * (fit.length_mm + 10)) << run;
    const BetaFit elevated =
        fitBeta(pair.a.elevated(), pair.b.elevated().elevated(), order, fit.length_mm);
    expectSame(elevated, fit, noise, run);
    const BetaFit backwards = fitBeta(pair.b.reversed(), pair.a.reversed(), order);
    expectSame(backwards, fit, noise, run);
    // Half of each curve: a parameter twice as slow. Moebius: weights c^i.
    const BetaFit halves =
        fitBeta(pair.a.split(0.5).second, pair.b.split(0.5).first, order, fit.length_mm);
    expectSame(halves, fit, noise, run);
    HomogeneousPoles poles = pair.b.homogeneousPoles();
    for (int i = 1; i < poles.rows(); ++i) poles.row(i) *= std::pow(0.8, i);
    expectSame(fitBeta(pair.a, BezierCurve::fromHomogeneous(poles), order, fit.length_mm), fit,
               noise, run);
    worst = std::max(worst, std::abs(fit.upper[0] - fit.lower[0]));
  }
  EXPECT_LE(worst, 1e-10);
}

TEST(BetaFit, Identity7AgainstMeasureJoint) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 1000; ++run) {
    const Pair pair = randomPair(run, test::logUniform(random, -3, 3), random);
    const BetaFit fit = fitBeta(pair.a, pair.b, pair.order);
    const CurveJoint joint = measureJoint(pair.a, pair.b, pair.order);
    ASSERT_EQ(fit.defects.size(), joint.differences.size());
    for (std::size_t k = 0; k < fit.defects.size(); ++k) {
      const double wanted =
          joint.differences[k] * std::pow(fit.length_mm, static_cast<double>(k) - 1);
      EXPECT_NEAR(fit.defects[k], wanted, 1e-13 * sensitivity(pair, fit) * (1 + wanted))
          << run << " " << k;
    }
  }
}

TEST(BetaFit, ScaleByPowersOfTwoChangesNoBit) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 300; ++run) {
    const Pair pair = randomPair(run, 1, random);
    const BetaFit fit = fitBeta(pair.a, pair.b, pair.order);
    for (const int exponent : {-140, 140}) {
      const auto scaled = [&](const BezierCurve& curve) {
        HomogeneousPoles poles = curve.homogeneousPoles();
        poles.leftCols<3>() *= std::ldexp(1.0, exponent);
        return BezierCurve::fromHomogeneous(poles);
      };
      const BetaFit far = fitBeta(scaled(pair.a), scaled(pair.b), pair.order);
      EXPECT_EQ(far.lower, fit.lower) << run;
      EXPECT_EQ(far.upper, fit.upper) << run;
    }
  }
}

TEST(BetaFit, HighOrdersHaveBoundsToo) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 20; ++run) {
    const auto [left, right] = test::randomCurve(6, CurveKind::Space, true, 1, random).split(0.5);
    const BetaFit fit = fitBeta(left, right, 30);
    ASSERT_EQ(fit.upper.size(), 31u);
    for (std::size_t k = 0; k <= 30; ++k) {
      EXPECT_LE(fit.lower[k], fit.defects[k]) << run << " order " << k;
      EXPECT_LE(fit.defects[k], fit.upper[k]) << run << " order " << k;
    }
    EXPECT_LE(fit.upper[6], 1e-3) << run;
  }
}

/// Arcs of radii r and R as rational quadratics, on one side of their tangent: |1/r - 1/R| L.
TEST(BetaFit, ArcsDifferByTheirCurvatures) {
  const auto quarter = [](double r, bool arrives) {
    Poles poles(3, 3);
    poles << 0, 0, 0, r, 0, 0, r, r, 0;
    if (arrives) poles << -r, r, 0, -r, 0, 0, 0, 0, 0;
    return BezierCurve(poles, Eigen::Vector3d(1, std::numbers::sqrt2 / 2, 1));
  };
  for (const double R : {1.0, 2.0, 30.0, 1e4}) {
    const BetaFit fit = fitBeta(quarter(2, true), quarter(R, false), 2);
    EXPECT_NEAR(fit.length_mm, std::min(2.0, R) * std::numbers::sqrt2, 1e-15 * R);
    EXPECT_NEAR(fit.defects[2], std::abs(0.5 - 1 / R) * fit.length_mm, 1e-14);
    EXPECT_NEAR(fit.beta(0), R / 2, 1e-12 * R);
    EXPECT_EQ(fit.lower[2] > 0, R != 2) << "proved not to be G2";
    EXPECT_EQ(fit.lower[1], 0);
  }
}

TEST(BetaFit, LengthOfClosedCurves) {
  Poles loop(4, 3), line(2, 3);
  loop << 0, 0, 0, 3, 0, 0, 3, 4, 0, 0, 0, 0;
  line << -7, 0, 0, 0, 0, 0;
  const BezierCurve closed(loop), open(line);
  EXPECT_EQ(fitBeta(open, closed, 1).length_mm, 7) << "the chord of the open one";
  EXPECT_EQ(fitBeta(closed, closed, 1).length_mm, 5) << "the diagonal of the box";
  EXPECT_EQ(fitBeta(closed, closed, 1, 2.5).length_mm, 2.5);
  EXPECT_NEAR(fitBeta(closed, closed, 1).defects[1], (Vec(-3, -4, 0) / 5 - Vec(1, 0, 0)).norm(),
              1e-15);
}

TEST(BetaFit, LengthOfNearlyClosedCurves) {
  Poles loop(4, 3), line(2, 3);
  loop << 0, 0, 0, 3, 0, 0, 3, 4, 0, 1e-14, 0, 0;
  line << -7, 0, 0, 0, 0, 0;
  EXPECT_EQ(fitBeta(BezierCurve(line), BezierCurve(loop), 1).length_mm, 7)
      << "1e-14 of a size of 5 is closed";
  loop(3, 0) = 1e-10;
  EXPECT_EQ(fitBeta(BezierCurve(line), BezierCurve(loop), 1).length_mm, 1e-10);
}

TEST(BetaFit, ACuspAndALostTangent) {
  Poles line(2, 3), still(4, 3);
  line << 0, 0, 0, 1, 2, 3;
  still << 1, 2, 3, 1, 2, 3, 2, 2, 3, 5, 2, 3;
  const BezierCurve a(line);
  const BetaFit cusp = fitBeta(a, a.reversed(), 3);
  EXPECT_EQ(cusp.beta.size(), 0);
  EXPECT_NEAR(cusp.defects[1], 2, 1e-15);
  const BetaFit lost = fitBeta(a, BezierCurve(still), 3);
  EXPECT_EQ(lost.beta.size(), 0);
  EXPECT_EQ(lost.defects, std::vector<double>{0}) << "the gap alone";
  EXPECT_EQ(lost.lower.size(), 1u);
  EXPECT_EQ(fitBeta(a, a, 0).defects.size(), 1u);
  EXPECT_NEAR(fitBeta(a, a, 0).defects[0], 1, 1e-15);
}

TEST(BetaFit, RefusesBadInput) {
  Poles line(2, 3);
  line << 0, 0, 0, 1, 2, 3;
  const BezierCurve a(line), point(Poles::Ones(3, 3));
  const auto refusal = [](const std::function<void()>& call) -> std::string {
    try {
      call();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refusal([&] { fitBeta(a, a, -1); }),
              HasSubstr("order -1: it must be within 0 to 30"));
  EXPECT_THAT(refusal([&] { fitBeta(a, a, 31); }), HasSubstr("order 31"));
  EXPECT_NO_THROW(fitBeta(a, a, 30));
  EXPECT_THAT(refusal([&] { fitBeta(a, a, 1, 0); }),
              HasSubstr("length_mm is 0: it must be positive"));
  EXPECT_THAT(refusal([&] { fitBeta(a, a, 1, -2); }), HasSubstr("length_mm is -2"));
  EXPECT_THAT(refusal([&] { fitBeta(a, a, 1, std::nan("")); }), HasSubstr("length_mm is nan"));
  EXPECT_THAT(refusal([&] { fitBeta(point, point, 1); }), HasSubstr("length_mm is 0"));
}

}  // namespace
}  // namespace seamwright
