// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners whose faces are curved, or whose edges end among others.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <cmath>
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

struct Case {
  const char* name;
  TopoDS_Shape shape;
  Vector3d corner;
  std::vector<double> radii_mm;
};

std::ostream& operator<<(std::ostream& stream, const Case& of) {
  return stream << of.name;
}

TopoDS_Shape box(double x, double y, double z) {
  return BRepPrimAPI_MakeBox(x, y, z).Shape();
}

/// With seam and poles outside of the first octant, about the origin.
TopoDS_Shape ball(double radius) {
  return BRepPrimAPI_MakeSphere(gp_Ax2(gp::Origin(), gp_Dir(1, -1, 0), gp_Dir(-1, -1, -1)), radius).Shape();
}

/// A pointed dome of cylindrical gores, its apex above the origin.
TopoDS_Shape dome(int gores) {
  TopoDS_Shape shape = BRepPrimAPI_MakeBox(gp_Pnt(-60, -60, 0), gp_Pnt(60, 60, 60)).Shape();
  for (int k = 0; k < gores; ++k) {
    const double angle = 2 * std::numbers::pi * k / gores;
    const gp_Dir away(std::cos(angle), std::sin(angle), 0), along(-std::sin(angle), std::cos(angle), 0);
    const gp_Pnt start = gp_Pnt(0, 0, 0).Translated(gp_Vec(away) * 20 - gp_Vec(along) * 80);
    shape = BRepAlgoAPI_Common(shape, BRepPrimAPI_MakeCylinder(gp_Ax2(start, along, away), 40, 160).Shape())
                .Shape();
  }
  return shape;
}

std::vector<Case> cases() {
  return {
      {"QuarterCylinder", BRepPrimAPI_MakeCylinder(20, 30, 1.5).Shape(), {20, 0, 0}, {1, 2, 3}},
      {"QuarterCylinderEqual", BRepPrimAPI_MakeCylinder(20, 30, 1.5).Shape(), {20, 0, 0}, {2}},
      {"QuarterCone", BRepPrimAPI_MakeCone(20, 10, 30, 1.5).Shape(), {20, 0, 0}, {1, 2, 3}},
      {"BoxLessBall", BRepAlgoAPI_Cut(box(20, 20, 20), ball(10)).Shape(), {10, 0, 0}, {1}},
      {"BoxLessBallUnequal", BRepAlgoAPI_Cut(box(20, 20, 20), ball(10)).Shape(), {0, 10, 0}, {1, 0.5, 2}},
      {"Octant", BRepAlgoAPI_Common(box(20, 20, 20), ball(15)).Shape(), {15, 0, 0}, {1}},
      {"OctantUnequal", BRepAlgoAPI_Common(box(20, 20, 20), ball(15)).Shape(), {15, 0, 0}, {0.5, 1, 2}},
      {"PyramidBase", regularPyramid(4, 10), {10, 0, 0}, {1}},
      {"BoxLessCylinder",
       BRepAlgoAPI_Cut(box(40, 40, 20),
                       BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 20, -1), gp::DZ()), 10, 30).Shape())
           .Shape(),
       {0, 10, 20},
       {1, 2, 1.5}},
      {"TwoCylinders",
       BRepAlgoAPI_Common(
           BRepAlgoAPI_Common(
               BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -30), gp::DZ(), gp_Dir(-1, -1, 0)), 20, 60)
                   .Shape(),
               BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-30, 0, 0), gp::DX(), gp_Dir(0, -1, -1)), 15, 60)
                   .Shape())
               .Shape(),
           box(40, 40, 40))
           .Shape(),
       {20, 0, 15},
       {1, 2, 1.5}},
      {"BlockOnCylinder",
       BRepAlgoAPI_Fuse(
           BRepPrimAPI_MakeCylinder(gp_Ax2(gp::Origin(), gp::DZ(), gp_Dir(-1, 0, 0)), 20, 20).Shape(),
           BRepPrimAPI_MakeBox(gp_Pnt(0, -5, 5), gp_Pnt(30, 5, 15)).Shape())
           .Shape(),
       {std::sqrt(375.0), 5, 15},
       {1, 2, 1}},
      {"DomeOfFour", dome(4), {0, 0, std::sqrt(1200.0)}, {1}},
      {"DomeOfFourUnequal", dome(4), {0, 0, std::sqrt(1200.0)}, {1, 2}},
      {"DomeOfFive", dome(5), {0, 0, std::sqrt(1200.0)}, {1, 2}},
      {"X1", BRepAlgoAPI_Cut(box(20, 20, 20), ball(10)).Shape(), {10, 0, 0}, {0.1, 1, 2}},
      {"X2", BRepAlgoAPI_Cut(box(20, 20, 20), ball(10)).Shape(), {10, 0, 0}, {3, 0.2, 0.2}},
      {"X3", BRepAlgoAPI_Common(box(20, 20, 20), ball(15)).Shape(), {15, 0, 0}, {0.1, 2, 1}},
      {"X4", BRepPrimAPI_MakeCylinder(20, 30, 0.5).Shape(), {20, 0, 0}, {1, 3, 0.2}},
      {"X5", BRepPrimAPI_MakeCylinder(20, 30, 0.5).Shape(), {0, 0, 0}, {0.2, 1, 0.1}},
      {"X6", BRepPrimAPI_MakeCone(20, 2, 30, 1.0).Shape(), {20, 0, 0}, {0.3, 3, 1}},
      {"X7", dome(3), {0, 0, std::sqrt(1200.0)}, {0.2, 1, 2}},
      {"X8", dome(4), {0, 0, std::sqrt(1200.0)}, {0.2, 2, 1}},
      {"X9", dome(5), {0, 0, std::sqrt(1200.0)}, {0.2, 2, 1}},
      {"X10", dome(6), {0, 0, std::sqrt(1200.0)}, {0.2, 2, 1}},
      {"X11",
       BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(gp_Ax2(gp::Origin(), gp::DZ(), gp_Dir(-1, 0, 0)), 20, 20).Shape(),
                        BRepPrimAPI_MakeBox(gp_Pnt(0, -5, 5), gp_Pnt(30, 5, 15)).Shape())
           .Shape(),
       {std::sqrt(375.0), 5, 15},
       {0.1, 2, 1}},
      {"X12",
       BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(gp_Ax2(gp::Origin(), gp::DZ(), gp_Dir(-1, 0, 0)), 20, 20).Shape(),
                        BRepPrimAPI_MakeBox(gp_Pnt(0, -5, 5), gp_Pnt(30, 5, 15)).Shape())
           .Shape(),
       {std::sqrt(375.0), 5, 15},
       {2, 0.3, 2}},
      {"X13",
       BRepAlgoAPI_Cut(box(40, 40, 20), BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 20, -1), gp::DZ()), 10, 30).Shape()).Shape(),
       {0, 10, 20},
       {3, 0.1, 1}},
      {"X14", regularPyramid(5, 20), {10, 0, 0}, {1,0.2,2}},
      {"X15", regularPyramid(6, 20), {10, 0, 0}, {0.2,1,2}},
      {"DomeOfSix", dome(6), {0, 0, std::sqrt(1200.0)}, {0.5, 1, 1}},
  };
}

