// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <utility>

/// De Casteljau's algorithm on rows of coefficients; shared by curves and patches, not a public
/// header.
namespace seamwright::casteljau {

/// Coefficients in Bernstein form, one per row: (degree + 1) by any number of columns.
template <int Columns>
using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, Columns, Eigen::RowMajor>;

/// Value and derivatives, one per row. \p Count is their number, or Eigen::Dynamic.
template <int Columns, int Count>
using Derivatives = Eigen::Matrix<double, Count, Columns, Eigen::RowMajor>;

/// Returns the value at t; overwrites the coefficients.
template <int Columns>
Eigen::Matrix<double, 1, Columns> collapse(Coefficients<Columns>& c, double t) {
  for (Eigen::Index rows = c.rows() - 1; rows > 0; --rows)
    for (Eigen::Index i = 0; i < rows; ++i) c.row(i) = (1 - t) * c.row(i) + t * c.row(i + 1);
  return c.row(0);
}

/// The value and the derivatives of orders 0..count - 1. The k-th derivative is n!/(n-k)! times the
/// Bernstein form of the k-th differences.
template <int Columns, int Count>
Derivatives<Columns, Count> derivatives(const Coefficients<Columns>& coefficients, double t,
                                        Eigen::Index count = Count) {
  using Result = Derivatives<Columns, Count>;
  Result result = Result::Zero(count, coefficients.cols());
  Coefficients<Columns> differences = coefficients;
  double factor = 1;
  for (Eigen::Index order = 0; order < count && order < coefficients.rows(); ++order) {
    Coefficients<Columns> work = differences;
    result.row(order) = factor * collapse<Columns>(work, t);
    const Eigen::Index rows = differences.rows() - 1;
    factor *= static_cast<double>(rows);
    differences = (differences.bottomRows(rows) - differences.topRows(rows)).eval();
  }
  return result;
}

/// The two edges of de Casteljau's triangle: the coefficients over [0, t] and over [t, 1].
template <int Columns>
std::pair<Coefficients<Columns>, Coefficients<Columns>> split(
    const Coefficients<Columns>& coefficients, double t) {
  Coefficients<Columns> left(coefficients.rows(), coefficients.cols());
  Coefficients<Columns> right = coefficients;
  for (Eigen::Index k = 0; k < coefficients.rows(); ++k) {
    left.row(k) = right.row(0);
    for (Eigen::Index i = 0; i + 1 < coefficients.rows() - k; ++i)
      right.row(i) = (1 - t) * right.row(i) + t * right.row(i + 1);
  }
  return {left, right};
}

}  // namespace seamwright::casteljau
