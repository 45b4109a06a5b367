// SPDX-License-Identifier: LGPL-2.1-or-later
#include <utility>

#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/topology/corner_vertices.hpp>
#include <seamwright/occ_adapter/topology/sewn_edges.hpp>

namespace seamwright::occ {

namespace {

/// By interval: the edge that replaces both. Ends at the first interval without one.
struct CommonEdges {
  std::vector<CommonEdge> edges;
  SewReasons refused;
};

CommonEdges commonEdges(const std::vector<Seam>& seams, const std::vector<SewnInterval>& intervals,
                        double gap_mm) {
  CommonEdges common;
  for (const SewnInterval& interval : intervals) {
    try {
      common.edges.push_back(commonEdge(seams[interval.seam], interval.ranges, gap_mm));
    } catch (const NoCommonEdge& why) {
      common.refused[interval.seam] = why.reason();
    } catch (const GeometryError& error) {
      common.refused[interval.seam] = why_not_sewn::noCurve(error.what());
    }
    // The caller tries again without this seam and computes all common edges again.
    if (!common.refused.empty()) break;
  }
  return common;
}

}  // namespace

SewnEdges sewnEdges(const ShapeParts& parts, const std::vector<Seam>& seams,
                    const std::vector<std::size_t>& chosen, double gap_mm) {
  SewnEdges result;
  SewnIntervals cut = sewnIntervals(seams, chosen, gap_mm);
  if (!cut.refused.empty()) return {.refused = std::move(cut.refused)};
  JoinedNodes joined = joinedNodes(parts, cut);
  if (!joined.refused.empty()) return {.refused = std::move(joined.refused)};
  CommonEdges common = commonEdges(seams, cut.intervals, gap_mm);
  if (!common.refused.empty()) return {.refused = std::move(common.refused)};
  EdgePieces pieces = edgePieces(parts, joined, cut.intervals, common.edges);
  CornerVertices corners = cornerVertices(parts, joined, pieces, gap_mm);
  if (!corners.refused.empty()) return {.refused = std::move(corners.refused)};
  addVertices(parts, joined.nodes, corners.vertices, pieces);

  for (const CommonEdge& edge : common.edges) result.common.push_back(edge.edge);
  for (const auto& [edge, of_edge] : pieces)
    for (const EdgePiece& piece : of_edge) result.pieces[edge].push_back(piece.edge);
  for (int v = 1; v <= parts.vertices.Extent(); ++v)
    if (const auto corner = corners.vertices.find(joined.nodes.of(v));
        corner != corners.vertices.end())
      result.vertices[v] = corner->second;
  result.intervals = std::move(cut.intervals);
  return result;
}

}  // namespace seamwright::occ