class CurvedCorners : public testing::TestWithParam<Case> {};

TEST_P(CurvedCorners, BecomeValidSolidsOfSmoothSeams) {
  const auto& [name, shape, corner, radii_mm] = GetParam();
  const CornerFillet result = rounded(shape, corner, radii_mm);
  BRepTools::Write(result.model.shape, (std::string("/tmp/wc/") + name + ".brep").c_str());
  EXPECT_TRUE(result.met()) << result.shortfall;
  EXPECT_TRUE(BRepCheck_Analyzer(result.model.shape).IsValid());
  const occ::Report report = occ::analyze(result.model);
  EXPECT_TRUE(report.open.empty());
  std::cout << name << ": angle " << result.largestAngle_rad() / degree << " deg, gap "
            << result.largestGap_mm() << " volume " << volume_mm3(shape) << " -> "
            << volume_mm3(result.model.shape);
  for (const auto& edge : result.edges)
    std::cout << " [" << edge.edge << (edge.convex ? " convex " : " concave ") << edge.radius_mm << ' '
              << edge.contact_mm << ' ' << edge.setback_mm << ']';
  try {
    const Model model = modelFromShape(shape);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    BRepFilletAPI_MakeFillet fillet(shape);
    for (const occ::CornerFilletEdge& edge : result.edges)
      fillet.Add(edge.radius_mm, TopoDS::Edge(edges(edge.edge)));
    fillet.Build();
    std::cout << " theirs: " << fillet.IsDone();
    if (fillet.IsDone())
      std::cout << ' ' << BRepCheck_Analyzer(fillet.Shape()).IsValid() << ' ' << volume_mm3(fillet.Shape());
  } catch (const Standard_Failure& failure) {
    std::cout << " theirs: " << failure.DynamicType()->Name();
  }
  std::cout << std::endl;
}

INSTANTIATE_TEST_SUITE_P(All, CurvedCorners, testing::ValuesIn(cases()),
                         [](const testing::TestParamInfo<Case>& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace seamwright::test
