// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fill_checks.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>

namespace seamwright::test {

TopoDS_Shape without(const TopoDS_Shape& shape, const std::vector<int>& faces) {
  const opencascade::handle<BRepTools_ReShape> change = new BRepTools_ReShape;
  for (const int face : faces) change->Remove(partsOf(shape, TopAbs_FACE)(face));
  return change->Apply(shape);
}

namespace {

gp_Vec normalAt(const TopoDS_Edge& edge, const TopoDS_Face& face, double share) {
  double first = 0, last = 0;
  const opencascade::handle<Geom2d_Curve> path = BRep_Tool::CurveOnSurface(edge, face, first, last);
  const gp_Pnt2d uv = path->Value(first + share * (last - first));
  gp_Pnt point;
  gp_Vec du, dv;
  BRepAdaptor_Surface(face).D1(uv.X(), uv.Y(), point, du, dv);
  const gp_Vec normal = du.Crossed(dv).Normalized();
  return face.Orientation() == TopAbs_REVERSED ? normal.Reversed() : normal;
}

}  // namespace

double largestAngle_rad(const TopoDS_Shape& shape, const std::vector<int>& faces) {
  const TopTools_IndexedMapOfShape all = partsOf(shape, TopAbs_FACE);
  TopTools_IndexedDataMapOfShapeListOfShape beside;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, beside);
  double largest = 0;
  for (const int face : faces)
    for (TopExp_Explorer edge(all(face), TopAbs_EDGE); edge.More(); edge.Next()) {
      const TopTools_ListOfShape& two = beside.FindFromKey(edge.Current());
      EXPECT_EQ(two.Extent(), 2);
      for (int i = 0; i <= 100; ++i)
        largest = std::max(
            largest, normalAt(TopoDS::Edge(edge.Current()), TopoDS::Face(two.First()), i / 100.0)
                         .Angle(normalAt(TopoDS::Edge(edge.Current()), TopoDS::Face(two.Last()),
                                         i / 100.0)));
    }
  return largest;
}

}  // namespace seamwright::test
