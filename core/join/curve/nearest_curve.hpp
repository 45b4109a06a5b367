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
  /// What a moved pole costs: one a pole, positive; empty: 1. Infinite: the pole is fixed.
  Eigen::VectorXd costs_a, costs_b;
  std::optional<Eigen::VectorXd> beta;          ///< prescribed beta_1..beta_n; nothing: found
  double least_beta1 = 1e-3, most_beta1 = 1e3;  ///< of beta_1 divided by the measured |b'| / |a'|
  int max_iterations = 100;
};

enum class NearestCurveStatus {
  Solved,       ///< a smallest move, at least of those nearby
  Infeasible,   ///< the poles that may move cannot make the join
  NotConverged  ///< the join is made and exact, but may not be the nearest
};

/// The nearest join of two curves.
template <typename Curve>
struct NearestCurveJoin {
  Curve a, b;                 ///< the given ones where it is infeasible
  Eigen::VectorXd beta = {};  ///< by the parameters of the curves
  NearestCurveStatus status = NearestCurveStatus::Infeasible;
  double cost = 0;  ///< sum of cost_i |move_i|^2 / 2
  double largest_move_mm = 0;
  double residual = 0;  ///< the largest defect of the joint after it, as BetaFit::defects
  /// Share of the move that lies along the joins of other betas: the derivative of the cost by
  /// beta, without unit. 0 where beta is given or nothing moves; where the move is rounding, the
  /// share is too.
  double gradient = 0;
  int iterations = 0;
  std::string reason = {};  ///< why it is not solved; else empty
};

/// The smallest move of the poles of one or both curves that makes the end of a and the beginning
/// of b join exactly G^n. Only the last n + 1 poles of a and the first n + 1 of b can move (of a
/// B-spline those of its end span); weights stay.
///
/// For given beta the move is a projection on linear equations; beta is then found by a Newton
/// method with exact second derivatives on what is left as a function of beta, beta_1 = exp(u). It
/// starts from the beta that lets the arc lengths of both curves agree, which is that of a joint
/// that is exact. Where both curves move it searches from either side and takes the nearer join.
/// There may be several local minima where the curves are far from joining: it is one of those
/// nearby.
///
/// **Infeasible** is said, and the curves are as given, where poles that stay forbid the join,
/// where the search does not find one that holds to rounding, where a first derivative would fall
/// below 1e-6 of what it is, and where rounding leaves a defect above 1e-6 in units of the curves'
/// own derivatives by arc length (curves far too small for their distance from the origin).
///
/// **NotConverged** with beta_1 at its bound: curves that meet at more than a right angle, as a
/// rule. The nearer a join is, the shorter is a first derivative; there is no nearest one with a
/// tangent.
///
/// Identities (each has a test of its number):
///   (1) The joint is G^n: fitBeta() of the result leaves rounding.
///   (2) The cost is stationary in beta, and no join with beta nearby costs less.
///   (3) A joint that is G^n already does not move, but for rounding; its equations holding to
///       rounding, no bit changes.
///   (4) Rigid motion and scale go with it; exchanging both curves, reversed, mirrors it.
///   (5) Fixed poles do not change bit by bit.
/// \throws std::invalid_argument for an order, costs, betas out of range or of wrong number (index
/// and value); a degree below the order (elevate first); curves without tangent at the joint.
/// Source: docs/theory/curves.md C4.1 to C4.4.
NearestCurveJoin<BezierCurve> nearestJoin(const BezierCurve& a, const BezierCurve& b,
                                          const NearestCurveJoinOptions& options = {});
NearestCurveJoin<BSplineCurve> nearestJoin(const BSplineCurve& a, const BSplineCurve& b,
                                           const NearestCurveJoinOptions& options = {});

}  // namespace seamwright
