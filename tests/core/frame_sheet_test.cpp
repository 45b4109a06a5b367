// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <numbers>
#include <seamwright/core/blend/frame_sheet.hpp>
#include <seamwright/core/seam/bspline_side.hpp>

#include "frames.hpp"
#include "joins.hpp"
#include "spline_surfaces.hpp"

namespace seamwright {
namespace {

using test::distanceAt;
using test::drawn;
using test::expectCertified;
using test::narrowTolerance;
using test::Vec;
using testing::AllOf;
using testing::HasSubstr;
using testing::Message;
using testing::ThrowsMessage;

/// A surface over v = 0..3 of class C^2 along v, with its edge u = 0 near x = 0; rows go to x =
/// sense * 3, sense * 6, ..
BSplineSurface neighbour(double sense, double height, std::mt19937_64& random) {
  BSplineSurface surface{3, 5, {0, 0, 0, 0, 0.7, 1, 1, 1, 1}, {}, {}};
  surface.knots_v = {0, 0, 0, 0, 0, 0, 1, 1, 1, 2, 2, 3, 3, 3, 3, 3, 3};
  const int rows = surface.countU(), columns = surface.countV();
  surface.poles.resize(static_cast<Eigen::Index>(rows) * columns, 4);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      surface.poles.row(static_cast<Eigen::Index>(i) * columns + j)
          << sense * 3 * i + drawn(-0.2, 0.2, random),
          j + drawn(-0.2, 0.2, random), height + 0.4 * i * i + drawn(-0.4, 0.4, random), 1;
  return surface;
}

/// Frames between two curves of class C^n by the knots 0..3, whose ratios at the joints leave 1
/// between the ends.
struct SheetFrames {
  BezierSpline first, last;
  double ratio = 0.5;
  int order = 2;

  BezierSpline operator()(double omega) const {
    const double bump = std::pow(std::sin(std::numbers::pi * omega), 2);
    BezierSpline frame = first;
    frame.poles = (1 - omega) * first.poles + omega * last.poles;
    frame.poles.col(2).array() += bump;
    frame.poles.col(3).setOnes();
    Eigen::VectorXd beta = Eigen::VectorXd::Zero(order);
    if (order > 0) beta(0) = 1 + ratio * bump;
    if (order > 1) beta(1) = ratio * bump;
    for (int i = 1; i < frame.segments() && order > 0; ++i)
      frame.poles.middleRows(static_cast<Eigen::Index>(i) * frame.degree, order + 1) =
          nextPoles(segment(frame, i - 1), frame.degree,
                    {.beta = beta, .length = 1, .next_length = 1, .scale = {}});
    return frame;
  }
};

struct Between {
  BSplineSurface before, after;
  PatchEdge edge_before, edge_after;
  FrameRibbon start, end;
  SheetFrames frames;
};

Between between(int run, std::mt19937_64& random) {
  Between result;
  result.edge_before = test::patch_edges[run % 4];
  result.edge_after = test::patch_edges[(run + 1) % 4];
  const BSplineSurface left = neighbour(-1, 0, random);
  BSplineSurface right = neighbour(1, 3, random);
  for (Eigen::Index i = 0; i < right.poles.rows(); ++i) right.poles(i, 0) += 8;
  result.before = test::turned(left, result.edge_before);
  result.after = test::turned(right, result.edge_after);
  result.start = edgeRibbon(result.before, result.edge_before, false, SheetSide::Start, 2);
  result.end = edgeRibbon(result.after, result.edge_after, false, SheetSide::End, 2.5);
  result.frames = {result.start.position, result.end.position, 0.5, 2};
  return result;
}

TEST(FrameSheet, Identity1EndsAreTheRibbons) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 8; ++run) {
    const Between b = between(run, random);
    const int order = run % 3;
    const FrameLoft sheet = frameSheet(b.frames, {0, 1}, SheetEnd{b.start, order},
                                       SheetEnd{b.end, order}, {.tolerance_mm = 1e-2});
    EXPECT_TRUE(sheet.reached) << run;
    EXPECT_FALSE(sheet.smooth_frames) << run;
    for (const bool at_start : {true, false})
      for (int i = 0; i <= 30; ++i) {
        const double u = 0.1 * i;
        const FrameRibbon& ribbon = at_start ? b.start : b.end;
        const SurfaceJet at = jet(sheet.surface, u, at_start ? 0 : 1);
        const auto value = [&](const BezierSpline& of) -> Vec {
          return derivatives(of, u, 0).row(0).transpose();
        };
        EXPECT_LE((at.p - value(ribbon.position)).norm(), 1e-11) << run << " " << u;
        if (order > 0) {
          EXPECT_LE((at.v - value(ribbon.first)).norm(), 1e-9) << run << " " << u;
        }
        if (order > 1) {
          EXPECT_LE((at.vv - value(ribbon.second)).norm(), 1e-7) << run << " " << u;
        }
      }
    EXPECT_LE(sheet.zone_distance_mm, 3) << run;
    for (int i = order > 0 ? 10 : 0; i <= (order > 0 ? 30 : 40); ++i)
      EXPECT_LE(distanceAt(sheet.surface, b.frames(i / 40.0), i / 40.0), 2e-2) << run << " " << i;
  }
}

