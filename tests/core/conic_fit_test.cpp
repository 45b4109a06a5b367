// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/planar/conic_fit.hpp>
#include <seamwright/core/planar/conic_spline.hpp>
#include <seamwright/core/planar/planar_chain.hpp>

#include "planar.hpp"

/// Conics near a curve. The oracle are samples: distances and curvatures of points alone.
namespace seamwright {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;
using test::uniform;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<Vector2d> samplesOf(const BezierSpline& curve) {
  constexpr int count = 4000;
  std::vector<Vector2d> points;
  for (int i = 0; i <= count; ++i) {
    const double u =
        std::lerp(curve.knots.front(), curve.knots.back(), static_cast<double>(i) / count);
    points.emplace_back(derivatives(curve, u, 0).row(0).head<2>());
  }
  return points;
}

std::vector<Vector2d> samplesOf(const std::vector<PlanarConic>& conics) {
  constexpr int count = 60;
  std::vector<Vector2d> points;
  for (const PlanarConic& conic : conics)
    for (int i = 0; i <= count; ++i) points.push_back(conic.point(static_cast<double>(i) / count));
  return points;
}

/// The largest distance of points from a polygon.
double distanceFrom(const std::vector<Vector2d>& polygon, const std::vector<Vector2d>& points) {
  double largest = 0;
  for (const Vector2d& point : points) {
    double nearest = (point - polygon.front()).norm();
    for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
      const Vector2d edge = polygon[i + 1] - polygon[i], from = point - polygon[i];
      const double squared = edge.squaredNorm();
      const double t = squared > 0 ? std::clamp(from.dot(edge) / squared, 0.0, 1.0) : 0;
      nearest = std::min(nearest, (from - t * edge).norm());
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

BezierCurve planarBezier(const std::vector<Vector2d>& points) {
  Poles poles = Poles::Zero(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    poles.row(static_cast<Eigen::Index>(i)).head<2>() = points[i].transpose();
  return BezierCurve(poles);
}

BezierSpline planarSpline(const std::vector<BezierCurve>& segments, bool closed = false) {
  std::vector<double> knots;
  for (std::size_t i = 0; i <= segments.size(); ++i) knots.push_back(static_cast<double>(i));
  return bezierSpline(segments, knots, closed, 1e-9);
}

/// A C2 cubic spline along the first axis, with random heights.
BezierSpline randomCurve(std::mt19937_64& random, int segments, bool rational) {
  constexpr int degree = 3;
  HomogeneousPoles poles = test::randomPoles(segments + degree, rational, random);
  poles.col(2).setZero();
  for (Eigen::Index i = 0; i < poles.rows(); ++i)
    poles(i, 0) = poles(i, 3) * (static_cast<double>(i) + uniform(random, -0.2, 0.2));
  std::vector<double> breaks;
  for (int i = 0; i <= segments; ++i) breaks.push_back(i);
  return bezierSpline(BSplineCurve(degree, test::flatKnots(degree, breaks, 1), poles));
}

BezierSpline arcSpline(const std::vector<PlanarArc>& arcs, bool closed) {
  return bezierSpline(PlanarChain{.curves = {arcs.begin(), arcs.end()}, .closed = closed}, 1e-9);
}

/// By differences of points, so without the derivatives of the conic.
double curvatureBeside(const PlanarConic& conic, double t) {
  constexpr double h = 1e-3;
  const double s = std::clamp(t, h, 1 - h);
  const Vector2d a = conic.point(s - h), b = conic.point(s), c = conic.point(s + h);
  return 2 * cross(b - a, c - b) / ((b - a).norm() * (c - b).norm() * (c - a).norm());
}

/// The largest curvature: rounding of the differences is small against it.
double sharpest(const PlanarConic& conic) {
  double largest = 0;
  for (int i = 0; i <= 10; ++i)
    largest = std::max(largest, std::abs(curvatureBeside(conic, i / 10.0)));
  return largest;
}

bool contains(const std::vector<int>& list, int value) {
  return std::ranges::find(list, value) != list.end();
}

TEST(ConicFit, Identity1StaysWithinTheToleranceInBothDirections) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 10; ++i) {
    const BezierSpline curve = randomCurve(random, 1 + i % 5, i % 2 == 1);
    const double tolerance = std::pow(10, uniform(random, -4, -1));
    SCOPED_TRACE(tolerance);
    const ConicFit fit = fitConics(curve, {.tolerance_mm = tolerance});
    EXPECT_LE(fit.distance_mm, tolerance);
    const std::vector<Vector2d> of_curve = samplesOf(curve), of_conics = samplesOf(fit.conics);
    // A polygon of samples is inside of the curve by the square of their distance.
    const double off = 2e-6 + 0.01 * tolerance;
    EXPECT_LE(distanceFrom(of_conics, of_curve), fit.distance_mm + off);
    EXPECT_LE(distanceFrom(of_curve, of_conics), fit.distance_mm + off);
  }
}

TEST(ConicFit, Identity2JoinsG2ExceptWhereItSays) {
  std::mt19937_64 random(testSeed());
  for (int k = 0; k < 6; ++k) {
    const ConicFit fit = fitConics(randomCurve(random, 2 + k, false), {.tolerance_mm = 1e-3});
    for (int i = 1; i < static_cast<int>(fit.conics.size()); ++i) {
      const PlanarConic &before = fit.conics[i - 1], &after = fit.conics[i];
      EXPECT_EQ(before.end, after.start);
      const Vector2d in = (before.end - before.corner).normalized(),
                     out = (after.corner - after.start).normalized();
      EXPECT_NEAR(cross(in, out), 0, 1e-9);
      EXPECT_GT(in.dot(out), 0);
      // Formulas, which have tests of their own: beside inflections differences are all rounding.
      const double ahead = after.startCurvature_per_mm(), back = before.endCurvature_per_mm();
      if (contains(fit.g1_joints, i))
        EXPECT_LT(ahead * back, 0);
      else
        EXPECT_NEAR(ahead, back, 1e-6 * std::max(sharpest(before), sharpest(after)));
    }
  }
}

TEST(ConicFit, Identity3LinesAndCirclesStay) {
  const ConicFit line = fitConics(planarSpline({planarBezier({{1, 2}, {3, 5}})}));
  ASSERT_THAT(line.conics, SizeIs(1));
  EXPECT_LT(std::abs(cross(line.conics[0].corner - Vector2d(1, 2), Vector2d(2, 3))), 1e-14);
  EXPECT_EQ(line.conics[0].end, Vector2d(3, 5));

  std::vector<PlanarArc> arcs;
  for (int i = 0; i < 4; ++i)
    arcs.push_back({.start = Vector2d(7, -3) + 2.5 * unitVector(i * pi / 2),
                    .direction_rad = (i + 1) * pi / 2,
                    .curvature_per_mm = 0.4,
                    .length_mm = 2.5 * pi / 2});
  const ConicFit circle = fitConics(arcSpline(arcs, true), {.tolerance_mm = 1e-6});
  for (const Vector2d& point : samplesOf(circle.conics))
    EXPECT_NEAR((point - Vector2d(7, -3)).norm(), 2.5, 1e-12);
  EXPECT_TRUE(circle.closed);
}

/// A line, an arc that turns by a right angle, and a line.
BezierSpline bend() {
  return arcSpline(
      {{.start = {0, 0}, .direction_rad = 0, .length_mm = 20},
       {.start = {20, 0}, .direction_rad = 0, .curvature_per_mm = 0.2, .length_mm = 5 * pi / 2},
       {.start = {25, 5}, .direction_rad = pi / 2, .length_mm = 10}},
      false);
}

TEST(ConicFit, LinesBesideArcsStayAndTouchThem) {
  const ConicFit fit = fitConics(bend(), {.tolerance_mm = 1e-4});
  EXPECT_EQ(fit.conics.front().start, Vector2d(0, 0));
  EXPECT_EQ(fit.conics.front().end, Vector2d(20, 0));
  EXPECT_EQ(fit.conics.front().turn_rad(), 0);
  EXPECT_LT((fit.conics.back().start - Vector2d(25, 5)).norm(), 1e-12);
  const int last = static_cast<int>(fit.conics.size()) - 1;
  EXPECT_THAT(fit.g1_joints, ElementsAre(1, last));
  const PlanarConic& first = fit.conics[1];
  EXPECT_NEAR((first.corner - first.start).normalized().y(), 0, 1e-9);
  // The arc is a conic: no waves are added.
  for (int i = 1; i < last; ++i)
    for (const double t : {0.0, 0.5, 1.0})
      EXPECT_NEAR(curvatureBeside(fit.conics[static_cast<std::size_t>(i)], t), 0.2, 1e-4);
}

TEST(ConicFit, Identity4CornersStay) {
  // Half a disc, which begins in the middle of its straight side.
  const auto arc = [](double start_rad) {
    return PlanarArc{.start = 4 * unitVector(start_rad),
                     .direction_rad = start_rad + pi / 2,
                     .curvature_per_mm = 0.25,
                     .length_mm = pi * 2};
  };
  const ConicFit fit = fitConics(arcSpline({{.start = {0, 0}, .direction_rad = 0, .length_mm = 4},
                                            arc(0),
                                            arc(pi / 2),
                                            {.start = {-4, 0}, .direction_rad = 0, .length_mm = 4}},
                                           true),
                                 {.tolerance_mm = 1e-3});
  EXPECT_TRUE(fit.closed);
  ASSERT_THAT(fit.corners, SizeIs(2));
  std::vector<Vector2d> corners;
  for (const int i : fit.corners) corners.push_back(fit.conics[static_cast<std::size_t>(i)].start);
  std::ranges::sort(corners, {}, [](const Vector2d& point) { return point.x(); });
  EXPECT_LT((corners[0] - Vector2d(-4, 0)).norm(), 1e-12);
  EXPECT_LT((corners[1] - Vector2d(4, 0)).norm(), 1e-12);
  EXPECT_LT((fit.conics.back().end - fit.conics.front().start).norm(), 1e-12);
}

TEST(ConicFit, WavesWithinTheToleranceAreNotFollowed) {
  // A quarter of an ellipse with waves of 2e-4 mm: the curve has dozens of extrema.
  std::vector<Vector2d> points;
  constexpr int count = 40;
  for (int i = 0; i <= count; ++i) {
    const double angle = pi / 2 * i / count, wave = i % 2 == 0 ? 2e-4 : -2e-4;
    points.emplace_back((30 + wave) * std::cos(angle), (12 + wave) * std::sin(angle));
  }
  HomogeneousPoles poles = HomogeneousPoles::Zero(count + 1, 4);
  for (int i = 0; i <= count; ++i) {
    poles.row(i).head<2>() = points[static_cast<std::size_t>(i)].transpose();
    poles(i, 3) = 1;
  }
  std::vector<double> breaks;
  for (int i = 0; i <= count - 2; ++i) breaks.push_back(i);
  const BSplineCurve waves(3, test::flatKnots(3, breaks, 1), poles);
  const int before = figuresOf({.curves = {waves}, .closed = false}).extrema;
  EXPECT_GE(before, 15);
  const ConicFit fit = fitConics(bezierSpline(waves), {.tolerance_mm = 0.02});
  const PlanarChain chain{.curves = {fit.conics.begin(), fit.conics.end()}, .closed = false};
  EXPECT_LE(figuresOf(chain).extrema, 3);
  EXPECT_EQ(figuresOf(chain).inflections, 0);
  EXPECT_THAT(fit.g1_joints, IsEmpty());
}

TEST(ConicFit, KinksOfASampledCurveAreSmoothAndOthersStay) {
  // Sides of a circle of the radius 10 with a sagitta of 2e-4 mm.
  constexpr int sides = 240;
  std::vector<BezierCurve> circle;
  for (int i = 0; i < sides; ++i)
    circle.push_back(planarBezier({10 * unitVector(2 * pi * i / sides),
                                   10 * unitVector(2 * pi * ((i + 1) % sides) / sides)}));
  const BezierSpline polygon = planarSpline(circle, true);
  const ConicFit smooth = fitConics(polygon, {.tolerance_mm = 0.01});
  EXPECT_THAT(smooth.corners, IsEmpty());
  EXPECT_LE(smooth.conics.size(), 40u);
  for (const Vector2d& point : samplesOf(smooth.conics)) EXPECT_NEAR(point.norm(), 10, 0.01);
  // Below the sagitta the sides are the curve.
  EXPECT_THAT(fitConics(polygon, {.tolerance_mm = 1e-4}).corners, SizeIs(sides));
  // The same kink between long sides is a corner.
  const ConicFit bent =
      fitConics(planarSpline({planarBezier({{-50, 0}, {0, 0}}),
                              planarBezier({{0, 0}, 50 * unitVector(2 * pi / sides)})}),
                {.tolerance_mm = 0.01});
  EXPECT_THAT(bent.corners, ElementsAre(1));
}

TEST(ConicFit, ACuspIsACorner) {
  // (t^3, t^2) from -1 to 1.
  const BezierSpline curve =
      planarSpline({planarBezier({{-1, 1}, {1, -1.0 / 3}, {-1, -1.0 / 3}, {1, 1}})});
  const ConicFit fit = fitConics(curve, {.tolerance_mm = 1e-4});
  ASSERT_THAT(fit.corners, SizeIs(1));
  EXPECT_LT(fit.conics[static_cast<std::size_t>(fit.corners[0])].start.norm(), 1e-6);
  for (const Vector2d& point : samplesOf(fit.conics)) {
    // The nearest point of the curve is not further than those with the same abscissa and ordinate.
    const double t = std::cbrt(point.x()), s = std::sqrt(std::max(point.y(), 0.0));
    EXPECT_LE(std::min(std::abs(t * t - point.y()), std::abs(s * s * s - std::abs(point.x()))),
              1e-4 * (1 + 1e-9));
  }
}

TEST(ConicFit, ASpeckIsALine) {
  // A wire of a drawing, which goes nowhere.
  const ConicFit fit = fitConics(
      planarSpline({planarBezier({{0, 0}, {5.8e-7, 7.9e-8}, {8.8e-7, 1.2e-7}, {0, 0}})}, true));
  EXPECT_THAT(fit.conics, SizeIs(2));
  EXPECT_LE(fit.distance_mm, 2e-6);
  EXPECT_EQ(fit.conics[0].start, fit.conics[1].end);
}

/// The quarters of a figure eight meet at its crossing, in one point up to rounding.
TEST(ConicFit, AFigureEightMayBeginAtItsCrossing) {
  constexpr int points = 48;
  for (const double start : {0.0, pi / 3}) {
    PlanarPoints eight(points, 2);
    for (int i = 0; i < points; ++i) {
      const double t = start + 2 * pi * i / points;
      eight.row(i) << 50 * std::sin(t), 25 * std::sin(2 * t);
    }
    for (const bool closed : {false, true}) {
      if (!closed) {
        eight.conservativeResize(points + 1, 2);
        eight.row(points) = eight.row(0);
      }
      const std::vector<PlanarConic> conics =
          conicSpline(eight.topRows(points + !closed), closed).conics;
      const BezierSpline curve = bezierSpline(
          PlanarChain{.curves = {conics.begin(), conics.end()}, .closed = closed}, 1e-9);
      for (const double tolerance_mm : {0.1, 1e-3}) {
        const ConicFit fit = fitConics(curve, {.tolerance_mm = tolerance_mm});
        EXPECT_LE(fit.distance_mm, tolerance_mm);
        EXPECT_LE(distanceFrom(samplesOf(fit.conics), samplesOf(curve)), tolerance_mm + 1e-4);
        EXPECT_THAT(fit.corners, IsEmpty());
        EXPECT_THAT(fit.g1_joints, SizeIs(closed ? 2 : start > 0 ? 2 : 1));
      }
    }
  }
}

TEST(ConicFit, EndsWhereNoConicsKeepTheTolerance) {
  std::mt19937_64 random(testSeed());
  EXPECT_THROW(fitConics(randomCurve(random, 6, false), {.tolerance_mm = 1e-18}),
               std::domain_error);
}

TEST(ConicFit, RefusesBadInputAndPoints) {
  const BezierSpline line = planarSpline({planarBezier({{0, 0}, {1, 0}})});
  EXPECT_THROW(fitConics(line, {.tolerance_mm = 0}), std::invalid_argument);
  EXPECT_THROW(fitConics(line, {.tolerance_mm = 0.1, .corner_rad = 4}), std::invalid_argument);
  // A point is no curve.
  EXPECT_THROW(fitConics(planarSpline({planarBezier({{1, 2}, {1, 2}})})), std::logic_error);
}

}  // namespace
}  // namespace seamwright
