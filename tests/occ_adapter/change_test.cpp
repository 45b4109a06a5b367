// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>
#include <cmath>
#include <stdexcept>

#include "match_pairs.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/repair/change.hpp>

namespace seamwright::test {
namespace {

using occ::FaceChange;
using occ::withChanges;

constexpr double gap_mm = 0.01;

Spline splineOfFace(const TopoDS_Shape& shape, int number) {
  TopLoc_Location location;
  const handle<Geom_Surface> surface = BRep_Tool::Surface(face(shape, number), location);
  return occ::clampedSpline(surface, location);
}

/// All spline faces with their surfaces moved.
std::vector<FaceChange> allMoved(const TopoDS_Shape& shape, const gp_Trsf& by) {
  std::vector<FaceChange> changes;
  for (int f = 1; f <= partsOf(shape, TopAbs_FACE).Extent(); ++f) {
    const Spline spline = splineOfFace(shape, f);
    spline->Transform(by);
    changes.push_back({f, handle<Geom_Surface>(spline), 0});
  }
  return changes;
}

void expectSamePoint(const gp_Pnt& a, const gp_Pnt& b, double near_mm) {
  EXPECT_LE(a.Distance(b), near_mm);
}

/// The same parts in the same order, with the same senses; points of vertices, edges and faces near
/// each other.
void expectSameShape(const TopoDS_Shape& a, const TopoDS_Shape& b, double near_mm) {
  for (const TopAbs_ShapeEnum kind :
       {TopAbs_SOLID, TopAbs_SHELL, TopAbs_WIRE, TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
    const TopTools_IndexedMapOfShape of_a = partsOf(a, kind), of_b = partsOf(b, kind);
    ASSERT_EQ(of_a.Extent(), of_b.Extent());
    for (int i = 1; i <= of_a.Extent(); ++i) {
      EXPECT_EQ(of_a(i).Orientation(), of_b(i).Orientation());
      EXPECT_EQ(of_a(i).Closed(), of_b(i).Closed());
      if (kind == TopAbs_VERTEX)
        expectSamePoint(BRep_Tool::Pnt(TopoDS::Vertex(of_a(i))),
                        BRep_Tool::Pnt(TopoDS::Vertex(of_b(i))), near_mm);
      if (kind != TopAbs_EDGE) continue;
      const TopoDS_Edge& on_a = TopoDS::Edge(of_a(i));
      const TopoDS_Edge& on_b = TopoDS::Edge(of_b(i));
      ASSERT_EQ(BRep_Tool::Degenerated(on_a), BRep_Tool::Degenerated(on_b));
      if (BRep_Tool::Degenerated(on_a)) continue;
      double first = 0, last = 0;
      const handle<Geom_Curve> curve_a = BRep_Tool::Curve(on_a, first, last);
      const handle<Geom_Curve> curve_b = BRep_Tool::Curve(on_b, first, last);
      for (int k = 0; k <= 50; ++k) {
        const double t = first + (last - first) * k / 50;
        expectSamePoint(curve_a->Value(t), curve_b->Value(t), near_mm);
      }
    }
  }
}

std::vector<TopoDS_Shape> solidsOfSplines() {
  std::vector<TopoDS_Shape> solids = {
      BRepPrimAPI_MakeBox(30, 20, 10).Shape(), BRepPrimAPI_MakeCylinder(12, 30).Shape(),
      BRepPrimAPI_MakeSphere(15).Shape(), BRepPrimAPI_MakeCone(10, 0, 20).Shape(),
      BRepPrimAPI_MakeTorus(20, 6).Shape()};
  for (TopoDS_Shape& solid : solids) solid = BRepBuilderAPI_NurbsConvert(solid).Shape();
  return solids;
}

gp_Trsf shift(double x, double y, double z) {
  gp_Trsf by;
  by.SetTranslation(gp_Vec(x, y, z));
  return by;
}

// What is known without the code: a solid whose surfaces are all moved alike is the solid moved.
// Periodic faces, faces that meet themselves and degenerated edges are among these.
TEST(Change, SurfacesMovedAlikeGiveTheShapeMoved) {
  std::mt19937 generator(testSeed());
  for (const TopoDS_Shape& solid : solidsOfSplines())
    for (int trial = 0; trial < 4; ++trial) {
      const gp_Trsf by = trial == 0 ? shift(0.3, -0.2, 0.1) : randomMotion(generator);
      const TopoDS_Shape changed = withChanges(solid, allMoved(solid, by), gap_mm);
      EXPECT_TRUE(BRepCheck_Analyzer(changed).IsValid());
      expectTolerancesHold(changed);
      expectSameShape(changed, transformed(solid, by), gap_mm / 100);
      EXPECT_FALSE(changed.IsPartner(solid));
    }
}

TEST(Change, LocationsStay) {
  gp_Trsf mirror, scale;
  mirror.SetMirror(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 2)));
  scale.SetScale(gp_Pnt(3, 0, 1), 1.7);
  std::mt19937 generator(testSeed());
  for (const TopoDS_Shape& solid : solidsOfSplines())
    for (const gp_Trsf& motion : {randomMotion(generator), mirror, scale, mirror * scale}) {
      const TopoDS_Shape placed = located(solid, motion);
      const gp_Trsf by = shift(0.2, 0.3, -0.1);
      const TopoDS_Shape changed = withChanges(placed, allMoved(placed, by), gap_mm);
      EXPECT_TRUE(changed.Location() == placed.Location());
      expectSameShape(changed, located(placed, by), gap_mm / 100);
      EXPECT_EQ(BRepCheck_Analyzer(changed).IsValid(), BRepCheck_Analyzer(placed).IsValid());
    }
}

TopoDS_Shape sheetsAndBox(std::mt19937& generator) {
  BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  builder.Add(compound, joinedSheets(disturbedSheets(generator, 0)));
  builder.Add(compound, BRepPrimAPI_MakeBox(gp_Pnt(200, 0, 0), 30, 20, 10).Shape());
  return compound;
}

TEST(Change, WhatDoesNotDependOnTheFaceIsShared) {
  std::mt19937 generator(testSeed());
  const TopoDS_Shape shape = sheetsAndBox(generator);
  const Spline spline = splineOfFace(shape, 2);
  disturb(spline, generator, 2, 0.05);
  const TopoDS_Shape changed = withChanges(shape, {{2, handle<Geom_Surface>(spline), 0}}, gap_mm);
  EXPECT_TRUE(BRepCheck_Analyzer(changed).IsValid());
  expectTolerancesHold(changed);
  const TopTools_IndexedMapOfShape before = partsOf(shape, TopAbs_FACE),
                                   after = partsOf(changed, TopAbs_FACE);
  ASSERT_EQ(before.Extent(), after.Extent());
  for (int f = 1; f <= before.Extent(); ++f) {
    EXPECT_EQ(after(f).IsPartner(before(f)), f > 2) << f;
    TopLoc_Location location;
    const bool same_surface = BRep_Tool::Surface(TopoDS::Face(after(f)), location) ==
                              BRep_Tool::Surface(TopoDS::Face(before(f)), location);
    EXPECT_EQ(same_surface, f != 2) << f;
  }
  const TopTools_IndexedMapOfShape edges = partsOf(shape, TopAbs_EDGE),
                                   now = partsOf(changed, TopAbs_EDGE);
  const TopTools_IndexedMapOfShape of_second = partsOf(before(2), TopAbs_EDGE),
                                   ends = partsOf(before(2), TopAbs_VERTEX);
  for (int e = 1; e <= edges.Extent(); ++e) {
    bool touches = false;
    for (int v = 1; v <= 2; ++v) {
      const TopTools_IndexedMapOfShape own = partsOf(edges(e), TopAbs_VERTEX);
      if (v <= own.Extent()) touches = touches || ends.Contains(own(v));
    }
    EXPECT_EQ(now(e).IsPartner(edges(e)), !touches) << e;
    double first = 0, last = 0;
    for (int f = 1; f <= 2; ++f) {
      if (!partsOf(before(f), TopAbs_EDGE).Contains(edges(e))) continue;
      EXPECT_EQ(
          BRep_Tool::CurveOnSurface(TopoDS::Edge(now(e)), TopoDS::Face(after(f)), first, last),
          BRep_Tool::CurveOnSurface(TopoDS::Edge(edges(e)), TopoDS::Face(before(f)), first, last));
    }
  }
  // Nothing of the old surface is left behind.
  for (int e = 1; e <= edges.Extent(); ++e)
    if (of_second.Contains(edges(e))) {
      double first = 0, last = 0;
      EXPECT_TRUE(
          BRep_Tool::CurveOnSurface(TopoDS::Edge(now(e)), TopoDS::Face(before(2)), first, last)
              .IsNull());
    }
}

TEST(Change, AnEdgeLiesHalfwayBetweenItsFaces) {
  std::mt19937 generator(testSeed());
  const TopoDS_Shape shape = joinedSheets(disturbedSheets(generator, 0));
  const Spline spline = splineOfFace(shape, 2);
  spline->Transform(shift(0, 0, 0.02));
  const TopoDS_Shape changed =
      withChanges(shape, {{2, handle<Geom_Surface>(spline), 0.02}}, gap_mm);
  const TopTools_IndexedMapOfShape edges = partsOf(shape, TopAbs_EDGE),
                                   now = partsOf(changed, TopAbs_EDGE);
  const TopTools_IndexedMapOfShape of_first = partsOf(face(shape, 1), TopAbs_EDGE);
  const TopTools_IndexedMapOfShape of_second = partsOf(face(shape, 2), TopAbs_EDGE);
  for (int e = 1; e <= edges.Extent(); ++e) {
    const bool on_first = of_first.Contains(edges(e)), on_second = of_second.Contains(edges(e));
    const TopoDS_Edge edge = TopoDS::Edge(now(e)), old = TopoDS::Edge(edges(e));
    double first = 0, last = 0;
    const handle<Geom_Curve> as_was = BRep_Tool::Curve(old, first, last);
    const handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
    const double up = !on_second ? 0 : on_first ? 0.01 : 0.02;
    for (const double share : {0.0, 0.3, 1.0}) {
      const double t = first + share * (last - first);
      EXPECT_NEAR(curve->Value(t).Z() - as_was->Value(t).Z(), up, 1e-6);
    }
    if (on_first && on_second)
      EXPECT_NEAR(BRep_Tool::Tolerance(edge), 1.2 * 0.01, 1e-6);
    else if (on_second)
      EXPECT_LE(BRep_Tool::Tolerance(edge), 1e-6);
    else
      EXPECT_EQ(BRep_Tool::Tolerance(edge), BRep_Tool::Tolerance(old));
  }
}

TEST(Change, ASurfaceThatIsTheSameMovesNothing) {
  std::mt19937 generator(testSeed());
  const TopoDS_Shape shape = sheetsAndBox(generator);
  const TopoDS_Shape changed =
      withChanges(shape, {{1, handle<Geom_Surface>(splineOfFace(shape, 1)), 0}}, gap_mm);
  const TopTools_IndexedMapOfShape vertices = partsOf(shape, TopAbs_VERTEX),
                                   edges = partsOf(shape, TopAbs_EDGE);
  const TopTools_IndexedMapOfShape vertices_now = partsOf(changed, TopAbs_VERTEX),
                                   edges_now = partsOf(changed, TopAbs_EDGE);
  for (int v = 1; v <= vertices.Extent(); ++v) EXPECT_TRUE(vertices_now(v).IsPartner(vertices(v)));
  for (int e = 1; e <= edges.Extent(); ++e) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges_now(e));
    double first = 0, last = 0;
    EXPECT_EQ(BRep_Tool::Curve(edge, first, last),
              BRep_Tool::Curve(TopoDS::Edge(edges(e)), first, last));
    EXPECT_EQ(BRep_Tool::Tolerance(edge), BRep_Tool::Tolerance(TopoDS::Edge(edges(e))));
  }
  EXPECT_TRUE(withChanges(shape, {}, gap_mm).IsEqual(shape));
}

