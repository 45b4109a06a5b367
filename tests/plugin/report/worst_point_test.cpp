// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <seamwright/occ_adapter/analyze/report.hpp>

namespace seamwright::occ {
namespace {

Eigen::Vector3d onLine(double at) {
  return {10 * at, 1, 2};
}

SeamFigures figures() {
  SeamFigures all;
  all.gap_mm = Figure{0.1, {}, 0.125};
  all.angle_rad = Figure{0.2, {}, 0.25};
  all.curvature_rel = Figure{0.3, {}, 0.5};
  all.curvature_change_rel = Figure{0.4, {}, 0.75};
  return all;
}

struct Expected {
  Level level;
  std::string quantity;
  double at;
};

class WorstPointOf : public testing::TestWithParam<Expected> {};

TEST_P(WorstPointOf, TheFigureThatDecidesTheNextLevel) {
  const auto worst = worstPoint(figures(), GetParam().level, onLine);
  ASSERT_TRUE(worst);
  EXPECT_EQ(worst->quantity, GetParam().quantity);
  EXPECT_EQ(worst->at, GetParam().at);
  EXPECT_EQ(worst->point, onLine(GetParam().at));
}

INSTANTIATE_TEST_SUITE_P(EachLevel, WorstPointOf,
                         testing::Values(Expected{Level::None, "gap", 0.125},
                                         Expected{Level::G0, "angle", 0.25},
                                         Expected{Level::G1, "curvature", 0.5},
                                         Expected{Level::G2, "curvature_change", 0.75},
                                         Expected{Level::G3, "curvature_change", 0.75}));

TEST(WorstPoint, FallsBackToTheLastFigureThatHasAValue) {
  SeamFigures some = figures();
  some.curvature_change_rel.reset();
  EXPECT_EQ(worstPoint(some, Level::G3, onLine)->quantity, "curvature");
  some.curvature_rel.reset();
  EXPECT_EQ(worstPoint(some, Level::G1, onLine)->quantity, "angle");
  some.angle_rad.reset();
  EXPECT_EQ(worstPoint(some, Level::G0, onLine)->quantity, "gap");
  EXPECT_FALSE(worstPoint({}, Level::None, onLine));
}

TEST(WorstPoint, OfAFoldIsWhereItFolds) {
  SeamFigures folded = figures();
  folded.fold_at = 0.875;
  const auto worst = worstPoint(folded, Level::G0, onLine);
  EXPECT_EQ(worst->quantity, "angle");
  EXPECT_EQ(worst->at, 0.875);
}

}  // namespace
}  // namespace seamwright::occ
