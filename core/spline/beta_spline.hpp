// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/spline/nu_spline.hpp>

namespace seamwright {

/// Points to interpolate, n + 1 of them, with every segment over an interval of length 1, and how
/// they join.
struct BetaSplineData {
  Poles points;
  /// n + 1 each; at joint j, X'(-) = bias_j X'(+) and X''(-) = bias_j^2 X''(+) + tension_j X'(+).
  /// Entry 0 changes nothing, nor does entry n of an open one; finite they must be. The curve
  /// tightens for tension -> -infinity.
  std::vector<double> bias;
  std::vector<double> tension;
  SplineEnds ends = SplineEnds::Natural;
  double start_nu = 0, end_nu = 0;  ///< natural ends: X'' = start_nu X', X'' = -end_nu X'
  Eigen::Vector3d start_derivative = Eigen::Vector3d::Zero();
  Eigen::Vector3d end_derivative = Eigen::Vector3d::Zero();
};

struct BetaSpline {
  /// In knots in which it is C1 as far as they hold the lengths: h_{j+1} = h_j / bias_j, the first
  /// is 1. Knots add the lengths up, so shrinking ones lose digits, and continuity() then finds 0:
  /// the curve, whose poles need no knots, stays
  /// G2. Reversed points with inverse biases make lengths grow. Round a periodic one the biases
  /// need not multiply to 1: then it is G2 and not C1 at its seam.
  BezierSpline curve;
  Poles derivatives;  ///< m_j = X'(+) at the points in the parameter of a segment, n + 1 rows
  std::vector<int> stationary;  ///< as of NuSpline
};

/// The interpolating beta-spline, G2 at all joints where X' != 0.
///
/// Open ones are nu-splines with nu_j = -tension_j / (bias_j h_j). Periodic ones whose biases do
/// not multiply to 1 may have no solution (all bias (3 + sqrt 5) / 2, no tension, n even): the
/// cyclic system is solved with pivoting in O(n) and judged by its condition.
///
/// Identities (each has a test of its number):
///   (1) Both equations of every joint.
///   (2) The end conditions.
///   (3) bias = 1, tension = 0: the C2 cubic spline with uniform knots.
///   (4) The nu-spline that it is.
/// \throws as nuSpline(), and std::invalid_argument for a bias that is not positive, and where the
/// lengths shrink so far that the knots do not increase; with the index.
/// Source: docs/theory/curves.md C7.1 to C7.3; [BarskyBeatty1983].
BetaSpline betaSpline(const BetaSplineData& data);

}  // namespace seamwright
