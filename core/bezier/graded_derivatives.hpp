// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>

/// Derivatives of rational curves that weights of very different size do not make parallel; not a
/// public header.
namespace seamwright {

/// value 2^exponent, off by at most error 2^exponent in length.
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

/// Derivatives of orders 1, 2, 3, ... at a point by a parameter of their own, of which a multiple
/// of the lower ones is taken away: span and determinant of the first k are those of X', ...,
/// X^(k).
///
/// With d, d', d'' the first three there is a parameter by which the derivatives of X are d, d' and
/// d'' + shift d' + (...) d. So curvature changes by the arc length at the rate
/// kappa / |d| ((d x d').(d x d'') / |d x d'|^2 - 3 d.d' / |d|^2 + shift).
struct GradedDerivatives {
  std::vector<GradedVector> by_order;  ///< that of order k at k - 1
  GradedNumber shift;                  ///< known from order 3 on
  GradedNumber rate;                   ///< ds / dt
};

/// With z = t / (1 - t) the curve is sum_i g_i P_i / sum_i g_i, g_i = C(n, i) w_i z^i, and by s =
/// log z the differential operator (d/ds - p) multiplies the term of g_i by i - p, without
/// rounding. The derivative of order k is
///
///     sum_i g_i (i - p_0) ... (i - p_(k-1)) (P_i - X) / sum_i g_i
///
/// with p_j the index of the largest term of order j. So the pole p_j counts in no order above j:
/// rounding in the order k acts like a movement of pole p_k by a few units in the last place of its
/// distance to the others. That is backward stable whatever the weights. Derivatives by t are not:
/// where one weight exceeds the others by 10^7, X', X'' and X''' are parallel to 10^-7 and more,
/// and torsion is what is left of them.
/// Source: docs/theory/curves.md C1.3.
/// \param t finite; outside [0, 1] the weights may cancel, which the errors include.
/// \throws std::invalid_argument if a pole or the point is beyond the range of a double.
GradedDerivatives gradedDerivatives(const HomogeneousPoles& poles, double t, int order);

/// Derivatives by a parameter a of the curve's own that increases with t, of speed 1 / n to 1.
struct OwnDerivatives {
  CurveDerivatives derivatives;  ///< orders 0..n, (n+1) by 3; the point is left out: row 0 is 0
  double speed_noise = 0;        ///< bound of the error of the first
};

/// In powers of a the curve is sum_i share_i (1 + a)^x_i (P_i - X) over its weight, x_i = (i - p_0)
/// / (p_1 - p_0): of order 1 in a for the pole p_1, of order 0 for p_0. The parameter is a / (1 +
/// turn a), by which the weight has no first derivative. So higher derivatives hold nothing along
/// the first that uneven weights make large, and the derivatives by arc length that
/// arcLengthDerivatives() makes of them keep their digits.
/// \throws std::invalid_argument as gradedDerivatives().
OwnDerivatives ownDerivatives(const HomogeneousPoles& poles, double t, int order);

}  // namespace seamwright
