// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/core/bspline/surface.hpp>

namespace seamwright {

/// What connects the two sides of a seam, in a form that neither side is preferred by; polynomials
/// of the seam's parameter in Bernstein form.
///
/// With P surface 0 (s out of it) and Q surface 1 (s into it), both along the same t, and all
/// parameters scaled to 0..1:
///   c Q_s    = d P_s + e P_t                                               (G1; c, d > 0)
///   c^2 Q_ss = d^2 P_ss + 2 d e P_st + e^2 P_tt + p P_s + q P_t            (G2)
/// With c = 1 these are Connection's alpha = d, beta = e, p, q. c, d, e times one factor (p, q
/// times its square) say the same.
struct SeamLaw {
  Eigen::VectorXd c = Eigen::VectorXd::Ones(1);
  Eigen::VectorXd d = Eigen::VectorXd::Ones(1);
  Eigen::VectorXd e = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd p = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(1);
};

/// One surface of a network; its weights must be equal (no rational surface).
struct NetworkSurface {
  BSplineSurface surface;
  bool moves = true;             ///< false: no pole of it moves
  Eigen::VectorXd weights = {};  ///< how dear a move of each pole is, > 0; empty: 1
  std::vector<bool> fixed = {};  ///< poles that stay; empty: none
};

/// A whole edge of one surface that is to join a whole edge of another (or of the same one). Its
/// parameter runs as the edge of surface 0 does.
struct NetworkSeam {
  std::array<int, 2> surfaces = {0, 1};
  std::array<PatchEdge, 2> edges = {PatchEdge::U1, PatchEdge::U0};
  bool reversed = false;  ///< the edge of surface 1 runs against it
  int order = 1;          ///< 1: G1, 2: G2
  std::optional<SeamLaw> held =
      std::nullopt;  ///< the law to be used, instead of one that is sought
};

struct NetworkOptions {
  /// A vertex of four surfaces is regular if its opposite seams are opposite to this angle; then
  /// they become so exactly.
  double regular_rad = 0.1;
  bool raise = true;        ///< degrees and multiplicities may be raised where a vertex demands it
  int max_iterations = 30;  ///< of the improvement of the laws
};

enum class SeamStatus {
  Joined,     ///< the law holds to rounding
  Unchanged,  ///< it held already, and no number of the network was changed
  Left,       ///< no join was found that agrees with the others: the seam took no part, see why
};

struct SeamJoin {
  SeamStatus status = SeamStatus::Left;
  int order =
      0;  ///< with which it joins: that asked for, or 1 where a vertex allows no more; see why
  double residual = 0;  ///< of the law, relative to the largest derivative in it; of a seam that is
                        ///< left: when it was given up
  SeamLaw law;
  std::string why;  ///< it is left, or joins with another order; empty otherwise
};

enum class NetworkStatus {
  Joined,        ///< all seams join with the orders asked for, and the move is stationary
  Unchanged,     ///< they did already: no number was changed
  NotConverged,  ///< they join, but a smaller move may exist
  Partly,        ///< some seams are left or join with a lower order
};

/// The smallest move that makes the surfaces of a network join.
struct NetworkResult {
  NetworkStatus status = NetworkStatus::Partly;
  std::vector<BSplineSurface> surfaces;
  std::vector<SeamJoin> seams;
  /// Of each surface: the largest move of a pole, in mm, compared with the same surface in the
  /// degrees and knots that it has now.
  std::vector<double> moves_mm;
  double largest_move_mm = 0;
  double cost = 0;  ///< sum of weight times squared move, in mm^2
  /// By how much the cost may still fall by better laws, relative to it; the search ends below
  /// 1e-10. 0 for no move.
  double stationarity = 0;
  int iterations = 0;
};

/// Moves the poles of a network of surfaces, as little as possible, so that all seams join exactly
/// at once, and agree where seams meet.
///
/// Sought is the smallest sum of weight |move|^2 over all poles for which each seam obeys a law of
/// the form above. Poles on a seam are shared. All laws together are one sparse linear system A x =
/// 0 of the poles; the nearest x is a projection, and the laws are improved by Gauss and Newton's
/// method until the cost falls no more. A pole that no seam needs keeps its bits, as do poles that
/// are fixed.
///
/// **Vertices** are the places where corners of surfaces meet; they follow from the seams that the
/// edges of a corner take part in. At a vertex that seams surround, the values of the laws have to
/// close: with r_i the tangents of the seams in turn and A_i = det(r_(i-1), r_i) in the tangent
/// plane, c : d : e = A_i : A_(i+1) : det(r_(i-1), r_(i+1)) (e with the sign of the seam's sense).
/// They are taken from tangents in one plane, so that no vertex collapses. Three sorts are told
/// apart:
///   - a regular vertex of two lines through four surfaces, as inside a grid: e (and q) is zero
///     along each seam that ends there, d / c (and p / d) one constant along each line. Degrees and
///     knots stay. G2 is possible.
///   - an extraordinary vertex of 3, 5, or more surfaces, or of 4 that is not regular: e is linear
///     between its values at the ends (quadratic towards a regular one). First d / c is constant on
///     each seam, with which bicubic patches can do. If the move with linear c and d and quadratic
///     e is less than half as large, those are used; surfaces come back in degree 4 along such
///     seams (inner knots: with one multiplicity more), as do all that the opposite edges are tied
///     to. An extraordinary vertex allows no G2 in general: such seams join with G1, and say so.
///   - a boundary vertex, which seams do not surround: the laws are free there, each seam having d
///     / c constant and e (and q) linear, or zero where inner knots are no smoother than that needs
///     (see nearestJoin()).
///
/// **What stays.** Surfaces and poles that are fixed keep every bit; seams between two of them
/// should be given too, as their laws rule those at the same vertices. A seam that is smooth
/// already is kept so by giving it, while its neighbours move.
///
/// **What cannot be.** Where the laws contradict each other or the fixed poles, seams are left out
/// step by step: of those that hang together by their surfaces that of the largest residual, until
/// the rest can be solved. Each says why. The surfaces are then joined along the others.
///
/// Identities (each has a test of its number):
///   (1) encloseSeam() of each seam that joins: a gap of 0, an angle and for order 2 a curvature
///       difference of rounding.
///   (2) The move is orthogonal to the solutions of A x = 0, and of two surfaces it is that of
///       nearestJoin() if the latter's laws are these.
///   (3) Rigid motion and scale of all surfaces move the result likewise.
///   (4) The order of surfaces and of seams, the sides of a seam and the sense of edges do not
///       change the result.
///   (5) A second call changes nothing.
///   (6) Poles that are fixed, and surfaces that do not move, keep every bit.
///
/// Time and memory are those of one sparse factorisation for each iteration.
///
/// \throws std::invalid_argument for surfaces that are none or rational, weights and fixed poles of
/// another number than the poles, weights that are not positive, seams that name no surface, an
/// edge in two seams or joined to itself, sides of other degree or knots along the seam (scaled to
/// 0..1), orders but 1 and 2, held laws with coefficients that are not finite or c, d not positive,
/// and options out of range: an angle not in [0, 1], fewer than 0 iterations.
/// Source: docs/theory/surfaces.md S2.6, S5.3, S6.1 to S6.3; docs/theory/fills.md F1.2 to F1.5.
NetworkResult nearestNetwork(const std::vector<NetworkSurface>& surfaces,
                             const std::vector<NetworkSeam>& seams,
                             const NetworkOptions& options = {});

}  // namespace seamwright
