// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes that one surface closes. Areas and volumes are those of the shapes before anything was cut
// out of them.
#include <gmock/gmock.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Elips.hxx>
#include <gp_Pln.hxx>
#include <map>
#include <numbers>

#include "fill_checks.hpp"
#include "shapes.hpp"

#include <seamwright/occ_adapter/fill/fill.hpp>

namespace seamwright::test {
namespace {

using occ::FillHoleReport;
using occ::Hole;
using occ::modelFromShape;

constexpr double low = -30, high = 60;

TopoDS_Shape prismOf(const TopoDS_Wire& wire) {
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire).Face(), gp_Vec(0, 0, high - low))
      .Shape();
}

TopoDS_Shape polygon(const std::vector<std::pair<double, double>>& corners) {
  BRepBuilderAPI_MakePolygon wire;
  for (const auto& [x, y] : corners) wire.Add(gp_Pnt(x, y, low));
  wire.Close();
  return prismOf(wire.Wire());
}

/// Four lines and four arcs: eight smooth joints.
TopoDS_Shape roundedRectangle(double a, double b, double r) {
  BRepBuilderAPI_MakeWire wire;
  const auto point = [](double x, double y) { return gp_Pnt(x, y, low); };
  const double in = r * (1 - std::numbers::sqrt2 / 2);
  wire.Add(BRepBuilderAPI_MakeEdge(point(-a + r, -b), point(a - r, -b)));
  wire.Add(BRepBuilderAPI_MakeEdge(
      GC_MakeArcOfCircle(point(a - r, -b), point(a - in, -b + in), point(a, -b + r)).Value()));
  wire.Add(BRepBuilderAPI_MakeEdge(point(a, -b + r), point(a, b - r)));
  wire.Add(BRepBuilderAPI_MakeEdge(
      GC_MakeArcOfCircle(point(a, b - r), point(a - in, b - in), point(a - r, b)).Value()));
  wire.Add(BRepBuilderAPI_MakeEdge(point(a - r, b), point(-a + r, b)));
  wire.Add(BRepBuilderAPI_MakeEdge(
      GC_MakeArcOfCircle(point(-a + r, b), point(-a + in, b - in), point(-a, b - r)).Value()));
  wire.Add(BRepBuilderAPI_MakeEdge(point(-a, b - r), point(-a, -b + r)));
  wire.Add(BRepBuilderAPI_MakeEdge(
      GC_MakeArcOfCircle(point(-a, -b + r), point(-a + in, -b + in), point(-a + r, -b)).Value()));
  return prismOf(wire.Wire());
}

TopoDS_Shape ellipse(double a, double b) {
  const gp_Elips curve(gp_Ax2(gp_Pnt(0, 0, low), gp::DZ()), a, b);
  return prismOf(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve)));
}

/// Most of a disc and a slit that leads into it.
TopoDS_Shape keyhole(double r, double width, double length) {
  const double x = std::sqrt(r * r - width * width);
  BRepBuilderAPI_MakeWire wire;
  const auto point = [](double at_x, double at_y) { return gp_Pnt(at_x, at_y, low); };
  wire.Add(BRepBuilderAPI_MakeEdge(
      GC_MakeArcOfCircle(point(x, width), point(-r, 0), point(x, -width)).Value()));
  wire.Add(BRepBuilderAPI_MakeEdge(point(x, -width), point(length, -width)));
  wire.Add(BRepBuilderAPI_MakeEdge(point(length, -width), point(length, width)));
  wire.Add(BRepBuilderAPI_MakeEdge(point(length, width), point(x, width)));
  return prismOf(wire.Wire());
}

/// A rounded bar that crosses a tube along y where this angle about y leads.
TopoDS_Shape prismAcross(double turn_rad) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp::Origin(), gp::DY()), std::numbers::pi / 2 - turn_rad);
  const TopoDS_Shape upper =
      BRepAlgoAPI_Cut(roundedRectangle(6, 8, 2),
                      BRepPrimAPI_MakeBox(gp_Pnt(-50, -50, low - 1), gp_Pnt(50, 50, 0)).Shape())
          .Shape();
  return upper.Moved(turn);
}

struct Tool {
  const char* name;
  TopoDS_Shape shape;
};

