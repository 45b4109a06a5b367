// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/planar_chain.hpp>
#include <seamwright/core/planar/plane_frame.hpp>

#include "planar.hpp"

namespace seamwright {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;
using test::uniform;
using ::testing::SizeIs;

Poles randomPoints(std::mt19937_64& random, int count, double height) {
  Poles points(count, 3);
  for (Eigen::Index i = 0; i < count; ++i)
    points.row(i) << uniform(random, -9, 9), uniform(random, -9, 9),
        uniform(random, -height, height);
  return points;
}

double sumOfSquares(const Poles& points, const Vector3d& normal) {
  return ((points.rowwise() - points.colwise().mean()) * normal).squaredNorm();
}

TEST(PlaneFrame, Identity1CoordinatePlanesHaveTheCoordinatesOfSpace) {
  std::mt19937_64 random(testSeed());
  for (const int axis : {0, 1, 2}) {
    Poles points = randomPoints(random, 9, 9);
    points.col(axis).setConstant(0.3);
    const FittedPlane plane = fitPlane(points);
    EXPECT_EQ(plane.distance_mm, 0);
    const PlanarPoints inside = coordinatesIn(plane.frame, points);
    EXPECT_EQ(inside.col(0), points.col(axis == 0 ? 1 : 0));
    EXPECT_EQ(inside.col(1), points.col(axis == 2 ? 1 : 2));
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      EXPECT_EQ(plane.frame.point(inside.row(i).transpose()), points.row(i).transpose());
    // A rounding of one point changes nothing.
    points(4, axis) = std::nextafter(0.3, 1);
    EXPECT_EQ(fitPlane(points).frame.x, plane.frame.x);
  }
}

TEST(PlaneFrame, Identity2RigidMotionsMoveThePlane) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 200; ++trial) {
    const Poles points = randomPoints(random, 12, 0.5);
    const FittedPlane plane = fitPlane(points);
    const Eigen::AngleAxisd turn(uniform(random, -3, 3), Vector3d(1, 2, 3).normalized());
    const Vector3d shift(4, -5, 6);
    const Poles moved =
        (points * turn.toRotationMatrix().transpose()).rowwise() + shift.transpose();
    const FittedPlane after = fitPlane(moved);
    EXPECT_NEAR(after.distance_mm, plane.distance_mm, 1e-12);
    EXPECT_NEAR(std::abs(after.frame.normal().dot(turn * plane.frame.normal())), 1, 1e-12);
    EXPECT_NEAR(after.frame.height_mm(turn * plane.frame.origin + shift), 0, 1e-12);
  }
}

TEST(PlaneFrame, Identity3NoOtherPlaneHasASmallerSum) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 50; ++trial) {
    const Poles points = randomPoints(random, 12, 3);
    const PlaneFrame frame = fitPlane(points).frame;
    const double least = sumOfSquares(points, frame.normal());
    for (int other = 0; other < 100; ++other) {
      const Vector3d tilt(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
      EXPECT_GE(sumOfSquares(points, (frame.normal() + 0.1 * tilt).normalized()),
                least * (1 - 1e-12));
    }
  }
}

TEST(PlaneFrame, LinesAndPointsHaveAPlane) {
  Poles points(3, 3);
  points << 0, 0, 0, 1, 2, 3, 2, 4, 6;
  const FittedPlane plane = fitPlane(points);
  EXPECT_LT(plane.distance_mm, 1e-14);
  EXPECT_NEAR(plane.frame.normal().norm(), 1, 1e-15);
  EXPECT_EQ(fitPlane(points.topRows(1)).distance_mm, 0);
  EXPECT_THROW(fitPlane(points.topRows(0)), std::invalid_argument);
  points(1, 1) = NAN;
  EXPECT_THROW(fitPlane(points), std::invalid_argument);
}

PlanarArc circle(double radius) {
  return {.start = {radius, 0},
          .direction_rad = pi / 2,
          .curvature_per_mm = 1 / radius,
          .length_mm = 2 * pi * radius};
}