TEST(FrameSheet, Identity2SeamsAndJointLinesAreCertified) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 8; ++run) {
    const Between b = between(run, random);
    const int order = 1 + run % 2;
    const FrameLoft sheet = frameSheet(b.frames, {0, 1}, SheetEnd{b.start, order},
                                       SheetEnd{b.end, order}, {.tolerance_mm = 1e-2});
    const EncloseOptions verdict{.figures = false};
    expectCertified(encloseSeam(seamSide(sheet.surface, PatchEdge::V0),
                                seamSide(b.before, b.edge_before), narrowTolerance(), verdict),
                    order, Message() << run << " start: ");
    expectCertified(encloseSeam(seamSide(sheet.surface, PatchEdge::V1),
                                seamSide(b.after, b.edge_after), narrowTolerance(), verdict),
                    order, Message() << run << " end: ");
    for (const KnotLine& line :
         encloseKnotLines(sheet.surface, SurfaceDirection::U, narrowTolerance(), false, verdict))
      expectCertified(line.figures, 2, Message() << run << " line " << line.knot << ": ");
  }
}

TEST(FrameSheet, FreeEndsAreNotG1) {
  std::mt19937_64 random(testSeed());
  const Between b = between(0, random);
  const FrameLoft sheet =
      frameSheet(b.frames, {0, 1}, SheetEnd{b.start, 2}, {}, {.tolerance_mm = 1e-2});
  const auto at_end = encloseSeam(seamSide(sheet.surface, PatchEdge::V1),
                                  seamSide(b.after, b.edge_after), narrowTolerance());
  EXPECT_GT(at_end.angle_rad->lower, 1e-3);
  EXPECT_LE(*at_end.gap_mm->upper, 1e-9);
}

TEST(FrameSheet, Identity3SurfacesAreReproduced) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 4; ++run) {
    BSplineSurface surface = test::turned(neighbour(1, 0, random), PatchEdge::V0);
    surface.knots_v = {0, 0, 0, 0, 1, 1, 1, 1};
    HomogeneousPoles poles(static_cast<Eigen::Index>(surface.countU()) * 4, 4);
    for (Eigen::Index i = 0; i < surface.countU(); ++i)
      poles.middleRows(4 * i, 4) = surface.poles.middleRows(5 * i, 4);
    surface.poles = poles;
    const auto frames = [&](double omega) { return isoCurve(surface, omega); };
    const SheetEnd start{edgeRibbon(surface, PatchEdge::V0, false, SheetSide::End, 1), 2},
        end{edgeRibbon(surface, PatchEdge::V1, false, SheetSide::Start, 1), 2};
    // As plain loft, and with the form of frames that are G^n only.
    BezierSpline uneven = frames(0);
    uneven.knots[1] *= 1.1;
    const auto other_knots = [&](double omega) {
      BezierSpline frame = frames(omega);
      frame.knots = uneven.knots;
      return frame;
    };
    for (const bool plain : {true, false}) {
      const FrameLoft sheet =
          frameSheet(plain ? FrameFunction(frames) : other_knots, {0, 1}, start, end, {.order = 2});
      EXPECT_EQ(sheet.smooth_frames, plain);
      EXPECT_TRUE(sheet.reached);
      for (int i = 0; i < 100; ++i) {
        const double u = drawn(0, 3, random), v = drawn(0, 1, random);
        const SurfaceJet a = jet(sheet.surface, u, v), b = jet(surface, u, v);
        EXPECT_LE((a.p - b.p).norm(), 1e-11);
        EXPECT_LE((a.vv - b.vv).norm(), 1e-7);
      }
    }
  }
}

