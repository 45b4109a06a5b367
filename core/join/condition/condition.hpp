// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <seamwright/core/join/connection.hpp>
#include <seamwright/core/join/ribbon.hpp>
#include <string_view>

namespace seamwright {

/// A polynomial of the seam's parameter that vanishes iff a condition holds.
struct JoinResidual {
  /// The Bernstein coefficients; for a vector-valued polynomial their lengths. Weights are divided
  /// by the largest weight of both seams.
  Eigen::VectorXd coefficients;
  /// Largest coefficient, divided by the product of the sizes of the fields that it is made of. It
  /// is dimensionless and independent of the size and the position of the patches and of the speed
  /// of their parameters.
  double relative = 0;
  /// Bound of the relative residual that the rounding of the poles and of these computations may
  /// cause where the exact one is 0.
  double noise = 0;
  double at = 0;  ///< parameter k / degree of the largest coefficient
  /// relative <= the caller's tolerance, or, without a tolerance, relative <= noise. Without a
  /// tolerance no condition holds whose noise is above 1e-2 of the fields (for second derivatives:
  /// of these or of the first ones), because it cannot be decided.
  bool holds = false;
};

/// How the tangent planes of two sides meet.
enum class JoinVerdict {
  G1,       ///< the same, and the second patch continues the first one
  Fold,     ///< the same, but the second patch turns back
  NotG1,    ///< not the same, or the sides do not meet
  Singular  ///< a side has no tangent plane at some parameter
};

/// "G1", "fold", "not G1", "singular".
std::string_view name(JoinVerdict verdict);

struct JoinCondition {
  JoinResidual position;  ///< Q - P, in mm (rational: by both weights)
  /// Bound, up to rounding, of the distance of the two sides' points at the same t.
  double gap_bound_mm = 0;
  /// Parametric: Q_s - P_s and Q_ss - P_ss, of points, not homogeneous.
  JoinResidual first, second;
  /// Largest n <= 2 for which the sides are found to meet with C^n in (s, t); -1: they do not meet.
  int parametric_order = -1;
  JoinResidual tangent_plane;  ///< det(P_s, P_t, Q_s); rational: det(P, P_s, P_t, Q_s) of
                               ///< homogeneous vectors over n
  /// Bound of the angle between the tangent planes at the same t; pi if no bound is known.
  double angle_bound_rad = 0;
  JoinVerdict verdict = JoinVerdict::NotG1;
  /// Parameter at which a side has no tangent plane, or is too near to that to tell.
  std::optional<double> singular_at;
  std::optional<JoinResidual> curvature;  ///< only if the verdict is G1
  bool g2() const { return curvature && curvature->holds; }
};

struct JoinConditionOptions {
  /// Of relative residuals; nothing: the noise of each one.
  std::optional<double> tolerance = std::nullopt;
  /// Of b to a, for the curvature condition; nothing: from the ribbons.
  std::optional<Connection> connection = std::nullopt;
};

/// Judges the join of two ribbons over the same t. Ribbon a runs out of its patch, ribbon b into
/// its own. The judgement uses polynomials that vanish iff the join holds, and no samples. Any pair
/// of tensor-product patches and triangles is allowed, polynomial or rational.
///
/// G1. det(P_s, P_t, Q_s) = 0 and N_P.N_Q > 0 with N_P = P_s x P_t, N_Q = Q_s x P_t. For rational
/// sides the determinant is det(P, P_s, P_t, Q_s) of the homogeneous vectors. It needs no common
/// scale: any e0(t) is allowed. Its coefficients are divided by the degree n of P, as P ^ P_t = n X
/// ^ Y with X, Y the first and the last n poles. The determinant also vanishes for folds and where
/// a side has no tangent plane. So the sign of N_P.N_Q is certified by Bernstein coefficients and
/// subdivision. Rounding of the poles perturbs a normal. If fewer than two digits remain, as for a
/// small patch very far from the origin, the verdict is Singular.
///
/// The angle of the tangent planes is the angle of P_s x P_t and Q_s x Q_t, each side with its own
/// seam. If the seams differ, it includes the angle between their directions.
///
/// G2, of a G1 join. With alpha = A / mu, beta = B / mu, A = (Q_s x P_t).N_P, B = (P_s x Q_s).N_P,
/// mu = N_P.N_P:
///   N_P.(mu^2 Q_ss - A^2 P_ss - 2 A B P_st - B^2 P_tt) = 0,
/// which is necessary and sufficient for rational functions alpha and beta too. If a connection is
/// given, its alpha and beta are used, and Q_s = alpha P_s + beta P_t is assumed, not checked:
/// N_P.(Q_ss - alpha^2 P_ss - 2 alpha beta P_st - beta^2 P_tt) = 0. For rational sides these are
/// derivatives of the points, multiplied by the powers of the weights that make them polynomials.
///
/// Ribbons of different degrees are compared in the higher degree.
/// Identities (each has a test of its number):
///   (1) The verdict of a constructed join is G1, and for order 2 g2() holds too; with alpha < 0
///       the verdict is Fold.
///   (2) After a move of one pole of rows 0 or 1 (for g2(): of row 2) by 1e-6 of the patch's size
///       the join no longer holds.
///   (3) Rigid motion, scaling and reversal of the seam change no verdict, and residuals only by
///       rounding.
///   (4) angle_bound_rad is at least the angle of the tangent planes at every t, even if the seams
///       differ.
///
/// \throws std::invalid_argument for a ribbon with a part that is empty or not finite, a degree
/// above 30, or weights that are not positive; for a tolerance that is negative or not finite; and
/// for functions of a given connection that tensorRows() refuses.
/// Source: docs/theory/surfaces.md S1.2, S1.3, S2.2 to S2.4, S3.2; [DeRose1990]; [Liu1990].
JoinCondition joinCondition(const Ribbon& a, const Ribbon& b,
                            const JoinConditionOptions& options = {});

}  // namespace seamwright
