// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc_clothoids.hpp>
#include <seamwright/core/planar/clothoid_transition.hpp>
#include <seamwright/core/planar/planar_curve.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;
using std::numbers::pi;

/// A chain of arcs without joints between arcs of one circle. Joint j is the start of arc j.
struct JumpChain {
  std::vector<PlanarArc> arcs;
  bool closed = false;
  double distance_mm = 0;  ///< upper bound of the distance from the chain with all joints

  std::size_t count() const { return arcs.size(); }
  bool hasJoint(std::size_t j) const { return count() > 1 && (j > 0 || closed); }
  std::size_t before(std::size_t j) const { return (j + count() - 1) % count(); }
  std::size_t after(std::size_t i) const { return (i + 1) % count(); }
  bool isFixedStart(std::size_t i) const { return !closed && i == 0; }
  bool isFixedEnd(std::size_t i) const { return !closed && i + 1 == count(); }
  bool isLine(std::size_t i) const { return arcs[i].curvature_per_mm == 0; }
  /// Lines stay, so that only joints between arcs can move.
  bool isFree(std::size_t j) const { return hasJoint(j) && !isLine(j) && !isLine(before(j)); }
  double jump_per_mm(std::size_t j) const {
    return arcs[j].curvature_per_mm - arcs[before(j)].curvature_per_mm;
  }
};

/// Upper bound of the distance of an arc from the other one continued beyond its end, if the
/// curvatures agree.
double apart_mm(const PlanarArc& arc, const PlanarArc& next) {
  const double turn_rad = std::abs(wrapped(next.direction_rad - arc.endDirection_rad())),
               change_per_mm = std::abs(next.curvature_per_mm - arc.curvature_per_mm);
  return (next.start - arc.end()).norm() +
         next.length_mm * (turn_rad + next.length_mm * change_per_mm / 2);
}

JumpChain jumpChain(const std::vector<PlanarArc>& arcs, bool closed) {
  JumpChain chain{.arcs = {}, .closed = closed};
  double largest_per_mm = 0, length_mm = 0;
  for (const PlanarArc& arc : arcs) {
    largest_per_mm = std::max(largest_per_mm, std::abs(arc.curvature_per_mm));
    length_mm += arc.length_mm;
  }
  // What does not count as an extremum either, see ClothoidFigures; and rounding of the chain, so
  // that its last arc keeps its end.
  constexpr double negligible = 1e-9, rounding = 1e-11;
  const double least_per_mm = negligible * std::max(largest_per_mm, 1 / length_mm);
  const auto continues = [&](const PlanarArc& arc, const PlanarArc& next) {
    if (std::abs(arc.curvature_per_mm - next.curvature_per_mm) > least_per_mm) return false;
    chain.distance_mm += apart_mm(arc, next);
    if (!(chain.distance_mm <= rounding * length_mm))
      throw std::domain_error(fmt::format(
          "there is no transition between arcs that both have the curvature {} per mm, at ({}, {})",
          arc.curvature_per_mm, next.start.x(), next.start.y()));
    return true;
  };
  for (const PlanarArc& arc : arcs)
    if (chain.arcs.empty() || !continues(chain.arcs.back(), arc))
      chain.arcs.push_back(arc);
    else
      chain.arcs.back().length_mm += arc.length_mm;
  if (closed && chain.count() > 1 && continues(chain.arcs.back(), chain.arcs.front())) {
    const double first_mm = chain.arcs.front().length_mm;
    chain.arcs.front() = chain.arcs.back();
    chain.arcs.front().length_mm += first_mm;
    chain.arcs.pop_back();
  }
  return chain;
}

/// By how much the ends of an arc move to its left.
struct EndMoves {
  double start_mm = 0, end_mm = 0;
};

/// Turned around its middle, and made a parallel arc. The ends move to first order.
PlanarArc movedArc(const PlanarArc& arc, const EndMoves& moves) {
  PlanarArc result = offset(arc, (moves.start_mm + moves.end_mm) / 2);
  const double difference_mm = moves.end_mm - moves.start_mm;
  if (difference_mm == 0) return result;
  const double turn_rad = difference_mm / (arc.length_mm * sinc(arc.sweep_rad() / 2));
  const Vector2d middle = result.point(result.length_mm / 2), way = result.start - middle;
  result.start =
      middle + std::cos(turn_rad) * way + std::sin(turn_rad) * Vector2d(-way.y(), way.x());
  result.direction_rad += turn_rad;
  return result;
}

