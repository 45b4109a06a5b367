// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <StdFail_NotDone.hxx>

#include <seamwright/occ_adapter/match/match_reasons.hpp>

#include "reason_rows.hpp"

namespace seamwright::test {
namespace {

using occ::MatchFault;
using occ::MatchReason;
using Rows = std::vector<ReasonRow<MatchReason>>;

namespace why = occ::match_why;

occ::FaceMove lessFairMove() {
  occ::FaceMove move{7, 0.1};
  move.surface.emplace();
  move.surface->before.variation_per_mm = 0.25;
  move.surface->after.variation_per_mm = 0.5;
  move.less_fair.text = "it varies by 0.5";
  move.less_fair.fault = occ::RepairFault::LessFair;
  return move;
}

Rows rowsOfRemarks() {
  return {
      {"one_of_several_edges",
       why::oneOfSeveralEdges({11, 13, 17}, 13, true),
       {.says = "of the common edges 11, 13, 17, edge 13, the longest, was taken",
        .edges = {13, 11, 17}}},
      {"one_of_several_edges",
       why::oneOfSeveralEdges({11, 13}, 13, false),
       {.says = "of the common edges 11, 13, edge 13 was taken", .edges = {13, 11}}},
      {"face_stays",
       why::faceStays(why::pathNotFitted(7, 16, 0.5, 0.25)),
       {.says = "not 0.25 mm, so it stays",
        .numbers = {{"pieces", 16}, {"stray_mm", 0.5}, {"limit_mm", 0.25}},
        .faces = {7}}},
      {"has_level", why::hasLevel(), {.says = "nothing had to move"}},
      {"joined_in_poles",
       why::joinedInPoles(0),
       {.says = "joined in poles", .numbers = {{"repeated", 0}}, .silent = {0}}},
      {"joined_in_poles",
       why::joinedInPoles(1),
       {.says = "repeated once more", .numbers = {{"repeated", 1}}, .silent = {1}}},
      {"joined_in_poles",
       why::joinedInPoles(2),
       {.says = "repeated twice more", .numbers = {{"repeated", 2}}, .silent = {2}}},
      {"joined_to_tolerance",
       why::joinedToTolerance(0),
       {.says = "joined to the tolerance", .numbers = {{"halvings", 0}}, .silent = {0}}},
      {"joined_to_tolerance",
       why::joinedToTolerance(1),
       {.says = "knot spans halved 1 time", .numbers = {{"halvings", 1}}}},
      {"joined_to_tolerance",
       why::joinedToTolerance(3),
       {.says = "knot spans halved 3 times", .numbers = {{"halvings", 3}}}},
      {"ends_in_point",
       why::endsInPoint(7),
       {.says = "face 7 ends in a point at the seam", .faces = {7}}},
      {"other_edge_apart",
       why::otherEdgeApart(0.25),
       {.says = "they are 0.25 mm apart now", .numbers = {{"gap_mm", 0.25}}}},
      {"joined_in_zone",
       why::joinedInZone(12.5),
       {.says = "by a change up to 12.5 mm from the side", .numbers = {{"depth_mm", 12.5}}}},
      {"face_converted",
       why::faceConverted(7, "a plane", 0.25),
       {.says = "face 7, a plane, became a spline, up to 0.25 mm away",
        .numbers = {{"error_mm", 0.25}},
        .faces = {7}}},
      {"other_seams_worse",
       why::otherSeamsWorse({11, 13}),
       {.says = "lost a level: edge 11, edge 13", .edges = {11, 13}}},
      {"neighbours_apart",
       why::neighboursApart(why::joinedInZone(12.5), {11, 13}, 0.25),
       {.says = "join one another at edge 11 and edge 13 are 0.25 mm apart",
        .numbers = {{"depth_mm", 12.5}, {"gap_mm", 0.25}},
        .edges = {11, 13}}},
      {"side_partly_met",
       why::sidePartlyMet({11, 13}, 2.5, 12.5),
       {.says = "of the side of edge 11, 13, 2.5 of 12.5 mm meet a neighbour",
        .numbers = {{"met_mm", 2.5}, {"length_mm", 12.5}},
        .edges = {11, 13}}},
      {"face_less_fair",
       why::isLessFair(7, lessFairMove()),
       {.says = "face 7 is less fair: it varies by 0.5",
        .numbers = {{"before_per_mm", 0.25}, {"after_per_mm", 0.5}},
        .faces = {7},
        .silent = {0.25}}},
      {"face_could_move", why::faceCouldMove(7), {.says = "face 7 could move", .faces = {7}}},
  };
}

Rows rowsOfBoundaries() {
  return {
      {"face_unusable",
       why::faceUnusable(7, "has the number inf"),
       {.says = "face 7 has the number inf", .faces = {7}}},
      {"face_instances",
       why::faceInstances(7, 3),
       {.says = "face 7 or an edge of it stands in the model 3 times",
        .numbers = {{"count", 3}},
        .faces = {7}}},
      {"no_common_boundary",
       why::noCommonBoundary(0.25),
       {.says = "side by side within 0.25 mm", .numbers = {{"match_mm", 0.25}}}},
      {"no_common_boundary",
       why::noCommonBoundary(0.25, 0.5),
       {.says = "within 0.25 mm; the faces are 0.5 mm apart",
        .numbers = {{"match_mm", 0.25}, {"apart_mm", 0.5}}}},
      {"side_is_free",
       why::sideIsFree({11}, 0.25),
       {.says = "no chosen edge meets the side of edge 11 within 0.25 mm",
        .numbers = {{"match_mm", 0.25}},
        .edges = {11}}},
      {"depth_too_small",
       why::depthTooSmall(7, 0.25),
       {.says = "face 7 has no poles that act only within 0.25 mm",
        .numbers = {{"depth_mm", 0.25}},
        .faces = {7}}},
      {"less_fair",
       why::lessFair(7, lessFairMove()),
       {.says = "face 7 would be less fair: it varies by 0.5",
        .numbers = {{"before_per_mm", 0.25}, {"after_per_mm", 0.5}},
        .faces = {7},
        .silent = {0.25}}},
      {"closed_boundary", why::closedBoundary(), {.says = "a closed loop, or no longer"}},
      {"ends_apart",
       why::endsApart(0.25),
       {.says = "ends of the boundaries are 0.25 mm apart", .numbers = {{"apart_mm", 0.25}}}},
      {"boundaries_apart",
       why::boundariesApart(0.25, 2.5, 10),
       {.says = "within 0.25 mm of one another over 2.5 of 10 mm only",
        .numbers = {{"near_mm", 0.25}, {"side_by_side_mm", 2.5}, {"length_mm", 10}}}},
      {"boundary_folds", why::boundaryFolds(), {.says = "boundaries turn back on one another"}},
      {"path_not_fitted",
       why::pathNotFitted(7, 16, 0.5, 0.25),
       {.says = "16 pieces keep within 0.5 mm of it, not 0.25 mm",
        .numbers = {{"pieces", 16}, {"stray_mm", 0.5}, {"limit_mm", 0.25}},
        .faces = {7}}},
  };
}

Rows rowsOfFacesThatStay() {
  return {
      {"face_without_poles",
       why::hasNoPoles("a plane"),
       {.says = "is a plane, which has no poles"}},
      {"face_trimmed", why::isTrimmed(), {.says = "is trimmed along the boundary"}},
      {"face_goes_on", why::goesOn(), {.says = "continues beyond the boundary"}},
      {"face_side_longer", why::sideIsLonger(), {.says = "the boundary is a part only"}},
      {"face_beyond_surface", why::reachesBeyond(), {.says = "reaches beyond its surface"}},
      {"face_boundary_turns_back", why::boundaryTurnsBack(), {.says = "turns back on itself"}},
      {"face_trimmed", why::onFace(7, why::isTrimmed()), {.says = "face 7 is t", .faces = {7}}},
  };
}

Rows rowsWithoutJoin() {
  return {
      {"join_refused", why::joinRefused("no tangent"), {.says = "no tangent"}},
      {"no_exact_join", why::noExactJoin(), {.says = "allow no exact join"}},
      {"faces_fold", why::facesFold(), {.says = "would fold back on one another"}},
      {"misses_tolerance",
       why::missesTolerance(3, 2.5),
       {.says = "halved up to 3 times the worst figure is 2.5 times its tolerance",
        .numbers = {{"halvings", 3}, {"times_tolerance", 2.5}}}},
      {"side_ends_away",
       why::sideEndsAway(0.25),
       {.says = "ends 0.25 mm away from the other face", .numbers = {{"gap_mm", 0.25}}}},
      {"side_ends_tilted",
       why::sideEndsTilted(12.5),
       {.says = "ends at 12.5 degrees to the tangent plane", .numbers = {{"angle_deg", 12.5}}}},
      {"side_ends_curved",
       why::sideEndsCurved(0.5, 0.25),
       {.says = "curvature of 0.5 per mm where the other face has 0.25",
        .numbers = {{"own_per_mm", 0.5}, {"other_per_mm", 0.25}}}},
      {"moves_too_far",
       why::movesTooFar(0.5, 0.25),
       {.says = "a move of 0.5 mm, more than 0.25 mm",
        .numbers = {{"move_mm", 0.5}, {"limit_mm", 0.25}}}},
      {"side_moves",
       why::sideMoves(7, 0.25),
       {.says = "of face 7 that ends at the seam would move by 0.25 mm",
        .numbers = {{"move_mm", 0.25}},
        .faces = {7}}},
  };
}

/// Joins that are not kept have the numbers of how they were made.
Rows rowsOfJoins() {
  const MatchReason how = why::joinedToTolerance(3);
  const Numbers numbers = {{"halvings", 3}};
  return {
      {"folds_over",
       why::foldsOver(how, 7),
       {.says = "halved 3 times: face 7 would fold over", .numbers = numbers, .faces = {7}}},
      {"still_misses",
       why::stillMisses(how, "gap 0.5 mm"),
       {.says = "halved 3 times, but then gap 0.5 mm", .numbers = numbers, .foreign = {0.5}}},
      {"edges_stray",
       why::edgesStray(how, 0.25),
       {.says = "halved 3 times, but then edges are 0.25 mm away",
        .numbers = {{"halvings", 3}, {"stray_mm", 0.25}}}},
      {"checks_fail",
       why::checksFail(how),
       {.says = "halved 3 times, but OpenCASCADE's checks do not pass", .numbers = numbers}},
      {"opencascade_failed",
       why::openCascadeFailed(StdFail_NotDone("a test")),
       {.says = "OpenCASCADE failed: StdFail_NotDone a test"}},
      {"failed", why::failed("no normal"), {.says = "no normal"}},
  };
}

TEST(MatchReasons, EachHasItsCodeNumbersAndLocation) {
  std::set<std::string> codes = expectRows(rowsOfRemarks());
  codes.merge(expectRows(rowsOfBoundaries()));
  codes.merge(expectRows(rowsOfFacesThatStay()));
  codes.merge(expectRows(rowsWithoutJoin()));
  codes.merge(expectRows(rowsOfJoins()));
  expectEveryCode<MatchFault>(codes);
}

TEST(MatchReasons, AreAddedOnce) {
  std::vector<MatchReason> reasons;
  why::add(reasons, {});
  EXPECT_TRUE(reasons.empty());
  why::add(reasons, why::movesTooFar(0.5, 0.25));
  why::add(reasons, why::hasLevel());
  why::add(reasons, why::movesTooFar(0.5, 0.25));
  ASSERT_EQ(reasons.size(), 2);
  EXPECT_EQ(codeOf(reasons[0].fault), "moves_too_far");
  EXPECT_EQ(codeOf(reasons[1].fault), "has_level");
}

}  // namespace
}  // namespace seamwright::test
