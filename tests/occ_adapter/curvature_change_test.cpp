// SPDX-License-Identifier: LGPL-2.1-or-later
// G3: shapes of OpenCASCADE whose change of curvature across a seam is known in closed form.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <array>
#include <cmath>

#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::SeamKind;
using occ::SeamResult;
using Surface = opencascade::handle<Geom_Surface>;

occ::Report analyzedToG3(const TopoDS_Shape& shape) {
  occ::AnalyzeOptions options;
  options.level = Level::G3;
  return analyzed(shape, options);
}

SeamResult onlySeam(const TopoDS_Shape& shape) {
  const occ::Report report = analyzedToG3(shape);
  EXPECT_EQ(report.seams.size(), 1u);
  return report.seams.at(0);
}

void expectG3(const SeamResult& seam, double noise) {
  SCOPED_TRACE(describe(seam));
  EXPECT_EQ(seam.verdict.level, Level::G3);
  EXPECT_EQ(seam.verdict.seam_class, SeamClass::Smooth);
  ASSERT_TRUE(seam.figures.curvature_change_per_mm2 && seam.figures.curvature_change_rel);
  EXPECT_LT(seam.figures.curvature_change_per_mm2->lower, noise);
  EXPECT_TRUE(seam.figures.curvature_change_rel->upper);
  // Next to a pole of a spline rounding is divided by the cube of the distance.
  EXPECT_TRUE(seam.verdict.certain || !seam.figures.degenerate.empty());
}

TEST(CurvatureChange, IsMeasuredForG3Alone) {
  const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(20, 6).Shape();
  for (const Level level : {Level::G1, Level::G2}) {
    occ::AnalyzeOptions options;
    options.level = level;
    for (const SeamResult& seam : analyzed(torus, options).seams) {
      EXPECT_FALSE(seam.figures.curvature_change_per_mm2 || seam.figures.curvature_change_rel);
      EXPECT_EQ(seam.verdict.level, Level::G2);
    }
  }
  EXPECT_EQ(analyzedToG3(torus).seams.size(), 2u);
  EXPECT_TRUE(analyzedToG3(torus).passed());
}

TEST(CurvatureChange, ClosedFacesOfPrimitivesAreG3AlsoAsSplines) {
  for (const TopoDS_Shape& shape :
       {BRepPrimAPI_MakeTorus(20, 6).Shape(), BRepPrimAPI_MakeCylinder(7, 20).Shape(),
        BRepPrimAPI_MakeCone(9, 4, 12).Shape(), BRepPrimAPI_MakeSphere(10).Shape()}) {
    const TopoDS_Shape splines = BRepBuilderAPI_NurbsConvert(shape, true).Shape();
    for (const TopoDS_Shape& form : {shape, splines}) {
      int closed = 0;
      for (const SeamResult& seam : analyzedToG3(form).seams) {
        if (seam.kind == SeamKind::Closed) {
          expectG3(seam, 1e-8);
          ++closed;
        }
      }
      EXPECT_GE(closed, 1);
    }
  }
}

TEST(CurvatureChange, CreasesHaveNone) {
  for (const SeamResult& seam : analyzedToG3(BRepPrimAPI_MakeBox(1, 2, 3).Shape()).seams) {
    EXPECT_FALSE(seam.figures.curvature_change_rel);
    EXPECT_EQ(seam.verdict.seam_class, SeamClass::Crease);
  }
}

Surface randomBezier(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  NCollection_Array2<gp_Pnt> poles(1, 5, 1, 4);
  NCollection_Array2<double> weights(1, 5, 1, 4);
  for (int i = 1; i <= 5; ++i)
    for (int j = 1; j <= 4; ++j) {
      poles(i, j) = gp_Pnt(3 * i + uniform(random), 3 * j + uniform(random), uniform(random));
      weights(i, j) = std::exp(0.3 * uniform(random));
    }
  return new Geom_BezierSurface(poles, weights);
}

