// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <Standard_Failure.hxx>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include <seamwright/occ_adapter/repair/convert_faces.hpp>
#include <seamwright/occ_adapter/repair/face_change.hpp>
#include <seamwright/occ_adapter/repair/instances.hpp>
#include <seamwright/occ_adapter/repair/prove.hpp>
#include <seamwright/occ_adapter/repair/reasons.hpp>
#include <seamwright/occ_adapter/repair/repair_stages.hpp>
#include <seamwright/occ_adapter/repair/sew.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::occ {

namespace {

std::vector<Seam> seamsOf(const TopoDS_Shape& shape, const RepairOptions& options,
                          const Progress& progress) {
  SeamGraph graph = findSeams(shape);
  if (options.match_mm > 0)
    matchFreeEdges({.match_mm = options.match_mm, .gap_mm = options.tolerance.gap_mm}, graph,
                   progress);
  return std::move(graph.seams);
}

/// The faces around the ends of wanted seams, as far as they can be computed with.
std::set<int> facesAround(const TopoDS_Shape& shape, const std::vector<Seam>& seams,
                          const std::vector<bool>& wanted, const UnusableParts& unusable) {
  const FacesAtVertices around(shape);
  std::set<int> faces;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i]) faces.merge(around.of(seams[i]));
  std::erase_if(faces, [&unusable](int face) { return unusable.hasFace(face); });
  return faces;
}

/// Leaves seams at kinks of a surface unrepaired.
/// \returns the wanted seams without them.
std::vector<bool> withoutKinks(std::vector<bool> wanted, const std::vector<bool>& sharp,
                               const ContinuityTolerance& tolerance, RepairState& state) {
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!wanted[i] || sharp[i]) continue;
    try {
      state.reasons[i].target = whyKinked(state.seams[i], tolerance);
    } catch (const Standard_Failure& failure) {
      state.reasons[i].target = why::failed(failure);
    }
    wanted[i] = state.reasons[i].target.empty();
  }
  return wanted;
}

bool anyOf(const std::vector<bool>& wanted) {
  return std::ranges::count(wanted, true) > 0;
}

/// Seams that are to lose their angle.
std::vector<bool> turned(std::vector<bool> wanted, const std::vector<bool>& sharp) {
  for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] = wanted[i] && !sharp[i];
  return wanted;
}

/// Sews matched seams of the report's model. The report gets the sewn model.
/// \returns why seams that were to be sewn are not.
SewReasons sewInto(const Model& given, std::vector<Seam> seams, const RepairOptions& options,
                   const Progress& progress, RepairReport& report) {
  if (seams.empty()) seams = seamsOf(given.shape, options, {});
  const TopoDS_Shape shape = report.model.shape;
  const std::vector<SeamResult> before = report.after.seams;
  const std::vector<Seam> seams_now = seamsAfter(shape, seams, before, options, {});
  SewSolution solution = sewFreeEdges(
      {.shape = shape, .seams = seams_now, .before = before, .options = options}, progress);
  if (solution.sewn.shape.IsNull()) return std::move(solution.reasons);
  report.model.shape = solution.sewn.shape;
  report.model.attributes = attributesAfter(given.attributes, shape, solution.sewn);
  report.after.seams = std::move(solution.after);
  report.after.open = std::move(solution.open);
  report.after.non_manifold = std::move(solution.non_manifold);
  report.after.model.edges = report.model.edgeCount();
  report.faces_now = std::move(solution.sewn.faces);
  report.edges_now = std::move(solution.sewn.edges);
  return std::move(solution.reasons);
}

/// Puts the moves into the report.
void tellMoves(const RepairState& state, RepairReport& report) {
  for (const auto& [face, move_mm] : state.moves) {
    if (!(move_mm > 0)) continue;
    FaceMove move = state.judged.at(face);
    move.largest_move_mm = move_mm;
    if (move.surface) move.surface->move_mm.upper = std::max(move.surface->move_mm.lower, move_mm);
    report.moves.push_back(std::move(move));
  }
  for (const auto& [edge, move_mm] : state.edge_moves) report.edge_moves.push_back({edge, move_mm});
}

/// What became of a seam, except that it was not sewn.
struct SeamOutcome {
  bool treated = false, sharp = false, wants_conversion = false;
  RepairReason reason = {};  ///< why it was not repaired, if it was not
};

