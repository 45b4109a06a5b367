// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include <seamwright/core/bezier/hermite.hpp>
#include <seamwright/occ_adapter/blend/lateral_pace.hpp>

namespace seamwright::occ {

namespace {

BezierCurve paceCurve(const BlendEnd& start, const BlendEnd& end) {
  const int degree = start.order + end.order + 1;
  const auto derivatives = [](const BlendEnd& of, double sense, double at) {
    CurveDerivatives rows = CurveDerivatives::Zero(of.order + 1, 3);
    rows.row(0) << at, at, 0;
    if (of.order > 0) rows(1, 0) = sense * of.tension;
    return rows;
  };
  Poles poles(degree + 1, 3);
  poles.topRows(start.order + 1) = polesFrom(derivatives(start, 1, 0), degree);
  poles.bottomRows(end.order + 1) = polesFrom(derivatives(end, -1, 1), degree).colwise().reverse();
  return BezierCurve(poles);
}

}  // namespace

LateralPace::LateralPace(const BlendEnd& start, const BlendEnd& end)
    : curve_(paceCurve(start, end)) {
  constexpr int samples = 64;
  constexpr double least_slope = 0.05;  // a choice: slower, the lines along the sides are crowded
  for (int i = 0; i <= samples; ++i) {
    const double v = static_cast<double>(i) / samples;
    if (!(curve_.derivatives(v, 1)(1, 0) >= std::min({least_slope, start.tension, end.tension})))
      throw std::invalid_argument(
          fmt::format("the tensions {:.3g} and {:.3g} are too large for lateral boundaries: lines "
                      "across would turn back; G3 allows 1.8 at both ends, G2 2, G1 2.9",
                      start.tension, end.tension));
  }
}

double LateralPace::parameterOf(double share) const {
  double low = 0, high = 1;
  constexpr int halvings = 60;  // more than a double has digits
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (shareAt(middle) < share ? low : high) = middle;
  }
  return high;
}

}  // namespace seamwright::occ
