// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/planar/clothoid_spline.hpp>

#include "planar.hpp"

namespace seamwright {
namespace {

using std::numbers::pi;
using test::angleBetween;
using test::uniform;

PlanarPoints randomWalk(Eigen::Index count, std::mt19937_64& random) {
  PlanarPoints points(count, 2);
  Eigen::RowVector2d at(uniform(random, -5, 5), uniform(random, -5, 5));
  double direction = uniform(random, -3, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    points.row(i) = at;
    direction += uniform(random, -0.8, 0.8);
    at += uniform(random, 0.5, 2) * Eigen::RowVector2d(std::cos(direction), std::sin(direction));
  }
  return points;
}

PlanarPoints ring(Eigen::Index count, double spread, std::mt19937_64& random) {
  PlanarPoints points(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(count);
    points.row(i) = 5 * (1 + uniform(random, -spread, spread)) *
                    Eigen::RowVector2d(std::cos(angle), std::sin(angle));
  }
  return points;
}

void expectG2(const ClothoidSpline& spline, const PlanarPoints& points) {
  const std::size_t count = spline.pieces.size();
  for (std::size_t s = 0; s < count; ++s) {
    const Clothoid& piece = spline.pieces[s];
    const Eigen::Index next = static_cast<Eigen::Index>(s + 1) % points.rows();
    EXPECT_EQ(piece.start, points.row(static_cast<Eigen::Index>(s)).transpose());
    EXPECT_LT((piece.end() - points.row(next).transpose()).norm(), 1e-12);
    if (s + 1 == count && !spline.closed) continue;
    const Clothoid& after = spline.pieces[(s + 1) % count];
    EXPECT_LT(angleBetween(piece.directionAt_rad(piece.length_mm), after.direction_rad), 1e-12);
    EXPECT_NEAR(piece.curvatureAt_per_mm(piece.length_mm), after.curvature_per_mm, 1e-10);
  }
}

// Identity (1), with each kind of ends.
TEST(ClothoidSpline, NeighboursAgreeInPositionTangentAndCurvature) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const PlanarPoints points = randomWalk(2 + static_cast<Eigen::Index>(random() % 12), random);
    ClothoidSplineOptions options;
    if (i % 3 == 1) options.start.curvature_per_mm = uniform(random, -0.3, 0.3);
    if (i % 3 == 2) options.end.direction_rad = tangentsAt(points).directions_rad.back() + 0.2;
    const ClothoidSpline spline = clothoidSpline(points, options);
    expectG2(spline, points);
    const Clothoid& last = spline.pieces.back();
    EXPECT_NEAR(spline.pieces.front().curvature_per_mm, options.start.curvature_per_mm, 1e-10);
    if (options.end.direction_rad)
      EXPECT_LT(angleBetween(last.directionAt_rad(last.length_mm), *options.end.direction_rad),
                1e-12);
    else
      EXPECT_NEAR(last.curvatureAt_per_mm(last.length_mm), 0, 1e-10);
    EXPECT_LT(spline.curvature_jump_per_mm, 1e-10);
  }
}

TEST(ClothoidSpline, ClosedIsG2AllAround) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 60; ++i) {
    const PlanarPoints points = ring(4 + static_cast<Eigen::Index>(random() % 9), 0.15, random);
    const ClothoidSpline spline = clothoidSpline(points, {.closed = true});
    EXPECT_EQ(spline.pieces.size(), static_cast<std::size_t>(points.rows()));
    expectG2(spline, points);
    const SplineWithin bezier = bezierSpline(spline.pieces, 1e-6, true, 1e-9);
    for (const CurveJoint& joint : measureJoints(bezier.curve, 2))
      EXPECT_EQ(orderReached(joint, {}), 2);
  }
}

// Identity (2).
TEST(ClothoidSpline, PointsOfACircleGiveTheCircle) {
  std::mt19937_64 random(testSeed());
  const PlanarPoints points = ring(7, 0, random);
  for (const Clothoid& piece : clothoidSpline(points, {.closed = true}).pieces) {
    EXPECT_NEAR(piece.curvature_per_mm, 0.2, 1e-12);
    EXPECT_NEAR(piece.curvature_slope_per_mm2, 0, 1e-12);
  }
  ClothoidSplineOptions options;
  options.start.curvature_per_mm = 0.2;
  options.end.direction_rad = std::atan2(points(6, 0), -points(6, 1));
  for (const Clothoid& piece : clothoidSpline(points, options).pieces)
    EXPECT_NEAR(piece.curvature_per_mm, 0.2, 1e-10);
}

// Identity (4).
TEST(ClothoidSpline, ArcsAtTheEndsFollowACircle) {
  std::mt19937_64 random(testSeed());
  for (const Eigen::Index count : {3, 4, 9}) {
    ClothoidSplineOptions options;
    options.start.arc = options.end.arc = true;
    for (const Clothoid& piece :
         clothoidSpline(ring(12, 0, random).topRows(count), options).pieces) {
      EXPECT_NEAR(piece.curvature_per_mm, 0.2, 1e-11);
      EXPECT_NEAR(piece.curvature_slope_per_mm2, 0, 1e-11);
    }
    const ClothoidSpline other = clothoidSpline(randomWalk(count, random), options);
    EXPECT_NEAR(other.pieces.front().curvature_slope_per_mm2, 0, 1e-8);
    EXPECT_NEAR(other.pieces.back().curvature_slope_per_mm2, 0, 1e-8);
  }
}

// Identity (3).
TEST(ClothoidSpline, ReversedAndMovedPointsGiveReversedAndMovedSplines) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 40; ++i) {
    const PlanarPoints points = randomWalk(8, random);
    const ClothoidSpline found = clothoidSpline(points);
    const ClothoidSpline back = clothoidSpline(points.colwise().reverse());
    const double turn = uniform(random, -3, 3), scale = uniform(random, 0.01, 100);
    Eigen::Matrix2d rotation;
    rotation << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn);
    PlanarPoints moved = scale * points * rotation.transpose();
    moved.rowwise() += Eigen::RowVector2d(3, -4);
    const ClothoidSpline of_moved = clothoidSpline(moved);
    const std::size_t count = found.directions_rad.size();
    for (std::size_t k = 0; k < count; ++k) {
      EXPECT_LT(angleBetween(back.directions_rad[count - 1 - k], found.directions_rad[k] + pi),
                1e-11);
      EXPECT_LT(angleBetween(of_moved.directions_rad[k], found.directions_rad[k] + turn), 1e-11);
    }
  }
}

// The number of steps does not grow with the number of points.
TEST(ClothoidSpline, ManyPointsTakeFewSteps) {
  std::mt19937_64 random(testSeed());
  const ClothoidSpline spline = clothoidSpline(randomWalk(2000, random));
  EXPECT_LE(spline.steps, 10);
}

TEST(ClothoidSpline, InvalidInputIsNamed) {
  std::mt19937_64 random(testSeed());
  const PlanarPoints points = randomWalk(5, random);
  ClothoidSplineOptions options;
  options.start.curvature_per_mm = std::nan("");
  EXPECT_THROW(clothoidSpline(points, options), std::invalid_argument);
  options.start.curvature_per_mm = 0.1;
  options.closed = true;
  EXPECT_THROW(clothoidSpline(points, options), std::invalid_argument);
  EXPECT_THROW(clothoidSpline(points.topRows(1)), std::invalid_argument);
  options = {};
  options.start.arc = true;
  EXPECT_THROW(clothoidSpline(points.topRows(2), options), std::invalid_argument);
  options.start.curvature_per_mm = 0.1;
  EXPECT_THROW(clothoidSpline(points, options), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
