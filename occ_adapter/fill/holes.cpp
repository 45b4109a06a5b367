// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <stdexcept>

#include <seamwright/core/angle.hpp>
#include <seamwright/core/disjoint_sets.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/fill/holes.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/seams/edge_path.hpp>

namespace seamwright::occ {

namespace {

/// A free edge with its ends: begin and end in the direction of the hole.
struct Link {
  HoleEdge edge;
  std::array<int, 2> nodes{};
  std::array<Eigen::Vector3d, 2> tangents;  ///< unit, in the direction of the hole
  Eigen::Vector3d centre;                   ///< centre of mass
};

Eigen::Vector3d centreOf(const TopoDS_Edge& edge) {
  GProp_GProps properties;
  BRepGProp::LinearProperties(edge, properties);
  return vector(properties.CentreOfMass());
}

struct Corner {
  gp_Pnt point;
  double reach_mm;
};

std::string freeEdgesText(std::vector<int> edges) {
  // A choice: a message of one or two lines.
  constexpr std::size_t most = 10;
  std::ranges::sort(edges);
  std::string text = edges.size() == 1 ? "edge" : std::to_string(edges.size()) + " edges:";
  for (std::size_t k = 0; k < std::min(edges.size(), most); ++k)
    text += (k == 0 ? " " : ", ") + std::to_string(edges[k]);
  if (edges.size() > most) text += " ...";
  return text + (edges.size() == 1 ? " is" : " are") + " part of no closed loop";
}

/// Whether no edge of the loop is part of the outer boundary of its face.
bool isInsideFaces(const Hole& hole, const TopTools_IndexedMapOfShape& faces) {
  for (const HoleSide& side : hole.sides)
    for (const HoleEdge& edge : side.edges) {
      const TopoDS_Wire outer = BRepTools::OuterWire(TopoDS::Face(faces(edge.use.face)));
      for (TopExp_Explorer it(outer, TopAbs_EDGE); it.More(); it.Next())
        if (it.Current().IsSame(edge.use.edge)) return false;
    }
  return true;
}

class Loops {
 public:
  Loops(const TopoDS_Shape& shape, const HoleOptions& options) : options_(options) {
    TopExp::MapShapes(shape, TopAbs_FACE, faces_);
    TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
    graph_ = findSeams(shape);
  }

  Holes run() {
    for (const Coedge& use : graph_.open_uses) addLink(use);
    mergeNodes();
    walk();
    std::ranges::sort(loops_, {}, [](const std::vector<Link>& loop) { return smallestEdge(loop); });
    for (const std::vector<Link>& loop : loops_) {
      result_.holes.push_back(holeOf(loop));
      result_.holes.back().id = static_cast<int>(result_.holes.size());
    }
    markLongest();
    return std::move(result_);
  }

 private:
  static int smallestEdge(const std::vector<Link>& loop) {
    return std::ranges::min(loop, {}, [](const Link& link) { return link.edge.edge; }).edge.edge;
  }

  /// Whether the hole runs against the edge's curve. The face lies to the left of its coedge, so
  /// the hole is to the right, unless the face is reversed.
  bool runsAgainst(const Coedge& use) const {
    const bool face_turned = faces_(use.face).Orientation() == TopAbs_REVERSED;
    return (use.edge.Orientation() == TopAbs_REVERSED) == face_turned;
  }

  void addLink(const Coedge& use) {
    const int number = edges_.FindIndex(use.edge);
    try {
      requireUsable(use);
      const EdgePath path(use, number, options_.gap_mm);
      Link link;
      link.edge = {number, use, runsAgainst(use), path.length_mm()};
      link.centre = centreOf(use.edge);
      for (const int end : {0, 1}) {
        const bool at_last = (end == 1) != link.edge.reversed;
        link.tangents[end] = (link.edge.reversed ? -1 : 1) * path.direction(at_last ? 1 : 0);
        link.nodes[end] = nodeOf(use.edge, at_last);
      }
      links_.push_back(std::move(link));
    } catch (const Standard_Failure& failure) {
      result_.notes.push_back("edge " + std::to_string(number) +
                              " can't be evaluated: OpenCASCADE failed: " +
                              failure.DynamicType()->Name() + " " + failure.GetMessageString());
    } catch (const GeometryError& error) {
      result_.notes.push_back("edge " + std::to_string(number) +
                              " can't be evaluated: " + error.what());
    }
  }

  int nodeOf(const TopoDS_Edge& edge, bool at_last) {
    const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex vertex =
        at_last ? TopExp::LastVertex(forward) : TopExp::FirstVertex(forward);
    if (vertex.IsNull()) throw GeometryError("it ends without a vertex");
    if (const int known = vertices_.FindIndex(vertex); known > 0) return known - 1;
    corners_.push_back({BRep_Tool::Pnt(vertex), BRep_Tool::Tolerance(vertex)});
    return vertices_.Add(vertex) - 1;
  }

  /// Merges ends at the same position into one node, whether the edges share a vertex or not.
  void mergeNodes() {
    nodes_ = DisjointSets(static_cast<int>(corners_.size()));
    std::vector<int> order(corners_.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [this](int k) { return corners_[k].point.X(); });
    double largest_mm = options_.gap_mm;
    for (const Corner& corner : corners_) largest_mm = std::max(largest_mm, corner.reach_mm);
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        const Corner &a = corners_[order[i]], &b = corners_[order[j]];
        if (b.point.X() - a.point.X() > 2 * largest_mm) break;
        if (a.point.Distance(b.point) <= std::max(options_.gap_mm, a.reach_mm + b.reach_mm))
          nodes_.unite(order[i], order[j]);
      }
    for (Link& link : links_)
      for (int& node : link.nodes) node = nodes_.of(node);
  }

