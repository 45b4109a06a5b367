// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <numbers>
#include <seamwright/core/join/checked_connection.hpp>
#include <seamwright/core/join/condition/condition.hpp>
#include <seamwright/core/join/condition/point_derivatives.hpp>
#include <seamwright/core/join/normalized.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using rows::Field;
using rows::Sum;
using rows::times;

/// A condition in the units of NormalizedPair.
struct Polynomials {
  Eigen::VectorXd coefficients;
  double scale = 0;  ///< the product of the sizes of the fields
  double noise = 0;  ///< of a coefficient
  /// The scale that the condition has where no field happens to be small. Second derivatives, for
  /// example, vanish in bilinear patches; then 0 = 0 can be decided if the noise is small against
  /// first derivatives. 0: scale alone counts.
  double usual_scale = 0;
};

bool canBeTold(const Polynomials& condition) {
  return condition.scale == 0 ||
         condition.noise <= kLargestNoise * std::max(condition.scale, condition.usual_scale);
}

/// \param unit factor of the resulting coefficients.
JoinResidual residual(const Polynomials& condition, double unit, std::optional<double> tolerance) {
  JoinResidual result;
  Eigen::Index largest = 0;
  const double size = condition.coefficients.cwiseAbs().maxCoeff(&largest);
  const Eigen::Index degree = condition.coefficients.size() - 1;
  result.at = degree > 0 ? static_cast<double>(largest) / static_cast<double>(degree) : 0;
  result.relative = condition.scale > 0 ? size / condition.scale : 0;
  result.noise = condition.scale > 0 ? condition.noise / condition.scale : 0;
  result.holds = tolerance ? result.relative <= *tolerance
                           : result.relative <= result.noise && canBeTold(condition);
  result.coefficients = unit * condition.coefficients;
  return result;
}

/// f A - g B = 0 of vector-valued polynomials A, B, relative to the size of its larger term.
/// \param usual_size that of A and B where they do not happen to be small; 0: none is known.
JoinResidual agreement(const Eigen::VectorXd& f, const RoundedField<3>& a, const Eigen::VectorXd& g,
                       const RoundedField<3>& b, double usual_size, double length,
                       std::optional<double> tolerance) {
  const Field<3> difference = Sum<3>().add(f, b.field).add(-g, a.field).total();
  const double size_f = f.cwiseAbs().maxCoeff(), size_g = g.cwiseAbs().maxCoeff();
  const double scale = std::max(size_f * b.size(), size_g * a.size());
  const double noise =
      size_f * b.noise + size_g * a.noise + field_roundings * machine_epsilon * scale;
  return residual({.coefficients = difference.rowwise().norm(),
                   .scale = scale,
                   .noise = noise,
                   .usual_scale = usual_size * std::max(size_f, size_g)},
                  length, tolerance);
}

/// A lower bound of a polynomial on [0, 1], within a thousandth of its largest coefficient.
double lowest(const Eigen::VectorXd& p) {
  return BernsteinPolynomial(p).range(1e-3 * p.cwiseAbs().maxCoeff()).lower;
}

/// An upper bound of (|field| + noise) / divisor on [0, 1], within a tenth; infinite where the
/// divisor is not certain to be positive.
double largestQuotient(const Field<3>& field, double noise, const Eigen::VectorXd& divisor,
                       int halvings) {
  const double least = divisor.minCoeff(), first = divisor(0), last = divisor(divisor.size() - 1);
  if (!(first > 0 && last > 0)) return std::numeric_limits<double>::infinity();
  const double bound =
      least > 0 ? (rows::size(field) + noise) / least : std::numeric_limits<double>::infinity();
  const double reached = std::max((field.row(0).norm() + noise) / first,
                                  (field.bottomRows<1>().norm() + noise) / last);
  // A choice: a bound within a tenth of a value that occurs decides nearly every verdict.
  if (halvings == 0 || bound <= 1.1 * reached) return bound;
  const bernstein::Step half = bernstein::Step::at(0.5);
  const auto [left, right] = bernstein::casteljau(field, half);
  const auto [below, above] = bernstein::casteljau(divisor, half);
  return std::max(largestQuotient(left, noise, below, halvings - 1),
                  largestQuotient(right, noise, above, halvings - 1));
}

