// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <numeric>

#include <seamwright/occ_adapter/deform/block_cholesky.hpp>

namespace seamwright::occ {

namespace {

/// The points in an order of elimination that fills in little.
std::vector<int> fillReducing(const BlockPattern& pattern) {
  using Sparse = Eigen::SparseMatrix<double>;
  const std::vector<double> ones(pattern.rows.size(), 1);
  const Eigen::Map<const Sparse> matrix(pattern.size(), pattern.size(), std::ssize(pattern.rows),
                                        pattern.begins.data(), pattern.rows.data(), ones.data());
  Eigen::AMDOrdering<int>::PermutationType order;
  Eigen::AMDOrdering<int>()(Sparse(matrix).selfadjointView<Eigen::Upper>(), order);
  return {order.indices().begin(), order.indices().end()};
}

std::vector<int> inverse(const std::vector<int>& order) {
  std::vector<int> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) position[order[k]] = static_cast<int>(k);
  return position;
}

/// By position: the positions before it that stand in a block with it.
std::vector<std::vector<int>> earlierNeighbours(const BlockPattern& pattern,
                                                const std::vector<int>& position) {
  std::vector<std::vector<int>> earlier(position.size());
  for (int j = 0; j < pattern.size(); ++j)
    for (int k = pattern.begins[j]; k < pattern.begins[j + 1]; ++k) {
      const auto [low, high] = std::minmax(position[pattern.rows[k]], position[j]);
      if (low < high) earlier[high].push_back(low);
    }
  return earlier;
}

/// The parents in the tree of elimination, -1: none (Liu 1990, with compressed paths).
std::vector<int> eliminationTree(const std::vector<std::vector<int>>& earlier) {
  const int count = static_cast<int>(earlier.size());
  std::vector<int> parent(count, -1), ancestor(count, -1);
  for (int i = 0; i < count; ++i)
    for (int k : earlier[i])
      while (k != -1 && k < i) {
        const int next = ancestor[k];
        ancestor[k] = i;
        if (next == -1) parent[k] = i;
        k = next;
      }
  return parent;
}

/// Children before their parents, without anything between that is not theirs.
std::vector<int> postorder(const std::vector<int>& parent) {
  const int count = static_cast<int>(parent.size());
  std::vector<std::vector<int>> children(count);
  std::vector<int> order, pending;
  for (int k = 0; k < count; ++k)
    if (parent[k] >= 0)
      children[parent[k]].push_back(k);
    else
      pending.push_back(k);
  // Parents first, read backwards.
  while (!pending.empty()) {
    const int k = pending.back();
    pending.pop_back();
    order.push_back(k);
    pending.insert(pending.end(), children[k].begin(), children[k].end());
  }
  std::ranges::reverse(order);
  return order;
}

/// By column of the factor: its rows below the diagonal.
std::vector<std::vector<int>> structures(const std::vector<std::vector<int>>& earlier) {
  const int count = static_cast<int>(earlier.size());
  std::vector<std::vector<int>> below(count);
  for (int i = 0; i < count; ++i)
    for (const int k : earlier[i]) below[k].push_back(i);
  for (int j = 0; j < count; ++j) {
    std::ranges::sort(below[j]);
    below[j].erase(std::unique(below[j].begin(), below[j].end()), below[j].end());
    if (below[j].empty()) continue;
    // What a column has below goes on to the first of these.
    std::vector<int>& parent = below[below[j].front()];
    parent.insert(parent.end(), below[j].begin() + 1, below[j].end());
  }
  return below;
}

}  // namespace

int BlockCholesky::Front::row(int point) const {
  if (point < last) return point - first;
  return columns() + static_cast<int>(std::ranges::lower_bound(below, point) - below.begin());
}

BlockCholesky::BlockCholesky(const BlockPattern& pattern) {
  const std::vector<int> order = fillReducing(pattern);
  position_ = inverse(order);
  const std::vector<int> later =
      inverse(postorder(eliminationTree(earlierNeighbours(pattern, position_))));
  for (int& position : position_) position = later[position];
  fronts_ = amalgamated(structures(earlierNeighbours(pattern, position_)));
  std::vector<int> front_of(position_.size());
  for (int f = 0; f < static_cast<int>(fronts_.size()); ++f)
    std::fill(front_of.begin() + fronts_[f].first, front_of.begin() + fronts_[f].last, f);
  for (int f = 0; f < static_cast<int>(fronts_.size()); ++f) {
    Front& front = fronts_[f];
    if (front.below.empty()) continue;
    Front& parent = fronts_[front_of[front.below.front()]];
    parent.children.push_back(f);
    for (const int point : front.below) front.in_parent.push_back(parent.row(point));
  }
  for (int j = 0; j < pattern.size(); ++j)
    for (int k = pattern.begins[j]; k < pattern.begins[j + 1]; ++k) {
      const auto [low, high] = std::minmax(position_[pattern.rows[k]], position_[j]);
      Front& front = fronts_[front_of[low]];
      front.entries.push_back({k, front.row(high), low - front.first});
    }
}

