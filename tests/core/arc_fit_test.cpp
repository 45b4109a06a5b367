// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc_fit.hpp>
#include <seamwright/core/planar/clothoid.hpp>

#include "planar.hpp"

namespace seamwright {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;
using test::uniform;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Distance of a point from an arc, by its angle around the centre.
double distanceTo(const PlanarArc& arc, const Vector2d& point) {
  const double ends = std::min((point - arc.start).norm(), (point - arc.end()).norm());
  const Vector2d tangent = unitVector(arc.direction_rad), normal(-tangent.y(), tangent.x());
  if (std::abs(arc.curvature_per_mm) < 1e-12) {
    const double along = (point - arc.start).dot(tangent);
    if (along < 0 || along > arc.length_mm) return ends;
    return std::abs((point - arc.start).dot(normal));
  }
  const double radius = 1 / arc.curvature_per_mm;
  const Vector2d centre = arc.start + radius * normal;
  const Vector2d spoke = (point - centre) / (radius > 0 ? 1 : -1);
  const double angle = std::atan2(spoke.dot(tangent), -spoke.dot(normal));
  double along = angle * radius;
  const double around = 2 * pi * std::abs(radius);
  if (along < 0) along += around;
  return along <= arc.length_mm ? std::abs(spoke.norm() - std::abs(radius)) : ends;
}

/// The largest distances of samples of both curves from the other one.
std::pair<double, double> sampledDistances(const BezierSpline& curve,
                                           const std::vector<PlanarArc>& arcs) {
  double from_curve = 0, from_arcs = 0;
  std::vector<Vector2d> points;
  const double begin = curve.knots.front(), end = curve.knots.back();
  const int count = 3000;
  for (int i = 0; i <= count; ++i) {
    const CurveDerivatives d = derivatives(curve, std::lerp(begin, end, double(i) / count), 0);
    points.emplace_back(d.row(0).head<2>());
    double nearest = infinite;
    for (const PlanarArc& arc : arcs) nearest = std::min(nearest, distanceTo(arc, points.back()));
    from_curve = std::max(from_curve, nearest);
  }
  for (const PlanarArc& arc : arcs) {
    for (int j = 0; j <= 20; ++j) {
      const Vector2d point = arc.point(arc.length_mm * j / 20);
      double nearest = infinite;
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vector2d edge = points[i + 1] - points[i];
        const double t = std::clamp((point - points[i]).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (point - points[i] - t * edge).norm());
      }
      from_arcs = std::max(from_arcs, nearest);
    }
  }
  return {from_curve, from_arcs};
}

BezierSpline planarSpline(const std::vector<BezierCurve>& segments, bool closed = false) {
  std::vector<double> knots;
  for (std::size_t i = 0; i <= segments.size(); ++i) knots.push_back(static_cast<double>(i));
  return bezierSpline(segments, knots, closed, 1e-9);
}

/// A C2 cubic spline along the first axis, with random heights. \param rational random weights.
BezierSpline randomCurve(std::mt19937_64& random, int segments, bool rational) {
  const int degree = 3;
  HomogeneousPoles poles = test::randomPoles(segments + degree, rational, random);
  poles.col(2).setZero();
  for (Eigen::Index i = 0; i < poles.rows(); ++i)
    poles(i, 0) = poles(i, 3) * (static_cast<double>(i) + uniform(random, -0.2, 0.2));
  std::vector<double> breaks;
  for (int i = 0; i <= segments; ++i) breaks.push_back(i);
  return bezierSpline(BSplineCurve(degree, test::flatKnots(degree, breaks, 1), poles));
}

void expectChain(const ArcFit& fit, double tolerance) {
  ASSERT_THAT(fit.arcs, ::testing::Not(IsEmpty()));
  for (std::size_t i = 0; i < fit.arcs.size(); ++i) {
    const PlanarArc& arc = fit.arcs[i];
    EXPECT_GT(arc.length_mm, 0);
    if (i + 1 == fit.arcs.size() && !fit.closed) break;
    const std::size_t next = (i + 1) % fit.arcs.size();
    EXPECT_LT((arc.end() - fit.arcs[next].start).norm(), tolerance * 1e-5);
    if (std::ranges::find(fit.corners, static_cast<int>(next)) != fit.corners.end()) continue;
    EXPECT_LT(test::angleBetween(arc.endDirection_rad(), fit.arcs[next].direction_rad), 1e-9);
  }
}

