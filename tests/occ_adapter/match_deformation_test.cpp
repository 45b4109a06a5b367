// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRep_Tool.hxx>
#include <Geom_CylindricalSurface.hxx>

#include "match_pairs.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

TEST(MatchFaces, AStripFollowsATrimmedFace) {
  std::mt19937 generator(testSeed());
  for (const Trimmed& kind : trimmedKinds())
    for (const int order : {1, 2}) {
      const TopoDS_Shape pair =
          loose(trimmedFace(kind.surface, kind.path, kind.into),
                wholeFace(stripBeside(kind.surface, kind.path, kind.away, 9, generator, 0.01)));
      const MatchReport report =
          matchedPair(pair, ofOrder(order), kind.name + " G" + std::to_string(order));
      EXPECT_FALSE(report.exact);
      EXPECT_EQ(report.before.kind, occ::SeamKind::Matched);
    }
}

TEST(MatchFaces, SidesOfAFollowerAreHeld) {
  std::mt19937 generator(testSeed());
  const handle<Geom_Surface> cylinder = new Geom_CylindricalSurface(gp::XOY(), 30);
  const handle<Geom2d_BSplineCurve> line = curvedPath({{0.1, 5}, {1.2, 5}});
  const Spline strip = stripBeside(cylinder, line, gp_Vec2d(0, 8), 7, generator, 0);
  for (int i = 1; i <= 3; ++i)
    for (int j = 2; j < strip->NbVPoles(); ++j)
      strip->SetPole(i, j,
                     strip->Pole(i, j).Translated(
                         gp_Vec(random(generator, 0.03), 0, random(generator, 0.03))));
  const TopoDS_Shape pair = loose(trimmedFace(cylinder, line, gp_Vec2d(0, -10)), wholeFace(strip));
  FaceMatchOptions options;
  options.hold_sides = true;
  options.tolerance.angle_rad = 0.02 * degree;
  for (const int order : {1, 2}) {
    options.order = order;
    const MatchReport report = matchedPair(pair, options, "held");
    const Spline after = Spline::DownCast(BRep_Tool::Surface(face(report.shape, 2)));
    for (double u = 0; u <= 1; u += 0.01)
      for (const double v : {0.0, 1.0}) {
        EXPECT_LT(strip->Value(u, v).Distance(after->Value(u, v)), 1e-11);
      }
  }
  // A side that leaves the cylinder's line with another curvature.
  strip->SetPole(3, 1, strip->Pole(3, 1).Translated(gp_Vec(1, 0.1, 0)));
  const MatchReport refused = matchFaces(
      loose(trimmedFace(cylinder, line, gp_Vec2d(0, -10)), wholeFace(strip)), 1, 2, options);
  EXPECT_FALSE(refused.matched);
  EXPECT_NE(refused.text().find("a side ends with a normal curvature of"), std::string::npos)
      << refused.text();
}

TEST(MatchFaces, RationalSurfacesJoinAndFollow) {
  std::mt19937 generator(testSeed());
  const auto weigh = [&](const Spline& surface) {
    for (int i = 1; i <= surface->NbUPoles(); ++i)
      for (int j = 1; j <= surface->NbVPoles(); ++j)
        surface->SetWeight(i, j, 1 + random(generator, 0.3));
  };
  for (const Trimmed& kind : trimmedKinds())
    for (const int order : {1, 2}) {
      const Spline strip = stripBeside(kind.surface, kind.path, kind.away, 9, generator, 0.01);
      // On the boundary equal weights, so that it stays where it is.
      weigh(strip);
      for (int j = 1; j <= strip->NbVPoles(); ++j) strip->SetWeight(1, j, 1);
      matchedPair(loose(trimmedFace(kind.surface, kind.path, kind.into), wholeFace(strip)),
                  ofOrder(order), "rational " + kind.name);
    }
  for (const int order : {1, 2}) {
    const Spline whole = sheet(generator, 9, 6, 3, 3);
    weigh(whole);
    const std::array<Spline, 2> parts = cutInTwo(whole);
    disturb(parts[1], generator, 3, 0.02);
    EXPECT_TRUE(matchedPair(joinedSheets(parts), ofOrder(order), "rational sheets").exact);
  }
}

