// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <seamwright/core/join/nearest/common_seam.hpp>
#include <seamwright/core/join/nearest/nearest.hpp>
#include <seamwright/core/join/nearest/nearest_family.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using namespace nearest;

/// Of a dense matrix, which then takes 12 MB. A choice that bounds the time of its factorisation.
constexpr double max_entries = 1.5e6;
/// Share of the derivatives above which rounding hides whether a join holds.
constexpr double largest_rounding = 1e-6;
/// Share of the ratio of the sides' cross-boundary derivatives below which alpha of a join that
/// holds is only rounding.
constexpr double least_alpha = 1e-9;

void requireOptions(const NearestOptions& options) {
  if (options.order < 1 || options.order > 3)
    refuse("order is " + std::to_string(options.order) + ": 1 to 3 is needed");
  requireDegree(options.degree_alpha, "alpha");
  requireDegree(options.degree_beta, "beta");
  requireDegree(options.degree_p, "p");
  requireDegree(options.degree_q, "q");
  requireDegree(options.degree_h, "h");
  requireDegree(options.degree_k, "k");
  requireDegree(options.degree_e1, "e1");
  requireDegree(options.degree_e2, "e2");
  requireDegree(options.degree_e3, "e3");
  if (!(options.smallest_alpha > 0 && options.smallest_alpha <= 1))
    refuse(fmt::format("smallest_alpha is {}: 0 to 1 is needed", options.smallest_alpha));
  if (options.max_iterations < 0)
    refuse("max_iterations is " + std::to_string(options.max_iterations) +
           ": it must not be negative");
}

void requireSize(const Unknowns& u, int order) {
  // Rows are at most as many as the poles times the degrees that the condition may add.
  const double poles = static_cast<double>(u.blocks()) * u.count();
  const double entries =
      poles * order * (u.count() + static_cast<double>(order * std::ssize(innerKnots(u.a))));
  if (entries > max_entries)
    refuse("the seam has " + std::to_string(u.count()) +
           " poles: the matrix of the join would have " +
           std::to_string(static_cast<long>(entries)) + " entries, more than " +
           std::to_string(static_cast<long>(max_entries)));
}

double relativeResidual(const Condition& condition, const Eigen::VectorXd& c,
                        const Eigen::MatrixXd& x) {
  return (condition.matrix(c) * x).rowwise().norm().maxCoeff() / condition.largestDerivative(x);
}

/// The join of that family for the unmoved unknowns, if there is one.
bool alreadyJoined(const Unknowns& u, const NearestOptions& options, const Family& family,
                   NearestJoin& result) {
  const Condition condition(u, options.order, family.degrees, {});
  const double rounding = 32 * std::numeric_limits<double>::epsilon() * u.largest;
  const Eigen::VectorXd c = family.basis.cols() > 0
                                ? condition.fitted(u.target, family.basis, family.held, 0)
                                : family.held;
  const Eigen::VectorXd alpha = c.head(family.degrees[Alpha] + 1);
  const std::array<double, 2> speeds = condition.crossSpeeds(u.target);
  const bool joined = alpha.minCoeff() > least_alpha * speeds[1] / speeds[0] &&
                      u.seam_gap <= rounding && holds(condition.matrix(c), u.target, u.largest);
  const double residual = relativeResidual(condition, c, u.target);
  if (!joined || !(residual <= largest_rounding)) return false;
  result.status = NearestStatus::Unchanged;
  result.connection = connectionOf(u, family.degrees, c);
  result.residual = residual;
  return true;
}

struct Candidate {
  Family family;
  Solution solution;
  double residual;
};

Candidate candidate(const Unknowns& u, const NearestOptions& options, const Family& family) {
  const Condition condition(u, options.order, family.degrees, family.vanishing);
  const std::array<double, 2> speeds = condition.crossSpeeds(u.target);
  const double smallest_alpha = options.smallest_alpha * speeds[1] / speeds[0];
  Solution solution = solve(u, condition, family, smallest_alpha, options.max_iterations);
  const double residual = relativeResidual(condition, solution.c, solution.x);
  solution.exact = solution.exact && residual <= largest_rounding;
  return {family, std::move(solution), residual};
}

