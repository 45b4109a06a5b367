// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <cmath>
#include <numbers>

#include "corner_solids.hpp"

namespace seamwright::test {

TopoDS_Shape polyhedron(const std::vector<Eigen::Vector3d>& points,
                        const std::vector<std::vector<int>>& faces) {
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (const std::vector<int>& face : faces) {
    BRepBuilderAPI_MakePolygon polygon;
    for (const int corner : face) {
      const Eigen::Vector3d& p = points[static_cast<std::size_t>(corner)];
      polygon.Add(gp_Pnt(p.x(), p.y(), p.z()));
    }
    polygon.Close();
    sewing.Add(BRepBuilderAPI_MakeFace(polygon.Wire(), true));
  }
  sewing.Perform();
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape()));
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

TopoDS_Shape pyramid(const std::vector<Eigen::Vector3d>& base, const Eigen::Vector3d& apex) {
  std::vector<Eigen::Vector3d> points = base;
  points.push_back(apex);
  const int sides = static_cast<int>(base.size());
  std::vector<std::vector<int>> faces(1);
  for (int k = 0; k < sides; ++k) {
    faces.front().insert(faces.front().begin(), k);
    faces.push_back({k, (k + 1) % sides, sides});
  }
  return polyhedron(points, faces);
}

TopoDS_Shape regularPyramid(int sides, double height) {
  std::vector<Eigen::Vector3d> base;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    base.emplace_back(10 * std::cos(angle), 10 * std::sin(angle), 0);
  }
  return pyramid(base, {0, 0, height});
}

TopoDS_Shape notchedCube() {
  const std::vector<Eigen::Vector3d> points = {
      {0, 0, 0},   {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {0, 0, 10},  {10, 0, 10}, {0, 10, 10},
      {10, 10, 5}, {10, 5, 5}, {5, 10, 5},  {5, 5, 5},  {10, 5, 10}, {5, 10, 10}, {5, 5, 10}};
  return polyhedron(points, {{0, 3, 2, 1},
                             {0, 1, 5, 4},
                             {0, 4, 6, 3},
                             {1, 2, 7, 8, 11, 5},
                             {3, 6, 12, 9, 7, 2},
                             {4, 5, 11, 13, 12, 6},
                             {7, 9, 10, 8},
                             {8, 10, 13, 11},
                             {9, 12, 13, 10}});
}

TopoDS_Shape linesAsSplines(const TopoDS_Shape& shape) {
  const TopoDS_Shape copy = BRepBuilderAPI_Copy(shape).Shape();
  for (TopExp_Explorer edges(copy, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
    if (BRepAdaptor_Curve(edge).GetType() != GeomAbs_Line) continue;
    double first = 0, last = 0;
    const opencascade::handle<Geom_Curve> line = BRep_Tool::Curve(edge, first, last);
    BRep_Builder().UpdateEdge(
        edge, GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(line, first, last)),
        BRep_Tool::Tolerance(edge));
  }
  return copy;
}

int vertexAt(const TopoDS_Shape& shape, const Eigen::Vector3d& point) {
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
  for (int number = 1; number <= vertices.Extent(); ++number)
    if (BRep_Tool::Pnt(TopoDS::Vertex(vertices(number)))
            .Distance(gp_Pnt(point.x(), point.y(), point.z())) < 1e-9)
      return number;
  return 0;
}

double volume_mm3(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-9);
  return properties.Mass();
}

}  // namespace seamwright::test
