// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

#include <seamwright/core/disjoint_sets.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/topology/sewn_edges.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// An edge, or a piece of one, after sewing.
struct EdgePiece {
  /// In the frame of the shape; FORWARD: in the direction of the edge of which it is a piece.
  TopoDS_Edge edge;
  int interval = -1;           ///< index of the interval, for a common edge; otherwise -1
  std::array<int, 2> nodes{};  ///< nodes at the first and the last end of the old edge's piece
  std::array<std::vector<gp_Pnt>, 2> curve_ends, image_ends;
  double tolerance_mm = 0;
};

/// The vertex that a group of vertices becomes.
struct Corner {
  std::vector<std::size_t> seams;  ///< sewn seams that end here
  gp_Pnt place;
  double tolerance_mm = 0, was_mm = 0;
  TopoDS_Vertex vertex;
};

class EdgeSewer {
 public:
  EdgeSewer(const TopoDS_Shape& shape, const std::vector<Seam>& seams, double gap_mm)
      : seams_(seams), gap_mm_(gap_mm), unusable_(shape) {
    TopExp::MapShapes(shape, TopAbs_FACE, faces_);
    TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
    TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
    TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edge_);
    nodes_ = DisjointSets(vertices_.Extent() + 1);
  }

  SewnEdges run(const std::vector<std::size_t>& chosen) {
    cut(chosen);
    if (mayGoOn()) joinEnds();
    if (mayGoOn()) makeCommonEdges();
    if (mayGoOn()) {
      makePieces();
      makeCorners();
    }
    if (mayGoOn()) {
      closePieces();
      hand();
    }
    return std::move(result_);
  }

 private:
  bool mayGoOn() const { return result_.refused.empty(); }
  void refuse(std::size_t seam, const std::string& why) { result_.refused.emplace(seam, why); }

  void cut(const std::vector<std::size_t>& chosen) {
    SewnIntervals found = sewnIntervals(seams_, chosen, gap_mm_);
    result_.intervals = std::move(found.intervals);
    cuts_ = std::move(found.cuts);
    result_.refused = std::move(found.refused);
    for (const auto& [edge, cuts] : cuts_)
      for (std::size_t k = 1; k + 1 < cuts.size(); ++k)
        cut_nodes_[{edge, static_cast<int>(k)}] = nodes_.add();
  }

  int piecesOf(int edge) const {
    const auto found = cuts_.find(edge);
    return found == cuts_.end() ? 1 : static_cast<int>(found->second.size()) - 1;
  }

  TopoDS_Edge oldEdge(int edge) const {
    return TopoDS::Edge(edges_(edge).Oriented(TopAbs_FORWARD));
  }

  /// The node after piece k - 1; 0 if the edge has no vertex there.
  int nodeAt(int edge, int k) const {
    if (const auto cut = cut_nodes_.find({edge, k}); cut != cut_nodes_.end()) return cut->second;
    const TopoDS_Vertex end =
        k == 0 ? TopExp::FirstVertex(oldEdge(edge)) : TopExp::LastVertex(oldEdge(edge));
    return end.IsNull() ? 0 : vertices_.FindIndex(end);
  }

  void joinEnds() {
    for (const SewnInterval& interval : result_.intervals)
      for (const int end : {0, 1}) {
        const int on_b = interval.reversed() ? 1 - end : end;
        const int a = nodeAt(interval.edges[0], interval.pieces[0] + end);
        const int b = nodeAt(interval.edges[1], interval.pieces[1] + on_b);
        if (a == 0 || b == 0)
          refuse(interval.seam, "an edge ends without a vertex");
        else
          nodes_.unite(a, b);
      }
    std::map<int, int> members;
    for (int node = 1; node < nodes_.count(); ++node) ++members[nodes_.of(node)];
    for (int node = 1; node < nodes_.count(); ++node)
      if (node > vertices_.Extent() || members.at(nodes_.of(node)) > 1) corners_[nodes_.of(node)];
    for (const SewnInterval& interval : result_.intervals)
      for (const int end : {0, 1})
        corners_[nodes_.of(nodeAt(interval.edges[0], interval.pieces[0] + end))].seams.push_back(
            interval.seam);
  }

  bool isCorner(int node) const { return corners_.count(nodes_.of(node)) > 0; }

  // Edges.

  void makeCommonEdges() {
    for (std::size_t k = 0; k < result_.intervals.size(); ++k) {
      const SewnInterval& interval = result_.intervals[k];
      try {
        common_.push_back(commonEdge(seams_[interval.seam], interval.places, gap_mm_));
      } catch (const std::runtime_error& error) {
        refuse(interval.seam, error.what());
        return;
      }
      for (const int side : {0, 1})
        interval_at_[{interval.edges[side], interval.pieces[side]}] = {static_cast<int>(k), side};
    }
  }

  void makePieces() {
    for (int edge = 1; edge <= edges_.Extent(); ++edge) {
      const int count = piecesOf(edge);
      const bool is_concerned =
          cuts_.count(edge) > 0 || isCorner(nodeAt(edge, 0)) || isCorner(nodeAt(edge, 1));
      if (!is_concerned) continue;
      for (int k = 0; k < count; ++k) pieces_[edge].push_back(pieceOf(edge, k));
    }
  }

  EdgePiece pieceOf(int edge, int k) const {
    const auto sewn = interval_at_.find({edge, k});
    EdgePiece piece = sewn == interval_at_.end()
                          ? ownPiece(edge, k)
                          : commonPiece(sewn->second.first, sewn->second.second);
    piece.nodes = {nodeAt(edge, k), nodeAt(edge, k + 1)};
    return piece;
  }

  EdgePiece commonPiece(int number, int side) const {
    const CommonEdge& common = common_[number];
    EdgePiece piece;
    piece.interval = number;
    const bool reversed = side == 1 && result_.intervals[number].reversed();
    piece.edge = TopoDS::Edge(common.edge.Oriented(reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
    piece.tolerance_mm = common.tolerance_mm;
    for (const int end : {0, 1}) {
      const bool at_first = (end == 0) != reversed;
      piece.curve_ends[end].push_back(common.curve->Value(at_first ? common.first : common.last));
      for (const EdgeSide& beside : common.sides)
        piece.image_ends[end].push_back(beside.at(at_first ? 0 : points_of_an_edge - 1));
    }
    return piece;
  }

  /// Whether the pcurve is stored. On a plane it may be implied by the curve in space and its
  /// range.
  static bool hasStoredPath(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    double first = 0, last = 0;
    bool is_stored = false;
    const handle<Geom2d_Curve> path =
        BRep_Tool::CurveOnSurface(edge, face, first, last, &is_stored);
    return !path.IsNull() && is_stored;
  }

  EdgePiece ownPiece(int edge, int k) const {
    const TopoDS_Edge old = oldEdge(edge);
    const auto cuts = cuts_.find(edge);
    const Places places =
        cuts == cuts_.end() ? Places{0, 1} : Places{cuts->second[k], cuts->second[k + 1]};
    const auto at = [](double first, double last, double place) {
      return first + place * (last - first);
    };
    EdgePiece piece;
    piece.edge = TopoDS::Edge(old.EmptyCopied());
    if (unusable_.hasEdge(edge)) return piece;  // the positions of its ends are not known
    piece.tolerance_mm = BRep_Tool::Tolerance(old);
    const bool is_part = places[0] > 0 || places[1] < 1;
    double first = 0, last = 0;
    const handle<Geom_Curve> curve = BRep_Tool::Curve(old, first, last);
    if (is_part)
      builder_.Range(piece.edge, at(first, last, places[0]), at(first, last, places[1]), true);
    for (const int end : {0, 1})
      if (!curve.IsNull())
        piece.curve_ends[end].push_back(curve->Value(at(first, last, places[end])));
    for (const TopoDS_Shape& beside : faces_of_edge_.FindFromKey(edges_(edge))) {
      if (unusable_.hasFace(faces_.FindIndex(beside))) continue;
      const TopoDS_Face face = TopoDS::Face(beside.Oriented(TopAbs_FORWARD));
      const PlanarPath path = pathOf(old, face);
      if (path.curve.IsNull()) continue;
      const PlacedSurface placed = surfaceOf(face);
      if (is_part && hasStoredPath(old, face))
        builder_.Range(piece.edge, placed.surface, placed.location,
                       at(path.first, path.last, places[0]), at(path.first, path.last, places[1]));
      for (const int end : {0, 1})
        piece.image_ends[end].push_back(
            placed.at(path.curve->Value(at(path.first, path.last, places[end]))));
    }
    return piece;
  }

  // Vertices.

  void makeCorners() {
    std::map<int, std::vector<gp_Pnt>> curves, all;
    for (const auto& [edge, pieces] : pieces_)
      for (const EdgePiece& piece : pieces)
        for (const int end : {0, 1}) {
          const int node = nodes_.of(piece.nodes[end]);
          const auto corner = corners_.find(node);
          if (corner == corners_.end()) continue;
          corner->second.tolerance_mm = std::max(corner->second.tolerance_mm, piece.tolerance_mm);
          for (const gp_Pnt& point : piece.curve_ends[end]) curves[node].push_back(point);
          for (const std::vector<gp_Pnt>* points : {&piece.curve_ends[end], &piece.image_ends[end]})
            all[node].insert(all[node].end(), points->begin(), points->end());
        }
    for (int v = 1; v <= vertices_.Extent(); ++v)
      if (const auto corner = corners_.find(nodes_.of(v)); corner != corners_.end())
        corner->second.was_mm =
            std::max(corner->second.was_mm, BRep_Tool::Tolerance(TopoDS::Vertex(vertices_(v))));
    for (auto& [node, corner] : corners_) makeCorner(curves[node], all[node], corner);
  }

  void makeCorner(const std::vector<gp_Pnt>& curves, const std::vector<gp_Pnt>& all,
                  Corner& corner) {
    const std::vector<gp_Pnt>& of_place = curves.empty() ? all : curves;
    gp_XYZ sum;
    for (const gp_Pnt& end : of_place) sum += end.XYZ();
    corner.place = gp_Pnt(sum / static_cast<double>(of_place.size()));
    // Margin: rounding must not leave an end outside of the tolerance.
    constexpr double rounding = 1.001;
    corner.tolerance_mm = std::max(Precision::Confusion(), corner.tolerance_mm);
    for (const gp_Pnt& end : all)
      corner.tolerance_mm = std::max(corner.tolerance_mm, rounding * end.Distance(corner.place));
    builder_.MakeVertex(corner.vertex, corner.place, corner.tolerance_mm);
    const double allowed_mm = 2 * std::max(gap_mm_, corner.was_mm);
    if (corner.tolerance_mm <= allowed_mm) return;
    std::ostringstream why;
    why << "a common vertex would be " << corner.tolerance_mm
        << " mm from the ends of its edges, more than " << allowed_mm << " mm";
    for (const std::size_t seam : corner.seams) refuse(seam, why.str());
  }

  TopoDS_Vertex vertexAt(int node) const {
    const auto corner = corners_.find(nodes_.of(node));
    return corner == corners_.end() ? TopoDS::Vertex(vertices_(node)) : corner->second.vertex;
  }

  /// Adds the vertices to the pieces, only once for a common edge.
  void closePieces() {
    std::set<int> closed;
    for (auto& [edge, pieces] : pieces_)
      for (EdgePiece& piece : pieces) {
        if (piece.interval >= 0 && !closed.insert(piece.interval).second) continue;
        const bool reversed = piece.edge.Orientation() == TopAbs_REVERSED;
        TopoDS_Edge forward = TopoDS::Edge(piece.edge.Oriented(TopAbs_FORWARD));
        for (const int end : {0, 1}) {
          const int node = piece.nodes[reversed ? 1 - end : end];
          if (node != 0)
            builder_.Add(forward,
                         vertexAt(node).Oriented(end == 0 ? TopAbs_FORWARD : TopAbs_REVERSED));
        }
      }
  }

  void hand() {
    for (const CommonEdge& common : common_) result_.common.push_back(common.edge);
    for (const auto& [edge, pieces] : pieces_)
      for (const EdgePiece& piece : pieces) result_.pieces[edge].push_back(piece.edge);
    for (int v = 1; v <= vertices_.Extent(); ++v)
      if (isCorner(v)) result_.vertices[v] = vertexAt(v);
  }

  const std::vector<Seam>& seams_;
  double gap_mm_;
  BRep_Builder builder_;
  UnusableParts unusable_;
  TopTools_IndexedMapOfShape faces_, edges_, vertices_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge_;
  std::map<int, std::vector<double>> cuts_;       ///< by edge
  std::map<std::pair<int, int>, int> cut_nodes_;  ///< by edge and number of the cut
  DisjointSets nodes_;                            ///< vertices, by number, and cuts
  std::map<int, Corner> corners_;                 ///< by node that becomes a new vertex
  std::vector<CommonEdge> common_;                ///< by interval
  /// By edge and piece: interval and side.
  std::map<std::pair<int, int>, std::pair<int, int>> interval_at_;
  std::map<int, std::vector<EdgePiece>> pieces_;  ///< by edge that changes
  SewnEdges result_;
};

}  // namespace

SewnEdges sewnEdges(const TopoDS_Shape& shape, const std::vector<Seam>& seams,
                    const std::vector<std::size_t>& chosen, double gap_mm) {
  return EdgeSewer(shape, seams, gap_mm).run(chosen);
}

}  // namespace seamwright::occ
