// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>

/// Brings a spline surface into a form that may move. Not a public header.
namespace seamwright::occ {

struct PreparedSurface {
  opencascade::handle<Geom_BSplineSurface> surface;
  double collapse_mm = 0;  ///< largest move of a pole, made to turn a side into one point
};

/// The same surface, made periodic where it closes on itself, except if it was given periodic in
/// the other direction. So it stays closed after a move, as smoothly as its poles and knots made it
/// before. Otherwise it is clamped. Sides within \p near_mm of one point become that point.
PreparedSurface prepared(const opencascade::handle<Geom_BSplineSurface>& given, double near_mm);

}  // namespace seamwright::occ
