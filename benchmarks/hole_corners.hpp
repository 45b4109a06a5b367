// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/fill/holes.hpp>

namespace seamwright {

/// Lower bounds for any fill of a hole that has one tangent plane where two sides, or two edges of
/// one side, meet. They follow from the neighbours of the hole, evaluated by OpenCASCADE alone.
struct CornerBounds {
  /// Half the largest angle between the normals of two neighbours where they meet: every fill has
  /// at least this angle to one of them.
  double angle_rad = 0;
  /// The largest relative difference of curvature between a fill that is tangent to both neighbours
  /// and either neighbour, at a point where they meet. The normal curvature of such a fill across
  /// one side is that along the edge of the next side. Corners of less than 3 degrees, and those of
  /// degenerate faces, are left out.
  double curvature_rel = 0;
};

CornerBounds cornerBounds(const occ::Hole& hole);

}  // namespace seamwright
