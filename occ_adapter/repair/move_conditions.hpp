// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/occ_adapter/match/least_moves.hpp>

/// Conditions on the poles of a surface, some of which stay; not a public header.
namespace seamwright::occ {

/// Conditions on all moves since the original.
class MoveConditions {
 public:
  /// \param unknown the number of each pole's move, -1: it stays; poles with one number move as one.
  /// \param start the original, but poles that stay as they are by now. All must outlive this.
  MoveConditions(const std::vector<int>& unknown, int count, const PointRows& original,
                 const PointRows& start)
      : unknown_(unknown), original_(original), start_(start), system_(count) {}

  /// One of the poles may move.
  bool canChange(const std::vector<int>& poles) const;

  /// Sum of share times pole = point
  void addPoint(const std::vector<int>& poles, const Eigen::RowVectorXd& share, const Eigen::Vector3d& point,
                double weight);
  /// For each row of shares: normal . (sum of share times pole) = value
  void add(const std::vector<int>& poles, const Eigen::MatrixXd& shares, const Eigen::Vector3d& normal,
           const Eigen::VectorXd& values, double weight);
  /// The sum of factor times move is zero; softness of solve() times.
  void addFairness(const std::vector<int>& poles, const Eigen::RowVectorXd& factors, double weight);

  /// Moves by number, see LeastMoves.
  PointRows solve(double damping, double softness) const { return system_.solve(damping, softness); }

 private:
  struct Selected {
    std::vector<int> numbers;
    Eigen::MatrixXd factors;
  };
  Selected select(const std::vector<int>& poles, const Eigen::MatrixXd& factors) const;
  Eigen::Matrix<double, Eigen::Dynamic, 3> sumOf(const std::vector<int>& poles,
                                                 const Eigen::MatrixXd& shares) const;

  const std::vector<int>& unknown_;
  const PointRows& original_;
  const PointRows& start_;
  LeastMoves system_;
};

}  // namespace seamwright::occ
