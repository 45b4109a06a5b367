// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/planar/conic.hpp>
#include <seamwright/core/progress.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

struct ConicFitOptions {
  double tolerance_mm = 0.01;
  /// A joint at which the tangent turns by more is a corner, and stays one...
  double corner_rad = 1e-3;
  /// ... unless it turns by no more than this, and arcs with this turn are no further from both
  /// segments beside it than half the tolerance: so it is where a curve was sampled.
  double sampled_rad = 0.2;
};

/// Conics near a curve.
struct ConicFit {
  std::vector<PlanarConic> conics;
  std::vector<int> corners;    ///< conics that begin at a corner of the curve; ends do not count
  std::vector<int> g1_joints;  ///< conics that begin at an inflection, or before or after a line
  bool closed = false;
  double distance_mm = 0;  ///< upper bound of the distance in both directions
};

/// A curve in the plane z = 0 as the conics of conicSpline() through points of it, divided where
/// the distance is not proven. The points fix the turns, not the curvature of the curve, so waves
/// of the curve that are within the tolerance are not followed. Identities (each has a test of its
/// number):
///   (1) distance_mm <= tolerance_mm, and points of a dense sample are not further, in both
///       directions.
///   (2) Conics join G2 except at corners, at inflections and beside lines.
///   (3) Lines, and closed circles, come back up to rounding.
///   (4) Corners are kept; a closed curve gives a closed chain.
/// \throws std::invalid_argument if the curve is not valid, a pole is outside of the plane, the
/// tolerance is not positive and finite, or the corner angle is not in (0, pi). Throws
/// std::domain_error if the curve may stop or turns back, with the parameter. Throws Cancelled, see
/// Progress; it is called before each piece.
/// Source: docs/theory/planar.md P7.5, P9.3.
ConicFit fitConics(const BezierSpline& curve, const ConicFitOptions& options = {},
                   const Progress& progress = {});

}  // namespace seamwright
