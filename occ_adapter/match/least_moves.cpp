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

/// Gives the products of a column with each of the first \p columns.
template <class Take>
void takeProducts(const Eigen::MatrixXd& factors, int column, int columns, const Take& take) {
  const double* const own = factors.col(column).data();
  const double* other = factors.data();
  for (int k = 0; k < columns; ++k) {
    double product = 0;
    for (Eigen::Index row = 0; row < factors.rows(); ++row) product += own[row] * *other++;
    take(k, product);
  }
}

}  // namespace

void LeastMoves::fix(int point, const Eigen::Vector3d& move) {
  fixed_[point] = move;
}

int LeastMoves::add(const std::vector<int>& points, const Eigen::MatrixXd& factors,
                    const Eigen::Vector3d& direction, const Eigen::VectorXd& values, int part) {
  return addGroup({points, factors, part, false, false, direction, values});
}

int LeastMoves::addPoint(const std::vector<int>& points, const Eigen::RowVectorXd& factors,
                         const Eigen::Vector3d& value, int part) {
  return addGroup({points, factors, part, true, false, value});
}

void LeastMoves::addZero(const std::vector<int>& points, const Eigen::MatrixXd& factors, int part) {
  Group group{points, factors, part, true, true};
  sortPoints(group);
  const Eigen::MatrixXd products = group.factors.transpose() * group.factors;
  group.factors = products;
  prepared_.reset();
  groups_.push_back(std::move(group));
}

void LeastMoves::setValue(int condition, double value) {
  groups_[static_cast<std::size_t>(condition)].values[0] = value;
}

void LeastMoves::setValue(int condition, const Eigen::Vector3d& value) {
  groups_[static_cast<std::size_t>(condition)].direction = value;
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
int LeastMoves::addGroup(Group group) {
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
  return static_cast<int>(groups_.size()) - 1;
}

std::vector<std::vector<LeastMoves::Use>> LeastMoves::usesOfPoints() const {
  std::vector<std::vector<Use>> uses(points_);
  for (int g = 0; g < static_cast<int>(groups_.size()); ++g)
    for (int k = 0; k < static_cast<int>(groups_[g].points.size()); ++k)
      uses[groups_[g].points[k]].push_back({g, k});
  return uses;
}

BlockPattern LeastMoves::patternOf(const std::vector<std::vector<Use>>& uses) const {
  BlockPattern pattern;
  std::vector<int> seen(points_, -1);
  for (int j = 0; j < points_; ++j) {
    const auto see = [&](int i) {
      if (i > j || seen[i] == j) return;
      seen[i] = j;
      pattern.rows.push_back(i);
    };
    see(j);
    for (const Use& use : uses[j])
      for (const int i : groups_[use.group].points) see(i);
    std::sort(pattern.rows.begin() + pattern.begins.back(), pattern.rows.end());
    pattern.begins.push_back(static_cast<int>(pattern.rows.size()));
  }
  return pattern;
}

LeastMoves::Normal LeastMoves::normalMatrix() const {
  const std::vector<std::vector<Use>> uses = usesOfPoints();
  Normal normal{patternOf(uses), std::vector<PartOfNormal>(parts_)};
  const std::vector<int>&begins = normal.pattern.begins, &rows = normal.pattern.rows;
  for (PartOfNormal& part : normal.parts) part.multiples.resize(rows.size(), 0);
  for (const Group& group : groups_)
    if (!group.is_point)
      normal.parts[group.part].blocks.resize(rows.size(), SymmetricBlock::Zero());
  std::vector<int> position(points_);
  for (int j = 0; j < points_; ++j) {
    for (int k = begins[j]; k < begins[j + 1]; ++k) position[rows[k]] = k;
    for (const Use& use : uses[j]) {
      const Group& group = groups_[use.group];
      PartOfNormal& part = normal.parts[group.part];
      const int* const points = group.points.data();
      const int columns =
          static_cast<int>(std::ranges::upper_bound(group.points, j) - group.points.begin());
      const SymmetricBlock square = squareOf(group.direction);
      const auto take = [&](int k, double product) {
        if (group.is_point)
          part.multiples[position[points[k]]] += product;
        else
          part.blocks[position[points[k]]] += product * square;
      };
      if (group.is_zero)
        for (int k = 0; k < columns; ++k) take(k, group.factors(k, use.column));
      else
        takeProducts(group.factors, use.column, columns, take);
    }
  }
  return normal;
}

/// Half the gradient of the sum of squares, downwards.
PointRows LeastMoves::pulled(const PointRows& moves, const std::vector<double>& weights) const {
  PointRows gradient = PointRows::Zero(points_, 3);
  const bool is_still = moves.isZero(0);
  for (const Group& group : groups_) {
    if (group.is_zero && is_still) continue;
    const double square = weights[group.part] * weights[group.part];
    for (Eigen::Index row = 0; row < group.factors.rows(); ++row) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::size_t k = 0; k < group.points.size(); ++k)
        sum += group.factors(row, static_cast<Eigen::Index>(k)) *
               moves.row(group.points[k]).transpose();
      if (group.is_zero) {
        gradient.row(group.points[row]) -= square * sum.transpose();
        continue;
      }
      Eigen::Vector3d missing =
          group.is_point
              ? Eigen::Vector3d(group.direction - sum)
              : Eigen::Vector3d((group.values[row] - group.direction.dot(sum)) * group.direction);
      missing *= square;
      for (std::size_t k = 0; k < group.points.size(); ++k)
        gradient.row(group.points[k]) +=
            group.factors(row, static_cast<Eigen::Index>(k)) * missing.transpose();
    }
  }
  return gradient;
}

