// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Circle.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Ax2.hxx>
#include <numbers>
#include <stdexcept>

#include "match_pairs.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

TEST(MatchFaces, SheetsThatWereOneAreJoinedInPolesOnAllSides) {
  std::mt19937 generator(testSeed());
  const double noises[] = {0.001, 0.01, 0.1};
  for (int side_a = 0; side_a < 4; ++side_a)
    for (int side_b = 0; side_b < 4; ++side_b) {
      const int order = 1 + (side_a + side_b) % 2, degree_v = 3 + side_b % 2;
      std::array<Spline, 2> parts =
          cutInTwo(sheet(generator, 9, 4 + 2 * side_a, 5, std::min(degree_v, 3 + 2 * side_a)));
      disturb(parts[1], generator, 3, noises[(side_a + 2 * side_b) % 3]);
      const std::string what =
          std::to_string(side_a) + "-" + std::to_string(side_b) + " G" + std::to_string(order);
      const MatchReport report =
          matchedPair(joinedSheets(parts, side_a, side_b), strict(order), what);
      EXPECT_TRUE(report.exact) << what << report.text();
    }
}

/// A point in the middle of a face and its normal out of it.
std::pair<gp_Pnt, gp_Vec> middle(const TopoDS_Face& face) {
  const handle<Geom_Surface> surface = BRep_Tool::Surface(face);
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface->Bounds(u0, u1, v0, v1);
  gp_Pnt p;
  gp_Vec u, v;
  surface->D1((u0 + u1) / 2, (v0 + v1) / 2, p, u, v);
  const gp_Vec normal = u.Crossed(v).Normalized();
  return {p, face.Orientation() == TopAbs_REVERSED ? -normal : normal};
}

TEST(MatchFaces, PlacedMirroredAndReversedFacesKeepTheirSense) {
  std::mt19937 generator(testSeed());
  gp_Trsf mirror, scale;
  mirror.SetMirror(gp_Ax2(gp_Pnt(3, 4, 5), gp_Dir(1, 2, 3)));
  scale.SetScale(gp_Pnt(1, 1, 1), 0.5);
  for (int order = 1; order <= 2; ++order)
    for (int k = 0; k < 4; ++k) {
      const std::array<gp_Trsf, 4> by = {randomMotion(generator), mirror * randomMotion(generator),
                                         scale * mirror, randomMotion(generator)};
      TopoDS_Shape pair = located(joinedSheets(disturbedSheets(generator, 0.02)), by[k]);
      if (k == 3) pair = facesSwappedAndReversed(pair);
      const std::string what = std::to_string(k) + " G" + std::to_string(order);
      const MatchReport report = matchedPair(pair, ofOrder(order), what);
      for (int number = 1; number <= 2; ++number) {
        const auto [before, out_before] = middle(face(pair, number));
        const auto [after, out_after] = middle(face(report.shape, number));
        EXPECT_LT(before.Distance(after), 0.1) << what;
        EXPECT_GT(out_before.Dot(out_after), 0.99) << what;
      }
      EXPECT_LT(middle(face(pair, 1)).first.Distance(middle(face(report.shape, 1)).first), 1e-12)
          << "the first face stays";
    }
}

TEST(MatchFaces, EitherFaceOrBothMove) {
  std::mt19937 generator(testSeed());
  for (const int order : {1, 2}) {
    const TopoDS_Shape pair = joinedSheets(disturbedSheets(generator, 0.05));
    std::array<double, 3> moves{};
    for (const MatchMoves which : {MatchMoves::First, MatchMoves::Second, MatchMoves::Both}) {
      FaceMatchOptions options = ofOrder(order);
      options.moves = which;
      const MatchReport report = matchedPair(pair, options, "both");
      moves[static_cast<std::size_t>(which)] = report.largest_move_mm;
      for (const int number : {1, 2}) {
        const bool stays = which == (number == 1 ? MatchMoves::Second : MatchMoves::First);
        const bool same = BRep_Tool::Surface(face(pair, number)) ==
                          BRep_Tool::Surface(face(report.shape, number));
        EXPECT_EQ(same, stays);
      }
      EXPECT_TRUE(which != MatchMoves::Both || report.exact);
    }
    EXPECT_LT(moves[2], moves[0]);
    EXPECT_LT(moves[2], moves[1]);
  }
}

