// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampled_outlines.hpp"

namespace seamwright {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;
using test::distanceTo;
using test::largestDistance;
using test::outlineOf;
using test::OutlinePiece;
using test::samplesOf;
using test::stepsOfPieces;
using test::turnsOf;
using test::uniform;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Identity (1) for a closed outline without corners; the polygon of few points is further from the
// arcs than the tolerance.
TEST(SampledChain, OfFewPointsOfLinesAndArcsIsThese) {
  std::mt19937_64 random(testSeed());
  const std::vector<OutlinePiece> stadium = {
      {0, 0, 40}, {0, 0.1, 10 * pi}, {0, 0, 40}, {0, 0.1, 10 * pi}};
  for (const double unit_mm : {1e-3, 1e-6, 1e-12})
    for (const int steps : {8, 25})
      for (const int first : {0, 3, 11}) {
        SCOPED_TRACE(testing::Message() << unit_mm << ' ' << steps << ' ' << first);
        const PlanarPoints points = samplesOf(outlineOf(stadium, uniform(random, -3, 3)),
                                              {.steps = steps, .unit_mm = unit_mm, .first = first});
        const auto chain = sampledChain(points, {.closed = true, .tolerance_mm = 0.02});
        ASSERT_TRUE(chain);
        ASSERT_THAT(chain->arcs, SizeIs(stadium.size()));
        EXPECT_THAT(chain->corners, IsEmpty());
        EXPECT_LE(chain->distance_mm, 20 * unit_mm + 1e-9);
        EXPECT_THAT(turnsOf(*chain), Each(testing::Lt(1e-6)));
        std::vector<double> lengths_mm;
        for (const PlanarArc& arc : chain->arcs) lengths_mm.push_back(arc.length_mm);
        std::ranges::sort(lengths_mm);
        EXPECT_NEAR(lengths_mm[0], 10 * pi, 0.1);
        EXPECT_NEAR(lengths_mm[3], 40, 0.1);
        EXPECT_EQ(std::ranges::count(chain->arcs, 0, &PlanarArc::curvature_per_mm), 2);
      }
}

// Identity (1): corners are not rounded, however large the tolerance is.
TEST(SampledChain, CornersStay) {
  std::mt19937_64 random(testSeed());
  const std::vector<OutlinePiece> rectangle = {
      {pi / 2, 0, 40}, {pi / 2, 0, 20}, {pi / 2, 0, 40}, {pi / 2, 0, 20}};
  for (const double unit_mm : {1e-3, 1e-9})
    for (const int steps : {2, 5, 50, 400})
      for (const double tolerance_mm : {0.02, 0.1})
        for (const int first : {0, 1}) {
          SCOPED_TRACE(testing::Message() << unit_mm << ' ' << steps << ' ' << tolerance_mm);
          const std::vector<PlanarArc> outline = outlineOf(rectangle, uniform(random, -3, 3));
          const PlanarPoints points =
              samplesOf(outline, {.steps = steps, .unit_mm = unit_mm, .first = first});
          const auto chain = sampledChain(points, {.closed = true, .tolerance_mm = tolerance_mm});
          ASSERT_TRUE(chain);
          ASSERT_THAT(chain->arcs, SizeIs(4));
          EXPECT_THAT(chain->corners, ElementsAre(0, 1, 2, 3));
          EXPECT_THAT(turnsOf(*chain), Each(testing::DoubleNear(pi / 2, 4 * unit_mm + 1e-9)));
          for (const PlanarArc& side : chain->arcs) {
            EXPECT_EQ(side.curvature_per_mm, 0);
            EXPECT_LT(distanceTo(outline, side.start), 4 * unit_mm + 1e-9);
          }
          EXPECT_LE(chain->distance_mm, 4 * unit_mm + 1e-9);
        }
}

// Identity (1): chamfers of 45 degrees.
TEST(SampledChain, SmallCornersStayIfThePiecesAreFewer) {
  std::vector<OutlinePiece> plate;
  for (int side = 0; side < 4; ++side) {
    plate.push_back({pi / 4, 0, side % 2 == 0 ? 40.0 : 20.0});
    plate.push_back({pi / 4, 0, 5});
  }
  const std::vector<PlanarArc> outline = outlineOf(plate, 0.2);
  const PlanarPoints points = samplesOf(outline, {.steps = 25, .unit_mm = 1e-4, .first = 7});
  const auto chain = sampledChain(points, {.closed = true, .tolerance_mm = 0.05});
  ASSERT_TRUE(chain);
  EXPECT_THAT(chain->arcs, SizeIs(8));
  EXPECT_THAT(chain->corners, SizeIs(8));
  for (const PlanarArc& side : chain->arcs) EXPECT_LT(distanceTo(outline, side.start), 1e-3);
}

// Identity (1): chords of short arcs are no sides, and lines of few points do not spoil the others.
TEST(SampledChain, OfShortArcsAndLinesIsThese) {
  std::vector<OutlinePiece> plate;
  for (int side = 0; side < 4; ++side) {
    plate.push_back({0, 0, side % 2 == 0 ? 64.0 : 34.0});
    plate.push_back({0, 0.125, 4 * pi});
  }
  for (const double unit_mm : {1e-3, 1e-6})
    for (const auto& [of_line, of_arc] : {std::pair{12, 4}, {4, 5}, {6, 4}}) {
      PlanarPoints points(4 * (of_line + of_arc), 2);
      Eigen::Index count = 0;
      for (const PlanarArc& arc : outlineOf(plate, 0.4)) {
        const int steps = arc.curvature_per_mm == 0 ? of_line : of_arc;
        for (int k = 0; k < steps; ++k)
          points.row(count++) =
              (arc.point(arc.length_mm * k / steps) / unit_mm).array().round().transpose() *
              unit_mm;
      }
      const auto chain = sampledChain(points, {.closed = true, .tolerance_mm = 0.02});
      SCOPED_TRACE(testing::Message() << unit_mm << ' ' << of_line << ' ' << of_arc);
      ASSERT_TRUE(chain);
      ASSERT_THAT(chain->arcs, SizeIs(8));
      EXPECT_THAT(chain->corners, IsEmpty());
      EXPECT_EQ(std::ranges::count(chain->arcs, 0, &PlanarArc::curvature_per_mm), 4);
      EXPECT_LT(chain->distance_mm, 20 * unit_mm);
    }
}

// Identity (1): a corner between an arc and a line, and one between two arcs.
TEST(SampledChain, ArcsMeetAtCorners) {
  // A half circle on a line, and two quarters of circles on a common chord.
  const std::vector<std::vector<OutlinePiece>> outlines = {
      {{pi / 2, 0, 20}, {pi / 2, 0.1, 10 * pi}}, {{pi / 2, 0.1, 5 * pi}, {pi / 2, 0.1, 5 * pi}}};
  for (const auto& pieces : outlines) {
    const std::vector<PlanarArc> outline = outlineOf(pieces, 0.3);
    ASSERT_LT((outline.back().end() - outline.front().start).norm(), 1e-9);
    const PlanarPoints points = samplesOf(outline, {.steps = 60, .unit_mm = 1e-6});
    const auto chain = sampledChain(points, {.closed = true, .tolerance_mm = 0.05});
    ASSERT_TRUE(chain);
    ASSERT_THAT(chain->arcs, SizeIs(2));
    EXPECT_THAT(chain->corners, ElementsAre(0, 1));
    EXPECT_LT(chain->distance_mm, 1e-5);
    for (const PlanarArc& arc : chain->arcs) EXPECT_LT(distanceTo(outline, arc.start), 1e-5);
    EXPECT_LT(largestDistance(chain->arcs, points), 1e-5);
  }
}

// Identity (1) for open curves: pieces at the ends, one piece, corners between.
TEST(SampledChain, OfOpenCurves) {
  std::mt19937_64 random(testSeed());
  const std::vector<std::vector<OutlinePiece>> curves = {
      {{0, 0, 30}, {0, 0.1, 10}, {0, 0, 30}},
      {{0, 0.1, 12}, {0, 0, 30}, {0, -0.05, 25}},
      {{0, 0, 30}, {0, -0.1, 12}},
      {{0, 0.2, 9}, {0, 0, 25}},
      {{0, 0, 20}, {0, 0.25, 4}, {0, -0.1, 12}, {0, 0, 30}},
      {{0, 0, 30}},
      {{0, 0.05, 30}},
      {{0, 0, 30}, {pi / 2, 0, 20}, {0, 0.1, 15}, {-pi / 2, 0, 10}}};
  for (const auto& pieces : curves)
    for (const double unit_mm : {1e-3, 1e-9, 1e-13}) {
      const std::vector<PlanarArc> curve = outlineOf(pieces, uniform(random, -3, 3));
      const PlanarPoints points =
          samplesOf(curve, {.steps = 40, .unit_mm = unit_mm, .closed = false});
      SCOPED_TRACE(testing::Message() << &pieces - curves.data() << ' ' << unit_mm);
      const auto chain = sampledChain(points, {.tolerance_mm = 0.05});
      ASSERT_TRUE(chain);
      ASSERT_THAT(chain->arcs, SizeIs(curve.size()));
      EXPECT_FALSE(chain->closed);
      EXPECT_LE(chain->distance_mm, 20 * unit_mm + 1e-9);
      EXPECT_LT((chain->arcs.front().start - curve.front().start).norm(), 20 * unit_mm + 1e-9);
      EXPECT_LT((chain->arcs.back().end() - curve.back().end()).norm(), 20 * unit_mm + 1e-9);
      const std::vector<double> turns = turnsOf(*chain);
      std::vector<int> corners;
      for (std::size_t i = 0; i < curve.size(); ++i) {
        EXPECT_NEAR(chain->arcs[i].curvature_per_mm, curve[i].curvature_per_mm,
                    0.02 * std::abs(curve[i].curvature_per_mm));
        if (i == 0) continue;
        EXPECT_NEAR(turns[i - 1], std::abs(pieces[i].turn_rad), 20 * unit_mm + 1e-6);
        if (pieces[i].turn_rad != 0) corners.push_back(static_cast<int>(i));
      }
      EXPECT_EQ(chain->corners, corners);
    }
}

// Two lines at a small angle cross far from the end of their points.
TEST(SampledChain, CornersAreNoFurtherFromThePointsThanTheTolerance) {
  for (const double off_mm : {0.0, 0.001, 0.004, 0.009}) {
    const double angle_rad = 0.005, length_mm = 100;
    PlanarPoints points(101, 2);
    for (int i = 0; i <= 50; ++i) {
      const double along = length_mm * i / 50, across = along * angle_rad / 2;
      points.row(50 - i) << along, across + (i > 0 ? off_mm : 0);
      points.row(50 + i) << along, -across - (i > 0 ? off_mm : 0);
    }
    const auto chain = sampledChain(points, {.tolerance_mm = 0.01});
    ASSERT_TRUE(chain || off_mm > 0);
    if (!chain) continue;
    EXPECT_LE(chain->distance_mm, 0.01);
    // The corner of the points can be off by as much as they are.
    for (const PlanarArc& arc : chain->arcs) EXPECT_GE(arc.start.x(), -0.02) << off_mm;
  }
}

PlanarPoints rotated(const PlanarPoints& points, Eigen::Index first) {
  PlanarPoints result(points.rows(), 2);
  result << points.bottomRows(points.rows() - first), points.topRows(first);
  return result;
}

PlanarPoints withErrors(PlanarPoints points, double error_mm, std::mt19937_64& random) {
  for (double& x : points.reshaped()) x += uniform(random, -error_mm, error_mm);
  return points;
}

double largestDistance(const std::vector<PlanarArc>& from, const std::vector<PlanarArc>& arcs) {
  double largest = 0;
  constexpr int samples = 60;
  for (const PlanarArc& arc : from)
    for (int k = 0; k <= samples; ++k)
      largest = std::max(largest, distanceTo(arcs, arc.point(arc.length_mm * k / samples)));
  return largest;
}

// Identity (3). The errors of many points cancel, so that the chain is nearer to the outline than
// they are.
TEST(SampledChain, OfPointsWithErrorsHasNoStart) {
  std::mt19937_64 random(testSeed());
  std::vector<OutlinePiece> plate, rounded;
  for (int side = 0; side < 4; ++side) {
    plate.push_back({pi / 4, 0, side % 2 == 0 ? 40.0 : 20.0});
    plate.push_back({pi / 4, 0, 8});
    rounded.push_back({0, 0, side % 2 == 0 ? 40.0 : 30.0});
    rounded.push_back({0, 0.125, 4 * pi});
  }
  const std::vector<std::vector<OutlinePiece>> outlines = {
      {{0, 0, 40}, {0, 0.1, 10 * pi}, {0, 0, 40}, {0, 0.1, 10 * pi}},      // a slot
      {{pi / 2, 0, 40}, {pi / 2, 0, 20}, {0, 0.05, 20 * pi}, {0, 0, 20}},  // a D
      plate,
      rounded};
  const std::vector<std::size_t> pieces = {4, 4, 8, 8}, corners = {0, 2, 8, 0};
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    const std::vector<PlanarArc> outline = outlineOf(outlines[k], uniform(random, -3, 3));
    ASSERT_LT((outline.back().end() - outline.front().start).norm(), 1e-9);
    const PlanarPoints points =
        withErrors(samplesOf(outline, {.steps = 30, .unit_mm = 1e-9}), 0.02, random);
    for (const Eigen::Index first : {0, 1, 17, 45, 88, 119}) {
      SCOPED_TRACE(testing::Message() << k << ' ' << first);
      const auto chain =
          sampledChain(rotated(points, first), {.closed = true, .tolerance_mm = 0.05});
      ASSERT_TRUE(chain);
      EXPECT_THAT(chain->arcs, SizeIs(pieces[k]));
      EXPECT_THAT(chain->corners, SizeIs(corners[k]));
      EXPECT_EQ(std::ranges::count(chain->arcs, 0, &PlanarArc::curvature_per_mm),
                std::ranges::count(outline, 0, &PlanarArc::curvature_per_mm));
      EXPECT_LT(largestDistance(chain->arcs, outline), 0.04);
      EXPECT_LT(largestDistance(outline, chain->arcs), 0.04);
    }
  }
}

