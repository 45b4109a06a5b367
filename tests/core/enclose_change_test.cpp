// SPDX-License-Identifier: LGPL-2.1-or-later
// The enclosed change of curvature against measurePair(), closed forms, exact joins and laws.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <seamwright/core/seam/enclose.hpp>
#include <seamwright/core/seam/judge.hpp>

#include "seam_sides.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using test::linePath;
using test::logUniform;
using test::PatchSide;
using test::poleList;
using test::Vec;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr EncloseOptions with_change{.curvature_change = true};

SidePoint thirdOrderAt(const PatchSide& side, double s) {
  SidePoint point = side.at(s);
  point.third_order = true;
  return point;
}

struct ChangeAt {
  double per_mm2 = 0, rel = 0, size_per_mm2 = 0;
};

/// Nothing where the pair has no change of curvature.
std::optional<ChangeAt> changeAt(const PatchSide& a, const PatchSide& b, double s, double flat) {
  const PairMeasure pair = measurePair(thirdOrderAt(a, s), thirdOrderAt(b, s));
  if (!pair.curvature_change) return std::nullopt;
  const CurvatureChange& change = *pair.curvature_change;
  const double norm = std::max(pair.curvature->norm_a_per_mm, pair.curvature->norm_b_per_mm);
  return ChangeAt{change.difference_per_mm2, relativeChange(change, *pair.curvature, flat),
                  std::max({change.change_a_per_mm2, change.change_b_per_mm2, norm * norm})};
}

/// A patch over about [0, 10]^2.
BezierPatch randomPatch(int m, int n, double roughness, bool rational, std::mt19937_64& random) {
  Poles poles((m + 1) * (n + 1), 3);
  Eigen::VectorXd weights(poles.rows());
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j) {
      const Eigen::Index row = i * (n + 1) + j;
      poles.row(row) =
          (Vec(10.0 * i / m, 10.0 * j / n, 0) + roughness * test::randomVector(random)).transpose();
      weights(row) = rational ? std::uniform_real_distribution<double>(0.5, 2)(random) : 1;
    }
  return {m, n, poles, weights};
}

BezierPatch shaken(const BezierPatch& patch, double by, int first_row, std::mt19937_64& random) {
  Poles poles = patch.poles();
  for (Eigen::Index i = static_cast<Eigen::Index>(first_row) * (patch.degreeV() + 1);
       i < poles.rows(); ++i)
    poles.row(i) += by * test::randomVector(random).transpose();
  return {patch.degreeU(), patch.degreeV(), poles, patch.weights()};
}

BezierCurve randomPath(bool rational, std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(0.3, 0.7);
  Poles poles(4, 3);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(4);
  for (int i = 0; i < 4; ++i) {
    poles.row(i) << place(random), 0.1 + 0.25 * i, 0;
    if (rational) weights(i) = std::uniform_real_distribution<double>(0.6, 1.6)(random);
  }
  return {poles, weights};
}

PatchSide endOf(const BezierPatch& patch) {
  return {patch, linePath(1, 0, 1, 1), true};
}
PatchSide beginOf(const BezierPatch& patch) {
  return {patch, linePath(0, 0, 0, 1), false};
}

/// Sides of one patch and one nearly like it: along one trimming path, along the edge between two
/// halves, or with exchanged parameters.
std::pair<PatchSide, PatchSide> randomSeam(double defect, std::mt19937_64& random) {
  const bool rational = random() % 3 == 0;
  const int m = 2 + static_cast<int>(random() % 3), n = 1 + static_cast<int>(random() % 3);
  const BezierPatch patch = randomPatch(m, n, logUniform(random, -2, -0.3), rational, random);
  switch (random() % 3) {
    case 0: {
      const BezierCurve path = randomPath(random() % 2 == 0, random);
      return {{patch, path, true}, {shaken(patch, defect, 0, random), path, false}};
    }
    case 1: {
      const auto [left, right] = patch.splitU(0.5);
      return {endOf(left), beginOf(shaken(right, defect, 1, random))};
    }
    default: {
      const BezierPatch other = shaken(patch, defect, 0, random).transposed();
      const double u = std::uniform_real_distribution<double>(0.2, 0.8)(random);
      return {{patch, linePath(u, 0, u, 1), true}, {other, linePath(0, u, 1, u), true}};
    }
  }
}

