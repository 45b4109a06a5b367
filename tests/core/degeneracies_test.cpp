// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <random>
#include <seamwright/core/bezier/frenet.hpp>

#include "support/random.hpp"
#include "surfaces.hpp"

namespace seamwright {
namespace {

using test::Vec;

constexpr int cases = 1500;

/// Coefficients by powers of t.
using Powers = Eigen::VectorXd;

Powers product(const Powers& a, const Powers& b) {
  Powers c = Powers::Zero(a.size() + b.size() - 1);
  for (Eigen::Index i = 0; i < a.size(); ++i) c.segment(i, b.size()) += a(i) * b;
  return c;
}

Powers withRoots(const std::vector<double>& roots) {
  Powers p = Powers::Ones(1);
  for (const double root : roots) p = product(p, Eigen::Vector2d(-root, 1));
  return p;
}

Powers integral(const Powers& p) {
  Powers result = Powers::Zero(p.size() + 1);
  for (Eigen::Index i = 0; i < p.size(); ++i) result(i + 1) = p(i) / static_cast<double>(i + 1);
  return result;
}

/// b_j = sum_i C(j, i) / C(n, i) p_i.
Eigen::VectorXd bernstein(const Powers& p, int n) {
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n + 1);
  for (int j = 0; j <= n; ++j) {
    double ratio = 1;
    for (int i = 0; i <= std::min<int>(j, static_cast<int>(p.size()) - 1); ++i) {
      b(j) += ratio * p(i);
      ratio *= static_cast<double>(j - i) / (n - i);
    }
  }
  return b;
}

BezierCurve curveOf(const std::array<Powers, 3>& x) {
  const auto n = static_cast<int>(std::max({x[0].size(), x[1].size(), x[2].size()})) - 1;
  Poles poles(n + 1, 3);
  for (int k = 0; k < 3; ++k) poles.col(k) = bernstein(x[k], n);
  return BezierCurve(poles);
}

/// Inflections survive a projective map.
BezierCurve projected(const BezierCurve& curve, std::mt19937_64& random) {
  Eigen::Matrix4d map = Eigen::Matrix4d::Identity();
  map.topLeftCorner<3, 3>() = test::randomRotation(random) * test::logUniform(random, -3, 3);
  const double reach = curve.poles().rowwise().norm().maxCoeff();
  map.bottomLeftCorner<1, 3>() =
      0.3 / reach * test::randomVector(random).cwiseMax(-1).cwiseMin(1).transpose();
  return BezierCurve::fromHomogeneous(curve.homogeneousPoles() * map.transpose());
}

BezierCurve moved(const BezierCurve& curve, std::mt19937_64& random) {
  const Eigen::Matrix3d turn = test::randomRotation(random) * test::logUniform(random, -3, 3);
  const Poles poles = curve.poles() * turn.transpose();
  return {poles, curve.weights()};
}

/// So many roots in [0.05, 0.95], at least 0.1 apart.
std::vector<double> randomRoots(int count, std::mt19937_64& random) {
  std::vector<double> roots;
  std::uniform_real_distribution<double> uniform(0.05, 0.95);
  while (static_cast<int>(roots.size()) < count) {
    const double root = uniform(random);
    if (std::none_of(roots.begin(), roots.end(),
                     [&](double other) { return std::abs(root - other) < 0.1; }))
      roots.push_back(root);
  }
  std::sort(roots.begin(), roots.end());
  return roots;
}

void expectIntervals(const CurveDegeneracies& found, const std::vector<double>& roots,
                     CurvePoint kind, double width) {
  ASSERT_EQ(found.intervals.size(), roots.size());
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const auto& [found_kind, first, last] = found.intervals[i];
    EXPECT_EQ(found_kind, kind);
    EXPECT_LE(first, roots[i] + 1e-12);
    EXPECT_GE(last, roots[i] - 1e-12);
    EXPECT_LE(last - first, width);
  }
}

// The graph y = f(x) bends where f'' is not zero. Its roots are given, and no projective map moves
// them.
TEST(Degeneracies, InflectionsAreWhereTheyWerePut) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const std::vector<double> roots = randomRoots(i % 4, random);
    const BezierCurve graph =
        curveOf({Eigen::Vector2d(0, 1), integral(integral(withRoots(roots))), Powers::Zero(1)});
    const BezierCurve curve = i % 2 ? projected(graph, random) : moved(graph, random);
    const CurveDegeneracies found = findDegeneracies(curve);
    SCOPED_TRACE(i);
    expectIntervals(found, roots, CurvePoint::Inflection, 1e-8);
    EXPECT_FALSE(found.straight);
    EXPECT_GT(found.speed_lower, 0);
  }
}

