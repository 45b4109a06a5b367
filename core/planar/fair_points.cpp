// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/fair_points.hpp>
#include <seamwright/core/planar/narrow_band.hpp>
#include <seamwright/core/planar/point_energy.hpp>
#include <seamwright/core/planar/point_move.hpp>

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
  MovablePoints result{.points = points, .closed = options.closed, .tolerances_mm = tolerances_mm};
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

/// When a search ends.
struct SearchEnd {
  double precision = 0;  ///< of the energy, relative
  int max_steps = 0;
  double least_part = 0;  ///< of a step: a smaller one is the last
};

/// A primal-dual interior-point method: lower and upper are the multipliers of share >= -1 and
/// share <= 1, and the barrier falls with their complementarity. At the minimum of the linearised
/// problem the energy is at most twice the complementarity above the least one.
class InteriorPoint {
 public:
  InteriorPoint(MovablePoints problem, double negligible, const Progress& progress)
      : problem_(std::move(problem)),
        order_{.count = problem_.points.rows(), .closed = problem_.closed},
        progress_(progress),
        negligible_(negligible),
        shares_(VectorXd::Zero(order_.count)),
        points_(problem_.points) {
    energy_ = energyOf(points_);
    barrier_ = 0.1 * energy_ / bounds();
    lower_ = upper_ = ArrayXd::Constant(order_.count, barrier_);
  }

  const PlanarPoints& points() const { return points_; }
  int steps() const { return steps_; }

  /// \returns whether the precision was reached.
  bool improve(EnergyLengths lengths, const SearchEnd& end) {
    // By how much the barrier falls after a whole step. After a shorter one it falls by less:
    // otherwise points stick at their bounds before the others have moved.
    constexpr double centring = 0.2;
    while (steps_ < end.max_steps) {
      checkProgress(progress_, shareAfter(steps_));
      const ArrayXd below = 1 + shares_.array(), above = 1 - shares_.array();
      const VectorXd change = gaussNewtonStep(lengths, below, above);
      if (!change.allFinite()) return false;
      ++steps_;
      const double part = move(change, lengths);
      raise(change.array(), below, above);
      const double gap = complementarity();
      const double small = end.precision * energy_ + negligible_;
      const bool still = change.cwiseAbs().maxCoeff() < 1e-3 || std::abs(slope_) < small;
      if (gap < small && still) return true;
      barrier_ = std::max(std::max(centring, 1 - part) * gap, small / 4) / bounds();
      if (part < end.least_part) return false;
    }
    return false;
  }

  /// From here on points move along the normals of the curve that was found. They slide along it to
  /// where these normals pass through the points as they were given.
  void followCurve() {
    const MoveNormals normals = moveNormals(points_, VectorXd::Zero(order_.count), problem_.closed);
    for (Index i = 0; i < order_.count; ++i) {
      const double tolerance_mm = problem_.tolerances_mm(i);
      if (tolerance_mm == 0) continue;
      const Eigen::RowVector2d normal = normals.vectors.row(i);
      shares_(i) = normal.dot(points_.row(i) - problem_.points.row(i)) / tolerance_mm;
      problem_.moves.row(i) = tolerance_mm * normal;
    }
    points_ = moved(problem_, shares_);
    energy_ = energyOf(points_);
  }

 private:
  double bounds() const { return static_cast<double>(2 * order_.count); }
  double energyOf(const PlanarPoints& points) const {
    return halfEnergyOf({.points = points, .lengths_of = points}, problem_.closed);
  }
  double complementarity() const {
    return (lower_ * (1 + shares_.array())).sum() + (upper_ * (1 - shares_.array())).sum();
  }
  /// Minus the barrier's part of the value.
  double logs(const VectorXd& shares) const {
    return barrier_ * (1 - shares.array().square()).log().sum();
  }

