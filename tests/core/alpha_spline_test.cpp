// SPDX-License-Identifier: LGPL-2.1-or-later
// Chains of alpha-curves: the equations of their joints, de Boor's polygon, and what moving a pole
// does.
#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <seamwright/core/spline/alpha_spline.hpp>

#include "alphas.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using test::uniform;
using test::Vec;
using testing::HasSubstr;

struct Case {
  Poles polygon;
  AlphaSplineShape shape;
};

Case randomCase(int order, bool closed, bool parametric, std::mt19937_64& random) {
  Case made;
  AlphaSplineShape& shape = made.shape;
  const int n = test::whole(closed ? 3 : 1, 7, random);
  shape.order = order;
  shape.closed = closed;
  const double least = order == 1 ? 0.1 : order == 2 ? 0.51 : 0.68;
  for (int i = 0; i < n; ++i) {
    shape.a.push_back(uniform(least, 1, random));
    shape.lengths.push_back(uniform(0.5, 2, random));
  }
  for (int j = 0; j < (closed ? n : n - 1) && !parametric; ++j) {
    shape.beta1.push_back(uniform(0.5, 1.5, random));
    if (order != 3) shape.beta2.push_back(uniform(0, 2, random));
  }
  const int count = order == 1 ? (closed ? 2 * n : 2 * n + 2) : closed ? n : n + 3;
  made.polygon.resize(count, 3);
  for (int i = 0; i < count; ++i)
    made.polygon.row(i) = (Vec(2 * i, 0, 0) + 2 * test::randomVector(random)).transpose();
  return made;
}

double valueAt(const std::vector<double>& values, std::size_t i, double otherwise) {
  return values.empty() ? otherwise : values[i];
}

TEST(AlphaSpline, Identity1EveryJointHasItsOrder) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1200; ++i) {
    const int order = 1 + i % 3;
    const bool closed = i % 2 == 0, parametric = i % 5 == 0 && order < 3;
    const Case made = randomCase(order, closed, parametric, random);
    const AlphaSpline spline = alphaSpline(made.polygon, made.shape);
    const std::size_t n = made.shape.a.size();
    ASSERT_EQ(spline.segments.size(), n);
    for (std::size_t j = 0; j < (closed ? n : n - 1); ++j) {
      const AlphaCurve &before = spline.segments[j], &after = spline.segments[(j + 1) % n];
      EXPECT_EQ(before.poles.row(3), after.poles.row(0));
      const double h = made.shape.lengths[j], k = made.shape.lengths[(j + 1) % n];
      const double b = valueAt(made.shape.beta1, j, 1);
      const Vec betas =
          order == 3 ? test::thirdOrderBetas(b, h, k) : Vec(b, valueAt(made.shape.beta2, j, 0), 0);
      const auto x = test::byCommon(alphaCurveBezier(before), 1, h, order),
                 y = test::byCommon(alphaCurveBezier(after), 0, k, order);
      EXPECT_LE(test::misfit(x, y, betas), 1e-11) << i << " joint " << j;
      AlphaCurve moved = after;
      moved.poles.row(std::min(order, 2)) += Eigen::RowVector3d(1e-6, 2e-6, -1e-6);
      EXPECT_GT(test::misfit(x, test::byCommon(alphaCurveBezier(moved), 0, k, order), betas), 1e-8);
    }
    const BezierSpline bezier = bezierSpline(spline);
    EXPECT_EQ(bezier.degree, 5);
    EXPECT_EQ(bezier.closed, closed);
    EXPECT_NEAR(bezier.knots.back(),
                std::accumulate(made.shape.lengths.begin(), made.shape.lengths.end(), 0.0),
                1e-14 * bezier.knots.back());
    for (std::size_t s = 0; s < n; ++s)
      EXPECT_EQ(segment(bezier, static_cast<int>(s)), alphaCurveBezier(spline.segments[s]));
    if (parametric && !closed && n > 1) {
      EXPECT_NO_THROW(bsplineCurve(bezier, order)) << "C^order by the knots themselves";
      EXPECT_THROW(bsplineCurve(bezier, order + 1), std::invalid_argument);
    }
  }
}

TEST(AlphaSpline, Identity2AffineMaps) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const Case made = randomCase(1 + i % 3, i % 2 == 0, false, random);
    const double scale = test::logUniform(random, -5, 5);
    const Eigen::Matrix3d map =
        scale * (test::randomRotation(random) + 0.4 * Eigen::Matrix3d::Ones());
    const Eigen::RowVector3d shift = scale * test::randomVector(random).transpose();
    const AlphaSpline plain = alphaSpline(made.polygon, made.shape);
    const AlphaSpline mapped =
        alphaSpline(Poles((made.polygon * map.transpose()).rowwise() + shift), made.shape);
    for (std::size_t s = 0; s < plain.segments.size(); ++s) {
      const Poles expected = (plain.segments[s].poles * map.transpose()).rowwise() + shift;
      EXPECT_LE((mapped.segments[s].poles - expected).cwiseAbs().maxCoeff(), 1e-12 * scale);
    }
  }
}

