// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstdio>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/fair_points.hpp>
#include <seamwright/core/planar/narrow_band.hpp>
#include <seamwright/core/planar/point_energy.hpp>
#include <seamwright/core/planar/point_move.hpp>
#include <seamwright/core/planar/point_triple.hpp>

namespace seamwright {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

/// Which points move, along which vectors by a share of 1.
struct MovablePoints {
  const PlanarPoints& points;
  bool closed = false;
  VectorXd tolerances_mm;  ///< 0 for points that stay
  PlanarPoints moves = {};
  bool crowded = false;
};

MovablePoints movablePoints(const PlanarPoints& points, const VectorXd& tolerances_mm,
                            const PointFairingOptions& options) {
  MovablePoints result{
      .points = points, .closed = options.closed, .tolerances_mm = tolerances_mm};
  VectorXd& tolerances = result.tolerances_mm;
  if (!options.closed && options.ends_fixed) tolerances(0) = tolerances(points.rows() - 1) = 0;
  MoveNormals normals = moveNormals(points, tolerances, options.closed);
  result.moves = tolerances.asDiagonal() * normals.vectors;
  result.crowded = normals.crowded;
  return result;
}

/// The points after moves, each a share of its tolerance.
PlanarPoints moved(const MovablePoints& problem, const VectorXd& shares) {
  PlanarPoints points = problem.points;
  for (Index i = 0; i < points.rows(); ++i)
    if (problem.tolerances_mm(i) > 0)
      points.row(i) = withinDistance(points.row(i) + shares(i) * problem.moves.row(i),
                                     problem.points.row(i), problem.tolerances_mm(i));
  return points;
}

/// The largest step up to 1 that keeps 99.5 % off the bound: value + step * change >= value / 200.
double stepToBound(const ArrayXd& values, const ArrayXd& changes) {
  double step = 1;
  for (Index i = 0; i < values.size(); ++i)
    if (changes(i) < 0) step = std::min(step, -0.995 * values(i) / changes(i));
  return step;
}

/// A primal-dual interior-point method: lower and upper are the multipliers of share >= -1 and
/// share <= 1, and the barrier falls with their complementarity. At the minimum of the linearised
/// problem the energy is at most twice the complementarity above the least one.
class InteriorPoint {
 public:
  InteriorPoint(MovablePoints& problem, double negligible, const Progress& progress)
      : problem_(problem),
        progress_(progress),
        negligible_(negligible),
        shares_(VectorXd::Zero(problem.points.rows())),
        points_(problem.points) {
    energy_ = halfEnergyOf({.points = points_, .lengths_of = points_}, problem_.closed);
    barrier_ = 0.1 * energy_ / bounds();
    lower_ = upper_ = ArrayXd::Constant(shares_.size(), barrier_);
  }

  const PlanarPoints& points() const { return points_; }
  int steps() const { return steps_; }

  /// Steps until the energy has this precision. \returns whether it was reached.
  bool improve(EnergyLengths lengths, double precision, int max_steps) {
    // By how much the barrier falls in each step.
    constexpr double centring = 0.2;
    while (steps_ < max_steps) {
      checkProgress(progress_, shareAfter(steps_));
      const ArrayXd below = 1 + shares_.array(), above = 1 - shares_.array();
      const VectorXd change = newtonStep(lengths, below, above);
      if (!change.allFinite()) return false;
      ++steps_;
      const double part = move(change, lengths);
      raise(change.array(), below, above);
      const double gap = complementarity();
      const double small = precision * energy_ + negligible_;
      const bool still =
          change.cwiseAbs().maxCoeff() < 1e-3 || std::abs(slope_) < small;
      if(std::getenv("DBG2")) std::printf("%d part %.3g maxc %.3g slope %.3g E %.6g gap %.3g barrier %.3g\n",steps_,part,change.cwiseAbs().maxCoeff(),slope_,energy_,gap,barrier_);
      if (gap < small && still) return true;
      barrier_ = std::max(std::max(centring, 1 - part) * gap, small / 4) / bounds();
      if (lengths == EnergyLengths::Given && part < 0.25) return false;
    }
    return false;
  }

