// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>

#include <seamwright/occ_adapter/topology/edge_pieces.hpp>

/// Makes the vertices where ends of pieces come together. Not a public header.
namespace seamwright::occ {

struct CornerVertices {
  std::map<int, TopoDS_Vertex> vertices;  ///< by node of a corner
  SewReasons refused;
};

/// A vertex is in the middle of the ends of the curves that end at it, or, if no curve does, in the
/// middle of the ends of images of pcurves. Its tolerance covers all these ends. It is refused if
/// that exceeds both twice \p gap_mm and twice the old tolerance.
CornerVertices cornerVertices(const ShapeParts& parts, const JoinedNodes& joined,
                              const EdgePieces& pieces, double gap_mm);

/// Adds the vertices to the edges of the pieces, once to each common edge.
void addVertices(const ShapeParts& parts, const EdgeNodes& nodes,
                 const std::map<int, TopoDS_Vertex>& vertices, EdgePieces& pieces);

}  // namespace seamwright::occ
