// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <limits>
#include <seamwright/core/blend/spline_blend.hpp>

#include "blends.hpp"
#include "splines.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using test::CurveKind;
using test::Vec;
using Continuity = KeyInterpolation::Continuity;

SplineBlendOptions ofOrder(int order) {
  SplineBlendOptions options;
  options.joint.order = order;
  return options;
}

Eigen::VectorXd gentleBeta(int order, std::mt19937_64& random) {
  Eigen::VectorXd beta = test::randomBeta(order, random);
  beta.tail(order - 1) *= 0.3;
  return beta;
}

/// A spline of random curves about a circle, G^n at its joints. A closed one has the degree 2n + 1.
BezierSpline randomSpline(int order, int degree, int segments, bool closed,
                          std::mt19937_64& random) {
  const auto curve = [&](int i) {
    Poles poles(degree + 1, 3);
    for (int j = 0; j <= degree; ++j) {
      const double angle = 6.28 / segments * (i + static_cast<double>(j) / degree);
      poles.row(j) << std::cos(angle), std::sin(angle), 0;
      poles.row(j) = 4 * poles.row(j) + 0.1 * test::randomVector(random).transpose();
    }
    return BezierCurve(poles);
  };
  std::vector<BezierCurve> curves = {curve(0)};
  std::vector<double> knots = {0, 1};
  for (int i = 1; i < segments - (closed ? 1 : 0); ++i) {
    curves.push_back(joinedCurve(
        curves.back(), curve(i),
        CurveJoinRule{
            .beta = gentleBeta(order, random), .length = 1, .next_length = 1, .scale = {}},
        false));
    knots.push_back(knots.back() + test::logUniform(random, -0.3, 0.3));
  }
  if (closed) {
    curves.push_back(bridgeCurve(curves.back(), curves.front(), gentleBeta(order, random),
                                 gentleBeta(order, random)));
    knots.push_back(knots.back() + 1);
  }
  return bezierSpline(curves, knots, closed, 1e-9);
}

BezierSpline mapped(const BezierSpline& spline, const Eigen::Affine3d& map) {
  BezierSpline result = spline;
  for (Eigen::Index i = 0; i < result.poles.rows(); ++i)
    result.poles.row(i).head<3>() =
        (map * Vec(spline.poles.row(i).head<3>().transpose())).transpose();
  if (result.closed) result.poles.row(result.poles.rows() - 1) = result.poles.row(0);
  return result;
}

BezierSpline reversed(const BezierSpline& spline) {
  BezierSpline result = spline;
  result.poles = spline.poles.colwise().reverse();
  for (std::size_t i = 0; i < spline.knots.size(); ++i)
    result.knots[i] = -spline.knots[spline.knots.size() - 1 - i];
  return result;
}

double distance(const BezierSpline& x, const BezierSpline& y) {
  return (x.poles - y.poles).cwiseAbs().maxCoeff();
}

void expectJoints(const SplineFrame& frame, int order) {
  requireValid(frame.spline);
  const int segments = frame.spline.segments();
  ASSERT_EQ(frame.joints.size(), segments - (frame.spline.closed ? 0u : 1u));
  for (const SplineJoint& joint : frame.joints) {
    if (joint.remedy != BlendRemedy::Intrinsic) {
      EXPECT_EQ(joint.order, order);
    }
    const BezierCurve a = segment(frame.spline, joint.knot - 1),
                      b = segment(frame.spline, joint.knot % segments);
    const BetaFit fit = fitBeta(a, b, joint.order);
    const double bound = std::max(1e-11, test::defectOfRounding(a, b, joint.order));
    EXPECT_LT(test::largestOf(fit.defects), bound) << nameOf(joint.remedy);
    EXPECT_LT(test::largestOf(joint.defects), bound);
    ASSERT_EQ(fit.beta.size(), joint.order);
    for (int k = 0; k < joint.order; ++k)
      EXPECT_NEAR(fit.beta(k), joint.beta(k), std::max(1e-9, 1e4 * bound) * joint.beta.norm());
  }
}

TEST(SplineBlend, Identities1And2FramesAreGn) {
  std::mt19937_64 random(testSeed());
  int moved = 0, joints = 0;
  for (int i = 0; i < 36; ++i) {
    const int n = 1 + i % 3, segments = 2 + i % 4, count = 2 + i / 3 % 3;
    const bool closed = i % 2 == 1;
    const int degree = closed ? 2 * n + 1 : n + 1;
    std::vector<BezierSpline> keys;
    std::vector<double> omegas;
    for (int k = 0; k < count; ++k) {
      keys.push_back(randomSpline(n, degree, segments, closed, random));
      omegas.push_back(k == 0 ? 0 : omegas.back() + test::logUniform(random, -0.3, 0.3));
    }
    SplineBlendOptions options = ofOrder(n);
    options.continuity = static_cast<Continuity>(i / 2 % 3);
    const SplineBlend blend(keys, omegas, options);
    EXPECT_EQ(blend.degree(), segments == 2 && !closed ? std::max(degree, n + 1) : 2 * n + 1);
    SCOPED_TRACE(i);
    for (int k = 0; k < count; ++k) {
      const SplineFrame frame = blend.frameAt(omegas[k]);
      if (blend.degree() == degree) {
        EXPECT_EQ(frame.spline, keys[k]);
      }
      for (const SplineJoint& joint : frame.joints) EXPECT_EQ(joint.moved_mm, 0);
    }
    for (const double share : {0.07, 0.4, 0.81}) {
      const SplineFrame frame = blend.frameAt(share * omegas.back());
      expectJoints(frame, n);
      for (const SplineJoint& joint : frame.joints) {
        ++joints;
        moved += joint.remedy == BlendRemedy::SmallestMove;
      }
    }
  }
  EXPECT_LT(moved, joints / 2);
}

