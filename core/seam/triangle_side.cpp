// SPDX-License-Identifier: LGPL-2.1-or-later
#include <stdexcept>
#include <string>

#include <seamwright/core/bezier/triangle_conversion.hpp>
#include <seamwright/core/seam/patch_side.hpp>
#include <seamwright/core/seam/triangle_side.hpp>

namespace seamwright {

SeamSide seamSide(const BezierTriangle& triangle, TriangleEdge edge, bool reversed) {
  if (triangle.degree() > max_spline_degree)
    throw std::invalid_argument("triangle of degree " + std::to_string(triangle.degree()) +
                                ": degrees up to " + std::to_string(max_spline_degree) +
                                " are enclosed");
  return seamSide(degeneratePatch(triangle, static_cast<int>(edge)), PatchEdge::U1, reversed);
}

}  // namespace seamwright
