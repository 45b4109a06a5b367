// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes whose neighbours are not of one piece: they miss one another by a little, their planes
// differ at corners, or two of them share a side. By how much is known of how they were made;
// angles are measured by OpenCASCADE's evaluation at many points.
#include <gmock/gmock.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>
#include <numbers>

#include "fill_checks.hpp"
#include "shapes.hpp"

#include <seamwright/occ_adapter/fill/fill.hpp>

namespace seamwright::test {
namespace {

using occ::FillHoleReport;
using occ::Hole;

constexpr double degree = std::numbers::pi / 180;

struct Range {
  double from, to;
};

/// Beyond x = joint, along y = -half: kink (x - joint) (half - x) (y + half), nothing at both ends.
struct Twist {
  double kink = 0, joint = 0, half = 0;
};

/// z = 0.1 x^2 - 0.06 x y + 0.05 y^2 and the twist, exactly.
TopoDS_Shape graphFace(const Range& x, const Range& y, const Twist& twist = {}) {
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      // Polar forms of degree 2: of the monomial x its mean, of x^2 the product of both arguments.
      const double x1 = i < 2 ? x.from : x.to, x2 = i < 1 ? x.from : x.to,
                   y1 = j < 2 ? y.from : y.to, y2 = j < 1 ? y.from : y.to;
      const double xm = (x1 + x2) / 2, ym = (y1 + y2) / 2;
      const double bump = twist.kink *
                          ((twist.joint + twist.half) * xm - x1 * x2 - twist.joint * twist.half) *
                          (ym + twist.half);
      poles(i + 1, j + 1) = gp_Pnt(xm, ym, 0.1 * x1 * x2 - 0.06 * xm * ym + 0.05 * y1 * y2 + bump);
    }
  return BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7).Face();
}

/// Faces around the square of half the width \p half; those below it are given.
TopoDS_Shape around(double half, const std::vector<TopoDS_Shape>& below, double sewn_mm) {
  const std::array<Range, 3> ranges = {Range{-3 * half, -half}, {-half, half}, {half, 3 * half}};
  BRepBuilderAPI_Sewing sewing(sewn_mm);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != 1 || j == 2) sewing.Add(graphFace(ranges.at(i), ranges.at(j)));
  for (const TopoDS_Shape& face : below) sewing.Add(face);
  sewing.Perform();
  return sewing.SewedShape();
}

TopoDS_Shape moved(const TopoDS_Shape& face, const gp_Trsf& motion) {
  return BRepBuilderAPI_Transform(face, motion, true).Shape();
}

FillHoleReport filledInside(const TopoDS_Shape& shape, const occ::FillHoleOptions& options = {}) {
  const std::vector<Hole> holes = occ::findHoles(shape).holes;
  const auto inside = std::ranges::min_element(holes, {}, &Hole::length_mm);
  EXPECT_EQ(inside->sides.size(), 4U);
  return occ::fillHole(occ::modelFromShape(shape), *inside, options);
}

TEST(FillSides, NeighboursThatMissOneAnotherByALittleAreMetInLowDegrees) {
  constexpr double half = 0.3;
  for (const double off_mm : {2e-5, 5e-5, 8e-5}) {
    gp_Trsf lifted;
    lifted.SetTranslation(gp_Vec(0, 0, off_mm));
    const TopoDS_Shape below = moved(graphFace({-half, half}, {-3 * half, -half}), lifted);
    const FillHoleReport report = filledInside(around(half, {below}, 1e-2));
    ASSERT_TRUE(report.filled && report.reached) << off_mm << " mm: " << textOf(report.reason);
    for (const occ::FilledSide& side : report.sides)
      EXPECT_EQ(side.edge_degree, 3) << off_mm << " mm";
    // A cubic that begins half of that off its path leaves it by no steeper slope.
    EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), 2 * off_mm / (2 * half))
        << off_mm << " mm";
  }
}

TEST(FillSides, PlanesThatDifferAtCornersAreMetHalfway) {
  constexpr double half = 1.5;
  const gp_Pnt begin(-half, -half, 0.1 * half * half - 0.06 * half * half + 0.05 * half * half),
      end(half, -half, 0.1 * half * half + 0.06 * half * half + 0.05 * half * half);
  for (const double differ_deg : {0.004, 0.012, 0.03}) {
    gp_Trsf turned;
    turned.SetRotation(gp_Ax1(begin, gp_Dir(gp_Vec(begin, end))), differ_deg * degree);
    const TopoDS_Shape below = moved(graphFace({-half, half}, {-3 * half, -half}), turned);
    const FillHoleReport report = filledInside(around(half, {below}, 1e-2), {.keep_anyway = true});
    ASSERT_TRUE(report.filled) << differ_deg << " degrees: " << textOf(report.reason);
    const double angle_deg = largestAngle_rad(report.model.shape, report.faces) / degree;
    // The edges of both sides lie within the planes: those differ at the corners by a little less
    // than they were turned.
    EXPECT_LT(angle_deg, 0.505 * differ_deg) << differ_deg << " degrees";
    EXPECT_GT(angle_deg, 0.45 * differ_deg) << differ_deg << " degrees";
    EXPECT_EQ(report.reached, differ_deg < 0.02) << differ_deg << " degrees";
  }
}

TEST(FillSides, TwoNeighboursOfOneSideMayTwistUnlike) {
  constexpr double half = 1.5, joint = -1.1;
  const TopoDS_Shape shape =
      around(half,
             {graphFace({-half, joint}, {-3 * half, -half}),
              graphFace({joint, half}, {-3 * half, -half}, {0.003, joint, half})},
             1e-6);
  const FillHoleReport report = filledInside(shape);
  ASSERT_TRUE(report.filled && report.reached) << textOf(report.reason);
  EXPECT_EQ(std::ranges::count_if(
                report.sides, [](const occ::FilledSide& side) { return side.edges.size() == 2; }),
            1);
  EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), 0.01 * degree);
}

}  // namespace
}  // namespace seamwright::test
