// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <seamwright/core/planar/conic_pair.hpp>
#include <seamwright/core/planar/conic_spline.hpp>
#include <seamwright/core/planar/planar_chain.hpp>

#include "planar.hpp"

/// Pairs of conics, and conics through points.
namespace seamwright {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;
using test::uniform;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// By differences of points of the conic, so without its derivatives.
double sampledCurvature(const PlanarConic& conic, double t) {
  constexpr double h = 1e-3;
  const double s = std::clamp(t, h, 1 - h);
  const Vector2d a = conic.point(s - h), b = conic.point(s), c = conic.point(s + h);
  return 2 * cross(b - a, c - b) / ((b - a).norm() * (c - b).norm() * (c - a).norm());
}

std::vector<double> sampledCurvatures(const std::vector<PlanarConic>& conics) {
  std::vector<double> result;
  for (const PlanarConic& conic : conics)
    for (int i = 1; i < 60; ++i) result.push_back(sampledCurvature(conic, i / 60.0));
  return result;
}

/// The corners of a random convex polygon: random edges in the order of their directions.
PlanarPoints convexPoints(std::mt19937_64& random, int count) {
  std::vector<Vector2d> edges;
  Vector2d mean(0, 0);
  for (int i = 0; i < count; ++i) {
    edges.emplace_back(uniform(random, -1, 1), uniform(random, -1, 1));
    mean += edges.back() / count;
  }
  for (Vector2d& edge : edges) edge -= mean;
  std::ranges::sort(edges, {}, [](const Vector2d& e) { return std::atan2(e.y(), e.x()); });
  PlanarPoints points(count, 2);
  Vector2d place(0, 0);
  for (Eigen::Index i = 0; i < count; ++i) {
    points.row(i) = place.transpose();
    place += edges[static_cast<std::size_t>(i)];
  }
  return points;
}

ConicPairEnds pairEnds(double alpha, double beta) {
  return {.ends = {.start = {1, 2},
                   .start_direction_rad = 0.3 - alpha,
                   .end = Vector2d(1, 2) + 5 * unitVector(0.3),
                   .end_direction_rad = 0.3 + beta},
          .start_curvature_per_mm =
              pairCurvature_per_mm({.chord_mm = 5, .own_rad = alpha, .other_rad = beta}),
          .end_curvature_per_mm =
              pairCurvature_per_mm({.chord_mm = 5, .own_rad = beta, .other_rad = alpha})};
}

TEST(ConicPair, Identity1MeetsTheEndsG2) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const ConicPairEnds ends = pairEnds(uniform(random, 0.01, 1.2), uniform(random, 0.01, 1.2));
    const auto [first, second] = fairConics(ends).conics;
    EXPECT_EQ(first.start, ends.ends.start);
    EXPECT_EQ(second.end, ends.ends.end);
    EXPECT_EQ(first.end, second.start);
    EXPECT_NEAR(first.startCurvature_per_mm() / ends.start_curvature_per_mm, 1, 1e-9);
    EXPECT_NEAR(second.endCurvature_per_mm() / ends.end_curvature_per_mm, 1, 1e-9);
    EXPECT_NEAR(first.endCurvature_per_mm() / second.startCurvature_per_mm(), 1, 1e-9);
    EXPECT_NEAR(cross(first.end - first.corner, second.corner - second.start), 0, 1e-11);
    EXPECT_GT(first.turn_rad(), 0);
    EXPECT_GT(second.turn_rad(), 0);
  }
}

TEST(ConicPair, Identity1HoldsForAnglesThatDifferALot) {
  // Beside an inflection one angle may be thousands of times the other one.
  for (const double ratio : {50.0, 125.0, 211.0, 1e3, 1e4}) {
    const ConicPairEnds ends = pairEnds(0.05, 0.05 / ratio);
    const auto [first, second] = fairConics(ends).conics;
    EXPECT_EQ(first.start, ends.ends.start);
    EXPECT_EQ(second.end, ends.ends.end);
    EXPECT_EQ(first.end, second.start);
    EXPECT_NEAR(first.startCurvature_per_mm() / ends.start_curvature_per_mm, 1, 1e-6) << ratio;
    EXPECT_NEAR(second.endCurvature_per_mm() / ends.end_curvature_per_mm, 1, 1e-6) << ratio;
    EXPECT_NEAR(first.endCurvature_per_mm() / second.startCurvature_per_mm(), 1, 1e-6) << ratio;
  }
}

