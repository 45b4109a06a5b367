// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <limits>
#include <numeric>

#include <seamwright/occ_adapter/match/least_moves.hpp>

namespace seamwright::occ {

namespace {

SymmetricBlock squareOf(const Eigen::Vector3d& v) {
  SymmetricBlock square;
  square << v[0] * v[0], v[1] * v[1], v[2] * v[2], v[0] * v[1], v[1] * v[2], v[2] * v[0];
  return square;
}

/// Gives the products of a column with each of the first \p columns. \tparam rows of the factors;
/// 0: as many as there are
template <int rows, class Take>
void takeProducts(const Eigen::MatrixXd& factors, int column, int columns, const Take& take) {
  const Eigen::Index count = rows > 0 ? rows : factors.rows();
  const double* const own = factors.col(column).data();
  const double* other = factors.data();
  for (int k = 0; k < columns; ++k) {
    double product = 0;
    for (Eigen::Index row = 0; row < count; ++row) product += own[row] * *other++;
    take(k, product);
  }
}

}  // namespace

void LeastMoves::fix(int point, const Eigen::Vector3d& move) {
  fixed_[point] = move;
}

void LeastMoves::add(const std::vector<int>& points, const Eigen::MatrixXd& factors,
                     const Eigen::Vector3d& direction, const Eigen::VectorXd& values) {
  addGroup({points, factors, false, false, direction, values});
}

void LeastMoves::addPoint(const std::vector<int>& points, const Eigen::RowVectorXd& factors,
                          const Eigen::Vector3d& value) {
  addGroup({points, factors, true, false, value, {}});
}

void LeastMoves::addSoft(const std::vector<int>& points, const Eigen::MatrixXd& factors) {
  addGroup({points, factors, true, true, Eigen::Vector3d::Zero(), {}});
}

void LeastMoves::sortPoints(Group& group) {
  if (std::ranges::is_sorted(group.points)) return;
  std::vector<int> order(group.points.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int k) { return group.points[k]; });
  const Eigen::MatrixXd factors = group.factors(Eigen::indexing::all, order);
  group.factors = factors;
  std::ranges::sort(group.points);
}

/// Points that are fixed have their part in the values.
void LeastMoves::addGroup(Group group) {
  prepared_.reset();
  sortPoints(group);
  for (std::size_t k = 0; k < group.points.size() && !fixed_.empty(); ++k) {
    const auto fixed = fixed_.find(group.points[k]);
    if (fixed == fixed_.end()) continue;
    const Eigen::VectorXd factors = group.factors.col(static_cast<Eigen::Index>(k));
    if (group.is_point)
      group.direction -= factors[0] * fixed->second;
    else
      group.values -= group.direction.dot(fixed->second) * factors;
    group.factors.col(static_cast<Eigen::Index>(k)).setZero();
  }
  groups_.push_back(std::move(group));
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
  std::vector<int>& rows = normal.pattern.rows;
  std::vector<SymmetricBlock> column(points_, SymmetricBlock::Zero());
  std::vector<double> of_points(points_, 0), soft(points_, 0);
  std::vector<int> seen(points_, -1);
  for (int j = 0; j < points_; ++j) {
    const auto see = [&](int i) {
      if (seen[i] == j) return;
      seen[i] = j;
      rows.push_back(i);
    };
    see(j);
    for (const Use& use : uses[j]) {
      const Group& group = groups_[use.group];
      const int columns =
          static_cast<int>(std::ranges::upper_bound(group.points, j) - group.points.begin());
      for (int k = 0; k < columns; ++k) see(group.points[k]);
      const auto add = [&](const auto& take) {
        switch (group.factors.rows()) {
          case 1:
            return takeProducts<1>(group.factors, use.column, columns, take);
          case 2:
            return takeProducts<2>(group.factors, use.column, columns, take);
          case 3:
            return takeProducts<3>(group.factors, use.column, columns, take);
          default:
            return takeProducts<0>(group.factors, use.column, columns, take);
        }
      };
      const int* const points = group.points.data();
      const SymmetricBlock square = squareOf(group.direction);
      std::vector<double>& multiples = group.is_soft ? soft : of_points;
      if (group.is_point)
        add([&](int k, double product) { multiples[points[k]] += product; });
      else
        add([&](int k, double product) { column[points[k]] += product * square; });
    }
    std::sort(rows.begin() + normal.pattern.begins.back(), rows.end());
    for (int k = normal.pattern.begins.back(); k < static_cast<int>(rows.size()); ++k) {
      const int i = rows[k];
      column[i].head<3>().array() += of_points[i];
      normal.blocks.push_back(column[i]);
      normal.soft.push_back(soft[i]);
      column[i].setZero();
      of_points[i] = soft[i] = 0;
    }
    normal.pattern.begins.push_back(static_cast<int>(rows.size()));
  }
  return normal;
}

/// Half the gradient of the sum of squares, downwards.
PointRows LeastMoves::pulled(const PointRows& moves, double softness) const {
  PointRows gradient = PointRows::Zero(points_, 3);
  for (const Group& group : groups_)
    for (Eigen::Index row = 0; row < group.factors.rows(); ++row) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::size_t k = 0; k < group.points.size(); ++k)
        sum += group.factors(row, static_cast<Eigen::Index>(k)) *
               moves.row(group.points[k]).transpose();
      Eigen::Vector3d missing =
          group.is_point
              ? Eigen::Vector3d(group.direction - sum)
              : Eigen::Vector3d((group.values[row] - group.direction.dot(sum)) * group.direction);
      if (group.is_soft) missing *= softness * softness;
      for (std::size_t k = 0; k < group.points.size(); ++k)
        gradient.row(group.points[k]) +=
            group.factors(row, static_cast<Eigen::Index>(k)) * missing.transpose();
    }
  return gradient;
}

/// Where rounding hides that the matrix is positive definite its diagonal is raised by as much; the
/// second pass of solve() makes up for it.
void LeastMoves::factor(double damping, double softness) const {
  if (!prepared_) {
    Normal normal = normalMatrix();
    BlockCholesky factors(normal.pattern);
    prepared_ = Prepared{std::move(normal), std::move(factors)};
  }
  const Normal& normal = prepared_->normal;
  std::vector<SymmetricBlock> blocks = normal.blocks;
  double largest = damping * damping;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    blocks[k].head<3>().array() += softness * softness * normal.soft[k];
    largest = std::max(largest, blocks[k].head<3>().maxCoeff());
  }
  double raised = 0;
  while (!prepared_->factors.factor(blocks, damping * damping + raised))
    // Raising starts at the rounding of the largest entry. Tenfold steps find a sufficient one soon
    // and are at most ten times too large.
    raised = std::max(10 * raised, std::numeric_limits<double>::epsilon() * largest);
}

PointRows LeastMoves::solve(double damping, double softness) const {
  factor(damping, softness);
  PointRows moves = PointRows::Zero(points_, 3);
  for (int pass = 0; pass < 2; ++pass)
    moves += prepared_->factors.solve(pulled(moves, softness) - damping * damping * moves);
  for (const auto& [point, move] : fixed_) moves.row(point) = move;
  return moves;
}

}  // namespace seamwright::occ