// Identity (3): the corners of regular polygons, from any start.
TEST(SampledChain, OfPolygonsWithErrorsHasNoStart) {
  std::mt19937_64 random(testSeed());
  for (const int sides : {4, 6, 8})
    for (const double step_mm : {1.25, 0.5}) {
      const std::vector<PlanarArc> outline =
          outlineOf(std::vector<OutlinePiece>(static_cast<std::size_t>(sides),
                                              {.turn_rad = 2 * pi / sides, .length_mm = 10}),
                    uniform(random, -3, 3));
      const PlanarPoints points = withErrors(stepsOfPieces(outline, step_mm), 0.02, random);
      for (const Eigen::Index first : {0, 3, 11}) {
        SCOPED_TRACE(testing::Message() << sides << ' ' << step_mm << ' ' << first);
        const auto chain =
            sampledChain(rotated(points, first), {.closed = true, .tolerance_mm = 0.05});
        ASSERT_TRUE(chain);
        EXPECT_THAT(chain->arcs, SizeIs(sides));
        EXPECT_THAT(chain->corners, SizeIs(sides));
        EXPECT_EQ(std::ranges::count(chain->arcs, 0, &PlanarArc::curvature_per_mm), sides);
      }
    }
}

// Identity (1): the pieces before and after an arc or two are lines, whatever their number.
TEST(SampledChain, LinesStayLines) {
  std::mt19937_64 random(testSeed());
  const std::vector<std::vector<OutlinePiece>> curves = {
      {{0, 0, 30}, {0, 0.05, 30}, {0, -0.05, 30}, {0, 0, 30}},
      {{0, 0, 30}, {0, 0.1, 9}, {0, 0, 20}, {0, 0.05, 30}, {0, -0.05, 30}, {0, 0, 30}},
      {{0, 0.04, 20}, {0, 0, 30}, {0, -0.1, 9}, {0, 0.05, 30}, {0, 0, 30}}};
  for (const auto& pieces : curves)
    for (const double unit_mm : {0.01, 1e-3, 1e-6}) {
      const std::vector<PlanarArc> curve = outlineOf(pieces, uniform(random, -3, 3));
      const PlanarPoints points =
          samplesOf(curve, {.steps = 25, .unit_mm = unit_mm, .closed = false});
      const auto chain = sampledChain(points, {.tolerance_mm = 0.05});
      SCOPED_TRACE(testing::Message() << &pieces - curves.data() << ' ' << unit_mm);
      ASSERT_TRUE(chain);
      ASSERT_THAT(chain->arcs, SizeIs(curve.size()));
      for (std::size_t i = 0; i < curve.size(); ++i)
        EXPECT_EQ(chain->arcs[i].curvature_per_mm == 0, curve[i].curvature_per_mm == 0) << i;
    }
}