/// An ellipse as four conics.
PlanarChain ellipse(double a, double b) {
  const auto quarter = [&](double u) -> ChainCurve {
    const auto at = [&](double v) { return Vector2d(a * std::cos(v), b * std::sin(v)); };
    return PlanarConic{at(u), std::sqrt(2.0) * at(u + pi / 4), at(u + pi / 2), std::sqrt(0.5)};
  };
  return {.curves = {quarter(0), quarter(pi / 2), quarter(pi), quarter(1.5 * pi)}, .closed = true};
}

BSplineCurve randomSpline(std::mt19937_64& random) {
  BSplineCurve spline;
  spline.degree = 3;
  spline.knots = {0.1, 0.1, 0.1, 0.1, 0.4, 0.9, 1.3, 1.3, 1.3, 1.3};
  spline.poles.resize(6, 4);
  for (Eigen::Index i = 0; i < 6; ++i)
    spline.poles.row(i) << static_cast<double>(2 * i), uniform(random, -1, 1), 0, 1;
  return spline;
}

TEST(PlanarChain, Identity1ReversingTwiceGivesTheCurve) {
  std::mt19937_64 random(testSeed());
  const ChainCurve spline = randomSpline(random);
  const ChainCurve conic = PlanarConic{{0, 0}, {2, 1}, {3, 4}, 0.7};
  const ChainCurve arc = PlanarArc{{1, 2}, 0.4, 0.3, 5};
  for (const ChainCurve& curve : {spline, conic, arc}) {
    const ChainCurve back = reversed(curve), twice = reversed(back);
    EXPECT_LT((startOf(back) - endOf(curve)).norm(), 1e-14);
    EXPECT_LT((endOf(back) - startOf(curve)).norm(), 1e-14);
    const auto one = bezierCurves(curve), other = bezierCurves(twice);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i)
      for (const double t : {0.0, 0.3, 0.8, 1.0}) {
        EXPECT_LT((one[i].point(t) - other[i].point(t)).norm(), 1e-13);
        EXPECT_LT((one[i].point(t) - bezierCurves(back)[one.size() - 1 - i].point(1 - t)).norm(),
                  1e-13);
      }
  }
}

TEST(PlanarChain, Identity2TheSplineHasThePointsOfTheCurves) {
  std::mt19937_64 random(testSeed());
  const BSplineCurve spline = randomSpline(random);
  const PlanarConic conic{endOf(spline), {15, 0}, {16, 4}, 0.7};
  const PlanarArc arc{conic.end, 1.2, 0.3, 5};
  const PlanarChain chain{.curves = {spline, conic, arc}, .closed = false};
  const BezierSpline whole = bezierSpline(chain, 1e-12);
  EXPECT_EQ(whole.degree, 3);
  std::vector<BezierCurve> parts;
  for (const ChainCurve& curve : chain.curves)
    for (const BezierCurve& one : bezierCurves(curve)) parts.push_back(one);
  ASSERT_EQ(whole.segments(), static_cast<int>(parts.size()));
  for (int i = 0; i < whole.segments(); ++i)
    for (const double t : {0.0, 0.2, 0.7, 1.0})
      EXPECT_LT((segment(whole, i).point(t) - parts[static_cast<std::size_t>(i)].point(t)).norm(),
                1e-13);
  EXPECT_THROW(bezierSpline(PlanarChain{.curves = {arc, conic}, .closed = false}, 1e-3),
               std::invalid_argument);
}

TEST(PlanarChain, Identity3FiguresOfACircle) {
  for (const double radius : {1e-3, 1.0, 250.0}) {
    const ChainFigures figures = figuresOf({.curves = {circle(radius)}, .closed = true});
    EXPECT_NEAR(figures.length_mm, 2 * pi * radius, 1e-12 * radius);
    EXPECT_NEAR(figures.energy_per_mm, 2 * pi / radius, 1e-12 / radius);
    EXPECT_EQ(figures.extrema, 0);
    EXPECT_EQ(figures.inflections, 0);
    // The same circle as conics.
    PlanarChain round = ellipse(radius, radius);
    EXPECT_NEAR(figuresOf(round).energy_per_mm, 2 * pi / radius, 1e-9 / radius);
    EXPECT_NEAR(figuresOf(round).length_mm, 2 * pi * radius, 1e-8 * radius);
    EXPECT_EQ(figuresOf(round).extrema, 0);
  }
}

