// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <seamwright/core/spline/bezier_spline.hpp>
#include <seamwright/plugin/cli/point_file.hpp>
#include <vector>

namespace seamwright::cli {

/// The curve of lines and arcs of which points are samples.
struct SampledCurve {
  /// Rational. A closed one begins at its first corner, else at the arc beside the first point.
  BezierSpline spline;
  int arcs = 0, lines = 0;
  std::vector<std::ptrdiff_t> corners;  ///< numbers of points, from 1
  std::vector<double> parameters;       ///< of the points, by the knots of the spline
  double distance_mm = 0;               ///< no point is further from the curve
};

/// The lines and arcs of which the points are samples within their own digits; see sampledChain().
/// Nothing if there are none, if the points are so few that they could be of other curves as well,
/// or if a curve of continuous curvature could be as near to them.
std::optional<SampledCurve> sampledCurve(const PointFile& file, bool closed);

}  // namespace seamwright::cli
