// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bezier/curve.hpp>

/// Blossoms of B-spline curves; not a public header.
namespace seamwright::bspline {

/// x + share (y - x): exact for the shares 0 and 1, and x itself where x = y, which keeps weights
/// 1.
inline Eigen::RowVector4d between(const Eigen::RowVector4d& x, const Eigen::RowVector4d& y,
                                  double share) {
  if (share <= 0.5) return x + share * (y - x);
  return y - (1 - share) * (y - x);
}

/// The blossom, at as many arguments as the degree n, of the polynomial that a B-spline curve is on
/// one span (de Boor's algorithm). \param poles the n + 1 of the span; \param knots the n before it
/// and the n after it, the span lying between knots[n - 1] < knots[n]. Arguments in the span
/// combine the poles convexly; those that are knots leave out whatever they can, exactly.
inline Eigen::RowVector4d blossom(HomogeneousPoles poles, const double* knots,
                                  const double* arguments) {
  const Eigen::Index n = poles.rows() - 1;
  for (Eigen::Index r = 1; r <= n; ++r)
    for (Eigen::Index j = n; j >= r; --j) {
      const double left = knots[j - 1], right = knots[n + j - r];
      poles.row(j) =
          between(poles.row(j - 1), poles.row(j), (arguments[r - 1] - left) / (right - left));
    }
  return poles.row(n);
}

}  // namespace seamwright::bspline
