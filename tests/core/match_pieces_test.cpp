// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <seamwright/core/blend/match_pieces.hpp>

#include "frames.hpp"

namespace seamwright {
namespace {

using test::drawn;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;
using Vec = Eigen::Vector3d;

/// A random open spline that goes along x.
BezierSpline wave(int segments, int degree, std::mt19937_64& random) {
  BezierSpline result{degree, {drawn(-1, 1, random)}, {}};
  for (int i = 0; i < segments; ++i)
    result.knots.push_back(result.knots.back() + drawn(0.2, 2, random));
  const Eigen::Index rows = static_cast<Eigen::Index>(segments) * degree + 1;
  result.poles.setOnes(rows, 4);
  for (Eigen::Index i = 0; i < rows; ++i)
    result.poles.row(i).head<3>() << 10.0 * static_cast<double>(i) / static_cast<double>(rows - 1),
        drawn(-0.5, 0.5, random), drawn(-0.5, 0.5, random);
  return result;
}

/// A closed star around the origin.
BezierSpline star(int segments, int degree, std::mt19937_64& random) {
  BezierSpline result{degree, {}, {}, true};
  for (int i = 0; i <= segments; ++i) result.knots.push_back(i);
  const Eigen::Index rows = static_cast<Eigen::Index>(segments) * degree + 1;
  result.poles.setOnes(rows, 4);
  for (Eigen::Index i = 0; i + 1 < rows; ++i) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(rows - 1);
    const double radius = 5 + std::cos(angle) + 0.7 * std::sin(2 * angle) + drawn(0, 0.3, random);
    result.poles.row(i).head<3>() << radius * std::cos(angle), radius * std::sin(angle), 0;
  }
  result.poles.row(rows - 1) = result.poles.row(0);
  return result;
}

/// The largest distance of points at equal parameters.
double deviation(const BezierSpline& a, const BezierSpline& b, double shift = 0) {
  double result = 0;
  const double from = a.knots.front(), range = a.knots.back() - from;
  for (int i = 0; i < 400; ++i) {
    const double t = from + range * i / 400;
    double s = t + shift;
    if (s >= from + range) s -= range;
    const auto at = [](const BezierSpline& of, double x) -> Eigen::RowVector3d {
      return derivatives(of, x, 0).row(0);
    };
    result = std::max(result, (at(a, t) - at(b, s)).norm());
  }
  return result;
}

bool hasKnot(const BezierSpline& spline, double knot) {
  return std::find(spline.knots.begin(), spline.knots.end(), knot) != spline.knots.end();
}

/// Lengths by a polygon of many points, another way than that of the library.
std::vector<double> shares(const BezierSpline& spline) {
  std::vector<double> sums{0};
  for (int i = 0; i < spline.segments(); ++i) {
    double sum = sums.back();
    const BezierCurve curve = segment(spline, i);
    for (int k = 0; k < 2000; ++k)
      sum += (curve.point((k + 1) / 2000.0) - curve.point(k / 2000.0)).norm();
    sums.push_back(sum);
  }
  for (double& sum : sums) sum /= sums.back();
  return sums;
}

TEST(MatchPieces, Identity1And2CurvesAndJointsStay) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 24; ++run) {
    std::vector<BezierSpline> frames;
    for (int f = 0; f < 2 + run % 3; ++f)
      frames.push_back(wave(1 + (run + 3 * f) % 6, 2 + (run + f) % 4, random));
    MatchOptions options;
    options.by = run % 2 ? MatchBy::Features : MatchBy::Length;
    options.closeness = drawn(0, 0.05, random);
    const MatchedFrames matched = matchPieces(frames, options);
    for (std::size_t f = 0; f < frames.size(); ++f) {
      EXPECT_EQ(matched.frames[f].degree, matched.frames[0].degree) << run;
      EXPECT_EQ(matched.frames[f].segments(), matched.summary.pieces_after) << run;
      EXPECT_EQ(matched.summary.pieces_before[f], frames[f].segments());
      EXPECT_LE(deviation(frames[f], matched.frames[f]), 1e-12) << run;
      for (const double knot : frames[f].knots) EXPECT_TRUE(hasKnot(matched.frames[f], knot));
    }
    EXPECT_GE(matched.summary.largest_ratio, 1);
  }
}

