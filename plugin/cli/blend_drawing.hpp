// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/spline/bezier_spline.hpp>
#include <seamwright/plugin/cli/curve_output.hpp>
#include <vector>

namespace seamwright::cli {

/// Frames as a table or a drawing. A table has 16 points of each segment with the omega of their
/// frame. A drawing has arcs within a tenth of \p tolerance_mm, and needs frames of one plane.
/// \param format Dxf, Svg or Csv
/// \throws std::runtime_error for a drawing of frames of several planes, with the distance.
CurveText framesText(CurveFormat format, const std::vector<BezierSpline>& frames,
                     const std::vector<double>& omegas, double tolerance_mm);

}  // namespace seamwright::cli
