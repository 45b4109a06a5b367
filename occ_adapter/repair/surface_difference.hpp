// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <array>
#include <optional>

/// What became of a surface's points and normals; not a public header.
namespace seamwright::occ {

/// On a grid of 4 by 4 points a knot span.
struct SurfaceDifference {
  double largest_mm = 0;            ///< of points
  std::optional<gp_Pnt> folded_at;  ///< where the normal turned by 90 degrees or more; not where
                                    ///< both sides are nearly collapsed
};

/// \param range of the parameters that both surfaces have: u from, to, v from, to.
SurfaceDifference differenceOf(const opencascade::handle<Geom_Surface>& before,
                               const opencascade::handle<Geom_BSplineSurface>& after,
                               const std::array<double, 4>& range);

}  // namespace seamwright::occ
