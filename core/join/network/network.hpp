// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/core/join/connection_functions.hpp>

namespace seamwright {

/// One surface of a network; not rational.
struct NetworkSurface {
  BSplineSurface surface;
  bool moves = true;             ///< false: no pole of it moves
  Eigen::VectorXd weights = {};  ///< weight of each pole's move, > 0; empty: 1
  std::vector<bool> fixed = {};  ///< poles that stay; empty: none
};

/// Two whole edges, of two surfaces or of one, that have to join. The parameter runs in the sense
/// of the edge of surface 0.
struct NetworkSeam {
  std::array<int, 2> surfaces = {0, 1};
  std::array<PatchEdge, 2> edges = {PatchEdge::U1, PatchEdge::U0};
  bool reversed = false;  ///< the edge of surface 1 runs against it
  int order = 1;          ///< 1: G1, 2: G2
  /// The connection functions to be used, with e0 = 1, e1 = e2 = 0; nothing: they are sought.
  std::optional<ConnectionFunctions> held = std::nullopt;
};

struct NetworkOptions {
  /// A vertex of four surfaces is regular, and made so exactly, if its opposite seams continue each
  /// other within this angle, in [0, 1].
  double regular_rad = 0.1;
  bool raise = true;        ///< degrees and multiplicities may be raised
  int max_iterations = 30;  ///< of the improvement of the connection functions
};

enum class SeamStatus {
  Joined,     ///< the equations of the join hold to rounding
  Unchanged,  ///< the sides already joined, and no number of the network was changed
  Left,       ///< the seam is excluded, see why
};

struct SeamJoin {
  SeamStatus status = SeamStatus::Left;
  int order = 0;  ///< of the join: the given one, or 1 if a vertex does not allow more
  /// Relative to the largest derivative in the equations.
  double residual = 0;
  ConnectionFunctions connection = {};  ///< of surface 1 to surface 0
  std::string why = {};  ///< why it is excluded or joins with another order; otherwise empty
};

enum class NetworkStatus {
  Joined,        ///< all seams join with the given orders, and the move is stationary
  Unchanged,     ///< they already did: no number was changed
  NotConverged,  ///< they join, but a smaller move may exist
  Partly,        ///< some seams are excluded or join with a lower order
};

struct NetworkResult {
  NetworkStatus status = NetworkStatus::Partly;
  std::vector<BSplineSurface> surfaces;
  std::vector<SeamJoin> seams;
  /// Largest move of a pole of each surface, from the given surface in the new degrees and knots.
  std::vector<double> moves_mm;
  double largest_move_mm = 0;
  double cost = 0;  ///< sum of weight times squared move, in mm^2
  /// Decrease that better connection functions may still give, relative to the cost. The search
  /// ends below 1e-10.
  double stationarity = 0;
  int iterations = 0;
};

/// Moves the poles of a network of surfaces, as little as possible, so that all seams join exactly
/// and agree at the vertices.
///
///     nearestNetwork({{.surface = a}, {.surface = b}}, {{.surfaces = {0, 1}}}).surfaces
///
/// Minimises the sum of weight |move|^2 over all poles such that each seam satisfies the equations
/// of ConnectionFunctions with surface 0 as P, surface 1 as Q and all parameters scaled to 0..1.
/// Poles on a seam are shared. The result is a local minimum. At a regular vertex of S6.2 degrees
/// and knots stay, and G2 is possible. At an extraordinary one G1 alone is, and surfaces beside it,
/// and those tied to them by opposite edges, may get degree 4 along the seams.
///
/// Give seams between fixed surfaces and smooth seams too. While equations contradict each other or
/// fixed poles, the seam of the largest residual is excluded.
///
/// Identities (each has a test of its number):
///   (1) encloseSeam() of each seam that joins gives a gap of 0, and an angle and for order 2 a
///       curvature difference of rounding.
///   (2) The move is orthogonal to the solutions of the joins' equations. For two surfaces it is
///       that of nearestJoin() if both find the same connection.
///   (3) Rigid motion and scale of all surfaces act on the result in the same way.
///   (4) Order of surfaces and seams, sides of seams and senses of edges do not matter.
///   (5) A second call changes nothing.
///   (6) Poles that are fixed, and surfaces that do not move, stay bitwise.
///
/// \throws std::invalid_argument for surfaces that are invalid or rational, lists whose length is
/// not the number of poles, weights that are not positive, seams of no surface, an edge in two
/// seams or joined to itself, sides whose degrees or knots along the seam (scaled to 0..1) differ,
/// held connections that are not finite, or with alpha or gamma not positive, and options out of
/// range. Source: docs/theory/surfaces.md S2.6, S5.3, S6.1 to S6.3; docs/theory/fills.md F1.2 to
/// F1.5.
NetworkResult nearestNetwork(const std::vector<NetworkSurface>& surfaces,
                             const std::vector<NetworkSeam>& seams,
                             const NetworkOptions& options = {});

}  // namespace seamwright
