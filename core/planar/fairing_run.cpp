// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/clothoid_curvatures.hpp>
#include <seamwright/core/planar/clothoid_spline.hpp>
#include <seamwright/core/planar/curvature_program.hpp>
#include <seamwright/core/planar/fairing_run.hpp>
#include <seamwright/core/planar/point_move.hpp>

namespace seamwright {

namespace {

using Eigen::Index;
using Triplets = std::vector<Eigen::Triplet<double>>;
using Chain = std::vector<Clothoid>;

std::optional<Chain> triedChain(const PlanarPoints& points, bool closed) {
  try {
    return chainThrough(points, closed);
  } catch (const std::domain_error&) {  // the points are too few for their turns
    return std::nullopt;
  } catch (const std::invalid_argument&) {  // moves made neighbours equal
    return std::nullopt;
  }
}

/// Units that make curvatures and energies about 1.
struct FairingUnits {
  double curvature_per_mm = 1, variation_per_mm3 = 1;
};

/// The program for the curvatures and moves of a run, linearised at a state.
class RunProgram {
 public:
  RunProgram(const FairingRun& run, const PlanarPoints& normals) : run_(run), normals_(normals) {}

  FairingUnits unitsOf(const Chain& chain) const {
    double length_mm = 0;
    for (const Clothoid& piece : chain) length_mm += piece.length_mm;
    const double largest = curvaturesAt(chain, run_.closed).cwiseAbs().maxCoeff();
    FairingUnits units{.curvature_per_mm = std::max(largest, 1e-9 / length_mm)};
    units.variation_per_mm3 =
        std::max(variationOf(chain), 1e-9 * std::pow(units.curvature_per_mm, 2) / length_mm);
    return units;
  }

  /// At each point between segments the directions of both agree; at an open end the curvature is
  /// that of the neighbour.
  CurvatureProgram at(const FairingState& now, const FairingUnits& units,
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

 private:
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
          (end == 0 ? -1 : 1) * run_.tolerances_mm(point) * normals_.row(point).transpose();
      result.by_moves.col(end) = of_length * along.dot(move) + of_turn * across.dot(move);
    }
    return result;
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
  const PlanarPoints& normals_;
};

}  // namespace

Chain chainThrough(const PlanarPoints& points, bool closed) {
  ClothoidSplineOptions options{.closed = closed, .start = {}, .end = {}};
  if (!closed && points.rows() > 2) options.start.arc = options.end.arc = true;
  return clothoidSpline(points, options).pieces;
}

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

RunFairing::RunFairing(const FairingRun& run, const PlanarPoints& fair_points) : run_(run) {
  const Index n = run.count();
  MoveNormals normals = moveNormals(run.points, run.tolerances_mm, run.closed);
  if (normals.crowded) normals = moveNormals(fair_points, Eigen::VectorXd::Zero(n), run.closed);
  normals_ = std::move(normals.vectors);
}

std::optional<FairingState> RunFairing::stateOf(const Eigen::VectorXd& shares) const {
  PlanarPoints points = run_.points;
  for (Index i = 0; i < run_.count(); ++i)
    if (run_.tolerances_mm(i) > 0 && shares(i) != 0)
      points.row(i) =
          withinDistance(points.row(i) + shares(i) * run_.tolerances_mm(i) * normals_.row(i),
                         run_.points.row(i), run_.tolerances_mm(i));
  std::optional<Chain> chain = triedChain(points, run_.closed);
  if (!chain) return std::nullopt;
  return FairingState{.shares = shares, .points = std::move(points), .chain = std::move(*chain)};
}

std::optional<FairingState> RunFairing::stateAt(const PlanarPoints& points) const {
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(run_.count());
  for (Index i = 0; i < run_.count(); ++i)
    if (run_.tolerances_mm(i) > 0)
      shares(i) = std::clamp(
          (points.row(i) - run_.points.row(i)).dot(normals_.row(i)) / run_.tolerances_mm(i), -1.0,
          1.0);
  return stateOf(shares);
}

FairingSearch RunFairing::improved(FairingState now, const CurvatureShape& shape,
                                   int steps_before) const {
  constexpr int most_steps = 15;
  // Moves by this share of the tolerance, and this relative gain, are negligible.
  constexpr double still = 1e-3, gain = 1e-4;
  FairingSearch search{.state = std::move(now)};
  const RunProgram program(run_, normals_);
  double penalty = 0;
  while (search.steps < most_steps) {
    checkProgress(run_.progress, shareAfter(steps_before + search.steps));
    ++search.steps;
    const Chain& chain = search.state.chain;
    const FairingUnits units = program.unitsOf(chain);
    const CurvatureSolution found =
        solve(program.at(search.state, units, shape),
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

double RunFairing::meritOf(const Chain& chain, const CurvatureShape& shape, double penalty) const {
  return variationOf(chain) + penalty * shape.miss(curvaturesAt(chain, run_.closed));
}

bool RunFairing::takeStep(FairingState& now, const Eigen::VectorXd& change,
                          const CurvatureShape& shape, double penalty) const {
  const double merit = meritOf(now.chain, shape, penalty);
  for (double part = 1; part > 0x1p-8; part /= 2) {
    std::optional<FairingState> tried = stateOf(Eigen::VectorXd(now.shares + part * change));
    if (!tried || !(meritOf(tried->chain, shape, penalty) < merit)) continue;
    now = std::move(*tried);
    return true;
  }
  return false;
}

}  // namespace seamwright
