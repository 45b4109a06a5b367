// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include <seamwright/occ_adapter/match/constrained_deformation.hpp>
#include <seamwright/occ_adapter/match/rebuild.hpp>

/// Joins of two faces before they are proven. Not a public header.
namespace seamwright::occ {

struct PairToMatch {
  std::array<MatchSide, 2> sides;
  std::array<bool, 2> moves{};  ///< at least one; true only where the side is natural
  int driver = 0;               ///< the side that moves; its parameter is that of the seam
  ReferencePath path;           ///< of the other side
  FaceMatchOptions options;

  const MatchSide& other() const { return sides[1 - driver]; }
};

/// A join before it is proven.
struct Candidate {
  MatchReason failure;  ///< why there is none
  MatchReason how;      ///< a remark for the user
  bool exact = false;
  std::array<MovedSurface, 2> moved;  ///< null surfaces where a side stays
  double largest_move_mm = 0;
  SeamPlan plan;
};

/// A copy of the side's spline with enough rows for the order and for the opposite side to stay.
EdgeRows rowsToMove(const MatchSide& side, int order);

/// The exact join (nearestJoin()). \pre both sides are natural. \throws Standard_Failure.
Candidate joinInPoles(const PairToMatch& pair);

/// The driver is deformed to meet the other side.
/// \param limit share of the tolerance that samples have to meet.
Candidate joinToTolerance(const PairToMatch& pair, double limit);

}  // namespace seamwright::occ
