// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>

/// Derivatives of rational curves that stay independent even if the weights are of very different
/// size; not a public header.
namespace seamwright {

/// The vector value 2^exponent; the length of its error is at most error 2^exponent.
struct GradedVector {
  Eigen::Vector3d value = Eigen::Vector3d::Zero();  ///< largest component in [0.5, 1), or 0
  double error = 0;
  int exponent = 0;
};

struct GradedNumber {
  double value = 0;
  double error = 0;
  int exponent = 0;
};

/// Derivatives of orders 1, 2, 3, ... at a point by a parameter that belongs to the method.
/// Multiples of lower derivatives are subtracted. The first k derivatives have the same span and
/// determinant as X', ..., X^(k).
///
/// Let d, d', d'' be the first three. There is a parameter by which the derivatives of X are d, d'
/// and d'' + shift d' + (...) d. So the change of curvature by arc length is
/// kappa / |d| ((d x d').(d x d'') / |d x d'|^2 - 3 d.d' / |d|^2 + shift).
struct GradedDerivatives {
  std::vector<GradedVector> by_order;  ///< the derivative of order k is at index k - 1
  GradedNumber shift;                  ///< known if order 3 is included
  GradedNumber rate;                   ///< ds / dt
};

/// With z = t / (1 - t) the curve is sum_i g_i P_i / sum_i g_i, g_i = C(n, i) w_i z^i. By s = log z
/// the differential operator (d/ds - p) multiplies the term of g_i by i - p, without rounding. The
/// derivative of order k is
///
///     sum_i g_i (i - p_0) ... (i - p_(k-1)) (P_i - X) / sum_i g_i
///
/// with p_j the index of the largest term of order j. So the pole p_j does not enter the orders
/// above j. Rounding in the order k acts like a movement of pole p_k by a few units in the last
/// place of its distance to the others. This is backward stable for all weights. Derivatives by t
/// are not: where one weight exceeds the others by a factor 10^7, X', X'' and X''' are parallel
/// within 10^-7 or less, and the torsion is what remains after cancellation.
/// Source: docs/theory/curves.md C1.3.
/// \param t finite; outside [0, 1] the weights may cancel, which the errors include.
/// \throws std::invalid_argument if a pole or the point is beyond the range of a double.
GradedDerivatives gradedDerivatives(const HomogeneousPoles& poles, double t, int order);

/// Derivatives by a parameter a that belongs to the curve. a increases with t, and its speed is 1 /
/// n to 1.
struct OwnDerivatives {
  CurveDerivatives derivatives;  ///< orders 0..n, (n+1) by 3; the point is left out: row 0 is 0
  double speed_noise = 0;        ///< bound of the error of the first derivative
};

/// In powers of a the curve is sum_i share_i (1 + a)^x_i (P_i - X), divided by its weight, with x_i
/// = (i - p_0) / (p_1 - p_0). The term of pole p_1 is of order 1 in a, that of p_0 of order 0. The
/// parameter is a / (1 + turn a), by which the weight has no first derivative. So higher
/// derivatives have no component along the first derivative that uneven weights make large. The
/// derivatives by arc length that arcLengthDerivatives() computes from them keep their digits.
/// \throws std::invalid_argument as gradedDerivatives() does.
OwnDerivatives ownDerivatives(const HomogeneousPoles& poles, double t, int order);

}  // namespace seamwright
