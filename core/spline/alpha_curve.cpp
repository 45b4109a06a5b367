// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <seamwright/core/spline/alpha_curve.hpp>
#include <seamwright/core/spline/alpha_form.hpp>

namespace seamwright {

namespace {

void requirePoles(const AlphaCurve::Polygon& poles) {
  for (int i = 0; i < 4; ++i)
    if (!poles.row(i).allFinite())
      throw std::invalid_argument("pole " + std::to_string(i) + " is (" +
                                  bernstein::text(poles(i, 0)) + ", " +
                                  bernstein::text(poles(i, 1)) + ", " +
                                  bernstein::text(poles(i, 2)) + "): it must be finite");
}

/// First differences of the quintic's poles: those for a = 0, and their derivative by a.
struct Differences {
  Poles without, by_shape;
};

/// Computed from the legs of the polygon, which are independent of the origin.
Differences differences(const AlphaCurve::Polygon& legs) {
  const Eigen::RowVector3d half = legs.row(1) / 2;
  Differences result{Poles::Zero(5, 3), Poles::Zero(5, 3)};
  result.without.row(1) = legs.row(0) + half;
  result.without.row(3) = legs.row(2) + half;
  result.by_shape << legs.row(0), -legs.row(0), Eigen::RowVector3d::Zero(), -legs.row(2),
      legs.row(2);
  return result;
}

/// Poles of the k-th derivative from first differences of the poles.
Poles derivativePoles(Poles differences, int k) {
  double scale = 5;
  for (int i = 1; i < k; ++i) {
    const Eigen::Index n = differences.rows() - 1;
    differences = (differences.bottomRows(n) - differences.topRows(n)).eval();
    scale *= 5 - i;
  }
  return scale * differences;
}

/// The integral over [0, 1] of the scalar product of two curves of the same degree.
double product(const Poles& x, const Poles& y) {
  const Eigen::Index n = x.rows() - 1;
  const Eigen::VectorXd &row = bernstein::binomials(n), &doubled = bernstein::binomials(2 * n);
  double sum = 0;
  for (Eigen::Index i = 0; i <= n; ++i)
    for (Eigen::Index j = 0; j <= n; ++j)
      sum += row(i) * row(j) / doubled(i + j) * x.row(i).dot(y.row(j));
  return sum / static_cast<double>(2 * n + 1);
}

void requireBounds(double a_min, double a_max) {
  alpha::requireWithin("a_min", a_min, 0, 1);
  alpha::requireWithin("a_max", a_max, a_min, 1);
}

}  // namespace

Eigen::Vector4d alphaBasis(double a, double t) {
  alpha::requireWithin("a", a, 0, 1);
  alpha::requireWithin("t", t, 0, 1);
  const double s = 1 - t, s4 = s * s * s * s, t4 = t * t * t * t, middle = 5 * s * s * t * t;
  return {s4 * (s + 5 * (1 - a) * t), 5 * a * s4 * t + middle, middle + 5 * a * s * t4,
          t4 * (5 * (1 - a) * s + t)};
}

BezierCurve alphaCurveBezier(const AlphaCurve& curve) {
  requirePoles(curve.poles);
  alpha::requireWithin("a", curve.a, 0, 1);
  return BezierCurve(Poles(alpha::quintic(curve.a) * curve.poles));
}

Poles alphaJoinPoles(const AlphaCurve& given, const AlphaCurveJoin& join) {
  requirePoles(given.poles);
  alpha::requireWithin("a", given.a, alpha::kSmallestShape, 1);
  alpha::requireWithin("next_a", join.next_a, alpha::kSmallestShape, 1);
  alpha::requireJoin(join);
  const Eigen::RowVector3d end = given.poles.row(3), along = end - given.poles.row(2);
  if (along.isZero(0))
    throw std::invalid_argument("poles 2 and 3 are the same: the curve has no tangent at its end");
  const double beta2 =
      join.order == 3 ? alpha::beta2OfG3(join.beta1, join.length, join.next_length) : join.beta2;
  const alpha::Factors factors =
      alpha::factors({given.a, join.length}, {join.next_a, join.next_length}, join.beta1, beta2);
  Poles next(join.order == 1 ? 2 : 3, 3);
  next.row(0) = end;
  next.row(1) = end + factors.first * along;
  if (join.order > 1)
    next.row(2) = end + factors.second * along + factors.third * (given.poles.row(1) - end);
  alpha::requireInRange(next);
  return next;
}

AlphaOptimum energyOptimalAlpha(const AlphaCurve::Polygon& poles, AlphaEnergy energy, double a_min,
                                double a_max) {
  requirePoles(poles);
  requireBounds(a_min, a_max);
  const int k = static_cast<int>(energy);
  AlphaCurve::Polygon legs = AlphaCurve::Polygon::Zero();
  legs.topRows<3>() = poles.bottomRows<3>() - poles.topRows<3>();
  const double size = std::max(legs.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
  const auto [without, by_shape] = differences(legs / size);
  const Poles f = derivativePoles(without, k), g = derivativePoles(by_shape, k);
  AlphaOptimum optimum;
  optimum.any = legs.row(0).isZero(0) && legs.row(2).isZero(0);
  if (!optimum.any) optimum.free_a = -product(f, g) / product(g, g);
  optimum.a = std::clamp(optimum.free_a, a_min, a_max);
  const Poles derivative = f + optimum.a * g;
  optimum.energy = product(derivative, derivative) * size * size;
  return optimum;
}

}  // namespace seamwright
