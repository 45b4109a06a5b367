// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include <seamwright/core/spline/g2_spline.hpp>
#include <seamwright/core/spline/nu_spline.hpp>

#include "spline_reference.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using Eigen::Index;
using test::complaint;
using test::logUniform;
using test::Real;
using test::Vec;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<double> randomKnots(Index count, double spread, std::mt19937_64& random) {
  std::vector<double> knots = {test::randomVector(random).x()};
  while (static_cast<Index>(knots.size()) < count)
    knots.push_back(knots.back() + logUniform(random, -spread, spread));
  return knots;
}

/// \param low the smallest tension in units of the critical one, -2 (1/h + 1/h).
NuSplineData randomData(Index n, SplineEnds ends, std::mt19937_64& random, double low = 0.9) {
  const bool closed = ends == SplineEnds::Periodic;
  NuSplineData data{test::randomPoints(n + 1, logUniform(random, -2, 3), closed, random),
                    randomKnots(n + 1, 0.7, random),
                    {},
                    ends,
                    test::randomVector(random),
                    test::randomVector(random)};
  const auto critical = [&](Index i) {
    const auto inverse = [&](Index s) { return 2 / (data.knots[s + 1] - data.knots[s]); };
    if (i > 0 && i < n) return inverse(i - 1) + inverse(i);
    return closed ? (inverse(0) + inverse(n - 1)) / 2 : inverse(i == 0 ? 0 : n - 1);
  };
  for (Index i = 0; i <= n; ++i)
    data.nu.push_back(i % 4 == 0 ? 0
                      : i % 4 == 1
                          ? -low * critical(i) * std::generate_canonical<double, 53>(random)
                          : logUniform(random, -2, 3));
  return data;
}

/// The largest difference, relative to the size of the expected ones.
double difference(const Poles& a, const Poles& b) {
  return (a - b).cwiseAbs().maxCoeff() / std::max(b.cwiseAbs().maxCoeff(), 1e-300);
}

double difference(const BezierSpline& a, const BezierSpline& b) {
  return (a.poles - b.poles).cwiseAbs().maxCoeff() / b.poles.leftCols<3>().cwiseAbs().maxCoeff();
}

double length(const NuSplineData& data, Index i) {
  return data.knots[i + 1] - data.knots[i];
}

/// What is left of X''(+) - X''(-) = nu X' at the joint of two segments, relative to its terms.
double jumpLeft(const BezierSpline& spline, const NuSplineData& data, Index before, Index after,
                double nu) {
  const auto a = test::endOf(spline, before), b = test::startOf(spline, after);
  const double g = length(data, before), h = length(data, after);
  const double size = spline.poles.leftCols<3>().cwiseAbs().maxCoeff();
  const double terms =
      24 * size * (1 / (g * g) + 1 / (h * h)) + std::abs(nu) * 6 * size / std::min(g, h);
  const double first = (a.first / g - b.first / h).norm() / (6 * size * (1 / g + 1 / h));
  return std::max(first,
                  (b.second / (h * h) - a.second / (g * g) - nu * b.first / h).norm() / terms);
}

double jumpLeft(const BezierSpline& spline, const NuSplineData& data) {
  const Index n = spline.segments();
  double left = 0;
  for (Index i = 1; i < n; ++i) left = std::max(left, jumpLeft(spline, data, i - 1, i, data.nu[i]));
  if (data.ends == SplineEnds::Periodic)
    left = std::max(left, jumpLeft(spline, data, n - 1, 0, data.nu[0] + data.nu[n]));
  return left;
}

TEST(NuSpline, DerivativesAreThoseOfTheData) {
  for (const auto& c : test::splineCases("nu_splines.json")) {
    const auto& in = c["in"];
    NuSplineData data{test::points(in["P"]), in["u"].get<std::vector<double>>(),
                      in["nu"].get<std::vector<double>>(), test::endsOf(in["bc"])};
    if (data.ends == SplineEnds::Clamped) {
      data.start_derivative = test::vector(in["m0"]);
      data.end_derivative = test::vector(in["mn"]);
    }
    const NuSpline spline = nuSpline(data);
    EXPECT_LT(difference(spline.derivatives, test::points(c["out"]["m"])), 1e-12) << c["name"];
    EXPECT_LT(jumpLeft(spline.curve, data), 1e-15) << c["name"];
    EXPECT_THAT(spline.stationary, ElementsAre()) << c["name"];
    requireValid(spline.curve);
  }
}

