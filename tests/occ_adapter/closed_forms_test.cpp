// SPDX-License-Identifier: LGPL-2.1-or-later
// Shapes of OpenCASCADE whose seams have answers in closed form.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <numbers>

#include <seamwright/core/seam/measure.hpp>

#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::SeamKind;
using occ::SeamResult;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<SeamResult> ofKind(const occ::Report& report, SeamKind kind) {
  std::vector<SeamResult> found;
  for (const SeamResult& seam : report.seams)
    if (seam.kind == kind) found.push_back(seam);
  return found;
}

/// \param norm_per_mm of the curvature of both sides.
void expectSmooth(const SeamResult& seam, double norm_per_mm) {
  SCOPED_TRACE(describe(seam));
  EXPECT_EQ(seam.verdict.level, Level::G2);
  EXPECT_EQ(seam.verdict.seam_class, SeamClass::Smooth);
  ASSERT_TRUE(seam.figures.gap_mm && seam.figures.angle_rad && seam.figures.curvature_per_mm);
  const ContinuityTolerance tolerance;
  expectEncloses(seam.figures.gap_mm, 0, tolerance.gap_mm, 1e-12);
  expectEncloses(seam.figures.angle_rad, 0, tolerance.angle_rad, 1e-12);
  expectEncloses(seam.figures.curvature_per_mm, 0, tolerance.curvature_rel * norm_per_mm, 1e-12);
  EXPECT_TRUE(seam.figures.certified && seam.verdict.certain);
}

void expectCrease(const SeamResult& seam, double angle_deg) {
  SCOPED_TRACE(describe(seam));
  EXPECT_EQ(seam.verdict.level, Level::G0);
  EXPECT_EQ(seam.verdict.seam_class, SeamClass::Crease);
  expectEncloses(seam.figures.angle_rad, angle_deg * degree, 0.1 * degree, 1e-11);
  EXPECT_TRUE(seam.figures.certified && seam.verdict.certain);
  EXPECT_FALSE(seam.figures.curvature_per_mm);
  EXPECT_FALSE(seam.figures.curvature_rel);
}

TEST(ClosedForms, BoxHasTwelveRightAngles) {
  const occ::Report report = analyzed(BRepPrimAPI_MakeBox(10, 20, 30).Shape());
  ASSERT_EQ(report.seams.size(), 12u);
  double length = 0;
  for (const SeamResult& seam : report.seams) {
    expectCrease(seam, 90);
    EXPECT_EQ(seam.kind, SeamKind::Shared);
    EXPECT_LT(seam.figures.gap_mm->lower, 1e-12);
    length += seam.length_mm;
  }
  EXPECT_NEAR(length, 4 * (10 + 20 + 30), 1e-9);
  EXPECT_TRUE(report.open.empty());
  EXPECT_TRUE(report.passed()) << "creases are not defects";
}

TEST(ClosedForms, CylinderHasASmoothSeamAndTwoRims) {
  const occ::Report report = analyzed(BRepPrimAPI_MakeCylinder(7, 20).Shape());
  ASSERT_EQ(report.seams.size(), 3u);
  const std::vector<SeamResult> closed = ofKind(report, SeamKind::Closed);
  ASSERT_EQ(closed.size(), 1u);
  expectSmooth(closed[0], 1 / 7.0);
  EXPECT_EQ(closed[0].faces[0], closed[0].faces[1]);
  EXPECT_NEAR(closed[0].length_mm, 20, 1e-9);
  for (const SeamResult& rim : ofKind(report, SeamKind::Shared)) {
    expectCrease(rim, 90);
    EXPECT_NEAR(rim.length_mm, 2 * std::numbers::pi * 7, 1e-6);
  }
}

