// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <array>
#include <optional>

/// Compares points and normals of two surfaces. Not a public header.
namespace seamwright::occ {

/// Differences, sampled on a grid of 4 by 4 points in each knot span.
struct SurfaceDifference {
  double largest_mm = 0;  ///< largest distance of points with the same parameters
  /// Where the normal turned by 90 degrees or more; points at which both surfaces are nearly
  /// degenerate don't count.
  std::optional<gp_Pnt> folded_at;
};

/// \param range common parameters of both surfaces: u from, to, v from, to.
SurfaceDifference differenceOf(const opencascade::handle<Geom_Surface>& before,
                               const opencascade::handle<Geom_BSplineSurface>& after,
                               const std::array<double, 4>& range);

}  // namespace seamwright::occ
