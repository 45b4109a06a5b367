// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <stdexcept>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/conic.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// A segment on its way through the conversion.
struct ChainPiece {
  PlanarConic conic;
  std::size_t origin = 0;  ///< index of the segment it comes from
  bool whole = true;       ///< not divided
};

/// Neighbours that turn to the same side.
struct ConvexRun {
  std::deque<ChainPiece> pieces;
  double start_curvature_per_mm = 0;
};

/// The sign of the turn; 0 if rounding hides it.
int turnSign(const PlanarConic& conic) {
  const Vector2d in = conic.corner - conic.start, out = conic.end - conic.corner;
  const double turn = cross(in, out);
  // Each coordinate of an edge has the rounding of one difference of coordinates of this size.
  const double size =
      std::max({conic.start.cwiseAbs().maxCoeff(), conic.corner.cwiseAbs().maxCoeff(),
                conic.end.cwiseAbs().maxCoeff()});
  const double noise = 4 * machine_epsilon * size * (in.norm() + out.norm());
  if (std::abs(turn) <= noise) return 0;
  return turn > 0 ? 1 : -1;
}

void requireSegment(const PlanarConic& conic, std::size_t i) {
  if (!conic.start.allFinite() || !conic.corner.allFinite() || !conic.end.allFinite())
    refuse(fmt::format("segment {} of the chain has a point that is not finite", i));
  if (!(conic.weight > 0 && std::isfinite(conic.weight)))
    refuse(fmt::format("the weight of segment {} is {}, not positive and finite", i, conic.weight));
  if (conic.corner == conic.start || conic.corner == conic.end)
    refuse(fmt::format("the corner of segment {} is one of its ends, ({}, {}): no tangent there", i,
                       conic.corner.x(), conic.corner.y()));
}

void requireJoint(const PlanarConic& left, const PlanarConic& right, std::size_t joint,
                  const G2ConicOptions& options) {
  const double gap_mm = (left.end - right.start).norm();
  if (!(gap_mm <= options.gap_mm))
    refuse(fmt::format("the segments at joint {} are {} mm apart, more than {} mm", joint, gap_mm,
                       options.gap_mm));
  const double angle_rad = std::abs(PlanarConic{
      .start = left.corner, .corner = left.end, .end = right.corner + (left.end - right.start)}
                                        .turn_rad());
  if (!(angle_rad <= options.angle_rad))
    refuse(
        fmt::format("the tangents at joint {} differ by {} rad, more than {} rad: the chain is"
                    " not G1",
                    joint, angle_rad, options.angle_rad));
}

void requireChain(const std::vector<PlanarConic>& chain, const G2ConicOptions& options) {
  if (chain.empty()) refuse("a chain of conics is empty");
  for (std::size_t i = 0; i < chain.size(); ++i) requireSegment(chain[i], i);
  for (std::size_t i = 1; i < chain.size(); ++i) requireJoint(chain[i - 1], chain[i], i, options);
  if (options.closed) requireJoint(chain.back(), chain.front(), 0, options);
  if (!options.start_curvature_per_mm) return;
  const double curvature = *options.start_curvature_per_mm;
  if (options.closed) refuse("a closed chain takes no start curvature");
  if (!(curvature * turnSign(chain.front()) > 0 && std::isfinite(curvature)))
    refuse(
        fmt::format("the start curvature {} /mm does not have the sign of the first segment's turn,"
                    " {} rad",
                    curvature, chain.front().turn_rad()));
}

/// The segments with ends that are bitwise the starts of the next ones.
std::deque<ChainPiece> piecesOf(const std::vector<PlanarConic>& chain, bool closed) {
  std::deque<ChainPiece> pieces;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    pieces.push_back({.conic = chain[i], .origin = i});
    if (i > 0) pieces[i - 1].conic.end = chain[i].start;
  }
  if (closed) pieces.back().conic.end = chain.front().start;
  return pieces;
}

bool sameTurn(const ChainPiece& left, const ChainPiece& right) {
  return turnSign(left.conic) * turnSign(right.conic) > 0;
}

/// The chain divided at the joints that stay G1. A closed chain with such a joint is rotated to
/// begin there.
std::vector<ConvexRun> convexRuns(std::deque<ChainPiece> pieces, const G2ConicOptions& options) {
  const double seam_curvature_per_mm = pieces.back().conic.endCurvature_per_mm();
  bool seamless = options.closed && sameTurn(pieces.back(), pieces.front());
  for (std::size_t i = 1; seamless && i < pieces.size(); ++i) {
    if (sameTurn(pieces[i - 1], pieces[i])) continue;
    std::rotate(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(i), pieces.end());
    seamless = false;
  }
  std::vector<ConvexRun> runs;
  for (const ChainPiece& piece : pieces) {
    const bool begins = runs.empty() || !sameTurn(runs.back().pieces.back(), piece);
    if (begins)
      runs.push_back({.pieces = {}, .start_curvature_per_mm = piece.conic.startCurvature_per_mm()});
    runs.back().pieces.push_back(piece);
  }
  if (seamless) runs.front().start_curvature_per_mm = seam_curvature_per_mm;
  if (options.start_curvature_per_mm)
    runs.front().start_curvature_per_mm = *options.start_curvature_per_mm;
  return runs;
}

