// SPDX-License-Identifier: LGPL-2.1-or-later
// A surface and its displacement, seen by OpenCASCADE's evaluation and the recursion that defines
// B-splines.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/QR>
#include <GeomConvert.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "match_pairs.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/repair/displacement.hpp>

namespace seamwright::test {
namespace {

using occ::Displacement;
using occ::PointRows;
using occ::SplineAxis;

constexpr double pi = std::numbers::pi, near_mm = 1e-4;

std::array<double, 4> wholeOf(const Spline& surface) {
  std::array<double, 4> range{};
  surface->Bounds(range[0], range[1], range[2], range[3]);
  return range;
}

/// B-splines by their definition. The last one is closed at the end of the axis.
double bspline(const SplineAxis& axis, int i, int degree, double t) {
  const auto knot = [&axis](int k) { return axis.knots[static_cast<std::size_t>(k)]; };
  if (degree == 0)
    return (knot(i) <= t && t < knot(i + 1)) || (t == axis.last && knot(i) < t && t == knot(i + 1))
               ? 1
               : 0;
  const double rise = knot(i + degree) - knot(i), fall = knot(i + degree + 1) - knot(i + 1);
  return (rise > 0 ? (t - knot(i)) / rise * bspline(axis, i, degree - 1, t) : 0) +
         (fall > 0 ? (knot(i + degree + 1) - t) / fall * bspline(axis, i + 1, degree - 1, t) : 0);
}

/// By pole of an axis.
Eigen::VectorXd functionsAt(const SplineAxis& axis, double t) {
  if (axis.periodic && t == axis.last) t = axis.first;
  Eigen::VectorXd values = Eigen::VectorXd::Zero(axis.poles);
  const int functions = static_cast<int>(axis.knots.size()) - axis.degree - 1;
  for (int i = 0; i < functions; ++i) values[axis.pole(i)] += bspline(axis, i, axis.degree, t);
  return values;
}

/// \pre no side is one point, so that a coefficient has the number of its pole
Eigen::Vector3d moveAt(const Displacement& displacement, double u, double v) {
  const occ::SurfaceBasis& basis = displacement.basis();
  const Eigen::VectorXd of_u = functionsAt(basis.u(), u), of_v = functionsAt(basis.v(), v);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < basis.u().poles; ++i)
    for (int j = 0; j < basis.v().poles; ++j)
      sum += of_u[i] * of_v[j] * displacement.coefficients().row(basis.pole(i, j)).transpose();
  return sum / displacement.denominator({u, v});
}

void moveAnyhow(Displacement& displacement, std::mt19937& generator, double size) {
  displacement.setCoefficients(
      PointRows::NullaryExpr(displacement.count(), 3, [&] { return random(generator, size); }));
}

Eigen::Vector3d pointOf(const handle<Geom_Surface>& surface, double u, double v) {
  const gp_Pnt p = surface->Value(u, v);
  return {p.X(), p.Y(), p.Z()};
}

void forGrid(const Spline& surface, const std::function<void(double u, double v)>& look) {
  constexpr int steps = 23;
  const std::array<double, 4> range = wholeOf(surface);
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      look(range[0] + (range[1] - range[0]) * i / steps,
           range[2] + (range[3] - range[2]) * j / steps);
}

/// The largest distance of the moved surface from X + D.
double largestError_mm(const Spline& given, const Displacement& displacement) {
  const Spline moved = displacement.moved().surface;
  double largest = 0;
  forGrid(given, [&](double u, double v) {
    largest = std::max(
        largest, (pointOf(moved, u, v) - pointOf(given, u, v) - moveAt(displacement, u, v)).norm());
  });
  return largest;
}

/// Inner knots anywhere, some of them twice or three times.
Spline unevenSheet(std::mt19937& generator, int degree_u, int degree_v) {
  const Spline surface = sheet(generator, degree_u + 4, degree_v + 4, degree_u, degree_v);
  const double u = 0.2 + random(generator, 0.1), v = 0.7 + random(generator, 0.1);
  surface->InsertUKnot(u, std::max(1, degree_u - 1), 1e-9);
  surface->InsertVKnot(v, std::min(2, degree_v), 1e-9);
  return surface;
}

void setRandomWeights(const Spline& surface, std::mt19937& generator) {
  for (int i = 1; i <= surface->NbUPoles(); ++i)
    for (int j = 1; j <= surface->NbVPoles(); ++j)
      surface->SetWeight(i, j, 1 + std::abs(random(generator, 0.5)));
}

/// Over its value at the first pole.
double denominatorAt(const Spline& surface, double u, double v) {
  const occ::SurfaceBasis basis(*surface);
  const Eigen::VectorXd of_u = functionsAt(basis.u(), u), of_v = functionsAt(basis.v(), v);
  double sum = 0;
  for (int i = 0; i < basis.u().poles; ++i)
    for (int j = 0; j < basis.v().poles; ++j)
      sum += of_u[i] * of_v[j] * surface->Weight(i + 1, j + 1);
  return sum / surface->Weight(1, 1);
}

/// So moves of it need no higher degree, however often it moves.
TEST(Displacement, HasASmoothDenominatorOfItsSurface) {
  std::mt19937 generator(testSeed());
  for (const auto& [degree_u, degree_v] : {std::pair(2, 3), std::pair(3, 3), std::pair(4, 2)}) {
    const Spline given = sheet(generator, degree_u + 4, degree_v + 4, degree_u, degree_v);
    given->InsertUKnot(0.2, degree_u - 1, 1e-9);
    setRandomWeights(given, generator);
    const std::array degrees = {degree_u, degree_v};
    Spline now = given;
    for (int turn = 0; turn < 3; ++turn) {
      Displacement next(now, wholeOf(now), 4, near_mm, false, degrees);
      forGrid(given, [&](double u, double v) {
        EXPECT_NEAR(next.denominator({u, v}), denominatorAt(given, u, v), 1e-10);
      });
      moveAnyhow(next, generator, 0.5);
      EXPECT_LT(largestError_mm(now, next), 1e-10);
      now = next.moved().surface;
      EXPECT_EQ(now->UDegree(), std::max(3, degree_u));
      EXPECT_EQ(now->VDegree(), std::max(3, degree_v));
    }
  }
}

/// Where the denominator bends D has none. The denominator is what it was, so moves of moved
/// surfaces need no higher degree.
TEST(Displacement, FurtherOnesKeepTheDegreeOfRationalSurfaces) {
  std::mt19937 generator(testSeed());
  for (const auto& [degree_u, degree_v] : {std::pair(2, 3), std::pair(3, 1), std::pair(4, 2)}) {
    const Spline given = unevenSheet(generator, degree_u, degree_v);
    given->InsertVKnot(0.4, degree_v, 1e-9);
    setRandomWeights(given, generator);
    const std::array degrees = {degree_u, degree_v};
    Displacement first(given, wholeOf(given), 4, near_mm);
    EXPECT_EQ(first.denominator({0.5, 0.5}), 1);
    moveAnyhow(first, generator, 0.5);
    Spline now = first.moved().surface;
    const int u = now->UDegree(), v = now->VDegree();
    EXPECT_EQ(u, degree_u + std::max(3, degree_u));
    for (int turn = 0; turn < 3; ++turn) {
      Displacement next(now, wholeOf(now), 4, near_mm, false, degrees);
      moveAnyhow(next, generator, 0.5);
      EXPECT_LT(largestError_mm(now, next), 1e-10);
      now = next.moved().surface;
      EXPECT_EQ(now->UDegree(), u);
      EXPECT_EQ(now->VDegree(), v);
    }
  }
}

TEST(Displacement, OfAPolynomialSurfaceIsAddedToIt) {
  std::mt19937 generator(testSeed());
  for (const auto& [degree_u, degree_v] :
       std::vector<std::pair<int, int>>{{1, 2}, {2, 3}, {3, 3}, {3, 5}, {4, 6}, {7, 3}}) {
    const Spline given = unevenSheet(generator, degree_u, degree_v);
    for (const int spans : {1, 4, 7}) {
      SCOPED_TRACE(std::to_string(degree_u) + " by " + std::to_string(degree_v) + ", " +
                   std::to_string(spans));
      Displacement displacement(given, wholeOf(given), spans, near_mm);
      moveAnyhow(displacement, generator, 1);
      EXPECT_LT(largestError_mm(given, displacement), 1e-12 * displacement.size_mm());
    }
  }
}

TEST(Displacement, WithoutAMoveTheSurfaceStays) {
  std::mt19937 generator(testSeed());
  const Spline given = unevenSheet(generator, 3, 2);
  const Displacement displacement(given, wholeOf(given), 4, near_mm);
  EXPECT_LT(largestError_mm(given, displacement), 1e-13 * displacement.size_mm());
  EXPECT_EQ(displacement.moved().largest_move_mm, 0);
}

TEST(Displacement, SharesAreTheDerivativesOfTheMove) {
  std::mt19937 generator(testSeed());
  const Spline given = unevenSheet(generator, 3, 4);
  Displacement displacement(given, wholeOf(given), 5, near_mm);
  moveAnyhow(displacement, generator, 1);
  const Spline moved = displacement.moved().surface;
  for (int k = 0; k < 50; ++k) {
    const Eigen::Vector2d uv(0.5 + random(generator, 0.5), 0.5 + random(generator, 0.5)),
        none = Eigen::Vector2d::Zero();
    const SurfaceJet jet =
        displacement.moved(displacement.given(uv, none), displacement.shares(uv, none));
    gp_Pnt p;
    gp_Vec du, dv, duu, dvv, duv;
    moved->D2(uv[0], uv[1], p, du, dv, duu, dvv, duv);
    const auto isNear = [](const Eigen::Vector3d& is, const auto& expected) {
      const Eigen::Vector3d e(expected.X(), expected.Y(), expected.Z());
      return (is - e).norm() < 1e-9 * (1 + e.norm());
    };
    EXPECT_TRUE(isNear(jet.p, p) && isNear(jet.u, du) && isNear(jet.v, dv)) << k;
    EXPECT_TRUE(isNear(jet.uu, duu) && isNear(jet.uv, duv) && isNear(jet.vv, dvv)) << k;
  }
}

Spline splineFrom(const handle<Geom_Surface>& surface, double u0, double u1, double v0, double v1) {
  return GeomConvert::SurfaceToBSplineSurface(
      new Geom_RectangularTrimmedSurface(surface, u0, u1, v0, v1));
}

/// Along a direction in which the denominator does not vary the degree stays.
TEST(Displacement, RaisesTheDegreeOnlyWhereTheDenominatorVaries) {
  const handle<Geom_Surface> cylinder = new Geom_CylindricalSurface(gp_Ax3(), 20);
  const Spline given = splineFrom(cylinder, 0, 5, 0, 30);
  std::mt19937 generator(testSeed());
  Displacement displacement(given, wholeOf(given), 4, near_mm);
  moveAnyhow(displacement, generator, 0.01);
  const Spline moved = displacement.moved().surface;
  EXPECT_EQ(moved->UDegree(), given->UDegree() + 3);
  EXPECT_EQ(moved->VDegree(), 3);
  EXPECT_LT(largestError_mm(given, displacement), 1e-10);
}

TEST(Displacement, OfARationalSurfaceIsAddedToIt) {
  std::mt19937 generator(testSeed());
  const handle<Geom_Surface> cylinder = new Geom_CylindricalSurface(gp_Ax3(), 20),
                             ball = new Geom_SphericalSurface(gp_Ax3(), 20);
  for (const Spline& given :
       {splineFrom(cylinder, 0, 1.2, 0, 30), splineFrom(ball, 0.1, 1.2, -0.5, 0.6),
        splineFrom(ball, 0.1, 5.2, -0.5, 0.6)}) {
    ASSERT_TRUE(given->IsURational() || given->IsVRational());
    Displacement displacement(given, wholeOf(given), 4, near_mm);
    moveAnyhow(displacement, generator, 0.01);
    EXPECT_LT(largestError_mm(given, displacement), 1e-10);
    // The move is never larger than that of the poles.
    const Spline moved = displacement.moved().surface;
    double largest = 0;
    forGrid(given, [&](double u, double v) {
      largest = std::max(largest, (pointOf(moved, u, v) - pointOf(given, u, v)).norm());
    });
    EXPECT_LE(largest, displacement.moved().largest_move_mm * (1 + 1e-9));
  }
}

/// Turned all round, as OpenCASCADE makes them of a cylinder, a torus and a ball: weights, double
/// knots, ends that meet, poles.
TEST(Displacement, OfAClosedRationalSurfaceIsAddedNearly) {
  constexpr double size_mm = 0.01;
  std::mt19937 generator(testSeed());
  const std::vector<std::pair<std::string, TopoDS_Shape>> solids = {
      {"cylinder", BRepPrimAPI_MakeCylinder(20, 30).Shape()},
      {"torus", BRepPrimAPI_MakeTorus(30, 10).Shape()},
      {"ball", BRepPrimAPI_MakeSphere(20).Shape()}};
  for (const auto& [name, solid] : solids)
    for (const int spans : {4, 8}) {
      SCOPED_TRACE(name + ", " + std::to_string(spans));
      const Spline given = Spline::DownCast(
          BRep_Tool::Surface(face(BRepBuilderAPI_NurbsConvert(solid, true).Shape(), 1)));
      ASSERT_TRUE(given->IsURational() || given->IsVRational());
      Displacement displacement(given, wholeOf(given), spans, near_mm);
      moveAnyhow(displacement, generator, size_mm);
      if (name != "ball") {
        EXPECT_LT(largestError_mm(given, displacement), 0.1 * size_mm);
      }
      EXPECT_LT(displacement.moved().largest_move_mm, 4 * size_mm);
    }
}

/// A tube with a wave, polynomial and periodic in u.
Spline tube(bool periodic, int degree_u = 3) {
  constexpr int around = 12, along = 6;
  TColgp_Array2OfPnt poles(1, around, 1, along);
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < along; ++j) {
      const double angle = 2 * pi * i / around, radius = 15 + std::sin(3 * angle);
      poles(i + 1, j + 1) = gp_Pnt(radius * std::cos(angle), radius * std::sin(angle), 8.0 * j);
    }
  TColStd_Array1OfReal u(1, around + 1), v(1, along - 2);
  TColStd_Array1OfInteger of_u(1, around + 1), of_v(1, along - 2);
  for (int k = 0; k <= around; ++k) u(k + 1) = k;
  for (int k = 0; k < along - 2; ++k) v(k + 1) = k;
  of_u.Init(1);
  of_v.Init(1);
  of_v(1) = of_v(along - 2) = 4;
  const Spline surface = new Geom_BSplineSurface(poles, u, v, of_u, of_v, degree_u, 3, true, false);
  if (periodic) return surface;
  surface->SetUNotPeriodic();
  surface->Segment(0, around, 0, along - 3);  // clamped
  return surface;
}