/// The arc with its start and the direction there, and a curvature that moves its end to the left
/// to first order.
PlanarArc bentArc(const PlanarArc& arc, double end_mm) {
  const double height = arc.length_mm * sinc(arc.sweep_rad() / 2);
  PlanarArc result = arc;
  result.curvature_per_mm += 2 * end_mm / (height * height);
  return result;
}

/// A gap of the circles at a joint, for a transition of this length.
struct Gap {
  double length_mm = 0;
  double gap_mm = 0;  ///< above 0
};

/// The longest transitions that the arcs beside a joint have room for, within the tolerance.
std::vector<Gap> largestGaps(const JumpChain& chain, double tolerance_mm) {
  // Both transitions of an arc leave a tenth of it. A turn of 1 rad keeps the shift below a sixth
  // of the radius.
  constexpr double share = 0.9, largest_turn_rad = 1;
  std::vector<Gap> gaps(chain.count());
  for (std::size_t j = 0; j < chain.count(); ++j) {
    if (!chain.hasJoint(j)) continue;
    const PlanarArc &from = chain.arcs[chain.before(j)], &to = chain.arcs[j];
    const double turn_per_mm =
        (std::abs(from.curvature_per_mm) + std::abs(to.curvature_per_mm)) / 2;
    const double room_mm =
        std::min(share * std::min(from.length_mm, to.length_mm), largest_turn_rad / turn_per_mm);
    const double factor = std::abs(chain.jump_per_mm(j)) / 24;
    gaps[j].gap_mm = std::min(factor * room_mm * room_mm, (chain.isFree(j) ? 2 : 1) * tolerance_mm);
    gaps[j].length_mm = std::sqrt(gaps[j].gap_mm / factor);
  }
  return gaps;
}

/// How the ends of the arcs move for these gaps: by half of them, but lines stay.
std::vector<EndMoves> halfGaps(const JumpChain& chain, const std::vector<Gap>& gaps) {
  std::vector<EndMoves> moves(chain.count());
  for (std::size_t j = 0; j < chain.count(); ++j) {
    if (!chain.hasJoint(j)) continue;
    const std::size_t i = chain.before(j);
    const bool stays = chain.isLine(i), next_stays = chain.isLine(j);
    const double gap_mm = std::copysign(gaps[j].gap_mm, chain.jump_per_mm(j));
    moves[i].end_mm = stays ? 0 : next_stays ? -gap_mm : -gap_mm / 2;
    moves[j].start_mm = next_stays ? 0 : stays ? gap_mm : gap_mm / 2;
  }
  return moves;
}

/// By what an arc turns at one of its ends, by the moves of both.
EndMoves turnsBy(const JumpChain& chain, std::size_t i, bool at_end) {
  const PlanarArc& arc = chain.arcs[i];
  const double reach_mm = arc.length_mm * sinc(arc.sweep_rad() / 2);
  if (chain.isLine(i)) return {};
  if (chain.isFixedStart(i)) return {.start_mm = 0, .end_mm = at_end ? 2 / reach_mm : 0};
  if (chain.isFixedEnd(i)) return {.start_mm = at_end ? 0 : -2 / reach_mm, .end_mm = 0};
  return {.start_mm = -1 / reach_mm, .end_mm = 1 / reach_mm};
}

/// Moves of both arcs at joints that let neighbours turn alike, as far as the jump between them is
/// small: circles of nearly one curvature that cross have no transition. Circles that turn by t
/// against each other come closer by t^2 / (2 jump). So the squares of t / (jump * length), and of
/// the moves against the tolerance, are least.
Eigen::VectorXd jointMoves(const JumpChain& chain, const std::vector<Gap>& gaps,
                           const std::vector<EndMoves>& moves, double tolerance_mm) {
  const auto count = static_cast<Eigen::Index>(chain.count());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * count);
  for (std::size_t j = 0; j < chain.count(); ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    entries.emplace_back(count + row, row, 1 / tolerance_mm);
    if (!chain.hasJoint(j)) continue;
    const double weight = 1 / (std::abs(chain.jump_per_mm(j)) * gaps[j].length_mm);
    const auto add = [&](std::size_t i, const EndMoves& turns, double sign) {
      right(row) -=
          sign * weight * (turns.start_mm * moves[i].start_mm + turns.end_mm * moves[i].end_mm);
      const std::size_t next = chain.after(i);
      if (chain.isFree(i))
        entries.emplace_back(row, static_cast<Eigen::Index>(i), sign * weight * turns.start_mm);
      if (chain.isFree(next))
        entries.emplace_back(row, static_cast<Eigen::Index>(next), sign * weight * turns.end_mm);
    };
    add(j, turnsBy(chain, j, false), 1);
    add(chain.before(j), turnsBy(chain, chain.before(j), true), -1);
  }
  Eigen::SparseMatrix<double> equations(2 * count, count);
  equations.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseMatrix<double> normal = equations.transpose() * equations;
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(normal).solve(equations.transpose() *
                                                                          right);
}

