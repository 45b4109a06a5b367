// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <unordered_map>
#include <vector>

/// Conditions on the moves of points, by least squares; not a public header.
namespace seamwright::occ {

/// A point a row.
using PointRows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Work and memory grow with the pairs of points that stand in a condition together.
class LeastMoves {
 public:
  explicit LeastMoves(int points) : points_(points) {}

  /// That move is given; before the conditions that hold the point.
  void fix(int point, const Eigen::Vector3d& move);

  /// For each row of factors: direction . (sum of factor times move) = value. A column of the factors is of the point of the same place in
  /// the list.
  void add(const std::vector<int>& points, const Eigen::MatrixXd& factors, const Eigen::Vector3d& direction,
           const Eigen::VectorXd& values);
  /// Sum of factor times move = value.
  void addPoint(const std::vector<int>& points, const Eigen::RowVectorXd& factors,
                const Eigen::Vector3d& value);

  /// The least sum of the squares of the conditions' residuals and, \p damping times, of the moves.
  PointRows solve(double damping) const;

 private:
  /// Conditions of some points: along one direction, a value each, or one condition in all three coordinates.
  struct Group {
    std::vector<int> points;
    Eigen::MatrixXd factors;
    bool is_point = false;
    Eigen::Vector3d direction;  ///< of a point: its value
    Eigen::VectorXd values;     ///< of a point: none
  };
  struct Normal;

  void takeOutFixed(Group& group) const;
  Normal normalMatrix() const;
  PointRows pulled(const PointRows& moves) const;

  int points_;
  std::unordered_map<int, Eigen::Vector3d> fixed_;
  std::vector<Group> groups_;
};

}  // namespace seamwright::occ