  static Link turned(Link link) {
    link.edge.reversed = !link.edge.reversed;
    std::swap(link.nodes[0], link.nodes[1]);
    std::swap(link.tangents[0], link.tangents[1]);
    for (Eigen::Vector3d& tangent : link.tangents) tangent = -tangent;
    return link;
  }

  /// Follows edges from node to node. When the path returns to one of its nodes, the loop so closed
  /// is removed from the path.
  void walk() {
    std::map<int, std::vector<std::size_t>> at_node;
    for (std::size_t k = 0; k < links_.size(); ++k)
      for (const int node : links_[k].nodes) at_node[node].push_back(k);
    std::vector<bool> used(links_.size());
    std::vector<int> free_edges;
    for (std::size_t start = 0; start < links_.size(); ++start) {
      if (used[start]) continue;
      std::vector<Link> path;
      std::optional<Link> next = links_[start];
      used[start] = true;
      while (next) {
        path.push_back(*next);
        cutLoop(path);
        next = path.empty() ? std::nullopt : nextLink(path.back().nodes[1], at_node, used);
      }
      for (const Link& link : path) free_edges.push_back(link.edge.edge);
    }
    if (!free_edges.empty()) result_.notes.push_back(freeEdgesText(free_edges));
  }

  /// A link that begins at the node; otherwise one that ends there, reversed.
  std::optional<Link> nextLink(int node, const std::map<int, std::vector<std::size_t>>& at_node,
                               std::vector<bool>& used) const {
    for (const bool turn : {false, true})
      for (const std::size_t k : at_node.at(node)) {
        if (used[k] || links_[k].nodes[turn ? 1 : 0] != node) continue;
        used[k] = true;
        return turn ? turned(links_[k]) : links_[k];
      }
    return std::nullopt;
  }

  void cutLoop(std::vector<Link>& path) {
    const int node = path.back().nodes[1];
    const auto first =
        std::ranges::find_if(path, [node](const Link& link) { return link.nodes[0] == node; });
    if (first == path.end()) return;
    loops_.emplace_back(first, path.end());
    path.erase(first, path.end());
  }

  Hole holeOf(std::vector<Link> loop) const {
    const std::size_t n = loop.size();
    std::vector<std::size_t> begins;
    for (std::size_t k = 0; k < n; ++k) {
      const Eigen::Vector3d &in = loop[(k + n - 1) % n].tangents[1], &out = loop[k].tangents[0];
      if (std::atan2(in.cross(out).norm(), in.dot(out)) > options_.corner_rad) begins.push_back(k);
    }
    Hole hole;
    hole.has_corners = !begins.empty();
    if (begins.empty()) begins.push_back(0);
    for (std::size_t s = 0; s < begins.size(); ++s) {
      HoleSide side;
      const std::size_t end = s + 1 < begins.size() ? begins[s + 1] : begins[0] + n;
      for (std::size_t k = begins[s]; k < end; ++k) {
        side.edges.push_back(loop[k < n ? k : k - n].edge);
        side.length_mm += side.edges.back().length_mm;
      }
      hole.length_mm += side.length_mm;
      hole.sides.push_back(std::move(side));
    }
    for (const Link& link : loop) hole.centre += link.edge.length_mm / hole.length_mm * link.centre;
    return hole;
  }

  void markLongest() {
    DisjointSets groups(faces_.Extent() + 1);
    for (const Seam& seam : graph_.seams) groups.unite(seam.sides[0].face, seam.sides[1].face);
    for (const std::vector<Link>& loop : loops_)
      for (const Link& link : loop) groups.unite(link.edge.use.face, loop.front().edge.use.face);
    std::map<int, std::vector<Hole*>> by_faces;
    for (Hole& hole : result_.holes)
      by_faces[groups.of(hole.sides.front().edges.front().use.face)].push_back(&hole);
    for (auto& [group, holes] : by_faces) {
      std::ranges::sort(holes, std::greater{}, &Hole::length_mm);
      const bool is_longest =
          holes.size() == 1 || holes[0]->length_mm - holes[1]->length_mm > options_.gap_mm;
      holes.front()->longest = is_longest && !isInsideFaces(*holes.front(), faces_);
    }
  }

  const HoleOptions& options_;
  TopTools_IndexedMapOfShape faces_, edges_, vertices_;
  SeamGraph graph_;
  std::vector<Link> links_;
  std::vector<Corner> corners_;  ///< by vertex
  DisjointSets nodes_;
  std::vector<std::vector<Link>> loops_;
  Holes result_;
};

}  // namespace

void HoleOptions::validate() const {
  if (!(corner_rad > 0 && corner_rad < std::numbers::pi))
    throw std::invalid_argument(
        fmt::format("corner angle is {:.6g} degrees: it must be above 0 and below 180",
                    corner_rad * degrees_per_radian));
  if (!(gap_mm > 0 && std::isfinite(gap_mm)))
    throw std::invalid_argument(fmt::format("gap is {:.6g} mm: it must be positive", gap_mm));
}

Holes findHoles(const TopoDS_Shape& shape, const HoleOptions& options) {
  options.validate();
  return Loops(shape, options).run();
}

}  // namespace seamwright::occ