TEST(EncloseChange, Identity1NoValueIsOutsideTheBounds) {
  std::mt19937_64 random(testSeed());
  int enclosed = 0, narrow = 0;
  for (int i = 0; i < 150; ++i) {
    SCOPED_TRACE(i);
    const auto [a, b] = randomSeam(logUniform(random, -7, -1), random);
    ContinuityTolerance tolerance;
    tolerance.crease_rad = 0.5;
    tolerance.flat_radius_mm = logUniform(random, 2, 6);
    const SeamFigures figures = encloseSeam(a.seamSide(), b.seamSide(), tolerance, with_change);
    if (!figures.curvature_change_rel) continue;
    const Figure& absolute = *figures.curvature_change_per_mm2;
    const Figure& relative = *figures.curvature_change_rel;
    ChangeAt most;
    for (int k = 0; k <= 400; ++k) {
      const auto here = changeAt(a, b, k / 400.0, tolerance.flat_radius_mm);
      if (!here) continue;
      most.per_mm2 = std::max(most.per_mm2, here->per_mm2);
      most.rel = std::max(most.rel, here->rel);
      most.size_per_mm2 = std::max(most.size_per_mm2, here->size_per_mm2);
    }
    const double noise = 1e-11 * (1 + most.size_per_mm2);
    ASSERT_TRUE(figures.certified) << figures.uncertified;
    EXPECT_GE(*absolute.upper, most.per_mm2 - noise);
    EXPECT_GE(*relative.upper, most.rel * (1 - 1e-9) - 1e-9);
    EXPECT_LE(*relative.upper, 2);
    const auto there = changeAt(a, b, absolute.at, tolerance.flat_radius_mm);
    ASSERT_TRUE(there);
    EXPECT_LE(absolute.lower, there->per_mm2 * (1 + 1e-9) + noise);
    EXPECT_LE(relative.lower,
              changeAt(a, b, relative.at, tolerance.flat_radius_mm)->rel * (1 + 1e-9) + 1e-9);
    ++enclosed;
    const double tolerated = tolerance.curvature_rel;
    narrow += *relative.upper - relative.lower <= 0.011 * std::max(relative.lower, tolerated);
    if (HasFailure()) break;
  }
  EXPECT_GT(enclosed, 120);
  EXPECT_GT(narrow, 0.9 * enclosed);
}

/// z = k x^2 / 2 + change(y) x^3 / 6 over [from, from + 1] x [0, 1], as a patch with u along x.
/// change is a polynomial in Bernstein form.
BezierPatch graph(double from, double curvature, const Eigen::VectorXd& change) {
  const int n = static_cast<int>(change.size()) - 1;
  // The blossoms of x, x^2 and x^3 at the poles of a cubic in u.
  Poles poles(4 * (n + 1), 3);
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; j <= n; ++j) {
      std::array<double, 3> t;
      for (int r = 0; r < 3; ++r) t[r] = from + (r < i ? 1 : 0);
      const double x = (t[0] + t[1] + t[2]) / 3, xx = (t[0] * t[1] + t[1] * t[2] + t[2] * t[0]) / 3,
                   xxx = t[0] * t[1] * t[2];
      poles.row(i * (n + 1) + j) << x, n == 0 ? 0 : static_cast<double>(j) / n,
          curvature * xx / 2 + change(j) * xxx / 6;
    }
  return {3, n, poles};
}

TEST(EncloseChange, OfGraphsItIsTheJumpOfTheCubicTerm) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    Eigen::VectorXd left(4), right(4);
    for (int j = 0; j < 4; ++j) {
      left(j) = test::randomVector(random)(0);
      right(j) = left(j) + logUniform(random, -3, 0) * test::randomVector(random)(0);
    }
    const double curvature = i % 4 == 0 ? 0 : logUniform(random, -2, 0);
    // A jump of the figure to nearly 2 may be narrower than the steps.
    double wanted = 0, wanted_rel = 0;
    const auto at = [](const Eigen::VectorXd& c, double y) {
      const double z = 1 - y;
      return z * z * z * c(0) + 3 * z * z * y * c(1) + 3 * z * y * y * c(2) + y * y * y * c(3);
    };
    const auto relative = [&](double y) {
      const double a = at(left, y), b = at(right, y);
      return std::abs(b - a) / std::max({std::abs(a), std::abs(b), curvature * curvature});
    };
    for (int k = 0; k <= 20000; ++k) {
      const double y = k / 20000.0;
      wanted = std::max(wanted, std::abs(at(right, y) - at(left, y)));
      wanted_rel = std::max(wanted_rel, relative(y));
    }
    const SeamFigures figures =
        encloseSeam(endOf(graph(-1, curvature, left)).seamSide(),
                    beginOf(graph(0, curvature, right)).seamSide(), {}, with_change);
    ASSERT_TRUE(figures.certified) << figures.uncertified;
    EXPECT_LT(*figures.curvature_rel->upper, 1e-9);
    EXPECT_LE(figures.curvature_change_per_mm2->lower, wanted + 1e-12);
    EXPECT_GE(*figures.curvature_change_per_mm2->upper, wanted - 1e-12);
    EXPECT_LE(*figures.curvature_change_per_mm2->upper,
              figures.curvature_change_per_mm2->lower + 0.01 * std::max(wanted, 0.02));
    EXPECT_LE(figures.curvature_change_rel->lower,
              relative(figures.curvature_change_rel->at) + 1e-9);
    EXPECT_GE(*figures.curvature_change_rel->upper, wanted_rel * (1 - 1e-6));
    EXPECT_LE(*figures.curvature_change_rel->upper,
              figures.curvature_change_rel->lower * 1.01 + 0.0002);
  }
}

