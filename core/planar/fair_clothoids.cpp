// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/clothoid_curvatures.hpp>
#include <seamwright/core/planar/clothoid_spline.hpp>
#include <seamwright/core/planar/curvature_program.hpp>
#include <seamwright/core/planar/fair_clothoids.hpp>
#include <seamwright/core/planar/fair_points.hpp>
#include <seamwright/core/planar/planar_chain.hpp>
#include <seamwright/core/planar/point_move.hpp>

namespace seamwright {

namespace {

using Eigen::Index;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// The part of a curve between corners, or all of it.
struct FairingRun {
  PlanarPoints points;
  Eigen::VectorXd tolerances_mm;
  bool closed = false;
  Progress progress = {};

  Index count() const { return points.rows(); }
  Index segments() const { return closed ? count() : count() - 1; }
  Index next(Index i) const { return (i + 1) % count(); }
};

struct FairedRun {
  PlanarPoints points;
  std::vector<Clothoid> pieces;
  std::optional<ClothoidFigures> before;
  ClothoidFigures after;
  int point_inflections = 0;
  int steps = 0;
};

using Chain = std::vector<Clothoid>;

/// The curve through the points; two points have a line.
Chain chainThrough(const PlanarPoints& points, bool closed) {
  ClothoidSplineOptions options{.closed = closed, .start = {}, .end = {}};
  if (!closed && points.rows() > 2) options.start.arc = options.end.arc = true;
  return clothoidSpline(points, options).pieces;
}

std::optional<Chain> triedChain(const PlanarPoints& points, bool closed) {
  try {
    return chainThrough(points, closed);
  } catch (const std::domain_error&) {  // the points are too few for their turns
    return std::nullopt;
  } catch (const std::invalid_argument&) {  // moves made neighbours equal
    return std::nullopt;
  }
}

/// Curvatures at the points. They are continuous, so that each is that of the piece after it.
Eigen::VectorXd curvaturesAt(const Chain& chain, bool closed) {
  const auto count = static_cast<Index>(chain.size());
  Eigen::VectorXd result(count + (closed ? 0 : 1));
  for (Index s = 0; s < count; ++s) result(s) = chain[static_cast<std::size_t>(s)].curvature_per_mm;
  if (!closed) result(count) = chain.back().curvatureAt_per_mm(chain.back().length_mm);
  return result;
}

double variationOf(const Chain& chain) {
  double sum = 0;
  for (const Clothoid& piece : chain)
    sum += piece.curvature_slope_per_mm2 * piece.curvature_slope_per_mm2 * piece.length_mm;
  return sum;
}

/// Units that make curvatures and energies about 1.
struct FairingUnits {
  double curvature_per_mm = 1, variation_per_mm3 = 1;
};

/// Points, their moves as shares of the tolerances, and the curve.
struct FairingState {
  Eigen::VectorXd shares;
  PlanarPoints points;
  Chain chain;
};

/// Bounds of curvatures at points, which keep the curve from turning to the other side, and of
/// their differences, which keep the curvature monotone.
class CurvatureShape {
 public:
  /// sign * curvature >= margin
  void keepSide(Index point, double sign, double margin_per_mm) {
    add({{point, sign}}, margin_per_mm);
  }
  /// sign * (curvature at next - curvature at point) >= margin
  void keepSlope(Index point, Index next, double sign, double margin_per_mm) {
    add({{next, sign}, {point, -sign}}, margin_per_mm);
  }
  Eigen::SparseMatrix<double> rows(Index points) const {
    Eigen::SparseMatrix<double> result(std::ssize(margins_per_mm_), points);
    result.setFromTriplets(entries_.begin(), entries_.end());
    return result;
  }
  Eigen::VectorXd margins_per_mm() const {
    return Eigen::VectorXd::Map(margins_per_mm_.data(), std::ssize(margins_per_mm_));
  }
  /// What is missing, summed up.
  double miss(const Eigen::VectorXd& curvatures_per_mm) const {
    const Eigen::VectorXd slack =
        rows(curvatures_per_mm.size()) * curvatures_per_mm - margins_per_mm();
    return (-slack.array()).max(0).sum();
  }

