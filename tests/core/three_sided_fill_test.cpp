// SPDX-License-Identifier: LGPL-2.1-or-later
// The laws of threeSidedFill(), numbered as there.
#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "support/random.hpp"
#include "three_sided_fills.hpp"

namespace seamwright {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;
using test::Move, test::randomMove, test::reversed;

/// Of sides whose ratio is at most that; their neighbours agree about mixed derivatives in the
/// corners, or not.
class RandomTriangleFill : public testing::TestWithParam<std::tuple<int, double, bool>> {
 protected:
  std::mt19937_64 random_{testSeed()};
  std::vector<FillSide> sides_ = hole();

  std::vector<FillSide> hole() {
    std::vector<FillSide> sides = test::randomHole(3, std::get<1>(GetParam()), random_);
    if (!std::get<2>(GetParam()))
      for (FillSide& side : sides)
        for (int i : {1, 2}) (*side.cross)(i, 2) += test::uniform(-0.5, 0.5, random_);
    return sides;
  }
};

TEST_P(RandomTriangleFill, Law1BoundariesAndSharedPoles) {
  const ThreeSidedFill fill = threeSidedFill(sides_);
  ASSERT_EQ(fill.triangles.size(), 3U);
  for (int k = 0; k < 3; ++k) {
    const BezierTriangle &ours = fill.triangles[k], &before = fill.triangles[(k + 2) % 3];
    EXPECT_EQ(ours.degree(), 5);
    for (int s = 0; s <= 5; ++s) EXPECT_EQ(ours.pole(s, 0), before.pole(0, s));
    for (double t : {0.0, 0.1, 0.4, 0.7, 1.0})
      EXPECT_LT((ours.point(1 - t, t) - sides_[k].edge.point(t)).norm(), 1e-13);
  }
}

TEST_P(RandomTriangleFill, Law2JoinsAreCertified) {
  const ThreeSidedFill fill = threeSidedFill(sides_);
  EXPECT_TRUE(fill.regular);
  for (int k = 0; k < 3; ++k) {
    EXPECT_TRUE(fill.corners[k].exact);
    for (const SeamFigures& figures :
         {test::spokeFigures(fill, k), test::sideFigures(fill, sides_, k)}) {
      EXPECT_TRUE(figures.certified);
      EXPECT_LT(*figures.gap_mm->upper, 1e-10);
      EXPECT_LT(*figures.angle_rad->upper, 1e-9) << k;
      EXPECT_FALSE(figures.fold_at);
    }
  }
}

TEST_P(RandomTriangleFill, Law2NormalsByTheDefinition) {
  const ThreeSidedFill fill = threeSidedFill(sides_);
  for (int k = 0; k < 3; ++k) {
    EXPECT_LT(test::spokeAngle(fill, k), 1e-9) << k;
    EXPECT_LT(test::sideAngle(fill, sides_, k), 1e-9) << k;
  }
}

TEST_P(RandomTriangleFill, LawOfTheSpokesAndConnections) {
  const ThreeSidedFill fill = threeSidedFill(sides_);
  for (int k = 0; k < 3; ++k)
    for (double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
      const SurfaceJet after = fill.triangles[k].jet(t, 0),
                       before = fill.triangles[(k + 2) % 3].jet(0, t);
      EXPECT_LT((before.u + after.u + after.v).norm(), 1e-11 * (before.u.norm() + after.v.norm()));
      const ConnectionFunctions& join = *fill.sides[k];
      const Vector3d beyond = -BezierCurve(*sides_[k].cross).point(t),
                     along = sides_[k].edge.jet(t).d1;
      const Vector3d in = -fill.triangles[k].jet(1 - t, t).u;
      EXPECT_LT(
          (in - test::value(join.alpha, t) * beyond - test::value(join.beta, t) * along).norm(),
          1e-11 * (1 + in.norm()));
      EXPECT_GT(test::value(join.alpha, t), 0);
    }
}

TEST_P(RandomTriangleFill, Law3MotionScaleAndNumbering) {
  const ThreeSidedFill fill = threeSidedFill(sides_);
  for (double scale : {1.0, 1e-3, 1e3}) {
    const Move move = randomMove(scale, random_);
    std::vector<FillSide> moved;
    for (int k = 0; k < 3; ++k) moved.push_back(move(sides_[(k + 1) % 3]));
    const ThreeSidedFill other = threeSidedFill(moved);
    for (int k = 0; k < 3; ++k)
      EXPECT_LT((other.triangles[k].poles() - move.points(fill.triangles[(k + 1) % 3].poles()))
                    .cwiseAbs()
                    .maxCoeff(),
                1e-10 * scale);
    EXPECT_NEAR(other.fairness_mm2, fill.fairness_mm2 * scale * scale,
                1e-9 * fill.fairness_mm2 * scale * scale);
  }
}

TEST_P(RandomTriangleFill, Law3ReversalExchangesCorners) {
  std::vector<FillSide> back;
  for (int k = 0; k < 3; ++k) back.push_back(reversed(sides_[2 - k]));
  const ThreeSidedFill fill = threeSidedFill(sides_), other = threeSidedFill(back);
  for (int k = 0; k < 3; ++k)
    EXPECT_LT(test::difference(other.triangles[k], fill.triangles[2 - k].permuted({1, 0, 2})),
              1e-10);
}

// The fills between this one and another of the same hole, and beyond, are fills of it too.
TEST_P(RandomTriangleFill, Law5NothingIsFairer) {
  for (int position_alone = 0; position_alone <= 3; ++position_alone) {
    std::vector<FillSide> sides = sides_;
    for (int k = 0; k < position_alone; ++k) sides[k].cross.reset();
    for (int order : {2, 3}) {
      const ThreeSidedFill fill = threeSidedFill(sides, {.fairness_order = order}),
                           other = threeSidedFill(sides, {.fairness_order = 5 - order});
      EXPECT_NEAR(fill.fairness_mm2, test::fairness(fill.triangles, order),
                  1e-10 * fill.fairness_mm2);
      const auto between = [&](double share) {
        std::vector<BezierTriangle> triangles;
        for (int k = 0; k < 3; ++k)
          triangles.emplace_back(fill.triangles[k].poles() +
                                 share * (other.triangles[k].poles() - fill.triangles[k].poles()));
        return test::fairness(triangles, order);
      };
      const double before = between(-0.5) - fill.fairness_mm2,
                   after = between(0.5) - fill.fairness_mm2;
      EXPECT_GT(after, 0);
      EXPECT_NEAR(before, after, 1e-7 * fill.fairness_mm2);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Holes, RandomTriangleFill,
                         testing::Combine(testing::Range(1, 7), testing::Values(1.0, 50.0),
                                          testing::Bool()),
                         [](const auto& hole) {
                           return std::to_string(std::get<0>(hole.param)) +
                                  (std::get<1>(hole.param) > 1 ? "short" : "even") +
                                  (std::get<2>(hole.param) ? "" : "twisted");
                         });

TEST(ThreeSidedFill, Law4ASymmetricHoleHasASymmetricFill) {
  const ThreeSidedFill fill =
      threeSidedFill(test::graphHole(test::sphere(20), test::polygon(3, 10)));
  const double angle = 2 * std::numbers::pi / 3;
  const Move turn{Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix()};
  for (int k = 0; k < 3; ++k) {
    const BezierTriangle &ours = fill.triangles[k], &next = fill.triangles[(k + 1) % 3];
    EXPECT_LT((next.poles() - turn.points(ours.poles())).cwiseAbs().maxCoeff(), 1e-12);
    // The mirror through the z axis and the middle of side k exchanges P0 and P1.
    const Vector3d normal =
        Eigen::AngleAxisd(angle * (k + 1), Vector3d::UnitZ()) * Vector3d::UnitY();
    const Move mirror{Matrix3d::Identity() - 2 * normal * normal.transpose()};
    EXPECT_LT(
        (ours.permuted({1, 0, 2}).poles() - mirror.points(ours.poles())).cwiseAbs().maxCoeff(),
        1e-12);
  }
}

TEST(ThreeSidedFill, MovedPoleIsSeen) {
  std::mt19937_64 random(testSeed());
  const std::vector<FillSide> sides = test::randomHole(3, 1, random);
  const ThreeSidedFill fill = threeSidedFill(sides);
  const auto moved = [&](int i, int j) {
    ThreeSidedFill bad = fill;
    Poles poles = bad.triangles[0].poles();
    poles(BezierTriangle::row(5, i, j), 2) += 1e-6;
    bad.triangles[0] = BezierTriangle(poles);
    return bad;
  };
  EXPECT_GT(test::spokeAngle(moved(2, 1), 0), 1e-8);
  EXPECT_GT(test::spokeFigures(moved(2, 1), 0).angle_rad->lower, 1e-8);
  EXPECT_GT(test::spokeAngle(moved(1, 2), 1), 1e-8);
  EXPECT_GT(test::sideAngle(moved(2, 2), sides, 0), 1e-8);
  EXPECT_GT(test::sideFigures(moved(2, 2), sides, 0).angle_rad->lower, 1e-8);
}

// Corners where no tensor-product patch can meet both neighbours.
TEST(ThreeSidedFill, NeighboursNeedNotAgreeAboutTheTwist) {
  std::mt19937_64 random(testSeed());
  std::vector<FillSide> sides = test::randomHole(3, 1, random);
  (*sides[1].cross)(1, 2) += 1;
  EXPECT_FALSE(nSidedFill(sides).corners[1].exact);
  const ThreeSidedFill fill = threeSidedFill(sides);
  EXPECT_TRUE(fill.corners[1].exact);
  EXPECT_EQ(fill.corners[1].angle_bound_rad, 0);
  EXPECT_LT(test::sideAngle(fill, sides, 1), 1e-9);
  EXPECT_LT(test::sideAngle(fill, sides, 0), 1e-9);
  EXPECT_LT(test::spokeAngle(fill, 1), 1e-9);
}

TEST(ThreeSidedFill, SidesOfPositionAlone) {
  for (int seed = 1; seed <= 4; ++seed) {
    std::mt19937_64 random(testSeed(seed));
    std::vector<FillSide> sides = test::randomHole(3, 1, random);
    double last = threeSidedFill(sides).fairness_mm2;
    for (int free = 0; free < 3; ++free) {
      sides[free].cross.reset();
      const ThreeSidedFill fill = threeSidedFill(sides);
      EXPECT_EQ(fill.triangles[0].degree(), free == 2 ? 3 : 5);
      if (free < 2) {
        EXPECT_LE(fill.fairness_mm2, last * (1 + 1e-9));
        last = fill.fairness_mm2;
      }
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(fill.sides[k].has_value(), k > free);
        EXPECT_TRUE(fill.corners[k].exact);
        EXPECT_LT(test::spokeAngle(fill, k), 1e-9);
        EXPECT_LT((fill.triangles[k].point(0.3, 0.7) - sides[k].edge.point(0.7)).norm(), 1e-13);
        if (k > free) {
          EXPECT_LT(test::sideAngle(fill, sides, k), 1e-9);
        }
      }
    }
  }
}

}  // namespace
}  // namespace seamwright
