// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <utility>

#include <seamwright/core/spline/band_factor.hpp>

/// Not a public header.
namespace seamwright {

/// Tridiagonal equations with one right side, summed up from terms. For a closed curve the first
/// and the last unknown are neighbours.
class TridiagonalEquations {
 public:
  TridiagonalEquations(Eigen::Index count, bool closed)
      : matrix_{.lower = Eigen::VectorXd::Zero(count),
                .diagonal = Eigen::VectorXd::Zero(count),
                .upper = Eigen::VectorXd::Zero(count),
                .scale = Eigen::VectorXd::Ones(count),
                .closed = closed},
        right_(Poles::Zero(count, 3)) {}

  void add(Eigen::Index i, double lower, double diagonal, double upper, double right) {
    matrix_.lower(i) += lower;
    matrix_.diagonal(i) += diagonal;
    matrix_.upper(i) += upper;
    right_(i, 0) += right;
  }

  /// Replaces equation i: the unknown has this value.
  void give(Eigen::Index i, double value) {
    matrix_.lower(i) = matrix_.upper(i) = 0;
    matrix_.diagonal(i) = 1;
    right_(i, 0) = value;
  }

  /// \throws std::domain_error as solveBand() does.
  Eigen::VectorXd solve() && {
    for (Eigen::Index i = 0; i < right_.rows(); ++i) {
      const double size =
          std::abs(matrix_.lower(i)) + std::abs(matrix_.diagonal(i)) + std::abs(matrix_.upper(i));
      matrix_.lower(i) /= size;
      matrix_.diagonal(i) /= size;
      matrix_.upper(i) /= size;
      right_(i, 0) /= size;
    }
    return solveBand(matrix_, std::move(right_)).x.col(0);
  }

 private:
  BandMatrix matrix_;
  Poles right_;
};

}  // namespace seamwright
