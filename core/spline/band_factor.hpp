// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <seamwright/core/bezier/curve.hpp>

/// Tridiagonal linear equations, also cyclic ones, in O(n); not a public header.
namespace seamwright {

/// Row i is lower(i) x(i-1) + diagonal(i) x(i) + upper(i) x(i+1). All rows should have a size of
/// about 1.
struct BandMatrix {
  Eigen::VectorXd lower, diagonal, upper;
  /// Powers of two by which rows were divided; they are also 1 / size of the unknowns. To choose
  /// pivots and to judge the condition, rows are multiplied and columns divided by them. So small
  /// unknowns keep their digits.
  Eigen::VectorXd scale;
  /// Whether the first and the last unknown are neighbours. If not, lower(0) and upper(n-1) are 0.
  bool closed = false;
};

struct BandSolution {
  Poles x;
  /// Largest |x| for right sides of at most 1, both relative to scale if pivoted. It is a bound if
  /// the matrix is diagonally dominant, otherwise Hager's estimate.
  double inverse_norm = 0;
  bool pivoted = false;
};

/// Reciprocal condition below which equations count as singular.
inline constexpr double kSmallestCondition = 1e-12;

/// Gaussian elimination. It uses no pivoting if every diagonal entry is larger in size than the sum
/// of its neighbours, and partial pivoting otherwise.
///
/// The unknowns of a closed matrix are taken in the order 0, n-1, 1, n-2, .. . Then neighbours in
/// the ring are at most 2 apart, so the matrix is a band matrix and pivoting works as for any band.
/// (Bordering fails if the ring without one unknown is singular although the whole ring is
/// regular.)
/// \pre at least one row; all numbers are finite. \throws std::domain_error with number and size of
/// the smallest pivot if the reciprocal condition in the maximum norm is below kSmallestCondition.
/// Source: docs/theory/curves.md C6.3; [Higham2002].
BandSolution solveBand(const BandMatrix& matrix, Poles right);

}  // namespace seamwright
