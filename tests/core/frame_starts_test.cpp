// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <seamwright/core/blend/common_knots.hpp>
#include <seamwright/core/blend/match_pieces.hpp>
#include <seamwright/core/spline/nu_spline.hpp>

#include "frames.hpp"

/// Where closed frames start, and which of their features correspond. The oracles are the rigid
/// motions and formulas that make the frames, and sums over all shifts of their corners.
namespace seamwright {
namespace {

using std::numbers::pi;
using test::drawn;
using Corners = std::vector<Eigen::Vector3d>;

Corners rectangle(double width, double height, double z) {
  return {{-width, -height, z}, {width, -height, z}, {width, height, z}, {-width, height, z}};
}

Corners rotated(Corners corners, double angle) {
  for (Eigen::Vector3d& corner : corners)
    corner = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * corner;
  return corners;
}

BezierSpline polygonFrame(const Corners& corners) {
  const auto count = static_cast<Eigen::Index>(corners.size());
  BezierSpline result{1, {}, HomogeneousPoles::Ones(count + 1, 4), true};
  for (Eigen::Index i = 0; i <= count; ++i) {
    result.knots.push_back(static_cast<double>(i));
    result.poles.row(i).head<3>() = corners[static_cast<std::size_t>(i % count)].transpose();
  }
  return result;
}

BezierSpline splineFrame(const Poles& points) {
  NuSplineData data;
  data.points = points;
  data.points.conservativeResize(points.rows() + 1, 3);
  data.points.bottomRows<1>() = points.topRows<1>();
  data.ends = SplineEnds::Periodic;
  data.knots = knotsOf(data.points);
  data.nu.assign(data.knots.size(), 0);
  return nuSpline(data).curve;
}

Eigen::Vector3d beginOf(const BezierSpline& spline) {
  return spline.poles.row(0).head<3>().transpose();
}

/// The corner of the second polygon to start at, by the sums over all shifts.
std::size_t bestShift(const Corners& first, const Corners& second) {
  std::size_t best = 0;
  double least = infinite;
  for (std::size_t shift = 0; shift < second.size(); ++shift) {
    double sum = 0;
    for (std::size_t i = 0; i < first.size(); ++i)
      sum += (first[i] - second[(i + shift) % second.size()]).squaredNorm();
    if (sum < least) {
      least = sum;
      best = shift;
    }
  }
  return best;
}

TEST(FrameStarts, RectanglesStartAtCornersThatCorrespond) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 24; ++run) {
    const Corners first = rectangle(20, 10, 0);
    Corners second =
        rotated(rectangle(drawn(12, 24, random), drawn(5, 10, random), 30), drawn(-1, 1, random));
    const Eigen::Vector3d shift(drawn(-30, 30, random), drawn(-30, 30, random), 0);
    for (Eigen::Vector3d& corner : second) corner += shift;
    const Eigen::Vector3d expected = second[bestShift(first, second)];
    std::rotate(second.begin(), second.begin() + run % 4, second.end());
    if (run % 3 == 0) std::reverse(second.begin(), second.end());
    const std::vector<BezierSpline> frames{polygonFrame(first), polygonFrame(second)};
    for (const MatchBy by : {MatchBy::Features, MatchBy::Length}) {
      const MatchedFrames matched =
          matchPieces(frames, {.by = by, .find_start = true, .find_direction = true});
      EXPECT_EQ(matched.summary.reversed[1], run % 3 == 0) << run;
      EXPECT_LT((beginOf(matched.frames[1]) - expected).norm(), 1e-12) << run;
      EXPECT_EQ(beginOf(matched.frames[0]), first[0]);
      if (by == MatchBy::Length) continue;
      EXPECT_EQ(matched.summary.pieces_after, 4) << run;
      EXPECT_EQ(matched.summary.matched_features, 4) << run;
    }
  }
}

