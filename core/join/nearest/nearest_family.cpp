// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/join/checked_connection.hpp>
#include <seamwright/core/join/nearest/nearest_family.hpp>
#include <seamwright/core/linear/dense.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::nearest {

namespace {

/// A limit of the interface, as a choice: higher degrees add unknowns to the search of the join.
constexpr int max_connection_degree = 6;

/// Functions of a higher order, and those of rational surfaces without need, are zero.
Degrees limited(Degrees degrees, int order, bool rational) {
  for (int f = 0; f < function_count; ++f)
    if (orderOf(f) > order || (isScaling(f) && !rational)) degrees[f] = -1;
  return degrees;
}

Degrees degreesOf(const NearestOptions& o, bool rational) {
  return limited({o.degree_alpha, o.degree_beta, o.degree_e1, o.degree_p, o.degree_q, o.degree_e2,
                  o.degree_h, o.degree_k, o.degree_e3},
                 o.order, rational);
}

/// Columns that span the polynomials of that degree that vanish at the given parameters.
Eigen::MatrixXd vanishingAt(const std::vector<double>& parameters, int degree) {
  if (parameters.empty()) return Eigen::MatrixXd::Identity(degree + 1, degree + 1);
  if (std::ssize(parameters) > degree) return {degree + 1, 0};
  Eigen::MatrixXd values(std::ssize(parameters), degree + 1);
  for (Eigen::Index i = 0; i < values.rows(); ++i)
    values.row(i) = bernsteinValues(degree, parameters[i]).transpose();
  return linear::kernel(values);
}

/// An end of the seam at which the poles of all rows stay, the cross-boundary derivatives of both
/// sides are parallel, and the seam's tangent may turn. There beta is 0, because a nonzero beta
/// would turn the tangent into the direction of these derivatives.
struct HeldEnd {
  double t = 0;
  int order = 0;  ///< up to which the conditions hold their functions
  std::array<double, function_count> value{};
};

/// The derivatives of both sides across the seam at one of its ends.
class EndFields {
 public:
  EndFields(const Unknowns& unknowns, double t)
      : u_(unknowns), pole_(t == 0 ? 0 : unknowns.count() - 1) {}

  Eigen::VectorXd of(Field field) const {
    switch (field) {
      case FieldP:
        return u_.target.row(pole_).transpose();
      case FieldPs:
        return -derivative(u_.a, 0, 1);
      case FieldPss:
        return derivative(u_.a, 0, 2);
      case FieldPsss:
        return -derivative(u_.a, 0, 3);
      case FieldQs:
        return derivative(u_.b, u_.a.depth, 1);
      case FieldQss:
        return derivative(u_.b, u_.a.depth, 2);
      case FieldQsss:
        return derivative(u_.b, u_.a.depth, 3);
      default:  // has a factor beta, q or k, which are zero there
        return Eigen::VectorXd::Zero(u_.target.cols());
    }
  }

  /// Whether the pole of that row of each side stays.
  bool stays(int row) const {
    return (row > u_.a.depth || u_.move_weights(index(row)) == 0) &&
           (row > u_.b.depth || u_.move_weights(index(u_.a.depth + row)) == 0);
  }

 private:
  Eigen::Index index(int block) const {
    return static_cast<Eigen::Index>(block) * u_.count() + pole_;
  }
  Eigen::VectorXd derivative(const SeamRows& rows, int first_block, int k) const {
    Eigen::VectorXd sum = rows.across(k, 0) * u_.target.row(pole_).transpose();
    for (int row = 1; row <= rows.depth; ++row)
      sum += rows.across(k, row) * u_.target.row(index(first_block + row)).transpose();
    return sum;
  }

