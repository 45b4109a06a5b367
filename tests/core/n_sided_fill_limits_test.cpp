// SPDX-License-Identifier: LGPL-2.1-or-later
// What nSidedFill() refuses, and how it says so; provedRegular().
#include <gmock/gmock.h>

#include <seamwright/core/fill/regular.hpp>

#include "fills.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using testing::AllOf, testing::HasSubstr, testing::ThrowsMessage;

std::vector<FillSide> square() {
  return test::graphHole(test::plane(), test::polygon(4, 10));
}

template <class Matcher>
void expectRefused(const std::vector<FillSide>& sides, const Matcher& message,
                   FillOptions options = {}) {
  EXPECT_THAT([&] { nSidedFill(sides, options); }, ThrowsMessage<std::invalid_argument>(message));
}

TEST(NSidedFillLimits, RefusesFewerThan3AndMoreThan12Sides) {
  std::vector<FillSide> sides = square();
  sides.resize(2, sides[0]);
  expectRefused(sides, HasSubstr("2 sides: a fill has 3 to 12"));
  sides.resize(13, sides[0]);
  expectRefused(sides, HasSubstr("13 sides"));
  expectRefused({}, HasSubstr("0 sides"));
}

TEST(NSidedFillLimits, RefusesBadOptions) {
  expectRefused(square(), HasSubstr("fairness order 4"), {.fairness_order = 4});
  for (double bad : {-1e-3, 0.2, std::numeric_limits<double>::quiet_NaN()})
    expectRefused(square(), HasSubstr("corner tolerance"), {.corner_tolerance_rad = bad});
}

TEST(NSidedFillLimits, RefusesBadEdges) {
  std::vector<FillSide> sides = square();
  const Poles poles = sides[1].edge.poles();
  sides[1].edge = BezierCurve(poles, Eigen::VectorXd::LinSpaced(6, 1, 2));
  expectRefused(sides, HasSubstr("side 1: the edge is rational"));
  sides[1].edge = BezierCurve(Poles(poles.topRows(1)));
  expectRefused(sides, HasSubstr("side 1: the edge has degree 0"));
  Poles away = poles;
  away(0, 2) += 0.25;
  sides[1].edge = BezierCurve(away);
  expectRefused(sides, HasSubstr("side 1 begins 0.25 mm from where side 0 ends"));
  Poles still = poles;
  still.row(1) = still.row(0);
  sides[1].edge = BezierCurve(still);
  expectRefused(sides, HasSubstr("side 1: the edge has no tangent"));
}

TEST(NSidedFillLimits, RefusesBadCrossBoundaryDerivatives) {
  for (double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    std::vector<FillSide> sides = square();
    (*sides[2].cross)(3, 1) = bad;
    expectRefused(sides, HasSubstr("side 2: coefficient 3 of the cross-boundary derivative is " +
                                   std::string(bad > 0 ? "inf" : "")));
  }
  std::vector<FillSide> sides = square();
  sides[2].cross = Poles(0, 3);
  expectRefused(sides, HasSubstr("side 2: the cross-boundary derivative has degree -1"));
  sides[2].cross = Poles::Zero(20, 3);
  expectRefused(sides, HasSubstr("side 2: the cross-boundary derivative has degree 19"));
  sides[2].cross = Poles(sides[2].edge.poles().bottomRows(1) - sides[2].edge.poles().topRows(1));
  expectRefused(sides, AllOf(HasSubstr("side 2"), HasSubstr("parallel to the edge")));
}

