// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <functional>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/fair_points.hpp>
#include <seamwright/core/planar/point_move.hpp>
#include <seamwright/core/planar/point_triple.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

/// Which points move along which normals, by how much at most.
struct MovablePoints {
  const PlanarPoints& points;
  bool closed = false;
  PlanarPoints normals;
  Eigen::VectorXd tolerances_mm;
  std::vector<Index> movable = {};   ///< points that may move
  std::vector<Index> variable = {};  ///< by point: its position in movable; -1 if it is fixed

  Index count() const { return static_cast<Index>(movable.size()); }
};

MovablePoints movablePoints(const PlanarPoints& points, const Eigen::VectorXd& tolerances_mm,
                            const PointFairingOptions& options) {
  const Index n = points.rows();
  MovablePoints result{.points = points,
                       .closed = options.closed,
                       .normals = PlanarPoints(n, 2),
                       .tolerances_mm = tolerances_mm,
                       .variable = std::vector<Index>(static_cast<std::size_t>(n), -1)};
  if (!options.closed && options.ends_fixed)
    result.tolerances_mm(0) = result.tolerances_mm(n - 1) = 0;
  for (Index i = 0; i < n; ++i) {
    const Index before = options.closed ? (i + n - 1) % n : std::max<Index>(i - 1, 0);
    const Index after = options.closed ? (i + 1) % n : std::min(i + 1, n - 1);
    const Eigen::RowVector2d chord = (points.row(after) - points.row(before)).normalized();
    result.normals.row(i) << -chord.y(), chord.x();
    if (result.tolerances_mm(i) == 0) continue;
    result.variable[static_cast<std::size_t>(i)] = result.count();
    result.movable.push_back(i);
  }
  return result;
}

/// The points after moves, each a share of its tolerance.
PlanarPoints moved(const MovablePoints& problem, const Eigen::VectorXd& shares) {
  PlanarPoints points = problem.points;
  for (Index k = 0; k < problem.count(); ++k) {
    const Index i = problem.movable[static_cast<std::size_t>(k)];
    const double tolerance_mm = problem.tolerances_mm(i);
    points.row(i) =
        withinDistance(points.row(i) + shares(k) * tolerance_mm * problem.normals.row(i),
                       problem.points.row(i), tolerance_mm);
  }
  return points;
}

/// Residuals whose squares add up to the energy.
Eigen::VectorXd residuals(const PlanarPoints& points, bool closed) {
  const PointTriples triples(points, closed);
  const Index count = triples.count() - (closed ? 0 : 1);
  Eigen::VectorXd result(count);
  for (Index i = 0; i < count; ++i) {
    const PointTriple one = triples.at(i), other = triples.at((i + 1) % triples.count());
    result(i) = (other.curvature_per_mm() - one.curvature_per_mm()) / std::sqrt(one.after.norm());
  }
  return result;
}

/// Derivatives of the residuals by the shares.
Eigen::SparseMatrix<double> jacobian(const MovablePoints& problem, const PlanarPoints& points) {
  const PointTriples triples(points, problem.closed);
  const Index count = triples.count() - (problem.closed ? 0 : 1);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(8 * count));
  for (Index i = 0; i < count; ++i) {
    const Index next = (i + 1) % triples.count();
    const PointTriple one = triples.at(i), other = triples.at(next);
    const double length_mm = one.after.norm(), root = std::sqrt(length_mm);
    const double residual = (other.curvature_per_mm() - one.curvature_per_mm()) / root;
    const auto add = [&](Index point, double slope) {
      const Index column = problem.variable[static_cast<std::size_t>(point)];
      if (column >= 0) entries.emplace_back(i, column, slope);
    };
    const auto addCurvature = [&](const PointTriple& triple, Index index, double factor) {
      const std::array<Index, 3> at = triples.indices(index);
      std::array<Eigen::Vector2d, 3> moves;
      for (std::size_t k = 0; k < 3; ++k)
        moves[k] = problem.tolerances_mm(at[k]) * problem.normals.row(at[k]).transpose();
      const Eigen::Vector3d slopes = triple.curvatureSlopes(moves);
      for (std::size_t k = 0; k < 3; ++k) add(at[k], factor * slopes(static_cast<Index>(k)));
    };
    addCurvature(one, i, -1 / root);
    addCurvature(other, next, 1 / root);
    // The length under the root changes as well.
    const Eigen::Vector2d factor = -residual / (2 * length_mm * length_mm) * one.after;
    const auto [first, from, to] = triples.indices(i);
    add(from, -problem.tolerances_mm(from) * problem.normals.row(from).dot(factor));
    add(to, problem.tolerances_mm(to) * problem.normals.row(to).dot(factor));
  }
  Eigen::SparseMatrix<double> result(count, problem.count());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

struct InteriorPoint {
  Eigen::VectorXd shares;  ///< between -1 and 1
  int steps = 0;
  bool converged = false;
};

/// Half the energy, with a barrier at the bounds of the shares.
double barrierValue(const MovablePoints& problem, const Eigen::VectorXd& shares, double barrier) {
  if (!(shares.cwiseAbs().maxCoeff() < 1)) return infinite;
  const double logs = (1 - shares.array().square()).log().sum();
  return residuals(moved(problem, shares), problem.closed).squaredNorm() / 2 - barrier * logs;
}

/// The largest step up to 1 that keeps 99.5 % off the bound: value + step * change >= value / 200.
double stepToBound(const Eigen::ArrayXd& values, const Eigen::ArrayXd& changes) {
  double step = 1;
  for (Index i = 0; i < values.size(); ++i)
    if (changes(i) < 0) step = std::min(step, -0.995 * values(i) / changes(i));
  return step;
}

