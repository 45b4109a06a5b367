// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <algorithm>
#include <optional>

#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/repair/changed_vertices.hpp>

namespace seamwright::occ {

namespace {

/// The ends, at a vertex, of edge curves and of their images on faces, with the tolerance that the
/// edges themselves require of the vertex.
struct EndsAtVertex {
  std::vector<gp_Pnt> curves, images;
  double tolerance_mm = 0;
  bool any_moved = false, any_stays = false;
};

/// An edge that does not change, as the faces that can be computed with show it.
ChangedEdge asItIs(const ConnectedParts& parts, int number) {
  const TopoDS_Edge edge = parts.edge(number);
  ChangedEdge same;
  same.curve = BRep_Tool::Curve(edge, same.first, same.last);
  for (const int beside : parts.facesOfEdge(number)) {
    const TopoDS_Face face = parts.face(beside);
    if (const PlanarPath path = pathOf(edge, face); !path.curve.IsNull() && isUsable(face))
      same.sides.push_back({surfaceOf(face), path});
  }
  same.tolerance_mm = BRep_Tool::Tolerance(edge);
  return same;
}

EndsAtVertex endsAt(const ConnectedParts& parts, const std::map<int, ChangedEdge>& edges,
                    int number) {
  const TopoDS_Vertex vertex = parts.vertex(number);
  EndsAtVertex ends;
  for (const int beside : parts.edgesOfVertex(number)) {
    const TopoDS_Edge old = parts.edge(beside);
    const auto changed = edges.find(beside);
    if (changed == edges.end() && !isUsable(old)) continue;  // no edge of known position ends here
    const ChangedEdge edge = changed == edges.end() ? asItIs(parts, beside) : changed->second;
    ends.tolerance_mm = std::max(ends.tolerance_mm, edge.tolerance_mm);
    ends.any_moved = ends.any_moved || edge.moved;
    ends.any_stays = ends.any_stays || (!edge.moved && !edge.curve.IsNull());
    for (const bool at_first : {true, false}) {
      const TopoDS_Vertex end = at_first ? TopExp::FirstVertex(old) : TopExp::LastVertex(old);
      if (!vertex.IsSame(end)) continue;
      if (!edge.curve.IsNull())
        ends.curves.push_back(edge.curve->Value(at_first ? edge.first : edge.last));
      for (const EdgeSide& side : edge.sides)
        ends.images.push_back(side.at(at_first ? 0 : points_of_an_edge - 1));
    }
  }
  return ends;
}

/// A vertex without orientation; nothing if the old one still fits.
std::optional<TopoDS_Vertex> changedVertex(const TopoDS_Vertex& old, const EndsAtVertex& ends) {
  const std::vector<gp_Pnt>& deciding = ends.curves.empty() ? ends.images : ends.curves;
  if (deciding.empty()) return {};
  gp_Pnt position = BRep_Tool::Pnt(old);
  // Readers of files trim edges at their vertices. So a vertex moves only if no edge that stays
  // ends there; otherwise the edge that stays would differ in the file.
  if (ends.any_moved && !ends.any_stays) {
    gp_XYZ sum;
    for (const gp_Pnt& end : deciding) sum += end.XYZ();
    position = gp_Pnt(sum / static_cast<double>(deciding.size()));
  }
  // Margin: rounding must not leave an end outside of the tolerance.
  constexpr double rounding = 1.001;
  double reach_mm = std::max(Precision::Confusion(), ends.tolerance_mm);
  for (const std::vector<gp_Pnt>* points : {&ends.curves, &ends.images})
    for (const gp_Pnt& end : *points)
      reach_mm = std::max(reach_mm, rounding * end.Distance(position));
  if (!ends.any_moved && reach_mm <= BRep_Tool::Tolerance(old)) return {};
  TopoDS_Vertex vertex;
  BRep_Builder().MakeVertex(vertex, position.Transformed(outOf(old.Location())), reach_mm);
  return vertex;
}

}  // namespace

std::map<int, TopoDS_Vertex> changedVertices(const ConnectedParts& parts,
                                             const std::map<int, ChangedEdge>& edges) {
  std::set<int> numbers;
  for (const auto& [edge, changed] : edges)
    numbers.merge(parts.vertices().numbersIn(parts.edges()(edge)));
  std::map<int, TopoDS_Vertex> vertices;
  for (const int number : numbers) {
    const std::optional<TopoDS_Vertex> vertex =
        changedVertex(parts.vertex(number), endsAt(parts, edges, number));
    if (!vertex) continue;
    parts.vertices().requireOnce(number);
    vertices[number] = *vertex;
  }
  return vertices;
}

}  // namespace seamwright::occ
