// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/fair/function_spline.hpp>

#include "planar.hpp"

namespace seamwright {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;
using test::number;
using test::uniform;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// Points of a wave with noise in y; \p spread is the largest move of x against an equal spacing.
FunctionPoints noisyWave(Index count, double noise_mm, double spread, std::mt19937_64& random) {
  FunctionPoints points(count, 2);
  for (Index i = 0; i < count; ++i) {
    const double x = double(i) + uniform(random, -spread, spread);
    points.row(i) << x, 5 * std::sin(0.15 * x) + uniform(random, -noise_mm, noise_mm);
  }
  return points;
}

FunctionSpline noisySpline(Index count, double noise_mm, bool clamped, std::mt19937_64& random) {
  const FunctionPoints points = noisyWave(count, noise_mm, 0.3, random);
  if (!clamped) return functionSpline(points);
  return functionSpline(points, EndSlopes{.start = 0.75, .end = uniform(random, -1, 1)});
}

double largestDistance_mm(const FunctionSpline& a, const FunctionSpline& b) {
  const auto x = a.points.col(0);
  const double from = x(0), to = x(x.size() - 1);
  double largest = 0;
  for (int i = 0; i <= 2000; ++i) {
    const double at = from + (to - from) * i / 2000;
    largest = std::max(largest, std::abs(derivatives(a, at)(0) - derivatives(b, at)(0)));
  }
  return largest;
}

double bending(const FunctionSpline& spline) {
  return fairnessOf(spline).bending_per_mm;
}

bool same(const FunctionSpline& a, const FunctionSpline& b) {
  return a.points == b.points && a.slopes == b.slopes && a.second_per_mm == b.second_per_mm;
}

FunctionSpline splineOf(const nlohmann::json& in) {
  FunctionPoints points(Index(in["x"].size()), 2);
  for (std::size_t i = 0; i < in["x"].size(); ++i)
    points.row(Index(i)) << number(in["x"][i]), number(in["y"][i]);
  if (in["bc"] == "natural") return functionSpline(points);
  return functionSpline(points, EndSlopes{.start = number(in["y0p"]), .end = number(in["ynp"])});
}

void expectNear(const VectorXd& found, const nlohmann::json& wanted) {
  ASSERT_EQ(std::size_t(found.size()), wanted.size());
  for (Index i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found(i), number(wanted[std::size_t(i)]), 1e-11 * (1 + std::abs(found(i)))) << i;
}

// Identity (3), and the figures of all methods.
TEST(FunctionSpline, AgreesWithHighPrecision) {
  for (const nlohmann::json& entry : test::splineCases("function_splines.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const nlohmann::json &in = entry["in"], &out = entry["out"];
    const FunctionSpline spline = splineOf(in);
    expectNear(spline.second_per_mm, out["M"]);
    expectNear(thirdJumps_per_mm2(spline), out["jump3"]);
    const Index j = in["j"].get<Index>();
    EXPECT_NEAR(correctedAt(spline, j).points(j, 1), number(out["y_j_faired"]), 1e-11);
    expectNear(rebounded(spline).points.col(1), out["rebound_full"]);
    const VectorXd poles = polishedPoles(spline.points.col(1), in["steps"].get<int>());
    expectNear(poles, out["polish"]);
    VectorXd nodes(poles.size() - 2);
    for (Index i = 0; i < nodes.size(); ++i)
      nodes(i) = (poles(i) + 4 * poles(i + 1) + poles(i + 2)) / 6;
    expectNear(nodes, out["polish_nodes"]);
  }
}

// Identity (1).
TEST(FunctionSpline, IsSmoothAndMeetsItsEnds) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 40; ++i) {
    const bool clamped = i % 2 == 0;
    const FunctionSpline spline = noisySpline(2 + Index(random() % 30), 2, clamped, random);
    const FunctionPoints& p = spline.points;
    const Index last = p.rows() - 1;
    for (Index k = 1; k < last; ++k) {
      const Eigen::Vector4d at = derivatives(spline, p(k, 0));
      const Eigen::Vector4d before = derivatives(spline, std::nextafter(p(k, 0), -1e9));
      EXPECT_LT((at - before).head<3>().norm(), 1e-11);
      EXPECT_NEAR(at(3) - before(3), thirdJumps_per_mm2(spline)(k - 1), 1e-10);
      EXPECT_EQ(at(0), p(k, 1));
    }
    const Eigen::Vector4d start = derivatives(spline, p(0, 0)),
                          end = derivatives(spline, p(last, 0));
    if (clamped) {
      EXPECT_NEAR(start(1), spline.slopes->start, 1e-13);
      EXPECT_NEAR(end(1), spline.slopes->end, 1e-12);
    } else {
      EXPECT_EQ(start(2), 0);
      EXPECT_NEAR(end(2), 0, 1e-13);
    }
  }
}

