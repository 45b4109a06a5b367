// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace seamwright::occ {

/// Why a seam is not repaired, or why a change is not kept. docs/repair.md says what helps.
enum class RepairFault {
  None,
  // The seam is not treated.
  NotMeasured,
  HasLevel,          ///< it reaches the target already
  FaceFixed,         ///< none of its faces can move; the fault is that of the first one
  FaceHeld,          ///< its move makes a seam worse in the written file
  FaceUnusable,      ///< a face has numbers that are not finite, or shares an edge with such a face
  FaceInstances,     ///< a face, or an edge of it, occurs in the model several times
  FaceNonManifold,   ///< an edge of a face has more than two faces
  FaceWithoutPoles,  ///< a plane, cylinder and the like
  FacesFold,         ///< the faces fold back on one another
  SurfaceKink,       ///< a surface has a kink across the seam
  // No solution.
  MissesTolerance,  ///< a fair move leaves more than the tolerance
  SidesApart,       ///< an edge alone can't close the gap: its sides are apart at an end
  SurfacesApart,    ///< an edge alone can't close the gap: the surfaces do not meet near it
  PathNotEnough,    ///< an edge alone can't make the seam smooth
  TimeLimit,
  OpenCascadeFailed,
  Failed,  ///< a surface or an edge can't be evaluated
  // The solution is not kept.
  StillMisses,    ///< the seam misses the target after the move
  SpoilsSeam,     ///< another seam would be worse
  EdgeStrays,     ///< an edge would be off its face
  FoldsOver,      ///< a face would fold
  PointMovesFar,  ///< a point would move further than the poles
  ChecksFail,     ///< OpenCASCADE's checks
  VolumeChanges,  ///< of a solid, more than the moves explain
  MovesTooFar,    ///< a face would move further than allowed
  LessFair,       ///< a face would be less fair
  PassesThrough,  ///< a face would pass through another one
  NothingProven,
  InstanceLessCertain,  ///< in the position of another instance
};

/// A fault with its numbers and its location in the given model, and its text for the user.
struct RepairReason {
  RepairFault fault = RepairFault::None;
  std::string text = {};
  /// By name with the unit, such as {"move_mm", 0.3}.
  std::vector<std::pair<std::string, double>> numbers = {};
  std::vector<int> faces = {}, edges = {};

  bool empty() const { return fault == RepairFault::None; }
};

/// The name of a fault in reports: "moves_too_far".
/// \throws std::out_of_range for a value that is not of the enum.
std::string codeOf(RepairFault fault);

}  // namespace seamwright::occ
