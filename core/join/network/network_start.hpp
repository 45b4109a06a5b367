// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <seamwright/core/join/network/network_parameters.hpp>

/// Where the search for the connection functions of a network starts; not a public header.
namespace seamwright::network {

/// The parameters that fit the given poles. Ratios come first, then the tangents at extraordinary
/// vertices that agree with them, then the values of beta and q that fit best with both.
Eigen::VectorXd startOf(const Network& network, const Unknowns& unknowns, const Plan& plan,
                        const Parameters& parameters);

/// The directions in which the parameters may move, one per column: d y / d step at the start.
Eigen::SparseMatrix<double> freeDirections(const Plan& plan, const Parameters& parameters,
                                           const Eigen::VectorXd& start);

}  // namespace seamwright::network
