// SPDX-License-Identifier: LGPL-2.1-or-later
// Seams of faces that share no edge. What is expected is known in closed form.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <limits>
#include <numbers>

#include "matched_seams.hpp"
#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::findSeams;
using occ::matchFreeEdges;
using occ::Report;
using occ::Seam;
using occ::SeamGraph;
using occ::SeamKind;
using occ::SeamResult;
using std::numbers::pi;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pointwise;
using ::testing::SizeIs;

opencascade::handle<Geom_BezierSurface> bezier(const std::vector<std::vector<gp_Pnt>>& rows) {
  const int n = static_cast<int>(rows.size()), m = static_cast<int>(rows[0].size());
  NCollection_Array2<gp_Pnt> poles(1, n, 1, m);
  for (int i = 1; i <= n; ++i)
    for (int j = 1; j <= m; ++j) poles(i, j) = rows[i - 1][j - 1];
  return new Geom_BezierSurface(poles);
}

/// A plate of which y is quadratic in v, slow at first; v runs down if asked.
opencascade::handle<Geom_BezierSurface> unevenSurface(double x0, double x1, double y0, double y1,
                                                      double z, bool down) {
  std::vector<std::vector<gp_Pnt>> rows;
  for (const double x : {x0, x1}) {
    rows.emplace_back();
    for (const double share : {0.0, 0.1, 1.0})
      rows.back().emplace_back(x, down ? y1 + share * (y0 - y1) : y0 + share * (y1 - y0), z);
  }
  return bezier(rows);
}

TopoDS_Shape unevenPlate(double x0, double x1, double y0, double y1, double z = 0,
                         bool down = false) {
  return BRepBuilderAPI_MakeFace(unevenSurface(x0, x1, y0, y1, z, down), 1e-7).Shape();
}

/// Turned about the line x = 0, z = height, which is the border of most plates here.
TopoDS_Shape turnedAboutY(const TopoDS_Shape& shape, double angle, double height = 0) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, height), gp::DY()), angle);
  return transformed(shape, turn);
}

/// What an enclosure may leave open of a gap of zero: a hundredth of the tolerance.
const double no_gap_mm = 0.01 * ContinuityTolerance().gap_mm;

/// The point at a parameter of a side, from the edge's curve in space.
gp_Pnt pointAt(const occ::Coedge& side, double parameter) {
  const BRepAdaptor_Curve curve(side.edge);
  return curve.Value(curve.FirstParameter() +
                     parameter * (curve.LastParameter() - curve.FirstParameter()));
}

/// What every correspondence promises; \p along is the largest distance along the seam of the
/// points halfway between knots.
void expectCorrespondenceLaws(const Seam& seam, double along) {
  const occ::Correspondence& map = seam.correspondence;
  ASSERT_GE(map.s.size(), 2u);
  ASSERT_EQ(map.a.size(), map.s.size());
  ASSERT_EQ(map.b.size(), map.s.size());
  EXPECT_EQ(map.s.front(), 0);
  EXPECT_EQ(map.s.back(), 1);
  const double sense = map.b.back() > map.b.front() ? 1 : -1;
  for (std::size_t i = 1; i < map.s.size(); ++i) {
    EXPECT_GT(map.s[i], map.s[i - 1]);
    EXPECT_GT(map.a[i], map.a[i - 1]);
    EXPECT_GE(sense * map.b[i], sense * map.b[i - 1]);
    const gp_Pnt on_a = pointAt(seam.sides[0], 0.5 * (map.a[i] + map.a[i - 1]));
    const gp_Pnt on_b = pointAt(seam.sides[1], 0.5 * (map.b[i] + map.b[i - 1]));
    const gp_Vec direction(pointAt(seam.sides[0], map.a[i - 1]), pointAt(seam.sides[0], map.a[i]));
    EXPECT_LT(std::abs(gp_Vec(on_a, on_b).Dot(direction.Normalized())), along) << "piece " << i;
  }
}

