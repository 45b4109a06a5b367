// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include <seamwright/core/join/network/network_plan.hpp>

/// The parameters y that the connection functions of a network depend on; not a public header.
namespace seamwright::network {

/// Indices in y of the parameters of one seam; -1: the seam has no such parameter.
struct SeamSlots {
  int ratio = -1, share = -1;  ///< of its line: log(alpha / gamma), p / alpha
  /// log(alpha / gamma) at a boundary vertex, if gamma and alpha are linear.
  std::array<int, 2> end_ratio = {-1, -1};
  std::array<int, 2> beta = {-1, -1}, q = {-1, -1};  ///< at boundary vertices
  int tied = -1;                                     ///< of its line: beta at the boundary
  int bulge = -1;  ///< middle coefficient of a quadratic beta minus the mean of its ends
};

/// Where each parameter is in y. The parameters are logarithms of ratios, p / alpha, values of beta
/// and q at ends, and tangents at extraordinary vertices.
struct Parameters {
  int count = 0;
  std::vector<SeamSlots> of_seam;
  /// All parameters that the connection functions of each seam depend on.
  std::vector<std::vector<int>> all_of_seam;
  std::vector<int> extraordinary;  ///< first coordinate of the rays, per vertex; -1: other sorts
  std::vector<int> ratio, share, tied;  ///< per line; -1: none
};

/// Relative step of central differences. Their error is step^2, plus rounding divided by the step:
/// about 1e-10, the least up to a factor of a few.
constexpr double difference_step = 1e-5;

/// Share of the largest pivot below which derivatives by differences are insignificant. It is above
/// their error by a factor for elimination.
constexpr double least_pivot = 1e-7;

Parameters parametersOf(const Network& network, const Plan& plan);

/// The connection functions of a seam.
ConnectionFunctions connectionAt(const Network& network, const Plan& plan,
                                 const Parameters& parameters, int seam, const Eigen::VectorXd& y);

/// By the coordinates of the rays of an extraordinary vertex, the derivative of its excess: for
/// each spoke of a line the logarithm of the vertex's alpha / gamma minus that of the line. Rays
/// that stay have derivative 0.
Eigen::MatrixXd excessDerivative(const Plan& plan, const Parameters& parameters, int vertex,
                                 const Eigen::VectorXd& y);

/// The parameters with the rays of extraordinary vertices corrected so that their excess is zero,
/// as far as rays that stay allow.
Eigen::VectorXd withoutExcess(const Plan& plan, const Parameters& parameters, Eigen::VectorXd y);

}  // namespace seamwright::network