std::optional<double> notPositive(const Eigen::VectorXd& polynomial, double size,
                                  double noise = 0) {
  return rows::notPositiveAt(BernsteinPolynomial(
      polynomial / size, std::clamp(noise, field_roundings * machine_epsilon, 2.0)));
}

/// The polynomials that judge a join of tangent planes.
class TangentPlanes {
 public:
  TangentPlanes(const NormalizedPair& pair, const PointDerivatives& a, const PointDerivatives& b)
      : pair_(pair), a_(a), b_(b) {
    normal_a_ = rows::cross(a.s.field, a.t.field);
    normal_b_ = rows::cross(b.s.field, b.t.field);
    product_ = rows::dot<3>(normal_a_, normal_b_);
  }

  const Field<3>& normal() const { return normal_a_; }

  /// A parameter at which a side has no tangent plane, or only one within rounding.
  std::optional<double> singularAt() const {
    const double size_a = a_.s.size() * a_.t.size(), size_b = b_.s.size() * b_.t.size();
    if (!(size_a > 0 && size_b > 0)) return 0.0;
    const double least = std::pow(noise() / kLargestNoise, 2);
    if (const auto at = notPositive(rows::dot<3>(normal_a_, normal_a_), size_a * size_a, least))
      return at;
    return notPositive(rows::dot<3>(normal_b_, normal_b_), size_b * size_b, least);
  }

  JoinResidual condition(std::optional<double> tolerance) const {
    return a_.w.size() == 1 && b_.w.size() == 1 ? polynomialCondition(tolerance)
                                                : rationalCondition(tolerance);
  }

  /// tan of the angle is |N_P x N_Q| / (N_P.N_Q), with each side's own normal.
  double angleBound() const {
    const double off = sizes() * noise();
    const double steepest =
        largestQuotient(rows::cross(normal_a_, normal_b_), off, product_.array() - off, 20);
    return std::isfinite(steepest) ? std::atan(steepest) : std::numbers::pi;
  }

  /// 1: the normals are nowhere opposite; -1: they nowhere have the same direction; 0: neither is
  /// certain.
  int sense() const {
    if (!notPositive(product_, sizes())) return 1;
    return notPositive(-product_, sizes()) ? 0 : -1;
  }

 private:
  /// Of all fields that the normals are made of: rounding, relative; sizes, as a product.
  double noise() const {
    return relativeNoise(a_.s) + relativeNoise(a_.t) + relativeNoise(b_.s) + relativeNoise(b_.t);
  }
  double sizes() const { return a_.s.size() * a_.t.size() * b_.s.size() * b_.t.size(); }

  JoinResidual polynomialCondition(std::optional<double> tolerance) const {
    const double scale = a_.s.size() * a_.t.size() * b_.s.size();
    const double noise = scale * (relativeNoise(a_.s) + relativeNoise(a_.t) + relativeNoise(b_.s));
    return residual({rows::determinant(a_.s.field, a_.t.field, b_.s.field), scale, noise},
                    std::pow(pair_.length, 3), tolerance);
  }

  JoinResidual rationalCondition(std::optional<double> tolerance) const {
    const Eigen::Index n = pair_.a.position.rows() - 1;
    const RoundedField<4> first{pair_.a.position.topRows(n), 16 * pair_.rounding};
    const RoundedField<4> along{pair_.a.position.bottomRows(n) - pair_.a.position.topRows(n),
                                16 * pair_.rounding};
    const RoundedField<4> out{pair_.a.first, 16 * pair_.rounding * pair_.a.degree_across};
    const RoundedField<4> into{pair_.b.first, 16 * pair_.rounding * pair_.b.degree_across};
    const double scale = first.size() * along.size() * out.size() * into.size();
    const double noise = scale * (relativeNoise(first) + relativeNoise(along) + relativeNoise(out) +
                                  relativeNoise(into));
    return residual(
        {rows::determinant(first.field, along.field, out.field, into.field), scale, noise},
        std::pow(pair_.length, 3), tolerance);
  }

