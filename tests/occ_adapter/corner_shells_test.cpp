// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners with curved faces of solids with voids: what is rounded is what is rounded without them. And corners of small size.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <numbers>

#include "corner_solids.hpp"
#include "curved_corners.hpp"
#include "shapes.hpp"

namespace seamwright::test {
namespace {

using Eigen::Vector3d;
using occ::CornerFillet;
using occ::cornerFillet;
using occ::CornerFilletOptions;
using occ::Model;
using occ::modelFromShape;
using testing::HasSubstr;

const Vector3d corner(20, 0, 0);

TopoDS_Shape bubble() {
  return BRepPrimAPI_MakeSphere(gp_Pnt(8, 8, 15), 2).Shape();
}

/// A block with a void of the form of wedge(20, 30).
TopoDS_Shape mould() {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, -10), gp_Pnt(40, 40, 40)).Shape();
  return BRepAlgoAPI_Cut(block, wedge(20, 30)).Shape();
}

/// 1 mm for the edge to the axis, 2 for the arc, 3 for the upright edge.
CornerFilletOptions byDirection(const TopoDS_Shape& shape) {
  const Model model = modelFromShape(shape);
  CornerFilletOptions options;
  for (const int edge : occ::cornerEdges(model, vertexAt(shape, corner))) {
    const TopoDS_Edge& of = TopoDS::Edge(parts(shape, TopAbs_EDGE)(edge));
    const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(of)), b = BRep_Tool::Pnt(TopExp::LastVertex(of));
    options.radii_mm[edge] = a.Z() + b.Z() > 20 ? 3 : a.Y() + b.Y() > 10 ? 2 : 1;
  }
  return options;
}

CornerFillet roundedByDirection(const TopoDS_Shape& shape) {
  return cornerFillet(modelFromShape(shape), vertexAt(shape, corner), byDirection(shape));
}

TEST(CornerOfShells, IsThatOfTheOuterOneAlone) {
  const TopoDS_Shape solid = wedge(20, 30), hollow = BRepAlgoAPI_Cut(solid, bubble()).Shape();
  ASSERT_EQ(parts(hollow, TopAbs_SHELL).Extent(), 2);
  const CornerFillet with = roundedByDirection(hollow), without = roundedByDirection(solid);
  EXPECT_TRUE(with.met()) << with.shortfall;
  EXPECT_TRUE(BRepCheck_Analyzer(with.model.shape).IsValid());
  EXPECT_EQ(parts(with.model.shape, TopAbs_SHELL).Extent(), 2);
  EXPECT_NEAR(volume_mm3(with.model.shape), volume_mm3(without.model.shape) - 32 * std::numbers::pi / 3,
              1e-5);
}

/// What is cut off the wedge is left in the block.
TEST(CornerOfShells, InTheWallOfAVoidIsTheOneOfWhatFillsIt) {
  const CornerFillet wall = roundedByDirection(mould()), wedge_alone = roundedByDirection(wedge(20, 30));
  EXPECT_TRUE(wall.met()) << wall.shortfall;
  EXPECT_TRUE(BRepCheck_Analyzer(wall.model.shape).IsValid());
  EXPECT_EQ(parts(wall.model.shape, TopAbs_SHELL).Extent(), 2);
  EXPECT_NEAR(volume_mm3(wall.model.shape), 50 * 50 * 50 - volume_mm3(wedge_alone.model.shape), 1e-5);

  const std::vector<int> edges = occ::cornerEdges(modelFromShape(mould()), vertexAt(mould(), corner));
  ASSERT_EQ(wall.edges.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(wall.edges[i].edge, edges[i]);
    EXPECT_FALSE(wall.edges[i].convex);
    EXPECT_TRUE(wedge_alone.edges[i].convex);
  }
}

/// Patch k begins side k and ends the one before, counter-clockwise seen from outside: its normal points into the solid or out of it, for
/// both shells the same.
TEST(CornerOfShells, HasItsPatchesInOrder) {
  const TopoDS_Shape solid = wedge(20, 30);
  const Vector3d inward = (Vector3d(8, 8, 15) - corner).normalized();
  double sense = 0;
  for (const TopoDS_Shape& shape : {solid, mould()}) {
    const CornerFillet result = roundedByDirection(shape);
    const std::vector<BezierPatch>& patches = result.fill.patches;
    ASSERT_EQ(patches.size(), 6U);
    const double out = shape.IsSame(solid) ? -1 : 1;
    for (std::size_t k = 0; k < patches.size(); ++k) {
      const BezierPatch& next = patches[(k + 1) % patches.size()];
      EXPECT_LT((patches[k].point(0, 1) - next.point(1, 0)).norm(), 1e-6);
      EXPECT_LT((patches[k].point(0, 0) - next.point(0, 0)).norm(), 1e-12);
      const Vector3d u = patches[k].point(0.51, 0.5) - patches[k].point(0.49, 0.5),
                     v = patches[k].point(0.5, 0.51) - patches[k].point(0.5, 0.49);
      const double side = out * u.cross(v).dot(inward);
      if (sense == 0) sense = side;
      EXPECT_GT(side * sense, 0) << k;
    }
  }
}

TEST(CornerOfShells, ThatRunsIntoAVoidIsNone) {
  const TopoDS_Shape close =
      BRepAlgoAPI_Cut(wedge(20, 30), BRepPrimAPI_MakeSphere(gp_Pnt(17, 1.3, 1.3), 1).Shape()).Shape();
  const Model model = modelFromShape(close);
  const int vertex = vertexAt(close, corner);
  EXPECT_THAT(cornerFillet(model, vertex, withRadii(model, vertex, {4})).shortfall,
              HasSubstr("runs into face "));
}

TEST(SmallCorner, Probe) {
  for (const double r : {0.1, 0.03, 0.01, 0.003, 0.001, 1e-4, 1e-5}) {
    try {
      const CornerFillet result = rounded(wedge(20, 30), corner, {r, 2 * r, 3 * r});
      std::printf("r %g met %d %s | %g\n", r, result.met(), result.shortfall.c_str(), result.largestGap_mm());
    } catch (const std::exception& e) {
      std::printf("r %g: %s\n", r, e.what());
    }
  }
  for (const double s : {0.1, 0.03, 0.01, 0.003, 0.001}) {
    gp_Trsf size;
    size.SetScaleFactor(s);
    const TopoDS_Shape shape = transformed(wedge(20, 30), size);
    try {
      const CornerFillet result = rounded(shape, s * corner, {s, 2 * s, 3 * s});
      std::printf("s %g met %d %s\n", s, result.met(), result.shortfall.c_str());
    } catch (const std::exception& e) {
      std::printf("s %g: %s\n", s, e.what());
    }
  }
}

}  // namespace
}  // namespace seamwright::test
