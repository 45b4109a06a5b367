// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <seamwright/core/bernstein/polynomial.hpp>
#include <seamwright/core/bezier/curve_difference.hpp>
#include <seamwright/core/bezier/homogeneous.hpp>

namespace seamwright {

namespace {

/// A parameter of \p curve near \p point, at which both parts are at least a quarter.
double parameterNear(const BezierCurve& curve, const Eigen::Vector3d& point) {
  double t = 0.5;
  // Each step doubles the digits; more than the chords of the halves need has no use.
  for (int step = 0; step < 3; ++step) {
    const CurveDerivatives x = curve.derivatives(t, 1);
    const Eigen::Vector3d off = point - x.row(0).transpose(), velocity = x.row(1);
    const double next = t + off.dot(velocity) / velocity.squaredNorm();
    if (!std::isfinite(next)) return 0.5;
    t = std::clamp(next, 0.25, 0.75);
  }
  return t;
}

struct Limits {
  double enough_mm, allowed_mm;
};

double boundOfParts(const BezierCurve& x, const BezierCurve& y, const Limits& limits,
                    int halvings) {
  const double bound = differenceBound(x, y);
  if (bound <= limits.enough_mm || halvings == 0) return bound;
  const double t = parameterNear(x, y.point(0.5));
  if ((x.point(t) - y.point(0.5)).norm() > limits.allowed_mm) return bound;
  const auto [x_before, x_after] = x.split(t);
  const auto [y_before, y_after] = y.split(0.5);
  return std::max(boundOfParts(x_before, y_before, limits, halvings - 1),
                  boundOfParts(x_after, y_after, limits, halvings - 1));
}

}  // namespace

double differenceBound(const BezierCurve& x, const BezierCurve& y) {
  const Eigen::Vector3d origin = x.point(0);
  const HomogeneousPoles a = about(x.homogeneousPoles(), origin),
                         b = about(y.homogeneousPoles(), origin);
  const BernsteinPolynomial weight(a.col(3));
  double square = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Interval range =
        (BernsteinPolynomial(a.col(axis)) - weight * BernsteinPolynomial(b.col(axis))).range();
    square += std::pow(std::max(std::abs(range.lower), std::abs(range.upper)), 2);
  }
  // The poles about the origin are rounded by eps times their size.
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  const double size = std::max(a.leftCols<3>().cwiseAbs().maxCoeff() / a.col(3).minCoeff(),
                               b.leftCols<3>().cwiseAbs().maxCoeff()) +
                      origin.cwiseAbs().maxCoeff();
  return (1 + rounding) * std::sqrt(square) / weight.range().lower + rounding * size;
}

double correspondenceBound(const BezierCurve& x, const BezierCurve& y, double enough_mm,
                           double allowed_mm) {
  // With 2^8 parts the mismatch of parameters is 2^-16 of that of the whole.
  constexpr int most_halvings = 8;
  // A division rounds each pole by degree * eps of the largest, each time.
  const double largest = std::max(x.poles().cwiseAbs().maxCoeff(), y.poles().cwiseAbs().maxCoeff()),
               weights = x.weights().maxCoeff() / x.weights().minCoeff();
  const double rounding_mm = most_halvings * (x.degree() + y.degree() + 2) *
                             std::numeric_limits<double>::epsilon() * weights * largest;
  const Limits limits = {.enough_mm = enough_mm - rounding_mm, .allowed_mm = allowed_mm};
  return boundOfParts(x, y, limits, most_halvings) + rounding_mm;
}

}  // namespace seamwright
