// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/bspline/surface.hpp>

namespace seamwright {

/// What a sheet has along one of its ends: the curve, and the derivatives by the parameter across
/// the sheet, as B-spline curves of one degree over the same flat, clamped knots.
struct SheetRibbon {
  int degree = 0;
  std::vector<double> knots;
  /// The poles of the position, and of the derivatives 1 to n.
  std::vector<Poles> derivatives;

  int order() const { return static_cast<int>(derivatives.size()) - 1; }
};

/// The sheet with these derivatives at both ends, of the least degree across: m + n + 1 for orders
/// m and n. U runs along the ribbons, v from 0 at the start to 1 at the end; the derivatives of
/// both ribbons are by v.
///
/// Each row of poles is one polynomial of v. So the sheet has no more poles along its ends than the
/// ribbons, and m + n + 2 across.
/// Identities (each has a test of its number):
///   (1) At v = 0 and v = 1 the partials by v are the ribbons'.
///   (2) The ribbons of a polynomial surface of degree m + n + 1 across give that surface.
///   (3) Swapping the ends, with odd derivatives negated, reverses v.
/// \throws std::invalid_argument for ribbons that differ in degree or knots, or are no valid
/// curves. Source: docs/theory/surfaces.md S8.1.
BSplineSurface hermiteSheet(const SheetRibbon& start, const SheetRibbon& end);

/// The sheet with these derivatives at v = 0 that goes on as their Taylor polynomial to v = 1.
///   (4) The partials by v of orders above n vanish.
/// \throws std::invalid_argument for a ribbon that is no valid curve, or without a derivative.
BSplineSurface taylorSheet(const SheetRibbon& start);

}  // namespace seamwright
