// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Geom2d_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <seamwright/core/join/nearest/nearest.hpp>
#include <seamwright/occ_adapter/match/candidate.hpp>
#include <seamwright/occ_adapter/match/match_reasons.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// The straight path from p to q over [first, last].
handle<Geom2d_Curve> straight(const Eigen::Vector2d& p, const Eigen::Vector2d& q, double first,
                              double last) {
  TColgp_Array1OfPnt2d poles(1, 2);
  poles(1) = gp_Pnt2d(p.x(), p.y());
  poles(2) = gp_Pnt2d(q.x(), q.y());
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = first;
  knots(2) = last;
  TColStd_Array1OfInteger multiplicities(1, 2);
  multiplicities.Init(2);
  return new Geom2d_BSplineCurve(poles, knots, multiplicities, 1);
}

handle<Geom_BSplineSurface> copyOf(const handle<Geom_BSplineSurface>& surface) {
  return handle<Geom_BSplineSurface>::DownCast(surface->Copy());
}

/// Path and sense of a natural side whose rows run with the seam.
FacePlan naturalPlan(const MatchSide& side, const EdgeRows& rows, double first, double last,
                     bool against) {
  FacePlan plan{side.face, side.use, {}, {}, true};
  plan.path =
      straight(rows.parameters(against ? 1 : 0), rows.parameters(against ? 0 : 1), first, last);
  plan.with_old_edge = (side.with_edge != rows.reversed()) != against;
  return plan;
}

/// Whether the seam's parameter runs against the own sense of the other side's edge.
bool isOtherReversed(const PairToMatch& pair) {
  const bool with_curve = pair.path.linear ? !pair.path.against : pair.path.with_edge_curve;
  return pair.other().with_edge != with_curve;
}

JoinSide joinSide(const EdgeRows& rows, bool moves, const FaceMatchOptions& options) {
  JoinSide side;
  side.surface = coreSurface(*rows.surface());
  side.edge = rows.edge();
  side.reversed = rows.reversed();
  side.moves = moves;
  if (!moves) return side;
  for (const int column : {0, rows.columns() - 1}) {
    if (!options.hold_sides && !isCollapsed(rows, column)) continue;
    side.fixed.resize(static_cast<std::size_t>(side.surface.poles.rows()), false);
    for (int row = 0; row <= options.order; ++row) side.fixed[rows.number(row, column)] = true;
  }
  return side;
}

/// The rows of both sides along the seam, that of the driver in its own sense.
std::array<EdgeRows, 2> rowsOf(const PairToMatch& pair, int extra_multiplicity) {
  const auto rows = [&](int which) {
    const MatchSide& side = pair.sides[which];
    const bool reversed = which != pair.driver && isOtherReversed(pair);
    const EdgeRows own = pair.moves[which] ? rowsToMove(side, pair.options.order)
                                           : EdgeRows(copyOf(side.spline), side.edge);
    return EdgeRows(own.surface(), side.edge, reversed);
  };
  std::array<EdgeRows, 2> both = {rows(0), rows(1)};
  alignAlong(both[1 - pair.driver], both[pair.driver], extra_multiplicity);
  return both;
}

/// The time of a join grows with the third power of the poles that move; with so many a step takes
/// some hundredths of a second.
bool hasFewPoles(const PairToMatch& pair, const EdgeRows& rows) {
  constexpr int most_poles = 300;
  const int moved_rows = (pair.options.order + 1) * (pair.moves[0] && pair.moves[1] ? 2 : 1);
  return rows.columns() * moved_rows <= most_poles;
}

Candidate joinWithKnots(const PairToMatch& pair, int extra_multiplicity) {
  const std::array<EdgeRows, 2> rows = rowsOf(pair, extra_multiplicity);
  Candidate candidate;
  NearestOptions options;
  options.order = pair.options.order;
  // Steps converge quadratically once they are near: the first ten bring most of the way, and each
  // takes seconds with thousands of poles.
  constexpr int steps_with_many_poles = 10;
  if (!hasFewPoles(pair, rows[0])) options.max_iterations = steps_with_many_poles;
  NearestJoin join;
  try {
    join = nearestJoin(joinSide(rows[0], pair.moves[0], pair.options),
                       joinSide(rows[1], pair.moves[1], pair.options), options);
  } catch (const std::invalid_argument& refused) {
    candidate.failure = match_why::joinRefused(refused.what());
    return candidate;
  }
  if (join.status == NearestStatus::Infeasible) {
    candidate.failure = match_why::noExactJoin();
    return candidate;
  }
  candidate.exact = true;
  candidate.plan.gap_mm = pair.options.tolerance.gap_mm;
  const std::array<const BSplineSurface*, 2> joined = {&join.a, &join.b};
  for (const int which : {0, 1}) {
    FacePlan& plan = candidate.plan.faces[which] =
        naturalPlan(pair.sides[which], rows[which], 0, 1, false);
    if (!pair.moves[which]) continue;
    MovedSurface& moved = candidate.moved[which];
    moved = {rows[which].surface(), geomSurface(*joined[which]), 0};
    const EdgeRows after(moved.after, rows[which].edge(), rows[which].reversed());
    moved.largest_move_mm = largestMove_mm(rows[which], after, options.order);
    candidate.largest_move_mm = std::max(candidate.largest_move_mm, moved.largest_move_mm);
    plan.surface = moved.after;
  }
  const EdgeRows driver(candidate.moved[pair.driver].after, rows[pair.driver].edge());
  candidate.plan.curve = driver.boundary(0, 1);
  candidate.how = match_why::joinedInPoles(extra_multiplicity);
  return candidate;
}

