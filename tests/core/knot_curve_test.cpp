// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <seamwright/core/bspline/knot_curve.hpp>

#include "splines.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using test::expectRefused;
using Real = long double;

/// Knots long before and after, by the recursion of Cox and de Boor in extended precision.
class Reference {
 public:
  explicit Reference(const KnotCurve& curve) : curve_(curve) {
    const auto append = [&](Real shift, std::size_t from) {
      for (std::size_t i = from; i < curve.knots.size(); ++i)
        knots_.insert(knots_.end(), static_cast<std::size_t>(curve.multiplicities[i]),
                      curve.knots[i] + shift);
    };
    const Real period = static_cast<Real>(curve.knots.back()) - curve.knots.front();
    const int turns = curve.periodic ? curve.degree + 3 : 0;
    for (int k = -turns; k <= turns; ++k) append(k * period, curve.periodic ? 1 : 0);
  }

  Eigen::RowVector3d point(double t) const {
    Eigen::Matrix<Real, 1, 4> sum = Eigen::Matrix<Real, 1, 4>::Zero();
    const std::size_t n = static_cast<std::size_t>(curve_.degree), rows = curve_.poles.rows();
    for (std::size_t i = 0; i + n + 1 < knots_.size(); ++i)
      if (knots_[i] <= t && t <= knots_[i + n + 1])
        sum += basis(i, n, t) *
               curve_.poles.row(static_cast<Eigen::Index>(curve_.periodic ? (i + n + 1) % rows : i))
                   .cast<Real>();
    return (sum.head<3>() / sum(3)).cast<double>();
  }

 private:
  Real basis(std::size_t i, std::size_t n, Real t) const {
    if (n == 0) return knots_[i] <= t && t < knots_[i + 1];
    Real value = 0;
    if (knots_[i + n] > knots_[i])
      value += (t - knots_[i]) / (knots_[i + n] - knots_[i]) * basis(i, n - 1, t);
    if (knots_[i + n + 1] > knots_[i + 1])
      value +=
          (knots_[i + n + 1] - t) / (knots_[i + n + 1] - knots_[i + 1]) * basis(i + 1, n - 1, t);
    return value;
  }

  KnotCurve curve_;
  std::vector<Real> knots_;
};

KnotCurve randomKnots(int degree, int spans, bool periodic, bool rational,
                      std::mt19937_64& random) {
  std::uniform_int_distribution<int> times(1, degree);
  KnotCurve curve{degree, test::randomBreaks(spans, 0.4, random), {}, {}, periodic};
  for (int i = 0; i <= spans; ++i) curve.multiplicities.push_back(i % 2 ? 1 : times(random));
  if (periodic) curve.multiplicities.back() = curve.multiplicities.front();
  const auto count = [&] {
    return std::accumulate(curve.multiplicities.begin() + periodic, curve.multiplicities.end(), 0) -
           (periodic ? 0 : degree + 1);
  };
  while (!periodic && count() < degree + 1) {
    curve.knots.push_back(curve.knots.back() + 0.7);
    curve.multiplicities.push_back(1);
  }
  curve.poles = test::randomPoles(count(), rational, random);
  return curve;
}

double drawn(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Degrees up to 6 with a single span and more; a tenth of a span and more than a turn.
TEST(KnotCurve, Identity1TheSamePoints) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1500; ++i) {
    const bool periodic = i % 2 == 0;
    const KnotCurve curve = randomKnots(1 + i % 6, 1 + i % 5, periodic, i % 3 == 0, random);
    auto [first, last] = rangeOf(curve);
    if (!(first < last)) continue;
    if (const double range = last - first; i % 4 > 1) {
      first += (periodic ? drawn(random, -2, 2) : drawn(random, 0, 0.4)) * range;
      last = first + drawn(random, 0.01, 0.6) * range;
    }
    const BSplineCurve ours = clampedCurve(curve, first, last);
    EXPECT_EQ(ours.knots.front(), first);
    EXPECT_EQ(ours.knots.back(), last);
    EXPECT_LE(ours.poles.cwiseAbs().maxCoeff(), curve.poles.cwiseAbs().maxCoeff() * (1 + 1e-15));
    const Reference reference(curve);
    for (int k = 0; k < 4; ++k) {
      const double t = drawn(random, first, last);
      ASSERT_LT((derivatives(ours, t, 0).row(0) - reference.point(t)).norm(),
                1e-12 * curve.poles.cwiseAbs().maxCoeff())
          << i;
    }
  }
}

