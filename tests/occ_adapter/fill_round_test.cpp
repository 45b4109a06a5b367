// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes with fewer corners than three, and fills that look to curvature. What is expected is known
// of the shapes; angles are measured by OpenCASCADE's evaluation at many points.
#include <gmock/gmock.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pln.hxx>
#include <numbers>

#include "fill_checks.hpp"
#include "shapes.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/fill/fill.hpp>

namespace seamwright::test {
namespace {

using occ::FillHoleReport;
using occ::Hole;
using occ::modelFromShape;
using occ::replaceFace;

constexpr double radius = 20;

/// The surface of a sphere less what is in a tool along the z axis.
TopoDS_Shape sphereWithout(const TopoDS_Shape& tool) {
  const TopoDS_Shape sphere =
      BRepPrimAPI_MakeSphere(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)), radius).Shape();
  return BRepAlgoAPI_Cut(partsOf(sphere, TopAbs_FACE)(1), tool).Shape();
}

TopoDS_Shape rod(double x, double y, double r) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, 0), gp_Dir(0, 0, 1)), r, 40).Shape();
}

TopoDS_Shape slab(double x0, double y0, double x1, double y1) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x0, y0, 0), gp_Pnt(x1, y1, 40)).Shape();
}

struct Case {
  const char* name;
  TopoDS_Shape tool;
  double within_mm;    ///< distance of the fill from the sphere
  double within_jump;  ///< jumps of curvature of the fill for G2, over the curvature of the sphere
};

std::vector<Case> cases() {
  return {{"circle", rod(0, 0, 8), 0.13, 5e-4},
          {"lens", BRepAlgoAPI_Common(rod(0, 5, 10), rod(0, -5, 10)).Shape(), 0.085, 0.005},
          {"half moon", BRepAlgoAPI_Common(rod(0, 0, 8), slab(-20, 1, 20, 20)).Shape(), 0.3, 0.06}};
}

double fromSphere_mm(const TopoDS_Shape& shape, const std::vector<int>& faces) {
  double worst = 0;
  for (const int face : faces) {
    const BRepAdaptor_Surface surface(TopoDS::Face(partsOf(shape, TopAbs_FACE)(face)));
    for (int i = 0; i <= 10; ++i)
      for (int j = 0; j <= 10; ++j)
        worst = std::max(worst,
                         std::abs(surface.Value(i / 10.0, j / 10.0).Distance(gp_Pnt()) - radius));
  }
  return worst;
}

/// By patches: the sphere would close the hole alone.
FillHoleReport filled(const TopoDS_Shape& shape, occ::FillHoleOptions options = {}) {
  options.continue_surface = false;
  const occ::Holes found = occ::findHoles(shape);
  EXPECT_EQ(found.holes.size(), 1U);
  return occ::fillHole(modelFromShape(shape), found.holes.front(), options);
}

class RoundHole : public testing::TestWithParam<int> {
 protected:
  Case case_ = cases()[GetParam()];
};

TEST_P(RoundHole, IsFilledByFiveFacesNearTheSphere) {
  const FillHoleReport report = filled(sphereWithout(case_.tool));
  ASSERT_TRUE(report.filled) << case_.name << ": " << textOf(report.reason);
  EXPECT_TRUE(report.reached);
  EXPECT_TRUE(report.regular);
  EXPECT_EQ(report.faces.size(), 5U);
  EXPECT_EQ(report.sides.size(), 4U);
  EXPECT_EQ(report.inner.size(), 8U);
  EXPECT_TRUE(BRepCheck_Analyzer(report.model.shape).IsValid());
  EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), 0.0006 * degree) << case_.name;
  for (const occ::SeamResult& seam : report.inner) EXPECT_LT(seam.figures.angle_rad->lower, 1e-9);
  EXPECT_LT(fromSphere_mm(report.model.shape, report.faces), case_.within_mm) << case_.name;
}

TEST_P(RoundHole, MovesWithTheModel) {
  std::mt19937 random(testSeed());
  const TopoDS_Shape shape = sphereWithout(case_.tool);
  const FillHoleReport plain = filled(shape),
                       moved = filled(transformed(shape, randomMotion(random)));
  ASSERT_TRUE(moved.filled) << case_.name << ": " << textOf(moved.reason);
  EXPECT_NEAR(*moved.largestAngle_rad(), *plain.largestAngle_rad(),
              1e-2 * *plain.largestAngle_rad() + 1e-7);
}