bool hasInnerKnots(const EdgeRows& rows) {
  return rows.columns() > rows.degreeAlong() + 1;
}

/// Halves the spans that miss the limit. \returns whether any does.
bool refine(EdgeRows& rows, const std::vector<double>& ratios, double limit) {
  std::vector<double> knots = rows.knotsAlong();
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  bool any = false;
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    if (ratios[i] <= limit) continue;
    rows.insertAlong((knots[i] + knots[i + 1]) / 2, 1);
    any = true;
  }
  return any;
}

/// The seam's parameter is that of the other side's path.
SeamPlan planAlongPath(const PairToMatch& pair, const EdgeRows& moved) {
  SeamPlan plan;
  plan.gap_mm = pair.options.tolerance.gap_mm;
  plan.first = pair.path.pcurve.first;
  plan.last = pair.path.pcurve.last;
  FacePlan& driver = plan.faces[pair.driver];
  driver = naturalPlan(pair.sides[pair.driver], moved, plan.first, plan.last, pair.path.against);
  driver.surface = moved.surface();
  plan.faces[1 - pair.driver] = {
      pair.other().face, pair.other().use, {}, pair.path.pcurve.curve, pair.path.with_edge_curve};
  plan.curve =
      EdgeRows(moved.surface(), moved.edge(), pair.path.against).boundary(plan.first, plan.last);
  return plan;
}

}  // namespace

EdgeRows rowsToMove(const MatchSide& side, int order) {
  EdgeRows rows(copyOf(side.spline), side.edge);
  const bool is_one_span = rows.rows() == rows.degreeAcross() + 1;
  // order + 1 rows move; as many behind the opposite side keep that side with its derivatives.
  rows.raiseDegreeAcross(is_one_span ? 2 * order + 1 : order);
  rows.refineAcross(2 * order + 2);
  return rows;
}

Candidate joinInPoles(const PairToMatch& pair) {
  Candidate best = joinWithKnots(pair, 0);
  const EdgeRows rows = rowsOf(pair, 0)[0];
  if (!hasInnerKnots(rows) || !hasFewPoles(pair, rows)) return best;
  for (int extra = 1; extra <= pair.options.order; ++extra) {
    Candidate next = joinWithKnots(pair, extra);
    if (!next.failure.empty()) continue;
    if (!best.failure.empty() || next.largest_move_mm < best.largest_move_mm)
      best = std::move(next);
  }
  return best;
}

Candidate joinToTolerance(const PairToMatch& pair, double limit) {
  // Figures of a fit fall by a power of the length of a span: where 64 parts of a span do not meet
  // the tolerance, the faces contradict each other there. The columns bound the time.
  constexpr int most_refinements = 6;
  constexpr int most_columns = 600;
  const DeformationOptions options{pair.options.order, pair.options.hold_sides,
                                   pair.options.tolerance};
  const Reference reference(pair.other(), pair.path);
  EdgeRows rows = rowsToMove(pair.sides[pair.driver], options.order);
  Candidate candidate;
  if (options.hold_sides) {
    candidate.failure = whySidesMove(rows, reference, options);
    if (!candidate.failure.empty()) return candidate;
  }
  // The error of a fit falls with the power degree + 1 of a span: rows of lower degree would need
  // many more spans.
  rows.raiseDegreeAlong(options.order + 2);
  double worst = 0;
  for (int refinements = 0; refinements <= most_refinements; ++refinements) {
    MovedSurface moved = deformed(rows, reference, options);
    const EdgeRows after(moved.after, rows.edge());
    const std::vector<double> ratios = sampledRatios(after, reference, options);
    worst = *std::ranges::max_element(ratios);
    if (rows.columns() < most_columns && refine(rows, ratios, limit)) continue;
    if (worst > limit) break;
    candidate.largest_move_mm = moved.largest_move_mm;
    candidate.plan = planAlongPath(pair, after);
    candidate.moved[pair.driver] = std::move(moved);
    candidate.how = match_why::joinedToTolerance(refinements);
    return candidate;
  }
  candidate.failure = std::isinf(worst) ? match_why::facesFold()
                                        : match_why::missesTolerance(most_refinements, worst);
  return candidate;
}

}  // namespace seamwright::occ
