// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <seamwright/core/bezier/length.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/conic.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

Eigen::RowVector3d inPlane(const Vector2d& point) {
  return {point.x(), point.y(), 0};
}

/// Curvature at the start; with the corner and the far end it is that of the end, seen backwards.
double endpointCurvature(const Vector2d& at, const Vector2d& corner, const Vector2d& far,
                         double weight) {
  const Vector2d edge = corner - at;
  const double area = cross(edge, far - corner) / 2;
  return area / (weight * weight * std::pow(edge.norm(), 3));
}

/// The derivative of the point times the square of the weight at t: P8.2 for the degree 2.
Vector2d weightedVelocity(const PlanarConic& conic, double t) {
  const double w = 2 * conic.weight;
  return (1 - t) * (1 - t) * w * (conic.corner - conic.start) +
         2 * t * (1 - t) * (conic.end - conic.start) + t * t * w * (conic.end - conic.corner);
}

}  // namespace

double PlanarConic::turn_rad() const {
  return angleFromTo(corner - start, end - corner);
}

double PlanarConic::startCurvature_per_mm() const {
  return endpointCurvature(start, corner, end, weight);
}

double PlanarConic::endCurvature_per_mm() const {
  return -endpointCurvature(end, corner, start, weight);
}

Vector2d PlanarConic::point(double t) const {
  const double a = (1 - t) * (1 - t), b = 2 * weight * t * (1 - t), c = t * t;
  return (a * start + b * corner + c * end) / (a + b + c);
}

double PlanarConic::directionAt_rad(double t) const {
  return directionOf(weightedVelocity(*this, t));
}

double PlanarConic::curvatureAt_per_mm(double t) const {
  const double weight_at = (1 - t) * (1 - t) + 2 * weight * t * (1 - t) + t * t;
  return 4 * weight * cross(corner - start, end - corner) *
         std::pow(weight_at / weightedVelocity(*this, t).norm(), 3);
}

double PlanarConic::length_mm() const {
  const BezierCurve curve = bezierCurve(*this);
  // No segment is longer than its polygon, so the first enclosure needs no division.
  const double polygon_mm = (corner - start).norm() + (end - corner).norm();
  if (polygon_mm == 0) return 0;
  const double rough_mm = arcLength(curve, polygon_mm).value_mm;
  return rough_mm > 0 ? arcLength(curve, 1e-10 * rough_mm).value_mm : 0;
}

PlanarConic reversed(const PlanarConic& conic) {
  return {.start = conic.end, .corner = conic.corner, .end = conic.start, .weight = conic.weight};
}

std::array<PlanarConic, 2> halves(const PlanarConic& conic) {
  const double w = conic.weight;
  const Vector2d left = (conic.start + w * conic.corner) / (1 + w);
  const Vector2d right = (conic.end + w * conic.corner) / (1 + w);
  const Vector2d shoulder = (left + right) / 2;
  const double weight = std::sqrt((1 + w) / 2);
  return {PlanarConic{.start = conic.start, .corner = left, .end = shoulder, .weight = weight},
          PlanarConic{.start = shoulder, .corner = right, .end = conic.end, .weight = weight}};
}

BezierCurve bezierCurve(const PlanarConic& conic) {
  Poles poles(3, 3);
  poles << inPlane(conic.start), inPlane(conic.corner), inPlane(conic.end);
  return BezierCurve(poles, Eigen::Vector3d(1, conic.weight, 1));
}

PlanarConic conicOf(const PlanarArc& arc) {
  const double half_rad = arc.sweep_rad() / 2;
  if (!(std::abs(half_rad) < std::numbers::pi / 2)) {
    throw std::domain_error(fmt::format(
        "an arc that turns by {} rad is not a single conic segment: it turns by pi or more",
        arc.sweep_rad()));
  }
  const Vector2d end = arc.end();
  const double edge_mm = (end - arc.start).norm() / 2 / std::cos(half_rad);
  return {.start = arc.start,
          .corner = arc.start + edge_mm * unitVector(arc.direction_rad),
          .end = end,
          .weight = std::cos(half_rad)};
}