/// The first weight of a periodic surface changes with its degree and its knots.
TEST(Displacement, OfAPeriodicSurfaceHasItsDenominator) {
  std::mt19937 generator(testSeed());
  for (const int degree : {2, 3, 5}) {
    SCOPED_TRACE(degree);
    const Spline given = tube(true, degree);
    setRandomWeights(given, generator);
    Displacement displacement(given, wholeOf(given), 4, near_mm);
    for (const bool halved : {false, true}) {
      if (halved) displacement.halve({std::set<int>{displacement.basis().u().spans().back()}, {}});
      moveAnyhow(displacement, generator, 0.5);
      EXPECT_NE(displacement.denominator({0.5, 0.5}), 1);
      EXPECT_LT(largestError_mm(given, displacement), 1e-10);
    }
  }
}

TEST(Displacement, ATubeStaysClosedAndSmooth) {
  std::mt19937 generator(testSeed());
  for (const bool periodic : {true, false}) {
    SCOPED_TRACE(periodic);
    const Spline given = tube(periodic);
    Displacement displacement(given, wholeOf(given), 6, near_mm);
    moveAnyhow(displacement, generator, 0.5);
    EXPECT_LT(largestError_mm(given, displacement), 1e-12 * displacement.size_mm());
    EXPECT_TRUE(displacement.basis().u().periodic);
    const Spline moved = displacement.moved().surface;
    EXPECT_EQ(moved->IsUPeriodic(), periodic);
    const std::array<double, 4> range = wholeOf(given);
    EXPECT_EQ(wholeOf(moved), range);
    for (const double v : {0.0, 1.3, 3.0}) {
      std::array<gp_Pnt, 2> p;
      std::array<gp_Vec, 2> du, dv, duu, dvv, duv;
      for (const int k : {0, 1}) moved->D2(range[k], v, p[k], du[k], dv[k], duu[k], dvv[k], duv[k]);
      EXPECT_LT(p[0].Distance(p[1]), 1e-11);
      EXPECT_LT((du[0] - du[1]).Magnitude(), 1e-10);
      EXPECT_LT((duu[0] - duu[1]).Magnitude(), 1e-9);
    }
  }
}

