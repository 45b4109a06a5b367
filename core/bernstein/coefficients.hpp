// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>
#include <string>
#include <utility>

#include <seamwright/core/bernstein/rounding.hpp>

/// The algorithms that Bernstein forms in one and in two variables share; not a public header.
///
/// Values is Eigen::VectorXd or Eigen::MatrixXd. An algorithm in one variable runs down the rows
/// and treats each column independently. Form is BernsteinPolynomial or BernsteinTensor: it has
/// coefficients() and padding() and is constructed from these two.
namespace seamwright::bernstein {

/// Largest degree of a product, summed over all variables. Coefficients are scaled to below 2^100
/// before they are multiplied. Up to this degree the terms of the product, weighted by binomials,
/// then stay below 2^1000.
inline constexpr int kMaxDegree = 800;

/// The number with 17 digits, which tell it from every other double.
std::string text(double value);

template <class Values>
double largest(const Values& values) {
  return values.cwiseAbs().maxCoeff();
}

/// The message "coefficient 3 is nan" for the first coefficient whose absolute value is not below
/// kLimit; empty if there is none.
template <class Values>
std::string offender(const Values& values) {
  for (Eigen::Index j = 0; j < values.cols(); ++j)
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      if (std::abs(values(i, j)) < rounding::kLimit) continue;
      const std::string row = std::to_string(i);
      const std::string index =
          Values::ColsAtCompileTime == 1 ? row : "(" + row + ", " + std::to_string(j) + ")";
      return "coefficient " + index + " is " + text(values(i, j));
    }
  return {};
}

template <class Values>
void requireUsable(const Values& values, double padding) {
  if (values.size() == 0) throw std::invalid_argument("no coefficients: at least one is needed");
  if (const std::string fault = offender(values); !fault.empty())
    throw std::invalid_argument(fault + ": finite numbers below 2^1023 in size are needed");
  if (!(padding >= 0 && padding < rounding::kLimit))
    throw std::invalid_argument("padding is " + text(padding) +
                                ": it must be 0 or positive and below 2^1023");
}

template <class Values>
void refuseOverflow(const Values& values, double padding, const char* operation) {
  if (const std::string fault = offender(values); !fault.empty())
    throw std::overflow_error(std::string(operation) + ": " + fault + ", beyond 2^1023");
  if (!(padding < rounding::kLimit))
    throw std::overflow_error(std::string(operation) + ": padding is " + text(padding) +
                              ", beyond 2^1023");
}

template <class Form, class Values>
Form result(Values values, double padding, const char* operation) {
  refuseOverflow(values, padding, operation);
  return Form(std::move(values), padding);
}

inline void requireUnit(double parameter) {
  if (!(parameter >= 0 && parameter <= 1))
    throw std::invalid_argument("parameter " + text(parameter) + " is not in [0, 1]");
}

inline void requireUnit(const Interval& domain) {
  if (!(0 <= domain.lower && domain.lower <= domain.upper && domain.upper <= 1))
    throw std::invalid_argument("[" + text(domain.lower) + ", " + text(domain.upper) +
                                "] is not an interval in [0, 1]");
}

/// C(n, 0..n). Exact for n <= 56; above, each number has binomialRoundings(n) roundings.
inline const Eigen::VectorXd& binomials(Eigen::Index n) {
  thread_local std::deque<Eigen::VectorXd> pascal{Eigen::VectorXd::Ones(1)};
  while (static_cast<Eigen::Index>(pascal.size()) <= n) {
    const Eigen::VectorXd& above = pascal.back();
    Eigen::VectorXd row = Eigen::VectorXd::Ones(above.size() + 1);
    row.segment(1, above.size() - 1) = above.head(above.size() - 1) + above.tail(above.size() - 1);
    pascal.push_back(std::move(row));
  }
  return pascal[static_cast<std::size_t>(n)];
}

/// Sums are exact while binomials are below 2^53, up to n = 56. Each further row rounds once.
inline int binomialRoundings(Eigen::Index n) {
  return static_cast<int>(std::max<Eigen::Index>(0, n - 56));
}

