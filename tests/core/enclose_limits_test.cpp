// SPDX-License-Identifier: LGPL-2.1-or-later
// Enclosures against measurePair(), closed forms, and seams made to hide something.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <random>
#include <seamwright/core/seam/enclose.hpp>
#include <seamwright/core/seam/judge.hpp>

#include "seam_sides.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using test::choose;
using test::linePath;
using test::logUniform;
using test::PatchSide;
using test::Vec;

constexpr double pi = std::numbers::pi;
constexpr double infinite = std::numeric_limits<double>::infinity();

SeamSide planeSide(double u0, bool left) {
  SeamSide side{LineEvaluator{{u0, 0, 0}, {0, 1, 0}}, planeEvaluator(Frame())};
  side.face_on_left = left;
  return side;
}

/// The strip z = height(v) u over [0, 1]^2, a spline of height with the knots, poles and degree
/// given.
SeamSide strip(int degree, const std::vector<double>& knots, const std::vector<double>& heights) {
  std::vector<Vec> poles;
  for (const int i : {0, 1})
    for (std::size_t j = 0; j < heights.size(); ++j) {
      double greville = 0;
      for (int k = 1; k <= degree; ++k) greville += knots[j + k] / degree;
      poles.emplace_back(i, greville, i * heights[j]);
    }
  SeamSide side{LineEvaluator{{0, 0, 0}, {0, 1, 0}},
                splineEvaluator(std::make_shared<SplineEvaluator>(test::bezierDirection(1),
                                                                  SplineDirection{degree, knots, 0},
                                                                  poles, std::vector<double>()))};
  side.face_on_left = false;
  return side;
}

TEST(EncloseSeam, ADefectOfFiveCloseKnotsIsFound) {
  for (const double width : {1e-2, 1e-3, 1e-5, 1e-7}) {
    for (const double at : {0.1234567, 0.5, 1 / std::numbers::pi, 0.99}) {
      SCOPED_TRACE(testing::Message() << width << " at " << at);
      std::vector<double> knots = {0, 0, 0, 0};
      for (int k = 0; k < 5; ++k) knots.push_back(at + (k / 4.0 - 0.5) * width);
      knots.insert(knots.end(), {1, 1, 1, 1});
      std::vector<double> heights(9, 0.0);
      heights[4] = 0.01;  // the basis function of the five knots, 2/3 in their middle
      const SeamFigures figures =
          encloseSeam(planeSide(0, true), strip(3, knots, heights), {}, {.max_pieces = 5000});
      const Verdict verdict = judge(figures, {}, Level::G1);
      const double truth = std::atan(0.01 * 2 / 3);
      EXPECT_GE(figures.angle_rad->upper.value_or(infinite), truth * (1 - 1e-12));
      EXPECT_FALSE(verdict.certain && verdict.level > Level::G0);
      if (width < 1e-6)
        continue;  // knots nearer than a piece is ever cut: not certain is all that is asked
      EXPECT_EQ(verdict.level, Level::G0);
      EXPECT_TRUE(verdict.certain) << figures.uncertified;
      EXPECT_NEAR(figures.angle_rad->lower, truth, 0.01 * truth);
      EXPECT_NEAR(figures.angle_rad->at, at, width);
    }
  }
}

/// Bernstein coefficients of T_k on [0, 1], of degree k.
std::vector<double> chebyshevBernstein(int k) {
  std::vector<double> b;
  for (int j = 0; j <= k; ++j)
    b.push_back(((k - j) % 2 == 0 ? 1 : -1) * choose(2 * k, 2 * j) / choose(k, j));
  return b;
}

std::vector<double> bezierKnots(int degree) {
  return test::bezierDirection(degree).knots;
}