TEST(SplineBlend, Identity3ParametricallySmoothSplinesAreInterpolated) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 20; ++i) {
    const int n = 1 + i % 3;
    const std::vector<double> breaks = test::randomBreaks(4, 0.3, random);
    std::vector<BezierSpline> keys;
    for (int k = 0; k < 3; ++k) {
      BSplineCurve curve{2 * n + 1, test::flatKnots(2 * n + 1, breaks, n + 1), {}};
      curve.poles = test::randomPoles(curve.count(), false, random);
      // Longer steps, so that no tangents are nearly lost.
      curve.poles.col(0) += Eigen::VectorXd::LinSpaced(curve.count(), 0, 5.0 * curve.count());
      keys.push_back(bezierSpline(curve));
    }
    const SplineBlend blend(keys, {0, 1, 2}, ofOrder(n));
    for (const BlendRemedy remedy : blend.remedies()) EXPECT_EQ(remedy, BlendRemedy::Plain) << i;
    const SplineFrame frame = blend.frameAt(1.3);
    const HomogeneousPoles plain = 0.7 * keys[1].poles + 0.3 * keys[2].poles;
    EXPECT_LT((frame.spline.poles - plain).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_EQ(frame.spline.knots, keys[0].knots);
    expectJoints(frame, n);
    for (const SplineJoint& joint : frame.joints) EXPECT_EQ(joint.moved_mm, 0);
  }
}

TEST(SplineBlend, Identities4And5MotionsReversalAndOrder) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 20; ++i) {
    const int n = 1 + i % 2;
    const bool closed = i / 2 % 2 == 1;
    std::vector<BezierSpline> keys, moved, back, turned;
    for (int k = 0; k < 2; ++k) keys.push_back(randomSpline(n, 2 * n + 1, 4, closed, random));
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    map.rotate(Eigen::AngleAxisd(1.1, test::randomVector(random).normalized()));
    map.scale(test::logUniform(random, -2, 2));
    map.translate(test::randomVector(random));
    for (const BezierSpline& key : keys) {
      moved.push_back(mapped(key, map));
      turned.push_back(reversed(key));
    }
    back = {keys[1], keys[0]};
    const SplineFrame frame = SplineBlend(keys, {0, 1}, ofOrder(n)).frameAt(0.3);
    const SplineFrame other = SplineBlend(moved, {0, 1}, ofOrder(n)).frameAt(0.3);
    EXPECT_LT(distance(other.spline, mapped(frame.spline, map)), 1e-8 * map.linear().norm()) << i;
    const SplineFrame exchanged = SplineBlend(back, {0, 1}, ofOrder(n)).frameAt(0.7);
    EXPECT_LT(distance(exchanged.spline, frame.spline), 1e-8) << i;
    if (n > 1) continue;
    const SplineFrame reverse = SplineBlend(turned, {0, 1}, ofOrder(n)).frameAt(0.3);
    EXPECT_LT(distance(reverse.spline, reversed(frame.spline)), 1e-8) << i;
  }
}

TEST(SplineBlend, Identity6OneJointIsThatOfJointBlend) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 20; ++i) {
    const int n = 1 + i % 3;
    const BezierSpline first = randomSpline(n, 2 * n + 1, 2, false, random),
                       second = randomSpline(n, 2 * n + 1, 2, false, random);
    JointBlendOptions options;
    options.order = n;
    options.max_degree = 0;
    const BlendedJoint joint = blendJoint({segment(first, 0), segment(first, 1)},
                                          {segment(second, 0), segment(second, 1)}, 0.6, options);
    const SplineFrame frame = SplineBlend({first, second}, {0, 1}, ofOrder(n)).frameAt(0.6);
    EXPECT_EQ(frame.joints[0].remedy, joint.remedy);
    EXPECT_LT(test::farthest(segment(frame.spline, 0), joint.a), 1e-12);
    EXPECT_LT(test::farthest(segment(frame.spline, 1), joint.b), 1e-12);
  }
}

