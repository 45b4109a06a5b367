// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>

#include <seamwright/occ_adapter/match/match_reasons.hpp>

namespace seamwright::occ {

namespace {

/// In the order of MatchFault.
constexpr std::array match_codes = {"",
                                    "one_of_several_edges",
                                    "face_stays",
                                    "has_level",
                                    "joined_in_poles",
                                    "joined_to_tolerance",
                                    "ends_in_point",
                                    "other_edge_apart",
                                    "face_could_move",
                                    "joined_in_zone",
                                    "face_converted",
                                    "other_seams_worse",
                                    "side_partly_met",
                                    "face_less_fair",
                                    "face_unusable",
                                    "face_instances",
                                    "no_common_boundary",
                                    "side_is_free",
                                    "closed_boundary",
                                    "ends_apart",
                                    "boundaries_apart",
                                    "boundary_folds",
                                    "path_not_fitted",
                                    "face_without_poles",
                                    "face_trimmed",
                                    "face_goes_on",
                                    "face_side_longer",
                                    "face_beyond_surface",
                                    "face_boundary_turns_back",
                                    "join_refused",
                                    "no_exact_join",
                                    "faces_fold",
                                    "misses_tolerance",
                                    "side_ends_away",
                                    "side_ends_tilted",
                                    "side_ends_curved",
                                    "depth_too_small",
                                    "less_fair",
                                    "moves_too_far",
                                    "side_moves",
                                    "folds_over",
                                    "still_misses",
                                    "edges_stray",
                                    "neighbours_apart",
                                    "checks_fail",
                                    "opencascade_failed",
                                    "failed"};

}  // namespace

std::string codeOf(MatchFault fault) {
  static_assert(match_codes.size() == static_cast<std::size_t>(MatchFault::Failed) + 1);
  return match_codes.at(static_cast<std::size_t>(fault));
}

namespace {

/// Of a join that is made, but not kept.
std::string remedyOfLostJoin(MatchFault fault) {
  switch (fault) {
    using enum MatchFault;
    case LessFair:
      return "a larger depth, a lower level, or a larger fairness";
    case MovesTooFar:
      return "a larger limit of the move";
    case FoldsOver:
      return "a larger depth, or let the other face move";
    case EdgesStray:
      return "hold the other edges, or match their faces too";
    case NeighboursApart:
      return "let one face move instead of both";
    case ChecksFail:
      return "let the other face move, or a smaller limit of the move";
    default:
      return {};
  }
}

}  // namespace

std::string remedyOf(MatchFault fault) {
  switch (fault) {
    using enum MatchFault;
    case NoCommonBoundary:
    case SideIsFree:
      return "a larger matching distance, or edges that meet";
    case EndsApart:
    case BoundariesApart:
      return "cut the longer boundary, or a larger matching distance";
    case ClosedBoundary:
      return "cut both faces in two across the boundary";
    case FaceWithoutPoles:
      return "convert the face to a spline, or let the other face move";
    case FaceCouldMove:
      return "let the other face move";
    case FaceTrimmed:
    case FaceGoesOn:
    case FaceSideLonger:
    case FaceBeyondSurface:
    case FaceBoundaryTurnsBack:
      return "let the other face move, or rebuild the face so that it ends at the boundary";
    case FaceUnusable:
      return "replace the face";
    case FaceInstances:
      return "match the part alone, and place it again";
    case BoundaryFolds:
    case PathNotFitted:
      return "repair the edges in the program that made them";
    case FacesFold:
      return "none: no small move makes the faces smooth";
    case JoinRefused:
    case NoExactJoin:
      return "let one face move instead of both";
    case MissesTolerance:
    case StillMisses:
      return "a larger tolerance, a lower level, a larger depth, or hold nothing";
    case DepthTooSmall:
      return "a larger depth";
    case SideEndsAway:
    case SideEndsTilted:
    case SideEndsCurved:
    case SideMoves:
      return "hold nothing, or match the faces beside the boundary first";
    case OpenCascadeFailed:
    case Failed:
      return "report the model";
    default:
      return remedyOfLostJoin(fault);
  }
}

namespace match_why {

std::string textOf(const std::vector<MatchReason>& remarks,
                   const std::vector<MatchReason>& failures) {
  std::string all;
  for (const std::vector<MatchReason>* reasons : {&remarks, &failures})
    for (const MatchReason& reason : *reasons) all += (all.empty() ? "" : "; ") + reason.text;
  return all;
}

void add(std::vector<MatchReason>& reasons, MatchReason reason) {
  if (reason.empty() || std::ranges::count(reasons, reason.text, &MatchReason::text) > 0) return;
  reasons.push_back(std::move(reason));
}

MatchReason oneOfSeveralEdges(const std::vector<int>& common, int taken, bool is_longest) {
  MatchReason reason{
      .fault = MatchFault::OneOfSeveralEdges,
      .text = fmt::format("of the common edges {}, edge {}{} was taken", fmt::join(common, ", "),
                          taken, is_longest ? ", the longest," : ""),
      .edges = {taken}};
  std::ranges::remove_copy(common, std::back_inserter(reason.edges), taken);
  return reason;
}

MatchReason faceStays(MatchReason obstacle) {
  obstacle.fault = MatchFault::FaceStays;
  obstacle.text += ", so it stays";
  return obstacle;
}

MatchReason hasLevel() {
  return {.fault = MatchFault::HasLevel,
          .text = "the faces already reach the target; nothing had to move"};
}

MatchReason joinedInPoles(int repeated) {
  constexpr std::array knots = {"", ", inner knots along the seam repeated once more",
                                ", inner knots along the seam repeated twice more"};
  return {.fault = MatchFault::JoinedInPoles,
          .text = fmt::format("joined in poles{}", knots.at(static_cast<std::size_t>(repeated))),
          .numbers = {{"repeated", repeated}}};
}

MatchReason joinedToTolerance(int halvings) {
  MatchReason reason{.fault = MatchFault::JoinedToTolerance,
                     .text = "joined to the tolerance",
                     .numbers = {{"halvings", halvings}}};
  if (halvings > 0)
    reason.text +=
        fmt::format(", knot spans halved {} {}", halvings, halvings == 1 ? "time" : "times");
  return reason;
}

MatchReason endsInPoint(int face) {
  return {.fault = MatchFault::EndsInPoint,
          .text = fmt::format("face {} ends in a point at the seam, where its curvature may have "
                              "become very large",
                              face),
          .faces = {face}};
}

MatchReason otherEdgeApart(double gap_mm) {
  return {.fault = MatchFault::OtherEdgeApart,
          .text = fmt::format("at another edge that the faces share they are {:.6g} mm apart now",
                              gap_mm),
          .numbers = {{"gap_mm", gap_mm}}};
}

MatchReason faceCouldMove(int face) {
  return {.fault = MatchFault::FaceCouldMove,
          .text = fmt::format("face {} could move", face),
          .faces = {face}};
}

MatchReason joinedInZone(double depth_mm) {
  return {.fault = MatchFault::JoinedInZone,
          .text = fmt::format("joined to the tolerance by a change up to {:.4g} mm from the side",
                              depth_mm),
          .numbers = {{"depth_mm", depth_mm}}};
}

MatchReason faceConverted(int face, const std::string& kind, double error_mm) {
  return {.fault = MatchFault::FaceConverted,
          .text = fmt::format("face {}, {}, became a spline, up to {:.3g} mm away", face, kind,
                              error_mm),
          .numbers = {{"error_mm", error_mm}},
          .faces = {face}};
}

MatchReason otherSeamsWorse(const std::vector<int>& edges) {
  return {.fault = MatchFault::OtherSeamsWorse,
          .text = fmt::format("other seams of the moved faces lost a level: edge {}",
                              fmt::join(edges, ", edge ")),
          .edges = edges};
}

MatchReason sidePartlyMet(const std::vector<int>& edges, double met_mm, double length_mm) {
  return {.fault = MatchFault::SidePartlyMet,
          .text = fmt::format("of the side of edge {}, {:.6g} of {:.6g} mm meet a neighbour",
                              fmt::join(edges, ", "), met_mm, length_mm),
          .numbers = {{"met_mm", met_mm}, {"length_mm", length_mm}},
          .edges = edges};
}

MatchReason sideIsFree(const std::vector<int>& edges, double match_mm) {
  return {.fault = MatchFault::SideIsFree,
          .text = fmt::format("no chosen edge meets the side of edge {} within {:.6g} mm",
                              fmt::join(edges, ", "), match_mm),
          .numbers = {{"match_mm", match_mm}},
          .edges = edges};
}

MatchReason depthTooSmall(int face, double depth_mm) {
  return {.fault = MatchFault::DepthTooSmall,
          .text = fmt::format("face {} has no poles that act only within {:.4g} mm of the side",
                              face, depth_mm),
          .numbers = {{"depth_mm", depth_mm}},
          .faces = {face}};
}

namespace {

MatchReason ofFairness(MatchFault fault, const char* verb, int face, const FaceMove& move) {
  MatchReason reason{
      .fault = fault,
      .text = fmt::format("face {} {} less fair: {}", face, verb, move.less_fair.text),
      .faces = {face}};
  if (move.surface) {
    reason.numbers.emplace_back("before_per_mm", move.surface->before.variation_per_mm);
    reason.numbers.emplace_back("after_per_mm", move.surface->after.variation_per_mm);
  }
  return reason;
}

}  // namespace

MatchReason lessFair(int face, const FaceMove& move) {
  return ofFairness(MatchFault::LessFair, "would be", face, move);
}

MatchReason isLessFair(int face, const FaceMove& move) {
  return ofFairness(MatchFault::FaceLessFair, "is", face, move);
}

MatchReason faceUnusable(int face, const std::string& fault) {
  return onFace(face, {.fault = MatchFault::FaceUnusable, .text = fault});
}

MatchReason faceInstances(int face, int count) {
  return onFace(face, {.fault = MatchFault::FaceInstances,
                       .text = fmt::format("or an edge of it stands in the model {} times", count),
                       .numbers = {{"count", count}}});
}

MatchReason noCommonBoundary(double match_mm) {
  return {.fault = MatchFault::NoCommonBoundary,
          .text = fmt::format("the faces have no common boundary: no edge is shared, and no free "
                              "edges run side by side within {:.6g} mm",
                              match_mm),
          .numbers = {{"match_mm", match_mm}}};
}

MatchReason noCommonBoundary(double match_mm, double apart_mm) {
  MatchReason reason = noCommonBoundary(match_mm);
  reason.text += fmt::format("; the faces are {:.6g} mm apart", apart_mm);
  reason.numbers.emplace_back("apart_mm", apart_mm);
  return reason;
}

MatchReason closedBoundary() {
  return {.fault = MatchFault::ClosedBoundary,
          .text =
              "the common boundary is a closed loop, or no longer than the gap tolerance, "
              "which is not handled"};
}

MatchReason endsApart(double apart_mm) {
  return {.fault = MatchFault::EndsApart,
          .text = fmt::format("the ends of the boundaries are {:.6g} mm apart: only boundaries "
                              "that run side by side over their whole length can be joined",
                              apart_mm),
          .numbers = {{"apart_mm", apart_mm}}};
}

MatchReason boundariesApart(double near_mm, double side_by_side_mm, double length_mm) {
  return {
      .fault = MatchFault::BoundariesApart,
      .text = fmt::format(
          "the boundaries are within {:.6g} mm of one another over {:.6g} of {:.6g} mm only",
          near_mm, side_by_side_mm, length_mm),
      .numbers = {
          {"near_mm", near_mm}, {"side_by_side_mm", side_by_side_mm}, {"length_mm", length_mm}}};
}

MatchReason boundaryFolds() {
  return {.fault = MatchFault::BoundaryFolds, .text = "the boundaries turn back on one another"};
}

MatchReason pathNotFitted(int face, int pieces, double stray_mm, double limit_mm) {
  return {.fault = MatchFault::PathNotFitted,
          .text = fmt::format(
              "the boundary's path on face {} can't be brought to the parameter of the other face: "
              "{} pieces keep within {:.6g} mm of it, not {:.6g} mm",
              face, pieces, stray_mm, limit_mm),
          .numbers = {{"pieces", pieces}, {"stray_mm", stray_mm}, {"limit_mm", limit_mm}},
          .faces = {face}};
}

MatchReason hasNoPoles(const std::string& kind) {
  return {.fault = MatchFault::FaceWithoutPoles,
          .text = fmt::format("is {}, which has no poles to move", kind)};
}

MatchReason isTrimmed() {
  return {.fault = MatchFault::FaceTrimmed,
          .text = "is trimmed along the boundary, which is not a parameter line of its surface"};
}

MatchReason goesOn() {
  return {.fault = MatchFault::FaceGoesOn, .text = "continues beyond the boundary"};
}

MatchReason sideIsLonger() {
  return {.fault = MatchFault::FaceSideLonger,
          .text = "has a side of which the boundary is a part only"};
}

MatchReason reachesBeyond() {
  return {.fault = MatchFault::FaceBeyondSurface,
          .text = "reaches beyond its surface, or across the origin of a periodic one"};
}

MatchReason boundaryTurnsBack() {
  return {.fault = MatchFault::FaceBoundaryTurnsBack,
          .text = "has a boundary that turns back on itself"};
}

MatchReason onFace(int face, MatchReason obstacle) {
  obstacle.text = fmt::format("face {} {}", face, obstacle.text);
  obstacle.faces.insert(obstacle.faces.begin(), face);
  return obstacle;
}

MatchReason joinRefused(const std::string& why) {
  return {.fault = MatchFault::JoinRefused, .text = why};
}

MatchReason noExactJoin() {
  return {.fault = MatchFault::NoExactJoin,
          .text = "the poles that stay, or the knots, allow no exact join"};
}

MatchReason facesFold() {
  return {
      .fault = MatchFault::FacesFold,
      .text = "the faces leave the boundary to the same side and would fold back on one another"};
}

MatchReason missesTolerance(int halvings, double missed) {
  return {.fault = MatchFault::MissesTolerance,
          .text = fmt::format("with knot spans halved up to {} times the worst figure is {:.6g} "
                              "times its tolerance",
                              halvings, missed),
          .numbers = {{"halvings", halvings}, {"times_tolerance", missed}}};
}

MatchReason sideEndsAway(double gap_mm) {
  return {.fault = MatchFault::SideEndsAway,
          .text = fmt::format("a side ends {:.6g} mm away from the other face", gap_mm),
          .numbers = {{"gap_mm", gap_mm}}};
}

MatchReason sideEndsTilted(double angle_deg) {
  return {.fault = MatchFault::SideEndsTilted,
          .text = fmt::format(
              "a side ends at {:.6g} degrees to the tangent plane of the other face", angle_deg),
          .numbers = {{"angle_deg", angle_deg}}};
}

MatchReason sideEndsCurved(double own_per_mm, double other_per_mm) {
  return {
      .fault = MatchFault::SideEndsCurved,
      .text = fmt::format("a side ends with a normal curvature of {:.6g} per mm where the other "
                          "face has {:.6g}",
                          own_per_mm, other_per_mm),
      .numbers = {{"own_per_mm", own_per_mm}, {"other_per_mm", other_per_mm}}};
}

MatchReason movesTooFar(double move_mm, double limit_mm) {
  return {.fault = MatchFault::MovesTooFar,
          .text = fmt::format("the join needs a move of {:.6g} mm, more than {:.6g} mm", move_mm,
                              limit_mm),
          .numbers = {{"move_mm", move_mm}, {"limit_mm", limit_mm}}};
}

MatchReason sideMoves(int face, double move_mm) {
  return {
      .fault = MatchFault::SideMoves,
      .text = fmt::format("a boundary of face {} that ends at the seam would move by {:.6g} mm: "
                          "it is trimmed, and only whole sides of a surface can be held",
                          face, move_mm),
      .numbers = {{"move_mm", move_mm}},
      .faces = {face}};
}

MatchReason foldsOver(const MatchReason& how, int face) {
  return {.fault = MatchFault::FoldsOver,
          .text = fmt::format("{}: face {} would fold over", how.text, face),
          .numbers = how.numbers,
          .faces = {face}};
}

MatchReason stillMisses(const MatchReason& how, const std::string& figures) {
  return {.fault = MatchFault::StillMisses,
          .text = fmt::format("{}, but then {}", how.text, figures),
          .numbers = how.numbers};
}

MatchReason edgesStray(const MatchReason& how, double stray_mm) {
  MatchReason reason{.fault = MatchFault::EdgesStray,
                     .text = fmt::format("{}, but then edges are {:.6g} mm away from their faces",
                                         how.text, stray_mm),
                     .numbers = how.numbers};
  reason.numbers.emplace_back("stray_mm", stray_mm);
  return reason;
}

MatchReason neighboursApart(const MatchReason& how, const std::vector<int>& edges, double gap_mm) {
  MatchReason reason{.fault = MatchFault::NeighboursApart,
                     .text = fmt::format("{}, but then faces that join one another at edge {} are "
                                         "{:.6g} mm apart",
                                         how.text, fmt::join(edges, " and edge "), gap_mm),
                     .numbers = how.numbers,
                     .edges = edges};
  reason.numbers.emplace_back("gap_mm", gap_mm);
  return reason;
}

MatchReason checksFail(const MatchReason& how) {
  return {.fault = MatchFault::ChecksFail,
          .text = how.text + ", but OpenCASCADE's checks do not pass",
          .numbers = how.numbers};
}

MatchReason openCascadeFailed(const Standard_Failure& failure) {
  return {.fault = MatchFault::OpenCascadeFailed,
          .text = fmt::format("OpenCASCADE failed: {} {}", failure.DynamicType()->Name(),
                              failure.GetMessageString())};
}

MatchReason failed(const std::string& message) {
  return {.fault = MatchFault::Failed, .text = message};
}

}  // namespace match_why

}  // namespace seamwright::occ
