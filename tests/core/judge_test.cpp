// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <seamwright/core/seam/judge.hpp>

namespace seamwright {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double degree = radians_per_degree;

SeamFigures figures(double gap_mm, double angle_deg, double curvature_rel) {
  SeamFigures f;
  f.gap_mm = Figure{gap_mm, std::nullopt, 0.5};
  f.angle_rad = Figure{angle_deg * degree, std::nullopt, 0.5};
  f.curvature_per_mm = Figure{1, std::nullopt, 0.5};
  f.curvature_rel = Figure{curvature_rel, std::nullopt, 0.5};
  return f;
}

TEST(Judge, ClimbsFromLevelToLevel) {
  const ContinuityTolerance tolerance;
  EXPECT_EQ(judge(figures(0.011, 0, 0), tolerance, Level::G1).level, Level::None);
  EXPECT_EQ(judge(figures(0.009, 0.11, 0), tolerance, Level::G1).level, Level::G0);
  EXPECT_EQ(judge(figures(0.009, 0.09, 0.021), tolerance, Level::G1).level, Level::G1);
  EXPECT_EQ(judge(figures(0.009, 0.09, 0.019), tolerance, Level::G1).level, Level::G2);
}

TEST(Judge, TheChangeOfCurvatureDecidesG3AndOnlyAboveG2) {
  const ContinuityTolerance tolerance;
  const auto with = [](SeamFigures f, double change_rel) {
    f.curvature_change_per_mm2 = Figure{1, std::nullopt, 0.5};
    f.curvature_change_rel = Figure{change_rel, std::nullopt, 0.5};
    return f;
  };
  EXPECT_EQ(judge(with(figures(0, 0, 0), 0.02), tolerance, Level::G3).level, Level::G3);
  EXPECT_EQ(judge(with(figures(0, 0, 0), 0.02), tolerance, Level::G3).seam_class,
            SeamClass::Smooth);
  EXPECT_EQ(judge(with(figures(0, 0, 0), 0.021), tolerance, Level::G3).level, Level::G2);
  EXPECT_EQ(judge(with(figures(0, 0, 0), 0.021), tolerance, Level::G3).seam_class,
            SeamClass::Defect);
  EXPECT_EQ(judge(with(figures(0, 0, 0.021), 0), tolerance, Level::G3).level, Level::G1);
  EXPECT_EQ(judge(figures(0, 0, 0), tolerance, Level::G3).level, Level::G2);
}

TEST(Judge, ToleranceItselfIsAccepted) {
  const ContinuityTolerance tolerance;
  SeamFigures f = figures(tolerance.gap_mm, 0, tolerance.curvature_rel);
  f.angle_rad->lower = tolerance.angle_rad;
  EXPECT_EQ(judge(f, tolerance, Level::G2).level, Level::G2);
}

TEST(Judge, WhatIsLeftOutCountsForCertaintyAlone) {
  const ContinuityTolerance tolerance;
  SeamFigures f = figures(0, 0.05, 0.01);
  for (auto figure : {&SeamFigures::gap_mm, &SeamFigures::angle_rad, &SeamFigures::curvature_rel})
    (f.*figure)->upper = (f.*figure)->lower;
  f.shares_known = true;
  f.curvature_left_out = {{{0, 1e-6}}, 0.015};
  EXPECT_TRUE(judge(f, tolerance, Level::G1).certain);
  EXPECT_TRUE(certainlyReaches(f, tolerance, Level::G2));
  for (const std::optional<double> upper : {std::optional(0.03), std::optional<double>()}) {
    f.curvature_left_out.upper = upper;
    EXPECT_EQ(judge(f, tolerance, Level::G1).level, Level::G2);
    EXPECT_FALSE(judge(f, tolerance, Level::G1).certain);
    EXPECT_FALSE(certainlyReaches(f, tolerance, Level::G2));
    EXPECT_TRUE(certainlyReaches(f, tolerance, Level::G1));
  }
  f.curvature_rel = Figure{0.5, 0.5, 0};
  EXPECT_TRUE(judge(f, tolerance, Level::G1).certain) << "G1 whatever is left out of the curvature";
  f.angle_left_out = {{{0.999, 1}}, std::nullopt};
  EXPECT_EQ(judge(f, tolerance, Level::G1).level, Level::G1);
  EXPECT_FALSE(judge(f, tolerance, Level::G1).certain);
  EXPECT_FALSE(certainlyReaches(f, tolerance, Level::G1));
  f.angle_rad = Figure{degree, degree, 0};
  f.below_crease_share = 1;
  EXPECT_TRUE(judge(f, tolerance, Level::G1).certain) << "a defect whatever is left out";
}

TEST(Judge, ClassFollowsTheLevelAskedFor) {
  const ContinuityTolerance tolerance;
  const SeamFigures g1 = figures(0, 0.05, 0.5);
  EXPECT_EQ(judge(g1, tolerance, Level::G0).seam_class, SeamClass::Smooth);
  EXPECT_EQ(judge(g1, tolerance, Level::G1).seam_class, SeamClass::Smooth);
  EXPECT_EQ(judge(g1, tolerance, Level::G2).seam_class, SeamClass::Defect);
  const SeamFigures kink = figures(0, 1, 0.5);
  EXPECT_EQ(judge(kink, tolerance, Level::G0).seam_class, SeamClass::Smooth);
  EXPECT_EQ(judge(kink, tolerance, Level::G1).seam_class, SeamClass::Defect);
}

TEST(Judge, CreaseIsNoDefectUnlessItGapesOrIsASpot) {
  const ContinuityTolerance tolerance;
  SeamFigures sharp = figures(0, 40, 0);
  EXPECT_EQ(judge(sharp, tolerance, Level::G1).seam_class, SeamClass::Crease);
  EXPECT_EQ(judge(sharp, tolerance, Level::G1).level, Level::G0);
  sharp.below_crease_share = 0.9;
  EXPECT_EQ(judge(sharp, tolerance, Level::G1).seam_class, SeamClass::Defect);
  sharp.below_crease_share = 0.1;
  sharp.gap_mm->lower = 0.02;
  EXPECT_EQ(judge(sharp, tolerance, Level::G1).seam_class, SeamClass::Defect);
  EXPECT_EQ(judge(sharp, tolerance, Level::G1).level, Level::None);
}

TEST(Judge, FoldIsACreaseAndNeverSmooth) {
  const ContinuityTolerance tolerance;
  SeamFigures fold = figures(0, 0, 0);
  fold.fold_at = 0.3;
  EXPECT_EQ(judge(fold, tolerance, Level::G1).level, Level::G0);
  EXPECT_EQ(judge(fold, tolerance, Level::G1).seam_class, SeamClass::Crease);
}

// The planes of a fold agree, so its angle alone reads like that of a smooth seam.
TEST(Judge, RemarksTellWhatTheFiguresHide) {
  const ContinuityTolerance tolerance;
  SeamFigures f = figures(0, 0.007, 0);
  EXPECT_EQ(remarksOn(f, tolerance), "");
  f.fold_at = 0.3;
  EXPECT_EQ(remarksOn(f, tolerance), "the faces fold back on one another");
  f.settled = false;
  f.points = 77;
  EXPECT_EQ(remarksOn(f, tolerance),
            "the faces fold back on one another; figures still changed after 77 points");
  f.fold_at.reset();
  f.settled = true;
  f.angle_rad->lower = 40 * degree;
  EXPECT_EQ(remarksOn(f, tolerance), "");
  f.below_crease_share = 0.625;
  EXPECT_EQ(remarksOn(f, tolerance),
            "sharp spot in a seam that is below the crease angle over 62 % of its length");
}

TEST(Judge, MissingFiguresStopTheClimb) {
  const ContinuityTolerance tolerance;
  SeamFigures f = figures(0, 0, 0);
  f.curvature_rel.reset();
  EXPECT_EQ(judge(f, tolerance, Level::G1).level, Level::G1);
  f.angle_rad.reset();
  EXPECT_EQ(judge(f, tolerance, Level::G1).level, Level::G0);
  EXPECT_EQ(judge(f, tolerance, Level::G1).seam_class, SeamClass::Defect);
  f.gap_mm.reset();
  EXPECT_EQ(judge(f, tolerance, Level::G0).level, Level::None);
  EXPECT_EQ(judge(SeamFigures(), tolerance, Level::G0).seam_class, SeamClass::Defect);
}

TEST(Judge, WithoutATangentPlaneOverMuchOfItsLengthASeamIsG0) {
  const ContinuityTolerance tolerance;
  SeamFigures f = figures(0, 0, 0);
  f.plane_share = 0.96;
  EXPECT_EQ(judge(f, tolerance, Level::G1).level, Level::G2);
  f.plane_share = 0.94;
  EXPECT_EQ(judge(f, tolerance, Level::G1).level, Level::G0);
  EXPECT_EQ(judge(f, tolerance, Level::G1).seam_class, SeamClass::Defect);
}

TEST(Judge, NamesGoThereAndBack) {
  for (const Level level : {Level::G0, Level::G1, Level::G2, Level::G3})
    EXPECT_EQ(levelFromName(name(level)), level);
  EXPECT_EQ(name(Level::None), "none");
  EXPECT_FALSE(levelFromName("g1").has_value());
  EXPECT_FALSE(levelFromName("none").has_value());
  EXPECT_EQ(name(SeamClass::Smooth), "smooth");
  EXPECT_EQ(name(SeamClass::Defect), "defect");
  EXPECT_EQ(name(SeamClass::Crease), "crease");
}

std::string complaint(const std::function<void(ContinuityTolerance&)>& spoil) {
  ContinuityTolerance tolerance;
  spoil(tolerance);
  try {
    tolerance.validate();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Tolerance, DefaultsAreValid) {
  EXPECT_NO_THROW(ContinuityTolerance().validate());
}

TEST(Tolerance, EveryFieldIsCheckedAndNamedWithItsValue) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THAT(complaint([&](auto& t) { t.gap_mm = nan; }),
              AllOf(HasSubstr("gap"), HasSubstr("nan")));
  EXPECT_THAT(complaint([&](auto& t) { t.gap_mm = -0.5; }),
              AllOf(HasSubstr("gap"), HasSubstr("-0.5")));
  EXPECT_THAT(complaint([&](auto& t) { t.angle_rad = -1 * degree; }),
              AllOf(HasSubstr("angle"), HasSubstr("-1 deg")));
  EXPECT_THAT(complaint([&](auto& t) { t.curvature_rel = infinity; }),
              AllOf(HasSubstr("curvature"), HasSubstr("inf")));
  EXPECT_THAT(complaint([&](auto& t) { t.flat_radius_mm = 0; }),
              AllOf(HasSubstr("flat radius"), HasSubstr("0 mm")));
  EXPECT_THAT(complaint([&](auto& t) { t.flat_radius_mm = -3; }),
              AllOf(HasSubstr("flat radius"), HasSubstr("-3")));
  EXPECT_THAT(complaint([&](auto& t) { t.crease_rad = nan; }),
              AllOf(HasSubstr("crease"), HasSubstr("nan")));
  EXPECT_THAT(complaint([&](auto& t) { t.crease_rad = 91 * degree; }),
              AllOf(HasSubstr("crease"), HasSubstr("91")));
  EXPECT_THAT(complaint([&](auto& t) { t.crease_rad = 0.05 * degree; }),
              AllOf(HasSubstr("crease"), HasSubstr("0.05")));
}

/// Enclosures from lower to a share of the tolerance more.
SeamFigures enclosed(double gap_mm, double angle_deg, double curvature_rel, double width) {
  SeamFigures f = figures(gap_mm, angle_deg, curvature_rel);
  const ContinuityTolerance tolerance;
  f.gap_mm->upper = gap_mm + width * tolerance.gap_mm;
  f.angle_rad->upper = f.angle_rad->lower + width * tolerance.angle_rad;
  f.curvature_per_mm->upper = 2;
  f.curvature_rel->upper = curvature_rel + width * tolerance.curvature_rel;
  f.below_crease_share = angle_deg > 5 ? 0 : 1;
  f.shares_known = true;
  return f;
}

TEST(Judge, CertainIffEveryValueWithinTheEnclosuresGivesTheSame) {
  const ContinuityTolerance tolerance;
  for (const double gap : {0.0, 0.009, 0.00999, 0.01, 0.0101, 1.0})
    for (const double angle : {0.0, 0.09, 0.0999, 0.1, 0.101, 4.9999, 5.1})
      for (const double curvature : {0.0, 0.0199, 0.02, 0.021})
        for (const double width : {0.0, 0.005, 0.5, 1e9})
          for (const Level required : {Level::G0, Level::G1, Level::G2}) {
            const SeamFigures f = enclosed(gap, angle, curvature, width);
            const Verdict verdict = judge(f, tolerance, required);
            // The verdicts of figures that are known exactly, at the corners of the box.
            bool same = true;
            for (int corner = 0; corner < 8; ++corner) {
              SeamFigures exact = f;
              if (corner & 1) exact.gap_mm->lower = *f.gap_mm->upper;
              if (corner & 2) exact.angle_rad->lower = *f.angle_rad->upper;
              if (corner & 4) exact.curvature_rel->lower = *f.curvature_rel->upper;
              const Verdict at = judge(exact, tolerance, required);
              same &= at.level == verdict.level && at.seam_class == verdict.seam_class;
            }
            EXPECT_EQ(verdict.certain, same)
                << gap << " " << angle << " " << curvature << " " << width;
          }
}

TEST(Judge, SampledFiguresAreNeverCertainUnlessTheGapIsTooLarge) {
  for (const double gap : {0.0, 0.009, 0.011})
    for (const double angle : {0.0, 0.2, 4.0, 30.0})
      for (const double curvature : {0.0, 1.0}) {
        SeamFigures f = figures(gap, angle, curvature);
        f.below_crease_share = angle > 5 ? 0 : 1;
        EXPECT_EQ(judge(f, {}, Level::G1).certain, gap > 0.01)
            << gap << " " << angle << " " << curvature;
        EXPECT_EQ(judge(f, {}, Level::G2).certain, gap > 0.01)
            << gap << " " << angle << " " << curvature;
      }
}

TEST(Judge, AnUnknownUpperBoundLeavesTheVerdictOpen) {
  const auto without = [](std::optional<Figure> SeamFigures::*figure) {
    SeamFigures f = enclosed(0, 0, 0, 0.1);
    (f.*figure)->upper.reset();
    return judge(f, {}, Level::G2).certain;
  };
  EXPECT_TRUE(judge(enclosed(0, 0, 0, 0.1), {}, Level::G2).certain);
  EXPECT_FALSE(without(&SeamFigures::gap_mm));
  EXPECT_FALSE(without(&SeamFigures::angle_rad));
  EXPECT_FALSE(without(&SeamFigures::curvature_rel));
  EXPECT_TRUE(without(&SeamFigures::curvature_per_mm));  // no tolerance asks for it
}

}  // namespace
}  // namespace seamwright