TEST(SplineBlend, CornersAreRefusedOrKept) {
  std::mt19937_64 random(testSeed());
  BezierSpline smooth = randomSpline(2, 5, 4, false, random);
  BezierSpline corner = smooth, bent = smooth;
  corner.poles.row(11).head<3>() += Eigen::RowVector3d(0, 0, 0.5);  // after knot 2
  bent.poles.row(17).head<3>() += Eigen::RowVector3d(0, 0, 0.1);    // second pole after knot 3
  test::expectRefused(
      [&] {
        SplineBlend({smooth, corner}, {0, 1});
      },
      "key frame 1, knot 2: the joint is not G1, defect");
  test::expectRefused(
      [&] {
        SplineBlend({bent, smooth}, {0, 1});
      },
      "key frame 0, knot 3: the joint is not G2, defect");
  SplineBlendOptions options;
  options.keep_lower_orders = true;
  const SplineBlend blend({smooth, corner, bent}, {0, 1, 2}, options);
  EXPECT_EQ(blend.orders(), (std::vector<int>{2, 0, 1}));
  const SplineFrame frame = blend.frameAt(0.5);
  EXPECT_EQ(frame.joints[1].order, 0);
  EXPECT_EQ(frame.joints[2].order, 1);
  EXPECT_LT(frame.joints[2].defects[1], 1e-12);
}

TEST(SplineBlend, SplinesAreRaisedForBalance) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 6; ++i) {
    const BezierSpline first = randomSpline(3, 7, 4, false, random),
                       second = randomSpline(3, 7, 4, false, random);
    SplineBlendOptions options = ofOrder(3);
    options.joint.most_departure = 0.15;
    const int least = SplineBlend({first, second}, {0, 1}, options).degree();
    options.joint.max_degree = 16;
    const SplineBlend raised({first, second}, {0, 1}, options);
    EXPECT_EQ(least, 7);
    EXPECT_LE(raised.degree(), 16);
    for (const BlendRemedy remedy : raised.remedies())
      EXPECT_TRUE(raised.degree() == 7 || remedy <= BlendRemedy::Balanced);
    expectJoints(raised.frameAt(0.5), 3);
  }
}

TEST(SplineBlend, RationalSplines) {
  std::mt19937_64 random(testSeed());
  const auto circle = [](double radius, double height) {
    // Four quadratic quarters.
    const double w = std::sqrt(0.5);
    BezierSpline result{2, {0, 1, 2, 3, 4}, HomogeneousPoles(9, 4), true};
    for (int i = 0; i < 9; ++i) {
      const double angle = std::acos(0.0) / 2 * (i % 8), size = i % 2 == 0 ? 1 : 1 / w;
      const double weight = i % 2 == 0 ? 1 : w;
      result.poles.row(i) << weight * size * radius * std::cos(angle),
          weight * size * radius * std::sin(angle), weight * height, weight;
    }
    return result;
  };
  const SplineBlend blend({circle(1, 0), circle(2, 3)}, {0, 1});
  const SplineFrame frame = blend.frameAt(0.5);
  expectJoints(frame, 2);
  // Equal weights: points are blended linearly, though homogeneous derivatives jump.
  for (const SplineJoint& joint : frame.joints) EXPECT_EQ(joint.remedy, BlendRemedy::Plain);
  for (int i = 0; i <= 40; ++i) {
    const CurveDerivatives x = derivatives(frame.spline, 0.1 * i, 0);
    EXPECT_NEAR(x.row(0).head<2>().norm(), 1.5, 1e-14);
    EXPECT_NEAR(x(0, 2), 1.5, 1e-14);
  }
  BezierSpline uneven = circle(1, 0);
  uneven.poles.row(7) *= 2;
  uneven.poles.row(8) *= 2;
  test::expectRefused(
      [&] {
        SplineBlend({uneven, uneven}, {0, 1});
      },
      "key frame 0 is closed, and its first and last weights are 1 and 2");
}

TEST(SplineBlend, BadInputIsRefused) {
  std::mt19937_64 random(testSeed());
  const BezierSpline good = randomSpline(2, 5, 3, false, random);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  test::expectRefused([&] { SplineBlend({good}, {0}); }, "omegas 1");
  test::expectRefused([&] { SplineBlend({good}, {0, 1}); }, "key frames 1, omegas 2");
  test::expectRefused([&] { SplineBlend({good, good}, {0, nan}); }, "omega 1 is nan");
  test::expectRefused(
      [&] {
        SplineBlend({good, randomSpline(2, 5, 4, false, random)}, {0, 1});
      },
      "key frame 1 has segments 4, the first 3");
  test::expectRefused(
      [&] {
        SplineBlend({good, randomSpline(2, 6, 3, false, random)}, {0, 1});
      },
      "key frame 1 has degree 6, the first 5");
  test::expectRefused(
      [&] {
        SplineBlend({good, randomSpline(2, 5, 3, true, random)}, {0, 1});
      },
      "key frame 1 is closed, the first is not");
  BezierSpline bad = good;
  bad.poles(4, 1) = nan;
  test::expectRefused([&] { SplineBlend({good, bad}, {0, 1}); }, "pole 4 is not finite");
  test::expectRefused([&] { SplineBlend({good, good}, {0, 1}).frameAt(2); }, "omega is 2");
}

}  // namespace
}  // namespace seamwright
