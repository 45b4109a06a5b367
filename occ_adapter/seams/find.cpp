// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

namespace seamwright::occ {

namespace {

using UsesOfEdge = std::vector<Coedge>;

/// Vertices to which a boundary of the face collapses.
TopTools_MapOfShape polesOf(const TopoDS_Face& face) {
  TopTools_MapOfShape poles;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (BRep_Tool::Degenerated(edge)) poles.Add(TopExp::FirstVertex(edge));
  }
  return poles;
}

double poleTolerance(const TopTools_MapOfShape& poles, const TopoDS_Vertex& vertex) {
  return !vertex.IsNull() && poles.Contains(vertex) ? BRep_Tool::Tolerance(vertex) : 0;
}

Coedge coedgeOf(int number, const TopoDS_Face& face, const TopoDS_Edge& edge,
                const TopTools_MapOfShape& poles) {
  return {number,
          face,
          edge,
          {poleTolerance(poles, TopExp::FirstVertex(edge)),
           poleTolerance(poles, TopExp::LastVertex(edge))}};
}

std::string faultOfUse(const UnusableParts& unusable, int face, int edge) {
  if (unusable.hasFace(face)) return unusable.describeFace(face);
  return unusable.hasEdge(edge) ? unusable.describeEdge(edge) : std::string();
}

/// Uses of each edge; index 0 is empty, as edges count from 1.
std::vector<UsesOfEdge> collectUses(const TopoDS_Shape& shape,
                                    const TopTools_IndexedMapOfShape& edges) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  std::vector<UsesOfEdge> uses(static_cast<std::size_t>(edges.Extent()) + 1);
  const UnusableParts unusable(shape);
  for (int f = 1; f <= faces.Extent(); ++f) {
    const TopoDS_Face face = TopoDS::Face(faces(f).Oriented(TopAbs_FORWARD));
    const TopTools_MapOfShape poles = polesOf(face);
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      const bool bounds =
          edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED;
      if (!bounds || BRep_Tool::Degenerated(edge)) continue;
      const int e = edges.FindIndex(edge);
      uses[e].push_back(coedgeOf(f, face, edge, poles));
      uses[e].back().fault = faultOfUse(unusable, f, e);
    }
  }
  return uses;
}

NonSeamEdge nonSeamEdge(int edge, const UsesOfEdge& uses) {
  NonSeamEdge result{edge, {}};
  for (const Coedge& use : uses) result.faces.push_back(use.face);
  return result;
}

}  // namespace

void requireUsable(const Coedge& use) {
  if (!use.fault.empty()) throw GeometryError(use.fault);
}

SeamGraph findSeams(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  const std::vector<UsesOfEdge> uses = collectUses(shape, edges);
  SeamGraph graph;
  for (int e = 1; e <= edges.Extent(); ++e) {
    const UsesOfEdge& sides = uses[e];
    if (sides.size() == 1) {
      graph.open.push_back(nonSeamEdge(e, sides));
      graph.open_uses.push_back(sides.front());
    } else if (sides.size() == 2) {
      const SeamKind kind = sides[0].face == sides[1].face ? SeamKind::Closed : SeamKind::Shared;
      graph.seams.push_back(
          {static_cast<int>(graph.seams.size()) + 1, kind, {e}, {sides[0], sides[1]}, {}, {}});
    } else if (sides.size() > 2) {
      graph.non_manifold.push_back(nonSeamEdge(e, sides));
    }
  }
  return graph;
}

}  // namespace seamwright::occ