TEST(NuSpline, Identity1And2JointsAndEnds) {
  std::mt19937_64 random(testSeed());
  for (int k = 0; k < 3000; ++k) {
    const SplineEnds ends = test::all_ends[k % 3];
    const Index n = (ends == SplineEnds::Periodic ? 2 : 1) + k % 17;
    const NuSplineData data = randomData(n, ends, random);
    const NuSpline result = nuSpline(data);
    BezierSpline spline = result.curve;
    requireValid(spline);
    double condition = 0;
    const auto expected = test::referenceDerivatives(test::conditionsOf(data), &condition);
    ASSERT_LT(difference(result.derivatives, expected.cast<double>()), 1e-14 * condition) << k;
    ASSERT_LT(jumpLeft(spline, data), 2e-15) << k;
    const double size = spline.poles.leftCols<3>().cwiseAbs().maxCoeff();
    const auto start = test::startOf(spline, 0), end = test::endOf(spline, n - 1);
    const double g = length(data, 0), h = length(data, n - 1);
    if (ends == SplineEnds::Clamped) {
      ASSERT_LT((start.first / g - data.start_derivative).norm(), 1e-14 * (size / g + 1));
      ASSERT_LT((end.first / h - data.end_derivative).norm(), 1e-14 * (size / h + 1));
    } else if (ends == SplineEnds::Natural) {
      ASSERT_LT((start.second - data.nu[0] * g * start.first).norm(),
                2e-15 * size * (24 + 6 * std::abs(data.nu[0]) * g));
      ASSERT_LT((end.second + data.nu[n] * h * end.first).norm(),
                2e-15 * size * (24 + 6 * std::abs(data.nu[n]) * h));
    } else {
      ASSERT_EQ(spline.poles.row(0), spline.poles.row(3 * n));
    }
    if (n < 2) continue;
    spline.poles(2, 1) += 1e-6 * size;
    ASSERT_GT(jumpLeft(spline, data), 1e-10) << k;
  }
}

TEST(NuSpline, Identity3WithoutTensionItIsTheC2Spline) {
  std::mt19937_64 random(testSeed());
  for (int k = 0; k < 600; ++k) {
    const SplineEnds ends = test::all_ends[k % 3];
    NuSplineData data = randomData(2 + k % 9, ends, random);
    std::fill(data.nu.begin(), data.nu.end(), 0.0);
    const NuSpline spline = nuSpline(data);
    ASSERT_EQ(bsplineCurve(spline.curve, 2).knots.size(), data.knots.size() + 6) << k;
    data.nu[1] = 1e-3 / length(data, 0);
    ASSERT_THAT(complaint([&] { bsplineCurve(nuSpline(data).curve, 2); }), HasSubstr("invalid: "))
        << k;
    ASSERT_EQ(bsplineCurve(nuSpline(data).curve, 1).degree, 3);
  }
  // A cubic polynomial is its own spline, by its end derivatives.
  NuSplineData cubic{Poles(6, 3), randomKnots(6, 0.7, random), std::vector<double>(6, 0.0),
                     SplineEnds::Clamped};
  for (Index i = 0; i < 6; ++i) {
    const double t = cubic.knots[i];
    cubic.points.row(i) << 1 - t + 2 * t * t * t, t * t - 3, t * t * t + t;
  }
  const auto slope = [](double t) { return Vec(-1 + 6 * t * t, 2 * t, 3 * t * t + 1); };
  cubic.start_derivative = slope(cubic.knots.front());
  cubic.end_derivative = slope(cubic.knots.back());
  const NuSpline spline = nuSpline(cubic);
  for (Index i = 0; i < 6; ++i)
    EXPECT_LT((spline.derivatives.row(i).transpose() - slope(cubic.knots[i])).norm(),
              1e-13 * spline.derivatives.norm());
}

