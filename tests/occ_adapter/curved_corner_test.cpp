// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners whose faces are curved, or whose edges end among others. Beside OpenCASCADE's checks: its own fillets, of all edges and of one alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <cmath>
#include <functional>
#include <numbers>

#include "corner_solids.hpp"
#include "shapes.hpp"

#include <seamwright/occ_adapter/fill/corner_fillet.hpp>

namespace seamwright::test {
namespace {

using Eigen::Vector3d;
using occ::CornerFillet;
using occ::cornerFillet;
using occ::CornerFilletOptions;
using occ::CornerSeam;
using occ::Model;
using occ::modelFromShape;
using testing::HasSubstr;

/// Radii of the edges in their order about the vertex, counter-clockwise; begun again where there are more edges.
CornerFilletOptions withRadii(const Model& model, int vertex, const std::vector<double>& radii_mm) {
  CornerFilletOptions options;
  std::size_t k = 0;
  for (const int edge : occ::cornerEdges(model, vertex))
    options.radii_mm[edge] = radii_mm[k++ % radii_mm.size()];
  return options;
}

CornerFillet rounded(const TopoDS_Shape& shape, const Vector3d& corner, const std::vector<double>& radii_mm) {
  const Model model = modelFromShape(shape);
  const int vertex = vertexAt(shape, corner);
  return cornerFillet(model, vertex, withRadii(model, vertex, radii_mm));
}

TopTools_IndexedMapOfShape parts(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return map;
}

/// OpenCASCADE's own fillets of the same edges.
TopoDS_Shape native(const TopoDS_Shape& shape, const std::vector<occ::CornerFilletEdge>& edges) {
  const TopTools_IndexedMapOfShape all = parts(shape, TopAbs_EDGE);
  BRepFilletAPI_MakeFillet fillet(shape);
  for (const occ::CornerFilletEdge& edge : edges) fillet.Add(edge.radius_mm, TopoDS::Edge(all(edge.edge)));
  fillet.Build();
  return fillet.IsDone() ? fillet.Shape() : TopoDS_Shape();
}

/// The largest angle that is surely there between faces that meet at less than 5 degrees.
double largestAngle_deg(const TopoDS_Shape& shape) {
  double largest = 0;
  for (const occ::SeamResult& seam : occ::analyze(modelFromShape(shape)).seams)
    if (seam.figures.angle_rad && seam.figures.angle_rad->lower < 5 * degree)
      largest = std::max(largest, seam.figures.angle_rad->lower / degree);
  return largest;
}

TopoDS_Shape box(double x, double y, double z) {
  return BRepPrimAPI_MakeBox(x, y, z).Shape();
}

/// About the origin; seam and poles outside of the first octant.
TopoDS_Shape ball(double radius) {
  return BRepPrimAPI_MakeSphere(gp_Ax2(gp::Origin(), gp_Dir(1, -1, 0), gp_Dir(-1, -1, -1)), radius).Shape();
}

TopoDS_Shape upright(const gp_Pnt& foot, double radius, double height) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(foot, gp::DZ(), gp_Dir(-1, 0, 0)), radius, height).Shape();
}

/// Its corner at (radius, 0, 0) has two planes at a right angle and the cylinder.
TopoDS_Shape wedge(double radius, double height) {
  return BRepPrimAPI_MakeCylinder(radius, height, 1.5).Shape();
}

TopoDS_Shape boxLessBall() {
  return BRepAlgoAPI_Cut(box(20, 20, 20), ball(10)).Shape();
}

/// A block that sticks out of an upright cylinder; its upper corner there has two concave edges and a convex one.
TopoDS_Shape blockOnCylinder() {
  return BRepAlgoAPI_Fuse(upright({0, 0, 0}, 20, 20),
                          BRepPrimAPI_MakeBox(gp_Pnt(0, -5, 5), gp_Pnt(30, 5, 15)).Shape())
      .Shape();
}