TEST(Match, TwoPlatesWithDifferentParametrisations) {
  const double tilt = 3 * degree, lift = 0.004;
  for (const bool down : {false, true}) {
    const TopoDS_Shape shape = compoundOf(
        {plate(-10, 0, 0, 20), turnedAboutY(unevenPlate(0, 10, 0, 20, lift, down), tilt, lift)});
    const Report report = analyzedMatched(shape);
    ASSERT_THAT(report.seams, SizeIs(1));
    const SeamResult& seam = report.seams[0];
    EXPECT_EQ(seam.kind, SeamKind::Matched);
    EXPECT_THAT(seam.edges, SizeIs(2));
    EXPECT_THAT(seam.faces, ElementsAre(1, 2));
    EXPECT_NEAR(seam.length_mm, 20, 1e-9);
    expectEncloses(seam.figures.gap_mm, lift, report.tolerance.gap_mm, 1e-12);
    EXPECT_TRUE(seam.figures.certified && seam.verdict.certain);
    EXPECT_NEAR(angleDeg(seam), 3, 1e-9);
    EXPECT_EQ(seam.verdict.level, Level::G0);
    EXPECT_FALSE(seam.figures.fold_at);
    EXPECT_EQ(seam.note, "");
    EXPECT_THAT(report.open, SizeIs(6));
  }
}

TEST(Match, PointsThatCorrespondAreBesideOneAnother) {
  for (const bool down : {false, true}) {
    const SeamGraph graph =
        matched(compoundOf({unevenPlate(-10, 0, 0, 20), unevenPlate(0, 10, 0, 20, 0.003, !down)}));
    ASSERT_THAT(graph.seams, SizeIs(1));
    expectCorrespondenceLaws(graph.seams[0], 1e-4);  // 1 % of the gap of 0.01 mm that is asked for
    const occ::Correspondence& map = graph.seams[0].correspondence;
    for (std::size_t i = 0; i < map.s.size(); ++i) {
      const gp_Pnt on_a = pointAt(graph.seams[0].sides[0], map.a[i]);
      EXPECT_NEAR(std::abs(on_a.Y() - pointAt(graph.seams[0].sides[0], map.a[0]).Y()),
                  20 * map.s[i], 1e-6);
      EXPECT_NEAR(pointAt(graph.seams[0].sides[1], map.b[i]).Y(), on_a.Y(), 1e-9);
    }
  }
}

TEST(Match, FoldedPlatesAreToldFromFlatOnes) {
  for (const bool down : {false, true}) {
    const Report flat =
        analyzedMatched(compoundOf({plate(-10, 0, 0, 20), unevenPlate(0, 10, 0, 20, 0, down)}));
    ASSERT_THAT(flat.seams, SizeIs(1));
    EXPECT_EQ(flat.seams[0].verdict.seam_class, SeamClass::Smooth);
    // The second plate turned on top of the first.
    const Report folded = analyzedMatched(
        compoundOf({plate(-10, 0, 0, 20), turnedAboutY(unevenPlate(0, 8, 0, 20, 0, down), -pi)}));
    std::vector<SeamResult> along_y;
    for (const SeamResult& seam : folded.seams)
      if (std::abs(seam.length_mm - 20) < 1e-6) along_y.push_back(seam);
    ASSERT_THAT(along_y, SizeIs(1));
    EXPECT_TRUE(along_y[0].figures.fold_at);
    EXPECT_NE(along_y[0].verdict.seam_class, SeamClass::Smooth);
  }
}

TEST(Match, OneLongEdgeMeetsThreeShortOnes) {
  const TopoDS_Shape shape =
      compoundOf({plate(0, 5, 0, 7), plate(-10, 0, 0, 20), unevenPlate(0, 5, 7, 12),
                  unevenPlate(0, 5, 12, 20, 0, true)});
  const Report report = analyzedMatched(shape);
  // Three at the long edge, two between the short plates.
  EXPECT_THAT(lengths(report), Pointwise(DoubleNear(1e-6), {5.0, 5.0, 5.0, 7.0, 8.0}));
  for (const SeamResult& seam : report.seams)
    expectEncloses(seam.figures.gap_mm, 0, report.tolerance.gap_mm, no_gap_mm);
  EXPECT_THAT(report.open, SizeIs(8));
  EXPECT_THAT(report.non_manifold, IsEmpty());
}

