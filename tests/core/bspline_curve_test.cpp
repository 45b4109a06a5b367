// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <seamwright/core/bspline/curve.hpp>

#include "splines.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using test::expectRefused;
using test::Vec;

constexpr double inf = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();

double drawn(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

TEST(BSplineCurve, Identity1ABezierCurveIsASplineWithoutInnerKnots) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1000; ++i) {
    const int degree = 1 + i % 25;
    const BezierCurve curve =
        BezierCurve::fromHomogeneous(test::randomPoles(degree + 1, i % 2 == 0, random));
    const BSplineCurve spline = splineCurve(curve);
    EXPECT_EQ(spline.poles, curve.homogeneousPoles());
    const double t = i % 7 == 0 ? i % 2 : drawn(random, 0, 1);
    const CurveDerivatives ours = derivatives(spline, t, 3), theirs = curve.derivatives(t, 3);
    // Differences of order k are rounded 2^k n! / (n - k)! eps times the poles; weights divide up
    // to order k.
    double scale = static_cast<double>(degree);
    for (int k = 0; k <= 3; ++k, scale *= 2 * degree)
      EXPECT_LT((ours.row(k) - theirs.row(k)).norm(), 1e-13 * scale * (1 << k))
          << i << " order " << k;
  }
}

/// Of a polynomial, Taylor's series is finite: all rows at one parameter give the point at any
/// other of the span.
TEST(BSplineCurve, Identity2RowsAreDerivativesOfRows) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 2000; ++i) {
    const int degree = 1 + i % 6, multiplicity = 1 + i % degree;
    const BSplineCurve curve = test::randomCurve(degree, multiplicity, 1 + i % 4, false, random);
    const double t = drawn(random, curve.knots.front(), curve.knots.back());
    const auto next = std::upper_bound(curve.knots.begin(), curve.knots.end(), t);
    const double from = *(next - 1), other = drawn(random, from, *next);
    const CurveDerivatives rows = derivatives(curve, t, degree + 1);
    EXPECT_TRUE(rows.row(degree + 1).isZero(0));
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    double power = 1, size = 1;
    for (int k = 0; k <= degree; ++k) {
      sum += power * rows.row(k);
      size = std::max(size, std::abs(power) * rows.row(k).norm());
      power *= (other - t) / (k + 1);
    }
    EXPECT_LT((sum - derivatives(curve, other, 0).row(0)).norm(), 1e-13 * size * degree) << i;
  }
}

/// A = w X with A and w evaluated as curves of their own.
TEST(BSplineCurve, Identity2RationalByLeibniz) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1000; ++i) {
    const BSplineCurve curve = test::randomCurve(1 + i % 5, 1, 3, true, random);
    BSplineCurve above = curve, below = curve;
    above.poles.col(3).setOnes();
    below.poles.setOnes();
    below.poles.col(0) = curve.poles.col(3);
    const double t = drawn(random, curve.knots.front(), curve.knots.back());
    const CurveDerivatives x = derivatives(curve, t, 4), a = derivatives(above, t, 4),
                           w = derivatives(below, t, 4);
    for (int k = 0; k <= 4; ++k) {
      Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
      double binomial = 1, size = a.row(k).norm();
      for (int j = 0; j <= k; ++j) {
        sum += binomial * w(j, 0) * x.row(k - j);
        size = std::max(size, std::abs(binomial * w(j, 0)) * x.row(k - j).norm());
        binomial *= static_cast<double>(k - j) / (j + 1);
      }
      EXPECT_LT((sum - a.row(k)).norm(), 1e-12 * size) << i << " order " << k;
    }
  }
}

