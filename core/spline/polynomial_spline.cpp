// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <seamwright/core/bezier/curve_difference.hpp>
#include <seamwright/core/bezier/hermite.hpp>
#include <seamwright/core/spline/polynomial_spline.hpp>

namespace seamwright {

namespace {

/// The curve of degree 2 n + 1 with the derivatives 0..n of the segment at both ends.
BezierCurve hermiteCurve(const BezierCurve& segment, int n) {
  const int degree = 2 * n + 1;
  Poles poles(degree + 1, 3);
  poles.topRows(n + 1) = polesFrom(segment.derivatives(0, n), degree);
  poles.bottomRows(n + 1) =
      polesFrom(segment.reversed().derivatives(0, n), degree).colwise().reverse();
  return BezierCurve(poles);
}

/// Segments of a polynomial spline as they come.
struct Builder {
  int order;
  double tolerance_mm;
  std::vector<BezierCurve> segments = {};
  std::vector<double> knots;
  double distance_mm = 0;

  void add(const BezierCurve& segment, double last, int halvings) {
    constexpr int most_halvings = 20;
    const BezierCurve near = hermiteCurve(segment, order);
    const double bound_mm = differenceBound(segment, near);
    if (bound_mm <= tolerance_mm) {
      segments.push_back(near);
      knots.push_back(last);
      distance_mm = std::max(distance_mm, bound_mm);
      return;
    }
    if (halvings == most_halvings)
      throw std::domain_error(fmt::format(
          "a part of 2^-{} of a rational segment is up to {:.3g} mm from its polynomial "
          "interpolant, more than {:.3g} mm",
          most_halvings, bound_mm, tolerance_mm));
    const auto [before, after] = segment.split(0.5);
    add(before, 0.5 * (knots.back() + last), halvings + 1);
    add(after, last, halvings + 1);
  }
};

}  // namespace

PolynomialSpline polynomialSpline(const BezierSpline& spline, int order, double tolerance_mm) {
  requireValid(spline);
  constexpr int most_order = 6;
  if (order < 1 || order > most_order)
    throw std::invalid_argument(fmt::format("order is {}: 1 to {} is possible", order, most_order));
  if (!(tolerance_mm > 0) || !std::isfinite(tolerance_mm))
    throw std::invalid_argument(
        fmt::format("the tolerance is {} mm: it must be positive and finite", tolerance_mm));
  if ((spline.poles.col(3).array() == 1).all()) return {.spline = spline};
  Builder builder{.order = order, .tolerance_mm = tolerance_mm, .knots = {spline.knots.front()}};
  for (int i = 0; i < spline.segments(); ++i) {
    const BezierCurve one = segment(spline, i);
    if (one.isRational()) {
      builder.add(one, spline.knots[i + 1], 0);
      continue;
    }
    builder.segments.emplace_back(one.poles());
    builder.knots.push_back(spline.knots[i + 1]);
  }
  if (spline.closed) {  // the ends are equal bitwise
    Poles poles = builder.segments.back().poles();
    poles.bottomRows<1>() = builder.segments.front().poles().topRows<1>();
    builder.segments.back() = BezierCurve(poles);
  }
  // Points at joints are computed twice, once for each side.
  constexpr double rounding = 1e-14;
  const double gap_mm = rounding * (1 + spline.poles.leftCols<3>().cwiseAbs().maxCoeff() /
                                            spline.poles.col(3).minCoeff());
  PolynomialSpline result;
  result.spline = bezierSpline(builder.segments, builder.knots, spline.closed, gap_mm);
  result.distance_mm = builder.distance_mm;
  result.added_joints = result.spline.segments() - spline.segments();
  return result;
}

}  // namespace seamwright
