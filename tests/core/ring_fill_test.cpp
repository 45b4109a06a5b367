// SPDX-License-Identifier: LGPL-2.1-or-later
// Round holes, lenses and others with smooth and reflex corners, in surfaces that are known.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <seamwright/core/differential/fundamental_forms.hpp>

#include "ring_holes.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using Eigen::Vector3d;
using test::Bowl;
using testing::HasSubstr, testing::ThrowsMessage;

/// Largest distance in height.
double error(const std::vector<BezierPatch>& patches, const Bowl& bowl) {
  double worst = 0;
  for (const BezierPatch& patch : patches)
    for (int i = 0; i <= 8; ++i)
      for (int j = 0; j <= 8; ++j) {
        const Vector3d point = patch.point(i / 8.0, j / 8.0);
        worst = std::max(worst, std::abs(point.z() - bowl.heightAt(point.x(), point.y())));
      }
  return worst;
}

/// The largest difference of the curvature tensors of both patches at points of the inner edges.
double largestTensorJump_per_mm(const RingFill& fill) {
  const auto tensor = [&](int patch, double u, double v) {
    const SurfaceJet jet = fill.patches[patch].jet(u, v);
    return curvatureTensor(jet, *unitNormal(jet));
  };
  double worst = 0;
  for (int k = 0; k < 4; ++k)
    for (const double t : {0.0, 0.13, 0.5, 0.77, 1.0}) {
      const std::array<std::array<double, 2>, 4> middle = {
          {{t, 0}, {1, t}, {1 - t, 1}, {0, 1 - t}}};
      const Eigen::Matrix3d spoke = tensor(k, t, 0) - tensor((k + 3) % 4, t, 1),
                            inner = tensor(k, 0, t) - tensor(4, middle[k][0], middle[k][1]);
      worst = std::max({worst, spoke.cwiseAbs().maxCoeff(), inner.cwiseAbs().maxCoeff()});
    }
  return worst;
}

struct Bending {
  double energy = 0, largest_per_mm = 0;
};

/// The integral of k1^2 + k2^2, and the largest curvature, on a grid.
Bending bendingOf(const RingFill& fill) {
  constexpr int cells = 20;
  Bending bending;
  for (const BezierPatch& patch : fill.patches)
    for (int i = 0; i <= cells; ++i)
      for (int j = 0; j <= cells; ++j) {
        const SurfaceJet jet = patch.jet(1.0 * i / cells, 1.0 * j / cells);
        const Eigen::Matrix3d tensor = curvatureTensor(jet, *unitNormal(jet));
        bending.energy += tensor.squaredNorm() * jet.u.cross(jet.v).norm() / (cells * cells);
        bending.largest_per_mm = std::max(bending.largest_per_mm, tensor.norm());
      }
  return bending;
}

struct Shape {
  const char* name;
  std::vector<Poles> plan;
  double worst_mm;  ///< distance of a fill from the bowl
};

std::vector<Shape> shapes() {
  return {
      {"circle", test::ovalPlan(10, 10), 0.3}, {"ellipse", test::ovalPlan(10, 4), 0.75},
      {"lens", test::lensPlan(8, 0.5), 0.3},   {"lens cut unevenly", test::lensPlan(8, 0.35), 0.3},
      {"drop", test::dropPlan(), 0.25},        {"arrow", test::arrowPlan(), 0.7}};
}

/// The number of the first side, motion and scale.
void expectMovesLikeTheHole(const std::vector<FillSide>& sides, const RingFillOptions& options) {
  const RingFill plain = ringFill(sides, options);
  const RingFill renumbered = ringFill({sides[1], sides[2], sides[3], sides[0]}, options);
  std::mt19937_64 random(testSeed());
  const Eigen::Matrix3d motion =
      3 *
      Eigen::Quaterniond(1, test::uniform(-3, 3, random), -2, 3).normalized().toRotationMatrix();
  const Eigen::RowVector3d shift(test::uniform(-50, 50, random), 20, -7);
  std::vector<FillSide> moved = sides;
  for (FillSide& side : moved) {
    Poles edge = (side.edge.poles() * motion.transpose()).eval();
    edge.rowwise() += shift;
    side.edge = BezierCurve(edge);
    side.cross = Poles((*side.cross * motion.transpose()).eval());
    side.bend = Poles((*side.bend * motion.transpose()).eval());
  }
  const RingFill image = ringFill(moved, options);
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; j <= 4; ++j) {
      const double u = i / 4.0, v = j / 4.0;
      for (int k = 0; k < 4; ++k)
        EXPECT_LT(
            (renumbered.patches[k].point(u, v) - plain.patches[(k + 1) % 4].point(u, v)).norm(),
            1e-8);
      EXPECT_LT((renumbered.patches[4].point(u, v) - plain.patches[4].point(1 - v, u)).norm(),
                1e-8);
      for (int k = 0; k < 5; ++k) {
        const Vector3d expected = motion * plain.patches[k].point(u, v) + shift.transpose();
        EXPECT_LT((image.patches[k].point(u, v) - expected).norm(), 1e-7);
      }
    }
}

