// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <seamwright/core/join/bernstein_rows.hpp>

/// Polynomials in Bernstein form whose coefficients are combinations of vectors; not a public
/// header.
namespace seamwright::umbrella {

/// Vectors as combinations, one per row: first the coefficients of the free vectors, then the
/// constant vector.
using Forms = Eigen::MatrixXd;

inline Forms times(const Eigen::VectorXd& factor, const Forms& field) {
  const int degree = rows::degree(field);
  Eigen::MatrixXd matrix(degree + factor.size(), degree + 1);
  for (int j = 0; j <= degree; ++j)
    matrix.col(j) = rows::times(factor, Eigen::VectorXd::Unit(degree + 1, j));
  return matrix * field;
}

inline Forms elevated(const Forms& field, int degree) {
  return rows::elevation(rows::degree(field), degree) * field;
}

inline Forms derivative(const Forms& field) {
  const int n = rows::degree(field);
  if (n == 0) return Forms::Zero(1, field.cols());
  return n * (field.bottomRows(n) - field.topRows(n));
}

}  // namespace seamwright::umbrella