TEST(EncloseSeam, ADefectThatVanishesAtTheChebyshevPointsIsFound) {
  for (const int k : {4, 8, 12}) {  // T_k^2 = (1 + T_2k) / 2 vanishes at the k points of T_k
    SCOPED_TRACE(k);
    std::vector<double> heights = chebyshevBernstein(2 * k);
    for (double& h : heights) h = 0.005 * (1 + h);
    const SeamFigures figures = encloseSeam(
        planeSide(0, true), strip(2 * k, bezierKnots(2 * k), heights), {}, {.max_pieces = 5000});
    const double truth = std::atan(0.01);
    EXPECT_GE(*figures.angle_rad->upper, truth);
    EXPECT_LE(figures.angle_rad->lower, truth * (1 + 1e-9));
    EXPECT_LE(*figures.angle_rad->upper - figures.angle_rad->lower, 0.0101 * truth);
    EXPECT_EQ(judge(figures, {}, Level::G1).level, Level::G0);
    EXPECT_TRUE(judge(figures, {}, Level::G1).certain);
  }
}

TEST(EncloseSeam, KnotsThatCoincideButForRoundingAreOne) {
  // A C0 line along the double knot u = 0.5, one of the two an ulp away: flat to the left, bent to
  // the right.
  for (const double at : {0.5, std::nextafter(0.5, 1.0)})
    for (const bool left : {true, false}) {
      const double near = std::nextafter(0.5, 1.0);
      std::vector<Vec> poles;
      for (int i = 0; i < 5; ++i)
        for (const int j : {0, 1})
          poles.emplace_back(i / 4.0, j, i > 2 ? 0.1 * (i - 2) / 4.0 : 0.0);
      SeamSide kinked{LineEvaluator{{at, 0, 0}, {0, 1, 0}},
                      splineEvaluator(std::make_shared<SplineEvaluator>(
                          SplineDirection{2, {0, 0, 0, 0.5, near, 1, 1, 1}, 0},
                          test::bezierDirection(1), poles, std::vector<double>()))};
      kinked.face_on_left = left;  // left of +v is -u
      SeamSide plane = planeSide(0.5, !left);
      const SeamFigures figures = encloseSeam(plane, kinked, {});
      ASSERT_TRUE(figures.angle_rad && figures.angle_rad->upper) << figures.uncertified;
      const double truth = left ? 0 : std::atan(0.1);
      EXPECT_GE(*figures.angle_rad->upper, truth - 1e-9) << left;
      EXPECT_LE(*figures.angle_rad->upper, truth * 1.01 + 1e-6) << left;
    }
}

TEST(EncloseSeam, TheGapOutsideTheRangeSeesAllOfThePath) {
  // A path with a kink at 0.05, off the seam by 0.3 there; the range begins at 0.2.
  const std::shared_ptr<const SplineEvaluator> path = std::make_shared<SplineEvaluator>(
      SplineDirection{1, {0, 0, 0.05, 0.1, 1, 1}, 0}, SplineDirection{0, {0, 1}, 0},
      std::vector<Vec>{{0, 0, 0}, {0.3, 0.05, 0}, {0, 0.1, 0}, {0, 1, 0}}, std::vector<double>());
  const SeamFigures figures = encloseSeam(SeamSide{path, planeEvaluator(Frame())},
                                          planeSide(0, false), {}, {.range = {0.2, 1}});
  if (figures.gap_mm->upper) {
    EXPECT_GE(*figures.gap_mm->upper, 0.3 * (1 - 1e-12));
  }
  SeamSide bent = planeSide(0, true);
  bent.s = bent.t = {0, 0.05, 1};
  bent.t[1] = 0.3;
  const SeamFigures stretched = encloseSeam(bent, planeSide(0, false), {}, {.range = {0.2, 1}});
  if (stretched.gap_mm->upper) {
    EXPECT_GE(*stretched.gap_mm->upper, 0.25 * (1 - 1e-12));
  }
}

