// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/core/join/connection.hpp>

namespace seamwright {

/// One of the two surfaces of a join.
struct JoinSide {
  BSplineSurface surface;
  PatchEdge edge = PatchEdge::U0;
  bool reversed = false;    ///< the seam's parameter runs against the edge's own sense
  bool moves = true;        ///< false: no pole of this surface moves
  Eigen::VectorXd weights;  ///< how dear a move of each pole is, > 0, in the order of the poles; empty: 1
  std::vector<bool> fixed;  ///< poles that stay, in the order of the poles; empty: none
};

struct NearestOptions {
  int order = 1;  ///< 1: G1, 2: G2
  /// Degrees of the connection functions that are sought.
  int degree_alpha = 0, degree_beta = 1, degree_p = 0, degree_q = 1;
  double smallest_alpha =
      1e-3;  ///< share of the ratio of the sides' cross derivatives below which alpha may not fall
  int max_iterations = 50;
};

enum class NearestStatus {
  Joined,     ///< the join holds to rounding and the move is stationary
  Unchanged,  ///< the join held already; no number was changed
  Infeasible,  ///< the fixed poles, or the knots, allow no join of these degrees; the surfaces are returned as given
  NotConverged  ///< the join holds to rounding, but a smaller move may exist
};

/// The smallest move that makes two surfaces join.
struct NearestJoin {
  NearestStatus status = NearestStatus::Infeasible;
  BSplineSurface a, b;         ///< same degrees and knots as given
  Connection connection;       ///< of b to a, see Connection
  double largest_move_mm = 0;  ///< of a pole
  double cost = 0;             ///< sum of weight times squared move, in mm^2
  double residual = 0;         ///< of the join, relative to the cross derivatives
  double stationarity = 0;     ///< projected gradient relative to the size of the move
  int iterations = 0;
};

/// \throws std::invalid_argument unless both sides have the same degree and knots along the seam (scaled to 0..1).
NearestJoin nearestJoin(const JoinSide& a, const JoinSide& b, const NearestOptions& options = {});

}  // namespace seamwright
