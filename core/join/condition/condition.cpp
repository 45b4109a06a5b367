// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <numbers>
#include <seamwright/core/join/checked_connection.hpp>
#include <seamwright/core/join/condition/condition.hpp>
#include <seamwright/core/join/normalized.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using rows::derivative;
using rows::Field;
using rows::Sum;
using rows::times;

/// Bound of all roundings in a product of fields: the noise is this times machine_epsilon for each
/// factor.
constexpr double factor_roundings = 64;

/// A vector-valued polynomial, and a bound of the error of a coefficient.
template <int Size>
struct Rounded {
  Field<Size> field;
  double noise = 0;

  double size() const { return rows::size(field); }
};

Field<3> space(const HomogeneousPoles& part) {
  return part.leftCols<3>();
}
Eigen::VectorXd weight(const HomogeneousPoles& part) {
  return rows::trimmed(part.col(3));
}

/// The derivatives of the points of a side, each multiplied by the power of the weight that makes
/// it a polynomial.
struct Derivatives {
  Eigen::VectorXd w;
  Rounded<3> p;           ///< times w
  Rounded<3> s, t;        ///< times w^2
  Rounded<3> ss, st, tt;  ///< times w^3
};

/// w A_i - w_i A, which is w^2 X_i.
Field<3> firstOf(const HomogeneousPoles& h, const HomogeneousPoles& h_i) {
  return Sum<3>().add(weight(h), space(h_i)).add(-weight(h_i), space(h)).total();
}

/// w^2 A_ij - w_i (w^2 X_j) - w_j (w^2 X_i) - w w_ij A, which is w^3 X_ij.
Field<3> secondOf(const HomogeneousPoles& h, const HomogeneousPoles& h_i,
                  const HomogeneousPoles& h_j, const HomogeneousPoles& h_ij) {
  const Eigen::VectorXd w = weight(h);
  return Sum<3>()
      .add(times(w, w), space(h_ij))
      .add(-weight(h_i), firstOf(h, h_j))
      .add(-weight(h_j), firstOf(h, h_i))
      .add(-times(w, weight(h_ij)), space(h))
      .total();
}

Derivatives derivativesOf(const Ribbon& ribbon, double rounding) {
  const HomogeneousPoles &h = ribbon.position, &s = ribbon.first, &ss = ribbon.second;
  const HomogeneousPoles t = derivative<4>(h), st = derivative<4>(s), tt = derivative<4>(t);
  const double weights = h.col(3).maxCoeff();
  const double m = std::max(ribbon.degree_across, 1), n = std::max(ribbon.degree(), 1);
  const double unit = 16 * rounding * std::max(1.0, std::pow(weights, 3));
  Derivatives d;
  d.w = weight(h);
  d.p = {space(h), unit};
  d.s = {firstOf(h, s), unit * m};
  d.t = {firstOf(h, t), unit * n};
  d.ss = {secondOf(h, s, s, ss), unit * 4 * m * m};
  d.st = {secondOf(h, s, t, st), unit * 4 * m * n};
  d.tt = {secondOf(h, t, t, tt), unit * 4 * n * n};
  return d;
}

/// Noise relative to size; at least that of computing with it.
template <int Size>
double relativeNoise(const Rounded<Size>& x) {
  const double size = x.size();
  return factor_roundings * machine_epsilon + (size > 0 ? x.noise / size : 0);
}

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
JoinResidual agreement(const Eigen::VectorXd& f, const Rounded<3>& a, const Eigen::VectorXd& g,
                       const Rounded<3>& b, double usual_size, double length,
                       std::optional<double> tolerance) {
  const Field<3> difference = Sum<3>().add(f, b.field).add(-g, a.field).total();
  const double size_f = f.cwiseAbs().maxCoeff(), size_g = g.cwiseAbs().maxCoeff();
  const double scale = std::max(size_f * b.size(), size_g * a.size());
  const double noise =
      size_f * b.noise + size_g * a.noise + factor_roundings * machine_epsilon * scale;
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
      polynomial / size, std::clamp(noise, factor_roundings * machine_epsilon, 2.0)));
}

/// The polynomials that judge a join of tangent planes.
class TangentPlanes {
 public:
  TangentPlanes(const NormalizedPair& pair, const Derivatives& a, const Derivatives& b)
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
    const Rounded<4> first{pair_.a.position.topRows(n), 16 * pair_.rounding};
    const Rounded<4> along{pair_.a.position.bottomRows(n) - pair_.a.position.topRows(n),
                           16 * pair_.rounding};
    const Rounded<4> out{pair_.a.first, 16 * pair_.rounding * pair_.a.degree_across};
    const Rounded<4> into{pair_.b.first, 16 * pair_.rounding * pair_.b.degree_across};
    const double scale = first.size() * along.size() * out.size() * into.size();
    const double noise = scale * (relativeNoise(first) + relativeNoise(along) + relativeNoise(out) +
                                  relativeNoise(into));
    return residual(
        {rows::determinant(first.field, along.field, out.field, into.field), scale, noise},
        std::pow(pair_.length, 3), tolerance);
  }

  const NormalizedPair& pair_;
  const Derivatives &a_, &b_;
  Field<3> normal_a_, normal_b_;
  Eigen::VectorXd product_;
};

