// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes that patches do not fill: many corners, corners above 180 degrees, outlines across joints
// of faces, several faces at once. What is expected is known of spheres, cylinders and planes;
// angles are measured by OpenCASCADE's evaluation at many points.
#include <gmock/gmock.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pln.hxx>
#include <numbers>
#include <tuple>

#include "fill_checks.hpp"
#include "shapes.hpp"

#include <seamwright/occ_adapter/fill/face_curvature.hpp>
#include <seamwright/occ_adapter/fill/fill.hpp>

namespace seamwright::test {
namespace {

using occ::FillHoleReport;
using occ::FillMethod;
using occ::modelFromShape;

constexpr double ball_mm = 20;

/// A prism along z over a polygon.
TopoDS_Shape prism(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const gp_Pnt& corner : corners) polygon.Add(corner);
  polygon.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire()).Face(), gp_Vec(0, 0, 80))
      .Shape();
}

std::vector<gp_Pnt> star(int points) {
  std::vector<gp_Pnt> corners;
  for (int k = 0; k < 2 * points; ++k) {
    const double angle = std::numbers::pi * k / points, r = k % 2 == 0 ? 9 : 6;
    corners.emplace_back(r * std::cos(angle), r * std::sin(angle), -40);
  }
  return corners;
}

std::vector<gp_Pnt> ell() {
  return {{-7, -7, -40}, {7, -7, -40}, {7, 0, -40}, {0, 0, -40}, {0, 7, -40}, {-7, 7, -40}};
}

/// The upper half of a sphere less a prism along z.
TopoDS_Shape sphereWithout(const TopoDS_Shape& tool) {
  const TopoDS_Shape half =
      BRepBuilderAPI_MakeFace(
          new Geom_SphericalSurface(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)), ball_mm), 1e-7)
          .Face();
  return BRepAlgoAPI_Cut(half, tool).Shape();
}

/// The hole with the centre nearest to a point.
occ::Hole holeNear(const TopoDS_Shape& shape, const Eigen::Vector3d& point) {
  const occ::Holes found = occ::findHoles(shape);
  return *std::ranges::min_element(
      found.holes, {}, [&](const occ::Hole& hole) { return (hole.centre - point).norm(); });
}

/// The largest distance of points of faces from the sphere around the origin.
double fromSphere_mm(const TopoDS_Shape& shape, const std::vector<int>& faces) {
  double worst = 0;
  for (const int number : faces) {
    const TopoDS_Face face = TopoDS::Face(partsOf(shape, TopAbs_FACE)(number));
    const BRepAdaptor_Surface surface(face);
    const BRepTopAdaptor_FClass2d inside(face, 1e-9);
    for (int i = 1; i < 40; ++i)
      for (int j = 1; j < 40; ++j) {
        const double u = std::lerp(surface.FirstUParameter(), surface.LastUParameter(), i / 40.0),
                     v = std::lerp(surface.FirstVParameter(), surface.LastVParameter(), j / 40.0);
        if (inside.Perform(gp_Pnt2d(u, v)) == TopAbs_IN)
          worst = std::max(worst, std::abs(surface.Value(u, v).Distance(gp_Pnt()) - ball_mm));
      }
  }
  return worst;
}

void expectGood(const FillHoleReport& report) {
  ASSERT_TRUE(report.filled) << textOf(report.reason);
  EXPECT_TRUE(report.reached);
  EXPECT_TRUE(BRepCheck_Analyzer(report.model.shape).IsValid());
  EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), 0.01 * degree);
}

struct Outline {
  const char* name;
  std::vector<gp_Pnt> corners;
};

class GraphInSphere : public testing::TestWithParam<Outline> {};

// The sphere itself would close these holes, so it must not continue.
TEST_P(GraphInSphere, MeetsIt) {
  const TopoDS_Shape shape = sphereWithout(prism(GetParam().corners));
  const FillHoleReport report = occ::fillHole(
      modelFromShape(shape), holeNear(shape, {0, 0, ball_mm}), {.continue_surface = false});
  expectGood(report);
  EXPECT_EQ(report.method, FillMethod::Graph);
  EXPECT_EQ(report.faces.size(), 1U);
  EXPECT_LT(fromSphere_mm(report.model.shape, report.faces), 0.02);
  EXPECT_NEAR(report.curvature_per_mm.value_or(0), 1 / ball_mm, 0.2 / ball_mm);
}