TEST(ClosedForms, AnglesWithoutBoundsOfTheCurvatureStayEnclosed) {
  // At 90 degrees no normal of one side tells which of the other's it is to be aligned with;
  // nothing is sharper than 90 degrees.
  ContinuityTolerance tolerance;
  tolerance.crease_rad = std::numbers::pi / 2;
  const occ::Report report =
      occ::analyze(occ::modelFromShape(BRepPrimAPI_MakeBox(5, 6, 10).Shape()), {tolerance});
  ASSERT_EQ(report.seams.size(), 12u);
  for (const SeamResult& seam : report.seams) {
    SCOPED_TRACE(describe(seam));
    expectEncloses(seam.figures.gap_mm, 0, tolerance.gap_mm, 1e-12);
    expectEncloses(seam.figures.angle_rad, std::numbers::pi / 2, tolerance.angle_rad, 1e-12);
    EXPECT_EQ(seam.verdict.level, Level::G0);
    EXPECT_FALSE(seam.figures.certified);
  }
}

TEST(ClosedForms, SphereIsSmoothAlsoAtItsPoles) {
  const occ::Report report = analyzed(BRepPrimAPI_MakeSphere(10).Shape());
  ASSERT_EQ(report.seams.size(), 1u) << "the poles are degenerated edges and no seams";
  expectSmooth(report.seams[0], 1 / 10.0);
  EXPECT_EQ(report.seams[0].kind, SeamKind::Closed);
  EXPECT_EQ(report.seams[0].note, "")
      << "a sphere has a tangent plane at the poles of its parameters";
  EXPECT_EQ(report.seams[0].figures.plane_share, 1);
  EXPECT_NEAR(report.seams[0].length_mm, 10 * std::numbers::pi, 1e-6);
  EXPECT_TRUE(report.open.empty());
}

TEST(ClosedForms, ConeNamesItsApex) {
  const double radius = 5, height = 12;
  const occ::Report report = analyzed(BRepPrimAPI_MakeCone(radius, 0, height).Shape());
  ASSERT_EQ(report.seams.size(), 2u);
  const std::vector<SeamResult> closed = ofKind(report, SeamKind::Closed);
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_EQ(closed[0].verdict.level, Level::G2) << describe(closed[0]);
  EXPECT_THAT(closed[0].note, HasSubstr("vanishing normal on face 1 at the end of the seam"));
  EXPECT_TRUE(closed[0].figures.certified && closed[0].verdict.certain) << describe(closed[0]);
  EXPECT_GT(closed[0].figures.plane_share, 1 - 1e-4);
  EXPECT_THAT(closed[0].note, Not(HasSubstr(";"))) << "one end alone";
  const SeamResult base = ofKind(report, SeamKind::Shared).at(0);
  expectCrease(base, 90 - std::atan(radius / height) / degree);
}

TEST(ClosedForms, TorusHasTwoSmoothClosedSeams) {
  const occ::Report report = analyzed(BRepPrimAPI_MakeTorus(20, 6).Shape());
  ASSERT_EQ(report.seams.size(), 2u);
  std::vector<double> lengths;
  for (const SeamResult& seam : report.seams) {
    EXPECT_EQ(seam.kind, SeamKind::Closed);
    expectSmooth(seam, 1 / 6.0);
    EXPECT_EQ(seam.note, "");
    lengths.push_back(seam.length_mm / (2 * std::numbers::pi));
  }
  // The parallel at angle 0 of the tube runs at radius 26, the meridian is the tube's circle.
  EXPECT_THAT(lengths, ::testing::UnorderedElementsAre(::testing::DoubleNear(26, 1e-5),
                                                       ::testing::DoubleNear(6, 1e-5)));
}

TEST(ClosedForms, FilletedBoxIsTangentWithTheCurvatureOfTheFillet) {
  const double r = 3;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(20, 30, 40).Shape();
  BRepFilletAPI_MakeFillet rounded(box);
  for (TopExp_Explorer it(box, TopAbs_EDGE); it.More(); it.Next())
    rounded.Add(r, TopoDS::Edge(it.Current()));
  const occ::Report report = analyzed(rounded.Shape());
  EXPECT_EQ(report.model.faces, 6 + 12 + 8);
  // 24 lines between planes and cylinders, 24 arcs between cylinders and spheres.
  ASSERT_EQ(report.seams.size(), 48u);
  for (const SeamResult& seam : report.seams) {
    SCOPED_TRACE(describe(seam));
    EXPECT_EQ(seam.verdict.level, Level::G1);
    EXPECT_EQ(seam.verdict.seam_class, SeamClass::Smooth);
    EXPECT_LT(angleDeg(seam), 1e-5);
    expectEncloses(seam.figures.curvature_per_mm, 1 / r, report.tolerance.curvature_rel / r, 1e-6);
    expectEncloses(seam.figures.curvature_rel, 1, report.tolerance.curvature_rel, 1e-5);
    EXPECT_TRUE(seam.figures.certified && seam.verdict.certain);
  }
}