TEST(FrameStarts, SymmetricInputHasOneAnswer) {
  // A square turned by 45 degrees: two corners are equally near.
  const Corners square = rectangle(10, 10, 0), turned = rotated(rectangle(10, 10, 20), pi / 4);
  const MatchOptions options{.by = MatchBy::Features, .find_start = true, .find_direction = true};
  const MatchedFrames matched = matchPieces({polygonFrame(square), polygonFrame(turned)}, options);
  EXPECT_FALSE(matched.summary.reversed[1]);
  EXPECT_EQ(matched.summary.pieces_after, 4);
  double nearest = infinite;
  for (const Eigen::Vector3d& corner : turned)
    nearest = std::min(nearest, (corner - beginOf(matched.frames[1])).norm());
  EXPECT_LT(nearest, 1e-12);
  // Rounding does not choose another one.
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 20; ++run) {
    Corners moved = turned;
    for (Eigen::Vector3d& corner : moved)
      corner += 1e-13 * Eigen::Vector3d(drawn(-1, 1, random), drawn(-1, 1, random), 0);
    const MatchedFrames again = matchPieces({polygonFrame(square), polygonFrame(moved)}, options);
    EXPECT_LT((beginOf(again.frames[1]) - beginOf(matched.frames[1])).norm(), 1e-9) << run;
  }
}

TEST(FrameStarts, CirclesFromDifferentStartsDoNotTwist) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 10; ++run) {
    const auto circle = [](int count, double radius, double phase, double z, bool backwards) {
      Poles points(count, 3);
      for (int i = 0; i < count; ++i) {
        const double angle = phase + (backwards ? -2 : 2) * pi * i / count;
        points.row(i) << radius * std::cos(angle), radius * std::sin(angle), z;
      }
      return splineFrame(points);
    };
    const CommonKnots common = commonKnots(
        {circle(24, 10, 0, 0, false), circle(31, 6, drawn(0, 2 * pi, random), 20, run % 2 == 1)},
        {.match = {.by = MatchBy::Features, .find_start = true, .find_direction = true},
         .tolerance_mm = 1e-3});
    ASSERT_TRUE(common.reached);
    const HomogeneousPoles &a = common.frames[0].poles, &b = common.frames[1].poles;
    for (Eigen::Index i = 0; i < a.rows(); i += 5) {
      const double turn =
          std::atan2(a(i, 0) * b(i, 1) - a(i, 1) * b(i, 0), a(i, 0) * b(i, 0) + a(i, 1) * b(i, 1));
      EXPECT_LT(std::abs(turn), 2e-3) << run << ", " << i;
    }
  }
}

/// The point of a slot at a share of its length, from the middle of its right end on.
Eigen::RowVector3d slotPoint(double share, double side, double radius) {
  const double arc = pi * radius, length = 2 * (side + arc);
  double s = (share - std::floor(share)) * length;
  const auto bow = [&](double angle, double x) -> Eigen::RowVector3d {
    return {x + radius * std::cos(angle), radius * std::sin(angle), 0};
  };
  if (s < arc / 2) return bow(s / radius, side / 2);
  s -= arc / 2;
  if (s < side) return {side / 2 - s, radius, 0};
  s -= side;
  if (s < arc) return bow(pi / 2 + s / radius, -side / 2);
  s -= arc;
  if (s < side) return {-side / 2 + s, -radius, 0};
  return bow(-pi / 2 + (s - side) / radius, side / 2);
}

double distanceFromSlot(const Eigen::RowVector3d& point, double side, double radius) {
  const double x = std::max(std::abs(point.x()) - side / 2, 0.0);
  return std::abs(std::hypot(x, point.y()) - radius);
}

TEST(FrameStarts, FramesBetweenTwoPointSetsOfOneSlotAreThatSlot) {
  const auto slot = [](int count, double phase) {
    Poles points(count, 3);
    for (int i = 0; i < count; ++i)
      points.row(i) = slotPoint(phase + static_cast<double>(i) / count, 30, 10);
    return splineFrame(points);
  };
  const auto farthest = [](const BezierSpline& spline) {
    double result = 0;
    for (int i = 0; i < spline.segments(); ++i)
      for (int k = 0; k < 8; ++k)
        result = std::max(result,
                          distanceFromSlot(segment(spline, i).point(k / 8.0).transpose(), 30, 10));
    return result;
  };
  for (const int count : {57, 64, 83})
    for (const double phase : {0.0, 0.11, 0.4}) {
      const BezierSpline a = slot(72, 0), b = slot(count, phase);
      const CommonKnots common = commonKnots(
          {a, b}, {.match = {.by = MatchBy::Features, .find_start = true, .find_direction = true}});
      ASSERT_TRUE(common.reached);
      BezierSpline middle = common.frames[0];
      middle.poles = 0.5 * (common.frames[0].poles + common.frames[1].poles);
      // Splines through points wave where the curvature jumps.
      EXPECT_LT(farthest(middle), std::max(farthest(a), farthest(b)) + 2e-3)
          << count << ", " << phase;
    }
}

