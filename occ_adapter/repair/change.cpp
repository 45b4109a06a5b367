// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>

#include <seamwright/occ_adapter/repair/changed_vertices.hpp>
#include <seamwright/occ_adapter/repair/replaced_parts.hpp>
#include <seamwright/occ_adapter/topology/own_parts.hpp>

namespace seamwright::occ {

namespace {

/// A face with its new surface, without edges, location and orientation.
TopoDS_Shape changedFace(const ChangedGeometry& geometry, int number) {
  TopoDS_Face changed = TopoDS::Face(geometry.parts().face(number).EmptyCopied());
  const PlacedSurface stored = geometry.storedAfter(number);
  BRep_Builder().UpdateFace(changed, stored.surface, stored.location,
                            BRep_Tool::Tolerance(changed));
  return bare(changed);
}

}  // namespace

TopoDS_Shape withChanges(const TopoDS_Shape& shape, const std::vector<FaceChange>& changes,
                         double gap_mm, const std::vector<PathChange>& paths, int jobs) {
  if (changes.empty() && paths.empty()) return shape;
  const TopoDS_Shape own = withOwnParts(shape);
  const ConnectedParts parts(own);
  const ChangedGeometry geometry(parts, changes, paths, gap_mm);
  const std::map<int, ChangedEdge> edges = changedEdges(geometry, jobs);
  const std::map<int, TopoDS_Vertex> vertices = changedVertices(parts, edges);
  TopTools_DataMapOfShapeShape new_parts;
  for (const int face : geometry.faces())
    new_parts.Bind(bare(parts.faces()(face)), changedFace(geometry, face));
  for (const auto& [edge, changed] : edges) new_parts.Bind(bare(parts.edges()(edge)), changed.bare);
  for (const auto& [number, vertex] : vertices)
    new_parts.Bind(bare(parts.vertices()(number)), vertex);
  return withReplacedParts(own, new_parts);
}

}  // namespace seamwright::occ
