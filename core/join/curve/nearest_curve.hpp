// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/bspline/curve.hpp>

namespace seamwright {

struct NearestCurveJoinOptions {
  enum class Moves { A, B, Both };

  int order = 1;  ///< n of G^n, 1 to 10
  Moves moves = Moves::Both;
  /// Weights of the moves, one per pole, positive; empty: all 1. Infinite: the pole is fixed.
  Eigen::VectorXd costs_a, costs_b;
  std::optional<Eigen::VectorXd> beta;  ///< prescribed beta_1..beta_n; nothing: found
  /// Bounds of beta_1, relative to the measured |b'| / |a'|.
  double least_beta1 = 1e-3, most_beta1 = 1e3;
  int max_iterations = 100;
};

enum class NearestCurveStatus {
  Solved,       ///< the move is a local minimum
  Infeasible,   ///< the join is not possible with the poles that may move
  NotConverged  ///< the join is exact, but a smaller move may exist
};

/// The nearest join of two curves.
template <typename Curve>
struct NearestCurveJoin {
  Curve a, b;                 ///< the given curves if the join is infeasible
  Eigen::VectorXd beta = {};  ///< by the parameters of the curves
  NearestCurveStatus status = NearestCurveStatus::Infeasible;
  double cost = 0;  ///< sum of cost_i |move_i|^2 / 2
  double largest_move_mm = 0;
  double residual = 0;  ///< the largest defect of the resulting joint, as BetaFit::defects
  /// Share of the move that lies along the joins of other betas: the dimensionless derivative of
  /// the cost by beta. It is 0 if beta is given or nothing moves. If the move is only rounding, so
  /// is the share.
  double gradient = 0;
  int iterations = 0;
  std::string reason = {};  ///< why it is not solved; otherwise empty
};

/// The smallest move of the poles of one or both curves after which the end of a and the beginning
/// of b join exactly G^n. Only the last n + 1 poles of a and the first n + 1 poles of b can move
/// (for a B-spline those of its end span). Weights stay.
///
/// For given beta the move is a projection onto the solutions of linear equations. The remaining
/// cost is a function of beta, with beta_1 = exp(u); a Newton method with exact second derivatives
/// minimises it. The search starts from the beta for which the arc lengths of both curves agree;
/// for an exact joint this is the solution. If both curves move, it searches from either side and
/// takes the nearer join. There may be several local minima if the curves are far from a join; the
/// result is one of those nearby.
///
/// **Infeasible** means that the curves are returned as given. The causes are: fixed poles forbid
/// the join; the search finds no join that holds up to rounding; a first derivative would fall
/// below 1e-6 of its given length; or rounding leaves a defect above 1e-6, in units of the curves'
/// own derivatives by arc length (the curves are too small for their distance from the origin).
///
/// **NotConverged** with beta_1 at its bound usually means that the curves meet at more than a
/// right angle. Then nearer joins have shorter first derivatives, and there is no nearest join with
/// a tangent.
///
/// Identities (each has a test of its number):
///   (1) The joint is G^n: the defects of fitBeta() for the result are rounding.
///   (2) The cost is stationary in beta, and joins with a beta nearby do not cost less.
///   (3) A joint that is already G^n moves by rounding at most. If its equations hold up to
///       rounding, it stays bitwise.
///   (4) Rigid motion and scale act on the result in the same way. If both curves are exchanged and
///       reversed, the result is exchanged and reversed.
///   (5) Fixed poles stay bitwise.
/// \throws std::invalid_argument for an order, costs or betas that are out of range or of the wrong
/// number (index and value); for a degree below the order (elevate before); and for curves without
/// tangent at the joint.
/// Source: docs/theory/curves.md C4.1 to C4.4.
NearestCurveJoin<BezierCurve> nearestJoin(const BezierCurve& a, const BezierCurve& b,
                                          const NearestCurveJoinOptions& options = {});
NearestCurveJoin<BSplineCurve> nearestJoin(const BSplineCurve& a, const BSplineCurve& b,
                                           const NearestCurveJoinOptions& options = {});

}  // namespace seamwright