TEST(MatchPieces, Identity3NoPieceIsShorterThanTheCloseness) {
  std::mt19937_64 random(testSeed());
  int merged = 0;
  for (int run = 0; run < 20; ++run) {
    // Joints of one frame are at least 1/8 of it apart, because chords are nearly equal.
    const std::vector<BezierSpline> frames{wave(2 + run % 3, 3, random), wave(3, 3, random),
                                           wave(4, 3, random)};
    const double closeness = 0.03;
    const MatchedFrames matched = matchPieces(frames, {.closeness = closeness});
    merged += matched.summary.merged;
    for (const BezierSpline& frame : matched.frames) {
      const std::vector<double> at = shares(frame);
      for (std::size_t i = 1; i < at.size(); ++i)
        EXPECT_GE(at[i] - at[i - 1], closeness * (1 - 1e-4)) << run;
    }
  }
  EXPECT_GT(merged, 5);
}

TEST(MatchPieces, ByLengthDividesAtEqualShares) {
  std::mt19937_64 random(testSeed());
  const BezierSpline one = wave(1, 3, random), many = wave(5, 4, random);
  const MatchedFrames matched = matchPieces({one, many});
  ASSERT_EQ(matched.summary.pieces_after, 5);
  EXPECT_EQ(matched.frames[1].poles, many.poles);
  const std::vector<double> a = shares(matched.frames[0]), b = shares(matched.frames[1]);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-6) << i;
  EXPECT_NEAR(matched.summary.largest_ratio, 1, 1e-6);
  EXPECT_EQ(matched.summary.merged, 0);
  EXPECT_THAT(matched.summary.pieces_before, ElementsAre(1, 5));
}

BezierSpline polyline(const std::vector<Vec>& corners) {
  BezierSpline result{1, {}, HomogeneousPoles::Ones(static_cast<Eigen::Index>(corners.size()), 4)};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    result.knots.push_back(static_cast<double>(i));
    result.poles.row(static_cast<Eigen::Index>(i)).head<3>() = corners[i].transpose();
  }
  return result;
}

TEST(MatchPieces, CornersAreMatchedInOrder) {
  // One corner at 0.4 and 0.5 of the length; the second has a joint without a corner besides.
  const BezierSpline a = polyline({{0, 0, 0}, {4, 0, 0}, {4, 6, 0}});
  const BezierSpline b = polyline({{0, 0, 1}, {1, 0, 1}, {5, 0, 1}, {5, 5, 1}});
  const MatchedFrames by_length = matchPieces({a, b}, {.closeness = 0.01});
  EXPECT_EQ(by_length.summary.pieces_after, 4);
  const MatchedFrames by_features = matchPieces({a, b}, {.by = MatchBy::Features});
  EXPECT_EQ(by_features.summary.pieces_after, 3);
  EXPECT_EQ(by_features.summary.matched_features, 1);
  // The joint at a fifth of the way to the corner.
  EXPECT_LE((by_features.frames[0].poles.row(1).head<3>() - Eigen::RowVector3d(0.8, 0, 0)).norm(),
            1e-7);
  EXPECT_NEAR(by_features.summary.largest_ratio, 1.25, 1e-6);
}

/// y = h (1 - (x / 5)^2) from x = -5 - shift to 5 - shift, as one parabola: its vertex is at x = 0.
BezierSpline parabola(double shift, double h) {
  const double a = -5 - shift, b = 5 - shift, k = -h / 25;
  BezierSpline result{2, {0, 1}, HomogeneousPoles::Ones(3, 4)};
  result.poles.leftCols<3>() << a, h + k * a * a, 0, (a + b) / 2, h + k * a * b, 0, b,
      h + k * b * b, 0;
  return result;
}

TEST(MatchPieces, ExtremaOfCurvatureAreMatched) {
  const MatchedFrames matched =
      matchPieces({parabola(-0.6, 4), parabola(0.7, 5)}, {.by = MatchBy::Features});
  EXPECT_EQ(matched.summary.matched_features, 1);
  ASSERT_EQ(matched.summary.pieces_after, 2);
  for (const BezierSpline& frame : matched.frames) EXPECT_NEAR(frame.poles(2, 0), 0, 1e-9);
  // Beyond the reach they are not.
  const MatchedFrames apart =
      matchPieces({parabola(-0.6, 4), parabola(0.7, 5)}, {.by = MatchBy::Features, .reach = 0.05});
  EXPECT_EQ(apart.summary.matched_features, 0);
  EXPECT_EQ(apart.summary.pieces_after, 1);
}

