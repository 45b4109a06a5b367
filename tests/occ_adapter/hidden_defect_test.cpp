// SPDX-License-Identifier: LGPL-2.1-or-later
// Defects that a coarse look along the seam passes over, and folds, which only look smooth.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <cmath>
#include <gp.hxx>
#include <numbers>

#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::SeamResult;
using ::testing::HasSubstr;

/// Knots of a cubic: 160 spans, eight of which, off the middle, are a quarter as long as the
/// others.
std::vector<double> knotsWithAFinePart() {
  std::vector<double> knots = {0};
  for (int span = 0; span < 160; ++span)
    knots.push_back(knots.back() + (span >= 60 && span < 68 ? 0.25 : 1));
  return knots;
}

std::vector<double> uniformKnots(int spans) {
  std::vector<double> knots;
  for (int k = 0; k <= spans; ++k) knots.push_back(k);
  return knots;
}

constexpr int fine_pole =
    66;  ///< from 1; its four spans, the knots 62 to 66, are of the short ones

constexpr double pole_spacing = 2;  // across the seam

/// The plane z = 0 over [0, 6] x [0, last knot] as a bicubic B-spline: u across, v along, v the
/// length in mm.
opencascade::handle<Geom_BSplineSurface> planeWithKnots(const std::vector<double>& knots) {
  const int spans = static_cast<int>(knots.size()) - 1;
  const int along = spans + 3;
  std::vector<double> flat(3, knots.front());
  flat.insert(flat.end(), knots.begin(), knots.end());
  flat.insert(flat.end(), 3, knots.back());
  NCollection_Array2<gp_Pnt> poles(1, 4, 1, along);
  for (int j = 0; j < along; ++j) {
    const double greville = (flat[j + 1] + flat[j + 2] + flat[j + 3]) / 3;
    for (int i = 0; i < 4; ++i) poles(i + 1, j + 1) = gp_Pnt(pole_spacing * i, greville, 0);
  }
  NCollection_Array1<double> knots_u(1, 2), knots_v(1, spans + 1);
  knots_u(1) = 0;
  knots_u(2) = 1;
  for (int k = 0; k <= spans; ++k) knots_v(k + 1) = knots[k];
  NCollection_Array1<int> ends(1, 2), simple(1, spans + 1);
  ends.Init(4);
  simple.Init(1);
  simple(1) = simple(spans + 1) = 4;
  return new Geom_BSplineSurface(poles, knots_u, knots_v, ends, simple, 3, 3);
}

void lift(const opencascade::handle<Geom_BSplineSurface>& surface, int row, int column, double by) {
  const gp_Pnt pole = surface->Pole(row, column);
  surface->SetPole(row, column, pole.Translated(gp_Vec(0, 0, by)));
}

/// The surface joined along u = 0 to the plane z = 0 beyond it.
TopoDS_Shape joinedToPlane(const opencascade::handle<Geom_BSplineSurface>& surface) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface->Bounds(u0, u1, v0, v1);
  const opencascade::handle<Geom_Surface> plane = new Geom_Plane(gp::XOY());
  const opencascade::handle<Geom_Surface> sheet(surface.get());
  return joined({sheet, beginningWith(3, rectangle(u0, u1, v0, v1))},
                {plane, beginningWith(1, rectangle(-6, 0, v0, v1))});
}

/// At the seam X_u = 3 (pole row 1 - pole row 0), so one pole of row 1 lifted by h tilts the normal
/// by atan(h N / spacing), N the cubic B-spline of that pole, whose maximum over equal spans is
/// 2/3.
SeamResult seamWithTilt(const std::vector<double>& knots, int pole, double tilt_deg) {
  const auto surface = planeWithKnots(knots);
  lift(surface, 2, pole, std::tan(tilt_deg * degree) * pole_spacing / (2.0 / 3));
  const occ::Report report = analyzed(joinedToPlane(surface));
  EXPECT_EQ(report.seams.size(), 1u);
  return report.seams.at(0);
}

TEST(HiddenDefect, FoundWhereverItsHeightWithinOnePercent) {
  struct Spot {
    std::vector<double> knots;
    int pole;
  };
  const std::vector<Spot> spots = {{knotsWithAFinePart(), fine_pole},
                                   {uniformKnots(160), 60},
                                   {uniformKnots(160), 117},
                                   {uniformKnots(513), 38},
                                   {uniformKnots(513), 347}};
  for (const Spot& spot : spots)
    for (const double tilt : {0.15, 1.0, 4.9, 5.2, 20.0, 70.0}) {
      const SeamResult seam = seamWithTilt(spot.knots, spot.pole, tilt);
      SCOPED_TRACE(describe(seam));
      EXPECT_GE(angleDeg(seam), 0.99 * tilt);
      EXPECT_LE(angleDeg(seam), tilt * (1 + 1e-9));
      // The middle of the four spans of the pole; the seam runs against v.
      const double middle = 1 - spot.knots[spot.pole - 2] / spot.knots.back();
      EXPECT_NEAR(seam.figures.angle_rad->at, middle, 0.5 / 160);
      EXPECT_EQ(seam.verdict.level, Level::G0);
      EXPECT_EQ(seam.verdict.seam_class, SeamClass::Defect)
          << "neither smooth nor a crease by design";
    }
}

