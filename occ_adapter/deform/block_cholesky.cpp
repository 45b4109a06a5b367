// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
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

/// The points of blocks that are no multiples of the unit matrix.
std::vector<bool> coupledPoints(const BlockPattern& pattern, const std::vector<bool>& is_multiple) {
  std::vector<bool> is_coupled(pattern.size(), false);
  for (int j = 0; j < pattern.size(); ++j)
    for (int k = pattern.begins[j]; k < pattern.begins[j + 1]; ++k)
      if (!is_multiple[k]) is_coupled[j] = is_coupled[pattern.rows[k]] = true;
  return is_coupled;
}

std::vector<int> withCoupledLast(std::vector<int> order, const std::vector<bool>& is_coupled) {
  std::stable_partition(order.begin(), order.end(), [&](int point) { return !is_coupled[point]; });
  return order;
}

}  // namespace

int BlockCholesky::Front::row(int point) const {
  if (point < last) return point - first;
  return columns() + static_cast<int>(std::ranges::lower_bound(below, point) - below.begin());
}

double BlockCholesky::Analysis::work() const {
  double work = 0;
  for (const Front& front : fronts)
    work += std::pow(front.size(), 3) * front.columns() * std::pow(front.rows(), 2);
  return work;
}

BlockCholesky::BlockCholesky(const BlockPattern& pattern, const std::vector<bool>& is_multiple) {
  const std::vector<int> order = fillReducing(pattern);
  Analysis best = analysed(pattern, is_multiple, order);
  if (!is_multiple.empty()) {
    Analysis other =
        analysed(pattern, is_multiple, withCoupledLast(order, coupledPoints(pattern, is_multiple)));
    if (other.work() < best.work()) best = std::move(other);
  }
  position_ = std::move(best.position);
  fronts_ = std::move(best.fronts);
}

BlockCholesky::Analysis BlockCholesky::analysed(const BlockPattern& pattern,
                                                const std::vector<bool>& is_multiple,
                                                const std::vector<int>& order) {
  Analysis found;
  std::vector<int>& position = found.position;
  std::vector<Front>& fronts = found.fronts;
  position = inverse(order);
  const std::vector<int> later =
      inverse(postorder(eliminationTree(earlierNeighbours(pattern, position))));
  for (int& at : position) at = later[at];
  const std::vector<std::vector<int>> below = structures(earlierNeighbours(pattern, position));
  std::vector<bool> is_scalar(position.size(), !is_multiple.empty());
  for (int j = 0; j < pattern.size() && !is_multiple.empty(); ++j)
    for (int k = pattern.begins[j]; k < pattern.begins[j + 1]; ++k)
      if (!is_multiple[k]) is_scalar[std::min(position[pattern.rows[k]], position[j])] = false;
  for (std::size_t j = 0; j < below.size(); ++j)
    if (!is_scalar[j] && !below[j].empty()) is_scalar[below[j].front()] = false;
  fronts = amalgamated(below, is_scalar);
  std::vector<int> front_of(position.size());
  for (int f = 0; f < static_cast<int>(fronts.size()); ++f)
    std::fill(front_of.begin() + fronts[f].first, front_of.begin() + fronts[f].last, f);
  for (int f = 0; f < static_cast<int>(fronts.size()); ++f) {
    Front& front = fronts[f];
    if (front.below.empty()) continue;
    Front& parent = fronts[front_of[front.below.front()]];
    parent.children.push_back(f);
    for (const int point : front.below) front.in_parent.push_back(parent.row(point));
  }
  for (int j = 0; j < pattern.size(); ++j)
    for (int k = pattern.begins[j]; k < pattern.begins[j + 1]; ++k) {
      const auto [low, high] = std::minmax(position[pattern.rows[k]], position[j]);
      Front& front = fronts[front_of[low]];
      front.entries.push_back({k, front.row(high), low - front.first});
    }
  return found;
}

