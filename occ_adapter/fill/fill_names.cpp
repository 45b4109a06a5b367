// SPDX-License-Identifier: LGPL-2.1-or-later
#include <TopoDS.hxx>

#include <seamwright/occ_adapter/fill/fill_names.hpp>
#include <seamwright/occ_adapter/topology/own_parts.hpp>

namespace seamwright::occ {

Model modelOfOwnParts(Model model) {
  model.shape = withOwnParts(model.shape);
  return model;
}

Hole holeIn(const Model& model, Hole hole) {
  const TopTools_IndexedMapOfShape faces = partsOf(model.shape, TopAbs_FACE),
                                   edges = partsOf(model.shape, TopAbs_EDGE);
  for (HoleSide& side : hole.sides)
    for (HoleEdge& edge : side.edges) {
      Coedge& use = edge.use;
      use.shape = TopoDS::Face(faces(use.face).Oriented(TopAbs_FORWARD));
      use.edge = TopoDS::Edge(edges(edge.edge).Oriented(use.edge.Orientation()));
    }
  return hole;
}

FillReason whyNotMet(const UnusableParts& unusable, int edge, int face) {
  std::string fault;
  if (unusable.hasFace(face))
    fault = unusable.describeFace(face);
  else if (unusable.hasEdge(edge))
    fault = unusable.describeEdge(edge);
  if (fault.empty()) return {};
  return {.fault = FillFault::UnusableBoundary,
          .faces = {numberedFace(face)},
          .edges = {edge},
          .detail = fault};
}

}  // namespace seamwright::occ