TEST(NuSpline, Identity4ReversedDataGiveTheReversedCurve) {
  std::mt19937_64 random(testSeed());
  for (int k = 0; k < 1000; ++k) {
    const SplineEnds ends = test::all_ends[k % 3];
    const NuSplineData data = randomData(2 + k % 9, ends, random);
    NuSplineData back = data;
    back.points = data.points.colwise().reverse();
    std::reverse(back.knots.begin(), back.knots.end());
    for (double& knot : back.knots) knot = -knot;
    std::reverse(back.nu.begin(), back.nu.end());
    back.start_derivative = -data.end_derivative;
    back.end_derivative = -data.start_derivative;
    double condition = 0;
    test::referenceDerivatives(test::conditionsOf(data), &condition);
    ASSERT_LT(
        difference(-nuSpline(back).derivatives.colwise().reverse(), nuSpline(data).derivatives),
        1e-14 * condition)
        << k;
  }
}

/// The largest distance of 33 points of each segment from its chord.
double fromPolygon(const BezierSpline& spline) {
  double distance = 0;
  for (int i = 0; i < spline.segments(); ++i) {
    const BezierCurve curve = segment(spline, i);
    const Vec a = curve.point(0), chord = (curve.point(1) - a).normalized();
    for (int k = 0; k <= 32; ++k) {
      const Vec from = curve.point(k / 32.0) - a;
      distance = std::max(distance, (from - from.dot(chord) * chord).norm());
    }
  }
  return distance;
}

TEST(NuSpline, Identity5TensionPullsIntoThePolygonAtARateOf1ByNu) {
  std::mt19937_64 random(testSeed());
  for (int k = 0; k < 60; ++k) {
    // Given end derivatives stay as they are; the other ends go to the polygon.
    const SplineEnds ends = k % 2 ? SplineEnds::Natural : SplineEnds::Periodic;
    NuSplineData data = randomData(3 + k % 6, ends, random);
    std::vector<double> distances;
    for (const double nu : {1e4, 1e5, 1e6}) {
      std::fill(data.nu.begin(), data.nu.end(), nu);
      distances.push_back(fromPolygon(nuSpline(data).curve));
    }
    ASSERT_NEAR(distances[0] / distances[1], 10, 0.5) << k;
    ASSERT_NEAR(distances[1] / distances[2], 10, 0.05) << k;
  }
}

TEST(NuSpline, Identity6KnotsAndTensionInOtherUnits) {
  std::mt19937_64 random(testSeed());
  for (int k = 0; k < 1000; ++k) {
    const NuSplineData data = randomData(2 + k % 9, test::all_ends[k % 3], random);
    const double c = logUniform(random, -6, 6);
    NuSplineData other = data;
    for (double& knot : other.knots) knot *= c;
    for (double& nu : other.nu) nu /= c;
    other.start_derivative /= c;
    other.end_derivative /= c;
    double condition = 0;
    test::referenceDerivatives(test::conditionsOf(data), &condition);
    ASSERT_LT(difference(nuSpline(other).curve, nuSpline(data).curve), 1e-14 * condition) << k;
  }
}

TEST(NuSpline, MovesAndScalesWithItsPoints) {
  std::mt19937_64 random(testSeed());
  for (int k = 0; k < 1000; ++k) {
    const NuSplineData data = randomData(2 + k % 9, test::all_ends[k % 3], random);
    const Eigen::Matrix3d turn = logUniform(random, -3, 3) * test::randomRotation(random);
    const Vec shift = data.points.norm() * test::randomVector(random);
    NuSplineData moved = data;
    moved.points = (data.points * turn.transpose()).rowwise() + (turn * shift).transpose();
    if (data.ends == SplineEnds::Periodic) moved.points.bottomRows<1>() = moved.points.row(0);
    moved.start_derivative = turn * data.start_derivative;
    moved.end_derivative = turn * data.end_derivative;
    double condition = 0;
    test::referenceDerivatives(test::conditionsOf(data), &condition);
    const Poles expected = nuSpline(data).derivatives * turn.transpose();
    const double slopes = moved.points.cwiseAbs().maxCoeff() / 0.1;
    ASSERT_LT((nuSpline(moved).derivatives - expected).cwiseAbs().maxCoeff(),
              1e-14 * condition * (slopes + expected.cwiseAbs().maxCoeff()))
        << k;
  }
}

