// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <numbers>

#include <seamwright/core/blend/frame_loft.hpp>

#include "frames.hpp"
#include "surfaces.hpp"

namespace seamwright {
namespace {

using test::ChainFrames;
using test::chainFrames;
using test::distanceAt;
using test::drawn;
using test::expectCertified;
using test::narrowTolerance;
using test::Vec;
using testing::AllOf;
using testing::HasSubstr;
using testing::Message;
using testing::ThrowsMessage;

TEST(FrameLoft, Identity1StationsAndEndsAreFrames) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 20; ++run) {
    const int order = run % 5;
    const ChainFrames frames = chainFrames(order, 1 + run % 4, 1 + run % 2, false, random);
    const double station = drawn(0.1, 0.9, random);
    const FrameLoft loft =
        frameLoft(frames, {0, 1}, {.order = order, .tolerance_mm = 1e-2, .stations = {station}});
    EXPECT_TRUE(loft.reached) << run;
    EXPECT_TRUE(loft.ratios_positive) << run;
    for (const double omega : {0.0, station, 1.0})
      EXPECT_LE(distanceAt(loft.surface, frames(omega), omega), 1e-9) << run << " " << omega;
    for (int i = 0; i <= 50; ++i)
      EXPECT_LE(distanceAt(loft.surface, frames(i / 50.0), i / 50.0), 2e-2) << run << " " << i;
  }
}

TEST(FrameLoft, Identity2JointLinesAreCertified) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 12; ++run) {
    const int order = 1 + run % 3;
    const ChainFrames frames = chainFrames(order, 2 + run % 3, 2, false, random);
    const FrameLoft loft = frameLoft(frames, {0, 1}, {.order = order, .tolerance_mm = 1e-2});
    EXPECT_EQ(loft.surface.degree_v, 3 * (order + 1));
    const auto lines = encloseKnotLines(loft.surface, SurfaceDirection::U, narrowTolerance(), false,
                                        {.figures = false});
    ASSERT_EQ(static_cast<int>(lines.size()), frames.segments - 1);
    for (const KnotLine& line : lines)
      expectCertified(line.figures, order, Message() << run << " at " << line.knot << ": ");
  }
}