  const Unknowns& u_;
  int pole_;
};

/// Adds the values that the condition of the next order requires, if it can hold.
bool holdNext(const EndFields& fields, bool rational, HeldEnd& end) {
  // Sine. Derivatives of fixed poles have rounding of about 1e-14, and more for poles far from the
  // origin.
  constexpr double parallel = 1e-10;
  const int order = end.order + 1, first = functions_of_order * end.order;
  Eigen::MatrixXd span = fields.of(FieldPs);
  if (rational) {
    span.conservativeResize(Eigen::NoChange, 2);
    span.col(1) = fields.of(FieldP);
  }
  Eigen::VectorXd rest = Eigen::VectorXd::Zero(span.rows());
  double size = 0;
  for (const Term& term : termsOf(order)) {
    double factor = term.factor;
    for (const int function : term.functions)
      if (function >= 0) factor *= end.value[static_cast<std::size_t>(function)];
    const Eigen::VectorXd field = fields.of(term.field);
    rest += factor * field;
    if (factor != 0) size += field.norm();
  }
  const Eigen::VectorXd values = linear::LeastSquares(span).solve(rest);
  if ((span * values - rest).norm() > parallel * size) return false;
  end.value[static_cast<std::size_t>(first)] = values(0);
  if (rational) end.value[static_cast<std::size_t>(first + E1)] = values(1);
  end.order = order;
  return true;
}

std::optional<HeldEnd> heldEnd(const Unknowns& u, int order, double t) {
  const int pole = t == 0 ? 0 : u.count() - 1, neighbour = t == 0 ? 1 : u.count() - 2;
  const EndFields fields(u, t);
  if (u.move_weights(pole) > 0 || !fields.stays(1) || u.move_weights(neighbour) == 0)
    return std::nullopt;
  HeldEnd end{.t = t};
  if (!holdNext(fields, u.rational, end) || !(end.value[Alpha] > 0)) return std::nullopt;
  bool holds = true;
  while (holds && end.order < order && fields.stays(end.order + 1))
    holds = holdNext(fields, u.rational, end);
  return end;
}

/// The held ends; empty if a constant alpha (or p, h, e1, e2, e3) cannot satisfy both ends.
std::vector<HeldEnd> heldEnds(const Unknowns& u, const Degrees& degrees, int order) {
  std::vector<HeldEnd> ends;
  for (const double t : {0.0, 1.0})
    if (const auto end = heldEnd(u, order, t)) ends.push_back(*end);
  if (ends.size() < 2) return ends;
  for (std::size_t f = 0; f < function_count; ++f) {
    const bool counts = std::min(ends[0].order, ends[1].order) >= orderOf(static_cast<int>(f));
    const double difference = std::abs(ends[0].value[f] - ends[1].value[f]);
    // The values are quotients of fixed derivatives, so they differ by their rounding.
    if (counts && degrees[f] == 0 && difference > 1e-10 * (1 + std::abs(ends[0].value[f])))
      return {};
  }
  return ends;
}

Family familyOf(const Degrees& degrees, std::vector<double> vanishing,
                const std::vector<HeldEnd>& ends = {}) {
  Family family{degrees, std::move(vanishing), {}, {}};
  const auto offset = offsets(degrees);
  family.held = Eigen::VectorXd::Zero(offset.back());
  family.basis.resize(offset.back(), 0);
  const auto append = [&](int f, const Eigen::MatrixXd& part) {
    const Eigen::Index columns = family.basis.cols();
    family.basis.conservativeResizeLike(
        Eigen::MatrixXd::Zero(offset.back(), columns + part.cols()));
    family.basis.block(offset[f], columns, part.rows(), part.cols()) = part;
  };
  for (int f = 0; f < function_count; ++f) {
    if (degrees[f] < 0) continue;
    const bool vanishes = isAlong(f);
    std::vector<double> zeros = vanishes ? family.vanishing : std::vector<double>{};
    std::vector<int> open(degrees[f] + 1);  // coefficients that no end determines
    std::iota(open.begin(), open.end(), 0);
    for (const HeldEnd& end : ends) {
      if (end.order < orderOf(f)) continue;
      if (vanishes) {
        zeros.push_back(end.t);
        continue;
      }
      const int k = end.t == 0 ? 0 : degrees[f];
      family.held(offset[f] + k) = end.value[f];
      std::erase(open, k);
    }
    const Eigen::MatrixXd all = Eigen::MatrixXd::Identity(degrees[f] + 1, degrees[f] + 1);
    append(f, vanishes ? vanishingAt(zeros, degrees[f])
                       : Eigen::MatrixXd(all(Eigen::indexing::all, open)));
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

/// The inner knots at which the seam (for higher orders also the rows behind it) is no smoother
/// than its knots make it, so that beta is not free.
std::vector<double> roughKnots(const Unknowns& u, int order) {
  // Share of the terms of a jump. It is 1e5 roundings of a term: far more than knots leave that
  // were inserted.
  constexpr double smooth = 1e-11;
  std::vector<double> rough;
  for (const double knot : innerKnots(u.a)) {
    const int r = u.a.degree - static_cast<int>(std::ranges::count(u.a.knots, knot));
    bool is_smooth = true;
    for (int block = 0; block < std::min(order, 1 + u.a.depth); ++block)
      for (int k = r + 1; k <= r + order - block; ++k) {
        const auto row =
            u.target.middleRows(static_cast<Eigen::Index>(block) * u.count(), u.count());
        const Eigen::RowVectorXd jump = jumpAt(u.a, knot, k);
        const double size = jump.cwiseAbs() * row.rowwise().norm();
        is_smooth = is_smooth && (jump * row).norm() <= smooth * size;
      }
    if (!is_smooth) rough.push_back(knot);
  }
  return rough;
}

/// The least cost of making the seam smooth at these knots; nothing if fixed poles do not allow it.
std::optional<double> costOfSmoothing(const Unknowns& u, const std::vector<double>& knots) {
  Eigen::MatrixXd jumps(std::ssize(knots), u.count());
  for (Eigen::Index i = 0; i < jumps.rows(); ++i) {
    const auto multiplicity = static_cast<int>(std::ranges::count(u.a.knots, knots[i]));
    jumps.row(i) = jumpAt(u.a, knots[i], u.a.degree - multiplicity + 1);
    jumps.row(i).normalize();
  }
  const Eigen::ArrayXd weights = u.move_weights.head(u.count()).array();
  const Eigen::VectorXd reach = (weights > 0).select(weights.rsqrt(), 0.0);
  const Eigen::MatrixXd seam = u.target.topRows(u.count()),
                        jumps_of_moves = jumps * reach.asDiagonal();
  const Eigen::MatrixXd move = linear::LeastSquares(jumps_of_moves).solve(jumps * seam);
  constexpr double rounding = 1e-9;  // of least squares; a fixed pole leaves a jump as a whole
  if ((jumps_of_moves * move - jumps * seam).norm() > rounding * (jumps * seam).norm())
    return std::nullopt;
  return move.squaredNorm();
}

}  // namespace

void requireDegree(int degree, const char* name) {
  if (degree < 0 || degree > max_connection_degree)
    refuse("degree of " + std::string(name) + " is " + std::to_string(degree) + ": 0 to " +
           std::to_string(max_connection_degree) + " is needed");
}

std::vector<double> innerKnots(const SeamRows& rows) {
  std::vector<double> knots(rows.knots.begin() + rows.degree + 1,
                            rows.knots.end() - rows.degree - 1);
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  return knots;
}

std::vector<Family> familiesOf(const Unknowns& u, const NearestOptions& options) {
  const Degrees asked = degreesOf(options, u.rational);
  Degrees constant = asked, natural = asked;
  constant[Alpha] = 0;
  for (int f = 0; f < function_count; ++f) natural[f] = std::min(asked[f], isAlong(f) ? 1 : 0);
  const std::vector<double> rough = roughKnots(u, options.order);
  std::vector<Family> families;
  const auto add = [&](const Degrees& degrees) {
    families.push_back(familyOf(degrees, rough, heldEnds(u, degrees, options.order)));
  };
  add(asked);
  if (constant != asked) add(constant);
  if (natural != constant) add(natural);
  return families;
}

std::optional<Family> smoothFamily(const Unknowns& u, const Family& rough,
                                   const Solution& solution) {
  if (rough.vanishing.empty()) return std::nullopt;
  const std::optional<double> least = costOfSmoothing(u, rough.vanishing);
  if (!least || (solution.exact && *least >= solution.cost)) return std::nullopt;
  return familyOf(rough.degrees, {});
}

std::vector<Family> familiesThatMayHold(const NearestOptions& options, bool rational) {
  std::vector<Family> families = {familyOf(degreesOf(options, rational), {})};
  for (int k = 0; k <= 2; ++k) {
    NearestOptions further = options;
    further.degree_alpha = further.degree_e1 = k;
    further.degree_beta = k + 1;
    further.degree_p = further.degree_e2 = 2 * k;
    further.degree_q = 2 * k + 1;
    further.degree_h = further.degree_e3 = 3 * k;
    further.degree_k = 3 * k + 1;
    families.push_back(familyOf(degreesOf(further, rational), {}));
  }
  return families;
}

Family heldFamily(const ConnectionFunctions& held, const NearestOptions& options, bool rational) {
  if (!isConstant(held.e0, 1)) refuse("e0 of a held connection must be 1");
  if (!isConstant(held.gamma, 1)) refuse("gamma of a held connection must be 1");
  if (!rational && !(isConstant(held.e1, 0) && isConstant(held.e2, 0) && isConstant(held.e3, 0)))
    refuse("e1, e2 and e3 of a held connection must be 0 unless a surface is rational");
  const std::array<const Eigen::VectorXd*, function_count> functions = {
      &held.alpha, &held.beta, &held.e1, &held.p, &held.q, &held.e2, &held.h, &held.k, &held.e3};
  static constexpr std::array names = {"alpha", "beta", "e1", "p", "q", "e2", "h", "k", "e3"};
  Degrees degrees{};
  for (int f = 0; f < function_count; ++f) {
    degrees[f] = static_cast<int>(functions[f]->size()) - 1;
    requireDegree(degrees[f], names[f]);
    if (!functions[f]->allFinite())
      refuse(std::string(names[f]) + " of the held connection is not finite");
  }
  for (Eigen::Index i = 0; i < held.alpha.size(); ++i)
    if (!(held.alpha(i) > 0))
      refuse("coefficient " + std::to_string(i) + " of alpha is " + std::to_string(held.alpha(i)) +
             ": it must be positive");
  Family family{limited(degrees, options.order, rational), {}, {}, {}};
  const auto offset = offsets(family.degrees);
  family.held.resize(offset.back());
  family.basis.resize(offset.back(), 0);
  for (int f = 0; f < function_count; ++f)
    if (family.degrees[f] >= 0)
      family.held.segment(offset[f], family.degrees[f] + 1) = *functions[f];
  return family;
}

ConnectionFunctions connectionOf(const Unknowns& u, const Degrees& degrees,
                                 const Eigen::VectorXd& c) {
  const auto offset = offsets(degrees);
  const auto part = [&](Function f) -> Eigen::VectorXd {
    if (degrees[f] < 0) return Eigen::VectorXd::Zero(1);
    return c.segment(offset[f], degrees[f] + 1);
  };
  ConnectionFunctions connection;
  connection.alpha = part(Alpha);
  connection.beta = part(Beta);
  connection.p = part(P);
  connection.q = part(Q);
  connection.h = part(H);
  connection.k = part(K);
  connection.e0 = Eigen::VectorXd::Constant(1, u.scale_b);
  connection.e1 = u.scale_b * part(E1);
  connection.e2 = u.scale_b * part(E2);
  connection.e3 = u.scale_b * part(E3);
  return connection;
}

}  // namespace seamwright::nearest
