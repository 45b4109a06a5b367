// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <Geom_BezierCurve.hxx>
#include <Geom_Line.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <seamwright/core/spline/g2_spline.hpp>
#include <seamwright/occ_adapter/convert/bezier_surface.hpp>
#include <seamwright/occ_adapter/convert/spline_curve.hpp>

#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::bezierCurve, occ::coreCurve, occ::toBezierCurve, occ::toBSplineCurve;
using opencascade::handle;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

double drawn(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Eigen::RowVector3d row(const gp_XYZ& v) {
  return {v.X(), v.Y(), v.Z()};
}

BSplineCurve randomCurve(int degree, int multiplicity, int spans, bool rational,
                         std::mt19937_64& random) {
  BSplineCurve curve{degree, std::vector<double>(degree + 1, drawn(random, -3, 3)), {}};
  for (int i = 0; i < spans; ++i)
    curve.knots.insert(curve.knots.end(), i + 1 < spans ? multiplicity : degree + 1,
                       curve.knots.back() + drawn(random, 0.1, 2));
  curve.poles.resize(curve.count(), 4);
  for (int i = 0; i < curve.count(); ++i) {
    const double w = rational ? drawn(random, 0.4, 2.5) : 1;
    curve.poles.row(i) << w * drawn(random, -9, 9), w * drawn(random, -9, 9),
        w * drawn(random, -9, 9), w;
  }
  return curve;
}

/// OpenCASCADE's evaluation against the curve's, on its own parameter. \param order at most 2.
template <class Curve>
void expectSameCurve(const Geom_Curve& theirs, const Curve& ours, double first, double last,
                     std::mt19937_64& random, double noise = 1e-13) {
  EXPECT_NEAR(theirs.FirstParameter(), first, 1e-15 * (1 + std::abs(first)));
  EXPECT_NEAR(theirs.LastParameter(), last, 1e-15 * (1 + std::abs(last)));
  for (int i = 0; i < 10; ++i) {
    const double t = drawn(random, first, last);
    gp_Pnt p;
    gp_Vec d1, d2;
    theirs.D2(t, p, d1, d2);
    const CurveDerivatives x = derivatives(ours, t, 2);
    EXPECT_LT((x.row(0) - row(p.XYZ())).norm(), noise * (1 + x.row(0).norm()));
    EXPECT_LT((x.row(1) - row(d1.XYZ())).norm(), 1e3 * noise * (10 + x.row(1).norm()));
    EXPECT_LT((x.row(2) - row(d2.XYZ())).norm(), 1e6 * noise * (10 + x.row(2).norm()));
  }
}

TEST(SplineCurve, PolynomialsComeBackBitByBit) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 500; ++i) {
    const int degree = 1 + i % 25;
    const BSplineCurve curve = randomCurve(degree, 1 + i % degree, 1 + i % 5, false, random);
    const handle<Geom_BSplineCurve> theirs = toBSplineCurve(curve);
    EXPECT_FALSE(theirs->IsRational());
    EXPECT_EQ(coreCurve(*theirs), curve);
    if (degree < 8)
      expectSameCurve(*theirs, curve, curve.knots.front(), curve.knots.back(), random, 1e-12);
  }
}

TEST(SplineCurve, RationalsComeBackToRounding) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const int degree = 1 + i % 7;
    const BSplineCurve curve = randomCurve(degree, 1 + i % degree, 1 + i % 5, true, random);
    const handle<Geom_BSplineCurve> theirs = toBSplineCurve(curve);
    const BSplineCurve back = coreCurve(*theirs);
    EXPECT_EQ(back.knots, curve.knots);
    EXPECT_EQ(back.poles.col(3), curve.poles.col(3));
    EXPECT_LT((back.poles - curve.poles).cwiseAbs().maxCoeff(), 1e-14);
    expectSameCurve(*theirs, curve, curve.knots.front(), curve.knots.back(), random, 1e-12);
  }
}

