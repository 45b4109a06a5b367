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

/// The arc length over which a short piece can move on the circle from its start, to both sides.
/// Nothing if it may be more than a quarter of the circle.
std::optional<double> movement(const CirclePolynomials& circle, const Interval& domain,
                               double curvature_per_mm, double distance_mm) {
  const double least_weight = circle.weight.restricted(domain).range().lower;
  const double closer = 1 - std::abs(curvature_per_mm) * distance_mm;
  if (!(least_weight > 0) || !(closer > 0)) return std::nullopt;
  const double speed = std::hypot(circle.x_velocity.restricted(domain).range().magnitude(),
                                  circle.y_velocity.restricted(domain).range().magnitude());
  const double length_mm = speed * domain.width() / (least_weight * least_weight * closer);
  constexpr double quarter_rad = 1.5;
  if (!(length_mm * std::abs(curvature_per_mm) < quarter_rad)) return std::nullopt;
  return length_mm;
}

/// Arc lengths on a circle.
struct CircleInterval {
  double from_mm = 0, to_mm = 0;
};

/// Of points that are near the circle and project on an interval of it: the distance from the arc.
double distanceFromArc(const PlanarArc& arc, const CircleInterval& interval, double distance_mm) {
  const double beyond_mm = std::max({0.0, -interval.from_mm, interval.to_mm - arc.length_mm});
  const double wider = 1 + std::abs(arc.curvature_per_mm) * distance_mm;
  return std::sqrt(distance_mm * distance_mm + wider * beyond_mm * beyond_mm);
}

Eigen::Vector2d pointOf(const CurvePiece& piece, double t) {
  const double weight = piece.polynomials.weight.evaluate(t).middle();
  return piece.origin + Eigen::Vector2d(piece.polynomials.point[0].evaluate(t).middle(),
                                        piece.polynomials.point[1].evaluate(t).middle()) /
                            weight;
}

/// How far the projection of a short way moves along the circle of an arc.
double advanceAlong(const PlanarArc& arc, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const double k = arc.curvature_per_mm;
  const Eigen::Vector2d normal(-std::sin(arc.direction_rad), std::cos(arc.direction_rad));
  // The vectors from the centre, times the curvature; their lengths are near 1.
  const Eigen::Vector2d a = k * (from - arc.start) - normal, b = k * (to - arc.start) - normal;
  const double angle_rad = angleFromTo(a, b);
  // On a flat circle by its tangent, since the angle loses digits.
  constexpr double flat_rad = 1e-6;
  if (std::abs(angle_rad) >= flat_rad && k != 0) return angle_rad / k;
  return Eigen::Vector2d(-a.y() - b.y(), a.x() + b.x()).normalized().dot(to - from);
}

/// \param begin_mm where the piece begins on the arc, if its projection may turn back.
std::optional<AlongCircle> besideCircle(const CurvePiece& piece, const PlanarArc& arc,
                                        double tolerance_mm, std::optional<double> begin_mm) {
  // A bound is good enough if it exceeds a value inside by 2 percent and 1 percent of the
  // tolerance. Each division brings the bounds closer by a factor of 4, so a few do.
  constexpr double enough = 1.02, negligible = 0.01;
  // Of the domain. A bound of the work where the point turns back or bounds do not come close.
  constexpr double smallest_share = 0x1p-12;
  const CirclePolynomials circle = circlePolynomials(piece, arc);
  const double k = arc.curvature_per_mm;
  AlongCircle result;
  std::vector<Interval> parts = {piece.domain};
  while (!parts.empty()) {
    const Interval part = parts.back();
    parts.pop_back();
    const Eigen::Vector2d from = pointOf(piece, part.lower), to = pointOf(piece, part.upper);
    const double bound_mm = distanceFrom(offsetBound(circle, part), k);
    const double inside_mm = distanceFrom(offsetInside(circle, part), k);
    if (inside_mm > tolerance_mm) return std::nullopt;
    const bool close =
        bound_mm <= tolerance_mm &&
        bound_mm <= enough * std::max(inside_mm, result.distance_mm) + negligible * tolerance_mm;
    const auto divide = [&] {
      if (part.width() <= smallest_share * piece.domain.width()) return false;
      parts.push_back({part.middle(), part.upper});
      parts.push_back({part.lower, part.middle()});
      return true;
    };
    if (!close) {
      if (!divide()) return std::nullopt;
      continue;
    }
    const double advance_mm = advanceAlong(arc, from, to);
    const bool forward = advances(circle, part, to - from);
    const std::optional<double> most_mm =
        forward || !begin_mm ? std::nullopt : movement(circle, part, k, bound_mm);
    double distance_mm = infinite;
    if (forward || most_mm) distance_mm = bound_mm;
    if (begin_mm && (forward || most_mm)) {
      const double at_mm = *begin_mm + result.advance_mm;
      const CircleInterval interval{.from_mm = at_mm - most_mm.value_or(0),
                                    .to_mm = at_mm + most_mm.value_or(advance_mm)};
      distance_mm = distanceFromArc(arc, interval, bound_mm);
    }
    if (distance_mm > tolerance_mm) {
      if (!divide()) return std::nullopt;
      continue;
    }
    result.distance_mm = std::max(result.distance_mm, distance_mm);
    result.advance_mm += advance_mm;
  }
  // Rounding of the arc's own points and directions.
  const double size =
      piece.origin.cwiseAbs().maxCoeff() + arc.start.cwiseAbs().maxCoeff() + arc.length_mm;
  result.distance_mm += 8 * machine_epsilon * size;
  if (result.distance_mm > tolerance_mm) return std::nullopt;
  return result;
}

}  // namespace

std::optional<AlongCircle> alongCircle(const CurvePiece& piece, const PlanarArc& arc,
                                       double tolerance_mm) {
  return besideCircle(piece, arc, tolerance_mm, std::nullopt);
}

std::optional<AlongCircle> besideArc(const CurvePiece& piece, const PlanarArc& arc,
                                     double tolerance_mm, double begin_mm) {
  return besideCircle(piece, arc, tolerance_mm, begin_mm);
}

}  // namespace seamwright
