// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners with curved faces of solids with voids: what is rounded is what is rounded without them.
// And corners of small size.
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
    const TopoDS_Edge of = TopoDS::Edge(parts(shape, TopAbs_EDGE)(edge));
    const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(of)),
                 b = BRep_Tool::Pnt(TopExp::LastVertex(of));
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
  EXPECT_TRUE(with.met()) << with.shortfall.text;
  EXPECT_TRUE(BRepCheck_Analyzer(with.model.shape).IsValid());
  EXPECT_EQ(parts(with.model.shape, TopAbs_SHELL).Extent(), 2);
  EXPECT_NEAR(volume_mm3(with.model.shape),
              volume_mm3(without.model.shape) - 32 * std::numbers::pi / 3, 1e-4);
}

/// What is cut off the wedge is left in the block.
TEST(CornerOfShells, InTheWallOfAVoidIsTheOneOfWhatFillsIt) {
  const CornerFillet wall = roundedByDirection(mould()),
                     wedge_alone = roundedByDirection(wedge(20, 30));
  EXPECT_TRUE(wall.met()) << wall.shortfall.text;
  EXPECT_TRUE(BRepCheck_Analyzer(wall.model.shape).IsValid());
  EXPECT_EQ(parts(wall.model.shape, TopAbs_SHELL).Extent(), 2);
  EXPECT_NEAR(volume_mm3(wall.model.shape), 50 * 50 * 50 - volume_mm3(wedge_alone.model.shape),
              5e-4);

  const std::vector<int> edges =
      occ::cornerEdges(modelFromShape(mould()), vertexAt(mould(), corner));
  ASSERT_EQ(wall.edges.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(wall.edges[i].edge, edges[i]);
    EXPECT_FALSE(wall.edges[i].convex);
    EXPECT_TRUE(wedge_alone.edges[i].convex);
  }
}

/// Patch k begins side k and ends the one before, counter-clockwise seen from outside: its normal
/// points into the solid or out of it, for both shells the same.
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
      BRepAlgoAPI_Cut(wedge(20, 30), BRepPrimAPI_MakeSphere(gp_Pnt(17, 1.3, 1.3), 1).Shape())
          .Shape();
  const Model model = modelFromShape(close);
  const int vertex = vertexAt(close, corner);
  EXPECT_THAT(cornerFillet(model, vertex, withRadii(model, vertex, {4})).shortfall.text,
              HasSubstr("runs into face "));
}

/// Smaller than the gap that is allowed: ends of sides are not to be taken for one.
TEST(SmallCorner, IsRoundedAsALargeOne) {
  for (const double size : {0.03, 0.003, 1e-4}) {
    const CornerFillet result = rounded(wedge(20, 30), corner, {size, 2 * size, 3 * size});
    EXPECT_TRUE(result.met()) << size << ": " << result.shortfall.text;
    EXPECT_LT(result.largestGap_mm(), 0.03 * size) << size;
  }
}

TEST(SmallCorner, OfASmallSolidIsThatOfALargeOne) {
  const double large_mm3 = volume_mm3(rounded(wedge(20, 30), corner, {1, 2, 3}).model.shape);
  for (const double scale : {0.03, 0.001}) {
    gp_Trsf size;
    size.SetScaleFactor(scale);
    const CornerFillet result =
        rounded(transformed(wedge(20, 30), size), scale * corner, {scale, 2 * scale, 3 * scale});
    EXPECT_TRUE(result.met()) << scale << ": " << result.shortfall.text;
    EXPECT_NEAR(volume_mm3(result.model.shape) / std::pow(scale, 3), large_mm3, 0.05) << scale;
  }
}

TEST(SmallCorner, BelowWhatOpenCascadeTellsApartSaysSo) {
  try {
    rounded(wedge(20, 30), corner, {1e-5, 2e-5, 3e-5});
    FAIL() << "rounded";
  } catch (const std::domain_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("edge 8, radius 3e-05 mm"));
  }
}

}  // namespace
}  // namespace seamwright::test