TEST(HiddenDefect, ASharpSpotIsSaidToBeOne) {
  const SeamResult seam = seamWithTilt(knotsWithAFinePart(), fine_pole, 30);
  EXPECT_THAT(seam.note, HasSubstr("sharp spot"));
  EXPECT_GT(seam.figures.below_crease_share, 0.98);
}

TEST(HiddenDefect, WithoutTheLiftedPoleTheSeamIsSmooth) {
  const SeamResult seam = analyzed(joinedToPlane(planeWithKnots(knotsWithAFinePart()))).seams.at(0);
  EXPECT_EQ(seam.verdict.level, Level::G2) << describe(seam);
  EXPECT_EQ(seam.verdict.seam_class, SeamClass::Smooth);
}

TEST(HiddenDefect, AlongTheWholeSeamItIsACrease) {
  const auto surface = planeWithKnots(uniformKnots(160));
  for (int j = 1; j <= surface->NbVPoles(); ++j)
    lift(surface, 2, j, std::tan(30 * degree) * pole_spacing);
  const SeamResult seam = analyzed(joinedToPlane(surface)).seams.at(0);
  EXPECT_NEAR(angleDeg(seam), 30, 1e-9);
  EXPECT_EQ(seam.verdict.seam_class, SeamClass::Crease) << describe(seam);
}

TEST(HiddenDefect, CurvatureSpotOfOnePole) {
  // A pole of row 2 lifted by h leaves the tangent plane alone: X_uu.z = 6 h N, kappa = 6 h N / (3
  // spacing)^2.
  const auto surface = planeWithKnots(knotsWithAFinePart());
  const double h = 0.01;
  lift(surface, 3, fine_pole, h);
  const double expected = 6 * h * (2.0 / 3) / (9 * pole_spacing * pole_spacing);
  occ::AnalyzeOptions options;
  options.level = Level::G2;
  const SeamResult seam = analyzed(joinedToPlane(surface), options).seams.at(0);
  SCOPED_TRACE(describe(seam));
  EXPECT_LT(angleDeg(seam), 1e-9);
  EXPECT_NEAR(curvature(seam), expected, 0.01 * expected);
  // The figure is the lower end of an enclosure.
  EXPECT_NEAR(relativeCurvature(seam), 1, 1e-6) << "the plane is flat, the spot is not";
  EXPECT_EQ(seam.verdict.level, Level::G1);
  EXPECT_EQ(seam.verdict.seam_class, SeamClass::Defect);
}

TEST(HiddenDefect, OnAPathThatCrossesKnotLinesAtAnAngle) {
  // The seam runs across the surface from one corner to the other; the lifted pole lies off it.
  const auto surface = planeWithKnots(uniformKnots(200));
  lift(surface, 2, 70, 0.2);
  const opencascade::handle<Geom_Surface> plane = new Geom_Plane(gp::XOY()), sheet(surface.get());
  const TopoDS_Shape shape =
      joined({sheet, {{0, 0}, {1, 200}, {0, 200}}}, {plane, {{6, 200}, {0, 0}, {6, 0}}});
  const SeamResult seam = analyzed(shape).seams.at(0);
  double angle = 0, gap = 0;
  for (int k = 0; k <= 200000; ++k) {
    gp_Pnt p;
    gp_Vec du, dv;
    surface->D1(k / 200000.0, k / 1000.0, p, du, dv);
    gap = std::max(gap, std::abs(p.Z()));
    const gp_Vec n = du.Crossed(dv);
    angle = std::max(angle, std::atan2(std::hypot(n.X(), n.Y()), std::abs(n.Z())));
  }
  SCOPED_TRACE(describe(seam));
  ASSERT_GT(angle, 0.5 * degree);
  EXPECT_NEAR(angleDeg(seam) * degree, angle, 0.01 * angle);
  EXPECT_NEAR(seam.figures.gap_mm->lower, gap, 0.01 * gap);
  EXPECT_NE(seam.verdict.seam_class, SeamClass::Smooth);
}