/// A spline of that degree and number of rows behind the last row of poles of a surface.
Spline behind(const Spline& surface, int rows, int degree_u) {
  TColgp_Array2OfPnt poles(1, rows, 1, 6);
  for (int i = 0; i < rows; ++i)
    for (int j = 1; j <= 6; ++j) {
      const double share = static_cast<double>(i) / (rows - 1);
      poles(i + 1, j) = surface->Pole(surface->NbUPoles(), j)
                            .Translated(gp_Vec(20 * share, share, (1 + 0.1 * j) * share));
    }
  return splineOf(poles, degree_u, 3);
}

TEST(MatchFaces, TheOppositeSideAndWhatLiesBeyondStay) {
  std::mt19937 generator(testSeed());
  struct Net {
    int rows, degree_u;
  };
  for (const int order : {1, 2})
    for (const Net& net : {Net{2, 1}, Net{4, 2}, Net{4, 3}, Net{5, 1}, Net{8, 3}}) {
      std::array<Spline, 2> parts = cutInTwo(sheet(generator, 9, 6, 3, 3));
      parts[1] = behind(parts[0], net.rows, net.degree_u);
      disturb(parts[1], generator, 1, 0.02);
      const MatchReport report = matchedPair(joinedSheets(parts), ofOrder(order), "opposite");
      const Spline after = Spline::DownCast(BRep_Tool::Surface(face(report.shape, 2)));
      ASSERT_FALSE(after.IsNull());
      double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
      after->Bounds(u0, u1, v0, v1);
      for (double v = v0; v <= v1; v += 0.05) {
        gp_Pnt p, q;
        gp_Vec pu, pv, qu, qv;
        parts[1]->D1(u1, v, p, pu, pv);
        after->D1(u1, v, q, qu, qv);
        EXPECT_LT(p.Distance(q), 1e-11);
        EXPECT_LT((pu - qu).Magnitude(), 1e-9);
      }
    }
}

TEST(MatchFaces, SidesThatAreHeldStay) {
  std::mt19937 generator(testSeed());
  FaceMatchOptions options;
  options.hold_sides = true;
  for (const int order : {1, 2}) {
    options.order = order;
    std::array<Spline, 2> parts = cutInTwo(sheet(generator, 9, 7, 3, 3));
    for (int i = 1; i <= 3; ++i)
      for (int j = 2; j <= 6; ++j)
        parts[1]->SetPole(i, j,
                          parts[1]->Pole(i, j).Translated(gp_Vec(0, 0, random(generator, 0.05))));
    const MatchReport report = matchedPair(joinedSheets(parts), options, "held");
    const Spline after = Spline::DownCast(BRep_Tool::Surface(face(report.shape, 2)));
    for (double u = 0.4; u <= 1; u += 0.01)
      for (const double v : {0.0, 1.0}) {
        EXPECT_LT(parts[1]->Value(u, v).Distance(after->Value(u, v)), 1e-11);
      }
  }
  const MatchReport refused =
      matchFaces(joinedSheets(disturbedSheets(generator, 0.09)), 1, 2, options);
  EXPECT_FALSE(refused.matched);
  EXPECT_NE(refused.text().find("a side ends"), std::string::npos) << refused.text();
}

TEST(MatchFaces, ASideInsideItsSurfaceIsCutOffThere) {
  std::mt19937 generator(testSeed());
  const Spline whole = sheet(generator, 9, 6, 3, 3);
  const Spline other = Spline::DownCast(whole->Copy());
  disturb(other, generator, 9, 0.02);
  const handle<Geom_Surface> a(whole.get()), b(other.get());
  const TopoDS_Shape pair =
      withTolerance(joined({a, beginningWith(1, rectangle(0, 0.4, 0.1, 0.9))},
                           {b, beginningWith(3, rectangle(0.4, 0.95, 0.1, 0.9))}),
                    0.3);
  for (const int order : {1, 2}) {
    const MatchReport report = matchedPair(pair, ofOrder(order), "inside");
    EXPECT_TRUE(report.exact) << report.text();
  }
}

