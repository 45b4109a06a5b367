// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

enum class SplineEnds {
  Natural,   ///< X'' = nu_0 X' at the beginning, X'' = -nu_n X' at the end; nu = 0 there: X'' = 0
  Clamped,   ///< the end derivatives are given
  Periodic,  ///< the last point equals the first one, which is a joint
};

/// The n + 1 points to interpolate, and the parameters of the spline.
struct NuSplineData {
  Poles points;
  std::vector<double> knots;  ///< n + 1, increasing
  std::vector<double> nu;     ///< n + 1 tensions; those of clamped ends have no effect
  SplineEnds ends = SplineEnds::Natural;
  /// By the parameter, for clamped ends.
  Eigen::Vector3d start_derivative = Eigen::Vector3d::Zero();
  Eigen::Vector3d end_derivative = Eigen::Vector3d::Zero();
};

struct NuSpline {
  BezierSpline curve;
  Poles derivatives;  ///< X' at the points, n + 1 rows
  /// Indices of the points at which the first derivative is zero up to rounding, or at which a pole
  /// beside the point equals the point up to rounding. G2 is lost there. At small derivatives that
  /// are not lost, the rounding of the poles, eps |X| / |pole - X|, still limits what can be
  /// measured at a joint: from tensions of about 1e13 on little of its tangent remains.
  std::vector<int> stationary;
};

/// Nielson's nu-spline: the piecewise cubic through the points that is C1 with X''(+) - X''(-) =
/// nu_i X' at point i, so it is G2 wherever X' != 0. nu = 0 gives the C2 cubic spline. For nu ->
/// infinity the curve approaches the polygon.
///
/// One tridiagonal system (periodic: with two corner entries) is solved in O(n). It is solved
/// without pivoting if it is diagonally dominant, as for all nu > -2 (1 / h_i + 1 / h_{i+1}), and
/// with pivoting otherwise. For tensions up to 1e300 the derivatives keep their relative accuracy.
///
/// Identities (each has a test of its number):
///   (1) X''(+) - X''(-) = nu_i X' at every inner point, and with nu_0 + nu_n at the seam of a
///       periodic spline.
///   (2) The end conditions.
///   (3) nu = 0: the C2 cubic spline with the same ends.
///   (4) Points in reverse order give the reversed curve.
///   (5) nu -> infinity: the distance to the polygon goes to 0 with 1 / nu.
///   (6) A knot vector multiplied by c with nu divided by c: the same curve.
/// \throws std::invalid_argument, with index and value, for fewer than 2 points (periodic: 3),
/// wrong counts, knots that do not increase or whose range is not a normal number, equal
/// neighbouring points, a periodic spline whose last point differs from the first, and numbers that
/// are not finite. Throws std::domain_error if the system is singular (reciprocal condition below
/// 1e-12), with number and size of the smallest pivot.
/// Source: docs/theory/curves.md C6.1 to C6.4; [Nielson1974].
NuSpline nuSpline(const NuSplineData& data);

/// Knots for points: the first is 0, and each step is |P_i - P_{i-1}|^exponent. Exponent 0 gives
/// uniform, 1/2 centripetal and 1 chord-length knots.
/// \throws std::invalid_argument, with the index, for an exponent outside 0..1, for equal
/// neighbouring points unless the exponent is 0, and for a step that is lost in the rounding of the
/// knots before it.
std::vector<double> knotsOf(const Poles& points, double exponent = 0.5);

}  // namespace seamwright
