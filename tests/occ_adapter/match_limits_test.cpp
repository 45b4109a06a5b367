// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "files.hpp"
#include "match_pairs.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

TEST(MatchFaces, ALargerMoveThanAllowedIsRefused) {
  std::mt19937 generator(testSeed());
  const TopoDS_Shape pair = joinedSheets(disturbedSheets(generator, 0.05));
  FaceMatchOptions options;
  const double needed = matchedPair(pair, options, "free").largest_move_mm;
  options.max_move_mm = needed / 2;
  const MatchReport refused = matchFaces(pair, 1, 2, options);
  EXPECT_FALSE(refused.matched);
  EXPECT_NE(refused.text().find("needs a move of"), std::string::npos) << refused.text();
  EXPECT_EQ(refused.code(), "moves_too_far");
  EXPECT_EQ(refused.largest_move_mm, 0);
  EXPECT_TRUE(face(refused.shape, 2).IsPartner(face(pair, 2)));
  EXPECT_EQ(refused.after.verdict.level, refused.before.verdict.level);
  options.max_move_mm = 1.001 * needed;
  expectMatched(matchFaces(pair, 1, 2, options), options, "just enough");
}

// Beside a plane a sheet with a crease in the middle of the seam only: its whole sides can be held,
// slanted ones inside it can not.
TEST(MatchFaces, TrimmedSidesThatWouldMoveAreHeldByAChangeNearTheBoundary) {
  TColgp_Array2OfPnt flat(1, 4, 1, 4), creased(1, 6, 1, 6);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) flat(i + 1, j + 1) = gp_Pnt(-30 + 10 * i, 40.0 / 3 * j, 0);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      creased(i + 1, j + 1) = gp_Pnt(6 * i, 8 * j, j == 2 || j == 3 ? 0.8 * i : 0);
  const Spline surface = splineOf(creased, 5, 5);
  const auto path = [](double u0, double v0, double u1, double v1) {
    return curvedPath({gp_Pnt2d(u0, v0), gp_Pnt2d(u1, v1)});
  };
  BRepBuilderAPI_MakeWire wire;
  for (const auto& line :
       {path(0, 0, 1, 0.3), path(1, 0.3, 1, 0.7), path(1, 0.7, 0, 1), path(0, 1, 0, 0)})
    wire.Add(BRepBuilderAPI_MakeEdge(line, surface, 0, 1).Edge());
  TopoDS_Face trapezoid = BRepBuilderAPI_MakeFace(surface, wire.Wire(), true).Face();
  BRepLib::BuildCurves3d(trapezoid);
  const TopoDS_Face still = wholeFace(splineOf(flat, 3, 3));
  FaceMatchOptions options;
  matchedPair(loose(still, trapezoid), options, "sides may move");
  options.hold_sides = true;
  matchedPair(loose(still, wholeFace(surface)), options, "whole sides held");
  const MatchReport report = matchFaces(loose(still, trapezoid), 1, 2, options);
  EXPECT_TRUE(report.matched) << report.text();
  EXPECT_NE(report.text().find("joined to the tolerance by a change"), std::string::npos)
      << report.text();
}

// With weights that change, points move further than poles.
TEST(MatchFaces, NoPointMovesFurtherThanReported) {
  std::mt19937 generator(testSeed());
  int matched = 0;
  std::uniform_real_distribution<double> weight(0.3, 3);
  for (int round = 0; round < 20; ++round) {
    TColgp_Array2OfPnt flat(1, 4, 1, 4), tilted(1, 4, 1, 4);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        flat(i + 1, j + 1) = gp_Pnt(-30 + 10 * i, 40.0 / 3 * j, 0);
        tilted(i + 1, j + 1) =
            gp_Pnt(10 * i, 40.0 / 3 * j, 1.3 * i + (i > 0 ? 2 * std::sin(j) : 0));
      }
    const Spline before = splineOf(tilted, 3, 3);
    for (int i = 1; i <= 4; ++i)
      for (int j = 1; j <= 4; ++j) before->SetWeight(i, j, weight(generator));
    const TopoDS_Shape pair = loose(wholeFace(splineOf(flat, 3, 3)), wholeFace(before));
    const MatchReport report = matchFaces(pair, 1, 2);
    if (!report.matched) continue;
    ++matched;
    const Spline after = Spline::DownCast(BRep_Tool::Surface(face(report.shape, 2)));
    double moved = 0;
    for (int k = 0; k <= 80; ++k)
      for (int l = 0; l <= 80; ++l)
        moved = std::max(
            moved, before->Value(k / 80.0, l / 80.0).Distance(after->Value(k / 80.0, l / 80.0)));
    EXPECT_LE(moved, 1.0001 * report.largest_move_mm) << "round " << round;
    FaceMatchOptions options;
    options.max_move_mm = 0.9 * moved;
    const MatchReport limited = matchFaces(pair, 1, 2, options);
    EXPECT_TRUE(!limited.matched || limited.largest_move_mm <= options.max_move_mm);
  }
  EXPECT_GT(matched, 0);
}

