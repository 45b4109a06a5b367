// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gp_Pnt.hxx>

#include <array>
#include <map>
#include <vector>

#include <seamwright/occ_adapter/topology/edge_nodes.hpp>

/// Makes the pieces of edges that are cut, sewn, or end at a new vertex. Not a public header.
namespace seamwright::occ {

/// An edge, or a piece of one, after sewing. It has no vertices yet.
struct EdgePiece {
  /// In the frame of the shape; FORWARD: in the direction of the edge of which it is a piece.
  TopoDS_Edge edge;
  int interval = -1;           ///< index of the interval, for a common edge; otherwise -1
  std::array<int, 2> nodes{};  ///< nodes at the first and the last end of the old edge's piece
  /// By end: the ends of its curve, and of the images of its pcurves.
  std::array<std::vector<gp_Pnt>, 2> curve_ends, image_ends;
  double tolerance_mm = 0;
};

/// By number of an edge: its pieces in the order and the direction of its curve.
using EdgePieces = std::map<int, std::vector<EdgePiece>>;

/// The pieces of all edges that are cut or end at a node of \p joined.corners. Pieces in an
/// interval are its common edge; others keep the curve and the pcurves of their edge, over a part
/// of their ranges.
/// \param common edges by interval.
EdgePieces edgePieces(const ShapeParts& parts, const JoinedNodes& joined,
                      const std::vector<SewnInterval>& intervals,
                      const std::vector<CommonEdge>& common);

}  // namespace seamwright::occ