TEST(ConicPair, Identity2CirclesStay) {
  for (const double half : {0.05, 0.4, 1.1}) {
    const double radius = 2.5 / std::sin(half);
    const Vector2d middle =
        Vector2d(1, 2) + 2.5 * unitVector(0.3) + radius * std::cos(half) * unitVector(0.3 + pi / 2);
    for (const PlanarConic& conic : fairConics(pairEnds(half, half)).conics)
      for (const double t : {0.0, 0.3, 0.8})
        EXPECT_NEAR((conic.point(t) - middle).norm() / radius, 1, 1e-10);
  }
}

TEST(ConicPair, Identity4ReversedEndsGiveTheReversedPair) {
  const ConicPairEnds ends = pairEnds(0.3, 0.7);
  const ConicPairEnds back{.ends = {.start = ends.ends.end,
                                    .start_direction_rad = ends.ends.end_direction_rad + pi,
                                    .end = ends.ends.start,
                                    .end_direction_rad = ends.ends.start_direction_rad + pi},
                           .start_curvature_per_mm = -ends.end_curvature_per_mm,
                           .end_curvature_per_mm = -ends.start_curvature_per_mm};
  const auto forward = fairConics(ends).conics, other = fairConics(back).conics;
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_LT((forward[i].corner - other[1 - i].corner).norm(), 1e-10);
    EXPECT_NEAR(forward[i].weight, other[1 - i].weight, 1e-10);
  }
}

TEST(ConicPair, Identity3NarrowPairsAreMonotone) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const double turn = uniform(random, 0.02, most_pair_turn_rad);
    const double ratio = std::exp(uniform(random, -std::log(10), std::log(10)));
    const ConicPair pair = fairConics(pairEnds(turn / (1 + ratio), turn * ratio / (1 + ratio)));
    EXPECT_EQ(pair.extrema, 0);
    const std::vector<double> k = sampledCurvatures({pair.conics.begin(), pair.conics.end()});
    EXPECT_EQ(turnsOf(k, false, 1e-5).extrema, 0) << turn << " " << ratio;
  }
}

TEST(ConicSpline, Identity1PassesThroughThePointsG2) {
  std::mt19937_64 random(testSeed());
  for (const bool closed : {false, true}) {
    const PlanarPoints points = convexPoints(random, 20);
    const ConicSpline spline = conicSpline(closed ? points : points.topRows(12), closed);
    EXPECT_THAT(spline.g1_joints, IsEmpty());
    std::size_t met = 0;
    for (std::size_t i = closed ? 0 : 1; i < spline.conics.size(); ++i) {
      const PlanarConic& left =
          spline.conics[(i + spline.conics.size() - 1) % spline.conics.size()];
      const PlanarConic& right = spline.conics[i];
      EXPECT_EQ(left.end, right.start);
      EXPECT_NEAR(left.endCurvature_per_mm() / right.startCurvature_per_mm(), 1, 1e-7);
      EXPECT_LT(std::abs(angleFromTo(left.end - left.corner, right.corner - right.start)), 1e-9);
    }
    for (const PlanarConic& conic : spline.conics)
      for (Eigen::Index i = 0; i < points.rows(); ++i)
        met += conic.start == points.row(i).transpose();
    EXPECT_EQ(met, closed ? 20U : 11U);
  }
}

TEST(ConicSpline, Identity2ConvexPointsGiveAConvexCurve) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 40; ++trial) {
    const int count = 5 + trial % 56;
    const ConicSpline spline = conicSpline(convexPoints(random, count), true);
    double turn = 0;
    for (const PlanarConic& conic : spline.conics) {
      EXPECT_GT(conic.turn_rad(), 0);
      turn += conic.turn_rad();
    }
    EXPECT_NEAR(turn, 2 * pi, 1e-9);
  }
}

TEST(ConicSpline, Identity2AnSShapeHasOneInflection) {
  PlanarPoints points(7, 2);
  points << 0, 0, 4, 3, 9, 4, 14, 2, 19, -1, 24, -1, 28, 2;
  const ConicSpline spline = conicSpline(points);
  EXPECT_THAT(spline.g1_joints, SizeIs(1));
  int changes = 0;
  for (std::size_t i = 1; i < spline.conics.size(); ++i)
    changes += spline.conics[i - 1].turn_rad() * spline.conics[i].turn_rad() < 0;
  EXPECT_EQ(changes, 1);
}