/// A pointed dome of cylindrical gores of radius 40, whose axes are aside of the middle: the steeper the further.
TopoDS_Shape dome(int gores, double aside_mm) {
  TopoDS_Shape shape = BRepPrimAPI_MakeBox(gp_Pnt(-60, -60, 0), gp_Pnt(60, 60, 60)).Shape();
  for (int k = 0; k < gores; ++k) {
    const double angle = 2 * std::numbers::pi * k / gores;
    const gp_Dir away(std::cos(angle), std::sin(angle), 0), along(-std::sin(angle), std::cos(angle), 0);
    const gp_Pnt start = gp::Origin().Translated(gp_Vec(away) * aside_mm - gp_Vec(along) * 80);
    const TopoDS_Shape gore = BRepPrimAPI_MakeCylinder(gp_Ax2(start, along, away), 40, 160).Shape();
    shape = BRepAlgoAPI_Common(shape, gore).Shape();
  }
  return shape;
}

Vector3d apex(double aside_mm) {
  return {0, 0, std::sqrt(1600 - aside_mm * aside_mm)};
}

struct Case {
  const char* name;
  TopoDS_Shape shape;
  Vector3d corner;
  std::vector<double> radii_mm;
  double native_deg = 0;  ///< seams of OpenCASCADE's own fillets miss G1 by more
};

std::ostream& operator<<(std::ostream& stream, const Case& of) {
  return stream << of.name;
}

std::vector<Case> cases() {
  return {{"Wedge", wedge(20, 30), {20, 0, 0}, {1, 2, 3}},
          {"Cone", BRepPrimAPI_MakeCone(20, 10, 30, 1.5).Shape(), {20, 0, 0}, {1, 2, 3}},
          {"BoxLessBall", boxLessBall(), {10, 0, 0}, {1}},
          {"Octant", BRepAlgoAPI_Common(box(20, 20, 20), ball(15)).Shape(), {15, 0, 0}, {0.1, 2, 1}},
          {"BaseOfPyramid", regularPyramid(4, 10), {10, 0, 0}, {1}},
          {"BoxLessCylinder",
           BRepAlgoAPI_Cut(box(40, 40, 20), upright({0, 20, -1}, 10, 30)).Shape(),
           {0, 10, 20},
           {1, 2, 1.5}},
          {"BlockOnCylinder", blockOnCylinder(), {std::sqrt(375.0), 5, 15}, {1, 2, 1}},
          {"BossInNotch",
           BRepAlgoAPI_Fuse(notchedCube(), upright({10, 5, 0}, 3, 7)).Shape(),
           {7, 5, 7},
           {0.3, 0.5, 0.2}},
          {"DomeOfFour", dome(4, 20), apex(20), {1, 2}, 0.2},
          {"SteepDomeOfThree", dome(3, 35), apex(35), {0.1, 0.5, 1}, 0.1},
          {"SteepDomeOfFive", dome(5, 35), apex(35), {0.2, 1, 1}, 3},
          {"SteepDomeOfSix", dome(6, 35), apex(35), {1, 0.1, 0.1}, 3}};
}

class CurvedCorners : public testing::TestWithParam<Case> {};

TEST_P(CurvedCorners, BecomeValidSolidsOfSmoothSeams) {
  const auto& [name, shape, corner, radii_mm, native_deg] = GetParam();
  const CornerFillet result = rounded(shape, corner, radii_mm);
  EXPECT_TRUE(result.met()) << result.shortfall;
  EXPECT_TRUE(result.fill.regular);
  EXPECT_EQ(result.model.shape.ShapeType(), shape.ShapeType());
  EXPECT_TRUE(BRepCheck_Analyzer(result.model.shape).IsValid());
  EXPECT_LT(result.largestAngle_rad(), 0.02 * degree);
  EXPECT_LT(result.largestGap_mm(), 5e-4);
  const occ::Report report = occ::analyze(result.model);
  EXPECT_TRUE(report.open.empty());
  EXPECT_TRUE(report.non_manifold.empty());

  // 2 m sides in two halves, 2 m spokes, and 2 contacts of each band at least.
  EXPECT_GE(result.seams.size(), 8 * result.edges.size());
  double size_mm3 = 0;
  for (const occ::CornerFilletEdge& edge : result.edges)
    size_mm3 += edge.contact_mm * edge.contact_mm * edge.setback_mm;
  const TopoDS_Shape theirs = native(shape, result.edges);
  ASSERT_FALSE(theirs.IsNull());
  EXPECT_NEAR(volume_mm3(result.model.shape), volume_mm3(theirs), size_mm3);
  if (native_deg > 0) {
    EXPECT_GT(largestAngle_deg(theirs), native_deg);
  }
}