// Identity (2), for points with errors and curves that are no lines and arcs.
TEST(SampledChain, IsWithinTheToleranceOrNothing) {
  std::mt19937_64 random(testSeed());
  int found = 0;
  for (int i = 0; i < 60; ++i) {
    std::vector<OutlinePiece> pieces;
    for (int k = 0; k < 5; ++k)
      pieces.push_back({k % 2 == 0 ? 0 : uniform(random, -2, 2),
                        k % 2 == 0 ? 0 : uniform(random, -0.2, 0.2), uniform(random, 2, 20)});
    PlanarPoints points = samplesOf(outlineOf(pieces, uniform(random, -3, 3)),
                                    {.steps = 20, .unit_mm = 1e-9, .closed = false});
    for (double& x : points.reshaped()) x += uniform(random, -0.01, 0.01);
    const auto chain = sampledChain(points, {.tolerance_mm = 0.05});
    if (!chain) continue;
    ++found;
    EXPECT_LE(chain->distance_mm, 0.05);
    turnsOf(*chain);
    EXPECT_LE(largestDistance(chain->arcs, points), chain->distance_mm + 1e-7);
  }
  EXPECT_GT(found, 20);
}

TEST(SampledChain, OfAnEllipseIsNothingOrNear) {
  PlanarPoints ellipse(100, 2);
  for (int i = 0; i < 100; ++i)
    ellipse.row(i) << 30 * std::cos(pi * i / 50), 10 * std::sin(pi * i / 50);
  const auto chain = sampledChain(ellipse, {.closed = true, .tolerance_mm = 1e-4});
  EXPECT_TRUE(!chain || largestDistance(chain->arcs, ellipse) <= 1e-4 + 1e-7);
}

