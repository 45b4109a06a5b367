// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <vector>

#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/occ_adapter/fill/side_fit.hpp>

/// The form of a fill beside that of its surroundings; not a public header.
namespace seamwright::occ {

/// The farthest pole of the surface from the middle of the box of the sides, over half its
/// diagonal.
double reachOf(const BSplineSurface& surface, const std::vector<FittedSide>& sides);

/// Whether the faces lie on both sides, seen along the normal of the hole, where all that they are
/// tangent to lies on one; looked at on grids. False where a side has position alone.
bool turnsBack(const std::vector<TopoDS_Face>& faces, const std::vector<FittedSide>& sides);

}  // namespace seamwright::occ
