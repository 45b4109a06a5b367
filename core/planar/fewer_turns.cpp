// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <seamwright/core/planar/fair_clothoids.hpp>
#include <seamwright/core/planar/fewer_turns.hpp>
#include <seamwright/core/planar/point_curvature.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

/// The curve keeps to the side of the circles through three points.
CurvatureShape sidesOf(const PlanarPoints& points, bool closed) {
  // Far above what linearisation misses near the solution, and far below the curvature.
  constexpr double margin = 0.01;
  // As for ChainFigures.
  constexpr double negligible = 1e-9;
  CurvatureShape shape;
  const Eigen::VectorXd circles = pointCurvatures_per_mm(points, closed);
  const double least = negligible * circles.cwiseAbs().maxCoeff();
  const Index first = closed ? 0 : 1;
  for (Index i = 0; i < circles.size(); ++i)
    if (std::abs(circles(i)) > least)
      shape.keepSide(first + i, circles(i) > 0 ? 1 : -1, margin * std::abs(circles(i)));
  return shape;
}

/// The curve turns to one side.
CurvatureShape oneSideOf(const PlanarPoints& points, bool closed) {
  constexpr double margin = 0.01;
  CurvatureShape shape;
  const Eigen::VectorXd circles = pointCurvatures_per_mm(points, closed);
  const double sign = circles.sum() > 0 ? 1 : -1;
  // The curvature that is left where points turn to the other side: that of the flattest points.
  const double least = margin * circles.cwiseAbs().minCoeff();
  const Index first = closed ? 0 : 1;
  for (Index i = 0; i < circles.size(); ++i)
    shape.keepSide(first + i, sign, std::max(least, margin * sign * circles(i)));
  return shape;
}

/// Indices of the extrema that rise above those beside them by more than the height.
std::vector<Index> highExtrema(const Eigen::VectorXd& values, bool closed, double height) {
  const Index n = values.size();
  Index start = 0;
  if (closed) values.maxCoeff(&start);
  int direction = closed ? -1 : 0;
  std::vector<Index> found;
  if (closed) found.push_back(start);
  Index high = start, low = start;
  for (Index step = 1; step < n + (closed ? 1 : 0); ++step) {
    const Index i = (start + step) % n;
    if (values(i) > values(high)) high = i;
    if (values(i) < values(low)) low = i;
    if (direction <= 0 && values(i) > values(low) + height) {
      if (direction < 0) found.push_back(low);
      direction = 1;
      high = i;
    } else if (direction >= 0 && values(i) < values(high) - height) {
      if (direction > 0) found.push_back(high);
      direction = -1;
      low = i;
    }
    if (direction > 0) low = i;
    if (direction < 0) high = i;
  }
  return found;
}

/// Between the extrema the curvature is monotone.
void keepMonotone(CurvatureShape& shape, const FairingRun& run, const std::vector<Clothoid>& chain,
                  const std::vector<Index>& extrema) {
  const Eigen::VectorXd values = curvaturesAt(chain, run.closed);
  const double length_mm = figuresOf(chain, run.closed).length_mm;
  // Far above the rounding of curvatures, and far below any slope that is seen.
  constexpr double margin = 1e-4;
  const double slope = margin * (values.maxCoeff() - values.minCoeff()) / length_mm;
  std::vector<Index> ends = extrema;
  if (run.closed) {
    ends.push_back(extrema.front() + run.count());
  } else {
    ends.insert(ends.begin(), 0);
    ends.push_back(run.count() - 1);
  }
  for (std::size_t k = 1; k < ends.size(); ++k) {
    Index to = ends[k];
    if (to < ends[k - 1]) to += run.count();
    const double sign = values(to % run.count()) > values(ends[k - 1] % run.count()) ? 1 : -1;
    for (Index i = ends[k - 1]; i < to; ++i) {
      const Index s = i % run.count();
      // The pieces at open ends are arcs.
      if (!run.closed && (s == 0 || s + 2 == run.count())) continue;
      shape.keepSlope(s, run.next(s), sign, slope * chain[static_cast<std::size_t>(s)].length_mm);
    }
  }
}

/// Whether a curve has fewer inflections, or as many and fewer extrema.
bool hasFewerTurns(const ClothoidFigures& one, const ClothoidFigures& other) {
  return std::pair(one.inflections, one.extrema) < std::pair(other.inflections, other.extrema);
}

/// Looks for a curve with fewer inflections and extrema that costs little variation.
class TurnReduction {
 public:
  TurnReduction(const FairingRun& run, const RunFairing& fairing, double most_variation_per_mm3)
      : run_(run), fairing_(fairing), most_variation_per_mm3_(most_variation_per_mm3) {}

  bool tryShape(const CurvatureShape& shape, FairingState& best, int& steps) const {
    FairingSearch search = fairing_.improved(best, shape, steps);
    steps += search.steps;
    if (!search.feasible) return false;
    const ClothoidFigures found = figuresOf(search.state.chain, run_.closed);
    if (!hasFewerTurns(found, figuresOf(best.chain, run_.closed)) ||
        found.variation_per_mm3 > most_variation_per_mm3_)
      return false;
    best = std::move(search.state);
    return true;
  }

  /// Without extrema below a height, from high to low.
  void flatten(const CurvatureShape& sides, FairingState& best, int& steps) const {
    const std::vector<Clothoid> chain = best.chain;
    const Eigen::VectorXd values = curvaturesAt(chain, run_.closed);
    const double range = values.maxCoeff() - values.minCoeff();
    std::size_t tried = 0;
    for (const double share : {0.3, 0.1, 0.03, 0.01, 0.003, 0.001, 3e-4, 1e-4, 3e-5}) {
      const std::vector<Index> extrema = highExtrema(values, run_.closed, share * range);
      if (std::ssize(extrema) >= figuresOf(chain, run_.closed).extrema) return;
      if (extrema.size() % 2 != 0 && run_.closed) continue;
      if (share < 0.3 && extrema.size() == tried) continue;
      tried = extrema.size();
      CurvatureShape shape = sides;
      keepMonotone(shape, run_, chain, extrema);
      if (tryShape(shape, best, steps)) return;
    }
  }

 private:
  const FairingRun& run_;
  const RunFairing& fairing_;
  double most_variation_per_mm3_;
};

}  // namespace

FairingSearch fewerTurns(const FairingRun& run, const RunFairing& fairing, FairingState now,
                         const PlanarPoints& fair_points, double most_variation_per_mm3) {
  constexpr double most_times = 2;
  CurvatureShape sides = sidesOf(fair_points, run.closed);
  FairingSearch best = fairing.improved(std::move(now), sides, 0);
  const TurnReduction reduction(
      run, fairing, std::min(most_times * variationOf(best.state.chain), most_variation_per_mm3));
  if (figuresOf(best.state.chain, run.closed).inflections > 0) {
    const CurvatureShape one_side = oneSideOf(fair_points, run.closed);
    if (reduction.tryShape(one_side, best.state, best.steps)) sides = one_side;
  }
  reduction.flatten(sides, best.state, best.steps);
  return best;
}

}  // namespace seamwright