INSTANTIATE_TEST_SUITE_P(All, CurvedCorners, testing::ValuesIn(cases()),
                         [](const testing::TestParamInfo<Case>& of) { return std::string(of.param.name); });

gp_Pnt centroid(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-9);
  return properties.CentreOfMass();
}

TEST(CurvedCorner, OfASymmetricSolidIsSymmetric) {
  const CornerFillet mirrored = rounded(boxLessBall(), {10, 0, 0}, {1});
  const gp_Pnt centre = centroid(mirrored.model.shape), before = centroid(boxLessBall());
  EXPECT_NEAR(centre.Y(), centre.Z(), 1e-7);
  EXPECT_GT(centre.Distance(before), 1e-4);
  const gp_Pnt of_dome = centroid(rounded(dome(4, 35), apex(35), {1}).model.shape);
  EXPECT_NEAR(of_dome.X(), 0, 1e-6);
  EXPECT_NEAR(of_dome.Y(), 0, 1e-6);
}

/// The same solid with its faces, and so its edges, in another order.
TopoDS_Shape reordered(const TopoDS_Shape& shape) {
  const TopTools_IndexedMapOfShape faces = parts(shape, TopAbs_FACE);
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (int k = faces.Extent(); k > 0; --k) sewing.Add(faces(k));
  sewing.Perform();
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape()));
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

TEST(CurvedCorner, DoesNotDependOnTheOrderOfTheEdges) {
  const auto roundedByLength = [](const TopoDS_Shape& shape) {
    const Model model = modelFromShape(shape);
    const int vertex = vertexAt(shape, {20, 0, 0});
    const TopTools_IndexedMapOfShape edges = parts(shape, TopAbs_EDGE);
    CornerFilletOptions options;
    for (const int edge : occ::cornerEdges(model, vertex)) {
      GProp_GProps properties;
      BRepGProp::LinearProperties(edges(edge), properties);
      options.radii_mm[edge] = properties.Mass() / 15;  // 20, 30 (the arc), 40 mm
    }
    return volume_mm3(cornerFillet(model, vertex, options).model.shape);
  };
  const TopoDS_Shape shape = wedge(20, 40), other = reordered(shape);
  EXPECT_NE(vertexAt(shape, {20, 0, 0}), vertexAt(other, {20, 0, 0}));
  EXPECT_NEAR(roundedByLength(shape), roundedByLength(other), 1e-5);
}

/// Identities (2) and (3) of cornerFillet(), to what OpenCASCADE's bands and the fits of the sides leave.
TEST(CurvedCorner, TakesTheSectionOfEachFillet) {
  const TopoDS_Shape given = wedge(20, 30);
  const CornerFillet here = rounded(given, {20, 0, 0}, {1, 2, 3});
  const CornerFillet longer = rounded(wedge(20, 40), {20, 0, 0}, {1, 2, 3});
  for (const occ::CornerFilletEdge& edge : here.edges) {
    const TopoDS_Edge& along = TopoDS::Edge(parts(given, TopAbs_EDGE)(edge.edge));
    const double height =
        BRep_Tool::Pnt(TopExp::LastVertex(along)).Z() + BRep_Tool::Pnt(TopExp::FirstVertex(along)).Z();
    if (height < 30) continue;
    const double section_mm2 = volume_mm3(native(given, {edge})) / 30;
    EXPECT_NEAR(volume_mm3(longer.model.shape) - volume_mm3(here.model.shape), 10 * section_mm2, 1e-3);
  }
}

