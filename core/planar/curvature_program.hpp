// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

/// Not a public header.
namespace seamwright {

/// Curvatures k at the joints of a spline, and moves x of its points, both without a unit:
///   minimise k' D k / 2 with A k - J x = b, -1 <= x <= 1 and S k >= margins.
struct CurvatureProgram {
  Eigen::SparseMatrix<double> energy;      ///< D: symmetric, not negative
  Eigen::SparseMatrix<double> curvatures;  ///< A: square and regular
  Eigen::SparseMatrix<double> moves;       ///< J
  Eigen::VectorXd right;                   ///< b
  Eigen::SparseMatrix<double> shape;       ///< S
  Eigen::VectorXd margins;
};

struct CurvatureSolution {
  Eigen::VectorXd curvatures, moves;
  int steps = 0;
  /// Whether energy and equations have the precision of the method. If not, no k and x may exist.
  bool converged = false;
};

/// A primal-dual interior-point method (Mehrotra's, without the corrector) that starts at these
/// values, which need not be feasible. A step costs O(n). The search ends early if the multipliers
/// prove that there is no solution.
/// Source: docs/theory/planar.md P10.5.
CurvatureSolution solve(const CurvatureProgram& program, const Eigen::VectorXd& curvatures,
                        const Eigen::VectorXd& moves);

}  // namespace seamwright
