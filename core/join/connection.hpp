// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace seamwright {

/// The connection functions of a join, each a polynomial of the seam's parameter in Bernstein form on [0, 1].
///
/// With P the homogeneous ribbon of the given patch (s out of it) and Q that of the other (s into it), both along the same t:
///   Q    = e0 P
///   Q_s  = e1 P + e0 (alpha P_s + beta P_t)                                                      (G1, alpha > 0)
///   Q_ss = e2 P + 2 e1 (alpha P_s + beta P_t)
///          + e0 (alpha^2 P_ss + 2 alpha beta P_st + beta^2 P_tt + p P_s + q P_t)                 (G2)
/// Polynomial patches have e0 = 1, e1 = e2 = 0. alpha = 1 and beta = p = q = 0 is C^1 (C^2) in s.
/// Source: MATH-surfaces 1.1, 8.2 (text 001, sections 2, 4, 5).
struct Connection {
  Eigen::VectorXd alpha = Eigen::VectorXd::Ones(1);
  Eigen::VectorXd beta = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd p = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd e0 = Eigen::VectorXd::Ones(1);
  Eigen::VectorXd e1 = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd e2 = Eigen::VectorXd::Zero(1);
};

}  // namespace seamwright