// X' = (t - r) V with V without zeros.
TEST(Degeneracies, CuspsAreWhereTheyWerePut) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const std::vector<double> roots = randomRoots(1 + i % 2, random);
    std::array<Powers, 3> x;
    for (int k = 0; k < 3; ++k) {
      Powers v = 0.3 * test::randomVector(random);
      if (k == 0) v = Eigen::Vector3d(2, 0.2 * v(0), 0.2 * v(1));  // positive on [0, 1]
      x[k] = integral(product(withRoots(roots), v));
    }
    const BezierCurve polynomial = curveOf(x);
    const BezierCurve curve = i % 3 == 0 ? projected(polynomial, random) : polynomial;
    const CurveDegeneracies found = findDegeneracies(curve);
    SCOPED_TRACE(i);
    // X' x X'' has a double zero at a cusp: rounding hides it in a wider interval.
    std::vector<double> cusps;
    for (const auto& interval : found.intervals)
      if (interval.kind == CurvePoint::Cusp)
        cusps.push_back(0.5 * (interval.first + interval.last));
    ASSERT_EQ(cusps.size(), roots.size());
    for (std::size_t k = 0; k < roots.size(); ++k) EXPECT_NEAR(cusps[k], roots[k], 1e-5);
    EXPECT_EQ(found.speed_lower, 0);
  }
}

TEST(Degeneracies, ASmallMoveEndsACusp) {
  Poles poles(4, 3);
  poles << 0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0;
  const CurveDegeneracies cusp = findDegeneracies(BezierCurve(poles));
  expectIntervals(cusp, {0.5}, CurvePoint::Cusp, 1e-6);
  poles(1, 2) = 1e-6;
  const CurveDegeneracies none = findDegeneracies(BezierCurve(poles));
  EXPECT_TRUE(none.intervals.empty());
  // X'(1/2) is 3/4 1e-6 e_z; the smallest speed lies nearby.
  EXPECT_LE(none.speed_lower, 0.75e-6);
  EXPECT_GE(none.speed_lower, 0.2e-6);
  poles(1, 2) = 0;
  poles(1, 0) = 1 + 1e-6;  // in the plane a loop or two inflections come of it
  const CurveDegeneracies opened = findDegeneracies(BezierCurve(poles));
  EXPECT_TRUE(std::none_of(opened.intervals.begin(), opened.intervals.end(),
                           [](const auto& interval) { return interval.kind == CurvePoint::Cusp; }));
}

/// The smallest speed on a grid that is made finer about its smallest three times.
double slowestOf(const BezierCurve& curve) {
  double slowest = std::numeric_limits<double>::infinity(), at = 0.5, reach = 0.5;
  for (int level = 0; level < 4; ++level, reach *= 0.02) {
    const double first = std::max(0.0, at - reach), last = std::min(1.0, at + reach);
    for (int k = 0; k <= 200; ++k) {
      const double t = first + (last - first) * k / 200,
                   speed = curve.derivatives(t, 1).row(1).norm();
      if (speed < slowest) slowest = speed, at = t;
    }
  }
  return slowest;
}

// Nothing on a fine grid contradicts what is said, and bounds of the speed are not far off.
TEST(Degeneracies, GridSeesNothingElse) {
  std::mt19937_64 random(testSeed());
  constexpr int steps = 200;
  for (int i = 0; i < cases; ++i) {
    const int degree = 1 + i % 9;
    Poles poles(degree + 1, 3);
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(degree + 1);
    const bool planar = i % 2 == 0;
    for (int k = 0; k <= degree; ++k) {
      poles.row(k) = test::randomVector(random).transpose();
      if (planar) poles(k, 2) = 0;
      if (i % 3 == 0) weights(k) = test::logUniform(random, -0.5, 0.5);
    }
    const BezierCurve curve(poles, weights);
    const CurveDegeneracies found = findDegeneracies(curve);
    const double slowest = slowestOf(curve);
    double turn_before = 0;
    for (int k = 0; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      const CurveDerivatives x = curve.derivatives(t, 2);
      if (!planar || degree == 1) continue;
      const double turn = x(1, 0) * x(2, 1) - x(1, 1) * x(2, 0);
      if (turn * turn_before <
          0) {  // a planar curve changes the side it turns to: there is an inflection
        const bool seen =
            std::any_of(found.intervals.begin(), found.intervals.end(), [&](const auto& interval) {
              return interval.last >= t - 1.0 / steps && interval.first <= t;
            });
        EXPECT_TRUE(seen) << i << " " << t;
      }
      turn_before = turn;
    }
    EXPECT_LE(found.speed_lower, slowest * (1 + 1e-12)) << i;
    EXPECT_GE(found.speed_lower, 0.45 * slowest) << i;
    EXPECT_TRUE(planar || degree < 3 || found.intervals.empty()) << i;
  }
}