TEST(Match, EdgesThatOverlapInPartStayOpen) {
  const Report report =
      analyzedMatched(compoundOf({plate(-10, 0, 0, 20), unevenPlate(0, 5, 4, 30)}));
  EXPECT_THAT(lengths(report), Pointwise(DoubleNear(1e-6), {16.0}));
  EXPECT_THAT(report.open, SizeIs(8));
}

TEST(Match, AWedgeIsMatchedAsFarAsItIsNarrowEnough) {
  const double wedge = 0.003, match_mm = 0.02;
  gp_Trsf turn;
  turn.SetRotation(gp::OZ(), -wedge);
  const TopoDS_Shape turned = transformed(unevenPlate(0, 10, 0, 20), turn);
  const Report report = analyzedMatched(compoundOf({plate(-10, 0, 0, 20), turned}), match_mm);
  ASSERT_THAT(report.seams, SizeIs(1));
  // The point at t of the first is t sin(wedge) from the line of the second.
  EXPECT_NEAR(report.seams[0].length_mm, match_mm / std::sin(wedge), 1e-6);
  EXPECT_NEAR(gap(report.seams[0]), match_mm, 1e-9);
  EXPECT_THAT(report.open, SizeIs(8));
}

TEST(Match, EdgesFurtherApartAreLeftAlone) {
  const Report report =
      analyzedMatched(compoundOf({plate(-10, 0, 0, 20), plate(0.0101, 10, 0, 20)}));
  EXPECT_THAT(report.seams, IsEmpty());
  EXPECT_THAT(report.open, SizeIs(8));
}

TEST(Match, AnEdgeThatTurnsAwayIsLeftAtTheTurn) {
  const double y = 12, away = 60 * degree;
  const gp_Pnt start(0, 0, 0), turn(0, y, 0), end(8 * std::sin(away), y + 8 * std::cos(away), 0);
  NCollection_Array1<gp_Pnt> poles(1, 3);
  poles(1) = start, poles(2) = turn, poles(3) = end;
  NCollection_Array1<double> knots(1, 3);
  knots(1) = 0, knots(2) = 1, knots(3) = 2;
  NCollection_Array1<int> multiplicities(1, 3);
  multiplicities(1) = 2, multiplicities(2) = 1, multiplicities(3) = 2;
  const opencascade::handle<Geom_Curve> bent =
      new Geom_BSplineCurve(poles, knots, multiplicities, 1);
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(bent);
  BRepBuilderAPI_MakeWire wire(edge);
  wire.Add(BRepBuilderAPI_MakeEdge(end, gp_Pnt(20, 0, 0)).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(20, 0, 0), start).Edge());
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(gp_Pln(), wire.Wire()).Shape();
  EXPECT_THAT(lengths(analyzedMatched(compoundOf({plate(-10, 0, 0, 20), face}), 0.5)),
              Pointwise(DoubleNear(1e-6), {y}));
}

TEST(Match, EdgesThatMeetOnlyAtACornerAreNoSeam) {
  const gp_Pnt corner(0, 0, 0);
  for (const double between : {15.0, 30.0, 60.0, 90.0}) {
    const double phi = between * degree;
    const gp_Pnt next(20 * std::cos(phi), 20 * std::sin(phi), 0);
    const TopoDS_Shape below =
        BRepBuilderAPI_MakeFace(
            BRepBuilderAPI_MakePolygon(corner, gp_Pnt(5, -9, 0), gp_Pnt(20, 0, 0), true).Wire())
            .Shape();
    const TopoDS_Shape above =
        BRepBuilderAPI_MakeFace(
            BRepBuilderAPI_MakePolygon(corner, next, gp_Pnt(-9, 15, 0), true).Wire())
            .Shape();
    for (const double match_mm : {0.01, 100.0})
      EXPECT_THAT(matched(compoundOf({below, above}), match_mm).seams, IsEmpty())
          << between << ' ' << match_mm;
  }
  // Plates that touch only at corners, their edges in a row, overlapping by less than the distance.
  EXPECT_THAT(matched(compoundOf({plate(-10, 0, 0, 10), plate(0, 10, -10, 0.005)})).seams,
              IsEmpty());
}

TopoDS_Shape disc(double radius, double z, double start, const gp_Dir& axis = gp::DZ()) {
  const gp_Ax2 axes(gp_Pnt(0, 0, z), axis, gp_Dir(std::cos(start), std::sin(start), 0));
  const TopoDS_Edge circle = BRepBuilderAPI_MakeEdge(gp_Circ(axes, radius));
  return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(circle).Wire(), true).Shape();
}

