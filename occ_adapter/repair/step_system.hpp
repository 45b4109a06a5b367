// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/occ_adapter/deform/block_cholesky.hpp>

/// One step of a Gauss-Newton method for points in space; not a public header.
namespace seamwright::occ {

/// The least sum of squares of conditions that are linear in the steps of points. Conditions are
/// added by cells: sets of points that may stand in one condition. Which points hang together is
/// analysed once; the conditions may be other ones for each solution.
class StepSystem {
 public:
  /// \param cells points from 0, increasing.
  StepSystem(int points, std::vector<std::vector<int>> cells);

  const std::vector<int>& cell(int number) const { return cells_[number]; }
  /// No condition.
  void clear();
  /// (direction . sum of factor times step - value)^2. \param factors one for each point of the
  /// cell.
  void add(int cell, const Eigen::VectorXd& factors, const Eigen::Vector3d& direction,
           double value);
  /// |sum of factor times step - value|^2
  void addPoint(int cell, const Eigen::VectorXd& factors, const Eigen::Vector3d& value);
  /// The sum over coordinates of (step + at)^T matrix (step + at), where \p pull = matrix at.
  void addEnergy(int cell, const Eigen::MatrixXd& matrix, const PointRows& pull);

  /// factor |step + at|^2
  void addDamping(int point, double factor, const Eigen::Vector3d& at);

  /// Adds that share of the diagonal of the normal matrix to it: steps become shorter, first those
  /// that conditions hardly tell (Levenberg and Marquardt).
  void damp(double share);

  /// Where rounding hides that the normal matrix is positive definite its diagonal is raised by as
  /// much. No step where it is zero or not finite.
  PointRows solve();

 private:
  template <class Take>
  void forPairs(int cell, const Eigen::VectorXd& factors, const Take& take);

  std::vector<std::vector<int>> cells_;
  std::vector<std::vector<int>>
      places_;  ///< by cell and pair of its points, row by row below the diagonal: the block
  BlockCholesky cholesky_;
  std::vector<int> diagonal_;  ///< by point: its block
  std::vector<SymmetricBlock> blocks_;
  PointRows right_;
};

}  // namespace seamwright::occ