  /// The change of the shares that makes the squares of residual + slopes . change and of
  /// root change + barrier_slope / root least, with the multipliers eliminated.
  VectorXd gaussNewtonStep(EnergyLengths lengths, const ArrayXd& below, const ArrayXd& above) {
    const ArrayXd roots = (lower_ / below + upper_ / above).sqrt();
    const ArrayXd barrier_slopes = barrier_ / above - barrier_ / below;
    const std::vector<EnergyRow> rows =
        energyRowsOf(points_, problem_.moves, lengths, problem_.closed);
    if (row_order_.empty()) row_order_ = orderOf(rows, order_);
    NarrowLeastSquares squares(order_);
    auto next = row_order_.begin();
    for (Index place = 0; place < order_.count; ++place) {
      for (; next != row_order_.end() && firstPlaceOf(rows[*next], order_) == place; ++next) {
        const EnergyRow& row = rows[*next];
        std::array<NarrowLeastSquares::Term, 4> terms = {};
        for (std::size_t k = 0; k < 4; ++k)
          terms[k] = {.unknown = row.points[k], .factor = row.slopes[k]};
        squares.add(terms, -row.residual);
      }
      const Index i = order_.unknownAt(place);
      squares.add(std::array{NarrowLeastSquares::Term{.unknown = i, .factor = roots(i)}},
                  -barrier_slopes(i) / roots(i));
    }
    VectorXd change = squares.solve();
    // That of a minimum of squares.
    slope_ = -(roots * change.array()).square().sum();
    for (const EnergyRow& row : rows) {
      double along = 0;
      for (std::size_t k = 0; k < 4; ++k) along += row.slopes[k] * change(row.points[k]);
      slope_ -= along * along;
    }
    return change;
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
      const double energy =
          lengths == EnergyLengths::Own
              ? energyOf(points)
              : halfEnergyOf({.points = points, .lengths_of = points_}, problem_.closed);
      if (!(energy - logs(shares) <= value + 1e-4 * part * slope_)) continue;
      shares_ = shares;
      points_ = std::move(points);
      energy_ = lengths == EnergyLengths::Own ? energy : energyOf(points_);
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

  MovablePoints problem_;
  NarrowOrder order_;
  std::vector<std::size_t> row_order_ = {};  ///< rows of the energy by their first place
  const Progress& progress_;
  double negligible_ = 0;
  VectorXd shares_;  ///< between -1 and 1
  PlanarPoints points_;
  ArrayXd lower_, upper_;
  double energy_ = 0, barrier_ = 0;  ///< half the energy of PointFairness
  double slope_ = 0;                 ///< of the value along the last step, below 0
  int steps_ = 0;
};

struct FoundPoints {
  PlanarPoints points;
  int steps = 0;
  PointFairingStatus status = PointFairingStatus::Converged;
};

FoundPoints leastEnergy(MovablePoints problem, double negligible, int max_steps,
                        const Progress& progress) {
  // The energy is computed to at least six digits of its least value.
  constexpr double precision = 1e-6;
  const bool crowded = problem.crowded;
  InteriorPoint search(std::move(problem), negligible, progress);
  if (crowded) {
    // The curvature of the circle through three points falls again where moves across the curve
    // exceed their distances, so the energy has minima far from the least. With given lengths it
    // grows with the moves. Two digits are enough to begin from; from short steps on, the bends of
    // the problem outweigh what a step wins.
    constexpr double first_precision = 1e-2, least_part = 0.25;
    constexpr int first_steps = 30;
    search.improve(EnergyLengths::Given, {.precision = first_precision,
                                          .max_steps = std::min(first_steps, max_steps),
                                          .least_part = least_part});
    search.followCurve();
  }
  const bool converged =
      search.improve(EnergyLengths::Own, {.precision = precision, .max_steps = max_steps});
  return {.points = search.points(),
          .steps = search.steps(),
          .status = converged ? PointFairingStatus::Converged : PointFairingStatus::NotConverged};
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
  FoundPoints found{.points = points};
  if ((problem.tolerances_mm.array() > 0).any() && before.energy_per_mm3 > before.rounding_per_mm3)
    found =
        leastEnergy(std::move(problem), before.rounding_per_mm3 / 2, options.max_steps, progress);
  FairedPoints result = compared(points, found.points, options.closed);
  if (!(result.after.energy_per_mm3 < before.energy_per_mm3))
    result = compared(points, points, options.closed);
  result.steps = found.steps;
  result.status = found.status;
  return result;
}

}  // namespace seamwright
