// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace seamwright::occ {

/// Why a hole is not filled, or why a fill misses its target. docs/fill.md says what helps.
enum class FillFault {
  None,
  // The hole.
  UnusableBoundary,  ///< a face or edge beside the hole can't be met
  TooManyCorners,
  Cusp,                 ///< a corner with an angle near 0 or near a full turn
  CornerTooWide,        ///< a corner of a hole with up to four corners, above 5.3 rad
  CornerAbove180,       ///< a corner of a hole with more than four corners, above pi
  OnlyFace,             ///< the faces to be replaced are all of the model
  EdgeOfOneFace,        ///< the face to be replaced has an edge without a neighbour
  NoLoop,               ///< the face to be replaced leaves no single loop of edges
  ConstructionRefused,  ///< the construction of patches refuses the sides
  OpenCascadeFailed,
  // The fill.
  NotSewn,
  FreeEdges,      ///< edges of the fill along no edge of the hole
  MissesTarget,   ///< for every value within the bounds
  MayMissTarget,  ///< for some value within the bounds
  MayFold,        ///< the new faces are not proved regular
  TurnsBack,
  ReachesTooFar,
  TooSmall,  ///< no seam can be measured
  RunsIntoItself,
  RunsIntoFace,
  InvalidFace,  ///< for OpenCASCADE's checks
  InvalidShape,
  // Causes of another fault.
  SharpTurn,             ///< edges of one side turn at a point
  SideNotPolynomial,     ///< one polynomial does not meet a side within the gap
  PositionOnly,          ///< tangent planes contradict each other at a corner
  NeighboursContradict,  ///< tangent planes of the faces beside two edges differ where these meet
};

/// A fault with its numbers, its location in the given model and its causes.
struct FillReason {
  FillFault fault = FillFault::None;
  /// By name with the unit, such as {"angle_deg", 270}.
  std::vector<std::pair<std::string, double>> numbers = {};
  std::vector<std::string> faces = {};  ///< "face 3", or "the fill"
  std::vector<int> edges = {};
  std::optional<Eigen::Vector3d> point_mm = {};
  std::string detail = {};  ///< text of OpenCASCADE, of the construction, or figures of a seam
  std::vector<FillReason> causes = {};

  bool empty() const { return fault == FillFault::None; }
  /// \throws std::out_of_range if there is no number of that name.
  double number(const std::string& name) const;
};

/// The name of a fault in reports: "corner_above_180".
/// \throws std::out_of_range for a value that is not of the enum.
std::string codeOf(FillFault fault);
/// One line for the user; empty for FillFault::None.
std::string textOf(const FillReason& reason);

}  // namespace seamwright::occ
