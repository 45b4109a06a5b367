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
using ::testing::ElementsAre;
using ::testing::SizeIs;

/// Points of a closed outline at much the same steps along it, the first so many steps after its
/// start.
PlanarPoints stepsAlong(const std::vector<PlanarArc>& outline, double step_mm, double first) {
  double length_mm = 0;
  for (const PlanarArc& arc : outline) length_mm += arc.length_mm;
  const auto n = static_cast<Eigen::Index>(std::round(length_mm / step_mm));
  PlanarPoints points(n, 2);
  auto arc = outline.begin();
  double before_mm = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double along_mm = length_mm / static_cast<double>(n) * (static_cast<double>(i) + first);
    while (along_mm - before_mm > arc->length_mm) before_mm += (arc++)->length_mm;
    points.row(i) = arc->point(along_mm - before_mm).transpose();
  }
  return points;
}

std::vector<OutlinePiece> polygonOf(const std::vector<Vector2d>& vertices) {
  std::vector<OutlinePiece> sides;
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d before = vertices[i] - vertices[(i + n - 1) % n],
                   side = vertices[(i + 1) % n] - vertices[i];
    sides.push_back({angleFromTo(before, side), 0, side.norm()});
  }
  return sides;
}

std::vector<OutlinePiece> starOf(double inner_mm, double outer_mm, int tips) {
  std::vector<Vector2d> vertices;
  for (int i = 0; i < 2 * tips; ++i)
    vertices.emplace_back((i % 2 == 0 ? outer_mm : inner_mm) * unitVector(i * pi / tips));
  return polygonOf(vertices);
}

/// A gear with straight teeth: three or four points are on each of its tips.
std::vector<OutlinePiece> gearOf(int teeth) {
  std::vector<Vector2d> vertices;
  for (int i = 0; i < teeth; ++i) {
    const double at_rad = 2 * pi * i / teeth;
    for (const auto& [share, radius_mm] :
         {std::pair{0.0, 27.0}, {0.15, 32.0}, {0.35, 32.0}, {0.5, 27.0}})
      vertices.emplace_back(radius_mm * unitVector(at_rad + share * 2 * pi / teeth));
  }
  return polygonOf(vertices);
}

// Identity (1): equal steps leave corners out, blunt and sharp ones, in either direction.
TEST(SampledCorners, CornersCanLieBetweenPoints) {
  const std::vector<std::vector<OutlinePiece>> outlines = {
      {{pi / 2, 0, 60}, {pi / 2, 0, 40}, {pi / 2, 0, 60}, {pi / 2, 0, 40}},
      {{2 * pi / 3, 0, 50}, {2 * pi / 3, 0, 50}, {2 * pi / 3, 0, 50}},
      {{pi / 2, 0, 40}, {pi / 2, 0, 20}, {0, 0.05, 20 * pi}, {0, 0, 20}},
      {{pi / 2, 0.1, 5 * pi}, {pi / 2, 0.1, 5 * pi}},
      starOf(12, 30, 5),
      gearOf(12)};
  constexpr int offsets = 5;
  constexpr double bound_mm = 1e-5;  // the least one that is tried
  for (std::size_t k = 0; k < outlines.size(); ++k)
    for (int offset = 0; offset < offsets; ++offset)
      for (const bool is_reversed : {false, true})
        for (const double unit_mm : {1e-12, 1e-3}) {
          SCOPED_TRACE(testing::Message() << k << ' ' << offset << ' ' << is_reversed << unit_mm);
          const std::vector<PlanarArc> outline = outlineOf(outlines[k], 0.3 * offset);
          PlanarPoints points = stepsAlong(outline, 1, offset / static_cast<double>(offsets));
          if (is_reversed) points = points.colwise().reverse().eval();
          points = (points / unit_mm).array().round() * unit_mm;
          const auto chain = sampledChain(points, {.closed = true, .tolerance_mm = 0.01});
          ASSERT_TRUE(chain);
          ASSERT_THAT(chain->arcs, SizeIs(outline.size()));
          EXPECT_LE(chain->distance_mm, unit_mm + bound_mm);
          for (const auto& [from, to] : {std::pair{chain->arcs, outline}, {outline, chain->arcs}})
            for (const PlanarArc& arc : from)
              EXPECT_LT(distanceTo(to, arc.start), 10 * (unit_mm + bound_mm));
        }
}

