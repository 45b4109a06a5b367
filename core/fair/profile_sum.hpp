// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bezier/curve.hpp>

/// Not a public header.
namespace seamwright {

/// Counts of the curvature profiles of segments that follow each other on a curve.
struct ProfileSum {
  bool planar = false;  ///< the curve has z = 0 throughout, and so a signed curvature
  /// Extrema and changes of sign inside of the segments; extrema at joints, where the slope of the
  /// curvature changes its sign.
  int extrema = 0, extrema_at_joints = 0, inflections = 0;
  int undecided = 0;      ///< segments in which rounding hides a sign, or the curve may stop
  double last_slope = 0;  ///< at the end of the segment before; only its sign has a meaning

  /// Adds the next segment.
  void add(const BezierCurve& segment);
};

}  // namespace seamwright