/// A search with a nearly constant alpha may approach the join of a constant alpha and never reach
/// it. So a candidate that has not converged must be nearer by more than rounding explains.
bool better(const Candidate& one, const Candidate& other) {
  // A search that stops early is off by its stationarity squared, which is far less.
  constexpr double clearly = 1e-3;
  if (one.solution.exact != other.solution.exact) return one.solution.exact;
  if (!one.solution.exact) return one.residual < other.residual;
  const auto effective = [&](const Solution& s) {
    return s.cost * (s.stationary ? 1 : 1 + clearly);
  };
  return effective(one.solution) < effective(other.solution);
}

Candidate nearestOf(const Unknowns& u, const NearestOptions& options,
                    const std::vector<Family>& families) {
  std::optional<Candidate> best;
  const auto consider = [&](const Family& family) {
    Candidate next = candidate(u, options, family);
    if (!best || better(next, *best)) best = std::move(next);
  };
  for (const Family& family : families) consider(family);
  if (const auto smooth = smoothFamily(u, families.back(), best->solution)) consider(*smooth);
  return std::move(*best);
}

/// The residual of the stored poles.
double storedResidual(JoinSide a, JoinSide b, const NearestJoin& join, const Candidate& found,
                      int order) {
  a.surface = join.a;
  b.surface = join.b;
  const Unknowns u = unknowns(a, b, order);
  const Condition condition(u, order, found.family.degrees, found.family.vanishing);
  return relativeResidual(condition, found.solution.c, u.target);
}

/// \pre both sides have the same degree, knots and parameter.
NearestJoin joinOf(const JoinSide& a, const JoinSide& b, const NearestOptions& options) {
  const Unknowns u = unknowns(a, b, options.order);
  requireSize(u, options.order);
  std::vector<Family> held;
  if (options.held) held = {heldFamily(*options.held, options, u.rational)};

  NearestJoin result;
  result.a = a.surface;
  result.b = b.surface;
  for (const Family& family : options.held ? held : familiesThatMayHold(options, u.rational))
    if (alreadyJoined(u, options, family, result)) return result;

  const double rounding = 32 * std::numeric_limits<double>::epsilon() * u.largest;
  result.residual = u.fixed_gap / u.size;
  if (u.fixed_gap > rounding) return result;
  const Candidate found = nearestOf(u, options, options.held ? held : familiesOf(u, options));
  const Solution& solution = found.solution;
  result.connection = connectionOf(u, found.family.degrees, solution.c);
  result.iterations = solution.iterations;
  result.residual = std::max(found.residual, result.residual);
  if (!solution.exact) return result;
  NearestJoin placed = result;
  place(u, solution.x, a, b, placed);
  placed.residual = result.residual = storedResidual(a, b, placed, found, options.order);
  if (!(placed.residual <= largest_rounding)) return result;
  placed.cost = solution.cost + u.seam_cost;
  placed.stationarity = solution.stationarity;
  placed.status = solution.stationary ? NearestStatus::Joined : NearestStatus::NotConverged;
  return placed;
}

}  // namespace

NearestJoin nearestJoin(const JoinSide& a, const JoinSide& b, const NearestOptions& options) {
  requireOptions(options);
  const CommonSeam seam = commonSeam(a, b, options.order);
  NearestJoin join = joinOf(seam.a.side, seam.b.side, options);
  join.parameter_of_b = seam.parameter_of_b;
  const bool moved =
      join.status == NearestStatus::Joined || join.status == NearestStatus::NotConverged;
  const auto giveBack = [&](const CommonSide& common, const JoinSide& given,
                            BSplineSurface& surface, SeamChange& change) {
    const bool changed = moved && given.moves;
    surface = changed ? common.inOwnParameter(surface) : given.surface;
    if (changed) change = common.change;
  };
  giveBack(seam.a, a, join.a, join.change_a);
  giveBack(seam.b, b, join.b, join.change_b);
  return join;
}

}  // namespace seamwright
