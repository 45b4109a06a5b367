// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc_fit.hpp>
#include <seamwright/core/planar/clothoid.hpp>
#include <seamwright/core/planar/free_arcs.hpp>

#include "planar.hpp"

/// How many arcs are near a curve, and how few can be.
namespace seamwright {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;
using test::uniform;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// The largest distance of points from the best circle around a centre.
double widthAround(const std::array<Vector2d, 4>& points, const Vector2d& centre) {
  double nearest = infinite, furthest = 0;
  for (const Vector2d& point : points) {
    nearest = std::min(nearest, (point - centre).norm());
    furthest = std::max(furthest, (point - centre).norm());
  }
  return (furthest - nearest) / 2;
}

// Identity (1) of circleOfFour().
TEST(FreeArcs, NoCircleIsNearerToFourPoints) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 30; ++i) {
    std::array<Vector2d, 4> points;
    for (Vector2d& point : points)
      point = {uniform(random, -1, 1), uniform(random, -1, 1) * (i % 2 == 0 ? 1 : 0.05)};
    const FourPointCircle best = circleOfFour(points);
    if (best.normal.isZero(0)) {
      EXPECT_NEAR(widthAround(points, best.centre), best.distance_mm, 1e-9);
    }
    for (int k = 0; k < 20000; ++k) {
      const double away = std::pow(10, uniform(random, -2, 4));
      const Vector2d centre = away * unitVector(uniform(random, 0, 2 * pi));
      ASSERT_GE(widthAround(points, centre), best.distance_mm * (1 - 1e-9) - 1e-10);
    }
  }
}

// Identity (2) of freeArcEnds().
TEST(FreeArcs, OfArcsAreNotMoreThanThese) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 20; ++i) {
    PlanarArc arc;
    std::vector<Vector2d> points;
    const int count = 1 + i % 6;
    const double tolerance = 0.01;
    for (int k = 0; k < count; ++k) {
      arc.curvature_per_mm = uniform(random, -0.5, 0.5);
      arc.length_mm = uniform(random, 1, 6);
      for (int j = 0; j < 60; ++j) {
        const double s = arc.length_mm * j / 60;
        const Vector2d across = unitVector(arc.directionAt_rad(s) + pi / 2);
        points.push_back(arc.point(s) + uniform(random, -tolerance, tolerance) * across);
      }
      arc = {.start = arc.end(), .direction_rad = arc.endDirection_rad()};
    }
    EXPECT_LE(freeArcEnds(points, tolerance).size(), static_cast<std::size_t>(count));
  }
}

TEST(FreeArcs, TheNearestCircleOfARunThatIsNearlyStraightIsBesideIt) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 2000; ++i) {
    const double curvature_per_mm = i % 4 == 0 ? 0 : std::pow(10, uniform(random, -12, -3));
    const double noise_mm = std::pow(10, uniform(random, -12, -3));
    const PlanarArc arc{.start = {uniform(random, -300, 300), uniform(random, -300, 300)},
                        .direction_rad = uniform(random, -3, 3),
                        .curvature_per_mm = curvature_per_mm,
                        .length_mm = uniform(random, 1, 90)};
    std::vector<Vector2d> points;
    constexpr int last = 40;
    for (int k = 0; k <= last; ++k)
      points.push_back(arc.point(arc.length_mm * k / last) +
                       noise_mm * Vector2d(uniform(random, -1, 1), uniform(random, -1, 1)));
    const ArcStart found = nearestCircle(points, points[last / 2]);
    EXPECT_LT((found.point - points[last / 2]).norm(), 4 * noise_mm + 1e-12)
        << noise_mm << ' ' << curvature_per_mm;
  }
}

TEST(ArcCount, OfAClothoidIsNearThatOfTheIdealChain) {
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    const Clothoid clothoid = {
        .curvature_per_mm = 0.02, .curvature_slope_per_mm2 = 0.01, .length_mm = 30};
    const BezierSpline curve = bezierSpline({clothoid}, tolerance * 1e-4, false, 1e-9).curve;
    const ArcFit fit = fitArcs(curve, {.tolerance_mm = tolerance});
    const double ideal = 30 * std::cbrt(0.01 / (72 * std::sqrt(3.0) * tolerance));
    const double free = 30 * std::cbrt(0.01 / (192 * tolerance));
    const auto arcs = static_cast<double>(fit.arcs.size());
    EXPECT_GE(arcs, fit.least_arcs);
    EXPECT_LE(arcs, 1.2 * ideal + 3) << ideal;
    EXPECT_GE(fit.least_arcs, 0.9 * free);
    EXPECT_LE(fit.least_arcs, free + 3);
  }
}

