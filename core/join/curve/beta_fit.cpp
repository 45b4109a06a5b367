// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include <seamwright/core/bernstein/bounded.hpp>
#include <seamwright/core/join/curve/bell.hpp>
#include <seamwright/core/join/curve/beta.hpp>
#include <seamwright/core/join/curve/joint_length.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

/// Rounding bounds grow by a digit or more with each order, so a double has none left long before.
constexpr int most_orders = 30;

/// Rows of numbers that carry the bounds of their own rounding.
template <int Columns>
using BoundedRows = Eigen::Matrix<Bounded, Eigen::Dynamic, Columns, Eigen::RowMajor>;
using BoundedSeries = Eigen::Matrix<Bounded, Eigen::Dynamic, 1>;

Bounded binomial(Index n, Index k) {
  return Bounded(bernstein::binomials(n)(k));
}

/// Derivatives of the homogeneous curve at t = 0: n!/(n-k)! times the differences of the poles;
/// lengths are divided by 2^exponent.
BoundedRows<4> homogeneousDerivatives(const HomogeneousPoles& poles, int order, int exponent) {
  BoundedRows<4> differences(poles.rows(), 4);
  for (Index i = 0; i < poles.rows(); ++i)
    for (Index c = 0; c < 4; ++c)
      differences(i, c) = ldexp(Bounded(poles(i, c)), c < 3 ? -exponent : 0);
  BoundedRows<4> result(order + 1, 4);
  Bounded factor(1);
  for (Index k = 0; k <= std::min<Index>(order, poles.rows() - 1); ++k) {
    for (Index c = 0; c < 4; ++c) result(k, c) = factor * differences(0, c);
    const Index rest = poles.rows() - 1 - k;
    factor = factor * Bounded(static_cast<double>(rest));
    for (Index i = 0; i < rest; ++i)
      for (Index c = 0; c < 4; ++c) differences(i, c) = differences(i + 1, c) - differences(i, c);
  }
  return result;
}

/// Leibniz' rule on A = w X.
BoundedRows<3> affine(const BoundedRows<4>& h) {
  BoundedRows<3> x(h.rows(), 3);
  for (Index k = 0; k < h.rows(); ++k)
    for (Index c = 0; c < 3; ++c) {
      Bounded sum = h(k, c);
      for (Index i = 1; i <= k; ++i) sum -= binomial(k, i) * h(i, 3) * x(k - i, c);
      x(k, c) = sum / h(0, 3);
    }
  return x;
}

/// The parameter multiplied by the power of two that makes the speed about 1.
void normalise(BoundedRows<3>& x) {
  if (x.rows() < 2) return;
  int exponent = 0;
  std::frexp(Eigen::Vector3d(x(1, 0).value, x(1, 1).value, x(1, 2).value).stableNorm(), &exponent);
  for (Index k = 1; k < x.rows(); ++k)
    for (Index c = 0; c < 3; ++c) x(k, c) = ldexp(x(k, c), -static_cast<int>(k) * exponent);
}

/// Derivatives of the arc length: the speed v from (v^2)^(m) = sum_i C(m, i) v^(i) v^(m-i) = (X' .
/// X')^(m).
BoundedSeries lengthDerivatives(const BoundedRows<3>& x) {
  const Index count = x.rows() - 1;
  BoundedSeries speed(count);
  for (Index m = 0; m < count; ++m) {
    Bounded sum;
    for (Index i = 0; i <= m; ++i)
      for (Index c = 0; c < 3; ++c) sum += binomial(m, i) * x(i + 1, c) * x(m - i + 1, c);
    for (Index i = 1; i < m; ++i) sum -= binomial(m, i) * speed(i) * speed(m - i);
    speed(m) = m == 0 ? sqrt(sum) : sum / (Bounded(2) * speed(0));
  }
  return speed;
}

/// Derivatives c by arc length, from those by the parameter, which are B(length derivatives) c.
BoundedRows<3> arcLengthRows(const BoundedRows<3>& x) {
  const auto matrix = bellMatrix<Bounded>(lengthDerivatives(x));
  BoundedRows<3> result = x;
  for (Index k = 1; k < x.rows(); ++k)
    for (Index c = 0; c < 3; ++c) {
      for (Index j = 1; j < k; ++j) result(k, c) -= matrix(k, j) * result(j, c);
      result(k, c) = result(k, c) / matrix(k, k);
    }
  return result;
}

BoundedRows<3> startOf(const BezierCurve& curve, int order, int exponent) {
  BoundedRows<3> x = affine(homogeneousDerivatives(curve.homogeneousPoles(), order, exponent));
  normalise(x);
  return arcLengthRows(x);
}

