// SPDX-License-Identifier: LGPL-2.1-or-later
// What edges, vertices and flags are after a change of faces beside them.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>
#include <stdexcept>
#include <string>

#include "match_pairs.hpp"

#include <seamwright/occ_adapter/repair/change.hpp>

namespace seamwright::test {
namespace {

using occ::withChanges;

constexpr double gap_mm = 0.01;

/// z = 0 over [x0, x0 + 10] x [0, 10], u and v running with x and y from 0 to 1.
Spline flat(double x0, double z = 0) {
  TColgp_Array2OfPnt poles(1, 2, 1, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) poles(i + 1, j + 1) = gp_Pnt(x0 + 10 * i, 10 * j, z);
  return splineOf(poles, 1, 1);
}

TopoDS_Shape twoFlats() {
  return joinedSheets({flat(0), flat(10)});
}

/// The one with two faces.
int commonEdge(const TopoDS_Shape& shape) {
  const TopTools_IndexedMapOfShape first = partsOf(face(shape, 1), TopAbs_EDGE),
                                   second = partsOf(face(shape, 2), TopAbs_EDGE);
  for (int e = 1; e <= first.Extent(); ++e)
    if (second.Contains(first(e))) return partsOf(shape, TopAbs_EDGE).FindIndex(first(e));
  throw std::logic_error("no common edge");
}

TopoDS_Edge edgeOf(const TopoDS_Shape& shape, int number) {
  return TopoDS::Edge(partsOf(shape, TopAbs_EDGE)(number).Oriented(TopAbs_FORWARD));
}

gp_Pnt middleOf(const TopoDS_Edge& edge) {
  double first = 0, last = 0;
  const handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
  return curve->Value((first + last) / 2);
}

void setTolerance(const TopoDS_Shape& part, double mm) {
  handle<BRep_TEdge>::DownCast(part.TShape())->Tolerance(mm);
}

TEST(ChangeEdges, ANewPathAloneLeadsTheEdge) {
  const TopoDS_Shape shape = twoFlats();
  const int number = commonEdge(shape);
  double first = 0, last = 0;
  const handle<Geom2d_Curve> old =
      BRep_Tool::CurveOnSurface(edgeOf(shape, number), face(shape, 2), first, last);
  const gp_Pnt2d from = old->Value(first), middle = old->Value((first + last) / 2),
                 to = old->Value(last);
  // Into the second face, so the edge is halfway there.
  const handle<Geom2d_BSplineCurve> path =
      curvedPath({from, middle.Translated(gp_Vec2d(0.004, 0)), to});
  TColStd_Array1OfReal knots(1, path->NbKnots());
  for (int k = 1; k <= path->NbKnots(); ++k)
    knots(k) = first + (last - first) * (path->Knot(k) - path->FirstParameter()) /
                           (path->LastParameter() - path->FirstParameter());
  path->SetKnots(knots);
  const TopoDS_Shape changed =
      withChanges(shape, {}, gap_mm, {{number, 2, handle<Geom2d_Curve>(path), 0.04}});
  const TopoDS_Edge edge = edgeOf(changed, number);
  const double into_mm = 10 * path->Value((first + last) / 2).X();
  EXPECT_GT(into_mm, 0.01);
  EXPECT_NEAR(middleOf(edge).X(), 10 + into_mm / 2, 1e-6);
  EXPECT_EQ(BRep_Tool::CurveOnSurface(edge, face(changed, 2), first, last), path);
  EXPECT_NE(BRep_Tool::CurveOnSurface(edge, face(changed, 1), first, last), path);
  expectTolerancesHold(changed);
}

TEST(ChangeEdges, WhatEdgesAreSaidToBeStaysSaid) {
  const BRep_Builder builder;
  const TopoDS_Shape shape = twoFlats();
  const int number = commonEdge(shape);
  builder.Continuity(edgeOf(shape, number), face(shape, 1), face(shape, 2), GeomAbs_C1);
  const TopoDS_Shape changed =
      withChanges(shape, {{2, handle<Geom_Surface>(flat(10, 0.001)), 0.001}}, gap_mm);
  ASSERT_TRUE(
      BRep_Tool::HasContinuity(edgeOf(changed, number), face(changed, 1), face(changed, 2)));
  EXPECT_EQ(BRep_Tool::Continuity(edgeOf(changed, number), face(changed, 1), face(changed, 2)),
            GeomAbs_C1);
  // So is that of a face with itself.
  const TopoDS_Shape tube =
      BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeCylinder(5, 10).Shape()).Shape();
  int closed = 0;
  for (int e = 1; e <= partsOf(tube, TopAbs_EDGE).Extent(); ++e) {
    if (!BRep_Tool::IsClosed(edgeOf(tube, e), face(tube, 1))) continue;
    ++closed;
    builder.Continuity(edgeOf(tube, e), face(tube, 1), face(tube, 1), GeomAbs_C2);
    const auto surface = handle<Geom_Surface>::DownCast(BRep_Tool::Surface(face(tube, 1))->Copy());
    const TopoDS_Shape copied = withChanges(tube, {{1, surface, 0}}, gap_mm);
    ASSERT_TRUE(BRep_Tool::HasContinuity(edgeOf(copied, e), face(copied, 1), face(copied, 1)));
    EXPECT_EQ(BRep_Tool::Continuity(edgeOf(copied, e), face(copied, 1), face(copied, 1)),
              GeomAbs_C2);
  }
  EXPECT_GT(closed, 0);
}

/// Two faces on one surface, which meet at u = 0.5.
TopoDS_Shape halvesOfOne(const Spline& surface) {
  const std::array<gp_Pnt2d, 6> uv = {gp_Pnt2d(0, 0), {0.5, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0, 1}};
  std::array<TopoDS_Vertex, 6> vertices;
  const BRep_Builder builder;
  for (int k = 0; k < 6; ++k)
    builder.MakeVertex(vertices[k], surface->Value(uv[k].X(), uv[k].Y()), 1e-7);
  const auto edge = [&](int a, int b) {
    const gp_Vec2d way(uv[a], uv[b]);
    const handle<Geom2d_Line> line = new Geom2d_Line(uv[a], gp_Dir2d(way));
    TopoDS_Edge made =
        BRepBuilderAPI_MakeEdge(line, surface, vertices[a], vertices[b], 0, way.Magnitude()).Edge();
    BRepLib::BuildCurve3d(made);
    return made;
  };
  const TopoDS_Edge common = edge(1, 4);
  const TopoDS_Wire left =
      BRepBuilderAPI_MakeWire(edge(0, 1), common, edge(4, 5), edge(5, 0)).Wire();
  BRepBuilderAPI_MakeWire right(edge(1, 2), edge(2, 3), edge(3, 4));
  right.Add(TopoDS::Edge(common.Reversed()));
  return loose(BRepBuilderAPI_MakeFace(surface, left, true).Face(),
               BRepBuilderAPI_MakeFace(surface, right.Wire(), true).Face());
}

TEST(ChangeEdges, AFaceOnTheOldSurfaceKeepsItsPaths) {
  const TopoDS_Shape shape = halvesOfOne(flat(0));
  const int number = commonEdge(shape);
  const TopoDS_Shape changed =
      withChanges(shape, {{1, handle<Geom_Surface>(flat(0, 0.002)), 0.002}}, gap_mm);
  TopLoc_Location location;
  EXPECT_EQ(BRep_Tool::Surface(face(changed, 2), location),
            BRep_Tool::Surface(face(shape, 2), location));
  for (const int f : {1, 2}) {
    double first = 0, last = 0;
    bool is_stored = false;
    const handle<Geom2d_Curve> path = BRep_Tool::CurveOnSurface(
        edgeOf(changed, number), face(changed, f), first, last, &is_stored);
    ASSERT_FALSE(path.IsNull()) << f;
    EXPECT_TRUE(is_stored);
  }
  EXPECT_NEAR(middleOf(edgeOf(changed, number)).Z(), 0.001, 1e-9);
}

TEST(ChangeEdges, AnEdgeWithoutACurveGetsOne) {
  const TopoDS_Shape shape = twoFlats();
  const int number = commonEdge(shape);
  BRep_Builder().UpdateEdge(edgeOf(shape, number), handle<Geom_Curve>(), 0.3);
  const TopoDS_Shape changed = withChanges(shape, {{1, handle<Geom_Surface>(flat(0)), 0}}, gap_mm);
  double first = 0, last = 0;
  ASSERT_FALSE(BRep_Tool::Curve(edgeOf(changed, number), first, last).IsNull());
  EXPECT_LT(middleOf(edgeOf(changed, number)).Distance(gp_Pnt(10, 5, 0)), 1e-9);
}

TEST(ChangeEdges, FlagsOfEdgesAreWhatTheyAreNow) {
  const BRep_Builder builder;
  const TopoDS_Shape shape = twoFlats();
  const int number = commonEdge(shape);
  builder.SameRange(edgeOf(shape, number), false);
  builder.SameParameter(edgeOf(shape, number), false);
  const TopoDS_Shape changed =
      withChanges(shape, {{1, handle<Geom_Surface>(flat(0, 0.002)), 0.002}}, gap_mm);
  EXPECT_TRUE(BRep_Tool::SameRange(edgeOf(changed, number)));
  EXPECT_TRUE(BRep_Tool::SameParameter(edgeOf(changed, number)));
}

TEST(ChangeEdges, AToleranceThatWasTooSmallIsMeasured) {
  TopoDS_Shape shape = twoFlats();
  // The second face is 0.005 mm below, and the edge lies on the first one and claims to lie on
  // both.
  shape = withChanges(shape, {{2, handle<Geom_Surface>(flat(10, -0.005)), 0.005}}, 100);
  const int number = commonEdge(shape);
  const double apart_mm = middleOf(edgeOf(shape, number)).Z() + 0.005;
  ASSERT_GT(apart_mm, 0.002);
  setTolerance(edgeOf(shape, number), 1e-7);
  const TopoDS_Shape changed = withChanges(shape, {{1, handle<Geom_Surface>(flat(0)), 0}}, 100);
  EXPECT_NEAR(BRep_Tool::Tolerance(edgeOf(changed, number)), 1.2 * apart_mm, 1e-9);
  expectTolerancesHold(changed);
}

TEST(ChangeEdges, VerticesReachTheirEdgesAndTheEndsOnEachFace) {
  const TopoDS_Shape shape = twoFlats();
  const TopoDS_Shape changed =
      withChanges(shape, {{2, handle<Geom_Surface>(flat(10, 0.02)), 0.02}}, gap_mm);
  for (const int f : {1, 2}) {
    const TopTools_IndexedMapOfShape edges = partsOf(face(changed, f), TopAbs_EDGE);
    for (int e = 1; e <= edges.Extent(); ++e) {
      const TopoDS_Edge edge = TopoDS::Edge(edges(e).Oriented(TopAbs_FORWARD));
      double first = 0, last = 0;
      const handle<Geom2d_Curve> path =
          BRep_Tool::CurveOnSurface(edge, face(changed, f), first, last);
      for (const bool at_first : {true, false}) {
        const TopoDS_Vertex vertex =
            at_first ? TopExp::FirstVertex(edge) : TopExp::LastVertex(edge);
        const gp_Pnt2d uv = path->Value(at_first ? first : last);
        const gp_Pnt end = BRep_Tool::Surface(face(changed, f))->Value(uv.X(), uv.Y());
        EXPECT_LE(end.Distance(BRep_Tool::Pnt(vertex)), BRep_Tool::Tolerance(vertex));
        EXPECT_LE(BRep_Tool::Tolerance(edge), BRep_Tool::Tolerance(vertex));
      }
    }
  }
}

TEST(ChangeEdges, FlagsOfPartsStay) {
  TopoDS_Shape shape = twoFlats();
  for (const bool flag : {false, true}) {
    shape.Convex(flag);
    shape.Infinite(flag);
    shape.Orientable(!flag);
    shape.Closed(flag);
    const TopoDS_Shape changed =
        withChanges(shape, {{2, handle<Geom_Surface>(flat(10, 0.002)), 0.002}}, gap_mm);
    EXPECT_EQ(changed.Convex(), flag);
    EXPECT_EQ(changed.Infinite(), flag);
    EXPECT_EQ(changed.Orientable(), !flag);
    EXPECT_EQ(changed.Closed(), flag);
  }
}

std::string refusalOf(const TopoDS_Shape& shape) {
  try {
    withChanges(shape, {{1, handle<Geom_Surface>(flat(0, 0.02)), 0.02}}, gap_mm);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(ChangeEdges, EdgesAndVerticesWithInstancesStay) {
  const TopoDS_Shape shape = wholeFace(flat(0));
  gp_Trsf away;
  away.SetTranslation(gp_Vec(0, 500, 0));
  for (const TopAbs_ShapeEnum kind : {TopAbs_EDGE, TopAbs_VERTEX}) {
    const std::string why = refusalOf(loose(shape, located(partsOf(shape, kind)(2), away)));
    EXPECT_EQ(why, std::string(kind == TopAbs_EDGE ? "edge" : "vertex") +
                       " 2 stands in the shape 2 times: parts with several instances stay");
  }
  EXPECT_EQ(refusalOf(shape), "");
}

}  // namespace
}  // namespace seamwright::test