TopoDS_Shape tube(double radius, double height, double from = 0, double to = 2 * pi) {
  const opencascade::handle<Geom_Surface> surface =
      new Geom_CylindricalSurface(gp_Ax3(gp::XOY()), radius);
  return BRepBuilderAPI_MakeFace(surface, from, to, 0, height, 1e-7).Shape();
}

TEST(Match, ClosedEdgesThatStartElsewhereMakeTwoSeams) {
  const double r = 5, start = 2;
  const TopoDS_Shape splines = BRepBuilderAPI_NurbsConvert(disc(r, 0, start), true).Shape();
  for (const TopoDS_Shape& cap : {disc(r, 0, start), disc(r, 0, start, -gp::DZ()), splines}) {
    const TopoDS_Shape shape = compoundOf({tube(r, 10), cap});
    const Report report = analyzedMatched(shape);
    EXPECT_THAT(lengths(report), Pointwise(DoubleNear(1e-5), {r * start, r * (2 * pi - start)}));
    for (const SeamResult& seam : report.seams) {
      if (seam.kind != SeamKind::Matched) continue;
      EXPECT_LT(gap(seam), no_gap_mm);
      EXPECT_NEAR(angleDeg(seam), 90, 1e-6);
    }
    EXPECT_THAT(report.open, SizeIs(1));
    for (const Seam& seam : matched(shape).seams)
      if (seam.kind == SeamKind::Matched) expectCorrespondenceLaws(seam, 1e-4);
  }
}

TEST(Match, ClosedEdgesAreFollowedUpToTheirStartAlsoFarApart) {
  const Report report = analyzedMatched(compoundOf({tube(6, 10), disc(5, 0, 2)}), 1.1);
  EXPECT_THAT(lengths(report), Pointwise(DoubleNear(1e-6), {6.0 * 2, 6 * (2 * pi - 2)}));
}

TEST(Match, ClosedEdgesThatStartTogetherMakeOneSeam) {
  const Report report =
      analyzedMatched(compoundOf({tube(5, 10), disc(5, 0, 0), disc(5.002, 10, 0)}));
  EXPECT_THAT(lengths(report), Pointwise(DoubleNear(0.02), {10 * pi, 10 * pi}));
  ASSERT_THAT(report.seams, SizeIs(3));
  EXPECT_NEAR(std::max(gap(report.seams[1]), gap(report.seams[2])), 0.002, 1e-9);
  EXPECT_THAT(report.open, IsEmpty());
}

TEST(Match, ATubeThatWasNotSewnMeetsItself) {
  const double r = 5, cleft = 1e-4;
  const Report report = analyzedMatched(tube(r, 10, 0, 2 * pi - cleft));
  ASSERT_THAT(report.seams, SizeIs(1));
  EXPECT_THAT(report.seams[0].faces, ElementsAre(1, 1));
  EXPECT_NEAR(gap(report.seams[0]), 2 * r * std::sin(cleft / 2), 1e-9);
  EXPECT_NEAR(angleDeg(report.seams[0]), cleft / degree, 1e-6);
  EXPECT_FALSE(report.seams[0].figures.fold_at);
}

TEST(Match, ASlitAndANarrowFaceDoNotMeetThemselves) {
  const double w = 0.002;
  BRepBuilderAPI_MakePolygon outline;
  for (const auto& [x, y] : std::vector<std::pair<double, double>>{
           {0, 0}, {20, 0}, {20, 10}, {10 + w, 10}, {10 + w, 2}, {10, 2}, {10, 10}, {0, 10}})
    outline.Add(gp_Pnt(x, y, 0));
  outline.Close();
  EXPECT_THAT(matched(BRepBuilderAPI_MakeFace(outline.Wire()).Shape()).seams, IsEmpty());
  EXPECT_THAT(matched(plate(0, w, 0, 20)).seams, IsEmpty());
}