BezierSpline polygon(const PlanarPoints& points, bool closed = true) {
  std::vector<BezierCurve> sides;
  std::vector<double> knots = {0};
  for (Eigen::Index i = 0; i + (closed ? 0 : 1) < points.rows(); ++i) {
    Poles poles = Poles::Zero(2, 3);
    poles.leftCols(2) << points.row(i), points.row((i + 1) % points.rows());
    sides.emplace_back(poles);
    knots.push_back(static_cast<double>(i + 1));
  }
  return bezierSpline(sides, knots, closed, 1e-9);
}

TEST(ArcCount, OfPointsNearALineIsOneLine) {
  std::mt19937_64 random(testSeed());
  PlanarPoints points(101, 2);
  for (int i = 0; i <= 100; ++i) points.row(i) << i, uniform(random, -0.004, 0.004);
  const ArcFit fit = fitArcs(polygon(points, false), {.tolerance_mm = 0.01});
  ASSERT_THAT(fit.arcs, SizeIs(1));
  EXPECT_EQ(fit.arcs.front().curvature_per_mm, 0);
}

/// Exact samples of a chain of arcs and lines, without its end.
PlanarPoints chainSamples(const std::vector<PlanarArc>& arcs) {
  const int count = 200;
  PlanarPoints points(count * static_cast<int>(arcs.size()), 2);
  Eigen::Index row = 0;
  for (const PlanarArc& arc : arcs)
    for (int i = 0; i < count; ++i)
      points.row(row++) = arc.point(arc.length_mm * i / count).transpose();
  return points;
}

TEST(ArcCount, OfSamplesOfLinesAndArcsIsThatOfThese) {
  std::vector<PlanarArc> stadium;
  PlanarArc arc;
  for (int i = 0; i < 4; ++i) {
    arc.curvature_per_mm = i % 2 == 0 ? 0 : 0.05;
    arc.length_mm = i % 2 == 0 ? 100 : 20 * pi;
    stadium.push_back(arc);
    arc = {.start = arc.end(), .direction_rad = arc.endDirection_rad()};
  }
  const ArcFit fit = fitArcs(polygon(chainSamples(stadium)), {.tolerance_mm = 0.01});
  EXPECT_THAT(fit.arcs, SizeIs(4));
  EXPECT_EQ(std::ranges::count(fit.arcs, 0.0, &PlanarArc::curvature_per_mm), 2);
  EXPECT_THAT(fit.corners, IsEmpty());
}

PlanarPoints regularPolygon(int corners, double radius) {
  PlanarPoints points(corners, 2);
  for (int i = 0; i < corners; ++i)
    points.row(i) = (radius * unitVector(2 * pi * i / corners)).transpose();
  return points;
}

// A circle of many sides: identities (1) and (4) of fitArcs().
TEST(ArcCount, OfAPolygonThatSamplesACircleIsSmall) {
  for (const double tolerance : {0.01, 0.001}) {
    const ArcFit fit = fitArcs(polygon(regularPolygon(360, 50)), {.tolerance_mm = tolerance});
    EXPECT_THAT(fit.arcs, SizeIs(1));
    EXPECT_THAT(fit.corners, IsEmpty());
    EXPECT_LE(fit.distance_mm, tolerance);
    for (const PlanarArc& arc : fit.arcs)
      for (int i = 0; i <= 100; ++i) {
        const double radius = arc.point(arc.length_mm * i / 100).norm();
        EXPECT_LE(radius, 50 + tolerance);
        EXPECT_GE(radius, 50 * std::cos(pi / 360) - tolerance);
      }
  }
}

TEST(ArcCount, OfAPolygonWithCornersIsThatOfItsSides) {
  for (const int corners : {3, 4, 6, 12}) {
    const ArcFit fit = fitArcs(polygon(regularPolygon(corners, 50)));
    EXPECT_THAT(fit.arcs, SizeIs(corners));
    EXPECT_THAT(fit.corners, SizeIs(corners));
    for (const PlanarArc& arc : fit.arcs) EXPECT_EQ(arc.curvature_per_mm, 0);
  }
}

TEST(ArcCount, OfAStaircaseIsSmall) {
  // A circle on a grid of 0.1 mm.
  PlanarPoints points(400, 2);
  Eigen::Index count = 0;
  for (int i = 0; i < 100000; ++i) {
    const Vector2d at = 100 * unitVector(2 * pi * i / 100000);
    const Eigen::RowVector2d pixel(std::round(at.x()), std::round(at.y()));
    if (count > 0 && (0.1 * pixel).isApprox(points.row(count - 1), 1e-9)) continue;
    if (count == points.rows()) points.conservativeResize(2 * count, 2);
    points.row(count++) = 0.1 * pixel;
  }
  points.conservativeResize(count - 1, 2);
  const ArcFit fit = fitArcs(polygon(points), {.tolerance_mm = 0.1});
  EXPECT_LE(fit.arcs.size(), 8U);
  EXPECT_THAT(fit.corners, IsEmpty());
}

}  // namespace
}  // namespace seamwright