TEST(FrameSheet, RibbonsAreDerivativesOfTheSurface) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 16; ++run) {
    const PatchEdge edge = test::patch_edges[run % 4];
    const bool reversed = run % 8 >= 4, start = run < 8;
    const BSplineSurface surface = test::turned(neighbour(1, 0, random), edge);
    const FrameRibbon ribbon =
        edgeRibbon(surface, edge, reversed, start ? SheetSide::Start : SheetSide::End, 3);
    const bool across_u = edge == PatchEdge::U0 || edge == PatchEdge::U1;
    const bool at_end = edge == PatchEdge::U1 || edge == PatchEdge::V1;
    for (int i = 1; i < 30; ++i) {
      const double t = 0.1 * i, along = reversed ? 3 - t : t, across = at_end ? 1 : 0;
      const SurfaceJet at = across_u ? jet(surface, across, along) : jet(surface, along, across);
      const double sense = (start ? -3 : 3) * (at_end ? -1 : 1);
      const auto value = [&](const BezierSpline& of) -> Vec {
        return derivatives(of, t, 0).row(0).transpose();
      };
      EXPECT_LE((value(ribbon.position) - at.p).norm(), 1e-11);
      EXPECT_LE((value(ribbon.first) - sense * (across_u ? at.u : at.v)).norm(), 1e-9);
      EXPECT_LE((value(ribbon.second) - 9 * (across_u ? at.uu : at.vv)).norm(), 1e-8);
    }
  }
}

TEST(FrameSheet, EvenRateIsTheSpeedOfTheFrames) {
  std::mt19937_64 random(testSeed());
  const BSplineSurface surface = test::turned(neighbour(1, 0, random), PatchEdge::V0);
  const FrameRibbon ribbon = edgeRibbon(surface, PatchEdge::V0, false, SheetSide::End, 1);
  const auto frames = [&](double omega) {
    BezierSpline frame = ribbon.position;
    frame.poles.leftCols<3>() += 7 * omega * ribbon.first.poles.leftCols<3>();
    return frame;
  };
  EXPECT_NEAR(evenRate(frames, {0, 1}, ribbon, SheetSide::Start), 7, 1e-9);
  EXPECT_NEAR(evenRate(frames, {0, 1}, ribbon, SheetSide::End, 0.5), 7, 1e-9);
  const auto still = [&](double) { return ribbon.position; };
  EXPECT_THROW(evenRate(still, {0, 1}, ribbon, SheetSide::Start), std::invalid_argument);
}

