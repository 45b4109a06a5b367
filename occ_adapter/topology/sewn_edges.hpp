// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/topology/sewn_intervals.hpp>
#include <seamwright/occ_adapter/topology/shape_parts.hpp>

/// Makes the edges and vertices of a shape with some of its matched seams sewn. Not a public
/// header.
namespace seamwright::occ {

struct SewnEdges {
  std::vector<SewnInterval> intervals = {};
  /// By interval: the edge that replaces both, in the direction of the first.
  std::vector<TopoDS_Edge> common = {};
  /// By number of an edge that changes: the edges that it becomes, in the order and the direction
  /// of its curve.
  std::map<int, std::vector<TopoDS_Edge>> pieces = {};
  std::map<int, TopoDS_Vertex> vertices = {};  ///< by number of a vertex that changes
  SewReasons refused = {};                     ///< if there are any, the other members are empty
};

/// Cuts edges where intervals begin and end. Pieces that lie along each other become one edge. Ends
/// that come together become one vertex, in the middle of the ends of the curves there. Tolerances
/// are the distances as measured.
///
/// A pipeline of values: sewnIntervals() cuts, joinedNodes() says which ends come together,
/// commonEdge() makes one edge of two pieces, edgePieces() makes the other pieces, and
/// cornerVertices() the vertices. A stage that refuses seams ends it.
SewnEdges sewnEdges(const ShapeParts& parts, const std::vector<Seam>& seams,
                    const std::vector<std::size_t>& chosen, double gap_mm);

}  // namespace seamwright::occ