TEST(FrameLoft, EachJointHasItsOrder) {
  std::mt19937_64 random(testSeed());
  const ChainFrames smooth = chainFrames(2, 3, 2, false, random);
  // The first segment, turned about the joint: a corner of half a radian for every omega.
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.5, Vec(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  const auto cornered = [&](double omega) {
    BezierSpline frame = smooth(omega);
    const Eigen::RowVector3d joint = frame.poles.row(frame.degree).head<3>();
    for (int i = 0; i < frame.degree; ++i) {
      const Eigen::RowVector3d leg = frame.poles.row(i).head<3>() - joint;
      frame.poles.row(i).head<3>() = joint + leg * turn.transpose();
    }
    return frame;
  };
  FrameLoftOptions options{.order = 2, .tolerance_mm = 1e-2};
  options.joint_orders = {0, 2};
  const FrameLoft loft = frameLoft(cornered, {0, 1}, options);
  EXPECT_TRUE(loft.reached);
  for (int i = 0; i <= 20; ++i)
    EXPECT_LE(distanceAt(loft.surface, cornered(i / 20.0), i / 20.0), 2e-2) << i;
  ContinuityTolerance tolerance = narrowTolerance();
  tolerance.crease_rad = 1;
  const auto lines = encloseKnotLines(loft.surface, SurfaceDirection::U, tolerance);
  ASSERT_EQ(lines.size(), 2);
  ASSERT_TRUE(lines[0].figures.angle_rad.has_value());
  EXPECT_GT(lines[0].figures.angle_rad->lower, 1e-3);
  expectCertified(lines[1].figures, 2, Message() << "joint 2: ");
  // G2 at both joints does not meet the corner.
  options.joint_orders.clear();
  options.max_spans = 8;
  EXPECT_FALSE(frameLoft(cornered, {0, 1}, options).reached);
}

TEST(FrameLoft, Identity6PartsBetweenLinesAreTheSurface) {
  std::mt19937_64 random(testSeed());
  const ChainFrames frames = chainFrames(0, 4, 2, false, random);
  const FrameLoft loft = frameLoft(frames, {0, 1}, {.order = 0, .tolerance_mm = 1e-2});
  const std::vector<KnotLine> lines = encloseKnotLines(loft.surface, SurfaceDirection::U, {});
  ASSERT_EQ(lines.size(), 3);
  const std::vector<BSplineSurface> parts =
      partsBetween(loft.surface, SurfaceDirection::U, {lines[0].knot, lines[2].knot});
  ASSERT_EQ(parts.size(), 3);
  for (const BSplineSurface& part : parts) {
    requireValid(part);
    for (int k = 0; k < 40; ++k) {
      const double u = drawn(part.knots_u.front(), part.knots_u.back(), random);
      const double v = drawn(part.knots_v.front(), part.knots_v.back(), random);
      EXPECT_LE((jet(part, u, v).p - jet(loft.surface, u, v).p).norm(), 1e-12);
    }
  }
  for (std::size_t i = 1; i < parts.size(); ++i)
    EXPECT_EQ(parts[i - 1].poles.bottomRows(loft.surface.countV()),
              parts[i].poles.topRows(loft.surface.countV()));
  const double between = 0.5 * (lines[0].knot + lines[1].knot);
  EXPECT_THROW(partsBetween(loft.surface, SurfaceDirection::U, {between}), std::invalid_argument);
  EXPECT_THROW(partsBetween(loft.surface, SurfaceDirection::U, {lines[1].knot, lines[0].knot}),
               std::invalid_argument);
}

TEST(FrameLoft, OrdersOfJointsAreChecked) {
  std::mt19937_64 random(testSeed());
  const ChainFrames frames = chainFrames(2, 3, 1, false, random);
  const auto refused = [&](const std::vector<int>& orders, const char* part) {
    FrameLoftOptions options{.order = 2};
    options.joint_orders = orders;
    EXPECT_THAT(
        [&] {
          frameLoft(frames, {0, 1}, options);
        },
        ThrowsMessage<std::invalid_argument>(HasSubstr(part)));
  };
  refused({0, 3}, "order of joint 2 is 3: 0 to 2");
  refused({-1, 0}, "order of joint 1 is -1");
  refused({2}, "orders of 1 joints are given: the frames have 2");
}

/// Poles interpolated as a plain loft does it lose the G1 of the frames.
TEST(FrameLoft, PlainSkinningHasAnAngleWhereTheLoftHasNone) {
  std::mt19937_64 random(testSeed());
  const ChainFrames frames = chainFrames(2, 3, 4, false, random);
  const FrameLoft loft = frameLoft(frames, {0, 1}, {.order = 2, .tolerance_mm = 1e-2});
  const FrameLoft plain =
      frameLoft(frames, {0, 1}, {.order = 0, .tolerance_mm = 100, .first_spans = loft.spans});
  for (int i = 1; i < 3; ++i) {
    const auto line = [&](const FrameLoft& of) {
      return encloseKnotLines(of.surface, SurfaceDirection::U, narrowTolerance())[i - 1].figures;
    };
    EXPECT_LE(*line(loft).angle_rad->upper, 1e-9);
    EXPECT_GE(line(plain).angle_rad->lower, 1e-6);
    EXPECT_GE(line(plain).curvature_rel->lower, 1e-4);
  }
}

TEST(FrameLoft, Identity3CubicFramesAreMetEverywhere) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 12; ++run) {
    const int order = run % 3;
    ChainFrames frames = chainFrames(order, 3, 3, true, random);
    const bool smooth = run >= 6;
    if (smooth)
      for (Eigen::MatrixXd& beta : frames.betas)
        beta = order == 0 ? beta : Eigen::MatrixXd::Identity(1, order).replicate(3, 1);
    const FrameLoft loft = frameLoft(frames, {0, 2}, {.order = order, .first_spans = 3});
    EXPECT_EQ(loft.smooth_frames, smooth || order == 0) << run;
    EXPECT_EQ(loft.surface.degree_v, 3) << run;
    EXPECT_EQ(loft.spans, 3) << run;
    for (int i = 0; i <= 40; ++i)
      EXPECT_LE(distanceAt(loft.surface, frames(i / 20.0), i / 20.0), 1e-9) << run << " " << i;
    if (loft.smooth_frames) {
      EXPECT_EQ(loft.surface.countU(), frames.degree + 1 + 2 * (frames.degree - order)) << run;
    }
  }
}