INSTANTIATE_TEST_SUITE_P(Outlines, GraphInSphere,
                         testing::Values(Outline{"ell", ell()}, Outline{"star", star(7)}),
                         [](const auto& outline) { return outline.param.name; });

/// A plane for x < 0 and a cylinder that is tangent to it for x > 0, sewn.
TopoDS_Shape planeAndCylinder() {
  constexpr double r = 30;
  BRepBuilderAPI_Sewing sewing(1e-6);
  sewing.Add(BRepBuilderAPI_MakeFace(
                 gp_Pln(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(1, 0, 0))), -20, 0, -20, 20)
                 .Face());
  // u = 0 is the line x = z = 0; u grows with x.
  const gp_Ax3 axes(gp_Pnt(0, -20, -r), gp_Dir(0, 1, 0), gp_Dir(0, 0, 1));
  sewing.Add(
      BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(axes, r), 0, 0.7, 0, 40, 1e-7).Face());
  sewing.Perform();
  return sewing.SewedShape();
}

TEST(GraphAcross, FillsAnLAcrossAPlaneAndACylinder) {
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(planeAndCylinder(), prism(ell())).Shape();
  const FillHoleReport report = occ::fillHole(modelFromShape(shape), holeNear(shape, {-1, -1, 0}));
  expectGood(report);
}

/// Patches of 4 by 4 of a sphere, sewn.
TopoDS_Shape sphereGrid() {
  const opencascade::handle<Geom_Surface> sphere =
      new Geom_SphericalSurface(gp_Ax3(gp::XOY()), ball_mm);
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      sewing.Add(BRepBuilderAPI_MakeFace(sphere, 0.3 * (i - 2), 0.3 * (i - 1), 0.3 * (j - 2),
                                         0.3 * (j - 1), 1e-7)
                     .Face());
  sewing.Perform();
  return sewing.SewedShape();
}

/// Numbers of the faces at a vertex near a point.
std::vector<int> facesAt(const TopoDS_Shape& shape, const gp_Pnt& point) {
  std::vector<int> faces;
  const TopTools_IndexedMapOfShape all = partsOf(shape, TopAbs_FACE);
  for (int face = 1; face <= all.Extent(); ++face) {
    const TopTools_IndexedMapOfShape vertices = partsOf(all(face), TopAbs_VERTEX);
    for (int k = 1; k <= vertices.Extent(); ++k)
      if (BRep_Tool::Pnt(TopoDS::Vertex(vertices(k))).Distance(point) < 1e-3) faces.push_back(face);
  }
  return faces;
}

TEST(ReplaceFaces, FillsWhatAllFacesAroundAVertexLeave) {
  const TopoDS_Shape shape = sphereGrid();
  const std::vector<int> around = facesAt(shape, gp_Pnt(ball_mm, 0, 0));
  ASSERT_EQ(around.size(), 4U);
  const FillHoleReport report =
      occ::replaceFaces(modelFromShape(shape), around, {.continue_surface = false});
  expectGood(report);
  EXPECT_LT(fromSphere_mm(report.model.shape, report.faces), 0.02);
  EXPECT_NEAR(report.removed_curvature_per_mm.value_or(0), 1 / ball_mm, 1e-6);
}

TEST(ReplaceFaces, OfOneFaceIsReplaceFace) {
  const TopoDS_Shape shape = sphereGrid();
  const std::vector<int> around = facesAt(shape, gp_Pnt(ball_mm, 0, 0));
  const FillHoleReport one = occ::replaceFace(modelFromShape(shape), around[0]),
                       other = occ::replaceFaces(modelFromShape(shape), {around[0]});
  EXPECT_TRUE(one.reached);
  EXPECT_EQ(one.largestAngle_rad(), other.largestAngle_rad());
}

