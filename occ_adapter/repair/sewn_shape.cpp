// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>

#include <seamwright/occ_adapter/repair/sewn_shape.hpp>
#include <seamwright/occ_adapter/repair/stretches.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// What is one.
class Groups {
 public:
  explicit Groups(int count = 0) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int add() {
    parent_.push_back(static_cast<int>(parent_.size()));
    return parent_.back();
  }
  int of(int member) const {
    while (parent_[member] != member) member = parent_[member];
    return member;
  }
  void join(int a, int b) { parent_[std::max(of(a), of(b))] = std::min(of(a), of(b)); }
  int count() const { return static_cast<int>(parent_.size()); }

 private:
  std::vector<int> parent_;
};

/// What an edge, or a part of it, is after sewing.
struct EdgePiece {
  TopoDS_Edge edge;  ///< in the frame of the shape, running as the edge that it is a piece of if forward
  int stretch = -1;  ///< of a common edge
  std::array<int, 2> nodes{};  ///< at the first and the last end of the old edge's piece
  std::array<std::vector<gp_Pnt>, 2> curve_ends, image_ends;
  double tolerance_mm = 0;
};

/// What a group of vertices becomes.
struct Corner {
  std::vector<std::size_t> seams;  ///< sewn ones that end here
  gp_Pnt place;
  double tolerance_mm = 0, was_mm = 0;
  TopoDS_Vertex vertex;
};