// Identity (1): the last step of a closed outline can be shorter or longer, at a corner or beside
// it.
TEST(SampledCorners, CornersAreFoundWhateverTheClosingStepIs) {
  const std::vector<std::vector<OutlinePiece>> outlines = {
      {{pi / 2, 0, 80}, {pi / 2, 0, 50}, {pi / 2, 0, 80}, {pi / 2, 0, 50}},
      {{pi - 2.5, 0.05, 100}, {pi - 2.5, 0, 40 * std::sin(2.5)}}};  // corners of 37 degrees
  for (const std::vector<OutlinePiece>& pieces : outlines)
    for (const double step_mm : {1.31, 2.1, 2.4})
      for (const double begin : {0.05, 0.4, 0.9})
        for (const double more : {0.0, 1.0}) {
          SCOPED_TRACE(testing::Message()
                       << pieces.size() << ' ' << step_mm << ' ' << begin << ' ' << more);
          const std::vector<PlanarArc> outline = outlineOf(pieces, 0.2);
          double length_mm = 0;
          for (const PlanarArc& arc : outline) length_mm += arc.length_mm;
          // The rest of the length is the closing step.
          const double count = std::floor(length_mm / step_mm) + more;
          const PlanarPoints all = stepsAlong(outline, length_mm / 1e4, 0);
          PlanarPoints points(static_cast<Eigen::Index>(count), 2);
          for (Eigen::Index i = 0; i < points.rows(); ++i) {
            double along_mm = std::fmod((static_cast<double>(i) + begin) * step_mm, length_mm);
            auto arc = outline.begin();
            while (along_mm > arc->length_mm) along_mm -= (arc++)->length_mm;
            points.row(i) = arc->point(along_mm).transpose();
          }
          const auto chain = sampledChain(points, {.closed = true, .tolerance_mm = 0.01});
          ASSERT_TRUE(chain);
          ASSERT_THAT(chain->arcs, SizeIs(outline.size()));
          EXPECT_LT(largestDistance(chain->arcs, all), 1e-4);
        }
}

// Identity (1): a chamfer that only its two ends show is no corner that equal steps leave out.
TEST(SampledCorners, ShortChamfersStay) {
  for (const double chamfer_mm : {0.3, 0.5, 1.7, 2.5}) {
    std::vector<OutlinePiece> plate;
    for (int side = 0; side < 4; ++side) {
      plate.push_back({pi / 4, 0, side % 2 == 0 ? 40.0 : 20.0});
      plate.push_back({pi / 4, 0, chamfer_mm});
    }
    const std::vector<PlanarArc> outline = outlineOf(plate, 0.2);
    const auto chain =
        sampledChain(stepsOfPieces(outline, 1), {.closed = true, .tolerance_mm = 0.01});
    SCOPED_TRACE(chamfer_mm);
    ASSERT_TRUE(chain);
    ASSERT_THAT(chain->arcs, SizeIs(8));
    EXPECT_THAT(chain->corners, SizeIs(8));
    for (const PlanarArc& side : chain->arcs) EXPECT_LT(distanceTo(outline, side.start), 1e-9);
  }
}

// A closed chain begins at the corner that is its first point, whatever rounding does to it.
TEST(SampledCorners, BeginsAtTheCornerThatIsTheFirstPoint) {
  const std::vector<OutlinePiece> plate = {
      {pi / 2, 0, 40}, {pi / 2, 0, 20}, {0, 0.05, 20 * pi}, {0, 0, 20}};
  for (const double unit_mm : {1e-2, 1e-3, 1e-6})
    for (int turn = 0; turn < 60; ++turn) {
      const std::vector<PlanarArc> outline = outlineOf(plate, 0.1 * turn);
      const PlanarPoints points = samplesOf(outline, {.steps = 20, .unit_mm = unit_mm});
      const auto chain = sampledChain(points, {.closed = true, .tolerance_mm = 0.03});
      SCOPED_TRACE(testing::Message() << unit_mm << ' ' << turn);
      ASSERT_TRUE(chain);
      ASSERT_THAT(chain->arcs, SizeIs(4));
      EXPECT_LT((chain->arcs[0].start - points.row(0).transpose()).norm(), 5 * unit_mm);
    }
}

// Identity (1): a corner of 30 degrees beside an arc whose chords turn by 6 degrees.
TEST(SampledCorners, CornersBesideCoarseArcsStay) {
  for (const double corner_deg : {20.0, 30.0, 45.0}) {
    const double turn_rad = corner_deg * radians_per_degree, step_rad = turn_rad / 5;
    const std::vector<PlanarArc> outline =
        outlineOf({{0, 0, 30}, {turn_rad, 1.0 / 12, 18 * 12 * step_rad}}, 0.3);
    const PlanarPoints points = samplesOf(outline, {.steps = 18, .closed = false});
    const auto chain = sampledChain(points, {.tolerance_mm = 0.01});
    SCOPED_TRACE(corner_deg);
    ASSERT_TRUE(chain);
    EXPECT_THAT(chain->arcs, SizeIs(2));
    EXPECT_THAT(chain->corners, ElementsAre(1));
  }
}

}  // namespace
}  // namespace seamwright
