// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/occ_adapter/topology/edge_nodes.hpp>

namespace seamwright::occ {

EdgeNodes::EdgeNodes(const ShapeParts& parts, std::map<int, std::vector<double>> cuts)
    : parts_(parts),
      vertices_(parts.vertices.Extent()),
      cuts_(std::move(cuts)),
      nodes_(vertices_ + 1) {
  for (const auto& [edge, parameters] : cuts_)
    for (std::size_t k = 1; k + 1 < parameters.size(); ++k)
      cut_nodes_[{edge, static_cast<int>(k)}] = nodes_.add();
}

int EdgeNodes::piecesOf(int edge) const {
  const auto found = cuts_.find(edge);
  return found == cuts_.end() ? 1 : static_cast<int>(found->second.size()) - 1;
}

ParameterRange EdgeNodes::rangeOf(int edge, int piece) const {
  const auto found = cuts_.find(edge);
  return found == cuts_.end() ? ParameterRange{0, 1}
                              : ParameterRange{found->second[piece], found->second[piece + 1]};
}

int EdgeNodes::at(int edge, int k) const {
  if (const auto cut = cut_nodes_.find({edge, k}); cut != cut_nodes_.end()) return cut->second;
  const TopoDS_Edge old = parts_.edge(edge);
  const TopoDS_Vertex end = k == 0 ? TopExp::FirstVertex(old) : TopExp::LastVertex(old);
  return end.IsNull() ? 0 : parts_.vertices.FindIndex(end);
}

namespace {

SewReasons uniteEnds(const std::vector<SewnInterval>& intervals, EdgeNodes& nodes) {
  SewReasons refused;
  for (const SewnInterval& interval : intervals)
    for (const int end : {0, 1}) {
      const int end_b = interval.reversed() ? 1 - end : end;
      const int a = nodes.at(interval.edges[0], interval.pieces[0] + end);
      const int b = nodes.at(interval.edges[1], interval.pieces[1] + end_b);
      if (a == 0 || b == 0)
        refused.emplace(interval.seam, why_not_sewn::noVertex(interval.edges[a == 0 ? 0 : 1]));
      else
        nodes.unite(a, b);
    }
  return refused;
}

/// New vertices are needed at cuts, and where several nodes come together. A sewn interval may also
/// end at a single vertex that both edges share: its common edge needs that vertex too.
CornerSeams cornersOf(const std::vector<SewnInterval>& intervals, const EdgeNodes& nodes) {
  std::map<int, int> members;
  for (int node = 1; node < nodes.count(); ++node) ++members[nodes.of(node)];
  CornerSeams corners;
  for (int node = 1; node < nodes.count(); ++node)
    if (nodes.isCutNode(node) || members.at(nodes.of(node)) > 1) corners[nodes.of(node)];
  for (const SewnInterval& interval : intervals)
    for (const int end : {0, 1})
      corners[nodes.of(nodes.at(interval.edges[0], interval.pieces[0] + end))].push_back(
          interval.seam);
  return corners;
}

}  // namespace

JoinedNodes joinedNodes(const ShapeParts& parts, const SewnIntervals& cut) {
  JoinedNodes joined{.nodes = EdgeNodes(parts, cut.cuts), .corners = {}, .refused = {}};
  joined.refused = uniteEnds(cut.intervals, joined.nodes);
  if (joined.refused.empty()) joined.corners = cornersOf(cut.intervals, joined.nodes);
  return joined;
}

}  // namespace seamwright::occ
