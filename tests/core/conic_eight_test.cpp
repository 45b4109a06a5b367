// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/conic_spline.hpp>

#include "planar.hpp"

/// Conics through points of closed curves that cross themselves at inflections, wherever the points
/// begin. The oracle are the curves.
namespace seamwright {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using std::numbers::pi;
using test::uniform;
using ::testing::SizeIs;

using Curve = std::function<Vector2d(double)>;  ///< of the period 2 pi

/// Its inflections are at pi/2 and 3 pi/2, where it crosses itself.
Vector2d lemniscate(double t) {
  const double shrunk = 1 + std::sin(t) * std::sin(t);
  return Vector2d(std::cos(t), std::sin(t) * std::cos(t)) / shrunk;
}

/// Its inflections are at 0 and pi, where it crosses itself.
Vector2d figureEight(double t) {
  return {std::sin(t), std::sin(2 * t) / 2};
}

/// Its inflections are where 3 cos 5t + 15 cos t = 0: at pi/2 and 3 pi/2, where it crosses itself.
Vector2d lissajous(double t) {
  return {std::sin(2 * t), std::cos(3 * t)};
}

PlanarPoints pointsOf(const Curve& curve, double start, Index count) {
  PlanarPoints points(count, 2);
  for (Index i = 0; i < count; ++i)
    points.row(i) =
        curve(start + 2 * pi * static_cast<double>(i) / static_cast<double>(count)).transpose();
  return points;
}

/// The first point again at the end.
PlanarPoints openedAt(const PlanarPoints& points) {
  PlanarPoints opened(points.rows() + 1, 2);
  opened << points, points.row(0);
  return opened;
}

/// From dense samples of the curve.
double distanceFrom(const Curve& curve, const Vector2d& point) {
  constexpr int samples = 4000;
  double nearest = infinite;
  for (int i = 0; i < samples; ++i)
    nearest = std::min(nearest, (curve(2 * pi * i / samples) - point).norm());
  return nearest;
}

void expectTangents(const ConicSpline& spline, double size_mm) {
  const auto n = spline.conics.size();
  for (std::size_t i = spline.closed ? 0 : 1; i < n; ++i) {
    const PlanarConic &before = spline.conics[(i + n - 1) % n], &after = spline.conics[i];
    const Vector2d in = before.end - before.corner, out = after.corner - after.start;
    EXPECT_LT(std::abs(angleFromTo(in, out)),
              1e-8 + 16 * machine_epsilon * size_mm / std::min(in.norm(), out.norm()));
  }
}

void expectSound(const ConicSpline& spline, const PlanarPoints& points) {
  for (const PlanarConic& conic : spline.conics) {
    ASSERT_TRUE(conic.start.allFinite() && conic.corner.allFinite() && conic.end.allFinite());
    ASSERT_TRUE(std::isfinite(conic.weight) && conic.weight > 0);
    ASSERT_GT((conic.end - conic.start).norm(), 0);
  }
  for (Index i = 0; i < points.rows(); ++i)
    EXPECT_TRUE(std::ranges::any_of(spline.conics, [&](const PlanarConic& conic) {
      return conic.start == points.row(i).transpose() || conic.end == points.row(i).transpose();
    })) << i;
  expectTangents(spline, points.cwiseAbs().maxCoeff());
}

/// Starts at an inflection, so near to it that rounding counts, and elsewhere.
std::vector<double> startsBeside(double inflection) {
  std::vector<double> starts = {inflection, inflection + 0.1, inflection + 1};
  for (int power = 2; power <= 17; ++power)
    for (const double sign : {-1.0, 1.0})
      starts.push_back(inflection + sign * std::pow(10, -power));
  return starts;
}

TEST(ConicEights, Identity6StartAnywhere) {
  for (const auto& [curve, inflection] :
       {std::pair<Curve, double>(&lemniscate, pi / 2), {&figureEight, 0}, {&lissajous, pi / 2}})
    for (const Index count : {24, 41})
      for (const double start : startsBeside(inflection)) {
        SCOPED_TRACE(testing::Message() << count << " points from " << start);
        const PlanarPoints points = pointsOf(curve, start, count);
        const ConicSpline closed = conicSpline(points, true);
        expectSound(closed, points);
        expectSound(conicSpline(openedAt(points)), points);
      }
}

TEST(ConicEights, Identity6AreNearTheCurveAndChangeTheirSideAtItsInflections) {
  std::mt19937_64 random(testSeed());
  for (const double start : {pi / 2, pi / 2 + 1e-9, pi / 2 - 1e-12, uniform(random, 0, 2 * pi)}) {
    SCOPED_TRACE(start);
    const ConicSpline spline = conicSpline(pointsOf(&lemniscate, start, 60), true);
    EXPECT_THAT(spline.g1_joints, SizeIs(2));
    double turn = 0, turned = 0;
    for (const PlanarConic& conic : spline.conics) {
      turn += conic.turn_rad();
      turned += std::abs(conic.turn_rad());
      for (const double t : {0.3, 0.7}) EXPECT_LT(distanceFrom(&lemniscate, conic.point(t)), 1e-3);
    }
    EXPECT_NEAR(turn, 0, 1e-6);
    // At the crossing the branches are at right angles to each other.
    EXPECT_NEAR(turned, 3 * pi, 0.02);
  }
}

TEST(ConicEights, Identity4MoveAlong) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 8; ++i) {
    const double size = std::pow(10, uniform(random, -6, 6)), angle = uniform(random, 0, 2 * pi);
    const Vector2d place = size * Vector2d(uniform(random, -3, 3), uniform(random, -3, 3));
    SCOPED_TRACE(testing::Message() << size << " " << angle << " at " << place.transpose());
    const Curve moved = [&](double t) {
      const Vector2d p = lemniscate(t);
      return Vector2d(place + size * Vector2d(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
                                              std::sin(angle) * p.x() + std::cos(angle) * p.y()));
    };
    for (const double start : {pi / 2, 3 * pi / 2, pi / 2 + 1e-8}) {
      const PlanarPoints points = pointsOf(moved, start, 48);
      const ConicSpline spline = conicSpline(points, true);
      expectSound(spline, points);
      expectSound(conicSpline(openedAt(points)), points);
      EXPECT_THAT(spline.g1_joints, SizeIs(2));
      for (const PlanarConic& conic : spline.conics)
        EXPECT_LT(distanceFrom(moved, conic.point(0.5)), 1e-3 * size);
    }
  }
}

}  // namespace
}  // namespace seamwright
