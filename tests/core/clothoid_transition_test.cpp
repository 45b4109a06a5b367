// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc_clothoids.hpp>
#include <seamwright/core/planar/clothoid_fit.hpp>
#include <seamwright/core/planar/clothoid_transition.hpp>
#include <seamwright/core/planar/fair_clothoids.hpp>
#include <seamwright/core/planar/planar_chain.hpp>

#include "planar.hpp"

/// Clothoids between circles, and near chains of arcs.
namespace seamwright {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;
using test::angleBetween;
using test::uniform;
using ::testing::SizeIs;

Clothoid randomClothoid(std::mt19937_64& random) {
  const double length = uniform(random, 0.2, 3);
  const double change = std::copysign(uniform(random, 0.05, 0.5), uniform(random, -1, 1));
  return {.start = {uniform(random, -9, 9), uniform(random, -9, 9)},
          .direction_rad = uniform(random, -4, 4),
          .curvature_per_mm = uniform(random, -0.5, 0.5),
          .curvature_slope_per_mm2 = change / length,
          .length_mm = length};
}

/// An arc of the circle that osculates at an end, which ends or begins \p beyond_mm further.
PlanarArc circleAt(const Clothoid& curve, double s_mm, double from_mm, double to_mm) {
  const PlanarArc there{.start = curve.point(s_mm),
                        .direction_rad = curve.directionAt_rad(s_mm),
                        .curvature_per_mm = curve.curvatureAt_per_mm(s_mm),
                        .length_mm = 1};
  return {.start = there.point(from_mm),
          .direction_rad = there.directionAt_rad(from_mm),
          .curvature_per_mm = there.curvature_per_mm,
          .length_mm = to_mm - from_mm};
}

void expectSame(const Clothoid& found, const Clothoid& expected, double scale = 1) {
  EXPECT_NEAR(found.length_mm, expected.length_mm, 1e-8 * scale);
  EXPECT_LT((found.start - expected.start).norm(), 1e-8 * scale);
  EXPECT_LT((found.end() - expected.end()).norm(), 1e-8 * scale);
  EXPECT_LT(angleBetween(found.direction_rad, expected.direction_rad), 1e-8);
  EXPECT_NEAR(found.curvature_per_mm, expected.curvature_per_mm, 1e-9 / scale);
}

// Identity (1): of all clothoids between the osculating circles of a clothoid there is this one.
TEST(ClothoidTransition, OsculatingCirclesGiveTheClothoid) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 400; ++i) {
    const Clothoid curve = randomClothoid(random);
    const double before = uniform(random, 0.1, 1), after = uniform(random, 0.1, 1);
    const PlanarArc from = circleAt(curve, 0, -before, after),
                    to = circleAt(curve, curve.length_mm, -after, before);
    const ClothoidTransition found = clothoidTransition(from, to);
    expectSame(found.clothoid, curve);
    EXPECT_NEAR(found.leaves_mm, before, 1e-8);
    EXPECT_NEAR(found.arrives_mm, after, 1e-8);
    EXPECT_LT((from.point(found.leaves_mm) - found.clothoid.start).norm(), 1e-12);
    EXPECT_LT((to.point(found.arrives_mm) - found.clothoid.end()).norm(), 1e-9);
  }
}

// Identity (2).
TEST(ClothoidTransition, ShiftOfACircleBesideALine) {
  for (const double radius : {0.5, 10.0, 4000.0})
    for (const double t : {0.004, 0.1, 0.5}) {
      const double length = 2 * radius * t;
      const double x = length * (1 - t * t / 10 + std::pow(t, 4) / 216 - std::pow(t, 6) / 9360),
                   y = length * (t / 3 - std::pow(t, 3) / 42 + std::pow(t, 5) / 1320 -
                                 std::pow(t, 7) / 75600);
      const double shift = y - radius * (1 - std::cos(t)), foot = x - radius * std::sin(t);
      const PlanarArc line{.start = {-9, 0}, .length_mm = 9};
      const PlanarArc circle{
          .start = {0, shift}, .curvature_per_mm = 1 / radius, .length_mm = radius};
      const ClothoidTransition found = clothoidTransition(line, circle);
      EXPECT_NEAR(found.clothoid.length_mm, length, 1e-7 * length);
      EXPECT_NEAR(found.leaves_mm, 9 - foot, 1e-7 * length);
      EXPECT_NEAR(found.arrives_mm, radius * t, 1e-7 * length);
      EXPECT_NEAR(found.clothoid.start.y(), 0, 1e-14);
    }
}