TEST(SplineCurve, BezierCurvesBothWays) {
  std::mt19937_64 random(testSeed());
  for (int degree = 1; degree <= 25; ++degree) {
    const BSplineCurve curve = randomCurve(degree, 1, 1, false, random);
    const BezierCurve bezier = BezierCurve::fromHomogeneous(curve.poles);
    EXPECT_EQ(bezierCurve(*toBezierCurve(bezier)), bezier);
    EXPECT_EQ(coreCurve(*toBezierCurve(bezier)), splineCurve(bezier));
    EXPECT_EQ(bezierCurve(*toBSplineCurve(curve)), bezier);
  }
  EXPECT_THAT(
      [&] { coreCurve(Geom_Line(gp::OX())); },
      ThrowsMessage<std::domain_error>(HasSubstr("Geom_Line is not a Bezier or B-spline curve")));
}

G2Polygon star(int vertices) {
  G2Polygon polygon{Poles(vertices, 3), true, std::vector<double>(vertices, 0.2),
                    std::vector<double>(vertices, 0.7)};
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2 * std::numbers::pi * i / vertices, r = i % 2 ? 3 : 5;
    polygon.vertices.row(i) << r * std::cos(angle), r * std::sin(angle), i % 3;
    polygon.alpha[i] += 0.05 * (i % 3);
  }
  return polygon;
}

TEST(SplineCurve, MultiplicitiesAreAsLowAsTheSplineAllows) {
  std::mt19937_64 random(testSeed());
  G2Polygon direct = star(7);
  direct.closed = false;
  direct.alpha.pop_back();
  direct.omega.pop_back();
  const BezierSpline spline = directG2Spline(direct);
  const handle<Geom_BSplineCurve> theirs = toBSplineCurve(spline);
  EXPECT_EQ(theirs->NbKnots(), 5);
  for (int i = 2; i < 5; ++i) EXPECT_EQ(theirs->Multiplicity(i), 2);
  EXPECT_EQ(theirs->Continuity(), GeomAbs_C1);
  expectSameCurve(*theirs, spline, spline.knots.front(), spline.knots.back(), random);

  const GammaPolygon ones{direct.vertices, false, {1, 2, 1.5, 1}, {1, 1, 1, 1}};
  const handle<Geom_BSplineCurve> smooth = toBSplineCurve(gammaSpline(ones));
  for (int i = 2; i < 5; ++i) EXPECT_EQ(smooth->Multiplicity(i), 1);
  EXPECT_EQ(smooth->Continuity(), GeomAbs_C2);
  for (int i = 1; i <= 7; ++i)
    EXPECT_LT((row(smooth->Pole(i).XYZ()) - direct.vertices.row(i - 1)).norm(), 1e-13);
}

/// A closed gamma-spline is C1 at its seam too, one with gamma = 1 is C2; a direct G2 spline in
/// general is not.
TEST(SplineCurve, ClosedSplinesArePeriodic) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const int count = 3 + i % 6;
    GammaPolygon polygon{star(count).vertices, true, {}, {}};
    for (int s = 0; s < count; ++s) {
      polygon.lengths.push_back(drawn(random, 0.3, 3));
      polygon.gamma.push_back(i % 3 == 0 ? 1 : drawn(random, 0.2, 4));
    }
    const BezierSpline spline = gammaSpline(polygon);
    const handle<Geom_BSplineCurve> theirs = toBSplineCurve(spline, true);
    EXPECT_TRUE(theirs->IsPeriodic());
    EXPECT_EQ(theirs->Multiplicity(1), i % 3 == 0 ? 1 : 2);
    EXPECT_EQ(theirs->NbPoles(), count * theirs->Multiplicity(1));
    expectSameCurve(*theirs, spline, spline.knots.front(), spline.knots.back(), random, 1e-12);
    gp_Pnt p;
    gp_Vec before, after, second;
    theirs->D2(theirs->LastParameter() - 1e-9, p, before, second);
    theirs->D2(theirs->FirstParameter() + 1e-9, p, after, second);
    EXPECT_LT((before - after).Magnitude(), 1e-6 * after.Magnitude());
    const BSplineCurve back = coreCurve(*theirs);
    EXPECT_EQ(back.knots.front(), spline.knots.front());
    expectSameCurve(*theirs, back, spline.knots.front(), spline.knots.back(), random, 1e-12);
  }
  const BezierSpline direct = directG2Spline(star(7));
  EXPECT_FALSE(toBSplineCurve(direct)->IsPeriodic());
  EXPECT_THAT(
      [&] { toBSplineCurve(direct, true); },
      ThrowsMessage<std::invalid_argument>(HasSubstr("is C1 at its knots and C0 at its seam")));
  BezierSpline open = direct;
  open.closed = false;
  EXPECT_THAT([&] { toBSplineCurve(open, true); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("not closed at its seam")));
}