TEST(Displacement, ASideThatIsOnePointStaysOne) {
  std::mt19937 generator(testSeed());
  for (const int side : {0, 1, 2, 3})
    for (const double off_mm : {0.0, 0.5 * near_mm}) {
      const Spline given = sheet(generator, 7, 7, 3, 3);
      const gp_Pnt top = given->Pole(side == 1 ? 7 : 1, side == 3 ? 7 : 1);
      for (int k = 1; k <= 7; ++k)
        given->SetPole(side == 0   ? 1
                       : side == 1 ? 7
                                   : k,
                       side == 2   ? 1
                       : side == 3 ? 7
                                   : k,
                       top.Translated(gp_Vec(random(generator, off_mm / 4), 0, 0)));
      Displacement displacement(given, wholeOf(given), 4, near_mm);
      const occ::SurfaceBasis& basis = displacement.basis();
      const int across = side < 2 ? basis.v().poles : basis.u().poles;
      EXPECT_EQ(displacement.count(), basis.u().poles * basis.v().poles - across + 1);
      moveAnyhow(displacement, generator, 0.3);
      const Spline moved = displacement.moved().surface;
      const auto at = [&](double t) {
        return side < 2 ? moved->Value(side, t) : moved->Value(t, side - 2);
      };
      EXPECT_GT(at(0.5).Distance(top), 1e-3);
      for (double t = 0; t <= 1; t += 0.04)
        EXPECT_LT(at(t).Distance(at(0)), 1e-11) << side << " " << t;
    }
}