TEST(Degeneracies, RunBackwardsTheyAreMirrored) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const BezierCurve curve =
        projected(curveOf({Eigen::Vector2d(0, 1),
                           integral(integral(withRoots(randomRoots(3, random)))), Powers::Zero(1)}),
                  random);
    const CurveDegeneracies there = findDegeneracies(curve),
                            back = findDegeneracies(curve.reversed());
    ASSERT_EQ(there.intervals.size(), back.intervals.size());
    for (std::size_t k = 0; k < there.intervals.size(); ++k) {
      EXPECT_NEAR(there.intervals[k].first, 1 - back.intervals[2 - k].last, 1e-8);
      EXPECT_NEAR(there.intervals[k].last, 1 - back.intervals[2 - k].first, 1e-8);
    }
    EXPECT_NEAR(there.speed_lower / back.speed_lower, 1, 0.6);
  }
}

TEST(Degeneracies, AStraightCurveThatTurnsBackHasACusp) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const Vec p = 100 * test::randomVector(random), q = test::randomVector(random);
    // x' = 3 (t - 1/4) on a line that no doubles lie on exactly
    const Eigen::Vector3d x(0, -0.375, 0.75);
    Poles poles(3, 3);
    for (int k = 0; k < 3; ++k) poles.row(k) = (p + x(k) * q).transpose();
    const CurveDegeneracies turning = findDegeneracies(BezierCurve(poles));
    EXPECT_TRUE(turning.straight);
    ASSERT_EQ(turning.intervals.size(), 3u);
    EXPECT_EQ(turning.intervals[0].kind, CurvePoint::Inflection);
    EXPECT_EQ(turning.intervals[1].kind, CurvePoint::Cusp);
    EXPECT_EQ(turning.intervals[2].kind, CurvePoint::Inflection);
    EXPECT_EQ(turning.intervals[0].first, 0);
    EXPECT_EQ(turning.intervals[0].last, turning.intervals[1].first);
    EXPECT_NEAR(turning.intervals[1].first, 0.25, 1e-10 * (1 + p.norm() / q.norm()));
    EXPECT_LT(turning.intervals[1].last - turning.intervals[1].first, 1e-8);
    EXPECT_EQ(turning.intervals[2].last, 1);
    poles.row(1) += 1e-6 * q.norm() * q.unitOrthogonal().transpose();
    EXPECT_FALSE(findDegeneracies(BezierCurve(poles)).straight);
  }
  Poles line(2, 3);
  line << 0, 0, 0, 3, 4, 0;
  const CurveDegeneracies found = findDegeneracies(BezierCurve(line));
  EXPECT_TRUE(found.straight);
  ASSERT_EQ(found.intervals.size(), 1u);
  EXPECT_EQ(found.intervals[0].kind, CurvePoint::Inflection);
  EXPECT_NEAR(found.speed_lower, 5, 1e-13);
  EXPECT_LE(found.speed_lower, 5);
}

// Whole multiples of a vector, rounded, are on a line to their rounding; bent by 60 units of it
// they are not.
TEST(Degeneracies, StraightToRoundingAndNoFurther) {
  std::mt19937_64 random(testSeed());
  std::uniform_int_distribution<int> whole(-9, 9);
  const double eps = std::numeric_limits<double>::epsilon();
  for (int i = 0; i < 8000; ++i) {
    Vec v = test::randomVector(random);
    if (i % 4 == 0) v.setConstant(v(0));
    if (i == 0) v.setConstant(0.6435995193012394);
    if (i == 1) v = Vec(1.7628493908712926, 1.7628493908712926, 1.2339945736099047);
    Poles poles(4, 3);
    const double x[] = {0, 3, -2, 1};
    for (int k = 0; k < 4; ++k) poles.row(k) = ((i < 4000 ? x[k] : whole(random)) * v).transpose();
    const double size = poles.rowwise().norm().maxCoeff();
    if (size == 0) continue;
    const CurveDegeneracies found = findDegeneracies(BezierCurve(poles));
    ASSERT_TRUE(found.straight) << i;
    if (i < 4000 && i % 40 < 2) {
      ASSERT_EQ(found.intervals.size(), 5u) << i;
      for (const int k : {1, 3}) {
        EXPECT_EQ(found.intervals[k].kind, CurvePoint::Cusp);
        EXPECT_NEAR(found.intervals[k].first, k == 1 ? 0.25 : 0.75, 1e-8);
        EXPECT_LT(found.intervals[k].last - found.intervals[k].first, 1e-8);
      }
    }
    if (i >= 4000) continue;
    poles.row(2) += 60 * eps * size * v.unitOrthogonal().transpose();
    EXPECT_FALSE(findDegeneracies(BezierCurve(poles)).straight) << i;
  }
}