// Identity (3).
TEST(ClothoidTransition, ReversedAndMovedArcs) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const Clothoid curve = randomClothoid(random);
    const PlanarArc from = circleAt(curve, 0, -1, 0), to = circleAt(curve, curve.length_mm, 0, 1);
    expectSame(clothoidTransition(reversed(to), reversed(from)).clothoid, reversed(curve));
    const double turn = uniform(random, -3, 3), scale = std::pow(10, uniform(random, -4, 4));
    const auto moved = [&](auto piece) {
      const Vector2d at = piece.start;
      piece.start = scale * Vector2d(std::cos(turn) * at.x() - std::sin(turn) * at.y(),
                                     std::sin(turn) * at.x() + std::cos(turn) * at.y());
      piece.direction_rad += turn;
      piece.curvature_per_mm /= scale;
      piece.length_mm *= scale;
      return piece;
    };
    Clothoid expected = moved(curve);
    expected.curvature_slope_per_mm2 /= scale * scale;
    expectSame(clothoidTransition(moved(from), moved(to)).clothoid, expected, scale);
  }
}

TEST(ClothoidTransition, CirclesWithoutOneAreNamed) {
  const PlanarArc line{.start = {-5, 0}, .length_mm = 5};
  PlanarArc circle{.start = {0, 0}, .curvature_per_mm = 0.1, .length_mm = 5};
  EXPECT_THROW(clothoidTransition(line, circle), std::domain_error);  // touch
  circle.start.y() = -0.1;
  EXPECT_THROW(clothoidTransition(line, circle), std::domain_error);  // cross
  circle.start.y() = 30;
  EXPECT_THROW(clothoidTransition(line, circle), std::domain_error);  // more than half a turn
  EXPECT_THROW(clothoidTransition(line, line), std::domain_error);
  circle.start.y() = std::nan("");
  EXPECT_THROW(clothoidTransition(line, circle), std::invalid_argument);
}

/// A G1 chain of arcs and lines.
std::vector<PlanarArc> randomChain(std::mt19937_64& random, int count) {
  std::vector<PlanarArc> arcs;
  PlanarArc arc{.direction_rad = uniform(random, -3, 3)};
  for (int i = 0; i < count; ++i) {
    const bool line = uniform(random, 0, 1) < 0.4 && arc.curvature_per_mm != 0;
    arc.curvature_per_mm = line ? 0 : uniform(random, -0.4, 0.4);
    arc.length_mm = uniform(random, 1, 6);
    arcs.push_back(arc);
    arc.start = arc.end();
    arc.direction_rad = arc.endDirection_rad();
  }
  return arcs;
}

/// The corners of a rectangle rounded by these radii, counter-clockwise.
std::vector<PlanarArc> roundedRectangle(double width, double height, double radius) {
  std::vector<PlanarArc> arcs;
  PlanarArc piece{.start = {radius, 0}};
  for (const double side : {width, height, width, height}) {
    piece.curvature_per_mm = 0;
    piece.length_mm = side - 2 * radius;
    if (piece.length_mm > 0) arcs.push_back(piece);
    piece.start = piece.end();
    piece.curvature_per_mm = 1 / radius;
    piece.length_mm = radius * pi / 2;
    arcs.push_back(piece);
    piece.start = piece.end();
    piece.direction_rad = piece.endDirection_rad();
  }
  return arcs;
}

SequenceTurns turnsOfArcs(const std::vector<PlanarArc>& arcs, bool closed) {
  std::vector<double> curvatures;
  for (const PlanarArc& arc : arcs) curvatures.push_back(arc.curvature_per_mm);
  return turnsOf(curvatures, closed, 1e-9);
}

void expectG2(const std::vector<Clothoid>& pieces, bool closed) {
  for (std::size_t i = closed ? 0 : 1; i < pieces.size(); ++i) {
    const Clothoid &left = pieces[(i + pieces.size() - 1) % pieces.size()], &right = pieces[i];
    EXPECT_LT((left.end() - right.start).norm(), 1e-9);
    EXPECT_LT(angleBetween(left.directionAt_rad(left.length_mm), right.direction_rad), 1e-9);
    EXPECT_NEAR(left.curvatureAt_per_mm(left.length_mm), right.curvature_per_mm, 1e-12);
  }
}

/// Largest distance of points of one chain from the nearest of dense points of the other one.
template <class From, class To>
double sampledDistance(const std::vector<From>& from, const std::vector<To>& to) {
  constexpr int coarse = 12, dense = 400;
  std::vector<Vector2d> points;
  for (const To& piece : to)
    for (int i = 0; i <= dense; ++i) points.push_back(piece.point(piece.length_mm * i / dense));
  double largest = 0;
  for (const From& piece : from)
    for (int i = 0; i <= coarse; ++i) {
      const Vector2d point = piece.point(piece.length_mm * i / coarse);
      double least = infinite;
      for (const Vector2d& other : points) least = std::min(least, (other - point).norm());
      largest = std::max(largest, least);
    }
  return largest;
}

