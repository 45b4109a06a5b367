// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <set>
#include <stdexcept>

#include <seamwright/core/disjoint_sets.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/topology/sewn_edges.hpp>
#include <seamwright/occ_adapter/topology/sewn_shape.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

class Sewer {
 public:
  Sewer(const TopoDS_Shape& shape, const std::vector<Seam>& seams,
        const std::vector<std::size_t>& chosen, double gap_mm, const FaceNames& names)
      : shape_(shape), seams_(seams), gap_mm_(gap_mm), names_(names), unusable_(shape) {
    TopExp::MapShapes(shape, TopAbs_FACE, faces_);
    TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
    TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
    groups_ = DisjointSets(faces_.Extent() + 1);
    refuseUnfit(chosen);
  }

  SewnShape run() {
    if (mayGoOn()) sewEdges();
    if (mayGoOn()) {
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

  // Selection of the seams that can be sewn.

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
    for (const Coedge& side : seam.sides) {
      const std::string face = names_(side.face);
      const int count = instances.at(side.shape.TShape().get());
      if (count > 1) return face + " stands in the model " + std::to_string(count) + " times";
      if (in_hollow.count(side.face) > 0) return face + " is part of a solid of several shells";
    }
    if (seam.sides[0].face == seam.sides[1].face) return {};
    const PlacedSurface a = surfaceOf(seam.sides[0].shape), b = surfaceOf(seam.sides[1].shape);
    if (a.surface == b.surface && a.location == b.location)
      return names_(seam.sides[0].face) + " and " + names_(seam.sides[1].face) +
             " have one surface in common";
    return {};
  }

  std::set<int> facesOfHollowSolids() const {
    std::set<int> numbers;
    for (TopExp_Explorer solid(shape_, TopAbs_SOLID); solid.More(); solid.Next()) {
      int shells = 0;
      for (TopExp_Explorer shell(solid.Current(), TopAbs_SHELL); shell.More(); shell.Next())
        ++shells;
      if (shells < 2) continue;
      for (TopExp_Explorer face(solid.Current(), TopAbs_FACE); face.More(); face.Next())
        numbers.insert(faces_.FindIndex(face.Current()));
    }
    return numbers;
  }

  void sewEdges() {
    edges_now_ = sewnEdges(shape_, seams_, chosen_, gap_mm_);
    result_.refused = edges_now_.refused;
  }

  // Faces.

  void makeFaces() {
    new_faces_.resize(faces_.Extent() + 1);
    for (int f = 1; f <= faces_.Extent(); ++f) {
      const TopoDS_Face old = TopoDS::Face(faces_(f));
      bool is_new = false;
      for (TopExp_Explorer edge(old, TopAbs_EDGE); edge.More() && !is_new; edge.Next())
        is_new = edges_now_.pieces.count(edges_.FindIndex(edge.Current())) > 0;
      new_faces_[f] = is_new ? rebuilt(old) : old;
    }
  }

  TopoDS_Face rebuilt(const TopoDS_Face& old) {
    const TopoDS_Face forward = TopoDS::Face(old.Oriented(TopAbs_FORWARD));
    TopoDS_Face face = TopoDS::Face(forward.EmptyCopied());
    for (TopoDS_Iterator part(forward); part.More(); part.Next())
      builder_.Add(face, part.Value().ShapeType() == TopAbs_WIRE
                             ? rebuiltWire(TopoDS::Wire(part.Value()))
                             : replaced(part.Value()));
    builder_.NaturalRestriction(face, BRep_Tool::NaturalRestriction(old));
    return TopoDS::Face(face.Oriented(old.Orientation()));
  }

  TopoDS_Shape rebuiltWire(const TopoDS_Wire& old) {
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (TopoDS_Iterator it(old.Oriented(TopAbs_FORWARD)); it.More(); it.Next())
      for (const TopoDS_Shape& piece : replacedEdge(TopoDS::Edge(it.Value())))
        builder_.Add(wire, piece);
    wire.Closed(old.Closed());
    return wire.Oriented(old.Orientation());
  }

  std::vector<TopoDS_Shape> replacedEdge(const TopoDS_Edge& edge) const {
    const auto found = edges_now_.pieces.find(edges_.FindIndex(edge));
    if (found == edges_now_.pieces.end()) return {edge};
    std::vector<TopoDS_Shape> pieces;
    for (const TopoDS_Edge& piece : found->second)
      pieces.push_back(piece.Oriented(TopAbs::Compose(edge.Orientation(), piece.Orientation())));
    if (edge.Orientation() == TopAbs_REVERSED) std::ranges::reverse(pieces);
    return pieces;
  }

  TopoDS_Shape replaced(const TopoDS_Shape& vertex) const {
    const auto found = edges_now_.vertices.find(vertices_.FindIndex(vertex));
    return found == edges_now_.vertices.end() ? vertex
                                              : found->second.Oriented(vertex.Orientation());
  }

  /// Groups the faces that are one shell after sewing.
  void joinFaces() {
    for (const SewnInterval& interval : edges_now_.intervals) {
      const auto& sides = seams_[interval.seam].sides;
      groups_.unite(sides[0].face, sides[1].face);
      sewn_faces_.insert({sides[0].face, sides[1].face});
    }
    for (TopExp_Explorer shell(shape_, TopAbs_SHELL); shell.More(); shell.Next()) {
      std::vector<int> numbers;
      for (TopExp_Explorer face(shell.Current(), TopAbs_FACE); face.More(); face.Next())
        numbers.push_back(faces_.FindIndex(face.Current()));
      const bool is_sewn =
          std::ranges::any_of(numbers, [this](int face) { return sewn_faces_.count(face) > 0; });
      for (const int face : numbers)
        if (is_sewn) groups_.unite(face, numbers.front());
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

  /// Reverses faces so that the two coedges of each edge have opposite directions.
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
    for (std::size_t k = 0; k < edges_now_.intervals.size(); ++k) {
      const std::size_t seam = edges_now_.intervals[k].seam;
      const TopoDS_Edge& common = edges_now_.common[k];
      std::vector<TopAbs_Orientation> senses;
      std::set<int> faces;
      for (const Coedge& side : seams_[seam].sides) faces.insert(side.face);
      for (const int face : faces)
        for (TopExp_Explorer edge(new_faces_[face], TopAbs_EDGE); edge.More(); edge.Next())
          if (edge.Current().IsSame(common)) senses.push_back(edge.Current().Orientation());
      if (senses.size() == 2 && senses[0] == senses[1])
        refuse(seam, "it would close a band that has one side only");
    }
  }

  // Assembly of the shape.

  bool hasUnusable(int group) const {
    return std::ranges::any_of(members_.at(group),
                               [this](int face) { return !unusable_.whyLeftOut(face).empty(); });
  }

  /// The shell of a group, or its solid. For a shell with faces that can't be computed with, the
  /// inside can't be determined. So it stays a shell, or the solid that it was, oriented as its
  /// first face.
  TopoDS_Shape shellOf(int group, bool was_solid) {
    TopoDS_Shell shell;
    builder_.MakeShell(shell);
    for (const int face : members_.at(group)) builder_.Add(shell, new_faces_[face]);
    shell.Closed(BRep_Tool::IsClosed(shell));
    const bool has_inside = !hasUnusable(group);
    if (!shell.Closed() || (!has_inside && !was_solid)) return shell;
    TopoDS_Solid solid;
    builder_.MakeSolid(solid);
    builder_.Add(solid, shell);
    if (has_inside) BRepLib::OrientClosedSolid(solid);
    return solid;
  }

  int sewnGroupOf(const TopoDS_Shape& part) const {
    const TopExp_Explorer face(part, TopAbs_FACE);
    if (!face.More()) return 0;
    const int number = faces_.FindIndex(face.Current());
    return isSewn(number) ? groups_.of(number) : 0;
  }

  bool isJoinedByLooseFacesAlone(const TopoDS_Shape& part, int group) const {
    TopTools_IndexedMapOfShape of_part, in_shells;
    TopExp::MapShapes(part, TopAbs_FACE, of_part);
    for (TopExp_Explorer shell(shape_, TopAbs_SHELL); shell.More(); shell.Next())
      TopExp::MapShapes(shell.Current(), TopAbs_FACE, in_shells);
    return std::ranges::all_of(members_.at(group), [&](int face) {
      return of_part.Contains(faces_(face)) || !in_shells.Contains(faces_(face));
    });
  }

  /// The parts that replace a part: itself, a new part, several parts, or none if its faces are now
  /// in another part.
  std::vector<TopoDS_Shape> rebuiltPart(const TopoDS_Shape& part) {
    const TopAbs_ShapeEnum kind = part.ShapeType();
    if (kind == TopAbs_VERTEX) return {replaced(part)};
    if (kind == TopAbs_EDGE) return replacedEdge(TopoDS::Edge(part));
    const int group =
        kind == TopAbs_SOLID || kind == TopAbs_SHELL || kind == TopAbs_FACE ? sewnGroupOf(part) : 0;
    if (group != 0) {
      if (!placed_.insert(group).second) return {};
      const TopoDS_Shape now = shellOf(group, kind == TopAbs_SOLID);
      if (now.ShapeType() == kind && isJoinedByLooseFacesAlone(part, group))
        result_.became.Bind(part, now);
      return {now};
    }
    if (kind == TopAbs_FACE)
      return {new_faces_[faces_.FindIndex(part)].Oriented(part.Orientation())};
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
    if (parts.size() != 1)
      throw std::runtime_error("the shape fell apart when its faces were sewn");
    result_.shape = parts.front();
  }

  void number() {
    TopTools_IndexedMapOfShape faces, edges;
    TopExp::MapShapes(result_.shape, TopAbs_FACE, faces);
    TopExp::MapShapes(result_.shape, TopAbs_EDGE, edges);
    result_.faces.assign(1, 0);
    for (int f = 1; f <= faces_.Extent(); ++f)
      result_.faces.push_back(faces.FindIndex(new_faces_[f]));
    result_.edges.assign(1, {});
    for (int e = 1; e <= edges_.Extent(); ++e) {
      std::vector<int> numbers;
      for (const TopoDS_Shape& piece :
           replacedEdge(TopoDS::Edge(edges_(e).Oriented(TopAbs_FORWARD))))
        numbers.push_back(edges.FindIndex(piece));
      result_.edges.push_back(numbers);
    }
    for (std::size_t k = 0; k < edges_now_.intervals.size(); ++k)
      result_.seam_edges[edges_now_.intervals[k].seam] = edges.FindIndex(edges_now_.common[k]);
    for (const auto& [v, vertex] : edges_now_.vertices) result_.became.Bind(vertices_(v), vertex);
  }

  const TopoDS_Shape& shape_;
  const std::vector<Seam>& seams_;
  double gap_mm_;
  const FaceNames& names_;
  const UnusableParts unusable_;
  BRep_Builder builder_;
  TopTools_IndexedMapOfShape faces_, edges_, vertices_;
  std::vector<std::size_t> chosen_;
  SewnEdges edges_now_;
  std::vector<TopoDS_Face> new_faces_;  ///< by face
  DisjointSets groups_;                 ///< of faces
  std::set<int> sewn_faces_;
  std::map<int, std::vector<int>> members_;  ///< faces by group, for groups that are sewn
  std::set<int> placed_;
  SewnShape result_;
};

}  // namespace

std::string numberedFace(int number) {
  return "face " + std::to_string(number);
}

SewnShape sewnShape(const TopoDS_Shape& shape, const std::vector<Seam>& seams,
                    const std::vector<std::size_t>& chosen, double gap_mm, const FaceNames& names) {
  return Sewer(shape, seams, chosen, gap_mm, names).run();
}

}  // namespace seamwright::occ
