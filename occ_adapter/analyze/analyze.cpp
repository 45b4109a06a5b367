// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/model/coordinate_rounding.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::occ {

namespace {

void requireFaces(const Model& model, const std::vector<int>& faces) {
  for (const int face : faces) requireFace(face, model.faceCount());
}

/// Leaves seams of these faces.
void keepSeamsOf(const std::vector<int>& faces, std::vector<Seam>& seams) {
  std::erase_if(seams, [&faces](const Seam& seam) {
    return std::ranges::none_of(seam.sides, [&faces](const Coedge& side) {
      return std::ranges::count(faces, side.face) > 0;
    });
  });
}

std::string noSeamNote(std::size_t free_edges, bool match) {
  std::string text = "no two faces share an edge, so no seam is judged; " +
                     std::to_string(free_edges) + (free_edges == 1 ? " free edge" : " free edges");
  if (free_edges > 1)
    text += match ? ", none of them within the distance to match of another"
                  : ": --match (in Python match_mm) pairs those that lie side by side";
  return text;
}

}  // namespace

ModelFacts factsOf(const Model& model) {
  return {model.path,        model.format,      model.length_unit,
          model.faceCount(), model.edgeCount(), model.notes};
}

void AnalyzeOptions::validate() const {
  tolerance.validate();
  if (level == Level::None)
    throw std::invalid_argument("level " + std::string(name(level)) +
                                ": it must be G0, G1, G2 or G3");
  if (!std::isfinite(match_mm) || match_mm < 0)
    throw std::invalid_argument(fmt::format(
        "distance to match is {:.6g} mm: it must be finite and not negative", match_mm));
  if (jobs < 0)
    throw std::invalid_argument("jobs is " + std::to_string(jobs) + ": it must not be negative");
}

bool Report::passed() const {
  return std::ranges::none_of(
      seams, [](const SeamResult& seam) { return seam.verdict.seam_class == SeamClass::Defect; });
}

Report analyze(const Model& model, const AnalyzeOptions& options, const Progress& progress) {
  options.validate();
  requireAboveRounding("gap tolerance", options.tolerance.gap_mm, model.shape);
  const bool match = options.match_mm > 0;
  if (match) requireAboveRounding("distance to match", options.match_mm, model.shape);
  requireFaces(model, options.faces);
  const auto start = std::chrono::steady_clock::now();
  SeamGraph graph = findSeams(model.shape);
  // Of the progress bar: for sheets without shared edges, matching takes about as long as this.
  constexpr double share_of_matching = 0.3;
  if (match)
    matchFreeEdges({.match_mm = options.match_mm, .gap_mm = options.tolerance.gap_mm}, graph,
                   partOf(progress, 0, share_of_matching));
  if (!options.faces.empty()) keepSeamsOf(options.faces, graph.seams);
  Report report{factsOf(model), options.tolerance, options.level, {}, {}, {}, model.read_s, 0};
  report.open = std::move(graph.open);
  report.non_manifold = std::move(graph.non_manifold);
  report.model.notes.insert(report.model.notes.end(), graph.notes.begin(), graph.notes.end());
  report.seams.resize(graph.seams.size());
  if (report.seams.empty()) report.model.notes.push_back(noSeamNote(report.open.size(), match));
  runParallel(
      graph.seams.size(), options.jobs,
      [&](std::size_t i) { report.seams[i] = measureSeam(graph.seams[i], options); },
      match ? partOf(progress, share_of_matching, 1) : progress);
  report.analyze_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace seamwright::occ