  void followCurve() {
    if (std::getenv("NOF")) return;
    const MoveNormals normals = moveNormals(points_, VectorXd::Zero(shares_.size()), problem_.closed);
    for (Index i = 0; i < shares_.size(); ++i) {
      const double t = problem_.tolerances_mm(i);
      if (t == 0) continue;
      const Eigen::RowVector2d n = normals.vectors.row(i);
      shares_(i) = n.dot(points_.row(i) - problem_.points.row(i)) / t;
      problem_.moves.row(i) = t * n;
    }
    points_ = moved(problem_, shares_);
    energy_ = halfEnergyOf({.points = points_, .lengths_of = points_}, problem_.closed);
    if(std::getenv("DBG2")) std::printf("follow E %.6g\n", energy_);
  }

 private:
  double bounds() const { return static_cast<double>(2 * shares_.size()); }

  double complementarity() const {
    return (lower_ * (1 + shares_.array())).sum() + (upper_ * (1 - shares_.array())).sum();
  }

  /// Minus the barrier's part of the value.
  double logs(const VectorXd& shares) const {
    return barrier_ * (1 - shares.array().square()).log().sum();
  }

  /// Gauss and Newton's, with the multipliers eliminated: it makes the sum of the squares of
  /// residual + slopes . change and root (change + barrier_slope / root^2) least.
  VectorXd newtonStep(EnergyLengths lengths, const ArrayXd& below, const ArrayXd& above) {
    const Index count = shares_.size();
    const ArrayXd roots = (lower_ / below + upper_ / above).sqrt();
    const ArrayXd barrier_slopes = barrier_ / above - barrier_ / below;
    const std::vector<EnergyRow> rows =
        energyRowsOf(points_, problem_.moves, lengths, problem_.closed);
    NarrowLeastSquares squares(count, problem_.closed);
    addByPlace(squares, rows, roots, barrier_slopes);
    VectorXd change = squares.solve();
    slope_ = -(roots * change.array()).square().sum();
    for (const EnergyRow& row : rows) {
      double along = 0;
      for (std::size_t k = 0; k < 4; ++k) along += row.slopes[k] * change(row.points[k]);
      slope_ -= along * along;
    }
    return change;
  }

  void addByPlace(NarrowLeastSquares& squares, const std::vector<EnergyRow>& rows, const ArrayXd& roots, const ArrayXd& barrier_slopes) const {
    const auto addRow = [&](const EnergyRow& row) {
      std::array<NarrowLeastSquares::Term, 4> terms;
      for (std::size_t k = 0; k < 4; ++k)
        terms[k] = {.unknown = row.points[k], .factor = row.slopes[k]};
      squares.add(terms, -row.residual);
    };
    const auto addBound = [&](Index i) {
      squares.add(std::array{NarrowLeastSquares::Term{.unknown = i, .factor = roots(i)}}, -barrier_slopes(i) / roots(i));
    };
    const Index n = shares_.size();
    if (!problem_.closed) {
      for (Index i = 0; i < n; ++i) {
        if (i < std::ssize(rows)) addRow(rows[static_cast<std::size_t>(i)]);
        addBound(i);
      }
      return;
    }
    // order by first place
    std::vector<std::vector<Index>> at(static_cast<std::size_t>(n));
    for (std::size_t k = 0; k < rows.size(); ++k) {
      Index first = n;
      for (const Index p : rows[k].points) first = std::min(first, squares.placeOf(p));
      at[static_cast<std::size_t>(first)].push_back(static_cast<Index>(k));
    }
    for (Index place = 0; place < n; ++place) {
      for (const Index k : at[static_cast<std::size_t>(place)]) addRow(rows[static_cast<std::size_t>(k)]);
      addBound(place % 2 == 0 ? place / 2 : n - 1 - place / 2);
    }
  }