TEST(HiddenDefect, CurvatureThatGrowsTowardsAPole) {
  // The meridian z = a x^2 (1 - x)^4 turned about z, and the same curve extruded across: tangent
  // all along. They differ by the curvature of the parallels, z' / (x sqrt(1 + z'^2)), which is
  // largest, 2 a, in the limit at the pole x = 0 and falls by 6 % over the first hundredth of the
  // seam.
  const double a = 0.05;
  NCollection_Array1<gp_Pnt> poles(1, 7);
  for (int i = 0; i <= 6; ++i) poles(i + 1) = gp_Pnt(i / 6.0, 0, i == 2 ? a / 15 : 0);
  const opencascade::handle<Geom_Curve> meridian = new Geom_BezierCurve(poles);
  const opencascade::handle<Geom_Surface> turned = new Geom_SurfaceOfRevolution(meridian, gp::OZ());
  const opencascade::handle<Geom_Surface> extruded =
      new Geom_SurfaceOfLinearExtrusion(meridian, gp::DY());
  const SeamResult seam = analyzed(joined({turned, {{0, 1}, {0, 0}, {0.5, 1}}},
                                          {extruded, {{1, 0}, {0, 0}, {0, -1}, {1, -1}}}))
                              .seams.at(0);
  SCOPED_TRACE(describe(seam));
  EXPECT_LT(angleDeg(seam), 1e-6);
  EXPECT_GE(curvature(seam), 0.99 * 2 * a);
  EXPECT_LE(curvature(seam), 2 * a * (1 + 1e-6));
  EXPECT_THAT(seam.note, HasSubstr("vanishing normal"));
}

void expectFold(const TopoDS_Shape& shape) {
  for (const Level level : {Level::G0, Level::G1, Level::G2}) {
    occ::AnalyzeOptions options;
    options.level = level;
    const SeamResult seam = analyzed(shape, options).seams.at(0);
    SCOPED_TRACE(describe(seam));
    EXPECT_LT(angleDeg(seam), 1e-9);
    EXPECT_EQ(seam.verdict.level, Level::G0);
    EXPECT_EQ(seam.verdict.seam_class, SeamClass::Crease);
    EXPECT_TRUE(seam.figures.fold_at);
    EXPECT_THAT(seam.note, HasSubstr("fold"));
  }
}

TEST(Fold, OfTwoPlanes) {
  expectFold(foldedPlanes());
}

TEST(Fold, OfPlaneAndCylinderWhateverTheirOrder) {
  const double r = 10, quarter = std::numbers::pi / 2;
  const opencascade::handle<Geom_Surface> plane = new Geom_Plane(gp::XOY());
  const opencascade::handle<Geom_Surface> cylinder =
      new Geom_CylindricalSurface(gp_Ax3(gp_Pnt(0, 0, -r), gp::DY(), gp::DZ()), r);
  const Polygon flat = {plane, beginningWith(1, rectangle(-5, 0, 0, 4))};
  const Polygon round = {cylinder, beginningWith(1, rectangle(-quarter, 0, 0, 4))};
  std::mt19937 random(testSeed());
  expectFold(joined(flat, round));
  expectFold(joined(round, flat));
  expectFold(located(joined(flat, round), randomMotion(random)));
  expectFold(facesSwappedAndReversed(joined(round, flat)));
}

TEST(Fold, TheSamePiecesOnTheOtherSideAreSmooth) {
  EXPECT_EQ(analyzed(planeAndCylinder(10, 4)).seams.at(0).verdict.seam_class, SeamClass::Smooth);
}

/// A polyline of two segments that turn by the angle, extruded: one surface with a corner along u =
/// 1.
opencascade::handle<Geom_Surface> extrudedCorner(double angle_rad) {
  NCollection_Array1<gp_Pnt> poles(1, 3);
  poles(1) = gp_Pnt(0, 0, 0);
  poles(2) = gp_Pnt(10, 0, 0);
  poles(3) = gp_Pnt(20, 10 * std::tan(angle_rad), 0);
  NCollection_Array1<double> knots(1, 3);
  NCollection_Array1<int> multiplicities(1, 3);
  for (int i = 1; i <= 3; ++i) {
    knots(i) = i - 1;
    multiplicities(i) = i == 2 ? 1 : 2;
  }
  return new Geom_SurfaceOfLinearExtrusion(new Geom_BSplineCurve(poles, knots, multiplicities, 1),
                                           gp::DZ());
}

TEST(HiddenDefect, OnAKnotLineEachFaceIsMeasuredFromItsOwnSide) {
  for (const double angle_deg : {2.0, 0.5}) {
    const auto surface = extrudedCorner(angle_deg * degree);
    const occ::Report report =
        analyzed(joined({surface, beginningWith(1, rectangle(0, 1, 0, 10))},
                        {surface, beginningWith(3, rectangle(1, 2, 0, 10))}));
    ASSERT_EQ(report.seams.size(), 1u);
    EXPECT_NEAR(report.seams[0].figures.angle_rad->lower, angle_deg * degree, 1e-9);
    EXPECT_LT(report.seams[0].figures.gap_mm->lower, 1e-9);
    EXPECT_FALSE(report.passed());
  }
}

}  // namespace
}  // namespace seamwright::test