SeamRepair seamRepair(const SeamResult& before, const SeamResult& after, SeamOutcome outcome,
                      const RepairOptions& options) {
  SeamRepair seam;
  seam.before = before;
  seam.after = after;
  seam.treated = outcome.treated;
  seam.sewn = before.kind == SeamKind::Matched && after.kind != SeamKind::Matched;
  seam.repaired =
      seam.treated && isRepaired(after, outcome.sharp, options.tolerance, options.level());
  seam.wants_conversion = outcome.wants_conversion && !seam.repaired;
  if (seam.repaired) return seam;
  seam.reason = std::move(outcome.reason);
  if (seam.treated && before.kind == SeamKind::Matched && !before.note.empty())
    seam.reason = why::afterNote(before.note, std::move(seam.reason));
  return seam;
}

/// Repairs the model without conversion of faces, and each instance of a part for itself. First
/// edges get new pcurves and faces move (repairInStages()), then seams that meet are sewn.
RepairReport repairOnce(const Model& model, const RepairOptions& options,
                        const Progress& progress) {
  // Progress at the ends of the analysis and of the repair.
  constexpr double share_of_analysis = 0.2, share_before_sewing = 0.9;
  const UnusableParts unusable(model.shape);
  const TimeLimit time(options.max_time_s);
  const bool sews = options.match_mm > 0 && options.sew;
  RepairReport report;
  report.model = model;
  report.before = analyze(model, analyzeOptions(options), partOf(progress, 0, share_of_analysis));
  const Choice choice = choose(model, report.before, options);
  RepairState state(model, report.before, choice.reasons);
  std::vector<bool> wanted = choice.treated;
  if (anyOf(wanted)) {
    state.seams = seamsOf(model.shape, options, {});
    wanted = withoutKinks(wanted, choice.sharp, options.tolerance, state);
  }
  if (anyOf(wanted)) {
    const RepairContext context{
        .model = model,
        .options = options,
        .unusable = unusable,
        .time = time,
        .faces = choice.faces,
        .sharp = choice.sharp,
        .needed = neededVariation(model.shape, report.before.seams, turned(wanted, choice.sharp)),
        .limits_mm =
            moveLimits(model.shape, report.before.seams,
                       facesAround(model.shape, state.seams, wanted, unusable), wanted, options)};
    state = repairInStages(context, std::move(state), wanted,
                           partOf(progress, share_of_analysis, sews ? share_before_sewing : 1));
  }
  report.model.shape = state.shape;
  report.after = state.after;
  SewReasons not_sewn;
  if (sews)
    not_sewn =
        sewInto(model, state.seams, options, partOf(progress, share_before_sewing, 1), report);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i] && state.out_of_time && state.reasons[i].target.empty())
      state.reasons[i].target = why::timeLimit();
    report.seams.push_back(seamRepair(report.before.seams[i], report.after.seams[i],
                                      {.treated = wanted[i],
                                       .sharp = choice.sharp[i],
                                       .wants_conversion = choice.wants_conversion[i],
                                       .reason = state.reasons[i].whole()},
                                      options));
    if (const auto why = not_sewn.find(i); why != not_sewn.end())
      report.seams.back().not_sewn = why->second;
  }
  tellMoves(state, report);
  report.repair_s = time.spent_s();
  if (progress) progress(1);
  return report;
}

}  // namespace

AnalyzeOptions analyzeOptions(const RepairOptions& options) {
  AnalyzeOptions analyze;
  analyze.tolerance = options.tolerance;
  analyze.level = options.level();
  analyze.match_mm = options.match_mm;
  analyze.jobs = options.jobs;
  return analyze;
}

void RepairOptions::validate() const {
  analyzeOptions(*this).validate();
  if (order != 1 && order != 2)
    throw std::invalid_argument(fmt::format("order is {}: it must be 1 or 2", order));
  SurfaceTolerance{.fairness = fairness}.validate();
  const auto requirePositive = [](const char* name, double value, const char* unit) {
    if (value > 0) return;
    throw std::invalid_argument(
        fmt::format("{} is {:.6g} {}: it must be larger than zero", name, value, unit));
  };
  if (max_move_mm) requirePositive("largest move", *max_move_mm, "mm");
  requirePositive("time limit", max_time_s, "s");
}

RepairReport repair(const Model& model, const RepairOptions& options, const Progress& progress) {
  options.validate();
  const auto converting = [](const Model& of, const RepairOptions& how, const Progress& part) {
    return how.convert_analytic ? repairConverting(of, how, repairOnce, part)
                                : repairOnce(of, how, part);
  };
  return repairInstances(model, options, converting, progress);
}

}  // namespace seamwright::occ