struct LineSearch {
  double longest = 1;
  double slope = 0;  ///< of the value at the start, below 0
};

/// The longest halved step that keeps Armijo's rule; 0 if there is none.
double stepLength(const LineSearch& search, const std::function<double(double)>& valueAt) {
  const double value = valueAt(0);
  // 2^-40 of a step is not a step.
  for (double step = search.longest; step > 0x1p-40; step /= 2)
    if (!(valueAt(step) > value + 1e-4 * step * search.slope)) return step;
  return 0;
}

/// A primal-dual interior-point method: lower and upper are the multipliers of share >= -1 and
/// share <= 1, and the barrier falls with their complementarity. At the minimum of the linearised
/// problem the energy is at most twice the complementarity above the least one.
InteriorPoint leastEnergy(const MovablePoints& problem, double negligible, int max_steps,
                          const Progress& progress) {
  // The energy is computed to at least six digits of its least value.
  constexpr double precision = 1e-6;
  // By how much the barrier falls in each step.
  constexpr double centring = 0.2;
  const Index count = problem.count();
  InteriorPoint result{.shares = Eigen::VectorXd::Zero(count)};
  double energy = residuals(problem.points, problem.closed).squaredNorm() / 2;
  double barrier = 0.1 * energy / static_cast<double>(2 * count);
  Eigen::ArrayXd lower = Eigen::ArrayXd::Constant(count, barrier), upper = lower;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>
      factor;
  while (result.steps < max_steps) {
    checkProgress(progress, shareAfter(result.steps));
    const PlanarPoints points = moved(problem, result.shares);
    const Eigen::SparseMatrix<double> slopes = jacobian(problem, points);
    const Eigen::ArrayXd below = 1 + result.shares.array(), above = 1 - result.shares.array();
    Eigen::SparseMatrix<double> matrix = slopes.transpose() * slopes;
    const Eigen::ArrayXd diagonal = lower / below + upper / above;
    for (Index i = 0; i < count; ++i) matrix.coeffRef(i, i) += diagonal(i);
    const Eigen::VectorXd gradient = slopes.transpose() * residuals(points, problem.closed);
    const Eigen::VectorXd barrier_gradient =
        (gradient.array() - barrier / below + barrier / above).matrix();
    factor.compute(matrix);
    if (factor.info() != Eigen::Success) return result;
    const Eigen::VectorXd change = -factor.solve(barrier_gradient);
    ++result.steps;

    const double slope = barrier_gradient.dot(change);
    const double step =
        stepLength({.longest = std::min(stepToBound(below, change.array()),
                                        stepToBound(above, -change.array())),
                    .slope = slope},
                   [&](double share) {
                     checkProgress(progress, shareAfter(result.steps));
                     return barrierValue(problem, result.shares + share * change, barrier);
                   });
    result.shares += step * change;

    const Eigen::ArrayXd lower_change = (barrier - lower * change.array()) / below - lower;
    const Eigen::ArrayXd upper_change = (barrier + upper * change.array()) / above - upper;
    const double multiplier_step =
        std::min(stepToBound(lower, lower_change), stepToBound(upper, upper_change));
    lower += multiplier_step * lower_change;
    upper += multiplier_step * upper_change;

    const double complementarity =
        (lower * (1 + result.shares.array())).sum() + (upper * (1 - result.shares.array())).sum();
    energy = residuals(moved(problem, result.shares), problem.closed).squaredNorm() / 2;
    const double small = precision * energy + negligible;
    const bool still = step * change.cwiseAbs().maxCoeff() < 1e-3 || std::abs(slope) < small;
    if (complementarity < small && still) {
      result.converged = true;
      return result;
    }
    barrier = std::max(centring * complementarity, small / 4) / static_cast<double>(2 * count);
  }
  return result;
}

FairedPoints compared(const PlanarPoints& before, const PlanarPoints& after, bool closed) {
  FairedPoints result{
      .points = after, .before = fairnessOf(before, closed), .after = fairnessOf(after, closed)};
  result.moved_mm = (after - before).rowwise().norm().maxCoeff(&result.most_moved);
  return result;
}

}  // namespace

void requireTolerances(const Eigen::VectorXd& tolerances_mm, Index count) {
  if (tolerances_mm.size() != count)
    refuse(fmt::format("{} tolerances for {} points", tolerances_mm.size(), count));
  for (Index i = 0; i < count; ++i)
    if (!(tolerances_mm(i) >= 0) || tolerances_mm(i) == infinite)
      refuse(fmt::format("the tolerance of point {} is {} mm: it must be at least 0 and finite", i,
                         tolerances_mm(i)));
}

FairedPoints fairPoints(const PlanarPoints& points, const Eigen::VectorXd& tolerances_mm,
                        const PointFairingOptions& options, const Progress& progress) {
  const PointFairness before = fairnessOf(points, options.closed);
  requireTolerances(tolerances_mm, points.rows());
  const MovablePoints problem = movablePoints(points, tolerances_mm, options);
  InteriorPoint found;
  found.converged = true;
  if (problem.count() > 0 && before.energy_per_mm3 > before.rounding_per_mm3)
    found = leastEnergy(problem, before.rounding_per_mm3 / 2, options.max_steps, progress);
  FairedPoints result =
      compared(points, found.steps > 0 ? moved(problem, found.shares) : points, options.closed);
  if (!(result.after.energy_per_mm3 < before.energy_per_mm3))
    result = compared(points, points, options.closed);
  result.steps = found.steps;
  result.converged = found.converged;
  return result;
}

}  // namespace seamwright
