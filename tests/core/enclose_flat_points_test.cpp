// SPDX-License-Identifier: LGPL-2.1-or-later
// Curvature that vanishes on both sides at one point, and curvature that jumps at knots of both
// sides: closed forms, and values at points.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <seamwright/core/seam/bspline_side.hpp>
#include <seamwright/core/seam/enclose.hpp>
#include <seamwright/core/seam/judge.hpp>

#include "support/random.hpp"

namespace seamwright {
namespace {

constexpr double length_mm = 10, height_mm = 5;

/// Both sides of a seam along y = 0: a has y <= 0, b has y >= 0.
struct Sheets {
  BSplineSurface a, b;

  SeamFigures enclosed(const ContinuityTolerance& tolerance) const {
    return encloseSeam(seamSide(a, PatchEdge::V1), seamSide(b, PatchEdge::V0), tolerance);
  }
  SeamFigures swapped(const ContinuityTolerance& tolerance) const {
    return encloseSeam(seamSide(b, PatchEdge::V0), seamSide(a, PatchEdge::V1), tolerance);
  }
  CurvatureDifference differenceAt(double u) const {
    const SurfaceJet on_a = jet(a, u, 1), on_b = jet(b, u, 0);
    return *measurePair({.jet = on_a, .noise = {}, .tangent = on_a.u},
                        {.jet = on_b, .noise = {}, .tangent = on_b.u})
                .curvature;
  }
};

void moveAndScale(const Eigen::Isometry3d& motion, double scale, BSplineSurface& surface) {
  for (Eigen::Index i = 0; i < surface.poles.rows(); ++i) {
    const Eigen::Vector3d pole = surface.poles.row(i).head<3>();
    surface.poles.row(i).head<3>() = motion * (scale * pole);
  }
}

Eigen::Isometry3d someMotion() {
  std::mt19937_64 random(testSeed());
  std::uniform_real_distribution<double> number(-1, 1);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.rotate(Eigen::Quaterniond(number(random), number(random), number(random), 1).normalized());
  motion.pretranslate(100 * Eigen::Vector3d(number(random), number(random), number(random)));
  return motion;
}

Verdict verdictOf(const SeamFigures& figures, const ContinuityTolerance& tolerance) {
  return judge(figures, tolerance, Level::G2);
}

// Curvature that vanishes at one point of both sides ---------------------------------------------

/// z = (slope (x - zero) + offset) y^2. Along y = 0 the curvature across the seam is twice the
/// factor of y^2, and there is no other.
BSplineSurface bentSheet(bool is_b, double slope, double zero, double offset) {
  BSplineSurface sheet{1, 2, {0, 0, 1, 1}, {0, 0, 0, 1, 1, 1}, {}};
  sheet.poles.resize(6, 4);
  for (const int i : {0, 1})
    for (const int j : {0, 1, 2}) {
      const double x = i * length_mm, y = (is_b ? 0.5 * j : 0.5 * j - 1) * height_mm;
      const bool is_far = j == (is_b ? 2 : 0);
      const double square = is_far ? height_mm * height_mm : 0;
      sheet.poles.row(3 * i + j) << x, y, (slope * (x - zero) + offset) * square, 1;
    }
  return sheet;
}

Sheets bentSheets(double ratio, double offset) {
  constexpr double slope = 1e-3, zero = 3.3;
  return {bentSheet(false, slope, zero, 0), bentSheet(true, slope * ratio, zero, offset)};
}

TEST(CommonFlatPoint, TheQuotientIsKnown) {
  const ContinuityTolerance tolerance;
  for (const double ratio : {1.01, 1.019, 1.022, 1.5, -1.0, 0.0}) {
    SCOPED_TRACE(ratio);
    const double truth = std::abs(1 - ratio) / std::max(1.0, std::abs(ratio));
    const SeamFigures figures = bentSheets(ratio, 0).enclosed(tolerance);
    EXPECT_NEAR(figures.curvature_rel->lower, truth, 0.01 * truth);
    EXPECT_GE(*figures.curvature_rel->upper, truth * (1 - 1e-12));
    EXPECT_LE(*figures.curvature_rel->upper, truth * 1.01);
    const Verdict verdict = verdictOf(figures, tolerance);
    EXPECT_TRUE(verdict.certain) << figures.uncertified;
    EXPECT_EQ(verdict.level, truth <= tolerance.curvature_rel ? Level::G2 : Level::G1);
  }
}

/// The difference 2 offset is the same everywhere, so the quotient is largest where the larger
/// curvature is just that of the flat radius.
TEST(CommonFlatPoint, AConstantDifferenceCountsAsFarAsTheFlatRadius) {
  const ContinuityTolerance tolerance;
  for (const double offset : {1e-8, 0.9e-7, 1.1e-7, 1e-6}) {
    SCOPED_TRACE(offset);
    const double truth = 2 * offset * tolerance.flat_radius_mm;
    const SeamFigures figures = bentSheets(1, offset).enclosed(tolerance);
    EXPECT_LE(figures.curvature_rel->lower, truth * (1 + 1e-12));
    EXPECT_GE(*figures.curvature_rel->upper, truth * (1 - 1e-12));
    const Verdict verdict = verdictOf(figures, tolerance);
    EXPECT_TRUE(verdict.certain) << figures.uncertified;
    EXPECT_EQ(verdict.level, truth <= tolerance.curvature_rel ? Level::G2 : Level::G1);
  }
}

TEST(CommonFlatPoint, MotionScaleAndSwapChangeNoVerdict) {
  for (const double scale : {1e-2, 1.0, 1e2}) {
    ContinuityTolerance tolerance;
    tolerance.gap_mm *= scale;
    tolerance.flat_radius_mm *= scale;
    for (const double ratio : {1.01, 1.03}) {
      SCOPED_TRACE(testing::Message() << scale << " " << ratio);
      Sheets sheets = bentSheets(ratio, 0);
      for (BSplineSurface* sheet : {&sheets.a, &sheets.b})
        moveAndScale(someMotion(), scale, *sheet);
      for (const SeamFigures& figures : {sheets.enclosed(tolerance), sheets.swapped(tolerance)}) {
        const Verdict verdict = verdictOf(figures, tolerance);
        EXPECT_TRUE(verdict.certain) << figures.uncertified;
        EXPECT_EQ(verdict.level, ratio == 1.01 ? Level::G2 : Level::G1);
        EXPECT_NEAR(figures.curvature_rel->lower, 1 - 1 / ratio, 0.01);
      }
    }
  }
}

// Curvature that jumps at knots of both sides ----------------------------------------------------

/// The extruded profile z(x) of tangent pieces whose second derivative is the bend between the
/// first and the second, the third and the fourth knot, and so on, else 0.
BSplineSurface profileSheet(bool is_b, const std::vector<double>& knots,
                            double bend_per_mm = 0.02) {
  BSplineSurface sheet{2, 1, {0, 0, 0}, {0, 0, 1, 1}, {}};
  sheet.knots_u.insert(sheet.knots_u.end(), knots.begin(), knots.end());
  sheet.knots_u.insert(sheet.knots_u.end(), 3, length_mm);
  const int count = sheet.countU();
  sheet.poles.resize(2 * static_cast<Eigen::Index>(count), 4);
  for (int i = 0; i < count; ++i) {
    const double first = sheet.knots_u[i + 1], second = sheet.knots_u[i + 2];
    double z = 0;  // a pole is the blossom of a piece at two knots
    for (std::size_t k = 0; k < knots.size() && knots[k] <= first; ++k)
      z += (k % 2 == 0 ? 0.5 : -0.5) * bend_per_mm * (first - knots[k]) * (second - knots[k]);
    for (const int j : {0, 1})
      sheet.poles.row(2 * i + j) << 0.5 * (first + second), (is_b ? j : j - 1) * height_mm, z, 1;
  }
  return sheet;
}

Sheets profileSheets(double off_mm, int knots = 3) {
  std::vector<double> of_a, of_b;
  for (int k = 1; k <= knots; ++k) {
    of_a.push_back(k * length_mm / (knots + 1));
    of_b.push_back(of_a.back() + (k % 2 == 0 ? -off_mm : off_mm));
  }
  return {profileSheet(false, of_a), profileSheet(true, of_b)};
}

double relativeAt(const Sheets& sheets, double u, const ContinuityTolerance& tolerance) {
  return relativeDifference(sheets.differenceAt(u), tolerance.flat_radius_mm);
}

TEST(JumpsAtKnots, NearlyTheSamePointIsLeftOutAndListed) {
  const ContinuityTolerance tolerance;
  for (const double off_mm : {1e-12, 1e-11, 1e-10}) {
    SCOPED_TRACE(off_mm);
    const Sheets sheets = profileSheets(off_mm);
    const SeamFigures figures = sheets.enclosed(tolerance);
    const Verdict verdict = verdictOf(figures, tolerance);
    EXPECT_EQ(verdict.level, Level::G2);
    EXPECT_TRUE(verdict.certain) << figures.uncertified;
    ASSERT_EQ(figures.curvature_left_out.intervals.size(), 3u);
    EXPECT_LE(figures.curvature_left_out.longest_mm, 2e-9 * length_mm);
    EXPECT_TRUE(figures.angle_left_out.intervals.empty());
    double from = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Interval& interval = figures.curvature_left_out.intervals[k];
      const double knot_a = sheets.a.knots_u[3 + k], knot_b = sheets.b.knots_u[3 + k];
      const double between = 0.5 * (knot_a + knot_b);
      EXPECT_TRUE(interval.contains(between / length_mm));
      EXPECT_NEAR(relativeAt(sheets, between, tolerance), 1, 1e-9);
      EXPECT_GE(figures.curvature_left_out.upper.value_or(2), 1 - 1e-12);
      for (int i = 0; i < 50; ++i) {
        const double at = from + i / 50.0 * (interval.lower - from);
        EXPECT_LE(relativeAt(sheets, at * length_mm, tolerance), *figures.curvature_rel->upper);
      }
      from = interval.upper + 1e-15;
    }
  }
}

TEST(JumpsAtKnots, ManyOfThemAreCertainToo) {
  const ContinuityTolerance tolerance;
  const SeamFigures figures = profileSheets(1e-11, 400).enclosed(tolerance);
  const Verdict verdict = verdictOf(figures, tolerance);
  EXPECT_EQ(verdict.level, Level::G2);
  EXPECT_TRUE(verdict.certain) << figures.uncertified;
}

TEST(JumpsAtKnots, KnotsThatAreApartCount) {
  const ContinuityTolerance tolerance;
  for (const double off_mm : {1e-7, 1e-5, 1e-3}) {
    SCOPED_TRACE(off_mm);
    const SeamFigures figures = profileSheets(off_mm).enclosed(tolerance);
    const Verdict verdict = verdictOf(figures, tolerance);
    EXPECT_EQ(verdict.level, Level::G1);
    EXPECT_TRUE(verdict.certain) << figures.uncertified;
    EXPECT_NEAR(figures.curvature_rel->lower, 1, 1e-9);
  }
}

TEST(JumpsAtKnots, AnIntervalLongerThanTheGapToleranceCounts) {
  ContinuityTolerance tolerance;
  tolerance.gap_mm = 1e-9;
  const SeamFigures figures = profileSheets(1e-11).enclosed(tolerance);
  EXPECT_GT(figures.curvature_left_out.longest_mm, tolerance.gap_mm);
  EXPECT_FALSE(verdictOf(figures, tolerance).certain);
}

TEST(JumpsAtKnots, AJumpOfOneSideIsNotLeftOut) {
  const ContinuityTolerance tolerance;
  const Sheets sheets = {profileSheet(false, {2, 4, 6}, 2e-5), profileSheet(true, {})};
  const SeamFigures figures = sheets.enclosed(tolerance);
  ASSERT_TRUE(figures.curvature_rel);
  EXPECT_NEAR(figures.curvature_rel->lower, 1, 1e-9);
  EXPECT_TRUE(figures.curvature_left_out.intervals.empty());
}

TEST(JumpsAtKnots, MotionScaleAndSwapChangeNoVerdict) {
  for (const double scale : {1e-2, 1.0, 1e2}) {
    ContinuityTolerance tolerance;
    tolerance.gap_mm *= scale;
    tolerance.flat_radius_mm *= scale;
    Sheets sheets = profileSheets(1e-11);
    for (BSplineSurface* sheet : {&sheets.a, &sheets.b}) moveAndScale(someMotion(), scale, *sheet);
    for (const SeamFigures& figures : {sheets.enclosed(tolerance), sheets.swapped(tolerance)}) {
      SCOPED_TRACE(scale);
      const Verdict verdict = verdictOf(figures, tolerance);
      EXPECT_EQ(verdict.level, Level::G2);
      EXPECT_TRUE(verdict.certain) << figures.uncertified;
      EXPECT_EQ(figures.curvature_left_out.intervals.size(), 3u);
    }
  }
}

}  // namespace
}  // namespace seamwright