// The neighbours' curvature is 1 / 20 everywhere.
TEST_P(RoundHole, CurvatureIsNearlyThatOfTheSphere) {
  occ::FillHoleOptions options{.target = Level::G2, .keep_anyway = true};
  const FillHoleReport curved = filled(sphereWithout(case_.tool), options);
  options.target = Level::G1;
  const FillHoleReport plain = filled(sphereWithout(case_.tool), options);
  ASSERT_TRUE(curved.filled && plain.filled) << textOf(curved.reason) << textOf(plain.reason);
  ASSERT_TRUE(curved.curvature_jump_per_mm.has_value());
  EXPECT_FALSE(plain.curvature_jump_per_mm.has_value());
  EXPECT_LT(*curved.curvature_jump_per_mm, case_.within_jump / radius) << case_.name;
  EXPECT_LT(largestAngle_rad(curved.model.shape, curved.faces), 0.0006 * degree) << case_.name;
  for (const occ::SeamResult& seam : curved.inner)
    EXPECT_LT(*seam.figures.curvature_rel->upper, 1e-3) << case_.name;
  EXPECT_LT(fromSphere_mm(curved.model.shape, curved.faces),
            0.75 * fromSphere_mm(plain.model.shape, plain.faces));
}

INSTANTIATE_TEST_SUITE_P(Cases, RoundHole, testing::Range(0, 3));

/// Of all these faces together.
double area_mm2(const TopoDS_Shape& shape, const std::vector<int>& faces) {
  double area = 0;
  for (const int face : faces) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(partsOf(shape, TopAbs_FACE)(face), properties, 1e-9);
    area += properties.Mass();
  }
  return area;
}

/// The faces lie in the plane at this height, with their normals on one side: areas alone would not
/// tell of a fold that comes back.
void expectFlat(const TopoDS_Shape& shape, const std::vector<int>& faces, double height_mm) {
  constexpr int count = 60;
  int up = 0, down = 0;
  for (const int face : faces) {
    const BRepAdaptor_Surface surface(TopoDS::Face(partsOf(shape, TopAbs_FACE)(face)));
    const bool turned = surface.Face().Orientation() == TopAbs_REVERSED;
    for (int i = 0; i <= count; ++i)
      for (int j = 0; j <= count; ++j) {
        gp_Pnt point;
        gp_Vec u, v;
        surface.D1(surface.FirstUParameter() +
                       (surface.LastUParameter() - surface.FirstUParameter()) * i / count,
                   surface.FirstVParameter() +
                       (surface.LastVParameter() - surface.FirstVParameter()) * j / count,
                   point, u, v);
        ASSERT_NEAR(point.Z(), height_mm, 1e-6);
        ((u.Crossed(v).Z() > 0) != turned ? up : down) += 1;
      }
  }
  EXPECT_TRUE(up == 0 || down == 0) << up << " up, " << down << " down";
}

// Cut at its four joints, the slot has sides that polynomials meet.
TEST(RoundHoles, ASlotInAPlaneIsFlat) {
  const TopoDS_Shape sheet =
      BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 10), gp_Dir(0, 0, 1)), -30, 30, -30, 30).Face();
  const TopoDS_Shape ends = BRepAlgoAPI_Fuse(rod(-10, 0, 4), rod(10, 0, 4)).Shape();
  const TopoDS_Shape slot = BRepAlgoAPI_Fuse(ends, slab(-10, -4, 10, 4)).Shape();
  const occ::Model model = modelFromShape(BRepAlgoAPI_Cut(sheet, slot).Shape());
  const occ::Holes found = occ::findHoles(model.shape);
  const auto hole =
      std::ranges::find_if(found.holes, [](const Hole& one) { return !one.has_corners; });
  ASSERT_NE(hole, found.holes.end());
  EXPECT_NEAR(hole->length_mm, 8 * std::numbers::pi + 40, 1e-6);
  for (const bool continue_surface : {false, true}) {
    const FillHoleReport report =
        occ::fillHole(model, *hole, {.continue_surface = continue_surface});
    ASSERT_TRUE(report.filled) << textOf(report.reason);
    EXPECT_EQ(report.faces.size(), continue_surface ? 1U : 5U);
    expectFlat(report.model.shape, report.faces, 10);
    EXPECT_NEAR(area_mm2(report.model.shape, report.faces), 20 * 8 + 16 * std::numbers::pi, 1e-3);
  }
}

