// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <set>

#include <seamwright/occ_adapter/topology/sewn_faces.hpp>

namespace seamwright::occ {

std::vector<TopoDS_Shape> replacedEdge(const ShapeParts& parts, const SewnEdges& sewn,
                                       const TopoDS_Edge& edge) {
  const auto found = sewn.pieces.find(parts.edges.FindIndex(edge));
  if (found == sewn.pieces.end()) return {edge};
  std::vector<TopoDS_Shape> pieces;
  for (const TopoDS_Edge& piece : found->second)
    pieces.push_back(piece.Oriented(TopAbs::Compose(edge.Orientation(), piece.Orientation())));
  if (edge.Orientation() == TopAbs_REVERSED) std::ranges::reverse(pieces);
  return pieces;
}

TopoDS_Shape replacedVertex(const ShapeParts& parts, const SewnEdges& sewn,
                            const TopoDS_Shape& vertex) {
  const auto found = sewn.vertices.find(parts.vertices.FindIndex(vertex));
  return found == sewn.vertices.end() ? vertex : found->second.Oriented(vertex.Orientation());
}

namespace {

TopoDS_Shape wireWithEdges(const ShapeParts& parts, const SewnEdges& sewn, const TopoDS_Wire& old) {
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (TopoDS_Iterator it(old.Oriented(TopAbs_FORWARD)); it.More(); it.Next())
    for (const TopoDS_Shape& piece : replacedEdge(parts, sewn, TopoDS::Edge(it.Value())))
      builder.Add(wire, piece);
  wire.Closed(old.Closed());
  return wire.Oriented(old.Orientation());
}

TopoDS_Face faceWithEdges(const ShapeParts& parts, const SewnEdges& sewn, const TopoDS_Face& old) {
  const BRep_Builder builder;
  const TopoDS_Face forward = TopoDS::Face(old.Oriented(TopAbs_FORWARD));
  TopoDS_Face face = TopoDS::Face(forward.EmptyCopied());
  for (TopoDS_Iterator part(forward); part.More(); part.Next())
    builder.Add(face, part.Value().ShapeType() == TopAbs_WIRE
                          ? wireWithEdges(parts, sewn, TopoDS::Wire(part.Value()))
                          : replacedVertex(parts, sewn, part.Value()));
  builder.NaturalRestriction(face, BRep_Tool::NaturalRestriction(old));
  return TopoDS::Face(face.Oriented(old.Orientation()));
}

bool hasNewEdge(const ShapeParts& parts, const SewnEdges& sewn, const TopoDS_Face& face) {
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
    if (sewn.pieces.count(parts.edges.FindIndex(edge.Current())) > 0) return true;
  return false;
}

}  // namespace

std::vector<TopoDS_Face> facesWithEdges(const ShapeParts& parts, const SewnEdges& sewn) {
  std::vector<TopoDS_Face> faces(parts.faces.Extent() + 1);
  for (int f = 1; f <= parts.faces.Extent(); ++f) {
    const TopoDS_Face old = parts.face(f);
    faces[f] = hasNewEdge(parts, sewn, old) ? faceWithEdges(parts, sewn, old) : old;
  }
  return faces;
}

FaceGroups sewnGroups(const ShapeParts& parts, const std::vector<Seam>& seams,
                      const std::vector<SewnInterval>& intervals) {
  FaceGroups result{.groups = DisjointSets(parts.faces.Extent() + 1)};
  std::set<int> sewn_faces;
  for (const SewnInterval& interval : intervals) {
    const auto& sides = seams[interval.seam].sides;
    result.groups.unite(sides[0].face, sides[1].face);
    sewn_faces.insert({sides[0].face, sides[1].face});
  }
  for (TopExp_Explorer shell(parts.shape, TopAbs_SHELL); shell.More(); shell.Next()) {
    std::vector<int> numbers;
    for (TopExp_Explorer face(shell.Current(), TopAbs_FACE); face.More(); face.Next())
      numbers.push_back(parts.faces.FindIndex(face.Current()));
    const bool is_sewn = std::ranges::any_of(
        numbers, [&sewn_faces](int face) { return sewn_faces.count(face) > 0; });
    for (const int face : numbers)
      if (is_sewn) result.groups.unite(face, numbers.front());
  }
  std::set<int> sewn_groups;
  for (const int face : sewn_faces) sewn_groups.insert(result.groups.of(face));
  for (int f = 1; f <= parts.faces.Extent(); ++f)
    if (const int group = result.groups.of(f); sewn_groups.count(group) > 0)
      result.members[group].push_back(f);
  return result;
}

namespace {

/// A coedge of a new face.
struct FaceEdgeUse {
  int face = 0;
  bool forward = true;
};

struct EdgeUses {
  std::map<const TopoDS_TShape*, std::vector<FaceEdgeUse>> by_edge;
  std::map<int, std::vector<const TopoDS_TShape*>> edges_of_face;
};

EdgeUses edgeUses(const FaceGroups& groups, const std::vector<TopoDS_Face>& faces) {
  EdgeUses uses;
  for (const auto& [group, members] : groups.members)
    for (const int face : members)
      for (TopExp_Explorer edge(faces[face], TopAbs_EDGE); edge.More(); edge.Next()) {
        const TopoDS_TShape* part = edge.Current().TShape().get();
        uses.by_edge[part].push_back(
            {.face = face, .forward = edge.Current().Orientation() == TopAbs_FORWARD});
        uses.edges_of_face[face].push_back(part);
      }
  return uses;
}

/// By face of a group that its first face reaches across edges: whether it must be reversed.
std::map<int, bool> facesToReverse(const FaceGroups& groups, const EdgeUses& uses) {
  std::map<int, bool> reversed;
  for (const auto& [group, faces] : groups.members) {
    std::vector<int> reached = {faces.front()};
    reversed[faces.front()] = false;
    for (std::size_t k = 0; k < reached.size(); ++k) {
      const auto edges = uses.edges_of_face.find(reached[k]);
      if (edges == uses.edges_of_face.end()) continue;
      for (const TopoDS_TShape* part : edges->second) {
        const std::vector<FaceEdgeUse>& both = uses.by_edge.at(part);
        // At a non-manifold edge, and where a face meets itself, orientations do not tell.
        if (both.size() != 2 || both[0].face == both[1].face) continue;
        const int other = both[0].face == reached[k] ? both[1].face : both[0].face;
        const bool reverse = reversed.at(reached[k]) != (both[0].forward == both[1].forward);
        if (reversed.emplace(other, reverse).second) reached.push_back(other);
      }
    }
  }
  return reversed;
}

}  // namespace

void orientFaces(const FaceGroups& groups, std::vector<TopoDS_Face>& faces) {
  for (const auto& [face, reverse] : facesToReverse(groups, edgeUses(groups, faces)))
    if (reverse) faces[face].Reverse();
}

SewReasons oneSidedSeams(const std::vector<Seam>& seams, const SewnEdges& sewn,
                         const std::vector<TopoDS_Face>& faces) {
  SewReasons refused;
  for (std::size_t k = 0; k < sewn.intervals.size(); ++k) {
    const std::size_t seam = sewn.intervals[k].seam;
    std::set<int> beside;
    for (const Coedge& side : seams[seam].sides) beside.insert(side.face);
    std::vector<TopAbs_Orientation> directions;
    for (const int face : beside)
      for (TopExp_Explorer edge(faces[face], TopAbs_EDGE); edge.More(); edge.Next())
        if (edge.Current().IsSame(sewn.common[k]))
          directions.push_back(edge.Current().Orientation());
    if (directions.size() == 2 && directions[0] == directions[1])
      refused.emplace(seam, why_not_sewn::oneSided());
  }
  return refused;
}

}  // namespace seamwright::occ
