// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <seamwright/core/join/ribbon.hpp>
#include <string>

namespace seamwright {

/// The connection functions of a join, each a polynomial of the seam's parameter in Bernstein form
/// on [0, 1].
///
/// With P the homogeneous ribbon of the given patch (s out of it) and Q that of the other (s into
/// it), both along the same t:
///   Q = e0 P Q_s = e1 P + e0 (alpha P_s + beta P_t) (G1, alpha > 0) Q_ss = e2 P + 2 e1 (alpha P_s
///   + beta P_t)
///          + e0 (alpha^2 P_ss + 2 alpha beta P_st + beta^2 P_tt + p P_s + q P_t) (G2)
/// Polynomial patches have e0 = 1, e1 = e2 = 0. alpha = 1 and beta = p = q = 0 is C^1 (C^2) in s.
/// Source: docs/theory/surfaces.md S1.1, S2.4, S3.3; [Peters2002].
struct Connection {
  Eigen::VectorXd alpha = Eigen::VectorXd::Ones(1);
  Eigen::VectorXd beta = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd p = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd e0 = Eigen::VectorXd::Ones(1);
  Eigen::VectorXd e1 = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd e2 = Eigen::VectorXd::Zero(1);
};

struct ConnectionFitOptions {
  int order = 1;  ///< 1: alpha, beta; 2: also p, q
  /// Degrees; nothing: ascending, (0, 1), (1, 2), (2, 3), ... until the residual is within the
  /// tolerance.
  std::optional<int> alpha_degree = std::nullopt, beta_degree = std::nullopt,
                     p_degree = std::nullopt, q_degree = std::nullopt;
  std::optional<double> tolerance =
      std::nullopt;  ///< of residuals; nothing: what rounding of the poles makes of 0
  double largest_condition = 1e12;  ///< of the systems of equations; above it nothing is recognised
};

/// What connects two ribbons.
struct ConnectionFit {
  bool found = false;  ///< all residuals are within the tolerance, and alpha is positive on [0, 1]
  Connection connection;  ///< the best of the degrees tried; of order 1 with p = q = 0
  double residual =
      0;  ///< largest coefficient that remains, relative to the fields, over all equations solved
  double noise = 0;  ///< what rounding of the poles makes of a residual of 0
  double condition =
      0;             ///< of the worst system of equations, by pivoted QR after scaling its columns
  std::string note;  ///< what stands in the way where nothing is found
};

/// Recognises the connection functions of two ribbons over the same t, a out of its patch and b
/// into its own, by linear least squares in Bernstein coefficients: first e0 from Q = e0 P, then
/// alpha, beta (rational: and e1) from Q_s, then p, q (rational: and e2) from Q_ss.
///
/// If b was constructed from a, its functions come back. A join whose alpha or beta is no
/// polynomial is not found, although it may be G1: joinCondition() tells; the note says so. Without
/// a tolerance nothing is found where noise is above 1e-2. Of a fold alpha is negative: it is in
/// the connection, but not found. Identities (each has a test of its number):
///   (1) The functions of a constructed join come back, of order 1 and 2, polynomial and rational,
///       of any pairing.
///   (2) Of a G1 join with rational alpha nothing is found, and the note says that it is G1.
///   (3) Rigid motion and scaling of both sides change nothing but rounding.
///
/// \throws std::invalid_argument for ribbons and tolerances as in joinCondition(), an order other
/// than 1 and 2, a negative degree, or one above 30.
/// Source: docs/theory/surfaces.md S2.5, S3.3.
ConnectionFit fitConnection(const Ribbon& a, const Ribbon& b,
                            const ConnectionFitOptions& options = {});

}  // namespace seamwright