/// Poles that are the blossom of (t, t^2, t^3) make that curve, whatever the knots (Marsden).
TEST(BSplineCurve, ClosedFormMarsden) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1000; ++i) {
    const int n = 3 + i % 5;
    BSplineCurve curve = test::randomCurve(n, 1 + i % n, 1 + i % 5, false, random);
    for (int p = 0; p < curve.count(); ++p) {
      // Newton's identities for the elementary symmetric functions.
      double p1 = 0, p2 = 0, p3 = 0;
      for (int j = 1; j <= n; ++j) {
        const double u = curve.knots[p + j];
        p1 += u, p2 += u * u, p3 += u * u * u;
      }
      const double e2 = (p1 * p1 - p2) / 2, e3 = (p1 * p1 * p1 - 3 * p1 * p2 + 2 * p3) / 6;
      curve.poles.row(p) << p1 / n, 2 * e2 / (n * (n - 1)), 6 * e3 / (n * (n - 1.0) * (n - 2)), 1;
    }
    const double t = drawn(random, curve.knots.front(), curve.knots.back());
    const double size =
        std::pow(1 + std::max(std::abs(curve.knots.front()), curve.knots.back()), 3);
    CurveDerivatives exact(4, 3);
    exact << t, t * t, t * t * t, 1, 2 * t, 3 * t * t, 0, 2, 6 * t, 0, 0, 6;
    const CurveDerivatives ours = derivatives(curve, t, 3);
    double least = inf;
    for (std::size_t j = 1; j < curve.knots.size(); ++j)
      if (curve.knots[j] > curve.knots[j - 1])
        least = std::min(least, curve.knots[j] - curve.knots[j - 1]);
    for (int k = 0; k <= 3; ++k)
      EXPECT_LT((ours.row(k) - exact.row(k)).norm(),
                1e-13 * size * std::pow(2 * n / std::min(least, 1.0), k))
          << i << " order " << k;
  }
}

TEST(BSplineCurve, KnotsBelongToWhatFollows) {
  // Two parabolas over [0, 1] and [1, 3] that meet with a corner; at the end and beyond the last
  // one goes on.
  BSplineCurve curve{2, {0, 0, 0, 1, 1, 3, 3, 3}, HomogeneousPoles::Ones(5, 4)};
  curve.poles.col(0) << 0, 1, 2, 6, 6;
  curve.poles.col(1).setZero();
  curve.poles.col(2).setZero();
  EXPECT_EQ(derivatives(curve, 1, 1)(1, 0), 4);
  EXPECT_EQ(derivatives(curve, std::nextafter(1.0, 0.0), 1)(1, 0), 2);
  EXPECT_EQ(derivatives(curve, 3, 1)(1, 0), 0);
  EXPECT_EQ(derivatives(curve, 5, 0)(0, 0), 2);    // 6 - (t - 3)^2
  EXPECT_EQ(derivatives(curve, -1, 0)(0, 0), -2);  // 2 t
}

TEST(BSplineCurve, OracleOfSixtyDigits) {
  for (const nlohmann::json& entry : test::splineCases("spline_conversions.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const nlohmann::json& out = entry["out"];
    const std::vector<double> breaks = test::numbers(out["knots"]);
    BSplineCurve curve{out["degree"], {}, test::homogeneous(test::points(out["poles"]))};
    for (std::size_t i = 0; i < breaks.size(); ++i)
      curve.knots.insert(curve.knots.end(), out["mults"][i].get<int>(), breaks[i]);
    if (!out["weights"].is_null())
      for (Eigen::Index i = 0; i < curve.poles.rows(); ++i)
        curve.poles.row(i) *= test::number(out["weights"][i]);
    const double size = curve.poles.cwiseAbs().maxCoeff();
    for (const nlohmann::json& sample : out["samples"])
      EXPECT_LT((derivatives(curve, test::number(sample["t"]), 0).row(0).transpose() -
                 test::vector(sample["point"]))
                    .norm(),
                1e-13 * size);
  }
}

TEST(BSplineCurve, LawsOfMotionScaleReversalAndParameter) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 500; ++i) {
    const int n = 1 + i % 5;
    const BSplineCurve curve = test::randomCurve(n, 1, 4, i % 2 == 0, random);
    const double t = drawn(random, curve.knots.front(), curve.knots.back());
    const CurveDerivatives plain = derivatives(curve, t, n);
    const Eigen::Matrix3d R = test::logUniform(random, -3, 3) * test::randomRotation(random);
    BSplineCurve moved = curve;
    moved.poles.leftCols<3>() = curve.poles.leftCols<3>() * R.transpose();
    BSplineCurve back = curve, faster = curve;
    std::ranges::reverse(back.knots);
    for (double& knot : back.knots) knot = -knot;
    back.poles = curve.poles.colwise().reverse().eval();
    for (double& knot : faster.knots) knot *= 0.125;
    const CurveDerivatives m = derivatives(moved, t, n), b = derivatives(back, -t, n),
                           f = derivatives(faster, 0.125 * t, n);
    for (int k = 0; k <= n; ++k) {
      const double size = 1e-10 * (1 + plain.row(k).norm());
      EXPECT_LT((m.row(k) - plain.row(k) * R.transpose()).norm(), size * R.norm());
      EXPECT_LT((b.row(k) * (k % 2 ? -1 : 1) - plain.row(k)).norm(), size);
      EXPECT_EQ(f.row(k) * std::pow(0.125, k), plain.row(k));
    }
  }
}

