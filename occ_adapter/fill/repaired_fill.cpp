// SPDX-License-Identifier: LGPL-2.1-or-later
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>
#include <functional>
#include <stdexcept>

#include <seamwright/occ_adapter/fill/filling.hpp>
#include <seamwright/occ_adapter/fill/repaired_fill.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/repair/repair.hpp>

namespace seamwright::occ {

namespace {

// Of the progress: guesses.
constexpr double share_of_repair = 0.4, share_with_fill = 0.8;

bool contains(const std::vector<int>& numbers, int number) {
  return std::ranges::find(numbers, number) != numbers.end();
}

std::vector<int> edgesOf(const Hole& hole) {
  std::vector<int> edges;
  for (const HoleSide& side : hole.sides)
    for (const HoleEdge& edge : side.edges) edges.push_back(edge.edge);
  return edges;
}

/// The edges of some faces.
std::vector<int> edgesOf(const TopoDS_Shape& shape, const std::vector<int>& faces) {
  const TopTools_IndexedMapOfShape all_faces = partsOf(shape, TopAbs_FACE),
                                   all_edges = partsOf(shape, TopAbs_EDGE);
  std::vector<int> edges;
  for (const int face : faces) {
    TopTools_IndexedMapOfShape its;
    TopExp::MapShapes(all_faces(face), TopAbs_EDGE, its);
    for (int i = 1; i <= its.Extent(); ++i) edges.push_back(all_edges.FindIndex(its(i)));
  }
  return edges;
}

/// The seams that share a vertex with edges around a hole, between faces that stay.
std::vector<int> seamsEndingAt(const TopoDS_Shape& shape, const std::vector<int>& around,
                               const std::vector<int>& removed) {
  const TopTools_IndexedMapOfShape edges = partsOf(shape, TopAbs_EDGE);
  TopTools_IndexedMapOfShape vertices;
  for (const int edge : around) TopExp::MapShapes(edges(edge), TopAbs_VERTEX, vertices);
  const auto endsThere = [&](int edge) {
    TopTools_IndexedMapOfShape its;
    TopExp::MapShapes(edges(edge), TopAbs_VERTEX, its);
    for (int i = 1; i <= its.Extent(); ++i)
      if (vertices.Contains(its(i))) return true;
    return false;
  };
  std::vector<int> found;
  for (const Seam& seam : findSeams(shape).seams) {
    if (contains(removed, seam.sides[0].face) || contains(removed, seam.sides[1].face)) continue;
    for (const int edge : seam.edges)
      if (!contains(around, edge) && endsThere(edge)) found.push_back(edge);
  }
  return found;
}

struct Repaired {
  Model model;
  RepairedAround around;
};

Repaired repairedAround(const Model& model, const std::vector<int>& around,
                        const std::vector<int>& removed, const FillHoleOptions& options,
                        const Progress& progress) {
  Repaired result{model, {}};
  if (options.target == Level::G0) return result;
  result.around.edges = seamsEndingAt(model.shape, around, removed);
  if (result.around.edges.empty()) return result;
  RepairOptions repair_options;
  repair_options.order = options.target == Level::G2 ? 2 : 1;
  repair_options.tolerance = options.tolerance;
  repair_options.edges = result.around.edges;
  repair_options.jobs = options.jobs;
  const RepairReport report = repair(model, repair_options, partOf(progress, 0, share_of_repair));
  result.model = report.model;
  for (const SeamRepair& seam : report.seams) {
    result.around.repaired += seam.repaired;
    const bool ends_there = std::ranges::any_of(
        seam.before.edges, [&](int edge) { return contains(result.around.edges, edge); });
    if (ends_there && !seam.repaired && !seam.reason.empty() &&
        seam.reason.fault != RepairFault::HasLevel)
      result.around.left.push_back({seam.before.edges, seam.reason});
  }
  result.around.treated = result.around.repaired + static_cast<int>(result.around.left.size());
  for (const FaceMove& move : report.moves)
    result.around.largest_move_mm = std::max(result.around.largest_move_mm, move.largest_move_mm);
  return result;
}

/// The hole of a repaired model with the edges of the given one: a repair keeps the numbers.
Hole sameHole(const Model& model, const Hole& given, const FillHoleOptions& options) {
  const std::vector<int> wanted = edgesOf(given);
  for (const Hole& hole :
       findHoles(model.shape, {options.corner_rad, options.tolerance.gap_mm}).holes)
    if (std::ranges::is_permutation(edgesOf(hole), wanted)) return hole;
  throw std::invalid_argument("hole " + std::to_string(given.id) +
                              " has other edges than any hole of the model");
}

using Fill = std::function<FillHoleReport(const Model&, const Progress&)>;

/// The fill of the repaired model; if it misses the target, that of the given one, if this reaches
/// it.
FillHoleReport filledAfterRepair(const Model& given, Repaired repaired, const Fill& fill,
                                 const Progress& progress) {
  FillHoleReport report = fill(repaired.model, partOf(progress, share_of_repair, share_with_fill));
  if (!report.reached && repaired.around.repaired > 0) {
    FillHoleReport plain = fill(given, partOf(progress, share_with_fill, 1));
    repaired.around.used = !plain.reached;
    if (plain.reached) report = std::move(plain);
  }
  if (!report.filled) report.model = given;
  report.around = std::move(repaired.around);
  return report;
}

}  // namespace

FillHoleReport repairedAndFilledHole(const Model& model, const Hole& hole,
                                     const FillHoleOptions& options, const Progress& progress) {
  requireOptions(model, options);
  return filledAfterRepair(
      model, repairedAround(model, edgesOf(hole), {}, options, progress),
      [&](const Model& around, const Progress& part) {
        return fillHole(around, sameHole(around, hole, options), options, part);
      },
      progress);
}

FillHoleReport repairedAndReplacedFaces(const Model& model, const std::vector<int>& faces,
                                        const FillHoleOptions& options, const Progress& progress) {
  requireOptions(model, options);
  requireRemovable(model, faces);
  return filledAfterRepair(
      model, repairedAround(model, edgesOf(model.shape, faces), faces, options, progress),
      [&](const Model& around, const Progress& part) {
        return replaceFaces(around, faces, options, part);
      },
      progress);
}

}  // namespace seamwright::occ
