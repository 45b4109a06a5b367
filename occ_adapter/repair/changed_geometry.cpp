// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include <stdexcept>

#include <seamwright/occ_adapter/repair/changed_geometry.hpp>

namespace seamwright::occ {

using opencascade::handle;

TopoDS_Shape bare(const TopoDS_Shape& shape) {
  return shape.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD);
}

gp_Trsf outOf(const TopLoc_Location& location) {
  return location.Inverted().Transformation();
}

NumberedParts::NumberedParts(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) : kind_(kind) {
  TopExp::MapShapes(shape, kind, parts_);
  for (int i = 1; i <= count(); ++i) ++instances_[parts_(i).TShape().get()];
}

std::set<int> NumberedParts::numbersIn(const TopoDS_Shape& part) const {
  TopTools_IndexedMapOfShape own;
  TopExp::MapShapes(part, kind_, own);
  std::set<int> numbers;
  for (int i = 1; i <= own.Extent(); ++i) numbers.insert(number(own(i)));
  return numbers;
}

void NumberedParts::requireOnce(int number) const {
  const int instances = instances_.at(parts_(number).TShape().get());
  if (instances == 1) return;
  const char* kind = kind_ == TopAbs_FACE ? "face" : kind_ == TopAbs_EDGE ? "edge" : "vertex";
  throw std::invalid_argument(
      fmt::format("{} {} stands in the shape {} times: parts with several instances stay", kind,
                  number, instances));
}

ConnectedParts::ConnectedParts(const TopoDS_Shape& shape)
    : faces_(shape, TopAbs_FACE), edges_(shape, TopAbs_EDGE), vertices_(shape, TopAbs_VERTEX) {
  TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edge_);
  TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_VERTEX, TopAbs_EDGE, edges_of_vertex_);
}

TopoDS_Face ConnectedParts::face(int number) const {
  return TopoDS::Face(faces_(number).Oriented(TopAbs_FORWARD));
}

TopoDS_Edge ConnectedParts::edge(int number) const {
  return TopoDS::Edge(edges_(number).Oriented(TopAbs_FORWARD));
}

TopoDS_Vertex ConnectedParts::vertex(int number) const {
  return TopoDS::Vertex(vertices_(number).Oriented(TopAbs_FORWARD));
}

std::vector<int> ConnectedParts::facesOfEdge(int edge) const {
  std::vector<int> numbers;
  for (const TopoDS_Shape& beside : faces_of_edge_.FindFromKey(edges_(edge)))
    numbers.push_back(faces_.number(beside));
  return numbers;
}

std::vector<int> ConnectedParts::edgesOfVertex(int vertex) const {
  std::vector<int> numbers;
  for (const TopoDS_Shape& beside : edges_of_vertex_.FindFromKey(vertices_(vertex)))
    numbers.push_back(edges_.number(beside));
  return numbers;
}

ChangedGeometry::ChangedGeometry(const ConnectedParts& parts,
                                 const std::vector<FaceChange>& changes,
                                 const std::vector<PathChange>& paths, double gap_mm)
    : parts_(parts), gap_mm_(gap_mm) {
  for (const FaceChange& change : changes) add(change);
  for (const PathChange& change : paths) new_paths_[{change.edge, change.face}] = change.path;
}

void ChangedGeometry::add(const FaceChange& change) {
  const int count = parts_.faces().count();
  if (change.face < 1 || change.face > count)
    throw std::invalid_argument(
        fmt::format("face {}: the shape has faces 1 to {}", change.face, count));
  if (change.surface.IsNull())
    throw std::invalid_argument(fmt::format("face {} is given no surface", change.face));
  if (changes(change.face))
    throw std::invalid_argument(fmt::format("face {} is given twice", change.face));
  parts_.faces().requireOnce(change.face);
  // The face keeps its location, so its new surface is stored in the frame of the old one.
  const TopLoc_Location location = surfaceBefore(change.face).location;
  const auto own = handle<Geom_Surface>::DownCast(change.surface->Transformed(outOf(location)));
  changed_[change.face] = {.in_shape = change.surface, .stored = {own, location}};
}

std::set<int> ChangedGeometry::faces() const {
  std::set<int> numbers;
  for (const auto& [face, surface] : changed_) numbers.insert(face);
  return numbers;
}

std::set<int> ChangedGeometry::edges() const {
  std::set<int> numbers;
  for (const auto& [face, surface] : changed_)
    numbers.merge(parts_.edges().numbersIn(parts_.faces()(face)));
  for (const auto& [edge_and_face, path] : new_paths_) numbers.insert(edge_and_face.first);
  return numbers;
}

PlacedSurface ChangedGeometry::surfaceAfter(int face) const {
  const auto found = changed_.find(face);
  if (found == changed_.end()) return surfaceBefore(face);
  return {found->second.in_shape, TopLoc_Location()};
}

PlacedSurface ChangedGeometry::storedAfter(int face) const {
  const auto found = changed_.find(face);
  return found == changed_.end() ? surfaceBefore(face) : found->second.stored;
}

std::vector<PlanarPath> ChangedGeometry::pathsAfter(int edge, int face) const {
  const TopoDS_Edge of_edge = parts_.edge(edge);
  const TopoDS_Face on_face = parts_.face(face);
  std::vector<PlanarPath> paths = {pathOrBuilt(of_edge, on_face, gap_mm_)};
  if (const auto changed = new_paths_.find({edge, face}); changed != new_paths_.end())
    paths.front().curve = changed->second;
  if (BRep_Tool::IsClosed(of_edge, on_face))
    paths.push_back(pathOf(TopoDS::Edge(of_edge.Reversed()), on_face));
  return paths;
}

std::vector<EdgeSide> ChangedGeometry::sidesAfter(int edge) const {
  std::vector<EdgeSide> sides;
  for (const int face : parts_.facesOfEdge(edge))
    for (const PlanarPath& path : pathsAfter(edge, face))
      sides.push_back({surfaceAfter(face), path});
  return sides;
}

}  // namespace seamwright::occ
