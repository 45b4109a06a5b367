// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <seamwright/core/angle.hpp>
#include <seamwright/occ_adapter/fill/hole_cuts.hpp>

namespace seamwright::occ {

namespace {

/// The ring of patches has so many sides.
constexpr std::size_t ring_sides = 4;

/// nSidedFill() takes so many sides at most.
constexpr std::size_t most_corners = 12;

/// A corner with a smaller angle, or nearer to a full turn than this, is a cusp.
constexpr double least_corner_rad = 1e-3;

/// Around corners with a larger angle, a ring of patches curls over.
constexpr double most_corner_rad = 5.3;

bool isReflex(const HoleAngle& corner) {
  return corner.angle_rad > std::numbers::pi;
}

void requireAngle(const HoleAngle& corner, std::size_t k, bool is_ring) {
  const double angle_rad = corner.angle_rad;
  const bool is_cusp = std::min(angle_rad, 2 * std::numbers::pi - angle_rad) < least_corner_rad;
  const bool is_wide = is_ring && angle_rad > most_corner_rad;
  if (!is_cusp && !is_wide && (is_ring || !isReflex(corner))) return;
  FillReason reason{.fault = is_cusp   ? FillFault::Cusp
                             : is_wide ? FillFault::CornerTooWide
                                       : FillFault::CornerAbove180,
                    .numbers = {{"corner", static_cast<double>(k) + 1},
                                {"angle_deg", angle_rad * degrees_per_radian}},
                    .edges = {corner.edges[0], corner.edges[1]},
                    .point_mm = corner.point};
  if (is_wide) reason.numbers.emplace_back("most_deg", most_corner_rad * degrees_per_radian);
  if (!is_ring) reason.numbers.emplace_back("corners", ring_sides);
  throw NotFilled(std::move(reason));
}

double largestMiss(const std::vector<FittedSide>& sides, const ContinuityTolerance& tolerance) {
  double most = 0;
  for (const FittedSide& side : sides)
    most = std::max({most, fit_share * side.gap_mm / tolerance.gap_mm,
                     fit_share * side.angle_rad / tolerance.angle_rad});
  return most;
}

HoleCut fitted(const FillTask& task, const FillAttempt& attempt, bool is_ring,
               std::vector<SideInterval> intervals) {
  const ContinuityTolerance& tolerance = task.options.tolerance;
  // With target G0 a smooth loop must be declared to have position only. At corners the angle of
  // the planes decides.
  const bool position_only = is_ring && task.options.target == Level::G0;
  std::vector<FittedSide> sides = fitSides(task.hole.sides, intervals,
                                           {.gap_mm = tolerance.gap_mm / fit_share,
                                            .angle_rad = tolerance.angle_rad / fit_share,
                                            .most_degree = attempt.most_degree,
                                            .planar_rad = position_only ? -1 : most_planar_rad,
                                            .curvature = attempt.curvature_raise.has_value()});
  const double misses = largestMiss(sides, tolerance);
  return {.intervals = std::move(intervals), .sides = std::move(sides), .misses = misses};
}

/// Adds other cuts of the hole into the sides of a ring, best fits first.
void addCuts(const FillTask& task, const FillAttempt& attempt, std::vector<HoleCut>& cuts) {
  const double gap_mm = task.options.tolerance.gap_mm / fit_share;
  const auto add = [&](std::vector<SideInterval> intervals) {
    cuts.push_back(fitted(task, attempt, true, std::move(intervals)));
  };
  add(cutSides(task.hole, ring_sides, gap_mm, false));
  if (!task.hole.has_corners)
    for (std::vector<SideInterval>& cut : loopCuts(task.hole, ring_sides, gap_mm))
      add(std::move(cut));
  std::ranges::stable_sort(cuts, {}, &HoleCut::misses);
}

/// Edges of the hole that lie along an interval of one of its sides.
std::vector<int> edgesAlong(const HoleSide& side, const SideInterval& interval) {
  std::vector<int> edges;
  const double round_mm = side.length_mm;
  const double first_mm = interval.begin * round_mm, last_mm = interval.end * round_mm;
  double begin_mm = 0;
  for (const HoleEdge& edge : side.edges) {
    const double end_mm = begin_mm + edge.length_mm;
    if ((end_mm > first_mm && begin_mm < last_mm) || begin_mm + round_mm < last_mm)
      edges.push_back(edge.edge);
    begin_mm = end_mm;
  }
  return edges;
}

}  // namespace

std::vector<FillSide> HoleCut::fillSides() const {
  std::vector<FillSide> result;
  for (const FittedSide& side : sides) result.push_back(side.side);
  return result;
}

HoleCuts cutsOf(const FillTask& task, const FillAttempt& attempt) {
  const Hole& hole = task.hole;
  const std::size_t corners = hole.has_corners ? hole.sides.size() : 0;
  if (corners > most_corners)
    throw NotFilled(
        {.fault = FillFault::TooManyCorners,
         .numbers = {{"corners", static_cast<double>(corners)}, {"most", most_corners}}});
  const double gap_mm = task.options.tolerance.gap_mm / fit_share;
  const std::vector<HoleAngle> angles = anglesOf(hole, gap_mm);
  HoleCuts result;
  result.is_ring = corners < 3 || (corners <= ring_sides && std::ranges::any_of(angles, isReflex));
  for (std::size_t k = 0; k < angles.size(); ++k) requireAngle(angles[k], k, result.is_ring);
  result.cuts.push_back(
      fitted(task, attempt, result.is_ring,
             result.is_ring ? cutSides(hole, ring_sides, gap_mm, true) : wholeSides(hole)));
  if (result.is_ring && result.cuts.front().misses > 1) addCuts(task, attempt, result.cuts);
  return result;
}

std::vector<FilledSide> filledSides(const Hole& hole, const HoleCut& cut) {
  std::vector<FilledSide> result;
  for (std::size_t k = 0; k < cut.sides.size(); ++k) {
    const FittedSide& side = cut.sides[k];
    const SideInterval& interval = cut.intervals[k];
    result.push_back(
        {.edges = edgesAlong(hole.sides[interval.side], interval),
         .position_only = !side.side.cross,
         .edge_degree = side.side.edge.degree(),
         .cross_degree = side.side.cross ? static_cast<int>(side.side.cross->rows()) - 1 : 0,
         .gap_mm = side.gap_mm,
         .angle_rad = side.angle_rad,
         .corner_rad = side.corner_rad});
  }
  return result;
}

std::vector<FillReason> causesOfDistance(const FillTask& task, const HoleCut& cut) {
  if (cut.sides.empty()) return {};
  const auto worst = std::ranges::max_element(cut.sides, {}, &FittedSide::gap_mm);
  const double gap_mm = task.options.tolerance.gap_mm;
  if (worst->gap_mm <= gap_mm) return {};
  const HoleAngle turn = sharpestTurn(task.hole, gap_mm / fit_share);
  if (turn.angle_rad > most_planar_rad)
    return {{.fault = FillFault::SharpTurn,
             .numbers = {{"turn_deg", turn.angle_rad * degrees_per_radian}},
             .edges = {turn.edges[0], turn.edges[1]},
             .point_mm = turn.point}};
  const SideInterval& interval = cut.intervals[static_cast<std::size_t>(worst - cut.sides.begin())];
  return {{.fault = FillFault::SideNotPolynomial,
           .numbers = {{"gap_mm", worst->gap_mm}},
           .edges = edgesAlong(task.hole.sides[interval.side], interval),
           .point_mm = worst->side.edge.point(0.5)}};
}

}  // namespace seamwright::occ