/// Two half tubes of spline surfaces that share two edges.
TopoDS_Shape halfTubes(std::mt19937& generator, double noise_mm) {
  const auto half = [&](double from) {
    TColgp_Array2OfPnt poles(1, 7, 1, 4);
    for (int i = 1; i <= 7; ++i)
      for (int j = 1; j <= 4; ++j) {
        const double angle = from + std::numbers::pi * (i - 1) / 6,
                     radius = i == 2 || i == 6 ? 10.4 : 10;
        gp_Pnt pole(radius * std::cos(angle), radius * std::sin(angle), 8.0 * j);
        if (i > 1 && i < 7)
          pole.Translate(gp_Vec(random(generator, noise_mm), random(generator, noise_mm), 0));
        poles(i, j) = pole;
      }
    return splineOf(poles, 3, 3);
  };
  BRepBuilderAPI_Sewing sewing(1e-4);
  sewing.Add(wholeFace(half(0)));
  sewing.Add(wholeFace(half(std::numbers::pi)));
  sewing.Perform();
  return sewing.SewedShape();
}

TEST(MatchFaces, OfSeveralCommonEdgesOneIsTaken) {
  std::mt19937 generator(testSeed());
  const TopoDS_Shape tube = halfTubes(generator, 0.1);
  const MatchReport longest = matchedPair(tube, ofOrder(1), "longest");
  EXPECT_NE(longest.text().find("of the common edges"), std::string::npos) << longest.text();
  const int taken = longest.before.edges.at(0);
  int other = 0;
  for (const occ::SeamResult& seam : analyzed(tube).seams)
    if (seam.edges.at(0) != taken) other = seam.edges.at(0);
  FaceMatchOptions options;
  options.edge = other;
  EXPECT_EQ(matchedPair(tube, options, "other").before.edges, std::vector<int>{other});
  options.edge = 77;
  EXPECT_THROW(matchFaces(tube, 1, 2, options), std::invalid_argument);
}

/// A sheet with a round hole near its first side.
TopoDS_Face sheetWithHole(const Spline& surface) {
  const handle<Geom_Surface> geometry(surface.get());
  const handle<Geom2d_Curve> circle =
      new Geom2d_Circle(gp_Ax2d(gp_Pnt2d(0.47, 0.5), gp_Dir2d(1, 0)), 0.05);
  const TopoDS_Edge edge =
      BRepBuilderAPI_MakeEdge(circle, geometry, 0, 2 * std::numbers::pi).Edge();
  BRepLib::BuildCurve3d(edge);
  BRepBuilderAPI_MakeFace face(wholeFace(surface));
  face.Add(TopoDS::Wire(BRepBuilderAPI_MakeWire(edge).Wire().Reversed()));
  return face.Face();
}

TEST(MatchFaces, TrimmingIsKeptAndItsEdgesFollow) {
  std::mt19937 generator(testSeed());
  for (const int order : {1, 2}) {
    std::array<Spline, 2> parts = cutInTwo(sheet(generator, 9, 6, 3, 3));
    disturb(parts[1], generator, 3, 0.05);
    const TopoDS_Shape pair = loose(wholeFace(parts[0]), sheetWithHole(parts[1]));
    ASSERT_TRUE(BRepCheck_Analyzer(pair).IsValid());
    FaceMatchOptions options = ofOrder(order);
    options.match_mm = 0.3;
    const MatchReport report = matchedPair(pair, options, "hole");
    int wires = 0;
    for (TopExp_Explorer it(face(report.shape, 2), TopAbs_WIRE); it.More(); it.Next()) ++wires;
    EXPECT_EQ(wires, 2);
    for (TopExp_Explorer it(report.shape, TopAbs_EDGE); it.More(); it.Next())
      EXPECT_LT(BRep_Tool::Tolerance(TopoDS::Edge(it.Current())), 2e-5)
          << "curves follow, not tolerances";
    EXPECT_TRUE(report.exact);
    EXPECT_EQ(report.before.kind, occ::SeamKind::Matched);
  }
}

}  // namespace
}  // namespace seamwright::test
