// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/core/bspline/surface.hpp>

namespace seamwright {

/// The law that connects the two sides of a seam, in a form that treats both sides alike. Its
/// functions are polynomials of the seam's parameter in Bernstein form.
///
/// Let P be surface 0 (s out of it) and Q surface 1 (s into it), both along the same t, with all
/// parameters scaled to 0..1:
///   c Q_s    = d P_s + e P_t                                               (G1; c, d > 0)
///   c^2 Q_ss = d^2 P_ss + 2 d e P_st + e^2 P_tt + p P_s + q P_t            (G2)
/// With c = 1 these are Connection's alpha = d, beta = e, p, q. The law stays the same if c, d, e
/// are multiplied by one factor and p, q by its square.
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
  Eigen::VectorXd weights = {};  ///< weight of each pole's move, > 0; empty: 1
  std::vector<bool> fixed = {};  ///< poles that stay; empty: none
};

/// A whole edge of one surface that has to join a whole edge of another surface (or of the same
/// one). The seam's parameter runs in the sense of the edge of surface 0.
struct NetworkSeam {
  std::array<int, 2> surfaces = {0, 1};
  std::array<PatchEdge, 2> edges = {PatchEdge::U1, PatchEdge::U0};
  bool reversed = false;  ///< the edge of surface 1 runs against it
  int order = 1;          ///< 1: G1, 2: G2
  /// The law to be used; nothing: it is sought.
  std::optional<SeamLaw> held = std::nullopt;
};

struct NetworkOptions {
  /// A vertex of four surfaces is regular if its opposite seams continue each other within this
  /// angle. Then they are made to do so exactly.
  double regular_rad = 0.1;
  bool raise = true;        ///< degrees and multiplicities may be raised where a vertex needs it
  int max_iterations = 30;  ///< of the improvement of the laws
};

enum class SeamStatus {
  Joined,     ///< the law holds to rounding
  Unchanged,  ///< the law already held, and no number of the network was changed
  Left,       ///< the seam is excluded: no join was found that agrees with the others, see why
};

struct SeamJoin {
  SeamStatus status = SeamStatus::Left;
  /// Order of the join: the given one, or 1 if a vertex does not allow more; see why.
  int order = 0;
  /// Of the law, relative to the largest derivative in it; for an excluded seam the residual when
  /// it was excluded.
  double residual = 0;
  SeamLaw law;
  std::string why;  ///< the reason why it is excluded or joins with another order; otherwise empty
};

enum class NetworkStatus {
  Joined,        ///< all seams join with the given orders, and the move is stationary
  Unchanged,     ///< they already did: no number was changed
  NotConverged,  ///< they join, but a smaller move may exist
  Partly,        ///< some seams are excluded or join with a lower order
};

/// The smallest move that makes the surfaces of a network join.
struct NetworkResult {
  NetworkStatus status = NetworkStatus::Partly;
  std::vector<BSplineSurface> surfaces;
  std::vector<SeamJoin> seams;
  /// Largest move of a pole of each surface, in mm, relative to the given surface raised to the
  /// resulting degrees and knots.
  std::vector<double> moves_mm;
  double largest_move_mm = 0;
  double cost = 0;  ///< sum of weight times squared move, in mm^2
  /// Decrease of the cost that better laws may still give, relative to the cost. The search ends
  /// below 1e-10. It is 0 for no move.
  double stationarity = 0;
  int iterations = 0;
};

/// Moves the poles of a network of surfaces, as little as possible, so that all seams join exactly
/// and agree at the vertices.
///
/// The function minimises the sum of weight |move|^2 over all poles such that each seam obeys a law
/// of the form above. Poles on a seam are shared. All laws together are one sparse linear system A
/// x = 0 of the poles, and the nearest x is a projection. The Gauss-Newton method improves the laws
/// until the cost no longer falls. Fixed poles, and poles that no seam needs, stay bitwise.
///
/// **Vertices** are the points where corners of surfaces meet. They are found from the seams of the
/// edges of a corner. At a vertex that seams surround, the values of the laws have to close: with
/// r_i the tangents of the seams in turn and A_i = det(r_(i-1), r_i) in the tangent plane, c : d :
/// e = A_i : A_(i+1) : det(r_(i-1), r_(i+1)) (e with the sign of the seam's sense). They are
/// computed from tangents in one plane, so that no vertex collapses. There are three sorts of
/// vertices:
///   - a regular vertex, where two lines cross between four surfaces, as inside a grid. e (and q)
///     is zero along each seam that ends there, and d / c (and p / d) is one constant along each
///     line. Degrees and knots stay. G2 is possible.
///   - an extraordinary vertex of 3, 5 or more surfaces, or of 4 if it is not regular. e is linear
///     between its values at the ends (quadratic towards a regular vertex). In the first attempt d
///     / c is constant on each seam, which is sufficient for bicubic patches. If the move with
///     linear c and d and quadratic e is less than half as large, those laws are used. Then
///     surfaces are returned in degree 4 along such seams (inner knots with one multiplicity more),
///     and so are all surfaces that are tied to them by opposite edges. An extraordinary vertex
///     does not allow G2 in general: such seams join with G1, and the result says so.
///   - a boundary vertex, which seams do not surround. The laws are free there. On each seam d / c
///     is constant and e (and q) is linear, or zero if the rows are not smooth enough at inner
///     knots (see nearestJoin()).
///
/// **What stays.** Surfaces and poles that are fixed stay bitwise. Give the seams between two fixed
/// surfaces too, because their laws determine the laws at the same vertices. A seam that is already
/// smooth stays smooth if it is given, while its neighbours move.
///
/// **What cannot be.** If the laws contradict each other or the fixed poles, seams are excluded
/// step by step until the rest can be solved. From each group of such seams that are connected by
/// surfaces the seam of the largest residual is excluded. Each excluded seam has a reason. The
/// surfaces are joined along the other seams.
///
/// Identities (each has a test of its number):
///   (1) encloseSeam() of each seam that joins gives a gap of 0, and an angle and for order 2 a
///       curvature difference that are rounding.
///   (2) The move is orthogonal to the solutions of A x = 0. For two surfaces it is the move of
///       nearestJoin() if that function finds the same laws.
///   (3) Rigid motion and scale of all surfaces act on the result in the same way.
///   (4) The order of surfaces and of seams, the sides of a seam and the sense of edges do not
///       change the result.
///   (5) A second call changes nothing.
///   (6) Poles that are fixed, and surfaces that do not move, stay bitwise.
///
/// Each iteration takes the time and memory of one sparse factorisation.
///
/// \throws std::invalid_argument for surfaces that are invalid or rational, weights or fixed poles
/// whose number differs from that of the poles, weights that are not positive, seams that name no
/// surface, an edge that is in two seams or joined to itself, sides whose degrees or knots along
/// the seam (scaled to 0..1) differ, orders other than 1 and 2, held laws with coefficients that
/// are not finite or with c or d not positive, and options out of range: an angle outside [0, 1], a
/// negative number of iterations.
/// Source: docs/theory/surfaces.md S2.6, S5.3, S6.1 to S6.3; docs/theory/fills.md F1.2 to F1.5.
NetworkResult nearestNetwork(const std::vector<NetworkSurface>& surfaces,
                             const std::vector<NetworkSeam>& seams,
                             const NetworkOptions& options = {});

}  // namespace seamwright
