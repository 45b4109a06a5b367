// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <seamwright/core/join/condition/seam_parameter.hpp>
#include <seamwright/core/join/connection_functions.hpp>
#include <seamwright/core/join/ribbon.hpp>
#include <string>

namespace seamwright {

struct ConnectionFitOptions {
  int order = 1;  ///< 1: alpha, beta; 2: also p, q; 3: also h, k
  /// Degrees. Nothing: the pairs (0, 1), (1, 2), (2, 3), ... are tried in ascending order until the
  /// residual is within the tolerance.
  std::optional<int> alpha_degree = std::nullopt, beta_degree = std::nullopt,
                     p_degree = std::nullopt, q_degree = std::nullopt, h_degree = std::nullopt,
                     k_degree = std::nullopt;
  /// Of residuals; nothing: the residual that rounding of the poles may cause.
  std::optional<double> tolerance = std::nullopt;
  /// Of the systems of equations; above it no connection is found.
  double largest_condition = 1e12;
};

/// The connection functions of two ribbons, and how well they fit.
struct ConnectionFit {
  /// Where the sides run along the seam at different speeds: see JoinCondition. The functions are
  /// those of the sides over the common parameter.
  std::optional<SeamParameter> parameter = std::nullopt;
  bool parameter_of_a = true;
  bool found = false;  ///< all residuals are within the tolerance, and alpha is positive on [0, 1]
  /// The best of the degrees tried, with gamma = 1; functions of a higher order are 0.
  ConnectionFunctions connection;
  /// Largest remaining coefficient of all equations solved, relative to the fields.
  double residual = 0;
  double noise = 0;  ///< the residual that rounding of the poles may cause where the exact one is 0
  /// Largest condition of the systems of equations, by pivoted QR with scaled columns.
  double condition = 0;
  std::string note;  ///< the reason if nothing is found
};

/// Finds the connection functions of two ribbons, over the same t or over the common parameter that
/// commonParameter() finds. Ribbon a runs out of its patch,
/// ribbon b into its own. The method is linear least squares in Bernstein coefficients: first e0
/// from Q = e0 P, then alpha and beta (rational: also e1) from Q_s, then p and q (rational: also
/// e2) from Q_ss, then h and k (rational: also e3) from Q_sss.
///
/// If b was constructed from a, the functions used are returned. A join whose alpha or beta is not
/// a polynomial is not found, although it may be G1: joinCondition() decides that, and the note
/// says so. Without a tolerance nothing is found if the noise is above 1e-2. For a fold alpha is
/// negative: the connection holds it, but found is false.
/// Identities (each has a test of its number):
///   (1) The functions of a constructed join are returned, for orders 1 to 3, polynomial and
///       rational ribbons, and any pair of patches.
///   (2) For a G1 join with rational alpha nothing is found, and the note says that it is G1.
///   (3) Rigid motion and scaling of both sides change the result only by rounding.
///
/// \throws std::invalid_argument for ribbons and tolerances that joinCondition() refuses, an order
/// outside 1 to 3, and a degree that is negative or above 30.
/// Source: docs/theory/surfaces.md S2.5, S3.3, S3.4.
ConnectionFit fitConnection(const Ribbon& a, const Ribbon& b,
                            const ConnectionFitOptions& options = {});

}  // namespace seamwright
