// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <iostream>

#include "repair_trials.hpp"
#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

struct Series {
  std::string kind;
  unsigned seeds = 1;
};

/// Runs the trials and tells their figures, each kind by itself.
RepairCounts counted(const std::vector<Series>& series, RepairTrial trial) {
  std::cout << tableHead() << "\n";
  RepairCounts all;
  for (const Series& of : series) {
    trial.kind = of.kind;
    RepairCounts counts;
    for (unsigned k = 0; k < of.seeds; ++k) {
      trial.seed = testSeed(k);
      counts += countsOf(trial);
    }
    std::cout << tableLine(of.kind, trial.noise_mm, counts) << "\n";
    for (const auto& [why, times] : counts.reasons)
      std::cout << "    " << times << " x " << why << "\n";
    all += counts;
  }
  std::cout << tableLine("all", trial.noise_mm, all) << "\n";
  testing::Test::RecordProperty("treated", all.treated);
  testing::Test::RecordProperty("repaired", all.repaired);
  testing::Test::RecordProperty("angle_deg", std::to_string(all.largest_angle_deg));
  testing::Test::RecordProperty("move_over_noise", std::to_string(all.largest_on_face));
  return all;
}

/// A fair move spreads a change over the face, so it is larger than the noise: by 4/27 of the kink
/// times the width of the face. Noise on the dense poles of refitted faces kinks by much for its
/// size.
constexpr double most_on_face = 25, most_on_dense_face = 150;

/// \param largest_on_face over the noise.
void expectRepaired(const RepairCounts& counts, int at_least_treated, double largest_on_face) {
  constexpr double share = 0.95;
  EXPECT_GE(counts.treated, at_least_treated);
  EXPECT_GE(counts.share(), share);
  EXPECT_LT(counts.largest_angle_deg, 0.01);
  EXPECT_LE(counts.largest_on_face, largest_on_face);
}

const std::vector<Series> flowing = {{"sheet", 2},          {"ring", 1},
                                     {"mixed sheet", 1},    {"trimmed bricks", 1},
                                     {"trimmed quads", 2},  {"trimmed triangles", 1},
                                     {"refitted quads", 1}, {"ring of bricks", 1}};

/// Without the slowest.
const std::vector<Series> fewer(flowing.begin(), flowing.end() - 1);

TEST(RepairNoise, TheModelsAreSmoothBeforeTheyAreBroken) {
  for (const NetKind& kind : netKinds()) {
    SCOPED_TRACE(kind.name);
    RepairTrial trial{kind.name, 0, 1, 2};
    const TopoDS_Shape shape = brokenModel(trial);
    EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
    occ::AnalyzeOptions options;
    options.tolerance = trialOptions(trial).tolerance;
    options.level = Level::G2;
    const occ::Report report = analyzed(shape, options);
    EXPECT_TRUE(report.passed());
    EXPECT_GE(report.seams.size(), 9);
    for (const occ::SeamResult& seam : report.seams) {
      EXPECT_TRUE(seam.verdict.certain);
      EXPECT_GE(seam.verdict.level, Level::G2) << describe(seam);
    }
  }
}

TEST(RepairNoise, RepairsNoiseOfAThousandth) {
  expectRepaired(counted(flowing, {"", 0.001, 1, 1, 10}), 180, most_on_dense_face);
}

TEST(RepairNoise, RepairsNoiseOfAHundredth) {
  expectRepaired(counted(flowing, {"", 0.01}), 180, most_on_face);
}

TEST(RepairNoise, RepairsNoiseOfATenth) {
  expectRepaired(counted(fewer, {"", 0.1}), 140, most_on_face);
}

/// Seams within the tolerance are noisy too, and stay.
TEST(RepairNoise, RepairsWhereOtherSeamsStay) {
  const std::vector<Series> trimmed = {
      {"trimmed bricks", 3}, {"trimmed quads", 3}, {"trimmed triangles", 3}, {"refitted quads", 3}};
  for (const double noise_mm : {0.0015, 0.002}) {
    const RepairCounts counts = counted(trimmed, {"", noise_mm});
    EXPECT_LT(counts.treated, counts.seams - 10);
    expectRepaired(counts, 60, most_on_face);
  }
}

TEST(RepairNoise, StarsBesideTheErrorOfTheirFit) {
  for (const double noise_mm : {0.001, 0.003})
    expectRepaired(counted({{"blob 6", 2}}, {"", noise_mm}), 20, most_on_face);
}

TEST(RepairNoise, StarsOfNaturalSides) {
  const std::vector<Series> stars = {{"blob 6", 1}, {"blob 24", 1}};
  for (const double noise_mm : {0.01, 0.1})
    expectRepaired(counted(stars, {"", noise_mm}), 60, most_on_face);
}

TEST(RepairNoise, RepairsCurvatureToo) {
  for (const double noise_mm : {0.001, 0.01}) {
    const RepairCounts counts =
        counted(flowing, {"", noise_mm, 1, 2, noise_mm < 0.01 ? 10.0 : 1.0});
    expectRepaired(counts, 100, most_on_dense_face);
    EXPECT_LT(counts.largest_curvature_rel, 0.02);
  }
}

}  // namespace
}  // namespace seamwright::test