TEST(BSplineCurve, RefusesWhatIsNoCurve) {
  const BSplineCurve good{2, {0, 0, 0, 1, 2, 2, 2}, HomogeneousPoles::Ones(4, 4)};
  requireValid(good);
  const auto refused = [&](auto change, const std::string& part) {
    BSplineCurve bad = good;
    change(bad);
    expectRefused([&] { requireValid(bad); }, part);
    expectRefused([&] { derivatives(bad, 0.5, 1); }, part);
  };
  refused([](BSplineCurve& c) { c.degree = 0; }, "degree is 0");
  refused([](BSplineCurve& c) { c.degree = 26; }, "degree is 26");
  refused([](BSplineCurve& c) { c.degree = 4; }, "knots are 7");
  refused([](BSplineCurve& c) { c.knots.clear(); }, "knots are 0");
  refused([](BSplineCurve& c) { c.knots[3] = nan; }, "knot 3 of knots is nan");
  refused([](BSplineCurve& c) { c.knots[6] = inf; }, "knot 6 of knots is inf");
  refused([](BSplineCurve& c) { c.knots[3] = 3; }, "knot 4 of knots is 2");
  refused([](BSplineCurve& c) { c.knots[0] = -1; }, "knot 1 of knots is 0");
  refused([](BSplineCurve& c) { c.knots[6] = 4; }, "the last degree + 1 knots");
  refused([](BSplineCurve& c) { c.knots[3] = 0; }, "knot 1 of knots is 0");
  refused([](BSplineCurve& c) { c.poles = HomogeneousPoles::Ones(5, 4); }, "poles 5, knots for 4");
  refused([](BSplineCurve& c) { c.poles(2, 1) = nan; }, "pole 2 is not finite");
  refused([](BSplineCurve& c) { c.poles(1, 3) = -2; }, "weight 1 is -2");
  refused([](BSplineCurve& c) { c.poles(3, 3) = 0; }, "weight 3 is 0");
  expectRefused([&] { derivatives(good, nan, 1); }, "parameter t is nan");
  expectRefused([&] { derivatives(good, inf, 1); }, "parameter t is inf");
  expectRefused([&] { derivatives(good, 0.5, -1); }, "order -1");
  expectRefused([&] { splineCurve(BezierCurve(Poles(Poles::Zero(1, 3)))); }, "degree is 0");
  expectRefused([&] { splineCurve(BezierCurve(Poles(Poles::Zero(27, 3)))); }, "degree is 26");
}

TEST(BSplineCurve, EqualWeightsOfAnySizeAreNone) {
  const BSplineCurve one{
      1, {0, 0, 1, 1}, (HomogeneousPoles(2, 4) << 1, 2, 3, 1, 4, 5, 6, 1).finished()};
  BSplineCurve three = one;
  three.poles *= 3;
  EXPECT_EQ(derivatives(three, 0.25, 1), derivatives(one, 0.25, 1));
}

TEST(BSplineCurve, ARangeThatUnderflowsIsRefused) {
  const BSplineCurve tiny{1, {0, 0, 1e-310, 1e-310}, HomogeneousPoles::Ones(2, 4)};
  expectRefused([&] { requireValid(tiny); },
                "the range of the knots must not overflow, nor underflow");
  const BSplineCurve flat{1, {0, 0, 1, 1}, HomogeneousPoles::Ones(2, 4) * 1e-12};
  BSplineCurve weightless = flat;
  weightless.poles(0, 3) = -1e-12;
  expectRefused([&] { requireValid(weightless); }, "weight 0 is -9.9999999999999998e-13");
}

}  // namespace
}  // namespace seamwright