/// The turned curve (radius + x, k x^2 / 2 + change x^3 / 6), x in [-1, 1], along its parallel x =
/// 0. The curvature of the parallel is 0 there and that of the meridian k.
SeamSide turned(double radius, double curvature, double change, const Frame& frame, bool on_left) {
  Poles poles(4, 3);
  for (int i = 0; i <= 3; ++i) {
    std::array<double, 3> t;
    for (int r = 0; r < 3; ++r) t[r] = r < i ? 1 : -1;
    const double x = (t[0] + t[1] + t[2]) / 3, xx = (t[0] * t[1] + t[1] * t[2] + t[2] * t[0]) / 3,
                 xxx = t[0] * t[1] * t[2];
    const Vec local(radius + x, 0, curvature * xx / 2 + change * xxx / 6);
    poles.row(i) = (frame.origin + frame.axes * local).transpose();
  }
  return {.path = LineEvaluator{{0, 0.5, 0}, {6, 0, 0}},
          .surface = revolutionEvaluator(frame, test::splineOf(BezierCurve(poles))),
          .face_on_left = on_left};
}

TEST(EncloseChange, OfTurnedCurvesItIsTheJumpOfTheirChange) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 30; ++i) {
    SCOPED_TRACE(i);
    const Frame frame{10 * test::randomVector(random), Eigen::Matrix3d::Identity()};
    const double radius = logUniform(random, 0.5, 2), curvature = logUniform(random, -2, -0.5);
    const double a = test::randomVector(random)(0), b = test::randomVector(random)(0);
    const SeamFigures figures =
        encloseSeam(turned(radius, curvature, a, frame, true),
                    turned(radius, curvature, b, frame, false), {}, with_change);
    ASSERT_TRUE(figures.certified) << figures.uncertified;
    const double largest = std::max({std::abs(a), std::abs(b), curvature * curvature});
    EXPECT_NEAR(figures.curvature_change_per_mm2->lower, std::abs(b - a), 1e-4);
    EXPECT_NEAR(*figures.curvature_change_per_mm2->upper, std::abs(b - a), 1e-4);
    EXPECT_LE(figures.curvature_change_per_mm2->lower, std::abs(b - a) + 1e-12);
    EXPECT_GE(*figures.curvature_change_per_mm2->upper, std::abs(b - a) - 1e-12);
    EXPECT_NEAR(figures.curvature_change_rel->lower, std::abs(b - a) / largest, 1e-3);
    EXPECT_NEAR(*figures.curvature_change_rel->upper, std::abs(b - a) / largest, 1e-3);
  }
}

