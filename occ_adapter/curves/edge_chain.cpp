// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include <seamwright/core/disjoint_sets.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/curves/edge_chain.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;

/// Ends that are this near meet, whatever the tolerances of their vertices: files of single curves
/// have none that tell.
constexpr double meeting_mm = 1e-6;

SpaceEdge spaceEdge(const TopoDS_Edge& edge, int number) {
  if (!isUsable(edge))
    throw GeometryError(
        fmt::format("Edge{} has numbers that are not finite, or 1e100 and more", number));
  SpaceEdge result;
  result.number = number;
  result.curve = BRep_Tool::Curve(edge, result.first, result.last);
  if (result.curve.IsNull())
    throw GeometryError(fmt::format("Edge{} has no curve in space", number));
  if (Precision::IsInfinite(result.first) || Precision::IsInfinite(result.last))
    throw GeometryError(fmt::format("Edge{} is infinite", number));
  result.ends = {vector(result.curve->Value(result.first)),
                 vector(result.curve->Value(result.last))};
  result.tolerance_mm = meeting_mm;
  TopoDS_Vertex first, last;
  TopExp::Vertices(edge, first, last);
  for (const TopoDS_Vertex& vertex : {first, last})
    if (!vertex.IsNull())
      result.tolerance_mm = std::max(result.tolerance_mm, BRep_Tool::Tolerance(vertex));
  return result;
}

bool isFree(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces) {
  if (BRep_Tool::Degenerated(edge) || faces.Extent() > 1) return false;
  return faces.IsEmpty() || !BRep_Tool::IsClosed(edge, TopoDS::Face(faces.First()));
}

std::vector<SpaceEdge> chosenEdges(const TopoDS_Shape& shape, const EdgeChainOptions& options) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  const auto edge = [&](int number) {
    return TopoDS::Edge(edges(number).Oriented(TopAbs_FORWARD));
  };
  std::vector<SpaceEdge> result;
  if (options.edges.empty()) {
    for (int i = 1; i <= edges.Extent(); ++i) {
      const bool alone = options.each_alone && !BRep_Tool::Degenerated(edge(i));
      if (alone || isFree(edge(i), faces.FindFromKey(edges(i))))
        result.push_back(spaceEdge(edge(i), i));
    }
    return result;
  }
  std::vector<int> numbers = options.edges;
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  for (const int number : numbers) {
    requireEdge(number, edges.Extent());
    result.push_back(spaceEdge(edge(number), number));
  }
  return result;
}

/// End \p side of edge \p edge, in the order of their first coordinates.
struct EdgeEnd {
  int edge = 0, side = 0;
};

/// The node of each end: ends that meet have the same one.
class EndNodes {
 public:
  explicit EndNodes(const std::vector<SpaceEdge>& edges)
      : sets_(2 * static_cast<int>(edges.size())) {
    std::vector<EdgeEnd> ends;
    double reach_mm = 0;
    for (int i = 0; i < static_cast<int>(edges.size()); ++i) {
      for (const int side : {0, 1}) ends.push_back({i, side});
      reach_mm = std::max(reach_mm, edges[i].tolerance_mm);
    }
    const auto at = [&](const EdgeEnd& end) -> const Vector3d& {
      return edges[end.edge].ends[end.side];
    };
    std::ranges::sort(ends, {}, [&](const EdgeEnd& end) { return at(end).x(); });
    for (std::size_t i = 0; i < ends.size(); ++i)
      for (std::size_t j = i + 1; j < ends.size(); ++j) {
        if (at(ends[j]).x() - at(ends[i]).x() > reach_mm) break;
        const double near_mm =
            std::max(edges[ends[i].edge].tolerance_mm, edges[ends[j].edge].tolerance_mm);
        if ((at(ends[j]) - at(ends[i])).norm() <= near_mm)
          sets_.unite(index(ends[i]), index(ends[j]));
      }
    for (const EdgeEnd& end : ends) ends_[node(end)].push_back(end);
  }

  int node(const EdgeEnd& end) { return sets_.of(index(end)); }
  /// The other end at a node where two ends meet.
  std::optional<EdgeEnd> partner(const EdgeEnd& end) {
    const std::vector<EdgeEnd>& here = ends_[node(end)];
    if (here.size() != 2) return std::nullopt;
    return here[0].edge == end.edge && here[0].side == end.side ? here[1] : here[0];
  }

 private:
  static int index(const EdgeEnd& end) { return 2 * end.edge + end.side; }

  DisjointSets sets_;
  std::map<int, std::vector<EdgeEnd>> ends_;
};

/// An edge by its index, and how it is run through.
struct Step {
  int edge = 0;
  bool forward = true;
};

struct Walk {
  std::vector<Step> steps;
  bool closed = false;
};

/// From an edge on, until the chain ends or comes back.
Walk walk(EndNodes& nodes, Step start) {
  Walk chain;
  for (Step step = start;;) {
    chain.steps.push_back(step);
    const std::optional<EdgeEnd> next = nodes.partner({step.edge, step.forward ? 1 : 0});
    if (!next) return chain;
    step = {next->edge, next->side == 0};
    if (step.edge == start.edge) {
      chain.closed = true;
      return chain;
    }
  }
}

std::vector<Walk> walksOf(const std::vector<SpaceEdge>& edges, bool each_alone) {
  std::vector<Walk> walks;
  const int count = static_cast<int>(edges.size());
  if (each_alone) {
    for (int i = 0; i < count; ++i) {
      const double gap_mm = (edges[i].ends[0] - edges[i].ends[1]).norm();
      walks.push_back({{{i, true}}, gap_mm <= edges[i].tolerance_mm});
    }
    return walks;
  }
  EndNodes nodes(edges);
  std::vector<bool> used(edges.size(), false);
  for (int i = 0; i < count; ++i) {
    if (used[i]) continue;
    Walk found = walk(nodes, {i, true});
    if (!found.closed) {  // back to its other end, and from there along all of it
      const Step back = walk(nodes, {i, false}).steps.back();
      found = walk(nodes, {back.edge, !back.forward});
    }
    for (const Step& step : found.steps) used[step.edge] = true;
    walks.push_back(std::move(found));
  }
  return walks;
}

}  // namespace

std::vector<EdgeChain> edgeChains(const TopoDS_Shape& shape, const EdgeChainOptions& options) {
  const std::vector<SpaceEdge> edges = chosenEdges(shape, options);
  std::vector<EdgeChain> chains;
  for (const Walk& walk : walksOf(edges, options.each_alone)) {
    EdgeChain& chain = chains.emplace_back();
    chain.closed = walk.closed;
    for (const Step& step : walk.steps) chain.edges.push_back({edges[step.edge], step.forward});
  }
  return chains;
}

std::string namesOf(const EdgeChain& chain) {
  constexpr std::size_t shown = 5;
  const std::size_t count = chain.edges.size();
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, count); ++i)
    text += fmt::format("{}Edge{}", i == 0 ? "" : ", ", chain.edges[i].edge.number);
  if (count > shown) text += fmt::format(" and {} more", count - shown);
  return text;
}

}  // namespace seamwright::occ
