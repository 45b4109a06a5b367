// SPDX-License-Identifier: LGPL-2.1-or-later
// Spline graphs in holes of functions with formulas. Heights and normals along the boundary are
// compared with the formulas, which the fill knows at its own samples only.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <seamwright/core/angle.hpp>
#include <seamwright/core/fill/graph_fill.hpp>
#include <seamwright/core/fill/graph_knots.hpp>

namespace seamwright::test {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

/// A function with its gradient and second derivatives.
struct Function {
  std::function<double(const Vector2d&)> height;
  std::function<Vector2d(const Vector2d&)> slope;
  std::function<Eigen::Matrix2d(const Vector2d&)> bend;
};

Function quadratic() {
  const Eigen::Matrix2d bend{{0.04, -0.03}, {-0.03, 0.02}};
  const Vector2d tilt(0.3, -0.1);
  return {[=](const Vector2d& p) { return 0.5 * p.dot(bend * p) + tilt.dot(p) + 7; },
          [=](const Vector2d& p) -> Vector2d { return bend * p + tilt; },
          [=](const Vector2d&) { return bend; }};
}

constexpr double radius = 20;

Function sphere() {
  const auto height = [](const Vector2d& p) { return std::sqrt(radius * radius - p.dot(p)); };
  return {height, [=](const Vector2d& p) -> Vector2d { return -p / height(p); },
          [=](const Vector2d& p) -> Eigen::Matrix2d {
            const double h = height(p);
            return -Eigen::Matrix2d::Identity() / h - p * p.transpose() / (h * h * h);
          }};
}

/// A plane for x < 1, and a cylinder tangent to it beyond.
Function planeAndCylinder() {
  const auto beyond = [](const Vector2d& p) { return std::max(p.x() - 1, 0.0); };
  const auto depth = [=](const Vector2d& p) {
    return std::sqrt(radius * radius - beyond(p) * beyond(p));
  };
  return {[=](const Vector2d& p) { return depth(p) - radius; },
          [=](const Vector2d& p) { return Vector2d(-beyond(p) / depth(p), 0); },
          [=](const Vector2d& p) {
            Eigen::Matrix2d bend = Eigen::Matrix2d::Zero();
            if (p.x() > 1) bend(0, 0) = -radius * radius / std::pow(depth(p), 3);
            return bend;
          }};
}

GraphSample sampleOf(const Function& f, const Vector2d& at, const Vector2d& derivative) {
  const Vector2d along = derivative.normalized(), across(along.y(), -along.x());
  return {.at = at,
          .height_mm = f.height(at),
          .slope = f.slope(at),
          .across = across,
          .bend_per_mm = across.dot(f.bend(at) * across),
          .speed_mm = derivative.norm()};
}

/// Straight parts between corners, which run to the left of the inside.
std::vector<GraphBoundary> polygon(const Function& f, const std::vector<Vector2d>& corners) {
  std::vector<GraphBoundary> parts;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector2d from = corners[k], step = corners[(k + 1) % corners.size()] - from;
    parts.emplace_back([=](double t) { return sampleOf(f, from + t * step, step); });
  }
  return parts;
}

const std::vector<Vector2d> l_shape = {{-6, -6}, {6, -6}, {6, 0}, {0, 0}, {0, 6}, {-6, 6}};

constexpr GraphFillOptions asked{.gap_mm = 0.001, .angle_rad = 0.01 * radians_per_degree};

/// The largest distance from the function along the boundary, and the largest angle of normals.
std::array<double, 2> missOf(const GraphFill& fill, const std::vector<GraphBoundary>& boundary) {
  std::array<double, 2> miss{};
  for (const GraphBoundary& part : boundary)
    for (int k = 0; k <= 400; ++k) {
      const GraphSample given = part(k / 400.0);
      const SurfaceJet made = jet(fill.surface, given.at.x(), given.at.y());
      const Vector3d normal(-given.slope.x(), -given.slope.y(), 1), other = made.u.cross(made.v);
      miss[0] = std::max(miss[0], std::abs(made.p.z() - given.height_mm));
      miss[1] = std::max(miss[1], std::atan2(normal.cross(other).norm(), normal.dot(other)));
    }
  return miss;
}

/// The largest distance from the function at points inside of the L.
double insideMiss(const GraphFill& fill, const Function& f) {
  double miss = 0;
  for (double x = -5.5; x < 6; ++x)
    for (double y = -5.5; y < 6; ++y)
      if (x < 0 || y < 0)
        miss = std::max(miss, std::abs(jet(fill.surface, x, y).p.z() - f.height({x, y})));
  return miss;
}

// (1), with corners of 90 and of 270 degrees.
TEST(GraphFill, ReproducesQuadraticFunctions) {
  const Function f = quadratic();
  const GraphFill fill = graphFill(polygon(f, l_shape), asked);
  EXPECT_LT(insideMiss(fill, f), 1e-6);
  EXPECT_LT(fill.gap_mm, 1e-6);
}

// (2)
TEST(GraphFill, DoesNotDependOnTheFirstPart) {
  const Function f = sphere();
  std::vector<Vector2d> later(l_shape.begin() + 2, l_shape.end());
  later.insert(later.end(), l_shape.begin(), l_shape.begin() + 2);
  const GraphFill one = graphFill(polygon(f, l_shape), asked),
                  other = graphFill(polygon(f, later), asked);
  for (const Vector2d& at : {Vector2d(-3, 3), Vector2d(3, -3), Vector2d(-1, -1)})
    EXPECT_NEAR(jet(one.surface, at.x(), at.y()).p.z(), jet(other.surface, at.x(), at.y()).p.z(),
                1e-5);
}

