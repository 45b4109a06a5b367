// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/seam/bspline_side.hpp>
#include <seamwright/core/seam/patch_side.hpp>

#include "spline_surfaces.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using test::clampedKnots, test::strip, test::StripShape, test::Vec;

double distance(const SurfaceJet& a, const SurfaceJet& b) {
  double largest = 0;
  for (const auto member :
       {&SurfaceJet::p, &SurfaceJet::u, &SurfaceJet::v, &SurfaceJet::uu, &SurfaceJet::uv,
        &SurfaceJet::vv, &SurfaceJet::uuu, &SurfaceJet::uuv, &SurfaceJet::uvv, &SurfaceJet::vvv})
    largest = std::max(largest, (a.*member - b.*member).norm() / (1 + (a.*member).norm()));
  return largest;
}

/// Cox and de Boor's definition.
double basis(const std::vector<double>& knots, int i, int degree, double t) {
  if (degree == 0) return knots[i] <= t && t < knots[i + 1] ? 1 : 0;
  double value = 0;
  if (knots[i + degree] > knots[i])
    value += (t - knots[i]) / (knots[i + degree] - knots[i]) * basis(knots, i, degree - 1, t);
  if (knots[i + degree + 1] > knots[i + 1])
    value += (knots[i + degree + 1] - t) / (knots[i + degree + 1] - knots[i + 1]) *
             basis(knots, i + 1, degree - 1, t);
  return value;
}

Vec pointByDefinition(const BSplineSurface& s, double u, double v) {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (int i = 0; i < s.countU(); ++i)
    for (int j = 0; j < s.countV(); ++j)
      sum += basis(s.knots_u, i, s.degree_u, u) * basis(s.knots_v, j, s.degree_v, v) *
             s.poles.row(static_cast<Eigen::Index>(i) * s.countV() + j).transpose();
  return sum.head<3>() / sum(3);
}

StripShape shape(int across, int along, std::vector<double> inner, bool rational) {
  return {across, along, std::move(inner), rational};
}

TEST(BSplineSurface, OfAPatchTheJetIsThePatchs) {  // (1)
  std::mt19937_64 random(testSeed());
  for (int across = 1; across <= 5; ++across)
    for (int along = 1; along <= 5; ++along)
      for (const bool rational : {false, true}) {
        const BezierPatch patch =
            bezierPatch(strip(shape(across, along, {}, rational), 1, 0.5, random));
        const BSplineSurface surface = splineSurface(patch);
        EXPECT_EQ(bezierPatch(surface).degreeV(), along);
        for (const double u : {0.0, 0.3, 1.0, 1.2})
          for (const double v : {0.0, 0.8, 1.0, -0.1})
            EXPECT_LT(distance(jet(surface, u, v), patch.jet(u, v)), 1e-11);
      }
}

TEST(BSplineSurface, PointsAreThoseOfTheDefinition) {
  std::mt19937_64 random(testSeed());
  for (const bool rational : {false, true}) {
    BSplineSurface surface = strip(shape(3, 3, {0.2, 0.5, 0.5, 0.9}, rational), 1, 0.5, random);
    surface = withKnot(surface, SurfaceDirection::U, 0.25);
    for (const double u : {0.0, 0.2, 0.25, 0.7})
      for (const double v : {0.0, 0.1, 0.2, 0.3, 0.5, 0.9, 0.95})
        EXPECT_LT((jet(surface, u, v).p - pointByDefinition(surface, u, v)).norm(), 1e-13);
  }
}

TEST(BSplineSurface, PartialsAreDerivativesOfThePoint) {  // (2)
  std::mt19937_64 random(testSeed());
  const BSplineSurface surface = strip(shape(4, 3, {0.4}, true), 1, 0.3, random);
  const double h = 1e-4, u = 0.55, v = 0.62;
  const auto by = [&](Vec SurfaceJet::*member, double du, double dv) -> Vec {
    return (jet(surface, u + du, v + dv).*member - jet(surface, u - du, v - dv).*member) / (2 * h);
  };
  const SurfaceJet x = jet(surface, u, v);
  const auto expectNear = [](const Vec& value, const Vec& wanted) {
    EXPECT_LT((value - wanted).norm(), 1e-5 * (1 + wanted.norm()));
  };
  expectNear(by(&SurfaceJet::p, h, 0), x.u);
  expectNear(by(&SurfaceJet::p, 0, h), x.v);
  expectNear(by(&SurfaceJet::u, h, 0), x.uu);
  expectNear(by(&SurfaceJet::u, 0, h), x.uv);
  expectNear(by(&SurfaceJet::v, 0, h), x.vv);
  expectNear(by(&SurfaceJet::uu, h, 0), x.uuu);
  expectNear(by(&SurfaceJet::uu, 0, h), x.uuv);
  expectNear(by(&SurfaceJet::vv, h, 0), x.uvv);
  expectNear(by(&SurfaceJet::vv, 0, h), x.vvv);
}

