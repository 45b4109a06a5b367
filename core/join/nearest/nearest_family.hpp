// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/join/nearest/nearest_solver.hpp>

/// Which connection functions a nearest join is sought among; not a public header.
namespace seamwright::nearest {

void requireDegree(int degree, const char* name);

/// Distinct, increasing.
std::vector<double> innerKnots(const SeamRows& rows);

/// Those of the degrees asked for, of these but for a constant alpha, and of the natural degrees at
/// most; with beta and q zero where the rows are not smooth enough for others.
std::vector<Family> familiesOf(const Unknowns& unknowns, const NearestOptions& options);

/// The joins whose seam becomes smoother than its knots, so that beta is free, unless they cost
/// more than the solution found.
std::optional<Family> smoothFamily(const Unknowns& unknowns, const Family& rough,
                                   const Solution& solution);

/// The degrees with which the join may hold already.
std::vector<Family> familiesThatMayHold(const NearestOptions& options, bool rational);

/// \throws std::invalid_argument as nearestJoin() does.
Family heldFamily(const Connection& held, const NearestOptions& options, bool rational);

Connection connectionOf(const Unknowns& unknowns, const Degrees& degrees, const Eigen::VectorXd& c);

}  // namespace seamwright::nearest
