// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cmath>
#include <seamwright/core/join/condition/composition.hpp>
#include <seamwright/core/join/condition/condition.hpp>
#include <seamwright/core/join/condition/connection.hpp>
#include <seamwright/core/join/normalized.hpp>
#include <seamwright/core/linear/dense.hpp>
#include <seamwright/core/numeric.hpp>
#include <vector>

namespace seamwright {

namespace {

using bernstein::text;
using rows::Field;

/// Bound of the relative rounding of a fit: products and sums of some hundred coefficients, and an
/// orthogonal solution, which adds a few units for each unknown. A choice above all of them: what
/// is less counts as rounding.
constexpr double fit_roundings = 256;

/// A term factor(t) field(t) with an unknown factor of that degree.
struct Unknown {
  Field<4> field;
  int degree;
};

struct FieldFit {
  std::vector<Eigen::VectorXd> factors;
  /// Largest remaining coefficient, relative to the right side, the terms and the given size.
  double residual = 0;
  double condition = 0;
};

/// A field in that degree as one column.
Eigen::VectorXd column(const Field<4>& field, int degree) {
  return rows::elevated<4>(field, degree).reshaped();
}

/// Solves by least squares. Columns are scaled to length 1, so units and speeds do not influence
/// the condition.
/// \param size lower bound of the size that residuals are relative to. So a right side that is only
/// rounding is not taken as significant.
FieldFit solve(const std::vector<Unknown>& unknowns, const Field<4>& right, double size) {
  int degree = rows::degree(right);
  Eigen::Index count = 0;
  for (const Unknown& term : unknowns) {
    degree = std::max(degree, rows::degree(term.field) + term.degree);
    count += term.degree + 1;
  }
  Eigen::MatrixXd matrix(4 * (degree + 1), count);
  Eigen::Index next = 0;
  size = std::max(size, rows::size(right));
  for (const Unknown& term : unknowns)
    for (int i = 0; i <= term.degree; ++i)
      matrix.col(next++) =
          column(rows::product<4>(Eigen::VectorXd::Unit(term.degree + 1, i), term.field), degree);
  const Eigen::VectorXd lengths =
      matrix.colwise().norm().cwiseMax(std::numeric_limits<double>::min()).transpose();
  const linear::PivotedQr qr(matrix * lengths.cwiseInverse().asDiagonal());
  const Eigen::VectorXd wanted = column(right, degree);
  const Eigen::VectorXd scaled = qr.solve(wanted);
  const auto diagonal = qr.matrixQR().diagonal().cwiseAbs();
  const Eigen::VectorXd solution = scaled.cwiseQuotient(lengths);

  FieldFit result;
  result.condition = diagonal.minCoeff() > 0 ? diagonal.maxCoeff() / diagonal.minCoeff()
                                             : std::numeric_limits<double>::infinity();
  next = 0;
  for (const Unknown& term : unknowns) {
    result.factors.emplace_back(solution.segment(next, term.degree + 1));
    next += term.degree + 1;
    size = std::max(size, result.factors.back().cwiseAbs().maxCoeff() * rows::size(term.field));
  }
  const double rest = (matrix * solution - wanted).cwiseAbs().maxCoeff();
  result.residual = size > 0 ? rest / size : 0;
  return result;
}

void requireConnectionDegree(const char* name, const std::optional<int>& degree) {
  if (degree && (*degree < 0 || *degree > 30))
    throw std::invalid_argument(std::string("degree of ") + name + " is " +
                                std::to_string(*degree) + ": it must be within 0 to 30");
}

bool isPolynomial(const Ribbon& ribbon) {
  return rows::trimmed(ribbon.position.col(3)).size() == 1;
}

/// The steps of the fit. Each step needs the previous ones.
class Recognition {
 public:
  Recognition(const Ribbon& a, const Ribbon& b, const ConnectionFitOptions& options,
              double roundings = 1)
      : pair_(a, b, roundings),
        options_(options),
        polynomial_(isPolynomial(a) && isPolynomial(b)),
        P_t_(rows::derivative<4>(pair_.a.position)) {
    const double m = std::max(pair_.a.degree_across, pair_.b.degree_across);
    const double sizes =
        std::min({rows::size(pair_.a.first), rows::size(pair_.b.first), rows::size(P_t_)});
    noise_first_ =
        fit_roundings * machine_epsilon +
        (sizes > 0 ? 64 * pair_.rounding * std::max<double>(m, pair_.a.degree()) / sizes : 0);
  }