TEST(MatchFaces, WhatJoinsAlreadyIsLeftAlone) {
  std::mt19937 generator(testSeed());
  const std::array<Spline, 2> parts = cutInTwo(sheet(generator, 9, 6, 5, 3));
  for (const int order : {1, 2}) {
    const TopoDS_Shape pair = joinedSheets(parts);
    const MatchReport report = matchFaces(pair, 1, 2, ofOrder(order));
    EXPECT_TRUE(report.matched);
    EXPECT_EQ(report.largest_move_mm, 0);
    EXPECT_NE(report.text().find("nothing had to move"), std::string::npos);
    for (const int number : {1, 2})
      EXPECT_TRUE(face(report.shape, number).IsPartner(face(pair, number)));
    EXPECT_EQ(report.after.faces, (std::array<int, 2>{1, 2}));
    // Matched once, a pair stays.
    const MatchReport first =
        matchFaces(joinedSheets(disturbedSheets(generator, 0.05)), 1, 2, ofOrder(order));
    const MatchReport second = matchFaces(first.shape, 1, 2, ofOrder(order));
    EXPECT_TRUE(second.matched);
    EXPECT_EQ(second.largest_move_mm, 0);
  }
}

TEST(MatchFaces, ClosedBoundariesAreJoinedAndMissingOnesRefusedWithReasons) {
  const auto ring = [](double z) {
    const handle<Geom_Surface> cylinder =
        new Geom_CylindricalSurface(gp_Ax3(gp_Pnt(0, 0, z), gp::DZ()), 10);
    return BRepBuilderAPI_MakeFace(cylinder, 0, 2 * std::numbers::pi, 0, 5, 1e-7).Face();
  };
  const auto spline_ring = [&](double z) {
    const handle<Geom_Surface> trimmed = new Geom_RectangularTrimmedSurface(
        new Geom_CylindricalSurface(gp_Ax3(gp_Pnt(0, 0, z), gp::DZ()), 10), 0.0,
        2 * std::numbers::pi, 0.0, 5.0);
    return wholeFace(GeomConvert::SurfaceToBSplineSurface(trimmed));
  };
  const MatchReport closed = matchFaces(loose(ring(0), spline_ring(5)), 1, 2);
  EXPECT_TRUE(closed.matched) << closed.text();
  EXPECT_NE(closed.text().find("nothing had to move"), std::string::npos) << closed.text();
  const MatchReport apart = matchFaces(loose(ring(0), spline_ring(8)), 1, 2);
  EXPECT_FALSE(apart.matched);
  EXPECT_NE(apart.text().find("3 mm apart"), std::string::npos) << apart.text();
  EXPECT_EQ(apart.code(), "no_common_boundary");
  EXPECT_EQ(apart.before.id, 0);
}

// Half of a sheet beside a whole one of the same surface: a part of a side.
TEST(MatchFaces, APartOfASideIsJoined) {
  std::mt19937 generator(testSeed());
  const std::array<Spline, 2> parts = cutInTwo(sheet(generator, 9, 6, 3, 3));
  const handle<Geom_Surface> a(parts[0].get());
  const TopoDS_Shape half =
      loose(BRepBuilderAPI_MakeFace(a, 0, 0.4, 0, 0.5, 1e-7).Face(), wholeFace(parts[1]));
  const MatchReport report = matchFaces(half, 1, 2);
  EXPECT_TRUE(report.matched) << report.text();
  EXPECT_NE(report.text().find("nothing had to move"), std::string::npos) << report.text();
}