TEST(BSplineSurface, MoreKnotsAndDegreesChangeNoPoint) {  // (3)
  std::mt19937_64 random(testSeed());
  std::uniform_real_distribution<double> place(0.01, 0.99);
  for (int round = 0; round < 40; ++round) {
    const BSplineSurface given =
        strip(shape(1 + round % 4, 2 + round % 4, {0.3, 0.6}, round % 2), 1, 0.5, random);
    const BSplineSurface finer[] = {
        withKnot(given, SurfaceDirection::U, place(random)),
        withKnot(given, SurfaceDirection::V, place(random)),
        withKnot(given, SurfaceDirection::V, 0.3),
        withRaisedKnots(given, SurfaceDirection::V, 1 + round % 3),
        withKnots(given, SurfaceDirection::V, {0.9, 0.41, 0.3, 0.72, 0.9}),
        elevated(given, SurfaceDirection::U),
        elevated(given, SurfaceDirection::V)};
    for (const BSplineSurface& surface : finer) {
      requireValid(surface);
      EXPECT_GT(surface.poles.rows(), given.poles.rows());
      for (int k = 0; k < 5; ++k) {
        const double u = place(random), v = place(random);
        EXPECT_LT(distance(jet(surface, u, v), jet(given, u, v)), 1e-11);
      }
    }
  }
}