TEST(NuSpline, AGammaSplineIsTheNuSplineOfItsJoints) {
  std::mt19937_64 random(testSeed());
  for (int k = 0; k < 500; ++k) {
    const Index n = 3 + k % 7;
    GammaPolygon polygon{test::randomPoints(n, 1, false, random), true, {}, {}};
    for (Index s = 0; s < n; ++s) {
      polygon.lengths.push_back(logUniform(random, -0.4, 0.4));
      polygon.gamma.push_back(logUniform(random, -1, 0.2));
    }
    const BezierSpline gamma = gammaSpline(polygon);
    NuSplineData data{Poles(n + 1, 3), gamma.knots, std::vector<double>(n + 1, 0.0),
                      SplineEnds::Periodic};
    for (Index i = 0; i <= n; ++i) data.points.row(i) = gamma.poles.row(3 * i).head<3>();
    for (Index s = 0; s < n; ++s)
      data.nu[s] = 2 * (1 / polygon.lengths[s == 0 ? n - 1 : s - 1] + 1 / polygon.lengths[s]) *
                   (1 / polygon.gamma[s] - 1);
    double condition = 0;
    test::referenceDerivatives(test::conditionsOf(data), &condition);
    ASSERT_LT(difference(nuSpline(data).curve, gamma), 1e-13 * condition) << k;
  }
}

TEST(NuSpline, TensionsOfAnySizeKeepTheDigitsOfEveryDerivative) {
  std::mt19937_64 random(testSeed());
  for (int k = 0; k < 3000; ++k) {
    NuSplineData data = randomData(2 + k % 9, test::all_ends[k % 3], random);
    for (double& nu : data.nu)
      if (random() % 2 == 0) nu = logUniform(random, 0, 300) * (random() % 4 == 0 ? -1 : 1);
    double condition = 0;
    const auto expected = test::referenceDerivatives(test::conditionsOf(data), &condition);
    if (condition > 1e4) continue;
    const NuSpline spline = nuSpline(data);
    for (Index i = 0; i < expected.rows(); ++i) {
      const Real size = expected.row(i).norm();
      const Real error = (spline.derivatives.row(i).cast<Real>() - expected.row(i)).norm();
      ASSERT_LT(static_cast<double>(error / size), 1e-14 * condition) << k << ", " << i;
    }
    requireValid(spline.curve);
  }
  NuSplineData largest = randomData(5, SplineEnds::Natural, random);
  std::fill(largest.nu.begin(), largest.nu.end(), std::numeric_limits<double>::max());
  for (double& knot : largest.knots) knot *= 1e6;
  EXPECT_TRUE(nuSpline(largest).derivatives.isZero(0))
      << "tension times length beyond the range of numbers";
}

TEST(NuSpline, CriticalTensionIsSingularAndBeyondItIsSolved) {
  using ::testing::ContainsRegex;
  std::mt19937_64 random(testSeed());
  for (const Index n : {2, 4, 6, 50}) {
    NuSplineData data{test::randomPoints(n + 1, 1, true, random), {}, {}, SplineEnds::Periodic};
    for (Index i = 0; i <= n; ++i) data.knots.push_back(static_cast<double>(i));
    data.nu.assign(n + 1, -4.0);
    data.nu.back() = 0;
    EXPECT_THAT(complaint([&] { nuSpline(data); }),
                ContainsRegex("domain: the " + std::to_string(n) +
                              " equations are singular: pivot [0-9]+ is "));
    for (const double nu : {-3.9, -4.1, -7.3}) {
      data.nu.assign(n + 1, nu);
      data.nu.back() = 0;
      double condition = 0;
      const auto expected = test::referenceDerivatives(test::conditionsOf(data), &condition);
      if (condition > 1e6) continue;
      EXPECT_LT(difference(nuSpline(data).derivatives, expected.cast<double>()), 1e-14 * condition)
          << n;
    }
  }
  NuSplineData pair{test::randomPoints(2, 1, false, random), {0, 2}, {-1, -1}, SplineEnds::Natural};
  EXPECT_THAT(complaint([&] { nuSpline(pair); }),
              HasSubstr("domain: the 2 equations are singular"));
  for (int k = 0; k < 2000; ++k) {
    const NuSplineData data = randomData(2 + k % 9, test::all_ends[k % 3], random, 3);
    double condition = 0;
    const auto expected = test::referenceDerivatives(test::conditionsOf(data), &condition);
    if (condition > 1e8) continue;
    ASSERT_LT(difference(nuSpline(data).derivatives, expected.cast<double>()), 1e-14 * condition)
        << k;
  }
}

