// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

/// Symmetric equations with a band; not a public header.
namespace seamwright::linear {

/// A symmetric matrix whose entries further than the width from the diagonal are 0.
class SymmetricBand {
 public:
  SymmetricBand() = default;
  SymmetricBand(Eigen::Index size, Eigen::Index width)
      : lower_(Eigen::MatrixXd::Zero(width + 1, size)) {}

  Eigen::Index size() const { return lower_.cols(); }
  Eigen::Index width() const { return lower_.rows() - 1; }

  /// \pre column <= row <= column + width
  double operator()(Eigen::Index row, Eigen::Index column) const {
    return lower_(row - column, column);
  }
  double& operator()(Eigen::Index row, Eigen::Index column) { return lower_(row - column, column); }

  Eigen::VectorXd diagonal() const { return lower_.row(0).transpose(); }
  /// \pre the other matrix has the same size and width.
  void add(double factor, const SymmetricBand& other) { lower_ += factor * other.lower_; }
  /// The rows and columns from the first one on.
  SymmetricBand block(Eigen::Index first, Eigen::Index count) const;
  /// One column for each column of the factor.
  Eigen::MatrixXd times(const Eigen::MatrixXd& factor) const;

 private:
  Eigen::MatrixXd lower_;  ///< column j: the entries (j, j), (j + 1, j), ...
};

/// The decomposition L D L' of a positive definite matrix, without pivots: O(size width^2).
class BandCholesky {
 public:
  explicit BandCholesky(SymmetricBand matrix);

  /// Whether all pivots are above 0. If not, nothing can be solved.
  bool positive() const { return positive_; }
  double leastPivot() const { return factor_.diagonal().minCoeff(); }
  double largestPivot() const { return factor_.diagonal().maxCoeff(); }
  /// \pre positive()
  Eigen::MatrixXd solve(Eigen::MatrixXd right) const;

 private:
  SymmetricBand factor_;  ///< D on the diagonal, L below
  bool positive_ = true;
};

}  // namespace seamwright::linear
