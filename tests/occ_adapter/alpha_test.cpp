// SPDX-License-Identifier: LGPL-2.1-or-later
// Alpha-curves and alpha-surfaces in OpenCASCADE: exactly there and back, and its evaluation
// against the basis.
#include <gmock/gmock.h>

#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <random>
#include <seamwright/core/spline/alpha_spline.hpp>
#include <seamwright/core/spline/alpha_surface.hpp>
#include <seamwright/occ_adapter/convert/bezier_surface.hpp>
#include <seamwright/occ_adapter/convert/spline_curve.hpp>

#include "support/random.hpp"

namespace seamwright {
namespace {

using opencascade::handle;

double uniform(double low, double high, std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Poles randomPoles(int count, std::mt19937_64& random) {
  return Poles::NullaryExpr(count, 3, [&] { return uniform(-10, 10, random); });
}

Eigen::Vector3d vector(const gp_XYZ& p) {
  return {p.X(), p.Y(), p.Z()};
}

TEST(Alpha, CurvesThereAndBack) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    AlphaCurve curve;
    curve.poles = randomPoles(4, random);
    curve.a = i % 10 == 0 ? 0 : i % 10 == 1 ? 1 : uniform(0, 1, random);
    const BezierCurve quintic = alphaCurveBezier(curve);
    const handle<Geom_BezierCurve> theirs = occ::toBezierCurve(quintic);
    EXPECT_EQ(theirs->Degree(), 5);
    EXPECT_EQ(occ::bezierCurve(*theirs), quintic);
    const double t = uniform(0, 1, random);
    const Eigen::Vector3d direct = curve.poles.transpose() * alphaBasis(curve.a, t);
    EXPECT_LE((vector(theirs->Value(t).XYZ()) - direct).norm(), 1e-13);
    gp_Pnt p;
    gp_Vec d1, d2, d3;
    theirs->D3(t, p, d1, d2, d3);
    const CurveDerivatives ours = quintic.derivatives(t, 3);
    EXPECT_LE((vector(d1.XYZ()).transpose() - ours.row(1)).norm(), 1e-12);
    EXPECT_LE((vector(d2.XYZ()).transpose() - ours.row(2)).norm(), 1e-11);
    EXPECT_LE((vector(d3.XYZ()).transpose() - ours.row(3)).norm(), 1e-10);
  }
}

TEST(Alpha, SurfacesThereAndBack) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    AlphaSurface surface;
    surface.poles = randomPoles(16, random);
    surface.a_u = uniform(0, 1, random);
    surface.a_v = i % 5 ? uniform(0, 1, random) : 1;
    const BezierPatch patch = alphaSurfacePatch(surface);
    const handle<Geom_BezierSurface> theirs = occ::toBezierSurface(patch);
    EXPECT_EQ(theirs->UDegree(), 5);
    EXPECT_EQ(theirs->VDegree(), 5);
    EXPECT_EQ(occ::bezierPatch(*theirs), patch);
    const double u = uniform(0, 1, random), v = uniform(0, 1, random);
    const Eigen::Vector4d b = alphaBasis(surface.a_u, u), c = alphaBasis(surface.a_v, v);
    Eigen::Vector3d direct = Eigen::Vector3d::Zero();
    for (int k = 0; k < 16; ++k) direct += b(k / 4) * c(k % 4) * surface.poles.row(k).transpose();
    EXPECT_LE((vector(theirs->Value(u, v).XYZ()) - direct).norm(), 1e-13);
    gp_Pnt p;
    gp_Vec du, dv;
    theirs->D1(u, v, p, du, dv);
    const SurfaceJet jet = patch.jet(u, v);
    EXPECT_LE((vector(du.XYZ()) - jet.u).norm(), 1e-12);
    EXPECT_LE((vector(dv.XYZ()) - jet.v).norm(), 1e-12);
  }
}

TEST(Alpha, SplinesHaveTheContinuityOfTheirOrder) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 60; ++i) {
    AlphaSplineShape shape;
    shape.order = 1 + i % 2;
    for (int k = 0; k < 4; ++k) {
      shape.a.push_back(uniform(0.55, 1, random));
      shape.lengths.push_back(uniform(0.5, 2, random));
    }
    const BezierSpline spline =
        bezierSpline(alphaSpline(randomPoles(shape.order == 1 ? 10 : 7, random), shape));
    const handle<Geom_BSplineCurve> theirs = occ::toBSplineCurve(spline);
    EXPECT_EQ(theirs->Degree(), 5);
    EXPECT_EQ(theirs->Continuity(), shape.order == 1 ? GeomAbs_C1 : GeomAbs_C2);
    for (int k = 0; k < 20; ++k) {
      const double t = uniform(0, spline.knots.back(), random);
      EXPECT_LE(
          (vector(theirs->Value(t).XYZ()).transpose() - derivatives(spline, t, 0).row(0)).norm(),
          1e-12);
    }
  }
}

}  // namespace
}  // namespace seamwright