TEST(Displacement, KnotsThatAreInsertedChangeNothing) {
  std::mt19937 generator(testSeed());
  for (const Spline& given : {unevenSheet(generator, 3, 3), tube(true), tube(false)}) {
    Displacement displacement(given, wholeOf(given), 4, near_mm);
    moveAnyhow(displacement, generator, 0.5);
    EXPECT_FALSE(displacement.halve({}));
    const Displacement before = displacement;
    for (int k = 0; k < 3; ++k) {
      const std::vector<int> u = displacement.basis().u().spans(),
                             v = displacement.basis().v().spans();
      const int count = displacement.count();
      ASSERT_TRUE(displacement.halve({{{u.front(), u.back()}, {v[v.size() / 2]}}}));
      EXPECT_GT(displacement.count(), count);
      forGrid(given, [&](double at_u, double at_v) {
        EXPECT_LT((moveAt(displacement, at_u, at_v) - moveAt(before, at_u, at_v)).norm(), 1e-12);
      });
      EXPECT_LT(largestError_mm(given, displacement), 1e-12 * displacement.size_mm());
    }
  }
}

double energyOf(const Displacement& displacement) {
  double sum = 0;
  for (const occ::EnergyBlock& block : displacement.bending()) {
    const PointRows own = displacement.coefficients()(block.coefficients, Eigen::indexing::all);
    sum += (own.transpose() * block.matrix * own).trace();
  }
  return sum;
}

