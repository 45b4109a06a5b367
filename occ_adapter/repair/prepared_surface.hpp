// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>

/// A spline surface in a form that may move; not a public header.
namespace seamwright::occ {

struct PreparedSurface {
  opencascade::handle<Geom_BSplineSurface> surface;
  double collapse_mm = 0;  ///< the largest move of a pole that made a side one point
};

/// The same surface, periodic where it ends at itself (but for one that was given periodic in the
/// other direction), so that it does so after a move, as smoothly as its poles and knots made it
/// before; else clamped. Sides within \p near_mm of one point are that point.
PreparedSurface prepared(const opencascade::handle<Geom_BSplineSurface>& given, double near_mm);

}  // namespace seamwright::occ
