// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepTools_ReShape.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <set>

#include <seamwright/occ_adapter/fill/fill.hpp>
#include <seamwright/occ_adapter/fill/fill_names.hpp>
#include <seamwright/occ_adapter/fill/filling.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>

namespace seamwright::occ {

namespace {

/// The model without one of its faces.
Model without(const Model& model, const TopoDS_Shape& face) {
  const opencascade::handle<BRepTools_ReShape> change = new BRepTools_ReShape;
  change->Remove(face);
  Model rest = model;
  rest.shape = change->Apply(model.shape);
  if (rest.shape.IsNull() || !TopExp_Explorer(rest.shape, TopAbs_FACE).More())
    throw NotFilled({.fault = FillFault::OnlyFace});
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

/// Requires that the edges of the face and the faces beside it are usable, because the new face
/// must meet them.
void requireUsableBorder(const TopoDS_Shape& whole, int face) {
  const UnusableParts unusable(whole);
  if (unusable.empty()) return;
  const TopTools_IndexedMapOfShape faces = partsOf(whole, TopAbs_FACE),
                                   edges = partsOf(whole, TopAbs_EDGE);
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
  TopExp::MapShapesAndUniqueAncestors(whole, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
  for (TopExp_Explorer edge(faces(face), TopAbs_EDGE); edge.More(); edge.Next())
    for (const TopoDS_Shape& beside : faces_of_edge.FindFromKey(edge.Current())) {
      const int other = faces.FindIndex(beside);
      if (other == face) continue;
      FillReason why = whyNotMet(unusable, edges.FindIndex(edge.Current()), other);
      if (!why.empty()) throw NotFilled(std::move(why));
    }
}

/// The hole that a removed face left in the rest of a model.
Hole holeOf(const Model& rest, const TopoDS_Shape& face, const FillHoleOptions& options) {
  std::set<int> wanted;
  const TopTools_IndexedMapOfShape edges = partsOf(rest.shape, TopAbs_EDGE);
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
    const int number = edges.FindIndex(edge.Current());
    if (number > 0)
      wanted.insert(number);
    else if (!BRep_Tool::Degenerated(TopoDS::Edge(edge.Current())))
      throw NotFilled({.fault = FillFault::EdgeOfOneFace});
  }
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

FillHoleReport replaceFace(const Model& model, int face, const FillHoleOptions& options,
                           const Progress& progress) {
  options.validate();
  requireFace(face, model.faceCount());
  FillHoleReport report;
  try {
    const Model whole = modelOfOwnParts(model);
    requireUsableBorder(whole.shape, face);
    const TopoDS_Shape old = partsOf(whole.shape, TopAbs_FACE)(face);
    const Model rest = without(whole, old);
    const Numbers faces(whole.shape, rest.shape, TopAbs_FACE),
        edges(whole.shape, rest.shape, TopAbs_EDGE);
    report = fillHole(
        rest, holeOf(rest, old, options), options,
        [&faces](int number) { return numberedFace(faces.given(number)); }, progress);
    for (FilledSide& side : report.sides)
      for (int& edge : side.edges) edge = edges.given(edge);
    report.reason = inGivenNumbers(std::move(report.reason), edges);
  } catch (const NotFilled& why) {
    report.reason = why.reason();
  } catch (const Standard_Failure& failure) {
    report.reason = reasonOf("taking the face out", failure);
  }
  if (!report.filled) report.model = model;
  return report;
}

}  // namespace seamwright::occ