TEST(CurvatureChange, ThirdPartialsOfAStripAreThoseOfTheSurface) {
  std::mt19937 random(testSeed());
  const Surface surface = randomBezier(random);
  const gp_Pnt2d from(0.2, 0.1), to(0.8, 0.7);
  const TopoDS_Shape shape =
      joined({surface, {from, to, {0.1, 0.9}}}, {surface, {to, from, {0.9, 0.2}}});
  const occ::SeamGraph graph = occ::findSeams(shape);
  ASSERT_EQ(graph.seams.size(), 1u);
  const auto derivative = [&](double s, int u_order, int v_order) {
    const gp_XY uv = from.XY() * (1 - s) + to.XY() * s;
    const gp_Vec d = surface->DN(uv.X(), uv.Y(), u_order, v_order);
    return Eigen::Vector3d(d.X(), d.Y(), d.Z());
  };
  for (const occ::Coedge& use : graph.seams[0].sides) {
    const occ::FaceStrip strip(use, occ::pcurveOf(use.edge, use.shape, 0.01), occ::JetOrder::Third);
    for (const double s : {0.0, 0.3, 1.0}) {
      const SidePoint side = strip.at(s);
      EXPECT_TRUE(side.third_order);
      const double noise = 1e-10 * derivative(s, 3, 0).norm();
      EXPECT_LT((side.jet.uuu - derivative(s, 3, 0)).norm(), noise);
      EXPECT_LT((side.jet.uuv - derivative(s, 2, 1)).norm(), noise);
      EXPECT_LT((side.jet.uvv - derivative(s, 1, 2)).norm(), noise);
      EXPECT_LT((side.jet.vvv - derivative(s, 0, 3)).norm(), noise);
    }
    EXPECT_FALSE(occ::FaceStrip(use, occ::pcurveOf(use.edge, use.shape, 0.01)).at(0.5).third_order);
  }
}

TEST(CurvatureChange, AnObliqueCutThroughOneSurfaceIsG3) {
  // Across the cut the curvature does change, on both sides alike.
  std::mt19937 random(testSeed());
  const Surface bezier = randomBezier(random);
  const opencascade::handle<Geom_Curve> section = bezier->UIso(0.4);
  const std::array<Surface, 6> surfaces = {new Geom_ConicalSurface(gp_Ax3(), 0.4, 5),
                                           new Geom_ToroidalSurface(gp_Ax3(), 9, 3),
                                           bezier,
                                           new Geom_OffsetSurface(bezier, 0.5),
                                           new Geom_SurfaceOfRevolution(section, gp::OX()),
                                           new Geom_SurfaceOfLinearExtrusion(section, gp::DX())};
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    SCOPED_TRACE(i);
    expectG3(onlySeam(joined({surfaces[i], {{0.2, 0.1}, {0.7, 0.9}, {0.1, 0.8}}},
                             {surfaces[i], {{0.7, 0.9}, {0.2, 0.1}, {0.8, 0.2}}})),
             1e-12);
  }
}

/// Plane z = 0 for x <= 0, z = c x^3 for 0 <= x <= 1.
TopoDS_Shape planeAndCubic(double c) {
  NCollection_Array2<gp_Pnt> poles(1, 4, 1, 2);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 2; ++j) poles(i + 1, j + 1) = gp_Pnt(i / 3.0, j, i == 3 ? c : 0);
  const Surface cubic = new Geom_BezierSurface(poles);
  return joined({new Geom_Plane(gp::XOY()), beginningWith(1, rectangle(-1, 0, 0, 1))},
                {cubic, beginningWith(3, rectangle(0, 1, 0, 1))});
}