/// A sum of terms factor (normal.field), with their sizes and bounds of their rounding.
class NormalSum {
 public:
  explicit NormalSum(const Field<3>& normal, double normal_noise)
      : normal_(normal), normal_noise_(normal_noise) {}

  /// \param first the first derivative that x is one of.
  NormalSum& add(const Eigen::VectorXd& factor, double factor_noise, const Rounded<3>& x,
                 const Rounded<3>& first) {
    if (rows::isZero(factor)) return *this;
    const double weight = factor.cwiseAbs().maxCoeff() * rows::size(normal_);
    scale_ += weight * x.size();
    ordinary_ += weight * first.size();
    noise_ +=
        weight *
        (x.noise + x.size() * (factor_noise + normal_noise_ + factor_roundings * machine_epsilon));
    sum_.add(factor, rows::dot<3>(normal_, x.field));
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

/// With the weights: alpha = A w_P^2 / (w_Q^2 mu), N.X_ij w^3 = h_ij, so that
/// mu^2 w_Q h^Q_ss - w_P (A^2 h_ss + 2 A B h_st + B^2 h_tt) = 0.
JoinResidual curvatureCondition(const Derivatives& a, const Derivatives& b, const Field<3>& normal,
                                double length, std::optional<double> tolerance) {
  const Eigen::VectorXd mu = rows::dot<3>(normal, normal);
  const Eigen::VectorXd A = rows::dot<3>(rows::cross(b.s.field, a.t.field), normal);
  const Eigen::VectorXd B = rows::dot<3>(rows::cross(a.s.field, b.s.field), normal);
  const double of_normal = relativeNoise(a.s) + relativeNoise(a.t);
  const double of_all = of_normal + relativeNoise(b.s);
  // B may be small relative to the fields it is made of, so its relative error may be larger.
  const double size_B = a.s.size() * b.s.size() * rows::size(normal),
               largest_B = B.cwiseAbs().maxCoeff();
  const double of_B = largest_B > 0 ? of_all * size_B / largest_B : 0;
  NormalSum sum(normal, of_normal);
  sum.add(times(times(mu, mu), b.w), 4 * of_normal, b.ss, b.s)
      .add(-times(times(A, A), a.w), 2 * of_all, a.ss, a.s)
      .add(-2 * times(times(A, B), a.w), of_all + of_B, a.st, a.s)
      .add(-times(times(B, B), a.w), 2 * of_B, a.tt, a.t);
  return sum.result(std::pow(length, 11), tolerance);
}

Eigen::VectorXd cube(const Eigen::VectorXd& w) {
  return times(w, times(w, w));
}

JoinResidual curvatureCondition(const Derivatives& a, const Derivatives& b, const Field<3>& normal,
                                double length, const ConnectionFunctions& c,
                                std::optional<double> tolerance) {
  const Eigen::VectorXd w = cube(b.w), &alpha = c.alpha, &beta = c.beta;
  const double of_normal = relativeNoise(a.s) + relativeNoise(a.t);
  NormalSum sum(normal, of_normal);
  sum.add(cube(a.w), 0, b.ss, b.s)
      .add(-times(w, times(alpha, alpha)), 0, a.ss, a.s)
      .add(-2 * times(w, times(alpha, beta)), 0, a.st, a.s)
      .add(-times(w, times(beta, beta)), 0, a.tt, a.t);
  return sum.result(std::pow(length, 3), tolerance);
}

void judgeParametric(const Derivatives& a, const Derivatives& b, double length,
                     std::optional<double> tolerance, JoinCondition& result) {
  const Eigen::VectorXd square_a = times(a.w, a.w), square_b = times(b.w, b.w);
  result.position = agreement(a.w, a.p, b.w, b.p, 1, length, tolerance);
  const double least = lowest(a.w) * lowest(b.w);
  result.gap_bound_mm = result.position.coefficients.maxCoeff() / least;
  result.first = agreement(square_a, a.s, square_b, b.s, 0, length, tolerance);
  result.second = agreement(cube(a.w), a.ss, cube(b.w), b.ss, std::max(a.s.size(), b.s.size()),
                            length, tolerance);
  result.parametric_order = -1;
  for (const JoinResidual* order : {&result.position, &result.first, &result.second}) {
    if (!order->holds) break;
    ++result.parametric_order;
  }
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
  std::optional<ConnectionFunctions> connection = options.connection;
  if (connection) connection = checked(*connection);
  const NormalizedPair pair(a, b);
  const Derivatives of_a = derivativesOf(pair.a, pair.rounding),
                    of_b = derivativesOf(pair.b, pair.rounding);
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
  result.curvature =
      connection ? curvatureCondition(of_a, of_b, planes.normal(), pair.length, *connection,
                                      options.tolerance)
                 : curvatureCondition(of_a, of_b, planes.normal(), pair.length, options.tolerance);
  return result;
}

}  // namespace seamwright
