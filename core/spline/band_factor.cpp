// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/spline/band_factor.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace seamwright {

namespace {

using Eigen::Index;

/// Position of an unknown of a closed matrix in the order 0, n-1, 1, n-2, ..
Index positionInRing(Index i, Index count) {
  return i < (count + 1) / 2 ? 2 * i : 2 * (count - 1 - i) + 1;
}

/// The LU factorisation of a band matrix with Width neighbours on each side. Pivoting fills Width
/// more diagonals above.
template <int Width, bool Pivoting>
class BandFactor {
 public:
  explicit BandFactor(const BandMatrix& matrix)
      : closed_(matrix.closed), count_(matrix.diagonal.size()) {
    fill(matrix);
    eliminate();
  }

  Index smallestPivot() const { return smallest_; }
  double pivot(Index k) const { return pivots_(k); }

  /// Right sides and unknowns in the order of the factorisation; Upper rows of zeros follow.
  template <class Right>
  void solve(Right& y) const {
    for (Index k = 0; k < count_; ++k) {
      if constexpr (Pivoting) y.row(k).swap(y.row(swaps_[static_cast<std::size_t>(k)]));
      for (int r = 1; r <= Width; ++r) y.row(k + r) -= at(k + r, k) * y.row(k);
    }
    for (Index k = count_; k-- > 0;) {
      for (int c = 1; c <= Upper; ++c) y.row(k) -= at(k, k + c) * y.row(k + c);
      y.row(k) /= pivots_(k);
    }
  }

  /// Solves the transposed equations.
  void solveTransposed(Eigen::VectorXd& y) const {
    for (Index k = 0; k < count_; ++k) {
      y(k) /= pivots_(k);
      for (int c = 1; c <= Upper; ++c) y(k + c) -= at(k, k + c) * y(k);
    }
    y.tail(Upper).setZero();
    for (Index k = count_; k-- > 0;) {
      for (int r = 1; r <= Width; ++r) y(k) -= at(k + r, k) * y(k + r);
      if constexpr (Pivoting) std::swap(y(k), y(swaps_[static_cast<std::size_t>(k)]));
    }
  }

  Poles solved(Poles right) const {
    if (!closed_) {
      right.conservativeResize(count_ + Upper, 3);
      right.bottomRows(Upper).setZero();
      solve(right);
      right.conservativeResize(count_, 3);
      return right;
    }
    Poles y = Poles::Zero(count_ + Upper, 3);
    for (Index i = 0; i < count_; ++i) y.row(position(i)) = right.row(i);
    solve(y);
    for (Index i = 0; i < count_; ++i) right.row(i) = y.row(position(i));
    return right;
  }

  /// Hager's estimate of the inverse's maximum norm, from below; N. Higham, ACM TOMS 14 (1988),
  /// algorithm 4.1.
  double inverseNorm() const {
    const double n = static_cast<double>(count_);
    Eigen::VectorXd x = padded(Eigen::VectorXd::Constant(count_, 1 / n));
    double norm = 0;
    for (int step = 0; step < 5; ++step) {
      Eigen::VectorXd y = x;
      solveTransposed(y);
      norm = std::max(norm, y.template lpNorm<1>());
      Eigen::VectorXd z =
          padded(y.head(count_).unaryExpr([](double v) { return v < 0 ? -1.0 : 1.0; }));
      solve(z);
      Index largest = 0;
      if (z.cwiseAbs().maxCoeff(&largest) <= z.dot(x)) break;
      x.setZero();
      x(largest) = 1;
    }
    Eigen::VectorXd waves = padded(Eigen::VectorXd::NullaryExpr(
        count_, [&](Index i) { return (i % 2 == 0 ? 1 : -1) * (1 + static_cast<double>(i) / n); }));
    solveTransposed(waves);
    return std::max(norm, 2 * waves.lpNorm<1>() / (3 * n));
  }

 private:
  static constexpr int Upper = Pivoting ? 2 * Width : Width;

