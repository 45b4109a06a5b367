// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <string>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/blend/balance.hpp>
#include <seamwright/core/join/curve/bell.hpp>
#include <seamwright/core/linear/dense.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using bernstein::binomials;
using bernstein::text;
using Eigen::Index;
using Fault = BalanceFault;

/// As of nextPoles(): a limit of the interface.
constexpr int most_blend_degree = 100;

void requireBalance(const Eigen::VectorXd& beta, int degree_a, int degree_b) {
  if (beta.size() == 0) refuse("0 betas: at least 1 is needed");
  for (Index k = 0; k < beta.size(); ++k)
    if (!std::isfinite(beta(k)))
      refuse("beta_" + std::to_string(k + 1) + " is " + text(beta(k)) + ": it must be finite");
  for (const int degree : {degree_a, degree_b})
    if (degree < beta.size() || degree > most_blend_degree)
      refuse("degree " + std::to_string(degree) + ": it must be within the order, " +
             std::to_string(beta.size()) + ", to " + std::to_string(most_blend_degree));
}

/// n! / (n-k)! for k = 0..order.
Eigen::VectorXd fallingFactorials(int n, Index order) {
  Eigen::VectorXd result = Eigen::VectorXd::Ones(order + 1);
  for (Index k = 1; k <= order; ++k) result(k) = result(k - 1) * static_cast<double>(n - k + 1);
  return result;
}

double signOf(Index k) {
  return k % 2 == 0 ? 1 : -1;
}

Eigen::MatrixXd relationsOf(const Eigen::VectorXd& beta, int degree_a, int degree_b) {
  const Index n = beta.size();
  const Eigen::MatrixXd bell = bellMatrix<double>(beta);
  const Eigen::VectorXd of_a = fallingFactorials(degree_a, n),
                        of_b = fallingFactorials(degree_b, n);
  Eigen::MatrixXd g = Eigen::MatrixXd::Zero(n, 2 * n + 1);
  for (Index k = 1; k <= n; ++k) {
    for (Index j = 0; j <= k; ++j) g(k - 1, n + j) += of_b(k) * signOf(k - j) * binomials(k)(j);
    for (Index l = 1; l <= k; ++l)
      for (Index j = 0; j <= l; ++j)
        g(k - 1, n - j) -= of_a(l) * bell(k, l) * signOf(j) * binomials(l)(j);
  }
  return g;
}

/// Row K of the relations, pushed down to the points of level K - 1: A_0 .. A_(K-1).
Eigen::VectorXd pushedDown(const Eigen::VectorXd& g, Index level, const Eigen::MatrixXd& delta) {
  const Index n = (g.size() - 1) / 2;
  Eigen::VectorXd a(1);
  a(0) = g(n);
  for (Index l = 1; l < level; ++l) {
    Eigen::VectorXd next(l + 1);
    next(0) = g(n - l) + (1 - delta(l - 1, 0)) * a(0);
    for (Index j = 1; j < l; ++j)
      next(j) = delta(l - 1, j - 1) * a(j - 1) + (1 - delta(l - 1, j)) * a(j);
    next(l) = delta(l - 1, l - 1) * a(l - 1) + g(n + l);
    a = std::move(next);
  }
  return a;
}

bool isFar(double ratio, const BalanceGuards& guards) {
  return std::abs(ratio) < guards.least_ratio || std::abs(1 - ratio) < guards.least_ratio ||
         std::abs(ratio) > guards.most_ratio;
}

/// The ratios of level K - 1. False if one of them does not exist.
bool addLevel(const Eigen::VectorXd& g, Index level, const BalanceGuards& guards,
              BalanceRatios& result) {
  const Index n = (g.size() - 1) / 2, row = level - 1;
  const Eigen::VectorXd a = pushedDown(g, level, result.delta);
  const double largest = g.cwiseAbs().maxCoeff();
  for (Index j = 0; j < level; ++j) {
    const double pivot = std::abs(a(j)) / largest;
    result.least_pivot = std::min(result.least_pivot, pivot);
    if (!(pivot > guards.least_pivot)) {
      result.faults.push_back(
          {Fault::Kind::NoRatio, static_cast<int>(row), static_cast<int>(j), pivot});
      return false;
    }
    const double before = j == 0 ? g(n - level) : result.delta(row, j - 1) * a(j - 1);
    const double ratio = 1 + before / a(j);
    result.delta(row, j) = ratio;
    if (isFar(ratio, guards))
      result.faults.push_back(
          {Fault::Kind::FarPoint, static_cast<int>(row), static_cast<int>(j), ratio});
  }
  return true;
}

void requireRows(Index rows, Index needed, const char* what) {
  if (rows != needed)
    refuse(std::string(what) + " " + std::to_string(rows) + ": " + std::to_string(needed) +
           " are needed");
}