// The boundaries have their ends in common and bulge apart between them.
TEST(MatchFaces, BoundariesThatLeaveOneAnotherAreRefused) {
  for (const double bulge : {0.06, 0.3, 0.7}) {
    TColgp_Array2OfPnt flat(1, 4, 1, 4), bulging(1, 4, 1, 4);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        flat(i + 1, j + 1) = gp_Pnt(-30 + 10 * i, 40.0 / 3 * j, 0);
        bulging(i + 1, j + 1) =
            gp_Pnt(10 * i, 40.0 / 3 * j, i > 0 ? i : (j % 3 > 0 ? bulge / 0.75 : 0));
      }
    const TopoDS_Shape pair =
        loose(wholeFace(splineOf(flat, 3, 3)), wholeFace(splineOf(bulging, 3, 3)));
    const MatchReport report = matchFaces(pair, 1, 2);
    EXPECT_EQ(report.matched, bulge < 0.1) << report.text();
    if (bulge > 0.1) {
      EXPECT_NE(report.text().find("within 0.1 mm of one another over"), std::string::npos)
          << report.text();
    }
    FaceMatchOptions wide;
    wide.match_mm = 1.1 * bulge;
    EXPECT_TRUE(matchFaces(pair, 1, 2, wide).matched) << bulge;
  }
}

TEST(MatchFaces, AFaceThatReachesBeyondItsSurfaceIsRefused) {
  std::mt19937 generator(testSeed());
  const std::array<Spline, 2> parts = disturbedSheets(generator, 0.05);
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  parts[1]->Bounds(u0, u1, v0, v1);
  BRepBuilderAPI_MakeWire wire;
  const double beyond = u1 + 0.2 * (u1 - u0);
  const std::array<gp_Pnt2d, 4> corners = {gp_Pnt2d(u0, v0), gp_Pnt2d(beyond, v0),
                                           gp_Pnt2d(beyond, v1), gp_Pnt2d(u0, v1)};
  for (std::size_t k = 0; k < 4; ++k) {
    const handle<Geom2d_BSplineCurve> line = curvedPath({corners.at(k), corners.at((k + 1) % 4)});
    wire.Add(BRepBuilderAPI_MakeEdge(line, parts[1], 0, 1).Edge());
  }
  TopoDS_Face face =
      BRepBuilderAPI_MakeFace(handle<Geom_Surface>(parts[1]), wire.Wire(), true).Face();
  BRepLib::BuildCurves3d(face);
  FaceMatchOptions options;
  options.match_mm = 1;
  const MatchReport report = matchFaces(loose(wholeFace(parts[0]), face), 1, 2, options);
  EXPECT_FALSE(report.matched);
  EXPECT_NE(report.text().find("reaches beyond its surface"), std::string::npos) << report.text();
}

TEST(MatchFaces, AKnifeEdgeIsRefused) {
  // Both sheets lie on the same side of the line x = 0, y = 0..30 and meet in it at 0.5 degrees.
  TColgp_Array2OfPnt below(1, 4, 1, 4), above(1, 4, 1, 4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      below(i + 1, j + 1) = gp_Pnt(-30 + 10.0 * i, 10.0 * j, 0.02 * i * j * (3 - i));
      above(i + 1, j + 1) = gp_Pnt(-10.0 * i, 10.0 * j, 0.1 * i);
    }
  const TopoDS_Shape pair =
      loose(wholeFace(splineOf(below, 3, 3)), wholeFace(splineOf(above, 3, 3)));
  for (const int order : {1, 2}) {
    const MatchReport report = matchFaces(pair, 1, 2, ofOrder(order));
    EXPECT_FALSE(report.matched);
    EXPECT_NE(report.text().find("fold"), std::string::npos) << report.text();
  }
}