// Identities (1) and (4).
TEST(ArcFit, StaysWithinTheToleranceInBothDirections) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 12; ++i) {
    const BezierSpline curve = randomCurve(random, 1 + i % 5, i % 2 == 1);
    const double tolerance = std::pow(10, uniform(random, -5, -1));
    const ArcFit fit = fitArcs(curve, {.tolerance_mm = tolerance});
    SCOPED_TRACE(tolerance);
    expectChain(fit, tolerance);
    EXPECT_LE(fit.distance_mm, tolerance);
    const auto [from_curve, from_arcs] = sampledDistances(curve, fit.arcs);
    EXPECT_LE(from_curve, fit.distance_mm * (1 + 1e-6) + 1e-12);
    // The polygon of the samples is off by the square of their distance.
    EXPECT_LE(from_arcs, fit.distance_mm + 2e-5);
    EXPECT_GE(fit.distance_mm, from_curve);
    EXPECT_LE(fit.distance_mm, 1.5 * from_curve + 1e-9);
    EXPECT_THAT(fit.corners, IsEmpty());
  }
}

/// A closed chain of a stadium and its bumps: lines and arcs of several radii.
std::vector<PlanarArc> arcChain(bool line_first) {
  std::vector<PlanarArc> arcs;
  PlanarArc arc = {.start = {1, 2}, .direction_rad = 0.4};
  const std::vector<std::pair<double, double>> shapes = {{0, 3}, {0.5, 2},   {-0.25, 4},
                                                         {0, 1}, {1.5, 2.5}, {0.2, 3}};
  for (const auto& [curvature, length] : shapes) {
    if (!line_first && arcs.empty() && curvature == 0) {
      arc.curvature_per_mm = 0.1;
    } else {
      arc.curvature_per_mm = curvature;
    }
    arc.length_mm = length;
    arcs.push_back(arc);
    arc.start = arc.end();
    arc.direction_rad = arc.endDirection_rad();
  }
  return arcs;
}

// Identity (2).
TEST(ArcFit, OfArcsAndLinesAreThese) {
  for (const bool line_first : {true, false}) {
    const std::vector<PlanarArc> arcs = arcChain(line_first);
    const ArcFit fit = fitArcs(bezierSpline(arcs, false, 1e-9), {.tolerance_mm = 0.01});
    ASSERT_EQ(fit.arcs.size(), arcs.size());
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      EXPECT_NEAR(fit.arcs[i].curvature_per_mm, arcs[i].curvature_per_mm, 1e-12);
      EXPECT_NEAR(fit.arcs[i].length_mm, arcs[i].length_mm, 1e-11);
      EXPECT_LT((fit.arcs[i].start - arcs[i].start).norm(), 1e-12);
    }
    EXPECT_LT(fit.distance_mm, 1e-6);
  }
}

BezierSpline closedPolygon(const std::vector<Vector2d>& vertices) {
  std::vector<BezierCurve> sides;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vector2d &from = vertices[i], &to = vertices[(i + 1) % vertices.size()];
    Poles poles(2, 3);
    poles << from.transpose(), 0, to.transpose(), 0;
    sides.emplace_back(poles);
  }
  return planarSpline(sides, true);
}

/// A closed G1 chain that turns by 2 pi.
std::vector<PlanarArc> closedChain(const std::vector<std::pair<double, double>>& pieces,
                                   double direction_rad) {
  std::vector<PlanarArc> arcs;
  PlanarArc arc{.start = {3, 5}, .direction_rad = direction_rad};
  for (const auto& [curvature_per_mm, length_mm] : pieces) {
    arc.curvature_per_mm = curvature_per_mm;
    arc.length_mm = length_mm;
    arcs.push_back(arc);
    arc.start = arc.end();
    arc.direction_rad = arc.endDirection_rad();
  }
  return arcs;
}

/// Some 1000 points at nearly equal distances with a number of digits, from one of them on.
std::vector<Vector2d> samplesOf(const std::vector<PlanarArc>& arcs, int digits, int first) {
  double length_mm = 0;
  for (const PlanarArc& arc : arcs) length_mm += arc.length_mm;
  std::vector<Vector2d> points;
  for (const PlanarArc& arc : arcs) {
    const int count = static_cast<int>(1000 * arc.length_mm / length_mm);
    for (int i = 0; i < count; ++i) points.push_back(arc.point(arc.length_mm * i / count));
  }
  // Digits of coordinates up to 100 mm.
  const double unit_mm = std::pow(10, 2 - digits);
  for (Vector2d& point : points) point = (point / unit_mm).array().round() * unit_mm;
  std::ranges::rotate(points, points.begin() + first);
  return points;
}

