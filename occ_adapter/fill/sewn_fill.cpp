// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>

#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/fill/sewn_fill.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::occ {

namespace {

/// The shape with additional faces, which are numbered after its own.
TopoDS_Compound withFaces(const TopoDS_Shape& shape, const std::vector<TopoDS_Face>& faces) {
  BRep_Builder builder;
  TopoDS_Compound whole;
  builder.MakeCompound(whole);
  if (shape.ShapeType() == TopAbs_COMPOUND)
    for (TopoDS_Iterator part(shape); part.More(); part.Next()) builder.Add(whole, part.Value());
  else
    builder.Add(whole, shape);
  for (const TopoDS_Face& face : faces) builder.Add(whole, face);
  return whole;
}

/// Whether the coedge is one of a new face or of the hole.
bool belongsToFill(const FillTask& task, const Coedge& coedge) {
  if (task.isNew(coedge.face)) return true;
  for (const HoleSide& side : task.hole.sides)
    for (const HoleEdge& edge : side.edges)
      if (edge.use.face == coedge.face && edge.use.edge.IsSame(coedge.edge)) return true;
  return false;
}

/// Whether the seam is between new faces, or between a new face and one beside the hole.
bool isOfFill(const FillTask& task, const Seam& seam) {
  return (task.isNew(seam.sides[0].face) || task.isNew(seam.sides[1].face)) &&
         belongsToFill(task, seam.sides[0]) && belongsToFill(task, seam.sides[1]);
}

FillReason notSewn(const FillTask& task, const Seam& seam, const HoleCut& cut) {
  FillReason reason{.fault = FillFault::NotSewn, .causes = causesOfDistance(task, cut)};
  for (const Coedge& side : seam.sides)
    if (!task.isNew(side.face)) {
      reason.edges = {partsOf(task.model.shape, TopAbs_EDGE).FindIndex(side.edge)};
      reason.faces = {task.nameOf(side.face)};
      break;
    }
  return reason;
}

void requireClosed(const FillTask& task, const SewnFill& fill,
                   const std::vector<NonSeamEdge>& free_edges, const HoleCut& cut) {
  const auto count = std::ranges::count_if(free_edges, [&fill](const NonSeamEdge& edge) {
    return std::ranges::any_of(edge.faces, [&fill](int face) { return fill.isNew(face); });
  });
  if (count > 0)
    throw NotFilled({.fault = FillFault::FreeEdges,
                     .numbers = {{"count", static_cast<double>(count)},
                                 {"gap_mm", task.options.tolerance.gap_mm}},
                     .causes = causesOfDistance(task, cut)});
}

}  // namespace

SewnFill sewFill(const FillTask& task, const std::vector<TopoDS_Face>& faces, const HoleCut& cut,
                 const Progress& progress) {
  SewnFill fill;
  fill.whole = withFaces(task.model.shape, faces);
  SeamGraph graph = findSeams(fill.whole);
  const double gap_mm = task.options.tolerance.gap_mm;
  double reach_mm = gap_mm;
  for (const FittedSide& side : cut.sides) reach_mm = std::max(reach_mm, 2 * side.gap_mm);
  matchFreeEdges({.match_mm = reach_mm, .gap_mm = gap_mm}, graph, progress);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < graph.seams.size(); ++i)
    if (graph.seams[i].kind == SeamKind::Matched && isOfFill(task, graph.seams[i]))
      chosen.push_back(i);
  fill.sewn = sewnShape(fill.whole, graph.seams, chosen, reach_mm,
                        [&task](int face) { return task.nameOf(face); });
  if (!fill.sewn.refused.empty())
    throw NotFilled(notSewn(task, graph.seams[fill.sewn.refused.begin()->first], cut));
  const int count = task.model.faceCount() + static_cast<int>(faces.size());
  fill.face_names.resize(static_cast<std::size_t>(count));
  for (int face = 1; face <= count; ++face) {
    const int number = fill.sewn.faces[face];
    fill.face_names[static_cast<std::size_t>(number) - 1] = task.nameOf(face);
    if (task.isNew(face)) fill.faces.insert(number);
  }
  SeamGraph sewn = findSeams(fill.sewn.shape);
  requireClosed(task, fill, sewn.open, cut);
  for (Seam& seam : sewn.seams)
    if (fill.isNew(seam.sides[0].face) || fill.isNew(seam.sides[1].face))
      fill.seams.push_back(std::move(seam));
  return fill;
}

FillSeams measureFill(const SewnFill& fill, const FillHoleOptions& options,
                      const Progress& progress) {
  AnalyzeOptions asked;
  asked.tolerance = options.tolerance;
  asked.level = options.target;
  asked.jobs = options.jobs;
  std::vector<SeamResult> results(fill.seams.size());
  runParallel(
      fill.seams.size(), options.jobs,
      [&](std::size_t i) { results[i] = measureSeam(fill.seams[i], asked); }, progress);
  FillSeams seams;
  for (SeamResult& seam : results) {
    const bool inner = fill.isNew(seam.faces[0]) && fill.isNew(seam.faces[1]);
    (inner ? seams.inner : seams.outer).push_back(std::move(seam));
  }
  return seams;
}

TopoDS_Shape filledShape(const SewnFill& fill, const TopoDS_Shape& given) {
  const TopoDS_Shape& whole = fill.sewn.shape;
  if (given.ShapeType() == TopAbs_COMPOUND) return whole;
  TopoDS_Iterator part(whole);
  const TopoDS_Shape first = part.Value();
  part.Next();
  return part.More() ? whole : first;
}

}  // namespace seamwright::occ