TEST(MatchFaces, ACylinderStaysAndIsNotMoved) {
  std::mt19937 generator(testSeed());
  const handle<Geom_Surface> cylinder = new Geom_CylindricalSurface(gp::XOY(), 30);
  const handle<Geom2d_BSplineCurve> line = curvedPath({{0.1, 5}, {1.2, 5}});
  const TopoDS_Shape pair =
      loose(trimmedFace(cylinder, line, gp_Vec2d(0, -10)),
            wholeFace(stripBeside(cylinder, line, gp_Vec2d(0, 8), 7, generator, 0.02)));
  for (const int order : {1, 2}) {
    const MatchReport report = matchedPair(pair, ofOrder(order), "fillet");
    EXPECT_FALSE(report.exact);
    FaceMatchOptions options = ofOrder(order);
    options.moves = MatchMoves::First;
    const MatchReport refused = matchFaces(pair, 1, 2, options);
    EXPECT_FALSE(refused.matched);
    EXPECT_EQ(refused.text(),
              "face 1 is a cylinder, which has no poles to move; face 2 could move");
    options.moves = MatchMoves::Both;
    const MatchReport one = matchedPair(pair, options, "both, of which one stays");
    EXPECT_NE(one.text().find("so it stays"), std::string::npos) << one.text();
  }
}

TEST(MatchFaces, AnotherSpeedAlongTheBoundaryIsFollowed) {
  // The same boundary, run through at another speed by the second surface: y = v against y = v^2 (3
  // - v) / 2 and the like.
  std::mt19937 generator(testSeed());
  TColgp_Array2OfPnt poles_a(1, 4, 1, 4), poles_b(1, 4, 1, 4);
  const double slow[] = {0, 4, 20, 30}, even[] = {0, 10, 20, 30};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      poles_a(i + 1, j + 1) = gp_Pnt(10.0 * i - 30, even[j], 0.3 * (i - 3) * (i - 3));
      poles_b(i + 1, j + 1) =
          gp_Pnt(10.0 * i, slow[j], (i == 0 ? 0 : 0.2 * i * j) + random(generator, 0.01));
    }
  const Spline a = splineOf(poles_a, 3, 3), b = splineOf(poles_b, 3, 3);
  for (const int order : {1, 2})
    for (int turns = 0; turns < 4; ++turns) {
      const Spline turned_a = Spline::DownCast(a->Copy()), turned_b = Spline::DownCast(b->Copy());
      if (turns & 1) turned_a->VReverse();
      if (turns & 2) turned_b->VReverse();
      const MatchReport report = matchedPair(loose(wholeFace(turned_a), wholeFace(turned_b)),
                                             ofOrder(order), "speed " + std::to_string(turns));
      EXPECT_LT(report.largest_move_mm, 4) << report.text();
    }
}

TEST(MatchFaces, ATriangularFaceKeepsItsCorner) {
  std::mt19937 generator(testSeed());
  std::array<Spline, 2> parts = cutInTwo(sheet(generator, 9, 6, 3, 3));
  disturb(parts[1], generator, 3, 0.02);
  const gp_Pnt corner = parts[1]->Pole(1, 1);
  for (int i = 1; i <= parts[1]->NbUPoles(); ++i) parts[1]->SetPole(i, 1, corner);
  const MatchReport report = matchFaces(joinedSheets(parts), 1, 2);
  ASSERT_TRUE(report.matched) << report.text();
  EXPECT_NE(report.text().find("face 2 ends in a point at the seam"), std::string::npos)
      << report.text();
  const Spline after = Spline::DownCast(BRep_Tool::Surface(face(report.shape, 2)));
  for (double u = 0.4; u <= 1; u += 0.1)
    EXPECT_LT(after->Value(u, 0).Distance(after->Value(0.4, 0)), 1e-9);
}

}  // namespace
}  // namespace seamwright::test