class RingFillOf : public testing::TestWithParam<int> {
 protected:
  Shape shape_ = shapes()[GetParam()];
};

// Identities (1) and (2).
TEST_P(RingFillOf, MeetsItsSidesAndItself) {
  for (const Bowl& bowl : {Bowl{-0.05, -0.05}, Bowl{0.06, -0.04}}) {
    const std::vector<FillSide> sides = test::lifted(shape_.plan, bowl);
    const RingFill fill = ringFill(sides);
    ASSERT_EQ(fill.patches.size(), 5U);
    EXPECT_TRUE(fill.regular);
    const int n = fill.patches[0].degreeU();
    for (int k = 0; k < 4; ++k) {
      for (int s = 0; s <= 10; ++s)
        EXPECT_LT((fill.patches[k].point(1, s / 10.0) - sides[k].edge.point(s / 10.0)).norm(),
                  1e-13 * 20);
      for (int s = 0; s <= n; ++s)
        EXPECT_EQ(fill.patches[k].pole(s, n), fill.patches[(k + 1) % 4].pole(s, 0));
    }
    for (int s = 0; s <= n; ++s) {
      EXPECT_EQ(fill.patches[4].pole(s, 0), fill.patches[0].pole(0, s));
      EXPECT_EQ(fill.patches[4].pole(n, s), fill.patches[1].pole(0, s));
      EXPECT_EQ(fill.patches[4].pole(n - s, n), fill.patches[2].pole(0, s));
      EXPECT_EQ(fill.patches[4].pole(0, n - s), fill.patches[3].pole(0, s));
    }
    EXPECT_LT(test::largestAngle_rad(test::ringSeams(fill, test::fine())), 1e-9);
    EXPECT_LT(test::largestAngle_rad(test::ringSideSeams(fill, sides, test::fine())), 1e-9);
    for (const FillCorner& corner : fill.corners) EXPECT_TRUE(corner.exact);
    EXPECT_LT(error(fill.patches, bowl), shape_.worst_mm) << shape_.name;
  }
}

// Identity (3).
TEST_P(RingFillOf, MovesLikeTheHole) {
  expectMovesLikeTheHole(test::lifted(shape_.plan, {0.06, -0.04}), {});
}

// Identity (4).
TEST_P(RingFillOf, PlanarSidesHaveAPlanarFill) {
  std::vector<FillSide> sides = test::lifted(shape_.plan, {});
  EXPECT_LT(error(ringFill(sides).patches, {}), 1e-12);
  for (FillSide& side : sides) side.cross.reset();
  const RingFill position_only = ringFill(sides);
  EXPECT_LT(error(position_only.patches, {}), 1e-12);
  EXPECT_LT(test::largestAngle_rad(test::ringSeams(position_only, test::fine())), 1e-9);
}

// The largest jump found at places is within the enclosures, which are far below those of the fill
// that asks for G1 alone.
TEST_P(RingFillOf, CurvatureJumpsAreMadeSmall) {
  const Bowl bowl{-0.06, -0.04};
  const std::vector<FillSide> sides = test::lifted(shape_.plan, bowl);
  const RingFill plain = ringFill(sides), curved = ringFill(sides, {.curvature_degrees = 0});
  ContinuityTolerance tolerance = test::fine();
  const auto jump = [&](const RingFill& fill) {
    return std::max(test::largestCurvature_per_mm(test::ringSeams(fill, tolerance)),
                    test::largestCurvature_per_mm(test::ringSideSeams(fill, sides, tolerance)));
  };
  EXPECT_LT(test::largestAngle_rad(test::ringSeams(curved, tolerance)), 1e-9);
  EXPECT_LT(test::largestAngle_rad(test::ringSideSeams(curved, sides, tolerance)), 1e-9);
  ASSERT_TRUE(curved.curvature_jump_per_mm.has_value());
  EXPECT_LE(*curved.curvature_jump_per_mm, jump(curved) * (1 + 1e-6) + 1e-9);
  EXPECT_LT(jump(curved), 0.5 * jump(plain)) << shape_.name;
  EXPECT_LT(error(curved.patches, bowl), 1.2 * error(plain.patches, bowl) + 1e-3) << shape_.name;
}

