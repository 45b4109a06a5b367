// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <seamwright/core/seam/judge.hpp>
#include <seamwright/core/seam/patch_side.hpp>

namespace seamwright {
namespace {

constexpr double slope = 0.01;

/// Height slope 4 v (1 - v) (x + x^2 / 4) over 0 <= x <= 1, or its mirror image in x = 0; it meets
/// the level along x = 0. There its angle is atan(slope 4 v (1 - v)), largest, atan(slope), at v =
/// 1/2.
BezierPatch bent(double sense) {
  Poles poles(9, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double height = j == 1 ? 2 * slope * (i == 0 ? 0 : i == 1 ? 0.5 : 1.25) : 0;
      poles.row(3L * i + j) << sense * 0.5 * i, 0.5 * j, height;
    }
  return {2, 2, poles};
}

/// The level over -1 <= x <= 0, with its boundary x = 0 at u = 0.
BezierPatch level() {
  Poles poles(4, 3);
  poles << 0, 0, 0, 0, 1, 0, -1, 0, 0, -1, 1, 0;
  return {1, 1, poles};
}

constexpr std::array edges = {PatchEdge::U0, PatchEdge::U1, PatchEdge::V0, PatchEdge::V1};

/// The same patch with its boundary u = 0 as that edge; the parameter along the edge stays.
BezierPatch turned(const BezierPatch& patch, PatchEdge edge) {
  const bool at_end = edge == PatchEdge::U1 || edge == PatchEdge::V1;
  const BezierPatch moved = at_end ? patch.reversedU() : patch;
  return edge == PatchEdge::V0 || edge == PatchEdge::V1 ? moved.transposed() : moved;
}

TEST(PatchSide, AnyEdgeInAnySenseGivesTheSameSeam) {
  const ContinuityTolerance tolerance;
  for (const PatchEdge a : edges)
    for (const PatchEdge b : edges)
      for (const bool reversed : {false, true}) {
        const SeamFigures figures =
            encloseSeam(seamSide(turned(level(), a), a, reversed),
                        seamSide(turned(bent(1), b), b, reversed), tolerance);
        EXPECT_LE(figures.gap_mm.value().upper.value(), 1e-11);
        const Figure angle = figures.angle_rad.value();
        EXPECT_LE(angle.lower, std::atan(slope) * (1 + 1e-14));
        EXPECT_GE(angle.upper.value(), std::atan(slope));
        EXPECT_LE(angle.upper.value(), 1.01 * angle.lower);
        EXPECT_FALSE(figures.fold_at);
        EXPECT_TRUE(figures.certified);
      }
}

TEST(PatchSide, SidesInOppositeSensesAreApart) {
  const SeamFigures figures =
      encloseSeam(seamSide(level(), PatchEdge::U0, false), seamSide(bent(1), PatchEdge::U0, true),
                  ContinuityTolerance{});
  EXPECT_NEAR(figures.gap_mm.value().lower, 1, 1e-11);  // at the ends the edge is 1 mm long
}

TEST(PatchSide, AFaceThatTurnsBackIsAFoldAtAnyEdge) {
  for (const PatchEdge a : edges)
    for (const PatchEdge b : edges) {
      const SeamFigures figures =
          encloseSeam(seamSide(turned(level(), a), a), seamSide(turned(bent(-1), b), b), {});
      EXPECT_TRUE(figures.fold_at);
    }
}

TEST(PatchSide, WeightsAreRespected) {
  // A quarter of a cylinder of radius 2 about the y axis, from the top on, beside the level at
  // height 2.
  Poles arc(6, 3);
  arc << 0, 0, 2, 0, 1, 2, 2, 0, 2, 2, 1, 2, 2, 0, 0, 2, 1, 0;
  Eigen::VectorXd weights(6);
  weights << 1, 1, std::sqrt(0.5), std::sqrt(0.5), 1, 1;
  Poles flat(4, 3);
  flat << -1, 0, 2, -1, 1, 2, 0, 0, 2, 0, 1, 2;
  const SeamFigures figures =
      encloseSeam(seamSide(BezierPatch(1, 1, flat), PatchEdge::U1),
                  seamSide(BezierPatch(2, 1, arc, weights), PatchEdge::U0), {});
  EXPECT_LE(figures.angle_rad.value().upper.value(), 1e-11);
  EXPECT_NEAR(figures.curvature_per_mm.value().lower, 0.5, 1e-7);
  EXPECT_NEAR(figures.curvature_per_mm.value().upper.value(), 0.5, 1e-7);
}

TEST(PatchSide, EdgesHaveNames) {
  EXPECT_EQ(patchEdgeFromName("u0"), PatchEdge::U0);
  EXPECT_EQ(patchEdgeFromName("u1"), PatchEdge::U1);
  EXPECT_EQ(patchEdgeFromName("v0"), PatchEdge::V0);
  EXPECT_EQ(patchEdgeFromName("v1"), PatchEdge::V1);
  EXPECT_EQ(patchEdgeFromName("w0"), std::nullopt);
}

}  // namespace
}  // namespace seamwright
