// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/disjoint_sets.hpp>
#include <seamwright/occ_adapter/topology/sewn_edges.hpp>

/// Gives faces their sewn edges, and finds which of them become one shell. Not a public header.
namespace seamwright::occ {

/// What replaces an edge in a wire: its pieces in the order of the wire, or the edge itself.
std::vector<TopoDS_Shape> replacedEdge(const ShapeParts& parts, const SewnEdges& sewn,
                                       const TopoDS_Edge& edge);
/// What replaces a vertex, oriented like it.
TopoDS_Shape replacedVertex(const ShapeParts& parts, const SewnEdges& sewn,
                            const TopoDS_Shape& vertex);

/// The faces of a shape, by number from 1, with their new edges. Faces without new edges stay.
std::vector<TopoDS_Face> facesWithEdges(const ShapeParts& parts, const SewnEdges& sewn);

/// Faces that become one shell.
struct FaceGroups {
  DisjointSets groups;  ///< of all faces
  /// By group with a sewn face: its faces.
  std::map<int, std::vector<int>> members = {};

  bool isSewn(int face) const { return members.count(groups.of(face)) > 0; }
};

/// Groups faces that intervals connect, each with all faces of its shell.
FaceGroups sewnGroups(const ShapeParts& parts, const std::vector<Seam>& seams,
                      const std::vector<SewnInterval>& intervals);

/// Reverses faces so that the two coedges of each edge have opposite directions. The first face of
/// each group stays. In a band that has one side only, an edge remains whose coedges agree.
void orientFaces(const FaceGroups& groups, std::vector<TopoDS_Face>& faces);

/// The sewn seams whose two coedges have the same direction in these faces.
SewReasons oneSidedSeams(const std::vector<Seam>& seams, const SewnEdges& sewn,
                         const std::vector<TopoDS_Face>& faces);

}  // namespace seamwright::occ
