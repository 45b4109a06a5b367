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
  /// In Bernstein form; of a vector-valued polynomial the lengths of its coefficients. Weights
  /// count as divided by the largest one of both seams.
  Eigen::VectorXd coefficients;
  /// Largest coefficient by the product of the sizes of the fields it is made of: without unit, the
  /// same for any size and place of the patches, and for any speed of their parameters.
  double relative = 0;
  double noise = 0;  ///< what rounding of the poles and of these computations may make of a
                     ///< relative residual of 0
  double at = 0;     ///< the parameter that the largest coefficient stands for, k / degree
  /// relative <= the caller's tolerance, or without one <= noise. Without one nothing holds whose
  /// noise is above 1e-2 of the fields (of second derivatives, of these or of the first ones): it
  /// cannot be told.
  bool holds = false;
};

/// How the tangent planes of two sides meet.
enum class JoinVerdict {
  G1,       ///< the same, and the second patch goes on where the first one ends
  Fold,     ///< the same, but the second patch turns back
  NotG1,    ///< not the same, or the sides do not even meet
  Singular  ///< a side has no tangent plane somewhere
};

/// "G1", "fold", "not G1", "singular".
std::string_view name(JoinVerdict verdict);

struct JoinCondition {
  JoinResidual position;    ///< Q - P, in mm (rational: by both weights)
  double gap_bound_mm = 0;  ///< but for rounding, no point of one seam is further from that of the
                            ///< other at the same t
  JoinResidual first, second;  ///< parametric: Q_s - P_s and Q_ss - P_ss, of the points themselves
  int parametric_order =
      -1;  ///< the sides meet with C^0, C^1 or C^2 in (s, t) as far as can be told; -1: not at all
  JoinResidual tangent_plane;  ///< det(P_s, P_t, Q_s); rational: det(P, P_s, P_t, Q_s) of
                               ///< homogeneous vectors over n
  double angle_bound_rad =
      0;  ///< no angle of the tangent planes at a t is larger; pi where nothing is known
  JoinVerdict verdict = JoinVerdict::NotG1;
  std::optional<double>
      singular_at;  ///< where a side has no tangent plane, or too near to that to tell
  std::optional<JoinResidual> curvature;  ///< only where the verdict is G1
  bool g2() const { return curvature && curvature->holds; }
};

struct JoinConditionOptions {
  std::optional<double> tolerance =
      std::nullopt;  ///< of relative residuals; nothing: the noise of each
  std::optional<Connection> connection =
      std::nullopt;  ///< of b to a, for the condition of curvature; nothing: from the ribbons
};

/// Judges the join of two ribbons over the same t, a out of its patch and b into its own, by
/// polynomials that vanish iff it holds: no samples, and any pairing of tensor-product patches and
/// triangles, polynomial and rational.
///
/// G1. det(P_s, P_t, Q_s) = 0 and N_P.N_Q > 0 with N_P = P_s x P_t, N_Q = Q_s x P_t. For rational
/// sides det(P, P_s, P_t, Q_s) of the homogeneous vectors, which needs no common scale: any e0(t)
/// is allowed. Its coefficients are divided by the degree n of P, as P ^ P_t = n X ^ Y with X, Y
/// the first and the last n poles. The determinant alone also vanishes for folds and where a side
/// has no tangent plane; the sign is certified by Bernstein coefficients and subdivision. Rounding
/// of the poles blurs a normal; where it leaves less than two digits, as of a small patch very far
/// from the origin, the verdict is Singular.
///
/// The angle of the tangent planes is that of P_s x P_t and Q_s x Q_t, each side with its own seam:
/// where the seams differ it also counts how they lean against each other.
///
/// G2, of a G1 join. With alpha = A / mu, beta = B / mu, A = (Q_s x P_t).N_P, B = (P_s x Q_s).N_P,
/// mu = N_P.N_P:
///   N_P.(mu^2 Q_ss - A^2 P_ss - 2 A B P_st - B^2 P_tt) = 0,
/// which is necessary and sufficient also where alpha and beta are rational functions. With a
/// connection given, its alpha and beta are taken, on the caller's word that Q_s = alpha P_s + beta
/// P_t: N_P.(Q_ss - alpha^2 P_ss - 2 alpha beta P_st - beta^2 P_tt) = 0. For rational sides these
/// are the derivatives of the points, times the powers of the weights that make polynomials of
/// them.
///
/// Ribbons of different degrees are compared in the higher one. Identities (each has a test of its
/// number):
///   (1) The verdict of a constructed join is G1, with order 2 moreover g2(); with alpha < 0 it is
///       Fold.
///   (2) Moving one pole of rows 0 or 1 (of row 2 for g2()) by 1e-6 of the patch's size ends it.
///   (3) Rigid motion, scaling and reversing the seam change no verdict, residuals by their
///       rounding only.
///   (4) angle_bound_rad is no less than any angle of the tangent planes at the same t, also where
///       the seams are not the same.
///
/// \throws std::invalid_argument for a ribbon with an empty or not finite part, a degree above 30
/// or weights that are not positive, a tolerance that is negative or not finite, or functions of a
/// given connection that tensorRows() would refuse.
/// Source: docs/theory/surfaces.md S1.2, S1.3, S2.2 to S2.4, S3.2; [DeRose1990]; [Liu1990].
JoinCondition joinCondition(const Ribbon& a, const Ribbon& b,
                            const JoinConditionOptions& options = {});

}  // namespace seamwright
