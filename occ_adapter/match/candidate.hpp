// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <string>

#include <seamwright/occ_adapter/match/constrained_deformation.hpp>
#include <seamwright/occ_adapter/match/rebuild.hpp>

/// Ways to make two faces join; not a public header.
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
  std::string failure;  ///< why there is none
  std::string how;
  bool exact = false;
  std::array<MovedSurface, 2> moved;  ///< null surfaces where a side stays
  double largest_move_mm = 0;
  SeamPlan plan;
};

/// The side's spline, a copy, with rows enough for the order and for the opposite side to stay.
EdgeRows rowsToMove(const MatchSide& side, int order);

/// \pre both sides are natural. \throws Standard_Failure.
Candidate joinInPoles(const PairToMatch& pair);

/// The driver follows the other side. \param limit share of the tolerance that samples have to
/// meet.
Candidate joinToTolerance(const PairToMatch& pair, double limit);

}  // namespace seamwright::occ