/// Columns one after another are one front if that stores few zero blocks.
std::vector<BlockCholesky::Front> BlockCholesky::amalgamated(
    const std::vector<std::vector<int>>& below, const std::vector<bool>& is_scalar) {
  // Shares of a front's blocks that may be zeros. They are choices that trade arithmetic on zeros
  // for larger dense blocks, and change the solution only by rounding. Fronts of up to 6 columns
  // (18 rows of numbers) are small: there the cost of assembly outweighs that of arithmetic.
  constexpr double few = 0.15, few_in_small = 0.5;
  constexpr int small = 6;
  std::vector<Front> fronts;
  for (int j = 0; j < static_cast<int>(below.size()); ++j) {
    Front front{j, j + 1, is_scalar[j], below[j]};
    while (!fronts.empty()) {
      const Front& child = fronts.back();
      if (child.below.empty() || child.below.front() >= front.last) break;
      if (child.is_scalar != front.is_scalar) break;
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

/// The matrix of a front: its own blocks and what its children leave, which is dropped.
Eigen::MatrixXd BlockCholesky::assembled(const Front& front,
                                         const std::vector<SymmetricBlock>& blocks,
                                         std::vector<Eigen::MatrixXd>& updates) const {
  const int all = front.size() * front.rows();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(all, all);
  for (const Entry& entry : front.entries) {
    const SymmetricBlock& b = blocks[entry.block];
    if (front.is_scalar) {
      matrix(entry.row, entry.column) += b[0];
      continue;
    }
    Eigen::Matrix3d block;
    block << b[0], b[3], b[5], b[3], b[1], b[4], b[5], b[4], b[2];
    matrix.block<3, 3>(3 * entry.row, 3 * entry.column) += block;
  }
  // Extend-add, by the relative indices of the child's rows.
  for (const int child : front.children) {
    const std::vector<int>& rows = fronts_[child].in_parent;
    const Eigen::MatrixXd& update = updates[child];
    for (int j = 0; j < std::ssize(rows); ++j)
      for (int i = j; i < std::ssize(rows); ++i)
        if (front.is_scalar)
          matrix(rows[i], rows[j]) += update(i, j);
        else if (fronts_[child].is_scalar)
          matrix.block<3, 3>(3 * rows[i], 3 * rows[j]).diagonal().array() += update(i, j);
        else
          matrix.block<3, 3>(3 * rows[i], 3 * rows[j]) += update.block<3, 3>(3 * i, 3 * j);
    updates[child].resize(0, 0);
  }
  return matrix;
}

bool BlockCholesky::factor(const std::vector<SymmetricBlock>& blocks, double diagonal) {
  // By front: its update matrix, the Schur complement that its parent's front assembles.
  std::vector<Eigen::MatrixXd> updates(fronts_.size());
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    Front& front = fronts_[f];
    const int own = front.size() * front.columns(), rest = front.size() * front.rows() - own;
    Eigen::MatrixXd matrix = assembled(front, blocks, updates);
    matrix.diagonal().head(own).array() += diagonal;
    auto corner = matrix.topLeftCorner(own, own);
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factored(corner);
    if (factored.info() != Eigen::Success) return false;
    auto lower = matrix.bottomLeftCorner(rest, own);
    corner.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(lower);
    matrix.bottomRightCorner(rest, rest).selfadjointView<Eigen::Lower>().rankUpdate(lower, -1);
    front.panel = matrix.leftCols(own);
    updates[f] = matrix.bottomRightCorner(rest, rest);
  }
  return true;
}

PointRows BlockCholesky::solve(const PointRows& right) const {
  PointRows x(right.rows(), 3);
  for (Eigen::Index k = 0; k < right.rows(); ++k) x.row(position_[k]) = right.row(k);
  // The rows of a front's points as its panel takes them: three columns, or one of all numbers.
  const auto with = [&x](const Front& front, const auto& act) {
    double* const data = x.row(front.first).data();
    if (front.is_scalar)
      act(Eigen::Map<PointRows>(data, front.columns(), 3));
    else
      act(Eigen::Map<Eigen::VectorXd>(data, 3 * front.columns()));
  };
  for (const Front& front : fronts_)
    with(front, [&](auto part) {
      using Rows = typename decltype(part)::PlainObject;
      front.panel.topRows(part.rows()).template triangularView<Eigen::Lower>().solveInPlace(part);
      const Rows change = front.panel.bottomRows(front.panel.rows() - part.rows()) * part;
      const Eigen::Map<const PointRows> changes(change.data(), std::ssize(front.below), 3);
      for (int k = 0; k < std::ssize(front.below); ++k) x.row(front.below[k]) -= changes.row(k);
    });
  for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front)
    with(*front, [&](auto part) {
      using Rows = typename decltype(part)::PlainObject;
      PointRows below(std::ssize(front->below), 3);
      for (int k = 0; k < below.rows(); ++k) below.row(k) = x.row(front->below[k]);
      const Eigen::Index rest = front->panel.rows() - part.rows();
      const Eigen::Map<const Rows> beyond(below.data(), rest, part.cols());
      part -= front->panel.bottomRows(rest).transpose() * beyond;
      front->panel.topRows(part.rows())
          .template triangularView<Eigen::Lower>()
          .transpose()
          .solveInPlace(part);
    });
  PointRows solution(right.rows(), 3);
  for (Eigen::Index k = 0; k < right.rows(); ++k) solution.row(k) = x.row(position_[k]);
  return solution;
}

}  // namespace seamwright::occ