TEST(EncloseSeam, CubicParametersAreThoseOfManyShortLines) {
  // The plane against itself: the gap is that of the parameters, and largest between the knots.
  const auto cubic = [](double q) { return q + 0.4 * q * (1 - q) * (0.8 - q); };
  SeamSide bent = planeSide(0, true), lines = bent;
  bent.s = {0, 0.25, 1};
  bent.t = {0, cubic(0.25 / 3), cubic(0.5 / 3), cubic(0.25), cubic(0.5), cubic(0.75), 1};
  lines.s = lines.t = {0};
  constexpr int count = 400;
  for (int i = 1; i <= count; ++i) {
    lines.s.push_back(static_cast<double>(i) / count);
    lines.t.push_back(cubic(lines.s.back()));
  }
  const SeamFigures by_cubics = encloseSeam(bent, planeSide(0, false), {}),
                    by_lines = encloseSeam(lines, planeSide(0, false), {});
  ASSERT_TRUE(by_cubics.gap_mm->upper && by_lines.gap_mm->upper);
  double truth = 0;
  for (int i = 0; i <= 10'000; ++i) truth = std::max(truth, std::abs(cubic(i / 1e4) - i / 1e4));
  EXPECT_GE(*by_cubics.gap_mm->upper, truth);
  EXPECT_LE(by_cubics.gap_mm->lower, truth * (1 + 1e-9));
  EXPECT_LE(*by_cubics.gap_mm->upper, truth * 1.02);
  EXPECT_NEAR(by_lines.gap_mm->lower, truth, 0.01 * truth);
}

// --- limits of the verdict

/// The plane z = 0 turned about y by the angle with this cosine and sine.
SeamSide turnedPlane(double cosine, double sine) {
  Frame frame;
  frame.axes << cosine, 0, -sine, 0, 1, 0, sine, 0, cosine;
  SeamSide side{LineEvaluator{{0, 0, 0}, {0, 1, 0}}, planeEvaluator(frame)};
  side.face_on_left = false;
  return side;
}

TEST(EncloseSeam, AnAngleAtALimitIsNotCertainOrRight) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const double angle = std::uniform_real_distribution<double>(0.01, 1.5)(random);
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const long double truth =
        std::atan2(static_cast<long double>(sine), static_cast<long double>(cosine));
    for (const double off : {0.0, 1e-16, -1e-16, 1e-15, -1e-15, 1e-12, -1e-12, 1e-4, -1e-4}) {
      SCOPED_TRACE(testing::Message() << angle << " " << off);
      ContinuityTolerance tolerance;
      tolerance.angle_rad = angle + off;
      tolerance.crease_rad = pi / 2;
      const EncloseOptions options{.max_pieces = 100, .figures = i % 2 == 0};
      Verdict verdict =
          judge(encloseSeam(planeSide(0, true), turnedPlane(cosine, sine), tolerance, options),
                tolerance, Level::G1);
      if (verdict.certain) {
        EXPECT_EQ(verdict.level >= Level::G1, truth <= tolerance.angle_rad);
      }
      if (std::abs(off) > 1e-5) {
        EXPECT_TRUE(verdict.certain);
      }
      tolerance.crease_rad = tolerance.angle_rad;
      tolerance.angle_rad = 0.001;
      verdict =
          judge(encloseSeam(planeSide(0, true), turnedPlane(cosine, sine), tolerance, options),
                tolerance, Level::G1);
      if (verdict.certain) {
        EXPECT_EQ(verdict.seam_class == SeamClass::Crease, truth > tolerance.crease_rad);
      }
      if (std::abs(off) > 1e-5) {
        EXPECT_TRUE(verdict.certain);
      }
    }
  }
}

TEST(EncloseSeam, AGapAtTheToleranceIsNotCertainOrRight) {
  for (const double gap : {0.01, 1e-3, 0.3, 7.0})
    for (const double tolerated :
         {gap, std::nextafter(gap, 0.0), std::nextafter(gap, 10.0), gap * 1.1}) {
      Frame frame;
      frame.origin = {0, 0, gap};
      SeamSide lifted{LineEvaluator{{0, 0, 0}, {0, 1, 0}}, planeEvaluator(frame)};
      lifted.face_on_left = false;
      ContinuityTolerance tolerance;
      tolerance.gap_mm = tolerated;
      const SeamFigures figures =
          encloseSeam(planeSide(0, true), lifted, tolerance, {.max_pieces = 100});
      EXPECT_LE(figures.gap_mm->lower, gap);
      EXPECT_GE(*figures.gap_mm->upper, gap);
      const Verdict verdict = judge(figures, tolerance, Level::G0);
      if (verdict.certain) {
        EXPECT_EQ(verdict.level >= Level::G0, gap <= tolerated);
      }
      if (tolerated > 1.01 * gap) {
        EXPECT_TRUE(verdict.certain);
      }
    }
}