std::vector<Tool> tools() {
  return {{"RoundedRectangle", roundedRectangle(10, 6, 2)},
          {"NarrowRoundedRectangle", roundedRectangle(10, 3, 1)},
          {"Ellipse", ellipse(12, 3)},
          {"Keyhole", keyhole(6, 2, 12)},
          {"L", polygon({{-6, -6}, {8, -6}, {8, 0}, {0, 0}, {0, 8}, {-6, 8}})},
          {"Plus", polygon({{-3, -9},
                            {3, -9},
                            {3, -3},
                            {9, -3},
                            {9, 3},
                            {3, 3},
                            {3, 9},
                            {-3, 9},
                            {-3, 3},
                            {-9, 3},
                            {-9, -3},
                            {-3, -3}})},
          {"Comb", polygon({{-9, -6},
                            {9, -6},
                            {9, 6},
                            {7, 6},
                            {7, 0},
                            {5, 0},
                            {5, 6},
                            {3, 6},
                            {3, 0},
                            {1, 0},
                            {1, 6},
                            {-1, 6},
                            {-1, 0},
                            {-3, 0},
                            {-3, 6},
                            {-9, 6}})}};
}

/// A surface through heights of a gentle wave.
TopoDS_Shape wave() {
  constexpr int count = 7;
  TColgp_Array2OfPnt points(1, count, 1, count);
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      const double x = -30 + 10 * i, y = -30 + 10 * j;
      points(i + 1, j + 1) = gp_Pnt(x, y, 20 + std::sin(x / 15) + std::cos(y / 20 + 0.3));
    }
  return BRepBuilderAPI_MakeFace(GeomAPI_PointsToBSplineSurface(points).Surface(), 1e-7).Face();
}

struct Base {
  const char* name;
  TopoDS_Shape shape;
};

std::vector<Base> bases() {
  const gp_Pln plane(gp_Pnt(0, 0, 20), gp_Dir(0, 0, 1));
  const gp_Ax2 lying(gp_Pnt(0, -40, 0), gp_Dir(0, 1, 0), gp_Dir(0, 0, -1));
  const gp_Ax2 seam_above(gp_Pnt(0, -40, 0), gp_Dir(0, 1, 0), gp_Dir(0, 0, 1));
  return {
      {"Plane", BRepBuilderAPI_MakeFace(plane, -30, 30, -30, 30).Face()},
      {"Cylinder", partsOf(BRepPrimAPI_MakeCylinder(lying, 20, 80).Shape(), TopAbs_FACE)(1)},
      {"CylinderWithItsSeamInTheHole",
       partsOf(BRepPrimAPI_MakeCylinder(seam_above, 20, 80).Shape(), TopAbs_FACE)(1)},
      {"Cone", partsOf(BRepPrimAPI_MakeCone(lying, 20, 28, 80).Shape(), TopAbs_FACE)(1)},
      {"SphereWithItsPoleInTheHole", partsOf(BRepPrimAPI_MakeSphere(25).Shape(), TopAbs_FACE)(1)},
      {"Wave", wave()}};
}

double area_mm2(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties, 1e-9);
  return properties.Mass();
}

double volume_mm3(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-9);
  return properties.Mass();
}

/// The hole nearest to the top of the base.
Hole holeOnTop(const TopoDS_Shape& shape) {
  const std::vector<Hole> holes = occ::findHoles(shape).holes;
  return *std::ranges::max_element(holes, {}, [](const Hole& hole) {
    return hole.centre.z() - std::hypot(hole.centre.x(), hole.centre.y()) - 0.1 * hole.length_mm;
  });
}

class HoleInOneSurface : public testing::TestWithParam<std::tuple<int, int>> {
 protected:
  Base base_ = bases()[std::get<0>(GetParam())];
  Tool tool_ = tools()[std::get<1>(GetParam())];
  /// What lies below stays.
  TopoDS_Shape holed_ = BRepAlgoAPI_Cut(base_.shape, upperPart(tool_.shape)).Shape();

  static TopoDS_Shape upperPart(const TopoDS_Shape& tool) {
    return BRepAlgoAPI_Cut(
               tool, BRepPrimAPI_MakeBox(gp_Pnt(-50, -50, low - 1), gp_Pnt(50, 50, 0)).Shape())
        .Shape();
  }
};