// x' = 27 K (t - 3/8)^2, y' = t - 3/8 up to a factor: halving comes to 3/8 with the rounding of x',
// not 0, on the side of the velocity on either side of it.
TEST(Degeneracies, RoundingDoesNotHideACusp) {
  std::mt19937_64 random(testSeed());
  std::uniform_int_distribution<long> whole(1L << 46, 1L << 47);
  for (int i = 0; i < 500; ++i) {
    const auto K = static_cast<double>(2 * whole(random) + 1);
    Poles poles = Poles::Zero(4, 3);
    const double x[] = {9, -15, 25}, y[] = {-3, 1, 5};
    for (int k = 0; k < 3; ++k)
      poles.row(k + 1) = poles.row(k) + Eigen::RowVector3d(K * x[k], std::exp2(46) * y[k], 0);
    const CurveDegeneracies found = findDegeneracies(BezierCurve(poles));
    EXPECT_TRUE(std::any_of(found.intervals.begin(), found.intervals.end(),
                            [](const auto& interval) {
                              return interval.kind == CurvePoint::Cusp && interval.first <= 0.375 &&
                                     0.375 <= interval.last;
                            }))
        << i;
    EXPECT_EQ(found.speed_lower, 0) << i;
  }
}

TEST(Degeneracies, PointsAndEnds) {
  const CurveDegeneracies point = findDegeneracies(BezierCurve(Poles::Constant(4, 3, 0.1)));
  ASSERT_EQ(point.intervals.size(), 1u);
  EXPECT_EQ(point.intervals[0].kind, CurvePoint::Point);
  EXPECT_EQ(point.intervals[0].last, 1);
  EXPECT_EQ(findDegeneracies(BezierCurve(Poles::Constant(1, 3, 2))).intervals.size(), 1u);
  Poles ends(5, 3);
  ends << 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4, 4, 4;
  const CurveDegeneracies found = findDegeneracies(BezierCurve(ends));
  ASSERT_GE(found.intervals.size(), 2u);
  EXPECT_EQ(found.intervals.front().kind, CurvePoint::Cusp);
  EXPECT_EQ(found.intervals.front().first, 0);
  EXPECT_EQ(found.intervals.back().kind, CurvePoint::Cusp);
  EXPECT_EQ(found.intervals.back().last, 1);
  // A triple pole: the speed vanishes twice, the curvature form five times. Still few places.
  Poles flat(6, 3);
  flat << 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 4, 1, 4, 5, 7;
  const CurveDegeneracies wide = findDegeneracies(BezierCurve(flat), 1e-12);
  ASSERT_GE(wide.intervals.size(), 1u);
  EXPECT_EQ(wide.intervals.front().kind, CurvePoint::Cusp);
  EXPECT_LT(wide.intervals.front().last, 1e-2);
}

TEST(Degeneracies, ConicsHaveNone) {
  Poles poles(3, 3);
  poles << 1, 0, 0, 1, 1, 0, 0, 1, 0;
  for (const double weight : {1e-3, std::sqrt(0.5), 1.0, 1e3}) {
    const CurveDegeneracies found =
        findDegeneracies(BezierCurve(poles, Eigen::Vector3d(1, weight, 1)));
    EXPECT_TRUE(found.intervals.empty()) << weight;
    EXPECT_GT(found.speed_lower, 0);
  }
}

TEST(Degeneracies, SizeDoesNotMatter) {
  for (const double size : {1e-150, 1e-20, 1.0, 1e20, 1e150}) {
    Poles poles(4, 3);
    poles << 0, 0, 0, 1, 2, 0, 2, -2, 0, 3, 0, 0;
    poles *= size;
    const CurveDegeneracies found = findDegeneracies(BezierCurve(poles));
    expectIntervals(found, {0.5}, CurvePoint::Inflection, 1e-8);
    EXPECT_GT(found.speed_lower / size, 0.1) << size;
  }
}

TEST(Degeneracies, ResolutionIsChecked) {
  const BezierCurve curve(Poles::Random(4, 3));
  for (const double bad : {0.0, -1.0, 1e-13, 1.5, std::nan("")})
    EXPECT_THROW(findDegeneracies(curve, bad), std::invalid_argument) << bad;
}

}  // namespace
}  // namespace seamwright
