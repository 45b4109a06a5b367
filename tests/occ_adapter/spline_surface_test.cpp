// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <GeomConvert.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "shapes.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/convert/spline_surface.hpp>

namespace seamwright::test {
namespace {

using occ::clampedSpline;
using occ::coreSurface;
using occ::EdgeRows;
using occ::geomSurface;
using opencascade::handle;
using Spline = handle<Geom_BSplineSurface>;

double random(std::mt19937& generator, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(generator);
}

TColgp_Array2OfPnt randomPoles(std::mt19937& generator, int rows, int columns) {
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  for (int i = 1; i <= rows; ++i)
    for (int j = 1; j <= columns; ++j)
      poles(i, j) = gp_Pnt(10 * i + random(generator, -1, 1), 10 * j + random(generator, -1, 1),
                           random(generator, -9, 9));
  return poles;
}

TColStd_Array2OfReal randomWeights(std::mt19937& generator, int rows, int columns) {
  TColStd_Array2OfReal weights(1, rows, 1, columns);
  for (int i = 1; i <= rows; ++i)
    for (int j = 1; j <= columns; ++j) weights(i, j) = random(generator, 0.5, 2);
  return weights;
}

/// Knots 1, 2.5, 3, 4.5, ... with those multiplicities at the ends and 1 inside.
struct RandomKnots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger multiplicities;
};

RandomKnots knots(std::mt19937& generator, int count, int at_ends) {
  RandomKnots made{TColStd_Array1OfReal(1, count), TColStd_Array1OfInteger(1, count)};
  made.multiplicities.Init(1);
  made.multiplicities(1) = made.multiplicities(count) = at_ends;
  double value = 1;
  for (int i = 1; i <= count; ++i) made.values(i) = value += random(generator, 0.4, 1.5);
  return made;
}

/// Degrees 3 and 2, 7 by 5 poles.
Spline clamped(std::mt19937& generator, bool rational) {
  const RandomKnots u = knots(generator, 5, 4), v = knots(generator, 4, 3);
  const TColgp_Array2OfPnt poles = randomPoles(generator, 7, 5);
  if (!rational)
    return new Geom_BSplineSurface(poles, u.values, v.values, u.multiplicities, v.multiplicities, 3,
                                   2);
  return new Geom_BSplineSurface(poles, randomWeights(generator, 7, 5), u.values, v.values,
                                 u.multiplicities, v.multiplicities, 3, 2);
}

Spline unclamped(std::mt19937& generator) {
  const RandomKnots u = knots(generator, 11, 1), v = knots(generator, 4, 3);
  return new Geom_BSplineSurface(randomPoles(generator, 7, 5), u.values, v.values, u.multiplicities,
                                 v.multiplicities, 3, 2);
}

Spline periodic(std::mt19937& generator) {
  const RandomKnots u = knots(generator, 8, 1), v = knots(generator, 4, 3);
  return new Geom_BSplineSurface(randomPoles(generator, 7, 5), randomWeights(generator, 7, 5),
                                 u.values, v.values, u.multiplicities, v.multiplicities, 3, 2, true,
                                 false);
}

handle<Geom_Surface> bezier(std::mt19937& generator) {
  return new Geom_BezierSurface(randomPoles(generator, 4, 3), randomWeights(generator, 4, 3));
}

/// Points of the numbers and of OpenCASCADE's surface agree, first partials too.
void expectSame(const BSplineSurface& core, const handle<Geom_Surface>& surface,
                const gp_Trsf& placed, std::mt19937& generator) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface->Bounds(u0, u1, v0, v1);
  EXPECT_NEAR(core.knots_u.front(), u0, 1e-14);
  EXPECT_NEAR(core.knots_u.back(), u1, 1e-14);
  EXPECT_NEAR(core.knots_v.front(), v0, 1e-14);
  EXPECT_NEAR(core.knots_v.back(), v1, 1e-14);
  for (int k = 0; k < 40; ++k) {
    const double u = k == 0   ? u0
                     : k == 1 ? u1
                              : random(generator, u0, u1),
                 v = k < 2 ? v0 : random(generator, v0, v1);
    gp_Pnt point;
    gp_Vec by_u, by_v;
    surface->D1(u, v, point, by_u, by_v);
    point.Transform(placed);
    by_u.Transform(placed);
    by_v.Transform(placed);
    const SurfaceJet seen = jet(core, u, v);
    EXPECT_LT(gp_Pnt(seen.p.x(), seen.p.y(), seen.p.z()).Distance(point), 1e-11);
    EXPECT_LT((gp_Vec(seen.u.x(), seen.u.y(), seen.u.z()) - by_u).Magnitude(), 1e-9);
    EXPECT_LT((gp_Vec(seen.v.x(), seen.v.y(), seen.v.z()) - by_v).Magnitude(), 1e-9);
  }
}

