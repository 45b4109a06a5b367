// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <seamwright/core/join/nearest/nearest_condition.hpp>

/// The smallest move of poles x that makes A(c) x = 0 for some c; not a public header.
namespace seamwright::nearest {

/// A family of connection functions, in which the smallest move is sought.
struct Family {
  Degrees degrees{};
  std::vector<double> vanishing;  ///< inner knots at which beta and q are zero
  /// The coefficients c are held + basis y with y free.
  Eigen::MatrixXd basis;
  Eigen::VectorXd held;
};

struct Solution {
  Eigen::VectorXd c;
  Eigen::MatrixXd x;
  /// A(c) x is rounding, weights are positive, and the tangent plane has neither turned over nor
  /// collapsed.
  bool exact = false;
  bool stationary = false;  ///< x is a local minimum, up to rounding
  double cost = 0;          ///< sum of weight times squared move from the target
  double stationarity = 0;
  int iterations = 0;
};

/// Whether each row of A x is at most what rounding of poles of size \p rounding causes.
bool holds(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& x, double rounding);

/// Newton's method for the stationary points of
///   min 1/2 |x - target|^2  subject to  A(c) x = 0
/// in c alone: for each c the nearest x is a projection. With x = target + D z, D = w^(-1/2)
/// (w is the weight of a move; D is 0 where a pole stays), M = A D, T_i = M^+ (A_i x), nu the
/// multipliers, H_i = D A_i' nu, the gradient by c_i is -<z, T_i> and the Hessian
///   <T_i, T_j> - <T_i, H_j> - <H_i, T_j> - <H_i, (1 - M^+ M) H_j> + <nu, A_ij x>.
/// The part of A_i x that no movable pole can reach, (1 - M M^+) A_i x, gives linear conditions on
/// the step. Coefficients of alpha stay above a bound.
/// Source: docs/theory/surfaces.md S5.2; [GolubPereyra1973].
Solution solve(const Unknowns& unknowns, const Condition& condition, const Family& family,
               double smallest_alpha, int max_iterations);

}  // namespace seamwright::nearest