/// Rotates the tangent at the joint of two pieces and adapts the weights, so that the curvatures
/// agree there. The first piece gets the curvature given at its start.
void joinG2(PlanarConic& left, PlanarConic& right, double start_curvature_per_mm) {
  const double alpha = std::abs(left.turn_rad()), beta = std::abs(right.turn_rad());
  const Vector2d joint = left.end;
  const double left_in = (left.corner - left.start).norm(), left_out = (joint - left.corner).norm();
  const double right_in = (right.corner - joint).norm();
  const double right_out = (right.end - right.corner).norm();
  const double left_ratio = left_out / left_in, right_ratio = right_in / right_out;
  // What the weights of the new pieces have to make good.
  const double start_change = left.startCurvature_per_mm() / start_curvature_per_mm;
  const double jump = right.startCurvature_per_mm() / left.endCurvature_per_mm();
  const double balance = std::sin(alpha) / std::sin(beta) * std::cbrt(jump * start_change);
  const double theta =
      std::atan2(balance * std::sin(beta) - std::sin(alpha),
                 std::cos(alpha) + balance * std::cos(beta) + left_ratio + right_ratio * balance);
  const double left_scale = 1 + left_ratio * std::sin(theta) / std::sin(theta + alpha);
  const double right_scale = 1 - right_ratio * std::sin(theta) / std::sin(beta - theta);
  left.corner = left.start + left_scale * (left.corner - left.start);
  right.corner = right.end + right_scale * (right.corner - right.end);
  left.weight *= std::sqrt(start_change) / left_scale;
  right.weight /= right_scale;
}

/// Replaces a piece by its halves.
void divide(std::deque<ChainPiece>& pieces, std::size_t i) {
  const std::array<PlanarConic, 2> parts = halves(pieces[i].conic);
  const std::size_t origin = pieces[i].origin;
  pieces[i] = {.conic = parts[0], .origin = origin, .whole = false};
  pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                {.conic = parts[1], .origin = origin, .whole = false});
}

/// Makes all joints of the run G2. Returns the number of divisions.
int makeG2(ConvexRun& run) {
  // A bound against an endless loop: each division reduces the larger of two turns below pi, so a
  // joint needs few.
  constexpr int most_divisions = 1000;
  std::deque<ChainPiece>& pieces = run.pieces;
  int divisions = 0;
  const double given = pieces.front().conic.startCurvature_per_mm();
  if (pieces.size() == 1 && run.start_curvature_per_mm != given) {
    divide(pieces, 0);
    ++divisions;
  }
  double curvature = run.start_curvature_per_mm;
  for (std::size_t i = 0; i + 1 < pieces.size();) {
    PlanarConic &left = pieces[i].conic, &right = pieces[i + 1].conic;
    const double alpha = std::abs(left.turn_rad()), beta = std::abs(right.turn_rad());
    if (alpha + beta < std::numbers::pi) {
      joinG2(left, right, curvature);
      curvature = left.endCurvature_per_mm();
      ++i;
      continue;
    }
    if (++divisions > most_divisions) {
      throw std::domain_error(fmt::format(
          "the segments at ({}, {}) turn by {} rad together, not below pi after {} divisions",
          left.end.x(), left.end.y(), alpha + beta, most_divisions));
    }
    divide(pieces, alpha >= beta ? i : i + 1);
  }
  return divisions;
}

}  // namespace

G2Conics g2Conics(const std::vector<PlanarConic>& chain, const G2ConicOptions& options) {
  requireChain(chain, options);
  std::vector<ConvexRun> runs = convexRuns(piecesOf(chain, options.closed), options);
  G2Conics result;
  std::deque<ChainPiece> pieces;
  std::vector<bool> starts_run;
  for (ConvexRun& run : runs) {
    result.divisions += makeG2(run);
    for (const ChainPiece& piece : run.pieces) {
      starts_run.push_back(&piece == &run.pieces.front());
      pieces.push_back(piece);
    }
  }
  // A closed run without a G1 joint starts at joint 0, which is G2.
  if (runs.size() == 1)
    starts_run.front() = options.closed && !sameTurn(pieces.back(), pieces.front());

  const auto first = std::ranges::find(pieces, std::size_t{0}, &ChainPiece::origin);
  const auto shift = first - pieces.begin();
  std::rotate(pieces.begin(), first, pieces.end());
  std::rotate(starts_run.begin(), starts_run.begin() + shift, starts_run.end());
  if (!options.closed) starts_run.front() = false;

  result.least_weight = result.largest_weight = pieces.front().conic.weight;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const ChainPiece& piece = pieces[i];
    result.conics.push_back(piece.conic);
    if (starts_run[i]) result.g1_joints.push_back(static_cast<int>(i));
    result.least_weight = std::min(result.least_weight, piece.conic.weight);
    result.largest_weight = std::max(result.largest_weight, piece.conic.weight);
    if (piece.whole)
      result.largest_move_mm = std::max(result.largest_move_mm,
                                        (piece.conic.corner - chain[piece.origin].corner).norm());
  }
  return result;
}

}  // namespace seamwright
