// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <ElCLib.hxx>
#include <Geom2dAPI_ProjectPointOnCurve.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Hyperbola.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <Geom2d_Parabola.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomAPI.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <cmath>
#include <gp_Ax22d.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pln.hxx>
#include <numbers>
#include <random>

#include <seamwright/occ_adapter/planar/planar_curves.hpp>

#include "support/random.hpp"

namespace seamwright::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using opencascade::handle;
using std::numbers::pi;
using ::testing::HasSubstr;
using ::testing::SizeIs;

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A curve with a range, and the size of its numbers.
struct Case {
  handle<Geom2d_Curve> curve;
  double first = 0, last = 0;
};

gp_Ax22d randomAxes(std::mt19937_64& random) {
  const double angle = uniform(random, -pi, pi);
  return {gp_Pnt2d(uniform(random, -20, 20), uniform(random, -20, 20)),
          gp_Dir2d(std::cos(angle), std::sin(angle)), uniform(random, 0, 1) < 0.5};
}

handle<Geom2d_Curve> randomSpline(std::mt19937_64& random, bool rational) {
  TColgp_Array1OfPnt2d poles(1, 7);
  TColStd_Array1OfReal weights(1, 7), knots(1, 5);
  TColStd_Array1OfInteger multiplicities(1, 5);
  for (int i = 1; i <= 7; ++i) {
    poles(i) = gp_Pnt2d(3 * i + uniform(random, -1, 1), uniform(random, -9, 9));
    weights(i) = rational ? uniform(random, 0.5, 2) : 1;
  }
  for (int i = 1; i <= 5; ++i) {
    knots(i) = i * 0.75;
    multiplicities(i) = i == 1 || i == 5 ? 4 : 1;
  }
  return new Geom2d_BSplineCurve(poles, weights, knots, multiplicities, 3);
}

/// Curves of every kind, with both orientations of their axes.
std::vector<Case> cases(std::mt19937_64& random) {
  std::vector<Case> result;
  const double from = uniform(random, -4, 4);
  const gp_Ax22d axes = randomAxes(random);
  result.push_back({new Geom2d_Line(axes.Location(), axes.XDirection()), from, from + 7});
  result.push_back({new Geom2d_Circle(axes, uniform(random, 0.1, 30)), from,
                    from + uniform(random, 0.01, 2 * pi)});
  result.push_back({new Geom2d_Ellipse(axes, 9, uniform(random, 1, 9)), from,
                    from + uniform(random, 0.1, 6.28)});
  result.push_back({new Geom2d_Ellipse(axes, 9, 4), 0, 2 * pi});
  result.push_back({new Geom2d_Hyperbola(axes, 3, 2), -1.5, uniform(random, -1, 3)});
  result.push_back({new Geom2d_Parabola(axes, uniform(random, 0.5, 5)), from, from + 12});
  for (const bool rational : {false, true}) {
    const handle<Geom2d_Curve> spline = randomSpline(random, rational);
    result.push_back({spline, spline->FirstParameter(), spline->LastParameter()});
    result.push_back({spline, 1.1, 2.9});
  }
  TColgp_Array1OfPnt2d poles(1, 4);
  for (int i = 1; i <= 4; ++i) poles(i) = gp_Pnt2d(i, uniform(random, -3, 3));
  result.push_back({new Geom2d_BezierCurve(poles), 0, 1});
  const handle<Geom2d_Curve> circle = new Geom2d_Circle(axes, 5);
  result.push_back({new Geom2d_TrimmedCurve(circle, 1, 4), 1, 4});
  return result;
}

double distanceFrom(const Case& of, const Vector2d& point) {
  const gp_Pnt2d p(point.x(), point.y());
  double least =
      std::min(p.Distance(of.curve->Value(of.first)), p.Distance(of.curve->Value(of.last)));
  if (const auto* ellipse = dynamic_cast<const Geom2d_Ellipse*>(of.curve.get())) {
    // The search for feet misses some on nearly full ellipses.
    const double u = ElCLib::InPeriod(ElCLib::Parameter(ellipse->Elips2d(), p), of.first - 1e-6,
                                      of.first - 1e-6 + 2 * pi);
    return u <= of.last + 1e-6 ? std::min(least, p.Distance(of.curve->Value(u))) : least;
  }
  const Geom2dAPI_ProjectPointOnCurve feet(p, of.curve, of.first - 1e-6, of.last + 1e-6);
  if (feet.NbPoints() > 0) least = std::min(least, feet.LowerDistance());
  return least;
}

std::vector<Vector2d> samples(const std::vector<ChainCurve>& curves, int count) {
  std::vector<Vector2d> result;
  for (const ChainCurve& curve : curves)
    for (const BezierCurve& segment : bezierCurves(curve))
      for (int i = 0; i <= count; ++i)
        result.emplace_back(segment.point(static_cast<double>(i) / count).head<2>());
  return result;
}

Vector2d vector2d(const gp_Pnt2d& p) {
  return {p.X(), p.Y()};
}