TEST(NuSpline, WhereTheDerivativeVanishesG2IsLost) {
  // G2 at every point is claimed in print (docs/theory/curves.md C6.4). With these end derivatives
  // X' vanishes in the middle.
  NuSplineData data{Poles(3, 3), {0, 1, 2}, {0, 3, 0}, SplineEnds::Clamped};
  data.points << 5, 5, 5, 1, 2, 3, 4, -4, 0.5;
  const Vec sum = 3 * (data.points.row(2) - data.points.row(0)).transpose();
  data.start_derivative = Vec(1, 2, 0.5);
  data.end_derivative = sum - data.start_derivative;
  const NuSpline spline = nuSpline(data);
  EXPECT_THAT(spline.stationary, ElementsAre(1));
  EXPECT_LT(jumpLeft(spline.curve, data), 1e-15) << "it is a nu-spline all the same";
  EXPECT_LT(orderReached(measureJoints(spline.curve, 2)[0], {}), 1);
  data.end_derivative *= 1 + 1e-6;
  const NuSpline other = nuSpline(data);
  EXPECT_THAT(other.stationary, ElementsAre());
  EXPECT_EQ(orderReached(measureJoints(other.curve, 2)[0], {}), 2);

  NuSplineData back{
      Poles(5, 3), {0, 1, 2, 3, 4}, std::vector<double>(5, 1.0), SplineEnds::Periodic};
  back.points << 0, 0, 0, 1, 2, 3, 4, -4, 0.5, 1, 2, 3, 0, 0, 0;
  EXPECT_THAT(nuSpline(back).stationary, ElementsAre(0, 2, 4)) << "it runs to and fro";

  NuSplineData tight{Poles(3, 3), {0, 1, 2}, {0, 1e18, 0}, SplineEnds::Natural};
  tight.points << 1, 1, 1, 2, 3, 4, 3, 3, 5;
  EXPECT_THAT(nuSpline(tight).stationary, ElementsAre(1)) << "the poles beside it are the point";
  tight.nu[1] = 1e9;
  EXPECT_THAT(nuSpline(tight).stationary, ElementsAre());
}

TEST(NuSpline, RandomOnesAreG2) {
  std::mt19937_64 random(testSeed());
  int joints = 0, lost = 0;
  for (int k = 0; k < 500; ++k) {
    NuSplineData data = randomData(3 + k % 9, test::all_ends[k % 3], random);
    for (const CurveJoint& joint : measureJoints(nuSpline(data).curve, 2)) {
      ASSERT_EQ(orderReached(joint, {}), 2) << k;
      ++joints;
    }
    NuSpline spoilt = nuSpline(data);
    spoilt.curve.poles(1, 0) += 0.1 * data.points.cwiseAbs().maxCoeff();
    lost += orderReached(measureJoints(spoilt.curve, 2)[0], {}) < 2;
  }
  EXPECT_GT(joints, 3000);
  EXPECT_GT(lost, 450) << "the others are flat there";
}

