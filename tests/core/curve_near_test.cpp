// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc_conics.hpp>
#include <seamwright/core/planar/arc_fit.hpp>
#include <seamwright/core/planar/clothoid_fit.hpp>
#include <seamwright/core/planar/planar_chain.hpp>

#include "planar.hpp"

/// Conics near arcs, and clothoids near curves.
namespace seamwright {
namespace {

using Eigen::Vector2d;
using test::uniform;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Samples = std::vector<Vector2d>;

constexpr int per_piece = 70;

Samples samplesOf(const std::vector<PlanarConic>& conics) {
  Samples result;
  for (const PlanarConic& conic : conics)
    for (int i = 0; i <= per_piece; ++i) result.push_back(conic.point(double(i) / per_piece));
  return result;
}

template <class Piece>
Samples samplesByLength(const std::vector<Piece>& pieces) {
  Samples result;
  for (const Piece& piece : pieces)
    for (int i = 0; i <= per_piece; ++i)
      result.push_back(piece.point(piece.length_mm * i / per_piece));
  return result;
}

Samples samplesOf(const BezierSpline& spline) {
  Samples result;
  for (int i = 0; i < spline.segments(); ++i)
    for (int k = 0; k <= per_piece; ++k)
      result.emplace_back(segment(spline, i).point(double(k) / per_piece).head<2>());
  return result;
}

double distanceFrom(const Samples& line, const Vector2d& point) {
  double least = infinite;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vector2d chord = line[i] - line[i - 1];
    const double length2 = chord.squaredNorm();
    const double t =
        length2 > 0 ? std::clamp((point - line[i - 1]).dot(chord) / length2, 0.0, 1.0) : 0;
    least = std::min(least, (line[i - 1] + t * chord - point).norm());
  }
  return least;
}

/// In both directions, up to the sagitta of the chords between samples.
double sampledDistance(const Samples& a, const Samples& b) {
  double distance = 0;
  for (std::size_t i = 0; i < a.size(); i += 7)
    distance = std::max(distance, distanceFrom(b, a[i]));
  for (std::size_t i = 0; i < b.size(); i += 7)
    distance = std::max(distance, distanceFrom(a, b[i]));
  return distance;
}

/// A wave through random points, as a spline.
BezierSpline wave(std::mt19937_64& random, bool closed) {
  const int count = 9;
  PlanarPoints points(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double u = static_cast<double>(i) / count * 2 * std::numbers::pi;
    const double r = 20 + uniform(random, -2, 2);
    if (closed)
      points.row(i) << r * std::cos(u), r * std::sin(u);
    else
      points.row(i) << static_cast<double>(8 * i), uniform(random, -4, 4);
  }
  const BiarcSpline arcs = biarcSpline(points, {.closed = closed});
  // Not a chain of arcs: a cubic of each pair of Hermite ends.
  std::vector<BezierCurve> segments;
  std::vector<double> knots = {0};
  for (Eigen::Index i = 0; i + (closed ? 0 : 1) < count; ++i) {
    const Eigen::Index j = (i + 1) % count;
    const Vector2d a = points.row(i).transpose(), b = points.row(j).transpose();
    const double third = (b - a).norm() / 3;
    const Vector2d p = a + third * unitVector(arcs.directions_rad[static_cast<std::size_t>(i)]),
                   q = b - third * unitVector(arcs.directions_rad[static_cast<std::size_t>(j)]);
    Poles poles(4, 3);
    poles << a.x(), a.y(), 0, p.x(), p.y(), 0, q.x(), q.y(), 0, b.x(), b.y(), 0;
    segments.emplace_back(poles);
    knots.push_back(knots.back() + 3 * third);
  }
  return bezierSpline(segments, knots, closed, 1e-12);
}

TEST(ArcConics, Identity1NoPointIsFurtherThanTheBound) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 6; ++trial) {
    const bool closed = trial % 2 == 0;
    const ArcFit fit = fitArcs(wave(random, closed), {.tolerance_mm = 0.05});
    const ArcConics conics =
        g2ConicsNear({.arcs = fit.arcs, .corners = fit.corners, .closed = fit.closed}, 10);
    ASSERT_TRUE(std::isfinite(conics.distance_mm));
    EXPECT_LE(sampledDistance(samplesOf(conics.conics), samplesByLength(fit.arcs)),
              conics.distance_mm + 5e-4);
    EXPECT_EQ(conics.closed, closed);
    for (std::size_t i = 1; i < conics.conics.size(); ++i) {
      const PlanarConic &left = conics.conics[i - 1], &right = conics.conics[i];
      EXPECT_LT((left.end - right.start).norm(), 1e-9);
      if (std::ranges::find(conics.g1_joints, static_cast<int>(i)) != conics.g1_joints.end())
        continue;
      EXPECT_NEAR(left.endCurvature_per_mm(), right.startCurvature_per_mm(),
                  1e-8 * std::abs(left.endCurvature_per_mm()));
    }
  }
}

