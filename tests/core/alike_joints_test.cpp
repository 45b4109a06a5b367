// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <seamwright/core/blend/common_knots.hpp>
#include <seamwright/core/blend/match_pieces.hpp>
#include <seamwright/core/blend/spline_places.hpp>

/// Outlines of lines and arcs in the same order correspond joint by joint, whatever their shares of
/// the length are. The oracle is the closed form: a linear blend of two rounded rectangles, line by
/// line and arc by arc, is the rounded rectangle of the mean sides and radius.
namespace seamwright {
namespace {

using std::numbers::pi;

struct Rounded {
  double width = 0, height = 0, radius = 0;
};

constexpr Rounded wide{60, 40, 5}, middle{55, 45, 7.5}, square{50, 50, 10}, tall{40, 60, 15};

/// Lines and quarter circles, from the beginning of the lower line on, counterclockwise. Piece 2 i
/// is a line.
BezierSpline outline(const Rounded& shape) {
  const double a = shape.width / 2 - shape.radius, b = shape.height / 2 - shape.radius;
  BezierSpline result{2, {}, HomogeneousPoles::Ones(17, 4), true};
  for (int side = 0; side < 4; ++side) {
    const Eigen::Rotation2Dd turn(side * pi / 2);
    const Eigen::Vector2d start = side % 2 == 0 ? Eigen::Vector2d(-a, -b) : Eigen::Vector2d(-b, -a),
                          end(-start.x(), start.y()), down(0, -shape.radius),
                          right(shape.radius, 0);
    const Eigen::Vector2d poles[] = {start + down, 0.5 * (start + end) + down, end + down,
                                     end + down + right};
    for (Eigen::Index k = 0; k < 4; ++k) {
      const double weight = k == 3 ? std::sqrt(0.5) : 1;
      const Eigen::Vector2d pole = turn * poles[k];
      result.poles.row(4 * side + k) << weight * pole.x(), weight * pole.y(), 0, weight;
    }
  }
  result.poles.row(16) = result.poles.row(0);
  for (int i = 0; i <= 8; ++i) result.knots.push_back(i);
  return result;
}

double distanceFrom(const Rounded& shape, const Eigen::Vector3d& point) {
  const Eigen::Array2d q =
      point.head<2>().array().abs() - Eigen::Array2d(shape.width, shape.height) / 2 + shape.radius;
  return std::abs(q.max(0).matrix().norm() + std::min(q.maxCoeff(), 0.0) - shape.radius);
}

double farthest(const Rounded& shape, const BezierSpline& spline) {
  double result = 0;
  for (int i = 0; i < spline.segments(); ++i)
    for (int k = 0; k < 8; ++k)
      result = std::max(result, distanceFrom(shape, segment(spline, i).point(k / 8.0)));
  return result;
}

BezierSpline mean(const BezierSpline& a, const BezierSpline& b) {
  BezierSpline result = a;
  result.poles = 0.5 * (a.poles + b.poles);
  return result;
}

/// The same from a place within a piece on.
BezierSpline from(const BezierSpline& spline, int piece, double t) {
  return match::startingAt(spline, {piece, t});
}

constexpr double tolerance_mm = 1e-4;

const MatchOptions found{.by = MatchBy::Features, .find_start = true, .find_direction = true};

TEST(AlikeJoints, HalfWayBetweenRoundedRectanglesIsOne) {
  const BezierSpline a = outline(wide), b = outline(tall);
  // Starts at a line, at an arc, within both; the second frame also the other way round.
  for (const BezierSpline& first : {a, from(a, 1, 0), from(a, 0, 0.3), from(a, 3, 0.6)})
    for (const BezierSpline& start : {b, from(b, 4, 0), from(b, 5, 0), from(b, 2, 0.7)})
      for (const BezierSpline& second : {start, match::runBackwards(start)}) {
        const CommonKnots common =
            commonKnots({first, second}, {.match = found, .tolerance_mm = tolerance_mm});
        ASSERT_TRUE(common.reached);
        EXPECT_EQ(common.summary.matched_features, 8);
        EXPECT_FALSE(common.summary.lengths_fit_better);
        EXPECT_LT(farthest(square, mean(common.frames[0], common.frames[1])), 2 * tolerance_mm);
      }
}

TEST(AlikeJoints, DividedFramesHaveTheJointsOfBoth) {
  const MatchedFrames matched = matchPieces({outline(wide), from(outline(tall), 4, 0)}, found);
  EXPECT_EQ(matched.summary.pieces_after, 8);
  EXPECT_LT(farthest(square, mean(matched.frames[0], matched.frames[1])), 1e-9);
}

TEST(AlikeJoints, ThreeFramesCorrespond) {
  const CommonKnots common = commonKnots({outline(wide), outline(square), outline(tall)},
                                         {.match = found, .tolerance_mm = tolerance_mm});
  EXPECT_EQ(common.summary.matched_features, 8);
  EXPECT_LT(farthest(middle, mean(common.frames[0], common.frames[1])), 2 * tolerance_mm);
  EXPECT_LT(farthest(square, mean(common.frames[0], common.frames[2])), 2 * tolerance_mm);
}

/// A rectangle of which one corner is rounded, turned and scaled.
BezierSpline blunted(double turn, double scale) {
  BezierSpline result{2, {0, 1, 2, 3, 4, 5}, HomogeneousPoles::Ones(11, 4), true};
  const double weight = std::sqrt(0.5);
  const double places[11][2] = {{-20, -10}, {0, -10}, {20, -10}, {20, -1}, {20, 8},   {20, 10},
                                {18, 10},   {-1, 10}, {-20, 10}, {-20, 0}, {-20, -10}};
  for (Eigen::Index i = 0; i < 11; ++i) {
    const double w = i == 5 ? weight : 1;
    const Eigen::Vector2d place =
        scale * (Eigen::Rotation2Dd(turn) * Eigen::Vector2d(places[i][0], places[i][1]));
    result.poles.row(i) << w * place.x(), w * place.y(), 0, w;
  }
  return result;
}

TEST(AlikeJoints, TheStartKeepsTheOrderUnlessFramesWouldShrink) {
  for (const double turn : {-1.2, 0.4, 1.4}) {
    const BezierSpline b = blunted(turn, 0.8);
    const MatchedFrames matched = matchPieces({blunted(0, 1), from(b, 4, 0)}, found);
    EXPECT_EQ(matched.summary.pieces_after, 5) << turn;
    EXPECT_LT((matched.frames[1].poles - b.poles).norm(), 1e-9) << turn;
  }
  // Turned by 180 degrees, the frame halfway would be a point.
  const MatchedFrames matched = matchPieces({blunted(0, 1), blunted(pi, 1)}, found);
  const BezierSpline half = mean(matched.frames[0], matched.frames[1]);
  EXPECT_GT(half.poles.col(0).maxCoeff(), 17);
  EXPECT_GT(half.poles.col(1).maxCoeff(), 8);
}

/// A line, an arc to the left and a line.
BezierSpline bow(double before, double radius, double after) {
  BezierSpline result{2, {0, 1, 2, 3}, HomogeneousPoles::Ones(7, 4), false};
  const double weight = std::sqrt(0.5);
  result.poles.leftCols<2>() << 0, 0, before / 2, 0, before, 0, weight * (before + radius), 0,
      before + radius, radius, before + radius, radius + after / 2, before + radius, radius + after;
  result.poles.col(2).setZero();
  result.poles(3, 3) = weight;
  return result;
}

TEST(AlikeJoints, OpenFramesCorrespondWhateverTheShares) {
  // The arc begins at 7 and at 78 % of the length.
  const BezierSpline a = bow(10, 8, 120), b = bow(120, 16, 10);
  const MatchedFrames matched = matchPieces({a, b}, {.by = MatchBy::Features});
  EXPECT_EQ(matched.summary.matched_features, 2);
  ASSERT_EQ(matched.summary.pieces_after, 3);
  EXPECT_LT((matched.frames[0].poles - a.poles).norm(), 1e-12);
  EXPECT_LT((matched.frames[1].poles - b.poles).norm(), 1e-12);
}

TEST(AlikeJoints, CornersCorrespondWhateverTheShares) {
  const auto angle = [](double before, double after) {
    BezierSpline result{1, {0, 1, 2}, HomogeneousPoles::Ones(3, 4), false};
    result.poles.leftCols<3>() << 0, 0, 0, before, 0, 0, before, after, 0;
    return result;
  };
  const MatchedFrames matched =
      matchPieces({angle(10, 80), angle(70, 20)}, {.by = MatchBy::Features});
  EXPECT_EQ(matched.summary.matched_features, 1);
  EXPECT_EQ(matched.summary.pieces_after, 2);
}

TEST(AlikeJoints, SharesBetweenGivenJointsAreLinear) {
  const std::vector<BezierSpline> frames = {outline(wide), outline(tall)};
  const std::vector<double> joints = {0, 1, 2, 3, 4, 5, 6, 7};
  const CommonKnots common = commonKnots(
      frames,
      {.match = {.by = MatchBy::Given, .given = {joints, joints}}, .tolerance_mm = tolerance_mm});
  ASSERT_TRUE(common.reached);
  EXPECT_EQ(common.summary.matched_features, 8);
  EXPECT_LT(farthest(square, mean(common.frames[0], common.frames[1])), 2 * tolerance_mm);
  // Each arc runs evenly in both frames: corresponding points have one normal.
  for (int i = 0; i < common.frames[0].segments(); ++i) {
    const Eigen::Vector3d p = segment(common.frames[0], i).point(0.4),
                          q = segment(common.frames[1], i).point(0.4);
    const auto angle = [](const Rounded& shape, const Eigen::Vector3d& point) {
      const Eigen::Array2d off = (point.head<2>().array().abs() -
                                  Eigen::Array2d(shape.width, shape.height) / 2 + shape.radius)
                                     .max(0);
      return std::atan2(off.y(), off.x());
    };
    EXPECT_NEAR(angle(wide, p), angle(tall, q), 1e-4) << i;
  }
}

TEST(AlikeJoints, SpeedsStaySmoothAtGivenPlacesWithinPieces) {
  // The middles of lines and arcs of both.
  const std::vector<double> places = {0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5};
  const CommonKnots common = commonKnots(
      {outline(wide), outline(tall)},
      {.match = {.by = MatchBy::Given, .given = {places, places}}, .tolerance_mm = tolerance_mm});
  for (const BezierSpline& frame : common.frames)
    for (int i = 1; i < frame.segments(); ++i) {
      const double before = frame.knots[i] - frame.knots[i - 1],
                   after = frame.knots[i + 1] - frame.knots[i];
      const double arriving = segment(frame, i - 1).derivatives(1, 1).row(1).norm() / before,
                   leaving = segment(frame, i).derivatives(0, 1).row(1).norm() / after;
      EXPECT_NEAR(arriving / leaving, 1, 1e-6) << i;
    }
}

}  // namespace
}  // namespace seamwright
