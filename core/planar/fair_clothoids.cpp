// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/fair_clothoids.hpp>
#include <seamwright/core/planar/fair_points.hpp>
#include <seamwright/core/planar/fairing_run.hpp>
#include <seamwright/core/planar/fewer_turns.hpp>
#include <seamwright/core/planar/planar_chain.hpp>
#include <seamwright/core/planar/point_move.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

struct FairedRun {
  PlanarPoints points;
  std::vector<Clothoid> pieces;
  std::optional<ClothoidFigures> before;
  ClothoidFigures after;
  int point_inflections = 0;
  int steps = 0;
  bool stays = false;  ///< nothing fairer was found
};

FairedRun unmovedRun(const FairingRun& run) {
  FairedRun result;
  result.points = run.points;
  result.pieces = chainThrough(run.points, run.closed);
  result.after = figuresOf(result.pieces, run.closed);
  result.before = result.after;
  return result;
}

FairedRun fairedWithin(const FairingRun& run) {
  const FairedPoints faired =
      fairPoints(run.points, run.tolerances_mm, {.closed = run.closed, .ends_fixed = false},
                 partOf(run.progress, 0, 0));
  FairedRun result;
  result.point_inflections = static_cast<int>(faired.after.inflections.size());
  const RunFairing fairing(run, faired.points);
  std::optional<FairingState> given = fairing.stateAt(run.points);
  std::optional<FairingState> best = fairing.stateAt(faired.points);
  if (given) result.before = figuresOf(given->chain, run.closed);
  if (!best) best = given;
  if (!best) chainThrough(faired.points, run.closed);  // throws
  if (faired.moved_mm > 0 || !given) {
    double most = infinite;
    if (result.before) most = result.before->variation_per_mm3;
    FairingSearch search = fewerTurns(run, fairing, std::move(*best), faired.points, most);
    result.steps = search.steps;
    best = std::move(search.state);
  }
  result.after = figuresOf(best->chain, run.closed);
  if (result.before && (result.after.inflections > result.before->inflections ||
                        result.after.variation_per_mm3 >= result.before->variation_per_mm3)) {
    best = std::move(given);
    result.after = *result.before;
    result.stays = true;
  }
  result.points = best->points;
  result.pieces = std::move(best->chain);
  return result;
}

int turnsOf(const ClothoidFigures& figures) {
  return figures.extrema + figures.inflections;
}

/// Whether a run has more extrema or inflections than before, or stays as it is.
bool isLacking(const FairedRun& run) {
  return run.stays || (run.before && (run.after.extrema > run.before->extrema ||
                                      run.after.inflections > run.before->inflections));
}

/// The search may miss the solution where points may move by about their distances: with a part of
/// the tolerances it can find fewer extrema and inflections. These may cost up to twice the
/// variation, as in fewerTurns().
FairedRun fairRun(const FairingRun& run) {
  if (run.count() < 3) return unmovedRun(run);
  constexpr double most_times = 2;
  FairedRun best = fairedWithin(run);
  const double most_per_mm3 = most_times * best.after.variation_per_mm3;
  int steps = best.steps;
  for (const double share : {0.5, 0.2, 0.1, 0.05}) {
    if (turnsOf(best.after) <= 1) break;
    FairingRun part = run;
    part.tolerances_mm *= share;
    part.progress = partOf(run.progress, 1, 1);
    FairedRun found = fairedWithin(part);
    steps += found.steps;
    // Then the curve follows errors, and smaller parts will too.
    constexpr int most_turns = 2;
    if (!isLacking(best) && turnsOf(found.after) > most_turns * turnsOf(best.after)) break;
    const bool fewer =
        turnsOf(found.after) < turnsOf(best.after) && found.after.variation_per_mm3 <= most_per_mm3;
    if (!isLacking(found) && (isLacking(best) || fewer)) best = std::move(found);
  }
  best.steps = steps;
  return best;
}

void addFigures(ClothoidFigures& sum, const ClothoidFigures& part) {
  sum.length_mm += part.length_mm;
  sum.energy_per_mm += part.energy_per_mm;
  sum.variation_per_mm3 += part.variation_per_mm3;
  sum.extrema += part.extrema;
  sum.inflections += part.inflections;
}