TEST(EncloseSeam, AKnifeEdgeFolds) {
  SeamSide back = turnedPlane(1, 0);
  back.face_on_left = true;  // both faces on the same side
  const SeamFigures figures = encloseSeam(planeSide(0, true), back, {});
  EXPECT_TRUE(figures.fold_at);
  const Verdict verdict = judge(figures, {}, Level::G1);
  EXPECT_EQ(verdict.seam_class, SeamClass::Crease);
  EXPECT_TRUE(verdict.certain);
}

TEST(EncloseSeam, AShortFoldOfASeamThatIsMostlySmoothIsSeenOrLeftOpen) {
  // The strip turns about the seam: flat up to 0.6, up at 0.8, back onto the plane at the end, or
  // not quite.
  for (const double last : {180.0, 179.9, 178.0, 176.0, 174.0, 120.0}) {
    SCOPED_TRACE(last);
    std::vector<Vec> poles;
    const std::vector<double> at = {0, 0.6, 0.8, 1}, turned = {0, 0, pi / 2, last * pi / 180};
    for (const int i : {0, 1})
      for (std::size_t j = 0; j < at.size(); ++j)
        poles.emplace_back(i * std::cos(turned[j]), at[j], i * std::sin(turned[j]));
    SeamSide side{LineEvaluator{{0, 0, 0}, {0, 1, 0}},
                  splineEvaluator(std::make_shared<SplineEvaluator>(
                      test::bezierDirection(1), SplineDirection{1, {0, 0, 0.6, 0.8, 1, 1}, 0},
                      poles, std::vector<double>()))};
    side.face_on_left = false;
    const Verdict verdict = judge(encloseSeam(planeSide(0, true), side, {}), {}, Level::G1);
    if (verdict.certain) {
      EXPECT_EQ(verdict.seam_class, SeamClass::Defect)
          << "sharp, but below the crease angle over more than half";
    }
  }
}

TEST(EncloseSeam, ARightAngleIsACrease) {
  const SeamFigures figures = encloseSeam(planeSide(0, true), turnedPlane(0, 1), {});
  EXPECT_LE(figures.angle_rad->lower, pi / 2);
  EXPECT_GE(*figures.angle_rad->upper, pi / 2 * (1 - 1e-15));
  EXPECT_LE(*figures.angle_rad->upper, 1.01 * pi / 2);
  EXPECT_EQ(judge(figures, {}, Level::G1).seam_class, SeamClass::Crease);
  EXPECT_TRUE(judge(figures, {}, Level::G1).certain);
}

TEST(EncloseSeam, AnAngleThatPassesTheCreaseAngleIsJudgedByTheLength) {
  ContinuityTolerance tolerance;
  for (const double share : {0.1, 0.45, 0.49, 0.499, 0.501, 0.51, 0.55, 0.9}) {
    SCOPED_TRACE(share);
    // Height of slope tan(crease) at v = share, rising.
    const double slope = std::tan(tolerance.crease_rad) / share;
    const SeamFigures figures =
        encloseSeam(planeSide(0, true), strip(1, {0, 0, 1, 1}, {0, slope}), tolerance);
    const Verdict verdict = judge(figures, tolerance, Level::G1);
    const bool crease = share < 0.5;
    if (verdict.certain) {
      EXPECT_EQ(verdict.seam_class == SeamClass::Crease, crease);
    }
    if (std::abs(share - 0.5) > 0.03) {
      EXPECT_TRUE(verdict.certain);
    }
    EXPECT_NEAR(figures.below_crease_share, share, 0.02);
  }
}