TEST(SplineCurve, ACircleIsARationalPeriodicSpline) {
  std::mt19937_64 random(testSeed());
  const double c = std::sqrt(0.5);
  BezierSpline circle{2, {0, 1, 2, 3, 4}, HomogeneousPoles(9, 4), true};
  circle.poles << 1, 0, 0, 1, c, c, 0, c, 0, 1, 0, 1, -c, c, 0, c, -1, 0, 0, 1, -c, -c, 0, c, 0, -1,
      0, 1, c, -c, 0, c, 1, 0, 0, 1;
  const handle<Geom_BSplineCurve> theirs = toBSplineCurve(circle, true);
  EXPECT_TRUE(theirs->IsPeriodic() && theirs->IsRational());
  EXPECT_EQ(theirs->NbPoles(), 8);
  expectSameCurve(*theirs, circle, 0, 4, random);
  expectSameCurve(*toBSplineCurve(circle), circle, 0, 4, random);
}

TEST(SplineCurve, TrimmedCurvesGiveTheirRange) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const BSplineCurve curve = randomCurve(1 + i % 5, 1, 4, i % 2 == 0, random);
    const double range = curve.knots.back() - curve.knots.front();
    const double first = curve.knots.front() + drawn(random, 0.05, 0.4) * range,
                 last = curve.knots.front() + drawn(random, 0.6, 0.95) * range;
    const handle<Geom_TrimmedCurve> trimmed =
        new Geom_TrimmedCurve(toBSplineCurve(curve), first, last);
    const BSplineCurve back = coreCurve(*trimmed);
    EXPECT_EQ(back.knots.front(), first);
    EXPECT_EQ(back.knots.back(), last);
    expectSameCurve(*trimmed, back, first, last, random, 1e-11);
    const BezierCurve bezier = BezierCurve::fromHomogeneous(curve.poles.topRows(3));
    const handle<Geom_TrimmedCurve> part = new Geom_TrimmedCurve(toBezierCurve(bezier), 0.25, 0.75);
    expectSameCurve(*part, coreCurve(*part), 0.25, 0.75, random, 1e-12);
  }
}

TEST(SplineCurve, TrimmedAcrossTheSeamOfAPeriodicCurve) {
  std::mt19937_64 random(testSeed());
  const BezierSpline spline =
      gammaSpline({star(5).vertices, true, {1, 2, 1, 1.5, 1}, {1, 2, 0.5, 1, 1}});
  const handle<Geom_BSplineCurve> periodic = toBSplineCurve(spline, true);
  const handle<Geom_TrimmedCurve> part = new Geom_TrimmedCurve(periodic, 4.5, 8.25);
  const BSplineCurve ours = coreCurve(*part);
  expectSameCurve(*part, ours, 4.5, 8.25, random, 1e-12);
}