PlaneFrame randomFrame(std::mt19937_64& random) {
  Vector3d x, y;
  do {
    x = {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
    y = {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
  } while (x.cross(y).norm() < 0.1);
  x.normalize();
  y = (y - y.dot(x) * x).normalized();
  return {.origin = {uniform(random, -9, 9), uniform(random, -9, 9), uniform(random, -9, 9)},
          .x = x,
          .y = y};
}

handle<Geom_Curve> inSpace(const handle<Geom2d_Curve>& curve, const PlaneFrame& frame) {
  const Vector3d n = frame.normal();
  return GeomAPI::To3d(
      curve,
      gp_Pln(gp_Ax3(gp_Pnt(frame.origin.x(), frame.origin.y(), frame.origin.z()),
                    gp_Dir(n.x(), n.y(), n.z()), gp_Dir(frame.x.x(), frame.x.y(), frame.x.z()))));
}

constexpr double rounding = 1e-12;  // of sizes up to 100

TEST(PlanarCurves, Identity1PointsOfTheValuesAreOnTheCurve) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 40; ++trial)
    for (const Case& one : cases(random))
      for (const Vector2d& point : samples(occ::planarCurves(*one.curve, one.first, one.last), 9))
        // OpenCASCADE finds feet on splines to some 1e-9.
        EXPECT_LT(distanceFrom(one, point), 1e-8)
            << one.curve->DynamicType()->Name() << " from " << one.first << " to " << one.last;
}

TEST(PlanarCurves, Identity2TheEndsAreThoseOfTheRange) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 200; ++trial)
    for (const Case& one : cases(random)) {
      const std::vector<ChainCurve> curves = occ::planarCurves(*one.curve, one.first, one.last);
      const Vector2d start = vector2d(one.curve->Value(one.first)),
                     end = vector2d(one.curve->Value(one.last));
      EXPECT_LT((startOf(curves.front()) - start).norm(), 100 * rounding);
      EXPECT_LT((endOf(curves.back()) - end).norm(), 100 * rounding);
      for (std::size_t i = 1; i < curves.size(); ++i)
        EXPECT_EQ(endOf(curves[i - 1]), startOf(curves[i]));
    }
}

/// Points of conics and circles fulfil the equations of their kinds.
TEST(PlanarCurves, ConicsAreExact) {
  const handle<Geom2d_Curve> ellipse = new Geom2d_Ellipse(gp::OX2d(), 8, 3),
                             hyperbola = new Geom2d_Hyperbola(gp::OX2d(), 2, 3),
                             parabola = new Geom2d_Parabola(gp::OX2d(), 1.5);
  for (const Vector2d& p : samples(occ::planarCurves(*ellipse), 50))
    EXPECT_NEAR(p.x() * p.x() / 64 + p.y() * p.y() / 9, 1, 1e-14);
  for (const Vector2d& p : samples(occ::planarCurves(*hyperbola, -2, 3), 50))
    EXPECT_NEAR((p.x() * p.x() / 4 - p.y() * p.y() / 9) / (p.squaredNorm() + 1),
                1 / (p.squaredNorm() + 1), 1e-14);
  for (const Vector2d& p : samples(occ::planarCurves(*parabola, -5, 8), 50))
    EXPECT_NEAR(p.y() * p.y(), 6 * p.x(), 1e-12);
}

TEST(PlanarCurves, CirclesStayCircles) {
  const std::vector<ChainCurve> curves =
      occ::planarCurves(*handle<Geom2d_Curve>(new Geom2d_Circle(gp::OX2d(), 4)));
  ASSERT_THAT(curves, SizeIs(1));
  const PlanarArc& arc = std::get<PlanarArc>(curves.front());
  EXPECT_EQ(arc.curvature_per_mm, 0.25);
  EXPECT_NEAR(arc.sweep_rad(), 2 * pi, 1e-15);
  const auto circle = handle<Geom2d_Circle>::DownCast(occ::toGeom2d(arc));
  ASSERT_FALSE(circle.IsNull());
  EXPECT_EQ(circle->Radius(), 4);
  EXPECT_LT(circle->Location().Distance(gp_Pnt2d(0, 0)), 1e-15);
}

TEST(PlanarCurves, Identity3CurvesOfSpaceAreThoseOfTheirPlane) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 40; ++trial) {
    const PlaneFrame frame = randomFrame(random);
    for (const Case& one : cases(random)) {
      const handle<Geom_Curve> curve = inSpace(one.curve, frame);
      EXPECT_LT(occ::heightOf(*curve, one.first, one.last, frame), 100 * rounding);
      const auto inside = samples(occ::planarCurves(*curve, one.first, one.last, frame), 9);
      const auto wanted = samples(occ::planarCurves(*one.curve, one.first, one.last), 9);
      ASSERT_EQ(inside.size(), wanted.size());
      for (std::size_t i = 0; i < inside.size(); ++i)
        EXPECT_LT((inside[i] - wanted[i]).norm(), 100 * rounding)
            << one.curve->DynamicType()->Name();
    }
  }
}

