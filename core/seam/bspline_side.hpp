// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/core/seam/seam_side.hpp>

namespace seamwright {

/// The side that a surface gives to a seam along one of its edges, for encloseSeam(); s is the
/// parameter that runs along the edge, mapped to 0..1, or 1 minus it if \p reversed.
/// \throws std::invalid_argument as requireValid() does.
SeamSide seamSide(const BSplineSurface& surface, PatchEdge edge, bool reversed = false);

}  // namespace seamwright
