// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <numbers>
#include <seamwright/core/seam/survey.hpp>

#include "support/random.hpp"
#include "surfaces.hpp"

namespace seamwright {
namespace {

using testing::HasSubstr;

const std::vector<double> whole = {0, 1};

/// A pair that has the given figures; curvature norms are 1 per mm.
PairMeasure pairWith(double t, double gap_mm, double angle_rad, double difference_per_mm = 0) {
  PairMeasure pair;
  pair.point = {t, 0, 0};
  pair.gap_mm = gap_mm;
  pair.angle_rad = angle_rad;
  pair.curvature = CurvatureDifference{difference_per_mm, 1, 1};
  return pair;
}

TEST(Survey, FindsSmoothMaximaWithinOnePercent) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const double frequency = std::uniform_real_distribution<double>(0.3, 20)(random);
    const double phase = std::uniform_real_distribution<double>(0, 6.3)(random);
    const double size = test::logUniform(random, -2, -1.2);
    const auto angle = [&](double t) { return size * (1.5 + std::sin(frequency * t + phase) * t); };
    const SeamFigures figures =
        surveySeam([&](double t) { return pairWith(t, 0, angle(t)); }, whole, {});
    double truth = 0;
    for (int k = 0; k <= 20000; ++k) truth = std::max(truth, angle(k / 20000.0));
    EXPECT_LE(figures.angle_rad->lower, truth * (1 + 1e-8));
    EXPECT_GE(figures.angle_rad->lower, 0.99 * truth)
        << "frequency " << frequency << " phase " << phase;
    EXPECT_NEAR(angle(figures.angle_rad->at), figures.angle_rad->lower, 1e-15);
    EXPECT_TRUE(figures.settled);
  }
}

TEST(Survey, BreaksLeadToADefectNarrowerThanAThousandthOfTheSeam) {
  const double from = 0.41234, to = from + 0.0008;
  const auto angle = [&](double t) {
    return t > from && t < to ? 0.05 * std::sin(std::numbers::pi * (t - from) / (to - from)) : 0;
  };
  const std::vector<double> breaks = {0, from, to, 1};
  const SeamFigures figures =
      surveySeam([&](double t) { return pairWith(t, 0, angle(t)); }, breaks, {});
  EXPECT_NEAR(figures.angle_rad->lower, 0.05, 0.0005);
  EXPECT_NEAR(figures.angle_rad->at, 0.5 * (from + to), 2e-4);
  EXPECT_GT(figures.below_crease_share, 0.99);
}

TEST(Survey, ApproachesAJumpAtABreakFromBothSides) {
  const std::vector<double> breaks = {0, 0.5, 1};
  const auto jump = [](double t) { return t < 0.5 ? 0.02 * t : 0.03 * (1 - t); };
  const SeamFigures figures =
      surveySeam([&](double t) { return pairWith(t, 0, jump(t)); }, breaks, {});
  EXPECT_NEAR(figures.angle_rad->lower, 0.015, 1e-6);
  EXPECT_GE(figures.angle_rad->at, 0.5);
}

TEST(Survey, PlacesAreSharesOfTheRange) {
  const std::vector<double> breaks = {-3, 5};
  const SeamFigures figures =
      surveySeam([](double t) { return pairWith(t, t == 5 ? 1 : 0, 0); }, breaks, {});
  EXPECT_EQ(figures.gap_mm->at, 1);
  EXPECT_EQ(figures.gap_mm->lower, 1);
}

TEST(Survey, CurvatureIsLeftOutOnASharpSeamAndAtSharpPoints) {
  const auto sharp_end = [](double t) {
    return pairWith(t, 0, t > 0.9 ? 0.5 : 0, t > 0.9 ? 99 : 0.3);
  };
  EXPECT_FALSE(surveySeam(sharp_end, whole, {}).curvature_per_mm.has_value());
  ContinuityTolerance wide;
  wide.crease_rad = 1;
  EXPECT_EQ(surveySeam(sharp_end, whole, wide).curvature_per_mm->lower, 99);
  const SeamFigures smooth = surveySeam([](double t) { return pairWith(t, 0, 0, 0.3); }, whole, {});
  EXPECT_EQ(smooth.curvature_per_mm->lower, 0.3);
  EXPECT_DOUBLE_EQ(smooth.curvature_rel->lower, 0.3);
}