/// A slot of lines and rational arcs, from the beginning of the lower line on.
BezierSpline exactSlot(double side, double radius, double z) {
  BezierSpline result{2, {0, 1, 2, 3, 4, 5, 6}, HomogeneousPoles::Ones(13, 4), true};
  const double a = side / 2, r = radius;
  const double places[13][2] = {{-a, -r},    {0, -r},      {a, -r}, {a + r, -r}, {a + r, 0},
                                {a + r, r},  {a, r},       {0, r},  {-a, r},     {-a - r, r},
                                {-a - r, 0}, {-a - r, -r}, {-a, -r}};
  for (Eigen::Index i = 0; i < 13; ++i) {
    // The corner poles of quarter circles.
    const double weight = i % 2 == 1 && i != 1 && i != 7 ? std::sqrt(0.5) : 1;
    result.poles.row(i) << weight * places[i][0], weight * places[i][1], weight * z, weight;
  }
  return result;
}

TEST(FrameStarts, LinesOfSlotsCorrespondToLines) {
  for (const double turn : {0.0, 0.2, -0.3}) {
    const BezierSpline a = exactSlot(30, 10, 0);
    BezierSpline b = exactSlot(40, 8, 30);
    b.poles.leftCols<3>() =
        b.poles.leftCols<3>() *
        Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix().transpose();
    const MatchedFrames matched =
        matchPieces({a, b}, {.by = MatchBy::Features, .find_start = true, .find_direction = true});
    EXPECT_FALSE(matched.summary.lengths_fit_better);
    EXPECT_GE(matched.summary.matched_features, 3);
    // The joints are those of both: no arc corresponds to a part of a line.
    ASSERT_EQ(matched.summary.pieces_after, 6) << turn;
    EXPECT_LT((matched.frames[0].poles - a.poles).norm(), 1e-9);
    EXPECT_LT((matched.frames[1].poles - b.poles).norm(), 1e-9);
  }
}

TEST(FrameStarts, BothCornersOfABluntEndCorrespond) {
  // The ends are 0.2 and 1 % of the length.
  const Corners thin{{100, 0.2, 0}, {0, 5, 0}, {0, -5, 0}, {100, -0.2, 0}},
      thick{{90, 1, 20}, {0, 12, 20}, {0, -12, 20}, {90, -1, 20}};
  const MatchedFrames matched =
      matchPieces({polygonFrame(thin), polygonFrame(thick)},
                  {.by = MatchBy::Features, .find_start = true, .find_direction = true});
  EXPECT_EQ(matched.summary.pieces_after, 4);
  EXPECT_EQ(matched.frames[0].poles, polygonFrame(thin).poles);
  EXPECT_EQ(matched.frames[1].poles, polygonFrame(thick).poles);
}

TEST(FrameStarts, LengthsCorrespondWhereFeaturesMislead) {
  // Right angles in the middle, and a faint corner before it in one and behind it in the other: in
  // order the first corner of one corresponds to the first one of the other.
  const auto open = [](const Corners& corners) {
    BezierSpline result = polygonFrame(corners);
    result.closed = false;
    result.knots.pop_back();
    result.poles = result.poles.topRows(static_cast<Eigen::Index>(corners.size())).eval();
    return result;
  };
  const BezierSpline a = open({{0, 0, 0}, {3.3, 0.5, 0}, {5, 0, 0}, {5, 5, 0}}),
                     b = open({{0, 0, 5}, {5, 0, 5}, {5.5, 1.7, 5}, {5, 5, 5}});
  const MatchedFrames matched = matchPieces({a, b}, {.by = MatchBy::Features, .closeness = 0.02});
  EXPECT_TRUE(matched.summary.lengths_fit_better);
  EXPECT_EQ(matched.summary.matched_features, 0);
  // The right angles are at almost the same place, and one joint.
  EXPECT_EQ(matched.summary.pieces_after, 4);
  EXPECT_LT((matched.frames[0].poles.row(2).head<3>() - Eigen::RowVector3d(5, 0, 0)).norm(), 1e-12);
  EXPECT_LT((matched.frames[1].poles.row(2).head<3>() - Eigen::RowVector3d(5, 0, 5)).norm(), 1e-12);
}

}  // namespace
}  // namespace seamwright
