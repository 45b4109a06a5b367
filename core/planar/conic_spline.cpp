// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/conic_pair.hpp>
#include <seamwright/core/planar/conic_spline.hpp>
#include <seamwright/core/planar/tridiagonal.hpp>

namespace seamwright {

namespace {

using Eigen::Index;
using Eigen::Vector2d;
using std::numbers::pi;

enum class NodeKind {
  End,         ///< of an open chain
  Turn,        ///< curves on both sides that turn to the same side: the tangent is sought
  Inflection,  ///< curves on both sides that turn to different sides
  Line,        ///< a line on one side or on both
};

/// A point of the spline, and the span that begins there.
struct SplineNode {
  Vector2d point = Vector2d::Zero();
  double turn_rad = 0;  ///< of the polygon; 0 at ends
  int turn_sign = 0;    ///< 0 also if rounding hides it
  NodeKind kind = NodeKind::Turn;
  bool inserted = false;
  double chord_mm = 0, chord_direction_rad = 0;  ///< of the span
  bool is_line = false;                          ///< the span
  /// From the tangent to the chord of the span, without sign; only at a Turn.
  double angle_rad = 0;
};

/// Nodes in a row or in a ring. The last one of a row has no span.
class NodeChain {
 public:
  NodeChain(std::vector<SplineNode> nodes, bool closed)
      : nodes_(std::move(nodes)), closed_(closed) {}

  Index count() const { return static_cast<Index>(nodes_.size()); }
  Index spans() const { return closed_ ? count() : count() - 1; }
  bool closed() const { return closed_; }
  SplineNode& at(Index i) { return nodes_[static_cast<std::size_t>((i + count()) % count())]; }
  const SplineNode& at(Index i) const {
    return nodes_[static_cast<std::size_t>((i + count()) % count())];
  }
  bool hasSpanBefore(Index i) const { return closed_ || i > 0; }
  bool hasSpanAfter(Index i) const { return closed_ || i + 1 < count(); }
  /// Before node i.
  void insert(Index i, const SplineNode& node) { nodes_.insert(nodes_.begin() + i, node); }

  /// Angles of the span at its ends against the chord, without sign.
  double startAngle(Index span) const;
  double endAngle(Index span) const;
  /// To which side the span turns.
  int side(Index span) const {
    return at(span).kind == NodeKind::Turn || at(span).kind == NodeKind::Line
               ? at(span).turn_sign
               : at(span + 1).turn_sign;
  }