TEST(MatchFaces, BadArgumentsAreNamed) {
  std::mt19937 generator(testSeed());
  const TopoDS_Shape pair = joinedSheets(disturbedSheets(generator, 0.05));
  const auto refused = [&](int a, int b,
                           const std::function<void(FaceMatchOptions&)>& change) -> std::string {
    FaceMatchOptions options;
    change(options);
    try {
      matchFaces(pair, a, b, options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "not refused";
  };
  const auto nothing = [](FaceMatchOptions&) {};
  EXPECT_EQ(refused(0, 1, nothing), "face 0: the model has faces 1 to 2");
  EXPECT_EQ(refused(1, 3, nothing), "face 3: the model has faces 1 to 2");
  EXPECT_EQ(refused(2, 2, nothing), "face 2 is given twice: two faces are needed");
  EXPECT_EQ(refused(1, 2, [](FaceMatchOptions& o) { o.order = 3; }),
            "order is 3: it must be 1 or 2");
  EXPECT_EQ(refused(1, 2, [](FaceMatchOptions& o) { o.max_move_mm = -1; }),
            "largest move is -1 mm: it must be zero or larger");
  EXPECT_EQ(refused(1, 2, [](FaceMatchOptions& o) { o.match_mm = std::nan(""); }),
            "distance to match is nan mm: it must be zero or larger");
  EXPECT_EQ(refused(1, 2, [](FaceMatchOptions& o) { o.edge = -2; }),
            "edge is -2: edges count from 1");
  EXPECT_NE(refused(1, 2, [](FaceMatchOptions& o) { o.tolerance.gap_mm = -1; }), "not refused");
  EXPECT_THROW(matchFaces(TopoDS_Shape(), 1, 2), std::invalid_argument);
}

TEST(MatchFaces, ProgressGrowsAndCanStopIt) {
  std::mt19937 generator(testSeed());
  const TopoDS_Shape pair = joinedSheets(disturbedSheets(generator, 0.05));
  std::vector<double> shares;
  matchFaces(pair, 1, 2, {}, [&](double share) {
    shares.push_back(share);
    return true;
  });
  ASSERT_GE(shares.size(), 4);
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_EQ(shares.back(), 1);
  for (const double stop : shares)
    EXPECT_THROW(matchFaces(pair, 1, 2, {}, [&](double share) { return share < stop; }),
                 occ::Cancelled);
}

/// Seams of a model that fall short and are matched at their second face: how many are, and of
/// these how many exactly. Figures of all that are matched are looked at again by plain evaluation.
struct Tally {
  int tried = 0, matched = 0, exact = 0;
};

Tally tallyOf(const std::filesystem::path& path, int order, double max_move_mm, int most) {
  const occ::Model model = occ::readModel(path);
  occ::AnalyzeOptions analyze;
  analyze.level = order == 1 ? Level::G1 : Level::G2;
  Tally tally;
  for (const occ::SeamResult& seam : occ::analyze(model, analyze).seams) {
    if (seam.verdict.seam_class != SeamClass::Defect || seam.kind != occ::SeamKind::Shared)
      continue;
    FaceMatchOptions options = ofOrder(order);
    options.edge = seam.edges[0];
    options.max_move_mm = max_move_mm;
    if (tally.tried == most) break;
    const MatchReport report = matchFaces(model.shape, seam.faces[0], seam.faces[1], options);
    ++tally.tried;
    EXPECT_FALSE(report.text().empty());
    if (!report.matched) continue;
    ++tally.matched;
    tally.exact += report.exact ? 1 : 0;
    EXPECT_LE(report.largest_move_mm, max_move_mm);
    expectMatched(report, options,
                  path.filename().string() + " edge " + std::to_string(seam.edges[0]));
  }
  return tally;
}

TEST(MatchFaces, SeamsOfModelsFromOtherHandsAreMatched) {
  struct Case {
    const char* name;
    int order;
    double max_move_mm;
    int most, matched, exact;
  };
  const Case cases[] = {{"occ/hammer.brep", 1, 100, 15, 7, 5},
                        {"step/linkrods.step", 1, 1, 4, 1, 0}};
  for (const Case& each : cases) {
    const Tally tally = tallyOf(occtModel(each.name), each.order, each.max_move_mm, each.most);
    EXPECT_GE(tally.matched, each.matched) << each.name;
    EXPECT_GE(tally.exact, each.exact) << each.name;
  }
}

}  // namespace
}  // namespace seamwright::test