// A plane of a wire in space has no paths of its own; where an edge moves away from it the path it
// had is kept.
TEST(Change, PathsThatOnlyFollowedFromTheCurveAreStored) {
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = 1; i <= 3; ++i)
    for (int j = 1; j <= 3; ++j)
      poles(i, j) = gp_Pnt(10 * (j - 1), 5 * (i - 1), 4 * (i - 1) * (i - 1));
  const Spline spline = splineOf(poles, 2, 2);
  const TopoDS_Face sheet_face = wholeFace(spline);
  TopoDS_Edge common;
  const TopTools_IndexedMapOfShape edges = partsOf(sheet_face, TopAbs_EDGE);
  for (int e = 1; e <= 4; ++e) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(e));
    if (std::abs(BRep_Tool::Pnt(TopExp::FirstVertex(edge)).Y()) +
            std::abs(BRep_Tool::Pnt(TopExp::LastVertex(edge)).Y()) <
        1e-9)
      common = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
  }
  const TopoDS_Vertex from = TopExp::FirstVertex(common), to = TopExp::LastVertex(common);
  const gp_Pnt below(10, -8, 0);
  const TopoDS_Edge side =
      BRepBuilderAPI_MakeEdge(to, BRepBuilderAPI_MakeEdge(BRep_Tool::Pnt(to), below).Vertex2());
  BRepBuilderAPI_MakeWire wire(common, side,
                               BRepBuilderAPI_MakeEdge(TopExp::LastVertex(side), from).Edge());
  const TopoDS_Face plane =
      BRepBuilderAPI_MakeFace(handle<Geom_Plane>(new Geom_Plane(gp::XOY())), wire.Wire(), true);
  double first = 0, last = 0;
  bool is_stored = true;
  BRep_Tool::CurveOnSurface(common, plane, first, last, &is_stored);
  ASSERT_FALSE(is_stored);
  const TopoDS_Shape shape = loose(sheet_face, plane);
  const Spline moved = Spline::DownCast(spline->Copy());
  moved->Transform(shift(0, 0, 0.05));
  const TopoDS_Shape changed = withChanges(shape, {{1, handle<Geom_Surface>(moved), 0.05}}, gap_mm);
  expectTolerancesHold(changed);
  EXPECT_TRUE(BRepCheck_Analyzer(changed).IsValid());
  const int number = partsOf(shape, TopAbs_EDGE).FindIndex(common);
  const TopoDS_Edge edge = TopoDS::Edge(partsOf(changed, TopAbs_EDGE)(number));
  BRep_Tool::CurveOnSurface(edge, face(changed, 2), first, last, &is_stored);
  EXPECT_TRUE(is_stored);
  EXPECT_NEAR(BRep_Tool::Curve(edge, first, last)->Value(first).Z(), 0.025, 1e-9);
}

TEST(Change, RefusesWhatNamesNoFace) {
  std::mt19937 generator(testSeed());
  const TopoDS_Shape shape = sheetsAndBox(generator);
  const handle<Geom_Surface> surface(splineOfFace(shape, 1));
  EXPECT_THROW(withChanges(shape, {{0, surface, 0}}, gap_mm), std::invalid_argument);
  EXPECT_THROW(withChanges(shape, {{9, surface, 0}}, gap_mm), std::invalid_argument);
  EXPECT_THROW(withChanges(shape, {{1, {}, 0}}, gap_mm), std::invalid_argument);
  EXPECT_THROW(withChanges(shape, {{1, surface, 0}, {1, surface, 0}}, gap_mm),
               std::invalid_argument);
  const TopoDS_Shape twice = loose(shape, located(shape, shift(0, 500, 0)));
  EXPECT_THROW(withChanges(twice, {{1, surface, 0}}, gap_mm), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright::test