  /// Takes the longest halved step that keeps Armijo's rule, if there is one. \returns its part of
  /// the change.
  double move(const VectorXd& change, EnergyLengths lengths) {
    const double value = energy_ - logs(shares_);
    const double longest = std::min(stepToBound(1 + shares_.array(), change.array()),
                                    stepToBound(1 - shares_.array(), -change.array()));
    // 2^-40 of a step is not a step.
    for (double part = longest; part > 0x1p-40; part /= 2) {
      checkProgress(progress_, shareAfter(steps_));
      const VectorXd shares = shares_ + part * change;
      if (!(shares.cwiseAbs().maxCoeff() < 1)) continue;
      PlanarPoints points = moved(problem_, shares);
      const bool own = lengths == EnergyLengths::Own;
      const double energy = halfEnergyOf({.points = points, .lengths_of = own ? points : points_},
                                         problem_.closed);
      if (!(energy - logs(shares) <= value + 1e-4 * part * slope_)) continue;
      shares_ = shares;
      points_ = std::move(points);
      energy_ = own ? energy
                    : halfEnergyOf({.points = points_, .lengths_of = points_}, problem_.closed);
      return part;
    }
    return 0;
  }

  /// Steps of the multipliers, from distances to the bounds before the step.
  void raise(const ArrayXd& change, const ArrayXd& below, const ArrayXd& above) {
    const ArrayXd lower_change = (barrier_ - lower_ * change) / below - lower_;
    const ArrayXd upper_change = (barrier_ + upper_ * change) / above - upper_;
    const double part =
        std::min(stepToBound(lower_, lower_change), stepToBound(upper_, upper_change));
    lower_ += part * lower_change;
    upper_ += part * upper_change;
  }

  MovablePoints& problem_;
  const Progress& progress_;
  double negligible_ = 0;
  VectorXd shares_;  ///< between -1 and 1
  PlanarPoints points_;
  ArrayXd lower_, upper_;
  double energy_ = 0, barrier_ = 0;
  double slope_ = 0;  ///< of the value by the last step, below 0
  int steps_ = 0;
};

struct FoundPoints {
  PlanarPoints points;
  int steps = 0;
  bool converged = false;
};

FoundPoints leastEnergy(MovablePoints& problem, double negligible, int max_steps,
                        const Progress& progress) {
  // The energy is computed to at least six digits of its least value.
  constexpr double precision = 1e-6;
  InteriorPoint search(problem, negligible, progress);
  if (problem.crowded && !std::getenv("NOG")) search.improve(EnergyLengths::Given, 1e-2, std::min(30,max_steps)), search.followCurve();
  if(std::getenv("DBG")) std::printf("phase1 %d\n", search.steps());
  const bool converged = search.improve(EnergyLengths::Own, precision, max_steps);
  return {.points = search.points(), .steps = search.steps(), .converged = converged};
}

FairedPoints compared(const PlanarPoints& before, const PlanarPoints& after, bool closed) {
  FairedPoints result{
      .points = after, .before = fairnessOf(before, closed), .after = fairnessOf(after, closed)};
  result.moved_mm = (after - before).rowwise().norm().maxCoeff(&result.most_moved);
  return result;
}

}  // namespace

FairedPoints fairPoints(const PlanarPoints& points, const Eigen::VectorXd& tolerances_mm,
                        const PointFairingOptions& options, const Progress& progress) {
  const PointFairness before = fairnessOf(points, options.closed);
  requireTolerances(tolerances_mm, points.rows());
  MovablePoints problem = movablePoints(points, tolerances_mm, options);
  FoundPoints found{.points = points, .converged = true};
  if ((problem.tolerances_mm.array() > 0).any() && before.energy_per_mm3 > before.rounding_per_mm3)
    found = leastEnergy(problem, before.rounding_per_mm3 / 2, options.max_steps, progress);
  FairedPoints result = compared(points, found.points, options.closed);
  if (!(result.after.energy_per_mm3 < before.energy_per_mm3))
    result = compared(points, points, options.closed);
  result.steps = found.steps;
  result.converged = found.converged;
  return result;
}

}  // namespace seamwright
