// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <limits>

#include <seamwright/occ_adapter/repair/step_system.hpp>

namespace seamwright::occ {

namespace {

/// The block pattern: the diagonal and all pairs of points within a cell.
BlockPattern patternOf(int points, const std::vector<std::vector<int>>& cells) {
  std::vector<std::vector<int>> rows(points);
  for (int j = 0; j < points; ++j) rows[j].push_back(j);
  for (const std::vector<int>& cell : cells)
    for (std::size_t j = 0; j < cell.size(); ++j)
      rows[cell[j]].insert(rows[cell[j]].end(), cell.begin(),
                           cell.begin() + static_cast<std::ptrdiff_t>(j));
  BlockPattern pattern;
  for (std::vector<int>& column : rows) {
    std::ranges::sort(column);
    column.erase(std::unique(column.begin(), column.end()), column.end());
    pattern.rows.insert(pattern.rows.end(), column.begin(), column.end());
    pattern.begins.push_back(static_cast<int>(pattern.rows.size()));
  }
  return pattern;
}

std::vector<int> positionsOf(const std::vector<int>& cell, const BlockPattern& pattern) {
  std::vector<int> positions;
  positions.reserve(cell.size() * (cell.size() + 1) / 2);
  for (std::size_t j = 0; j < cell.size(); ++j) {
    const auto first = pattern.rows.begin() + pattern.begins[cell[j]];
    const auto last = pattern.rows.begin() + pattern.begins[cell[j] + 1];
    for (std::size_t i = 0; i <= j; ++i)
      positions.push_back(
          static_cast<int>(std::lower_bound(first, last, cell[i]) - pattern.rows.begin()));
  }
  return positions;
}

}  // namespace

StepSystem::StepSystem(int points, std::vector<std::vector<int>> cells)
    : cells_(std::move(cells)), cholesky_(BlockPattern{}) {
  const BlockPattern pattern = patternOf(points, cells_);
  for (const std::vector<int>& cell : cells_) positions_.push_back(positionsOf(cell, pattern));
  for (int j = 0; j < points; ++j) diagonal_.push_back(pattern.begins[j + 1] - 1);
  cholesky_ = BlockCholesky(pattern);
  blocks_.assign(pattern.rows.size(), SymmetricBlock::Zero());
  right_ = PointRows::Zero(points, 3);
}

void StepSystem::clear() {
  std::ranges::fill(blocks_, SymmetricBlock::Zero());
  right_.setZero();
}

template <class Take>
void StepSystem::forPairs(int cell, const Eigen::VectorXd& factors, const Take& take) {
  const int* position = positions_[cell].data();
  for (Eigen::Index j = 0; j < factors.size(); ++j, position += j)
    if (const double own = factors[j]; own != 0)
      for (Eigen::Index i = 0; i <= j; ++i)
        if (factors[i] != 0) take(blocks_[position[i]], own * factors[i]);
}

void StepSystem::add(int cell, const Eigen::VectorXd& factors, const Eigen::Vector3d& direction,
                     double value) {
  const Eigen::Vector3d& d = direction;
  SymmetricBlock square;
  square << d[0] * d[0], d[1] * d[1], d[2] * d[2], d[0] * d[1], d[1] * d[2], d[2] * d[0];
  forPairs(cell, factors,
           [&square](SymmetricBlock& block, double product) { block += product * square; });
  for (std::size_t k = 0; k < cells_[cell].size(); ++k)
    right_.row(cells_[cell][k]) += factors[static_cast<Eigen::Index>(k)] * value * d.transpose();
}

void StepSystem::addPoint(int cell, const Eigen::VectorXd& factors, const Eigen::Vector3d& value) {
  forPairs(cell, factors,
           [](SymmetricBlock& block, double product) { block.head<3>().array() += product; });
  for (std::size_t k = 0; k < cells_[cell].size(); ++k)
    right_.row(cells_[cell][k]) += factors[static_cast<Eigen::Index>(k)] * value.transpose();
}

void StepSystem::addEnergy(int cell, const Eigen::MatrixXd& matrix, const PointRows& gradient) {
  const int* position = positions_[cell].data();
  for (Eigen::Index j = 0; j < matrix.cols(); ++j, position += j)
    for (Eigen::Index i = 0; i <= j; ++i) blocks_[position[i]].head<3>().array() += matrix(i, j);
  for (std::size_t k = 0; k < cells_[cell].size(); ++k)
    right_.row(cells_[cell][k]) -= gradient.row(static_cast<Eigen::Index>(k));
}

void StepSystem::addDamping(int point, double factor, const Eigen::Vector3d& at) {
  blocks_[diagonal_[point]].head<3>().array() += factor;
  right_.row(point) -= factor * at.transpose();
}

void StepSystem::damp(double share) {
  for (const int position : diagonal_) blocks_[position].head<3>() *= 1 + share;
}

PointRows StepSystem::solve() {
  double largest = 0;
  for (const SymmetricBlock& block : blocks_)
    largest = std::max(largest, block.head<3>().maxCoeff());
  double raised = 0;
  while (!cholesky_.factor(blocks_, raised)) {
    // Rounding may make a singular matrix indefinite. The least addition that helps changes the
    // solution least, so it starts at rounding and grows by tens.
    raised = std::max(10 * raised, std::numeric_limits<double>::epsilon() * largest);
    if (!(raised > 0) || !(raised <= largest)) return PointRows::Zero(right_.rows(), 3);
  }
  return cholesky_.solve(right_);
}

}  // namespace seamwright::occ
