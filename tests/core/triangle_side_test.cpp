// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts of one triangle join with continuity of any order, whatever they are made into.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <seamwright/core/bezier/triangle_conversion.hpp>
#include <seamwright/core/seam/judge.hpp>
#include <seamwright/core/seam/patch_side.hpp>
#include <seamwright/core/seam/triangle_side.hpp>

#include "support/random.hpp"
#include "triangles.hpp"

namespace seamwright {
namespace {

/// Lower than what any user accepts, above rounding.
ContinuityTolerance tight() {
  ContinuityTolerance tolerance;
  tolerance.gap_mm = 1e-10;
  tolerance.angle_rad = 1e-9;
  tolerance.curvature_rel = 1e-6;
  return tolerance;
}

/// A random triangle that is regular: about the plane one of side 1, with poles moved by up to a
/// tenth.
BezierTriangle regularTriangle(int degree, bool rational, std::mt19937_64& random) {
  Poles poles = test::randomNet(degree, random);
  Eigen::VectorXd weights(poles.rows());
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j) {
      const Eigen::Index row = BezierTriangle::row(degree, i, j);
      poles.row(row) *= 0.1 / degree;
      poles.row(row) += Eigen::RowVector3d(i, j, 0) / degree;
      weights(row) = test::logUniform(random, -0.1, 0.1);
    }
  return rational ? BezierTriangle(poles, weights) : BezierTriangle(poles);
}

void expectSmooth(const SeamSide& a, const SeamSide& b) {
  const SeamFigures figures = encloseSeam(a, b, tight());
  EXPECT_TRUE(figures.certified) << figures.uncertified;
  EXPECT_FALSE(figures.fold_at);
  const Verdict verdict = judge(figures, tight(), Level::G2);
  EXPECT_EQ(verdict.level, Level::G2);
  EXPECT_TRUE(verdict.certain);
}

TEST(TriangleSide, PartsOfATriangleJoin) {
  std::mt19937_64 random(testSeed());
  for (int degree = 1; degree <= 8; ++degree)
    for (const bool rational : {false, true}) {
      const BezierTriangle triangle = regularTriangle(degree, rational, random);
      const std::array<BezierTriangle, 4> four = triangle.quartered();
      for (const TriangleEdge edge : {TriangleEdge::L0, TriangleEdge::L1, TriangleEdge::L2})
        expectSmooth(seamSide(four[3], edge, true), seamSide(four[static_cast<int>(edge)], edge));
    }
}

TEST(TriangleSide, ATriangleJoinsTheRestOfThePatch) {
  std::mt19937_64 random(testSeed());
  for (int degree = 1; degree <= 8; ++degree)
    for (const bool rational : {false, true}) {
      const BezierTriangle triangle = regularTriangle(degree, rational, random);
      const BezierPatch rest = degeneratePatch(triangle).splitU(0.4).second;
      const BezierTriangle tip = triangle.subtriangle(
          {Barycentric(1, 0, 0), Barycentric(0.6, 0.4, 0), Barycentric(0.6, 0, 0.4)});
      expectSmooth(seamSide(tip, TriangleEdge::L0), seamSide(rest, PatchEdge::U0));
      expectSmooth(seamSide(rest.reversedU(), PatchEdge::U1, true),
                   seamSide(tip.permuted({1, 2, 0}), TriangleEdge::L2, true));
    }
}

TEST(TriangleSide, ThreeRegularPatchesJoin) {
  std::mt19937_64 random(testSeed());
  for (int degree = 1; degree <= 8; ++degree)
    for (const bool rational : {false, true}) {
      const std::array<BezierPatch, 3> patches =
          regularPatches(regularTriangle(degree, rational, random));
      for (int k = 0; k < 3; ++k)
        expectSmooth(seamSide(patches[k], PatchEdge::U1),
                     seamSide(patches[(k + 1) % 3], PatchEdge::V1));
    }
}

constexpr double slope = 0.01;

/// Height slope 4 v (1 - v) x over 0 <= x <= 1, or its mirror image in x = 0. It meets the level
/// along x = 0 at angles up to atan(slope).
BezierPatch bent(double sense) {
  Poles poles(6, 3);
  poles << 0, 0, 0, 0, 0.5, 0, 0, 1, 0, sense, 0, 0, sense, 0.5, 2 * slope * sense, sense, 1, 0;
  return {1, 2, poles};
}

/// Part of the level, x <= 0, with the edge L0 from (0, 0) to (0, 1).
BezierTriangle level() {
  Poles poles(3, 3);
  poles << 0, 1, 0, 0, 0, 0, -1, 0.3, 0;  // P2, P1, P0
  return BezierTriangle(poles);
}

TEST(TriangleSide, AnyEdgeInAnySenseGivesTheSameSeam) {
  for (const std::array<int, 3>& corners :
       {std::array{0, 1, 2}, std::array{1, 2, 0}, std::array{2, 0, 1}, std::array{0, 2, 1},
        std::array{1, 0, 2}, std::array{2, 1, 0}})
    for (const double sense : {1.0, -1.0}) {
      const auto edge = static_cast<TriangleEdge>(std::ranges::find(corners, 0) - corners.begin());
      const bool odd = corners[(static_cast<int>(edge) + 1) % 3] == 2;
      const SeamFigures figures =
          encloseSeam(seamSide(level().elevated().permuted(corners), edge, odd),
                      seamSide(bent(sense), PatchEdge::U0), ContinuityTolerance{});
      EXPECT_LE(figures.gap_mm.value().upper.value(), 1e-11);
      const Figure angle = figures.angle_rad.value();
      EXPECT_LE(angle.lower, std::atan(slope) * (1 + 1e-14));
      EXPECT_GE(angle.upper.value(), std::atan(slope));
      EXPECT_LE(angle.upper.value(), 1.01 * angle.lower);
      EXPECT_EQ(figures.fold_at.has_value(), sense < 0);
      EXPECT_TRUE(figures.certified);
    }
}

TEST(TriangleSide, SidesInOppositeSensesAreApart) {
  const SeamFigures figures =
      encloseSeam(seamSide(level(), TriangleEdge::L0, true), seamSide(bent(1), PatchEdge::U0), {});
  EXPECT_NEAR(figures.gap_mm.value().lower, 1, 1e-11);  // at the ends the edge is 1 mm long
}

TEST(TriangleSide, CurvatureIsThatOfTheTriangle) {
  // The graph z = x^2 / 5 over 0 <= x beside the level: curvature 0.4 across the seam.
  const auto blossom = [](double x1, double y1, double x2, double y2) {
    return Eigen::RowVector3d((x1 + x2) / 2, (y1 + y2) / 2, x1 * x2 / 5);
  };
  Poles poles(6, 3);  // P0 = (2, 1/2), P1 = (0, 1), P2 = (0, 0)
  poles << blossom(0, 0, 0, 0), blossom(0, 0, 0, 1), blossom(0, 1, 0, 1), blossom(0, 0, 2, 0.5),
      blossom(0, 1, 2, 0.5), blossom(2, 0.5, 2, 0.5);
  const SeamFigures figures =
      encloseSeam(seamSide(level(), TriangleEdge::L0),
                  seamSide(BezierTriangle(poles), TriangleEdge::L0, true), {});
  EXPECT_LE(figures.angle_rad.value().upper.value(), 1e-11);
  EXPECT_NEAR(figures.curvature_per_mm.value().lower, 0.4, 1e-8);
  EXPECT_NEAR(figures.curvature_per_mm.value().upper.value(), 0.4, 1e-8);
}

TEST(TriangleSide, ACollapsedCornerIsNamed) {
  // P0 = P1, and the edge between them is this point: no tangent plane there.
  Poles poles(6, 3);
  poles << 0, 1, 0, 0, 0.5, 0, 0, 0, 0, -1, 0.9, 0, 0, 0, 0, 0, 0, 0;
  const SeamFigures figures = encloseSeam(seamSide(BezierTriangle(poles), TriangleEdge::L0),
                                          seamSide(bent(1), PatchEdge::U0), ContinuityTolerance{});
  ASSERT_EQ(figures.degenerate.size(), 1U);
  EXPECT_LT(figures.degenerate[0].at, 1e-6);
  EXPECT_EQ(figures.degenerate[0].side_a, Degeneracy::VanishingNormal);
  EXPECT_TRUE(figures.certified);
  EXPECT_NEAR(figures.angle_rad.value().upper.value(), std::atan(slope), 1e-4);
}

TEST(TriangleSide, ATriangleWithoutAreaIsNotCertified) {
  Poles poles(3, 3);
  poles << 0, 1, 0, 0, 0, 0, 0, 0.3, 0;
  const BezierTriangle flat(poles), point(Poles::Zero(1, 3));
  const SeamFigures line =
      encloseSeam(seamSide(flat, TriangleEdge::L0), seamSide(bent(1), PatchEdge::U0), {});
  EXPECT_FALSE(line.certified);
  EXPECT_LE(line.gap_mm.value().upper.value(), 1e-11);
  EXPECT_FALSE(encloseSeam(seamSide(point, TriangleEdge::L1), seamSide(point, TriangleEdge::L2), {})
                   .certified);
}

TEST(TriangleSide, DegreesBeyondThoseEnclosedAreRefused) {
  const auto ofDegree = [](int degree) {
    return BezierTriangle(Poles::Zero(BezierTriangle::row(degree, degree, 0) + 1, 3));
  };
  EXPECT_NO_THROW(seamSide(ofDegree(25), TriangleEdge::L0));
  try {
    seamSide(ofDegree(26), TriangleEdge::L0);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("degree 26"));
  }
}

TEST(TriangleSide, EdgesHaveNames) {
  EXPECT_EQ(triangleEdgeFromName("l0"), TriangleEdge::L0);
  EXPECT_EQ(triangleEdgeFromName("l1"), TriangleEdge::L1);
  EXPECT_EQ(triangleEdgeFromName("l2"), TriangleEdge::L2);
  EXPECT_EQ(triangleEdgeFromName("u0"), std::nullopt);
}

}  // namespace
}  // namespace seamwright
