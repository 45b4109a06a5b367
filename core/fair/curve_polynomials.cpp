// SPDX-License-Identifier: LGPL-2.1-or-later
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

}  // namespace

CurvePolynomials curvePolynomials(const BezierCurve& curve, const Eigen::RowVector3d& origin,
                                  double unit) {
  const PolynomialVector points = {coordinate(curve, 0, origin[0], unit),
                                   coordinate(curve, 1, origin[1], unit),
                                   coordinate(curve, 2, origin[2], unit)};
  if (!curve.isRational()) {
    const double weight = curve.homogeneousPoles()(0, 3);
    return {.weight = BernsteinPolynomial(Eigen::VectorXd::Constant(1, weight)),
            .point = points,
            .velocity = {weight * points[0].derivative(), weight * points[1].derivative(),
                         weight * points[2].derivative()}};
  }
  // With A = (1 - t) A0 + t A1, A0 and A1 of degree n - 1, A' W - A W' = n (A1 W0 - A0 W1).
  const BernsteinPolynomial weight(curve.weights());
  const BernsteinPolynomial w0 = shortened(weight, 0), w1 = shortened(weight, 1);
  const auto velocity = [&](const BernsteinPolynomial& a) {
    return curve.degree() * (shortened(a, 1) * w0 - shortened(a, 0) * w1);
  };
  return {.weight = weight,
          .point = points,
          .velocity = {velocity(points[0]), velocity(points[1]), velocity(points[2])}};
}

}  // namespace seamwright