TEST(PlanarChain, Identity4AnEllipseHasFourExtrema) {
  for (const double b : {0.3, 0.9, 1.7}) {
    const ChainFigures figures = figuresOf(ellipse(1, b));
    EXPECT_EQ(figures.extrema, 4);
    EXPECT_EQ(figures.inflections, 0);
  }
  // The length of the ellipse 2 : 1, by its elliptic integral.
  EXPECT_NEAR(figuresOf(ellipse(2, 1)).length_mm, 9.688448220547675, 1e-7);
}

TEST(PlanarChain, Identity5CornersAreNoExtrema) {
  const auto turning = [](const std::vector<double>& curvatures, std::size_t corner, bool closed) {
    PlanarChain chain{.curves = {}, .closed = closed};
    PlanarArc arc;
    for (std::size_t i = 0; i < curvatures.size(); ++i) {
      arc = {.start = arc.end(),
             .direction_rad = arc.direction_rad + arc.curvature_per_mm * arc.length_mm,
             .curvature_per_mm = curvatures[i],
             .length_mm = 1};
      if (i == corner) arc.direction_rad += 1.5;
      chain.curves.emplace_back(arc);
    }
    return chain;
  };
  constexpr std::size_t none = 99;
  const ChainFigures smooth = figuresOf(turning({1, 2, -1, -2, 0.5}, none, false));
  EXPECT_EQ(smooth.extrema, 2);
  EXPECT_EQ(smooth.inflections, 2);
  // 1, 2 | -1, -2, 0.5
  const ChainFigures cut = figuresOf(turning({1, 2, -1, -2, 0.5}, 2, false));
  EXPECT_EQ(cut.extrema, 1);
  EXPECT_EQ(cut.inflections, 1);
  EXPECT_EQ(cut.energy_per_mm, smooth.energy_per_mm);
  // Closed smoothly: 4 arcs with a whole turn; with a corner the run 3, 4 goes on with 1, 2.
  const double part = pi / 5;
  PlanarChain ring = turning({part, 2 * part, 3 * part, 4 * part}, none, true);
  EXPECT_EQ(figuresOf(ring).extrema, 2);
  std::get<PlanarArc>(ring.curves[0]).direction_rad += 1;
  std::get<PlanarArc>(ring.curves[1]).direction_rad += 1;
  // 3, 4 | 1, 2 up to the corners before 1 and 3.
  EXPECT_EQ(figuresOf(ring).extrema, 0);
  // With the one before 3 alone: 3, 4, 1, 2.
  ring = turning({part, 2 * part, 3 * part, 4 * part}, 2, true);
  for (const std::size_t i : {0U, 1U}) std::get<PlanarArc>(ring.curves[i]).direction_rad += 1.5;
  EXPECT_EQ(figuresOf(ring).extrema, 2);
}

TEST(PlanarChain, CountsOfASequence) {
  EXPECT_EQ(turnsOf({1, 2, 3}, false, 0).extrema, 0);
  EXPECT_EQ(turnsOf({1, 2, 3}, true, 0).extrema, 2);
  EXPECT_EQ(turnsOf({1, 3, 2, 4}, false, 0).extrema, 2);
  EXPECT_EQ(turnsOf({1, 3, 3.5, 4}, false, 1).extrema, 0);
  EXPECT_EQ(turnsOf({1, 1.1, 1, 1.1}, false, 0.2).extrema, 0);
  EXPECT_EQ(turnsOf({1, -1, 0, -1, 2}, false, 0.5).inflections, 2);
  EXPECT_EQ(turnsOf({1, -1}, true, 0).inflections, 2);
  EXPECT_EQ(turnsOf({}, true, 0).inflections, 0);
}

}  // namespace
}  // namespace seamwright
