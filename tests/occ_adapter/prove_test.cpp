// SPDX-License-Identifier: LGPL-2.1-or-later
// What a change has to hold to be kept: each promise broken alone, by changes made by hand on
// strips of which gap, angle and curvature are known beforehand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepFill.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "nets.hpp"
#include "proof_case.hpp"
#include "shapes.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/repair/volumes.hpp>
namespace seamwright::test {
namespace {

using occ::FaceChange;
using occ::Proof;
using occ::RepairOptions;
using occ::RepairTask;
using testing::HasSubstr;
using testing::IsEmpty;

RepairOptions picking(std::vector<int> edges, int order = 1) {
  RepairOptions options;
  options.order = order;
  options.edges = std::move(edges);
  return options;
}

std::string onlyText(const occ::Reasons& reasons) {
  return reasons.size() == 1 ? reasons.begin()->second.text
                             : std::to_string(reasons.size()) + " reasons";
}

TEST(Prove, HoldsWhereTheTreatedSeamIsMetAndNoOtherIsWorse) {
  for (const int order : {1, 2}) {
    const ProofCase strips(chain({{}, {.kink = 1 * degree}, {}}), picking({}, order));
    const Proof proof = strips.proofOf({strips.changed(2, {}), strips.changed(3, {})});
    EXPECT_TRUE(proof.holds()) << textOf(proof);
    EXPECT_EQ(proof.after[0].verdict.seam_class, SeamClass::Smooth);
  }
}

TEST(Prove, TheTargetIsMet) {
  const ProofCase strips(chain({{}, {.kink = 1 * degree}, {}}), {});
  ASSERT_TRUE(strips.task().isTreated(0));
  const Proof proof = strips.proofOf(
      {strips.changed(2, {.kink = 0.5 * degree}), strips.changed(3, {.kink = -0.5 * degree})});
  ASSERT_EQ(proof.unrepaired.size(), 1);
  EXPECT_THAT(proof.unrepaired.at(0).text, HasSubstr("after a move it has level G0"));
  EXPECT_THAT(proof.unrepaired.at(0).text, HasSubstr("angle 0.500"));
}

/// The seam between the first two strips is treated, and met; what becomes of that between the
/// second and the third is judged.
std::string whyWorse(const Strip& third, const Strip& third_after, RepairOptions options = {}) {
  if (options.edges.empty()) options.edges = {first_seam_edge};
  const ProofCase strips(chain({{}, {.kink = 0.5 * degree}, third}), options);
  const std::vector<FaceChange> changes = {strips.changed(2, {}), strips.changed(3, third_after)};
  const Proof proof = strips.proofOf(changes);
  EXPECT_THAT(proof.unrepaired, IsEmpty());
  if (proof.holds()) return {};
  EXPECT_EQ(proof.worse.count(1), 1) << textOf(proof);
  return onlyText(proof.worse);
}

TEST(Prove, NoOtherSeamHasALowerLevel) {
  EXPECT_EQ(whyWorse({}, {}), "");
  EXPECT_THAT(whyWorse({}, {.kink = 0.2 * degree}), HasSubstr("a lower level"));
  EXPECT_THAT(whyWorse({}, {.step_mm = 0.015}), HasSubstr("a lower level"));
  EXPECT_THAT(whyWorse({.kink = 2 * degree}, {.kink = 2 * degree, .step_mm = 0.015}),
              HasSubstr("a lower level"));
}

/// Above the level that is asked for: only where the user wants it kept, and where it was sure.
TEST(Prove, AboveTheTargetALevelMayGoUnlessItIsSureAndKept) {
  EXPECT_EQ(whyWorse({}, {.bend_per_mm = 0.002}), "");
  RepairOptions options = picking({first_seam_edge});
  options.keep_curvature = true;
  EXPECT_EQ(whyWorse({}, {}, options), "");
  EXPECT_THAT(whyWorse({}, {.bend_per_mm = 0.002}, options), HasSubstr("a lower level"));
  ProofCase strips(chain({{}, {.kink = 0.5 * degree}, {}}), options);
  const std::vector<FaceChange> changes = {strips.changed(2, {}),
                                           strips.changed(3, {.bend_per_mm = 0.002})};
  strips.before()[1].figures.curvature_rel->upper.reset();
  EXPECT_TRUE(strips.proofOf(changes).holds());
  // At the level asked for what is seen counts.
  const std::vector<FaceChange> kinked = {strips.changed(2, {}),
                                          strips.changed(3, {.kink = 0.2 * degree})};
  strips.before()[1].figures.angle_rad->upper.reset();
  strips.before()[1].verdict.certain = false;
  EXPECT_THAT(onlyText(strips.proofOf(kinked).worse), HasSubstr("a lower level"));
}

/// The seam that is treated shall have G1 only, as it can't have the G2 that was asked for.
TEST(Prove, WhatTheUserAskedForIsHeldWhereLessIsTried) {
  ProofCase strips(chain({{}, {.kink = 0.5 * degree}, {}}), picking({first_seam_edge}, 2));
  RepairTask task = strips.task();
  task.orders[0] = 1;
  const std::vector<FaceChange> bent = {strips.changed(2, {}),
                                        strips.changed(3, {.bend_per_mm = 0.002})},
                                flat = {strips.changed(2, {}), strips.changed(3, {})};
  const auto makeUnsure = [](occ::SeamResult& seam) {
    seam.figures.curvature_rel->upper.reset();
    seam.verdict = judge(seam.figures, {}, Level::G2);
  };
  occ::MeasuredSeams unsure;
  EXPECT_TRUE(strips.proofOf(task, flat, &unsure).holds());
  for (auto& [key, seam] : unsure) makeUnsure(seam);
  EXPECT_THAT(onlyText(strips.proofOf(task, flat, &unsure).worse), HasSubstr("less certain"));
  EXPECT_THAT(onlyText(strips.proofOf(task, bent).worse), HasSubstr("a lower level"));
  // What may have had the level may not certainly lack it after.
  makeUnsure(strips.before()[1]);
  EXPECT_TRUE(strips.proofOf(task, flat, &unsure).holds());
  EXPECT_THAT(onlyText(strips.proofOf(task, bent).worse), HasSubstr("a lower level"));
}

/// The treated seam keeps what it is to have, and no more: the curvature
/// of one that is to have G1 does not count.
TEST(Prove, TheOrderOfATreatedSeamDecides) {
  const ProofCase strips(chain({{}, {.kink = 0.5 * degree}, {}}), picking({first_seam_edge}, 2));
  RepairTask task = strips.task();
  const std::vector<FaceChange> bent = {strips.changed(2, {.bend_per_mm = 0.002}),
                                        strips.changed(3, {})};
  EXPECT_EQ(strips.proofOf(task, bent).unrepaired.size(), 1);
  task.orders[0] = 1;
  const Proof proof = strips.proofOf(task, bent);
  EXPECT_TRUE(proof.holds()) << textOf(proof);
}

TEST(Prove, NoCreaseBecomesADefectOrTurns) {
  EXPECT_EQ(whyWorse({.kink = 6 * degree}, {.kink = 5.95 * degree}), "");
  EXPECT_EQ(whyWorse({.kink = 6 * degree}, {.kink = 6.05 * degree}), "");
  // By more than the tolerance of angles.
  EXPECT_THAT(whyWorse({.kink = 6 * degree}, {.kink = 5.8 * degree}), HasSubstr("another angle"));
  EXPECT_THAT(whyWorse({.kink = 6 * degree}, {.kink = 6.2 * degree}), HasSubstr("another angle"));
  EXPECT_THAT(whyWorse({.kink = 6 * degree}, {.kink = 4 * degree}), HasSubstr("another class"));
}

TEST(Prove, NoOtherSeamIsLessCertain) {
  // Just as far apart as is tolerated: bounds from both sides can't tell.
  EXPECT_THAT(whyWorse({}, {.step_mm = 0.01}), HasSubstr("less certain"));
  EXPECT_EQ(whyWorse({}, {.step_mm = 0.0095}), "");
}

TEST(Prove, NoFigureGrowsByATenthOfItsTolerance) {
  RepairOptions options;  // gap 0.01 mm, angle 0.1 degrees, curvature 2 %
  EXPECT_EQ(whyWorse({.step_mm = 0.05}, {.step_mm = 0.0505}), "");
  EXPECT_THAT(whyWorse({.step_mm = 0.05}, {.step_mm = 0.052}), HasSubstr("a larger gap"));
  EXPECT_EQ(whyWorse({.kink = 1 * degree}, {.kink = 1.005 * degree}), "");
  EXPECT_THAT(whyWorse({.kink = 1 * degree}, {.kink = 1.02 * degree}), HasSubstr("a larger angle"));
  const auto curvature = [&](double before, double after) {
    options.edges = {first_seam_edge};
    return whyWorse({.bend_per_mm = before}, {.bend_per_mm = after}, options);
  };
  options.order = 2;
  EXPECT_EQ(curvature(0.002, 0.00201), "");
  EXPECT_EQ(curvature(0.002, 0.0021), "");  // by a tenth of what it was
  EXPECT_THAT(curvature(0.002, 0.0025), HasSubstr("a larger difference of curvature"));
  options.order = 1;
  EXPECT_EQ(curvature(0.002, 0.0021), "");
}

TEST(Prove, AMatchedSeamThatOpensIsJudgedOverAllOfIt) {
  RepairOptions options;
  options.match_mm = 0.2;
  options.sew = false;
  ProofCase pair(looseChain({{}, {.step_mm = 0.05}}), options);
  ASSERT_EQ(pair.task().seams.size(), 1);
  ASSERT_EQ(pair.task().before[0].kind, occ::SeamKind::Matched);
  RepairTask task = pair.task();
  task.orders[0] = 0;
  const Proof there = pair.proofOf(task, {pair.changed(2, {.step_mm = 0.04})});
  EXPECT_TRUE(there.holds()) << textOf(there);
  EXPECT_NEAR(there.after[0].figures.gap_mm->lower, 0.04, 1e-6);
  pair.before()[0].verdict.certain = false;
  // Beyond the distance to match.
  const Proof open = pair.proofOf(task, {pair.changed(2, {.step_mm = 0.5})});
  EXPECT_THAT(onlyText(open.worse), HasSubstr("a larger gap"));
  EXPECT_NEAR(open.after[0].figures.gap_mm->lower, 0.5, 1e-6);
  EXPECT_NEAR(open.after[0].length_mm, pair.before()[0].length_mm, 1e-6);
}

TEST(Prove, OnlyWhatIsNewIsMeasuredAndThatOnce) {
  const ProofCase strips(chain({{}, {.kink = 0.5 * degree}, {}, {}, {}}), {});
  ASSERT_EQ(strips.task().seams.size(), 4);
  const FaceChange change = strips.changed(2, {});
  occ::MeasuredSeams known;
  const Proof proof = strips.proofOf(strips.task(), {change}, &known);
  EXPECT_TRUE(proof.holds()) << textOf(proof);
  std::vector<std::size_t> measured;
  for (const auto& [key, seam] : known) measured.push_back(key.first);
  // The third strip has a new edge.
  EXPECT_THAT(measured, testing::ElementsAre(0, 1, 2));
  for (auto& [key, seam] : known) seam.note = "known";
  EXPECT_EQ(strips.proofOf(strips.task(), {change}, &known).after[0].note, "known");
  // Another surface is another seam.
  EXPECT_EQ(strips.proofOf(strips.task(), {strips.changed(2, {})}, &known).after[0].note, "");
}

TEST(Prove, NoFaceFoldsOver) {
  const ProofCase strips(chain({{}, {.kink = 0.5 * degree}, {}}), {});
  for (const bool folded : {false, true}) {
    // The second row of poles beyond the first, away from the seams: a lap.
    FaceChange change = strips.changed(2, {});
    const Spline surface = Spline::DownCast(change.surface);
    surface->InsertUKnot(0.5, 3, 1e-9);
    const gp_Vec back(folded ? -12 : -2, 0, 0);
    for (int j = 1; j <= surface->NbVPoles(); ++j)
      surface->SetPole(4, j, surface->Pole(4, j).Translated(back));
    change.largest_move_mm += back.Magnitude();
    const Proof proof = strips.proofOf({change, strips.changed(3, {})});
    EXPECT_EQ(proof.faces.count(2), folded) << textOf(proof);
    if (folded) {
      EXPECT_EQ(proof.faces.at(2).text, "it would fold over");
    }
  }
}

TEST(Prove, ASideThatIsAPointIsNoFold) {
  const Net net = dome(4, 50);
  const ProofCase sectors(shapeOf(net), {});
  std::mt19937 generator(testSeed());
  const auto surface = Spline::DownCast(net.faces[0].surface->Copy());
  for (int i = 3; i < surface->NbUPoles() - 1; ++i)
    for (int j = 3; j < surface->NbVPoles() - 2; ++j)
      surface->SetPole(i, j, surface->Pole(i, j).Translated(gp_Vec(0, 0, random(generator, 1e-4))));
  gp_Pnt top;
  gp_Vec along_u, along_v;
  surface->D1(0.5, 1, top, along_u, along_v);
  ASSERT_EQ(along_u.Crossed(along_v).Magnitude(), 0);
  EXPECT_THAT(sectors.proofOf({{1, handle<Geom_Surface>(surface), 0.001}}).faces, IsEmpty());
}

TEST(Prove, NoEdgeStaysBehindItsFaces) {
  // A gap that may not be closed any more, so that only the edge is at fault.
  RepairOptions options = picking({first_seam_edge});
  const ProofCase strips(chain({{}, {.kink = 0.5 * degree}, {}}, 1e-7), options);
  const Proof near = strips.proofOf({strips.changed(2, {}), strips.changed(3, {.step_mm = 0.03})});
  EXPECT_THAT(near.faces, IsEmpty());
  const Proof far = strips.proofOf({strips.changed(2, {}), strips.changed(3, {.step_mm = 0.04})});
  ASSERT_EQ(far.faces.size(), 2) << textOf(far);
  EXPECT_EQ(far.faces.at(3).text, "an edge of it would be 0.024 mm away");
}

TEST(Prove, AnEdgeThatStrayedMayRunBetweenItsFaces) {
  const ProofCase strips(chain({{}, {.kink = 0.5 * degree}, {.step_mm = 0.06}}, 1e-7),
                         picking({first_seam_edge}));
  EXPECT_THAT(strips.proofOf({strips.changed(2, {})}).faces, IsEmpty());
}

TEST(Prove, ChecksThatPassedPassStill) {
  const ProofCase strips(chain({{}, {.kink = 0.5 * degree}, {}}, 1e-7), {});
  const std::vector<FaceChange> changes = {strips.changed(2, {}), strips.changed(3, {})};
  const TopoDS_Shape changed = strips.withChanges(changes);
  ASSERT_TRUE(strips.proofOf(strips.task(), changes, changed).holds());
  // The curve of the last strip's far edge is not where its path is.
  const auto spoil = [](const TopoDS_Shape& shape) {
    const TopTools_IndexedMapOfShape edges = partsOf(shape, TopAbs_EDGE);
    const TopoDS_Edge spoilt = TopoDS::Edge(edges(edges.Extent()));
    double first = 0, last = 0;
    const handle<Geom_Curve> curve = handle<Geom_Curve>::DownCast(
        BRep_Tool::Curve(spoilt, first, last)->Translated(gp_Vec(0, 0, 0.3)));
    BRep_Builder().UpdateEdge(spoilt, curve, 1e-7);
  };
  EXPECT_TRUE(occ::validityOf(strips.shape(), 1).whole);
  spoil(changed);
  const Proof proof = strips.proofOf(strips.task(), changes, changed);
  ASSERT_EQ(proof.faces.size(), 1) << textOf(proof);
  EXPECT_EQ(proof.faces.at(3).text, "OpenCASCADE's checks do not pass");
  spoil(strips.shape());
  EXPECT_FALSE(occ::validityOf(strips.shape(), 1).whole);
  EXPECT_TRUE(strips.proofOf(strips.task(), changes, changed).holds());
}

TEST(Prove, TheWholeIsCheckedToo) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
  const ProofCase solid(box, {});
  // One face of the shell with the other sense: each by itself is sound.
  BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  const TopTools_IndexedMapOfShape faces = partsOf(box, TopAbs_FACE);
  for (int f = 1; f <= 6; ++f) builder.Add(shell, f == 3 ? faces(f).Reversed() : faces(f));
  shell.Closed(true);
  TopoDS_Solid turned;
  builder.MakeSolid(turned);
  builder.Add(turned, shell);
  EXPECT_TRUE(solid.proofOf(solid.task(), {}, box).holds());
  const Proof proof = solid.proofOf(solid.task(), {}, turned);
  EXPECT_THAT(proof.faces, IsEmpty());
  EXPECT_EQ(proof.whole.text, "OpenCASCADE's checks do not pass");
}

/// A wavy spline of many spans, along z at that distance and angle from the axis.
TopoDS_Edge wavyEdge(double radius_mm, double angle_rad) {
  constexpr int count = 401;
  TColgp_Array1OfPnt points(1, count);
  for (int i = 1; i <= count; ++i) {
    const double z = 0.1 * (i - 1);
    points(i) = gp_Pnt(radius_mm * std::cos(angle_rad) + 0.3 * std::sin(z),
                       radius_mm * std::sin(angle_rad) + 0.3 * std::cos(z), z);
  }
  return BRepBuilderAPI_MakeEdge(
      handle<Geom_Curve>(GeomAPI_PointsToBSpline(points, 3, 3, GeomAbs_C2).Curve()));
}

/// Ruled faces about an edge that all of them share.
TopoDS_Shape fan(int faces) {
  constexpr double pi = 3.14159265358979;
  const TopoDS_Edge axis = wavyEdge(0, 0);
  BRepBuilderAPI_Sewing sewing(1e-6, true, true, true, true);
  for (int f = 0; f < faces; ++f)
    sewing.Add(BRepFill::Face(axis, wavyEdge(10, 2 * pi * f / faces)));
  sewing.Perform();
  return sewing.SewedShape();
}

TEST(Prove, ChecksOfFacesThatShareAnEdgeAreTheSameOnTwoThreads) {
  const TopoDS_Shape shape = fan(24);
  ASSERT_EQ(partsOf(shape, TopAbs_EDGE).Extent(), 1 + 3 * 24);
  ASSERT_TRUE(occ::validityOf(shape, 1).whole);
  int invalid = 0;
  for (int k = 0; k < 150; ++k) invalid += occ::validityOf(shape, 2).whole ? 0 : 1;
  EXPECT_EQ(invalid, 0);
}

TEST(Prove, ChecksLeaveNoThreadBehind) {
  const auto threads = [] {
    return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {});
  };
  if (!std::filesystem::exists("/proc/self/task")) GTEST_SKIP();
  const TopoDS_Shape shape = fan(24);
  const auto before = threads();
  EXPECT_TRUE(occ::validityOf(shape, 2).whole);
  EXPECT_EQ(threads(), before);
}

