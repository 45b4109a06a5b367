// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <seamwright/core/surface/judge.hpp>
#include <seamwright/core/surface/measure.hpp>

#include "support/random.hpp"

namespace seamwright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> randomValues(std::mt19937& random, std::size_t count) {
  std::normal_distribution<double> step(0, 1);
  std::vector<double> values = {step(random)};
  while (values.size() < count) values.push_back(values.back() + step(random));
  return values;
}

std::vector<double> wave(int places, double amplitude, double waves, double offset = 0) {
  std::vector<double> values;
  for (int k = 0; k < places; ++k)
    values.push_back(offset +
                     amplitude * std::sin(2 * std::numbers::pi * waves * k / (places - 1)));
  return values;
}

void expectSame(const LineVariation& a, const LineVariation& b, double factor = 1) {
  EXPECT_NEAR(factor * a.total, b.total, 1e-12 * (1 + b.total));
  EXPECT_EQ(a.extrema, b.extrema);
  EXPECT_EQ(a.inflections, b.inflections);
}

TEST(LineVariation, Law1MonotoneSequences) {
  const std::vector<double> values = {-3, -1, -1, 0.5, 4, 4.5};
  for (const double noise : {0.0, 0.1, 1.0, 10.0}) {
    const LineVariation line = variationOf(values, noise);
    EXPECT_DOUBLE_EQ(line.total, 7.5);
    EXPECT_EQ(line.extrema, 0);
  }
}

TEST(LineVariation, Laws2To4Reversal_Constants_Scale) {
  std::mt19937 random(testSeed());
  for (int trial = 0; trial < 200; ++trial) {
    const std::vector<double> values = randomValues(random, 1 + trial % 60);
    const double noise = 0.1 * (trial % 20);
    const LineVariation line = variationOf(values, noise);
    std::vector<double> other = values;
    std::ranges::reverse(other);
    expectSame(line, variationOf(other, noise));
    for (double& value : other) value = -value;
    expectSame(line, variationOf(other, noise));
    for (double& value : other) value *= -8;
    expectSame(line, variationOf(other, 8 * noise), 8);
    for (double& value : other) value = value / 8 + 5;
    const LineVariation shifted = variationOf(other, noise);
    EXPECT_NEAR(shifted.total, line.total, 1e-11 * (1 + line.total));
  }
}

TEST(LineVariation, Law3ConstantsKeepExtrema) {
  // Values of few bits, so that the shift rounds nothing.
  std::mt19937 random(testSeed());
  std::uniform_int_distribution<int> integer(-20, 20);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<double> values(40);
    for (double& value : values) value = integer(random);
    const LineVariation line = variationOf(values, 3);
    for (double& value : values) value += 64;
    EXPECT_EQ(variationOf(values, 3).extrema, line.extrema);
    EXPECT_EQ(variationOf(values, 3).total, line.total);
    EXPECT_EQ(variationOf(values, 3).inflections, 0);
  }
}

TEST(LineVariation, Law5WavesWithinTheNoise) {
  std::mt19937 random(testSeed());
  std::uniform_real_distribution<double> noise(-0.5, 0.5);
  std::vector<double> values = wave(400, 10, 1.5);
  const LineVariation clean = variationOf(values, 1);
  EXPECT_EQ(clean.extrema, 3);
  EXPECT_EQ(clean.inflections, 2);
  for (double& value : values) value += noise(random);
  const LineVariation noisy = variationOf(values, 1);
  EXPECT_EQ(noisy.extrema, 3);
  EXPECT_EQ(noisy.inflections, 2);
  EXPECT_GT(noisy.total, 1.5 * clean.total);
}

TEST(LineVariation, CountsOfWavesAreThoseOfTheFormula) {
  for (const int waves : {1, 2, 7}) {
    const LineVariation line = variationOf(wave(64 * waves + 1, 2, waves), 0.1);
    EXPECT_NEAR(line.total, 8.0 * waves, 0.01 * waves);
    EXPECT_EQ(line.extrema, 2 * waves);
    EXPECT_EQ(line.inflections, 2 * waves - 1);
    const LineVariation raised = variationOf(wave(64 * waves + 1, 2, waves, 3), 0.1);
    EXPECT_EQ(raised.extrema, 2 * waves);
    EXPECT_EQ(raised.inflections, 0);
  }
}

