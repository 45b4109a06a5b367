// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/planar/conic.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

struct ConicFitOptions {
  double tolerance_mm = 0.01;
  /// A joint at which the tangent turns by more is a corner, and stays one.
  double corner_rad = 1e-3;
};

/// Conics near a curve.
struct ConicFit {
  std::vector<PlanarConic> conics;
  std::vector<int> corners;    ///< conics that begin at a corner of the curve; ends do not count
  std::vector<int> g1_joints;  ///< conics that begin at an inflection, or before or after a line
  bool closed = false;
  /// Upper bound of the distance in both directions; infinite if none up to the tolerance is
  /// certain.
  double distance_mm = 0;
};

/// A curve in the plane z = 0 as conics with the points, tangents and curvatures of the curve at
/// their ends: pairs by fairConics(), divided where the distance is not proven. Parts of the curve
/// that are conics come back as they are. Identities (each has a test of its number):
///   (1) distance_mm <= tolerance_mm, and points of a dense sample are not further, in both
///       directions.
///   (2) Conics join G2 except at corners, at inflections and beside lines. There are as many
///       inflections as the curve has.
///   (3) Arcs, ellipses and lines come back exactly.
///   (4) Corners are kept; a closed curve gives a closed chain.
/// Where the curvature of the curve jumps without a change of its sign, both sides get the
/// geometric mean. This adds extrema.
/// \throws std::invalid_argument if the curve is not valid, a pole is outside of the plane, the
/// tolerance is not positive and finite, or the corner angle is not in (0, pi). Throws
/// std::domain_error if the curve may stop.
/// Source: docs/theory/planar.md P7.4, P7.6, P9.3.
ConicFit fitConics(const BezierSpline& curve, const ConicFitOptions& options = {});

}  // namespace seamwright
