// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <seamwright/core/join/condition/connection.hpp>
#include <seamwright/core/join/condition/seam_parameter.hpp>
#include <seamwright/core/join/ribbon.hpp>
#include <string_view>

namespace seamwright {

/// A polynomial of the seam's parameter that vanishes iff a condition holds.
struct JoinResidual {
  /// In Bernstein form, of vectors the lengths. Weights are divided by the largest of both seams.
  Eigen::VectorXd coefficients;
  /// Largest coefficient, divided by the sizes of the fields that it is made of: without unit, and
  /// independent of size, position and speed.
  double relative = 0;
  /// Bound of the relative residual that rounding may cause where the exact one is 0.
  double noise = 0;
  double at = 0;  ///< parameter k / degree of the largest coefficient
  /// relative <= the caller's tolerance, or without one relative <= noise <= 1e-2; with more noise
  /// nothing can be decided.
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
  /// Where the sides run along the seam at different speeds: the parameter of one side at which it
  /// meets the other. All other members are those of this side over the other's parameter, but
  /// parametric_order, which is -1.
  std::optional<SeamParameter> parameter = std::nullopt;
  bool parameter_of_a = true;  ///< the map is the parameter of a; otherwise that of b
  JoinResidual position;       ///< Q - P, in mm (rational: by both weights)
  /// Bound, up to rounding, of the distance of the two sides' points at the same t.
  double gap_bound_mm = 0;
  /// Parametric: Q_s - P_s and Q_ss - P_ss, of points, not homogeneous.
  JoinResidual first, second;
  /// Largest n <= 2 for which the sides are found to meet with C^n in (s, t); -1: they do not meet.
  int parametric_order = -1;
  JoinResidual tangent_plane;  ///< det(P_s, P_t, Q_s); rational: det(P, P_s, P_t, Q_s) / n
  /// Bound of the angle between the tangent planes at the same t; pi if no bound is known.
  double angle_bound_rad = 0;
  JoinVerdict verdict = JoinVerdict::NotG1;
  /// Parameter at which a side has no tangent plane, or is too near to that to tell.
  std::optional<double> singular_at;
  std::optional<JoinResidual> curvature;  ///< only if the verdict is G1
  /// The change of curvature across the seam; only if the join is G2 and the degrees allow it.
  std::optional<JoinResidual> curvature_change;
  bool g2() const { return curvature && curvature->holds; }
  bool g3() const { return curvature_change && curvature_change->holds; }
};

struct JoinConditionOptions {
  /// Of relative residuals; nothing: the noise of each one.
  std::optional<double> tolerance = std::nullopt;
  /// Of b to a, for the conditions of curvature and its change; nothing: from the ribbons.
  std::optional<ConnectionFunctions> connection = std::nullopt;
};

/// Judges the join of two ribbons. Ribbon a runs out of its patch, ribbon b into
/// its own. The judgement uses polynomials that vanish iff the join holds, and no samples. Any pair
/// of patches and triangles is allowed, polynomial or rational.
///
///     const JoinCondition join = joinCondition(a, b);
///     if (join.g2()) ...
///
/// G1: det(P_s, P_t, Q_s) = 0 and N_P.N_Q > 0 with N_P = P_s x P_t, N_Q = Q_s x P_t; for rational
/// sides det(P, P_s, P_t, Q_s) of the homogeneous vectors. The sign of N_P.N_Q is certified by
/// Bernstein coefficients and subdivision. Where rounding of the poles leaves a normal less than
/// two digits, the verdict is Singular.
///
/// G2, of a G1 join, with A = (Q_s x P_t).N_P, B = (P_s x Q_s).N_P, mu = N_P.N_P:
///   N_P.(mu^2 Q_ss - A^2 P_ss - 2 A B P_st - B^2 P_tt) = 0.
/// It is necessary and sufficient for rational functions alpha = A / mu and beta = B / mu too. A
/// given connection is used in place of these, without a check that it is one.
///
/// G3, of a G2 join, with R = mu^2 Q_ss - A^2 P_ss - 2 A B P_st - B^2 P_tt, C = (R x P_t).N_P and D
/// = (P_s x R).N_P:
///   N_P.(mu^4 Q_sss - mu (A^3 P_sss + 3 A^2 B P_sst + 3 A B^2 P_stt + B^3 P_ttt)
///        - 3 (A C P_ss + (A D + B C) P_st + B D P_tt)) = 0.
/// Its degree is 19 times that of the sides, 42 times if they are rational; it is not judged above
/// a degree of 800.
///
/// Sides that do not meet at the same t are judged in the common parameter that commonParameter()
/// finds, if it finds one and no connection is given.
///
/// The angle is that of P_s x P_t and Q_s x Q_t, each side with its own seam.
///
/// Identities (each has a test of its number):
///   (1) The verdict of a constructed join is G1, and for order 2 g2() holds too, for order 3 also
///       g3(); with alpha < 0 the verdict is Fold.
///   (2) After a move of one pole of rows 0 or 1 (for g2(): of row 2, for g3(): of row 3) by 1e-6
///       of the patch's size the join no longer holds.
///   (3) Rigid motion, scaling and reversal of the seam change no verdict, and residuals only by
///       rounding.
///   (4) angle_bound_rad is at least the angle of the tangent planes at every t, even if the seams
///       differ.
///   (5) The verdict of sides that join does not change if a linear-rational map or a polynomial
///       replaces the parameter of one side.
///
/// \throws std::invalid_argument for a ribbon with a part that is empty or not finite, a degree
/// above 30, or weights that are not positive; for a tolerance that is negative or not finite; and
/// for functions of a given connection that tensorRows() refuses.
/// Source: docs/theory/surfaces.md S1.2, S1.3, S2.2 to S2.4, S3.2, S3.4; [DeRose1990]; [Liu1990].
JoinCondition joinCondition(const Ribbon& a, const Ribbon& b,
                            const JoinConditionOptions& options = {});

}  // namespace seamwright