TEST(NuSpline, KnotsArePowersOfTheChords) {
  Poles points(4, 3);
  points << 0, 0, 0, 3, 4, 0, 3, 4, 16, 3, 4, 15;
  EXPECT_THAT(knotsOf(points, 0), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(knotsOf(points, 1), ElementsAre(0, 5, 21, 22));
  EXPECT_THAT(knotsOf(points),
              ElementsAre(0, std::sqrt(5.0), std::sqrt(5.0) + 4, std::sqrt(5.0) + 5));
  points.row(2) = points.row(1);
  EXPECT_THAT(knotsOf(points, 0), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(complaint([&] { knotsOf(points); }),
              HasSubstr("points 1 and 2 are the same: exponent is 0.5"));
  EXPECT_THAT(complaint([&] { knotsOf(points, 1.5); }), HasSubstr("exponent is 1.5"));
  EXPECT_THAT(complaint([&] { knotsOf(points, std::nan("")); }), HasSubstr("exponent is nan"));
  points.row(2) << 3, 4, 1e20;
  points.row(3) << 4, 4, 1e20;
  EXPECT_THAT(complaint([&] { knotsOf(points, 1); }), HasSubstr("knot 3 is "));
  points(3, 1) = std::nan("");
  EXPECT_THAT(complaint([&] { knotsOf(points); }), HasSubstr("point 3 is (4, nan, "));
  EXPECT_TRUE(knotsOf(Poles(0, 3)).empty());
}

TEST(NuSpline, BadInputIsNamed) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  std::mt19937_64 random(testSeed());
  const NuSplineData good = randomData(4, SplineEnds::Clamped, random);
  const auto of = [&](const std::function<void(NuSplineData&)>& spoil) {
    NuSplineData data = good;
    spoil(data);
    return complaint([&] { nuSpline(data); });
  };
  EXPECT_EQ(of([](NuSplineData&) {}), "accepted");
  EXPECT_EQ(of([](NuSplineData& d) { d.points.conservativeResize(1, 3); }),
            "invalid: points 1: at least 2 are needed");
  EXPECT_THAT(of([](NuSplineData& d) {
                d.ends = SplineEnds::Periodic;
                d.points.conservativeResize(2, 3);
              }),
              HasSubstr("points 2: at least 3"));
  EXPECT_EQ(of([](NuSplineData& d) { d.knots.pop_back(); }),
            "invalid: knot has 4 numbers for 5 points");
  EXPECT_EQ(of([](NuSplineData& d) { d.nu.push_back(1); }),
            "invalid: nu has 6 numbers for 5 points");
  EXPECT_THAT(of([](NuSplineData& d) { d.knots[2] = d.knots[1]; }),
              HasSubstr("invalid: knot 2 is "));
  EXPECT_THAT(of([&](NuSplineData& d) { d.knots[3] = nan; }), HasSubstr("knot 3 is nan"));
  EXPECT_THAT(of([&](NuSplineData& d) { d.nu[4] = infinity; }), HasSubstr("nu 4 is inf"));
  EXPECT_THAT(of([&](NuSplineData& d) { d.points(1, 2) = nan; }), HasSubstr("point 1 is ("));
  EXPECT_THAT(of([](NuSplineData& d) { d.points.row(3) = d.points.row(2); }),
              ::testing::ContainsRegex("points 2 and 3, .* are the same"));
  EXPECT_THAT(of([](NuSplineData& d) {
                d.points(2, 0) = 1.5e308;
                d.points(3, 0) = -1.5e308;
              }),
              ::testing::ContainsRegex("points 2 and 3, .*1.5.*, are too far apart"));
  EXPECT_THAT(of([](NuSplineData& d) { d.ends = SplineEnds::Periodic; }),
              HasSubstr("point 4 is ("));
  EXPECT_THAT(of([&](NuSplineData& d) { d.start_derivative(1) = nan; }),
              HasSubstr("start_derivative is ("));
  EXPECT_THAT(of([&](NuSplineData& d) { d.end_derivative(0) = infinity; }),
              HasSubstr("end_derivative is (inf"));
  EXPECT_THAT(of([&](NuSplineData& d) {
                d.knots = {0, 1e-310, 2e-310, 3e-310, 4e-310};
              }),
              HasSubstr("invalid: "));
}

TEST(NuSpline, KnotsWhoseRangeIsNoNumberAreRefused) {
  NuSplineData data{Poles(5, 3), {-1e308, -1e307, 0, 1e307, 1e308}, std::vector<double>(5, 0.0)};
  data.points << 0, 0, 0, 1, 2, 3, 4, -4, 0.5, 1, 2, 4, 0, 0, 1;
  EXPECT_THAT(complaint([&] { nuSpline(data); }), HasSubstr("the knots range over inf"));
  data.knots = {0, 1e-310, 2e-310, 3e-310, 4e-310};
  EXPECT_THAT(complaint([&] { nuSpline(data); }), HasSubstr("the knots range over 3.99"));
}

/// A point is stationary by one side alone: its segment before, or after, is so short that the pole
/// is lost.
TEST(NuSpline, StationaryByOneSideAlone) {
  for (const bool before : {true, false}) {
    NuSplineData data{Poles(3, 3), {0, 1, 2}, {0, 0, 0}, SplineEnds::Clamped};
    data.points << 1, 1, 1, 2, 3, 4, 3, 3, 5;
    // At an end there is one side only; the derivative, 1e-15, is far above its own noise.
    (before ? data.end_derivative : data.start_derivative) = Vec::Constant(1e-15);
    (before ? data.start_derivative : data.end_derivative) = Vec(1, 2, 3);
    EXPECT_THAT(nuSpline(data).stationary, ElementsAre(before ? 2 : 0));
  }
}

}  // namespace
}  // namespace seamwright
