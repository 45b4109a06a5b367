// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>

/// Spline surfaces that end at themselves; not a public header.
namespace seamwright::occ {

enum class Direction { U, V };

/// Whether the first and the last pole of each row in that direction are within that distance of
/// each other and the side is not a single point. False for a surface that is periodic in that
/// direction.
bool endsAtItself(const Geom_BSplineSurface& surface, Direction direction, double near_mm);

/// Makes a surface that ends at itself periodic over the same range. The knot at its ends gets the
/// least multiplicity with which no pole moves further than \p near_mm; the poles at the end become
/// those at the beginning. \pre endsAtItself() \throws Standard_Failure.
void makePeriodic(Geom_BSplineSurface& surface, Direction direction, double near_mm);

/// Makes a surface clamped and not periodic. Range and shape stay. \throws Standard_Failure.
void makeClamped(Geom_BSplineSurface& surface);

}  // namespace seamwright::occ
