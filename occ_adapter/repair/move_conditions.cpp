// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include <seamwright/occ_adapter/repair/move_conditions.hpp>

namespace seamwright::occ {

bool MoveConditions::canChange(const std::vector<int>& poles) const {
  return std::ranges::any_of(poles, [this](int pole) { return unknown_[pole] >= 0; });
}

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
  if (selected.numbers.empty()) return;
  Eigen::RowVector3d given = Eigen::RowVector3d::Zero();
  for (std::size_t k = 0; k < poles.size(); ++k)
    given += factors[static_cast<Eigen::Index>(k)] * (start_.row(poles[k]) - original_.row(poles[k]));
  system_.addSoft(selected.numbers, weight * selected.factors, -weight * given.transpose());
}

/// Of the poles that may move and have a part: along a natural side most functions are zero.
MoveConditions::Selected MoveConditions::select(const std::vector<int>& poles,
                                                const Eigen::MatrixXd& factors) const {
  constexpr double no_part = 1e-13;
  const double largest = factors.cwiseAbs().maxCoeff();
  Selected selected;
  std::vector<int> columns;
  for (std::size_t k = 0; k < poles.size(); ++k) {
    if (unknown_[poles[k]] < 0 ||
        factors.col(static_cast<Eigen::Index>(k)).cwiseAbs().maxCoeff() <= no_part * largest)
      continue;
    selected.numbers.push_back(unknown_[poles[k]]);
    columns.push_back(static_cast<int>(k));
  }
  selected.factors = factors(Eigen::indexing::all, columns);
  return selected;
}

Eigen::Matrix<double, Eigen::Dynamic, 3> MoveConditions::sumOf(const std::vector<int>& poles,
                                                               const Eigen::MatrixXd& shares) const {
  Eigen::Matrix<double, Eigen::Dynamic, 3> sum(shares.rows(), 3);
  sum.setZero();
  for (std::size_t k = 0; k < poles.size(); ++k)
    sum.noalias() += shares.col(static_cast<Eigen::Index>(k)) * start_.row(poles[k]);
  return sum;
}

}  // namespace seamwright::occ