TEST(RoundHoles, TheFlatLidOfACanClosesIt) {
  const TopoDS_Shape can = BRepPrimAPI_MakeCylinder(5, 10).Shape();
  for (const int lid : {2, 3})
    for (const bool continue_surface : {false, true}) {
      const FillHoleReport flat = replaceFace(
          modelFromShape(can), lid, {.target = Level::G0, .continue_surface = continue_surface});
      ASSERT_TRUE(flat.filled) << textOf(flat.reason);
      EXPECT_EQ(flat.faces.size(), continue_surface ? 1U : 5U);
      EXPECT_EQ(flat.model.shape.ShapeType(), TopAbs_SOLID);
      EXPECT_TRUE(BRepCheck_Analyzer(flat.model.shape).IsValid());
      expectFlat(flat.model.shape, flat.faces, lid == 2 ? 10 : 0);
      EXPECT_NEAR(area_mm2(flat.model.shape, flat.faces), 25 * std::numbers::pi, 1e-3);
      GProp_GProps properties;
      BRepGProp::VolumeProperties(flat.model.shape, properties, 1e-9);
      EXPECT_NEAR(properties.Mass(), 250 * std::numbers::pi, 1e-2);
    }
}

TEST(RoundHoles, TheSmoothLidOfACanIsADome) {
  const TopoDS_Shape can = BRepPrimAPI_MakeCylinder(5, 10).Shape();
  for (const int lid : {2, 3}) {
    const FillHoleReport dome = replaceFace(modelFromShape(can), lid);
    ASSERT_TRUE(dome.filled) << textOf(dome.reason);
    EXPECT_LT(largestAngle_rad(dome.model.shape, dome.faces), 0.001 * degree);
    // Along the wall's straight lines the dome begins without curvature, if it is told of the
    // wall's.
    const FillHoleReport curved = replaceFace(modelFromShape(can), lid, {.target = Level::G2});
    EXPECT_TRUE(curved.reached) << textOf(curved.reason);
    EXPECT_LT(curved.largestCurvature_rel().value_or(1), 0.005);
    EXPECT_GT(dome.largestCurvature_rel().value_or(0), 0.1);
  }
}

/// Speeds of the sides that differ by 1e-8 alone once made equations that contradict each other.
TEST(RoundHoles, ARoundHoleInACylinderIsFilledByPatches) {
  const TopoDS_Shape wall = partsOf(
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, -100, -40), gp_Dir(0, 1, 0)), 40, 200).Shape(),
      TopAbs_FACE)(1);
  const TopoDS_Shape holed =
      BRepAlgoAPI_Cut(
          wall, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -30), gp_Dir(0, 0, 1)), 8, 60).Shape())
          .Shape();
  const std::vector<Hole> holes = occ::findHoles(holed).holes;
  const FillHoleReport report =
      occ::fillHole(modelFromShape(holed), *std::ranges::min_element(holes, {}, &Hole::length_mm),
                    {.continue_surface = false});
  ASSERT_TRUE(report.reached) << textOf(report.reason);
  EXPECT_EQ(report.faces.size(), 5U);
  EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), 0.01 * degree);
}

/// A line, an arc that leaves it backwards at (0, 0), and a line that joins them.
TEST(RoundHoles, ACuspIsFilledByAGraph) {
  const double r = (100 + 9) / 6.0, half = std::asin(10 / r) / 2;
  const gp_Pnt tip(0, 0, 0), low(10, 0, 0), high(10, 3, 0);
  const gp_Pnt middle(r * std::sin(half), r - r * std::cos(half), 0);
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(low, tip));
  wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(tip, middle, high).Value()));
  wire.Add(BRepBuilderAPI_MakeEdge(high, low));
  const gp_Pln plane(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  const TopoDS_Shape holed =
      BRepAlgoAPI_Cut(BRepBuilderAPI_MakeFace(plane, -30, 30, -30, 30).Face(),
                      BRepBuilderAPI_MakeFace(plane, wire.Wire()).Face())
          .Shape();
  const std::vector<Hole> holes = occ::findHoles(holed).holes;
  const FillHoleReport report =
      occ::fillHole(modelFromShape(holed), *std::ranges::min_element(holes, {}, &Hole::length_mm),
                    {.continue_surface = false});
  ASSERT_TRUE(report.reached) << textOf(report.reason);
  EXPECT_EQ(report.method, occ::FillMethod::Graph);
}

// A corner of 270 degrees between five others.
TEST(RoundHoles, AReflexCornerAmongManyIsFilledByAGraph) {
  const TopoDS_Shape arrow = BRepAlgoAPI_Cut(slab(-8, -8, 8, 8), slab(0, 0, 20, 20)).Shape();
  const FillHoleReport report = filled(sphereWithout(arrow));
  ASSERT_TRUE(report.reached) << textOf(report.reason);
  EXPECT_EQ(report.method, occ::FillMethod::Graph);
  EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), 0.01 * degree);
}

}  // namespace
}  // namespace seamwright::test
