// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/fill/fill_space.hpp>
#include <seamwright/core/fill/ring_fill.hpp>

/// All ring fills of a hole whose joins are exact; not a public header.
namespace seamwright::fill {

/// Where a pole of the ring is kept: neighbours share those of their common edge.
Eigen::Index sharedRow(const FillSpace& space, int patch, int i, int j);

struct RingSpace {
  FillSpace space;  ///< of five patches; without a centre
  std::vector<FillCorner> corners;
};

/// \throws as ringFill() for what concerns corners; std::runtime_error if the joins contradict each
/// other.
RingSpace ringSpace(const std::vector<FillSide>& sides, double spoke_scale, double tolerance_rad,
                    int more_degrees);

/// Poles that neighbours share are bitwise the same.
std::vector<BezierPatch> ringPatches(const FillSpace& space, const Poles& unknowns);

}  // namespace seamwright::fill