TEST(MatchPieces, GivenParametersBecomeJoints) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 10; ++run) {
    const BezierSpline a = wave(2, 3, random), b = wave(3, 4, random);
    const auto inside = [&](const BezierSpline& of, double share) {
      return of.knots.front() + share * (of.knots.back() - of.knots.front());
    };
    const double p = inside(a, drawn(0.3, 0.7, random)), q = inside(b, drawn(0.3, 0.7, random));
    const MatchedFrames matched = matchPieces({a, b}, {.by = MatchBy::Given, .given = {{p}, {q}}});
    const auto index = [](const BezierSpline& of, double knot) {
      double best = infinite;
      int result = -1;
      for (std::size_t i = 0; i < of.knots.size(); ++i)
        if (std::abs(of.knots[i] - knot) < best) {
          best = std::abs(of.knots[i] - knot);
          result = static_cast<int>(i);
        }
      EXPECT_LE(best, 1e-12);
      return result;
    };
    EXPECT_EQ(index(matched.frames[0], p), index(matched.frames[1], q)) << run;
    EXPECT_LE(deviation(b, matched.frames[1]), 1e-12);
  }
}

TEST(MatchPieces, ClosedCurvesStartWhereTheyFit) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 8; ++run) {
    const BezierSpline a = star(5, 3, random);
    // The same curve from another joint on, backwards in half of the runs.
    const int first = 1 + run % 4;
    std::vector<BezierCurve> pieces;
    for (int i = 0; i < 5; ++i) pieces.push_back(segment(a, (first + i) % 5));
    BezierSpline b = bezierSpline(pieces, a.knots, true);
    const bool backwards = run % 2 == 1;
    if (backwards) b.poles = b.poles.colwise().reverse().eval();
    b.poles.col(2).array() += 3;
    const MatchedFrames matched = matchPieces({a, b}, {.find_start = true, .find_direction = true});
    EXPECT_EQ(matched.summary.reversed[1], backwards) << run;
    EXPECT_EQ(matched.summary.pieces_after, 5) << run;
    HomogeneousPoles lifted = a.poles;
    lifted.col(2).array() += 3;
    EXPECT_EQ(matched.frames[1].poles, lifted) << run;
    EXPECT_TRUE(matched.frames[1].closed);
  }
}

TEST(MatchPieces, StartInsideOfAPiece) {
  std::mt19937_64 random(testSeed());
  const BezierSpline a = star(5, 3, random);
  BezierSpline turned = a;
  const double angle = 0.3;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vec::UnitZ()).toRotationMatrix();
  turned.poles.leftCols<3>() = (turn * a.poles.leftCols<3>().transpose()).transpose();
  // Given starts: the curve is the same, from another parameter on.
  const MatchedFrames matched =
      matchPieces({a, turned}, {.by = MatchBy::Given, .given = {{0.5, 2.25}, {1.75, 3}}});
  EXPECT_LE(deviation(matched.frames[0], a, 0.5), 1e-12);
  EXPECT_LE(deviation(matched.frames[1], turned, 1.75), 1e-12);
  EXPECT_TRUE(matched.frames[0].closed);
  const auto index = [](const BezierSpline& of, double knot) {
    for (std::size_t i = 0; i < of.knots.size(); ++i)
      if (std::abs(of.knots[i] - knot) <= 1e-12) return static_cast<int>(i);
    return -1;
  };
  EXPECT_GT(index(matched.frames[0], 1.75), 0);
  EXPECT_EQ(index(matched.frames[0], 1.75), index(matched.frames[1], 1.25));
}

TEST(MatchPieces, OpenCurvesInTheNearerDirection) {
  std::mt19937_64 random(testSeed());
  const BezierSpline a = wave(3, 3, random);
  BezierSpline b = wave(2, 3, random);
  b.poles = b.poles.colwise().reverse().eval();
  const MatchedFrames matched = matchPieces({a, b}, {.find_direction = true});
  EXPECT_THAT(matched.summary.reversed, ElementsAre(false, true));
  EXPECT_LT(matched.frames[1].poles(0, 0), 1);
  EXPECT_THAT(matchPieces({a, b}).summary.reversed, ElementsAre(false, false));
}

