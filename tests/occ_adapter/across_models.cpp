// SPDX-License-Identifier: LGPL-2.1-or-later
#include "across_models.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>

namespace seamwright::test {

namespace {

TopoDS_Wire turned(const TopoDS_Wire& wire, double turn_rad) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(), gp_Dir(0, 0, 1)), turn_rad);
  return TopoDS::Wire(BRepBuilderAPI_Transform(wire, turn, true).Shape());
}

TopoDS_Edge arc(const gp_Pnt& centre, double radius_mm, double begin_rad, double end_rad) {
  return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(centre, gp_Dir(0, 0, 1)), radius_mm), begin_rad,
                                 end_rad);
}

}  // namespace

TopoDS_Shape bentPlate() {
  constexpr double radius_mm = 200, half_mm = 50;
  const auto onArc = [](double along_mm) {
    const double angle = along_mm / radius_mm;
    return gp_Pnt(radius_mm * std::sin(angle), -40, radius_mm * (std::cos(angle) - 1));
  };
  BRepBuilderAPI_MakeWire profile;
  profile.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(-half_mm, -40, 0), gp_Pnt(0, -40, 0)));
  profile.Add(BRepBuilderAPI_MakeEdge(
      GC_MakeArcOfCircle(gp_Pnt(0, -40, 0), onArc(half_mm / 2), onArc(half_mm)).Value()));
  return BRepPrimAPI_MakePrism(profile.Wire(), gp_Vec(0, 80, 0)).Shape();
}

TopoDS_Shape quarteredSheet() {
  constexpr int count = 13;
  TColgp_Array2OfPnt points(1, count, 1, count);
  for (int i = 1; i <= count; ++i)
    for (int j = 1; j <= count; ++j) {
      const double x = -50 + 100.0 * (i - 1) / (count - 1), y = -40 + 80.0 * (j - 1) / (count - 1);
      points(i, j) = gp_Pnt(x, y, 5 * std::sin(x / 40) * std::cos(y / 50) + 0.002 * x * y);
    }
  const opencascade::handle<Geom_BSplineSurface> whole =
      GeomAPI_PointsToBSplineSurface(points, 3, 5, GeomAbs_C2, 1e-3).Surface();
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  whole->Bounds(u0, u1, v0, v1);
  const double u[] = {u0, (u0 + u1) / 2, u1}, v[] = {v0, (v0 + v1) / 2, v1};
  BRepBuilderAPI_Sewing sewing(1e-5);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const auto quarter = opencascade::handle<Geom_BSplineSurface>::DownCast(whole->Copy());
      quarter->Segment(u[i], u[i + 1], v[j], v[j + 1]);
      sewing.Add(BRepBuilderAPI_MakeFace(quarter, 1e-7).Face());
    }
  sewing.Perform();
  return sewing.SewedShape();
}

TopoDS_Wire roundedRectangle(double length_mm, double width_mm, double radius_mm, double turn_rad) {
  const double x = length_mm / 2, y = width_mm / 2, r = radius_mm;
  BRepBuilderAPI_MakeWire wire;
  const auto line = [&](double ax, double ay, double bx, double by) {
    if (std::hypot(bx - ax, by - ay) > 1e-9)
      wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(ax, ay, 0), gp_Pnt(bx, by, 0)));
  };
  line(-x + r, -y, x - r, -y);
  wire.Add(arc({x - r, -y + r, 0}, r, -M_PI / 2, 0));
  line(x, -y + r, x, y - r);
  wire.Add(arc({x - r, y - r, 0}, r, 0, M_PI / 2));
  line(x - r, y, -x + r, y);
  wire.Add(arc({-x + r, y - r, 0}, r, M_PI / 2, M_PI));
  line(-x, y - r, -x, -y + r);
  wire.Add(arc({-x + r, -y + r, 0}, r, M_PI, 3 * M_PI / 2));
  return turned(wire.Wire(), turn_rad);
}

TopoDS_Wire ellipse(double length_mm, double width_mm, double turn_rad) {
  const gp_Elips outline(gp_Ax2(gp_Pnt(), gp_Dir(0, 0, 1)), length_mm / 2, width_mm / 2);
  return turned(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(outline)).Wire(), turn_rad);
}

TopoDS_Wire halfDisc(double radius_mm, double turn_rad) {
  BRepBuilderAPI_MakeWire wire;
  wire.Add(arc(gp_Pnt(), radius_mm, -M_PI / 2, M_PI / 2));
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, radius_mm, 0), gp_Pnt(0, -radius_mm, 0)));
  return turned(wire.Wire(), turn_rad);
}

TopoDS_Wire elbow(double size_mm, double turn_rad) {
  BRepBuilderAPI_MakePolygon wire;
  const double s = size_mm / 2;
  for (const auto& [x, y] : {std::pair{-s, -s}, {s, -s}, {s, 0.0}, {0.0, 0.0}, {0.0, s}, {-s, s}})
    wire.Add(gp_Pnt(x, y, 0));
  wire.Close();
  return turned(wire.Wire(), turn_rad);
}

TopoDS_Shape cutThrough(const TopoDS_Shape& sheet, const TopoDS_Wire& outline) {
  gp_Trsf down;
  down.SetTranslation(gp_Vec(0, 0, -50));
  const TopoDS_Shape base =
      BRepBuilderAPI_Transform(BRepBuilderAPI_MakeFace(outline).Face(), down).Shape();
  return BRepAlgoAPI_Cut(sheet, BRepPrimAPI_MakePrism(base, gp_Vec(0, 0, 100)).Shape()).Shape();
}

}  // namespace seamwright::test