/// Spans of 1e-9 and 1e-12 mm among long ones, and at both ends.
TEST(KnotCurve, Identity1ShortSpansKeepTheCurve) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 500; ++i) {
    const bool periodic = i % 2 == 0;
    const int degree = 2 + i % 4, spans = periodic ? 6 : 2 * degree + 4;
    KnotCurve curve{degree, {0}, {}, {}, periodic};
    for (int k = 0; k < spans; ++k)
      curve.knots.push_back(curve.knots.back() + (k % 3 == i % 3 ? 1e-9
                                                  : i % 5 == 0   ? 1e-12
                                                                 : 0.5));
    curve.multiplicities.assign(curve.knots.size(), 1);
    curve.poles = test::randomPoles(periodic ? spans : spans - degree, false, random);
    const auto [first, last] = rangeOf(curve);
    const BSplineCurve ours = clampedCurve(curve, first, last);
    EXPECT_EQ(ours.knots.front(), first);
    const Reference reference(curve);
    for (int k = 0; k < 8; ++k) {
      const double t = drawn(random, first, last);
      // What the rounding of the knots of the next turn makes of spans of 1e-12 is theirs.
      ASSERT_LT((derivatives(ours, t, 0).row(0) - reference.point(t)).norm(),
                i % 5 == 0 ? 1e-2 : 1e-5)
          << i;
    }
  }
}

TEST(KnotCurve, Identity2PowersOfTwo) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const KnotCurve curve = randomKnots(1 + i % 6, 1 + i % 5, i % 2 == 0, i % 3 == 0, random);
    const auto [first, last] = rangeOf(curve);
    if (!(first < last)) continue;
    const BSplineCurve ours = clampedCurve(curve, first, last);
    for (const double factor : {0x1p-30, 0x1p-300, 0x1p40}) {
      KnotCurve scaled = curve;
      for (double& knot : scaled.knots) knot *= factor;
      EXPECT_EQ(clampedCurve(scaled, factor * first, factor * last).poles, ours.poles) << i;
    }
  }
}

TEST(KnotCurve, ClampedCurvesComeBackBitByBit) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const int degree = 1 + i % 7;
    KnotCurve curve{
        degree, test::randomBreaks(4, 0.4, random), {degree + 1, 1, degree, 1, degree + 1}, {}};
    curve.poles = test::randomPoles(2 * degree + 3, i % 2 == 0, random);
    EXPECT_EQ(clampedCurve(curve, curve.knots.front(), curve.knots.back()).poles, curve.poles);
  }
}

/// A polygon's poles are its points at the knots: which pole belongs to which knot of a ring.
TEST(KnotCurve, APolygonRunsThroughItsPolesAtItsKnots) {
  std::mt19937_64 random(testSeed());
  const KnotCurve ring{1, {1, 2, 4, 5}, {1, 1, 1, 1}, test::randomPoles(3, false, random), true};
  const BSplineCurve ours = clampedCurve(ring, 1, 5);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(ours.poles.row(i), ring.poles.row(i % 3));
}

TEST(KnotCurve, RefusesWhatIsNoCurve) {
  const KnotCurve ring{2, {0, 1, 2, 3}, {1, 1, 1, 1}, HomogeneousPoles::Ones(3, 4), true};
  const auto refused = [&](auto change, const std::string& part) {
    KnotCurve bad = ring;
    change(bad);
    expectRefused([&] { clampedCurve(bad, 0, 3); }, part);
  };
  EXPECT_EQ(clampedCurve(ring, 0, 3).count(), 5);
  refused([](KnotCurve& c) { c.degree = 0; }, "degree is 0");
  refused([](KnotCurve& c) { c.degree = 26; }, "degree is 26");
  refused([](KnotCurve& c) { c.knots = {}; }, "knots 0, multiplicities 4");
  refused([](KnotCurve& c) { c.knots[2] = 1; }, "knot 2 is 1 after 1");
  refused([](KnotCurve& c) { c.knots[3] = std::numeric_limits<double>::infinity(); },
          "knot 3 is inf");
  refused([](KnotCurve& c) { c.multiplicities[1] = 3; }, "multiplicity 1 is 3: 1 to 2");
  refused([](KnotCurve& c) { c.multiplicities[0] = 2; }, "are 2 and 1");
  refused([](KnotCurve& c) { c.poles = HomogeneousPoles::Ones(4, 4); },
          "poles 4, knots of degree 2 for 3");
  refused([](KnotCurve& c) { c.periodic = false; }, "poles 3, knots of degree 2 for 1");
  refused([](KnotCurve& c) { c.poles(2, 3) = 0; }, "weight 2 is 0");
  expectRefused([&] { clampedCurve(ring, 1, 1); }, "first is 1, last 1");
  expectRefused([&] { clampedCurve(ring, 0, 7); }, "at most two periods");
  expectRefused([&] { clampedCurve(ring, 1e300, 2e300); }, "at most two periods");
  expectRefused([&] { clampedCurve(ring, std::nan(""), 1); }, "first is nan");
}

}  // namespace
}  // namespace seamwright