TEST(CurvatureChange, PlaneThenCubicIsG2AndNotG3) {
  std::mt19937 random(testSeed());
  for (const double c : {0.5, -2e-3, 1e-7}) {
    const TopoDS_Shape plain = planeAndCubic(c);
    for (const TopoDS_Shape& shape :
         {plain, transformed(plain, randomMotion(random)), located(plain, randomMotion(random)),
          facesSwappedAndReversed(plain)}) {
      const SeamResult seam = onlySeam(shape);
      SCOPED_TRACE(describe(seam));
      ASSERT_TRUE(seam.figures.curvature_change_per_mm2);
      // The bounds differ by the rounding of a placed surface.
      EXPECT_NEAR(seam.figures.curvature_change_per_mm2->lower, 6 * std::abs(c), 2e-11);
      EXPECT_NEAR(seam.figures.curvature_change_per_mm2->upper.value_or(0), 6 * std::abs(c), 2e-11);
      EXPECT_TRUE(seam.verdict.certain);
      EXPECT_NEAR(seam.figures.curvature_change_rel->lower, 1, 1e-5);
      EXPECT_EQ(seam.verdict.level, Level::G2);
      EXPECT_EQ(seam.verdict.seam_class, SeamClass::Defect);
    }
  }
  // A change below 100 / (flat radius)^2 counts for nothing.
  expectG3(onlySeam(planeAndCubic(1e-9)), 1e-8);
}

/// A cubic spline profile over x = length u, knots 0, 1, 2, extruded along y.
struct Profile {
  double length;
  std::array<double, 5> z;  ///< poles

  Surface surface() const {
    NCollection_Array2<gp_Pnt> poles(1, 5, 1, 2);
    const double greville[5] = {0, 1.0 / 3, 1, 5.0 / 3, 2};
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 2; ++j) poles(i + 1, j + 1) = gp_Pnt(length * greville[i], 4 * j, z[i]);
    NCollection_Array1<double> knots_u(1, 3), knots_v(1, 2);
    NCollection_Array1<int> times_u(1, 3), times_v(1, 2);
    for (int i = 0; i < 3; ++i) {
      knots_u(i + 1) = i;
      times_u(i + 1) = i == 1 ? 1 : 4;
    }
    knots_v(1) = 0;
    knots_v(2) = 1;
    times_v.Init(2);
    return new Geom_BSplineSurface(poles, knots_u, knots_v, times_u, times_v, 3, 1);
  }
};

TEST(CurvatureChange, AKnotOfACubicSplineIsG2WithTheJumpOfItsThirdDerivative) {
  std::mt19937 random(testSeed());
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 40; ++trial) {
    Profile profile{std::pow(10, uniform(random)), {}};
    for (double& z : profile.z) z = 0.3 * profile.length * uniform(random);
    const auto& z = profile.z;
    // Poles of the derivatives by u.
    const double d[4] = {3 * (z[1] - z[0]), 1.5 * (z[2] - z[1]), 1.5 * (z[3] - z[2]),
                         3 * (z[4] - z[3])};
    const double dd[3] = {2 * (d[1] - d[0]), d[2] - d[1], 2 * (d[3] - d[2])};
    const double L = profile.length;
    const double slope = 0.5 * (d[1] + d[2]) / L, bend = dd[1] / (L * L), w = 1 + slope * slope;
    const auto change = [&](double third) {
      return (third * w - 3 * slope * bend * bend) / (w * w * w);
    };
    const double before = change((dd[1] - dd[0]) / (L * L * L)),
                 after = change((dd[2] - dd[1]) / (L * L * L));
    const double kappa = std::abs(bend) / std::pow(w, 1.5);

    const Surface surface = profile.surface();
    const TopoDS_Shape shape = joined({surface, beginningWith(1, rectangle(0, 1, 0, 1))},
                                      {surface, beginningWith(3, rectangle(1, 2, 0, 1))});
    const SeamResult seam = onlySeam(trial % 2 ? facesSwappedAndReversed(shape) : shape);
    SCOPED_TRACE(describe(seam));
    ASSERT_TRUE(seam.figures.curvature_change_per_mm2 && seam.figures.curvature_change_rel);
    const double jump = std::abs(after - before);
    EXPECT_NEAR(seam.figures.curvature_change_per_mm2->lower, jump, 1e-6 * jump);
    const double relative = jump / std::max({std::abs(before), std::abs(after), kappa * kappa});
    EXPECT_NEAR(seam.figures.curvature_change_rel->lower, relative, 1e-5);
    EXPECT_EQ(seam.verdict.level, relative > 0.02 ? Level::G2 : Level::G3);
  }
}

}  // namespace
}  // namespace seamwright::test