 private:
  void add(std::initializer_list<std::pair<Index, double>> terms, double margin_per_mm) {
    for (const auto& [point, factor] : terms)
      entries_.emplace_back(std::ssize(margins_per_mm_), point, factor);
    margins_per_mm_.push_back(margin_per_mm);
  }

  Triplets entries_;
  std::vector<double> margins_per_mm_;
};

struct FairingSearch {
  FairingState state;
  int steps = 0;
  bool feasible = false;  ///< the last program had a solution
};

class RunFairing {
 public:
  explicit RunFairing(const FairingRun& run) : run_(run) {
    const Index n = run.count();
    tolerances_mm_ = run.tolerances_mm;
    if (!run.closed) tolerances_mm_(0) = tolerances_mm_(n - 1) = 0;
    normals_.resize(n, 2);
    for (Index i = 0; i < n; ++i) {
      const Index before = run.closed ? (i + n - 1) % n : std::max<Index>(i - 1, 0);
      const Index after = run.closed ? (i + 1) % n : std::min(i + 1, n - 1);
      const Eigen::RowVector2d chord =
          (run.points.row(after) - run.points.row(before)).normalized();
      normals_.row(i) << -chord.y(), chord.x();
    }
  }

  std::optional<FairingState> stateAt(const Eigen::VectorXd& shares) const {
    PlanarPoints points = run_.points;
    for (Index i = 0; i < run_.count(); ++i)
      if (tolerances_mm_(i) > 0 && shares(i) != 0)
        points.row(i) =
            withinDistance(points.row(i) + shares(i) * tolerances_mm_(i) * normals_.row(i),
                           run_.points.row(i), tolerances_mm_(i));
    std::optional<Chain> chain = triedChain(points, run_.closed);
    if (!chain) return std::nullopt;
    return FairingState{.shares = shares, .points = std::move(points), .chain = std::move(*chain)};
  }
  std::optional<FairingState> stateAt(const PlanarPoints& points) const {
    Eigen::VectorXd shares = Eigen::VectorXd::Zero(run_.count());
    for (Index i = 0; i < run_.count(); ++i)
      if (tolerances_mm_(i) > 0)
        shares(i) = std::clamp(
            (points.row(i) - run_.points.row(i)).dot(normals_.row(i)) / tolerances_mm_(i), -1.0,
            1.0);
    return stateAt(shares);
  }

  /// Sequential quadratic programming.
  /// \param steps_before of other searches, for the progress.
  FairingSearch improved(FairingState now, const CurvatureShape& shape, int steps_before) const {
    constexpr int most_steps = 15;
    // Moves by this share of the tolerance, and this relative gain, are negligible.
    constexpr double still = 1e-3, gain = 1e-4;
    FairingSearch search{.state = std::move(now)};
    double penalty = 0;
    while (search.steps < most_steps) {
      checkProgress(run_.progress, shareAfter(steps_before + search.steps));
      ++search.steps;
      const Chain& chain = search.state.chain;
      const FairingUnits units = unitsOf(chain);
      const CurvatureSolution found =
          solve(programAt(search.state, units, shape),
                curvaturesAt(chain, run_.closed) / units.curvature_per_mm, search.state.shares);
      search.feasible = found.converged;
      if (!found.converged || !found.moves.allFinite()) break;
      const Eigen::VectorXd change = found.moves.cwiseMax(-1).cwiseMin(1) - search.state.shares;
      // A miss of one unit of curvature outweighs all variation.
      penalty = std::max(penalty, 10 * units.variation_per_mm3 / units.curvature_per_mm);
      const double before = meritOf(chain, shape, penalty);
      if (!takeStep(search.state, change, shape, penalty)) break;
      if (change.cwiseAbs().maxCoeff() < still ||
          meritOf(search.state.chain, shape, penalty) > (1 - gain) * before)
        break;
    }
    return search;
  }

 private:
  double meritOf(const Chain& chain, const CurvatureShape& shape, double penalty) const {
    return variationOf(chain) + penalty * shape.miss(curvaturesAt(chain, run_.closed));
  }

  bool takeStep(FairingState& now, const Eigen::VectorXd& change, const CurvatureShape& shape,
                double penalty) const {
    const double merit = meritOf(now.chain, shape, penalty);
    for (double part = 1; part > 0x1p-8; part /= 2) {
      std::optional<FairingState> tried = stateAt(Eigen::VectorXd(now.shares + part * change));
      if (!tried || !(meritOf(tried->chain, shape, penalty) < merit)) continue;
      now = std::move(*tried);
      return true;
    }
    return false;
  }

