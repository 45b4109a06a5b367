// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <algorithm>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/linear/symmetric_band.hpp>

/// Quadratic forms of the poles of B-spline curves; not a public header.
namespace seamwright {

/// The order of the derivative that the energy of a curve of a degree squares.
inline int energyOrder(int degree) {
  return std::min(3, degree);
}

/// The symmetric matrix of the integrals of N_i^(order) N_j^(order) over all spans, exact up to
/// rounding: Gauss quadrature with degree + 1 - order nodes in each span. Its width is the degree.
linear::SymmetricBand derivativeProducts(int degree, const std::vector<double>& knots, int order);

/// The symmetric matrix of the sums of N_i N_j over parameters. Its width is the degree.
linear::SymmetricBand valueProducts(int degree, const std::vector<double>& knots,
                                    const std::vector<double>& parameters);

/// The basis functions at parameters: one row each.
Eigen::SparseMatrix<double> basisAt(int degree, const std::vector<double>& knots,
                                    const std::vector<double>& parameters);

/// The integral of |P^(order)|^2 of splines P with given knots. Values and gradients are formed by
/// differences of the poles, so polynomials of a degree below the order, which have none, add
/// rounding of the size of the derivative only, not of the size of the poles.
class SplineEnergy {
 public:
  SplineEnergy(int degree, const std::vector<double>& knots, int order);

  double of(const Poles& poles) const;
  /// Half of the derivatives by the poles: products() times the poles.
  Poles gradient(const Poles& poles) const;
  const linear::SymmetricBand& products() const { return products_; }

 private:
  Poles derivative(Poles poles) const;

  std::vector<Eigen::VectorXd> factors_;  ///< of the differences of each order
  linear::SymmetricBand products_;
  linear::SymmetricBand inner_products_;  ///< of the poles of the derivative
};

}  // namespace seamwright
