// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "shapes.hpp"

#include <seamwright/occ_adapter/blend/blend_surface.hpp>

namespace seamwright::test {

/// Tolerances that blends between natural sides have to meet.
inline occ::BlendSurfaceOptions strictly() {
  occ::BlendSurfaceOptions options;
  options.tolerance.gap_mm = 1e-4;
  options.tolerance.angle_rad = 0.001 * degree;
  options.tolerance.curvature_rel = 1e-3;
  return options;
}

}  // namespace seamwright::test
