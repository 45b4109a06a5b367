// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include <seamwright/core/fair/span_maps.hpp>

namespace seamwright {

namespace {

/// The shares of the poles in the blossom whose first arguments, as many as said, are the end of
/// the span and the others its start: de Boor's algorithm from its result back to the poles.
Eigen::RowVectorXd blossomShares(int degree, const double* knots, int at_end) {
  const double from = knots[degree - 1], to = knots[degree];
  Eigen::RowVectorXd shares = Eigen::RowVectorXd::Zero(degree + 1);
  shares(degree) = 1;
  for (int r = degree; r >= 1; --r) {
    const double argument = r <= at_end ? to : from;
    for (int j = r; j <= degree; ++j) {
      const double left = knots[j - 1], right = knots[degree + j - r];
      const double share = shares(j);
      shares(j - 1) += share * ((right - argument) / (right - left));
      shares(j) = share * ((argument - left) / (right - left));
    }
  }
  return shares;
}

}  // namespace

Eigen::MatrixXd bezierMap(int degree, const std::vector<double>& knots, int span) {
  Eigen::MatrixXd map(degree + 1, degree + 1);
  for (int i = 0; i <= degree; ++i)
    map.row(i) = blossomShares(degree, knots.data() + span - degree + 1, i);
  return map;
}

Eigen::MatrixXd bernsteinDerivatives(int degree, double t) {
  // Row 0 of the degree degree - order has the values; their differences are the derivatives.
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(4, degree + 1);
  Eigen::RowVectorXd values = Eigen::RowVectorXd::Ones(1);
  for (int n = 0;; ++n) {
    if (const int order = degree - n; order <= 3) {
      Eigen::RowVectorXd row = values;
      for (int m = n + 1; m <= degree; ++m) {
        Eigen::RowVectorXd raised = Eigen::RowVectorXd::Zero(m + 1);
        raised.tail(m) += m * row;
        raised.head(m) -= m * row;
        row = std::move(raised);
      }
      result.row(order) = row;
    }
    if (n == degree) return result;
    Eigen::RowVectorXd raised = Eigen::RowVectorXd::Zero(n + 2);
    raised.head(n + 1) += (1 - t) * values;
    raised.tail(n + 1) += t * values;
    values = std::move(raised);
  }
}

}  // namespace seamwright
