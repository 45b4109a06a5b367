// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <limits>
#include <seamwright/core/bezier/frenet.hpp>
#include <seamwright/core/bspline/curve.hpp>
#include <seamwright/core/seam/curve_joint.hpp>

#include "exact_frenet.hpp"
#include "support/random.hpp"
#include "surfaces.hpp"

namespace seamwright {
namespace {

/// Weights 2^-spread to 2^spread.
BezierCurve unevenCurve(int degree, double spread, std::mt19937_64& random) {
  std::uniform_real_distribution<double> exponent(-spread, spread);
  Poles poles(degree + 1, 3);
  Eigen::VectorXd weights(degree + 1);
  for (int i = 0; i <= degree; ++i) {
    poles.row(i) = test::randomVector(random).transpose();
    weights(i) = std::exp2(exponent(random));
  }
  return {poles, weights};
}

/// What the bounds promise, and what they are worth: the widest of them over its figure.
struct Worth {
  double kappa = 0, tau = 0, kappa_s = 0;
};

void expectWithin(long double exact, const std::optional<double>& value,
                  const std::optional<double>& error, const char* what) {
  ASSERT_TRUE(value && error) << what;
  EXPECT_LE(std::abs(*value - exact), *error)
      << what << " is " << *value << ", exactly " << static_cast<double>(exact);
}

Worth expectExact(const BezierCurve& curve, double t) {
  const FrenetFrame frame = frenetFrame(curve, t);
  EXPECT_EQ(frame.kind, CurvePoint::Regular);
  const test::ExactFigures f = test::exactFigures(curve, t);
  EXPECT_LE(std::abs(frame.speed - f.speed), frame.speed_error);
  expectWithin(f.kappa, frame.curvature_per_mm, frame.curvature_error_per_mm, "curvature");
  expectWithin(f.tau, frame.torsion_per_mm, frame.torsion_error_per_mm, "torsion");
  expectWithin(f.kappa_s, frame.curvature_change_per_mm2, frame.curvature_change_error_per_mm2,
               "change of curvature");
  const auto share = [](const std::optional<double>& error, long double figure) {
    return error.value_or(1e300) / static_cast<double>(std::abs(figure));
  };
  return {share(frame.curvature_error_per_mm, f.kappa), share(frame.torsion_error_per_mm, f.tau),
          share(frame.curvature_change_error_per_mm2, f.kappa_s)};
}

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

// Curvature 1.18e-9 and torsion 0.00221 at the end, to 40 digits in the data they are from.
TEST(FrenetExact, SevenOrdersOfMagnitudeOfWeight) {
  HomogeneousPoles poles(4, 4);
  poles << 0.015625, 0.828125, 0.453125, 1, 0.0118408203125, -0.00579833984375, -0.00494384765625,
      0.00390625, 406, 61, -18, 64, 0.0697021484375, -0.0103759765625, 0.0155029296875, 0.0078125;
  const BezierCurve curve = BezierCurve::fromHomogeneous(poles);
  const FrenetFrame end = frenetFrame(curve, 1);
  EXPECT_NEAR(*end.torsion_per_mm, 0.002210790547637762394, 1e-17);
  EXPECT_NEAR(*end.curvature_per_mm, 1.180200257723693100558e-9, 1e-23);
  EXPECT_NEAR(*end.curvature_change_per_mm2, -8.62085063599967789724733842558e-10, 1e-23);
  for (const double t : {0.0, 0x1p-40, 0.1, 0.5, 0.75, 0.999, 1.0}) {
    SCOPED_TRACE(t);
    const Worth worth = expectExact(curve, t);
    EXPECT_LE(worth.kappa, 1e-12);
    EXPECT_LE(worth.tau, 1e-12);
  }
}

TEST(FrenetExact, RandomCurvesOfUnevenWeights) {
  std::mt19937_64 random(testSeed());
  std::uniform_real_distribution<double> inside(0, 1);
  for (const double spread : {0.0, 4.0, 6.0, 12.0, 40.0})
    for (const int degree : {3, 4, 7}) {
      SCOPED_TRACE(std::to_string(spread) + ", degree " + std::to_string(degree));
      std::vector<double> kappa, tau, kappa_s;
      for (int i = 0; i < 60; ++i) {
        const double t = i % 10 == 0 ? i % 20 == 0 : inside(random);
        const Worth worth = expectExact(unevenCurve(degree, spread, random), t);
        kappa.push_back(worth.kappa);
        tau.push_back(worth.tau);
        kappa_s.push_back(worth.kappa_s);
      }
      EXPECT_LE(median(kappa), 4e-12);
      EXPECT_LE(median(tau), 4e-12);
      EXPECT_LE(median(kappa_s), 4e-12);
      EXPECT_LE(std::ranges::max(kappa), 1e-9);
      EXPECT_LE(std::ranges::max(tau), 1e-9);
    }
}

TEST(FrenetExact, FarFromTheOriginAndNearTheEnds) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 60; ++i) {
    const BezierCurve near = unevenCurve(3 + i % 3, 8, random);
    const Eigen::RowVector3d shift = 1e6 * test::randomVector(random).transpose();
    const BezierCurve far(near.poles().rowwise() + shift, near.weights());
    for (const double t : {0x1p-1000, 0x1p-300, 0x1p-30, 0.3, 1 - 0x1p-50}) {
      SCOPED_TRACE(t);
      EXPECT_LE(expectExact(far, t).tau, 1e-6);
    }
  }
}

