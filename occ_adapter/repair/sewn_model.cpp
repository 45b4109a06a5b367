// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/repair/sew.hpp>
#include <seamwright/occ_adapter/repair/sewn_model.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::occ {

Model sewnModel(const Model& model, const SewModelOptions& options, const Progress& progress) {
  if (!(options.sew_mm > 0) || !std::isfinite(options.sew_mm))
    throw std::invalid_argument(fmt::format(
        "distance to sew is {:.6g} mm: it must be positive and finite", options.sew_mm));
  RepairOptions sewing;
  sewing.tolerance.gap_mm = options.sew_mm;
  sewing.match_mm = options.sew_mm;
  sewing.jobs = options.jobs;
  sewing.validate();
  // Shares of the progress bar: the seams are measured once more after they are sewn.
  constexpr double matched = 0.1, measured = 0.4;
  SeamGraph graph = findSeams(model.shape);
  matchFreeEdges({.match_mm = options.sew_mm, .gap_mm = options.sew_mm}, graph,
                 partOf(progress, 0, matched));
  std::vector<SeamResult> before(graph.seams.size());
  runParallel(
      graph.seams.size(), options.jobs,
      [&](std::size_t i) { before[i] = measureSeam(graph.seams[i], analyzeOptions(sewing)); },
      partOf(progress, matched, measured));
  SewSolution solution = sewFreeEdges(
      {.shape = model.shape, .seams = graph.seams, .before = before, .options = sewing},
      partOf(progress, measured, 1));
  Model sewn = model;
  for (const auto& [seam, reason] : solution.reasons)
    sewn.notes.push_back(fmt::format("the seam of Edge{} and Edge{} is not sewn: {}",
                                     before[seam].edges.front(), before[seam].edges.back(),
                                     reason.text));
  if (solution.sewn.shape.IsNull()) return sewn;
  sewn.shape = solution.sewn.shape;
  sewn.attributes = attributesAfter(model.attributes, model.shape, solution.sewn);
  return sewn;
}

}  // namespace seamwright::occ
