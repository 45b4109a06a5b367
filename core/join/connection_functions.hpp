// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace seamwright {

/// The connection functions of a join. They express the derivatives of one side by those of the
/// other. Each is a polynomial of the seam's parameter in Bernstein form on [0, 1].
///
/// Let P be the given side (s out of it) and Q the other side (s into it), both along the same t,
/// in homogeneous coordinates. With Y1 = alpha P_s + beta P_t the sides satisfy:
///   Q    = e0 P
///   gamma Q_s    = gamma e1 P + e0 Y1                           (G1; alpha, gamma > 0)
///   gamma^2 Q_ss = gamma^2 e2 P + 2 gamma e1 Y1
///                  + e0 (alpha^2 P_ss + 2 alpha beta P_st + beta^2 P_tt + p P_s + q P_t)    (G2)
/// and with gamma = 1, and Y2 the sum in the parentheses above,
///   Q_sss = e3 P + 3 e2 Y1 + 3 e1 Y2 + e0 Y3                                      (G3)
///   Y3    = alpha^3 P_sss + 3 alpha^2 beta P_sst + 3 alpha beta^2 P_stt + beta^3 P_ttt
///           + 3 (alpha p P_ss + (alpha q + beta p) P_st + beta q P_tt) + h P_s + k P_t.
/// Polynomial surfaces have e0 = 1, e1 = e2 = e3 = 0. The default, alpha = 1 and beta = p = q = h =
/// k = 0, is C^1 (C^2, C^3) in s.
///
/// gamma is a common denominator: the functions of the equations without it are alpha / gamma,
/// beta / gamma, p / gamma^2 and q / gamma^2. nearestNetwork() needs it, because it treats both
/// sides alike. All other functions require gamma = 1. If gamma, alpha and beta are multiplied by
/// one positive function and p, q by its square, the join is the same.
/// Source: docs/theory/surfaces.md S1.1, S2.4, S2.6, S3.3, S3.4; [Peters2002].
struct ConnectionFunctions {
  Eigen::VectorXd alpha = Eigen::VectorXd::Ones(1);
  Eigen::VectorXd beta = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd p = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd h = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd k = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd e0 = Eigen::VectorXd::Ones(1);
  Eigen::VectorXd e1 = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd e2 = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd e3 = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd gamma = Eigen::VectorXd::Ones(1);
};

}  // namespace seamwright
