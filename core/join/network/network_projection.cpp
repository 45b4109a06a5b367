// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/SparseQR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <seamwright/core/join/network/network_projection.hpp>

namespace seamwright::network {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Shift of the scaled system, whose rows have length 1. It must be far above the rounding of sums
/// of squares, some 1e-15, so that the factorisation succeeds for dependent rows. It must be far
/// below 1, because a pass of the refinement leaves shift / (shift + s^2) of the part of the rest
/// with singular value s.
constexpr double shift = 1e-12;

Eigen::VectorXd reachOf(const Eigen::VectorXd& weights) {
  return (weights.array() > 0).select(weights.array().rsqrt(), 0.0);
}

Eigen::VectorXd rowLengths(const Sparse& a) {
  Eigen::VectorXd squared = Eigen::VectorXd::Zero(a.rows());
  for (int k = 0; k < a.outerSize(); ++k)
    for (Sparse::InnerIterator it(a, k); it; ++it) squared(it.row()) += it.value() * it.value();
  return squared.cwiseSqrt();
}

Sparse shifted(const Sparse& m) {
  Sparse unit(m.rows(), m.cols());
  unit.setIdentity();
  return m + shift * unit;
}

/// Solves A A' nu = b by linearly independent rows of A, without squaring A's condition. b must be
/// in the range of A.
class IndependentRows {
 public:
  explicit IndependentRows(const Sparse& a) : qr_(Sparse(a.transpose())) {
    // Within a column of R the rows are in no order; another storage order and back sorts them.
    const Eigen::SparseMatrix<double, Eigen::RowMajor> by_rows = qr_.matrixR();
    r_ = Sparse(by_rows).topLeftCorner(qr_.rank(), qr_.rank());
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const {
    const Eigen::Index rank = qr_.rank();
    const auto upper = r_.triangularView<Eigen::Upper>();
    const Eigen::MatrixXd permuted = qr_.colsPermutation().transpose() * b;
    Eigen::MatrixXd nu = Eigen::MatrixXd::Zero(b.rows(), b.cols());
    const Eigen::MatrixXd first = upper.transpose().solve(permuted.topRows(rank));
    nu.topRows(rank) = upper.solve(first);
    return qr_.colsPermutation() * nu;
  }

 private:
  Eigen::SparseQR<Sparse, Eigen::COLAMDOrdering<int>> qr_;
  Sparse r_;  ///< of the independent rows
};

Projection refined(const Sparse& a, const Eigen::VectorXd& weights, const Eigen::MatrixXd& target,
                   OrderedFactors& factors) {
  // A pass must remove a tenth of the rest. A system without dependent rows needs two or three; the
  // shift slows those down whose singular values are near it.
  constexpr int max_passes = 20;
  // What is left of an unsolvable system is not rounding: its rest stays near the given one. What
  // is within a few roundings need not be solved again.
  constexpr double nearly = 1e-6, near_rounding = 4;
  // In rows. An orthogonal factorisation of more rows takes seconds.
  constexpr Eigen::Index most_independent = 2000;
  // Of a coordinate in a sum, on the mean of many: half of the largest rounding of one number.
  constexpr double rounding = std::numeric_limits<double>::epsilon() / 4;
  const Eigen::VectorXd reach = reachOf(weights);
  Projection result;
  result.x = target;
  result.multipliers = Eigen::MatrixXd::Zero(a.rows(), target.cols());
  const Sparse reached = a * reach.asDiagonal();
  const Eigen::VectorXd length = rowLengths(reached), whole = rowLengths(a);
  result.row_scale =
      (length.array() > 1e-9 * whole.array()).select(length, whole.cwiseMax(1e-300)).cwiseInverse();
  if (a.rows() == 0) return result;
  const Sparse scaled = result.row_scale.asDiagonal() * reached;
  const OrderedFactors::Solver& solver =
      factors.factor(shifted(scaled * Sparse(scaled.transpose())));
  const auto rest = [&](const Eigen::MatrixXd& x) -> Eigen::MatrixXd {
    return result.row_scale.asDiagonal() * (a * x);
  };
  const double resolved =
      rounding * (result.row_scale.asDiagonal() * (a.cwiseAbs() * target.cwiseAbs())).norm();

  Eigen::MatrixXd z = Eigen::MatrixXd::Zero(target.rows(), target.cols()), r = rest(result.x);
  const double given = r.norm();
  result.unreachable = given;
  Eigen::MatrixXd nu = result.multipliers;
  // Whether x is nearer to a solution by more than rounding.
  const auto advance = [&](const Eigen::MatrixXd& change) {
    nu += change;
    z -= scaled.transpose() * change;
    const Eigen::MatrixXd x = target + reach.asDiagonal() * z;
    r = rest(x);
    const bool much = r.norm() < 0.9 * result.unreachable;
    if (r.norm() < result.unreachable) {
      result.unreachable = r.norm();
      result.x = x;
      result.multipliers = nu;
      result.cost = z.squaredNorm();
    }
    return much;
  };
  for (int pass = 0; pass < max_passes && result.unreachable > resolved; ++pass)
    if (!advance(solver.solve(r))) break;
  if (result.unreachable > nearly * given) return result;
  if (result.unreachable <= near_rounding * resolved || a.rows() > most_independent) return result;
  const IndependentRows rows(scaled);
  for (int pass = 0; pass < max_passes && result.unreachable > resolved; ++pass)
    if (!advance(rows.solve(r))) break;
  return result;
}

}  // namespace

const OrderedFactors::Solver& OrderedFactors::factor(const Sparse& lower) {
  const std::span<const int> begins(lower.outerIndexPtr(),
                                    static_cast<std::size_t>(lower.outerSize() + 1));
  const std::span<const int> rows(lower.innerIndexPtr(),
                                  static_cast<std::size_t>(lower.nonZeros()));
  if (!std::ranges::equal(begins, begins_) || !std::ranges::equal(rows, rows_)) {
    begins_.assign(begins.begin(), begins.end());
    rows_.assign(rows.begin(), rows.end());
    solver_.analyzePattern(lower);
  }
  solver_.factorize(lower);
  return solver_;
}

Projection project(const Sparse& a, const Eigen::VectorXd& weights, const Eigen::MatrixXd& target,
                   OrderedFactors& factors) {
  Projection result = refined(a, weights, target, factors);
  if (a.rows() == 0) return result;
  const Eigen::VectorXd sums = a.cwiseAbs() * Eigen::VectorXd::Ones(a.cols());
  result.rounding = ((a * result.x).rowwise().norm().array() / sums.array().max(1e-300)).maxCoeff();
  return result;
}

// Let S be the row scale, K = S A D, M = K K' + shift, and B = S G U, where U scales columns to
// length 1; dy = U y. The minimum of |z|^2 + damping |y|^2 subject to S A target + K z + B y = 0
// has z = -K' nu, and
//
//     [ I x M   -B         ] [ nu ]   [ S A target ]
//     [ -B'     -damping I ] [ y  ] = [ 0          ]
//
// where I x M is a block M for each column of the target. With damping > 0 the matrix is
// quasidefinite, so L D L' exists in every order. Only the lower triangle is stored.
Step step(const Sparse& a, const Eigen::VectorXd& weights, const Eigen::MatrixXd& target,
          const Projection& at, const Sparse& g, double damping, OrderedFactors& factors) {
  const Eigen::Index rows = a.rows(), parameters = g.cols(),
                     all = target.cols() * rows + parameters;
  const Sparse scaled = at.row_scale.asDiagonal() * a * reachOf(weights).asDiagonal();
  const Sparse m = shifted(scaled * Sparse(scaled.transpose()));
  const Eigen::VectorXd scale_of_g = at.row_scale.replicate(target.cols(), 1);
  Sparse by = scale_of_g.asDiagonal() * g;
  Eigen::VectorXd unit(parameters);
  for (Eigen::Index k = 0; k < parameters; ++k) {
    const double length = by.col(k).norm();
    unit(k) = length > 0 ? 1 / length : 0;
  }
  by = by * unit.asDiagonal();

  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index d = 0; d < target.cols(); ++d)
    for (int k = 0; k < m.outerSize(); ++k)
      for (Sparse::InnerIterator it(m, k); it; ++it)
        if (it.row() >= it.col())
          entries.emplace_back(d * rows + it.row(), d * rows + it.col(), it.value());
  for (int k = 0; k < by.outerSize(); ++k)
    for (Sparse::InnerIterator it(by, k); it; ++it)
      entries.emplace_back(all - parameters + k, it.row(), -it.value());
  for (Eigen::Index k = 0; k < parameters; ++k)
    entries.emplace_back(all - parameters + k, all - parameters + k, -damping);
  Sparse system(all, all);
  system.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd right = Eigen::VectorXd::Zero(all);
  right.head(all - parameters) = (at.row_scale.asDiagonal() * (a * target)).reshaped();
  const Eigen::VectorXd found = factors.factor(system).solve(right);
  Step result;
  const Eigen::VectorXd change = found.tail(parameters);
  result.change = unit.asDiagonal() * change;
  // The cost falls by -g' dy, g = 2 G' nu being its gradient.
  result.decrease = -change.dot(by.transpose() * at.multipliers.reshaped());
  return result;
}

}  // namespace seamwright::network