TEST(MatchPieces, Identity4MotionScaleAndReversal) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 10; ++run) {
    const std::vector<BezierSpline> frames{wave(2, 3, random), wave(4, 3, random)};
    const MatchOptions options{.by = run % 2 ? MatchBy::Features : MatchBy::Length};
    const MatchedFrames matched = matchPieces(frames, options);
    std::vector<BezierSpline> scaled = frames, moved = frames, reversed = frames;
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(run + 1, Vec(1, 2, 3).normalized()).toRotationMatrix();
    for (std::size_t f = 0; f < frames.size(); ++f) {
      scaled[f].poles.leftCols<3>() *= 8;
      moved[f].poles.leftCols<3>() = (turn * frames[f].poles.leftCols<3>().transpose()).transpose();
      reversed[f].poles = frames[f].poles.colwise().reverse();
      for (std::size_t i = 0; i < frames[f].knots.size(); ++i)
        reversed[f].knots[i] = -frames[f].knots[frames[f].knots.size() - 1 - i];
    }
    const MatchedFrames of_scaled = matchPieces(scaled, options),
                        of_moved = matchPieces(moved, options),
                        of_reversed = matchPieces(reversed, options);
    for (std::size_t f = 0; f < frames.size(); ++f) {
      const BezierSpline& expected = matched.frames[f];
      ASSERT_EQ(of_moved.frames[f].segments(), expected.segments()) << run;
      ASSERT_EQ(of_reversed.frames[f].segments(), expected.segments()) << run;
      EXPECT_EQ(of_scaled.frames[f].knots, expected.knots) << run;
      for (int i = 0; i <= expected.segments(); ++i) {
        EXPECT_NEAR(of_moved.frames[f].knots[i], expected.knots[i], 1e-6) << run;
        EXPECT_NEAR(-of_reversed.frames[f].knots[expected.segments() - i], expected.knots[i], 1e-6)
            << run;
      }
    }
  }
}

TEST(MatchPieces, OneFrameNeverLosesAJoint) {
  // Joints at 0.495 and 0.505 of one frame, 0.5 of the other: one of them is shared.
  const BezierSpline a = polyline({{0, 0, 0}, {4.95, 0, 0}, {5.05, 0, 0}, {10, 0, 0}});
  const BezierSpline b = polyline({{0, 0, 1}, {5, 0, 1}, {10, 0, 1}});
  const MatchedFrames matched = matchPieces({a, b}, {.closeness = 0.02});
  EXPECT_EQ(matched.summary.pieces_after, 3);
  EXPECT_EQ(matched.summary.merged, 1);
  EXPECT_EQ(matched.frames[0].poles, a.poles);
  EXPECT_TRUE(hasKnot(matched.frames[1], 1));
}

TEST(MatchPieces, RefusesInvalidInput) {
  std::mt19937_64 random(testSeed());
  const BezierSpline a = wave(2, 3, random), b = wave(3, 3, random), c = star(4, 3, random);
  const auto refused = [](const std::vector<BezierSpline>& frames, const MatchOptions& options,
                          const std::string& first, const std::string& second) {
    EXPECT_THAT([&] { matchPieces(frames, options); },
                ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(first), HasSubstr(second))));
  };
  refused({a}, {}, "frames 1", "2");
  refused({a, c}, {}, "frame 1 is closed", "frame 0 is open");
  BezierSpline bad = b;
  bad.poles(4, 2) = std::nan("");
  refused({a, bad}, {}, "frame 1", "4");
  BezierSpline point = b;
  for (int i = 3; i <= 6; ++i) point.poles.row(i) = b.poles.row(3);
  refused({a, point}, {}, "frame 1", "piece 1");
  refused({a, b}, {.closeness = -1}, "closeness", "-1");
  refused({a, b}, {.closeness = std::nan("")}, "closeness", "nan");
  refused({a, b}, {.reach = 0.6}, "reach", "0.6");
  refused({a, b}, {.corner_rad = 0}, "corner_rad", "0");
  refused({a, b}, {.given = {{0}}}, "given", "only");
  refused({a, b}, {.by = MatchBy::Given, .given = {{0}}}, "frames 2", "1");
  const double middle = a.knots[1], other = b.knots[1];
  refused({a, b}, {.by = MatchBy::Given, .given = {{middle}, {}}}, "frame 1 has 0", "frame 0 1");
  refused({a, b}, {.by = MatchBy::Given, .given = {{middle}, {100}}}, "frame 1", "100");
  refused({a, b}, {.by = MatchBy::Given, .given = {{middle, middle}, {other, other}}}, "frame 0",
          "increase");
  refused({a, b}, {.by = MatchBy::Given, .given = {{middle}, {other}}, .find_direction = true},
          "direction", "given");
}

}  // namespace
}  // namespace seamwright
