// SPDX-License-Identifier: LGPL-2.1-or-later
// Which seams are given up for what speaks against a change.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "grids.hpp"
#include "proof_case.hpp"

namespace seamwright::test {
namespace {

using occ::culprits;
using occ::Proof;
using occ::RepairSolution;
using occ::RepairTask;
using testing::ElementsAre;
using testing::Pair;

RepairSolution moving(const std::set<int>& faces) {
  RepairSolution solution;
  for (const int face : faces) solution.changes.push_back({face, {}, 0});
  return solution;
}

/// Five strips; all seams but the third, between strips 3 and 4, are defects, the second one the worst.
ProofCase strips() {
  return {chain({{}, {.kink = 0.5 * degree}, {.kink = 1 * degree}, {}, {.kink = 0.5 * degree}}), {}};
}

TEST(Culprits, OfAFaceAtFaultAllItsTreatedSeams) {
  const ProofCase five = strips();
  Proof proof;
  proof.faces = {{2, "it folds"}};
  EXPECT_THAT(culprits(five.task(), moving({1, 2, 3, 4, 5}), proof, false),
              ElementsAre(Pair(0, "face 2: it folds"), Pair(1, "face 2: it folds")));
}

TEST(Culprits, OfAFaceThatMovesTooFarTheWorst) {
  const ProofCase five = strips();
  Proof proof;
  proof.too_far = {{2, "it is far"}};
  EXPECT_THAT(culprits(five.task(), moving({1, 2, 3, 4, 5}), proof, false),
              ElementsAre(Pair(1, "face 2: it is far")));
  const ProofCase first_worst(chain({{}, {.kink = 1 * degree}, {.kink = 0.5 * degree}}), {});
  EXPECT_THAT(culprits(first_worst.task(), moving({1, 2, 3}), proof, false),
              ElementsAre(Pair(0, "face 2: it is far")));
  RepairTask first_alone = five.task();
  first_alone.treated[1] = false;
  EXPECT_THAT(culprits(first_alone, moving({1, 2}), proof, false), ElementsAre(Pair(0, "face 2: it is far")));
}

TEST(Culprits, WhatIsNotMetComesBeforeWhatIsWorse) {
  const ProofCase five = strips();
  Proof proof;
  proof.worse = {{2, "it is worse"}};
  EXPECT_THAT(culprits(five.task(), moving({1, 2, 3, 4, 5}), proof, false),
              ElementsAre(Pair(1, "it is worse"), Pair(3, "it is worse")));
  // Only those that moved one of its faces.
  EXPECT_THAT(culprits(five.task(), moving({4, 5}), proof, false), ElementsAre(Pair(3, "it is worse")));
  proof.unrepaired = {{0, "it is not met"}};
  EXPECT_THAT(culprits(five.task(), moving({1, 2, 3, 4, 5}), proof, false),
              ElementsAre(Pair(0, "it is not met")));
}

TEST(Culprits, WhatIsConnectedGoesWithThem) {
  const ProofCase five = strips();
  Proof proof;
  proof.unrepaired = {{0, "it is not met"}};
  const std::string first = "it depends on edge " + std::to_string(five.task().seams[0].edges[0]);
  EXPECT_THAT(culprits(five.task(), moving({1, 2, 3, 4, 5}), proof, true),
              ElementsAre(Pair(0, "it is not met"), Pair(1, first + ": it is not met")));
  EXPECT_EQ(culprits(five.task(), moving({1, 4, 5}), proof, true).size(), 1);
}

TEST(Culprits, WhereNobodyIsToBlameAllAre) {
  const ProofCase five = strips();
  const auto reasonsOf = [&](const Proof& proof) {
    const auto all = culprits(five.task(), moving({1, 2, 3, 4, 5}), proof, false);
    EXPECT_EQ(all.size(), 3);
    return all.begin()->second;
  };
  Proof proof;
  proof.whole = "the volume changes";
  EXPECT_EQ(reasonsOf(proof), "the volume changes");
  const ProofCase smooth(chain({{}, {}, {.kink = 1 * degree}}), {});
  proof = {};
  proof.faces = {{1, "it folds"}};
  EXPECT_THAT(culprits(smooth.task(), moving({1, 2, 3}), proof, false),
              ElementsAre(Pair(1, "face 1: it folds")));
  proof = {};
  proof.worse = {{0, "it is worse"}};
  EXPECT_THAT(culprits(smooth.task(), moving({3}), proof, false), ElementsAre(Pair(1, "it is worse")));
}

TEST(Culprits, OfASeamThatIsWorseThoseThatEndWhereItEnds) {
  std::mt19937 generator(20601);
  const std::vector<double> cuts = {0, 0.3, 0.7, 1};
  const ProofCase grid(gridOf(cutUp(sheet(generator, 9, 9, 3, 3), cuts, cuts)), {});
  // Faces 1 to 3 are the first row. Between 2 and 5 is what gets worse: 2 and 3 meet where it ends, 5 and 8 do not.
  RepairTask task = grid.task();
  const auto between = [&](int a, int b) {
    const auto found = std::ranges::find(task.before, std::array{a, b}, &occ::SeamResult::faces);
    EXPECT_NE(found, task.before.end());
    return static_cast<std::size_t>(found - task.before.begin());
  };
  const std::size_t near = between(2, 3), away = between(5, 8);
  Proof proof;
  proof.worse = {{between(2, 5), "it is worse"}};
  const RepairSolution all = moving({1, 2, 3, 4, 5, 6, 7, 8, 9});
  task.treated[away] = true;
  EXPECT_THAT(culprits(task, all, proof, false), ElementsAre(Pair(away, "it is worse")));
  task.treated[near] = true;
  EXPECT_THAT(culprits(task, all, proof, false), ElementsAre(Pair(near, "it is worse")));
}

}  // namespace
}  // namespace seamwright::test
