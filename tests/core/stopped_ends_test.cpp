// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/bernstein/polynomial.hpp>
#include <seamwright/core/bezier/stopped_ends.hpp>
#include <seamwright/core/fair/curvature_profile.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc_fit.hpp>
#include <seamwright/core/planar/clothoid_fit.hpp>
#include <seamwright/core/planar/conic_fit.hpp>
#include <seamwright/core/planar/planar_chain.hpp>

#include "planar.hpp"

namespace seamwright {
namespace {

using Eigen::Vector2d;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Poles rowsOf(const std::vector<Vector2d>& poles) {
  Poles rows = Poles::Zero(static_cast<Eigen::Index>(poles.size()), 3);
  for (std::size_t i = 0; i < poles.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)).head<2>() = poles[i].transpose();
  return rows;
}

BezierCurve curveOf(const std::vector<Vector2d>& poles) {
  return BezierCurve(rowsOf(poles));
}

/// (t^2, t^3): y = x^(3/2), with the curvature 3 / (4 sqrt(x) (1 + 9 x / 4)^(3/2)).
BezierCurve halfOfCusp(double size = 1) {
  return curveOf({{0, 0}, {0, 0}, {size / 3, 0}, {size, size}});
}

/// a t^2 + b t^4, which is a t + b t^2 at t^2: the parabola y = x^2.
BezierCurve slowParabola() {
  return curveOf({{0, 0}, {0, 0}, {1.0 / 6, 0}, {0.5, 0}, {1, 1}});
}

BSplineCurve bezierAsSpline(const BezierCurve& curve) {
  const auto n = static_cast<std::size_t>(curve.degree());
  std::vector<double> knots(n + 1, 0.0);
  knots.insert(knots.end(), n + 1, 1.0);
  return {curve.degree(), knots, curve.homogeneousPoles()};
}

TEST(StoppedEnds, CountsPolesThatAreEqualToAnEnd) {
  EXPECT_EQ(stoppedEnds(halfOfCusp()).start, 1);
  EXPECT_EQ(stoppedEnds(halfOfCusp()).end, 0);
  EXPECT_EQ(stoppedEnds(halfOfCusp().reversed()).end, 1);
  EXPECT_EQ(stoppedEnds(curveOf({{1, 2}, {1, 2}, {1, 2}, {3, 5}})).start, 2);
  EXPECT_FALSE(stoppedEnds(curveOf({{0, 0}, {1, 0}, {1, 0}, {2, 1}})).any());
  EXPECT_FALSE(stoppedEnds(curveOf({{1, 2}, {1, 2}, {1, 2}})).any());
  EXPECT_TRUE(isPoint(curveOf({{1, 2}, {1, 2}, {1, 2}})));
  EXPECT_FALSE(isPoint(halfOfCusp()));
}

TEST(StoppedEnds, RoundingOfEqualPolesDoesNotCount) {
  BezierCurve curve = curveOf({{0.1, 0.7}, {0.1, 0.7}, {0.3, 0.9}, {1.3, 0.7}});
  for (int i = 0; i < 4; ++i) curve = curve.elevated();
  EXPECT_EQ(stoppedEnds(curve).start, 1);
  const Eigen::Vector4d weights(0.7, 1.3, 0.9, 1.1);
  const BezierCurve rational(rowsOf({{0.1, 0.7}, {0.1, 0.7}, {0.3, 0.9}, {1.3, 0.7}}), weights);
  EXPECT_EQ(stoppedEnds(rational).start, 1);
}

// Identity (1).
TEST(StoppedEnds, TheTangentIsTheLimitOfTheDirection) {
  const Eigen::Vector4d weights(0.7, 1.3, 0.9, 1.1);
  for (const BezierCurve& curve :
       {halfOfCusp(), slowParabola(), curveOf({{0, 0}, {0, 0}, {0, 0}, {-1, 2}}),
        BezierCurve(rowsOf({{3, 1}, {3, 1}, {4, 3}, {9, 9}}), weights)}) {
    const auto start = stoppedTangent(curve, 0);
    ASSERT_TRUE(start);
    const Eigen::RowVector3d near = curve.derivatives(1e-7, 1).row(1);
    EXPECT_LT((near.normalized() - start->transpose()).norm(), 1e-6);
    const auto end = stoppedTangent(curve.reversed(), 1);
    ASSERT_TRUE(end);
    EXPECT_EQ(*end, -*start);
    EXPECT_FALSE(stoppedTangent(curve, 1));
    EXPECT_FALSE(stoppedTangent(curve, 0.5));
  }
}

// Identity (6) of planarCurvatureProfile().
TEST(StoppedEnds, TheCurvatureBesideACuspFalls) {
  const CurvatureProfile profile = planarCurvatureProfile(halfOfCusp());
  EXPECT_TRUE(profile.monotone());
  EXPECT_THAT(profile.inflections, IsEmpty());
  EXPECT_TRUE(planarCurvatureProfile(halfOfCusp().reversed()).monotone());
}

// y = x^2 from (-1, 1): the vertex is at (0, 0), where (1 - (1 - t)^2) of [-1, 1] is 1 / 2.
TEST(StoppedEnds, ExtremaAreThoseOfTheCurveInAnotherParameter) {
  // x = -1 + 2 t^2, y = x^2 = 1 - 4 t^2 + 4 t^4.
  const BezierCurve slow = curveOf({{-1, 1}, {-1, 1}, {-2.0 / 3, 1.0 / 3}, {0, -1}, {1, 1}});
  const CurvatureProfile profile = planarCurvatureProfile(slow);
  ASSERT_THAT(profile.extrema, SizeIs(1));
  EXPECT_NEAR(profile.extrema[0].parameters.middle(), std::sqrt(0.5), 1e-10);
  EXPECT_NEAR(profile.extrema[0].curvature_per_mm, 2, 1e-9);
  EXPECT_TRUE(profile.extrema[0].maximum);
  const CurvatureProfile space = spaceCurvatureProfile(slow);
  ASSERT_THAT(space.extrema, SizeIs(1));
  EXPECT_NEAR(space.extrema[0].parameters.middle(), std::sqrt(0.5), 1e-10);
}

// Both ends: x = 3 s^2 - 2 s^3 and the parabola y = x^2 from -1 to 1, in the parameter s.
TEST(StoppedEnds, BothEndsCanStop) {
  // x = -1 + 6 s^2 - 4 s^3, so the sixth degree of y has the poles of x^2.
  const BernsteinPolynomial x(Eigen::Vector4d(-1, -1, 1, 1));
  const BernsteinPolynomial y = x * x, raised = x.elevated(3);
  std::vector<Vector2d> poles;
  for (int i = 0; i <= 6; ++i) poles.emplace_back(raised.coefficients()[i], y.coefficients()[i]);
  const BezierCurve curve = curveOf(poles);
  ASSERT_EQ(stoppedEnds(curve).start, 1);
  ASSERT_EQ(stoppedEnds(curve).end, 1);
  const CurvatureProfile profile = planarCurvatureProfile(curve);
  ASSERT_THAT(profile.extrema, SizeIs(1));
  EXPECT_NEAR(profile.extrema[0].parameters.middle(), 0.5, 1e-10);
  EXPECT_NEAR(startCurvature(curve).curvature_per_mm, 2 / std::pow(5, 1.5), 1e-12);
  EXPECT_NEAR(endCurvature(curve).curvature_per_mm, 2 / std::pow(5, 1.5), 1e-12);
}

// Identity (7) of EndCurvature.
TEST(StoppedEnds, WhereTheSpeedIsAboveZeroTheCurvatureIsThatOfTheDerivatives) {
  const Eigen::Vector4d weights(0.7, 1.3, 0.9, 1.1);
  const BezierCurve curve(rowsOf({{3, 1}, {4, 1}, {4, 3}, {9, 9}}), weights);
  for (const double t : {0.0, 1.0}) {
    const CurveDerivatives d = curve.derivatives(t, 2);
    const double expected = (d(1, 0) * d(2, 1) - d(1, 1) * d(2, 0)) / std::pow(d.row(1).norm(), 3);
    const EndCurvature found = t == 0 ? startCurvature(curve) : endCurvature(curve);
    EXPECT_NEAR(found.curvature_per_mm, expected, 1e-12 * std::abs(expected));
    EXPECT_TRUE(found.finite_energy);
  }
}

// Identity (8) of EndCurvature.
TEST(StoppedEnds, TheCurvatureAtAStopIsItsLimit) {
  EXPECT_EQ(startCurvature(halfOfCusp()).curvature_per_mm, infinite);
  EXPECT_FALSE(startCurvature(halfOfCusp()).finite_energy);
  EXPECT_EQ(endCurvature(halfOfCusp().reversed()).curvature_per_mm, -infinite);
  EXPECT_NEAR(startCurvature(slowParabola()).curvature_per_mm, 2, 1e-12);
  EXPECT_TRUE(startCurvature(slowParabola()).finite_energy);
  const BezierCurve line = curveOf({{0, 0}, {0, 0}, {3, 4}, {3, 4}});
  EXPECT_EQ(startCurvature(line).curvature_per_mm, 0);
  EXPECT_EQ(endCurvature(line).curvature_per_mm, 0);
}

TEST(StoppedEnds, FiguresOfAChain) {
  const ChainFigures line = figuresOf(
      {.curves = {bezierAsSpline(curveOf({{0, 0}, {0, 0}, {3, 4}, {3, 4}}))}, .closed = false});
  EXPECT_NEAR(line.length_mm, 5, 1e-8);
  EXPECT_NEAR(line.energy_per_mm, 0, 1e-20);
  EXPECT_EQ(line.extrema + line.inflections, 0);
  const ChainFigures half = figuresOf({.curves = {bezierAsSpline(halfOfCusp())}, .closed = false});
  // (8 / 27) ((1 + 9 / 4)^(3/2) - 1).
  EXPECT_NEAR(half.length_mm, 8.0 / 27 * (std::pow(3.25, 1.5) - 1), 1e-8);
  EXPECT_EQ(half.energy_per_mm, infinite);
  EXPECT_EQ(half.extrema + half.inflections, 0);
  // Backwards to the end, and on along the curve turned by half a turn: one change of the sign.
  const BezierCurve other = curveOf({{0, 0}, {0, 0}, {-1.0 / 3, 0}, {-1, -1}});
  const ChainFigures both =
      figuresOf({.curves = {bezierAsSpline(halfOfCusp().reversed()), bezierAsSpline(other)},
                 .closed = false});
  EXPECT_EQ(both.inflections, 1);
}

TEST(StoppedEnds, SpansWithoutLengthAreLeftOut) {
  BSplineCurve curve{3, {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4}, HomogeneousPoles(7, 4)};
  curve.poles << 0, 0, 0, 1, 1, 0.5, 0, 1, 1.3, 0.7, 0, 1, 1.3, 0.7, 0, 1, 1.3, 0.7, 0, 1, 1.3, 0.7,
      0, 1, 3, 2, 0, 1;
  const std::vector<BezierCurve> spans = bezierCurves(curve);
  ASSERT_THAT(spans, SizeIs(3));
  for (const BezierCurve& span : spans) EXPECT_FALSE(isPoint(span));
  EXPECT_EQ(figuresOf({.curves = {curve}, .closed = false}).inflections, 0);
}

TEST(StoppedEnds, EqualPolesMoveAcrossAGap) {
  const BezierCurve before = curveOf({{0, 0}, {1, 0}, {2, 1}, {2, 1}});
  const BezierCurve after = curveOf({{2, 1 + 1e-7}, {3, 2}, {4, 2}, {5, 2}});
  const BezierSpline spline = splineOverLengths({before, after}, false, 1e-6);
  EXPECT_EQ(spline.poles.row(2), spline.poles.row(3));
  EXPECT_EQ(stoppedEnds(segment(spline, 0)).end, 1);
}

/// The largest distance of points from y = 10 (x / 10)^(3/2) across it.
double distanceAcross(const Vector2d& point) {
  const double x = std::max(point.x(), 0.0);
  return std::abs(point.y() - 10 * std::pow(x / 10, 1.5)) /
         std::sqrt(1 + 2.25 * std::min(x / 10, 1.0));
}

TEST(StoppedEnds, ArcsClothoidsAndConicsBesideACusp) {
  const BezierSpline curve = splineOverLengths({halfOfCusp(10)});
  const double tolerance_mm = 1e-3, room = 1.01 * tolerance_mm;
  const ArcFit arcs = fitArcs(curve, {.tolerance_mm = tolerance_mm});
  EXPECT_LE(arcs.distance_mm, tolerance_mm);
  EXPECT_LT(arcs.arcs.size(), 60U);
  EXPECT_NEAR(arcs.arcs.front().direction_rad, 0, 1e-12);
  for (const PlanarArc& arc : arcs.arcs)
    for (const BezierCurve& one : bezierCurves(arc))
      for (int k = 0; k <= 20; ++k) EXPECT_LE(distanceAcross(one.point(k / 20.0).head<2>()), room);
  const ClothoidFit clothoids = fitClothoids(curve, {.tolerance_mm = tolerance_mm});
  EXPECT_LE(clothoids.distance_mm, tolerance_mm);
  EXPECT_LT(clothoids.pieces.size(), 60U);
  for (const Clothoid& piece : clothoids.pieces) EXPECT_LE(distanceAcross(piece.end()), room);
  const ConicFit conics = fitConics(curve, {.tolerance_mm = tolerance_mm});
  EXPECT_LE(conics.distance_mm, tolerance_mm);
  EXPECT_LT(conics.conics.size(), 60U);
  for (const PlanarConic& conic : conics.conics)
    for (int k = 0; k <= 20; ++k)
      EXPECT_LE(distanceAcross(bezierCurve(conic).point(k / 20.0).head<2>()), room);
}

TEST(StoppedEnds, ALineWithEqualPolesIsOneLine) {
  const BezierSpline line = splineOverLengths({curveOf({{0, 0}, {0, 0}, {30, 40}, {30, 40}})});
  const ArcFit fit = fitArcs(line, {.tolerance_mm = 1e-3});
  ASSERT_THAT(fit.arcs, SizeIs(1));
  EXPECT_NEAR(fit.arcs[0].curvature_per_mm, 0, 1e-15);
  EXPECT_NEAR(fit.arcs[0].length_mm, 50, 1e-12);
}

TEST(StoppedEnds, ACuspInsideIsRefused) {
  const BezierCurve cusp = curveOf({{0, 0}, {10, 10}, {0, 10}, {10, 0}});
  EXPECT_THROW(planarCurvatureProfile(cusp), std::domain_error);
  EXPECT_THROW(startCurvature(cusp), std::domain_error);
  EXPECT_THROW(fitArcs(splineOverLengths({cusp}), {.tolerance_mm = 1e-3}), std::domain_error);
}

}  // namespace
}  // namespace seamwright
