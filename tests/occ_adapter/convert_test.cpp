// SPDX-License-Identifier: LGPL-2.1-or-later
// Analytic faces that become splines so that they may move.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "dense_oracle.hpp"
#include "match_pairs.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/convert/polynomial_surface.hpp>
#include <seamwright/occ_adapter/repair/repair.hpp>

namespace seamwright::test {
namespace {

using occ::modelFromShape;
using occ::polynomialSurface;
using occ::repair;
using occ::RepairOptions;
using occ::RepairReport;
using std::numbers::pi;

struct Analytic {
  std::string name;
  handle<Geom_Surface> surface;
  std::array<double, 4> range;
  std::function<gp_Pnt(double u, double v)> at;  ///< what every textbook says
  bool exact = false;
};

gp_Pnt aboutZ(double radius, double z, double u) {
  return {radius * std::cos(u), radius * std::sin(u), z};
}

constexpr std::array<std::array<double, 2>, 4> profile_poles = {
    {{10, 0}, {14, 5}, {9, 9}, {12, 15}}};

handle<Geom_Curve> profile() {
  TColgp_Array1OfPnt poles(1, 4);
  for (int k = 0; k < 4; ++k) poles(k + 1) = gp_Pnt(profile_poles[k][0], 0, profile_poles[k][1]);
  return new Geom_BezierCurve(poles);
}

/// Radius and height by the binomial formula.
std::array<double, 2> onProfile(double t) {
  const std::array<double, 4> share = {std::pow(1 - t, 3), 3 * t * std::pow(1 - t, 2),
                                       3 * t * t * (1 - t), t * t * t};
  std::array<double, 2> sum{};
  for (int k = 0; k < 4; ++k)
    for (const int c : {0, 1}) sum[c] += share[k] * profile_poles[k][c];
  return sum;
}

std::vector<Analytic> analyticKinds() {
  const auto cylinder = [](double radius) {
    return [radius](double u, double v) { return aboutZ(radius, v, u); };
  };
  const auto cone = [](double radius) {
    return [radius](double u, double v) {
      return aboutZ(radius + v * std::sin(0.4), v * std::cos(0.4), u);
    };
  };
  const auto sphere = [](double u, double v) {
    return aboutZ(40 * std::cos(v), 40 * std::sin(v), u);
  };
  return {
      {"plane",
       new Geom_Plane(gp::XOY()),
       {-10, 30, 5, 20},
       [](double u, double v) { return gp_Pnt(u, v, 0); },
       true},
      {"cylinder", new Geom_CylindricalSurface(gp::XOY(), 30), {0.3, 1.2, -5, 40}, cylinder(30)},
      {"whole cylinder",
       new Geom_CylindricalSurface(gp::XOY(), 30),
       {0, 2 * pi, -5, 40},
       cylinder(30)},
      {"turned cylinder", new Geom_CylindricalSurface(gp::XOY(), 3), {5, 8, 0, 1}, cylinder(3)},
      {"cylinder from before its first period",
       new Geom_CylindricalSurface(gp::XOY(), 3),
       {-0.3, 0.2, 0, 1},
       cylinder(3)},
      {"cylinder of the period before",
       new Geom_CylindricalSurface(gp::XOY(), 3),
       {-4, -3, 0, 1},
       cylinder(3)},
      {"cone", new Geom_ConicalSurface(gp::XOY(), 0.4, 10), {0, 3, 0, 20}, cone(10)},
      {"cone to its tip", new Geom_ConicalSurface(gp::XOY(), 0.4, 0), {0, 2 * pi, 0, 20}, cone(0)},
      {"sphere", new Geom_SphericalSurface(gp::XOY(), 40), {0, 2 * pi, -pi / 2, pi / 2}, sphere},
      {"cap", new Geom_SphericalSurface(gp::XOY(), 40), {1, 2, 1, pi / 2}, sphere},
      {"torus",
       new Geom_ToroidalSurface(gp::XOY(), 40, 10),
       {0, 2 * pi, 0, 2 * pi},
       [](double u, double v) { return aboutZ(40 + 10 * std::cos(v), 10 * std::sin(v), u); }},
      {"part of a torus",
       new Geom_ToroidalSurface(gp::XOY(), 40, 10),
       {-0.5, 0.5, -1, 0.3},
       [](double u, double v) { return aboutZ(40 + 10 * std::cos(v), 10 * std::sin(v), u); }},
      {"extrusion",
       new Geom_SurfaceOfLinearExtrusion(profile(), gp::DY()),
       {0, 1, -10, 10},
       [](double u, double v) { return gp_Pnt(onProfile(u)[0], v, onProfile(u)[1]); },
       true},
      {"revolution",
       new Geom_SurfaceOfRevolution(profile(), gp::OZ()),
       {0, 2, 0, 1},
       [](double u, double v) { return aboutZ(onProfile(v)[0], onProfile(v)[1], u); }}};
}

/// BRepBuilderAPI_MakeFace takes parameters of the first period; files have others too.
TopoDS_Face faceOf(const Analytic& kind) {
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(kind.surface, kind.range[0], kind.range[1],
                                                   kind.range[2], kind.range[3], 1e-7)
                               .Face();
  std::array<double, 4> range{};
  BRepTools::UVBounds(face, range[0], range[1], range[2], range[3]);
  const gp_Vec2d shift(kind.range[0] - range[0], kind.range[2] - range[2]);
  if (shift.Magnitude() < 1) return face;
  const TopTools_IndexedMapOfShape edges = partsOf(face, TopAbs_EDGE);
  const BRep_Builder builder;
  for (int e = 1; e <= edges.Extent(); ++e) {
    double first = 0, last = 0;
    const TopoDS_Edge edge = TopoDS::Edge(edges(e));
    const handle<Geom2d_Curve> path = BRep_Tool::CurveOnSurface(edge, face, first, last);
    builder.UpdateEdge(edge, handle<Geom2d_Curve>::DownCast(path->Translated(shift)), face, 1e-7);
  }
  return face;
}

TEST(PolynomialSurface, HasTheSameParameters) {
  std::mt19937 generator(testSeed());
  for (const Analytic& kind : analyticKinds())
    for (const double near_mm : {1e-4, 1e-5, 1e-6}) {
      SCOPED_TRACE(kind.name);
      const gp_Trsf motion = randomMotion(generator);
      const TopoDS_Face face = TopoDS::Face(located(faceOf(kind), motion));
      const occ::PolynomialSurface polynomial = polynomialSurface(face, near_mm);
      EXPECT_FALSE(polynomial.surface->IsURational() || polynomial.surface->IsVRational());
      EXPECT_LE(polynomial.error_mm, near_mm);
      EXPECT_GE(std::min(polynomial.surface->Continuity(), GeomAbs_C2), GeomAbs_C2);
      double worst = 0;
      for (int i = 0; i <= 210; ++i)
        for (int j = 0; j <= 70; ++j) {
          const double u = kind.range[0] + (kind.range[1] - kind.range[0]) * i / 210;
          const double v = kind.range[2] + (kind.range[3] - kind.range[2]) * j / 70;
          worst = std::max(
              worst, polynomial.surface->Value(u, v).Distance(kind.at(u, v).Transformed(motion)));
        }
      EXPECT_LE(worst, polynomial.error_mm + 1e-12 * 1000);
      EXPECT_LE(polynomial.error_mm, kind.exact ? 1e-12 : near_mm);
    }
}

TEST(PolynomialSurface, PolesStayPoints) {
  for (const Analytic& kind : analyticKinds()) {
    if (kind.name != "sphere" && kind.name != "cap" && kind.name != "cone to its tip") continue;
    const Spline spline = polynomialSurface(faceOf(kind), 1e-5).surface;
    const int row = kind.name == "cone to its tip" ? 1 : spline->NbVPoles();
    for (int i = 1; i <= spline->NbUPoles(); ++i)
      EXPECT_EQ(spline->Pole(i, row).Distance(spline->Pole(1, row)), 0);
  }
}

TEST(PolynomialSurface, TellsWhatItCannot) {
  // A profile with a corner has no continuous curvature.
  TColgp_Array1OfPnt poles(1, 3);
  poles(1) = gp_Pnt(10, 0, 0);
  poles(2) = gp_Pnt(14, 0, 5);
  poles(3) = gp_Pnt(9, 0, 9);
  TColStd_Array1OfReal knots(1, 3);
  TColStd_Array1OfInteger multiplicities(1, 3);
  for (int k = 1; k <= 3; ++k) {
    knots(k) = k - 1;
    multiplicities(k) = k == 2 ? 1 : 2;
  }
  const handle<Geom_Curve> corner = new Geom_BSplineCurve(poles, knots, multiplicities, 1);
  const TopoDS_Face face =
      BRepBuilderAPI_MakeFace(new Geom_SurfaceOfRevolution(corner, gp::OZ()), 0, 1, 0, 2, 1e-7)
          .Face();
  EXPECT_THROW(polynomialSurface(face, 1e-9), std::runtime_error);
}

RepairOptions converting(double gap_mm = 0.01) {
  RepairOptions options;
  options.convert_analytic = true;
  options.tolerance.gap_mm = gap_mm;
  return options;
}

int repairedSeams(const RepairReport& report) {
  return static_cast<int>(std::ranges::count(report.seams, true, &occ::SeamRepair::repaired));
}

std::string reasonsOf(const RepairReport& report) {
  std::string reasons;
  for (const occ::SeamRepair& seam : report.seams)
    if (!seam.reason.empty()) reasons += describe(seam.after) + ": " + seam.reason.text + "\n";
  return reasons;
}

/// Two analytic faces that share an edge at a small angle.
TopoDS_Shape kinked(double angle_rad) {
  const Polygon plate{new Geom_Plane(gp::XOY()), rectangle(0, 40, 0, 30)};
  const Polygon tilted{
      new Geom_Plane(
          gp_Ax3(gp::Origin(), gp_Dir(0, std::sin(angle_rad), std::cos(angle_rad)), gp::DX())),
      {{40, 0}, {0, 0}, {0, -30}, {40, -30}}};
  return joined(plate, tilted);
}

TEST(Convert, OneOfTwoPlanes) {
  const TopoDS_Shape shape = kinked(0.5 * degree);
  RepairOptions options = converting();
  options.convert_analytic = false;
  const RepairReport kept = repair(modelFromShape(shape), options);
  EXPECT_FALSE(kept.changed());
  EXPECT_NE(reasonsOf(kept).find("no poles to move"), std::string::npos);
  EXPECT_EQ(std::ranges::count(kept.seams, true, &occ::SeamRepair::wants_conversion), 1);
  const RepairReport report = repair(modelFromShape(shape), converting());
  EXPECT_EQ(repairedSeams(report), 1) << reasonsOf(report);
  EXPECT_EQ(std::ranges::count(report.seams, true, &occ::SeamRepair::wants_conversion), 0);
  ASSERT_EQ(report.converted.size(), 1);
  EXPECT_EQ(report.converted[0].kind, "a plane");
  EXPECT_LE(report.converted[0].error_mm, 1e-12);
  ASSERT_EQ(report.moves.size(), 1);
  EXPECT_EQ(report.moves[0].face, report.converted[0].face);
  EXPECT_TRUE(BRepCheck_Analyzer(report.model.shape).IsValid());
  expectTolerancesHold(report.model.shape);
  const auto sides =
      denseSides(report.model.shape, report.seams[0].after.edges[0], report.seams[0].after.faces);
  ASSERT_TRUE(sides);
  const DenseMaxima dense = denseMaxima(*sides, 501, options.tolerance);
  EXPECT_LE(dense.angle_rad->sure(), options.tolerance.angle_rad);
  // The other one is what it was.
  const int other = 3 - report.converted[0].face;
  TopLoc_Location location;
  EXPECT_TRUE(BRep_Tool::Surface(face(report.model.shape, other), location)
                  ->IsKind(STANDARD_TYPE(Geom_Plane)));
}

TEST(Convert, ConvertsNothingWithoutNeed) {
  for (const TopoDS_Shape& shape : {planeAndCylinder(10, 20), kinked(30 * degree),
                                    TopoDS_Shape(BRepPrimAPI_MakeCylinder(5, 9).Shape())}) {
    const RepairReport report = repair(modelFromShape(shape), converting());
    EXPECT_FALSE(report.changed());
    EXPECT_TRUE(report.converted.empty());
    EXPECT_TRUE(report.model.shape.IsEqual(shape));
  }
}

TEST(Convert, AFixedFaceStays) {
  for (const int fixed : {1, 2}) {
    RepairOptions options = converting();
    options.fixed_faces = {fixed};
    const RepairReport report = repair(modelFromShape(kinked(0.4 * degree)), options);
    EXPECT_EQ(repairedSeams(report), 1) << reasonsOf(report);
    ASSERT_EQ(report.converted.size(), 1);
    EXPECT_EQ(report.converted[0].face, 3 - fixed);
  }
}

/// A quarter of a cylinder and a plane that leaves it at a small angle.
TopoDS_Shape cylinderAndTiltedPlane(double angle_rad) {
  const double r = 20;
  const Polygon round{new Geom_CylindricalSurface(gp::XOY(), r),
                      {{0, 30}, {0, 0}, {pi / 2, 0}, {pi / 2, 30}}};
  const gp_Dir out(std::cos(angle_rad), std::sin(angle_rad), 0);
  const Polygon flat{new Geom_Plane(gp_Ax3(gp_Pnt(r, 0, 0), out, gp::DZ())),
                     {{0, 0}, {30, 0}, {30, 25}, {0, 25}}};
  return joined(flat, round);
}

TEST(Convert, ConvertsACylinderBesideATiltedPlane) {
  std::mt19937 generator(testSeed());
  for (const double angle : {0.3, -0.3, 0.8})
    for (const bool moved : {false, true}) {
      TopoDS_Shape shape = cylinderAndTiltedPlane(angle * degree);
      if (moved) shape = transformed(shape, randomMotion(generator));
      RepairOptions options = converting();
      options.fixed_faces = {1};
      const RepairReport report = repair(modelFromShape(shape), options);
      SCOPED_TRACE(reasonsOf(report));
      EXPECT_EQ(repairedSeams(report), 1);
      ASSERT_EQ(report.converted.size(), 1);
      EXPECT_EQ(report.converted[0].kind, "a cylinder");
      EXPECT_LE(report.converted[0].error_mm, 1e-5);
      EXPECT_TRUE(BRepCheck_Analyzer(report.model.shape).IsValid());
      expectTolerancesHold(report.model.shape);
      const auto sides = denseSides(report.model.shape, report.seams[0].after.edges[0],
                                    report.seams[0].after.faces);
      ASSERT_TRUE(sides);
      EXPECT_LE(denseMaxima(*sides, 501, options.tolerance).angle_rad->sure(),
                options.tolerance.angle_rad);
    }
}

TEST(Convert, WhatDoesNotHelpIsNotDone) {
  RepairOptions options = converting();
  options.max_move_mm = 1e-6;
  const TopoDS_Shape shape = kinked(0.5 * degree);
  const RepairReport report = repair(modelFromShape(shape), options);
  EXPECT_FALSE(report.changed());
  EXPECT_TRUE(report.converted.empty());
  EXPECT_TRUE(report.model.shape.IsEqual(shape));
  EXPECT_NE(reasonsOf(report).find("as splines: a fair move"), std::string::npos)
      << reasonsOf(report);
}

TEST(Convert, StopsWhereItIsAskedTo) {
  const occ::Model model = modelFromShape(kinked(0.5 * degree));
  std::vector<double> shares;
  const auto note = [&shares](double share) {
    shares.push_back(share);
    return true;
  };
  EXPECT_GT(repair(model, converting(), note).repair_s, 0);
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_EQ(shares.back(), 1);
  for (const double stop : {0.0, 0.3, 0.6})
    EXPECT_THROW(repair(model, converting(), [stop](double share) { return share < stop; }),
                 occ::Cancelled)
        << stop;
}

/// Three sheets at an edge, and a fourth that continues one of them at a small angle.
TopoDS_Shape threeSheets(double angle_rad) {
  const auto sheet = [](const gp_Pnt& a, const gp_Pnt& b, const gp_Pnt& c, const gp_Pnt& d) {
    TColgp_Array2OfPnt poles(1, 4, 1, 4);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const double u = i / 3.0, v = j / 3.0;
        poles(i + 1, j + 1) = gp_Pnt((1 - u) * (1 - v) * a.XYZ() + (1 - u) * v * b.XYZ() +
                                     u * (1 - v) * c.XYZ() + u * v * d.XYZ());
      }
    return BRepBuilderAPI_MakeFace(splineOf(poles, 3, 3), 1e-7).Shape();
  };
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  BRepBuilderAPI_Sewing sewing(1e-6, true, true, true, true);
  sewing.Add(sheet({0, 0, 0}, {0, 30, 0}, {20, 0, 0}, {20, 30, 0}));
  sewing.Add(sheet({0, 0, 0}, {0, 30, 0}, {-20, 0, 0}, {-20, 30, 0}));
  sewing.Add(sheet({0, 0, 0}, {0, 30, 0}, {0, 0, 20}, {0, 30, 20}));
  sewing.Add(sheet({20, 0, 0}, {20, 30, 0}, {20 + 20 * c, 0, 20 * s}, {20 + 20 * c, 30, 20 * s}));
  sewing.Perform();
  return sewing.SewedShape();
}

TEST(Convert, FacesAtAnEdgeOfThreeStay) {
  const TopoDS_Shape shape = threeSheets(0.5 * degree);
  const occ::Report before = analyzed(shape);
  ASSERT_EQ(before.non_manifold.size(), 1);
  const std::vector<int> crowded = before.non_manifold[0].faces;
  ASSERT_EQ(crowded.size(), 3);
  RepairOptions options = converting();
  const RepairReport report = repair(modelFromShape(shape), options);
  EXPECT_EQ(repairedSeams(report), 1) << reasonsOf(report);
  ASSERT_EQ(report.moves.size(), 1);
  EXPECT_EQ(std::ranges::count(crowded, report.moves[0].face), 0);
  options.fixed_faces = {report.moves[0].face};
  const RepairReport none = repair(modelFromShape(shape), options);
  EXPECT_FALSE(none.changed());
  EXPECT_NE(reasonsOf(none).find("where 3 faces meet"), std::string::npos) << reasonsOf(none);
}

}  // namespace
}  // namespace seamwright::test
