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
      {};  ///< how dear a move of each pole is, > 0, in the order of the poles; empty: 1
  std::vector<bool> fixed = {};  ///< poles that stay, in the order of the poles; empty: none
};

struct NearestOptions {
  int order = 1;  ///< 1: G1, 2: G2
  /// Degrees of the connection functions that are sought, 0 to 6. \p degree_e1, \p degree_e2: of
  /// rational surfaces only.
  int degree_alpha = 0, degree_beta = 1, degree_p = 0, degree_q = 1, degree_e1 = 0, degree_e2 = 0;
  double smallest_alpha =
      1e-3;  ///< share of the ratio of the sides' cross derivatives below which alpha may not fall
  int max_iterations = 50;
  /// The connection functions to be used, instead of those that are sought. e0 must be 1; e1 and e2
  /// 0 unless a surface is rational.
  std::optional<Connection> held = std::nullopt;
};

enum class NearestStatus {
  Joined,       ///< the join holds to rounding and the move is stationary
  Unchanged,    ///< the join held already; no number was changed
  Infeasible,   ///< no join of these degrees was found, see below; the surfaces are returned as
                ///< given
  NotConverged  ///< the join holds to rounding, but a smaller move may exist
};

/// The smallest move that makes two surfaces join.
struct NearestJoin {
  NearestStatus status = NearestStatus::Infeasible;
  BSplineSurface a, b;         ///< same degrees and knots as given
  Connection connection;       ///< of b to a, see Connection; all parameters scaled to 0..1
  double largest_move_mm = 0;  ///< of a pole
  double cost = 0;             ///< sum of weight times squared move, in mm^2
  /// Of the join: largest length of the two sides' difference in the seam and in each condition of
  /// Connection, over the largest |Q_s| (and
  /// |Q_ss|), each in the scale of moves of poles. What is left of an infeasible one at the
  /// connection that was tried last; where poles that stay on both sides keep the seam open none is
  /// tried, and it is their distance.
  double residual = 0;
  double stationarity =
      0;  ///< length of the move's part along the joins nearby, relative to the move; 0 for no move
  int iterations = 0;
};

/// Moves poles of two surfaces that nearly meet along an edge of each, as little as possible, so
/// that they join with G1 or G2 exactly.
///
/// Sought are the smallest sum of weight |move|^2 over the poles of the first order + 1 rows of
/// both sides, and with it the connection functions of the degrees asked for, such that
/// Connection's equations hold, P being surface a and Q surface b. They are polynomials of the
/// seam's parameter, the same on all spans between knots, so the join holds everywhere and not at
/// points. Degrees and knots stay. A pole that is fixed, or of a side that does not move, stays to
/// the bit; on the seam it is met by the other side.
///
/// The result is a local minimum, found from the connection that fits the surfaces as they are. Its
/// residual is rounding: a few units in the last place of the coordinates, divided by the distance
/// of rows, and 1e-6 at most.
///
/// **Inner knots along the seam.** Where the rows are of class C^r at a knot, beta P_t is only of
/// class C^(r-1). So either beta vanishes there (and q, for G2), or the seam has to become
/// smoother. Both are tried, and the smaller move is returned; with several simple knots this is
/// beta = 0 throughout. To let beta be free without that, raise the multiplicities first:
/// withRaisedKnots(surface, along(edge), order) on both sides changes neither surface, and gives
/// the rows the freedom that beta P_t needs. Connections of more than the natural degrees (alpha, p
/// constant, beta, q linear) ask the rows to have less than their degree where both sides move;
/// those of the natural degrees are tried as well.
///
/// **Nothing to do.** If the surfaces join already, to rounding of their coordinates, with
/// connection functions of the degrees asked for or of the degrees (k, k + 1, 2k, 2k + 1) of alpha,
/// beta, p, q for k = 0, 1, 2, no number is changed. Coefficients of alpha above 1e-9 of the ratio
/// of the sides' cross derivatives are asked for, so that rounding is not taken for a positive
/// alpha.
///
/// **Tangent planes.** A join that takes the tangent plane from a side which had one is none.
/// Neither |P_s x P_t| nor |Q_s x Q_t| may fall to 1e-6 of what it is in the surface as given; and
/// P_s x P_t, with the seam between both, neither to 1/1000 nor turn by a right angle. That is
/// looked at in 4 degree + 1 places of each span. So a regular side does not join one that stays
/// and has its seam, or a corner at the seam, in one point. Where a side has no tangent plane as
/// given, nothing is asked, and the equations do not make one. Where all poles of an end of the
/// seam stay and the cross derivatives there are parallel, beta (and q) is zero at that end, which
/// keeps the seam's tangent from turning into them.
///
/// **Infeasible** is said if no join was found that holds to rounding, with tangent planes as above
/// and positive weights. Poles that stay, knots, collapsed edges or corners, weights that would
/// have to become negative can be the cause, and coordinates so large that their rounding leaves a
/// residual above 1e-6. It does not prove that there is none.
///
/// **Rational surfaces** move in homogeneous coordinates, weights with poles. The squared move of a
/// pole (w x, w) is |w dx + (x - m) dw|^2 / w^2 + (L dw / w)^2, with m the mean of the seam's poles
/// and L the size of the rows: |dx|^2 where the weight stays. The weights of both sides are
/// compared after division of those of b by e0, which is constant: the ratio of the seams' weights.
/// Weights stay positive.
///
/// Identities (each has a test of its number):
///   (1) encloseSeam() of the result: a gap of 0, an angle and for order 2 a curvature difference
///       of rounding.
///   (2) The move is orthogonal to the joins nearby, and no join nearby is nearer.
///   (3) Rigid motion and scale of both surfaces move the result likewise.
///   (4) Reversal of the seam's parameter changes the poles not at all, beta and q by their signs.
///   (5) Swapping the sides changes the poles not at all if alpha is constant and beta linear: then
///       alpha' = 1 / alpha, beta' = beta / alpha. (1 / alpha is no polynomial where alpha is not
///       constant: such a join is another problem when swapped.)
///   (6) A second call changes nothing.
///
/// The time is that of a dense decomposition for each step, which grows with the third power of the
/// number of spans.
///
/// \throws std::invalid_argument unless both sides have the same degree and knots along the seam
/// (scaled to 0..1); for orders but 1 and 2, degrees but 0 to 6, a share smallest_alpha that is not
/// in (0, 1], fewer than 0 iterations, weights that are not positive or of another number than the
/// poles, surfaces that are none (see requireValid()), a side without extent across the seam, a
/// held connection with an alpha that has a coefficient that is not positive, and seams of so many
/// poles that the matrix has more than 1.5 million entries (about 220 cubic spans for G2).
/// Source: docs/theory/surfaces.md S5.1 to S5.4, S2.5, S3.3; [GolubPereyra1973].
NearestJoin nearestJoin(const JoinSide& a, const JoinSide& b, const NearestOptions& options = {});

}  // namespace seamwright