class Sewer {
 public:
  Sewer(const TopoDS_Shape& shape, const std::vector<Seam>& seams, const std::vector<std::size_t>& chosen,
        double gap_mm)
      : shape_(shape), seams_(seams), gap_mm_(gap_mm) {
    TopExp::MapShapes(shape, TopAbs_FACE, faces_);
    TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
    TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
    TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edge_);
    groups_ = Groups(faces_.Extent() + 1);
    nodes_ = Groups(vertices_.Extent() + 1);
    refuseUnfit(chosen);
  }

  SewnShape run() {
    if (mayGoOn()) cut();
    if (mayGoOn()) joinEnds();
    if (mayGoOn()) makeCommonEdges();
    if (mayGoOn()) makePieces();
    if (mayGoOn()) makeCorners();
    if (mayGoOn()) {
      closePieces();
      makeFaces();
      joinFaces();
      turnFaces();
    }
    if (mayGoOn()) {
      putTogether();
      number();
    }
    return std::move(result_);
  }

 private:
  bool mayGoOn() const { return result_.refused.empty(); }
  void refuse(std::size_t seam, const std::string& why) { result_.refused.emplace(seam, why); }

  // What can be sewn at all.

  void refuseUnfit(const std::vector<std::size_t>& chosen) {
    std::map<const TopoDS_TShape*, int> instances;
    for (int f = 1; f <= faces_.Extent(); ++f) ++instances[faces_(f).TShape().get()];
    const std::set<int> in_hollow = facesOfHollowSolids();
    for (const std::size_t i : chosen) {
      const std::string why = whyUnfit(seams_[i], instances, in_hollow);
      if (why.empty())
        chosen_.push_back(i);
      else
        refuse(i, why);
    }
  }

  std::string whyUnfit(const Seam& seam, const std::map<const TopoDS_TShape*, int>& instances,
                       const std::set<int>& in_hollow) const {
    for (const FaceUse& side : seam.sides) {
      const std::string face = "face " + std::to_string(side.face);
      const int count = instances.at(side.shape.TShape().get());
      if (count > 1) return face + " stands in the model " + std::to_string(count) + " times";
      if (in_hollow.count(side.face) > 0) return face + " is part of a solid of several shells";
    }
    if (seam.sides[0].face == seam.sides[1].face) return {};
    const PlacedSurface a = surfaceOf(seam.sides[0].shape), b = surfaceOf(seam.sides[1].shape);
    if (a.surface == b.surface && a.location == b.location)
      return "faces " + std::to_string(seam.sides[0].face) + " and " + std::to_string(seam.sides[1].face) +
             " have one surface in common";
    return {};
  }

  std::set<int> facesOfHollowSolids() const {
    std::set<int> numbers;
    for (TopExp_Explorer solid(shape_, TopAbs_SOLID); solid.More(); solid.Next()) {
      int shells = 0;
      for (TopExp_Explorer shell(solid.Current(), TopAbs_SHELL); shell.More(); shell.Next()) ++shells;
      if (shells < 2) continue;
      for (TopExp_Explorer face(solid.Current(), TopAbs_FACE); face.More(); face.Next())
        numbers.insert(faces_.FindIndex(face.Current()));
    }
    return numbers;
  }

  // Ends of edges.

  void cut() {
    SewnStretches found = sewnStretches(seams_, chosen_, gap_mm_);
    stretches_ = std::move(found.stretches);
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

  TopoDS_Edge oldEdge(int edge) const { return TopoDS::Edge(edges_(edge).Oriented(TopAbs_FORWARD)); }

  /// After piece k - 1; 0 where the edge has no vertex there.
  int nodeAt(int edge, int k) const {
    if (const auto cut = cut_nodes_.find({edge, k}); cut != cut_nodes_.end()) return cut->second;
    const TopoDS_Vertex end = k == 0 ? TopExp::FirstVertex(oldEdge(edge)) : TopExp::LastVertex(oldEdge(edge));
    return end.IsNull() ? 0 : vertices_.FindIndex(end);
  }

  void joinEnds() {
    for (const SewnStretch& stretch : stretches_)
      for (const int end : {0, 1}) {
        const int on_b = stretch.reversed() ? 1 - end : end;
        const int a = nodeAt(stretch.edges[0], stretch.pieces[0] + end);
        const int b = nodeAt(stretch.edges[1], stretch.pieces[1] + on_b);
        if (a == 0 || b == 0)
          refuse(stretch.seam, "an edge ends without a vertex");
        else
          nodes_.join(a, b);
      }
    std::map<int, int> members;
    for (int node = 1; node < nodes_.count(); ++node) ++members[nodes_.of(node)];
    for (int node = 1; node < nodes_.count(); ++node)
      if (node > vertices_.Extent() || members.at(nodes_.of(node)) > 1) corners_[nodes_.of(node)];
    for (const SewnStretch& stretch : stretches_)
      for (const int end : {0, 1})
        corners_[nodes_.of(nodeAt(stretch.edges[0], stretch.pieces[0] + end))].seams.push_back(stretch.seam);
  }

  bool isCorner(int node) const { return corners_.count(nodes_.of(node)) > 0; }

  // Edges.

  void makeCommonEdges() {
    for (std::size_t k = 0; k < stretches_.size(); ++k) {
      const SewnStretch& stretch = stretches_[k];
      try {
        common_.push_back(commonEdge(seams_[stretch.seam], stretch.places, gap_mm_));
      } catch (const std::runtime_error& error) {
        refuse(stretch.seam, error.what());
        return;
      }
      result_.largest_tolerance_mm = std::max(result_.largest_tolerance_mm, common_.back().tolerance_mm);
      for (const int side : {0, 1})
        stretch_at_[{stretch.edges[side], stretch.pieces[side]}] = {static_cast<int>(k), side};
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
    const auto sewn = stretch_at_.find({edge, k});
    EdgePiece piece =
        sewn == stretch_at_.end() ? ownPiece(edge, k) : commonPiece(sewn->second.first, sewn->second.second);
    piece.nodes = {nodeAt(edge, k), nodeAt(edge, k + 1)};
    return piece;
  }

  EdgePiece commonPiece(int number, int side) const {
    const CommonEdge& common = common_[number];
    EdgePiece piece;
    piece.stretch = number;
    const bool reversed = side == 1 && stretches_[number].reversed();
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

  EdgePiece ownPiece(int edge, int k) const {
    const TopoDS_Edge old = oldEdge(edge);
    const auto cuts = cuts_.find(edge);
    const Places places = cuts == cuts_.end() ? Places{0, 1} : Places{cuts->second[k], cuts->second[k + 1]};
    const auto at = [](double first, double last, double place) { return first + place * (last - first); };
    EdgePiece piece;
    piece.edge = TopoDS::Edge(old.EmptyCopied());
    piece.tolerance_mm = BRep_Tool::Tolerance(old);
    const bool is_part = places[0] > 0 || places[1] < 1;
    double first = 0, last = 0;
    const handle<Geom_Curve> curve = BRep_Tool::Curve(old, first, last);
    if (is_part) builder_.Range(piece.edge, at(first, last, places[0]), at(first, last, places[1]), true);
    for (const int end : {0, 1})
      if (!curve.IsNull()) piece.curve_ends[end].push_back(curve->Value(at(first, last, places[end])));
    for (const TopoDS_Shape& beside : faces_of_edge_.FindFromKey(edges_(edge))) {
      const TopoDS_Face face = TopoDS::Face(beside.Oriented(TopAbs_FORWARD));
      const PlanarPath path = pathOf(old, face);
      if (path.curve.IsNull()) continue;
      const PlacedSurface placed = surfaceOf(face);
      if (is_part)
        builder_.Range(piece.edge, placed.surface, placed.location, at(path.first, path.last, places[0]),
                       at(path.first, path.last, places[1]));
      for (const int end : {0, 1})
        piece.image_ends[end].push_back(placed.at(path.curve->Value(at(path.first, path.last, places[end]))));
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

  void makeCorner(const std::vector<gp_Pnt>& curves, const std::vector<gp_Pnt>& all, Corner& corner) {
    const std::vector<gp_Pnt>& of_place = curves.empty() ? all : curves;
    gp_XYZ sum;
    for (const gp_Pnt& end : of_place) sum += end.XYZ();
    corner.place = gp_Pnt(sum / static_cast<double>(of_place.size()));
    constexpr double rounding = 1.001;
    corner.tolerance_mm = std::max(Precision::Confusion(), corner.tolerance_mm);
    for (const gp_Pnt& end : all)
      corner.tolerance_mm = std::max(corner.tolerance_mm, rounding * end.Distance(corner.place));
    builder_.MakeVertex(corner.vertex, corner.place, corner.tolerance_mm);
    const double allowed_mm = 2 * std::max(gap_mm_, corner.was_mm);
    if (corner.tolerance_mm <= allowed_mm) return;
    for (const std::size_t seam : corner.seams)
      refuse(seam, "a common vertex would be " + std::to_string(corner.tolerance_mm) +
                       " mm from the ends of its edges, more than " + std::to_string(allowed_mm) + " mm");
  }

  TopoDS_Vertex vertexAt(int node) const {
    const auto corner = corners_.find(nodes_.of(node));
    return corner == corners_.end() ? TopoDS::Vertex(vertices_(node)) : corner->second.vertex;
  }

  /// Gives the pieces their vertices; a common edge is given them once.
  void closePieces() {
    std::set<int> closed;
    for (auto& [edge, pieces] : pieces_)
      for (EdgePiece& piece : pieces) {
        if (piece.stretch >= 0 && !closed.insert(piece.stretch).second) continue;
        const bool reversed = piece.edge.Orientation() == TopAbs_REVERSED;
        TopoDS_Edge forward = TopoDS::Edge(piece.edge.Oriented(TopAbs_FORWARD));
        for (const int end : {0, 1}) {
          const int node = piece.nodes[reversed ? 1 - end : end];
          if (node != 0)
            builder_.Add(forward, vertexAt(node).Oriented(end == 0 ? TopAbs_FORWARD : TopAbs_REVERSED));
        }
      }
  }

  // Faces.

  void makeFaces() {
    new_faces_.resize(faces_.Extent() + 1);
    for (int f = 1; f <= faces_.Extent(); ++f) {
      const TopoDS_Face old = TopoDS::Face(faces_(f));
      bool is_new = false;
      for (TopExp_Explorer edge(old, TopAbs_EDGE); edge.More() && !is_new; edge.Next())
        is_new = pieces_.count(edges_.FindIndex(edge.Current())) > 0;
      new_faces_[f] = is_new ? rebuilt(old) : old;
    }
  }

  TopoDS_Face rebuilt(const TopoDS_Face& old) {
    const TopoDS_Face forward = TopoDS::Face(old.Oriented(TopAbs_FORWARD));
    TopoDS_Face face = TopoDS::Face(forward.EmptyCopied());
    for (TopoDS_Iterator part(forward); part.More(); part.Next())
      builder_.Add(face, part.Value().ShapeType() == TopAbs_WIRE ? rebuiltWire(TopoDS::Wire(part.Value()))
                                                                 : replaced(part.Value()));
    builder_.NaturalRestriction(face, BRep_Tool::NaturalRestriction(old));
    return TopoDS::Face(face.Oriented(old.Orientation()));
  }

  TopoDS_Shape rebuiltWire(const TopoDS_Wire& old) {
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (TopoDS_Iterator it(old.Oriented(TopAbs_FORWARD)); it.More(); it.Next())
      for (const TopoDS_Shape& piece : replacedEdge(TopoDS::Edge(it.Value()))) builder_.Add(wire, piece);
    wire.Closed(old.Closed());
    return wire.Oriented(old.Orientation());
  }

  std::vector<TopoDS_Shape> replacedEdge(const TopoDS_Edge& edge) const {
    const auto found = pieces_.find(edges_.FindIndex(edge));
    if (found == pieces_.end()) return {edge};
    std::vector<TopoDS_Shape> pieces;
    for (const EdgePiece& piece : found->second)
      pieces.push_back(piece.edge.Oriented(TopAbs::Compose(edge.Orientation(), piece.edge.Orientation())));
    if (edge.Orientation() == TopAbs_REVERSED) std::ranges::reverse(pieces);
    return pieces;
  }

  TopoDS_Shape replaced(const TopoDS_Shape& vertex) const {
    if (vertex.ShapeType() != TopAbs_VERTEX) return vertex;
    return vertexAt(vertices_.FindIndex(vertex)).Oriented(vertex.Orientation());
  }

  /// Faces of one shell after sewing.
  void joinFaces() {
    for (const SewnStretch& stretch : stretches_) {
      const auto& sides = seams_[stretch.seam].sides;
      groups_.join(sides[0].face, sides[1].face);
      sewn_faces_.insert({sides[0].face, sides[1].face});
    }
    for (TopExp_Explorer shell(shape_, TopAbs_SHELL); shell.More(); shell.Next()) {
      std::vector<int> numbers;
      for (TopExp_Explorer face(shell.Current(), TopAbs_FACE); face.More(); face.Next())
        numbers.push_back(faces_.FindIndex(face.Current()));
      const bool is_sewn =
          std::ranges::any_of(numbers, [this](int face) { return sewn_faces_.count(face) > 0; });
      for (const int face : numbers)
        if (is_sewn) groups_.join(face, numbers.front());
    }
    std::set<int> sewn;
    for (const int face : sewn_faces_) sewn.insert(groups_.of(face));
    for (int f = 1; f <= faces_.Extent(); ++f)
      if (sewn.count(groups_.of(f)) > 0) members_[groups_.of(f)].push_back(f);
  }

  bool isSewn(int face) const { return members_.count(groups_.of(face)) > 0; }

  struct Use {
    int face = 0;
    bool forward = true;
  };

  /// Turns faces until each edge is run along both ways.
  void turnFaces() {
    std::map<const TopoDS_TShape*, std::vector<Use>> uses;
    std::map<int, std::vector<const TopoDS_TShape*>> edges_of_face;
    for (const auto& [group, faces] : members_)
      for (const int face : faces)
        for (TopExp_Explorer edge(new_faces_[face], TopAbs_EDGE); edge.More(); edge.Next()) {
          const TopoDS_TShape* part = edge.Current().TShape().get();
          uses[part].push_back({face, edge.Current().Orientation() == TopAbs_FORWARD});
          edges_of_face[face].push_back(part);
        }
    std::map<int, bool> turned;
    for (const auto& [group, faces] : members_) {
      std::vector<int> reached = {faces.front()};
      turned[faces.front()] = false;
      for (std::size_t k = 0; k < reached.size(); ++k)
        for (const TopoDS_TShape* part : edges_of_face[reached[k]]) {
          const std::vector<Use>& both = uses[part];
          if (both.size() != 2 || both[0].face == both[1].face) continue;
          const int other = both[0].face == reached[k] ? both[1].face : both[0].face;
          const bool turn = turned.at(reached[k]) != (both[0].forward == both[1].forward);
          if (turned.emplace(other, turn).second) reached.push_back(other);
        }
    }
    for (const auto& [face, turn] : turned)
      if (turn) new_faces_[face].Reverse();
    refuseOneSided();
  }

  void refuseOneSided() {
    for (const SewnStretch& stretch : stretches_) {
      std::vector<TopAbs_Orientation> senses;
      std::set<int> faces;
      for (const FaceUse& side : seams_[stretch.seam].sides) faces.insert(side.face);
      const TopoDS_Edge& common = common_[static_cast<std::size_t>(&stretch - stretches_.data())].edge;
      for (const int face : faces)
        for (TopExp_Explorer edge(new_faces_[face], TopAbs_EDGE); edge.More(); edge.Next())
          if (edge.Current().IsSame(common)) senses.push_back(edge.Current().Orientation());
      if (senses.size() == 2 && senses[0] == senses[1])
        refuse(stretch.seam, "it would close a band that has one side only");
    }
  }

  // The whole.

  TopoDS_Shape shellOf(int group) {
    TopoDS_Shell shell;
    builder_.MakeShell(shell);
    for (const int face : members_.at(group)) builder_.Add(shell, new_faces_[face]);
    shell.Closed(BRep_Tool::IsClosed(shell));
    if (!shell.Closed()) return shell;
    TopoDS_Solid solid;
    builder_.MakeSolid(solid);
    builder_.Add(solid, shell);
    BRepLib::OrientClosedSolid(solid);
    return solid;
  }

  int sewnGroupOf(const TopoDS_Shape& part) const {
    const TopExp_Explorer face(part, TopAbs_FACE);
    if (!face.More()) return 0;
    const int number = faces_.FindIndex(face.Current());
    return isSewn(number) ? groups_.of(number) : 0;
  }

  /// What a part becomes: itself, another one, several, or nothing, where another part has its faces now.
  std::vector<TopoDS_Shape> rebuiltPart(const TopoDS_Shape& part) {
    const TopAbs_ShapeEnum kind = part.ShapeType();
    if (kind == TopAbs_VERTEX) return {replaced(part)};
    if (kind == TopAbs_EDGE) return replacedEdge(TopoDS::Edge(part));
    const int group =
        kind == TopAbs_SOLID || kind == TopAbs_SHELL || kind == TopAbs_FACE ? sewnGroupOf(part) : 0;
    if (group != 0) {
      if (!placed_.insert(group).second) return {};
      return {shellOf(group)};
    }
    if (kind == TopAbs_FACE) return {new_faces_[faces_.FindIndex(part)].Oriented(part.Orientation())};
    std::vector<TopoDS_Shape> children;
    bool is_same = true;
    for (TopoDS_Iterator it(part); it.More(); it.Next()) {
      const std::vector<TopoDS_Shape> now = rebuiltPart(it.Value());
      is_same = is_same && now.size() == 1 && now.front().IsEqual(it.Value());
      children.insert(children.end(), now.begin(), now.end());
    }
    if (is_same) return {part};
    if (children.empty()) return {};
    TopoDS_Shape copy = part.EmptyCopied();
    for (const TopoDS_Shape& child : children) builder_.Add(copy, child);
    copy.Closed(part.Closed());
    result_.became.Bind(part, copy);
    return {copy};
  }

  void putTogether() {
    const std::vector<TopoDS_Shape> parts = rebuiltPart(shape_);
    if (parts.size() != 1) throw std::runtime_error("the shape fell apart when its faces were sewn");
    result_.shape = parts.front();
  }

  void number() {
    TopTools_IndexedMapOfShape faces, edges;
    TopExp::MapShapes(result_.shape, TopAbs_FACE, faces);
    TopExp::MapShapes(result_.shape, TopAbs_EDGE, edges);
    result_.faces.assign(1, 0);
    for (int f = 1; f <= faces_.Extent(); ++f) result_.faces.push_back(faces.FindIndex(new_faces_[f]));
    result_.edges.assign(1, {});
    for (int e = 1; e <= edges_.Extent(); ++e) {
      std::vector<int> numbers;
      for (const TopoDS_Shape& piece : replacedEdge(oldEdge(e))) numbers.push_back(edges.FindIndex(piece));
      result_.edges.push_back(numbers);
    }
    for (std::size_t k = 0; k < stretches_.size(); ++k)
      result_.seam_edges[stretches_[k].seam] = edges.FindIndex(common_[k].edge);
    for (const auto& [node, corner] : corners_)
      for (int v = 1; v <= vertices_.Extent(); ++v)
        if (nodes_.of(v) == node) result_.became.Bind(vertices_(v), corner.vertex);
  }

  const TopoDS_Shape& shape_;
  const std::vector<Seam>& seams_;
  double gap_mm_;
  BRep_Builder builder_;
  TopTools_IndexedMapOfShape faces_, edges_, vertices_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge_;
  std::vector<std::size_t> chosen_;
  std::vector<SewnStretch> stretches_;
  std::map<int, std::vector<double>> cuts_;                        ///< by edge
  std::map<std::pair<int, int>, int> cut_nodes_;                   ///< by edge and number of the cut
  Groups nodes_;                                                   ///< vertices by number, and cuts
  std::map<int, Corner> corners_;                                  ///< by node: what is a new vertex
  std::vector<CommonEdge> common_;                                 ///< by stretch
  std::map<std::pair<int, int>, std::pair<int, int>> stretch_at_;  ///< stretch and side, by edge and piece
  std::map<int, std::vector<EdgePiece>> pieces_;                   ///< by edge, of those that are new
  std::vector<TopoDS_Face> new_faces_;                             ///< by face
  Groups groups_;                                                  ///< of faces
  std::set<int> sewn_faces_;
  std::map<int, std::vector<int>> members_;  ///< faces by group, of groups that are sewn
  std::set<int> placed_;
  SewnShape result_;
};

}  // namespace

SewnShape sewnShape(const TopoDS_Shape& shape, const std::vector<Seam>& seams,
                    const std::vector<std::size_t>& chosen, double gap_mm) {
  return Sewer(shape, seams, chosen, gap_mm).run();
}

}  // namespace seamwright::occ