TEST(EncloseSeam, CylindersThatPassTheFlatRadius) {
  // Cylinders of radii r and r (1 + off), touching along a ruling, about the flat radius of 1000.
  for (const double radius : {500.0, 999.0, 1000.0, 1001.0, 2000.0})
    for (const double ratio : {1.0, 0.5, 0.999, 1.001, 2.0, -1.0}) {
      SCOPED_TRACE(testing::Message() << radius << " " << ratio);
      const auto side = [](double r, bool left) {
        Frame frame;
        frame.origin = {-r, 0, 0};
        SeamSide result{
            LineEvaluator{{0, 0, 0}, {0, 1, 0}},
            r < 0 ? placedEvaluator(cylinderEvaluator(Frame(), -r),
                                    {1, Eigen::Vector3d(-1, -1, 1).asDiagonal(), {-r, 0, 0}})
                  : cylinderEvaluator(frame, r)};
        result.face_on_left = left;
        return result;
      };
      ContinuityTolerance tolerance;
      tolerance.flat_radius_mm = 1000;
      const double other = radius * ratio;
      const SeamFigures figures =
          encloseSeam(side(radius, true), side(other, other < 0), tolerance, {.max_pieces = 300});
      const bool flat_a = radius > 1000, flat_b = std::abs(other) > 1000;
      const double difference = std::abs(1 / radius - 1 / other);
      const double largest = std::max(1 / radius, 1 / std::abs(other));
      const double truth = flat_a && flat_b ? 0 : difference / largest;
      ASSERT_TRUE(figures.curvature_rel && figures.curvature_rel->upper) << figures.uncertified;
      EXPECT_GE(*figures.curvature_rel->upper, truth * (1 - 1e-12));
      EXPECT_LE(figures.curvature_rel->lower, truth * (1 + 1e-12));
      EXPECT_GE(*figures.curvature_per_mm->upper, difference * (1 - 1e-12));
      EXPECT_LE(figures.curvature_per_mm->lower, difference * (1 + 1e-12) + 1e-18);
      const Verdict verdict = judge(figures, tolerance, Level::G2);
      if (verdict.certain) {
        EXPECT_EQ(verdict.level >= Level::G2, truth <= tolerance.curvature_rel);
      }
    }
}

TEST(EncloseSeam, ConesThatPassTheFlatRadiusAtDifferentPlacesAreSmooth) {
  // Two cones with one apex touch along a ruling, where their curvatures are 1 / (v tan(angle)).
  constexpr double radius = 1000;
  const auto cone = [](double tangent) {
    const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = cosine * tangent;
    Frame frame;
    frame.axes << sine, 0, cosine, 0, -1, 0, cosine, 0, -sine;
    return coneEvaluator(frame, 0, std::atan(tangent));
  };
  for (const double excess : {1e-6, 1e-3, 0.1}) {
    SCOPED_TRACE(excess);
    const LineEvaluator ruling{{0, 0.5 * radius, 0}, {0, 1.5 * radius, 0}};
    const SeamSide a{ruling, cone(1)};
    SeamSide b{ruling, cone(1 + excess)};
    b.face_on_left = false;
    ContinuityTolerance tolerance;
    tolerance.flat_radius_mm = radius;
    const SeamFigures figures = encloseSeam(a, b, tolerance, {});
    ASSERT_TRUE(figures.certified) << figures.uncertified;
    const double truth = excess / (1 + excess);
    EXPECT_LE(figures.curvature_rel->lower, truth * (1 + 1e-9));
    EXPECT_GE(*figures.curvature_rel->upper, truth * (1 - 1e-9));
    EXPECT_LE(*figures.curvature_rel->upper, 1.02 * truth + 0.01 * tolerance.curvature_rel);
    EXPECT_TRUE(judge(figures, tolerance, Level::G2).certain);
  }
}