std::vector<PlanarConic> conicsOf(const std::vector<PlanarArc>& arcs) {
  std::vector<PlanarConic> conics;
  for (const PlanarArc& arc : arcs) {
    const int parts = 1 + static_cast<int>(std::abs(arc.sweep_rad()) / (2 * std::numbers::pi / 3));
    for (int i = 0; i < parts; ++i) {
      const double share = static_cast<double>(i) / parts;
      conics.push_back(conicOf({.start = i == 0 ? arc.start : conics.back().end,
                                .direction_rad = arc.direction_rad + share * arc.sweep_rad(),
                                .curvature_per_mm = arc.curvature_per_mm,
                                .length_mm = arc.length_mm / parts}));
    }
  }
  return conics;
}

std::array<PlanarConic, 2> twoConics(const TwoConicsEnds& ends) {
  const double turn_rad = angleFromTo(ends.apex - ends.start, ends.end - ends.apex);
  const double k0 = ends.start_curvature_per_mm, k1 = ends.end_curvature_per_mm;
  if (!std::isfinite(turn_rad) || !std::isfinite(k0) || !std::isfinite(k1))
    refuse("two conics: a point or a curvature is not finite");
  if (turn_rad == 0 || std::abs(turn_rad) == std::numbers::pi)
    refuse("two conics: start, apex and end lie on a line");
  if (!(k0 * turn_rad > 0 && k1 * turn_rad > 0)) {
    refuse(fmt::format(
        "two conics: the curvatures {} and {} /mm do not have the sign of the turn, {} rad", k0, k1,
        turn_rad));
  }
  for (const double share : {ends.start_share, ends.end_share}) {
    if (!(share > 0 && share < 1))
      refuse(fmt::format("two conics: the share {} is not between 0 and 1", share));
  }
  const Vector2d first = ends.start + ends.start_share * (ends.apex - ends.start);
  const Vector2d last = ends.end + ends.end_share * (ends.apex - ends.end);
  const double first_mm = (first - ends.start).norm(), last_mm = (last - ends.end).norm();
  const double ratio = first_mm / last_mm * std::cbrt(k0 / k1);
  const Vector2d joint = (first + ratio * last) / (1 + ratio);
  // The curvature at an end is that for the weight 1 over the square of the weight.
  const auto weight = [](const Vector2d& at, const Vector2d& corner, const Vector2d& far,
                         double curvature) {
    return std::sqrt(std::abs(endpointCurvature(at, corner, far, 1) / curvature));
  };
  return {PlanarConic{.start = ends.start,
                      .corner = first,
                      .end = joint,
                      .weight = weight(ends.start, first, joint, k0)},
          PlanarConic{.start = joint,
                      .corner = last,
                      .end = ends.end,
                      .weight = weight(ends.end, last, joint, k1)}};
}

ConicCurvature curvatureKind(const PlanarConic& conic) {
  const Vector2d chord = conic.end - conic.start;
  const double squared_weight = conic.weight * conic.weight;
  const Vector2d to_centre = chord / (4 * squared_weight);
  const double radius_mm = to_centre.norm();
  const bool inside_first = (conic.corner - conic.start - to_centre).norm() < radius_mm;
  const bool inside_last = (conic.corner - conic.end + to_centre).norm() < radius_mm;
  if (inside_first && inside_last) return ConicCurvature::OneMinimum;
  if (!inside_first && !inside_last) return ConicCurvature::OneMaximum;
  return squared_weight >= 0.5 ? ConicCurvature::Monotone : ConicCurvature::MaximumAndMinimum;
}

BezierSpline bezierSpline(const std::vector<PlanarConic>& chain, bool closed) {
  if (chain.empty()) refuse("a chain of conics is empty");
  std::vector<BezierCurve> segments;
  std::vector<double> knots = {0};
  for (std::size_t i = 0; i < chain.size(); ++i) {
    PlanarConic conic = chain[i];
    if (i + 1 < chain.size()) conic.end = chain[i + 1].start;
    if (closed && i + 1 == chain.size()) conic.end = chain.front().start;
    segments.push_back(bezierCurve(conic));
    knots.push_back(knots.back() + (conic.corner - conic.start).norm() +
                    (conic.end - conic.corner).norm());
  }
  return bezierSpline(segments, knots, closed);
}

}  // namespace seamwright