  Index position(Index i) const { return closed_ ? positionInRing(i, count_) : i; }
  double& at(Index row, Index column) {
    return rows_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column - row + Width)];
  }
  double at(Index row, Index column) const {
    return rows_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column - row + Width)];
  }

  static Eigen::VectorXd padded(const Eigen::VectorXd& values) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(values.size() + Upper);
    result.head(values.size()) = values;
    return result;
  }

  void fill(const BandMatrix& matrix) {
    rows_.resize(static_cast<std::size_t>(count_ + Upper), {});
    for (Index i = 0; i < count_; ++i) {
      const Index row = position(i);
      at(row, row) += matrix.diagonal(i);
      if (closed_ || i > 0) at(row, position((i + count_ - 1) % count_)) += matrix.lower(i);
      if (closed_ || i + 1 < count_) at(row, position((i + 1) % count_)) += matrix.upper(i);
    }
  }

  void eliminate() {
    pivots_.resize(count_);
    for (Index k = 0; k < count_; ++k) {
      if constexpr (Pivoting) bringUpPivot(k);
      const double pivot = pivots_(k) = at(k, k);
      if (std::abs(pivot) < std::abs(pivots_(smallest_))) smallest_ = k;
      if (pivot == 0) return;
      for (int r = 1; r <= Width; ++r) {
        const double factor = at(k + r, k) /= pivot;
        for (int c = 1; c <= Upper; ++c)
          if (c - r <= Upper) at(k + r, k + c) -= factor * at(k, k + c);
      }
    }
  }

  void bringUpPivot(Index k) {
    Index best = k;
    for (int r = 1; r <= Width; ++r)
      if (std::abs(at(k + r, k)) > std::abs(at(best, k))) best = k + r;
    swaps_.push_back(best);
    if (best == k) return;
    for (int c = 0; c <= Upper; ++c) std::swap(at(k, k + c), at(best, k + c));
  }

  bool closed_;
  Index count_, smallest_ = 0;
  /// Row r: columns r - Width .. r + Upper; the multipliers are stored left of the diagonal.
  std::vector<std::array<double, Width + 1 + Upper>> rows_;
  Eigen::VectorXd pivots_;
  std::vector<Index> swaps_;
};

double rowNorm(const BandMatrix& m) {
  return (m.lower.cwiseAbs() + m.diagonal.cwiseAbs() + m.upper.cwiseAbs()).maxCoeff();
}

/// Upper bound of the inverse's maximum norm; infinite unless every row is strictly dominant.
double dominanceBound(const BandMatrix& m) {
  const double margin =
      (m.diagonal.cwiseAbs() - m.lower.cwiseAbs() - m.upper.cwiseAbs()).minCoeff();
  return margin > 0 ? 1 / margin : std::numeric_limits<double>::infinity();
}

/// Rows multiplied and columns divided by the scale.
BandMatrix balanced(const BandMatrix& m) {
  BandMatrix result = m;
  const Index n = m.diagonal.size();
  for (Index i = 0; i < n; ++i) {
    result.lower(i) *= m.scale(i) / m.scale((i + n - 1) % n);
    result.upper(i) *= m.scale(i) / m.scale((i + 1) % n);
  }
  return result;
}

template <int Width>
BandSolution solvePivoted(const BandMatrix& given, Poles right) {
  const BandMatrix matrix = balanced(given);
  const BandFactor<Width, true> factor(matrix);
  const Index smallest = factor.smallestPivot();
  const double size = std::abs(factor.pivot(smallest));
  const double inverse = size > 0 ? factor.inverseNorm() : std::numeric_limits<double>::infinity();
  const double condition = 1 / (rowNorm(matrix) * inverse);
  if (!(condition >= kSmallestCondition))
    throw std::domain_error("the " + std::to_string(matrix.diagonal.size()) +
                            " equations are singular: pivot " + std::to_string(smallest) + " is " +
                            bernstein::text(size) + ", reciprocal condition " +
                            bernstein::text(condition));
  right.array().colwise() *= given.scale.array();
  right = factor.solved(std::move(right));
  right.array().colwise() /= given.scale.array();
  return {std::move(right), inverse, true};
}

/// Thomas's algorithm, in place.
Poles solvedOpenDominant(const BandMatrix& m, Poles x) {
  const Index n = m.diagonal.size();
  Eigen::VectorXd pivots(n);
  pivots(0) = m.diagonal(0);
  for (Index k = 1; k < n; ++k) {
    const double factor = m.lower(k) / pivots(k - 1);
    pivots(k) = m.diagonal(k) - factor * m.upper(k - 1);
    x.row(k) -= factor * x.row(k - 1);
  }
  x.row(n - 1) /= pivots(n - 1);
  for (Index k = n - 1; k-- > 0;) {
    x.row(k) -= m.upper(k) * x.row(k + 1);
    x.row(k) /= pivots(k);
  }
  return x;
}

template <int Width>
BandSolution solveOfWidth(const BandMatrix& matrix, Poles right) {
  const double bound = dominanceBound(matrix);
  if (!(rowNorm(matrix) * bound * kSmallestCondition <= 1))
    return solvePivoted<Width>(matrix, std::move(right));
  if constexpr (Width == 1) return {solvedOpenDominant(matrix, std::move(right)), bound, false};
  return {BandFactor<Width, false>(matrix).solved(std::move(right)), bound, false};
}

}  // namespace

BandSolution solveBand(const BandMatrix& matrix, Poles right) {
  return matrix.closed ? solveOfWidth<2>(matrix, std::move(right))
                       : solveOfWidth<1>(matrix, std::move(right));
}

}  // namespace seamwright
