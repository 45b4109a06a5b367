// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Vertex.hxx>

#include <seamwright/occ_adapter/topology/sewn_intervals.hpp>

/// Edges and vertices of a shape with some of its matched seams sewn; not a public header.
namespace seamwright::occ {

struct SewnEdges {
  std::vector<SewnInterval> intervals;
  std::vector<TopoDS_Edge>
      common;  ///< by interval: the edge in place of both, running with the first
  /// By number, of those that are new: what an edge becomes, one after the other in the sense of
  /// its curve, turned so that they run with it.
  std::map<int, std::vector<TopoDS_Edge>> pieces;
  std::map<int, TopoDS_Vertex> vertices;  ///< by number, of those that are new
  std::map<std::size_t, std::string>
      refused;  ///< seams that stand in the way; then the rest is not made
};

/// Edges are cut where intervals begin and end; pieces that lie along one another become one edge;
/// ends that come together become one vertex in the middle of the curves that end there. Tolerances
/// are what is measured.
SewnEdges sewnEdges(const TopoDS_Shape& shape, const std::vector<Seam>& seams,
                    const std::vector<std::size_t>& chosen, double gap_mm);

}  // namespace seamwright::occ