BoundedRows<3> endOf(const BezierCurve& curve, int order, int exponent) {
  BoundedRows<3> x = startOf(curve.reversed(), order, exponent);
  for (Index k = 1; k <= order; k += 2)
    for (Index c = 0; c < 3; ++c) x(k, c) = -x(k, c);
  return x;
}

Bounded norm(double x, double y, double z) {
  const Bounded a(x), b(y), c(z);
  return sqrt(a * a + b * b + c * c);
}

/// |c_k of b - c_k of a| L^(k-1), k up to \p order, lengths divided by the power of two nearest to
/// L.
void boundDefects(const BezierCurve& a, const BezierCurve& b, int order, BetaFit& fit) {
  int exponent = 0;
  const Bounded length(std::frexp(fit.length_mm, &exponent));
  const BoundedRows<3> from = endOf(a, order, exponent), to = startOf(b, order, exponent);
  Bounded power = Bounded(1) / length;
  for (Index k = 0; k <= order; ++k, power = power * length) {
    const Bounded x = to(k, 0) - from(k, 0), y = to(k, 1) - from(k, 1), z = to(k, 2) - from(k, 2);
    const Bounded least = norm(x.sizeLower(), y.sizeLower(), z.sizeLower()),
                  most = norm(x.sizeUpper(), y.sizeUpper(), z.sizeUpper());
    fit.lower.push_back((Bounded(least.sizeLower()) * power).sizeLower());
    fit.upper.push_back((Bounded(most.sizeUpper()) * power).sizeUpper());
  }
}

/// beta_k = a_1 . (b_k - sum_{j=2..k} B_kj a_j) / |a_1|^2. \pre |a_1| > 0.
Eigen::VectorXd projectedBeta(const CurveDerivatives& a, const CurveDerivatives& b) {
  const double speed = a.row(1).stableNorm();
  const Eigen::RowVector3d tangent = a.row(1) / speed;
  Eigen::VectorXd beta = Eigen::VectorXd::Zero(a.rows() - 1);
  for (Index k = 1; k < a.rows(); ++k) {
    const Eigen::MatrixXd matrix = bellMatrix<double>(beta.head(k));
    Eigen::RowVector3d left = b.row(k);
    for (Index j = 2; j <= k; ++j) left -= matrix(k, j) * a.row(j);
    beta(k - 1) = tangent.dot(left) / speed;
    if (beta(0) <= 0 || !std::isfinite(beta(k - 1))) return beta.head(k - 1);
  }
  return beta;
}

}  // namespace

BetaFit fitBeta(const BezierCurve& a, const BezierCurve& b, int order,
                std::optional<double> length_mm) {
  if (order < 0 || order > most_orders)
    throw std::invalid_argument("order " + std::to_string(order) + ": it must be within 0 to " +
                                std::to_string(most_orders));
  BetaFit fit;
  fit.length_mm = length_mm.value_or(0);
  if (!length_mm) fit.length_mm = jointLength(extentOf(a.poles()), extentOf(b.poles()));
  if (!(fit.length_mm > 0 && std::isfinite(fit.length_mm)))
    throw std::invalid_argument("length_mm is " + bernstein::text(fit.length_mm) +
                                ": it must be positive");
  int exponent = 0;
  const double length = std::frexp(fit.length_mm, &exponent);
  // In units of the power of two nearest to L, so that powers of lengths stay within the range of a
  // double.
  const auto scaled = [&](const CurveDerivatives& derivatives, double noise) {
    return CurveEnd{derivatives.unaryExpr([&](double x) { return std::ldexp(x, -exponent); }),
                    std::ldexp(noise, -exponent)};
  };
  const CurveEnd end = scaled(a.derivatives(1, order), a.noise());
  const CurveEnd beginning = scaled(b.derivatives(0, order), b.noise());
  const CurveJoint joint = measureJoint(end, beginning);
  if (!joint.gap_mm)
    throw std::invalid_argument("the curves' ends are beyond the range of a double");
  const bool tangents = !joint.differences.empty();
  boundDefects(a, b, tangents ? order : 0, fit);
  for (std::size_t k = 0; k < fit.upper.size(); ++k) {
    const double difference = k == 0 ? *joint.gap_mm : joint.differences[k];
    const double defect = difference * std::pow(length, static_cast<double>(k) - 1);
    fit.defects.push_back(std::clamp(defect, fit.lower[k], fit.upper[k]));
  }
  if (tangents && order > 0) fit.beta = projectedBeta(end.derivatives, beginning.derivatives);
  return fit;
}

}  // namespace seamwright
