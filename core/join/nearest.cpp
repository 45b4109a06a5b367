// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/join/nearest.hpp>
#include <seamwright/core/join/nearest_solver.hpp>

namespace seamwright {

namespace {

using namespace nearest;

constexpr int max_connection_degree = 6;
constexpr double max_entries = 6e6;

[[noreturn]] void refuse(const std::string& text) {
  throw std::invalid_argument(text);
}

void requireDegree(int degree, const char* name) {
  if (degree < 0 || degree > max_connection_degree)
    refuse("degree of " + std::string(name) + " is " + std::to_string(degree) + ": 0 to " +
           std::to_string(max_connection_degree) + " is needed");
}

void requireOptions(const NearestOptions& options) {
  if (options.order != 1 && options.order != 2)
    refuse("order is " + std::to_string(options.order) + ": 1 or 2 is needed");
  requireDegree(options.degree_alpha, "alpha");
  requireDegree(options.degree_beta, "beta");
  requireDegree(options.degree_p, "p");
  requireDegree(options.degree_q, "q");
  requireDegree(options.degree_e1, "e1");
  requireDegree(options.degree_e2, "e2");
  if (!(options.smallest_alpha > 0 && options.smallest_alpha <= 1))
    refuse("smallest_alpha is " + std::to_string(options.smallest_alpha) + ": 0 to 1 is needed");
  if (options.max_iterations < 0)
    refuse("max_iterations is " + std::to_string(options.max_iterations) + ": it must not be negative");
}

Degrees degreesOf(const NearestOptions& options, bool rational) {
  const bool second = options.order == 2;
  return {options.degree_alpha,
          options.degree_beta,
          rational ? options.degree_e1 : -1,
          second ? options.degree_p : -1,
          second ? options.degree_q : -1,
          second && rational ? options.degree_e2 : -1};
}

std::vector<double> innerKnots(const SeamRows& rows) {
  std::vector<double> knots(rows.knots.begin() + rows.degree + 1, rows.knots.end() - rows.degree - 1);
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  return knots;
}

/// Columns span the polynomials of that degree that vanish at the places.
Eigen::MatrixXd vanishingAt(const std::vector<double>& places, int degree) {
  if (places.empty()) return Eigen::MatrixXd::Identity(degree + 1, degree + 1);
  if (std::ssize(places) > degree) return {degree + 1, 0};
  Eigen::MatrixXd values(std::ssize(places), degree + 1);
  for (Eigen::Index i = 0; i < values.rows(); ++i)
    values.row(i) = bernsteinValues(degree, places[i]).transpose();
  return values.fullPivLu().kernel();
}

Family familyOf(const Degrees& degrees, std::vector<double> vanishing) {
  Family family{degrees, std::move(vanishing), {}, {}};
  const auto offset = offsets(degrees);
  for (int f = 0; f < function_count; ++f) {
    if (degrees[f] < 0) continue;
    const bool bound = f == Beta || f == Q;
    const Eigen::MatrixXd part = vanishingAt(bound ? family.vanishing : std::vector<double>{}, degrees[f]);
    const Eigen::Index columns = family.basis.cols();
    family.basis.conservativeResizeLike(Eigen::MatrixXd::Zero(offset.back(), columns + part.cols()));
    family.basis.block(offset[f], columns, part.rows(), part.cols()) = part;
  }
  return family;
}

/// The functional that is the jump at a knot of the k-th derivative of a row of poles.
Eigen::RowVectorXd jumpAt(const SeamRows& rows, double knot, int k) {
  const auto above = std::upper_bound(rows.knots.begin(), rows.knots.end(), knot);
  const auto below = std::lower_bound(rows.knots.begin(), rows.knots.end(), knot);
  const int right = static_cast<int>(above - rows.knots.begin()) - 1;
  const int left = static_cast<int>(below - rows.knots.begin()) - 1;
  Eigen::RowVectorXd jump = Eigen::RowVectorXd::Zero(rows.count);
  jump.segment(right - rows.degree, rows.degree + 1) +=
      bspline::basisDerivatives(rows.degree, rows.knots, right, knot, k).row(k);
  jump.segment(left - rows.degree, rows.degree + 1) -=
      bspline::basisDerivatives(rows.degree, rows.knots, left, knot, k).row(k);
  return jump;
}

/// The inner knots at which the seam (for order 2 also the row behind it) is no smoother than its knots make it, so that beta is not free.
std::vector<double> roughKnots(const Unknowns& u, int order) {
  constexpr double smooth = 1e-11;
  std::vector<double> rough;
  for (const double knot : innerKnots(u.a)) {
    const int r = u.a.degree - static_cast<int>(std::ranges::count(u.a.knots, knot));
    bool is_smooth = true;
    for (int block = 0; block < (order == 2 ? 2 : 1); ++block)
      for (int k = r + 1; k <= r + order - block; ++k) {
        const auto row = u.target.middleRows(static_cast<Eigen::Index>(block) * u.count(), u.count());
        const Eigen::RowVectorXd jump = jumpAt(u.a, knot, k);
        const double size = jump.cwiseAbs() * row.rowwise().norm();
        is_smooth = is_smooth && (jump * row).norm() <= smooth * size;
      }
    if (!is_smooth) rough.push_back(knot);
  }
  return rough;
}

bool seamMoves(const Unknowns& u) {
  return (u.pull.head(u.count()).array() > 0).any();
}

std::vector<Family> familiesOf(const Unknowns& u, const NearestOptions& options) {
  const Degrees asked = degreesOf(options, u.rational);
  Degrees natural = asked;
  for (int f = 0; f < function_count; ++f) natural[f] = std::min(asked[f], f == Beta || f == Q ? 1 : 0);
  const std::vector<double> rough = roughKnots(u, options.order);
  std::vector<Family> families = {familyOf(asked, rough)};
  if (asked != natural) families.push_back(familyOf(natural, rough));
  if (!rough.empty() && seamMoves(u)) families.push_back(familyOf(natural, {}));
  return families;
}

/// The degrees with which the join may hold already.
std::vector<Family> familiesThatMayHold(const NearestOptions& options, bool rational) {
  std::vector<Family> families = {familyOf(degreesOf(options, rational), {})};
  for (int k = 0; k <= 2; ++k) {
    NearestOptions further = options;
    further.degree_alpha = further.degree_e1 = k;
    further.degree_beta = k + 1;
    further.degree_p = further.degree_e2 = 2 * k;
    further.degree_q = 2 * k + 1;
    families.push_back(familyOf(degreesOf(further, rational), {}));
  }
  return families;
}

Family heldFamily(const Connection& held, const NearestOptions& options, bool rational) {
  const auto isConstant = [](const Eigen::VectorXd& f, double value) {
    return f.size() > 0 && (f.array() == value).all();
  };
  if (!isConstant(held.e0, 1)) refuse("e0 of a held connection must be 1");
  if (!rational && (!isConstant(held.e1, 0) || !isConstant(held.e2, 0)))
    refuse("e1 and e2 of a held connection must be 0 unless a surface is rational");
  const std::array<const Eigen::VectorXd*, function_count> functions = {&held.alpha, &held.beta, &held.e1,
                                                                        &held.p,     &held.q,    &held.e2};
  static constexpr std::array names = {"alpha", "beta", "e1", "p", "q", "e2"};
  NearestOptions of_held = options;
  const std::array<int*, function_count> degrees = {&of_held.degree_alpha, &of_held.degree_beta,
                                                    &of_held.degree_e1,    &of_held.degree_p,
                                                    &of_held.degree_q,     &of_held.degree_e2};
  for (int f = 0; f < function_count; ++f) {
    *degrees[f] = static_cast<int>(functions[f]->size()) - 1;
    requireDegree(*degrees[f], names[f]);
    if (!functions[f]->allFinite()) refuse(std::string(names[f]) + " of the held connection is not finite");
  }
  for (Eigen::Index i = 0; i < held.alpha.size(); ++i)
    if (!(held.alpha(i) > 0))
      refuse("coefficient " + std::to_string(i) + " of alpha is " + std::to_string(held.alpha(i)) +
             ": it must be positive");
  Family family{degreesOf(of_held, rational), {}, {}, {}};
  const auto offset = offsets(family.degrees);
  family.held.resize(offset.back());
  family.basis.resize(offset.back(), 0);
  for (int f = 0; f < function_count; ++f)
    if (family.degrees[f] >= 0) family.held.segment(offset[f], family.degrees[f] + 1) = *functions[f];
  return family;
}

Connection connectionOf(const Unknowns& u, const Degrees& degrees, const Eigen::VectorXd& c) {
  const auto offset = offsets(degrees);
  const auto part = [&](Function f) -> Eigen::VectorXd {
    if (degrees[f] < 0) return Eigen::VectorXd::Zero(1);
    return c.segment(offset[f], degrees[f] + 1);
  };
  Connection connection;
  connection.alpha = part(Alpha);
  connection.beta = part(Beta);
  connection.p = part(P);
  connection.q = part(Q);
  connection.e0 = Eigen::VectorXd::Constant(1, u.scale_b);
  connection.e1 = u.scale_b * part(E1);
  connection.e2 = u.scale_b * part(E2);
  return connection;
}

void requireSize(const Unknowns& u, int order) {
  // Rows are at most as many as the poles times the degrees that the condition may add.
  const double poles = static_cast<double>(u.blocks()) * u.count();
  const double entries =
      poles * order * (u.count() + static_cast<double>(order * std::ssize(innerKnots(u.a))));
  if (entries > max_entries)
    refuse("the seam has " + std::to_string(u.count()) + " poles: the matrix of the join would have " +
           std::to_string(static_cast<long>(entries)) + " entries, more than " +
           std::to_string(static_cast<long>(max_entries)));
}

/// A join for the unknowns as they are, if there is one of that family.
bool alreadyJoined(const Unknowns& u, const NearestOptions& options, const Family& family,
                   NearestJoin& result) {
  const Condition condition(u, options.order, family.degrees, {});
  const double rounding = 32 * std::numeric_limits<double>::epsilon() * u.largest;
  Eigen::VectorXd c = family.held;
  if (family.basis.cols() > 0) c = condition.fitted(u.target, family.basis, 0);
  const Eigen::VectorXd alpha = c.head(family.degrees[Alpha] + 1);
  const bool joined = alpha.minCoeff() > 0 && u.seam_gap <= rounding && u.seam_cost <= rounding * rounding &&
                      holds(condition.matrix(c), u.target, u.largest);
  if (!joined) return false;
  result.status = NearestStatus::Unchanged;
  result.connection = connectionOf(u, family.degrees, c);
  result.residual =
      (condition.matrix(c) * u.target).rowwise().norm().maxCoeff() / condition.largestDerivative(u.target);
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
  if (!(speeds[0] > 0 && speeds[1] > 0))
    refuse("surface " + std::string(speeds[0] > 0 ? "b" : "a") + " has no extent across the seam");
  const double smallest_alpha = options.smallest_alpha * speeds[1] / speeds[0];
  Candidate result{family, solve(u, condition, family, smallest_alpha, options.max_iterations), 0};
  const Solution& s = result.solution;
  result.residual =
      (condition.matrix(s.c) * s.x).rowwise().norm().maxCoeff() / condition.largestDerivative(s.x);
  return result;
}

bool better(const Candidate& one, const Candidate& other) {
  if (one.solution.exact != other.solution.exact) return one.solution.exact;
  return one.solution.exact ? one.solution.cost < other.solution.cost : one.residual < other.residual;
}

}  // namespace

NearestJoin nearestJoin(const JoinSide& a, const JoinSide& b, const NearestOptions& options) {
  requireOptions(options);
  const Unknowns u = unknowns(a, b, options.order);
  requireSize(u, options.order);
  std::vector<Family> given;
  if (options.held) given = {heldFamily(*options.held, options, u.rational)};

  NearestJoin result;
  result.a = a.surface;
  result.b = b.surface;
  for (const Family& family : options.held ? given : familiesThatMayHold(options, u.rational))
    if (alreadyJoined(u, options, family, result)) return result;

  std::optional<Candidate> best;
  for (const Family& family : options.held ? given : familiesOf(u, options)) {
    Candidate next = candidate(u, options, family);
    if (!best || better(next, *best)) best = std::move(next);
  }
  const Solution& solution = best->solution;
  result.connection = connectionOf(u, best->family.degrees, solution.c);
  result.residual = std::max(best->residual, u.seam_gap / u.size);
  result.iterations = solution.iterations;
  const double rounding = 32 * std::numeric_limits<double>::epsilon() * u.largest;
  if (!solution.exact || u.seam_gap > rounding) return result;
  place(u, solution.x, a, b, result);
  result.cost = solution.cost + u.seam_cost;
  result.stationarity = solution.stationarity;
  result.status = solution.stationary ? NearestStatus::Joined : NearestStatus::NotConverged;
  return result;
}

}  // namespace seamwright
