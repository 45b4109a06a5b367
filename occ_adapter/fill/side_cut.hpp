// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/occ_adapter/fill/holes.hpp>

/// Long smooth sides cut into several; not a public header.
namespace seamwright::occ {

/// A part of a side of a hole, by shares of its length.
struct SideStretch {
  std::size_t side = 0;
  double begin = 0, end = 1;
  bool begins_smoothly = false;  ///< it goes on from the stretch before it without a corner
};

/// Every side whole.
std::vector<SideStretch> wholeSides(const Hole& hole);

/// So many stretches. The sides that are longest and turn most are cut, into parts of which the sum of length over the length of the hole and
/// turning over that of the hole is the same. \param at_joints cuts are moved to the nearest joint of two edges of different curvature that is not too far away.
/// \pre the hole has no more sides. \throws as SidePath.
std::vector<SideStretch> cutSides(const Hole& hole, std::size_t count, double gap_mm, bool at_joints);

/// Whether the angle of the hole is above pi in one of its corners, seen as its faces are turned.
bool hasReflexCorner(const Hole& hole, double gap_mm);

}  // namespace seamwright::occ