  FairingUnits unitsOf(const Chain& chain) const {
    double length_mm = 0;
    for (const Clothoid& piece : chain) length_mm += piece.length_mm;
    const double largest = curvaturesAt(chain, run_.closed).cwiseAbs().maxCoeff();
    FairingUnits units{.curvature_per_mm = std::max(largest, 1e-9 / length_mm)};
    units.variation_per_mm3 =
        std::max(variationOf(chain), 1e-9 * std::pow(units.curvature_per_mm, 2) / length_mm);
    return units;
  }

  /// The directions at the ends of a segment by curvatures and moves, to first order:
  ///   change = by_curvatures * (changes of the curvatures) + by_moves * (shares of both ends).
  struct SegmentSlopes {
    Eigen::Matrix2d by_curvatures, by_moves;
  };

  SegmentSlopes slopesOf(const FairingState& now, Index s) const {
    const Clothoid& piece = now.chain[static_cast<std::size_t>(s)];
    const Index next = run_.next(s);
    const ChordAngles angles =
        chordAngles({.start = now.points.row(s).transpose(),
                     .start_direction_rad = piece.direction_rad,
                     .end = now.points.row(next).transpose(),
                     .end_direction_rad = piece.directionAt_rad(piece.length_mm)});
    const EndCurvatures ends = endCurvatures(piece, angles);
    const Eigen::Vector2d along = unitVector(angles.chord_direction_rad);
    const Eigen::Vector2d across(-along.y(), along.x());
    SegmentSlopes result;
    result.by_curvatures = ends.slope.inverse();
    // A turn of the chord turns the directions with it; a longer chord has smaller curvatures.
    const Eigen::Vector2d of_length = result.by_curvatures * ends.value_per_mm / angles.chord_mm;
    const Eigen::Vector2d of_turn = Eigen::Vector2d::Constant(1 / angles.chord_mm);
    for (int end = 0; end < 2; ++end) {
      const Index point = end == 0 ? s : next;
      const Eigen::Vector2d move =
          (end == 0 ? -1 : 1) * tolerances_mm_(point) * normals_.row(point).transpose();
      result.by_moves.col(end) = of_length * along.dot(move) + of_turn * across.dot(move);
    }
    return result;
  }

  /// At each point between segments the directions of both agree; at an open end the curvature is
  /// that of the neighbour.
  CurvatureProgram programAt(const FairingState& now, const FairingUnits& units,
                             const CurvatureShape& shape) const {
    const Index n = run_.count();
    Triplets curvatures, moves, energy;
    const auto add = [&](Index row, Index s, const SegmentSlopes& slopes, int end, double sign) {
      const double scale = units.curvature_per_mm;
      const Index next = run_.next(s);
      curvatures.emplace_back(row, s, sign * scale * slopes.by_curvatures(end, 0));
      curvatures.emplace_back(row, next, sign * scale * slopes.by_curvatures(end, 1));
      moves.emplace_back(row, s, -sign * slopes.by_moves(end, 0));
      moves.emplace_back(row, next, -sign * slopes.by_moves(end, 1));
    };
    for (Index s = 0; s < run_.segments(); ++s) {
      const SegmentSlopes slopes = slopesOf(now, s);
      const Index next = run_.next(s);
      if (run_.closed || s > 0) add(s, s, slopes, 0, -1);
      if (run_.closed || next < n - 1) add(next, s, slopes, 1, 1);
      const double weight = std::pow(units.curvature_per_mm, 2) / units.variation_per_mm3 /
                            now.chain[static_cast<std::size_t>(s)].length_mm;
      for (const auto& [i, j, sign] :
           {std::tuple{s, s, 1.0}, {next, next, 1.0}, {s, next, -1.0}, {next, s, -1.0}})
        energy.emplace_back(i, j, sign * weight);
    }
    if (!run_.closed)
      for (const auto& [row, column, sign] : {std::tuple{Index{0}, Index{0}, 1.0},
                                              {Index{0}, Index{1}, -1.0},
                                              {n - 1, n - 1, 1.0},
                                              {n - 1, n - 2, -1.0}})
        curvatures.emplace_back(row, column, sign);
    CurvatureProgram program = scaledProgram(now, units, curvatures, moves, energy);
    program.shape = shape.rows(n);
    program.margins = shape.margins_per_mm() / units.curvature_per_mm;
    return program;
  }