TEST(FrenetExact, BeyondTheEndsAndPlanarCurves) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 60; ++i) {
    const BezierCurve curve = unevenCurve(3 + i % 3, i % 2, random);
    for (const double t : {-0.25, -0x1p-30, 1.125}) {
      SCOPED_TRACE(t);
      expectExact(curve, t);
    }
    const FrenetFrame conic = frenetFrame(unevenCurve(2, 20, random), 0.3);
    EXPECT_EQ(*conic.torsion_per_mm, 0);
  }
}

/// Where a third derivative vanishes, as at the ends of a conic, it has no size to compare others
/// with.
TEST(FrenetExact, ConicsAtTheirEnds) {
  Eigen::MatrixX3d poles(3, 3);
  poles << 0, 0, 0, 1, 0, 0, 1, 1, 0;
  for (const auto& [t, change] : {std::pair{0.0, 0.75}, {1e-300, 0.75}, {1.0, -0.75}}) {
    // kappa = (1 - 2 t + 2 t^2)^-1.5 / 2, |X'| = 2 (1 - 2 t + 2 t^2)^0.5
    const FrenetFrame parabola = frenetFrame(BezierCurve(poles), t);
    ASSERT_TRUE(parabola.curvature_change_per_mm2);
    EXPECT_NEAR(*parabola.curvature_change_per_mm2, change,
                *parabola.curvature_change_error_per_mm2);
    EXPECT_LT(*parabola.curvature_change_error_per_mm2, 1e-13);
  }
  std::mt19937_64 random(testSeed());
  for (const double spread : {0.0, 4.0, 20.0})
    for (const double t : {0.0, 0x1p-1000, 0x1p-30, 0.5, 1.0}) {
      SCOPED_TRACE(std::to_string(spread) + ", t = " + std::to_string(t));
      expectExact(unevenCurve(2, spread, random), t);
    }
}