// Identity (5), by enclosures and by the curvature tensors of the patches in points.
TEST_P(RingFillOf, MeetsItselfWithG2) {
  for (const std::optional<int> degrees : {std::optional<int>(), std::optional(0)}) {
    const Bowl bowl = degrees ? Bowl{0.06, -0.04} : Bowl{-0.05, -0.05};
    const std::vector<FillSide> sides = test::lifted(shape_.plan, bowl);
    const RingFill fill = ringFill(sides, {.law = SpokeLaw::G2, .curvature_degrees = degrees});
    EXPECT_TRUE(fill.regular);
    EXPECT_EQ(fill.patches[0].degreeU(), ringFill(sides).patches[0].degreeU());
    const std::vector<SeamFigures> seams = test::ringSeams(fill, test::fine());
    EXPECT_LT(test::largestAngle_rad(seams), 1e-9);
    EXPECT_LT(test::largestCurvature_per_mm(seams), 1e-7) << shape_.name;
    EXPECT_LT(test::largestAngle_rad(test::ringSideSeams(fill, sides, test::fine())), 1e-9);
    EXPECT_LT(largestTensorJump_per_mm(fill), 1e-7) << shape_.name;
    EXPECT_LT(*fill.spoke_jump_per_mm, 1e-10);
    EXPECT_LT(error(fill.patches, bowl), 1.3 * shape_.worst_mm) << shape_.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, RingFillOf, testing::Range(0, 6));

TEST(RingFill, WithG2MovesLikeTheHole) {
  expectMovesLikeTheHole(test::lifted(test::lensPlan(8, 0.35), {0.06, -0.04}),
                         {.law = SpokeLaw::G2});
}

// Against the same fill without G2 inside: the surface does not pay for it.
TEST(RingFill, IsAsFairWithG2) {
  for (const std::vector<Poles>& plan :
       {test::ovalPlan(10, 10), test::ovalPlan(10, 4), test::lensPlan(8, 0.5)}) {
    const std::vector<FillSide> sides = test::lifted(plan, {-0.06, -0.04});
    const Bending plain = bendingOf(ringFill(sides, {.curvature_degrees = 0})),
                  curved =
                      bendingOf(ringFill(sides, {.law = SpokeLaw::G2, .curvature_degrees = 0}));
    EXPECT_LT(curved.energy, plain.energy);
    EXPECT_LT(curved.largest_per_mm, 1.1 * plain.largest_per_mm);
  }
}

// What the neighbours of a corner disagree about is left at that corner alone, and the tangent
// planes are met all the same.
TEST(RingFill, WithG2ContradictionsOfNeighboursStayAtTheirCorner) {
  std::vector<FillSide> sides = test::lifted(test::arrowPlan(), {-0.05, -0.05});
  sides[2].cross->row(1).z() += 0.5;  // beside corner 2
  const RingFill fill = ringFill(sides, {.law = SpokeLaw::G2});
  EXPECT_TRUE(fill.corners[2].exact);
  EXPECT_GT(*fill.spoke_jump_per_mm, 1e-3);
  const std::vector<SeamFigures> seams = test::ringSeams(fill, test::fine());
  EXPECT_LT(test::largestAngle_rad(seams), 1e-9);
  EXPECT_LT(test::largestAngle_rad(test::ringSideSeams(fill, sides, test::fine())), 1e-9);
  for (int s = 0; s < 8; ++s) {
    if (s == 4) continue;  // the spoke to corner 2
    EXPECT_LT(*seams[s].curvature_per_mm->upper, 1e-7) << s;
  }
  EXPECT_NEAR(seams[4].curvature_per_mm->lower, *fill.spoke_jump_per_mm,
              0.05 * *fill.spoke_jump_per_mm);
}

TEST(RingFill, WithG2SidesMayHavePositionAlone) {
  for (const auto& free : {std::vector<int>{0}, {0, 1}, {0, 1, 2, 3}}) {
    std::vector<FillSide> sides = test::lifted(test::lensPlan(8, 0.5), {-0.05, -0.05});
    for (const int k : free) sides[k].cross.reset();
    const RingFill fill = ringFill(sides, {.law = SpokeLaw::G2});
    EXPECT_TRUE(fill.regular);
    const std::vector<SeamFigures> seams = test::ringSeams(fill, test::fine());
    EXPECT_LT(test::largestAngle_rad(seams), 1e-9);
    EXPECT_LT(test::largestCurvature_per_mm(seams), 1e-7);
  }
}

// The functions c and d of a spoke are nearly constant here. Some equations then nearly follow from
// others, in every amount.
TEST(RingFill, NearlyEqualSidesDoNotContradictEachOther) {
  for (const double share : {1e-2, 1e-5, 1e-8, 1e-10}) {
    std::vector<Poles> plan = test::ovalPlan(10, 10);
    plan[0].row(2) += share * (plan[0].row(2) - plan[0].row(3)).eval();
    plan[2].row(1) -= share * (plan[2].row(1) - plan[2].row(0)).eval();
    const std::vector<FillSide> sides = test::lifted(plan, {-0.06, -0.04});
    for (const SpokeLaw law : {SpokeLaw::Linear, SpokeLaw::G2}) {
      const std::vector<SeamFigures> seams =
          test::ringSeams(ringFill(sides, {.law = law}), test::fine());
      EXPECT_LT(test::largestAngle_rad(seams), 1e-9) << share;
      if (law == SpokeLaw::G2) {
        EXPECT_LT(test::largestCurvature_per_mm(seams), 1e-7) << share;
      }
    }
  }
}

// A twist defect in a smooth corner: the fields of its sides differ in their normal slope.
TEST(RingFill, ASmoothCornerBetweenDifferentNeighboursIsBounded) {
  const Bowl bowl{-0.05, -0.05};
  std::vector<FillSide> sides = test::lifted(test::ovalPlan(10, 10), bowl);
  sides[1].cross->row(1).z() += 0.4;
  const RingFill fill = ringFill(sides);
  EXPECT_FALSE(fill.corners[1].exact);
  EXPECT_TRUE(fill.corners[3].exact);
  EXPECT_GT(std::abs(fill.corners[1].twist_defect_mm), 0.1);
  EXPECT_LT(test::largestAngle_rad(test::ringSeams(fill, test::fine())), 1e-9);
  const std::vector<SeamFigures> seams = test::ringSideSeams(fill, sides, test::fine());
  for (const int k : {0, 1}) {
    EXPECT_GT(seams[k].angle_rad->lower, 1e-4);
    EXPECT_LE(*seams[k].angle_rad->upper, fill.corners[1].angle_bound_rad * (1 + 1e-9));
  }
  for (const int k : {2, 3}) EXPECT_LT(*seams[k].angle_rad->upper, 1e-9);
}

TEST(RingFill, RefusesWhatItCantFill) {
  const std::vector<FillSide> sides = test::lifted(test::ovalPlan(10, 10), {});
  const auto refused = [](const std::vector<FillSide>& of, const std::string& text,
                          RingFillOptions options = {}) {
    EXPECT_THAT([&] { ringFill(of, options); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
  };
  refused({sides[0], sides[1], sides[2]}, "3 sides: a ring fill has 4");
  refused(sides, "no quadratic law", {.law = SpokeLaw::Quadratic});
  refused(sides, "fairness order 1", {.fairness_order = 1});
  refused(sides, "corner tolerance", {.corner_tolerance_rad = std::nan("")});
  refused(sides, "curvature degrees 7", {.curvature_degrees = 7});
  std::vector<FillSide> bent = sides;
  Poles poles = bent[0].edge.poles();
  poles(1, 0) += 0.005;
  bent[0].edge = BezierCurve(poles);
  refused(bent, "corner 0: the angle of the hole is 180.1");
  std::vector<FillSide> unknown = sides;
  (*unknown[2].bend)(1, 2) = std::nan("");
  refused(unknown, "side 2: coefficient 1 of the second derivative is nan");
}

}  // namespace
}  // namespace seamwright