/// The weights of one step (1 - t) a + t b.
struct Step {
  double keep;    ///< 1 - t
  double take;    ///< t
  int roundings;  ///< factors 1 + d that each term takes, including those of the weights

  /// The step of a given double t. In general 1 - t, the product and the sum are rounded; at t =
  /// 1/2 only the sum is rounded, and at t = 0 and 1 nothing is.
  static Step at(double t) { return {1 - t, t, t == 0 || t == 1 ? 0 : t == 0.5 ? 1 : 3}; }

  /// The step that takes [a, 1] to [a, b]: t = (b - a) / (1 - a), 1 - t = (1 - b) / (1 - a). Each
  /// weight has 3 roundings; with product and sum that makes 5. A quotient that underflows has an
  /// absolute error eta <= u instead; the sixth rounding accounts for it.
  static Step within(double a, double b) {
    if (a == b) return at(0);
    if (b == 1) return at(1);
    return {(1 - b) / (1 - a), (b - a) / (1 - a), 6};
  }

  double operator()(double a, double b) const { return keep * a + take * b; }

  /// Bound of the rounding in de Casteljau's triangle. Each result is a sum of coefficients times
  /// weights that add up to 1. Each term has at most degree x roundings factors 1 + d. In addition,
  /// each step may underflow twice.
  double error(Eigen::Index degree, double magnitude) const {
    if (roundings == 0) return 0;
    const int n = static_cast<int>(degree);
    return rounding::sumUp(rounding::productUp(rounding::gamma(roundings * n), magnitude),
                           4 * n * rounding::kUnderflow);
  }
};

/// The two edges of de Casteljau's triangle: the coefficients over [0, t] and over [t, 1].
template <class Values>
std::pair<Values, Values> casteljau(const Values& values, const Step& step) {
  Values left(values.rows(), values.cols());
  Values right = values;
  for (Eigen::Index j = 0; j < values.cols(); ++j)
    for (Eigen::Index k = 0; k < values.rows(); ++k) {
      left(k, j) = right(0, j);
      for (Eigen::Index i = 0; i + 1 < values.rows() - k; ++i)
        right(i, j) = step(right(i, j), right(i + 1, j));
    }
  return {left, right};
}

/// The values at a parameter, one for each column.
template <class Values>
Eigen::VectorXd collapsed(Values values, const Step& step) {
  for (Eigen::Index j = 0; j < values.cols(); ++j)
    for (Eigen::Index rows = values.rows() - 1; rows > 0; --rows)
      for (Eigen::Index i = 0; i < rows; ++i) values(i, j) = step(values(i, j), values(i + 1, j));
  return values.row(0).transpose();
}

template <class Form>
std::pair<Form, Form> split(const Form& p, double t) {
  requireUnit(t);
  const Step step = Step::at(t);
  auto [left, right] = casteljau(p.coefficients(), step);
  const double padding = rounding::sumUp(
      p.padding(), step.error(p.coefficients().rows() - 1, largest(p.coefficients())));
  return {result<Form>(std::move(left), padding, "split"),
          result<Form>(std::move(right), padding, "split")};
}

/// The restriction to [a, b]: first to [a, 1], then to [a, b] within it.
template <class Form>
Form restricted(const Form& p, const Interval& domain) {
  requireUnit(domain);
  const Form upper = domain.lower == 0 ? p : split(p, domain.lower).second;
  const Step step = Step::within(domain.lower, domain.upper);
  const double error = step.error(p.coefficients().rows() - 1, largest(upper.coefficients()));
  return result<Form>(casteljau(upper.coefficients(), step).first,
                      rounding::sumUp(upper.padding(), error), "restriction");
}