TEST_P(HoleInOneSurface, IsClosedByIt) {
  const Hole hole = holeOnTop(holed_);
  const FillHoleReport report = occ::fillHole(modelFromShape(holed_), hole);
  ASSERT_TRUE(report.reached) << base_.name << " " << tool_.name << ": " << textOf(report.reason);
  EXPECT_TRUE(report.filled && report.regular);
  ASSERT_EQ(report.faces.size(), 1U);
  EXPECT_TRUE(report.sides.empty() && report.inner.empty());
  EXPECT_TRUE(BRepCheck_Analyzer(report.model.shape).IsValid());
  EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), 1e-5 * degree);
  EXPECT_LT(*report.largestGap_mm(), 1e-5);
  EXPECT_LT(*report.largestAngle_rad(), 1e-3 * degree);
  EXPECT_NEAR(area_mm2(report.model.shape), area_mm2(base_.shape), 2e-5 * area_mm2(base_.shape));
  EXPECT_EQ(occ::findHoles(report.model.shape).holes.size(),
            occ::findHoles(holed_).holes.size() - 1);
}

INSTANTIATE_TEST_SUITE_P(All, HoleInOneSurface,
                         testing::Combine(testing::Range(0, 6), testing::Range(0, 7)),
                         [](const testing::TestParamInfo<std::tuple<int, int>>& of) {
                           return std::string(tools()[std::get<1>(of.param)].name) + "In" +
                                  bases()[std::get<0>(of.param)].name;
                         });

TopoDS_Shape roundedBox() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(40, 30, 20).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  const TopTools_IndexedMapOfShape edges = partsOf(box, TopAbs_EDGE);
  for (int edge = 1; edge <= edges.Extent(); ++edge) fillet.Add(3, TopoDS::Edge(edges(edge)));
  return fillet.Shape();
}

/// Around a flat face of a box whose edges are all rounded there is no plane, but fillets that
/// touch its own.
TEST(FillByAFace, OfAFaceBetweenFilletsIsItsPlane) {
  const TopoDS_Shape shape = roundedBox();
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE);
  int flat = 0;
  for (int face = 1; face <= faces.Extent(); ++face) {
    if (BRepAdaptor_Surface(TopoDS::Face(faces(face))).GetType() != GeomAbs_Plane) continue;
    ++flat;
    const FillHoleReport report = occ::replaceFace(modelFromShape(shape), face);
    ASSERT_TRUE(report.reached) << textOf(report.reason);
    ASSERT_EQ(report.faces.size(), 1U);
    EXPECT_TRUE(BRepCheck_Analyzer(report.model.shape).IsValid());
    EXPECT_NEAR(volume_mm3(report.model.shape), volume_mm3(shape), 1e-6);
    EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), 1e-6);
  }
  EXPECT_EQ(flat, 6);
}

TEST(FillByAFace, KeepsLinesAndCircles) {
  const TopoDS_Shape sheet =
      BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 20), gp_Dir(0, 0, 1)), -30, 30, -30, 30).Face();
  const TopoDS_Shape holed = BRepAlgoAPI_Cut(sheet, roundedRectangle(10, 6, 2)).Shape();
  const FillHoleReport report = occ::fillHole(modelFromShape(holed), holeOnTop(holed));
  ASSERT_TRUE(report.reached) << textOf(report.reason);
  std::map<GeomAbs_CurveType, int> kinds;
  const TopTools_IndexedMapOfShape edges = partsOf(report.model.shape, TopAbs_EDGE);
  for (int edge = 1; edge <= edges.Extent(); ++edge)
    ++kinds[BRepAdaptor_Curve(TopoDS::Edge(edges(edge))).GetType()];
  EXPECT_EQ(kinds[GeomAbs_Line], 8);
  EXPECT_EQ(kinds[GeomAbs_Circle], 4);
}