TEST(NSidedFillLimits, TangentPlanesOfACornerDiffer) {
  std::vector<FillSide> sides = square();
  sides[0].cross->col(2).array() += 0.003;
  expectRefused(sides, HasSubstr("corner 0: the tangent planes of its sides differ by 0.0529"));
  const NSidedFill fill = nSidedFill(sides, {.corner_tolerance_rad = 2e-3});
  EXPECT_FALSE(fill.corners[0].exact || fill.corners[1].exact);
  EXPECT_TRUE(fill.corners[2].exact && fill.corners[3].exact);
  for (int k = 0; k < 4; ++k) {
    EXPECT_LT(*test::spokeFigures(fill, k).angle_rad->upper, 1e-9);
    const SeamFigures first = test::sideFigures(fill, sides, k, 0),
                      second = test::sideFigures(fill, sides, k, 1);
    EXPECT_LE(first.angle_rad->lower, fill.corners[k].angle_bound_rad + 1e-9);
    EXPECT_LE(second.angle_rad->lower, fill.corners[(k + 1) % 4].angle_bound_rad + 1e-9);
  }
  EXPECT_GT(test::sideFigures(fill, sides, 0, 0).angle_rad->lower, 1e-5);
}

// An L with its inner corner at the origin, then with straight sides there.
TEST(NSidedFillLimits, AnglesOfPiAndMore) {
  const std::vector<Eigen::Vector2d> bent = {{0, 0},     {0, 10},   {-10, 10},
                                             {-10, -10}, {10, -10}, {10, 0}};
  expectRefused(
      test::graphHole(test::plane(), bent),
      AllOf(HasSubstr("corner 0: the angle of the hole is 266.76"), HasSubstr("split the hole")));
  const std::vector<Eigen::Vector2d> straight = {{0, 0}, {10, 0}, {10, 10}, {-10, 10}, {-10, 0}};
  expectRefused(test::graphHole(test::plane(), straight),
                AllOf(HasSubstr("corner 0: the angle of the hole is 180 degrees"),
                      HasSubstr("merge the two sides")));
  std::vector<FillSide> free = test::graphHole(test::plane(), straight);
  for (FillSide& side : free) side.cross.reset();
  expectRefused(free, HasSubstr("merge the two sides"));
}

// A cross-boundary derivative that points into the hole: the angle lies on the other side.
TEST(NSidedFillLimits, CrossBoundaryDerivativesPointIntoTheHole) {
  std::vector<FillSide> sides = square();
  for (FillSide& side : sides) side.cross = -*side.cross;
  expectRefused(sides, HasSubstr("split the hole"));
  sides = square();
  sides[1].cross = -*sides[1].cross;
  expectRefused(sides,
                HasSubstr("corner 1: the tangent planes of its sides differ by 180 degrees"));
}

TEST(ProvedRegular, FlatFoldedAndCollapsedPatches) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 20; ++run)
    EXPECT_TRUE(provedRegular(test::gentlePatch(1 + run % 4, 1 + run % 3, false, random)));
  Poles square(4, 3), triangle(4, 3), bow(4, 3);
  square << 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0;
  triangle << 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0;
  bow << 0, 0, 0, 0, 1, 0, 1, 1, 0, 1, 0, 0;
  EXPECT_TRUE(provedRegular(BezierPatch(1, 1, square)));
  EXPECT_FALSE(provedRegular(BezierPatch(1, 1, triangle)));
  EXPECT_FALSE(provedRegular(BezierPatch(1, 1, bow)));
  EXPECT_FALSE(provedRegular(BezierPatch(1, 1, square, Eigen::Vector4d(1, 2, 1, 1))));
}

// x = u^2 / 2 - a u turns back at u = a.
TEST(ProvedRegular, NormalThatTurnsBack) {
  for (double a : {-0.01, 0.01, 0.5, 0.99, 1.01}) {
    Poles poles(6, 3);
    poles << 0, 0, 0, 0, 1, 0, -a / 2, 0, 0, -a / 2, 1, 0, 0.5 - a, 0, 0, 0.5 - a, 1, 0;
    EXPECT_EQ(provedRegular(BezierPatch(2, 1, poles)), a < 0 || a > 1) << a;
  }
}

// More than a half turn: no vector has all normals on its side.
TEST(ProvedRegular, PatchThatTurnsFar) {
  Poles poles(8, 3);
  poles << 0, 0, 0, 0, 1, 0, 4, 0, 4, 4, 1, 4, -4, 0, 4, -4, 1, 4, 0.5, 0, 0, 0.5, 1, 0;
  EXPECT_TRUE(provedRegular(BezierPatch(3, 1, poles)));
}

}  // namespace
}  // namespace seamwright
