// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/occ_adapter/match/match_sides.hpp>
#include <seamwright/occ_adapter/match/side_piece.hpp>

/// Changes a face so that parts of its boundary meet its neighbours. Not a public header.
namespace seamwright::occ {

/// A face and the parts of its boundary that have to meet their neighbours.
struct SideJoin {
  TopoDS_Shape shape;
  int face = 0;
  /// The numbers of the faces for the user, if the shape is a part of the model; empty: those of
  /// the shape. Other seams of a part are not judged.
  std::vector<int> names = {};
  std::vector<SidePiece> pieces;
  SideMatchOptions options;
};

struct SideJoinResult {
  MatchReason failure;                    ///< empty: joined
  std::vector<MatchReason> remarks;       ///< of a join
  TopoDS_Shape shape;                     ///< as given if not joined
  std::vector<SeamResult> before, after;  ///< by piece
  std::vector<FaceMove> moves;            ///< of the last attempt, also if it was refused
  double depth_mm = 0;
};

/// Tries the depth that the options give, or one after the other: as little as possible, half of
/// the width of the face, and all of it, until a join is proven.
/// \throws GeometryError, Standard_Failure; Cancelled.
SideJoinResult joinSides(const SideJoin& join, const Progress& progress);

}  // namespace seamwright::occ
