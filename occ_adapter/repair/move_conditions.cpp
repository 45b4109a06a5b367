// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/occ_adapter/repair/move_conditions.hpp>

namespace seamwright::occ {

void MoveConditions::addPoint(const std::vector<int>& poles, const Eigen::RowVectorXd& share,
                              const Eigen::Vector3d& point, double weight) {
  const Selected selected = select(poles, share);
  if (selected.numbers.empty()) return;
  const Eigen::RowVector3d now = sumOf(poles, share);
  system_.addPoint(selected.numbers, weight * selected.factors, weight * (point - now.transpose()));
}

void MoveConditions::add(const std::vector<int>& poles, const Eigen::MatrixXd& shares,
                         const Eigen::Vector3d& normal, const Eigen::VectorXd& values, double weight) {
  const Selected selected = select(poles, shares);
  if (selected.numbers.empty()) return;
  const Eigen::VectorXd now = sumOf(poles, shares) * normal;
  system_.add(selected.numbers, weight * selected.factors, normal, weight * (values - now));
}

void MoveConditions::addFairness(const std::vector<int>& poles, const Eigen::RowVectorXd& factors,
                                 double weight) {
  const Selected selected = select(poles, factors);
  if (!selected.numbers.empty())
    system_.addPoint(selected.numbers, weight * selected.factors, Eigen::Vector3d::Zero());
}

/// Of the poles that may move.
MoveConditions::Selected MoveConditions::select(const std::vector<int>& poles,
                                                const Eigen::MatrixXd& factors) const {
  Selected selected;
  std::vector<int> columns;
  for (std::size_t k = 0; k < poles.size(); ++k) {
    if (unknown_[poles[k]] < 0) continue;
    selected.numbers.push_back(unknown_[poles[k]]);
    columns.push_back(static_cast<int>(k));
  }
  selected.factors = factors(Eigen::all, columns);
  return selected;
}

Eigen::Matrix<double, Eigen::Dynamic, 3> MoveConditions::sumOf(const std::vector<int>& poles,
                                                               const Eigen::MatrixXd& shares) const {
  return shares * original_(poles, Eigen::all);
}

}  // namespace seamwright::occ
