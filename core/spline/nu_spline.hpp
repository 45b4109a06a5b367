// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

enum class SplineEnds {
  Natural,   ///< X'' = nu_0 X' at the beginning, X'' = -nu_n X' at the end; nu = 0 there: X'' = 0
  Clamped,   ///< the end derivatives are given
  Periodic,  ///< the last point is the first one, and a joint
};

/// Points to interpolate, n + 1 of them, and how.
struct NuSplineData {
  Poles points;
  std::vector<double> knots;  ///< n + 1, increasing
  std::vector<double> nu;     ///< n + 1 tensions; those of clamped ends change nothing
  SplineEnds ends = SplineEnds::Natural;
  Eigen::Vector3d start_derivative = Eigen::Vector3d::Zero();  ///< by the parameter, clamped ends
  Eigen::Vector3d end_derivative = Eigen::Vector3d::Zero();
};

struct NuSpline {
  BezierSpline curve;
  Poles derivatives;  ///< X' at the points, n + 1 rows
  /// Points where the first derivative is within rounding of zero, or a pole beside the point is it
  /// but for rounding: G2 is lost there. Where derivatives are small but not lost, the poles'
  /// rounding, eps |X| / |pole - X|, still goes into what can be measured of a joint: little of its
  /// tangent is left from tensions of some 1e13.
  std::vector<int> stationary;
};

/// Nielson's nu-spline: the piecewise cubic through the points that is C1 with X''(+) - X''(-) =
/// nu_i X' at point i, so G2 wherever X' != 0. nu = 0 is the C2 cubic spline; nu -> infinity runs
/// into the polygon.
///
/// One tridiagonal system (periodic: one with two corners) in O(n), without pivoting where it is
/// diagonally dominant, which all nu > -2 (1 / h_i + 1 / h_{i+1}) are; with pivoting otherwise.
/// Tensions of any size to 1e300 are solved with the relative accuracy of the derivatives.
///
/// Identities (each has a test of its number):
///   (1) X''(+) - X''(-) = nu_i X' at every inner point, and at the seam of a periodic one with
///       nu_0 + nu_n.
///   (2) The end conditions.
///   (3) nu = 0: the C2 cubic spline of the same ends.
///   (4) Points in reverse order give the curve run backwards.
///   (5) nu -> infinity: the distance to the polygon goes to 0 with 1 / nu.
///   (6) A knot vector multiplied by c with nu divided by c: the same curve.
/// \throws std::invalid_argument for fewer than 2 points (periodic: 3), wrong counts, knots that do
/// not increase or whose range is no normal number, neighbours that are the same point, a last
/// point of a periodic one other than the first, numbers that are not finite; with index and value.
/// std::domain_error if the system is singular (reciprocal condition below 1e-12), with number and
/// size of the smallest pivot.
/// Source: docs/theory/curves.md C6.1 to C6.4; [Nielson1974].
NuSpline nuSpline(const NuSplineData& data);

/// Knots for points: 0, then growing by |P_i - P_{i-1}|^exponent. 0: uniform, 1/2: centripetal, 1:
/// chord length.
/// \throws std::invalid_argument for an exponent outside 0..1, and for neighbours that are the same
/// point unless it is 0; with the index. Also where a step is lost in the rounding of the knots
/// before it.
std::vector<double> knotsOf(const Poles& points, double exponent = 0.5);

}  // namespace seamwright
