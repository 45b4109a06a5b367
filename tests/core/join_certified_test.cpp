// SPDX-License-Identifier: LGPL-2.1-or-later
// Constructed joins certified by enclosures.
#include <gtest/gtest.h>

#include <seamwright/core/seam/patch_side.hpp>
#include <seamwright/core/seam/triangle_side.hpp>

#include "joins.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using test::built;
using test::gentlePatch;
using test::gentleTriangle;
using test::whole;
using testing::Message;

/// Certified angles are below 1e-10 rad and relative differences of curvature below 1e-9, for order
/// 3 those of curvature and its change below 1e-7. Where a
/// random patch comes near to losing its tangent plane rounding counts for more: then up to thirty
/// times as much, which is counted.
class Certifier {
 public:
  void expectJoined(const SeamSide& a, const SeamSide& b, int order, const Message& what) {
    ContinuityTolerance tolerance;
    tolerance.gap_mm = 1e-9;
    tolerance.angle_rad = 1e-10;
    tolerance.curvature_rel = order == 3 ? 1e-7 : 1e-9;
    const SeamFigures figures =
        encloseSeam(a, b, tolerance, {.figures = false, .curvature_change = order == 3});
    ASSERT_TRUE(figures.certified) << what << figures.uncertified;
    EXPECT_FALSE(figures.fold_at) << what;
    EXPECT_LE(*figures.gap_mm->upper, tolerance.gap_mm) << what;
    EXPECT_LE(*figures.angle_rad->upper, 30 * tolerance.angle_rad) << what;
    bool fine = *figures.angle_rad->upper <= tolerance.angle_rad;
    if (order >= 2) {
      EXPECT_LE(*figures.curvature_rel->upper, 30 * tolerance.curvature_rel) << what;
      fine = fine && *figures.curvature_rel->upper <= tolerance.curvature_rel;
    }
    if (order == 3) {
      EXPECT_LE(*figures.curvature_change_rel->upper, 30 * tolerance.curvature_rel) << what;
      fine = fine && *figures.curvature_change_rel->upper <= tolerance.curvature_rel;
    }
    ++(fine ? fine_ : coarse_);
  }

  ~Certifier() { EXPECT_LE(50 * coarse_, fine_) << "joins that are certified less sharply"; }

 private:
  int fine_ = 0;
  int coarse_ = 0;
};

TEST(JoinCertified, Identity2ContinuationsOfTensorPatches) {
  std::mt19937_64 random(testSeed());
  int joined = 0;
  Certifier certifier;
  for (int run = 0; run < 1500; ++run) {
    const bool rational = run % 8 >= 6;
    const int m = whole(2, 7, random), n = whole(2, 7, random), order = whole(1, 3, random),
              k = whole(0, 2, random);
    const BezierPatch patch = gentlePatch(m, n, rational, random);
    const PatchEdge edge = test::patch_edges[run % 4];
    const bool reversed = run % 8 < 4;
    const ConnectionFunctions c = test::randomConnection(k, whole(0, k + 1, random), random);
    const int l = whole(order, 6, random);
    const auto next = built(
        [&] { return continuation(ribbon(patch, edge, reversed, Across::OutOf), c, order, l); });
    if (!next) continue;
    ++joined;
    certifier.expectJoined(seamSide(patch, edge, reversed), seamSide(*next, PatchEdge::U0), order,
                           Message() << "run " << run << " m " << m << " n " << n << " to "
                                     << next->degreeU() << " " << next->degreeV()
                                     << (rational ? " rational: " : ": "));
  }
  EXPECT_GT(joined, 750);
}

TEST(JoinCertified, Identity2TrianglesAndPatches) {
  std::mt19937_64 random(testSeed());
  Certifier certifier;
  for (int run = 0; run < 600; ++run) {
    const int n = whole(1, 4, random), k = whole(0, 1, random);
    const ConnectionFunctions c = test::randomConnection(k, whole(0, k + 1, random), random);
    const TriangleEdge edge = test::triangle_edges[run % 3];
    const bool reversed = run % 2 == 0, tensor = run % 3 == 0;
    const BezierTriangle triangle = gentleTriangle(n, false, random);
    const BezierPatch patch = gentlePatch(n, n, false, random);
    const PatchEdge patch_edge = test::patch_edges[run % 4];
    const Ribbon given = tensor ? ribbon(patch, patch_edge, reversed, Across::OutOf)
                                : ribbon(triangle, edge, reversed, Across::OutOf);
    const SeamSide side =
        tensor ? seamSide(patch, patch_edge, reversed) : seamSide(triangle, edge, reversed);
    if (tensor || run % 3 == 1) {
      const int order = whole(1, 3, random);
      const BezierTriangle next = triangleContinuation(given, c, order);
      certifier.expectJoined(side, seamSide(next, TriangleEdge::L0), order,
                             Message() << "run " << run << " to triangle: ");
    } else {
      const int order = whole(1, 3, random);
      const BezierPatch next = continuation(given, c, order, 4);
      certifier.expectJoined(side, seamSide(next, PatchEdge::U0), order,
                             Message() << "run " << run << " to patch: ");
    }
  }
}

TEST(JoinCertified, BlendsMeetBoth) {
  std::mt19937_64 random(testSeed());
  int blends = 0;
  Certifier certifier;
  for (int run = 0; run < 300; ++run) {
    const int order = run % 3 + 1, n = whole(1, 3, random);
    const BezierPatch first = gentlePatch(2, n, run % 5 == 0, random);
    Poles away = gentlePatch(3, 2, false, random).poles();
    away.col(0).array() += 20;
    const BezierPatch second(3, 2, away);
    const ConnectionFunctions to_first = test::randomConnection(0, 1, random),
                              to_second = test::randomConnection(1, 1, random);
    const auto between = built([&] {
      return blend(ribbon(first, PatchEdge::U1, false, Across::OutOf), to_first,
                   ribbon(second, PatchEdge::U0, false, Across::OutOf), to_second, order);
    });
    if (!between) continue;
    ++blends;
    EXPECT_EQ(between->degreeU(), 2 * order + 1);
    certifier.expectJoined(seamSide(first, PatchEdge::U1), seamSide(*between, PatchEdge::U0), order,
                           Message() << run << " first ");
    certifier.expectJoined(seamSide(*between, PatchEdge::U1), seamSide(second, PatchEdge::U0),
                           order, Message() << run << " second ");
  }
  EXPECT_GT(blends, 150);
}

TEST(JoinCertified, OneMovedPoleIsSeen) {
  std::mt19937_64 random(testSeed());
  for (int row = 0; row < 3; ++row) {
    const BezierPatch patch = gentlePatch(3, 3, false, random);
    const BezierPatch next =
        continuation(ribbon(patch, PatchEdge::U1, false, Across::OutOf), {}, 2, 3);
    Poles poles = next.poles();
    poles(4L * row + 1, 2) += 1e-5;
    ContinuityTolerance tolerance;
    tolerance.gap_mm = 1e-9;
    tolerance.angle_rad = 1e-8;
    tolerance.curvature_rel = 1e-7;
    const SeamFigures figures =
        encloseSeam(seamSide(patch, PatchEdge::U1),
                    seamSide(BezierPatch(3, 3, poles), PatchEdge::U0), tolerance);
    EXPECT_EQ(figures.gap_mm->lower > tolerance.gap_mm, row == 0);
    EXPECT_EQ(figures.angle_rad->lower > tolerance.angle_rad, row <= 1);
    EXPECT_GT(figures.curvature_rel->lower, tolerance.curvature_rel);
  }
}

}  // namespace
}  // namespace seamwright
