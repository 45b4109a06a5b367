// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>

#include <seamwright/core/join/network/network_model.hpp>
#include <seamwright/core/join/network/network_start.hpp>

namespace seamwright::network {

ConnectionModel::ConnectionModel(const Network& network, const Unknowns& unknowns, const Plan& plan)
    : network_(network),
      plan_(plan),
      parameters_(network::parametersOf(network, plan)),
      start_(startOf(network, unknowns, plan, parameters_)),
      directions_(freeDirections(plan, parameters_, start_)) {}

ConnectionFunctions ConnectionModel::at(int seam, const Eigen::VectorXd& y) const {
  return connectionAt(network_, plan_, parameters_, seam, y);
}

Eigen::VectorXd ConnectionModel::moved(const Eigen::VectorXd& y,
                                       const Eigen::VectorXd& step) const {
  return withoutExcess(plan_, parameters_, y + directions_ * step);
}

ConnectionFunctions ConnectionModel::derivative(int seam, const Eigen::VectorXd& y, int k) const {
  const double h = difference_step * (1 + std::abs(y(k)));
  Eigen::VectorXd trial = y;
  trial(k) = y(k) + h;
  ConnectionFunctions result = at(seam, trial);
  trial(k) = y(k) - h;
  const ConnectionFunctions below = at(seam, trial);
  const auto to = functions(result);
  const auto from = functions(below);
  for (int f = 0; f < function_count; ++f) *to[f] = (*to[f] - *from[f]) / (2 * h);
  return result;
}

ConnectionFunctions ConnectionModel::shape(int seam) const {
  if (network_.seams[seam].held) return *network_.seams[seam].held;
  ConnectionFunctions result = at(seam, start_);
  const SeamSlots& slots = parameters_.of_seam[seam];
  if (plan_.seams[seam].beta != SeamPlan::BetaForm::Zero) result.beta.setOnes();
  if (slots.share >= 0) result.p.setOnes();
  if (slots.q[0] >= 0) result.q.setOnes();
  return result;
}

}  // namespace seamwright::network
