// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/occ_adapter/fill/fill_reason.hpp>
#include <seamwright/occ_adapter/fill/holes.hpp>

/// Where the surroundings of a hole contradict each other. Not a public header.
namespace seamwright::occ {

/// The joint of two edges of the hole at which the tangent planes of their faces differ most, if
/// they do so by more than twice the accepted angle; a fill has one tangent plane there, and so
/// misses one of them by half of that at least. Joints where a face has no tangent plane, as at the
/// tip of a cone, do not count.
std::vector<FillReason> causesOfContradiction(const Hole& hole, double angle_rad, double gap_mm);

}  // namespace seamwright::occ