BezierSpline mappedFrame(BezierSpline frame, const Eigen::Matrix3d& map, const Vec& shift) {
  for (Eigen::Index i = 0; i < frame.poles.rows(); ++i)
    frame.poles.row(i).head<3>() =
        (map * frame.poles.row(i).head<3>().transpose() + shift).transpose();
  return frame;
}

BezierSpline backwards(const BezierSpline& frame) {
  BezierSpline result = frame;
  result.poles = frame.poles.colwise().reverse();
  for (std::size_t i = 0; i < frame.knots.size(); ++i)
    result.knots[i] =
        frame.knots.front() + (frame.knots.back() - frame.knots[frame.knots.size() - 1 - i]);
  return result;
}

TEST(FrameLoft, Identity4MotionScaleAndReversal) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 6; ++run) {
    const int order = 1 + run % 3;
    const ChainFrames frames = chainFrames(order, 3, 1, false, random);
    const FrameLoftOptions options{.order = order, .tolerance_mm = 1e-3};
    const BSplineSurface surface = frameLoft(frames, {0, 1}, options).surface;
    const double scale = 4;
    const Eigen::Matrix3d turn =
        scale * Eigen::AngleAxisd(1 + run, Vec(1, 2, run - 3).normalized()).toRotationMatrix();
    const Vec shift(10, -20, 5);
    FrameLoftOptions scaled = options;
    scaled.tolerance_mm *= scale;
    const BSplineSurface moved =
        frameLoft([&](double w) { return mappedFrame(frames(w), turn, shift); }, {0, 1}, scaled)
            .surface;
    const BSplineSurface reversed_u =
        frameLoft([&](double w) { return backwards(frames(w)); }, {0, 1}, options).surface;
    const BSplineSurface reversed_v =
        frameLoft([&](double w) { return frames(1 - w); }, {0, 1}, options).surface;
    for (int i = 0; i < 60; ++i) {
      const double u = drawn(0, 3, random), v = drawn(0, 1, random);
      const Vec point = jet(surface, u, v).p;
      EXPECT_LE((jet(moved, u, v).p - (turn * point + shift)).norm(), 1e-8) << run;
      EXPECT_LE((jet(reversed_u, 3 - u, v).p - point).norm(), 1e-8) << run;
      EXPECT_LE((jet(reversed_v, u, 1 - v).p - point).norm(), 1e-8) << run;
    }
  }
}

TEST(FrameLoft, Identity5KnotLinesOfRandomSurfaces) {
  std::mt19937_64 random(testSeed());
  BSplineSurface surface{4, 3, {}, {0, 0, 0, 0, 1, 1, 1, 1}, {}};
  surface.knots_u = {0, 0, 0, 0, 0, 1, 1, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 4};
  surface.poles.resize(static_cast<Eigen::Index>(surface.countU()) * 4, 4);
  for (int i = 0; i < surface.countU(); ++i)
    for (int j = 0; j < 4; ++j)
      surface.poles.row(4 * i + j) << i + drawn(-0.1, 0.1, random), j + drawn(-0.1, 0.1, random),
          drawn(-0.4, 0.4, random), 1;
  const auto lines = encloseKnotLines(surface, SurfaceDirection::U, narrowTolerance());
  ASSERT_EQ(lines.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(lines[i].knot, i + 1);
    expectCertified(lines[i].figures, 2 - i, Message() << "line " << i);
  }
  EXPECT_GT(lines[1].figures.curvature_rel->lower, 1e-2);
  EXPECT_GT(lines[2].figures.angle_rad->lower, 1e-2);
}

/// Two cubics that meet with G1; alpha is the ratio of their speeds.
struct KeyFrame {
  Poles poles;
  double alpha;
};

KeyFrame keyFrame(double height, std::mt19937_64& random) {
  KeyFrame key{Poles(7, 3), drawn(0.5, 2, random)};
  for (int i = 0; i < 7; ++i)
    key.poles.row(i) << 2 * i + drawn(-0.5, 0.5, random), drawn(-1, 1, random),
        height + drawn(-1, 1, random);
  key.poles.row(4) = key.poles.row(3) + key.alpha * (key.poles.row(3) - key.poles.row(2));
  return key;
}

