// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <seamwright/core/bezier/curve.hpp>

/// Linear equations between neighbours, in O(n); not a public header.
namespace seamwright {

/// Row i: lower(i) x(i-1) + diagonal(i) x(i) + upper(i) x(i+1). Rows should be of one size, about
/// 1.
struct BandMatrix {
  Eigen::VectorXd lower, diagonal, upper;
  /// Powers of two that rows were divided by, and 1 / size of their unknowns: pivots are chosen,
  /// and the condition is judged, with rows multiplied and columns divided by them, so that small
  /// unknowns keep their digits.
  Eigen::VectorXd scale;
  /// The first and the last unknown are neighbours. Otherwise lower(0) and upper(n-1) are 0.
  bool closed = false;
};

struct BandSolution {
  Poles x;
  /// Largest |x| for right sides of up to 1, both by scale if pivoted: a bound where the matrix is
  /// dominant, else Hager's estimate.
  double inverse_norm = 0;
  bool pivoted = false;
};

/// Reciprocal condition below which equations count as singular.
inline constexpr double kSmallestCondition = 1e-12;

/// Gauss's elimination: without pivoting where every diagonal entry is above the sum of its
/// neighbours in size, with partial pivoting elsewhere.
///
/// A closed matrix is taken in the order 0, n-1, 1, n-2, ..: neighbours in the ring are then at
/// most 2 apart, so it is a band like the other, and pivoting does for it what it does for any
/// band. (Bordering fails where the ring without one unknown is singular and the ring is not.)
/// \pre at least one row, all finite. \throws std::domain_error with number and size of the
/// smallest pivot if the reciprocal condition in the maximum norm is below kSmallestCondition.
/// Source: docs/theory/curves.md C6.3; [Higham2002].
BandSolution solveBand(const BandMatrix& matrix, Poles right);

}  // namespace seamwright
