// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepTools_ReShape.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <set>
#include <stdexcept>

#include <seamwright/occ_adapter/fill/face_curvature.hpp>
#include <seamwright/occ_adapter/fill/fill.hpp>
#include <seamwright/occ_adapter/fill/fill_names.hpp>
#include <seamwright/occ_adapter/fill/filling.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>

namespace seamwright::occ {

namespace {

/// The model without some of its faces.
Model without(const Model& model, const std::vector<TopoDS_Shape>& faces) {
  const opencascade::handle<BRepTools_ReShape> change = new BRepTools_ReShape;
  for (const TopoDS_Shape& face : faces) change->Remove(face);
  Model rest = model;
  rest.shape = change->Apply(model.shape);
  if (rest.shape.IsNull() || !TopExp_Explorer(rest.shape, TopAbs_FACE).More())
    throw NotFilled(
        {.fault = FillFault::OnlyFace, .numbers = {{"faces", static_cast<double>(faces.size())}}});
  rest.attributes.clear();
  for (const ShapeAttribute& attribute : model.attributes) {
    const TopoDS_Shape part = change->Apply(partsOf(model.shape, attribute.kind)(attribute.index));
    if (part.IsNull()) continue;
    ShapeAttribute kept = attribute;
    kept.index = partsOf(rest.shape, attribute.kind).FindIndex(part);
    if (kept.index > 0) rest.attributes.push_back(std::move(kept));
  }
  return rest;
}

/// Requires that the edges around the faces and the faces beside them are usable, because the new
/// faces must meet them.
void requireUsableBorder(const TopoDS_Shape& whole, const std::vector<int>& removed) {
  const UnusableParts unusable(whole);
  if (unusable.empty()) return;
  const TopTools_IndexedMapOfShape faces = partsOf(whole, TopAbs_FACE),
                                   edges = partsOf(whole, TopAbs_EDGE);
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
  TopExp::MapShapesAndUniqueAncestors(whole, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
  for (const int face : removed)
    for (TopExp_Explorer edge(faces(face), TopAbs_EDGE); edge.More(); edge.Next())
      for (const TopoDS_Shape& beside : faces_of_edge.FindFromKey(edge.Current())) {
        const int other = faces.FindIndex(beside);
        if (std::ranges::find(removed, other) != removed.end()) continue;
        FillReason why = whyNotMet(unusable, edges.FindIndex(edge.Current()), other);
        if (!why.empty()) throw NotFilled(std::move(why));
      }
}

/// The edges of the rest that removed faces had.
std::set<int> edgesLeftBy(const std::vector<TopoDS_Shape>& removed, const TopoDS_Shape& rest) {
  std::set<int> left;
  TopTools_IndexedMapOfShape gone;
  const TopTools_IndexedMapOfShape edges = partsOf(rest, TopAbs_EDGE);
  for (const TopoDS_Shape& face : removed) {
    TopTools_IndexedMapOfShape its;
    TopExp::MapShapes(face, TopAbs_EDGE, its);
    for (int k = 1; k <= its.Extent(); ++k) {
      const TopoDS_Shape& edge = its(k);
      const int number = edges.FindIndex(edge);
      if (number > 0)
        left.insert(number);
      else if (!BRep_Tool::Degenerated(TopoDS::Edge(edge)) && !gone.Contains(edge))
        gone.Add(edge);
      else
        gone.RemoveKey(edge);
    }
  }
  // What is gone and was met once only had no face on the other side.
  if (!gone.IsEmpty()) throw NotFilled({.fault = FillFault::EdgeOfOneFace});
  return left;
}

/// The hole that removed faces left in the rest of a model.
Hole holeOf(const Model& rest, const std::vector<TopoDS_Shape>& removed,
            const FillHoleOptions& options) {
  const std::set<int> wanted = edgesLeftBy(removed, rest.shape);
  const Holes found = findHoles(rest.shape, {options.corner_rad, options.tolerance.gap_mm});
  for (const Hole& hole : found.holes) {
    std::set<int> its;
    for (const HoleSide& side : hole.sides)
      for (const HoleEdge& edge : side.edges) its.insert(edge.edge);
    if (its == wanted) return hole;
  }
  throw NotFilled({.fault = FillFault::NoLoop});
}

/// Edges of the reason and its causes by their numbers in the given model.
FillReason inGivenNumbers(FillReason reason, const Numbers& edges) {
  for (int& edge : reason.edges) edge = edges.given(edge);
  for (FillReason& cause : reason.causes) cause = inGivenNumbers(std::move(cause), edges);
  return reason;
}

}  // namespace

void requireRemovable(const Model& model, const std::vector<int>& faces) {
  if (faces.empty()) throw std::invalid_argument("no face is named: one at least is needed");
  for (const int face : faces) {
    requireFace(face, model.faceCount());
    if (std::ranges::count(faces, face) > 1)
      throw std::invalid_argument("face " + std::to_string(face) + " is given twice");
  }
}

FillHoleReport replaceFaces(const Model& model, const std::vector<int>& faces,
                            const FillHoleOptions& options, const Progress& progress) {
  requireOptions(model, options);
  requireRemovable(model, faces);
  FillHoleReport report;
  try {
    const Model whole = modelOfOwnParts(model);
    requireUsableBorder(whole.shape, faces);
    std::vector<TopoDS_Shape> old;
    for (const int face : faces) old.push_back(partsOf(whole.shape, TopAbs_FACE)(face));
    const Model rest = without(whole, old);
    const Numbers given_faces(whole.shape, rest.shape, TopAbs_FACE),
        edges(whole.shape, rest.shape, TopAbs_EDGE);
    report = fillHole(
        rest, holeOf(rest, old, options), options,
        [&given_faces](int number) { return numberedFace(given_faces.given(number)); }, progress);
    for (FilledSide& side : report.sides)
      for (int& edge : side.edges) edge = edges.given(edge);
    report.reason = inGivenNumbers(std::move(report.reason), edges);
    if (const std::optional<Bends> bends = bendsOf(old))
      report.removed_curvature_per_mm = bends->largest_per_mm;
  } catch (const NotFilled& why) {
    report.reason = why.reason();
  } catch (const Standard_Failure& failure) {
    report.reason = reasonOf("taking the face out", failure);
  }
  if (!report.filled) report.model = model;
  return report;
}

FillHoleReport replaceFace(const Model& model, int face, const FillHoleOptions& options,
                           const Progress& progress) {
  return replaceFaces(model, {face}, options, progress);
}

}  // namespace seamwright::occ
