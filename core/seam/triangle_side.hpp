// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bezier/patch_edge.hpp>
#include <seamwright/core/bezier/triangle.hpp>
#include <seamwright/core/seam/seam_side.hpp>

namespace seamwright {

/// The side of a seam that lies on one edge of a triangle, for encloseSeam(). s runs in the
/// direction of the edge, from 0 at its first corner to 1, or against it if \p reversed.
///
/// The surface is degeneratePatch() with the corner opposite the edge as apex. So it is regular
/// along the whole seam where the triangle is regular. The poles of the seam are copied unchanged.
/// The poles of row k behind the seam differ from the exact ones by at most k / n
/// conversionNoise(), which is not part of the enclosure. So the direction across the seam, n times
/// a difference of poles, is that of the triangle up to conversionNoise().
/// \throws std::invalid_argument if the degree is above 25, the largest that is enclosed.
SeamSide seamSide(const BezierTriangle& triangle, TriangleEdge edge, bool reversed = false);

}  // namespace seamwright