TEST(ConicSpline, Identity1HoldsBesideAnInflectionNearAPoint) {
  // Of an airfoil: the polygon turns by 0.19 degrees before the inflection and by 0.03 after it.
  PlanarPoints points(6, 2);
  points << 0.97145561, 0.00363339, 0.95035123, 0.00677805, 0.92424036, 0.01086920, 0.89362390,
      0.01576960, 0.85900629, 0.02129402, 0.82089086, 0.02721967;
  const ConicSpline spline = conicSpline(points);
  EXPECT_THAT(spline.g1_joints, SizeIs(1));
  for (const PlanarConic& conic : spline.conics) {
    EXPECT_GT(conic.weight, 0);
    EXPECT_GT((conic.end - conic.start).norm(), 0);
  }
  for (Eigen::Index i = 0; i + 1 < points.rows(); ++i)
    EXPECT_TRUE(std::ranges::any_of(spline.conics, [&](const PlanarConic& conic) {
      return conic.start == points.row(i).transpose();
    })) << i;
}

TEST(ConicSpline, Identity3CirclesAndLinesStay) {
  std::mt19937_64 random(testSeed());
  PlanarPoints points(9, 2);
  for (Eigen::Index i = 0; i < 9; ++i) {
    const double u = 0.65 * static_cast<double>(i) + uniform(random, -0.2, 0.2);
    points.row(i) << 3 + 7 * std::cos(u), 2 + 7 * std::sin(u);
  }
  for (const bool closed : {false, true})
    for (const PlanarConic& conic : conicSpline(points, closed).conics)
      for (const double t : {0.2, 0.5, 0.9})
        EXPECT_NEAR((conic.point(t) - Vector2d(3, 2)).norm(), 7, 1e-8);
  PlanarPoints line(4, 2);
  line << 0, 0, 1, 2, 2, 4, 5, 10;
  const ConicSpline straight = conicSpline(line);
  EXPECT_THAT(straight.conics, SizeIs(3));
  EXPECT_THAT(straight.g1_joints, IsEmpty());
}

TEST(ConicSpline, Identity4MovesAlong) {
  std::mt19937_64 random(testSeed());
  const PlanarPoints points = convexPoints(random, 13);
  const ConicSpline spline = conicSpline(points);
  Eigen::Matrix2d turn;
  turn << std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7);
  const PlanarPoints moved = 8 * points * turn.transpose();
  const ConicSpline after = conicSpline(moved), back = conicSpline(points.colwise().reverse());
  ASSERT_EQ(after.conics.size(), spline.conics.size());
  ASSERT_EQ(back.conics.size(), spline.conics.size());
  const auto tangent = [](const PlanarConic& conic) {
    return Eigen::Vector2d((conic.corner - conic.start).normalized());
  };
  for (std::size_t i = 0; i < spline.conics.size(); i += 2) {
    const PlanarConic &one = spline.conics[i], &moved_one = after.conics[i];
    EXPECT_LT((moved_one.start - 8 * turn * one.start).norm(), 1e-12 * points.norm());
    EXPECT_LT((tangent(moved_one) - turn * tangent(one)).norm(), 1e-7);
    EXPECT_NEAR(8 * moved_one.startCurvature_per_mm() / one.startCurvature_per_mm(), 1, 1e-6);
    const PlanarConic mirror = reversed(back.conics[spline.conics.size() - 1 - i]);
    EXPECT_EQ(mirror.start, one.start);
    EXPECT_LT((tangent(mirror) - tangent(one)).norm(), 1e-7);
    EXPECT_NEAR(mirror.startCurvature_per_mm() / one.startCurvature_per_mm(), 1, 1e-6);
  }
}

TEST(ConicSpline, Identity5ThreeOnALineStay) {
  PlanarPoints points(7, 2);
  points << 0, 3, 2, 1, 5, 0, 8, 0, 11, 0, 14, 1, 16, 4;
  const ConicSpline spline = conicSpline(points);
  int lines = 0;
  for (const PlanarConic& conic : spline.conics) lines += conic.turn_rad() == 0;
  EXPECT_EQ(lines, 2);
  EXPECT_THAT(spline.g1_joints, SizeIs(2));
  EXPECT_THAT(spline.corners, IsEmpty());
}

TEST(ConicSpline, RefusesBadInput) {
  PlanarPoints points(3, 2);
  points << 0, 0, 1, 1, 1, 1;
  EXPECT_THROW(conicSpline(points), std::invalid_argument);
  EXPECT_THROW(conicSpline(points.topRows(2), true), std::invalid_argument);
  points << 0, 0, 2, 0, 1, 0;
  EXPECT_THROW(conicSpline(points), std::domain_error);
}

}  // namespace
}  // namespace seamwright