/// With B_k = w A_k - w_k A: w^3 X'' = w B_2 - 2 w_1 B_1, w^4 X''' = w^2 B_3 - 3 w_1 w^3 X'' - 3
/// w_2 w B_1.
TEST(FrenetExact, DerivativesAreExactToTheirSize) {
  std::mt19937_64 random(testSeed());
  for (const double spread : {0.0, 6.0, 12.0})
    for (int i = 0; i < 40; ++i) {
      SCOPED_TRACE(std::to_string(spread) + ", " + std::to_string(i));
      const BezierCurve curve = unevenCurve(3 + i % 3, spread, random);
      const double t = 0.0234375 * i;
      std::array<test::DyadicRow, 4> h;
      for (int k = 0; k < 4; ++k) h[k] = test::exactDerivative(curve.homogeneousPoles(), t, k);
      const test::Dyadic w = h[0][3];
      const auto about = [&](int k) {
        return test::combined(w, test::spaceOf(h[k]), h[k][3], test::spaceOf(h[0]));
      };
      const test::DyadicSpace second = test::combined(w, about(2), 2 * h[1][3], about(1));
      const test::DyadicSpace third = test::combined(
          1, test::combined(w * w, about(3), 3 * h[1][3], second), 3 * h[2][3] * w, about(1));
      const test::DyadicSpace* const exact[] = {nullptr, nullptr, &second, &third};
      const CurveDerivatives bezier = curve.derivatives(t, 3),
                             spline = derivatives(splineCurve(curve), t, 3);
      for (int k = 2; k < 4; ++k) {
        Eigen::Vector3d x;
        for (int c = 0; c < 3; ++c)
          x(c) = static_cast<double>((*exact[k])[c].approximate() /
                                     std::pow(w.approximate(), k + 1.0L));
        EXPECT_LE((bezier.row(k).transpose() - x).norm(), 1e-11 * x.norm()) << k;
        EXPECT_LE((spline.row(k).transpose() - x).norm(), 1e-11 * x.norm()) << k;
      }
    }
}

/// c_2 = kappa N, c_3 = -kappa^2 T + kappa_s N + kappa tau B; halves of one curve meet in all
/// orders.
TEST(FrenetExact, JointsOfUnevenCurvesToAnyOrder) {
  std::mt19937_64 random(testSeed());
  for (const double spread : {0.0, 6.0, 12.0, 30.0})
    for (int i = 0; i < 40; ++i) {
      SCOPED_TRACE(std::to_string(spread) + ", " + std::to_string(i));
      const BezierCurve curve = unevenCurve(3 + i % 3, spread, random);
      const CurveJoint turned = measureJoint(curve, curve.reversed(), 3);
      const auto end = test::exactFigures(curve, 1),
                 start = test::exactFigures(curve.reversed(), 0);
      EXPECT_NEAR(static_cast<double>(turned.sizes[2] / end.kappa), 1, 1e-11);
      EXPECT_NEAR(static_cast<double>(start.kappa / end.kappa), 1, 1e-15);
      const long double c3 = std::hypot(end.kappa * end.kappa, end.kappa_s, end.kappa * end.tau);
      EXPECT_NEAR(static_cast<double>(turned.sizes[3] / c3), 1, 1e-10);
      if (spread > 12) continue;  // the poles of halves are rounded
      const auto [before, after] = curve.split(0.375);
      const CurveJoint smooth = measureJoint(before, after, 6);
      for (int k = 2; k <= 6; ++k) EXPECT_LE(relativeDifference(smooth, k, 1e300), 1e-6) << k;
    }
}

// Poles on a line but for the rounding of their coordinates: what is seen of curvature is not told
// from none.
TEST(FrenetExact, WhatRoundingHidesIsNotRegular) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    BezierCurve curve = unevenCurve(4, 10, random);
    const Eigen::RowVector3d along = test::randomVector(random).transpose().normalized();
    Poles poles = curve.poles();
    for (Eigen::Index k = 0; k < poles.rows(); ++k)
      poles.row(k) = 3 * static_cast<double>(k) * along;
    curve = BezierCurve(poles, curve.weights());
    const FrenetFrame frame = frenetFrame(curve, 0.01 + 0.0049 * i);
    const test::ExactFigures f = test::exactFigures(curve, 0.01 + 0.0049 * i);
    EXPECT_LE(f.kappa, *frame.curvature_per_mm + *frame.curvature_error_per_mm);
    EXPECT_LE(*frame.curvature_error_per_mm, 1e-9 * (1 + f.kappa * 1e9));
    if (frame.kind == CurvePoint::Regular) {
      EXPECT_GT(*frame.curvature_per_mm, *frame.curvature_error_per_mm);
    }
  }
}

}  // namespace
}  // namespace seamwright
