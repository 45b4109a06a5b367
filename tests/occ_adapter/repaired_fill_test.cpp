// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes whose surroundings are repaired first.
#include <gmock/gmock.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>

#include <seamwright/occ_adapter/fill/holes.hpp>
#include <seamwright/occ_adapter/fill/repaired_fill.hpp>

namespace seamwright {
namespace {

using occ::FillHoleReport, occ::Hole, occ::Model;

/// Four planes around a square hole of 10 mm. Neighbours meet at a ridge of less than a degree.
Model flatPyramidWithoutTop() {
  constexpr double inner_mm = 5, outer_mm = 10, height_mm = 0.05;
  const auto corner = [](int k, double half_mm, double z_mm) {
    const double x = k % 4 == 0 || k % 4 == 3 ? half_mm : -half_mm,
                 y = k % 4 < 2 ? half_mm : -half_mm;
    return gp_Pnt(x, y, z_mm);
  };
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (int k = 0; k < 4; ++k) {
    BRepBuilderAPI_MakePolygon wire(corner(k, outer_mm, 0), corner(k + 1, outer_mm, 0),
                                    corner(k + 1, inner_mm, height_mm),
                                    corner(k, inner_mm, height_mm), true);
    sewing.Add(BRepBuilderAPI_MakeFace(wire.Wire(), true).Face());
  }
  sewing.Perform();
  return occ::modelFromShape(sewing.SewedShape());
}

TEST(RepairedFill, SeamsOfPlanesAreListedAsLeft) {
  const Model model = flatPyramidWithoutTop();
  const std::vector<Hole> holes = occ::findHoles(model.shape).holes;
  const auto inner = std::ranges::find_if(holes, [](const Hole& hole) { return !hole.longest; });
  ASSERT_NE(inner, holes.end());
  const FillHoleReport report = occ::repairedAndFilledHole(model, *inner, {});
  ASSERT_TRUE(report.around.has_value());
  EXPECT_FALSE(report.reached);
  EXPECT_EQ(report.around->edges.size(), 4U);
  EXPECT_EQ(report.around->treated, 4);
  EXPECT_EQ(report.around->repaired, 0);
  ASSERT_EQ(report.around->left.size(), 4U);
  for (const occ::LeftSeam& seam : report.around->left) {
    EXPECT_THAT(report.around->edges, testing::IsSupersetOf(seam.edges));
    EXPECT_EQ(seam.reason.fault, occ::RepairFault::FaceWithoutPoles);
    EXPECT_FALSE(seam.reason.text.empty());
  }
}

}  // namespace
}  // namespace seamwright