/// The coefficients are n (c_(i+1) - c_i), with two roundings each. A multiple of a denormal is
/// exact.
template <class Form>
Form derivative(const Form& p) {
  using Values = std::decay_t<decltype(p.coefficients())>;
  const Values& c = p.coefficients();
  const Eigen::Index n = c.rows() - 1;
  if (n == 0) return Form(Values::Zero(1, c.cols()), 0);
  const double degree = static_cast<double>(n);
  Values values = degree * (c.bottomRows(n) - c.topRows(n));
  const double padding = rounding::sumUp(rounding::productUp(2 * degree, p.padding()),
                                         rounding::productUp(rounding::gamma(3), largest(values)));
  return result<Form>(std::move(values), padding, "derivative");
}

/// \pre p and q have coefficients of the same shape.
template <class Form>
Form sum(const Form& p, const Form& q) {
  std::decay_t<decltype(p.coefficients())> values = p.coefficients() + q.coefficients();
  const double padding = rounding::sumUp(p.padding(), q.padding(),
                                         rounding::productUp(rounding::kUnit, largest(values)));
  return result<Form>(std::move(values), padding, "sum");
}

template <class Form>
Form scaled(double factor, const Form& p) {
  if (!std::isfinite(factor))
    throw std::invalid_argument("factor is " + text(factor) + ": it must be finite");
  std::decay_t<decltype(p.coefficients())> values = factor * p.coefficients();
  const double padding = rounding::sumUp(rounding::productUp(std::abs(factor), p.padding()),
                                         rounding::productUp(rounding::kUnit, largest(values)),
                                         factor == 0 ? 0 : rounding::kUnderflow);
  return result<Form>(std::move(values), padding, "multiple");
}

/// Coefficients, each within \p error of the true one.
template <class Values>
struct Rounded {
  Values values;
  double error;
};

/// The exponent of the power of two by which coefficients are divided before they are multiplied by
/// binomials. It is 0 while the coefficients are of moderate size.
inline int scaleExponent(double magnitude) {
  int exponent = 0;
  std::frexp(magnitude, &exponent);
  return std::abs(exponent) <= 100 ? 0 : exponent;
}

template <class Values>
Values scaledBy(const Values& values, int exponent) {
  if (exponent == 0) return values;
  return values.unaryExpr([&](double c) { return std::ldexp(c, exponent); });
}

/// The value of scaledBy(), rounded upwards.
inline double scaledUp(double value, int exponent) {
  return exponent == 0 || value == 0 ? value : rounding::up(std::ldexp(value, exponent));
}

/// The weighted coefficients c_ij C(m, i) C(n, j), with m and n the degrees.
template <class Values>
Values weighted(const Values& values) {
  return binomials(values.rows() - 1).asDiagonal() * values *
         binomials(values.cols() - 1).asDiagonal();
}

/// Coefficients of the product of two polynomials given by their weighted coefficients.
template <class Values>
Values combined(const Values& a, const Values& b) {
  using Eigen::Index;
  Values values = Values::Zero(a.rows() + b.rows() - 1, a.cols() + b.cols() - 1);
  for (Index l = 0; l < a.cols(); ++l)
    for (Index j = 0; j < b.cols(); ++j)
      for (Index i = 0; i < a.rows(); ++i)
        values.col(l + j).segment(i, b.rows()) += a(i, l) * b.col(j);
  values.array().colwise() /= binomials(values.rows() - 1).array();
  if constexpr (Values::ColsAtCompileTime != 1)
    values.array().rowwise() /= binomials(values.cols() - 1).transpose().array();
  return values;
}

/// The number of factors 1 + d in a term of combined(weighted(a), weighted(b)). They come from the
/// binomials, the weighting of both factors, the division in each variable, the product and the
/// sum.
template <class Values>
int productRoundings(const Values& a, const Values& b) {
  const Eigen::Index terms = std::min(a.rows(), b.rows()) * std::min(a.cols(), b.cols());
  int roundings = static_cast<int>(terms) + (Values::ColsAtCompileTime == 1 ? 3 : 6);
  for (const Eigen::Index size : {a.rows(), b.rows(), a.rows() + b.rows() - 1})
    roundings += binomialRoundings(size - 1);
  for (const Eigen::Index size : {a.cols(), b.cols(), a.cols() + b.cols() - 1})
    roundings += binomialRoundings(size - 1);
  return roundings;
}

