// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include <seamwright/core/join/network/network_parameters.hpp>

/// The connection functions of a network as a model with parameters; not a public header.
namespace seamwright::network {

/// The connection functions of all seams, as functions of the parameters y.
class ConnectionModel {
 public:
  /// Keeps references to the network and the plan.
  /// \pre the plan has no obstacles.
  ConnectionModel(const Network& network, const Unknowns& unknowns, const Plan& plan);

  /// The parameters that fit the given poles.
  const Eigen::VectorXd& start() const { return start_; }
  /// The directions in which parameters may move, one per column: d y / d step, at the start.
  const Eigen::SparseMatrix<double>& directions() const { return directions_; }
  ConnectionFunctions at(int seam, const Eigen::VectorXd& y) const;
  /// The parameters after a step in the free directions. The tangents at extraordinary vertices are
  /// then corrected so that they give the ratios of the lines.
  Eigen::VectorXd moved(const Eigen::VectorXd& y, const Eigen::VectorXd& step) const;
  /// The parameters that the connection functions of a seam depend on.
  const std::vector<int>& parametersOf(int seam) const { return parameters_.all_of_seam[seam]; }
  /// d at(seam, y) / d y(k).
  ConnectionFunctions derivative(int seam, const Eigen::VectorXd& y, int k) const;
  /// Functions with the degrees of those of the seam. A coefficient is 1 if it may be nonzero.
  ConnectionFunctions shape(int seam) const;

 private:
  const Network& network_;
  const Plan& plan_;
  Parameters parameters_;
  Eigen::VectorXd start_;
  Eigen::SparseMatrix<double> directions_;
};

}  // namespace seamwright::network
