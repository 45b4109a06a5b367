// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <seamwright/occ_adapter/blend/blend_seams.hpp>

/// Sides of a blend that share a vertex. Not a public header.
namespace seamwright::occ {

/// Where two open sides meet.
struct SharedCorner {
  std::array<int, 2> of_sides{};  ///< the ends, 0 or 1, of the paths of start and end
};

/// The ends of the sides that are within the gap tolerance of one another.
/// \throws std::invalid_argument where no blend can begin: the angle across the gap is below 5 or
/// above 175 degrees, or an order is above 1 and the faces differ in their tangent planes; with
/// figures. Source: docs/theory/surfaces.md S8.7.
std::vector<SharedCorner> sharedCorners(const std::vector<ChosenEnd>& ends,
                                        const ContinuityTolerance& tolerance);

}  // namespace seamwright::occ
