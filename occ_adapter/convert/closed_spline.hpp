// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>

/// Spline surfaces that end at themselves; not a public header.
namespace seamwright::occ {

enum class Direction { U, V };

/// The first and the last pole of each row in that direction are one, or within that distance one,
/// and the side is no single point. False for a surface that is periodic there.
bool endsAtItself(const Geom_BSplineSurface& surface, Direction direction, double near_mm);

/// Makes a surface that ends at itself periodic over the same range, with the knot at its ends
/// repeated only as often as has to be for no pole to move further than \p near_mm; the poles at
/// the end become those at the beginning. \pre endsAtItself() \throws Standard_Failure.
void makePeriodic(Geom_BSplineSurface& surface, Direction direction, double near_mm);

/// Range and shape stay; the surface is periodic in no direction. \throws Standard_Failure.
void makeClamped(Geom_BSplineSurface& surface);

}  // namespace seamwright::occ
