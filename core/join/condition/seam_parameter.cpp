// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <seamwright/core/join/condition/seam_parameter.hpp>
#include <seamwright/core/linear/dense.hpp>
#include <seamwright/core/numeric.hpp>
#include <utility>
#include <vector>

namespace seamwright {

namespace {

using rows::Field;

constexpr int highest_degree = 30;  ///< of a ribbon that a condition is computed of

double valueAt(const Eigen::VectorXd& polynomial, double t) {
  return bernstein::casteljau(polynomial, bernstein::Step::at(t)).first.bottomRows<1>().value();
}

/// The point of a seam and its derivative.
struct SeamPoint {
  Eigen::Vector3d at, along;
};

SeamPoint pointOf(const HomogeneousPoles& seam, double t) {
  const bernstein::Step step = bernstein::Step::at(t);
  const Eigen::RowVector4d p = bernstein::casteljau(Field<4>(seam), step).first.bottomRows<1>();
  const Eigen::RowVector4d d =
      bernstein::casteljau(rows::derivative<4>(seam), step).first.bottomRows<1>();
  const Eigen::Vector3d at = p.head<3>().transpose() / p[3];
  return {at, (d.head<3>().transpose() - d[3] * at) / p[3]};
}

/// Corresponding parameters: of the one seam, increasing, and equally spaced ones of the other.
struct MatchedParameters {
  std::vector<double> of, at;
  double error = 0;  ///< of the former, by rounding
};

/// Corresponding parameters of the same curve. Nothing: the curves differ.
std::optional<MatchedParameters> corresponding(const HomogeneousPoles& of,
                                               const HomogeneousPoles& at, double rounding_mm) {
  // More than the unknowns of a map.
  constexpr int points = 64, most_steps = 40;
  MatchedParameters found;
  double last = 0, slowest = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= points; ++k) {
    const double t = static_cast<double>(k) / points;
    const Eigen::Vector3d wanted = pointOf(at, t).at;
    double tau = k == 0 ? 0 : k == points ? 1 : last;
    for (int step = 0; step < most_steps && k > 0 && k < points; ++step) {
      const SeamPoint here = pointOf(of, tau);
      const double speed = here.along.squaredNorm();
      if (!(speed > 0)) return std::nullopt;
      const double next = std::clamp(tau + here.along.dot(wanted - here.at) / speed, 0.0, 1.0);
      const double moved = std::abs(next - tau);
      tau = next;
      if (moved <= machine_epsilon) break;
    }
    const SeamPoint there = pointOf(of, tau);
    if (!((there.at - wanted).norm() <= rounding_mm) || (k > 0 && !(tau > last)))
      return std::nullopt;
    slowest = std::min(slowest, there.along.norm());
    found.of.push_back(tau);
    found.at.push_back(t);
    last = tau;
  }
  if (!(slowest > 0)) return std::nullopt;
  found.error = rounding_mm / slowest;
  return found;
}

/// The quotient of that degree nearest to the pairs, with ends 0 and 1.
SeamParameter quotientOf(const MatchedParameters& pairs, int degree, bool is_quotient) {
  const auto count = static_cast<Eigen::Index>(pairs.of.size());
  const int inner = degree - 1, below = is_quotient ? degree : 0;
  // Unknowns: the inner coefficients of the numerator, and all but the first of the denominator;
  // the last ones of both are the same.
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, std::max(inner + below, 1));
  Eigen::VectorXd right(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const double tau = pairs.of[k], t = pairs.at[k];
    const auto basis = [&](int i) {
      return bernstein::binomials(degree)(i) * std::pow(t, i) * std::pow(1 - t, degree - i);
    };
    for (int i = 1; i < degree; ++i) matrix(k, i - 1) = basis(i);
    if (is_quotient) {
      for (int i = 1; i <= degree; ++i) matrix(k, inner + i - 1) = -tau * basis(i);
      matrix(k, inner + degree - 1) += basis(degree);
      right(k) = tau * basis(0);
    } else {
      right(k) = tau - basis(degree);
    }
  }
  SeamParameter map{Eigen::VectorXd::Zero(degree + 1), Eigen::VectorXd::Ones(degree + 1)};
  map.numerator(degree) = 1;
  if (inner + below == 0) return map;
  const Eigen::VectorXd solution = linear::PivotedQr(matrix).solve(right);
  map.numerator.segment(1, inner) = solution.head(inner);
  if (!is_quotient) return map;
  map.denominator.tail(degree) = solution.tail(degree);
  map.numerator(degree) = map.denominator(degree);
  return map;
}

