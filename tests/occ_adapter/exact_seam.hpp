// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <seamwright/core/seam/measure.hpp>

#include <seamwright/occ_adapter/convert/pcurve.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

/// Angle and curvature difference of seams between splines in 113 bits, from what OpenCASCADE
/// holds.
namespace seamwright::test {

struct ExactMeasure {
  double angle_rad = 0;
  double curvature_per_mm = 0;
  double curvature_rel = 0;
};

/// At s in 0..1, of sides that are planes, Bezier or B-spline surfaces without location, along
/// lines or B-spline curves; along a knot line on the side of the face. Nothing for other sides, or
/// where X_u x X_v vanishes.
std::optional<ExactMeasure> exactMeasure(const occ::Seam& seam,
                                         const std::array<occ::Pcurve, 2>& pcurves, double s,
                                         double flat_radius_mm);

}  // namespace seamwright::test