/// Coefficients of the spline nearest to a function of the point in space. \returns by how much it
/// is missed.
double moveBy(const Spline& given,
              const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& move,
              Displacement& displacement) {
  const occ::SurfaceBasis& basis = displacement.basis();
  std::vector<Eigen::RowVectorXd> rows;
  std::vector<Eigen::Vector3d> values;
  forGrid(given, [&](double u, double v) {
    const Eigen::VectorXd of_u = functionsAt(basis.u(), u), of_v = functionsAt(basis.v(), v);
    Eigen::RowVectorXd row(displacement.count());
    for (int i = 0; i < basis.u().poles; ++i)
      for (int j = 0; j < basis.v().poles; ++j) row[basis.pole(i, j)] = of_u[i] * of_v[j];
    rows.push_back(row);
    values.push_back(move(pointOf(given, u, v)));
  });
  const auto count = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd a(count, displacement.count()), b(count, 3);
  for (Eigen::Index k = 0; k < count; ++k) {
    a.row(k) = rows[k];
    b.row(k) = values[k].transpose();
  }
  const Eigen::MatrixXd found = a.colPivHouseholderQr().solve(b);
  displacement.setCoefficients(found);
  return (a * found - b).cwiseAbs().maxCoeff();
}

constexpr double length_mm = 40, width_mm = 25;

/// A rectangle of that length and width, its parameters from 0 to 1. \param bent how uneven they
/// run
Spline rectangle(double bent = 0) {
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      poles(i + 1, j + 1) = gp_Pnt(length_mm * (0.5 * i + (i == 1 ? bent : 0)),
                                   width_mm * (0.5 * j - (j == 1 ? bent : 0)), 0);
  return splineOf(poles, 2, 2);
}