  ConnectionFit run() {
    fit_.found = scale() && tangents() && (options_.order < 2 || curvatures()) &&
                 (options_.order < 3 || curvatureChanges());
    return fit_;
  }

 private:
  double tolerance(double noise) {
    fit_.noise = std::max(fit_.noise, noise);
    return options_.tolerance.value_or(noise);
  }

  /// Tries (first, second) degrees, given or ascending. Keeps the first pair within the tolerance,
  /// or the best one.
  template <class Try>
  bool ascend(const std::optional<int>& first, const std::optional<int>& second, int last,
              double allowed, const char* names, const Try& attempt) {
    if (!options_.tolerance && fit_.noise > kLargestNoise) {
      fit_.note = "rounding of the poles makes up to " + text(fit_.noise) +
                  " of a residual of 0: " + names + " cannot be decided";
      return false;
    }
    double best = std::numeric_limits<double>::infinity();
    const bool given = first || second;
    for (int k = 0; k <= (given ? 0 : last); ++k) {
      const int degree = first.value_or(second ? std::max(*second - 1, 0) : k);
      const FieldFit solution = attempt(degree, second.value_or(degree + 1), best);
      fit_.condition = std::max(fit_.condition, solution.condition);
      if (!(solution.condition <= options_.largest_condition)) {
        fit_.note = std::string("the equations for ") + names + " have condition " +
                    text(solution.condition) + ", above " + text(options_.largest_condition);
        return false;
      }
      best = std::min(best, solution.residual);
      if (solution.residual <= allowed) break;
    }
    fit_.residual = std::max(fit_.residual, best);
    return best <= allowed;
  }

  bool scale() {
    const HomogeneousPoles &P = pair_.a.position, &Q = pair_.b.position;
    const double allowed = tolerance(fit_roundings * (machine_epsilon + pair_.rounding) *
                                     (rows::degree(P) + rows::degree(Q) + 2));
    const int last = polynomial_ ? 0 : std::max(rows::degree(Q) - rows::degree(P), 0) + 3;
    const bool found =
        ascend(std::nullopt, std::nullopt, last, allowed, "e0", [&](int degree, int, double best) {
          FieldFit solution = solve({{P, degree}}, Q, 0);
          if (solution.residual < best) fit_.connection.e0 = solution.factors[0];
          return solution;
        });
    if (!found && fit_.note.empty())
      fit_.note = "the edges do not coincide: they are met to " + text(fit_.residual) +
                  ", not to " + text(allowed) + ", by weights of degree up to " +
                  std::to_string(last);
    return found;
  }

  bool tangents() {
    ConnectionFunctions& c = fit_.connection;
    const Field<4> out = rows::product<4>(c.e0, pair_.a.first),
                   along = rows::product<4>(c.e0, P_t_);
    const int last = std::max(rows::degree(pair_.b.first) - rows::degree(out), 0) + 2;
    const bool found =
        ascend(options_.alpha_degree, options_.beta_degree, last, tolerance(noise_first_),
               "alpha and beta", [&](int degree, int other, double best) {
                 std::vector<Unknown> unknowns = {{out, degree}, {along, other}};
                 if (!polynomial_)
                   unknowns.push_back({pair_.a.position, degree + rows::degree(c.e0)});
                 FieldFit solution = solve(unknowns, pair_.b.first, 0);
                 if (solution.residual < best) {
                   c.alpha = solution.factors[0];
                   c.beta = solution.factors[1];
                   if (!polynomial_) c.e1 = solution.factors[2];
                 }
                 return solution;
               });
    if (!found && fit_.note.empty()) fit_.note = whyNoTangents(last);
    if (!found || !rows::notPositiveAt(BernsteinPolynomial(c.alpha))) return found;
    fit_.note = "alpha is not positive everywhere: the join is " + std::string(name(verdict()));
    return false;
  }

  JoinVerdict verdict() const {
    return joinCondition(pair_.a, pair_.b, {options_.tolerance, std::nullopt}).verdict;
  }

  std::string whyNoTangents(int last) const {
    if (verdict() != JoinVerdict::G1) return "the join is " + std::string(name(verdict()));
    if (options_.alpha_degree || options_.beta_degree)
      return "the join is G1, but alpha and beta are not polynomials of these degrees";
    return "the join is G1, but alpha and beta are not polynomials of degrees up to " +
           std::to_string(last) + " and " + std::to_string(last + 1);
  }