TEST(SurfaceMeasure, EmptyAndNotFinite) {
  EXPECT_EQ(variationOf({}, 0).total, 0);
  EXPECT_EQ(measureSurface({}, 0).lines, 0);
  const CurvatureLine short_line{{1}, {1}},
      holes{{1, nan, 2, infinity, 1}, {1, nan, -1, -infinity, 1}};
  const std::vector<CurvatureLine> lines = {short_line, holes};
  const SurfaceMeasure measure = measureSurface(lines, 0.1);
  EXPECT_EQ(measure.lines, 1);
  EXPECT_DOUBLE_EQ(measure.variation_per_mm, 2);
  EXPECT_EQ(measure.extrema, 1);
  EXPECT_EQ(measure.inflections, 2);
}

TEST(SurfaceMeasure, MeanAndLargestOfLines) {
  const std::vector<CurvatureLine> lines = {{{0, 1}, {1, 1}}, {{0, 1, 0, 1}, {-1, 1, -1, 1}}};
  const SurfaceMeasure measure = measureSurface(lines, 0.1);
  EXPECT_DOUBLE_EQ(measure.variation_per_mm, 2);
  EXPECT_DOUBLE_EQ(measure.largest_variation_per_mm, 3);
  EXPECT_EQ(measure.extrema, 2);
  EXPECT_EQ(measure.inflections, 3);
}

/// Height z = (a x^2 + 2 b x y + c y^2) / 2 over the plane, at its apex.
SurfaceJet paraboloid(double a, double b, double c) {
  SurfaceJet jet;
  jet.u = {1, 0, 0};
  jet.v = {0, 1, 0};
  jet.uu = {0, 0, a};
  jet.uv = {0, 0, b};
  jet.vv = {0, 0, c};
  return jet;
}

TEST(SurfaceChange, PartsOfMovesTurnsAndCurvatures) {
  SurfaceJet after = paraboloid(3, 0, 1);
  after.p = {3, 4, -2};
  SurfaceChange change;
  include(change, curvedPoint(paraboloid(1, 0, 1)), curvedPoint(after));
  EXPECT_DOUBLE_EQ(change.normal_move_mm, 2);
  EXPECT_DOUBLE_EQ(change.tangential_move_mm, 5);
  EXPECT_DOUBLE_EQ(change.move_mm.lower, std::sqrt(29.0));
  EXPECT_DOUBLE_EQ(change.turn_rad, 0);
  EXPECT_DOUBLE_EQ(change.curvature_change_per_mm, 2);
  // The largest counts.
  include(change, curvedPoint(paraboloid(0, 0, 0)), curvedPoint(paraboloid(0, 0.5, 0)));
  EXPECT_DOUBLE_EQ(change.curvature_change_per_mm, 2);
  EXPECT_DOUBLE_EQ(change.normal_move_mm, 2);
}

/// A turned copy of a surface has its curvature: what remains is the turn.
TEST(SurfaceChange, TurnsAreNotTakenForCurvature) {
  std::mt19937 random(testSeed());
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 100; ++trial) {
    const SurfaceJet before = paraboloid(number(random), number(random), number(random));
    const double angle = 0.3 * number(random);
    const Eigen::Vector3d axis = Eigen::Vector3d(number(random), number(random), 0).normalized();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    SurfaceJet after = before;
    for (Eigen::Vector3d* part : {&after.u, &after.v, &after.uu, &after.uv, &after.vv})
      *part = turn * *part;
    SurfaceChange change;
    include(change, curvedPoint(before), curvedPoint(after));
    EXPECT_NEAR(change.turn_rad, std::abs(angle), 1e-12);
    EXPECT_NEAR(change.curvature_change_per_mm, 0, 1e-12);
  }
}