// Identities (1) and (2).
TEST(ArcClothoids, StayNearAndAddNoTurns) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 40; ++i) {
    const std::vector<PlanarArc> arcs = randomChain(random, 2 + i % 9);
    const double tolerance = i % 2 == 0 ? 0.05 : 0.002;
    const ArcClothoids found = clothoidsNear(arcs, false, tolerance);
    EXPECT_THAT(found.pieces, SizeIs(2 * arcs.size() - 1));
    expectG2(found.pieces, false);
    EXPECT_LT((found.pieces.front().start - arcs.front().start).norm(), 1e-12);
    EXPECT_LT((found.pieces.back().end() - arcs.back().end()).norm(), 1e-9);
    EXPECT_LT(angleBetween(found.pieces.front().direction_rad, arcs.front().direction_rad), 1e-12);
    EXPECT_LE(found.distance_mm, tolerance);
    // Half of the spacing of dense points is at most 6 / 800 across the distance.
    const double spread = std::hypot(found.distance_mm, 6.0 / 800);
    EXPECT_LE(sampledDistance(arcs, found.pieces), spread);
    EXPECT_LE(sampledDistance(found.pieces, arcs), spread);
    const ClothoidFigures figures = figuresOf(found.pieces);
    const SequenceTurns turns = turnsOfArcs(arcs, false);
    EXPECT_EQ(figures.extrema, turns.extrema);
    EXPECT_EQ(figures.inflections, turns.inflections);
  }
}

// Identity (3).
TEST(ArcClothoids, AnArcBetweenLinesKeepsItsCentre) {
  constexpr double radius = 6, tolerance = 0.01;
  const ArcClothoids found = clothoidsNear(roundedRectangle(60, 40, radius), true, tolerance);
  ASSERT_THAT(found.pieces, SizeIs(16));
  expectG2(found.pieces, true);
  for (std::size_t i = 0; i < found.pieces.size(); i += 4) {
    const Clothoid &line = found.pieces[i + 1], &into = found.pieces[i + 2],
                   &arc = found.pieces[i + 3];
    EXPECT_EQ(line.curvature_per_mm, 0);
    EXPECT_EQ(line.curvature_slope_per_mm2, 0);
    const double small = 1 / arc.curvature_per_mm, shift = radius - small;
    EXPECT_LE(shift, tolerance);
    EXPECT_GT(shift, 0.95 * tolerance);
    // Y - R (1 - cos t) of P4.5 begins with L^2 / (24 R).
    EXPECT_NEAR(into.length_mm * into.length_mm / (24 * small), shift, 1e-3 * shift);
    const Vector2d centre = arc.start + small * unitVector(arc.direction_rad + pi / 2);
    EXPECT_NEAR(std::abs(centre.x() - 30), 30 - radius, 1e-9);
    EXPECT_NEAR(std::abs(centre.y() - 20), 20 - radius, 1e-9);
  }
}

TEST(ArcClothoids, RoomBoundsTheTransitions) {
  // The lines are 0.1 mm long.
  const ArcClothoids found = clothoidsNear(roundedRectangle(12.1, 12.1, 6), true, 1);
  for (std::size_t i = 0; i < found.pieces.size(); i += 2)
    EXPECT_NEAR(found.pieces[i].length_mm, 0.09, 1e-4);
  EXPECT_THAT(clothoidsNear(roundedRectangle(12, 12, 6), true, 1).pieces, SizeIs(1));  // a circle
}

TEST(ArcClothoids, CornersAndBadInputAreNamed) {
  std::vector<PlanarArc> arcs = roundedRectangle(60, 40, 6);
  EXPECT_THROW(clothoidsNear({}, false, 1), std::invalid_argument);
  EXPECT_THROW(clothoidsNear(arcs, true, 0), std::invalid_argument);
  arcs.erase(arcs.begin() + 1);
  arcs[0].length_mm += 12;
  arcs[1].start = arcs[0].end();
  EXPECT_THROW(clothoidsNear({arcs[0], arcs[1]}, false, 1e-3), std::domain_error);
}

// Identity (3) of fitClothoids().
TEST(ClothoidFit, LinesAndArcsGetOneTransitionForEachJoint) {
  const std::vector<PlanarArc> slot = {
      {.start = {0, -10}, .length_mm = 40},
      {.start = {40, -10}, .curvature_per_mm = 0.1, .length_mm = 10 * pi},
      {.start = {40, 10}, .direction_rad = pi, .length_mm = 40},
      {.start = {0, 10}, .direction_rad = pi, .curvature_per_mm = 0.1, .length_mm = 10 * pi}};
  for (const auto& arcs : {slot, roundedRectangle(60, 40, 6), roundedRectangle(20, 8, 4)}) {
    const PlanarChain chain{.curves = {arcs.begin(), arcs.end()}, .closed = true};
    const ClothoidFit fit = fitClothoids(bezierSpline(chain, 1e-9), {.tolerance_mm = 0.01});
    const SequenceTurns turns = turnsOfArcs(arcs, true);
    const ClothoidFigures figures = figuresOf(fit.pieces, true);
    EXPECT_TRUE(fit.closed);
    EXPECT_LE(fit.distance_mm, 0.01);
    EXPECT_EQ(figures.extrema, turns.extrema);
    EXPECT_EQ(figures.inflections, 0);
    EXPECT_LE(fit.pieces.size(), 2 * arcs.size());
    expectG2(fit.pieces, true);
  }
}

}  // namespace
}  // namespace seamwright