Eigen::Vector3d quadratic(const Eigen::Vector3d& at) {
  const double x = at[0], y = at[1];
  return {1e-4 * x * x, 0.3 - 2e-4 * x * y, 3e-4 * y * y - 1e-4 * x * y + 0.01 * x};
}

/// Of its coordinates: (2 1e-4)^2; 2 (2e-4)^2; (2 3e-4)^2 + 2 (1e-4)^2.
constexpr double quadratic_density = 4e-8 + 8e-8 + 36e-8 + 2e-8;

TEST(Displacement, BendingOfAQuadraticOverAPlaneIsInClosedForm) {
  const Spline given = rectangle();
  for (const int spans : {1, 4, 6}) {
    Displacement displacement(given, wholeOf(given), spans, near_mm);
    ASSERT_LT(moveBy(given, quadratic, displacement), 1e-12);
    const double exact = quadratic_density * length_mm * width_mm;
    EXPECT_NEAR(energyOf(displacement), exact, 1e-8 * exact);
    ASSERT_LT(moveBy(
                  given,
                  [](const Eigen::Vector3d& p) {
                    return Eigen::Vector3d(1 + 0.1 * p[0], p[0] - 0.2 * p[1], p[1]);
                  },
                  displacement),
              1e-11);
    EXPECT_LT(energyOf(displacement), 1e-8 * exact);
  }
}

/// Beyond the face the surface bends nearly for free.
TEST(Displacement, BeyondTheFaceBendingCountsForLess) {
  const Spline given = rectangle();
  Displacement displacement(given, {0, 0.5, 0, 1}, 4, near_mm);
  ASSERT_LT(moveBy(given, quadratic, displacement), 1e-12);
  const double half = quadratic_density * length_mm * width_mm / 2;
  EXPECT_NEAR(energyOf(displacement), 1.03 * half, 1e-6 * half);
}

/// A tilted plane of uneven parameters: the energy is that of the move in space.
TEST(Displacement, BendingDoesNotDependOnParameters) {
  const Spline given = rectangle(0.1);
  given->IncreaseDegree(4, 4);
  Displacement displacement(given, wholeOf(given), 4, near_mm);
  ASSERT_LT(moveBy(given, quadratic, displacement), 1e-10);
  const double exact = quadratic_density * length_mm * width_mm;
  EXPECT_NEAR(energyOf(displacement), exact, 1e-3 * exact);
}

TEST(Displacement, BendingUnderMotionScaleAndExchange) {
  std::mt19937 generator(testSeed());
  const Spline given = unevenSheet(generator, 3, 4);
  Displacement here(given, wholeOf(given), 4, near_mm);
  moveAnyhow(here, generator, 0.1);
  const double energy = energyOf(here);
  ASSERT_GT(energy, 0);
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(3, -20, 7), gp_Dir(1, 2, -0.5)), 0.8);
  Displacement there(Spline::DownCast(given->Transformed(turn)), wholeOf(given), 4, near_mm);
  there.setCoefficients(here.coefficients());  // turning all of them changes no sum of squares
  EXPECT_NEAR(energyOf(there), energy, 1e-9 * energy);
  EXPECT_NEAR(there.size_mm(), here.size_mm(), 1e-9 * here.size_mm());
  gp_Trsf grow;
  grow.SetScale(gp_Pnt(1, 2, 3), 30);
  Displacement larger(Spline::DownCast(given->Transformed(grow)), wholeOf(given), 4, 30 * near_mm);
  larger.setCoefficients(30 * here.coefficients());
  EXPECT_NEAR(energyOf(larger), energy, 1e-9 * energy);
  const Spline swapped = Spline::DownCast(given->Copy());
  swapped->ExchangeUV();
  Displacement exchanged(swapped, wholeOf(swapped), 4, near_mm);
  PointRows own(here.count(), 3);
  for (int i = 0; i < here.basis().u().poles; ++i)
    for (int j = 0; j < here.basis().v().poles; ++j)
      own.row(exchanged.basis().pole(j, i)) = here.coefficients().row(here.basis().pole(i, j));
  exchanged.setCoefficients(own);
  EXPECT_NEAR(energyOf(exchanged), energy, 1e-9 * energy);
}

}  // namespace
}  // namespace seamwright::test