TEST(SplineCurve, UnclampedCurvesAreTheSameCurves) {
  std::mt19937_64 random(testSeed());
  TColgp_Array1OfPnt poles(1, 6);
  for (gp_Pnt& pole : poles)
    pole = gp_Pnt(drawn(random, -5, 5), drawn(random, -5, 5), drawn(random, -5, 5));
  TColStd_Array1OfReal knots(1, 10);
  TColStd_Array1OfInteger multiplicities(1, 10);
  multiplicities.Init(1);
  for (int i = 1; i <= 10; ++i) knots(i) = i + 0.1 * (i % 3);
  const handle<Geom_BSplineCurve> uniform = new Geom_BSplineCurve(poles, knots, multiplicities, 3);
  const BSplineCurve ours = coreCurve(*uniform);
  EXPECT_EQ(ours.count(), 6);
  expectSameCurve(*uniform, ours, uniform->FirstParameter(), uniform->LastParameter(), random,
                  1e-12);
}

/// Fewer spans than the degree, and spacings down to 2^-34: the same poles bit by bit, and those of
/// a round trip.
TEST(SplineCurve, PeriodicCurvesOfFewAndShortSpans) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 60; ++i) {
    const int degree = 2 + i % 9, spans = 2 + i % 6;
    TColgp_Array1OfPnt poles(1, spans);
    for (gp_Pnt& pole : poles)
      pole = gp_Pnt(drawn(random, -9, 9), drawn(random, -9, 9), drawn(random, -9, 9));
    TColStd_Array1OfReal knots(1, spans + 1);
    TColStd_Array1OfInteger multiplicities(1, spans + 1);
    multiplicities.Init(1);
    HomogeneousPoles found;
    for (const double spacing : {1.0, 0x1p-30, 0x1p-34}) {
      for (int k = 0; k <= spans; ++k) knots(k + 1) = k * spacing;
      const BSplineCurve ours =
          coreCurve(Geom_BSplineCurve(poles, knots, multiplicities, degree, true));
      EXPECT_EQ(ours.knots.back(), spans * spacing);
      if (spacing == 1) found = ours.poles;
      EXPECT_EQ(ours.poles, found) << spacing;
    }
  }
  for (const int count : {3, 4}) {
    const BezierSpline spline =
        gammaSpline({star(count).vertices, true, std::vector<double>(count, 1.0),
                     std::vector<double>(count, 0.5)});
    const handle<Geom_BSplineCurve> theirs = toBSplineCurve(spline, true);
    EXPECT_LT((bezierSpline(coreCurve(*theirs)).poles - spline.poles).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(SplineCurve, TrimmedToLessThanOpenCascadesConfusion) {
  std::mt19937_64 random(testSeed());
  const BSplineCurve curve = randomCurve(3, 1, 4, false, random);
  const handle<Geom_BSplineCurve> whole = toBSplineCurve(curve);
  const double middle = curve.knots[5];
  for (const double half : {1e-9, 1e-10}) {
    const handle<Geom_TrimmedCurve> part =
        new Geom_TrimmedCurve(whole, middle - half, middle + half);
    const BSplineCurve ours = coreCurve(*part);
    EXPECT_EQ(ours.knots.front(), middle - half);
    EXPECT_EQ(ours.knots.back(), middle + half);
    for (const double t : {middle - half, middle + half})
      EXPECT_LT((derivatives(ours, t, 0) - derivatives(curve, t, 0)).norm(), 1e-14);
  }
}

TEST(SplineCurve, EqualWeightsComeBackAsOne) {
  BSplineCurve curve{
      1, {0, 0, 1, 1}, (HomogeneousPoles(2, 4) << 1, 2, 4, 1, 4, 5, 6, 1).finished()};
  const BSplineCurve one = curve;
  curve.poles *= 4;
  EXPECT_EQ(coreCurve(*toBSplineCurve(curve)), one);
}

TEST(SplineCurve, KnotsTooNearAreNamed) {
  BSplineCurve curve{1, {0, 0, 1, std::nextafter(1.0, 2.0), 2, 2}, HomogeneousPoles::Ones(4, 4)};
  requireValid(curve);
  EXPECT_THAT([&] { toBSplineCurve(curve); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("distinct knots 1 and 2 are both 1")));
  curve.poles(2, 3) = 0;
  EXPECT_THAT([&] { toBSplineCurve(curve); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("weight 2 is 0")));
}

}  // namespace
}  // namespace seamwright::test