TEST(SplineSurface, SurfacesOfAllSplineKindsComeAcross) {
  std::mt19937 generator(testSeed());
  gp_Trsf mirror, scale;
  mirror.SetMirror(gp_Ax2(gp_Pnt(3, 4, 5), gp_Dir(1, 2, 3)));
  scale.SetScale(gp_Pnt(1, 2, 3), 0.25);
  const std::vector<handle<Geom_Surface>> surfaces = {
      clamped(generator, false), clamped(generator, true), unclamped(generator),
      periodic(generator), bezier(generator)};
  for (const handle<Geom_Surface>& surface : surfaces)
    for (const gp_Trsf& by : {gp_Trsf(), randomMotion(generator), mirror, scale}) {
      const Spline spline = clampedSpline(surface, TopLoc_Location(by));
      ASSERT_FALSE(spline.IsNull());
      EXPECT_FALSE(spline->IsUPeriodic() || spline->IsVPeriodic());
      expectSame(coreSurface(*spline), surface, by, generator);
    }
}

TEST(SplineSurface, ATrimmedSurfaceComesOverItsRange) {
  std::mt19937 generator(testSeed());
  for (const Spline& basis : {clamped(generator, true), periodic(generator)}) {
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    basis->Bounds(u0, u1, v0, v1);
    const handle<Geom_Surface> trimmed =
        new Geom_RectangularTrimmedSurface(basis, u0 + 0.3, u1 - 0.2, v0 + 0.1, v1);
    expectSame(coreSurface(*clampedSpline(trimmed)), trimmed, gp_Trsf(), generator);
  }
}

TEST(SplineSurface, NumbersGoThereAndBack) {
  std::mt19937 generator(testSeed());
  for (const bool rational : {false, true}) {
    const BSplineSurface core = coreSurface(*clamped(generator, rational));
    const BSplineSurface again = coreSurface(*geomSurface(core));
    EXPECT_EQ(again.degree_u, core.degree_u);
    EXPECT_EQ(again.knots_u, core.knots_u);
    EXPECT_EQ(again.knots_v, core.knots_v);
    EXPECT_LT((again.poles - core.poles).cwiseAbs().maxCoeff(), 1e-13);
  }
}

TEST(SplineSurface, WhatIsNoSplineOrCannotBeSaysSo) {
  EXPECT_TRUE(clampedSpline(new Geom_CylindricalSurface(gp::XOY(), 3)).IsNull());
  EXPECT_TRUE(clampedSpline(new Geom_RectangularTrimmedSurface(
                                new Geom_ToroidalSurface(gp::XOY(), 5, 1), 0.0, 1.0, 0.0, 1.0))
                  .IsNull());
  std::mt19937 generator(testSeed());
  EXPECT_THROW(coreSurface(*unclamped(generator)), std::invalid_argument);
  EXPECT_THROW(coreSurface(*periodic(generator)), std::invalid_argument);
  BSplineSurface core = coreSurface(*clamped(generator, true));
  core.poles(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(geomSurface(core), std::invalid_argument);
}

/// Largest distance of two surfaces at equal parameters.
double distance(const Geom_BSplineSurface& a, const Geom_BSplineSurface& b) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0, largest = 0;
  a.Bounds(u0, u1, v0, v1);
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j) {
      const double u = u0 + (u1 - u0) * i / 20, v = v0 + (v1 - v0) * j / 20;
      largest = std::max(largest, a.Value(u, v).Distance(b.Value(u, v)));
    }
  return largest;
}