// (3)
TEST(GraphFill, MeetsASphereAlongAnLShape) {
  const Function f = sphere();
  const auto boundary = polygon(f, l_shape);
  const GraphFill fill = graphFill(boundary, asked);
  const auto [gap_mm, angle_rad] = missOf(fill, boundary);
  EXPECT_LT(gap_mm, asked.gap_mm);
  EXPECT_LT(angle_rad, asked.angle_rad);
  EXPECT_LT(insideMiss(fill, f), 0.01);
}

TEST(GraphFill, MeetsAJointOfAPlaneAndACylinder) {
  const Function f = planeAndCylinder();
  // Parts end at the joint, as edges of a model do.
  const auto boundary = polygon(f, {{-6, -6}, {1, -6}, {6, -6}, {6, 0}, {4, 6}, {1, 6}, {-6, 6}});
  const GraphFill fill = graphFill(boundary, asked);
  const auto [gap_mm, angle_rad] = missOf(fill, boundary);
  EXPECT_LT(gap_mm, asked.gap_mm);
  EXPECT_LT(angle_rad, asked.angle_rad);
}

/// Flat for x < y, and bent beyond: tangent everywhere, with another mixed derivative on both
/// sides.
Function bentAcrossADiagonal() {
  constexpr double bend_per_mm = 0.05;
  const auto beyond = [](const Vector2d& p) { return std::max(p.x() - p.y(), 0.0); };
  return {[=](const Vector2d& p) { return 0.5 * bend_per_mm * beyond(p) * beyond(p); },
          [=](const Vector2d& p) -> Vector2d { return bend_per_mm * beyond(p) * Vector2d(1, -1); },
          [=](const Vector2d& p) -> Eigen::Matrix2d {
            return (p.x() > p.y() ? bend_per_mm : 0.0) * Eigen::Matrix2d{{1, -1}, {-1, 1}};
          }};
}

/// The same function and polygon, x and y being turned.
std::vector<GraphBoundary> turned(const Function& f, std::vector<Vector2d> corners,
                                  double turn_rad) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(turn_rad).toRotationMatrix();
  for (Vector2d& corner : corners) corner = turn.transpose() * corner;
  return polygon(
      {[=](const Vector2d& p) { return f.height(turn * p); },
       [=](const Vector2d& p) -> Vector2d { return turn.transpose() * f.slope(turn * p); },
       [=](const Vector2d& p) -> Eigen::Matrix2d {
         return turn.transpose() * f.bend(turn * p) * turn;
       }},
      corners);
}

const std::vector<Vector2d> square = {{-6, -6}, {6, -6}, {6, 6}, {-6, 6}};

// The diagonal between the two corners is where the second derivatives jump least.
TEST(GraphFill, TurnsWhereCornersDisagreeAboutTheMixedDerivative) {
  const auto turn_rad = graphTurn_rad(polygon(bentAcrossADiagonal(), square));
  ASSERT_TRUE(turn_rad);
  EXPECT_NEAR(*turn_rad, std::numbers::pi / 4, 1e-3);
  EXPECT_FALSE(graphTurn_rad(polygon(sphere(), square)));
  EXPECT_FALSE(graphTurn_rad(turned(bentAcrossADiagonal(), square, std::numbers::pi / 4)));
}

TEST(GraphFill, MeetsCornersThatDisagreeAboutTheMixedDerivative) {
  const auto boundary = turned(bentAcrossADiagonal(), square, std::numbers::pi / 4);
  const GraphFill fill = graphFill(boundary, asked);
  const auto [gap_mm, angle_rad] = missOf(fill, boundary);
  EXPECT_LT(gap_mm, asked.gap_mm);
  EXPECT_LT(angle_rad, asked.angle_rad);
  // Along the axes spans would have to be halved towards both corners instead.
  EXPECT_LT(fill.surface.poles.rows(), 400);
}

// The sum of the steps is not the whole range, up to rounding.
TEST(GraphKnots, KeepBothEndsBesideABend) {
  for (int k = 1; k < 200; ++k) {
    const double first = -std::sqrt(k), last = std::cbrt(k + 1);
    const fill::GraphKnots knots(first, last, 4, {last - 0.05 * (last - first)});
    EXPECT_EQ(knots.flat().front(), first);
    EXPECT_EQ(knots.flat().back(), last);
    EXPECT_EQ(std::ranges::count(knots.flat(), last), fill::graph_degree + 1);
  }
}

TEST(GraphFill, WithoutAnAngleItMeetsHeightsAlone) {
  const Function f = sphere();
  const auto boundary = polygon(f, l_shape);
  const GraphFill fill = graphFill(boundary, {.gap_mm = 0.001});
  EXPECT_LT(missOf(fill, boundary)[0], 0.001);
}

TEST(GraphFill, RefusesBadArguments) {
  const auto boundary = polygon(sphere(), l_shape);
  EXPECT_THROW(graphFill({}, asked), std::invalid_argument);
  EXPECT_THROW(graphFill(boundary, {.gap_mm = 0}), std::invalid_argument);
  EXPECT_THROW(graphFill(boundary, {.gap_mm = 1, .angle_rad = -1}), std::invalid_argument);
  const std::vector<GraphBoundary> broken = {[](double) {
    GraphSample sample;
    sample.at = sample.slope = sample.across = Vector2d(NAN, 0);
    return sample;
  }};
  EXPECT_THROW(graphFill(broken, asked), std::invalid_argument);
}

TEST(GraphFill, CanBeStopped) {
  EXPECT_THROW(graphFill(polygon(sphere(), l_shape), asked, [](double) { return false; }),
               Cancelled);
}

}  // namespace
}  // namespace seamwright::test
