// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <utility>

#include <seamwright/occ_adapter/repair/repair_state.hpp>

namespace seamwright::occ {

RepairReason LeftReason::whole() const {
  RepairReason reason = target;
  if (has_g1)
    reason.text = "G1 reached; G2: " + target.text;
  else if (!g1.empty())
    reason.text = target.text + "; G1: " + g1.text;
  return reason;
}

RepairState::RepairState(const Model& model, const Report& before,
                         std::vector<RepairReason> of_choice)
    : shape(model.shape), after(before), to_keep(before.seams) {
  for (RepairReason& reason : of_choice) reasons.push_back({.target = std::move(reason)});
}

void RepairState::keep(const std::vector<int>& asked, const RepairOptions& options,
                       const std::vector<bool>& sharp, Improvement done) {
  for (const auto& [i, why] : done.reasons)
    (asked[i] < options.order && !reasons[i].target.empty() ? reasons[i].g1 : reasons[i].target) =
        why;
  for (const auto& [i, why] : done.g1_reasons) reasons[i].g1 = why;
  if (done.changes.empty() && done.paths.empty()) return;
  shape = done.shape;
  after.seams = std::move(done.after);
  seams = seamsIn(done.shape, seams);
  for (const FaceChange& change : done.changes) moves[change.face] += change.largest_move_mm;
  for (auto& [face, move] : done.judged) judged[face] = std::move(move);
  addEdgeMoves(done.paths);
  for (std::size_t i = 0; i < done.orders.size(); ++i) {
    // The accepted turn of a fold depends on the seams beside it and has been judged, so the new
    // angle is the one to keep.
    if (SeamResult& kept = to_keep[i]; isFold(kept, options.tolerance))
      kept.figures.angle_rad = after.seams[i].figures.angle_rad;
    if (done.orders[i] == 0) continue;
    to_keep[i] = after.seams[i];
    if (done.orders[i] == options.order || sharp[i])
      reasons[i] = {};
    else
      reasons[i].has_g1 = true;
  }
}

/// Adds moves of edges. For an edge with new pcurves on both faces the larger move counts.
void RepairState::addEdgeMoves(const std::vector<PathChange>& paths) {
  std::map<int, double> by_edge;
  for (const PathChange& change : paths)
    by_edge[change.edge] = std::max(by_edge[change.edge], change.largest_move_mm);
  for (const auto& [edge, move_mm] : by_edge) edge_moves[edge] += move_mm;
}

}  // namespace seamwright::occ
