// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <numbers>

#include "corner_solids.hpp"
#include "curved_corners.hpp"

namespace seamwright::test {

using Eigen::Vector3d;

occ::CornerFilletOptions withRadii(const occ::Model& model, int vertex,
                                   const std::vector<double>& radii_mm) {
  occ::CornerFilletOptions options;
  std::size_t k = 0;
  for (const int edge : occ::cornerEdges(model, vertex))
    options.radii_mm[edge] = radii_mm[k++ % radii_mm.size()];
  return options;
}

occ::CornerFillet rounded(const TopoDS_Shape& shape, const Vector3d& corner,
                          const std::vector<double>& radii_mm) {
  const occ::Model model = occ::modelFromShape(shape);
  const int vertex = vertexAt(shape, corner);
  return occ::cornerFillet(model, vertex, withRadii(model, vertex, radii_mm));
}

TopTools_IndexedMapOfShape parts(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return map;
}

TopoDS_Shape native(const TopoDS_Shape& shape, const std::vector<occ::CornerFilletEdge>& edges) {
  const TopTools_IndexedMapOfShape all = parts(shape, TopAbs_EDGE);
  BRepFilletAPI_MakeFillet fillet(shape);
  for (const occ::CornerFilletEdge& edge : edges)
    fillet.Add(edge.radius_mm, TopoDS::Edge(all(edge.edge)));
  fillet.Build();
  return fillet.IsDone() ? fillet.Shape() : TopoDS_Shape();
}

TopoDS_Shape box(double x, double y, double z) {
  return BRepPrimAPI_MakeBox(x, y, z).Shape();
}

TopoDS_Shape ball(double radius) {
  return BRepPrimAPI_MakeSphere(gp_Ax2(gp::Origin(), gp_Dir(1, -1, 0), gp_Dir(-1, -1, -1)), radius)
      .Shape();
}

TopoDS_Shape upright(const gp_Pnt& foot, double radius, double height) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(foot, gp::DZ(), gp_Dir(-1, 0, 0)), radius, height).Shape();
}

TopoDS_Shape wedge(double radius, double height) {
  return BRepPrimAPI_MakeCylinder(radius, height, 1.5).Shape();
}

TopoDS_Shape extrudedQuarterDisc() {
  const gp_Pnt centre(0, 0, 0), right(20, 0, 0), top(0, 20, 0);
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(centre, right));
  wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(right, gp_Pnt(14, 14, 0), top).Value()));
  wire.Add(BRepBuilderAPI_MakeEdge(top, centre));
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Vec(0, 0, 10))
      .Shape();
}

TopoDS_Shape boxLessBall() {
  return BRepAlgoAPI_Cut(box(20, 20, 20), ball(10)).Shape();
}

TopoDS_Shape blockOnCylinder() {
  return BRepAlgoAPI_Fuse(upright({0, 0, 0}, 20, 20),
                          BRepPrimAPI_MakeBox(gp_Pnt(0, -5, 5), gp_Pnt(30, 5, 15)).Shape())
      .Shape();
}

TopoDS_Shape boxWithRoundEdge() {
  const TopoDS_Shape shape = box(20, 20, 10);
  const TopTools_IndexedMapOfShape edges = parts(shape, TopAbs_EDGE);
  BRepFilletAPI_MakeFillet fillet(shape);
  for (int k = 1; k <= edges.Extent(); ++k) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(k));
    const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(edge)),
                 b = BRep_Tool::Pnt(TopExp::LastVertex(edge));
    if (a.X() + b.X() == 40 && a.Y() + b.Y() == 0) fillet.Add(5, edge);
  }
  return fillet.Shape();
}

TopoDS_Shape vault(int gores, double aside_mm) {
  TopoDS_Shape shape = BRepPrimAPI_MakeBox(gp_Pnt(-60, -60, 0), gp_Pnt(60, 60, 60)).Shape();
  for (int k = 0; k < gores; ++k) {
    const double angle = 2 * std::numbers::pi * k / gores;
    const gp_Dir away(std::cos(angle), std::sin(angle), 0),
        along(-std::sin(angle), std::cos(angle), 0);
    const gp_Pnt start = gp::Origin().Translated(gp_Vec(away) * aside_mm - gp_Vec(along) * 80);
    const TopoDS_Shape gore = BRepPrimAPI_MakeCylinder(gp_Ax2(start, along, away), 40, 160).Shape();
    shape = BRepAlgoAPI_Common(shape, gore).Shape();
  }
  return shape;
}

Vector3d apex(double aside_mm) {
  return {0, 0, std::sqrt(1600 - aside_mm * aside_mm)};
}

}  // namespace seamwright::test
