// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes across smooth joints of different surfaces: no single surface closes them. Angles are
// measured by OpenCASCADE's evaluation.
#include <gmock/gmock.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <algorithm>

#include "across_models.hpp"
#include "fill_checks.hpp"
#include "shapes.hpp"

#include <seamwright/occ_adapter/fill/fill.hpp>

namespace seamwright::test {
namespace {

using occ::FillHoleReport;
using occ::Hole;
using occ::modelFromShape;

FillHoleReport filled(const TopoDS_Shape& shape) {
  const std::vector<Hole> holes = occ::findHoles(shape).holes;
  return occ::fillHole(modelFromShape(shape),
                       *std::ranges::min_element(holes, {}, &Hole::length_mm));
}

void expectSmoothlyFilled(const TopoDS_Shape& sheet, const TopoDS_Wire& outline,
                          std::size_t faces = 5, double angle_deg = 0.002) {
  const FillHoleReport report = filled(cutThrough(sheet, outline));
  ASSERT_TRUE(report.reached) << textOf(report.reason);
  EXPECT_TRUE(report.regular);
  EXPECT_EQ(report.faces.size(), faces);
  EXPECT_TRUE(BRepCheck_Analyzer(report.model.shape).IsValid());
  EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), angle_deg * degree);
}

void expectFilledByOneFace(const TopoDS_Shape& sheet, const TopoDS_Wire& outline) {
  expectSmoothlyFilled(sheet, outline, 1, 0.01);
}

class EllipsesAcross : public testing::TestWithParam<int> {};

TEST_P(EllipsesAcross, AreFilledInASplineSheetInAnyDirection) {
  expectSmoothlyFilled(quarteredSheet(), ellipse(32, 32.0 / GetParam(), 0.4));
}

// Where both sides of the joint are cut there, the jump of its curvature does no harm.
TEST_P(EllipsesAcross, AreFilledAcrossAPlaneAndACylinder) {
  expectSmoothlyFilled(bentPlate(), ellipse(32, 32.0 / GetParam(), 0));
}

INSTANTIATE_TEST_SUITE_P(Lengths, EllipsesAcross, testing::Values(2, 3, 4));

// Cut where its lines meet its arcs, though the loop begins elsewhere.
TEST(HolesAcross, ASlotIsFilled) {
  expectSmoothlyFilled(quarteredSheet(), roundedRectangle(28, 8, 4, 0));
}

TEST(HolesAcross, AHalfDiscIsFilled) {
  expectSmoothlyFilled(quarteredSheet(), halfDisc(10, 0.4));
}

// Four lines and four arcs: no four polynomials meet them, one trimmed face does.
TEST(HolesAcross, ARoundedWindowIsFilled) {
  expectFilledByOneFace(quarteredSheet(), roundedRectangle(24, 14, 4, 0));
}

TEST(HolesAcross, AnElbowIsFilled) {
  expectFilledByOneFace(bentPlate(), elbow(24, 0.4));
}

TEST(HolesAcross, CornersThatWereTakenForSmoothAreNamed) {
  const TopoDS_Shape box = without(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), {1});
  const double corner_rad = 179 * degree;
  const occ::Holes found = occ::findHoles(box, {.corner_rad = corner_rad});
  ASSERT_EQ(found.holes.size(), 1U);
  const FillHoleReport report =
      occ::fillHole(modelFromShape(box), found.holes.front(), {.corner_rad = corner_rad});
  EXPECT_FALSE(report.filled);
  EXPECT_THAT(
      textOf(report.reason),
      testing::ContainsRegex("; edges [0-9]+ and [0-9]+ are one side, but turn by 90 degrees at "
                             "\\(.*\\) mm: a corner angle below that makes a corner of it$"));
}

}  // namespace
}  // namespace seamwright::test