TEST(Match, AFaceNarrowerThanTheDistanceIsJoinedOnBothSides) {
  const double w = 0.002;
  const TopoDS_Shape narrow = plate(0, w, 0, 20);
  for (const double apart : {0.0, 0.003}) {
    const Report report = analyzedMatched(
        compoundOf({unevenPlate(-10, -apart, 0, 20), narrow, plate(w + apart, 10, 0, 20)}));
    ASSERT_THAT(report.seams, SizeIs(2));
    for (const SeamResult& seam : report.seams) {
      EXPECT_NEAR(seam.length_mm, 20, 1e-6);
      expectEncloses(seam.figures.gap_mm, apart, report.tolerance.gap_mm, no_gap_mm);
      EXPECT_TRUE(seam.faces[0] == 2 || seam.faces[1] == 2);
    }
    EXPECT_THAT(report.non_manifold, IsEmpty());
  }
}

TEST(Match, ThreeFacesAtALineAreNotManifold) {
  const TopoDS_Shape shape = compoundOf({plate(-10, 0, 0, 20), turnedAboutY(plate(0, 10, 0, 20), 1),
                                         turnedAboutY(unevenPlate(0, 10, 0, 20), -0.5)});
  const SeamGraph graph = matched(shape);
  EXPECT_THAT(graph.seams, IsEmpty());
  EXPECT_THAT(graph.open, SizeIs(9));
  ASSERT_THAT(graph.non_manifold, SizeIs(3));
  for (const occ::NonSeamEdge& edge : graph.non_manifold)
    EXPECT_THAT(edge.faces, ElementsAre(1, 2, 3));
}

TEST(Match, AThirdFaceAlongAPartLeavesTheRest) {
  const TopoDS_Shape shape = compoundOf(
      {plate(-10, 0, 0, 20), plate(0, 10, 0, 20), turnedAboutY(unevenPlate(0, 10, 12, 20), -0.5)});
  const Report report = analyzedMatched(shape);
  EXPECT_THAT(lengths(report), Pointwise(DoubleNear(1e-6), {12.0}));
  EXPECT_THAT(report.non_manifold, SizeIs(3));
  // One that is clearly further away takes nothing.
  const TopoDS_Shape off =
      compoundOf({plate(-10, 0, 0, 20), plate(0.001, 10, 0, 20), plate(0.004, 9, 12, 19)});
  EXPECT_THAT(lengths(analyzedMatched(off)), Pointwise(DoubleNear(1e-6), {20.0}));
}

/// Small pieces of a wavy ground, each face with edges of its own.
TopoDS_Shape grid(int n) {
  const auto corner = [](int i, int j) { return gp_Pnt(i, j, 0.3 * std::sin(1.7 * i + 0.6 * j)); };
  std::vector<TopoDS_Shape> faces;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const opencascade::handle<Geom_Surface> surface =
          bezier({{corner(i, j), corner(i, j + 1)}, {corner(i + 1, j), corner(i + 1, j + 1)}});
      faces.push_back(BRepBuilderAPI_MakeFace(surface, 1e-7).Shape());
    }
  return compoundOf(faces);
}

TEST(Match, AGridIsFoundWithWorkInProportionToItsSize) {
  std::mt19937 random(testSeed());
  for (const int n : {8, 16, 32}) {
    SeamGraph graph = findSeams(transformed(grid(n), randomMotion(random)));
    const occ::MatchSummary summary = matchFreeEdges({.match_mm = 0.001}, graph);
    EXPECT_EQ(graph.seams.size(), static_cast<std::size_t>(2 * n * (n - 1)));
    EXPECT_EQ(graph.open.size(), static_cast<std::size_t>(4 * n));
    EXPECT_THAT(graph.non_manifold, IsEmpty());
    EXPECT_EQ(summary.edges, static_cast<std::size_t>(4 * n * n));
    // Eight pieces an edge, each close to three of the other, and a few about the corners.
    EXPECT_LE(summary.close_pieces, 32 * graph.seams.size());
  }
}

TEST(Match, ADistanceLargerThanTheEdgesFindsTheSame) {
  for (const double match_mm : {1e-6, 1.0, 1e6}) {
    const SeamGraph graph = matched(grid(4), match_mm);
    EXPECT_EQ(graph.seams.size(), 24u) << match_mm;
    EXPECT_EQ(graph.open.size(), 16u) << match_mm;
  }
}

