// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/bezier/patch_edge.hpp>
#include <seamwright/core/seam/enclose.hpp>

namespace seamwright {

/// The side of a seam that lies on one edge of a patch, for encloseSeam(). s is the parameter that
/// runs along the edge, or 1 minus it if \p reversed. The numbers of poles() and weights() count as
/// exact.
SeamSide seamSide(const BezierPatch& patch, PatchEdge edge, bool reversed = false);

}  // namespace seamwright
