// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

/// Bézier poles of the spans of a B-spline curve; not a public header.
namespace seamwright {

/// What makes the Bézier poles of a span from the degree + 1 poles of the spline that it depends
/// on: row i has the shares of the Bézier pole i, which are not negative and have the sum 1 up to
/// rounding.
/// \pre knots[span] < knots[span + 1]
/// Source: docs/theory/planar.md P11.4.
Eigen::MatrixXd bezierMap(int degree, const std::vector<double>& knots, int span);

/// The derivatives of the orders 0 to 3 of the Bernstein polynomials of a degree at a parameter in
/// [0, 1]: one row for each order.
Eigen::MatrixXd bernsteinDerivatives(int degree, double t);

}  // namespace seamwright
