// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <seamwright/core/blend/common_knots.hpp>
#include <seamwright/core/spline/nu_spline.hpp>

#include "frames.hpp"

namespace seamwright {
namespace {

using std::numbers::pi;
using test::drawn;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// The C2 cubic spline through points.
BezierSpline through(const Poles& points, bool closed) {
  NuSplineData data;
  data.points = points;
  if (closed) {
    data.points.conservativeResize(points.rows() + 1, 3);
    data.points.bottomRows<1>() = points.topRows<1>();
    data.ends = SplineEnds::Periodic;
  }
  data.knots = knotsOf(data.points);
  data.nu.assign(data.knots.size(), 0);
  return nuSpline(data).curve;
}

/// Points of an ellipse with four waves, at uneven angles.
BezierSpline outline(int count, double a, double b, double waves, std::mt19937_64& random) {
  Poles points(count, 3);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * (i + drawn(-0.2, 0.2, random)) / count;
    const double swell = 1 + waves * std::cos(4 * angle);
    points.row(i) << swell * a * std::cos(angle), swell * b * std::sin(angle), 0;
  }
  return through(points, true);
}

/// An arc of a helix, for curves of space.
BezierSpline helix(int count, double radius, double rise, std::mt19937_64& random) {
  Poles points(count, 3);
  for (int i = 0; i < count; ++i) {
    const double angle = 2.5 * (i + drawn(-0.2, 0.2, random)) / count;
    points.row(i) << radius * std::cos(angle), radius * std::sin(angle), rise * angle;
  }
  return through(points, false);
}

Poles samples(const BezierSpline& spline, int of_segment) {
  Poles result(static_cast<Eigen::Index>(spline.segments()) * of_segment + 1, 3);
  for (int i = 0; i < spline.segments(); ++i)
    for (int k = 0; k <= of_segment; ++k)
      result.row(static_cast<Eigen::Index>(i) * of_segment + k) =
          segment(spline, i).point(static_cast<double>(k) / of_segment).transpose();
  return result;
}

/// The distance of a point from a curve: Newton's method from the nearest of dense samples.
double distanceFrom(const BezierSpline& curve, const Poles& dense, int of_segment,
                    const Eigen::Vector3d& point) {
  Eigen::Index nearest = 0;
  (dense.rowwise() - point.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  double result = (dense.row(nearest).transpose() - point).norm();
  const int piece = static_cast<int>(nearest) / of_segment;
  for (const int i : {piece - 1, piece, curve.segments() - 1}) {
    if (i < 0 || i >= curve.segments()) continue;
    double t = std::clamp(static_cast<double>(nearest) / of_segment - i, 0.0, 1.0);
    for (int step = 0; step < 20; ++step) {
      const CurveDerivatives x = segment(curve, i).derivatives(t, 1);
      const Eigen::Vector3d off = point - x.row(0).transpose(), velocity = x.row(1);
      result = std::min(result, off.norm());
      t = std::clamp(t + off.dot(velocity) / velocity.squaredNorm(), 0.0, 1.0);
    }
  }
  return result;
}

/// The largest distance of samples of one curve from the other curve.
double strayed(const BezierSpline& from, const BezierSpline& to) {
  constexpr int of_segment = 20;
  const Poles points = samples(from, 16), dense = samples(to, of_segment);
  double result = 0;
  for (const auto& p : points.rowwise())
    result = std::max(result, distanceFrom(to, dense, of_segment, p.transpose()));
  return result;
}

BezierSpline blended(const BezierSpline& a, const BezierSpline& b, double omega) {
  BezierSpline result = a;
  result.poles = (1 - omega) * a.poles + omega * b.poles;
  return result;
}

/// The largest turn and jump of the curvature at joints.
std::pair<double, double> jumpsOf(const BezierSpline& spline) {
  double turn = 0, jump = 0;
  for (const CurveJoint& joint : measureJoints(spline, 2)) {
    turn = std::max(turn, joint.angle_rad.value_or(pi));
    jump = std::max(jump, joint.differences.size() > 2 ? joint.differences[2] : 1e9);
  }
  return {turn, jump};
}

/// The range of the curvature over the spline.
std::pair<double, double> curvatures(const BezierSpline& spline) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (int i = 0; i < spline.segments(); ++i)
    for (int k = 0; k <= 20; ++k) {
      const CurveDerivatives d = segment(spline, i).derivatives(k / 20.0, 2);
      const Eigen::Vector3d first = d.row(1), second = d.row(2);
      const double curvature = first.cross(second).z() / std::pow(first.norm(), 3);
      least = std::min(least, curvature);
      most = std::max(most, curvature);
    }
  return {least, most};
}

TEST(CommonKnots, Identity1ResultsAreWithinTheDistance) {
  std::mt19937_64 random(testSeed());
  for (const double tolerance_mm : {1e-2, 1e-4})
    for (const MatchBy by : {MatchBy::Length, MatchBy::Features}) {
      const std::vector<BezierSpline> frames = {outline(24, 30, 20, 0, random),
                                                outline(37, 15, 25, 0.1, random)};
      const CommonKnots common =
          commonKnots(frames, {.match = {.by = by}, .tolerance_mm = tolerance_mm});
      EXPECT_TRUE(common.reached);
      EXPECT_EQ(common.frames[0].knots, common.frames[1].knots);
      for (std::size_t f = 0; f < 2; ++f) {
        EXPECT_LE(common.distance_mm[f], tolerance_mm);
        const double there_mm = strayed(common.frames[f], frames[f]),
                     back_mm = strayed(frames[f], common.frames[f]);
        EXPECT_LE(std::max(there_mm, back_mm), common.distance_mm[f]);
        // At joints of the frame the bound also counts the distance along the curve.
        EXPECT_LT(common.distance_mm[f],
                  std::max(3 * std::max(there_mm, back_mm), 0.25 * tolerance_mm));
      }
    }
}

TEST(CommonKnots, Identity2CornersStay) {
  // A polygon with a right angle in the middle, and a circular arc.
  Poles ends(3, 3), arc(9, 3);
  ends << 0, 0, 0, 10, 0, 0, 10, 10, 0;
  for (int i = 0; i < 9; ++i)
    arc.row(i) << 12 * std::sin(pi / 16 * i), 12 - 12 * std::cos(pi / 16 * i), 5;
  const BezierSpline corner =
      bezierSpline({BezierCurve(ends.topRows<2>()), BezierCurve(ends.bottomRows<2>())}, {0, 1, 2});
  const CommonKnots common = commonKnots({corner, through(arc, false)}, {.tolerance_mm = 1e-5});
  EXPECT_TRUE(common.reached);
  double largest = 0;
  for (const CurveJoint& joint : measureJoints(common.frames[0], 1))
    largest = std::max(largest, joint.angle_rad.value_or(0));
  EXPECT_NEAR(largest, pi / 2, 1e-9);
  EXPECT_LT(jumpsOf(common.frames[1]).first, 1e-9);
  EXPECT_LT(strayed(common.frames[0], corner), 2e-5);
}

TEST(CommonKnots, Identity3LinearBlendsAreG2AndFair) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 6; ++trial) {
    const BezierSpline a = outline(20 + 3 * trial, 30, 20, 0, random),
                       b = outline(31 - trial, 25, 24, 0.02, random);
    const CommonKnots common = commonKnots({a, b}, {.tolerance_mm = 1e-3});
    const auto [least_a, most_a] = curvatures(common.frames[0]);
    const auto [least_b, most_b] = curvatures(common.frames[1]);
    for (const double omega : {0.25, 0.5, 0.75}) {
      const BezierSpline frame = blended(common.frames[0], common.frames[1], omega);
      const auto [turn, jump] = jumpsOf(frame);
      EXPECT_LT(turn, 1e-10) << trial;
      EXPECT_LT(jump, 1e-8) << trial;
      // No narrow turns: the curvature between is about within that of the key curves.
      const auto [least, most] = curvatures(frame);
      const double range = std::max(most_a, most_b) - std::min(least_a, least_b);
      EXPECT_GT(least, std::min(least_a, least_b) - 0.5 * range) << trial;
      EXPECT_LT(most, std::max(most_a, most_b) + 0.5 * range) << trial;
    }
  }
}

