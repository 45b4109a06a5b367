// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include <seamwright/occ_adapter/fill/holes.hpp>

/// Cuts long smooth sides into several. Not a public header.
namespace seamwright::occ {

/// A part of a side of a hole. Its ends are shares of the side's length.
struct SideInterval {
  std::size_t side = 0;
  double begin = 0, end = 1;     ///< on a smooth loop the end may exceed 1, up to begin + 1
  bool begins_smoothly = false;  ///< there is no corner between the interval before and this one
};

/// Every side as one interval.
std::vector<SideInterval> wholeSides(const Hole& hole);

/// Cuts sides until there are \p count intervals. The sides that are longest and turn most are cut.
/// The parts of a side have equal sums of length (over the length of the hole) and turning (over
/// that of the hole).
/// \param at_joints cuts move to the nearest joint of two edges of different curvature that is not
/// too far away.
/// \pre the hole has at most \p count sides.
/// \throws as SidePath.
std::vector<SideInterval> cutSides(const Hole& hole, std::size_t count, double gap_mm,
                                   bool at_joints);

/// Alternative cuts of a smooth loop into \p count intervals of nearly equal sums of length and
/// turning: at joints of lines and arcs; at joints of faces; starting where the loop turns most;
/// and starting half an interval after that. No interval ends so close to a joint of edges that a
/// sliver is left.
/// \pre the hole has no corners. \throws as SidePath.
std::vector<std::vector<SideInterval>> loopCuts(const Hole& hole, std::size_t count, double gap_mm);

/// A corner of a hole, where a side begins.
struct HoleAngle {
  double angle_rad = 0;  ///< inner angle of the hole for the orientation of its faces, in [0, 2 pi]
  Eigen::Vector3d point;
  std::array<int, 2> edges{};  ///< the last edge before the corner and the first one after it
};

/// The corners of a hole in the order of its sides; empty if the hole is smooth. \throws as
/// SidePath.
std::vector<HoleAngle> anglesOf(const Hole& hole, double gap_mm);

/// The joint of two edges of one side at which the tangent turns most, with that angle in [0, pi];
/// the angle is 0 if no side has two edges. \throws as SidePath.
HoleAngle sharpestTurn(const Hole& hole, double gap_mm);

}  // namespace seamwright::occ
