// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include <seamwright/core/angle.hpp>
#include <seamwright/occ_adapter/fill/clearance.hpp>
#include <seamwright/occ_adapter/fill/fill_form.hpp>
#include <seamwright/occ_adapter/fill/fill_verdict.hpp>
#include <seamwright/occ_adapter/fill/hole_contradiction.hpp>
#include <seamwright/occ_adapter/fill/self_contact.hpp>
#include <seamwright/occ_adapter/repair/prove.hpp>
#include <seamwright/occ_adapter/repair/sew.hpp>

namespace seamwright::occ {

namespace {

/// Whether the seam misses the target for every value that the figures may have.
bool certainlyMisses(const SeamResult& seam, const FillHoleOptions& options) {
  const auto beyond = [](const std::optional<Figure>& figure, double tolerance) {
    return figure && figure->lower > tolerance;
  };
  const ContinuityTolerance& tolerance = options.tolerance;
  return beyond(seam.figures.gap_mm, tolerance.gap_mm) ||
         (options.target >= Level::G1 && beyond(seam.figures.angle_rad, tolerance.angle_rad)) ||
         (options.target >= Level::G2 &&
          beyond(seam.figures.curvature_rel, tolerance.curvature_rel));
}

/// The seam of the largest angle among those that may miss the target; nothing if there is none.
const SeamResult* worstOf(const FillSeams& seams, const FillHoleOptions& options) {
  const SeamResult* worst = nullptr;
  const auto angle = [](const SeamResult& seam) {
    const std::optional<Figure>& found = seam.figures.angle_rad;
    return found ? found->upper.value_or(HUGE_VAL) : HUGE_VAL;
  };
  for (const auto* group : {&seams.outer, &seams.inner})
    for (const SeamResult& seam : *group)
      if (!certainlyReaches(seam.figures, options.tolerance, options.target) &&
          (worst == nullptr || angle(seam) > angle(*worst)))
        worst = &seam;
  return worst;
}

/// The sides that could be met in position only, as a cause; empty if there are none.
std::vector<FillReason> causesOfAngle(const FillTask& task, const HoleCut& cut) {
  if (task.options.target < Level::G1) return {};
  double turn_rad = 0;
  FillReason cause{.fault = FillFault::PositionOnly};
  for (const FilledSide& side : filledSides(task.hole, cut)) {
    if (!side.position_only) continue;
    turn_rad = std::max({turn_rad, side.corner_rad[0], side.corner_rad[1]});
    cause.edges.insert(cause.edges.end(), side.edges.begin(), side.edges.end());
  }
  if (cause.edges.empty()) return {};
  cause.numbers = {{"turn_deg", turn_rad * degrees_per_radian}};
  return {cause};
}

FillReason missed(const FillTask& task, const FillFaces& made, const SewnFill& fill,
                  const FillSeams& seams) {
  const SeamResult* worst = worstOf(seams, task.options);
  if (worst == nullptr) return {};
  const auto nameOf = [&fill](int face) {
    return fill.face_names.at(static_cast<std::size_t>(face) - 1);
  };
  FillReason reason{.fault = certainlyMisses(*worst, task.options) ? FillFault::MissesTarget
                                                                   : FillFault::MayMissTarget,
                    .numbers = {{"target", static_cast<double>(task.options.target) -
                                               static_cast<double>(Level::G0)}},
                    .faces = {nameOf(worst->faces[0]), nameOf(worst->faces[1])},
                    .detail = figuresText(*worst),
                    .causes = causesOfAngle(task, made.cut)};
  if (task.options.target >= Level::G1 && reason.causes.empty())
    reason.causes = causesOfContradiction(task.hole, task.options.tolerance.angle_rad,
                                          task.options.tolerance.gap_mm);
  for (FillReason& cause : causesOfDistance(task, made.cut))
    reason.causes.push_back(std::move(cause));
  return reason;
}

/// What is wrong with the form of the new faces, whose seams are good; empty if nothing.
FillReason misshapen(const FillFaces& made, const SewnFill& fill, const FillSeams& seams) {
  if (!made.regular) return {.fault = FillFault::MayFold};
  if (turnsBack(made.faces, made.cut.sides)) return {.fault = FillFault::TurnsBack};
  if (made.reach > most_reach)
    return {.fault = FillFault::ReachesTooFar, .numbers = {{"reach", made.reach}}};
  if (seams.outer.empty()) return {.fault = FillFault::TooSmall};
  // A graph does not meet itself, and a given surface is one of the model.
  if (!made.is_trimmed && meetThemselves(made.faces)) return {.fault = FillFault::RunsIntoItself};
  // A fitted face is tangent to its neighbours: sections find the contact along their common edges.
  if (const auto touching = touchingFaces(fill.sewn.shape, fill.faces, !made.is_fitted)) {
    if (fill.isNew(touching->second)) return {.fault = FillFault::RunsIntoItself};
    return {.fault = FillFault::RunsIntoFace,
            .faces = {fill.face_names.at(static_cast<std::size_t>(touching->second) - 1)}};
  }
  return {};
}

/// What OpenCASCADE's checks find that they did not find before; empty if nothing.
FillReason invalid(const FillTask& task, const FillFaces& made, const SewnFill& fill) {
  const Validity was = validityOf(task.model.shape, task.options.jobs),
                 is = validityOf(fill.sewn.shape, task.options.jobs);
  const int count = task.model.faceCount() + static_cast<int>(made.faces.size());
  for (int face = 1; face <= count; ++face)
    if ((task.isNew(face) || was.faces[face]) && !is.faces[fill.sewn.faces[face]])
      return {.fault = FillFault::InvalidFace, .faces = {task.nameOf(face)}};
  if (was.whole && !is.whole) return {.fault = FillFault::InvalidShape};
  return {};
}

}  // namespace

FillVerdict judgeFill(const FillTask& task, const FillFaces& made, const SewnFill& fill,
                      const FillSeams& seams) {
  FillVerdict verdict{.reason = missed(task, made, fill, seams)};
  if (verdict.reason.empty()) verdict.reason = misshapen(made, fill, seams);
  verdict.meets_others = verdict.reason.fault == FillFault::RunsIntoItself ||
                         verdict.reason.fault == FillFault::RunsIntoFace;
  FillReason fault = invalid(task, made, fill);
  verdict.valid = fault.empty();
  if (!verdict.valid) verdict.reason = std::move(fault);
  return verdict;
}

}  // namespace seamwright::occ
