// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include <seamwright/occ_adapter/fill/holes.hpp>

/// Long smooth sides cut into several; not a public header.
namespace seamwright::occ {

/// A part of a side of a hole, by shares of its length.
struct SideInterval {
  std::size_t side = 0;
  double begin = 0, end = 1;     ///< of a smooth loop the end may be beyond 1, up to begin + 1
  bool begins_smoothly = false;  ///< it goes on from the interval before it without a corner
};

/// Every side whole.
std::vector<SideInterval> wholeSides(const Hole& hole);

/// So many intervals. The sides that are longest and turn most are cut, into parts of which the sum
/// of length over the length of the hole and turning over that of the hole is the same. \param
/// at_joints cuts are moved to the nearest joint of two edges of different curvature that is not
/// too far away.
/// \pre the hole has no more sides. \throws as SidePath.
std::vector<SideInterval> cutSides(const Hole& hole, std::size_t count, double gap_mm,
                                   bool at_joints);

/// Ways to cut a smooth loop into so many intervals of nearly the same sum of length and turning:
/// at joints of lines and arcs; at joints of faces; from where it turns most; and from half an
/// interval after that. No interval ends so near to a joint of edges that a sliver is left.
/// \pre the hole has no corners. \throws as SidePath.
std::vector<std::vector<SideInterval>> loopCuts(const Hole& hole, std::size_t count, double gap_mm);

/// A corner of a hole, where a side begins.
struct HoleAngle {
  double angle_rad = 0;  ///< of the hole, seen as its faces are turned, in [0, 2 pi]
  Eigen::Vector3d point;
  std::array<int, 2> edges{};  ///< the last one before the corner, the first one after it
};

/// The corners of a hole in the order of its sides; empty where it is smooth. \throws as SidePath.
std::vector<HoleAngle> anglesOf(const Hole& hole, double gap_mm);

/// Where the tangent turns most between two edges of one side, with that angle in [0, pi]; 0 where
/// no side has two. \throws as SidePath.
HoleAngle sharpestTurn(const Hole& hole, double gap_mm);

}  // namespace seamwright::occ
