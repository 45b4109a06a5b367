// SPDX-License-Identifier: LGPL-2.1-or-later
// Round holes, lenses and others with smooth and reflex corners, in surfaces that are known.
#include <gmock/gmock.h>

#include <Eigen/Geometry>

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

// Identity (3): the number of the first side, motion and scale.
TEST_P(RingFillOf, MovesLikeTheHole) {
  const Bowl bowl{0.06, -0.04};
  const std::vector<FillSide> sides = test::lifted(shape_.plan, bowl);
  const RingFill plain = ringFill(sides);
  const RingFill renumbered = ringFill({sides[1], sides[2], sides[3], sides[0]});
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
  }
  const RingFill image = ringFill(moved);
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

INSTANTIATE_TEST_SUITE_P(Shapes, RingFillOf, testing::Range(0, 6));

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