 private:
  std::vector<SplineNode> nodes_;
  bool closed_;
};

/// Half of the smaller angle at the other ends of the two spans, where clothoids have it.
double inflectionAngle(const NodeChain& chain, Index i);

void measureChords(NodeChain& chain) {
  for (Index i = 0; i < chain.spans(); ++i) {
    const Vector2d chord = chain.at(i + 1).point - chain.at(i).point;
    chain.at(i).chord_mm = chord.norm();
    chain.at(i).chord_direction_rad = directionOf(chord);
  }
  for (Index i = 0; i < chain.count(); ++i)
    if (chain.hasSpanBefore(i) && chain.hasSpanAfter(i))
      chain.at(i).turn_rad = angleFromTo(chain.at(i).point - chain.at(i - 1).point,
                                         chain.at(i + 1).point - chain.at(i).point);
}

/// Each coordinate of a chord has one rounding of this size, and so has each given point.
double roundingOf_mm(const SplineNode& before, const SplineNode& node, const SplineNode& after) {
  return machine_epsilon *
         std::max({before.point.cwiseAbs().maxCoeff(), node.point.cwiseAbs().maxCoeff(),
                   after.point.cwiseAbs().maxCoeff()});
}

/// The side to which the polygon turns; 0 if rounding hides it.
int turnSide(const SplineNode& before, const SplineNode& node, const SplineNode& after) {
  const double noise_rad =
      4 * roundingOf_mm(before, node, after) * (1 / before.chord_mm + 1 / node.chord_mm);
  if (std::abs(node.turn_rad) <= noise_rad) return 0;
  return node.turn_rad > 0 ? 1 : -1;
}

NodeChain chainOf(const PlanarPoints& points, bool closed) {
  const Index least = closed ? 3 : 2;
  if (points.rows() < least)
    refuse(fmt::format("{} points: at least {} are needed", points.rows(), least));
  std::vector<SplineNode> nodes;
  for (Index i = 0; i < points.rows(); ++i) {
    if (!points.row(i).allFinite()) refuse(fmt::format("point {} is not finite", i));
    nodes.push_back({.point = points.row(i).transpose()});
  }
  NodeChain chain(std::move(nodes), closed);
  for (Index i = 0; i < chain.spans(); ++i)
    if (chain.at(i).point == chain.at(i + 1).point)
      refuse(fmt::format("points {} and {} are equal: ({}, {})", i, (i + 1) % chain.count(),
                         chain.at(i).point.x(), chain.at(i).point.y()));
  measureChords(chain);
  for (Index i = 0; i < chain.count(); ++i) {
    if (!chain.hasSpanBefore(i) || !chain.hasSpanAfter(i)) continue;
    chain.at(i).turn_sign = turnSide(chain.at(i - 1), chain.at(i), chain.at(i + 1));
    // As in tangentsAt(): the sense of a turn by pi is rounding.
    constexpr double reversal_rad = pi - 1e-9;
    if (std::abs(chain.at(i).turn_rad) > reversal_rad)
      throw std::domain_error(fmt::format("the polygon reverses its direction at ({:.6g}, {:.6g})",
                                          chain.at(i).point.x(), chain.at(i).point.y()));
  }
  return chain;
}

/// The side of the first node that turns, going back (step -1) or on from a node; 0 at an end.
int nextSide(const NodeChain& chain, Index from, Index step) {
  for (Index k = 1; k <= chain.count(); ++k) {
    const Index i = from + k * step;
    if (!chain.closed() && (i <= 0 || i >= chain.count() - 1)) return 0;
    if (chain.at(i).turn_sign != 0) return chain.at(i).turn_sign;
  }
  return 0;
}

/// Nodes without a turn are inflections, or have lines on both sides.
void findLines(NodeChain& chain) {
  if (chain.count() == 2 && !chain.closed()) chain.at(0).is_line = true;
  for (Index i = 0; i < chain.count(); ++i) {
    SplineNode& node = chain.at(i);
    if (!chain.hasSpanBefore(i) || !chain.hasSpanAfter(i)) {
      node.kind = NodeKind::End;
      continue;
    }
    if (node.turn_sign != 0) continue;
    const bool alone = chain.at(i - 1).turn_sign != 0 && chain.at(i + 1).turn_sign != 0;
    if (alone && nextSide(chain, i, -1) * nextSide(chain, i, 1) < 0) {
      node.kind = NodeKind::Inflection;
      continue;
    }
    chain.at(i - 1).is_line = node.is_line = true;
  }
  for (Index i = 0; i < chain.count(); ++i) {
    const bool line_before = chain.hasSpanBefore(i) && chain.at(i - 1).is_line;
    const bool line_after = chain.hasSpanAfter(i) && chain.at(i).is_line;
    if (line_before || line_after) chain.at(i).kind = NodeKind::Line;
  }
}

/// Of the circle through a node and its neighbours, without sign.
double circleCurvature(const NodeChain& chain, Index i) {
  const double across_mm = (chain.at(i + 1).point - chain.at(i - 1).point).norm();
  return 2 * std::abs(std::sin(chain.at(i).turn_rad)) / across_mm;
}

/// Whether the ends of a span turn to different sides.
bool turnsBothWays(const NodeChain& chain, Index s) {
  return chain.at(s).turn_sign * chain.at(s + 1).turn_sign < 0;
}

/// The share of a span at which a curvature is 0 that is linear along the chord.
double inflectionShare(const NodeChain& chain, Index s) {
  const double before = circleCurvature(chain, s), after = circleCurvature(chain, s + 1);
  return before / (before + after);
}

/// A node has no turn if a node inserted at the inflection beside it would be so near that the
/// conic between them waves, or that rounding of its place gives the chord between them another
/// direction.
void hideTurnsAtInflections(NodeChain& chain) {
  // A choice: the direction is to have an error of less than about a hundredth of the turn.
  constexpr double clear = 512, near_share = 1e-3;
  std::vector<Index> hidden;
  const auto consider = [&](Index i, double share, double chord_mm) {
    const double rounding_mm = roundingOf_mm(chain.at(i - 1), chain.at(i), chain.at(i + 1));
    const double to_inflection_mm = share * chord_mm;
    if (share <= near_share ||
        to_inflection_mm * std::abs(chain.at(i).turn_rad) <= clear * rounding_mm)
      hidden.push_back(i);
  };
  for (Index s = 0; s < chain.spans(); ++s) {
    if (!turnsBothWays(chain, s)) continue;
    const double share = inflectionShare(chain, s), chord_mm = chain.at(s).chord_mm;
    consider(s, share, chord_mm);
    consider(s + 1, 1 - share, chord_mm);
  }
  for (const Index i : hidden) chain.at(i).turn_sign = 0;
}

/// A node on the chord of each span whose ends turn to different sides.
void insertInflections(NodeChain& chain) {
  std::vector<std::pair<Index, Vector2d>> inserted;
  for (Index s = 0; s < chain.spans(); ++s) {
    const SplineNode &start = chain.at(s), &end = chain.at(s + 1);
    if (start.is_line || !turnsBothWays(chain, s)) continue;
    inserted.emplace_back(s + 1,
                          start.point + inflectionShare(chain, s) * (end.point - start.point));
  }
  for (auto node = inserted.rbegin(); node != inserted.rend(); ++node)
    chain.insert(node->first,
                 {.point = node->second, .kind = NodeKind::Inflection, .inserted = true});
  measureChords(chain);
}

/// The tangents of the circles through three neighbours.
void takeCircleTangents(NodeChain& chain) {
  for (Index i = 0; i < chain.count(); ++i) {
    SplineNode& node = chain.at(i);
    if (node.kind != NodeKind::Turn) continue;
    const Vector2d before = chain.at(i - 1).point, after = chain.at(i + 1).point;
    node.angle_rad = std::abs(angleFromTo(node.point - before, after - before));
  }
}

/// The logarithm of the curvature at a node from the span on one side, and its slopes.
struct SideCurvature {
  double value = 0;
  double by_own = 0, by_other = 0;  ///< by the angles at the node and at the other end of the span
};

SideCurvature sideCurvature(const NodeChain& chain, Index i, bool after) {
  const Index span = after ? i : i - 1;
  const SplineNode& far = chain.at(after ? i + 1 : i - 1);
  const double own = after ? chain.startAngle(span) : chain.endAngle(span);
  const double other = after ? chain.endAngle(span) : chain.startAngle(span);
  const double cot = 1 / std::tan(own);
  const double circle = std::log(2 * std::sin(own) / chain.at(span).chord_mm);
  // The angle at an end is the same, at an inflection half as large: it follows.
  if (far.kind == NodeKind::End) return {.value = circle, .by_own = cot};
  if (far.kind == NodeKind::Inflection)
    return {.value = circle + pair_power * std::numbers::ln2, .by_own = cot};
  return {.value = circle + pair_power * std::log(std::sin(own) / std::sin(other)),
          .by_own = (1 + pair_power) * cot,
          .by_other = -pair_power / std::tan(other)};
}

/// One Newton step towards one curvature from both sides of each node. Returns the largest
/// difference of the logarithms before the step.
double stepTangents(NodeChain& chain) {
  TridiagonalEquations equations(chain.count(), chain.closed());
  double largest = 0;
  for (Index i = 0; i < chain.count(); ++i) {
    if (chain.at(i).kind != NodeKind::Turn) {
      equations.give(i, 0);
      continue;
    }
    const SideCurvature before = sideCurvature(chain, i, false),
                        after = sideCurvature(chain, i, true);
    const double difference = after.value - before.value;
    largest = std::max(largest, std::abs(difference));
    // The angle before a node falls as the one after it grows.
    const bool moves_before = chain.at(i - 1).kind == NodeKind::Turn,
               moves_after = chain.at(i + 1).kind == NodeKind::Turn;
    equations.add(i, moves_before ? -before.by_other : 0, after.by_own + before.by_own,
                  moves_after ? -after.by_other : 0, -difference);
  }
  const Eigen::VectorXd steps = std::move(equations).solve();
  for (Index i = 0; i < chain.count(); ++i) {
    SplineNode& node = chain.at(i);
    if (node.kind != NodeKind::Turn) continue;
    // Both angles stay positive.
    constexpr double kept = 0.3;
    const double least = kept * node.angle_rad, turn = std::abs(node.turn_rad);
    const double most = turn - kept * (turn - node.angle_rad);
    node.angle_rad = std::clamp(node.angle_rad + steps(i), least, most);
  }
  return largest;
}

/// Newton's method from the tangents of circles; the best tangents on the way are kept, since any
/// give a convex curve.
void findTangents(NodeChain& chain) {
  constexpr int most_steps = 60;
  // Logarithms of the curvatures agree to this; the mean of both sides is taken.
  constexpr double agreed = 1e-12;
  takeCircleTangents(chain);
  NodeChain best = chain;
  double least = infinite;
  for (int step = 0; step < most_steps && !(least <= agreed); ++step) {
    const NodeChain before = chain;
    double difference = 0;
    try {
      difference = stepTangents(chain);
    } catch (const std::domain_error&) {  // the equations are singular
      break;
    }
    if (difference < least) {
      least = difference;
      best = before;
    }
  }
  chain = std::move(best);
}

/// A node in each span that turns by more than one pair of conics may: where the lines meet that
/// halve the angles at its ends. Its triangle with the chord keeps the polygon convex.
int divideWideSpans(NodeChain& chain) {
  int divided = 0;
  for (Index s = chain.spans() - 1; s >= 0; --s) {
    const SplineNode& node = chain.at(s);
    if (node.is_line) continue;
    const double start = chain.startAngle(s), end = chain.endAngle(s);
    if (start + end <= most_pair_turn_rad) continue;
    const int side = chain.side(s);
    const double along_mm = node.chord_mm * std::sin(end / 2) / std::sin((start + end) / 2);
    chain.insert(s + 1, {.point = node.point + along_mm * unitVector(node.chord_direction_rad -
                                                                     side * start / 2),
                         .turn_sign = side,
                         .inserted = true});
    ++divided;
  }
  if (divided > 0) measureChords(chain);
  return divided;
}

/// The direction of the tangent at a node.
double tangentAt(const NodeChain& chain, Index i) {
  const bool after = chain.hasSpanAfter(i);
  const SplineNode& node = chain.at(i);
  if (after && node.is_line) return node.chord_direction_rad;
  if (chain.hasSpanBefore(i) && (!after || chain.at(i - 1).is_line)) {
    const SplineNode& before = chain.at(i - 1);
    if (before.is_line) return before.chord_direction_rad;
    return before.chord_direction_rad + chain.side(i - 1) * chain.endAngle(i - 1);
  }
  return node.chord_direction_rad - chain.side(i) * chain.startAngle(i);
}

/// The size of the curvature at a node for the span on one side.
double curvatureAt(const NodeChain& chain, Index i, bool after) {
  const Index span = after ? i : i - 1;
  const double chord_mm = chain.at(span).chord_mm;
  const double own = after ? chain.startAngle(span) : chain.endAngle(span);
  const double other = after ? chain.endAngle(span) : chain.startAngle(span);
  switch (chain.at(i).kind) {
    case NodeKind::Turn:
      return std::exp((sideCurvature(chain, i, false).value + sideCurvature(chain, i, true).value) /
                      2);
    case NodeKind::End: {
      // As far from that of the circle as the curvature at the other end, to the other side.
      const double circle = 2 * std::sin(own) / chord_mm;
      return circle * circle / curvatureAt(chain, after ? i + 1 : i - 1, !after);
    }
    case NodeKind::Line:
    case NodeKind::Inflection:
      break;
  }
  return pairCurvature_per_mm({.chord_mm = chord_mm, .own_rad = own, .other_rad = other});
}

std::array<PlanarConic, 2> conicsOfSpan(const NodeChain& chain, Index s, PairEffort effort) {
  const int side = chain.side(s);
  return fairConics({.ends = {.start = chain.at(s).point,
                              .start_direction_rad = tangentAt(chain, s),
                              .end = chain.at(s + 1).point,
                              .end_direction_rad = tangentAt(chain, s + 1)},
                     .start_curvature_per_mm = side * curvatureAt(chain, s, true),
                     .end_curvature_per_mm = side * curvatureAt(chain, s + 1, false)},
                    effort)
      .conics;
}

/// Notes how span s joins the one before it.
void noteJoint(const NodeChain& chain, Index s, ConicSpline& result) {
  if (!chain.hasSpanBefore(s)) return;
  const int joint = static_cast<int>(result.conics.size());
  const SplineNode& node = chain.at(s);
  if (node.kind == NodeKind::Inflection || node.is_line != chain.at(s - 1).is_line)
    result.g1_joints.push_back(joint);
  else if (node.is_line && node.turn_sign != 0)
    result.corners.push_back(joint);
}

double inflectionAngle(const NodeChain& chain, Index i) {
  // A choice: with a far smaller share the other span would be pressed into a kink.
  constexpr double least_share = 0.005;
  const double before = chain.startAngle(i - 1), after = chain.endAngle(i);
  return std::max(std::min(before, after), least_share * std::max(before, after)) / 2;
}

}  // namespace

double NodeChain::startAngle(Index span) const {
  const SplineNode& node = at(span);
  if (node.kind == NodeKind::Turn) return node.angle_rad;
  if (node.kind == NodeKind::Line) return std::abs(node.turn_rad);
  return node.kind == NodeKind::End ? endAngle(span) : inflectionAngle(*this, span);
}

double NodeChain::endAngle(Index span) const {
  const SplineNode& node = at(span + 1);
  if (node.kind == NodeKind::Turn) return std::abs(node.turn_rad) - node.angle_rad;
  if (node.kind == NodeKind::Line) return std::abs(node.turn_rad);
  return node.kind == NodeKind::End ? startAngle(span) : inflectionAngle(*this, span + 1);
}

ConicSpline conicSpline(const PlanarPoints& points, bool closed, const Progress& progress,
                        PairEffort effort) {
  NodeChain chain = chainOf(points, closed);
  hideTurnsAtInflections(chain);
  findLines(chain);
  insertInflections(chain);
  ConicSpline result;
  result.closed = closed;
  takeCircleTangents(chain);
  while (const int divided = divideWideSpans(chain)) {
    result.inserted += divided;
    takeCircleTangents(chain);
  }
  findTangents(chain);
  // A division halves the turn of a span. Then its tangents change a little: few rounds are needed,
  // and a wider span is still a pair of conics.
  constexpr int most_rounds = 8;
  for (int round = 0; round < most_rounds; ++round) {
    const int divided = divideWideSpans(chain);
    if (divided == 0) break;
    result.inserted += divided;
    findTangents(chain);
  }
  // A choice: most of the time goes into the pairs.
  constexpr double tangents_found = 0.1;
  for (Index s = 0; s < chain.spans(); ++s) {
    const double share = static_cast<double>(s) / static_cast<double>(chain.spans());
    checkProgress(progress, tangents_found + (1 - tangents_found) * share);
    noteJoint(chain, s, result);
    if (chain.at(s).is_line) {
      const Vector2d start = chain.at(s).point, end = chain.at(s + 1).point;
      result.conics.push_back({.start = start, .corner = (start + end) / 2, .end = end});
      continue;
    }
    const std::array<PlanarConic, 2> pair = conicsOfSpan(chain, s, effort);
    result.conics.insert(result.conics.end(), pair.begin(), pair.end());
  }
  return result;
}

}  // namespace seamwright