/// The blend of two key frames that keeps G1, written down.
BezierSpline blended(const KeyFrame& a, const KeyFrame& b, double omega) {
  Poles p = (1 - omega) * a.poles + omega * b.poles;
  const double lambda =
      (b.poles.row(3) - b.poles.row(2)).norm() / (a.poles.row(3) - a.poles.row(2)).norm();
  const double alpha =
      ((1 - omega) * a.alpha + lambda * omega * b.alpha) / ((1 - omega) + lambda * omega);
  p.row(3) = (3 * alpha * p.row(2) + 3 * p.row(4)) / (3 + 3 * alpha);
  BezierSpline result{3, {0, 1, 2}, HomogeneousPoles::Ones(7, 4)};
  result.poles.leftCols<3>() = p;
  return result;
}

TEST(FrameLoft, BlendsOfKeyFramesKeepTheirTangentPlane) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 8; ++run) {
    const KeyFrame a = keyFrame(0, random), b = keyFrame(10, random);
    const auto frames = [&](double omega) { return blended(a, b, omega); };
    const FrameLoft loft = frameLoft(frames, {0, 1}, {.order = 1, .tolerance_mm = 1e-4});
    EXPECT_TRUE(loft.reached) << run;
    for (int i = 0; i <= 100; ++i)
      EXPECT_LE(distanceAt(loft.surface, frames(i / 100.0), i / 100.0), 1.1e-4) << run;
    const auto lines = encloseKnotLines(loft.surface, SurfaceDirection::U, narrowTolerance());
    expectCertified(lines.front().figures, 1, Message() << run);
  }
}

/// A circle of four cubic arcs, exact to 2.8e-4 of its radius.
BezierSpline circle(double radius, double z) {
  const double k = 4.0 / 3 * (std::sqrt(2) - 1);
  BezierSpline result{3, {0, 1, 2, 3, 4}, HomogeneousPoles::Ones(13, 4), true};
  const Eigen::Matrix<double, 4, 2> arc{{1, 0}, {1, k}, {k, 1}, {0, 1}};
  for (int q = 0; q < 4; ++q)
    for (int i = 0; i < 4; ++i) {
      const double x = radius * arc(i, 0), y = radius * arc(i, 1);
      const Eigen::Vector2d turned = q == 0   ? Eigen::Vector2d(x, y)
                                     : q == 1 ? Eigen::Vector2d(-y, x)
                                     : q == 2 ? Eigen::Vector2d(-x, -y)
                                              : Eigen::Vector2d(y, -x);
      result.poles.row(3 * q + i).head<3>() << turned(0), turned(1), z;
    }
  result.poles.row(12) = result.poles.row(0);
  return result;
}

TEST(FrameLoft, CirclesMakeASurfaceOfRevolution) {
  const auto radius = [](double z) { return 5 + std::sin(z); };
  const FrameLoft loft = frameLoft([&](double z) { return circle(radius(z), z); }, {0, 3},
                                   {.order = 1, .tolerance_mm = 1e-5});
  EXPECT_TRUE(loft.reached);
  EXPECT_TRUE(loft.smooth_frames);
  for (int i = 0; i <= 30; ++i)
    for (int j = 0; j < 30; ++j) {
      const Vec p = jet(loft.surface, 4.0 * j / 30, i / 10.0).p;
      EXPECT_NEAR(p.head<2>().norm(), radius(i / 10.0), 2.8e-4 * radius(i / 10.0));
      EXPECT_NEAR(p.z(), i / 10.0, 1e-12);
    }
  const auto lines = encloseKnotLines(loft.surface, SurfaceDirection::U, narrowTolerance(), true,
                                      {.figures = false});
  ASSERT_EQ(lines.size(), 4u);
  for (const KnotLine& line : lines) expectCertified(line.figures, 1, Message() << line.knot);
}