/// Two halves of a tube, each with a cylinder of its own, and a hole across the joint.
TEST(FillByAFace, CrossesFacesOfEqualSurfaces) {
  const auto half = [](double turn_rad) {
    const gp_Ax2 axes(gp_Pnt(0, -40, 0), gp::DY(),
                      gp_Dir(std::cos(turn_rad), 0, std::sin(turn_rad)));
    return partsOf(BRepPrimAPI_MakeCylinder(axes, 20, 80, std::numbers::pi).Shape(),
                   TopAbs_FACE)(1);
  };
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (const double turn_rad : {0.4, 0.4 + std::numbers::pi})
    sewing.Add(BRepAlgoAPI_Cut(half(turn_rad), prismAcross(0.4)).Shape());
  sewing.Perform();
  const TopoDS_Shape holed = sewing.SewedShape();
  const std::vector<Hole> holes = occ::findHoles(holed).holes;
  ASSERT_EQ(holes.size(), 3U);
  const Hole hole = *std::ranges::min_element(holes, {}, &Hole::length_mm);
  const FillHoleReport report = occ::fillHole(modelFromShape(holed), hole);
  ASSERT_TRUE(report.reached) << textOf(report.reason);
  EXPECT_EQ(report.faces.size(), 1U);
  EXPECT_NEAR(area_mm2(report.model.shape), 40 * std::numbers::pi * 80, 0.01);
}

/// The rim of a sheet bounds the sheet, not a hole in its plane; nor do the mouths of a tube lie on
/// its wall.
TEST(FillByAFace, LiesNotOnItsNeighbours) {
  const TopoDS_Shape sheet =
      BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 20), gp_Dir(0, 0, 1)), -30, 30, -30, 30).Face();
  EXPECT_FALSE(occ::fillHole(modelFromShape(sheet), occ::findHoles(sheet).holes.front()).filled);
  const TopoDS_Shape tube = without(BRepPrimAPI_MakeCylinder(5, 10).Shape(), {2});
  const FillHoleReport dome =
      occ::fillHole(modelFromShape(tube), occ::findHoles(tube).holes.front());
  EXPECT_TRUE(dome.reached) << textOf(dome.reason);
  EXPECT_EQ(dome.faces.size(), 5U);
}

/// A cup whose bottom rises through the plane of its rim, and a gutter around the axis, whose inner
/// rim lies in the plane of the outer one.
TEST(FillByAFace, RunsNotIntoItsNeighbour) {
  const auto revolved = [](const opencascade::handle<Geom_Curve>& curve) {
    return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeEdge(curve).Edge(), gp::OZ()).Shape();
  };
  TColgp_Array1OfPnt poles(1, 5);
  poles(1) = gp_Pnt(10, 0, 0), poles(2) = gp_Pnt(10, 0, -12), poles(3) = gp_Pnt(3, 0, -12),
  poles(4) = gp_Pnt(3, 0, 8), poles(5) = gp_Pnt(0, 0, 8);
  const opencascade::handle<Geom_Curve> circle =
      new Geom_Circle(gp_Ax2(gp_Pnt(20, 0, 0), -gp::DY(), gp::DX()), 5);
  for (const TopoDS_Shape& shape :
       {revolved(new Geom_BezierCurve(poles)),
        revolved(new Geom_TrimmedCurve(circle, std::numbers::pi, 2 * std::numbers::pi))}) {
    const std::vector<Hole> holes = occ::findHoles(shape).holes;
    const Hole rim = *std::ranges::max_element(holes, {}, &Hole::length_mm);
    const FillHoleReport report = occ::fillHole(modelFromShape(shape), rim, {.target = Level::G0});
    EXPECT_FALSE(report.filled || report.reached);
    EXPECT_EQ(textOf(report.reason), "the fill runs into face 1");
  }
}

/// Walls over a loop that crosses itself: no seam tells of it, OpenCASCADE's checks do.
TEST(FillByAFace, OfALoopThatCrossesItselfIsRefused) {
  BRepBuilderAPI_MakePolygon bow;
  for (const auto& [x, y] : {std::pair{0., 0.}, {20., 12.}, {20., 0.}, {0., 10.}})
    bow.Add(gp_Pnt(x, y, 0));
  bow.Close();
  const TopoDS_Shape walls = BRepPrimAPI_MakePrism(bow.Wire(), gp_Vec(0, 0, 5)).Shape();
  for (const Hole& hole : occ::findHoles(walls).holes) {
    const FillHoleReport report = occ::fillHole(modelFromShape(walls), hole, {.target = Level::G0});
    EXPECT_FALSE(report.filled || report.reached);
    EXPECT_EQ(textOf(report.reason), "OpenCASCADE's checks would not pass for the fill");
  }
}

}  // namespace
}  // namespace seamwright::test
