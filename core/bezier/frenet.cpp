// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/frenet.hpp>
#include <seamwright/core/bezier/graded_derivatives.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using Eigen::Vector3d;

void requireUsable(const CurveDerivatives& derivatives, double speed_noise,
                   double acceleration_noise) {
  if (derivatives.rows() < 2)
    throw std::invalid_argument("derivatives have " + std::to_string(derivatives.rows()) +
                                " rows: at least point and first derivative are needed");
  for (Eigen::Index k = 0; k < derivatives.rows(); ++k)
    for (int i = 0; i < 3; ++i)
      if (!std::isfinite(derivatives(k, i)))
        throw std::invalid_argument("coordinate " + std::to_string(i) + " of derivative " +
                                    std::to_string(k) + " is " +
                                    bernstein::text(derivatives(k, i)) + ": it must be finite");
  for (const double noise : {speed_noise, acceleration_noise})
    if (!(noise >= 0) || !std::isfinite(noise))
      throw std::invalid_argument("noise is " + bernstein::text(noise) +
                                  ": it must be finite and not negative");
}

std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// The largest angle, in radians, by which an error turns a vector. \pre error < size
double turnedBy(double error, double size) {
  return std::asin(std::min(1.0, error / size)) + 4 * machine_epsilon;
}

bool isKnown(const GradedVector& vector) {
  return vector.value.norm() > vector.error;
}

/// Sets the tangent at a cusp: X(t + h) - X(t) begins with the first derivative that is not zero.
/// \param sense -1 if s decreases with t.
void setLeavingTangent(const GradedDerivatives& derivatives, double sense, FrenetFrame& frame) {
  frame.kind = CurvePoint::Point;
  double side = sense;
  for (const GradedVector& derivative : derivatives.by_order) {
    if (isKnown(derivative)) {
      frame.kind = CurvePoint::Cusp;
      frame.tangent = side * derivative.value.normalized();
      frame.tangent_error_rad = turnedBy(derivative.error, derivative.value.norm());
      return;
    }
    side *= sense;
  }
}

/// A value with a bound of its error.
struct Uncertain {
  double value, error;
};

/// The quotient x y^-n. \pre |y| exceeds its error.
Uncertain quotient(const Uncertain& x, const Uncertain& y, int n) {
  const double size = std::abs(y.value), least = size - y.error;
  const double inverse = std::pow(size, -n), most = std::pow(least, -n);
  return {x.value * inverse * (y.value < 0 && n % 2 != 0 ? -1 : 1),
          x.error * most + std::abs(x.value) * (most - inverse + (4 + n) * machine_epsilon * most)};
}

Uncertain product(const Uncertain& x, const Uncertain& y) {
  return {x.value * y.value, std::abs(x.value) * y.error + std::abs(y.value) * x.error +
                                 x.error * y.error + machine_epsilon * std::abs(x.value * y.value)};
}

Uncertain dot(const GradedVector& x, const GradedVector& y) {
  const double a = x.value.norm(), b = y.value.norm();
  return {x.value.dot(y.value),
          x.error * b + y.error * a + x.error * y.error + 4 * machine_epsilon * a * b};
}

GradedVector cross(const GradedVector& x, const GradedVector& y) {
  const double a = x.value.norm(), b = y.value.norm();
  return {x.value.cross(y.value),
          x.error * b + y.error * a + x.error * y.error + 4 * machine_epsilon * a * b,
          x.exponent + y.exponent};
}

/// The determinant of x, y, z. An error of one factor is multiplied by the area of the other two,
/// which is less than the product of their lengths.
Uncertain determinant(const GradedVector& x, const GradedVector& y, const GradedVector& z) {
  const double a = x.value.norm(), b = y.value.norm(), c = z.value.norm();
  const double first = x.error * y.value.cross(z.value).norm() +
                       y.error * x.value.cross(z.value).norm() +
                       z.error * x.value.cross(y.value).norm();
  const double higher = x.error * y.error * c + x.error * z.error * b + y.error * z.error * a +
                        x.error * y.error * z.error;
  return {x.value.cross(y.value).dot(z.value), first + higher + 12 * machine_epsilon * a * b * c};
}

void setFigure(const Uncertain& figure, int exponent, std::optional<double>& value,
               std::optional<double>& error) {
  value = finite(std::ldexp(figure.value, exponent));
  error = finite(std::ldexp(figure.error, exponent));
  // A value without a bound is of no use.
  if (!value || !error) value = error = std::nullopt;
}

/// The number value 2^exponent.
struct Scaled {
  Uncertain value;
  int exponent = 0;
};

/// The exponent of the largest term; terms that are zero are ignored.
int commonExponent(std::span<const Scaled> terms) {
  std::optional<int> common;
  for (const Scaled& term : terms)
    if (const double size = std::max(std::abs(term.value.value), term.value.error); size > 0)
      common = std::max(common.value_or(std::numeric_limits<int>::min()),
                        term.exponent + std::ilogb(size));
  return common.value_or(0);
}