  const NormalizedPair& pair_;
  const PointDerivatives &a_, &b_;
  Field<3> normal_a_, normal_b_;
  Eigen::VectorXd product_;
};

/// A scalar polynomial, and its error relative to its size.
struct Factor {
  Eigen::VectorXd value;
  double relative = 0;

  double size() const { return value.cwiseAbs().maxCoeff(); }
};

Factor operator*(const Factor& f, const Factor& g) {
  return {times(f.value, g.value), f.relative + g.relative};
}

Factor power(const Factor& f, int exponent) {
  Factor result = f;
  for (int k = 1; k < exponent; ++k) result = result * f;
  return result;
}

/// A sum of terms count times factor times vector, with its error.
class RoundedSum {
 public:
  RoundedSum& add(double count, const Factor& factor, const RoundedField<3>& x) {
    if (rows::isZero(factor.value)) return *this;
    sum_.add(count * factor.value, x.field);
    noise_ += std::abs(count) * factor.size() *
              (x.noise + x.size() * (factor.relative + field_roundings * machine_epsilon));
    return *this;
  }
  RoundedField<3> total() const { return {sum_.total(), noise_}; }

 private:
  Sum<3> sum_;
  double noise_ = 0;
};

/// A sum of terms count times factor (normal.field), with their sizes and bounds of their rounding.
class NormalSum {
 public:
  NormalSum(const Field<3>& normal, double normal_noise)
      : normal_(normal), normal_noise_(normal_noise) {}

  /// \param first the first derivative that x is one of.
  NormalSum& add(double count, const Factor& factor, const RoundedField<3>& x,
                 const RoundedField<3>& first) {
    if (rows::isZero(factor.value)) return *this;
    const double weight = std::abs(count) * factor.size() * rows::size(normal_);
    scale_ += weight * x.size();
    ordinary_ += weight * first.size();
    noise_ += weight * (x.noise + x.size() * (factor.relative + normal_noise_ +
                                              field_roundings * machine_epsilon));
    sum_.add(count * factor.value, rows::dot<3>(normal_, x.field));
    return *this;
  }

  /// \param unit factor of the coefficients.
  JoinResidual result(double unit, std::optional<double> tolerance) const {
    return residual({sum_.total(), scale_, noise_, ordinary_}, unit, tolerance);
  }

 private:
  const Field<3>& normal_;
  double normal_noise_;
  Sum<1> sum_;
  double scale_ = 0, noise_ = 0, ordinary_ = 0;
};

/// The reparametrisation of a that b is compared with, up to common factors: the conditions are
///   N_P.(lead Q_ss - second (alpha^2 P_ss + 2 alpha beta P_st + beta^2 P_tt)) = 0
///   N_P.(lead Q_sss - third (alpha^3 P_sss + 3 alpha^2 beta P_sst + 3 alpha beta^2 P_stt + beta^3
///        P_ttt) - 3 second (alpha p P_ss + (alpha q + beta p) P_st + beta q P_tt)) = 0.
struct Reparametrisation {
  Factor alpha, beta, p, q;
  struct {
    Factor lead, second;
  } curvature;
  struct {
    Factor lead, second, third;
  } change;
  double curvature_unit = 1, change_unit = 1;  ///< lengths of the coefficients
};

/// Of a given connection, which counts as exact.
Reparametrisation reparametrisation(const PointDerivatives& a, const PointDerivatives& b,
                                    const ConnectionFunctions& c, double length) {
  const Factor of_a{a.w}, of_b{b.w};
  return {
      .alpha = {c.alpha},
      .beta = {c.beta},
      .p = {c.p},
      .q = {c.q},
      .curvature = {.lead = power(of_a, 3), .second = power(of_b, 3)},
      .change = {.lead = power(of_a, 4), .second = power(of_b, 4) * of_a, .third = power(of_b, 4)},
      .curvature_unit = std::pow(length, 3),
      .change_unit = std::pow(length, 3)};
}

/// The relative error of a polynomial that may be small against the fields it is made of.
/// \param noise relative to these, \p size.
Factor cancelled(const Eigen::VectorXd& value, double noise, double size) {
  const double largest = value.cwiseAbs().maxCoeff();
  return {value, largest > 0 ? noise * size / largest : 0};
}