/// Finds an order of elimination for the parts that have a weight.
void LeastMoves::order(const std::vector<double>& weights) const {
  std::vector<bool> counting;
  for (const double weight : weights) counting.push_back(weight != 0);
  if (prepared_->counting == counting) return;
  const Normal& normal = prepared_->normal;
  std::vector<bool> is_multiple(normal.pattern.rows.size(), true);
  for (std::size_t part = 0; part < normal.parts.size(); ++part)
    for (std::size_t k = 0; counting[part] && k < normal.parts[part].blocks.size(); ++k)
      if (!normal.parts[part].blocks[k].isZero(0)) is_multiple[k] = false;
  prepared_->factors = BlockCholesky(normal.pattern, is_multiple);
  prepared_->counting = counting;
  prepared_->weights.clear();
}

/// Where rounding hides that the matrix is positive definite its diagonal is raised by as much; the
/// second pass of solve() makes up for it.
void LeastMoves::factor(double damping, const std::vector<double>& weights) const {
  if (!prepared_) prepared_ = Prepared{normalMatrix()};
  order(weights);
  if (prepared_->damping == damping && prepared_->weights == weights) return;
  const Normal& normal = prepared_->normal;
  std::vector<SymmetricBlock> blocks(normal.pattern.rows.size(), SymmetricBlock::Zero());
  for (std::size_t part = 0; part < normal.parts.size(); ++part) {
    const double square = weights[part] * weights[part];
    const PartOfNormal& of_part = normal.parts[part];
    for (std::size_t k = 0; k < of_part.multiples.size(); ++k)
      blocks[k].head<3>().array() += square * of_part.multiples[k];
    for (std::size_t k = 0; k < of_part.blocks.size(); ++k) blocks[k] += square * of_part.blocks[k];
  }
  double largest = damping * damping;
  for (const SymmetricBlock& block : blocks)
    largest = std::max(largest, block.head<3>().maxCoeff());
  double raised = 0;
  while (!prepared_->factors.factor(blocks, damping * damping + raised))
    // Raising starts at the rounding of the largest entry. Tenfold steps find a sufficient one soon
    // and are at most ten times too large.
    raised = std::max(10 * raised, std::numeric_limits<double>::epsilon() * largest);
  prepared_->damping = damping;
  prepared_->weights = weights;
}

PointRows LeastMoves::solve(double damping, const std::vector<double>& weights) const {
  factor(damping, weights);
  PointRows moves = PointRows::Zero(points_, 3);
  for (int pass = 0; pass < 2; ++pass)
    moves += prepared_->factors.solve(pulled(moves, weights) - damping * damping * moves);
  for (const auto& [point, move] : fixed_) moves.row(point) = move;
  return moves;
}

}  // namespace seamwright::occ
