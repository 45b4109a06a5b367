// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>

/// Quadratic forms of the poles of B-spline curves; not a public header.
namespace seamwright {

/// The symmetric matrix of the integrals of N_i^(order) N_j^(order) over all spans, exact up to
/// rounding: Gauss quadrature with degree + 1 - order nodes in each span. It has 2 degree + 1
/// diagonals.
Eigen::SparseMatrix<double> derivativeProducts(int degree, const std::vector<double>& knots,
                                               int order);

/// derivativeProducts() times the poles, by differences of the poles. Its component along
/// polynomials of a degree below the order, which is 0, has rounding of the size of the derivative
/// only, not of the size of the poles.
Poles derivativeGradient(int degree, const std::vector<double>& knots, int order,
                         const Poles& poles);

/// The basis functions at parameters: one row each.
Eigen::SparseMatrix<double> basisAt(int degree, const std::vector<double>& knots,
                                    const std::vector<double>& parameters);

}  // namespace seamwright