TEST(ArcConics, Identity2OneArcStays) {
  const PlanarArc arc{
      .start = {1, 2}, .direction_rad = 0.3, .curvature_per_mm = 0.1, .length_mm = 15};
  const ArcConics conics = g2ConicsNear({.arcs = {arc}}, 1);
  EXPECT_THAT(conics.conics, SizeIs(1));
  EXPECT_THAT(conics.corners, IsEmpty());
  EXPECT_LT(conics.distance_mm, 1e-12);
  EXPECT_THROW(g2ConicsNear({}, 1), std::invalid_argument);
}

TEST(ArcConics, CornersStay) {
  const PlanarArc first{
      .start = {0, 0}, .direction_rad = 0, .curvature_per_mm = 0.1, .length_mm = 9};
  PlanarArc second{
      .start = first.end(), .direction_rad = 2, .curvature_per_mm = 0.2, .length_mm = 9};
  const ArcConics open = g2ConicsNear({.arcs = {first, second}, .corners = {1}}, 1);
  EXPECT_THAT(open.corners, ::testing::ElementsAre(1));
  EXPECT_LT(open.distance_mm, 1e-12);
}

TEST(ClothoidFit, Identity1NoPointIsFurtherThanTheBound) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 6; ++trial) {
    const bool closed = trial % 2 == 0;
    const BezierSpline curve = wave(random, closed);
    for (const double tolerance : {0.2, 0.01}) {
      // The cubics meet G1, so the joints are not corners.
      const ClothoidFit fit = fitClothoids(curve, {.tolerance_mm = tolerance});
      EXPECT_LE(fit.distance_mm, tolerance);
      EXPECT_LE(sampledDistance(samplesOf(curve), samplesByLength(fit.pieces)),
                fit.distance_mm + 5e-4);
      EXPECT_EQ(fit.closed, closed);
      EXPECT_THAT(fit.corners, IsEmpty());
      for (std::size_t i = 1; i < fit.pieces.size(); ++i) {
        const Clothoid &left = fit.pieces[i - 1], &right = fit.pieces[i];
        EXPECT_LT((left.end() - right.start).norm(), 1e-9);
        EXPECT_NEAR(left.curvatureAt_per_mm(left.length_mm), right.curvature_per_mm, 1e-7);
      }
    }
  }
}

TEST(ClothoidFit, Identity2CornersAndClosureStay) {
  // A square, whose sides are bent outwards.
  const auto side = [](const Vector2d& a, const Vector2d& b) -> ChainCurve {
    return arcThrough(a, directionOf(b - a) - 0.3, b);
  };
  const std::array<Vector2d, 4> at = {Vector2d(0, 0), {10, 0}, {10, 10}, {0, 10}};
  const PlanarChain square{
      .curves = {side(at[0], at[1]), side(at[1], at[2]), side(at[2], at[3]), side(at[3], at[0])},
      .closed = true};
  const ClothoidFit fit = fitClothoids(bezierSpline(square, 1e-12), {.tolerance_mm = 1e-3});
  EXPECT_TRUE(fit.closed);
  EXPECT_THAT(fit.corners, ::testing::ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(fit.pieces, SizeIs(4));
  EXPECT_LE(fit.distance_mm, 1e-3);
}

TEST(ClothoidFit, RefusesBadInput) {
  const BezierSpline line =
      bezierSpline({.curves = {PlanarArc{.length_mm = 3}}, .closed = false}, 0);
  EXPECT_THROW(fitClothoids(line, {.tolerance_mm = 0}), std::invalid_argument);
  EXPECT_THROW(fitClothoids(line, {.tolerance_mm = 1, .corner_rad = 0}), std::invalid_argument);
  EXPECT_THAT(fitClothoids(line).pieces, SizeIs(1));
}

}  // namespace
}  // namespace seamwright