TEST(Survey, TheChangeOfCurvatureIsSearchedWhereItIsTold) {
  const auto change = [](double t) { return 0.04 * std::exp(-std::pow((t - 0.3713) / 0.01, 2)); };
  const auto pair = [&](double t) {
    PairMeasure p = pairWith(t, 0, 0);
    p.curvature_change = CurvatureChange{change(t), 2, 2};
    return p;
  };
  const std::vector<double> breaks = {0, 0.34, 0.4, 1};
  const SeamFigures figures = surveySeam(pair, breaks, {});
  ASSERT_TRUE(figures.curvature_change_per_mm2 && figures.curvature_change_rel);
  EXPECT_NEAR(figures.curvature_change_per_mm2->lower, 0.04, 0.0004);
  EXPECT_NEAR(figures.curvature_change_rel->lower, 0.02, 0.0002);
  EXPECT_NEAR(figures.curvature_change_rel->at, 0.3713, 0.002);
  const SeamFigures silent = surveySeam([](double t) { return pairWith(t, 0, 0); }, whole, {});
  EXPECT_FALSE(silent.curvature_change_per_mm2 || silent.curvature_change_rel);
  const auto sharp = [&](double t) {
    PairMeasure p = pair(t);
    p.angle_rad = 0.5;
    return p;
  };
  EXPECT_FALSE(surveySeam(sharp, breaks, {}).curvature_change_rel);
}

TEST(Survey, TangentShareIsAShareOfLengthAndNotOfTheParameter) {
  const auto pair = [](double t) {
    PairMeasure p = pairWith(t, 0, t < 0.5 ? 0 : 0.2);
    p.point.x() = t < 0.5 ? t : 0.5 + 9 * (t - 0.5);
    return p;
  };
  const std::vector<double> breaks = {0, 0.5, 1};
  EXPECT_NEAR(surveySeam(pair, breaks, {}).below_crease_share, 0.1, 1e-6);
}

TEST(Survey, DegeneratePointsAreNamedAndSkipped) {
  const auto pair = [](double t) {
    PairMeasure p = pairWith(t, 0.001, 0.01);
    if (t == 0) {
      p.angle_rad.reset();
      p.curvature.reset();
      p.degenerate_b = Degeneracy::VanishingNormal;
    }
    return p;
  };
  const SeamFigures figures = surveySeam(pair, whole, {});
  ASSERT_EQ(figures.degenerate.size(), 1u);
  EXPECT_EQ(figures.degenerate[0].at, 0);
  EXPECT_EQ(figures.degenerate[0].side_b, Degeneracy::VanishingNormal);
  EXPECT_EQ(figures.degenerate[0].side_a, Degeneracy::None);
  EXPECT_EQ(figures.angle_rad->lower, 0.01);
}

TEST(Survey, OnePointThatIsNotFiniteTakesAllFiguresAway) {
  const auto pair = [](double t) {
    PairMeasure p = pairWith(t, 0, 0);
    if (t > 0.49 && t < 0.51) {
      p.gap_mm.reset();
      p.angle_rad.reset();
      p.curvature.reset();
      p.degenerate_a = Degeneracy::NotFinite;
    }
    return p;
  };
  const SeamFigures figures = surveySeam(pair, whole, {});
  EXPECT_FALSE(figures.gap_mm || figures.angle_rad || figures.curvature_per_mm ||
               figures.curvature_rel);
  EXPECT_FALSE(figures.degenerate.empty());
}

TEST(Survey, FoldIsNotedUnlessItIsSharpAnyway) {
  const auto fold = [](double t, double angle) {
    PairMeasure p = pairWith(t, 0, angle);
    p.fold = true;
    return p;
  };
  EXPECT_TRUE(surveySeam([&](double t) { return fold(t, 0.001); }, whole, {}).fold_at.has_value());
  EXPECT_EQ(surveySeam([&](double t) { return fold(t, 0.001); }, whole, {}).below_crease_share, 0);
  EXPECT_FALSE(surveySeam([&](double t) { return fold(t, 1); }, whole, {}).fold_at.has_value());
}

TEST(Survey, NoiseIsSampledNoLongerThanAllowed) {
  std::mt19937_64 random(testSeed());
  std::uniform_real_distribution<double> uniform(0, 0.08);
  SurveyOptions options;
  options.max_points = 300;
  const SeamFigures figures =
      surveySeam([&](double t) { return pairWith(t, 0, uniform(random)); }, whole, {}, options);
  EXPECT_LE(figures.points, 300);
  EXPECT_FALSE(figures.settled);
}

TEST(Survey, SmoothSeamsAreCheap) {
  EXPECT_EQ(surveySeam([](double t) { return pairWith(t, 0, 0); }, whole, {}).points,
            SurveyOptions().first_points);
}

std::string complaint(const std::vector<double>& breaks, const SurveyOptions& options = {}) {
  try {
    surveySeam([](double t) { return pairWith(t, 0, 0); }, breaks, {}, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Survey, BadInputIsNamed) {
  EXPECT_THAT(complaint({0.5}), HasSubstr("breaks 1"));
  EXPECT_THAT(complaint({0, 0.7, 0.7, 1}), HasSubstr("break 2 is 0.7"));
  EXPECT_THAT(complaint({0, std::nan(""), 1}), HasSubstr("break 1 is nan"));
  SurveyOptions options;
  options.points_per_span = 2;
  EXPECT_THAT(complaint({0, 1}, options), HasSubstr("points per span 2"));
  ContinuityTolerance bad;
  bad.gap_mm = -1;
  EXPECT_THROW(surveySeam([](double t) { return pairWith(t, 0, 0); }, whole, bad),
               std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