TEST(FrameLoft, ClosedInBothDirections) {
  // A tube of circles whose speeds differ from quarter to quarter, so that joints are G1 only.
  const auto frames = [](double omega) {
    BezierSpline frame = circle(2 + 0.3 * std::cos(omega), 0);
    const double k = 0.1 * std::sin(omega);
    const Eigen::RowVectorXd tangent = frame.poles.row(4) - frame.poles.row(3);
    frame.poles.row(4) += k * tangent;
    const Eigen::RowVectorXd seam = frame.poles.row(1) - frame.poles.row(0);
    frame.poles.row(1) += k * seam;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(omega, Vec::UnitY()).toRotationMatrix();
    return mappedFrame(frame, turn, turn * Vec(8, 0, 0));
  };
  const double round = 2 * std::numbers::pi;
  const FrameLoft loft = frameLoft(
      frames, {0, round}, {.order = 1, .tolerance_mm = 1e-3, .closed = true, .first_spans = 8});
  EXPECT_TRUE(loft.reached);
  EXPECT_FALSE(loft.smooth_frames);
  for (int i = 0; i <= 100; ++i)
    EXPECT_LE(distanceAt(loft.surface, frames(round * i / 100), round * i / 100), 1.5e-3);
  for (const KnotLine& line : encloseKnotLines(loft.surface, SurfaceDirection::U, narrowTolerance(),
                                               true, {.figures = false}))
    expectCertified(line.figures, 1, Message() << "u " << line.knot << ": ");
  for (const KnotLine& line : encloseKnotLines(loft.surface, SurfaceDirection::V, narrowTolerance(),
                                               true, {.figures = false}))
    expectCertified(line.figures, 2, Message() << "v " << line.knot << ": ");
  EXPECT_THAT(
      [&] {
        frameLoft(frames, {0, 6}, {.order = 1, .closed = true});
      },
      ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("closed"), HasSubstr("mm apart"))));
}

TEST(FrameLoft, KinksStayWhereTheyAre) {
  std::mt19937_64 random(testSeed());
  const ChainFrames one = chainFrames(2, 2, 1, false, random);
  const auto frames = [&](double omega) {
    return mappedFrame(one(omega), Eigen::Matrix3d::Identity(),
                       std::max(0.0, omega - 0.4) * Vec(2, 5, 3));
  };
  const FrameLoft loft =
      frameLoft(frames, {0, 1}, {.order = 2, .tolerance_mm = 1e-3, .kinks = {0.4}});
  EXPECT_TRUE(loft.reached);
  EXPECT_LE(loft.spans, 12);
  for (int i = 0; i <= 100; ++i)
    EXPECT_LE(distanceAt(loft.surface, frames(i / 100.0), i / 100.0), 1.5e-3) << i;
  for (const KnotLine& line :
       encloseKnotLines(loft.surface, SurfaceDirection::V, narrowTolerance())) {
    if (line.knot == 0.4) {
      EXPECT_GT(line.figures.angle_rad->lower, 0.1);
    } else {
      expectCertified(line.figures, 2, Message() << "v " << line.knot << ": ");
    }
  }
}

TEST(FrameLoft, ProvenDistanceHoldsEverywhere) {
  std::mt19937_64 random(testSeed());
  const ChainFrames chain = chainFrames(1, 2, 0, true, random);
  const BezierSpline base = chain(0);
  double size = 0;
  for (Eigen::Index i = 0; i < base.poles.rows(); ++i)
    size = std::max(size, base.poles.row(i).head<3>().norm());
  // Rotation: every derivative of a pole by the angle is at most as long as the pole.
  const auto frames = [&](double angle) {
    return mappedFrame(base, Eigen::AngleAxisd(angle, Vec::UnitZ()).toRotationMatrix(),
                       Vec::Zero());
  };
  for (const int order : {2, 4, 6}) {
    const FrameLoft loft =
        frameLoft(frames, {0, 3},
                  {.order = 1,
                   .tolerance_mm = 1e-3,
                   .derivative_bound = FrameDerivativeBound{.order = order, .size = size}});
    ASSERT_TRUE(loft.proven_mm) << order;
    EXPECT_TRUE(loft.reached) << order;
    EXPECT_LE(*loft.proven_mm, 1e-3) << order;
    EXPECT_LE(loft.distance_mm, *loft.proven_mm) << order;
    for (int i = 0; i <= 1000; ++i)
      ASSERT_LE(distanceAt(loft.surface, frames(0.003 * i), 0.003 * i), *loft.proven_mm) << order;
  }
}

TEST(FrameLoft, WorkLimitIsReported) {
  std::mt19937_64 random(testSeed());
  const ChainFrames frames = chainFrames(2, 2, 1, false, random);
  const FrameLoft loft =
      frameLoft(frames, {0, 1}, {.order = 2, .tolerance_mm = 1e-12, .max_spans = 10});
  EXPECT_FALSE(loft.reached);
  EXPECT_LE(loft.spans, 10);
  EXPECT_GT(loft.distance_mm, 1e-12);
  EXPECT_THROW(frameLoft(frames, {0, 1}, {.progress = [](double) { return false; }}), Cancelled);
}

