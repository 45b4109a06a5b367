// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace seamwright::occ {

/// Why two faces are not matched, and what the user should know about a match. docs/match.md says
/// what helps.
enum class MatchFault {
  None,
  // Remarks.
  OneOfSeveralEdges,  ///< the faces have several common edges, and one of them was taken
  FaceStays,          ///< a face that should move can't; the other one moves alone
  HasLevel,           ///< the faces have the level already
  JoinedInPoles,
  JoinedToTolerance,
  EndsInPoint,      ///< a moved face ends in a point at the seam
  OtherEdgeApart,   ///< another common edge of the faces has a gap now
  FaceCouldMove,    ///< the face that should stay could move
  JoinedInZone,     ///< by a change that ends at a depth
  FaceConverted,    ///< a face without poles became a spline
  OtherSeamsWorse,  ///< other seams of the moved faces lost a level
  SidePartlyMet,    ///< a part of the side has no neighbour
  FaceLessFair,     ///< a moved face varies more than before
  // The common boundary.
  FaceUnusable,   ///< a face or an edge of it has numbers that are not finite
  FaceInstances,  ///< a face that should move, or an edge of it, stands in the model several times
  NoCommonBoundary,
  SideIsFree,       ///< no edge meets the side
  ClosedBoundary,   ///< a closed loop, or no longer than the gap tolerance
  EndsApart,        ///< the ends of both boundaries do not meet
  BoundariesApart,  ///< free edges are side by side over a part of their length only
  BoundaryFolds,    ///< the boundaries turn back on one another
  PathNotFitted,    ///< the path on the face that stays can't be brought to the other parameter
  // A face can't move.
  FaceWithoutPoles,       ///< a plane, cylinder and the like
  FaceTrimmed,            ///< the boundary is not a parameter line
  FaceGoesOn,             ///< the face does not end at the boundary
  FaceSideLonger,         ///< the boundary is a part of a side
  FaceBeyondSurface,      ///< the face reaches beyond its surface
  FaceBoundaryTurnsBack,  ///< the boundary turns back on itself
  // No join.
  JoinRefused,      ///< by the construction of joins in poles
  NoExactJoin,      ///< the poles that stay, or the knots, allow none
  FacesFold,        ///< the faces leave the boundary to the same side
  MissesTolerance,  ///< with all knot spans that are allowed
  SideEndsAway,     ///< of a side that is held: position,
  SideEndsTilted,   ///< tangent plane,
  SideEndsCurved,   ///< curvature
  DepthTooSmall,    ///< no pole acts within the depth alone
  // A join is not kept.
  LessFair,  ///< a moved face would be less fair
  MovesTooFar,
  SideMoves,        ///< a side that is held would move
  FoldsOver,        ///< a moved face would fold
  StillMisses,      ///< the proven figures miss the level
  EdgesStray,       ///< edges would be off their faces
  NeighboursApart,  ///< faces that move and join one another would be moved apart
  ChecksFail,       ///< OpenCASCADE's checks
  OpenCascadeFailed,
  Failed  ///< a surface or an edge can't be evaluated
};

/// A fault or a remark with its numbers and its location in the given model, and its text for the
/// user.
struct MatchReason {
  MatchFault fault = MatchFault::None;
  std::string text = {};
  /// By name with the unit, such as {"move_mm", 0.3}.
  std::vector<std::pair<std::string, double>> numbers = {};
  std::vector<int> faces = {}, edges = {};

  bool empty() const { return fault == MatchFault::None; }
};

/// The name of a fault in reports: "moves_too_far".
/// \throws std::out_of_range for a value that is not of the enum.
std::string codeOf(MatchFault fault);

/// What the user can do: "a larger match_mm"; empty for remarks.
std::string remedyOf(MatchFault fault);

}  // namespace seamwright::occ