/// The rate of change of curvature, divided by kappa / |d|: c.(d x d'') / |c|^2 - 3 d.d' / |d|^2 +
/// shift.
Scaled relativeChange(const GradedDerivatives& derivatives, const GradedVector& c) {
  const GradedVector &d = derivatives.by_order[0], &d2 = derivatives.by_order[1],
                     &d3 = derivatives.by_order[2];
  const Uncertain length{d.value.norm(), d.error}, area{c.value.norm(), c.error};
  const Scaled terms[] = {
      {quotient(dot(c, cross(d, d3)), area, 2), d3.exponent - d2.exponent},
      {quotient(dot(d, d2), length, 2), d2.exponent - d.exponent},
      {{derivatives.shift.value, derivatives.shift.error}, derivatives.shift.exponent}};
  const double factors[] = {1, -3, 1};
  Scaled sum{{0, 0}, commonExponent(terms)};
  for (int i = 0; i < 3; ++i) {
    const int by = terms[i].exponent - sum.exponent;
    const double value = std::ldexp(factors[i] * terms[i].value.value, by);
    sum.value.value += value;
    sum.value.error += std::ldexp(std::abs(factors[i]) * terms[i].value.error, by) +
                       4 * machine_epsilon * std::abs(value);
  }
  return sum;
}

/// Sets curvature and what follows from it.
/// \pre X' is known.
/// \param sense -1 if s decreases with t.
void setCurvature(const GradedDerivatives& derivatives, double sense, FrenetFrame& frame) {
  const GradedVector &d = derivatives.by_order[0], &d2 = derivatives.by_order[1];
  const GradedVector c = cross(d, d2);
  const Uncertain length{d.value.norm(), d.error}, area{c.value.norm(), c.error};
  const Uncertain kappa = quotient(area, length, 3);
  const int exponent = d2.exponent - 2 * d.exponent;
  setFigure(kappa, exponent, frame.curvature_per_mm, frame.curvature_error_per_mm);
  if (area.value <= area.error) {
    frame.kind = CurvePoint::Inflection;
    frame.curvature_per_mm = 0;
    frame.curvature_error_per_mm = std::ldexp(kappa.value + kappa.error, exponent);
    return;
  }
  const Vector3d B = sense * c.value / area.value;
  frame.binormal = B;
  frame.binormal_error_rad = turnedBy(area.error, area.value);
  frame.normal = B.cross(*frame.tangent);
  if (derivatives.by_order.size() < 3) return;
  const GradedVector& d3 = derivatives.by_order[2];
  setFigure(quotient(determinant(d, d2, d3), area, 2), d3.exponent - d.exponent - d2.exponent,
            frame.torsion_per_mm, frame.torsion_error_per_mm);
  const Scaled relative = relativeChange(derivatives, c);
  const Uncertain change = product(quotient(area, length, 4), relative.value);
  setFigure({sense * change.value, change.error}, d2.exponent - 3 * d.exponent + relative.exponent,
            frame.curvature_change_per_mm2, frame.curvature_change_error_per_mm2);
}

FrenetFrame frameOf(const GradedDerivatives& derivatives) {
  FrenetFrame frame;
  const GradedVector& d = derivatives.by_order[0];
  const GradedNumber& rate = derivatives.rate;
  const double sense = rate.value < 0 ? -1 : 1;
  const Uncertain speed = product({d.value.norm(), d.error}, {std::abs(rate.value), rate.error});
  frame.speed = std::ldexp(speed.value, d.exponent + rate.exponent);
  frame.speed_error = std::ldexp(speed.error, d.exponent + rate.exponent);
  if (!isKnown(d)) {
    setLeavingTangent(derivatives, sense, frame);
    return frame;
  }
  frame.kind = CurvePoint::Regular;
  frame.tangent = sense * d.value.normalized();
  frame.tangent_error_rad = turnedBy(d.error, d.value.norm());
  if (derivatives.by_order.size() > 1) setCurvature(derivatives, sense, frame);
  return frame;
}

GradedVector graded(const Vector3d& vector, double error) {
  GradedVector result;
  std::frexp(vector.cwiseAbs().maxCoeff(), &result.exponent);
  for (int i = 0; i < 3; ++i) result.value(i) = std::ldexp(vector(i), -result.exponent);
  result.error = std::ldexp(error, -result.exponent);
  return result;
}

}  // namespace

FrenetFrame frenetFrame(const CurveDerivatives& derivatives, double speed_noise,
                        double acceleration_noise) {
  requireUsable(derivatives, speed_noise, acceleration_noise);
  GradedDerivatives local;
  local.rate = {1, 0, 0};
  for (Eigen::Index k = 1; k < derivatives.rows(); ++k)
    local.by_order.push_back(graded(derivatives.row(k), k == 1 ? speed_noise : acceleration_noise));
  return frameOf(local);
}

FrenetFrame frenetFrame(const BezierCurve& curve, double t) {
  if (!std::isfinite(t))
    throw std::invalid_argument("parameter is " + bernstein::text(t) + ": it must be finite");
  const FrenetFrame frame = frameOf(gradedDerivatives(curve.homogeneousPoles(), t, 3));
  if (frame.kind != CurvePoint::Point || curve.degree() <= 3) return frame;
  return frameOf(gradedDerivatives(curve.homogeneousPoles(), t, curve.degree()));
}

}  // namespace seamwright