/// The arcs with these gaps at the joints.
std::vector<PlanarArc> movedArcs(const JumpChain& chain, const std::vector<Gap>& gaps,
                                 double tolerance_mm) {
  std::vector<EndMoves> moves = halfGaps(chain, gaps);
  const Eigen::VectorXd common_mm = jointMoves(chain, gaps, moves, tolerance_mm);
  std::vector<PlanarArc> arcs;
  for (std::size_t i = 0; i < chain.count(); ++i) {
    const std::size_t next = chain.after(i);
    if (chain.isFree(i)) moves[i].start_mm += common_mm(static_cast<Eigen::Index>(i));
    if (chain.isFree(next)) moves[i].end_mm += common_mm(static_cast<Eigen::Index>(next));
    const PlanarArc& arc = chain.arcs[i];
    if (chain.count() == 1 || chain.isLine(i))
      arcs.push_back(arc);
    else if (chain.isFixedStart(i))
      arcs.push_back(bentArc(arc, moves[i].end_mm));
    else if (chain.isFixedEnd(i))
      arcs.push_back(reversed(bentArc(reversed(arc), -moves[i].start_mm)));
    else
      arcs.push_back(movedArc(arc, moves[i]));
  }
  return arcs;
}

/// A part of a clothoid.
Clothoid subClothoid(const Clothoid& whole, double from_mm, double to_mm) {
  return {.start = whole.point(from_mm),
          .direction_rad = whole.directionAt_rad(from_mm),
          .curvature_per_mm = whole.curvatureAt_per_mm(from_mm),
          .curvature_slope_per_mm2 = whole.curvature_slope_per_mm2,
          .length_mm = to_mm - from_mm};
}

/// Where the clothoid crosses the normal of the chain at a joint.
std::optional<double> normalCrossing(const Clothoid& clothoid, const PlanarArc& after_joint) {
  const Vector2d tangent = unitVector(after_joint.direction_rad);
  const auto ahead_mm = [&](double s_mm) {
    return tangent.dot(clothoid.point(s_mm) - after_joint.start);
  };
  Interval inside = {0, clothoid.length_mm};
  if (ahead_mm(inside.lower) > 0 || ahead_mm(inside.upper) < 0) return std::nullopt;
  while (true) {
    const double middle_mm = inside.middle();
    if (!(inside.lower < middle_mm && middle_mm < inside.upper)) return middle_mm;
    (ahead_mm(middle_mm) < 0 ? inside.lower : inside.upper) = middle_mm;
  }
}

/// The transitions between moved arcs. Each arc has a part of its own between those at its ends.
struct Smoothed {
  std::vector<PlanarArc> kept;  ///< of the arcs; the length may be below 0
  /// Of the joint at the start of an arc, if there is one.
  std::vector<std::optional<Clothoid>> transitions;
};

/// \param failed takes the joints that have none.
Smoothed smoothed(const JumpChain& chain, const std::vector<PlanarArc>& arcs,
                  std::vector<std::size_t>& failed) {
  Smoothed result{.kept = arcs, .transitions = {}};
  result.transitions.resize(chain.count());
  std::vector<Interval> parts;
  for (const PlanarArc& arc : arcs) parts.push_back({0, arc.length_mm});
  for (std::size_t j = 0; j < chain.count(); ++j) {
    if (!chain.hasJoint(j)) continue;
    const std::size_t i = chain.before(j);
    try {
      const ClothoidTransition transition = clothoidTransition(arcs[i], arcs[j]);
      parts[i].upper = transition.leaves_mm;
      parts[j].lower = transition.arrives_mm;
      result.transitions[j] = transition.clothoid;
    } catch (const std::domain_error&) {
      failed.push_back(j);
    }
  }
  for (std::size_t i = 0; i < chain.count(); ++i) {
    PlanarArc& arc = result.kept[i];
    arc.start = arcs[i].point(parts[i].lower);
    arc.direction_rad = arcs[i].directionAt_rad(parts[i].lower);
    arc.length_mm = parts[i].width();
  }
  return result;
}

Clothoid asClothoid(const PlanarArc& arc) {
  return {.start = arc.start,
          .direction_rad = arc.direction_rad,
          .curvature_per_mm = arc.curvature_per_mm,
          .length_mm = arc.length_mm};
}

