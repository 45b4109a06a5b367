// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <GeomConvert.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "follow_seams.hpp"

namespace seamwright::test {
namespace {

using occ::FaceFollow;
using occ::FaceTask;
using occ::FollowPath;
using occ::followPaths;
using occ::TargetPoint;
using testing::HasSubstr;

using Path = handle<Geom2d_BSplineCurve>;

Spline copyOf(const Spline& surface) {
  return Spline::DownCast(surface->Copy());
}

double height(std::mt19937& generator) {
  return 0.5 + random(generator, 0.2);
}

/// Curved, from u = 0 to u = 1.
Path acrossPath(std::mt19937& generator) {
  return curvedPath(
      {{0, height(generator)}, {0.3, height(generator)}, {0.7, height(generator)}, {1, height(generator)}});
}

bool reaches(const occ::SeamResult& seam, int order) {
  return seam.verdict.level >= (order == 1 ? Level::G1 : Level::G2);
}

/// The given surface with the knots of the result.
Spline refinedAs(const Spline& given, const Spline& result) {
  const Spline refined = copyOf(given);
  TColStd_Array1OfReal u(1, result->NbUKnots()), v(1, result->NbVKnots());
  TColStd_Array1OfInteger times_u(1, result->NbUKnots()), times_v(1, result->NbVKnots());
  result->UKnots(u);
  result->VKnots(v);
  result->UMultiplicities(times_u);
  result->VMultiplicities(times_v);
  refined->InsertUKnots(u, times_u, 0, false);
  refined->InsertVKnots(v, times_v, 0, false);
  return refined;
}

double largestMove(const Spline& a, const Spline& b) {
  double largest = 0;
  for (int i = 1; i <= a->NbUPoles(); ++i)
    for (int j = 1; j <= a->NbVPoles(); ++j)
      largest = std::max(largest, a->Pole(i, j).Distance(b->Pole(i, j)));
  return largest;
}

TEST(FaceFollow, MeetsAnExactAnswerAlongACut) {
  std::mt19937 generator(71);
  int small_moves = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const int order = 1 + trial % 2, count = 12 + trial % 9;
    const Spline truth = sheet(generator, count, count, 3, 3);
    const double noise = logRandom(generator, 0.1, 2);
    const Spline moving = copyOf(truth);
    addNoise(moving, generator, noise);
    const Path path = acrossPath(generator);
    const PathOn staying(truth, path), own(moving, path, false);
    const FaceFollow follow = followPaths({moving, {pathTo(own, staying, order)}, fine()});
    EXPECT_EQ(follow.failure, "") << trial;
    const occ::SeamResult after =
        certified(seamBetween(staying, {follow.surface, path, false}), fine(), order);
    EXPECT_TRUE(reaches(after, order)) << trial << " " << describe(after);
    EXPECT_FALSE(reaches(certified(seamBetween(staying, own), fine(), order), order)) << trial;
    EXPECT_NEAR(follow.largest_move_mm, largestMove(refinedAs(moving, follow.surface), follow.surface),
                1e-12);
    small_moves += follow.largest_move_mm <= 3 * noise;
  }
  EXPECT_EQ(small_moves, 100);
}

TEST(FaceFollow, PolesAwayFromThePathStayToTheBit) {
  std::mt19937 generator(72);
  for (int trial = 0; trial < 20; ++trial) {
    const Spline truth = sheet(generator, 20, 20, 3, 3), moving = copyOf(truth);
    addNoise(moving, generator, 0.03);
    const Path path = acrossPath(generator);
    const FaceFollow follow =
        followPaths({moving, {pathTo({moving, path}, {truth, path}, 1 + trial % 2)}, fine()});
    const Spline before = refinedAs(moving, follow.surface);
    double low = 1, high = 0;
    for (int k = 0; k <= 1000; ++k) {
      low = std::min(low, path->Value(k / 1000.0).Y());
      high = std::max(high, path->Value(k / 1000.0).Y());
    }
    // A pole of the given knots that the path touches spans four of their 17 spans.
    const double reach = 4.0 / 17;
    const TColStd_Array1OfReal& knots = before->VKnotSequence();
    int staying = 0;
    for (int j = 1; j <= before->NbVPoles(); ++j) {
      if (knots(j + 4) > low - reach && knots(j) < high + reach) continue;
      for (int i = 1; i <= before->NbUPoles(); ++i, ++staying) {
        const gp_Pnt a = before->Pole(i, j), b = follow.surface->Pole(i, j);
        EXPECT_TRUE(a.X() == b.X() && a.Y() == b.Y() && a.Z() == b.Z());
      }
    }
    EXPECT_GT(staying, 20);
    // Also as a shape: where no touched pole of the given knots acts.
    for (int k = 0; k < 50; ++k) {
      const double u = random(generator, 0.5) + 0.5, v = random(generator, 0.5) + 0.5;
      if (v > low - reach && v < high + reach) continue;
      EXPECT_LT(moving->Value(u, v).Distance(follow.surface->Value(u, v)), 1e-12);
    }
  }
}

TEST(FaceFollow, AlongANaturalSideOnlyItsRowsMove) {
  std::mt19937 generator(73);
  for (int trial = 0; trial < 12; ++trial) {
    const int order = trial % 3, side = trial % 4;
    const Spline truth = sheet(generator, 11, 9, 3, 3), moving = copyOf(truth);
    addNoise(moving, generator, 0.02);
    const std::vector<gp_Pnt2d> corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const Path path = curvedPath({corners[side], corners[(side + 1) % 4]});
    const FaceFollow follow = followPaths({moving, {pathTo({moving, path}, {truth, path}, order)}, fine()});
    EXPECT_EQ(follow.failure, "");
    const Spline before = refinedAs(moving, follow.surface);
    int moved = 0;
    for (int i = 1; i <= before->NbUPoles(); ++i)
      for (int j = 1; j <= before->NbVPoles(); ++j) {
        const int row = std::array{j - 1, before->NbUPoles() - i, before->NbVPoles() - j, i - 1}[side];
        const gp_Pnt a = before->Pole(i, j), b = follow.surface->Pole(i, j);
        const bool stays = a.X() == b.X() && a.Y() == b.Y() && a.Z() == b.Z();
        if (row > order) {
          EXPECT_TRUE(stays) << i << " " << j << " side " << side;
        }
        moved += !stays;
      }
    EXPECT_GT(moved, 0);
  }
}

TEST(FaceFollow, APlaneStays) {
  std::mt19937 generator(74);
  TColgp_Array2OfPnt poles(1, 13, 1, 13);
  const auto greville = [](int i) {
    const auto knot = [](int k) { return std::clamp(k - 3, 0, 10) / 10.0; };
    return (knot(i) + knot(i + 1) + knot(i + 2)) / 3;
  };
  for (int i = 1; i <= 13; ++i)
    for (int j = 1; j <= 13; ++j) poles(i, j) = gp_Pnt(60 * greville(i), 40 * greville(j), 0);
  const Spline flat = splineOf(poles, 3, 3);
  ASSERT_LT(flat->Value(0.37, 0.21).Distance(gp_Pnt(60 * 0.37, 40 * 0.21, 0)), 1e-12);
  for (int trial = 0; trial < 10; ++trial) {
    const int order = 1 + trial % 2;
    const Spline moving = copyOf(flat);
    const double noise = logRandom(generator, 0.05, 1.5);
    addNoise(moving, generator, noise);
    const Path path = acrossPath(generator);
    std::vector<gp_Pnt2d> on_plane;
    for (int k = 1; k <= path->NbPoles(); ++k)
      on_plane.emplace_back(60 * path->Pole(k).X(), 40 * path->Pole(k).Y());
    const handle<Geom_Surface> plane = new Geom_Plane(gp::XOY());
    const PathOn staying(plane, curvedPath(on_plane));
    const FaceFollow follow = followPaths({moving, {pathTo({moving, path, false}, staying, order)}, fine()});
    EXPECT_EQ(follow.failure, "") << trial;
    const occ::SeamResult after =
        certified(seamBetween(staying, {follow.surface, path, false}), fine(), order);
    EXPECT_TRUE(reaches(after, order)) << trial << " " << describe(after);
    EXPECT_LE(follow.largest_move_mm, 3 * noise);
  }
}

TEST(FaceFollow, ACylinderStays) {
  std::mt19937 generator(75);
  constexpr double radius = 30;
  const handle<Geom_Surface> cylinder = new Geom_CylindricalSurface(gp::XOY(), radius);
  for (int trial = 0; trial < 10; ++trial) {
    const int order = 1 + trial % 2;
    // Exact, and rational.
    const Spline exact = GeomConvert::SurfaceToBSplineSurface(
        new Geom_RectangularTrimmedSurface(cylinder, 0.0, 1.5, 0.0, 40.0));
    exact->IncreaseDegree(4, 3);
    for (int k = 1; k < 10; ++k) {
      exact->InsertUKnot(0.15 * k, 1, 1e-9);
      exact->InsertVKnot(4.0 * k, 1, 1e-9);
    }
    const Spline moving = copyOf(exact);
    const double noise = logRandom(generator, 0.05, 1.5);
    addNoise(moving, generator, noise);
    const Path path = curvedPath({{0, 40 * height(generator)},
                                  {0.5, 40 * height(generator)},
                                  {1, 40 * height(generator)},
                                  {1.5, 40 * height(generator)}});
    FollowPath follows = pathTo({moving, path, false}, {exact, path}, order);
    follows.target = [&](double s) {
      const gp_Pnt2d uv = path->Value(s);
      const gp_Pnt p = exact->Value(uv.X(), uv.Y());
      TargetPoint target;
      target.point = {p.X(), p.Y(), p.Z()};
      target.normal = Eigen::Vector3d(p.X(), p.Y(), 0) / radius;
      const Eigen::Vector3d around(-target.normal.y(), target.normal.x(), 0);
      target.curvature = -around * around.transpose() / radius;
      return target;
    };
    const FaceFollow follow = followPaths({moving, {follows}, fine()});
    EXPECT_EQ(follow.failure, "") << trial;
    const occ::SeamResult after =
        certified(seamBetween({exact, path}, {follow.surface, path, false}), fine(), order);
    EXPECT_TRUE(reaches(after, order)) << trial << " " << describe(after);
    EXPECT_LE(follow.largest_move_mm, 3 * noise);
    for (int i = 1; i <= follow.surface->NbUPoles(); ++i)
      EXPECT_EQ(follow.surface->Weight(i, 3), refinedAs(moving, follow.surface)->Weight(i, 3));
  }
}

TEST(FaceFollow, AllSidesAreTargets) {
  std::mt19937 generator(76);
  for (int trial = 0; trial < 12; ++trial) {
    const int order = 1 + trial % 2;
    const bool natural = trial % 4 < 2;
    const Spline truth = sheet(generator, 14, 13, 3, 3), moving = copyOf(truth);
    const double noise = logRandom(generator, 0.05, 1.5);
    addNoise(moving, generator, noise);
    const double margin = natural ? 0 : 0.12;
    std::vector<gp_Pnt2d> corners = {
        {margin, margin}, {1 - margin, margin}, {1 - margin, 1 - margin}, {margin, 1 - margin}};
    std::vector<Path> paths;
    FaceTask task{moving, {}, fine()};
    for (int k = 0; k < 4; ++k) {
      const gp_Pnt2d a = corners[k], b = corners[(k + 1) % 4];
      const gp_XY middle = (a.XY() + b.XY()) / 2, in = gp_XY(0.5, 0.5) - middle;
      paths.push_back(natural ? curvedPath({a, b}) : curvedPath({a, gp_Pnt2d(middle + 0.3 * in), b}));
      task.paths.push_back(pathTo({moving, paths[k]}, {truth, paths[k]}, order));
    }
    const FaceFollow follow = followPaths(task);
    EXPECT_EQ(follow.failure, "") << trial;
    EXPECT_LE(follow.largest_move_mm, 3 * noise);
    for (const Path& path : paths) {
      const occ::SeamResult after =
          certified(seamBetween({truth, path, false}, {follow.surface, path}), fine(), order);
      EXPECT_TRUE(reaches(after, order)) << trial << " " << describe(after);
    }
  }
}

/// A closed curve about a point.
Path loop(double u, double v, double radius) {
  TColgp_Array1OfPnt2d poles(1, 12);
  TColStd_Array1OfReal knots(1, 13);
  TColStd_Array1OfInteger multiplicities(1, 13);
  multiplicities.Init(1);
  for (int k = 1; k <= 13; ++k) knots(k) = (k - 1) / 12.0;
  for (int k = 1; k <= 12; ++k) {
    const double angle = 2 * std::numbers::pi * k / 12, wave = radius * (1 + 0.2 * std::cos(3 * angle));
    poles(k) = gp_Pnt2d(u + wave * std::cos(angle), v + wave * std::sin(angle));
  }
  const Path path = new Geom2d_BSplineCurve(poles, knots, multiplicities, 3, true);
  path->SetNotPeriodic();
  return path;
}

TEST(FaceFollow, AHoleFollowsAndTheOuterSidesAreHeld) {
  std::mt19937 generator(77);
  for (int trial = 0; trial < 6; ++trial) {
    const int order = 1 + trial % 2;
    const Spline truth = sheet(generator, 16, 16, 3, 3), moving = copyOf(truth);
    const double noise = logRandom(generator, 0.05, 1.5);
    addNoise(moving, generator, noise);
    FaceTask task{moving, {}, fine()};
    const Path hole = loop(0.5, 0.45, 0.17);
    task.paths.push_back(pathTo({moving, hole, false}, {truth, hole}, order));
    const std::vector<gp_Pnt2d> corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    std::vector<Path> sides;
    for (int k = 0; k < 4; ++k) {
      sides.push_back(curvedPath({corners[k], corners[(k + 1) % 4]}));
      task.paths.push_back(pathTo({moving, sides[k]}, {moving, sides[k]}, order));
    }
    const FaceFollow follow = followPaths(task);
    EXPECT_EQ(follow.failure, "") << trial;
    EXPECT_LE(follow.largest_move_mm, 3 * noise);
    const occ::SeamResult after =
        certified(seamBetween({truth, hole}, {follow.surface, hole, false}), fine(), order);
    EXPECT_TRUE(reaches(after, order)) << trial << " " << describe(after);
    for (const Path& side : sides)
      EXPECT_TRUE(reaches(
          certified(seamBetween({moving, side, false}, {follow.surface, side}), fine(), order), order));
  }
}

TEST(FaceFollow, WhereATargetHasNoNormalThePointAloneIsMet) {
  std::mt19937 generator(31);
  for (int trial = 0; trial < 5; ++trial) {
    const Spline truth = sheet(generator, 12, 12, 3, 3), moving = Spline::DownCast(truth->Copy());
    addNoise(moving, generator, 0.05);
    const auto path = curvedPath({{0.1, 0.4}, {0.4, 0.6}, {0.7, 0.4}, {0.9, 0.6}});
    occ::FollowPath bare = pathTo({moving, path}, {truth, path}, 2);
    bare.target = [target = bare.target](double s) {
      occ::TargetPoint point = target(s);
      point.normal.setZero();
      return point;
    };
    const FaceFollow follow = followPaths({moving, {bare}, fine()});
    EXPECT_EQ(follow.failure, "");
    for (double s = 0; s <= 1; s += 0.01) {
      const gp_Pnt2d uv = path->Value(s);
      EXPECT_LE(follow.surface->Value(uv.X(), uv.Y()).Distance(truth->Value(uv.X(), uv.Y())), fine().gap_mm);
    }
  }
}

TEST(FaceFollow, ASurfaceThatMeetsItsTargetsComesBackAsItIs) {
  std::mt19937 generator(78);
  const Spline truth = sheet(generator, 10, 10, 3, 3);
  const Path path = acrossPath(generator);
  const FaceFollow follow = followPaths({truth, {pathTo({truth, path}, {truth, path}, 2)}, fine()});
  EXPECT_EQ(follow.failure, "");
  EXPECT_EQ(follow.largest_move_mm, 0);
  EXPECT_EQ(follow.refinements, 0);
  EXPECT_EQ(largestMove(truth, follow.surface), 0);
  EXPECT_EQ(largestMove(truth, followPaths({truth, {}, fine()}).surface), 0);
}

TEST(FaceFollow, LawsOfMotionScaleAndSense) {
  std::mt19937 generator(79);
  for (int trial = 0; trial < 12; ++trial) {
    const int order = 1 + trial % 2;
    const Spline truth = sheet(generator, 12, 12, 3, 3), moving = copyOf(truth);
    addNoise(moving, generator, 0.03);
    const Path path = acrossPath(generator);
    FaceTask task{moving, {pathTo({moving, path, false}, {truth, path}, order)}, fine()};
    const FaceFollow plain = followPaths(task);
    const auto expectSame = [&](const FaceFollow& other, double scale, const char* what) {
      EXPECT_EQ(other.refinements, plain.refinements) << what;
      EXPECT_NEAR(other.largest_move_mm, scale * plain.largest_move_mm, 1e-6 * scale) << what;
    };
    const auto moved = [&](const gp_Trsf& by, double scale) {
      const Spline there = copyOf(truth), own = copyOf(moving);
      there->Transform(by);
      own->Transform(by);
      FaceTask same{own, {pathTo({own, path, false}, {there, path}, order)}, fine()};
      same.tolerance.gap_mm *= scale;
      same.tolerance.flat_radius_mm *= scale;
      const FaceFollow result = followPaths(same);
      const Spline expected = copyOf(plain.surface);
      expected->Transform(by);
      expectSame(result, scale, "moved");
      EXPECT_LT(largestMove(expected, result.surface), 1e-6 * scale);
    };
    moved(randomMotion(generator), 1);
    gp_Trsf larger;
    larger.SetScale(gp_Pnt(1, 2, 3), 8);
    moved(larger, 8);
    FaceTask backwards = task;
    Path reversed = Path::DownCast(path->Copy());
    reversed->Reverse();
    backwards.paths = {pathTo({moving, reversed, true}, {truth, reversed}, order)};
    const FaceFollow back = followPaths(backwards);
    expectSame(back, 1, "reversed");
    EXPECT_LT(largestMove(plain.surface, back.surface), 1e-6);
    const Spline exchanged = copyOf(moving);
    exchanged->ExchangeUV();
    std::vector<gp_Pnt2d> poles;
    for (int k = 1; k <= path->NbPoles(); ++k) poles.emplace_back(path->Pole(k).Y(), path->Pole(k).X());
    FaceTask turned{
        exchanged, {pathTo({exchanged, curvedPath(poles), true}, {truth, path}, order, -1)}, fine()};
    const FaceFollow other = followPaths(turned);
    expectSame(other, 1, "exchanged");
    const Spline again = copyOf(other.surface);
    again->ExchangeUV();
    EXPECT_LT(largestMove(plain.surface, again), 1e-6);
  }
}

TEST(FaceFollow, ACollapsedSideStaysAPoint) {
  std::mt19937 generator(80);
  for (int trial = 0; trial < 8; ++trial) {
    const int order = 1 + trial % 2;
    const Spline truth = sheet(generator, 10, 12, 3, 3);
    const gp_Pnt corner = truth->Pole(5, 1);
    for (int i = 1; i <= truth->NbUPoles(); ++i) truth->SetPole(i, 1, corner);
    const Spline moving = copyOf(truth);
    addNoise(moving, generator, 0.01);
    for (int i = 1; i <= moving->NbUPoles(); ++i)
      moving->SetPole(i, 1, corner.Translated(gp_Vec(0.01, 0, 0.02)));
    const Path path = curvedPath({{0.5, 1}, {0.4, 0.6}, {0.55, 0.3}, {0.45, 0}});
    const FaceFollow follow = followPaths({moving, {pathTo({moving, path}, {truth, path}, order)}, fine()});
    for (int i = 2; i <= follow.surface->NbUPoles(); ++i)
      EXPECT_LT(follow.surface->Pole(i, 1).Distance(follow.surface->Pole(1, 1)), 1e-13);
    EXPECT_LT(follow.surface->Pole(1, 1).Distance(corner), 2.5e-4);
    EXPECT_EQ(follow.failure, "") << trial;
    // The point that all poles of the side are in moves back, and little else.
    EXPECT_LT(follow.largest_move_mm, 0.03);
  }
}

TEST(FaceFollow, PeriodicSurfacesStayClosed) {
  std::mt19937 generator(81);
  constexpr int around = 14, along = 9;
  TColgp_Array2OfPnt poles(1, around, 1, along);
  for (int i = 1; i <= around; ++i)
    for (int j = 1; j <= along; ++j) {
      const double angle = 2 * std::numbers::pi * i / around, r = 20 + 0.3 * j + random(generator, 0.5);
      poles(i, j) = gp_Pnt(r * std::cos(angle), r * std::sin(angle), 5 * j + random(generator, 0.5));
    }
  TColStd_Array1OfReal knots_u(1, around + 1), knots_v(1, along - 2);
  TColStd_Array1OfInteger times_u(1, around + 1), times_v(1, along - 2);
  for (int k = 1; k <= around + 1; ++k) knots_u(k) = k - 1;
  for (int k = 1; k <= along - 2; ++k) knots_v(k) = k - 1;
  times_u.Init(1);
  times_v.Init(1);
  times_v(1) = times_v(along - 2) = 4;
  const Spline truth = new Geom_BSplineSurface(poles, knots_u, knots_v, times_u, times_v, 3, 3, true, false);
  const std::vector<Path> paths = {curvedPath({{0, 3}, {4, 2}, {7, 5}, {10, 2}, {14, 3}}),  // all around
                                   curvedPath({{11, 1}, {13, 3}, {15, 2}, {18, 4}}),        // over the period
                                   curvedPath({{-3, 4}, {-1, 3}, {1, 5}, {3, 2}})};
  for (int trial = 0; trial < 12; ++trial) {
    const int order = 1 + trial % 2;
    const Path& path = paths[trial % 3];
    const Spline moving = copyOf(truth);
    const double noise = logRandom(generator, 0.05, 1.5);
    addNoise(moving, generator, noise);
    const FaceFollow follow =
        followPaths({moving, {pathTo({moving, path, false}, {truth, path}, order)}, fine()});
    EXPECT_EQ(follow.failure, "") << trial;
    EXPECT_TRUE(follow.surface->IsUPeriodic());
    EXPECT_LE(follow.largest_move_mm, 3 * noise);
    const occ::SeamResult after =
        certified(seamBetween({truth, path}, {follow.surface, path, false}), fine(), order);
    EXPECT_TRUE(reaches(after, order)) << trial << " " << describe(after);
  }
}

TEST(FaceFollow, CornersThatContradictAreTold) {
  std::mt19937 generator(82);
  const Spline truth = sheet(generator, 12, 12, 3, 3), moving = copyOf(truth);
  addNoise(moving, generator, 0.01);
  const Path first = curvedPath({{0, 0.5}, {0.3, 0.55}, {0.5, 0.5}}),
             second = curvedPath({{0.5, 0.5}, {0.6, 1}});
  FaceTask task{moving,
                {pathTo({moving, first}, {truth, first}, 1), pathTo({moving, second}, {truth, second}, 1)},
                fine()};
  EXPECT_EQ(followPaths(task).failure, "");
  task.paths[1].target = [=](double s) {
    TargetPoint target = shownBy(truth, second->Value(s));
    target.point.z() += 0.25;
    return target;
  };
  task.max_refinements = 1;
  EXPECT_THAT(followPaths(task).failure,
              HasSubstr("path 1 and path 2 ask for different things where they meet at ("));
  EXPECT_THAT(followPaths(task).failure, HasSubstr(": 0.25 mm, 0 degrees apart"));
}

TEST(FaceFollow, WhatIsOutOfReachIsTold) {
  std::mt19937 generator(83);
  const Spline truth = sheet(generator, 12, 12, 3, 3), moving = copyOf(truth);
  addNoise(moving, generator, 0.01);
  const Path path = acrossPath(generator);
  FaceTask task{moving, {pathTo({moving, path}, {truth, path}, 1)}, fine()};
  // A normal that the curve of the points contradicts.
  task.paths[0].target = [=](double s) {
    TargetPoint target = shownBy(truth, path->Value(s));
    const TargetPoint ahead = shownBy(truth, path->Value(s + 1e-3));
    target.normal = (target.normal + 0.02 * (ahead.point - target.point).normalized()).normalized();
    return target;
  };
  task.max_refinements = 1;
  const FaceFollow contradicted = followPaths(task);
  EXPECT_THAT(contradicted.failure, HasSubstr("path 1 is missed at ("));
  EXPECT_GT(contradicted.ratios[0], 1);
  // The other sense of the normal: not met, and not turned over either.
  task.paths[0] = pathTo({moving, path}, {truth, path}, 1, -1);
  EXPECT_THAT(followPaths(task).failure, HasSubstr("with its normal turned over"));
  task.paths[0] = pathTo({moving, path}, {truth, path}, 1);
  task.max_poles = 100;
  task.tolerance.gap_mm = 1e-9;
  const FaceFollow capped = followPaths(task);
  EXPECT_EQ(capped.refinements, 0);
}

TEST(FaceFollow, ARuledFaceIsRaisedSoThatItsOtherSideStays) {
  TColgp_Array2OfPnt poles(1, 8, 1, 2);
  for (int i = 1; i <= 8; ++i) {
    poles(i, 1) = gp_Pnt(10 * i, 0, 3 * std::sin(0.7 * i));
    poles(i, 2) = gp_Pnt(10 * i, 20, 2 * std::cos(0.5 * i));
  }
  const Spline ruled = splineOf(poles, 3, 1);
  const Path side = curvedPath({{0, 0}, {1, 0}});
  for (const int order : {1, 2}) {
    FollowPath follows = pathTo({ruled, side}, {ruled, side}, order);
    follows.target = [&](double s) {
      gp_Pnt p;
      gp_Vec along, across;
      ruled->D1(s, 0, p, along, across);
      TargetPoint target = shownBy(ruled, gp_Pnt2d(s, 0));
      const Eigen::Vector3d axis = Eigen::Vector3d(along.X(), along.Y(), along.Z()).normalized();
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.5 * degree, axis).toRotationMatrix();
      target.normal = turn * target.normal;
      target.curvature = turn * target.curvature * turn.transpose();
      return target;
    };
    ContinuityTolerance tolerance;
    tolerance.angle_rad = 0.01 * degree;
    const FaceFollow follow = followPaths({ruled, {follows}, tolerance});
    EXPECT_LT(follow.ratios[0], 1) << follow.failure;
    EXPECT_GT(follow.largest_move_mm, 0.01);
    EXPECT_EQ(follow.surface->VDegree(), order + 1);
    for (double u = 0; u <= 1; u += 0.05)
      EXPECT_LT(follow.surface->Value(u, 1).Distance(ruled->Value(u, 1)), 1e-12);
  }
}

}  // namespace
}  // namespace seamwright::test