TEST(SplineSurface, RowsRunAlongTheEdgeAndCountFromIt) {
  std::mt19937 generator(testSeed());
  const Spline spline = clamped(generator, true);
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  spline->Bounds(u0, u1, v0, v1);
  for (const PatchEdge edge : {PatchEdge::U0, PatchEdge::U1, PatchEdge::V0, PatchEdge::V1})
    for (const bool reversed : {false, true}) {
      const Spline copy = Spline::DownCast(spline->Copy());
      EdgeRows rows(copy, edge, reversed);
      const bool along_v = edge == PatchEdge::U0 || edge == PatchEdge::U1;
      EXPECT_EQ(rows.columns(), along_v ? 5 : 7);
      EXPECT_EQ(rows.rows(), along_v ? 7 : 5);
      // Corners: row 0 lies on the edge, its ends are the edge's.
      const auto corner = [&](double t, double across) {
        const Eigen::Vector2d at = rows.parameters(t, across);
        const gp_Pnt p = spline->Value(at[0], at[1]);
        return Eigen::Vector3d(p.X(), p.Y(), p.Z());
      };
      EXPECT_LT((rows.pole(0, 0) - corner(0, 0)).norm(), 1e-12);
      EXPECT_LT((rows.pole(0, rows.columns() - 1) - corner(1, 0)).norm(), 1e-12);
      EXPECT_LT((rows.pole(rows.rows() - 1, 0) - corner(0, 1)).norm(), 1e-12);
      const double side = edge == PatchEdge::U0   ? u0
                          : edge == PatchEdge::U1 ? u1
                          : edge == PatchEdge::V0 ? v0
                                                  : v1;
      EXPECT_EQ(rows.parameters(0.3)[along_v ? 0 : 1], side);
      // The numbers of poles are those of core.
      const BSplineSurface core = coreSurface(*copy);
      const Eigen::Vector4d homogeneous =
          core.poles.row(static_cast<int>(rows.number(1, 2))).transpose();
      EXPECT_LT((homogeneous.head<3>() / homogeneous[3] - rows.pole(1, 2)).norm(), 1e-12);
      EXPECT_EQ(homogeneous[3], rows.weight(1, 2));
      // The edge as a curve.
      const handle<Geom_Curve> boundary = rows.boundary(5, 7);
      for (const double t : {0.0, 0.2, 0.7, 1.0}) {
        const gp_Pnt p = boundary->Value(5 + 2 * t);
        EXPECT_LT((corner(t, 0) - Eigen::Vector3d(p.X(), p.Y(), p.Z())).norm(), 1e-12);
      }
      // Raised and refined the shape is the same, and a row is reached by its number.
      rows.raiseDegreeAlong(4);
      rows.raiseDegreeAcross(4);
      rows.insertAlong(0.37, 2);
      rows.refineAcross(12);
      EXPECT_GE(rows.rows(), 12);
      const std::vector<double> knots_along = rows.knotsAlong();
      EXPECT_EQ(
          std::ranges::count_if(knots_along, [](double t) { return std::abs(t - 0.37) < 1e-12; }),
          2);
      EXPECT_LT(distance(*spline, *copy), 1e-11);
      const Eigen::Vector3d moved = rows.pole(1, 1) + Eigen::Vector3d(1, 2, 3);
      rows.setPole(1, 1, moved);
      EXPECT_LT((rows.pole(1, 1) - moved).norm(), 1e-15);
    }
}

TEST(SplineSurface, AlignedEdgesHaveTheSameDegreeAndKnots) {
  std::mt19937 generator(testSeed());
  for (int k = 0; k < 20; ++k) {
    const Spline a = clamped(generator, false), b = clamped(generator, true);
    const Spline a_before = Spline::DownCast(a->Copy()), b_before = Spline::DownCast(b->Copy());
    EdgeRows first(a, k % 2 ? PatchEdge::U1 : PatchEdge::V0, k % 3 == 0);
    EdgeRows second(b, k % 4 < 2 ? PatchEdge::U0 : PatchEdge::V1, k % 5 == 0);
    occ::alignAlong(first, second, k % 3);
    EXPECT_EQ(first.degreeAlong(), second.degreeAlong());
    const std::vector<double> s = first.knotsAlong(), t = second.knotsAlong();
    ASSERT_EQ(s.size(), t.size());
    for (std::size_t i = 0; i < s.size(); ++i) EXPECT_NEAR(s[i], t[i], 1e-15);
    EXPECT_LT(distance(*a_before, *a), 1e-11);
    EXPECT_LT(distance(*b_before, *b), 1e-7) << "knots moved by up to 1e-9 of the range";
  }
}

TEST(SplineSurface, KnotsThatOnlyRoundingTellsApartBecomeOne) {
  std::mt19937 generator(testSeed());
  const Spline a = clamped(generator, false), b = Spline::DownCast(a->Copy());
  TColStd_Array1OfReal knots_u(1, b->NbUKnots());
  b->UKnots(knots_u);
  knots_u(2) += 1e-11;
  b->SetUKnots(knots_u);
  EdgeRows first(a, PatchEdge::V0), second(b, PatchEdge::V0);
  occ::alignAlong(first, second);
  EXPECT_EQ(first.columns(), 7);
  EXPECT_EQ(first.knotsAlong(), second.knotsAlong());
}

}  // namespace
}  // namespace seamwright::test