TEST(FrameLoft, RefusesInvalidFrames) {
  std::mt19937_64 random(testSeed());
  const ChainFrames frames = chainFrames(2, 2, 1, false, random);
  const auto refused = [&](const FrameFunction& of, const std::string& a, const std::string& b) {
    EXPECT_THAT(
        [&] {
          frameLoft(of, {0, 1});
        },
        ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(a), HasSubstr(b))));
  };
  const auto changed = [&](const std::function<void(BezierSpline&)>& change) {
    return [&frames, change](double omega) {
      BezierSpline frame = frames(omega);
      if (omega == 0.5) change(frame);
      return frame;
    };
  };
  refused(changed([](BezierSpline& f) { f.poles(4, 1) = std::nan(""); }), "omega 0.5", "4");
  refused(changed([](BezierSpline& f) { f = backwards(f), f.knots[1] = 7; }), "omega 0.5", "knot");
  refused(changed([](BezierSpline& f) {
            f.poles.row(f.poles.rows() - 1) = f.poles.row(0);
            f.closed = true;
          }),
          "omega 0.5", "closed");
  refused(changed([](BezierSpline& f) {
            f.poles.conservativeResize(6, 4);
            f.knots.pop_back();
          }),
          "omega 0.5", "segments 1");
  refused(changed([](BezierSpline& f) { f.poles.row(6) = f.poles.row(4); }), "omega 0.5",
          "joint 1");
  refused(changed([](BezierSpline& f) { f.poles.row(2) *= 2; }), "rational", "C^2");
  refused({}, "no function", "frames");
}

TEST(FrameLoft, RefusesInvalidOptions) {
  std::mt19937_64 random(testSeed());
  const ChainFrames frames = chainFrames(2, 2, 1, false, random);
  const auto refused = [&](const Interval& omegas, const FrameLoftOptions& options,
                           const std::string& a, const std::string& b) {
    EXPECT_THAT([&] { frameLoft(frames, omegas, options); },
                ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(a), HasSubstr(b))));
  };
  refused({1, 1}, {}, "omega runs", "1");
  refused({0, std::nan("")}, {}, "omega runs", "nan");
  refused({0, 1}, {.order = 5}, "order", "5");
  refused({0, 1}, {.order = -1}, "order", "-1");
  refused({0, 1}, {.tolerance_mm = 0}, "tolerance_mm", "0");
  refused({0, 1}, {.stations = {0.5, 2}}, "station 1", "2");
  refused({0, 1}, {.kinks = {std::nan("")}}, "kink 0", "nan");
  refused({0, 1}, {.first_spans = 0}, "first_spans", "0");
  refused({0, 1}, {.max_spans = 0}, "max_spans", "0");
  refused({0, 1}, {.checks = 0}, "checks", "0");
  refused({0, 1}, {.derivative_bound = FrameDerivativeBound{.order = 9}}, "derivative bound", "9");
  refused({0, 1}, {.derivative_bound = FrameDerivativeBound{.size = -1}}, "derivative bound", "-1");
  EXPECT_THROW(isoCurve(frameLoft(frames, {0, 1}).surface, 1.5), std::invalid_argument);
}

TEST(FrameLoft, OneSegmentAndRationalFrames) {
  // A quarter of a circle, exact, whose radius is cubic in omega.
  const auto radius = [](double w) { return 2 + w - w * w * w / 3; };
  const auto frames = [&](double w) {
    const double r = radius(w), s = std::sqrt(0.5);
    BezierSpline result{2, {0, 1}, HomogeneousPoles(3, 4)};
    result.poles << r, 0, w, 1, s * r, s * r, s * w, s, 0, r, w, 1;
    return result;
  };
  const FrameLoft loft = frameLoft(frames, {0, 1}, {.order = 1});
  EXPECT_TRUE(loft.smooth_frames);
  for (int i = 0; i <= 20; ++i) {
    const Vec p = jet(loft.surface, 0.37, i / 20.0).p;
    EXPECT_NEAR(p.head<2>().norm(), radius(i / 20.0), 1e-13);
    EXPECT_NEAR(p.z(), i / 20.0, 1e-13);
  }
}

}  // namespace
}  // namespace seamwright