TEST(CurvedCorner, MovesWithTheSolid) {
  std::mt19937 random(20261122);
  const std::vector<Case> all = cases();
  for (const std::size_t k : {0U, 6U}) {
    const Case& of = all[k];
    const CornerFillet here = rounded(of.shape, of.corner, of.radii_mm);
    for (const double scale : {1.0, 0.2, 10.0}) {
      gp_Trsf motion = randomMotion(random), size;
      size.SetScaleFactor(scale);
      motion.Multiply(size);
      const TopoDS_Shape moved = transformed(of.shape, motion);
      CornerFilletOptions options;
      options.tolerance.gap_mm *= scale;
      for (const occ::CornerFilletEdge& edge : here.edges)
        options.radii_mm[edge.edge] = scale * edge.radius_mm;
      const CornerFillet there = cornerFillet(modelFromShape(moved), vertexAt(of.shape, of.corner), options);
      EXPECT_TRUE(there.met()) << of.name << ' ' << scale << ": " << there.shortfall;
      EXPECT_NEAR(volume_mm3(there.model.shape) / std::pow(scale, 3), volume_mm3(here.model.shape),
                  1e-6 * volume_mm3(here.model.shape));
    }
  }
}

TEST(CurvedCorner, KeepsTheNamesOfFaces) {
  const TopoDS_Shape shape = wedge(20, 30);
  Model model = modelFromShape(shape);
  const TopTools_IndexedMapOfShape faces = parts(shape, TopAbs_FACE);
  for (int face = 1; face <= faces.Extent(); ++face) {
    const BRepAdaptor_Surface surface(TopoDS::Face(faces(face)));
    const bool curved = surface.GetType() == GeomAbs_Cylinder;
    model.attributes.push_back({TopAbs_FACE, face, curved ? "curved" : "flat", {}, {}});
  }
  const int vertex = vertexAt(shape, {20, 0, 0});
  const CornerFillet result = cornerFillet(model, vertex, withRadii(model, vertex, {1, 2, 3}));
  const TopTools_IndexedMapOfShape now = parts(result.model.shape, TopAbs_FACE);
  ASSERT_EQ(result.model.attributes.size(), model.attributes.size());
  for (const occ::ShapeAttribute& attribute : result.model.attributes) {
    const BRepAdaptor_Surface surface(TopoDS::Face(now(attribute.index)));
    if (attribute.name == "flat") {
      EXPECT_EQ(surface.GetType(), GeomAbs_Plane);
    } else {
      ASSERT_EQ(surface.GetType(), GeomAbs_Cylinder);
      EXPECT_NEAR(surface.Cylinder().Radius(), 20, 1e-9);
    }
  }
}

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::domain_error& error) {
    return error.what();
  }
  return "nothing thrown";
}

TEST(CurvedCorner, SaysWhatItCanNotDo) {
  const TopoDS_Shape shape = wedge(20, 30);
  const Model model = modelFromShape(shape);
  const int vertex = vertexAt(shape, {20, 0, 0});
  CornerFilletOptions options = withRadii(model, vertex, {2});
  const int edge = options.radii_mm.begin()->first;
  options.setbacks_mm[edge] = 2.01;
  EXPECT_THAT(refusal([&] { cornerFillet(model, vertex, options); }), HasSubstr("a setback of 2.010000 mm"));
  options.setbacks_mm[edge] = 100;
  EXPECT_THAT(refusal([&] { cornerFillet(model, vertex, options); }),
              HasSubstr("a setback of 100.000000 mm is beyond its end"));
  EXPECT_THAT(refusal([&] { cornerFillet(model, vertex, withRadii(model, vertex, {25})); }),
              HasSubstr("edge "));

  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(20, 0, 30, 1.5).Shape();
  EXPECT_THAT(refusal([&] {
                occ::cornerEdges(modelFromShape(cone), vertexAt(cone, {0, 0, 30}));
              }),
              HasSubstr("are needed"));

  const TopoDS_Shape hollow =
      BRepAlgoAPI_Cut(shape, BRepPrimAPI_MakeSphere(gp_Pnt(8, 8, 15), 2).Shape()).Shape();
  const Model with_void = modelFromShape(hollow);
  const int there = vertexAt(hollow, {20, 0, 0});
  EXPECT_THAT(refusal([&] { cornerFillet(with_void, there, withRadii(with_void, there, {1})); }),
              HasSubstr("the solid has 2 shells"));
}

}  // namespace
}  // namespace seamwright::test