/// A box grown by a hundredth, with moves of its faces as said.
class GrownBox : public testing::Test {
 protected:
  std::vector<FaceChange> changes(double said_mm, double share = 0.01) const {
    gp_Trsf grow;
    grow.SetScale(gp_Pnt(5, 10, 15), 1 + share);
    std::vector<FaceChange> changes;
    for (int f = 1; f <= 6; ++f) {
      const handle<Geom_Surface> surface = BRep_Tool::Surface(face(box_, f));
      changes.push_back({f, handle<Geom_Surface>::DownCast(surface->Transformed(grow)), said_mm});
    }
    return changes;
  }

  const TopoDS_Shape box_ =
      BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), true).Shape();
  const ProofCase solid_{box_, {}};
  /// Of the corners: a hundredth of half the diagonal.
  const double truly_mm_ = 0.01 * std::sqrt(5 * 5 + 10 * 10 + 15 * 15);
};

TEST_F(GrownBox, NoPointMovesFurtherThanIsSaid) {
  const Proof told = solid_.proofOf(changes(truly_mm_));
  EXPECT_TRUE(told.holds()) << textOf(told);
  const Proof lied = solid_.proofOf(changes(0.01));
  ASSERT_EQ(lied.faces.size(), 6u);
  for (const auto& [number, why] : lied.faces)
    EXPECT_EQ(why.text, "a point of it would move 0.187083 mm, its poles 0.01 mm");
}

