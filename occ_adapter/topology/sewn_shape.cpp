// SPDX-License-Identifier: LGPL-2.1-or-later
#include <utility>

#include <seamwright/occ_adapter/topology/sewn_assembly.hpp>
#include <seamwright/occ_adapter/topology/sewn_shape.hpp>

namespace seamwright::occ {

namespace {

/// The result of sewing with its numbers.
SewnShape numbered(const ShapeParts& parts, const SewnEdges& sewn,
                   const std::vector<TopoDS_Face>& new_faces, SewnAssembly assembly) {
  const TopTools_IndexedMapOfShape faces = partsOf(assembly.shape, TopAbs_FACE),
                                   edges = partsOf(assembly.shape, TopAbs_EDGE);
  SewnShape result;
  result.faces.assign(1, 0);
  for (int f = 1; f <= parts.faces.Extent(); ++f)
    result.faces.push_back(faces.FindIndex(new_faces[f]));
  result.edges.assign(1, {});
  for (int e = 1; e <= parts.edges.Extent(); ++e) {
    std::vector<int> numbers;
    for (const TopoDS_Shape& piece : replacedEdge(parts, sewn, parts.edge(e)))
      numbers.push_back(edges.FindIndex(piece));
    result.edges.push_back(std::move(numbers));
  }
  for (std::size_t k = 0; k < sewn.intervals.size(); ++k)
    result.seam_edges[sewn.intervals[k].seam] = edges.FindIndex(sewn.common[k]);
  result.became = assembly.became;
  for (const auto& [v, vertex] : sewn.vertices) result.became.Bind(parts.vertices(v), vertex);
  result.shape = std::move(assembly.shape);
  return result;
}

}  // namespace

SewnShape sewnShape(const TopoDS_Shape& shape, const std::vector<Seam>& seams,
                    const std::vector<std::size_t>& chosen, double gap_mm, const FaceNames& names) {
  SewnShape refusing;
  const ShapeParts parts(shape);
  refusing.refused = notSewable(parts, seams, chosen, names);
  if (!refusing.refused.empty()) return refusing;
  const SewnEdges edges = sewnEdges(parts, seams, chosen, gap_mm);
  refusing.refused = edges.refused;
  if (!refusing.refused.empty()) return refusing;
  std::vector<TopoDS_Face> faces = facesWithEdges(parts, edges);
  const FaceGroups groups = sewnGroups(parts, seams, edges.intervals);
  orientFaces(groups, faces);
  refusing.refused = oneSidedSeams(seams, edges, faces);
  if (!refusing.refused.empty()) return refusing;
  return numbered(parts, edges, faces, sewnAssembly(parts, edges, groups, faces));
}

}  // namespace seamwright::occ