TEST(FrameSheet, ClosedProfiles) {
  // Circles of cubic arcs between two cones of different slopes.
  const auto ring = [](double radius, double z) {
    const double k = 4.0 / 3 * (std::sqrt(2) - 1);
    BSplineSurface surface{3, 1, {}, {0, 0, 1, 1}, HomogeneousPoles::Ones(26, 4)};
    surface.knots_u = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 4};
    const double x[] = {1, 1, k, 0, -k, -1, -1, -1, -k, 0, k, 1, 1};
    const double y[] = {0, k, 1, 1, 1, k, 0, -k, -1, -1, -1, -k, 0};
    for (int i = 0; i < 13; ++i)
      for (int j = 0; j < 2; ++j) {
        const double r = radius - (1 - j) * 0.5;
        surface.poles.row(2 * i + j).head<3>() << r * x[i], r * y[i], z + j;
      }
    return surface;
  };
  const BSplineSurface below = ring(3, 0), above = ring(5, 4);
  const FrameRibbon start = edgeRibbon(below, PatchEdge::V1, false, SheetSide::Start, 1, true);
  const FrameRibbon end = edgeRibbon(above, PatchEdge::V0, false, SheetSide::End, 1, true);
  const auto frames = [&](double omega) {
    BezierSpline frame = start.position;
    frame.poles = (1 - omega) * start.position.poles + omega * end.position.poles;
    return frame;
  };
  const FrameLoft sheet = frameSheet(frames, {0, 1}, SheetEnd{start, 2}, SheetEnd{end, 2},
                                     {.order = 1, .tolerance_mm = 10});
  const EncloseOptions verdict{.figures = false};
  expectCertified(encloseSeam(seamSide(sheet.surface, PatchEdge::V0),
                              seamSide(below, PatchEdge::V1), narrowTolerance(), verdict),
                  2, Message() << "start");
  expectCertified(encloseSeam(seamSide(sheet.surface, PatchEdge::V1),
                              seamSide(above, PatchEdge::V0), narrowTolerance(), verdict),
                  2, Message() << "end");
  for (const KnotLine& line :
       encloseKnotLines(sheet.surface, SurfaceDirection::U, narrowTolerance(), true, verdict))
    expectCertified(line.figures, 1, Message() << line.knot);
}

TEST(FrameSheet, RefusesInvalidEnds) {
  std::mt19937_64 random(testSeed());
  const Between b = between(0, random);
  const auto refused = [&](const std::optional<SheetEnd>& start, const std::optional<SheetEnd>& end,
                           const FrameLoftOptions& options, const std::string& part) {
    EXPECT_THAT(
        [&] {
          frameSheet(b.frames, {0, 1}, start, end, options);
        },
        ThrowsMessage<std::invalid_argument>(HasSubstr(part)));
  };
  const SheetEnd good{b.start, 2};
  const auto with = [&](const std::function<void(SheetEnd&)>& change) {
    SheetEnd result = good;
    change(result);
    return result;
  };
  refused({}, {}, {}, "neither");
  refused(good, {}, {.closed = true}, "closed");
  refused(with([](SheetEnd& e) { e.order = 3; }), {}, {}, "order is 3");
  refused(with([](SheetEnd& e) { e.ribbon.position.poles(3, 2) += 1; }), {}, {}, "C^");
  refused(with([](SheetEnd& e) { e.ribbon.position.poles.col(2).array() += 1; }), {}, {},
          "mm from the frame");
  refused(with([](SheetEnd& e) { e.ribbon.first.poles(1, 3) = 2; }), {}, {}, "rational");
  refused(with([](SheetEnd& e) { e.ribbon.first.knots[1] = 1.5; }), {}, {}, "differ");
  refused(with([](SheetEnd& e) { e.ribbon.second.poles(1, 0) = std::nan(""); }), {}, {}, "1");
  refused(with([](SheetEnd& e) {
            e.ribbon.position.knots.pop_back();
            e.ribbon.position.poles.conservativeResize(11, 4);
          }),
          {}, {}, "2 segments");
  refused(with([](SheetEnd& e) { e.zone = -0.1; }), {}, {}, "-0.1");
  refused(with([](SheetEnd& e) { e.zone = 0.8; }), SheetEnd{b.end, 2}, {}, "0.25");
  refused(good, {}, {.stations = {0.2}}, "station 0.2");
  refused(good, {}, {.kinks = {0.1}}, "kink 0.1");
  SheetEnd other{b.end, 2};
  for (BezierSpline* curve : {&other.ribbon.position, &other.ribbon.first, &other.ribbon.second})
    for (double& knot : curve->knots) knot *= 2;
  refused(good, other, {}, "different knots");
  BSplineSurface rational = b.before;
  rational.poles.row(3) *= 2;
  EXPECT_THROW(edgeRibbon(rational, PatchEdge::U0, false, SheetSide::Start, 1),
               std::invalid_argument);
  EXPECT_THROW(edgeRibbon(b.before, PatchEdge::U0, false, SheetSide::Start, 0),
               std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