/// The product of a, known within padding_a, and b, known within padding_b.
///
/// Let |a| be the polynomial of the absolute coefficients, and 1 the polynomial of coefficients 1.
/// The error is at most gamma_k max(|a| |b|) + padding_a max(1 |b|) + padding_b max(|a| 1) +
/// padding_a padding_b, plus what underflows. The maxima are computed with as many roundings as the
/// product, hence gamma_(k+1) (rounding::gamma).
///
/// Underflow: in units of 2^(exponents) the larger of magnitude and padding of a factor is at least
/// 2^-101, or 0. No weight of a term in a coefficient is below 2^-800. So the largest of the four
/// terms, without its factor gamma_k, is at least 2^-1002. Scaling, products, quotients and maxima
/// may lose a few eta, which is less than u times that term, hence gamma_(k+2). Only scaling back
/// adds an eta.
template <class Values>
Rounded<Values> product(const Values& a, double padding_a, const Values& b, double padding_b) {
  using rounding::gamma, rounding::productUp, rounding::sumUp;
  const Eigen::Index degree = a.rows() + a.cols() + b.rows() + b.cols() - 4;
  if (degree > kMaxDegree)
    throw std::invalid_argument("degree " + std::to_string(degree) + " of a product is above " +
                                std::to_string(kMaxDegree));
  const int exponent_a = scaleExponent(std::max(largest(a), padding_a)),
            exponent_b = scaleExponent(std::max(largest(b), padding_b));
  const int exponent = exponent_a + exponent_b, roundings = productRoundings(a, b);
  const Values weighted_a = weighted(scaledBy(a, -exponent_a)),
               weighted_b = weighted(scaledBy(b, -exponent_b));
  const Values size_a = weighted_a.cwiseAbs(), size_b = weighted_b.cwiseAbs();

  double error = productUp(gamma(roundings + 2), largest(combined(size_a, size_b)));
  const double e = scaledUp(padding_a, -exponent_a), f = scaledUp(padding_b, -exponent_b);
  const double slack = rounding::up(1 + gamma(roundings + 2));
  const auto inherited = [&](double padding, const Values& others, const Values& size) {
    if (padding == 0) return 0.0;
    const Values ones = weighted<Values>(Values::Ones(others.rows(), others.cols()));
    return productUp(productUp(padding, slack), largest(combined(ones, size)));
  };
  error = sumUp(error, inherited(e, a, size_b), inherited(f, b, size_a),
                productUp(productUp(e, f), slack));

  Values values = scaledBy(combined(weighted_a, weighted_b), exponent);
  if (exponent != 0 && error != 0) error = sumUp(scaledUp(error, exponent), rounding::kUnderflow);
  refuseOverflow(values, error, "product");
  return {std::move(values), error};
}

template <class Form>
Form product(const Form& p, const Form& q) {
  auto [values, padding] = product(p.coefficients(), p.padding(), q.coefficients(), q.padding());
  return Form(std::move(values), padding);
}

template <class Form>
Interval range(const Form& p) {
  return rounding::widened({p.coefficients().minCoeff(), p.coefficients().maxCoeff()}, p.padding());
}

/// The value, widened by padding and rounding. \p companion is the value that the absolute
/// coefficients give.
/// \pre The steps took \p roundings roundings in all, and each of them may have underflowed.
inline Interval enclosure(double value, double companion, double padding, int roundings,
                          int steps) {
  if (roundings == 0) return rounding::widened({value, value}, padding);
  const double error =
      rounding::sumUp(rounding::productUp(rounding::gamma(roundings + 1), companion),
                      4 * steps * rounding::kUnderflow);
  return rounding::widened({value, value}, rounding::sumUp(padding, error));
}

}  // namespace seamwright::bernstein
