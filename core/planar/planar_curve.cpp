// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <seamwright/core/bezier/stopped_ends.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/planar_curve.hpp>

namespace seamwright {

CurveFrame frameAt(const BezierCurve& segment, double t, int index) {
  if (const std::optional<Eigen::Vector3d> tangent = stoppedTangent(segment, t))
    return {.point = segment.point(t).head<2>(),
            .direction_rad = directionOf(Eigen::Vector2d(tangent->head<2>()))};
  const CurveDerivatives d = segment.derivatives(t, 3);
  const Eigen::Vector2d first = d.row(1).head<2>(), second = d.row(2).head<2>(),
                        third = d.row(3).head<2>();
  const double speed = first.norm();
  if (!(speed > 0)) {
    const Eigen::Vector3d point = segment.point(t);
    throw std::domain_error(
        fmt::format("the curve stops at ({:.6g}, {:.6g}), in segment {} at the parameter {}: it "
                    "has no tangent there",
                    point.x(), point.y(), index, t));
  }
  // docs/theory/planar.md P8.1.
  const double slope =
      cross(first, third) * speed * speed - 3 * first.dot(second) * cross(first, second);
  return {.point = d.row(0).head<2>(),
          .direction_rad = directionOf(first),
          .curvature_slope_per_mm2 = slope / std::pow(speed, 6)};
}

PlanarCurve planarCurve(const BezierSpline& spline) {
  PlanarCurve curve;
  for (int i = 0; i < spline.segments(); ++i) {
    const BezierCurve one = segment(spline, i);
    const Poles poles = one.poles();
    if (poles.col(2).any())
      refuse(fmt::format("segment {} is outside of the plane z = 0: it has a pole at z = {} mm", i,
                         poles.col(2).cwiseAbs().maxCoeff()));
    curve.segments.push_back(one);
    curve.polynomials.push_back(curvePolynomials(one, poles.row(0)));
    curve.origins.emplace_back(poles.row(0).head<2>());
  }
  return curve;
}

std::optional<AlongCircle> alongCircle(const PlanarCurve& curve, const Interval& range,
                                       const PlanarArc& arc, double tolerance_mm) {
  AlongCircle result;
  for (int i = static_cast<int>(range.lower); i < curve.count() && i < range.upper; ++i) {
    const Interval domain = {std::max(range.lower - i, 0.0), std::min(range.upper - i, 1.0)};
    if (!(domain.width() > 0)) continue;
    const auto along = alongCircle(
        {.polynomials = curve.polynomials[i], .origin = curve.origins[i], .domain = domain}, arc,
        tolerance_mm);
    if (!along) return std::nullopt;
    result.distance_mm = std::max(result.distance_mm, along->distance_mm);
    result.advance_mm += along->advance_mm;
  }
  return result;
}

}  // namespace seamwright
