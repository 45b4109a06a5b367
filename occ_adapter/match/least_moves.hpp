// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include <seamwright/occ_adapter/deform/block_cholesky.hpp>

/// Conditions on the moves of points, by least squares; not a public header.
namespace seamwright::occ {

/// Work and memory grow with the pairs of points that stand in a condition together.
class LeastMoves {
 public:
  explicit LeastMoves(int points) : points_(points) {}

  /// That move is given; before the conditions that hold the point.
  void fix(int point, const Eigen::Vector3d& move);

  /// For each row of factors: direction . (sum of factor times move) = value. A column of the
  /// factors is of the point of the same place in the list.
  void add(const std::vector<int>& points, const Eigen::MatrixXd& factors,
           const Eigen::Vector3d& direction, const Eigen::VectorXd& values);
  /// Sum of factor times move = value.
  void addPoint(const std::vector<int>& points, const Eigen::RowVectorXd& factors,
                const Eigen::Vector3d& value);

  /// The same, but \p softness of solve() times.
  void addSoft(const std::vector<int>& points, const Eigen::RowVectorXd& factors,
               const Eigen::Vector3d& value);

  /// The least sum of the squares of the conditions' residuals and, \p damping times, of the moves.
  /// Solving again for the same conditions costs less.
  PointRows solve(double damping, double softness = 1) const;

 private:
  /// Conditions of some points: along one direction, a value each, or one condition in all three
  /// coordinates.
  struct Group {
    std::vector<int> points;  ///< they do not decrease
    Eigen::MatrixXd factors;
    bool is_point = false;
    bool is_soft = false;
    Eigen::Vector3d direction;  ///< of a point: its value
    Eigen::VectorXd values;     ///< of a point: none
  };
  /// The blocks of the normal matrix: those of soft conditions are multiples of the unit matrix.
  struct Normal {
    BlockPattern pattern;
    std::vector<SymmetricBlock> blocks;
    std::vector<double> soft;
  };
  struct Prepared {
    Normal normal;
    BlockCholesky factors;
  };

  void addGroup(Group group);
  static void sortPoints(Group& group);
  Normal normalMatrix() const;
  void factor(double damping, double softness) const;
  PointRows pulled(const PointRows& moves, double softness) const;

  int points_;
  std::unordered_map<int, Eigen::Vector3d> fixed_;
  std::vector<Group> groups_;
  mutable std::optional<Prepared>
      prepared_;  ///< for the conditions as they are, once they were solved
};

}  // namespace seamwright::occ