/// Plates of several kinds, their lengths, gaps and angles all different.
std::vector<TopoDS_Shape> mixture() {
  return {plate(-10, 0, 0, 20),
          turnedAboutY(unevenPlate(0, 5, 0, 9, 0.002, true), 0.3, 0.002),
          unevenPlate(0.001, 6, 9, 20),
          unevenPlate(-10, 0, 20.003, 31, 0.004),
          tube(3, 40, 0.2, 2 * pi + 0.2),
          disc(3.001, 0, 1.5)};
}

struct Figures {
  double length, gap, angle;
  auto operator<=>(const Figures&) const = default;
};

std::vector<Figures> figures(const TopoDS_Shape& shape) {
  std::vector<Figures> all;
  for (const SeamResult& seam : analyzedMatched(shape).seams)
    all.push_back({seam.length_mm, gap(seam), angleDeg(seam)});
  std::ranges::sort(all);
  return all;
}

TEST(Match, OrderAndPlaceOfTheFacesDoNotMatter) {
  const std::vector<TopoDS_Shape> faces = mixture();
  const std::vector<Figures> expected = figures(compoundOf(faces));
  ASSERT_GE(expected.size(), 6u);
  std::mt19937 random(testSeed());
  for (int trial = 0; trial < 6; ++trial) {
    std::vector<TopoDS_Shape> other = faces;
    std::shuffle(other.begin(), other.end(), random);
    TopoDS_Shape shape = compoundOf(other);
    if (trial % 2 == 1) shape = transformed(shape, randomMotion(random));
    if (trial % 3 == 1) shape = facesSwappedAndReversed(shape);
    const std::vector<Figures> found = figures(shape);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      // An interval is as long on one edge as on the other but for about the gap.
      EXPECT_NEAR(found[i].length, expected[i].length, 0.01);
      EXPECT_NEAR(found[i].gap, expected[i].gap, 1e-6);
      EXPECT_NEAR(found[i].angle, expected[i].angle, 1e-6);
    }
  }
}

TEST(Match, SharedSeamsComeFirstAndStay) {
  const TopoDS_Shape shape =
      compoundOf({plate(-40, -11, 0, 20), planeAndCylinder(10, 10), plate(-50, -40, 0, 20)});
  const SeamGraph before = findSeams(shape), graph = matched(shape);
  ASSERT_EQ(before.seams.size(), 1u);
  ASSERT_EQ(graph.seams.size(), 2u);
  EXPECT_EQ(graph.seams[0].edges, before.seams[0].edges);
  EXPECT_EQ(graph.seams[1].id, 2);
  EXPECT_EQ(graph.open.size(), before.open.size() - 2);
  EXPECT_EQ(graph.open_uses.size(), graph.open.size());
}

TEST(Match, TinyAndDegeneratedEdgesDoNoHarm) {
  const opencascade::handle<Geom_Surface> sphere = new Geom_SphericalSurface(gp_Ax3(gp::XOY()), 5);
  const TopoDS_Shape cap = BRepBuilderAPI_MakeFace(sphere, 0, 2 * pi, 0, pi / 2, 1e-7).Shape();
  const TopoDS_Shape speck = plate(4.99999, 5, 0, 1e-5);
  const Report report = analyzedMatched(compoundOf({cap, disc(5, 0, 0), speck}));
  ASSERT_THAT(lengths(report), SizeIs(1));
  EXPECT_NEAR(lengths(report)[0], 10 * pi, 1e-6);
}

TEST(Match, PointsThatAreNotFiniteAreANote) {
  const opencascade::handle<Geom_BezierSurface> surface = unevenSurface(0, 10, 0, 20, 0, false);
  const TopoDS_Shape broken = BRepBuilderAPI_MakeFace(surface, 1e-7).Shape();
  surface->SetPole(1, 2, gp_Pnt(std::numeric_limits<double>::quiet_NaN(), 0, 0));
  const SeamGraph graph =
      matched(compoundOf({plate(-10, 0, 0, 20), broken, plate(-20, -10, 0, 20)}));
  EXPECT_THAT(graph.seams, SizeIs(1));
  ASSERT_FALSE(graph.notes.empty());
  EXPECT_THAT(graph.notes[0], HasSubstr("face 2 has a surface with the number nan"));
}

