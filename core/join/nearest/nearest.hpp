// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/core/join/connection.hpp>

namespace seamwright {

/// One of the two surfaces of a join.
struct JoinSide {
  BSplineSurface surface;
  PatchEdge edge = PatchEdge::U0;
  bool reversed = false;  ///< the seam's parameter runs against the edge's own sense
  bool moves = true;      ///< false: no pole of this surface moves
  Eigen::VectorXd weights =
      {};  ///< weight of each pole's move, > 0, in the order of the poles; empty: 1
  std::vector<bool> fixed = {};  ///< poles that stay, in the order of the poles; empty: none
};

struct NearestOptions {
  int order = 1;  ///< 1: G1, 2: G2
  /// Degrees of the connection functions that are sought, 0 to 6. \p degree_e1 and \p degree_e2 are
  /// used for rational surfaces only.
  int degree_alpha = 0, degree_beta = 1, degree_p = 0, degree_q = 1, degree_e1 = 0, degree_e2 = 0;
  /// Lower bound of alpha, as a share of the ratio of the sides' cross-boundary derivatives.
  double smallest_alpha = 1e-3;
  int max_iterations = 50;
  /// The connection functions to be used; nothing: they are sought. e0 must be 1. e1 and e2 must be
  /// 0 unless a surface is rational.
  std::optional<Connection> held = std::nullopt;
};

enum class NearestStatus {
  Joined,       ///< the join holds up to rounding and the move is stationary
  Unchanged,    ///< the join already held; no number was changed
  Infeasible,   ///< no join of these degrees was found; the surfaces are returned as given
  NotConverged  ///< the join holds up to rounding, but a smaller move may exist
};

/// The smallest move that makes two surfaces join.
struct NearestJoin {
  NearestStatus status = NearestStatus::Infeasible;
  BSplineSurface a, b;         ///< with the degrees and knots given
  Connection connection;       ///< of b to a; all parameters are scaled to 0..1
  double largest_move_mm = 0;  ///< of a pole
  double cost = 0;             ///< sum of weight times squared move, in mm^2
  /// Residual of the join: the largest length of the two sides' difference in the seam and in each
  /// equation of Connection, divided by the largest |Q_s| (and |Q_ss|), each in the scale of moves
  /// of poles. For an infeasible join it is the residual with the last connection tried. If fixed
  /// poles on both sides keep the seam open, no connection is tried and the residual is their
  /// distance.
  double residual = 0;
  /// Length of the move's component along the joins nearby, relative to the move; 0 for no move.
  double stationarity = 0;
  int iterations = 0;
};

/// Moves poles of two surfaces that nearly meet along one edge each, so that the surfaces join
/// exactly with G1 or G2. The move is as small as possible.
///
/// The function minimises the sum of weight |move|^2 over the poles of the first order + 1 rows of
/// both sides, and over the connection functions of the given degrees, subject to Connection's
/// equations with surface a as P and surface b as Q. The connection functions are polynomials of
/// the seam's parameter, the same on all spans. So the join holds at every parameter, not only at
/// sampled points. Degrees and knots stay. A pole that is fixed, or that belongs to a side that
/// does not move, stays bitwise; on the seam the other side moves to it.
///
/// The result is a local minimum. The search starts from the connection that fits the given
/// surfaces best. The residual is rounding: a few units in the last place of the coordinates,
/// divided by the distance of rows, and at most 1e-6.
///
/// **Inner knots along the seam.** If the rows are of class C^r at a knot, beta P_t is only of
/// class C^(r-1). So either beta (for G2 also q) vanishes there, or the seam has to become
/// smoother. Both are tried, and the smaller move is returned. With several simple knots the first
/// case gives beta = 0 on the whole seam. To keep beta free, raise the multiplicities before:
/// withRaisedKnots(surface, along(edge), order) on both sides changes neither surface, and gives
/// the rows the freedom that beta P_t needs. The natural degrees are constant alpha and p with
/// linear beta and q. If both sides move, connections of higher degrees force the rows to have less
/// than their degree; therefore connections of the natural degrees are tried too.
///
/// **Nothing to do.** If the surfaces already join up to rounding of their coordinates, no number
/// is changed. This is tested with connection functions of the given degrees, and of the degrees
/// (k, k + 1, 2k, 2k + 1) of alpha, beta, p, q for k = 0, 1, 2. The coefficients of alpha must be
/// above 1e-9 of the ratio of the sides' cross-boundary derivatives, so that rounding is not taken
/// for a positive alpha.
///
/// **Tangent planes.** A join is invalid if a side that had a tangent plane loses it. Both |P_s x
/// P_t| and |Q_s x Q_t| must stay above 1e-6 of their given values. Let N be P_s x P_t of surface a
/// with its seam moved to the mean of both seams. The component of P_s x P_t along N must stay
/// above |N| / 1000, so the normal turns by less than a right angle. This is tested at 4 degree + 1
/// parameters of each span. So a regular side does not join a fixed side whose seam, or whose
/// corner at the seam, is one point. Where a given side has no tangent plane, there is no such
/// demand, and the equations do not create a tangent plane. If all poles at an end of the seam stay
/// and the cross-boundary derivatives there are parallel, beta (and q) is zero at that end. This
/// keeps the seam's tangent from becoming parallel to them.
///
/// **Infeasible** means that no join was found that holds up to rounding, with tangent planes as
/// above and positive weights. Possible causes are fixed poles, knots, collapsed edges or corners,
/// weights that would have to become negative, and coordinates so large that their rounding leaves
/// a residual above 1e-6. The status does not prove that no join exists.
///
/// **Rational surfaces** move in homogeneous coordinates: weights move with the poles. The squared
/// move of a pole (w x, w) is |w dx + (x - m) dw|^2 / w^2 + (L dw / w)^2, with m the mean of the
/// seam's poles and L the size of the rows. It is |dx|^2 if the weight stays. Before the weights of
/// both sides are compared, those of b are divided by e0, a constant: the ratio of the seams'
/// weights. Weights stay positive.
///
/// Identities (each has a test of its number):
///   (1) encloseSeam() of the result gives a gap of 0, and an angle and for order 2 a curvature
///       difference that are rounding.
///   (2) The move is orthogonal to the joins nearby, and none of these joins has a smaller move.
///   (3) Rigid motion and scale of both surfaces act on the result in the same way.
///   (4) Reversal of the seam's parameter leaves the poles the same and changes the signs of beta
///       and q.
///   (5) Swapping the sides leaves the poles the same if alpha is constant and beta linear: then
///       alpha' = 1 / alpha, beta' = beta / alpha. (If alpha is not constant, 1 / alpha is not a
///       polynomial, and the swapped join is a different problem.)
///   (6) A second call changes nothing.
///
/// Each step takes one dense decomposition, whose time grows with the third power of the number of
/// spans.
///
/// \throws std::invalid_argument unless both sides have the same degree and knots along the seam
/// (scaled to 0..1); for orders other than 1 and 2, degrees outside 0 to 6, a share smallest_alpha
/// outside (0, 1], a negative number of iterations, weights that are not positive or whose number
/// differs from that of the poles, invalid surfaces (see requireValid()), a side without extent
/// across the seam, a held connection whose alpha has a coefficient that is not positive, and seams
/// of so many poles that the matrix has more than 1.5 million entries (about 220 cubic spans for
/// G2).
/// Source: docs/theory/surfaces.md S5.1 to S5.4, S2.5, S3.3; [GolubPereyra1973].
NearestJoin nearestJoin(const JoinSide& a, const JoinSide& b, const NearestOptions& options = {});

}  // namespace seamwright
