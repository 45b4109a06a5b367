// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <StdFail_NotDone.hxx>
#include <limits>

#include <seamwright/occ_adapter/repair/reasons.hpp>

#include "reason_rows.hpp"

namespace seamwright::test {
namespace {

using occ::RepairFault;
using occ::RepairReason;
using Rows = std::vector<ReasonRow<RepairReason>>;

namespace why = occ::why;

/// The texts begin with what facesStay() puts before them.
Rows rowsOfFacesThatStay() {
  return {
      {"face_fixed", why::isFixed(), {.says = "is fixed"}},
      {"face_held", why::isHeld(), {.says = "its move makes a seam worse in the file"}},
      {"face_unusable", why::isUnusable("has the number inf"), {.says = "has the number inf"}},
      {"face_unusable",
       why::hasUnusableNeighbour(11, 7, "has the number inf"),
       {.says = "has edge 11 in common with face 7, which has the number inf",
        .faces = {7},
        .edges = {11}}},
      {"face_instances",
       why::hasInstances(3),
       {.says = "occurs in the model 3 times", .numbers = {{"count", 3}}}},
      {"face_instances",
       why::hasEdgeWithInstances(11, 3),
       {.says = "has edge 11, which occurs in the model 3 times",
        .numbers = {{"count", 3}},
        .edges = {11}}},
      {"face_non_manifold",
       why::hasNonManifoldEdge(11, 3),
       {.says = "has edge 11, where 3 faces meet", .numbers = {{"faces", 3}}, .edges = {11}}},
      {"face_without_poles",
       why::hasNoPoles("a plane"),
       {.says = "is a plane, which has no poles"}},
  };
}

Rows rowsWithoutSolution() {
  return {
      {"not_measured", why::notMeasured(""), {.says = "it can't be measured"}},
      {"not_measured", why::notMeasured("a fold"), {.says = "it can't be measured: a fold"}},
      {"not_measured", why::notMeasured("not measured: a fold"), {.says = "not measured: a fold"}},
      {"has_level", why::hasLevel(), {.says = "already reaches the target"}},
      {"faces_fold",
       why::facesFold(0.25),
       {.says = "first at 0.25 of its length", .numbers = {{"at", 0.25}}}},
      {"surface_kink",
       why::surfaceKink(7, 12.5, 0.25),
       {.says = "of face 7 has a kink of 12.5 degrees across the edge, at 0.25 of its length",
        .numbers = {{"turn_deg", 12.5}, {"at", 0.25}},
        .faces = {7}}},
      {"misses_tolerance",
       why::missesTolerance(2.5, 0.25),
       {.says = "of no more than 0.25 mm, leaves 2.5 times the tolerance",
        .numbers = {{"times_tolerance", 2.5}, {"limit_mm", 0.25}}}},
      {"misses_tolerance",
       why::missesTolerance(2.5, std::numeric_limits<double>::infinity()),
       {.says = "beside it leaves 2.5 times the tolerance", .numbers = {{"times_tolerance", 2.5}}}},
      {"sides_apart",
       why::sidesApart(0.25),
       {.says = "its sides are 0.25 mm apart", .numbers = {{"apart_mm", 0.25}}}},
      {"surfaces_apart", why::surfacesApart(), {.says = "the surfaces do not meet"}},
      {"path_not_enough", why::pathNotEnough(), {.says = "do not make it smooth"}},
      {"time_limit", why::timeLimit(), {.says = "the time limit was reached"}},
      {"opencascade_failed",
       why::failed(StdFail_NotDone("a test")),
       {.says = "OpenCASCADE failed: StdFail_NotDone a test"}},
      {"failed", why::failed(std::string("no normal")), {.says = "no normal"}},
  };
}

Rows rowsOfSolutions() {
  return {
      {"still_misses",
       why::stillMisses("gap 0.5 mm"),
       {.says = "after a move it has gap 0.5 mm", .foreign = {0.5}}},
      {"spoils_seam",
       why::spoilsSeam(11, "a larger gap", "0.5 mm", "0.25 mm"),
       {.says = "edge 11 would get a larger gap (0.5 mm; before 0.25 mm)",
        .edges = {11},
        .foreign = {0.5, 0.25}}},
      {"edge_strays",
       why::edgeStrays(0.25),
       {.says = "would be 0.25 mm away", .numbers = {{"stray_mm", 0.25}}}},
      {"folds_over", why::foldsOver(), {.says = "it would fold over"}},
      {"point_moves_far",
       why::pointMovesFar(0.5, 0.25),
       {.says = "would move 0.5 mm, its poles 0.25 mm",
        .numbers = {{"move_mm", 0.5}, {"pole_move_mm", 0.25}}}},
      {"checks_fail", why::checksFail(), {.says = "OpenCASCADE's checks do not pass"}},
      {"volume_changes",
       why::volumeChanges(2, 0.5, 0.25),
       {.says = "of solid 2 would change by 0.5 mm3, more than 0.25 mm3",
        .numbers = {{"solid", 2}, {"change_mm3", 0.5}, {"explained_mm3", 0.25}}}},
      {"moves_too_far",
       why::movesTooFar(0.5, 0.25),
       {.says = "by 0.5 mm, more than 0.25 mm", .numbers = {{"move_mm", 0.5}, {"limit_mm", 0.25}}}},
      {"passes_through",
       why::passesThrough(7),
       {.says = "it would pass through face 7", .faces = {7}}},
      {"nothing_proven", why::nothingProven(true), {.says = "of the faces beside it was proven"}},
      {"nothing_proven", why::nothingProven(false), {.says = "no change was proven"}},
      {"instance_less_certain", why::instanceLessCertain(), {.says = "it is less certain"}},
  };
}

Rows rowsOfFairness() {
  const SurfaceChange change{
      .before = {.variation_per_mm = 0.25, .inflections = 3, .lines = 40},
      .after = {.variation_per_mm = 0.5, .inflections = 21, .lines = 40},
  };
  return {
      {"less_fair",
       why::lessFair(SurfaceFault::Variation, change),
       {.says = "by 0.5 per mm along a line, before by 0.25",
        .numbers = {{"variation_before_per_mm", 0.25}, {"variation_after_per_mm", 0.5}}}},
      // The text has the difference of the two numbers.
      {"less_fair",
       why::lessFair(SurfaceFault::Inflections, change),
       {.says = "it has 18 more inflections along 40 lines",
        .numbers = {{"inflections_before", 3}, {"inflections_after", 21}, {"lines", 40}},
        .silent = {3, 21},
        .foreign = {18}}},
  };
}

/// A reason with two numbers, a face and an edge.
RepairReason sample() {
  return {.fault = RepairFault::VolumeChanges,
          .text = "from 0.5 to 0.25 at face 7 and edge 11",
          .numbers = {{"from", 0.5}, {"to", 0.25}},
          .faces = {7},
          .edges = {11}};
}

ExpectedReason sampleThat(const std::string& says) {
  return {.says = says, .numbers = {{"from", 0.5}, {"to", 0.25}}, .faces = {7}, .edges = {11}};
}

Rows rowsOfReasonsOfReasons() {
  const std::string code = "volume_changes";
  ExpectedReason on_face = sampleThat("face 9: from 0.5"),
                 of_instance = sampleThat("instance of edge 13: from 0.5");
  on_face.faces = {9, 7};
  of_instance.edges = {13, 11};
  return {
      {code, why::onFace(9, sample()), on_face},
      {code, why::ofInstance(13, sample()), of_instance},
      {code, why::wouldBe(sample()), sampleThat("it would be less fair: from 0.5")},
      {code, why::pathSpoils(sample()), sampleThat("its new pcurve would make worse: from 0.5")},
      {code, why::asSplines(sample()), sampleThat("with its faces as splines: from 0.5")},
      {code, why::withRemark(sample(), "a remark"), sampleThat("edge 11; a remark")},
      {code, why::afterNote("a note", sample()), sampleThat("a note; from 0.5")},
  };
}

Rows rowsOfJoinedReasons() {
  const RepairReason second{.fault = RepairFault::FaceInstances,
                            .text = "to 0.125 at 3 of face 9 and edge 13",
                            .numbers = {{"to", 0.125}, {"at", 3}},
                            .faces = {9},
                            .edges = {13}};
  return {
      {"volume_changes", why::joined(sample(), {}), sampleThat("edge 11")},
      {"volume_changes", why::joined({}, sample()), sampleThat("edge 11")},
      {"volume_changes",
       why::joined(sample(), second),
       {.says = "from 0.5 to 0.25 at face 7 and edge 11; to 0.125 at 3",
        .numbers = {{"from", 0.5}, {"to", 0.25}, {"at", 3}},
        .faces = {7, 9},
        .edges = {11, 13},
        .foreign = {0.125}}},
      {"face_instances",
       why::facesStay({{5, second}, {8, why::hasNonManifoldEdge(17, 4)}}),
       {.says = "edge 13; face 8 has edge 17, where 4 faces meet",
        .numbers = {{"to", 0.125}, {"at", 3}, {"faces", 4}},
        .faces = {5, 9, 8},
        .edges = {13, 17}}},
  };
}

TEST(RepairReasons, EachHasItsCodeNumbersAndLocation) {
  std::set<std::string> codes = expectRows(rowsOfFacesThatStay());
  codes.merge(expectRows(rowsWithoutSolution()));
  codes.merge(expectRows(rowsOfSolutions()));
  codes.merge(expectRows(rowsOfFairness()));
  expectEveryCode<RepairFault>(codes);
}

TEST(RepairReasons, ReasonsOfReasonsKeepFaultNumbersAndLocation) {
  expectRows(rowsOfReasonsOfReasons());
  expectRows(rowsOfJoinedReasons());
}

TEST(RepairReasons, NoReasonStaysNone) {
  for (const RepairReason& reason :
       {why::lessFair(SurfaceFault::None, {}), why::facesStay({}), why::joined({}, {}),
        why::onFace(7, {}), why::ofInstance(11, {}), why::wouldBe({}), why::pathSpoils({}),
        why::asSplines({})}) {
    EXPECT_TRUE(reason.empty());
    EXPECT_EQ(reason.text, "");
    EXPECT_TRUE(reason.faces.empty() && reason.edges.empty() && reason.numbers.empty());
  }
}

}  // namespace
}  // namespace seamwright::test