TEST(Match, TooFewPiecesAreANote) {
  const TopoDS_Shape shape = compoundOf({plate(-10, 0, 0, 20), unevenPlate(0, 10, 0, 20)});
  SeamGraph fine = findSeams(shape), coarse = fine;
  matchFreeEdges({.match_mm = 0.01, .gap_mm = 1e-3}, fine);
  matchFreeEdges({.match_mm = 0.01, .gap_mm = 1e-3, .most_pieces = 40}, coarse);
  ASSERT_THAT(fine.seams, SizeIs(1));
  ASSERT_THAT(coarse.seams, SizeIs(1));
  EXPECT_EQ(fine.seams[0].note, "");
  EXPECT_THAT(coarse.seams[0].note, HasSubstr("correspond only to"));
  EXPECT_LT(coarse.seams[0].correspondence.s.size(), 100u);
  EXPECT_GT(fine.seams[0].correspondence.s.size(), 200u);
}

TEST(Match, TheDistanceIsChecked) {
  const TopoDS_Shape shape = compoundOf({plate(-1e6, 0, 0, 20), plate(0, 10, 0, 20)});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {-0.01, nan, std::numeric_limits<double>::infinity(), 1e-12})
    EXPECT_THROW(analyzedMatched(shape, bad), std::invalid_argument) << bad;
  EXPECT_THAT(analyzedMatched(shape, 0).seams, IsEmpty());
}

TEST(Match, CanBeCancelled) {
  for (const int at : {0, 1, 2}) {
    SeamGraph graph = findSeams(grid(3));
    int calls = 0;
    EXPECT_THROW(matchFreeEdges({.match_mm = 0.01}, graph, [&](double) { return calls++ != at; }),
                 occ::Cancelled);
  }
}

/// A plate from x = -10 to 0 whose border at x = 0 has a bump: a cubic B-spline of that height and
/// width.
TopoDS_Shape bumpedPlate(double y0, double y1, double bump_at, double height, double width) {
  constexpr int poles = 17;
  TColStd_Array1OfReal knots(1, 15);
  TColStd_Array1OfInteger times(1, 15);
  for (int k = 0; k < 15; ++k) {
    knots(k + 1) = k == 0 ? y0 : k == 14 ? y1 : bump_at + (k - 7) * width / 4;
    times(k + 1) = k == 0 || k == 14 ? 4 : 1;
  }
  const auto pole = [&](int i) {
    double y = 0;  // the Greville abscissa, so that y is the parameter
    for (int j = 1; j <= 3; ++j) y += knots(std::clamp(i + j - 3, 1, 15)) / 3;
    return y;
  };
  TColgp_Array2OfPnt net(1, 2, 1, poles);
  for (int i = 1; i <= poles; ++i) {
    net(1, i) = gp_Pnt(-10, pole(i), 0);
    net(2, i) = gp_Pnt(i == 9 ? 1.5 * height : 0, pole(i), 0);
  }
  TColStd_Array1OfReal ends(1, 2);
  ends(1) = 0;
  ends(2) = 1;
  TColStd_Array1OfInteger twice(1, 2);
  twice.Init(2);
  const opencascade::handle<Geom_BSplineSurface> surface =
      new Geom_BSplineSurface(net, ends, knots, twice, times, 1, 3);
  return BRepBuilderAPI_MakeFace(surface, 1e-7).Shape();
}

TEST(Match, EdgesThatLeaveOneAnotherForAMomentMatchBesideIt) {
  const double match_mm = 0.01, bump_mm = 0.08;
  const Report report = analyzedMatched(
      compoundOf({bumpedPlate(0, 20, 7.03, 0.05, bump_mm), plate(0, 10, 0, 20)}), match_mm);
  ASSERT_THAT(lengths(report), SizeIs(2));
  EXPECT_NEAR(lengths(report)[0], 7.03 - bump_mm / 4, bump_mm / 4);
  EXPECT_NEAR(lengths(report)[1], 20 - 7.03 - bump_mm / 4, bump_mm / 4);
  for (const SeamResult& seam : report.seams) EXPECT_LE(gap(seam), 1.001 * match_mm);
}

}  // namespace
}  // namespace seamwright::test
