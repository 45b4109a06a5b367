// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/planar/arc_distance.hpp>
#include <seamwright/core/planar/conic.hpp>

/// Not a public header.
namespace seamwright {

/// A choice: bounds that do not look at the shape replace the others only this far below the
/// tolerance, where the shape does not matter. A larger share would accept conics with kinks.
inline constexpr double small_part = 8;

/// Upper bound of the distance in both directions of conics from the part of a curve between the
/// same points; nothing if it is certainly or possibly above the tolerance. Both have to be graphs
/// over their common chord: the conics by their control polygon, the curve by its velocity.
/// \param conics end to end, turning to one side by less than a right angle against the chord.
/// \param part pieces of the curve end to end.
/// Source: docs/theory/planar.md P9.3.
std::optional<double> distanceFromConics(const std::vector<CurvePiece>& part,
                                         const std::vector<PlanarConic>& conics,
                                         double tolerance_mm);

}  // namespace seamwright
