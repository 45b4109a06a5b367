// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/SparseCholesky>
#include <algorithm>

#include <seamwright/occ_adapter/match/least_moves.hpp>

namespace seamwright::occ {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// The places of points in an order of elimination that fills in little.
Eigen::VectorXi placesOf(const SparseMatrix& pattern) {
  Eigen::AMDOrdering<int>::PermutationType from;
  Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Upper>(), from);
  const Eigen::AMDOrdering<int>::PermutationType to = from.inverse();
  return to.indices();
}

}  // namespace

/// The blocks of the normal matrix on and above its diagonal, by columns.
struct LeastMoves::Normal {
  std::vector<int> begins = {0}, rows;
  std::vector<Eigen::Matrix3d> blocks;

  int points() const { return static_cast<int>(begins.size()) - 1; }

  SparseMatrix pattern() const {
    const std::vector<double> ones(rows.size(), 1);
    return Eigen::Map<const SparseMatrix>(points(), points(), static_cast<Eigen::Index>(rows.size()),
                                          begins.data(), rows.data(), ones.data());
  }

  /// All coordinates, points in their places; the upper triangle, not sorted within columns.
  SparseMatrix inOrder(const Eigen::VectorXi& place, double diagonal) const {
    SparseMatrix matrix(3 * points(), 3 * points());
    Eigen::VectorXi counts = Eigen::VectorXi::Zero(3 * points());
    forEach(place, diagonal, [&](int, int column, double) { ++counts[column]; });
    int* const outer = matrix.outerIndexPtr();
    for (int k = 0; k < counts.size(); ++k) outer[k + 1] = outer[k] + counts[k];
    matrix.resizeNonZeros(outer[counts.size()]);
    Eigen::VectorXi next = Eigen::Map<const Eigen::VectorXi>(outer, counts.size());
    forEach(place, diagonal, [&](int row, int column, double value) {
      matrix.innerIndexPtr()[next[column]] = row;
      matrix.valuePtr()[next[column]++] = value;
    });
    return matrix;
  }

 private:
  template <class Take>
  void forEach(const Eigen::VectorXi& place, double diagonal, const Take& take) const {
    for (int j = 0; j < points(); ++j)
      for (int k = begins[j]; k < begins[j + 1]; ++k) {
        const int row = 3 * place[rows[k]], column = 3 * place[j];
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b) {
            if (row < column)
              take(row + a, column + b, blocks[k](a, b));
            else if (row > column)
              take(column + a, row + b, blocks[k](b, a));
            else if (a <= b)
              take(row + a, column + b, blocks[k](a, b) + (a == b ? diagonal : 0));
          }
      }
  }
};

void LeastMoves::fix(int point, const Eigen::Vector3d& move) {
  fixed_[point] = move;
}

void LeastMoves::add(const std::vector<int>& points, const Eigen::MatrixXd& factors,
                     const Eigen::Vector3d& direction, const Eigen::VectorXd& values) {
  groups_.push_back({points, factors, false, direction, values});
  takeOutFixed(groups_.back());
}

void LeastMoves::addPoint(const std::vector<int>& points, const Eigen::RowVectorXd& factors,
                          const Eigen::Vector3d& value) {
  groups_.push_back({points, factors, true, value, {}});
  takeOutFixed(groups_.back());
}

/// Points that are fixed have their part in the values.
void LeastMoves::takeOutFixed(Group& group) const {
  if (fixed_.empty()) return;
  for (std::size_t k = 0; k < group.points.size(); ++k) {
    const auto fixed = fixed_.find(group.points[k]);
    if (fixed == fixed_.end()) continue;
    const Eigen::VectorXd factors = group.factors.col(static_cast<Eigen::Index>(k));
    if (group.is_point)
      group.direction -= factors[0] * fixed->second;
    else
      group.values -= group.direction.dot(fixed->second) * factors;
    group.factors.col(static_cast<Eigen::Index>(k)).setZero();
  }
}

LeastMoves::Normal LeastMoves::normalMatrix() const {
  struct Use {
    int group, column;
  };
  std::vector<std::vector<Use>> uses(points_);
  for (int g = 0; g < static_cast<int>(groups_.size()); ++g)
    for (int k = 0; k < static_cast<int>(groups_[g].points.size()); ++k)
      uses[groups_[g].points[k]].push_back({g, k});
  Normal normal;
  std::vector<Eigen::Matrix3d> column(points_, Eigen::Matrix3d::Zero());
  std::vector<int> seen(points_, -1);
  for (int j = 0; j < points_; ++j) {
    const auto see = [&](int i) {
      if (seen[i] == j) return;
      seen[i] = j;
      normal.rows.push_back(i);
    };
    see(j);
    for (const Use& use : uses[j]) {
      const Group& group = groups_[use.group];
      const Eigen::Matrix3d square = group.direction * group.direction.transpose();
      for (std::size_t k = 0; k < group.points.size(); ++k) {
        const int i = group.points[k];
        if (i > j) continue;
        see(i);
        const double product =
            group.factors.col(use.column).dot(group.factors.col(static_cast<Eigen::Index>(k)));
        if (group.is_point)
          column[i].diagonal().array() += product;
        else
          column[i] += product * square;
      }
    }
    std::sort(normal.rows.begin() + normal.begins.back(), normal.rows.end());
    for (int k = normal.begins.back(); k < static_cast<int>(normal.rows.size()); ++k) {
      normal.blocks.push_back(column[normal.rows[k]]);
      column[normal.rows[k]].setZero();
    }
    normal.begins.push_back(static_cast<int>(normal.rows.size()));
  }
  return normal;
}

/// Half the gradient of the sum of squares, downwards.
PointRows LeastMoves::pulled(const PointRows& moves) const {
  PointRows pull = PointRows::Zero(points_, 3);
  for (const Group& group : groups_)
    for (Eigen::Index row = 0; row < group.factors.rows(); ++row) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::size_t k = 0; k < group.points.size(); ++k)
        sum += group.factors(row, static_cast<Eigen::Index>(k)) * moves.row(group.points[k]).transpose();
      const Eigen::Vector3d missing =
          group.is_point ? Eigen::Vector3d(group.direction - sum)
                         : Eigen::Vector3d((group.values[row] - group.direction.dot(sum)) * group.direction);
      for (std::size_t k = 0; k < group.points.size(); ++k)
        pull.row(group.points[k]) += group.factors(row, static_cast<Eigen::Index>(k)) * missing.transpose();
    }
  return pull;
}

PointRows LeastMoves::solve(double damping) const {
  const Normal normal = normalMatrix();
  const Eigen::VectorXi place = placesOf(normal.pattern());
  const Eigen::SimplicialLDLT<SparseMatrix, Eigen::Upper, Eigen::NaturalOrdering<int>> factors(
      normal.inOrder(place, damping * damping));
  PointRows moves = PointRows::Zero(points_, 3), in_order(points_, 3);
  for (int pass = 0; pass < 2; ++pass) {
    const PointRows pull = pulled(moves) - damping * damping * moves;
    for (int i = 0; i < points_; ++i) in_order.row(place[i]) = pull.row(i);
    const Eigen::VectorXd step =
        factors.solve(Eigen::Map<const Eigen::VectorXd>(in_order.data(), in_order.size()));
    for (int i = 0; i < points_; ++i) moves.row(i) += step.segment<3>(3 * place[i]).transpose();
  }
  for (const auto& [point, move] : fixed_) moves.row(point) = move;
  return moves;
}

}  // namespace seamwright::occ