// Identity (2).
TEST(FunctionSpline, IsACurve) {
  std::mt19937_64 random(testSeed());
  for (const bool clamped : {true, false}) {
    const FunctionSpline spline = noisySpline(12, 2, clamped, random);
    const BSplineCurve curve = bsplineCurve(spline);
    for (int i = 0; i <= 200; ++i) {
      const double x = curve.knots.front() + (curve.knots.back() - curve.knots.front()) * i / 200;
      const CurveDerivatives at = derivatives(curve, x, 2);
      const Eigen::Vector4d wanted = derivatives(spline, x);
      EXPECT_NEAR(at(0, 0), x, 1e-13);
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(at(k, 1), wanted(k), 1e-12);
    }
  }
}

// Identity (3).
TEST(FunctionSpline, ACorrectedPointHasNoJump) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 50; ++i) {
    const FunctionSpline spline = noisySpline(200, 0.5, i % 2 == 0, random);
    const Index j = 1 + Index(random() % 198);
    const FunctionSpline found = correctedAt(spline, j);
    EXPECT_NEAR(thirdJumps_per_mm2(found)(j - 1), 0, 1e-12);
    for (Index k = 0; k < 200; ++k) EXPECT_EQ(found.points(k, 1) == spline.points(k, 1), k != j);
    EXPECT_NEAR(std::abs(correctedAt(spline, j, 1e-3).points(j, 1) - spline.points(j, 1)), 1e-3,
                1e-12);
  }
}

void expectFaired(const FunctionSpline& spline, const FairedFunction& found, double tolerance_mm) {
  EXPECT_LE(found.moved_mm, tolerance_mm);
  EXPECT_LE(largestDistance_mm(spline, found.spline), found.moved_mm);
  EXPECT_GE(largestDistance_mm(spline, found.spline), 0.5 * found.moved_mm);
  EXPECT_EQ(found.spline.points.col(0), spline.points.col(0));
  EXPECT_EQ(found.spline.points.row(0), spline.points.row(0));
  EXPECT_EQ(found.spline.points.bottomRows(1), spline.points.bottomRows(1));
  EXPECT_EQ(found.spline.slopes, spline.slopes);
  EXPECT_EQ(found.before.bending_per_mm, bending(spline));
  EXPECT_EQ(found.after.bending_per_mm, bending(found.spline));
}

// Identity (4).
TEST(FairFunction, CorrectionsLowerTheBendingWithinTheTolerance) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 20; ++i) {
    const FunctionSpline spline = noisySpline(60, 0.02, i % 2 == 0, random);
    const double tolerance = std::exp(uniform(random, -9, -3));
    const FairedFunction found = correctFunction(spline, tolerance);
    expectFaired(spline, found, tolerance);
    EXPECT_LT(found.after.bending_per_mm, found.before.bending_per_mm);
    if (tolerance > 0.03) {
      EXPECT_LT(found.after.jumps_per_mm2, found.before.jumps_per_mm2);
    }
    EXPECT_TRUE(same(correctFunction(spline, 0).spline, spline));
  }
}

// Identity (5): the steps per point and the neighbours that they change do not grow.
TEST(FairFunction, CorrectionsAreLinear) {
  std::mt19937_64 random(testSeed());
  for (const Index count : {200, 3200}) {
    const FairedFunction found = correctFunction(noisySpline(count, 0.02, false, random), 0.05);
    EXPECT_LE(found.steps, max_correction_rounds * count);
    EXPECT_GT(found.steps, count);
  }
}

// Identity (6).
TEST(FairFunction, ReboundsLowerTheBendingWithinTheTolerance) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 20; ++i) {
    const FunctionSpline spline = noisySpline(60, 0.02, i % 2 == 0, random);
    const double tolerance = std::exp(uniform(random, -9, -3));
    const FairedFunction found = reboundFunction(spline, tolerance);
    expectFaired(spline, found, tolerance);
    EXPECT_LT(found.after.bending_per_mm, found.before.bending_per_mm);
    EXPECT_GE(found.steps, 1);
    if (found.steps < 3) {
      EXPECT_GT(found.moved_mm, 0.9 * tolerance);
    }
    EXPECT_TRUE(same(reboundFunction(spline, 0).spline, spline));
    EXPECT_TRUE(same(reboundFunction(spline, 1, {.most_rebounds = 0}).spline, spline));
  }
  const FunctionSpline few = noisySpline(5, 1, false, random);
  const FairedFunction line = reboundFunction(few, 1e3, {.most_rebounds = 3000});
  EXPECT_LT(line.after.bending_per_mm, 1e-2 * line.before.bending_per_mm);
}

