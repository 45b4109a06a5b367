// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>

#include <seamwright/occ_adapter/repair/changed_edges.hpp>

/// Makes the vertices of changed edges. Not a public header.
namespace seamwright::occ {

/// By number: the new vertices at the ends of these edges, without location and orientation.
/// Vertices whose old tolerance is enough are not included.
///
/// A vertex moves to the middle of the curves that end at it, unless an edge that stays ends there
/// too. Its tolerance covers the ends of curves and of their images on faces.
/// \throws std::invalid_argument if one of these vertices occurs in the shape several times.
std::map<int, TopoDS_Vertex> changedVertices(const ConnectedParts& parts,
                                             const std::map<int, ChangedEdge>& edges);

}  // namespace seamwright::occ