TEST_F(GrownBox, ATenthAndAHundredthOfTheGapMoreAreNoMatter) {
  const auto faults = [this](double said_mm, double share) {
    return solid_.proofOf(changes(said_mm, share)).faces.size();
  };
  EXPECT_EQ(faults(truly_mm_ / 1.09, 0.01), 0);
  EXPECT_EQ(faults(truly_mm_ / 1.12, 0.01), 6);
  const double a_hundredth = 0.01 * 0.01 * 0.01 / truly_mm_;
  EXPECT_EQ(faults(0, 0.9 * a_hundredth), 0);
  EXPECT_EQ(faults(0, 1.1 * a_hundredth), 6);
}

TEST_F(GrownBox, TheVolumeChangesByWhatTheMovesExplain) {
  const occ::RepairTask task = solid_.task();
  const auto whyNot = [&](double said_mm) {
    const std::vector<FaceChange> all = changes(said_mm);
    return occ::whyNotVolumes(task, all, solid_.withChanges(all), task.before, {}).text;
  };
  EXPECT_EQ(whyNot(truly_mm_), "");
  EXPECT_THAT(whyNot(0.01),
              HasSubstr("the volume of solid 1 would change by 181.8"));  // 6000 (1.01^3 - 1)
  EXPECT_THAT(whyNot(0.01), HasSubstr("more than 22.22 mm3"));            // 1.01 x 2200 x 0.01
}

}  // namespace
}  // namespace seamwright::test