/// Upper bound of the distance of an arc from the clothoids between the normals at its ends.
std::optional<double> distanceBeside(const JumpChain& chain, const Smoothed& curve, std::size_t i,
                                     double tolerance_mm) {
  std::vector<Clothoid> beside;
  const std::optional<Clothoid>& into = curve.transitions[i];
  if (into) {
    const std::optional<double> cut_mm = normalCrossing(*into, chain.arcs[i]);
    if (!cut_mm) return std::nullopt;
    beside.push_back(subClothoid(*into, *cut_mm, into->length_mm));
  }
  if (curve.kept[i].length_mm > 0) beside.push_back(asClothoid(curve.kept[i]));
  const std::size_t next = chain.after(i);
  if (chain.hasJoint(next) && curve.transitions[next]) {
    const std::optional<double> cut_mm = normalCrossing(*curve.transitions[next], chain.arcs[next]);
    if (!cut_mm) return std::nullopt;
    beside.push_back(subClothoid(*curve.transitions[next], 0, *cut_mm));
  }
  // The quintic form and rounding cost little of the tolerance.
  constexpr double share = 1e-3;
  const SplineWithin quintics =
      bezierSpline(beside, share * tolerance_mm, false, share * tolerance_mm);
  const PlanarCurve spline = planarCurve(quintics.curve);
  const auto along = alongCircle(spline, {0, static_cast<double>(spline.count())}, chain.arcs[i],
                                 tolerance_mm - quintics.distance_mm);
  if (!along) return std::nullopt;
  const double missing_mm = std::abs(along->advance_mm - chain.arcs[i].length_mm);
  const double distance_mm = along->distance_mm + quintics.distance_mm + missing_mm;
  return distance_mm <= tolerance_mm ? std::optional(distance_mm) : std::nullopt;
}

/// Takes the pieces and the largest bound. Returns the joints of arcs that have none.
std::vector<std::size_t> bounded(const JumpChain& chain, const Smoothed& curve, double tolerance_mm,
                                 const Progress& progress, ArcClothoids& result) {
  std::vector<std::size_t> failed;
  for (std::size_t i = 0; i < chain.count(); ++i) {
    checkProgress(progress, 0);
    std::optional<double> distance_mm;
    if (curve.kept[i].length_mm >= 0) distance_mm = distanceBeside(chain, curve, i, tolerance_mm);
    if (!distance_mm) {
      failed.push_back(i);
      failed.push_back(chain.after(i));
      continue;
    }
    result.distance_mm = std::max(result.distance_mm, *distance_mm);
    if (curve.transitions[i]) result.pieces.push_back(*curve.transitions[i]);
    if (curve.kept[i].length_mm > 0) result.pieces.push_back(asClothoid(curve.kept[i]));
  }
  return failed;
}

}  // namespace

ArcClothoids clothoidsNear(const std::vector<PlanarArc>& arcs, bool closed, double tolerance_mm,
                           const Progress& progress) {
  if (arcs.empty()) refuse("the chain has no arcs");
  if (!(tolerance_mm > 0 && std::isfinite(tolerance_mm)))
    refuse(fmt::format("the tolerance is {} mm: it must be positive and finite", tolerance_mm));
  const JumpChain chain = jumpChain(arcs, closed);
  const double left_mm = tolerance_mm - chain.distance_mm;
  // Bounds exceed distances by up to 2 percent, see alongCircle().
  constexpr double used = 0.97;
  std::vector<Gap> gaps = largestGaps(chain, used * left_mm);
  // Choices: a round makes the transitions beside an arc that fails shorter by a tenth. After all
  // rounds they would be a thousandth as long.
  constexpr double shrink = 0.8;
  constexpr int most_rounds = 60;
  std::size_t worst = 0;
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<std::size_t> failed;
    const Smoothed curve = smoothed(chain, movedArcs(chain, gaps, left_mm), failed);
    ArcClothoids result;
    const Progress of_round = partOf(progress, shareAfter(round), shareAfter(round));
    if (failed.empty()) failed = bounded(chain, curve, left_mm, of_round, result);
    if (failed.empty()) {
      result.distance_mm += chain.distance_mm;
      return result;
    }
    worst = failed.front();
    for (const std::size_t j : failed) {
      gaps[j].gap_mm *= shrink;
      gaps[j].length_mm *= std::sqrt(shrink);
    }
  }
  throw std::domain_error(
      fmt::format("no transitions of clothoids were found at arc {} within {} mm: the chain has a "
                  "corner there, or the tolerance is below its rounding",
                  worst, tolerance_mm));
}

}  // namespace seamwright
