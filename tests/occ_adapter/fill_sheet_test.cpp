// SPDX-License-Identifier: LGPL-2.1-or-later
// Bands that bend round, between a tube and a plate: patches turn back there, and no direction sees
// all surroundings from above. The model is a solid of revolution, so that the tangent planes of
// its faces are known; angles are measured by OpenCASCADE's evaluation at many points.
#include <gmock/gmock.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS.hxx>
#include <array>
#include <cmath>
#include <gp_Ax1.hxx>
#include <gp_Circ.hxx>
#include <numbers>

#include "fill_checks.hpp"
#include "shapes.hpp"

#include <seamwright/occ_adapter/fill/fill.hpp>

namespace seamwright::test {
namespace {

constexpr double tube_mm = 32, round_mm = 6;

/// A tube around the z axis, a plate around its foot and the round between them, in two halves.
TopoDS_Shape tubeOnPlate() {
  const gp_Pnt top(tube_mm, 0, 30), foot(tube_mm, 0, round_mm), toe(tube_mm + round_mm, 0, 0),
      rim(60, 0, 0);
  // From the direction of -x over that of -z.
  const gp_Circ circle(gp_Ax2(gp_Pnt(tube_mm + round_mm, 0, round_mm), gp_Dir(0, -1, 0)), round_mm);
  const TopoDS_Shape profile =
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(top, foot).Edge(),
                              BRepBuilderAPI_MakeEdge(circle, foot, toe).Edge(),
                              BRepBuilderAPI_MakeEdge(toe, rim).Edge())
          .Shape();
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (const double from : {0.0, std::numbers::pi}) {
    gp_Trsf turn;
    turn.SetRotation(gp::OZ(), from);
    sewing.Add(BRepPrimAPI_MakeRevol(profile.Moved(turn), gp::OZ(), std::numbers::pi).Shape());
  }
  sewing.Perform();
  return sewing.SewedShape();
}

/// The first face that is neither of the tube nor of the plate.
int roundOf(const TopoDS_Shape& shape) {
  const auto faces = partsOf(shape, TopAbs_FACE);
  for (int k = 1; k <= faces.Extent(); ++k) {
    const GeomAbs_SurfaceType type = BRepAdaptor_Surface(TopoDS::Face(faces(k))).GetType();
    if (type != GeomAbs_Cylinder && type != GeomAbs_Plane) return k;
  }
  return 0;
}

TEST(FillBySheet, ClosesHalfARoundThatBendsAroundATube) {
  const TopoDS_Shape shape = tubeOnPlate();
  const occ::FillHoleReport report =
      occ::replaceFace(occ::modelFromShape(shape), roundOf(shape), {.continue_surface = false});
  ASSERT_TRUE(report.filled) << textOf(report.reason);
  EXPECT_TRUE(report.reached);
  EXPECT_EQ(report.method, occ::FillMethod::Sheet);
  EXPECT_STREQ(name(report.method), "sheet");
  EXPECT_TRUE(report.regular);
  EXPECT_EQ(report.faces.size(), 1U);
  EXPECT_TRUE(BRepCheck_Analyzer(report.model.shape).IsValid());
  EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), 0.01 * degree);
  // The removed torus has 1 / 6 mm.
  EXPECT_LT(report.curvature_per_mm.value_or(HUGE_VAL), 2.5 / round_mm);
}

/// A wall, 60 mm high, along a curve that turns by \p turn_rad in both directions from its middle,
/// in three by three faces.
TopoDS_Shape wallAlong(double turn_rad) {
  constexpr int points = 40;
  TColgp_Array1OfPnt curve(0, points);
  for (int k = 0; k <= points; ++k) {
    const double angle = turn_rad * (2.0 * k / points - 1);
    curve.SetValue(k, gp_Pnt(20 * std::sin(angle) - angle, 20 * std::cos(angle), 0));
  }
  const Handle(Geom_BSplineCurve) path = GeomAPI_PointsToBSpline(curve, 3, 5, GeomAbs_C2).Curve();
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      constexpr std::array<double, 4> shares{0, 0.03, 0.97, 1};
      gp_Trsf up;
      up.SetTranslation(gp_Vec(0, 0, 20 * row));
      const TopoDS_Edge part = BRepBuilderAPI_MakeEdge(path, shares[column], shares[column + 1]);
      sewing.Add(BRepPrimAPI_MakePrism(part, gp_Vec(0, 0, 20)).Shape().Moved(up));
    }
  sewing.Perform();
  return sewing.SewedShape();
}

/// The face nearest to a height, the one of the largest area among equals.
int largestFace(const TopoDS_Shape& shape, double z) {
  const auto faces = partsOf(shape, TopAbs_FACE);
  int found = 0;
  double most = 0;
  for (int k = 1; k <= faces.Extent(); ++k) {
    GProp_GProps area;
    BRepGProp::SurfaceProperties(faces(k), area);
    if (std::abs(area.CentreOfMass().Z() - z) > 1 || area.Mass() <= most) continue;
    most = area.Mass();
    found = k;
  }
  return found;
}

// The curve crosses itself where 20 sin(a) = a, at 2.99 radians.
TEST(FillBySheet, IsRefusedWhereItRunsThroughItself) {
  for (const double turn_rad : {2.8, 3.4}) {
    const TopoDS_Shape shape = wallAlong(turn_rad);
    const occ::FillHoleReport report = occ::replaceFace(
        occ::modelFromShape(shape), largestFace(shape, 30), {.continue_surface = false});
    EXPECT_EQ(report.reached, turn_rad < 3) << textOf(report.reason);
    EXPECT_EQ(report.reason.fault == occ::FillFault::RunsIntoItself, turn_rad > 3)
        << turn_rad << " " << textOf(report.reason);
  }
}

TEST(FillBySheet, IsNotTriedIfNotAskedFor) {
  const TopoDS_Shape shape = tubeOnPlate();
  const occ::FillHoleReport report = occ::replaceFace(occ::modelFromShape(shape), roundOf(shape),
                                                      {.continue_surface = false, .sheet = false});
  EXPECT_NE(report.method, occ::FillMethod::Sheet);
}

}  // namespace
}  // namespace seamwright::test