// Identity (2): a stadium, a rounded rectangle and a slot around a circle.
TEST(ArcFit, OfSamplesOfClosedArcsAndLinesAreThese) {
  std::mt19937_64 random(testSeed());
  const std::vector<std::vector<std::pair<double, double>>> outlines = {
      {{0, 40}, {0.1, 10 * pi}, {0, 40}, {0.1, 10 * pi}},
      {{0, 35},
       {0.25, 2 * pi},
       {0, 20},
       {0.25, 2 * pi},
       {0, 35},
       {0.25, 2 * pi},
       {0, 20},
       {0.25, 2 * pi}},
      {{-1.0 / 30, 20}, {0.25, 4 * pi}, {1.0 / 38, 20 * 38.0 / 30}, {0.25, 4 * pi}}};
  for (const auto& outline : outlines) {
    for (int digits = 5; digits <= 15; digits += 2) {
      for (const int first : {0, 33}) {
        const std::vector<PlanarArc> arcs = closedChain(outline, uniform(random, -3, 3));
        const BezierSpline curve = closedPolygon(samplesOf(arcs, digits, first));
        const ArcFit fit = fitArcs(curve, {.tolerance_mm = 0.02});
        ASSERT_THAT(fit.arcs, SizeIs(arcs.size())) << digits << ' ' << first;
        EXPECT_THAT(fit.corners, IsEmpty());
        EXPECT_LE(sampledDistances(curve, fit.arcs).first, fit.distance_mm * (1 + 1e-9));
        EXPECT_LE(sampledDistances(curve, fit.arcs).second, fit.distance_mm * (1 + 1e-9));
        const auto lines = [](const std::vector<PlanarArc>& of) {
          return std::ranges::count(of, 0, &PlanarArc::curvature_per_mm);
        };
        EXPECT_EQ(lines(fit.arcs), lines(arcs)) << digits << ' ' << first;
        double length_mm = 0;
        for (const PlanarArc& arc : fit.arcs) length_mm += arc.length_mm;
        double wanted_mm = 0;
        for (const PlanarArc& arc : arcs) wanted_mm += arc.length_mm;
        EXPECT_NEAR(length_mm, wanted_mm, 0.02);
      }
    }
  }
}

// Sides that turn where a line that stays begins leave no room for an arc.
TEST(ArcFit, PixelsAreFollowedWithinLessThanTheirSize) {
  std::vector<Vector2d> points;
  for (int i = 0; i < 300; ++i) {
    const double angle = 2 * pi * i / 300, radius = 50 + 8 * std::sin(5 * angle);
    const Vector2d point = radius * unitVector(angle);
    points.emplace_back((point * 20).array().round() / 20);
  }
  const BezierSpline curve = closedPolygon(points);
  const ArcFit fit = fitArcs(curve, {.tolerance_mm = 0.01});
  EXPECT_LE(fit.distance_mm, 0.01);
  EXPECT_LE(fit.arcs.size(), 200);
  const auto [from_curve, from_arcs] = sampledDistances(curve, fit.arcs);
  EXPECT_LE(std::max(from_curve, from_arcs), fit.distance_mm * (1 + 1e-9));
}

TEST(ArcFit, OfACircleIsOneArc) {
  const PlanarArc circle = {
      .start = {3, 0}, .direction_rad = pi / 2, .curvature_per_mm = 1.0 / 3, .length_mm = 6 * pi};
  const ArcFit fit = fitArcs(bezierSpline({circle}, true, 1e-9));
  ASSERT_THAT(fit.arcs, SizeIs(1));
  EXPECT_NEAR(fit.arcs[0].length_mm, 6 * pi, 1e-12);
  EXPECT_TRUE(fit.closed);
}

/// A closed curve with one corner: a cubic loop.
BezierSpline dropWithCorner() {
  Poles poles = Poles::Zero(4, 3);
  poles << 0, 0, 0, 6, 3, 0, 6, -3, 0, 0, 0, 0;
  return planarSpline({BezierCurve(poles)}, true);
}

