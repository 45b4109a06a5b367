// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <set>
#include <stdexcept>

#include <seamwright/occ_adapter/topology/sewn_assembly.hpp>

namespace seamwright::occ {

namespace {

/// The shell of these faces, or its solid if the shell is closed. The inside of a shell with faces
/// that can't be computed with is not known. Such a shell stays a shell, or the solid that it was,
/// oriented as its first face.
TopoDS_Shape shellOrSolid(const std::vector<int>& members, const std::vector<TopoDS_Face>& faces,
                          const UnusableParts& unusable, bool was_solid) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (const int face : members) builder.Add(shell, faces[face]);
  shell.Closed(BRep_Tool::IsClosed(shell));
  const bool has_inside = std::ranges::all_of(
      members, [&unusable](int face) { return unusable.whyLeftOut(face).empty(); });
  if (!shell.Closed() || (!has_inside && !was_solid)) return shell;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  if (has_inside) BRepLib::OrientClosedSolid(solid);
  return solid;
}

/// Whether all faces of a group are in this part or in no shell, so that no other shell became part
/// of it.
bool hasOnlyLooseFacesBeside(const ShapeParts& parts, const TopoDS_Shape& part,
                             const std::vector<int>& members) {
  const TopTools_IndexedMapOfShape of_part = partsOf(part, TopAbs_FACE);
  TopTools_IndexedMapOfShape in_shells;
  for (TopExp_Explorer shell(parts.shape, TopAbs_SHELL); shell.More(); shell.Next())
    TopExp::MapShapes(shell.Current(), TopAbs_FACE, in_shells);
  return std::ranges::all_of(members, [&](int face) {
    return of_part.Contains(parts.faces(face)) || !in_shells.Contains(parts.faces(face));
  });
}

/// Walks through the shape and replaces its parts. Each sewn group takes the position of the first
/// part that contains one of its faces.
class SewnParts {
 public:
  SewnParts(const ShapeParts& parts, const SewnEdges& edges, const FaceGroups& groups,
            const std::vector<TopoDS_Face>& faces)
      : parts_(parts), edges_(edges), groups_(groups), faces_(faces) {}

  /// The parts that replace a part: itself, a new part, several parts, or none if its faces are now
  /// in another part.
  std::vector<TopoDS_Shape> replaced(const TopoDS_Shape& part) {
    const TopAbs_ShapeEnum kind = part.ShapeType();
    if (kind == TopAbs_VERTEX) return {replacedVertex(parts_, edges_, part)};
    if (kind == TopAbs_EDGE) return replacedEdge(parts_, edges_, TopoDS::Edge(part));
    if (kind == TopAbs_SOLID || kind == TopAbs_SHELL || kind == TopAbs_FACE)
      if (const int group = sewnGroupOf(part); group != 0) return replacedByGroup(part, group);
    if (kind == TopAbs_FACE)
      return {faces_[parts_.faces.FindIndex(part)].Oriented(part.Orientation())};
    return withReplacedChildren(part);
  }

  TopTools_DataMapOfShapeShape became() const { return became_; }

 private:
  /// The group of the part's faces; 0 if they are not sewn.
  int sewnGroupOf(const TopoDS_Shape& part) const {
    const TopExp_Explorer face(part, TopAbs_FACE);
    if (!face.More()) return 0;
    const int number = parts_.faces.FindIndex(face.Current());
    return groups_.isSewn(number) ? groups_.groups.of(number) : 0;
  }

  std::vector<TopoDS_Shape> replacedByGroup(const TopoDS_Shape& part, int group) {
    if (!placed_.insert(group).second) return {};
    const std::vector<int>& members = groups_.members.at(group);
    const TopAbs_ShapeEnum kind = part.ShapeType();
    const TopoDS_Shape now = shellOrSolid(members, faces_, parts_.unusable, kind == TopAbs_SOLID);
    if (now.ShapeType() == kind && hasOnlyLooseFacesBeside(parts_, part, members))
      became_.Bind(part, now);
    return {now};
  }

  std::vector<TopoDS_Shape> withReplacedChildren(const TopoDS_Shape& part) {
    std::vector<TopoDS_Shape> children;
    bool is_same = true;
    for (TopoDS_Iterator it(part); it.More(); it.Next()) {
      const std::vector<TopoDS_Shape> now = replaced(it.Value());
      is_same = is_same && now.size() == 1 && now.front().IsEqual(it.Value());
      children.insert(children.end(), now.begin(), now.end());
    }
    if (is_same) return {part};
    if (children.empty()) return {};
    const BRep_Builder builder;
    TopoDS_Shape copy = part.EmptyCopied();
    for (const TopoDS_Shape& child : children) builder.Add(copy, child);
    copy.Closed(part.Closed());
    became_.Bind(part, copy);
    return {copy};
  }

  const ShapeParts& parts_;
  const SewnEdges& edges_;
  const FaceGroups& groups_;
  const std::vector<TopoDS_Face>& faces_;
  std::set<int> placed_;  ///< groups that have their position
  TopTools_DataMapOfShapeShape became_;
};

}  // namespace

SewnAssembly sewnAssembly(const ShapeParts& parts, const SewnEdges& edges, const FaceGroups& groups,
                          const std::vector<TopoDS_Face>& faces) {
  SewnParts sewn(parts, edges, groups, faces);
  const std::vector<TopoDS_Shape> replaced = sewn.replaced(parts.shape);
  // Only an edge becomes several parts, and a shape of edges has no seams.
  if (replaced.size() != 1)
    throw std::logic_error("a shape became " + std::to_string(replaced.size()) +
                           " shapes when its faces were sewn");
  return {.shape = replaced.front(), .became = sewn.became()};
}

}  // namespace seamwright::occ
