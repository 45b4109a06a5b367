// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <mutex>

#include <seamwright/core/enclosure/spline_matrices.hpp>

namespace seamwright {

namespace {

using SmallVector =
    Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, max_spline_degree + 1, 1>;

SplineMatrix makeBezierToChebyshev(int degree) {
  SplineMatrix matrix(degree + 1, degree + 1);
  double binomial = 1;
  for (int j = 0; j <= degree; ++j) {
    SmallVector product = SmallVector::Unit(degree + 1, 0);
    for (int factor = 0; factor < degree; ++factor) {
      // x T_0 = T_1, x T_k = (T_(k + 1) + T_(k - 1)) / 2.
      SmallVector by_x = SmallVector::Zero(degree + 1);
      by_x[1] = product[0];
      for (int k = 1; k <= factor; ++k) {
        by_x[k + 1] += 0.5 * product[k];
        by_x[k - 1] += 0.5 * product[k];
      }
      product = 0.5 * (factor < j ? SmallVector(product + by_x) : SmallVector(product - by_x));
    }
    matrix.col(j) = binomial * product;
    binomial = binomial * (degree - j) / (j + 1);
  }
  return matrix;
}

}  // namespace

const SplineMatrix& bezierToChebyshev(int degree) {
  // Most models need few degrees, and the table of a high one takes long.
  static std::array<std::once_flag, max_spline_degree + 1> made;
  static std::array<SplineMatrix, max_spline_degree + 1> tables;
  std::call_once(made[degree], [&] { tables[degree] = makeBezierToChebyshev(degree); });
  return tables[degree];
}

SplineMatrix splineToBezier(const std::vector<double>& knots, int degree, int s) {
  const int n = degree + 1;
  SplineMatrix matrix(n, n);
  for (int j = 0; j < n; ++j) {
    // Column i holds the combination i of a level. Of the poles it has i to i + level.
    SplineMatrix columns = SplineMatrix::Identity(n, n);
    for (int level = 1; level <= degree; ++level) {
      const double argument = level <= degree - j ? knots[s] : knots[s + 1];
      for (int i = 0; i + level <= degree; ++i) {
        const double left = knots[s - degree + level + i];
        const double right = knots[s + 1 + i];
        if (argument == left) continue;  // the factors are 1 and 0
        const auto own = [&](int column) { return columns.col(column).segment(i, level + 1); };
        if (argument == right)
          own(i) = own(i + 1);
        else
          own(i) = ((right - argument) / (right - left)) * own(i) +
                   ((argument - left) / (right - left)) * own(i + 1);
      }
    }
    matrix.row(j) = columns.col(0).transpose();
  }
  return matrix;
}

Eigen::VectorXd derivativeFactors(const std::vector<double>& knots, int degree, int s) {
  Eigen::VectorXd factors(degree);
  for (int i = 0; i < degree; ++i)
    factors[i] = degree / (knots[s + 1 + i] - knots[s - degree + 1 + i]);
  return factors;
}

}  // namespace seamwright