/// The jet of an OpenCASCADE surface as core takes it, written out here.
SidePoint sideOf(const opencascade::handle<Geom_Surface>& surface, double u, double v) {
  gp_Pnt p;
  gp_Vec du, dv, duu, dvv, duv;
  surface->D2(u, v, p, du, dv, duu, dvv, duv);
  const auto vec = [](const auto& x) { return Eigen::Vector3d(x.X(), x.Y(), x.Z()); };
  SidePoint side;
  side.jet.p = vec(p);
  side.jet.u = vec(du);
  side.jet.v = vec(dv);
  side.jet.uu = vec(duu);
  side.jet.uv = vec(duv);
  side.jet.vv = vec(dvv);
  return side;
}

TEST(ClosedForms, CrossedCylindersDifferBySinPhiOverRInAnyOrientation) {
  std::mt19937 random(testSeed());
  const double r = 10;
  for (int trial = 0; trial < 200; ++trial) {
    const gp_Trsf motion = randomMotion(random);
    for (const double phi : {90.0, 45.0, 30.0, 1.0}) {
      const gp_Ax3 axis_a(gp_Pnt(0, 0, -r), gp::DX(), gp::DZ());
      const gp_Dir tilted(std::cos(phi * degree), std::sin(phi * degree), 0);
      const gp_Ax3 axis_b(gp_Pnt(0, 0, -r), trial % 2 ? tilted : tilted.Reversed(), gp::DZ());
      opencascade::handle<Geom_Surface> a =
          new Geom_CylindricalSurface(axis_a.Transformed(motion), r);
      opencascade::handle<Geom_Surface> b =
          new Geom_CylindricalSurface(axis_b.Transformed(motion), r);
      if (trial % 3 == 0) a = a->UReversed();
      if (trial % 5 == 0) b = b->VReversed();
      // Both reversals keep the point of the parameters (0, 0).
      const PairMeasure pair = measurePair(sideOf(a, 0, 0), sideOf(b, 0, 0));
      ASSERT_TRUE(pair.curvature && pair.angle_rad);
      EXPECT_LT(*pair.gap_mm, 1e-12);
      EXPECT_LT(*pair.angle_rad, 1e-13);
      EXPECT_NEAR(pair.curvature->difference_per_mm, std::sin(phi * degree) / r, 1e-14);
      EXPECT_NEAR(relativeDifference(*pair.curvature, 1e5), std::sin(phi * degree), 1e-12);
    }
  }
}

TEST(ClosedForms, SpheresOfNearlyEqualRadiusDifferByTheirCurvatures) {
  std::mt19937 random(testSeed());
  for (int trial = 0; trial < 200; ++trial) {
    const gp_Trsf motion = randomMotion(random);
    const gp_Ax3 small(gp_Pnt(-10, 0, 0), gp::DZ(), gp::DX()),
        large(gp_Pnt(-10.001, 0, 0), gp::DZ(), gp::DX());
    opencascade::handle<Geom_Surface> a = new Geom_SphericalSurface(small.Transformed(motion), 10);
    opencascade::handle<Geom_Surface> b =
        new Geom_SphericalSurface(large.Transformed(motion), 10.001);
    if (trial % 2) b = b->UReversed();
    const PairMeasure pair = measurePair(sideOf(a, 0, 0), sideOf(b, 0, 0));
    ASSERT_TRUE(pair.curvature);
    EXPECT_LT(*pair.gap_mm, 1e-12);
    EXPECT_NEAR(pair.curvature->difference_per_mm, 1 / 10.0 - 1 / 10.001, 1e-14);
  }
}

}  // namespace
}  // namespace seamwright::test