TEST(BSplineSurface, KnotsAtOnceAreKnotsOneAfterAnother) {
  std::mt19937_64 random(testSeed());
  std::uniform_real_distribution<double> place(0.01, 0.99);
  for (int round = 0; round < 40; ++round) {
    const BSplineSurface given =
        strip(shape(3, 1 + round % 5, {0.3, 0.6}, round % 2), 1, 0.5, random);
    std::vector<double> added;
    for (int k = 0; k < 8; ++k) added.push_back(place(random));
    BSplineSurface one_by_one = given;
    for (const double knot : added) one_by_one = withKnot(one_by_one, SurfaceDirection::V, knot);
    const BSplineSurface at_once = withKnots(given, SurfaceDirection::V, added);
    EXPECT_EQ(at_once.knots_v, one_by_one.knots_v);
    EXPECT_LT((at_once.poles - one_by_one.poles).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_EQ(isRational(at_once.poles), isRational(given.poles));
    EXPECT_EQ(at_once.poles.row(0), given.poles.row(0));
    EXPECT_EQ(withKnots(given, SurfaceDirection::V, {}), given);
  }
}

TEST(BSplineSurface, TheNetOfAHigherDegreeIsConvexAndSmooth) {
  std::mt19937_64 random(testSeed());
  BSplineSurface given = strip(shape(2, 3, {0.2, 0.5, 0.5, 0.9}, false), 1, 0.5, random);
  for (int degree = 4; degree <= 25; ++degree) {
    given.poles.col(0).setConstant(7);
    const double low = given.poles.col(2).minCoeff(), high = given.poles.col(2).maxCoeff();
    given = elevated(given, SurfaceDirection::V);
    EXPECT_EQ(given.degree_v, degree);
    EXPECT_EQ(std::ranges::count(given.knots_v, 0.2), degree - 2);
    EXPECT_TRUE((given.poles.col(0).array() == 7).all());
    EXPECT_TRUE((given.poles.col(3).array() == 1).all());
    EXPECT_GE(given.poles.col(2).minCoeff(), low);
    EXPECT_LE(given.poles.col(2).maxCoeff(), high);
  }
  EXPECT_THROW(elevated(given, SurfaceDirection::V), std::invalid_argument);
}

TEST(BSplineSurface, RaisedKnotsEndAtTheDegree) {
  std::mt19937_64 random(testSeed());
  const BSplineSurface given = strip(shape(2, 3, {0.25, 0.5, 0.5}, false), 1, 0.5, random);
  EXPECT_EQ(withRaisedKnots(given, SurfaceDirection::V, 0), given);
  EXPECT_EQ(withRaisedKnots(given, SurfaceDirection::U, 2), given);
  EXPECT_EQ(withRaisedKnots(given, SurfaceDirection::V, 1).knots_v,
            clampedKnots(3, {0.25, 0.25, 0.5, 0.5, 0.5}));
  EXPECT_EQ(withRaisedKnots(given, SurfaceDirection::V, 9).knots_v,
            clampedKnots(3, {0.25, 0.25, 0.25, 0.5, 0.5, 0.5}));
}

TEST(BSplineSurface, AnyEdgeInAnySenseGivesTheSameSide) {
  std::mt19937_64 random(testSeed());
  const BSplineSurface left = strip(shape(2, 3, {0.5}, true), -1, 0, random),
                       right = strip(shape(3, 3, {0.5}, false), 1, 0.05, random);
  const SeamFigures wanted = encloseSeam(seamSide(left, PatchEdge::U0),
                                         seamSide(right, PatchEdge::U0), ContinuityTolerance{});
  for (const PatchEdge a : {PatchEdge::U0, PatchEdge::U1, PatchEdge::V0, PatchEdge::V1})
    for (const bool reversed : {false, true}) {
      const SeamFigures figures =
          encloseSeam(seamSide(test::turned(left, a), a, reversed),
                      seamSide(right, PatchEdge::U0, reversed), ContinuityTolerance{});
      EXPECT_TRUE(figures.certified);
      EXPECT_FALSE(figures.fold_at);
      EXPECT_NEAR(figures.gap_mm->lower, wanted.gap_mm->lower, 0.02 * wanted.gap_mm->lower);
      EXPECT_NEAR(figures.angle_rad->lower, wanted.angle_rad->lower,
                  0.02 * wanted.angle_rad->lower);
    }
}

TEST(BSplineSurface, TheSideOfAPatchIsThatOfItsSpline) {
  std::mt19937_64 random(testSeed());
  const BSplineSurface left = strip(shape(2, 3, {}, true), -1, 0.1, random),
                       right = strip(shape(3, 2, {}, true), 1, 0.1, random);
  const SeamFigures one =
      encloseSeam(seamSide(left, PatchEdge::U0), seamSide(right, PatchEdge::U0), {});
  const SeamFigures other = encloseSeam(seamSide(bezierPatch(left), PatchEdge::U0),
                                        seamSide(bezierPatch(right), PatchEdge::U0), {});
  EXPECT_NEAR(one.angle_rad->lower, other.angle_rad->lower, 1e-9);
  EXPECT_NEAR(one.gap_mm->lower, other.gap_mm->lower, 1e-9);
}

TEST(BSplineSurface, WhatIsNoneIsRefused) {
  using testing::HasSubstr, testing::ThrowsMessage;
  std::mt19937_64 random(testSeed());
  const BSplineSurface good = strip(shape(2, 3, {0.5}, false), 1, 0.1, random);
  const auto expectRefused = [](const BSplineSurface& surface, const std::string& text) {
    EXPECT_THAT([&] { requireValid(surface); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
    EXPECT_THROW(jet(surface, 0.5, 0.5), std::invalid_argument);
    EXPECT_THROW(seamSide(surface, PatchEdge::U0), std::invalid_argument);
  };
  const auto changed = [&](auto change) {
    BSplineSurface surface = good;
    change(surface);
    return surface;
  };
  using S = BSplineSurface;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  expectRefused(S{}, "degree_u is 0");
  expectRefused(changed([](S& s) { s.degree_v = 26; }), "degree_v is 26");
  expectRefused(changed([](S& s) { s.knots_v.resize(7); }), "knots_v are 7");
  expectRefused(changed([](S& s) { s.knots_v[4] = -0.5; }), "knot 4 of knots_v is -0.5");
  expectRefused(changed([](S& s) { s.knots_v[4] = nan; }), "knot 4 of knots_v is nan");
  expectRefused(changed([](S& s) { s.knots_v[3] = 0.1; }), "knot 3 of knots_v");
  expectRefused(changed([](S& s) { s.knots_v[5] = 0.9; }), "knot 6 of knots_v");
  expectRefused(changed([](S& s) { s.knots_u = {0, 0, 0, 0, 0, 0}; }), "knots_u");
  expectRefused(changed([](S& s) {
                  for (double& knot : s.knots_u) knot = (2 * knot - 1) * 1e308;
                }),
                "range of the knots");
  expectRefused(changed([](S& s) {
                  for (double& knot : s.knots_u) knot *= 5e-324;
                }),
                "range of the knots");
  EXPECT_THROW(jet(good, nan, 0.5), std::invalid_argument);
  EXPECT_THROW(jet(good, 0.5, std::numeric_limits<double>::infinity()), std::invalid_argument);
  expectRefused(changed([](S& s) { s.poles.conservativeResize(14, 4); }), "poles 14");
  expectRefused(changed([](S& s) { s.poles(3, 1) = nan; }), "pole 3");
  expectRefused(changed([](S& s) { s.poles(5, 3) = -2; }), "weight 5 is -2");
  BSplineSurface quadruple = strip(shape(1, 3, {0.5, 0.5, 0.5, 0.5}, false), 1, 0.1, random);
  expectRefused(quadruple, "knot 4 of knots_v");
  EXPECT_THROW(withKnot(good, SurfaceDirection::V, 0), std::invalid_argument);
  EXPECT_THROW(withKnot(good, SurfaceDirection::V, 1), std::invalid_argument);
  EXPECT_THROW(withKnot(good, SurfaceDirection::V, nan), std::invalid_argument);
  EXPECT_THROW(withKnots(good, SurfaceDirection::V, {0.3, 1}), std::invalid_argument);
  EXPECT_THROW(withKnots(good, SurfaceDirection::V, {nan}), std::invalid_argument);
  EXPECT_THROW(withKnots(good, SurfaceDirection::V, std::vector(9, 0.3)), std::invalid_argument);
  EXPECT_THROW(withKnot(withRaisedKnots(good, SurfaceDirection::V, 9), SurfaceDirection::V, 0.5),
               std::invalid_argument);
  EXPECT_THROW(withRaisedKnots(good, SurfaceDirection::V, -1), std::invalid_argument);
  EXPECT_THROW(bezierPatch(good), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
