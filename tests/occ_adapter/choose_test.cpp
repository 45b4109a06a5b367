// SPDX-License-Identifier: LGPL-2.1-or-later
// What is treated, and what may move for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>

#include "proof_case.hpp"

#include <seamwright/occ_adapter/model/model.hpp>

namespace seamwright::test {
namespace {

using occ::Choice;
using occ::choose;
using occ::FaceChoice;
using occ::isRepaired;
using occ::modelFromShape;
using occ::RepairOptions;
using occ::Report;
using occ::SeamResult;
using testing::HasSubstr;

Choice chosen(const TopoDS_Shape& shape, const RepairOptions& options = {}) {
  const occ::Model model = modelFromShape(shape);
  return choose(model, occ::analyze(model, occ::analyzeOptions(options)), options);
}

TEST(Choose, DefectsAreTreatedAndCreasesAreNot) {
  const Choice choice = chosen(chain(
      {{}, {.kink = 1 * degree}, {.kink = 6 * degree}, {.step_mm = 0.02}, {.bend_per_mm = 0.01}}));
  EXPECT_EQ(choice.treated, (std::vector{true, false, true, false}));
  for (const occ::RepairReason& reason : choice.reasons) EXPECT_TRUE(reason.empty());
  RepairOptions flowing;
  flowing.order = 2;
  EXPECT_EQ(chosen(chain({{}, {.bend_per_mm = 0.01}}), flowing).treated, std::vector{true});
}

TEST(Choose, WhatIsPickedIsTreatedUnlessItHasTheLevel) {
  const TopoDS_Shape shape = chain({{}, {.kink = 1 * degree}, {.kink = 6 * degree}, {}});
  const std::vector<SeamResult> seams = analyzed(shape).seams;
  RepairOptions options;
  options.edges = {seams[1].edges[0], seams[2].edges[0]};
  const Choice choice = chosen(shape, options);
  EXPECT_EQ(choice.treated, (std::vector{false, true, false}));
  ASSERT_EQ(choice.reasons.size(), 3);
  EXPECT_TRUE(choice.reasons[0].empty() && choice.reasons[1].empty());
  EXPECT_EQ(choice.reasons[2].fault, occ::RepairFault::HasLevel);
  EXPECT_EQ(choice.reasons[2].text, "it already reaches the target");
}

TEST(Choose, WhatWouldBeACreaseIsSharpUnlessItIsPicked) {
  const TopoDS_Shape shape =
      chain({{}, {.kink = 6 * degree, .step_mm = 0.05}, {.kink = 1 * degree, .step_mm = 0.05}});
  const Choice choice = chosen(shape);
  EXPECT_EQ(choice.treated, (std::vector{true, true}));
  EXPECT_EQ(choice.sharp, (std::vector{true, false}));
  RepairOptions options;
  options.edges = {analyzed(shape).seams[0].edges[0]};
  EXPECT_EQ(chosen(shape, options).sharp, (std::vector{false, false}));
  EXPECT_EQ(chosen(shape, options).treated, (std::vector{true, false}));
  // A crease that meets is none either.
  EXPECT_EQ(chosen(chain({{}, {.kink = 6 * degree}})).sharp, std::vector{false});
}

TEST(Choose, WhatFoldsBackIsNotTreatedUnlessItIsSharp) {
  const TopoDS_Shape shape = chain({{}, {.kink = 1 * degree}});
  const occ::Model model = modelFromShape(shape);
  Report report = analyzed(shape);
  report.seams[0].figures.fold_at = 0.25;
  const Choice folded = choose(model, report, {});
  EXPECT_FALSE(folded.treated[0]);
  EXPECT_THAT(folded.reasons[0].text, HasSubstr("fold back on one another there, first at 0.25"));
  const TopoDS_Shape sharp = chain({{}, {.kink = 6 * degree, .step_mm = 0.05}});
  report = analyzed(sharp);
  report.seams[0].figures.fold_at = 0.25;
  const Choice apart = choose(modelFromShape(sharp), report, {});
  EXPECT_TRUE(apart.sharp[0]);
  EXPECT_TRUE(apart.treated[0]);
  EXPECT_EQ(apart.reasons[0].text, "");
}

TEST(Choose, WhatCantBeMeasuredIsToldWithItsNote) {
  const TopoDS_Shape shape = chain({{}, {.kink = 1 * degree}});
  Report report = analyzed(shape);
  report.seams[0].figures.gap_mm.reset();
  EXPECT_EQ(choose(modelFromShape(shape), report, {}).reasons[0].text, "it can't be measured");
  report.seams[0].note = "not finite";
  EXPECT_EQ(choose(modelFromShape(shape), report, {}).reasons[0].text,
            "it can't be measured: not finite");
}

void expectChoice(const FaceChoice& face, const std::string& cannot_move, bool may_be_trimmed,
                  bool convertible) {
  EXPECT_EQ(face.cannot_move.text, cannot_move);
  EXPECT_EQ(face.may_move, cannot_move.empty());
  EXPECT_EQ(face.may_be_trimmed, may_be_trimmed);
  EXPECT_EQ(face.convertible, convertible);
}

TEST(Choose, FacesThatMayMove) {
  RepairOptions options;
  options.fixed_faces = {2};
  const Choice spline = chosen(chain({{}, {.kink = 1 * degree}}), options);
  expectChoice(spline.faces[1], "", true, false);
  expectChoice(spline.faces[2], "is fixed", false, false);
  EXPECT_TRUE(spline.treated[0]);
  const Choice analytic = chosen(BRepPrimAPI_MakeCylinder(5, 9).Shape(), options);
  expectChoice(analytic.faces[1], "is a cylinder, which has no poles to move", true, true);
  expectChoice(analytic.faces[2], "is fixed", false, false);
  expectChoice(analytic.faces[3], "is a plane, which has no poles to move", true, true);
}

TEST(Choose, NoPartThatStandsTwiceAndNoFaceAtAnEdgeOfThree) {
  const TopoDS_Shape part = chain({{}, {.kink = 1 * degree}});
  gp_Trsf away;
  away.SetTranslation(gp_Vec(0, 100, 0));
  const Choice twice = chosen(loose(part, located(part, away)));
  for (int f = 1; f <= 4; ++f)
    expectChoice(twice.faces[f], "occurs in the model 2 times", false, false);
  EXPECT_EQ(twice.reasons[0].text,
            "face 1 occurs in the model 2 times; face 2 occurs in the model 2 times");
  Report report = analyzed(part);
  report.non_manifold = {{7, {2, 5, 6}}};
  const Choice crowded = choose(modelFromShape(part), report, {});
  expectChoice(crowded.faces[1], "", true, false);
  expectChoice(crowded.faces[2], "has edge 7, where 3 faces meet", false, false);
}

TEST(Choose, AFaceThatMeetsItselfIsNamedOnce) {
  const TopoDS_Shape shape = chain({{}, {.kink = 1 * degree}});
  Report report = analyzed(shape);
  report.seams[0].faces = {1, 1};
  RepairOptions options;
  options.fixed_faces = {1};
  EXPECT_EQ(choose(modelFromShape(shape), report, options).reasons[0].text, "face 1 is fixed");
}

TEST(IsRepaired, MeansThatBoundsAreWithinTheTolerance) {
  SeamResult seam = analyzed(chain({{}, {}})).seams[0];
  EXPECT_TRUE(isRepaired(seam, false, {}, Level::G1));
  for (const auto figure : {&SeamFigures::gap_mm, &SeamFigures::angle_rad}) {
    SeamResult unsure = seam;
    (unsure.figures.*figure)->upper.reset();
    EXPECT_GE(unsure.verdict.level, Level::G1);
    EXPECT_FALSE(isRepaired(unsure, false, {}, Level::G1));
  }
  EXPECT_TRUE(isRepaired(seam, false, {}, Level::G2));
  seam.figures.curvature_rel = Figure{0.03, 0.03, 0};
  EXPECT_TRUE(isRepaired(seam, false, {}, Level::G1));
  EXPECT_FALSE(isRepaired(seam, false, {}, Level::G2));
}

TEST(IsRepaired, OfASharpOneMeansACreaseThatMeets) {
  const SeamResult crease = analyzed(chain({{}, {.kink = 6 * degree}})).seams[0];
  ASSERT_EQ(crease.verdict.seam_class, SeamClass::Crease);
  EXPECT_TRUE(isRepaired(crease, true, {}, Level::G1));
  EXPECT_FALSE(isRepaired(crease, false, {}, Level::G1));
  SeamResult other = crease;
  other.verdict.seam_class = SeamClass::Defect;
  EXPECT_FALSE(isRepaired(other, true, {}, Level::G1));
  other = crease;
  other.figures.gap_mm->upper = 0.011;
  EXPECT_FALSE(isRepaired(other, true, {}, Level::G1));
  other.figures.gap_mm->upper.reset();
  EXPECT_FALSE(isRepaired(other, true, {}, Level::G1));
  other.figures.gap_mm.reset();
  EXPECT_FALSE(isRepaired(other, true, {}, Level::G1));
}

}  // namespace
}  // namespace seamwright::test