// Identity (3).
TEST(ArcFit, CornersAreKept) {
  Poles left = Poles::Zero(3, 3), right = Poles::Zero(3, 3);
  left << 0, 0, 0, 2, 2, 0, 4, 2, 0;
  right << 4, 2, 0, 4, 0, 0, 6, -1, 0;
  const ArcFit fit = fitArcs(planarSpline({BezierCurve(left), BezierCurve(right)}));
  ASSERT_THAT(fit.corners, SizeIs(1));
  const PlanarArc& after = fit.arcs[fit.corners[0]];
  EXPECT_LT((after.start - Vector2d(4, 2)).norm(), 1e-12);
  EXPECT_NEAR(after.direction_rad, -pi / 2, 1e-12);
  EXPECT_LT(test::angleBetween(fit.arcs[fit.corners[0] - 1].endDirection_rad(), 0), 1e-9);
  expectChain(fit, 0.01);

  const ArcFit drop = fitArcs(dropWithCorner());
  EXPECT_THAT(drop.corners, ElementsAre(0));
  EXPECT_TRUE(drop.closed);
  expectChain(drop, 0.01);
}

TEST(ArcFit, ASmoothClosedCurveStaysSmooth) {
  std::mt19937_64 random(testSeed());
  PlanarPoints points(7, 2);
  for (int i = 0; i < 7; ++i)
    points.row(i) = (uniform(random, 4, 6) * unitVector(2 * pi * i / 7)).transpose();
  const BiarcSpline biarcs = biarcSpline(points, {.closed = true});
  const BezierSpline curve = bezierSpline(biarcs.arcs, true, 1e-9);
  const ArcFit same = fitArcs(curve);
  EXPECT_LE(same.arcs.size(), biarcs.arcs.size());
  expectChain(same, 0.01);
  EXPECT_THAT(same.corners, IsEmpty());
}

// Identity (5), for a clothoid, whose slope of curvature is constant.
TEST(ArcFit, NeedsFewMoreArcsThanTheIdealChain) {
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const Clothoid clothoid = {
        .curvature_per_mm = 0.02, .curvature_slope_per_mm2 = 0.01, .length_mm = 30};
    const BezierSpline curve = bezierSpline({clothoid}, tolerance * 1e-4, false, 1e-9).curve;
    const ArcFit fit = fitArcs(curve, {.tolerance_mm = tolerance});
    const double ideal = 30 * std::cbrt(0.01 / (72 * std::sqrt(3.0) * tolerance));
    EXPECT_GE(static_cast<double>(fit.arcs.size()), 0.99 * ideal);
    EXPECT_LE(static_cast<double>(fit.arcs.size()), 1.7 * ideal + 4) << ideal;
  }
}

// Identity (6).
TEST(ArcFit, OffsetsAreAtTheDistance) {
  std::mt19937_64 random(testSeed());
  const ArcFit fit = fitArcs(randomCurve(random, 4, false), {.tolerance_mm = 1e-3});
  double least_radius = infinite;
  for (const PlanarArc& arc : fit.arcs)
    least_radius = std::min(least_radius, 1 / std::abs(arc.curvature_per_mm));
  for (const double distance : {0.5 * least_radius, -0.5 * least_radius}) {
    const std::vector<PlanarArc> moved = offset(fit, distance);
    ASSERT_EQ(moved.size(), fit.arcs.size());
    for (std::size_t i = 0; i < moved.size(); ++i) {
      if (i + 1 < moved.size()) {
        EXPECT_LT((moved[i].end() - moved[i + 1].start).norm(), 1e-9);
      }
      for (const double share : {0.0, 0.3, 1.0}) {
        const PlanarArc& arc = fit.arcs[i];
        const double s_mm = share * arc.length_mm;
        const Vector2d left = unitVector(arc.directionAt_rad(s_mm) + pi / 2);
        const Vector2d expected = arc.point(s_mm) + distance * left;
        EXPECT_LT((moved[i].point(share * moved[i].length_mm) - expected).norm(), 1e-9);
      }
    }
  }
  // One side has the centre of the tightest arc.
  const double beyond = 1.01 * least_radius;
  EXPECT_ANY_THROW({
    offset(fit, beyond);
    offset(fit, -beyond);
  });
}

TEST(ArcFit, OffsetGoesAroundACorner) {
  const ArcFit fit = fitArcs(dropWithCorner());
  // The drop runs clockwise, so its outside is to the left.
  const std::vector<PlanarArc> moved = offset(fit, 0.5);
  ASSERT_EQ(moved.size(), fit.arcs.size() + 1);
  EXPECT_NEAR(std::abs(moved.front().curvature_per_mm), 2, 1e-12);
  for (std::size_t i = 0; i < moved.size(); ++i)
    EXPECT_LT((moved[i].end() - moved[(i + 1) % moved.size()].start).norm(), 1e-6);
  EXPECT_THROW(offset(fit, -0.1), std::domain_error);
  EXPECT_EQ(offset(fit, 0).size(), fit.arcs.size());
}