TEST(PlanarCurves, PolesInCoordinatePlanesStayBitwise) {
  std::mt19937_64 random(testSeed());
  const PlaneFrame frame{.origin = {0, 0.1, 0}, .x = Vector3d::UnitX(), .y = Vector3d::UnitZ()};
  TColgp_Array1OfPnt poles(1, 4);
  TColStd_Array1OfReal knots(1, 2);
  TColStd_Array1OfInteger multiplicities(1, 2);
  for (int i = 1; i <= 4; ++i)
    poles(i) = gp_Pnt(uniform(random, -1, 1), 0.1, uniform(random, -1, 1));
  knots(1) = 0;
  knots(2) = 1;
  multiplicities.Init(4);
  const handle<Geom_BSplineCurve> spline = new Geom_BSplineCurve(poles, knots, multiplicities, 3);
  const auto curves = occ::planarCurves(*spline, 0, 1, frame);
  const BSplineCurve& value = std::get<BSplineCurve>(curves.front());
  for (int i = 1; i <= 4; ++i) {
    EXPECT_EQ(value.poles(i - 1, 0), poles(i).X());
    EXPECT_EQ(value.poles(i - 1, 1), poles(i).Z());
    EXPECT_EQ(value.poles(i - 1, 2), 0);
  }
}

TEST(PlanarCurves, Identity4ValuesComeBack) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 40; ++trial) {
    const PlaneFrame frame = randomFrame(random);
    for (const Case& one : cases(random))
      for (const ChainCurve& value : occ::planarCurves(*one.curve, one.first, one.last)) {
        const handle<Geom2d_Curve> flat = occ::toGeom2d(value);
        const handle<Geom_Curve> curve = occ::toGeom(value, frame);
        const auto back = samples(occ::planarCurves(*flat), 9);
        const auto from_space = samples(
            occ::planarCurves(*curve, curve->FirstParameter(), curve->LastParameter(), frame), 9);
        const auto wanted = samples({value}, 9);
        ASSERT_EQ(back.size(), wanted.size());
        ASSERT_EQ(from_space.size(), wanted.size());
        for (std::size_t i = 0; i < back.size(); ++i) {
          EXPECT_LT((back[i] - wanted[i]).norm(), 100 * rounding);
          EXPECT_LT((from_space[i] - wanted[i]).norm(), 100 * rounding);
        }
      }
  }
}

TEST(PlanarCurves, FlatArcsKeepTheirDigits) {
  for (const double curvature : {1e-4, 1e-6, 1e-8, 1e-12, -1e-16}) {
    const PlanarArc arc{
        .start = {3, 4}, .direction_rad = 0.5, .curvature_per_mm = curvature, .length_mm = 100};
    const handle<Geom2d_Curve> curve = occ::toGeom2d(arc);
    const double first = curve->FirstParameter(), last = curve->LastParameter();
    EXPECT_LT((vector2d(curve->Value(first)) - arc.start).norm(), 1e-8);
    EXPECT_LT((vector2d(curve->Value(last)) - arc.end()).norm(), 1e-8);
    EXPECT_LT((vector2d(curve->Value((first + last) / 2)) - arc.point(50)).norm(), 1e-8);
  }
}

TEST(PlanarCurves, HeightsAreBounds) {
  const handle<Geom_Curve> circle = new Geom_Circle(gp_Ax2(gp_Pnt(0, 0, 0.25), gp_Dir(0, 0, 1)), 3);
  EXPECT_EQ(occ::heightOf(*circle, 0, 2 * pi, PlaneFrame()), 0.25);
  const handle<Geom_Curve> line = new Geom_Line(gp_Pnt(0, 0, 0), gp_Dir(3, 0, 4));
  EXPECT_NEAR(occ::heightOf(*line, 0, 5, PlaneFrame()), 4, 1e-15);
}

template <class Call>
std::string whatOf(const Call& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(PlanarCurves, RefusesWithNumbers) {
  const handle<Geom2d_Curve> line = new Geom2d_Line(gp::OX2d());
  EXPECT_THROW(occ::planarCurves(*line), std::domain_error);
  EXPECT_THROW(occ::planarCurves(*line, 2, 2), std::invalid_argument);
  EXPECT_THROW(occ::planarCurves(*line, 0, NAN), std::invalid_argument);
  const handle<Geom2d_Curve> offset =
      new Geom2d_OffsetCurve(new Geom2d_Ellipse(gp::OX2d(), 5, 3), 1);
  EXPECT_THAT(whatOf([&] { occ::planarCurves(*offset); }), HasSubstr("Geom2d_OffsetCurve"));
  const handle<Geom_Curve> tilted = new Geom_Circle(gp_Ax2(gp::Origin(), gp_Dir(0, 0.6, 0.8)), 3);
  EXPECT_THAT(whatOf([&] { occ::planarCurves(*tilted, 0, 1, PlaneFrame()); }),
              HasSubstr("Geom_Circle is in another plane: its axis is 0.6"));
  EXPECT_THROW(occ::toGeom2d(PlanarArc{}), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright::test