TEST(AlphaSpline, Identity3Backwards) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const Case made = randomCase(1 + i % 3, false, false, random);
    AlphaSplineShape back = made.shape;
    std::ranges::reverse(back.a);
    std::ranges::reverse(back.lengths);
    std::ranges::reverse(back.beta1);
    std::ranges::reverse(back.beta2);
    for (std::size_t j = 0; j < back.beta2.size(); ++j) back.beta2[j] /= std::pow(back.beta1[j], 3);
    for (double& beta : back.beta1) beta = 1 / beta;
    const AlphaSpline forth = alphaSpline(made.polygon, made.shape),
                      reversed = alphaSpline(Poles(made.polygon.colwise().reverse()), back);
    const std::size_t n = forth.segments.size();
    for (std::size_t s = 0; s < n; ++s) {
      const Poles expected = forth.segments[n - 1 - s].poles.colwise().reverse();
      EXPECT_LE((reversed.segments[s].poles - expected).cwiseAbs().maxCoeff(), 1e-12);
    }
  }
}

TEST(AlphaSpline, Identity4APoleMovesFewSegments) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const int order = 1 + i % 3;
    Case made = randomCase(order, i % 2 == 0, false, random);
    const AlphaSpline before = alphaSpline(made.polygon, made.shape);
    const int pole = test::whole(0, static_cast<int>(made.polygon.rows()) - 1, random);
    made.polygon.row(pole).array() += 0.5;
    const AlphaSpline after = alphaSpline(made.polygon, made.shape);
    int moved = 0;
    for (std::size_t s = 0; s < before.segments.size(); ++s)
      moved += before.segments[s].poles != after.segments[s].poles;
    EXPECT_GE(moved, 1);
    EXPECT_LE(moved, order == 1 ? 2 : 4);
  }
}

TEST(AlphaSpline, Identity5NoPlaneMeetsItMoreOftenThanThePolygon) {
  std::mt19937_64 random(testSeed());
  int most = 0;
  for (int i = 0; i < 1500; ++i) {
    const Case made = randomCase(1 + i % 3, false, false, random);
    const Vec normal = test::randomVector(random),
              through = test::randomVector(random) + Vec(uniform(0, 12, random), 0, 0);
    const auto heights = [&](const Poles& x) -> Eigen::VectorXd {
      return (x.rowwise() - through.transpose()) * normal;
    };
    const BezierSpline bezier = bezierSpline(alphaSpline(made.polygon, made.shape));
    Poles points(60 * bezier.segments(), 3);
    for (Eigen::Index k = 0; k < points.rows(); ++k)
      points.row(k) = segment(bezier, static_cast<int>(k / 60))
                          .point(static_cast<double>(k % 60) / 59)
                          .transpose();
    const int meets = test::signChanges(heights(points));
    EXPECT_LE(meets, test::signChanges(heights(made.polygon)));
    most = std::max(most, meets);
  }
  EXPECT_GE(most, 4);
}

TEST(AlphaSpline, ShapeOneIsClosestToThePolygon) {
  // A zigzag: the larger the shape, the further the spline gets out to its corners.
  Poles polygon(8, 3);
  for (int i = 0; i < 8; ++i) polygon.row(i) << i, i % 2, 0;
  double before = 1;
  for (const double a : {0.6, 0.7, 0.8, 0.9, 1.0}) {
    AlphaSplineShape shape;
    shape.a.assign(5, a);
    const BezierSpline spline = bezierSpline(alphaSpline(polygon, shape));
    double furthest = 1;
    for (int k = 0; k <= 400; ++k)
      furthest = std::min(
          furthest, (derivatives(spline, 1 + 3 * k / 400.0, 0).row(0) - polygon.row(4)).norm());
    EXPECT_LT(furthest, before) << a;
    before = furthest;
  }
}

TEST(AlphaSpline, Identity6AChainOfItsLinks) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const int order = 1 + i % 3;
    const Case made = randomCase(order, false, false, random);
    const AlphaSpline spline = alphaSpline(made.polygon, made.shape);
    std::vector<AlphaLink> links;
    for (std::size_t s = 1; s < spline.segments.size(); ++s) {
      AlphaLink link;
      link.join = {order,
                   valueAt(made.shape.beta1, s - 1, 1),
                   valueAt(made.shape.beta2, s - 1, 0),
                   1,
                   made.shape.lengths[s],
                   made.shape.a[s]};
      link.free_poles = spline.segments[s].poles.bottomRows(order == 1 ? 2 : 1);
      links.push_back(link);
    }
    const AlphaSpline chain =
        alphaChain(spline.segments.front(), made.shape.lengths.front(), links);
    EXPECT_EQ(chain.knots, spline.knots);
    // What rounding puts into a leg goes on along the chain by the factors.
    for (std::size_t s = 0; s < spline.segments.size(); ++s)
      EXPECT_LE((chain.segments[s].poles - spline.segments[s].poles).cwiseAbs().maxCoeff(),
                1e-13 * std::pow(60, static_cast<double>(s)));
  }
}

