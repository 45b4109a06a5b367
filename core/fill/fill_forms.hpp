// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <seamwright/core/join/bernstein_rows.hpp>

/// Polynomials whose coefficients are combinations of unknown points; not a public header.
namespace seamwright::fill {

/// Bernstein coefficients of a polynomial, or poles of a row of a net; one per matrix row.
using Forms = Eigen::MatrixXd;

inline Forms derivative(const Forms& polynomial) {
  const Eigen::Index n = polynomial.rows() - 1;
  return static_cast<double>(n) * (polynomial.bottomRows(n) - polynomial.topRows(n));
}

inline Forms elevated(const Forms& polynomial, int to) {
  return rows::elevation(static_cast<int>(polynomial.rows()) - 1, to) * polynomial;
}

/// Factor times polynomial.
inline Forms product(const Eigen::VectorXd& factor, const Forms& polynomial) {
  const Eigen::Index n = polynomial.rows() - 1;
  Forms result = Forms::Zero(n + factor.size(), polynomial.cols());
  for (Eigen::Index j = 0; j <= n; ++j) {
    const Eigen::VectorXd column = rows::times(factor, Eigen::VectorXd::Unit(n + 1, j));
    for (Eigen::Index i = j; i < j + factor.size(); ++i)
      result.row(i) += column(factor.size() == 1 ? j : i) * polynomial.row(j);
  }
  return result;
}

}  // namespace seamwright::fill
