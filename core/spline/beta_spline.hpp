// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/spline/nu_spline.hpp>

namespace seamwright {

/// The n + 1 points to interpolate, and the joints of the segments. Every segment has an interval
/// of length 1.
struct BetaSplineData {
  Poles points;
  /// n + 1 entries each. At joint j, X'(-) = bias_j X'(+) and X''(-) = bias_j^2 X''(+) + tension_j
  /// X'(+). Entry 0, and for an open spline entry n, have no effect but must be finite. The curve
  /// tightens for tension -> -infinity.
  std::vector<double> bias;
  std::vector<double> tension;
  SplineEnds ends = SplineEnds::Natural;
  double start_nu = 0, end_nu = 0;  ///< natural ends: X'' = start_nu X', X'' = -end_nu X'
  Eigen::Vector3d start_derivative = Eigen::Vector3d::Zero();
  Eigen::Vector3d end_derivative = Eigen::Vector3d::Zero();
};

struct BetaSpline {
  /// The curve with knots by which it is C1, as far as knots can represent the lengths: h_{j+1} =
  /// h_j / bias_j, and the first length is 1. Knots are sums of lengths, so decreasing lengths lose
  /// digits, and continuity() may find 0. The curve stays G2, because its poles do not depend on
  /// the knots. For reversed points with inverse biases the lengths increase. In a periodic spline
  /// the product of the biases may differ from 1; then the curve is G2 and not C1 at its seam.
  BezierSpline curve;
  Poles derivatives;  ///< m_j = X'(+) at the points by the parameter of a segment, n + 1 rows
  std::vector<int> stationary;  ///< as NuSpline::stationary
};

/// The interpolating beta-spline. It is G2 at all joints where X' != 0.
///
/// Open beta-splines are nu-splines with nu_j = -tension_j / (bias_j h_j). A periodic spline whose
/// product of biases differs from 1 may have no solution (for example all biases (3 + sqrt 5) / 2,
/// no tension, n even). The cyclic system is solved with pivoting in O(n) and judged by its
/// condition.
///
/// Identities (each has a test of its number):
///   (1) Both equations of every joint.
///   (2) The end conditions.
///   (3) bias = 1, tension = 0: the C2 cubic spline with uniform knots.
///   (4) An open beta-spline equals the nu-spline above.
/// \throws as nuSpline() does, and std::invalid_argument, with the index, for a bias that is not
/// positive, and if the lengths decrease so much that the knots do not increase.
/// Source: docs/theory/curves.md C7.1 to C7.3; [BarskyBeatty1983].
BetaSpline betaSpline(const BetaSplineData& data);

}  // namespace seamwright
