// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Face.hxx>
#include <memory>
#include <optional>
#include <vector>

#include <seamwright/occ_adapter/match/side_join.hpp>

/// The change of one face that has to meet its neighbours. Not a public header.
namespace seamwright::occ {

/// One side of a piece, of the face that moves.
struct MoverPiece {
  std::shared_ptr<const PieceStrips> strips;
  bool is_own = true;  ///< the face is the first one of the piece
  int order = 1;

  Eigen::Vector2d uvAt(double s) const {
    const PiecePoint point = strips->at(s);
    return is_own ? point.own_uv : point.other_uv;
  }
};

/// A face that moves, and what it has to meet.
struct Mover {
  int number = 0;
  TopoDS_Face face;
  opencascade::handle<Geom_BSplineSurface> spline;
  std::vector<MoverPiece> pieces;
};

/// The number of a face for the user.
inline int nameOf(const SideJoin& join, int face) {
  return join.names.empty() ? face : join.names.at(static_cast<std::size_t>(face - 1));
}

/// The surface of a face after its change.
struct FaceDeformation {
  MatchReason failure;  ///< empty: its points are nearer to their targets than the tolerances
  opencascade::handle<Geom_BSplineSurface> after;
  double move_mm = 0, depth_mm = 0;
  double worst = 0;          ///< of a figure, as a share of its tolerance
  bool keeps_edges = false;  ///< other edges would move too far by themselves
};

/// How far a change may reach.
struct Reachable {
  std::optional<double> depth_mm;  ///< see ZoneOptions
  double stray_mm = 0;             ///< other edges that the face shares move less if they can
};

/// Moves the poles near the pieces of the mover with the least bending of their moves. Spans are
/// cut where points, normals and curvatures miss half the tolerances, and bending weighs less as
/// long as the moves grow little. \param graph the seams of the join's shape. Source:
/// docs/theory/surfaces.md S5.6.
FaceDeformation deformedFace(const SideJoin& join, const Mover& mover, const SeamGraph& graph,
                             const Reachable& reachable);

}  // namespace seamwright::occ
