// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts with several instances in an assembly are repaired once, and stay instances.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_Ax1.hxx>
#include <set>

#include "match_pairs.hpp"
#include "repair_checks.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::RepairOptions;
using occ::RepairReport;
using testing::HasSubstr;

TopoDS_Shape brokenPart(unsigned index = 0) {
  std::mt19937 generator(testSeed(index));
  return joinedSheets(disturbedSheets(generator, 0.01));
}

gp_Trsf turnedAndMoved(double x_mm, double angle_rad) {
  gp_Trsf turn, move;
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 2)), angle_rad);
  move.SetTranslation(gp_Vec(x_mm, 0, 0));
  return move * turn;
}

TopoDS_Shape compoundOf(const std::vector<TopoDS_Shape>& parts) {
  const BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& part : parts) builder.Add(compound, part);
  return compound;
}

TopoDS_Shape threeTimes(const TopoDS_Shape& part) {
  return compoundOf({part, located(part, turnedAndMoved(300, 0.7)),
                     located(part, turnedAndMoved(-300, 2.1)).Reversed()});
}

std::size_t distinct(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  std::set<const TopoDS_TShape*> kinds;
  const TopTools_IndexedMapOfShape parts = partsOf(shape, kind);
  for (int i = 1; i <= parts.Extent(); ++i) kinds.insert(parts(i).TShape().get());
  return kinds.size();
}

