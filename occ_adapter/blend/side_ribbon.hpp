// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/blend/blend_surface.hpp>

namespace seamwright::occ {

/// A side of a model as a spline surface: what constructions of core continue in place of the
/// faces.
struct SideRibbon {
  /// u runs along the side, v from a depth inside to the side at v = 1. Of degree 5 by the order.
  BSplineSurface surface;
  BlendEndReport side;
  /// How the continuation of the ribbon beyond the side joins the faces, certified. Its jets at the
  /// side are those of the ribbon.
  std::vector<BlendSeam> seams;
  /// All seams certainly have the level of the order and cover the side, and the ribbon does not
  /// turn over. The reason of the side says why not.
  bool reached = false;
};

/// The ribbon of a side of any edges of any faces. Its lines across are the Taylor polynomials of
/// the geodesics across the side, of the order's degree, over the depth: they stand for the faces
/// up to that derivative at the side, not inside, and a large depth reaches beyond the faces.
///
///     const SideRibbon ribbon = sideRibbon(model, {.side = {{3}}, .order = 2}, 5);
///
/// \throws as extendSurface(). Source: docs/theory/surfaces.md S8.2 to S8.4.
SideRibbon sideRibbon(const TopoDS_Shape& model, const BlendEnd& side, double depth_mm,
                      const BlendSurfaceOptions& options = {}, const Progress& progress = {});

}  // namespace seamwright::occ
