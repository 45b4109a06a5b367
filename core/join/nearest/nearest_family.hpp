// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/join/nearest/nearest_solver.hpp>

/// The families of connection functions in which a nearest join is sought; not a public header.
namespace seamwright::nearest {

void requireDegree(int degree, const char* name);

/// The inner knots without repetition, increasing.
std::vector<double> innerKnots(const SeamRows& rows);

/// The families to be tried: the given degrees; the given degrees with a constant alpha; and the
/// given degrees limited to the natural ones. beta and q are zero where the rows are not smooth
/// enough for other values.
std::vector<Family> familiesOf(const Unknowns& unknowns, const NearestOptions& options);

/// The family of joins whose seam becomes smoother than its knots, so that beta is free; nothing if
/// they cost more than the solution found.
std::optional<Family> smoothFamily(const Unknowns& unknowns, const Family& rough,
                                   const Solution& solution);

/// The families for which the join may already hold.
std::vector<Family> familiesThatMayHold(const NearestOptions& options, bool rational);

/// \throws std::invalid_argument as nearestJoin() does.
Family heldFamily(const ConnectionFunctions& held, const NearestOptions& options, bool rational);

ConnectionFunctions connectionOf(const Unknowns& unknowns, const Degrees& degrees,
                                 const Eigen::VectorXd& c);

}  // namespace seamwright::nearest