void requireFiniteRows(const Eigen::Ref<const Eigen::MatrixXd>& rows, const char* what) {
  for (Index i = 0; i < rows.rows(); ++i)
    if (!rows.row(i).allFinite())
      refuse(std::string(what) + " " + std::to_string(i) + " is not finite");
}

/// The points of the next level between its ends, by least squares.
/// \pre level points are given, level >= 1.
Eigen::MatrixXd nextLevel(const Eigen::MatrixXd& points, const Eigen::VectorXd& delta,
                          const Eigen::RowVectorXd& first, const Eigen::RowVectorXd& last,
                          double& residual) {
  const Index count = points.rows();
  Eigen::MatrixXd result(count + 1, points.cols());
  result.row(0) = first;
  result.row(count) = last;
  Eigen::MatrixXd right = points;
  right.row(0) -= (1 - delta(0)) * first;
  right.row(count - 1) -= delta(count - 1) * last;
  if (count > 1) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count - 1);
    for (Index j = 0; j + 1 < count; ++j) {
      matrix(j, j) = delta(j);
      matrix(j + 1, j) = 1 - delta(j + 1);
    }
    const Eigen::MatrixXd inner = linear::LeastSquares(matrix).solve(right);
    result.middleRows(1, count - 1) = inner;
    right -= matrix * inner;
  }
  residual = std::max(residual, right.rowwise().norm().maxCoeff());
  return result;
}

}  // namespace

void BalanceGuards::validate() const {
  if (!(least_pivot > 0 && least_pivot < 1))
    refuse("least_pivot is " + text(least_pivot) + ": it must be within (0, 1)");
  if (!(least_ratio > 0 && least_ratio < 0.5))
    refuse("least_ratio is " + text(least_ratio) + ": it must be within (0, 1/2)");
  if (!(most_ratio > 1)) refuse("most_ratio is " + text(most_ratio) + ": it must be above 1");
}

bool BalanceRatios::canCut() const {
  return std::all_of(faults.begin(), faults.end(), [](const BalanceFault& fault) {
    return fault.kind == BalanceFault::Kind::FarPoint;
  });
}

Eigen::MatrixXd balanceRelations(const Eigen::VectorXd& beta, int degree_a, int degree_b) {
  requireBalance(beta, degree_a, degree_b);
  requireBeta(beta);
  return relationsOf(beta, degree_a, degree_b);
}

BalanceRatios balanceRatios(const Eigen::VectorXd& beta, int degree_a, int degree_b,
                            const BalanceGuards& guards) {
  requireBalance(beta, degree_a, degree_b);
  guards.validate();
  const Index n = beta.size();
  BalanceRatios result{Eigen::MatrixXd::Zero(n, n), {}, infinite};
  if (beta(0) <= 0) {
    result.faults.push_back({Fault::Kind::NegativeBeta, 0, 0, beta(0)});
    result.least_pivot = 0;
    return result;
  }
  const Eigen::MatrixXd g = relationsOf(beta, degree_a, degree_b);
  for (Index level = 1; level <= n; ++level)
    if (!addLevel(g.row(level - 1), level, guards, result)) break;
  return result;
}

AuxiliaryPoints auxiliaryPoints(const BalanceRatios& ratios,
                                const Eigen::Ref<const Eigen::MatrixXd>& poles) {
  const Index n = ratios.delta.rows();
  requireRows(poles.rows(), 2 * n + 1, "poles");
  requireFiniteRows(poles, "pole");
  if (!ratios.canSolve())
    refuse("ratio (" + std::to_string(ratios.faults.front().level) + ", " +
           std::to_string(ratios.faults.front().index) + ") has a fault, value " +
           text(ratios.faults.front().value));
  AuxiliaryPoints result{poles.row(n), 0};
  for (Index k = 1; k <= n; ++k)
    result.points = nextLevel(result.points, ratios.delta.row(k - 1).head(k), poles.row(n - k),
                              poles.row(n + k), result.residual);
  return result;
}

Eigen::MatrixXd balancedPoles(const BalanceRatios& ratios,
                              const Eigen::Ref<const Eigen::MatrixXd>& points) {
  const Index n = ratios.delta.rows();
  requireRows(points.rows(), n + 1, "points");
  requireFiniteRows(points, "point");
  if (!ratios.canCut())
    refuse("ratio (" + std::to_string(ratios.faults.back().level) + ", " +
           std::to_string(ratios.faults.back().index) + ") is missing");
  Eigen::MatrixXd level = points, poles(2 * n + 1, points.cols());
  for (Index k = n; k >= 0; --k) {
    poles.row(n - k) = level.row(0);
    poles.row(n + k) = level.row(k);
    if (k == 0) break;
    const Eigen::VectorXd take = ratios.delta.row(k - 1).head(k);
    level = ((1 - take.array()).matrix().asDiagonal() * level.topRows(k) +
             take.asDiagonal() * level.bottomRows(k))
                .eval();
  }
  return poles;
}

}  // namespace seamwright
