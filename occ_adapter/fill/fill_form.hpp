// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <vector>

#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/occ_adapter/fill/side_fit.hpp>

/// Compares the form of a fill with its surroundings. Not a public header.
namespace seamwright::occ {

/// The distance of the surface's farthest pole from the middle of the box of the sides, over half
/// the diagonal of that box.
double reachOf(const BSplineSurface& surface, const std::vector<FittedSide>& sides);

/// Whether the normals of the faces point to both sides of the hole's plane although all tangent
/// planes along the sides face one side. Sampled on grids. False if a side has position only.
bool turnsBack(const std::vector<TopoDS_Face>& faces, const std::vector<FittedSide>& sides);

}  // namespace seamwright::occ
