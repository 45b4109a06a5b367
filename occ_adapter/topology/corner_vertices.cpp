// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <set>

#include <seamwright/occ_adapter/topology/corner_vertices.hpp>

namespace seamwright::occ {

namespace {

/// What ends at a corner.
struct CornerEnds {
  std::vector<gp_Pnt> curves;  ///< ends of curves
  std::vector<gp_Pnt> all;     ///< and of the images of pcurves
  double tolerance_mm = 0;     ///< largest tolerance of the pieces
  double was_mm = 0;           ///< largest tolerance of the old vertices
};

/// By node of a corner.
std::map<int, CornerEnds> endsByCorner(const ShapeParts& parts, const JoinedNodes& joined,
                                       const EdgePieces& all_pieces) {
  std::map<int, CornerEnds> ends;
  for (const auto& [node, seams] : joined.corners) ends[node];
  for (const auto& [edge, pieces] : all_pieces)
    for (const EdgePiece& piece : pieces)
      for (const int end : {0, 1}) {
        const auto found = ends.find(joined.nodes.of(piece.nodes[end]));
        if (found == ends.end()) continue;
        CornerEnds& corner = found->second;
        corner.tolerance_mm = std::max(corner.tolerance_mm, piece.tolerance_mm);
        const std::vector<gp_Pnt>&curves = piece.curve_ends[end], &images = piece.image_ends[end];
        corner.curves.insert(corner.curves.end(), curves.begin(), curves.end());
        corner.all.insert(corner.all.end(), curves.begin(), curves.end());
        corner.all.insert(corner.all.end(), images.begin(), images.end());
      }
  for (int v = 1; v <= parts.vertices.Extent(); ++v)
    if (const auto found = ends.find(joined.nodes.of(v)); found != ends.end())
      found->second.was_mm = std::max(found->second.was_mm, BRep_Tool::Tolerance(parts.vertex(v)));
  return ends;
}

gp_Pnt middleOf(const std::vector<gp_Pnt>& points) {
  gp_XYZ sum;
  for (const gp_Pnt& point : points) sum += point.XYZ();
  return {sum / static_cast<double>(points.size())};
}

/// The least tolerance of a vertex at \p position.
double reachOf_mm(const CornerEnds& ends, const gp_Pnt& position) {
  // Margin: rounding must not leave an end outside of the tolerance.
  constexpr double rounding = 1.001;
  double reach_mm = std::max(Precision::Confusion(), ends.tolerance_mm);
  for (const gp_Pnt& end : ends.all)
    reach_mm = std::max(reach_mm, rounding * end.Distance(position));
  return reach_mm;
}

}  // namespace

CornerVertices cornerVertices(const ShapeParts& parts, const JoinedNodes& joined,
                              const EdgePieces& pieces, double gap_mm) {
  CornerVertices result;
  const BRep_Builder builder;
  for (const auto& [node, ends] : endsByCorner(parts, joined, pieces)) {
    const gp_Pnt position = middleOf(ends.curves.empty() ? ends.all : ends.curves);
    const double reach_mm = reachOf_mm(ends, position);
    builder.MakeVertex(result.vertices[node], position, reach_mm);
    // An end may be the gap away from the edge beside it, and up to the gap more where it becomes a
    // vertex near it (see sewnIntervals()). Ends that are further apart come from a chain of edges,
    // each within the gap of the next one.
    const double allowed_mm = 2 * std::max(gap_mm, ends.was_mm);
    if (reach_mm > allowed_mm)
      for (const std::size_t seam : joined.corners.at(node))
        result.refused.emplace(seam, why_not_sewn::vertexTooWide(reach_mm, allowed_mm));
  }
  return result;
}

void addVertices(const ShapeParts& parts, const EdgeNodes& nodes,
                 const std::map<int, TopoDS_Vertex>& vertices, EdgePieces& all_pieces) {
  const BRep_Builder builder;
  std::set<int> closed;  // intervals: their common edge is a piece of two edges
  for (auto& [edge, pieces] : all_pieces)
    for (EdgePiece& piece : pieces) {
      if (piece.interval >= 0 && !closed.insert(piece.interval).second) continue;
      const bool reversed = piece.edge.Orientation() == TopAbs_REVERSED;
      TopoDS_Edge forward = TopoDS::Edge(piece.edge.Oriented(TopAbs_FORWARD));
      for (const int end : {0, 1}) {
        const int node = piece.nodes[reversed ? 1 - end : end];
        if (node == 0) continue;
        const auto corner = vertices.find(nodes.of(node));
        const TopoDS_Vertex vertex = corner == vertices.end() ? parts.vertex(node) : corner->second;
        builder.Add(forward, vertex.Oriented(end == 0 ? TopAbs_FORWARD : TopAbs_REVERSED));
      }
    }
}

}  // namespace seamwright::occ
