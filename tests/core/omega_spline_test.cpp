// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <numbers>
#include <seamwright/core/blend/omega_spline.hpp>

#include "frames.hpp"

namespace seamwright {
namespace {

using loft::OmegaData;
using loft::OmegaSpline;
using loft::omegaSpline;
using loft::Row;
using test::drawn;

/// Value and derivatives of order 1 and 2 of column 0 at the beginning or the end of a piece.
Eigen::Vector3d pieceEnd(const OmegaSpline& spline, int i, bool at_end) {
  const double h = spline.breaks[i + 1] - spline.breaks[i];
  const Eigen::Vector4d c = spline.rows.col(0).segment<4>(3L * i);
  if (at_end) return {c(3), 3 * (c(3) - c(2)) / h, 6 * (c(3) - 2 * c(2) + c(1)) / (h * h)};
  return {c(0), 3 * (c(1) - c(0)) / h, 6 * (c(2) - 2 * c(1) + c(0)) / (h * h)};
}

OmegaData sampled(int count, const std::function<double(double)>& f, std::mt19937_64& random) {
  OmegaData data;
  double omega = drawn(-1, 1, random);
  data.values.resize(count, 1);
  for (int i = 0; i < count; ++i) {
    data.omegas.push_back(omega);
    data.values(i, 0) = f(omega);
    omega += drawn(0.1, 1, random);
  }
  return data;
}

void expectSmooth(const OmegaSpline& spline, double size, int run) {
  for (int i = 0; i + 2 < static_cast<int>(spline.breaks.size()); ++i)
    EXPECT_LE((pieceEnd(spline, i, true) - pieceEnd(spline, i + 1, false)).norm(), 1e-10 * size)
        << run << " " << i;
}

TEST(OmegaSpline, Identity1CubicsAreReproduced) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 60; ++run) {
    const int count = 2 + run % 6, ends = run % 4;
    const Eigen::Vector4d c(drawn(-1, 1, random), drawn(-1, 1, random), drawn(-1, 1, random),
                            drawn(-1, 1, random));
    const auto f = [&](double x) { return c(0) + x * (c(1) + x * (c(2) + x * c(3))); };
    const auto f1 = [&](double x) { return c(1) + x * (2 * c(2) + 3 * x * c(3)); };
    const auto f2 = [&](double x) { return 2 * c(2) + 6 * x * c(3); };
    OmegaData data = sampled(count, f, random);
    const double a = data.omegas.front(), b = data.omegas.back();
    // Free ends need four values, and each derivative replaces one.
    if (ends >= 1) data.start.first = Row::Constant(1, f1(a));
    if (ends >= 2) data.end.first = Row::Constant(1, f1(b));
    if (ends == 3) {
      data.start.second = Row::Constant(1, f2(a));
      data.end.second = Row::Constant(1, f2(b));
    }
    const OmegaSpline spline = omegaSpline(data);
    EXPECT_EQ(spline.breaks.size(), data.omegas.size() + (ends == 3 ? 2 : 0)) << run;
    expectSmooth(spline, 100, run);
    for (std::size_t i = 0, k = 0; i < spline.breaks.size(); ++i)
      if (k < data.omegas.size() && spline.breaks[i] == data.omegas[k]) {
        EXPECT_EQ(spline.rows(3 * static_cast<Eigen::Index>(i), 0),
                  data.values(static_cast<Eigen::Index>(k), 0));
        ++k;
      }
    if (count + std::min(ends, 2) < 4) continue;
    for (int i = 0; i + 1 < static_cast<int>(spline.breaks.size()); ++i) {
      const double x = spline.breaks[i];
      EXPECT_LE((pieceEnd(spline, i, false) - Eigen::Vector3d(f(x), f1(x), f2(x))).norm(), 1e-9)
          << run << " " << i;
    }
  }
}

TEST(OmegaSpline, TwoValuesMakeALineAndThreeAParabola) {
  std::mt19937_64 random(testSeed());
  const OmegaSpline line = omegaSpline(sampled(
      2, [](double x) { return 3 - 2 * x; }, random));
  EXPECT_NEAR(pieceEnd(line, 0, false)(1), -2, 1e-13);
  EXPECT_NEAR(pieceEnd(line, 0, false)(2), 0, 1e-12);
  const OmegaSpline parabola = omegaSpline(sampled(
      3, [](double x) { return x * x; }, random));
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(pieceEnd(parabola, i, true)(2), 2, 1e-11);
}

TEST(OmegaSpline, ClosedIsSmoothAcrossItsEnds) {
  std::mt19937_64 random(testSeed());
  OmegaData data;
  data.closed = true;
  data.values.resize(9, 1);
  for (int i = 0; i <= 8; ++i) {
    data.omegas.push_back(2 * std::numbers::pi * i / 8 +
                          (i % 8 == 0 ? 0 : drawn(-0.2, 0.2, random)));
    data.values(i, 0) = i == 8 ? 0.0 : std::sin(data.omegas[i]);
  }
  const OmegaSpline spline = omegaSpline(data);
  expectSmooth(spline, 1, 0);
  EXPECT_LE((pieceEnd(spline, 7, true) - pieceEnd(spline, 0, false)).norm(), 1e-11);
  EXPECT_NEAR(pieceEnd(spline, 0, false)(1), 1, 0.02);
}

TEST(OmegaSpline, PolesReproduceThePieces) {
  std::mt19937_64 random(testSeed());
  const OmegaSpline spline = omegaSpline(sampled(
      6, [](double x) { return std::exp(x); }, random));
  std::vector<bool> kink(spline.breaks.size(), false);
  const loft::OmegaPoles poles = loft::omegaPoles(spline.breaks, kink, 3, spline.rows);
  BSplineCurve curve{3, poles.knots, HomogeneousPoles::Ones(poles.rows.rows(), 4)};
  curve.poles.leftCols<3>() = poles.rows.replicate(1, 3);
  const BezierSpline pieces = bezierSpline(curve);
  ASSERT_EQ(pieces.poles.rows(), spline.rows.rows());
  EXPECT_LE((pieces.poles.col(0) - spline.rows.col(0)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(OmegaSpline, RefusesInvalidData) {
  OmegaData data{
      .omegas = {0, 1, 1}, .values = Eigen::MatrixXd::Zero(3, 1), .start = {}, .end = {}};
  EXPECT_THROW(omegaSpline(data), std::invalid_argument);
  data.omegas = {0, 1};
  EXPECT_THROW(omegaSpline(data), std::invalid_argument);
  data.omegas = {0, std::nan(""), 2};
  EXPECT_THROW(omegaSpline(data), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