/// From the ribbons. With the weights: alpha = A w_P^2 / (w_Q^2 mu), N.X_ij w^3 = h_ij, so that
/// mu^2 w_Q h^Q_ss - w_P (A^2 h_ss + 2 A B h_st + B^2 h_tt) = 0. Its vector R instead of h gives p
/// = C w_P^2 / (w_Q^4 mu^3).
Reparametrisation reparametrisation(const PointDerivatives& a, const PointDerivatives& b,
                                    const Field<3>& normal, double length) {
  const double of_normal = relativeNoise(a.s) + relativeNoise(a.t);
  const double of_all = of_normal + relativeNoise(b.s);
  const Factor of_a{a.w}, of_b{b.w}, mu{rows::dot<3>(normal, normal), 2 * of_normal};
  Reparametrisation r;
  r.alpha = {rows::dot<3>(rows::cross(b.s.field, a.t.field), normal), of_all};
  r.beta = cancelled(rows::dot<3>(rows::cross(a.s.field, b.s.field), normal), of_all,
                     a.s.size() * b.s.size() * rows::size(normal));
  r.curvature = {.lead = power(mu, 2) * of_b, .second = of_a};
  r.change = {.lead = power(mu, 4) * power(of_b, 2), .second = of_a, .third = mu * power(of_a, 2)};
  r.curvature_unit = std::pow(length, 11);
  r.change_unit = std::pow(length, 19);
  const RoundedField<3> rest = RoundedSum()
                                   .add(1, r.curvature.lead, b.ss)
                                   .add(-1, r.alpha * r.alpha * r.curvature.second, a.ss)
                                   .add(-2, r.alpha * r.beta * r.curvature.second, a.st)
                                   .add(-1, r.beta * r.beta * r.curvature.second, a.tt)
                                   .total();
  const double size = rest.size() * rows::size(normal),
               noise = 2 * of_normal + (rest.size() > 0 ? rest.noise / rest.size() : 0);
  r.p =
      cancelled(rows::dot<3>(rows::cross(rest.field, a.t.field), normal), noise, size * a.t.size());
  r.q =
      cancelled(rows::dot<3>(rows::cross(a.s.field, rest.field), normal), noise, size * a.s.size());
  return r;
}

JoinResidual curvatureCondition(const PointDerivatives& a, const PointDerivatives& b,
                                const Field<3>& normal, const Reparametrisation& r,
                                std::optional<double> tolerance) {
  const Factor& second = r.curvature.second;
  return NormalSum(normal, relativeNoise(a.s) + relativeNoise(a.t))
      .add(1, r.curvature.lead, b.ss, b.s)
      .add(-1, second * r.alpha * r.alpha, a.ss, a.s)
      .add(-2, second * r.alpha * r.beta, a.st, a.s)
      .add(-1, second * r.beta * r.beta, a.tt, a.t)
      .result(r.curvature_unit, tolerance);
}

JoinResidual curvatureChangeCondition(const PointDerivatives& a, const PointDerivatives& b,
                                      const Field<3>& normal, const Reparametrisation& r,
                                      std::optional<double> tolerance) {
  const Factor &second = r.change.second, &third = r.change.third;
  return NormalSum(normal, relativeNoise(a.s) + relativeNoise(a.t))
      .add(1, r.change.lead, b.sss, b.s)
      .add(-1, third * power(r.alpha, 3), a.sss, a.s)
      .add(-3, third * power(r.alpha, 2) * r.beta, a.sst, a.s)
      .add(-3, third * r.alpha * power(r.beta, 2), a.stt, a.s)
      .add(-1, third * power(r.beta, 3), a.ttt, a.t)
      .add(-3, second * r.alpha * r.p, a.ss, a.s)
      .add(-3, second * r.alpha * r.q, a.st, a.s)
      .add(-3, second * r.beta * r.p, a.st, a.s)
      .add(-3, second * r.beta * r.q, a.tt, a.t)
      .result(r.change_unit, tolerance);
}