/// Columns one after another are one front if that stores few zero blocks.
std::vector<BlockCholesky::Front> BlockCholesky::amalgamated(
    const std::vector<std::vector<int>>& below) const {
  // Shares of a front's blocks that may be zeros. They are choices that trade arithmetic on zeros
  // for larger dense blocks, and change the solution only by rounding. Fronts of up to 6 columns
  // (18 rows of numbers) are small: there the cost of assembly outweighs that of arithmetic.
  constexpr double few = 0.15, few_in_small = 0.5;
  constexpr int small = 6;
  std::vector<Front> fronts;
  for (int j = 0; j < static_cast<int>(below.size()); ++j) {
    Front front{j, j + 1, below[j]};
    while (!fronts.empty()) {
      const Front& child = fronts.back();
      if (child.below.empty() || child.below.front() >= front.last) break;
      const double zeros =
          child.zeros + front.zeros +
          static_cast<double>(child.columns()) *
              static_cast<double>(front.rows() - static_cast<int>(child.below.size()));
      const int columns = child.columns() + front.columns();
      const double blocks =
          columns * (static_cast<double>(front.below.size()) + 0.5 * (columns + 1));
      if (zeros > (columns <= small ? few_in_small : few) * blocks) break;
      front.first = child.first;
      front.zeros = zeros;
      fronts.pop_back();
    }
    fronts.push_back(std::move(front));
  }
  return fronts;
}

bool BlockCholesky::factor(const std::vector<SymmetricBlock>& blocks, double diagonal) {
  // By front: its update matrix, the Schur complement that its parent's front assembles.
  std::vector<Eigen::MatrixXd> updates(fronts_.size());
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    Front& front = fronts_[f];
    const int own = 3 * front.columns(), all = 3 * front.rows();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(all, all);
    for (const Entry& entry : front.entries) {
      const SymmetricBlock& b = blocks[entry.block];
      Eigen::Matrix3d block;
      block << b[0], b[3], b[5], b[3], b[1], b[4], b[5], b[4], b[2];
      matrix.block<3, 3>(3 * entry.row, 3 * entry.column) += block;
    }
    matrix.diagonal().head(own).array() += diagonal;
    // Extend-add, by the relative indices of the child's rows.
    for (const int child : front.children) {
      const std::vector<int>& rows = fronts_[child].in_parent;
      for (std::size_t j = 0; j < rows.size(); ++j)
        for (std::size_t i = j; i < rows.size(); ++i)
          matrix.block<3, 3>(3 * rows[i], 3 * rows[j]) +=
              updates[child].block<3, 3>(3 * static_cast<int>(i), 3 * static_cast<int>(j));
      updates[child].resize(0, 0);
    }
    auto corner = matrix.topLeftCorner(own, own);
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factored(corner);
    if (factored.info() != Eigen::Success) return false;
    auto lower = matrix.bottomLeftCorner(all - own, own);
    corner.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(lower);
    matrix.bottomRightCorner(all - own, all - own)
        .selfadjointView<Eigen::Lower>()
        .rankUpdate(lower, -1);
    front.panel = matrix.leftCols(own);
    updates[f] = matrix.bottomRightCorner(all - own, all - own);
  }
  return true;
}

PointRows BlockCholesky::solve(const PointRows& right) const {
  Eigen::VectorXd x(3 * right.rows());
  for (Eigen::Index k = 0; k < right.rows(); ++k)
    x.segment<3>(3 * position_[k]) = right.row(k).transpose();
  const auto gathered = [&x](const Front& front) {
    Eigen::VectorXd part(3 * static_cast<int>(front.below.size()));
    for (std::size_t k = 0; k < front.below.size(); ++k)
      part.segment<3>(3 * static_cast<int>(k)) = x.segment<3>(3 * front.below[k]);
    return part;
  };
  for (const Front& front : fronts_) {
    const int own = 3 * front.columns();
    auto part = x.segment(3 * front.first, own);
    front.panel.topRows(own).triangularView<Eigen::Lower>().solveInPlace(part);
    const Eigen::VectorXd change = front.panel.bottomRows(front.panel.rows() - own) * part;
    for (std::size_t k = 0; k < front.below.size(); ++k)
      x.segment<3>(3 * front.below[k]) -= change.segment<3>(3 * static_cast<int>(k));
  }
  for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front) {
    const int own = 3 * front->columns();
    auto part = x.segment(3 * front->first, own);
    part -= front->panel.bottomRows(front->panel.rows() - own).transpose() * gathered(*front);
    front->panel.topRows(own).triangularView<Eigen::Lower>().transpose().solveInPlace(part);
  }
  PointRows solution(right.rows(), 3);
  for (Eigen::Index k = 0; k < right.rows(); ++k)
    solution.row(k) = x.segment<3>(3 * position_[k]).transpose();
  return solution;
}

}  // namespace seamwright::occ
