// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/join/curve/nearest_curve_side.hpp>

/// The search for the beta whose join is nearest; not a public header.
/// Source: docs/theory/curves.md C4.2 to C4.4.
namespace seamwright::nearest_curve {

/// Everything is without unit: lengths by one of the joint, derivatives by parameters that pass at
/// one speed.
struct Problem {
  Side a, b;
  Eigen::VectorXd beta;  ///< to begin with, or for good if it is held
  bool held = false;
  double least_log = 0, most_log = 0;  ///< bounds of log beta_1
  double rounding = 0;                 ///< of a coordinate
  int max_iterations = 0;
};

struct Found {
  Eigen::VectorXd beta;
  Eigen::MatrixXd moves;    ///< of the poles of a, then of b
  double cost = 0;          ///< where the cheapest pole costs 1
  double stationarity = 0;  ///< share of the move that lies along the joins nearby
  bool exact = false;       ///< the equations of the join hold to rounding
  bool stationary = false;  ///< to rounding, and no join nearby is nearer
  bool bounded = false;     ///< beta_1 is at a bound that it would pass
  int iterations = 0;
};

/// Whether the equations of the join hold as the poles are, to rounding.
bool holds(const Problem& problem);

Found search(const Problem& problem);

}  // namespace seamwright::nearest_curve