TEST(CommonKnots, Identity4RigidMotionAndScale) {
  std::mt19937_64 random(testSeed());
  const std::vector<BezierSpline> frames = {helix(12, 20, 3, random), helix(17, 10, 9, random)};
  const CommonKnots given = commonKnots(frames, {.tolerance_mm = 1e-3});
  const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d(1, 2, 2).normalized());
  constexpr double scale = 8;
  std::vector<BezierSpline> moved = frames;
  const auto move = [&](BezierSpline& spline) {
    spline.poles.leftCols<3>() =
        (scale * spline.poles.leftCols<3>() * turn.toRotationMatrix().transpose()).rowwise() +
        Eigen::RowVector3d(5, -3, 2);
  };
  for (BezierSpline& frame : moved) move(frame);
  const CommonKnots found = commonKnots(moved, {.tolerance_mm = scale * 1e-3});
  for (std::size_t f = 0; f < 2; ++f) {
    BezierSpline expected = given.frames[f];
    move(expected);
    ASSERT_EQ(found.frames[f].segments(), expected.segments());
    EXPECT_LT((found.frames[f].poles - expected.poles).cwiseAbs().maxCoeff(), 1e-5);
  }
}

TEST(CommonKnots, TheLimitOfSegmentsIsKept) {
  std::mt19937_64 random(testSeed());
  const CommonKnots common =
      commonKnots({outline(40, 30, 20, 0.1, random), outline(30, 20, 20, 0, random)},
                  {.tolerance_mm = 1e-7, .max_segments = 20});
  EXPECT_FALSE(common.reached);
  EXPECT_LE(common.frames[0].segments(), 40);
  EXPECT_GT(*std::max_element(common.distance_mm.begin(), common.distance_mm.end()), 1e-7);
}

TEST(CommonKnots, BadInputIsRefused) {
  std::mt19937_64 random(testSeed());
  const BezierSpline closed = outline(12, 3, 2, 0, random), open = helix(8, 2, 1, random);
  const auto refused = [](const char* part) {
    return ThrowsMessage<std::invalid_argument>(HasSubstr(part));
  };
  EXPECT_THAT([&] { commonKnots({closed}); }, refused("at least 2"));
  EXPECT_THAT([&] { commonKnots({closed, open}); }, refused("frame 1 is open, frame 0 is closed"));
  for (const double tolerance : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THAT(
        [&] {
          commonKnots({open, open}, {.tolerance_mm = tolerance});
        },
        refused("the tolerance is"));
  EXPECT_THAT(
      [&] {
        commonKnots({open, open}, {.tolerance_mm = 1e-13});
      },
      refused("frame 0: the tolerance is 1e-13 mm, and places on the curve are known to"));
  BezierSpline broken = open;
  broken.poles(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { commonKnots({open, broken}); }, refused("frame 1"));
}

}  // namespace
}  // namespace seamwright
