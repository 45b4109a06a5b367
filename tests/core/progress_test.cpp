// SPDX-License-Identifier: LGPL-2.1-or-later
#include <functional>
#include <seamwright/core/fair/fair_curve.hpp>
#include <seamwright/core/planar/arc_conics.hpp>
#include <seamwright/core/planar/arc_fit.hpp>
#include <seamwright/core/planar/clothoid_fit.hpp>
#include <seamwright/core/planar/clothoid_spline.hpp>
#include <seamwright/core/planar/fair_points.hpp>
#include <seamwright/core/planar/local_origin.hpp>
#include <vector>

#include "planar.hpp"

namespace seamwright {
namespace {

PlanarPoints wave(Eigen::Index count) {
  PlanarPoints points(count, 2);
  for (Eigen::Index i = 0; i < count; ++i)
    points.row(i) << 5.0 * double(i), 10 * std::sin(0.5 * double(i));
  return points;
}

/// Work that is stopped at its call n of the progress, for n = 0, 1, ..., until it ends.
/// \returns how often the whole work calls it.
int expectStopsAtEveryCall(const std::function<void(const Progress&)>& work) {
  constexpr int most = 3;
  for (int n = 0; n < most; ++n) {
    int calls = 0;
    EXPECT_THROW(work([&](double) { return calls++ < n; }), Cancelled) << n;
    EXPECT_EQ(calls, n + 1) << "it goes on after it was stopped";
  }
  int calls = 0;
  work([&](double share) {
    EXPECT_TRUE(share >= 0 && share <= 1) << share;
    return ++calls > 0;
  });
  return calls;
}

TEST(Progress, StopsLongWorkOnPlanarCurves) {
  const PlanarPoints points = wave(40);
  const BezierSpline smooth = bezierSpline(clothoidSpline(points).pieces, 1e-4, false, 1e-9).curve;
  const ArcFit fit = fitArcs(smooth);
  EXPECT_GT(expectStopsAtEveryCall([&](const Progress& p) { fitArcs(smooth, {}, p); }),
            static_cast<int>(fit.arcs.size()) / 2);
  EXPECT_GT(expectStopsAtEveryCall([&](const Progress& p) { fitClothoids(smooth, {}, p); }), 10);
  expectStopsAtEveryCall([&](const Progress& p) { clothoidSpline(points, {}, p); });
  const Eigen::VectorXd tolerances = Eigen::VectorXd::Constant(points.rows(), 0.1);
  expectStopsAtEveryCall([&](const Progress& p) { fairPoints(points, tolerances, {}, p); });
  expectStopsAtEveryCall([&](const Progress& p) { g2ConicsNear({.arcs = fit.arcs}, 1, p); });
  expectStopsAtEveryCall([&](const Progress& p) {
    fairCurve({3, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}, HomogeneousPoles::Ones(6, 4)}, 0.1, {}, p);
  });
}

TEST(LocalOrigin, HasNoRounding) {
  std::mt19937_64 random(testSeed());
  for (const double far : {1e6, 1e9, -3e12}) {
    PlanarPoints points(20, 2);
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      points.row(i) << far + test::uniform(random, -9, 9), test::uniform(random, -9, 9);
    const Eigen::Vector2d origin = localOrigin(points);
    EXPECT_NE(origin.x(), 0);
    EXPECT_EQ(origin.y(), 0);
    const PlanarPoints local = points.rowwise() - origin.transpose();
    EXPECT_EQ(PlanarPoints(local.rowwise() + origin.transpose()), points);
    EXPECT_LE(local.cwiseAbs().maxCoeff(), 18.1);
  }
  EXPECT_TRUE(localOrigin(wave(20)).isZero(0));
}

TEST(FairnessOf, RoundedPointsOfACircleHaveNoExtremum) {
  PlanarPoints points(5000, 2);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double t = 3 * double(i) / double(points.rows());
    points.row(i) << std::round(1e6 * 10 * std::cos(t)) / 1e6,
        std::round(1e6 * 10 * std::sin(t)) / 1e6;
  }
  EXPECT_GT(fairnessOf(points).extrema.size(), 1000u);
  EXPECT_EQ(fairnessOf(points, false, 0.5e-6 * std::sqrt(2)).extrema.size(), 0u);
  EXPECT_THROW(fairnessOf(points, false, -1), std::invalid_argument);
}

TEST(FitArcs, RefusesAToleranceBelowTheRounding) {
  const BezierSpline spline = bezierSpline(biarcSpline(wave(20)).arcs, false, 1e-9);
  EXPECT_THROW(fitArcs(spline, {.tolerance_mm = 1e-14}), std::domain_error);
}

}  // namespace
}  // namespace seamwright
