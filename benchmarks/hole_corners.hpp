// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/fill/holes.hpp>

namespace seamwright {

/// What the neighbours of a hole ask of any fill that has one tangent plane where two of its sides,
/// or two edges of one, meet; by OpenCASCADE's evaluation alone.
struct CornerBounds {
  /// Half the largest angle between the normals of two neighbours where they meet: every fill
  /// leaves one of them by so much.
  double angle_rad = 0;
  /// The largest relative difference of curvature to either neighbour there of what is tangent to
  /// both and has a curvature: across one side that is the curvature of the next side's edge.
  /// Corners of less than 3 degrees, and of degenerate faces, are left out.
  double curvature_rel = 0;
};

CornerBounds cornerBounds(const occ::Hole& hole);

}  // namespace seamwright