void requireCorners(const std::vector<Index>& corners, Index count, bool closed) {
  Index last = closed ? -1 : 0;
  for (const Index corner : corners) {
    if (corner <= last || corner >= count - (closed ? 0 : 1))
      refuse(fmt::format("corner {} of {} points: corners must be ascending, and inside", corner,
                         count));
    last = corner;
  }
}

/// With 0 for corners and for ends that stay.
Eigen::VectorXd tolerancesOfMoves(const Eigen::VectorXd& tolerances_mm,
                                  const ClothoidFairingOptions& options) {
  Eigen::VectorXd result = tolerances_mm;
  if (!options.closed && options.ends_fixed) result(0) = result(result.size() - 1) = 0;
  for (const Index corner : options.corners) result(corner) = 0;
  return result;
}

}  // namespace

ClothoidFigures figuresOf(const std::vector<Clothoid>& chain, bool closed) {
  ClothoidFigures result;
  double largest = 0;
  std::vector<double> curvatures;
  for (const Clothoid& piece : chain) {
    const double k = piece.curvature_per_mm, s = piece.curvature_slope_per_mm2, l = piece.length_mm;
    result.length_mm += l;
    result.energy_per_mm += l * (k * k + k * s * l + s * s * l * l / 3);
    for (const double end : {k, piece.curvatureAt_per_mm(l)}) {
      curvatures.push_back(end);
      largest = std::max(largest, std::abs(end));
    }
  }
  result.variation_per_mm3 = variationOf(chain);
  // As for ChainFigures.
  constexpr double negligible = 1e-9;
  const SequenceTurns turns =
      turnsOf(curvatures, closed, negligible * std::max(largest, 1 / result.length_mm));
  result.extrema = turns.extrema;
  result.inflections = turns.inflections;
  return result;
}

FairedClothoids fairClothoids(const PlanarPoints& points, const Eigen::VectorXd& tolerances_mm,
                              const ClothoidFairingOptions& options, const Progress& progress) {
  const Index count = points.rows();
  fairnessOf(points, options.closed);  // throws for points without curvatures
  requireTolerances(tolerances_mm, count);
  requireCorners(options.corners, count, options.closed);
  const Eigen::VectorXd movable_mm = tolerancesOfMoves(tolerances_mm, options);
  FairedClothoids result;
  result.points = points;
  result.corners = options.corners;
  result.before = ClothoidFigures{};
  const bool smooth = options.closed && options.corners.empty();
  // A closed curve begins at its first point, which may be inside of a run.
  const auto first = static_cast<std::size_t>(
      options.closed && !options.corners.empty() ? options.corners.front() : 0);
  double done = 0;
  for (const std::vector<Index>& indices : runsBetween(count, options.corners, options.closed)) {
    const auto size = static_cast<Index>(indices.size());
    const double share = static_cast<double>(size) / static_cast<double>(count + 1);
    FairingRun run{.points = PlanarPoints(size, 2),
                   .tolerances_mm = Eigen::VectorXd(size),
                   .closed = smooth,
                   .progress = partOf(progress, done, std::min(1.0, done + share))};
    done = std::min(1.0, done + share);
    for (Index i = 0; i < size; ++i) {
      run.points.row(i) = points.row(indices[static_cast<std::size_t>(i)]);
      run.tolerances_mm(i) = movable_mm(indices[static_cast<std::size_t>(i)]);
    }
    FairedRun faired = fairRun(run);
    for (Index i = 0; i < size; ++i)
      result.points.row(indices[static_cast<std::size_t>(i)]) = faired.points.row(i);
    result.pieces.insert(result.pieces.end(), faired.pieces.begin(), faired.pieces.end());
    addFigures(result.after, faired.after);
    if (result.before && faired.before)
      addFigures(*result.before, *faired.before);
    else
      result.before.reset();
    result.point_inflections += faired.point_inflections;
    result.steps += faired.steps;
  }
  auto& pieces = result.pieces;
  std::rotate(pieces.begin(), pieces.end() - static_cast<std::ptrdiff_t>(first), pieces.end());
  result.moved_mm = (result.points - points).rowwise().norm().maxCoeff();
  return result;
}

}  // namespace seamwright