TEST(SurfaceChange, DegenerateAndNotFinitePlaces) {
  SurfaceChange change;
  SurfaceJet broken = paraboloid(1, 0, 0);
  broken.p.x() = nan;
  include(change, curvedPoint(paraboloid(0, 0, 0)), curvedPoint(broken));
  EXPECT_EQ(change.move_mm.upper, 0);
  SurfaceJet pole = paraboloid(1, 0, 0);
  pole.u.setZero();
  pole.p.z() = 3;
  include(change, curvedPoint(pole), curvedPoint(paraboloid(5, 5, 5)));
  EXPECT_DOUBLE_EQ(change.move_mm.lower, 3);
  EXPECT_EQ(change.turn_rad, 0);
  EXPECT_EQ(change.curvature_change_per_mm, 0);
}

SurfaceChange changed(double before, double after, int inflections_before = 0,
                      int inflections_after = 0) {
  SurfaceChange change;
  change.before.variation_per_mm = before;
  change.after.variation_per_mm = after;
  change.before.inflections = inflections_before;
  change.after.inflections = inflections_after;
  change.before.lines = change.after.lines = 40;
  return change;
}

TEST(SurfaceJudge, JudgesVariationAndInflectionsApart) {
  const SurfaceTolerance tolerance{1.5, 0.1};
  EXPECT_EQ(judgeSurface(changed(2, 3.1), tolerance), SurfaceFault::None);
  EXPECT_EQ(judgeSurface(changed(2, 3.2), tolerance), SurfaceFault::Variation);
  EXPECT_EQ(judgeSurface(changed(0, 0.1), tolerance), SurfaceFault::None);
  EXPECT_EQ(judgeSurface(changed(0, 0.11), tolerance), SurfaceFault::Variation);
  // A fifth of the 40 lines may have one more.
  EXPECT_EQ(judgeSurface(changed(1, 1, 5, 13), tolerance), SurfaceFault::None);
  EXPECT_EQ(judgeSurface(changed(1, 1, 5, 14), tolerance), SurfaceFault::Inflections);
  EXPECT_EQ(judgeSurface(changed(1, nan), tolerance), SurfaceFault::Variation);
}

TEST(SurfaceJudge, LargerTolerancesAcceptMore) {
  std::mt19937 random(testSeed());
  int accepted = 0;
  std::uniform_real_distribution<double> number(0, 4);
  for (int trial = 0; trial < 200; ++trial) {
    const SurfaceChange change = changed(number(random), number(random));
    const double fairness = 1 + number(random), visible = number(random);
    if (judgeSurface(change, {fairness, visible}) != SurfaceFault::None) continue;
    ++accepted;
    EXPECT_EQ(judgeSurface(change, {fairness + number(random), visible}), SurfaceFault::None);
    EXPECT_EQ(judgeSurface(change, {fairness, visible + number(random)}), SurfaceFault::None);
  }
  EXPECT_GT(accepted, 20);
}

TEST(SurfaceJudge, RefusesBadTolerances) {
  for (const double fairness : {0.99, -1.0, nan})
    EXPECT_THROW((SurfaceTolerance{fairness, 0}).validate(), std::invalid_argument);
  EXPECT_THROW((SurfaceTolerance{infinity, 0}).validate(), std::invalid_argument);
  for (const double visible : {-1e-9, infinity, nan})
    EXPECT_THROW((SurfaceTolerance{1.5, visible}).validate(), std::invalid_argument);
}

/// The profile x (1 - x / w)^2 of unit slope, which bends least: its second derivative by
/// differences.
TEST(SurfaceJudge, VisibleVariationIsWhatTheFairestTurnCosts) {
  const double width = 20;
  ContinuityTolerance tolerance;
  tolerance.angle_rad = 0.002;
  const auto height = [&](double x) {
    return tolerance.angle_rad * x * (1 - x / width) * (1 - x / width);
  };
  std::vector<double> mean;
  constexpr int places = 2000;
  const double h = width / places;
  for (int k = 1; k < places; ++k)
    mean.push_back(0.5 * (height((k - 1) * h) - 2 * height(k * h) + height((k + 1) * h)) / (h * h));
  EXPECT_NEAR(variationOf(mean, 0).total, visibleVariation(tolerance.angle_rad, width),
              0.01 * visibleVariation(tolerance.angle_rad, width));
}

}  // namespace
}  // namespace seamwright
