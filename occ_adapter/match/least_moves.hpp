// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <unordered_map>
#include <vector>

/// Conditions on the moves of points, by least squares; not a public header.
namespace seamwright::occ {

/// A point a row.
using PointRows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

class LeastMoves {
 public:
  explicit LeastMoves(int points) : unknowns_(3 * points) {}

  /// That move is given; before the rows that hold the point.
  void fix(int point, const Eigen::Vector3d& move);

  /// direction . (sum of factor times move) = value. A factor is of the point of the same place in the list.
  void add(const std::vector<int>& points, const Eigen::RowVectorXd& factors,
           const Eigen::Vector3d& direction, double value);

  /// The least sum of the squares of the rows' residuals and, \p damping times, of the moves.
  PointRows solve(double damping) const;

 private:
  int unknowns_;
  std::unordered_map<int, double> fixed_;
  std::vector<Eigen::Triplet<double>> entries_;
  std::vector<double> values_;
};

}  // namespace seamwright::occ
