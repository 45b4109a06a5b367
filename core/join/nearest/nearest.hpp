// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/core/join/condition/connection.hpp>
#include <seamwright/core/join/condition/seam_parameter.hpp>

namespace seamwright {

/// One of the two surfaces of a join.
struct JoinSide {
  BSplineSurface surface;
  PatchEdge edge = PatchEdge::U0;
  bool reversed = false;         ///< the seam's parameter runs against the edge's own sense
  bool moves = true;             ///< false: no pole of this surface moves
  Eigen::VectorXd weights = {};  ///< of each given pole's move, > 0, in their order; empty: 1
  std::vector<bool> fixed = {};  ///< given poles that stay; empty: none
};

struct NearestOptions {
  int order = 1;  ///< of the join, G1 to G3
  /// Degrees of the functions that are sought, 0 to 6; those of e1 to e3 for rational surfaces
  /// only.
  int degree_alpha = 0, degree_beta = 1, degree_p = 0, degree_q = 1, degree_h = 0, degree_k = 1;
  int degree_e1 = 0, degree_e2 = 0, degree_e3 = 0;
  /// Lower bound of alpha, in (0, 1], as a share of the ratio of the cross-boundary derivatives.
  double smallest_alpha = 1e-3;
  int max_iterations = 50;
  /// The connection functions to be used; nothing: they are sought. e0 and gamma must be 1. e1 to
  /// e3 must be 0 unless a surface is rational.
  std::optional<ConnectionFunctions> held = std::nullopt;
};

enum class NearestStatus {
  Joined,       ///< the join holds up to rounding and the move is stationary
  Unchanged,    ///< the join already held; no number was changed
  Infeasible,   ///< no join was found; the surfaces are as given
  NotConverged  ///< the join holds up to rounding, but a smaller move may exist
};

/// What a surface that moved got along the seam before its poles moved.
struct SeamChange {
  int raised_degree = 0;                 ///< by how much; each knot is then repeated as often more
  std::vector<double> added_knots = {};  ///< further ones, in its parameter, with repetitions
  /// The largest change of a knot that became a knot of the other side, as a share of the range.
  double moved_knots = 0;
};

/// The smallest move that makes two surfaces join.
struct NearestJoin {
  NearestStatus status = NearestStatus::Infeasible;
  BSplineSurface a, b;             ///< with their own parameters
  SeamChange change_a, change_b;   ///< nothing where the surface is as given
  ConnectionFunctions connection;  ///< of b to a; all parameters are scaled to 0..1
  /// The seam's parameter of b, where it is a linear-rational function of that of a; else both are
  /// the same. The connection is that in the parameter of a.
  std::optional<SeamParameter> parameter_of_b;
  double largest_move_mm = 0;  ///< of a pole
  double cost = 0;             ///< sum of weight times squared move, in mm^2
  /// The largest defect of the equations, relative to the largest |Q_s| (|Q_ss|, |Q_sss|).
  double residual = 0;
  /// Share of the move that lies along the joins nearby, 0 to 1.
  double stationarity = 0;
  int iterations = 0;
};

/// Moves poles of two surfaces that nearly meet along one edge each, so that the surfaces join
/// exactly with G1, G2 or G3, by the smallest move. See docs/nearest_joins.md.
///
///     const NearestJoin join = nearestJoin({.surface = a, .edge = PatchEdge::U1, .moves = false},
///                                          {.surface = b, .edge = PatchEdge::U0}, {.order = 2});
///
/// Minimises the sum of weight |move|^2 over the poles of the first order + 1 rows of both sides
/// and over the connection functions, subject to their equations with surface a as P and b as Q.
/// The join holds at every parameter, up to rounding (a residual of at most 1e-6). Poles that do
/// not move stay bitwise. The result is a local minimum.
///
///   - Ends of the seam correspond to ends, and equal shares of both parameter ranges to each
///   other.
///     A side that moves gets the degree and the knots along the seam that the other has
///     (change_a, change_b); no point of it changes by that. Knots within 1e-9 of the range are
///     one: the side that moves, or b, takes that of the other, unless they differ by rounding
///     alone. If both agree, no number changes, and no side that stays ever does.
///   - A pole of the refined surface has the mean of the weights of the given poles on which it
///     depends, by their shares. It stays if all of these are fixed.
///   - Rational sides whose weights along the seam become proportional, to 1e-10, by a
///   linear-rational
///     map of the parameter are joined in the parameter of a (parameter_of_b).
///   - Inner knots along the seam force beta (and q and k) to vanish there, or the seam to become
///     smoother. withRaisedKnots() on both sides leaves beta free.
///   - A side that has a tangent plane keeps it; it turns by less than a right angle.
///   - Infeasible does not prove that no join exists.
///   - Rational surfaces move in homogeneous coordinates. The squared move of a pole (w x, w) is
///     |w dx + (x - m) dw|^2 / w^2 + (L dw / w)^2, with m the mean of the seam's poles and L the
///     size of the rows.
///
/// Identities (each has a test of its number):
///   (1) encloseSeam() of the result gives a gap of 0, and an angle, for order 2 a curvature
///       difference and for order 3 a difference of its change that are rounding.
///   (2) The move is orthogonal to the joins nearby, and none of these joins has a smaller move.
///   (3) Rigid motion and scale of both surfaces act on the result in the same way.
///   (4) Reversal of the seam's parameter only changes the signs of beta, q and k.
///   (5) Swapping the sides leaves the poles the same if alpha is constant and beta linear: then
///       alpha' = 1 / alpha, beta' = beta / alpha. The searches may end in different local minima.
///   (6) A second call changes nothing.
///   (7) Another parameter range of a side changes no pole, and neither do knots that it would get,
///       inserted beforehand.
///
/// The time of a step grows with the third power of the number of spans.
///
/// \throws std::invalid_argument for fixed poles that the poles with further knots or a higher
/// degree cannot hold (with their indices); for options out of range, weights that are not
/// positive, lists of a wrong length, invalid surfaces (see requireValid()), a side without extent
/// across the seam, a held alpha with a coefficient that is not positive, and more than 1.5 million
/// matrix entries (220 cubic spans for G2). Source: docs/theory/surfaces.md S5.1 to S5.4, S5.7,
/// S1.9, S2.5, S3.3, S3.4; [GolubPereyra1973].
NearestJoin nearestJoin(const JoinSide& a, const JoinSide& b, const NearestOptions& options = {});

}  // namespace seamwright
