// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <gp.hxx>
#include <gp_Pln.hxx>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "shapes.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/repair/passed_faces.hpp>

namespace seamwright::test {
namespace {

using occ::PassedFaces;

constexpr double touch_mm = 0.01;

/// Squares of 10 mm, one over the other, in a common frame.
TopoDS_Shape squaresAt(const std::vector<double>& heights_mm, const gp_Trsf& motion) {
  std::vector<TopoDS_Shape> squares;
  for (const double z : heights_mm)
    squares.push_back(
        BRepBuilderAPI_MakeFace(gp_Pln(gp_Ax3(gp_Pnt(0, 0, z), gp::DZ())).Transformed(motion), -5,
                                5, -5, 5)
            .Face());
  return compoundOf(squares);
}

std::map<int, int> passed(const std::vector<double>& before_mm, const std::vector<double>& after_mm,
                          const std::set<int>& moved,
                          const std::set<std::pair<int, int>>& beside = {}) {
  std::mt19937 generator(testSeed(1));
  const gp_Trsf motion = randomMotion(generator);
  PassedFaces faces(squaresAt(before_mm, motion), beside, touch_mm);
  return faces.in(squaresAt(after_mm, motion), moved);
}

using Pairs = std::map<int, int>;

TEST(PassedFaces, AWallIsPassedByWhatComesOutOnItsOtherSide) {
  EXPECT_EQ(passed({0, -0.1}, {-0.4, -0.1}, {1}), (Pairs{{1, 2}}));
  EXPECT_EQ(passed({0, -0.5}, {-0.4, -0.5}, {1}), Pairs{});
  EXPECT_EQ(passed({0, -0.1}, {0.4, -0.1}, {1}), Pairs{});
}

TEST(PassedFaces, SidesThatMoveAlikeDoNotPass) {
  EXPECT_EQ(passed({0, -0.1}, {-0.4, -0.5}, {1, 2}), Pairs{});
  EXPECT_EQ(passed({0, 0.1, 0.2}, {1, 1.1, 1.2}, {1, 2, 3}), Pairs{});
}

TEST(PassedFaces, SidesThatMoveTowardsOneAnotherPass) {
  EXPECT_EQ(passed({0, 0.3}, {0.5, -0.2}, {1, 2}), (Pairs{{1, 2}, {2, 1}}));
  EXPECT_EQ(passed({0, 0.3}, {0.1, 0.2}, {1, 2}), Pairs{});
}

TEST(PassedFaces, FacesThatTouchedDoNotCount) {
  EXPECT_EQ(passed({0, -0.005}, {-0.4, -0.005}, {1}), Pairs{});
}

TEST(PassedFaces, FacesBesideASeamDoNotCount) {
  EXPECT_EQ(passed({0, -0.1}, {-0.4, -0.1}, {1}, {{1, 2}}), Pairs{});
}

/// As noise of a solution is.
TEST(PassedFaces, ShortWaysAreNotLookedAt) {
  EXPECT_EQ(passed({0, -0.02}, {-0.009, -0.02}, {1}), Pairs{});
}

}  // namespace
}  // namespace seamwright::test
