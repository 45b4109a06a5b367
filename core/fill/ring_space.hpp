// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/fill/fill_space.hpp>
#include <seamwright/core/fill/ring_fill.hpp>

/// The space of all ring fills of a hole with exact joins; not a public header.
namespace seamwright::fill {

/// The row in which a pole of the ring is stored. Neighbours share the poles of their common edge.
Eigen::Index sharedRow(const FillSpace& space, int patch, int i, int j);

struct RingSpace {
  FillSpace space;  ///< of five patches; without a centre
  std::vector<FillCorner> corners;
  std::optional<double> spoke_jump_per_mm;  ///< as in RingFill
};

/// \throws as ringFill() does for corners; RingContradiction.
RingSpace ringSpace(const std::vector<FillSide>& sides, SpokeLaw law, double spoke_scale,
                    double tolerance_rad, int more_degrees);

/// Poles that neighbours share are bitwise the same.
std::vector<BezierPatch> ringPatches(const FillSpace& space, const Poles& unknowns);

}  // namespace seamwright::fill