/// Whether the degree of the condition of the change of curvature is one that can be multiplied.
bool changeCanBeJudged(const NormalizedPair& pair, const PointDerivatives& a,
                       const PointDerivatives& b) {
  const int degree = std::max(pair.a.degree(), pair.b.degree());
  const bool rational = a.w.size() > 1 || b.w.size() > 1;
  return (rational ? 42 : 19) * degree <= bernstein::kMaxDegree;
}

void judgeParametric(const PointDerivatives& a, const PointDerivatives& b, double length,
                     std::optional<double> tolerance, JoinCondition& result) {
  const Eigen::VectorXd square_a = times(a.w, a.w), square_b = times(b.w, b.w);
  result.position = agreement(a.w, a.p, b.w, b.p, 1, length, tolerance);
  const double least = lowest(a.w) * lowest(b.w);
  result.gap_bound_mm = result.position.coefficients.maxCoeff() / least;
  result.first = agreement(square_a, a.s, square_b, b.s, 0, length, tolerance);
  const Eigen::VectorXd cube_a = times(a.w, square_a), cube_b = times(b.w, square_b);
  result.second =
      agreement(cube_a, a.ss, cube_b, b.ss, std::max(a.s.size(), b.s.size()), length, tolerance);
  result.parametric_order = -1;
  for (const JoinResidual* order : {&result.position, &result.first, &result.second}) {
    if (!order->holds) break;
    ++result.parametric_order;
  }
}

/// Over the same t.
JoinCondition judged(const Ribbon& a, const Ribbon& b, const JoinConditionOptions& options,
                     double roundings = 1) {
  const NormalizedPair pair(a, b, roundings);
  const PointDerivatives of_a = pointDerivativesOf(pair.a, pair.rounding),
                         of_b = pointDerivativesOf(pair.b, pair.rounding);
  JoinCondition result;
  judgeParametric(of_a, of_b, pair.length, options.tolerance, result);
  const TangentPlanes planes(pair, of_a, of_b);
  result.singular_at = planes.singularAt();
  result.angle_bound_rad = std::numbers::pi;
  if (result.singular_at) {
    result.verdict = JoinVerdict::Singular;
    return result;
  }
  result.tangent_plane = planes.condition(options.tolerance);
  result.angle_bound_rad = planes.angleBound();
  const int sense = planes.sense();
  if (!result.position.holds || !result.tangent_plane.holds || sense == 0) return result;
  result.verdict = sense > 0 ? JoinVerdict::G1 : JoinVerdict::Fold;
  if (result.verdict != JoinVerdict::G1) return result;
  const Reparametrisation of_b_to_a =
      options.connection ? reparametrisation(of_a, of_b, *options.connection, pair.length)
                         : reparametrisation(of_a, of_b, planes.normal(), pair.length);
  result.curvature = curvatureCondition(of_a, of_b, planes.normal(), of_b_to_a, options.tolerance);
  if (result.g2() && changeCanBeJudged(pair, of_a, of_b))
    result.curvature_change =
        curvatureChangeCondition(of_a, of_b, planes.normal(), of_b_to_a, options.tolerance);
  return result;
}

}  // namespace

std::string_view name(JoinVerdict verdict) {
  switch (verdict) {
    case JoinVerdict::G1:
      return "G1";
    case JoinVerdict::Fold:
      return "fold";
    case JoinVerdict::NotG1:
      return "not G1";
    case JoinVerdict::Singular:
      return "singular";
  }
  return "";
}

JoinCondition joinCondition(const Ribbon& a, const Ribbon& b, const JoinConditionOptions& options) {
  requireTolerance(options.tolerance);
  JoinConditionOptions checked_options = options;
  if (options.connection) checked_options.connection = checked(*options.connection);
  JoinCondition same = judged(a, b, checked_options);
  if (same.position.holds || options.connection) return same;
  const std::optional<CommonParameter> common = commonParameter(a, b);
  if (!common) return same;
  JoinCondition moved = judged(common->a, common->b, checked_options, common->roundings);
  moved.parameter = common->map;
  moved.parameter_of_a = common->of_a;
  moved.parametric_order = -1;
  return moved;
}

}  // namespace seamwright