// Identity (1): one arc goes all the way round.
TEST(SampledChain, OfACircleIsOneArc) {
  std::mt19937_64 random(testSeed());
  for (const int count : {5, 8, 12, 60, 400})
    for (const double unit_mm : {1e-3, 1e-6, 1e-12})
      for (const double radius_mm : {20.0, -20.0}) {
        SCOPED_TRACE(testing::Message() << count << ' ' << unit_mm << ' ' << radius_mm);
        const std::vector<PlanarArc> circle =
            outlineOf({{0, 1 / radius_mm, 40 * pi}}, uniform(random, -3, 3));
        const PlanarPoints points = samplesOf(circle, {.steps = count, .unit_mm = unit_mm});
        const auto chain = sampledChain(points, {.closed = true, .tolerance_mm = 0.02});
        ASSERT_TRUE(chain);
        ASSERT_THAT(chain->arcs, SizeIs(1));
        EXPECT_THAT(chain->corners, IsEmpty());
        EXPECT_LT((chain->arcs[0].start - points.row(0).transpose()).norm(), 5 * unit_mm + 1e-9);
        EXPECT_LT((chain->arcs[0].end() - chain->arcs[0].start).norm(), 1e-9);
        EXPECT_NEAR(chain->arcs[0].curvature_per_mm, 1 / radius_mm, unit_mm);
        EXPECT_LT(largestDistance(chain->arcs, samplesOf(circle, {.steps = 1000})),
                  10 * unit_mm + 1e-9);
      }
}

// Lines through two points each show nothing.
TEST(SampledChain, OfFewPointsOfACurveIsNothing) {
  PlanarPoints points(5, 2);
  points << 0, 0, 10, 8, 25, 12, 40, 6, 60, 10;
  EXPECT_FALSE(sampledChain(points, {.tolerance_mm = 0.01}));
}

TEST(SampledChain, OfFewPointsIsNothing) {
  PlanarPoints points(3, 2);
  points << 0, 0, 1, 0, 1, 1;
  EXPECT_FALSE(sampledChain(points, {.closed = true, .tolerance_mm = 0.1}));
  EXPECT_FALSE(sampledChain(points.topRows(2), {.tolerance_mm = 0.1}));
  points.row(1) = points.row(0);
  EXPECT_THROW(sampledChain(points, {.tolerance_mm = 0.1}), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
