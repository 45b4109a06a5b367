// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bezier/curve.hpp>

/// Blossoms of B-spline curves; not a public header.
namespace seamwright::bspline {

/// The combination x + share (y - x). It is exact for the shares 0 and 1, and it is x itself where
/// x = y. So weights of 1 stay 1.
inline Eigen::RowVector4d between(const Eigen::RowVector4d& x, const Eigen::RowVector4d& y,
                                  double share) {
  if (share <= 0.5) return x + share * (y - x);
  return y - (1 - share) * (y - x);
}

/// The blossom of the polynomial that a B-spline curve is on one span, by de Boor's algorithm. It
/// takes as many arguments as the degree n. Arguments in the span combine the poles convexly.
/// Arguments that are knots give shares of 0 or 1, so the poles that do not contribute drop out
/// exactly.
/// \param poles the n + 1 poles of the span.
/// \param knots the n knots before the span and the n after it: the span lies between knots[n - 1]
/// < knots[n].
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