  CurvatureProgram scaledProgram(const FairingState& now, const FairingUnits& units,
                                 const Triplets& curvatures, const Triplets& moves,
                                 const Triplets& energy) const {
    const Index n = run_.count();
    CurvatureProgram program;
    program.energy.resize(n, n);
    program.curvatures.resize(n, n);
    program.moves.resize(n, n);
    program.energy.setFromTriplets(energy.begin(), energy.end());
    program.curvatures.setFromTriplets(curvatures.begin(), curvatures.end());
    program.moves.setFromTriplets(moves.begin(), moves.end());
    // Rows of size 1.
    Eigen::VectorXd scale(n);
    for (Index i = 0; i < n; ++i) scale(i) = 1 / std::abs(program.curvatures.coeff(i, i));
    program.curvatures = scale.asDiagonal() * program.curvatures;
    program.moves = scale.asDiagonal() * program.moves;
    program.right =
        program.curvatures * (curvaturesAt(now.chain, run_.closed) / units.curvature_per_mm) -
        program.moves * now.shares;
    return program;
  }

  const FairingRun& run_;
  PlanarPoints normals_;
  Eigen::VectorXd tolerances_mm_;
};

FairedRun unmovedRun(const FairingRun& run) {
  FairedRun result;
  result.points = run.points;
  result.pieces = chainThrough(run.points, run.closed);
  result.after = figuresOf(result.pieces, run.closed);
  result.before = result.after;
  return result;
}

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
void keepMonotone(CurvatureShape& shape, const FairingRun& run, const Chain& chain,
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
    const Chain chain = best.chain;
    const Eigen::VectorXd values = curvaturesAt(chain, run_.closed);
    const double range = values.maxCoeff() - values.minCoeff();
    std::size_t tried = 0;
    for (const double share : {0.3, 0.1, 0.03, 0.01, 0.003}) {
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

/// The least variation, then fewer turns at up to twice that variation.
void fairState(const FairingRun& run, const RunFairing& fairing, const PlanarPoints& faired,
               FairedRun& result, FairingState& best) {
  constexpr double most_times = 2;
  CurvatureShape sides = sidesOf(faired, run.closed);
  FairingSearch search = fairing.improved(best, sides, 0);
  result.steps = search.steps;
  best = std::move(search.state);
  double most = most_times * variationOf(best.chain);
  if (result.before) most = std::min(most, result.before->variation_per_mm3);
  const TurnReduction reduction(run, fairing, most);
  if (figuresOf(best.chain, run.closed).inflections > 0) {
    const CurvatureShape one_side = oneSideOf(faired, run.closed);
    if (reduction.tryShape(one_side, best, result.steps)) sides = one_side;
  }
  reduction.flatten(sides, best, result.steps);
}

FairedRun fairRun(const FairingRun& run) {
  if (run.count() < 3) return unmovedRun(run);
  const FairedPoints faired =
      fairPoints(run.points, run.tolerances_mm, {.closed = run.closed}, partOf(run.progress, 0, 0));
  FairedRun result;
  result.point_inflections = static_cast<int>(faired.after.inflections.size());
  const RunFairing fairing(run);
  std::optional<FairingState> given = fairing.stateAt(run.points);
  std::optional<FairingState> best = fairing.stateAt(faired.points);
  if (given) result.before = figuresOf(given->chain, run.closed);
  if (!best) best = given;
  if (!best) chainThrough(faired.points, run.closed);  // throws
  if (faired.moved_mm > 0 || !given) fairState(run, fairing, faired.points, result, *best);
  result.after = figuresOf(best->chain, run.closed);
  if (result.before && (result.after.inflections > result.before->inflections ||
                        result.after.variation_per_mm3 >= result.before->variation_per_mm3)) {
    best = std::move(given);
    result.after = *result.before;
  }
  result.points = best->points;
  result.pieces = std::move(best->chain);
  return result;
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
      run.tolerances_mm(i) = tolerances_mm(indices[static_cast<std::size_t>(i)]);
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
