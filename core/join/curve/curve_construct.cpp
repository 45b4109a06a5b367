// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <stdexcept>
#include <string>

#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/join/curve/bell.hpp>
#include <seamwright/core/join/curve/beta.hpp>

namespace seamwright {

namespace {

using bernstein::binomials;
using bernstein::text;
using Eigen::Index;

/// A limit of the interface, as a choice: binomials stay far within a double.
constexpr int most_degree = 100;

void requirePositive(const char* name, double value) {
  if (!(value > 0 && std::isfinite(value)))
    throw std::invalid_argument(std::string(name) + " is " + text(value) + ": it must be positive");
}

void requireScale(const Eigen::VectorXd& scale, Index order) {
  if (scale.size() == 0) return;
  if (scale.size() != order + 1)
    throw std::invalid_argument("scale has " + std::to_string(scale.size()) +
                                " numbers: " + std::to_string(order + 1) + " are needed, or none");
  for (Index k = 0; k < scale.size(); ++k)
    if (!std::isfinite(scale(k)))
      throw std::invalid_argument("scale e_" + std::to_string(k) + " is " + text(scale(k)) +
                                  ": it must be finite");
  requirePositive("scale e_0", scale(0));
}

void requireTangent(const BezierCurve& a) {
  const double speed = a.derivatives(1, 1).row(1).stableNorm(), noise = a.noise();
  if (speed <= noise)
    throw std::invalid_argument("the curve has no tangent at its end: speed " + text(speed) +
                                ", rounding " + text(noise));
}

void requireRule(const BezierCurve& a, int degree, const CurveJoinRule& rule) {
  requireBeta(rule.beta);
  const Index order = rule.beta.size();
  if (degree < order || degree > most_degree)
    throw std::invalid_argument("degree " + std::to_string(degree) + ": it must be within " +
                                std::to_string(order) + " to " + std::to_string(most_degree));
  requirePositive("length", rule.length);
  requirePositive("next_length", rule.next_length);
  requireScale(rule.scale, order);
  if (order > 0) requireTangent(a);
}

void requireResult(const HomogeneousPoles& poles) {
  for (Index k = 0; k < poles.rows(); ++k) {
    const std::string index = std::to_string(k);
    if (!poles.row(k).allFinite())
      throw std::invalid_argument("pole " + index + " comes out beyond the range of a double");
    if (poles(k, 3) <= 0)
      throw std::invalid_argument("weight " + index + " comes out as " + text(poles(k, 3)) +
                                  ": make next_length or the scale e_1, e_2, .. smaller");
  }
}

/// Row k is the k-th difference of the poles about the first one.
HomogeneousPoles differences(const HomogeneousPoles& poles, Index order) {
  HomogeneousPoles work = poles, result = HomogeneousPoles::Zero(order + 1, 4);
  for (Index k = 0; k <= std::min(order, poles.rows() - 1); ++k) {
    result.row(k) = work.row(0);
    const Index rest = work.rows() - 1;
    work = (work.bottomRows(rest) - work.topRows(rest)).eval();
  }
  return result;
}

/// n! / (n-k)!, 0 for k > n.
double falling(Index n, Index k) {
  double product = 1;
  for (Index i = 0; i < k; ++i) product *= static_cast<double>(n - i);
  return product;
}

/// Of the homogeneous curve at t = 1.
HomogeneousPoles derivativesAtEnd(const BezierCurve& a, Index order) {
  HomogeneousPoles result = differences(a.reversed().homogeneousPoles(), order);
  for (Index k = 0; k <= order; ++k)
    result.row(k) *= (k % 2 == 0 ? 1 : -1) * falling(a.degree(), k);
  return result;
}

/// Row k of the product with the scale: sum_j C(k, j) e_(k-j) h_j.
HomogeneousPoles scaled(const HomogeneousPoles& derivatives, const Eigen::VectorXd& scale) {
  HomogeneousPoles result = HomogeneousPoles::Zero(derivatives.rows(), 4);
  for (Index k = 0; k < derivatives.rows(); ++k)
    for (Index j = 0; j <= k; ++j)
      result.row(k) += binomials(k)(j) * scale(k - j) * derivatives.row(j);
  return result;
}

/// The first poles of a curve of that degree with these derivatives at t = 0.
HomogeneousPoles polesFrom(const HomogeneousPoles& derivatives, int degree) {
  HomogeneousPoles result = HomogeneousPoles::Zero(derivatives.rows(), 4);
  for (Index k = 0; k < derivatives.rows(); ++k)
    for (Index j = 0; j <= k; ++j)
      result.row(k) += binomials(k)(j) / falling(degree, j) * derivatives.row(j);
  return result;
}

BezierCurve raisedTo(BezierCurve curve, Index degree) {
  while (curve.degree() < degree) curve = curve.elevated();
  return curve;
}

/// With all weights 1.
BezierCurve polynomial(const char* name, const BezierCurve& curve) {
  if (!curve.isRational()) return BezierCurve(curve.poles());
  const Eigen::VectorXd weights = curve.weights();
  Index i = 1;
  while (weights(i) == weights(0)) ++i;
  throw std::invalid_argument(std::string(name) + " is rational, weight 0 is " + text(weights(0)) +
                              ", weight " + std::to_string(i) + " is " + text(weights(i)) +
                              ": a bridge is made between polynomial curves");
}

}  // namespace

HomogeneousPoles nextPoles(const BezierCurve& a, int degree, const CurveJoinRule& rule) {
  requireRule(a, degree, rule);
  const Index order = rule.beta.size();
  // In parameters of the curves themselves, from 0 to 1, both lengths are 1.
  Eigen::VectorXd beta = rule.beta / rule.length, scale = Eigen::VectorXd::Unit(order + 1, 0);
  if (rule.scale.size() > 0) scale = rule.scale;
  for (Index k = 1; k <= order; ++k) {
    beta.tail(order - k + 1) *= rule.next_length;
    scale.tail(order - k + 1) *= rule.next_length;
  }
  const HomogeneousPoles derivatives =
      scaled(bellMatrix<double>(beta) * derivativesAtEnd(a, order), scale);
  HomogeneousPoles poles = polesFrom(derivatives, degree);
  requireResult(poles);
  return poles;
}

BezierCurve joinedCurve(const BezierCurve& a, const BezierCurve& b, const CurveJoinRule& rule,
                        bool keep_end) {
  requireBeta(rule.beta);
  const Index order = rule.beta.size();
  HomogeneousPoles poles = raisedTo(b, keep_end ? 2 * order + 1 : order).homogeneousPoles();
  poles.topRows(order + 1) = nextPoles(a, static_cast<int>(poles.rows()) - 1, rule);
  return BezierCurve::fromHomogeneous(std::move(poles));
}

BezierCurve bridgeCurve(const BezierCurve& a, const BezierCurve& b, const Eigen::VectorXd& beta,
                        const Eigen::VectorXd& beta_end) {
  requireBeta(beta);
  const CurveJoinRule rule{beta, 1, 1, {}}, rule_end{reversedBeta(beta_end), 1, 1, {}};
  const int degree = static_cast<int>(beta.size() + beta_end.size()) + 1;
  HomogeneousPoles poles(degree + 1, 4);
  poles.topRows(beta.size() + 1) = nextPoles(polynomial("a", a), degree, rule);
  poles.bottomRows(beta_end.size() + 1) =
      nextPoles(polynomial("b", b).reversed(), degree, rule_end).colwise().reverse();
  return BezierCurve::fromHomogeneous(std::move(poles));
}

}  // namespace seamwright