TEST(EncloseChange, OfAConeItDependsOnTheDirectionAcross) {
  // Across a slanted path the direction is neither that of the circle nor that of the curve. The
  // other side is a plane, so the figure is 3 cos^2(a) |sin(a)| |dk/ds| itself.
  constexpr double radius = 3, half_angle = 0.4;
  SeamSide cone{LineEvaluator{{0, 0.2, 0}, {1e-7, 1e-7, 0}}, coneEvaluator({}, radius, half_angle)};
  // Both along one short line, so that tangents and tangent planes agree.
  const double rho = radius + 0.2 * std::sin(half_angle);
  const Vec around(0, 1, 0), along(std::sin(half_angle), 0, std::cos(half_angle));
  const Vec tangent = (rho * around + along).normalized();
  const Vec normal = around.cross(along).normalized();
  Frame frame;
  frame.origin = Vec(rho, 0, 0.2 * std::cos(half_angle));
  frame.axes << tangent, normal.cross(tangent), normal;
  SeamSide flat{LineEvaluator{{0, 0, 0}, {1e-7 * (rho * around + along).norm(), 0, 0}},
                planeEvaluator(frame)};
  flat.face_on_left = false;
  const SeamFigures figures = encloseSeam(cone, flat, {}, with_change);
  ASSERT_TRUE(figures.certified) << figures.uncertified;
  const Vec across = normal.cross(tangent);
  const double cosine = across.dot(around), sine = across.dot(along);
  const double rate = std::cos(half_angle) * std::sin(half_angle) / (rho * rho);
  const double wanted = 3 * cosine * cosine * std::abs(sine) * rate;
  EXPECT_NEAR(figures.curvature_change_per_mm2->lower, wanted, 1e-6 * wanted);
  EXPECT_NEAR(*figures.curvature_change_per_mm2->upper, wanted, 1e-6 * wanted);
}

TEST(EncloseChange, Identity3OfAnExactJoinItIsRounding) {
  std::mt19937_64 random(testSeed());
  int joined = 0;
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const auto [a, b] = randomSeam(0, random);
    const SeamFigures figures = encloseSeam(a.seamSide(), b.seamSide(), {}, with_change);
    ASSERT_TRUE(figures.curvature_change_rel) << figures.uncertified;
    ASSERT_TRUE(figures.certified) << figures.uncertified;
    EXPECT_LT(*figures.curvature_change_per_mm2->upper, 1e-6);
    const Verdict verdict = judge(figures, {}, Level::G3);
    joined += verdict.level == Level::G3 && verdict.certain;
  }
  EXPECT_EQ(joined, 60);
}

TEST(EncloseChange, VerdictsAreCertainOnBothSidesOfTheTolerance) {
  const ContinuityTolerance tolerance;
  for (const auto& [jump, level] : {std::pair{0.019, Level::G3}, std::pair{0.021, Level::G2}}) {
    for (const bool figures : {true, false}) {
      const EncloseOptions options{.figures = figures, .curvature_change = true};
      const SeamFigures enclosed = encloseSeam(
          endOf(graph(-1, 1, Eigen::VectorXd::Zero(3))).seamSide(),
          beginOf(graph(0, 1, Eigen::VectorXd::Constant(3, jump))).seamSide(), tolerance, options);
      const Verdict verdict = judge(enclosed, tolerance, Level::G3);
      EXPECT_EQ(verdict.level, level) << jump;
      EXPECT_TRUE(verdict.certain) << jump;
    }
  }
}

TEST(EncloseChange, WhatTheCurvatureLeavesOutIsNotCertainlyG3) {
  SeamFigures figures =
      encloseSeam(endOf(graph(-1, 1, Eigen::VectorXd::Zero(3))).seamSide(),
                  beginOf(graph(0, 1, Eigen::VectorXd::Zero(3))).seamSide(), {}, with_change);
  EXPECT_TRUE(judge(figures, {}, Level::G3).certain);
  figures.curvature_left_out = {{{0, 0.1}}, 0, 0.1};
  EXPECT_EQ(judge(figures, {}, Level::G3).level, Level::G3);
  EXPECT_FALSE(judge(figures, {}, Level::G3).certain);
  EXPECT_TRUE(judge(figures, {}, Level::G2).level == Level::G3);
  figures.curvature_left_out.longest_mm = 0.001;  // below the gap tolerance it is a point
  EXPECT_TRUE(judge(figures, {}, Level::G3).certain);
}

TEST(EncloseChange, OnlyWhereItIsAskedForAndBelowTheCreaseAngle) {
  const SeamSide left = endOf(graph(-1, 1, Eigen::VectorXd::Zero(3))).seamSide();
  const SeamSide right = beginOf(graph(0, 1, Eigen::VectorXd::Zero(3))).seamSide();
  EXPECT_FALSE(encloseSeam(left, right, {}).curvature_change_rel);
  EXPECT_TRUE(encloseSeam(left, right, {}).certified);
  Frame frame;
  frame.axes = Eigen::AngleAxisd(1, Vec::UnitY()).toRotationMatrix();
  const SeamSide steep{LineEvaluator{{0, 0, 0}, {0, 1, 0}}, planeEvaluator(frame)};
  const SeamFigures crease = encloseSeam(left, steep, {}, with_change);
  EXPECT_FALSE(crease.curvature_change_rel);
  EXPECT_TRUE(crease.certified);
}