TEST(ReplaceFaces, RefusesFacesThatLeaveTwoHolesOrTouchTheBoundary) {
  const TopoDS_Shape shape = sphereGrid();
  const std::vector<int> corner = facesAt(
      shape, BRepAdaptor_Surface(TopoDS::Face(partsOf(shape, TopAbs_FACE)(1))).Value(-0.6, -0.6));
  ASSERT_EQ(corner.size(), 1U);
  EXPECT_EQ(codeOf(occ::replaceFaces(modelFromShape(shape), corner).reason.fault),
            "edge_of_one_face");
  EXPECT_THROW(occ::replaceFaces(modelFromShape(shape), {}), std::invalid_argument);
  EXPECT_THROW(occ::replaceFaces(modelFromShape(shape), {99}), std::invalid_argument);
  EXPECT_THROW(occ::replaceFaces(modelFromShape(shape), {1, 1}), std::invalid_argument);
}

// Half of the sheet is turned by one degree: at both joints the fill has one tangent plane.
TEST(Contradiction, IsNamedWithItsAngle) {
  BRepBuilderAPI_Sewing sewing(1e-6);
  const double turn = 1 * degree;
  sewing.Add(BRepBuilderAPI_MakeFace(
                 gp_Pln(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(1, 0, 0))), -20, 0, -20, 20)
                 .Face());
  sewing.Add(BRepBuilderAPI_MakeFace(
                 gp_Pln(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(-std::sin(turn), 0, std::cos(turn)),
                               gp_Dir(std::cos(turn), 0, std::sin(turn)))),
                 0, 20, -20, 20)
                 .Face());
  sewing.Perform();
  const TopoDS_Shape tool = prism({{-6, -6, -40}, {6, -6, -40}, {6, 6, -40}, {-6, 6, -40}});
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(sewing.SewedShape(), tool).Shape();
  const occ::Hole hole = holeNear(shape, {0, 0, 0});
  const FillHoleReport refused = occ::fillHole(modelFromShape(shape), hole);
  EXPECT_FALSE(refused.reached);
  const auto cause = std::ranges::find(refused.reason.causes, occ::FillFault::NeighboursContradict,
                                       &occ::FillReason::fault);
  ASSERT_NE(cause, refused.reason.causes.end()) << textOf(refused.reason);
  EXPECT_NEAR(cause->number("angle_deg"), 1, 1e-6);
  EXPECT_NEAR(std::abs(cause->point_mm->y()), 6, 1e-6);
  const FillHoleReport kept = occ::fillHole(modelFromShape(shape), hole, {.keep_anyway = true});
  ASSERT_TRUE(kept.filled) << textOf(kept.reason);
  EXPECT_GT(largestAngle_rad(kept.model.shape, kept.faces), 0.45 * degree);
}

TEST(FillWaves, BendsOfAGraphInClosedForm) {
  // z = c x^3 over [-10, 10]^2 has the mean curvature 3 c x / (1 + 9 c^2 x^4)^1.5; the outermost
  // points of the grid have |x| = 9.375.
  constexpr double c = 1e-4, x = 9.375;
  TColgp_Array2OfPnt poles(1, 4, 1, 2);
  const double z[] = {-1000 * c, 1000 * c, -1000 * c, 1000 * c};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 2; ++j) poles(i + 1, j + 1) = gp_Pnt(-10 + 20.0 * i / 3, 20 * j - 10, z[i]);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7);
  const auto bends = occ::bendsOf({face, face.Reversed()});
  ASSERT_TRUE(bends.has_value());
  const double mean = 3 * c * x / std::pow(1 + 9 * c * c * x * x * x * x, 1.5);
  EXPECT_NEAR(bends->mean_per_mm.upper, mean, 1e-12);
  EXPECT_NEAR(bends->mean_per_mm.lower, -mean, 1e-12);
  EXPECT_NEAR(bends->largest_per_mm, 2 * mean, 1e-12);
}

TEST(FillWaves, AreNamedFromTwiceTheCurvatureAround) {
  FillHoleReport report;
  EXPECT_FALSE(report.waves());
  for (const auto& [around, both_ways, expected] :
       {std::tuple{0.2, 0.4, 2.0}, {0.2, 0.39, 0.0}, {0.0, 0.4, 0.0}, {0.2, 1.0, 5.0}}) {
    report.around_curvature_per_mm = around;
    report.both_ways_per_mm = both_ways;
    EXPECT_EQ(report.waves().value_or(0), expected) << around << ' ' << both_ways;
  }
}

}  // namespace
}  // namespace seamwright::test
