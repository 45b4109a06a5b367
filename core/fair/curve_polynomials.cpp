// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include <seamwright/core/fair/curve_polynomials.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

/// The coordinate of the homogeneous curve, from the origin, in the unit.
BernsteinPolynomial coordinate(const BezierCurve& curve, int axis, double origin, double unit) {
  const HomogeneousPoles& poles = curve.homogeneousPoles();
  const Eigen::VectorXd shifted = (poles.col(axis) - origin * poles.col(3)) / unit;
  if (poles.col(3).isOnes(0)) {
    // One rounding of each difference.
    return BernsteinPolynomial(shifted, machine_epsilon / 2 * shifted.cwiseAbs().maxCoeff());
  }
  // A rounding of the product and one of the difference, each by half of machine_epsilon at most.
  const double sizes = (poles.col(axis).cwiseAbs().maxCoeff() +
                        std::abs(origin) * poles.col(3).cwiseAbs().maxCoeff()) /
                       unit;
  return BernsteinPolynomial(shifted, 2 * machine_epsilon * sizes);
}

/// The first (from = 0) or last (from = 1) n coefficients of a polynomial of degree n.
BernsteinPolynomial shortened(const BernsteinPolynomial& p, int from) {
  return BernsteinPolynomial(p.coefficients().segment(from, p.degree()), p.padding());
}

/// p / (t^a (1 - t)^b) for a polynomial whose first a and last b coefficients are 0 but for
/// rounding: coefficient i is multiplied by binomial(n, i) / binomial(n - a - b, i - a).
BernsteinPolynomial divided(const BernsteinPolynomial& p, const StoppedEnds& stops) {
  if (!stops.any()) return p;
  const int degree = p.degree() - stops.start - stops.end;
  // binomial(n, a), and from one factor to the next (n - i) (i + 1 - a) / ((i + 1) (n - b - i)).
  double factor = 1, largest_factor = 1;
  for (int i = 0; i < stops.start; ++i) factor *= static_cast<double>(p.degree() - i) / (i + 1);
  Eigen::VectorXd result(degree + 1);
  for (int j = 0; j <= degree; ++j) {
    const int i = j + stops.start;
    result[j] = factor * p.coefficients()[i];
    largest_factor = std::max(largest_factor, factor);
    if (j < degree)
      factor *= static_cast<double>((p.degree() - i) * (j + 1)) / ((i + 1) * (degree - j));
  }
  // Two roundings of a factor for each step, and one of the product.
  const double roundings = 2 * (p.degree() + 2) * machine_epsilon;
  return BernsteinPolynomial(result, (1 + roundings) * largest_factor * p.padding() +
                                         roundings * result.cwiseAbs().maxCoeff());
}

PolynomialVector divided(const PolynomialVector& velocity, const StoppedEnds& stops) {
  return {divided(velocity[0], stops), divided(velocity[1], stops), divided(velocity[2], stops)};
}

}  // namespace

CurvePolynomials curvePolynomials(const BezierCurve& curve, const Eigen::RowVector3d& origin,
                                  double unit) {
  const PolynomialVector points = {coordinate(curve, 0, origin[0], unit),
                                   coordinate(curve, 1, origin[1], unit),
                                   coordinate(curve, 2, origin[2], unit)};
  const StoppedEnds stops = stoppedEnds(curve);
  if (!curve.isRational()) {
    const double weight = curve.homogeneousPoles()(0, 3);
    return {.weight = BernsteinPolynomial(Eigen::VectorXd::Constant(1, weight)),
            .point = points,
            .velocity = divided({weight * points[0].derivative(), weight * points[1].derivative(),
                                 weight * points[2].derivative()},
                                stops),
            .stops = stops};
  }
  // With A = (1 - t) A0 + t A1, A0 and A1 of degree n - 1, A' W - A W' = n (A1 W0 - A0 W1).
  const BernsteinPolynomial weight(curve.weights());
  const BernsteinPolynomial w0 = shortened(weight, 0), w1 = shortened(weight, 1);
  const auto velocity = [&](const BernsteinPolynomial& a) {
    return curve.degree() * (shortened(a, 1) * w0 - shortened(a, 0) * w1);
  };
  return {
      .weight = weight,
      .point = points,
      .velocity = divided({velocity(points[0]), velocity(points[1]), velocity(points[2])}, stops),
      .stops = stops};
}

}  // namespace seamwright