  /// The functions that the derivative of an order above 1 adds.
  struct Added {
    int order;
    Eigen::VectorXd ConnectionFunctions::*out;    ///< factor of P_s
    Eigen::VectorXd ConnectionFunctions::*along;  ///< factor of P_t
    Eigen::VectorXd ConnectionFunctions::*scale;  ///< factor of P, of rational sides
    std::optional<int> out_degree, along_degree;
    const char* names;
  };

  bool curvatures() {
    return added({.order = 2,
                  .out = &ConnectionFunctions::p,
                  .along = &ConnectionFunctions::q,
                  .scale = &ConnectionFunctions::e2,
                  .out_degree = options_.p_degree,
                  .along_degree = options_.q_degree,
                  .names = "p and q"});
  }

  bool curvatureChanges() {
    return added({.order = 3,
                  .out = &ConnectionFunctions::h,
                  .along = &ConnectionFunctions::k,
                  .scale = &ConnectionFunctions::e3,
                  .out_degree = options_.h_degree,
                  .along_degree = options_.k_degree,
                  .names = "h and k"});
  }

  bool added(const Added& functions) {
    ConnectionFunctions& c = fit_.connection;
    const auto order = static_cast<std::size_t>(functions.order);
    const std::vector<Field<4>> composed = composedDerivatives(pair_.a, c, functions.order);
    const Field<4>&given = *pair_.b.parts()[order], &P_s = pair_.a.first;
    const Field<4> rest = rows::sum<4>(given, -scaledDerivative(composed, c, functions.order));
    const Field<4> out = rows::product<4>(c.e0, P_s), along = rows::product<4>(c.e0, P_t_);
    const int last = std::max(rows::degree(rest) - rows::degree(out), 0) + 2;
    const double m = std::max({pair_.a.degree_across, pair_.b.degree_across, pair_.a.degree()});
    const double terms =
        rows::size(given) + rows::size(composed[order]) + rows::size(P_s) + rows::size(P_t_);
    const double size = std::max(rows::size(rest), std::min(rows::size(P_s), rows::size(P_t_)));
    const double before = fit_.noise;  // of the functions found so far
    const double allowed = tolerance(before + (64 * std::pow(m, functions.order) * pair_.rounding +
                                               (fit_roundings * machine_epsilon + before) * terms) /
                                                  size);
    const bool found =
        ascend(functions.out_degree, functions.along_degree, last, allowed, functions.names,
               [&](int degree, int other, double best) {
                 std::vector<Unknown> unknowns = {{out, degree}, {along, other}};
                 if (!polynomial_)
                   unknowns.push_back({pair_.a.position, degree + rows::degree(c.e0)});
                 FieldFit solution = solve(unknowns, rest, size);
                 if (solution.residual < best) {
                   c.*functions.out = solution.factors[0];
                   c.*functions.along = solution.factors[1];
                   if (!polynomial_) c.*functions.scale = solution.factors[2];
                 }
                 return solution;
               });
    if (!found && fit_.note.empty())
      fit_.note = fmt::format(
          "the join is G{} with the functions found, but not G{} with {} of degrees up to {} and "
          "{}",
          order - 1, order, functions.names, last, last + 1);
    return found;
  }

  NormalizedPair pair_;
  ConnectionFitOptions options_;
  bool polynomial_;
  Field<4> P_t_;
  double noise_first_ = 0;
  ConnectionFit fit_;
};

}  // namespace

ConnectionFit fitConnection(const Ribbon& a, const Ribbon& b, const ConnectionFitOptions& options) {
  if (options.order < 1 || options.order > 3)
    throw std::invalid_argument("order " + std::to_string(options.order) +
                                ": known are 1, 2 and 3");
  requireTolerance(options.tolerance);
  requireConnectionDegree("alpha", options.alpha_degree);
  requireConnectionDegree("beta", options.beta_degree);
  requireConnectionDegree("p", options.p_degree);
  requireConnectionDegree("q", options.q_degree);
  requireConnectionDegree("h", options.h_degree);
  requireConnectionDegree("k", options.k_degree);
  ConnectionFit same = Recognition(a, b, options).run();
  if (same.found) return same;
  const std::optional<CommonParameter> common = commonParameter(a, b);
  if (!common) return same;
  ConnectionFit moved = Recognition(common->a, common->b, options, common->roundings).run();
  moved.parameter = common->map;
  moved.parameter_of_a = common->of_a;
  return moved;
}

}  // namespace seamwright
