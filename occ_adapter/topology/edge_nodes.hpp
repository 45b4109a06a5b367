// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <utility>
#include <vector>

#include <seamwright/core/disjoint_sets.hpp>
#include <seamwright/occ_adapter/topology/sewn_intervals.hpp>
#include <seamwright/occ_adapter/topology/shape_parts.hpp>

/// Says which ends of edges come together when pieces of edges become one. Not a public header.
namespace seamwright::occ {

/// The ends of all pieces of the edges of a shape. Their nodes are its vertices, by number, and
/// after them the cuts of its edges.
class EdgeNodes {
 public:
  /// \param cuts see SewnIntervals.
  EdgeNodes(const ShapeParts& parts, std::map<int, std::vector<double>> cuts);

  bool isCut(int edge) const { return cuts_.count(edge) > 0; }
  int piecesOf(int edge) const;
  /// Begin and end of a piece, as parameters in 0..1 of its edge.
  ParameterRange rangeOf(int edge, int piece) const;
  /// The node at the begin of the piece with number \p k, or at the end of the last piece; 0 if the
  /// edge has no vertex there.
  int at(int edge, int k) const;
  /// The smallest node of those that come together with this one.
  int of(int node) const { return nodes_.of(node); }
  int count() const { return nodes_.count(); }
  bool isCutNode(int node) const { return node > vertices_; }
  void unite(int a, int b) { nodes_.unite(a, b); }

 private:
  const ShapeParts& parts_;
  int vertices_ = 0;
  std::map<int, std::vector<double>> cuts_;       ///< by edge
  std::map<std::pair<int, int>, int> cut_nodes_;  ///< by edge and number of the cut
  DisjointSets nodes_;
};

/// Nodes that become new vertices, by smallest node: the seams that end there, once for each end.
using CornerSeams = std::map<int, std::vector<std::size_t>>;

struct JoinedNodes {
  EdgeNodes nodes;
  CornerSeams corners;
  SewReasons refused;
};

/// Unites the nodes at both ends of each interval.
JoinedNodes joinedNodes(const ShapeParts& parts, const SewnIntervals& cut);

}  // namespace seamwright::occ
