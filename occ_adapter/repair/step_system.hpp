// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/occ_adapter/deform/block_cholesky.hpp>

/// Solves one Gauss-Newton step for points in space. Not a public header.
namespace seamwright::occ {

/// Minimises the sum of squares of conditions that are linear in the steps of points. Each
/// condition belongs to a cell: a set of points that may occur together in one condition. The
/// sparsity pattern is analysed once; the conditions may differ for each solution.
class StepSystem {
 public:
  /// \param cells numbers of points, from 0, increasing.
  StepSystem(int points, std::vector<std::vector<int>> cells);

  const std::vector<int>& cell(int number) const { return cells_[number]; }
  /// Removes all conditions.
  void clear();
  /// Adds (direction . sum of factor times step - value)^2. \param factors one for each point of
  /// the cell.
  void add(int cell, const Eigen::VectorXd& factors, const Eigen::Vector3d& direction,
           double value);
  /// Adds |sum of factor times step - value|^2.
  void addPoint(int cell, const Eigen::VectorXd& factors, const Eigen::Vector3d& value);
  /// Adds the sum over x, y, z of (step + at)^T matrix (step + at), where \p gradient = matrix at.
  void addEnergy(int cell, const Eigen::MatrixXd& matrix, const PointRows& gradient);

  /// Adds factor |step + at|^2.
  void addDamping(int point, double factor, const Eigen::Vector3d& at);

  /// Adds that share of its diagonal to the normal matrix. Steps become shorter, most of all those
  /// that the conditions hardly determine (Levenberg-Marquardt).
  void damp(double share);

  /// Returns the step by point. Where rounding hides that the normal matrix is positive definite,
  /// its diagonal is raised by the size of the rounding. The step is zero if the normal matrix is
  /// zero or not finite.
  PointRows solve();

 private:
  template <class Take>
  void forPairs(int cell, const Eigen::VectorXd& factors, const Take& take);

  std::vector<std::vector<int>> cells_;
  /// By cell and pair of its points, row by row of the lower triangle: index of the block.
  std::vector<std::vector<int>> positions_;
  BlockCholesky cholesky_;
  std::vector<int> diagonal_;  ///< by point: index of its block
  std::vector<SymmetricBlock> blocks_;
  PointRows right_;
};

}  // namespace seamwright::occ
