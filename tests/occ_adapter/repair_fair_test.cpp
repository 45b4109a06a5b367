// SPDX-License-Identifier: LGPL-2.1-or-later
// A repair does not spoil surfaces: fairness by code that has nothing in common with the repair's
// own judge.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <gp_Ax1.hxx>
#include <iostream>
#include <utility>

#include "fairness.hpp"
#include "grids.hpp"
#include "match_pairs.hpp"
#include "proof_case.hpp"
#include "repair_checks.hpp"
#include "repair_trials.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/repair/reasons.hpp>

namespace seamwright::test {
namespace {

using occ::RepairOptions;
using occ::RepairReport;

/// Repairs, and expects no moved face to vary more than it may. \returns how many seams are
/// repaired.
int expectFair(const TopoDS_Shape& shape, const RepairOptions& options) {
  const RepairReport report = repairedModel(shape, options);
  const auto faces = fairnessOfChanges(shape, report, options.tolerance);
  EXPECT_EQ(faces.size(), report.moves.size());
  for (const FaceFairness& face : faces)
    EXPECT_FALSE(face.isWorse()) << "face " << face.face << ": " << face.before_per_mm << " -> "
                                 << face.after_per_mm << " /mm, at most " << face.limit_per_mm;
  for (const occ::FaceMove& move : report.moves)
    EXPECT_TRUE(move.less_fair.empty()) << move.less_fair.text;
  double broken_rad = 0;
  for (const occ::SeamRepair& seam : report.seams)
    broken_rad = std::max(broken_rad, upper(seam.before.figures.angle_rad));
  std::cout << repairedSeams(report) << " of " << treated(report) << " seams, broken by up to "
            << broken_rad / degree << " degrees; " << faces.size() << " faces\n"
            << reasonsOf(report);
  return repairedSeams(report);
}

TEST(LessFair, TheReasonHasTheFigures) {
  SurfaceChange change;
  change.before.variation_per_mm = 2;
  change.after.variation_per_mm = 30;
  change.before.inflections = 5;
  change.after.inflections = 14;
  change.before.lines = change.after.lines = 40;
  EXPECT_TRUE(occ::why::lessFair(SurfaceFault::None, change).empty());
  const occ::RepairReason varies = occ::why::lessFair(SurfaceFault::Variation, change);
  EXPECT_EQ(varies.fault, occ::RepairFault::LessFair);
  EXPECT_EQ(varies.text, "its mean curvature varies by 30 per mm along a line, before by 2");
  EXPECT_EQ(varies.numbers.back(), std::pair(std::string("variation_after_per_mm"), 30.0));
  EXPECT_EQ(occ::why::wouldBe(varies).text, "it would be less fair: " + varies.text);
  EXPECT_EQ(occ::why::lessFair(SurfaceFault::Inflections, change).text,
            "it has 9 more inflections along 40 lines");
}

struct FairTrial {
  std::string kind;
  double noise_mm = 0;
};

class RepairFair : public testing::TestWithParam<FairTrial> {};

/// Noise on the poles beside the seams of a smooth model.
TEST_P(RepairFair, NoFaceOfABrokenNetBecomesWorse) {
  const auto& [kind, noise_mm] = GetParam();
  const RepairTrial trial{kind, noise_mm, testSeed()};
  EXPECT_GT(expectFair(brokenModel(trial), trialOptions(trial)), 0);
}

std::vector<FairTrial> fairTrials() {
  std::vector<FairTrial> trials;
  for (const char* kind :
       {"sheet", "ring", "trimmed bricks", "trimmed quads", "trimmed triangles", "blob 6"})
    for (const double noise_mm : {0.005, 0.05}) trials.push_back({kind, noise_mm});
  return trials;
}

INSTANTIATE_TEST_SUITE_P(Nets, RepairFair, testing::ValuesIn(fairTrials()), [](const auto& trial) {
  std::string name = trial.param.kind + (trial.param.noise_mm < 0.01 ? "_fine" : "_coarse");
  std::ranges::replace(name, ' ', '_');
  return name;
});

/// Smooth faces that meet in kinks: all of what repair has to do is bending them.
TEST(RepairFairness, OfStripsWithKinks) {
  EXPECT_EQ(expectFair(chain({{}, {.kink = 0.5 * degree}, {.kink = -0.5 * degree}, {}}), {}), 2);
  EXPECT_EQ(expectFair(chain({{}, {.kink = 1 * degree}, {}}), {}), 1);
  EXPECT_EQ(expectFair(chain({{}, {.step_mm = 0.05}, {}}), {}), 1);
}

/// One surface cut into nine, of which some are turned about a line through their middle.
TEST(RepairFairness, OfAGridWithTurnedPatches) {
  for (const double turn_deg : {0.3, 0.6}) {
    SCOPED_TRACE(turn_deg);
    std::mt19937 generator(testSeed());
    const Patches patches =
        cutUp(sheet(generator, 9, 8, 3, 3), {0, 1.0 / 3, 2.0 / 3, 1}, {0, 1.0 / 3, 2.0 / 3, 1});
    for (const auto& [i, j] : std::vector<std::pair<int, int>>{{0, 0}, {1, 1}, {2, 1}}) {
      const Spline& patch = patches[i][j];
      gp_Trsf turn;
      turn.SetRotation(gp_Ax1(patch->Value((i + 0.5) / 3, (j + 0.5) / 3), gp_Dir(1, 0.5, 0)),
                       turn_deg * degree);
      patch->Transform(turn);
    }
    EXPECT_GE(expectFair(gridOf(patches), {}), 1);
  }
}

/// Two planes that meet at an angle.
TopoDS_Shape roof(double kink_rad) {
  const auto half = [kink_rad](bool right) {
    constexpr double length_mm = 40, width_mm = 30;
    TColgp_Array2OfPnt poles(1, 4, 1, 4);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const double along = length_mm * (right ? i : 3 - i) / 3.0;
        poles(i + 1, j + 1) = gp_Pnt((right ? 1 : -1) * along * std::cos(kink_rad / 2),
                                     width_mm * j / 3.0, along * std::sin(kink_rad / 2));
      }
    return splineOf(poles, 3, 3);
  };
  return gridOf({{half(false)}, {half(true)}}, 1e-6);
}

/// All that a fair move may cost is what turning the planes costs at the least.
TEST(RepairFairness, ARoofIsMadeFairAtTheLeastCost) {
  for (const double kink_deg : {0.15, 1.0, 2.0}) {
    SCOPED_TRACE(kink_deg);
    EXPECT_EQ(expectFair(roof(kink_deg * degree), {}), 1);
  }
}

}  // namespace
}  // namespace seamwright::test
