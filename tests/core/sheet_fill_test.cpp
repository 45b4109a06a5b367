// SPDX-License-Identifier: LGPL-2.1-or-later
// Splines between four sides, in holes of surfaces with formulas. Points and normals along the
// sides are compared with the formulas, which the fill knows at its own samples only.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <random>

#include "support/random.hpp"

#include <seamwright/core/angle.hpp>
#include <seamwright/core/fill/sheet_fill.hpp>

namespace seamwright::test {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

constexpr double pi = std::numbers::pi;

/// A surface over [0, 1]², whose parameter lines along the border have a constant speed.
using Formula = std::function<SheetSample(double u, double v, bool along_u)>;

/// Around the z axis by half a turn, and by an angle around the circle of the tube.
Formula halfTorus(double ring_mm, double tube_mm, double from_rad, double to_rad) {
  return [=](double u, double v, bool along_u) -> SheetSample {
    const double phi = pi * u, theta = std::lerp(from_rad, to_rad, v);
    const Vector3d out(std::cos(phi), std::sin(phi), 0), z = Vector3d::UnitZ();
    const Vector3d normal = std::cos(theta) * out + std::sin(theta) * z, around = z.cross(out),
                   up = normal.cross(around);
    const double reach_mm = ring_mm + tube_mm * std::cos(theta);
    return {.point = ring_mm * out + tube_mm * normal,
            .derivative = along_u ? Vector3d(pi * reach_mm * around)
                                  : Vector3d((to_rad - from_rad) * tube_mm * up),
            .normal = normal,
            .bend = -up * up.transpose() / tube_mm -
                    std::cos(theta) / reach_mm * around * around.transpose()};
  };
}

/// A plane for u < 1/2 and a tangent cylinder beyond, unrolled.
Formula planeAndCylinder() {
  constexpr double radius_mm = 20, half_mm = 6, wide_mm = 8;
  return [=](double u, double v, bool along_u) -> SheetSample {
    const double s = half_mm * (2 * u - 1), turn = std::max(s, 0.0) / radius_mm;
    const Vector3d along(std::cos(turn), 0, -std::sin(turn));
    const double x = s < 0 ? s : radius_mm * std::sin(turn);
    return {.point = {x, wide_mm * v, radius_mm * (std::cos(turn) - 1)},
            .derivative = along_u ? Vector3d(2 * half_mm * along) : Vector3d(0, wide_mm, 0),
            .normal = {std::sin(turn), 0, std::cos(turn)},
            .bend = s < 0 ? Eigen::Matrix3d::Zero()
                          : Eigen::Matrix3d(-along * along.transpose() / radius_mm)};
  };
}

/// A bilinear surface; its sides are straight.
Formula bilinear() {
  const Vector3d a(0, 0, 0), b(9, 1, 2), c(11, 6, -1), d(1, 5, 3);
  return [=](double u, double v, bool along_u) -> SheetSample {
    const Vector3d by_u = (1 - v) * (b - a) + v * (c - d), by_v = (1 - u) * (d - a) + u * (c - b),
                   twist = a - b + c - d, normal = by_u.cross(by_v).normalized();
    Eigen::Matrix<double, 3, 2> jacobian;
    jacobian << by_u, by_v;
    const double bend = normal.dot(twist);
    const Eigen::Matrix2d second{{0, bend}, {bend, 0}};
    const Eigen::Matrix<double, 2, 3> inverse =
        (jacobian.transpose() * jacobian).inverse() * jacobian.transpose();
    return {.point = a + u * (b - a) + v * (d - a) + u * v * twist,
            .derivative = along_u ? by_u : by_v,
            .normal = normal,
            .bend = inverse.transpose() * second * inverse};
  };
}

/// The point of [0, 1]² at a share of a side.
Vector2d placeOf(std::size_t side, double share) {
  const std::array<Vector2d, 5> corners = {Vector2d(0, 0), Vector2d(1, 0), Vector2d(1, 1),
                                           Vector2d(0, 1), Vector2d(0, 0)};
  return (1 - share) * corners.at(side) + share * corners.at(side + 1);
}

std::array<SheetFillSide, 4> sidesOf(const Formula& formula,
                                     const std::vector<double>& joints_u = {}) {
  std::array<SheetFillSide, 4> sides;
  for (std::size_t side = 0; side < 4; ++side) {
    sides[side].at = [=](double share) {
      const Vector2d at = placeOf(side, share);
      SheetSample sample = formula(at.x(), at.y(), side % 2 == 0);
      if (side >= 2) sample.derivative *= -1;
      return sample;
    };
    if (side % 2 == 0) sides[side].joints = joints_u;
  }
  return sides;
}

constexpr SheetFillOptions asked{.gap_mm = 0.001, .angle_rad = 0.01 * radians_per_degree};

Vector3d pointOf(const SheetFill& fill, double u, double v) {
  return jet(fill.surface, u * fill.surface.knots_u.back(), v * fill.surface.knots_v.back()).p;
}

/// The largest distance from the sides, and the largest angle of normals.
std::array<double, 2> missOf(const SheetFill& fill, const std::array<SheetFillSide, 4>& sides) {
  std::array<double, 2> miss{};
  for (std::size_t side = 0; side < 4; ++side)
    for (int k = 0; k <= 400; ++k) {
      const SheetSample given = sides[side].at(k / 400.0);
      const Vector2d at = placeOf(side, k / 400.0);
      const SurfaceJet made = jet(fill.surface, at.x() * fill.surface.knots_u.back(),
                                  at.y() * fill.surface.knots_v.back());
      const Vector3d normal = made.u.cross(made.v);
      miss[0] = std::max(miss[0], (made.p - given.point).norm());
      miss[1] = std::max(miss[1],
                         std::atan2(given.normal.cross(normal).norm(), given.normal.dot(normal)));
    }
  return miss;
}

void expectMeets(const SheetFill& fill, const std::array<SheetFillSide, 4>& sides) {
  const auto [gap_mm, angle_rad] = missOf(fill, sides);
  EXPECT_LT(gap_mm, asked.gap_mm);
  EXPECT_LT(angle_rad, asked.angle_rad);
  EXPECT_TRUE(fill.regular);
}

double insideMiss(const SheetFill& fill, const Formula& formula) {
  double miss = 0;
  for (int i = 1; i < 20; ++i)
    for (int j = 1; j < 20; ++j)
      miss = std::max(
          miss,
          (pointOf(fill, i / 20.0, j / 20.0) - formula(i / 20.0, j / 20.0, true).point).norm());
  return miss;
}

// (1)
TEST(SheetFill, ReproducesABilinearSurface) {
  const SheetFill fill = sheetFill(sidesOf(bilinear()), asked);
  EXPECT_LT(insideMiss(fill, bilinear()), 1e-6);
  EXPECT_LT(fill.gap_mm, 1e-6);
  EXPECT_TRUE(fill.regular);
}

// (2)
TEST(SheetFill, DoesNotDependOnTheFirstSide) {
  const std::array<SheetFillSide, 4> sides = sidesOf(halfTorus(20, 6, 0.2, 1.4));
  std::array<SheetFillSide, 4> turned = sides;
  std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  const SheetFill one = sheetFill(sides, asked), other = sheetFill(turned, asked);
  for (const Vector2d& at : {Vector2d(0.2, 0.3), Vector2d(0.5, 0.5), Vector2d(0.9, 0.6)})
    EXPECT_LT((pointOf(one, at.x(), at.y()) - pointOf(other, at.y(), 1 - at.x())).norm(), 1e-3);
}

// (3): no direction sees the whole of such a band.
TEST(SheetFill, MeetsAHalfRing) {
  const Formula formula = halfTorus(34.9, 6.35, pi / 2, pi);
  const auto sides = sidesOf(formula);
  const SheetFill fill = sheetFill(sides, asked);
  expectMeets(fill, sides);
  EXPECT_LT(insideMiss(fill, formula), 0.3);
}

// The surfaces beyond bend far more than the hole is long.
TEST(SheetFill, MeetsAThinTube) {
  const Formula formula = halfTorus(20, 1.5, -1, 1);
  const auto sides = sidesOf(formula);
  const SheetFill fill = sheetFill(sides, asked);
  expectMeets(fill, sides);
  EXPECT_LT(insideMiss(fill, formula), 0.3);
}

// The second derivatives jump at the joints, where knots let them.
TEST(SheetFill, MeetsAJointOfAPlaneAndACylinder) {
  const auto sides = sidesOf(planeAndCylinder(), {0.5});
  const SheetFill fill = sheetFill(sides, asked);
  expectMeets(fill, sides);
  EXPECT_LT(insideMiss(fill, planeAndCylinder()), 0.01);
}

// A joint without a kink gets no knot of its own.
TEST(SheetFill, IgnoresJointsOfOneCurve) {
  const Formula formula = halfTorus(34.9, 6.35, pi / 2, pi);
  const SheetFill plain = sheetFill(sidesOf(formula), asked),
                  jointed = sheetFill(sidesOf(formula, {0.3, 0.61}), asked);
  EXPECT_EQ(plain.surface.knots_u, jointed.surface.knots_u);
}

// (4): bands around thin and thick tubes, whose long sides differ by far.
TEST(SheetFill, WhatMeetsAToleranceMeetsLargerOnes) {
  std::mt19937 random(testSeed());
  std::uniform_real_distribution<double> tubes_mm(5, 25), inners_mm(2, 10);
  for (int band = 0; band < 3; ++band) {
    const double tube_mm = tubes_mm(random), inner_mm = inners_mm(random);
    const auto sides = sidesOf(halfTorus(inner_mm + tube_mm, tube_mm, pi / 2, pi));
    bool is_met = true;
    for (const double angle_deg : {1.0, 0.3, 0.1, 0.03, 0.01, 0.005, 0.002}) {
      const SheetFillOptions options{.gap_mm = 0.1 * angle_deg,
                                     .angle_rad = angle_deg * radians_per_degree};
      const SheetFill fill = sheetFill(sides, options);
      const auto [gap_mm, angle_rad] = missOf(fill, sides);
      const bool now = fill.regular && gap_mm <= options.gap_mm && angle_rad <= options.angle_rad;
      EXPECT_TRUE(is_met || !now) << tube_mm << " " << inner_mm << " at " << angle_deg;
      EXPECT_TRUE(now || angle_deg < 0.01) << tube_mm << " " << inner_mm << " at " << angle_deg;
      is_met = now;
    }
  }
}

TEST(SheetFill, FinerSheetsFollow) {
  SheetSequence sheets(sidesOf(halfTorus(20, 6, 0.2, 1.4)), {.gap_mm = 1, .angle_rad = 0.1});
  const std::optional<SheetFill> first = sheets.next(), second = sheets.next();
  ASSERT_TRUE(first && second);
  EXPECT_GT(second->surface.poles.rows(), first->surface.poles.rows());
}

TEST(SheetFill, WithoutAnAngleItMeetsThePositionAlone) {
  const auto sides = sidesOf(halfTorus(20, 6, 0.2, 1.4));
  const SheetFill fill = sheetFill(sides, {.gap_mm = 0.001});
  EXPECT_LT(missOf(fill, sides)[0], 0.001);
}

TEST(SheetFill, RefusesWhatItCannotUse) {
  const auto sides = sidesOf(bilinear());
  EXPECT_THROW(sheetFill(sides, {.gap_mm = 0}), std::invalid_argument);
  EXPECT_THROW(sheetFill(sides, {.gap_mm = 1, .angle_rad = -1}), std::invalid_argument);
  auto bad = sides;
  bad[2].at = [](double) {
    SheetSample sample{};
    sample.point = Vector3d::Constant(NAN);
    return sample;
  };
  EXPECT_THROW(sheetFill(bad, asked), std::invalid_argument);
}

TEST(SheetFill, StopsWhenCancelled) {
  EXPECT_THROW(sheetFill(sidesOf(bilinear()), asked, [](double) { return false; }), Cancelled);
}

}  // namespace
}  // namespace seamwright::test
