// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <vector>

/// Conditions on the moves of points as rows of a dense matrix, solved by an orthogonal
/// factorisation.
namespace seamwright::test {

struct DenseRows {
  explicit DenseRows(int points) : unknowns(3 * points) {}

  /// direction . sum of factor times move = value
  void add(const std::vector<int>& points, const Eigen::RowVectorXd& factors,
           const Eigen::Vector3d& direction, double value) {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(unknowns);
    for (std::size_t k = 0; k < points.size(); ++k)
      row.segment<3>(3 * points[k]) +=
          factors[static_cast<Eigen::Index>(k)] * direction.transpose();
    rows.push_back(row);
    values.push_back(value);
  }

  /// sum of factor times move = value
  void addPoint(const std::vector<int>& points, const Eigen::RowVectorXd& factors,
                const Eigen::Vector3d& value) {
    for (int c = 0; c < 3; ++c) add(points, factors, Eigen::Vector3d::Unit(c), value[c]);
  }

  Eigen::MatrixXd matrix() const {
    Eigen::MatrixXd all(static_cast<Eigen::Index>(rows.size()), unknowns);
    for (std::size_t r = 0; r < rows.size(); ++r) all.row(static_cast<Eigen::Index>(r)) = rows[r];
    return all;
  }

  /// Half of the gradient of the sum of squares.
  Eigen::VectorXd gradient(const Eigen::VectorXd& at) const {
    const Eigen::Map<const Eigen::VectorXd> right(values.data(),
                                                  static_cast<Eigen::Index>(values.size()));
    return matrix().transpose() * (matrix() * at - right);
  }

  /// \param fixed by unknown, NaN: free. \param damping of each free unknown.
  Eigen::VectorXd solve(const Eigen::VectorXd& fixed, double damping) const {
    std::vector<int> free;
    for (int k = 0; k < unknowns; ++k)
      if (std::isnan(fixed[k])) free.push_back(k);
    const auto count = static_cast<Eigen::Index>(rows.size()),
               columns = static_cast<Eigen::Index>(free.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(count + columns, columns);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(count + columns);
    for (Eigen::Index r = 0; r < count; ++r) {
      a.row(r).head(columns) = rows[r](free);
      b[r] = values[r];
      for (int k = 0; k < unknowns; ++k)
        if (!std::isnan(fixed[k])) b[r] -= rows[r][k] * fixed[k];
    }
    a.bottomRows(columns).diagonal().setConstant(damping);
    const Eigen::VectorXd found = a.colPivHouseholderQr().solve(b);
    Eigen::VectorXd all = fixed;
    for (Eigen::Index k = 0; k < columns; ++k) all[free[k]] = found[k];
    return all;
  }

  Eigen::VectorXd solve() const {
    return matrix().colPivHouseholderQr().solve(
        Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
  }

  int unknowns;
  std::vector<Eigen::RowVectorXd> rows;
  std::vector<double> values;
};

}  // namespace seamwright::test