TEST(EncloseSeam, SpheresThatTouchAreHeldToThePrecisionOfRounding) {
  // Umbilic tensors have double eigenvalues, the hard case of an eigenvalue's formula.
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 500; ++i) {
    const double r = logUniform(random, -1, 3), R = r * (1 + logUniform(random, -9, 1));
    // At the same parameters the normals are the same, whatever the gap.
    const Vec uv = test::randomVector(random);
    const SeamSide a{LineEvaluator{uv, {0, 0, 0}}, sphereEvaluator(Frame(), r)};
    SeamSide b{LineEvaluator{uv, {0, 0, 0}}, sphereEvaluator(Frame(), R)};
    b.face_on_left = false;
    const SeamFigures figures = encloseSeam(a, b, {}, {.max_pieces = 50});
    const long double truth =
        std::abs(1 / static_cast<long double>(r) - 1 / static_cast<long double>(R));
    ASSERT_TRUE(figures.curvature_per_mm && figures.curvature_per_mm->upper);
    EXPECT_GE(*figures.curvature_per_mm->upper, truth * (1 - 1e-17L)) << i;
    EXPECT_LE(figures.curvature_per_mm->lower, truth * (1 + 1e-17L)) << i;
  }
}

// --- degenerate patches

// --- laws

TEST(EncloseSeam, ACreaseWhereAPeriodEndsIsSeen) {
  // A prism over an equilateral triangle, the period from -pi to pi, which its knots round.
  const std::vector<Vec> corners = {{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}, {0, 0, 0}};
  std::vector<Vec> poles;
  for (const Vec& corner : corners)
    for (const double height : {0.0, 1.0}) poles.emplace_back(corner + height * Vec::UnitZ());
  const auto sideAt = [&](double u, bool face_on_left) {
    SeamSide side{LineEvaluator{{u, 0, 0}, {0, 1, 0}},
                  splineEvaluator(std::make_shared<SplineEvaluator>(
                      SplineDirection{1, {-pi, -pi, -1, 1, pi, pi}, 2 * pi},
                      test::bezierDirection(1), poles, std::vector<double>()))};
    side.face_on_left = face_on_left;
    return side;
  };
  const SeamFigures figures = encloseSeam(sideAt(-pi, false), sideAt(pi, true), {});
  ASSERT_TRUE(figures.angle_rad && figures.angle_rad->upper);
  EXPECT_NEAR(figures.angle_rad->lower, pi / 3, 1e-9);
  EXPECT_NEAR(*figures.angle_rad->upper, pi / 3, 1e-9);
}

TEST(EncloseSeam, AlongAKnotLineTheSideOfTheFaceCounts) {
  // A roof with its ridge at u = 0, and a plane that goes on from one of its slopes.
  const std::vector<Vec> poles = {{-1, 0, -1}, {-1, 1, -1}, {0, 0, 0},
                                  {0, 1, 0},   {1, 0, -1},  {1, 1, -1}};
  SeamSide roof{LineEvaluator{{0, 0, 0}, {0, 1, 0}},
                splineEvaluator(std::make_shared<SplineEvaluator>(
                    SplineDirection{1, {-1, -1, 0, 1, 1}, 0}, test::bezierDirection(1), poles,
                    std::vector<double>()))};
  for (const bool rising : {true, false}) {
    roof.face_on_left = rising;  // left of the ridge it rises
    Frame frame;
    frame.axes.col(0) = Vec(1, 0, rising ? 1 : -1).normalized();
    frame.axes.col(1) = Vec::UnitY();
    frame.axes.col(2) = frame.axes.col(0).cross(frame.axes.col(1));
    SeamSide plane{LineEvaluator{{0, 0, 0}, {0, 1, 0}}, planeEvaluator(frame)};
    plane.face_on_left = !rising;
    const SeamFigures figures = encloseSeam(roof, plane, {});
    ASSERT_TRUE(figures.angle_rad && figures.angle_rad->upper);
    EXPECT_LT(*figures.angle_rad->upper, 1e-9) << "rising " << rising;
  }
}

TEST(EncloseSeam, RefusesToleranceThatIsNone) {
  ContinuityTolerance tolerance;
  tolerance.gap_mm = -1;
  EXPECT_THROW(encloseSeam(planeSide(0, true), planeSide(0, false), tolerance),
               std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