/// The map of the pairs with the lowest degree that fits them to rounding.
std::optional<SeamParameter> mapOf(const MatchedParameters& pairs, int degree_of_seam,
                                   bool may_be_quotient) {
  constexpr int most = 6;
  // Of an error of a point: a fit of exact values adds a few roundings to it.
  const double allowed = 8 * (pairs.error + machine_epsilon);
  for (int degree = 1; degree <= most && degree * degree_of_seam <= highest_degree; ++degree)
    for (const bool is_quotient : {false, true}) {
      if (is_quotient && !may_be_quotient) continue;
      SeamParameter map = quotientOf(pairs, degree, is_quotient);
      if (!map.numerator.allFinite() || !(map.denominator.minCoeff() > 0)) continue;
      double worst = 0;
      for (std::size_t k = 0; k < pairs.of.size(); ++k)
        worst = std::max(worst, std::abs(map.at(pairs.at[k]) - pairs.of[k]));
      if (!(worst <= allowed)) continue;
      if (degree == 1 && !is_quotient) return std::nullopt;  // the same parameter
      // The fit is a mean over many pairs: nearer than the worst of them.
      map.error = worst + machine_epsilon;
      return map;
    }
  return std::nullopt;
}

std::optional<SeamParameter> mapBetween(const Ribbon& of, const Ribbon& at) {
  const double size = std::max(of.position.leftCols<3>().cwiseAbs().maxCoeff(),
                               at.position.leftCols<3>().cwiseAbs().maxCoeff());
  const double weight = std::min(of.position.col(3).minCoeff(), at.position.col(3).minCoeff());
  if (!(weight > 0)) return std::nullopt;
  const double rounding_mm = 16 * (of.degree() + at.degree() + 1) * machine_epsilon * size / weight;
  const bool is_rational = of.position.col(3).minCoeff() < of.position.col(3).maxCoeff() ||
                           at.position.col(3).minCoeff() < at.position.col(3).maxCoeff();
  const std::optional<MatchedParameters> pairs =
      corresponding(of.position, at.position, rounding_mm);
  return pairs ? mapOf(*pairs, of.degree(), is_rational) : std::nullopt;
}

/// A part over the map, by de Casteljau's steps (denominator - numerator) b_i + numerator b_(i+1),
/// times the denominator to the power of the degrees that it lacks.
HomogeneousPoles composed(const HomogeneousPoles& part, const SeamParameter& map, int degree) {
  const Eigen::VectorXd keep = map.denominator - map.numerator;
  std::vector<Field<4>> values;
  for (Eigen::Index i = 0; i < part.rows(); ++i) values.emplace_back(part.row(i));
  for (std::size_t left = values.size(); left > 1; --left) {
    for (std::size_t i = 0; i + 1 < left; ++i)
      values[i] =
          rows::product<4>(keep, values[i]) + rows::product<4>(map.numerator, values[i + 1]);
    --degree;
  }
  const bool is_polynomial = rows::trimmed(map.denominator).size() == 1;
  Field<4> result = values.front();
  for (; degree > 0 && !is_polynomial; --degree) result = rows::product<4>(map.denominator, result);
  return result;
}

/// The largest ratio of weights.
double unevenness(const CommonParameter& pair) {
  const auto ratio = [](const Ribbon& ribbon) {
    return ribbon.position.col(3).maxCoeff() / ribbon.position.col(3).minCoeff();
  };
  return std::max(ratio(pair.a), ratio(pair.b));
}

}  // namespace

double SeamParameter::at(double t) const {
  return valueAt(numerator, t) / valueAt(denominator, t);
}

Ribbon reparametrised(const Ribbon& ribbon, const SeamParameter& map) {
  Ribbon result = ribbon;
  const int degree = ribbon.degree();
  for (HomogeneousPoles* part : result.parts()) *part = composed(*part, map, degree);
  return result;
}

std::optional<CommonParameter> commonParameter(const Ribbon& a, const Ribbon& b) {
  std::optional<CommonParameter> best;
  for (const bool of_a : {true, false}) {
    const Ribbon &of = of_a ? a : b, &at = of_a ? b : a;
    const std::optional<SeamParameter> map = mapBetween(of, at);
    if (!map) continue;
    const Ribbon changed = reparametrised(of, *map);
    // Of a coefficient: those of the products, and the error of the map times the derivative.
    const double degree = of.degree();
    const double roundings = 2 * degree * static_cast<double>(map->numerator.size()) +
                             2 * degree * map->error / machine_epsilon;
    CommonParameter found{of_a ? changed : a, of_a ? b : changed, roundings, *map, of_a};
    // Conditions hold powers of the weights. A polynomial may be near enough to an inverse of one.
    const auto cost = [](const CommonParameter& pair) {
      return std::pair(unevenness(pair), pair.map.numerator.size());
    };
    if (!best || cost(found) < cost(*best)) best = std::move(found);
  }
  return best;
}

}  // namespace seamwright
