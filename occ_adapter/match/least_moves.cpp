// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/SparseCholesky>

#include <seamwright/occ_adapter/match/least_moves.hpp>

namespace seamwright::occ {

void LeastMoves::fix(int point, const Eigen::Vector3d& move) {
  for (int c = 0; c < 3; ++c) fixed_[3 * point + c] = move[c];
}

void LeastMoves::add(const std::vector<int>& points, const Eigen::RowVectorXd& factors,
                     const Eigen::Vector3d& direction, double value) {
  const int row = static_cast<int>(values_.size());
  for (int j = 0; j < factors.size(); ++j)
    for (int c = 0; c < 3; ++c) {
      const int unknown = 3 * points[j] + c;
      const double entry = factors[j] * direction[c];
      if (entry == 0) continue;
      if (const auto fixed = fixed_.find(unknown); fixed != fixed_.end())
        value -= entry * fixed->second;
      else
        entries_.emplace_back(row, unknown, entry);
    }
  values_.push_back(value);
}

PointRows LeastMoves::solve(double damping) const {
  Eigen::SparseMatrix<double> a(static_cast<int>(values_.size()), unknowns_);
  a.setFromTriplets(entries_.begin(), entries_.end());
  const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(values_.data(), a.rows());
  Eigen::SparseMatrix<double> normal = a.transpose() * a;
  Eigen::SparseMatrix<double> identity(unknowns_, unknowns_);
  identity.setIdentity();
  normal += damping * damping * identity;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(normal);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(unknowns_);
  for (int pass = 0; pass < 3; ++pass)
    x += factors.solve(a.transpose() * (b - a * x) - damping * damping * x);
  for (const auto& [unknown, value] : fixed_) x[unknown] = value;
  return Eigen::Map<const PointRows>(x.data(), unknowns_ / 3, 3);
}

}  // namespace seamwright::occ
