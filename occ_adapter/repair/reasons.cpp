// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <seamwright/occ_adapter/repair/reasons.hpp>

namespace seamwright::occ {

namespace {

/// In the order of RepairFault.
constexpr std::array repair_codes = {"",
                                     "not_measured",
                                     "has_level",
                                     "face_fixed",
                                     "face_held",
                                     "face_unusable",
                                     "face_instances",
                                     "face_non_manifold",
                                     "face_without_poles",
                                     "faces_fold",
                                     "surface_kink",
                                     "misses_tolerance",
                                     "sides_apart",
                                     "surfaces_apart",
                                     "path_not_enough",
                                     "time_limit",
                                     "opencascade_failed",
                                     "failed",
                                     "still_misses",
                                     "spoils_seam",
                                     "edge_strays",
                                     "folds_over",
                                     "point_moves_far",
                                     "checks_fail",
                                     "volume_changes",
                                     "moves_too_far",
                                     "less_fair",
                                     "passes_through",
                                     "nothing_proven",
                                     "instance_less_certain"};

RepairReason prefixed(const std::string& prefix, RepairReason reason) {
  if (!reason.empty()) reason.text = prefix + reason.text;
  return reason;
}

}  // namespace

std::string codeOf(RepairFault fault) {
  static_assert(repair_codes.size() ==
                static_cast<std::size_t>(RepairFault::InstanceLessCertain) + 1);
  return repair_codes.at(static_cast<std::size_t>(fault));
}

namespace why {

RepairReason isFixed() {
  return {.fault = RepairFault::FaceFixed, .text = "is fixed"};
}

RepairReason isHeld() {
  return {.fault = RepairFault::FaceHeld,
          .text = "stays, because its move makes a seam worse in the file"};
}

RepairReason isUnusable(const std::string& fault) {
  return {.fault = RepairFault::FaceUnusable, .text = fault};
}

RepairReason hasUnusableNeighbour(int edge, int face, const std::string& fault) {
  return {.fault = RepairFault::FaceUnusable,
          .text = fmt::format("has edge {} in common with face {}, which {}", edge, face, fault),
          .faces = {face},
          .edges = {edge}};
}

RepairReason hasInstances(int count) {
  return {.fault = RepairFault::FaceInstances,
          .text = fmt::format("occurs in the model {} times", count),
          .numbers = {{"count", count}}};
}

RepairReason hasEdgeWithInstances(int edge, int count) {
  return {.fault = RepairFault::FaceInstances,
          .text = fmt::format("has edge {}, which occurs in the model {} times", edge, count),
          .numbers = {{"count", count}},
          .edges = {edge}};
}

RepairReason hasNonManifoldEdge(int edge, int faces) {
  return {.fault = RepairFault::FaceNonManifold,
          .text = fmt::format("has edge {}, where {} faces meet", edge, faces),
          .numbers = {{"faces", faces}},
          .edges = {edge}};
}

RepairReason hasNoPoles(const std::string& kind) {
  return {.fault = RepairFault::FaceWithoutPoles,
          .text = fmt::format("is {}, which has no poles to move", kind)};
}

RepairReason facesStay(const std::vector<std::pair<int, RepairReason>>& obstacles) {
  RepairReason result;
  for (const auto& [face, obstacle] : obstacles) {
    RepairReason of_face = prefixed(fmt::format("face {} ", face), obstacle);
    of_face.faces.insert(of_face.faces.begin(), face);
    result = joined(std::move(result), of_face);
  }
  return result;
}

RepairReason notMeasured(const std::string& note) {
  return {.fault = RepairFault::NotMeasured,
          .text = note.empty()                       ? "it can't be measured"
                  : note.starts_with("not measured") ? note
                                                     : "it can't be measured: " + note};
}

RepairReason hasLevel() {
  return {.fault = RepairFault::HasLevel, .text = "it already reaches the target"};
}

RepairReason facesFold(double at) {
  return {.fault = RepairFault::FacesFold,
          .text = fmt::format("the faces fold back on one another there, first at {:.6g} of its "
                              "length: no small move makes that smooth",
                              at),
          .numbers = {{"at", at}}};
}

RepairReason surfaceKink(int face, double turn_deg, double at) {
  return {
      .fault = RepairFault::SurfaceKink,
      .text = fmt::format("the surface of face {} has a kink of {:.3g} degrees across the edge, "
                          "at {:.3g} of its length: no smooth move takes that out",
                          face, turn_deg, at),
      .numbers = {{"turn_deg", turn_deg}, {"at", at}},
      .faces = {face}};
}

RepairReason missesTolerance(double missed, double limit_mm) {
  const bool is_limited = std::isfinite(limit_mm);
  RepairReason reason{
      .fault = RepairFault::MissesTolerance,
      .text = fmt::format("a fair move of the faces beside it{} leaves {:.3g} times the tolerance",
                          is_limited ? fmt::format(", of no more than {:.3g} mm,", limit_mm) : "",
                          missed),
      .numbers = {{"times_tolerance", missed}}};
  if (is_limited) reason.numbers.emplace_back("limit_mm", limit_mm);
  return reason;
}

RepairReason sidesApart(double apart_mm) {
  return {.fault = RepairFault::SidesApart,
          .text = fmt::format("its sides are {:.6g} mm apart at an end", apart_mm),
          .numbers = {{"apart_mm", apart_mm}}};
}

RepairReason surfacesApart() {
  return {.fault = RepairFault::SurfacesApart, .text = "the surfaces do not meet near the edge"};
}

RepairReason pathNotEnough() {
  return {.fault = RepairFault::PathNotEnough,
          .text = "new pcurves of the edge alone do not make it smooth"};
}

RepairReason timeLimit() {
  return {.fault = RepairFault::TimeLimit, .text = "the time limit was reached first"};
}

RepairReason failed(const Standard_Failure& failure) {
  return {.fault = RepairFault::OpenCascadeFailed,
          .text = fmt::format("OpenCASCADE failed: {} {}", failure.DynamicType()->Name(),
                              failure.GetMessageString())};
}

RepairReason failed(const std::string& message) {
  return {.fault = RepairFault::Failed, .text = message};
}

RepairReason stillMisses(const std::string& figures) {
  return {.fault = RepairFault::StillMisses, .text = "after a move it has " + figures};
}

RepairReason spoilsSeam(int edge, const std::string& change, const std::string& after,
                        const std::string& before) {
  return {.fault = RepairFault::SpoilsSeam,
          .text = fmt::format("edge {} would get {} ({}; before {})", edge, change, after, before),
          .edges = {edge}};
}

RepairReason edgeStrays(double stray_mm) {
  return {.fault = RepairFault::EdgeStrays,
          .text = fmt::format("an edge of it would be {:.6g} mm away", stray_mm),
          .numbers = {{"stray_mm", stray_mm}}};
}

RepairReason foldsOver() {
  return {.fault = RepairFault::FoldsOver, .text = "it would fold over"};
}

RepairReason pointMovesFar(double move_mm, double pole_move_mm) {
  return {.fault = RepairFault::PointMovesFar,
          .text = fmt::format("a point of it would move {:.6g} mm, its poles {:.6g} mm", move_mm,
                              pole_move_mm),
          .numbers = {{"move_mm", move_mm}, {"pole_move_mm", pole_move_mm}}};
}

RepairReason checksFail() {
  return {.fault = RepairFault::ChecksFail, .text = "OpenCASCADE's checks do not pass"};
}

RepairReason volumeChanges(int solid, double change_mm3, double explained_mm3) {
  return {
      .fault = RepairFault::VolumeChanges,
      .text = fmt::format("the volume of solid {} would change by {:.6g} mm3, more than {:.6g} "
                          "mm3, which the moves explain",
                          solid, change_mm3, explained_mm3),
      .numbers = {{"solid", solid}, {"change_mm3", change_mm3}, {"explained_mm3", explained_mm3}}};
}

RepairReason movesTooFar(double move_mm, double limit_mm) {
  return {.fault = RepairFault::MovesTooFar,
          .text = fmt::format("it would move by {:.6g} mm, more than {:.6g} mm", move_mm, limit_mm),
          .numbers = {{"move_mm", move_mm}, {"limit_mm", limit_mm}}};
}

RepairReason lessFair(SurfaceFault fault, const SurfaceChange& change) {
  const SurfaceMeasure &before = change.before, &after = change.after;
  switch (fault) {
    case SurfaceFault::None:
      return {};
    case SurfaceFault::Variation:
      return {.fault = RepairFault::LessFair,
              .text = fmt::format("its mean curvature varies by {:.6g} per mm along a line, before "
                                  "by {:.6g}",
                                  after.variation_per_mm, before.variation_per_mm),
              .numbers = {{"variation_before_per_mm", before.variation_per_mm},
                          {"variation_after_per_mm", after.variation_per_mm}}};
    case SurfaceFault::Inflections:
      return {.fault = RepairFault::LessFair,
              .text = fmt::format("it has {} more inflections along {} lines",
                                  after.inflections - before.inflections, after.lines),
              .numbers = {{"inflections_before", before.inflections},
                          {"inflections_after", after.inflections},
                          {"lines", after.lines}}};
  }
  return {};
}

RepairReason wouldBe(RepairReason less_fair) {
  return prefixed("it would be less fair: ", std::move(less_fair));
}

RepairReason passesThrough(int face) {
  return {.fault = RepairFault::PassesThrough,
          .text = fmt::format("it would pass through face {}", face),
          .faces = {face}};
}

RepairReason nothingProven(bool of_its_faces) {
  return {.fault = RepairFault::NothingProven,
          .text = of_its_faces ? "no change of the faces beside it was proven"
                               : "no change was proven"};
}

RepairReason instanceLessCertain() {
  return {.fault = RepairFault::InstanceLessCertain,
          .text = "measured in the position of this instance it is less certain"};
}

RepairReason onFace(int face, RepairReason reason) {
  if (reason.empty()) return reason;
  reason = prefixed(fmt::format("face {}: ", face), std::move(reason));
  reason.faces.insert(reason.faces.begin(), face);
  return reason;
}

RepairReason pathSpoils(RepairReason reason) {
  return prefixed("its new pcurve would make worse: ", std::move(reason));
}

RepairReason ofInstance(int first_edge, RepairReason reason) {
  if (reason.empty()) return reason;
  reason = prefixed(fmt::format("instance of edge {}: ", first_edge), std::move(reason));
  reason.edges.insert(reason.edges.begin(), first_edge);
  return reason;
}

RepairReason asSplines(RepairReason reason) {
  return prefixed("with its faces as splines: ", std::move(reason));
}

RepairReason joined(RepairReason first, const RepairReason& second) {
  if (first.empty()) return second;
  if (second.empty()) return first;
  first.text += "; " + second.text;
  const auto has = [&first](const std::string& name) {
    return std::ranges::count(first.numbers, name, &std::pair<std::string, double>::first) > 0;
  };
  std::ranges::copy_if(second.numbers, std::back_inserter(first.numbers),
                       [&has](const auto& number) { return !has(number.first); });
  first.faces.insert(first.faces.end(), second.faces.begin(), second.faces.end());
  first.edges.insert(first.edges.end(), second.edges.begin(), second.edges.end());
  return first;
}

RepairReason withRemark(RepairReason reason, const std::string& remark) {
  reason.text += (reason.text.empty() ? "" : "; ") + remark;
  return reason;
}

RepairReason afterNote(const std::string& note, RepairReason reason) {
  reason.text = note + "; " + reason.text;
  return reason;
}

}  // namespace why

}  // namespace seamwright::occ