// Identities (7) and (8).
TEST(FairFunction, PolishingIsALowPass) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 20; ++i) {
    const FunctionSpline spline = functionSpline(noisyWave(60, 0.02, 0, random));
    const double tolerance = std::exp(uniform(random, -12, -3));
    const FairedFunction found = polishFunction(spline, tolerance);
    expectFaired(spline, found, tolerance);
    EXPECT_LT(found.after.bending_per_mm, found.before.bending_per_mm);
    EXPECT_TRUE(same(polishFunction(spline, 0).spline, spline));
  }
  // Waves that vanish at the ends are eigenvectors.
  for (const int waves : {1, 7, 19}) {
    VectorXd y(21);
    for (Index i = 0; i < 21; ++i) y(i) = std::sin(pi * waves * double(i) / 20);
    const VectorXd poles = polishedPoles(y, 3);
    const double missed = std::pow((1 - std::cos(pi * waves / 20)) / 3, 4);
    for (Index i = 1; i < 20; ++i)
      EXPECT_NEAR((poles(i - 1) + 4 * poles(i) + poles(i + 1)) / 6, (1 - missed) * y(i), 1e-14);
  }
}

TEST(FairFunction, LinesStayAndNoiseLosesItsExtrema) {
  std::mt19937_64 random(testSeed());
  FunctionPoints line = noisyWave(30, 0, 0.2, random), uniform_line = noisyWave(30, 0, 0, random);
  line.col(1) = 0.25 * line.col(0);
  uniform_line.col(1) = 0.25 * uniform_line.col(0);
  EXPECT_LT(correctFunction(functionSpline(line), 1).moved_mm, 1e-12);
  EXPECT_LT(reboundFunction(functionSpline(line), 1).moved_mm, 1e-12);
  EXPECT_LT(polishFunction(functionSpline(uniform_line), 1).moved_mm, 1e-12);
  const FunctionSpline spline = functionSpline(noisyWave(80, 0.01, 0, random));
  for (const FairedFunction& found : {correctFunction(spline, 0.03), reboundFunction(spline, 0.03),
                                      polishFunction(spline, 0.03)}) {
    EXPECT_LT(found.after.curve.inflections, found.before.curve.inflections);
    EXPECT_EQ(found.addedInflections(), 0);
    EXPECT_EQ(found.addedExtrema(),
              std::max(0, found.after.curve.extrema + found.after.curve.extrema_at_knots -
                              found.before.curve.extrema - found.before.curve.extrema_at_knots));
  }
}

TEST(FairFunction, RefusesInvalidNumbers) {
  std::mt19937_64 random(testSeed());
  const auto refused = [](const auto& call, const char* text) {
    EXPECT_THAT(call, ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
  };
  FunctionPoints points = noisyWave(9, 0.1, 0, random);
  const FunctionSpline spline = functionSpline(points);
  for (const double bad : {-1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
    refused([&] { correctFunction(spline, bad); }, "the tolerance is");
    refused([&] { reboundFunction(spline, bad); }, "the tolerance is");
    refused([&] { polishFunction(spline, bad); }, "the tolerance is");
  }
  refused([&] { correctedAt(spline, 0); }, "point 0 of 9");
  refused([&] { correctedAt(spline, 8); }, "point 8 of 9");
  refused([&] { correctedAt(spline, 3, -1); }, "the limit is -1 mm");
  refused([&] { reboundFunction(spline, 1, {.most_rebounds = -1}); }, "-1 rebounds");
  refused([&] { polishFunction(functionSpline(points, EndSlopes{}), 1); }, "slopes");
  refused([&] { polishedPoles(points.col(1), -1); }, "-1 steps");
  refused([&] { functionSpline(points, EndSlopes{NAN, 0}); }, "the slopes");
  refused([&] { functionSpline(points.topRows(1)); }, "1 points make no spline");
  points(4, 0) += 0.1;
  refused([&] { polishFunction(functionSpline(points), 1); },
          "point 4 is 1.0999999999999996 mm after");
  points(4, 0) = points(3, 0);
  refused([&] { functionSpline(points); }, "point 4 has x = 3 mm after 3 mm");
  points(4, 1) = NAN;
  refused([&] { functionSpline(points); }, "point 4 is (3, nan)");
}

}  // namespace
}  // namespace seamwright