TEST(AlphaSpline, ChainsTakeSmallShapesThatPolygonsDoNot) {
  Poles polygon(5, 3);
  polygon << 0, 0, 0, 1, 2, 0, 3, 2, 1, 4, 0, 0, 5, 1, 0;
  AlphaSplineShape shape;
  shape.a = {0.4, 0.3};
  EXPECT_THAT(test::complaint([&] { alphaSpline(polygon, shape); }),
              HasSubstr("joint 0: second - first - third is -"));
  shape.a = {0.5, 0.5};
  EXPECT_THAT(test::complaint([&] { alphaSpline(polygon, shape); }),
              HasSubstr("second - first - third is 0"));
  shape.beta2 = {12};
  EXPECT_NO_THROW(alphaSpline(polygon, shape)) << "tension makes up for it";
  shape.beta2.clear();
  shape.order = 3;
  shape.a = {2.0 / 3 - 1e-6, 2.0 / 3 - 1e-6};
  EXPECT_THAT(test::complaint([&] { alphaSpline(polygon, shape); }), HasSubstr("joint 0"));
  AlphaCurve first;
  first.poles = polygon.topRows<4>();
  first.a = 0.4;
  AlphaLink link;
  link.join.order = 2;
  link.join.next_a = 0.3;
  link.free_poles = polygon.bottomRows<1>();
  const AlphaSpline chain = alphaChain(first, 1, {link});
  EXPECT_LE(test::misfit(alphaCurveBezier(chain.segments[0]).derivatives(1, 2),
                         alphaCurveBezier(chain.segments[1]).derivatives(0, 2), Vec(1, 0, 0)),
            1e-13);
}

TEST(AlphaSpline, RefusesBadPolygonsAndShapes) {
  std::mt19937_64 random(testSeed());
  const auto with = [&](int order, bool closed, auto change) {
    Case made = randomCase(order, closed, false, random);
    while (made.shape.a.size() < 4) made = randomCase(order, closed, false, random);
    change(made);
    return test::complaint([&] { alphaSpline(made.polygon, made.shape); });
  };
  const double nan = std::nan("");
  EXPECT_EQ(with(2, false, [](Case&) {}), "nothing was refused");
  EXPECT_THAT(with(2, false, [](Case& c) { c.shape.order = 4; }), HasSubstr("order 4"));
  EXPECT_THAT(with(2, false, [](Case& c) { c.shape.a.clear(); }), HasSubstr("a has 0 numbers"));
  EXPECT_THAT(with(2, true, [](Case& c) { c.shape.a.resize(2); }),
              HasSubstr("at least 3 are needed"));
  EXPECT_THAT(with(2, false, [](Case& c) { c.shape.a[3] = 1.5; }), HasSubstr("a[3] is 1.5"));
  EXPECT_THAT(with(1, true, [](Case& c) { c.shape.lengths[1] = -1; }),
              HasSubstr("lengths[1] is -1"));
  EXPECT_THAT(with(2, false, [](Case& c) { c.shape.lengths.pop_back(); }),
              HasSubstr("lengths has"));
  EXPECT_THAT(with(1, false, [](Case& c) { c.shape.beta1[2] = 0; }), HasSubstr("beta1[2] is 0"));
  EXPECT_THAT(with(2, true, [&](Case& c) { c.shape.beta2[0] = nan; }),
              HasSubstr("beta2[0] is nan"));
  EXPECT_THAT(with(3, true, [](Case& c) { c.shape.beta2.assign(c.shape.a.size(), 0); }),
              HasSubstr("beta2 is not free"));
  EXPECT_THAT(with(2, false, [&](Case& c) { c.polygon(3, 2) = nan; }), HasSubstr("pole 3 is ("));
  EXPECT_THAT(with(2, false, [](Case& c) { c.polygon.conservativeResize(4, 3); }),
              HasSubstr("the polygon has 4 poles"));
  EXPECT_THAT(with(1, false, [](Case& c) { c.polygon.row(3) = c.polygon.row(2).eval(); }),
              HasSubstr("joint 0: the poles before and after it are the same"));
  EXPECT_THAT(with(2, false, [](Case& c) { c.shape.beta1[0] = 1e200; }),
              HasSubstr("second of joint[0] is inf"));
  EXPECT_THAT(with(1, false,
                   [](Case& c) {
                     c.shape.beta1[1] = 1e300;
                     c.polygon *= 1e20;
                   }),
              HasSubstr("segment 1 has poles that are not finite"));
  AlphaLink link;
  link.free_poles = Poles::Zero(1, 3);
  const AlphaCurve first = test::randomAlphaCurve(random);
  EXPECT_THAT(test::complaint([&] { alphaChain(first, 1, {link}); }),
              HasSubstr("link 0: 1 free poles: 2 are needed"));
  EXPECT_THAT(test::complaint([&] { alphaChain(first, 0, {}); }), HasSubstr("length is 0"));
  link.free_poles = Poles::Constant(2, 3, nan);
  EXPECT_THAT(test::complaint([&] { alphaChain(first, 1, {link}); }),
              HasSubstr("link 0: pole 2 is (nan"));
}

}  // namespace
}  // namespace seamwright