void expectSamePlacements(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  for (const TopAbs_ShapeEnum kind :
       {TopAbs_COMPOUND, TopAbs_SHELL, TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
    EXPECT_EQ(distinct(a, kind), distinct(b, kind));
    const TopTools_IndexedMapOfShape of_a = partsOf(a, kind), of_b = partsOf(b, kind);
    ASSERT_EQ(of_a.Extent(), of_b.Extent());
    for (int i = 1; i <= of_a.Extent(); ++i) {
      EXPECT_EQ(of_a(i).Orientation(), of_b(i).Orientation());
      EXPECT_TRUE(of_a(i).Location() == of_b(i).Location());
    }
  }
}

TEST(RepairInstances, AreRepairedLikeThePartAlone) {
  const TopoDS_Shape part = brokenPart(), all = threeTimes(part);
  for (const int order : {1, 2}) {
    const RepairReport alone = repairedModel(part, strictRepair(order)),
                       report = repairedModel(all, strictRepair(order));
    ASSERT_EQ(repairedSeams(alone), 1) << reasonsOf(alone);
    EXPECT_EQ(repairedSeams(report), 3) << reasonsOf(report);
    expectSamePlacements(report.model.shape, all);
    ASSERT_EQ(report.moves.size(), 3 * alone.moves.size());
    for (std::size_t i = 0; i < report.moves.size(); ++i) {
      const occ::FaceMove &one = report.moves[i], &as = alone.moves[i % alone.moves.size()];
      EXPECT_EQ(one.face, as.face + 2 * static_cast<int>(i / alone.moves.size()));
      EXPECT_NEAR(one.largest_move_mm, as.largest_move_mm, 1e-9);
    }
  }
}

TEST(RepairInstances, PartsWithinPartsAndCompoundsOfLooseFaces) {
  const TopoDS_Shape inner = brokenPart();
  const TopTools_IndexedMapOfShape faces = partsOf(brokenPart(1), TopAbs_FACE);
  // Loose faces with a common edge: only together they have nothing in common with others.
  const TopoDS_Shape sheets = compoundOf({faces(1), faces(2)});
  const TopoDS_Shape pair = compoundOf({inner, located(inner, turnedAndMoved(200, 1)),
                                        located(brokenPart(2), turnedAndMoved(0, 3))});
  const TopoDS_Shape all = compoundOf({located(pair, turnedAndMoved(-500, 0.3)), sheets, pair,
                                       located(sheets, turnedAndMoved(900, -1)), inner});
  const RepairReport report = repairedModel(all, strictRepair(1));
  // The last part stands where the pair without a move has its first one.
  EXPECT_EQ(report.seams.size(), 8);
  EXPECT_EQ(repairedSeams(report), 8) << reasonsOf(report);
  expectSamePlacements(report.model.shape, all);
}

TEST(RepairInstances, WhatIsAskedOfOneHoldsForAll) {
  const TopoDS_Shape all = threeTimes(brokenPart());
  const RepairReport every = repairedModel(all, strictRepair(1));
  RepairOptions picked = strictRepair(1);
  picked.edges = {every.seams[1].before.edges[0]};
  const RepairReport one = repairedModel(all, picked);
  EXPECT_EQ(repairedSeams(one), 3) << reasonsOf(one);
  RepairOptions fixed = strictRepair(1);
  fixed.fixed_faces = {3, 6};  // one side in the second instance, the other one in the third
  const RepairReport stays = repairedModel(all, fixed);
  EXPECT_TRUE(stays.model.shape.IsEqual(all));
  for (const occ::SeamRepair& seam : stays.seams)
    EXPECT_THAT(seam.reason.text, HasSubstr("face 1 is fixed; face 2 is fixed"));
  EXPECT_THAT(stays.seams[2].reason.text,
              HasSubstr("instance of edge " + std::to_string(stays.seams[0].before.edges[0])));
}

TEST(RepairInstances, WhatStaysIsShared) {
  const TopoDS_Shape broken = brokenPart(),
                     smooth = repairedModel(brokenPart(1), strictRepair(1)).model.shape;
  const TopoDS_Shape all = compoundOf({smooth, broken, located(smooth, turnedAndMoved(400, 1)),
                                       located(broken, turnedAndMoved(800, 1))});
  const RepairReport report = repairedModel(all, strictRepair(1));
  EXPECT_EQ(repairedSeams(report), 2) << reasonsOf(report);
  const TopTools_IndexedMapOfShape faces = partsOf(all, TopAbs_FACE),
                                   now = partsOf(report.model.shape, TopAbs_FACE);
  for (const int f : {1, 2, 5, 6}) EXPECT_TRUE(faces(f).IsEqual(now(f)));
  for (const int f : {3, 4, 7, 8}) EXPECT_FALSE(faces(f).IsPartner(now(f)));
}

TEST(RepairInstances, PartsThatShareWithOthersStay) {
  const TopoDS_Shape part = brokenPart(), other = brokenPart(1);
  const TopoDS_Shape all =
      compoundOf({part, located(part, turnedAndMoved(400, 1)),
                  located(partsOf(part, TopAbs_FACE)(1), turnedAndMoved(0, 2)), other});
  const RepairReport report = repairedModel(all, strictRepair(1));
  EXPECT_EQ(repairedSeams(report), 1) << reasonsOf(report);
  EXPECT_TRUE(report.seams.back().repaired);
  for (const std::size_t i : {0, 1})
    EXPECT_THAT(report.seams[i].reason.text, HasSubstr("occurs in the model 3 times"));
}

TEST(RepairInstances, OptionsAreCheckedAsEver) {
  const TopoDS_Shape all = threeTimes(brokenPart());
  for (const int number : {0, 7}) {
    RepairOptions options = strictRepair(1);
    options.fixed_faces = {number};
    EXPECT_THROW(repair(occ::modelFromShape(all), options), std::invalid_argument);
  }
}

TEST(RepairInstances, AreLeftWhereOpenEdgesAreMatched) {
  RepairOptions options = strictRepair(1);
  options.match_mm = 0.1;
  const TopoDS_Shape all = threeTimes(brokenPart());
  const RepairReport report = repair(occ::modelFromShape(all), options);
  EXPECT_FALSE(report.changed());
  for (const occ::SeamRepair& seam : report.seams)
    EXPECT_THAT(seam.reason.text, HasSubstr("occurs in the model 3 times"));
}

}  // namespace
}  // namespace seamwright::test