TEST(ArcFit, MovesAlongWithTheCurve) {
  std::mt19937_64 random(testSeed());
  const BezierSpline curve = randomCurve(random, 3, false);
  BezierSpline moved = curve;
  const double angle = 0.7;
  moved.poles.col(0) =
      4 * (std::cos(angle) * curve.poles.col(0) - std::sin(angle) * curve.poles.col(1)) +
      100 * curve.poles.col(3);
  moved.poles.col(1) =
      4 * (std::sin(angle) * curve.poles.col(0) + std::cos(angle) * curve.poles.col(1));
  const ArcFit one = fitArcs(curve, {.tolerance_mm = 1e-3});
  const ArcFit other = fitArcs(moved, {.tolerance_mm = 4e-3});
  // Rounding decides how far a step reaches, so the arcs differ within the resolution of steps.
  EXPECT_NEAR(static_cast<double>(one.arcs.size()), static_cast<double>(other.arcs.size()), 2);
  EXPECT_LE(other.distance_mm, 4e-3);
}

// Identity (1), or an error, where rounding is near the tolerance.
TEST(ArcFit, RoundingDoesNotExceedTheTolerance) {
  const auto distance = [](double size, double weight, double tolerance) {
    HomogeneousPoles poles = HomogeneousPoles::Zero(3, 4);
    poles << size, 0, 0, 1, weight * (size + 10), weight * 10, 0, weight, size + 20, 0, 0, 1;
    const BezierSpline curve =
        bezierSpline(BSplineCurve(2, std::vector<double>{0, 0, 0, 1, 1, 1}, poles));
    try {
      return fitArcs(curve, {.tolerance_mm = tolerance}).distance_mm / tolerance;
    } catch (const std::domain_error&) {
      return 0.0;
    }
  };
  EXPECT_LE(distance(1e12, 1, 0.01), 1);
  EXPECT_LE(distance(0, 1e-12, 1e-9), 1);
}

TEST(ArcFit, SlantedLinesAreLines) {
  // A slot in several directions, far from the origin: its lines are exact to rounding only.
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const double turn = uniform(random, -4, 4), size = std::pow(10, uniform(random, -2, 3));
    std::vector<PlanarArc> slot;
    PlanarArc arc{.start = Vector2d(uniform(random, -1e3, 1e3), uniform(random, -1e3, 1e3)),
                  .direction_rad = turn};
    for (const bool line : {true, false, true, false}) {
      arc.curvature_per_mm = line ? 0 : 1 / size;
      arc.length_mm = line ? 3 * size : std::numbers::pi * size;
      slot.push_back(arc);
      arc.start = arc.end();
      arc.direction_rad = arc.endDirection_rad();
    }
    const ArcFit fit = fitArcs(bezierSpline(slot, true, 1e-8), {.tolerance_mm = 1e-3 * size});
    const auto lines = std::ranges::count_if(
        fit.arcs, [](const PlanarArc& piece) { return piece.curvature_per_mm == 0; });
    EXPECT_EQ(lines, 2) << i;
    EXPECT_LE(fit.arcs.size(), 5U) << i;  // the closing point may divide an arc
  }
}

TEST(ArcFit, InvalidInputIsNamed) {
  std::mt19937_64 random(testSeed());
  const BezierSpline good = randomCurve(random, 2, false);
  const auto message = [](const BezierSpline& curve, ArcFitOptions options = {}) -> std::string {
    try {
      fitArcs(curve, options);
      return "nothing";
    } catch (const std::exception& error) {
      return error.what();
    }
  };
  EXPECT_THAT(message(good, {.tolerance_mm = 0}), HasSubstr("tolerance is 0 mm"));
  EXPECT_THAT(message(good, {.tolerance_mm = std::nan("")}), HasSubstr("tolerance is nan"));
  EXPECT_THAT(message(good, {.corner_rad = 4}), HasSubstr("corner angle is 4 rad"));
  EXPECT_THAT(message(good, {.tolerance_mm = 1e-17}), HasSubstr("the tolerance 1e-17 mm is below"));
  BezierSpline outside = good;
  outside.poles(1, 2) = 0.5;
  EXPECT_THAT(message(outside), HasSubstr("outside of the plane"));
  Poles cusp = Poles::Zero(4, 3);
  cusp << 0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0;
  EXPECT_THAT(message(planarSpline({BezierCurve(cusp)})), HasSubstr("the curve stops"));
}

}  // namespace
}  // namespace seamwright