/// Both bounds hold one value, so the intervals must meet.
void expectSame(const Figure& one, const Figure& other, double factor, double noise) {
  EXPECT_LE(one.lower * factor, *other.upper + noise);
  EXPECT_LE(other.lower, *one.upper * factor + noise);
}

TEST(EncloseChange, Identity2SwapReversalMotionAndScale) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 30; ++i) {
    SCOPED_TRACE(i);
    const auto [a, b] = randomSeam(logUniform(random, -4, -2), random);
    ContinuityTolerance tolerance;
    tolerance.crease_rad = 0.5;
    tolerance.flat_radius_mm = 1e9;  // scaled sides are compared with it
    const SeamFigures wanted = encloseSeam(a.seamSide(), b.seamSide(), tolerance, with_change);
    if (!wanted.curvature_change_rel || !wanted.certified) continue;
    const auto compare = [&](const SeamSide& x, const SeamSide& y, double scale, const char* law) {
      SCOPED_TRACE(law);
      const SeamFigures figures = encloseSeam(x, y, tolerance, with_change);
      ASSERT_TRUE(figures.certified) << figures.uncertified;
      expectSame(*wanted.curvature_change_per_mm2, *figures.curvature_change_per_mm2,
                 1 / (scale * scale), 1e-9 / (scale * scale));
      expectSame(*wanted.curvature_change_rel, *figures.curvature_change_rel, 1, 1e-9);
    };
    compare(b.seamSide(), a.seamSide(), 1, "swap");
    PatchSide back_a = a, back_b = b;
    for (PatchSide* side : {&back_a, &back_b}) {
      side->reversed = true;
      side->face_on_left = !side->face_on_left;
    }
    compare(back_a.seamSide(), back_b.seamSide(), 1, "reversal");
    const auto placed = [&](const PatchSide& side, const Placement& placement) {
      SeamSide result = side.seamSide();
      result.surface = placedEvaluator(splineEvaluator(test::splineOf(side.surface)), placement);
      return result;
    };
    Placement motion;
    motion.orthogonal =
        Eigen::AngleAxisd(2, test::randomVector(random).normalized()).toRotationMatrix();
    motion.translation = 10 * test::randomVector(random);
    compare(placed(a, motion), placed(b, motion), 1, "motion");
    Placement scale;
    scale.scale = logUniform(random, -2, 2);
    tolerance.gap_mm *= scale.scale;
    compare(placed(a, scale), placed(b, scale), scale.scale, "scale");
  }
}

TEST(EncloseChange, AlternativesAcrossKnotLinesBothCount) {
  // A cubic spline strip with a knot of third order across the path: f jumps along the seam.
  const auto strip = [](double jump) {
    const std::vector<double> knots = {0, 0, 0, 0, 0.5, 1, 1, 1, 1};
    SplineDirection along{3, knots, 0}, across{3, {0, 0, 0, 0, 1, 1, 1, 1}, 0};
    std::vector<Vec> poles;
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 4; ++j) {
        const double y = (knots[i + 1] + knots[i + 2] + knots[i + 3]) / 3;
        poles.emplace_back(j / 3.0, y, j == 3 ? jump * (i == 2 ? 1 : 0) / 6 : 0);
      }
    return SeamSide{LineEvaluator{{0, 0, 0}, {1, 0, 0}},
                    splineEvaluator(std::make_shared<SplineEvaluator>(along, across, poles,
                                                                      std::vector<double>())),
                    {0, 1},
                    {0, 1},
                    true};
  };
  const SeamFigures figures = encloseSeam(
      SeamSide{LineEvaluator{{0, 0, 0}, {0, 1, 0}}, planeEvaluator({})}, strip(1), {}, with_change);
  ASSERT_TRUE(figures.certified) << figures.uncertified;
  // Across x = 0 the height is basis(y) x^3 / 6, and the largest basis value of a C2 cubic spline
  // with knots 0, 1/2, 1 at the middle is 1/2.
  EXPECT_NEAR(figures.curvature_change_per_mm2->lower, 0.5, 1e-2);
  EXPECT_GE(*figures.curvature_change_per_mm2->upper, 0.5);
}

}  // namespace
}  // namespace seamwright
