// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc_distance.hpp>

namespace seamwright {

namespace {

using Polynomial = BernsteinPolynomial;

/// What decides how a curve runs beside a circle, for p = P / W from the start of the arc, with the
/// unit tangent T and the left normal n there.
struct CirclePolynomials {
  /// h W^2 = k |P|^2 - 2 W (P . n). The signed distance from the circle is h / (1 + sqrt(1 + k h)).
  Polynomial offset;
  /// The speed of the projection has the sign of k (P x D) + W (T . D).
  Polynomial advance;
  Polynomial x_velocity, y_velocity;
  Polynomial weight;
};

CirclePolynomials circlePolynomials(const CurvePiece& piece, const PlanarArc& arc) {
  const CurvePolynomials& curve = piece.polynomials;
  const Eigen::Vector2d shift = piece.origin - arc.start;
  // The shift has one rounding; a product by it must not hide that.
  const auto from_start = [&](int axis) {
    const Polynomial moved(Eigen::VectorXd::Constant(1, shift[axis]),
                           machine_epsilon * std::abs(shift[axis]));
    return curve.point[axis] + moved * curve.weight;
  };
  const Polynomial x = from_start(0), y = from_start(1);
  const Polynomial &w = curve.weight, &dx = curve.velocity[0], &dy = curve.velocity[1];
  const Eigen::Vector2d tangent = unitVector(arc.direction_rad);
  const double k = arc.curvature_per_mm;
  const Polynomial left = tangent.x() * y - tangent.y() * x;
  return {.offset = k * (x * x + y * y) - 2 * (w * left),
          .advance = k * (x * dy - y * dx) + w * (tangent.x() * dx + tangent.y() * dy),
          .x_velocity = dx,
          .y_velocity = dy,
          .weight = w};
}

/// Upper bound of |h| on an interval.
double offsetBound(const CirclePolynomials& circle, const Interval& domain) {
  const double least_weight = circle.weight.restricted(domain).range().lower;
  if (!(least_weight > 0)) return infinite;
  return circle.offset.restricted(domain).range().magnitude() / (least_weight * least_weight);
}

/// |h| in the middle of an interval; no bound.
double offsetInside(const CirclePolynomials& circle, const Interval& domain) {
  const double t = domain.middle(), w = circle.weight.evaluate(t).middle();
  return std::abs(circle.offset.evaluate(t).middle()) / (w * w);
}

/// The distance from the circle that belongs to a bound of |h|; the inside is the worse side.
double distanceFrom(double offset_mm, double curvature_per_mm) {
  const double inside = 1 - std::abs(curvature_per_mm) * offset_mm;
  return inside > 0 ? offset_mm / (1 + std::sqrt(inside)) : infinite;
}

/// Whether the projection moves forward throughout, and by less than a full turn: the velocity then
/// has a positive part in the direction of the chord.
bool advances(const CirclePolynomials& circle, const Interval& domain,
              const Eigen::Vector2d& chord) {
  if (!(circle.advance.restricted(domain).range().lower > 0)) return false;
  const Polynomial along = chord.x() * circle.x_velocity.restricted(domain) +
                           chord.y() * circle.y_velocity.restricted(domain);
  return along.range().lower > 0;
}

}  // namespace

std::optional<AlongCircle> alongCircle(const CurvePiece& piece, const PlanarArc& arc,
                                       double tolerance_mm) {
  // A bound is good enough if it exceeds a value inside by 2 percent, or is below 1 percent of the
  // tolerance. Each division brings the bounds closer by a factor of 4, so a few do.
  constexpr double enough = 1.02, negligible = 0.01;
  // Of the domain. A bound of the work where the point turns back or bounds do not come close.
  constexpr double smallest_share = 0x1p-12;
  const CirclePolynomials circle = circlePolynomials(piece, arc);
  const double k = arc.curvature_per_mm;
  const auto pointAt = [&](double t) -> Eigen::Vector2d {
    const double w = piece.polynomials.weight.evaluate(t).middle();
    return piece.origin + Eigen::Vector2d(piece.polynomials.point[0].evaluate(t).middle(),
                                          piece.polynomials.point[1].evaluate(t).middle()) /
                              w;
  };
  /// The vector from the centre, times the curvature; its length is near 1.
  const Eigen::Vector2d normal(-std::sin(arc.direction_rad), std::cos(arc.direction_rad));
  const auto fromCentre = [&](const Eigen::Vector2d& point) -> Eigen::Vector2d {
    return k * (point - arc.start) - normal;
  };
  AlongCircle result;
  std::vector<Interval> parts = {piece.domain};
  while (!parts.empty()) {
    const Interval part = parts.back();
    parts.pop_back();
    const Eigen::Vector2d from = pointAt(part.lower), to = pointAt(part.upper);
    const double bound_mm = distanceFrom(offsetBound(circle, part), k);
    const double inside_mm = distanceFrom(offsetInside(circle, part), k);
    if (inside_mm > tolerance_mm) return std::nullopt;
    const bool close =
        bound_mm <= tolerance_mm && (bound_mm <= enough * std::max(inside_mm, result.distance_mm) ||
                                     bound_mm <= negligible * tolerance_mm);
    if (!close || !advances(circle, part, to - from)) {
      if (part.width() <= smallest_share * piece.domain.width()) return std::nullopt;
      parts.push_back({part.middle(), part.upper});
      parts.push_back({part.lower, part.middle()});
      continue;
    }
    result.distance_mm = std::max(result.distance_mm, bound_mm);
    const Eigen::Vector2d a = fromCentre(from), b = fromCentre(to);
    const double angle_rad = angleFromTo(a, b);
    // The projection of a short way on a flat circle: by its tangent, since the angle loses digits.
    constexpr double flat_rad = 1e-6;
    const Eigen::Vector2d tangent = Eigen::Vector2d(-a.y() - b.y(), a.x() + b.x()).normalized();
    result.advance_mm +=
        std::abs(angle_rad) < flat_rad || k == 0 ? tangent.dot(to - from) : angle_rad / k;
  }
  // Rounding of the arc's own points and directions.
  const double size =
      piece.origin.cwiseAbs().maxCoeff() + arc.start.cwiseAbs().maxCoeff() + arc.length_mm;
  result.distance_mm += 8 * machine_epsilon * size;
  if (result.distance_mm > tolerance_mm) return std::nullopt;
  return result;
}

}  // namespace seamwright
