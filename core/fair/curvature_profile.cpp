// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include <seamwright/core/bernstein/sign_changes.hpp>
#include <seamwright/core/fair/curvature_profile.hpp>
#include <seamwright/core/fair/curve_polynomials.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using Polynomial = BernsteinPolynomial;

/// A power of 2 near the size of the curve.
double unitOf(const Poles& poles) {
  const double extent = (poles.rowwise() - poles.row(0)).cwiseAbs().maxCoeff();
  return extent > 0 ? std::exp2(std::ilogb(extent)) : 1;
}

/// The curve from its first pole, in a unit of its size, so that products of many coordinates do
/// not overflow.
CurvePolynomials polynomialsOf(const BezierCurve& curve) {
  const Poles poles = curve.poles();
  return curvePolynomials(curve, poles.row(0), unitOf(poles));
}

Polynomial dot(const PolynomialVector& a, const PolynomialVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

PolynomialVector derivative(const PolynomialVector& a) {
  return {a[0].derivative(), a[1].derivative(), a[2].derivative()};
}

Polynomial crossInPlane(const PolynomialVector& a, const PolynomialVector& b) {
  return a[0] * b[1] - a[1] * b[0];
}

PolynomialVector cross(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

void requireDegree(const BezierCurve& curve) {
  if (curve.degree() < 1) refuse("a curve of degree 0 has no curvature");
}

void requirePlane(const BezierCurve& curve) {
  requireDegree(curve);
  const HomogeneousPoles& poles = curve.homogeneousPoles();
  for (Eigen::Index i = 0; i < poles.rows(); ++i) {
    if (poles(i, 2) != 0)
      refuse(fmt::format("pole {} of the curve is outside of the plane z = 0, at z = {} mm", i,
                         poles(i, 2) / poles(i, 3)));
  }
}

/// \param squared_speed of the curve, up to a positive factor.
void requireMotion(const BezierCurve& curve, const Polynomial& squared_speed) {
  const SignChanges zeros = signChanges(squared_speed);
  if (zeros.undecided.empty() && zeros.changes.empty()) return;
  const Interval where =
      zeros.undecided.empty() ? zeros.changes.front().interval : zeros.undecided.front();
  const Eigen::Vector3d point = curve.point(where.middle());
  throw std::domain_error(
      fmt::format("the curve may stop at the parameter {:.6g}, at ({:.6g}, {:.6g}, {:.6g}), as in "
                  "a cusp: its speed is not certainly "
                  "above 0",
                  where.middle(), point.x(), point.y(), point.z()));
}

/// What has the sign of the derivative of the curvature of a curve with stopped ends.
/// \param slope for the velocity without the factor f = t^a (1 - t)^b. \param product weight,
/// turn and squared speed. \returns slope g - product h with g = t (1 - t) and h = g f' / f,
/// without the factor t or 1 - t of an end that does not stop. Source: docs/theory/planar.md P8.7.
Polynomial withStops(const Polynomial& slope, const Polynomial& product, const StoppedEnds& stops) {
  if (!stops.any()) return slope;
  const Polynomial one(Eigen::VectorXd::Ones(1));
  const Polynomial t = stops.start > 0 ? Polynomial(Eigen::Vector2d(0, 1)) : one;
  const Polynomial rest = stops.end > 0 ? Polynomial(Eigen::Vector2d(1, 0)) : one;
  return slope * (t * rest) - product * (stops.start * rest - stops.end * t);
}

/// The number of leading coefficients that rounding can't tell from 0.
int zerosAtStart(const Polynomial& p) {
  int count = 0;
  while (count <= p.degree() && std::abs(p.coefficients()[count]) <= p.padding()) ++count;
  return count;
}

/// Curvature at a parameter; signed for a curve in the plane z = 0.
double curvatureAt(const BezierCurve& curve, double t, bool in_plane) {
  const CurveDerivatives d = curve.derivatives(t, 2);
  // In a unit of its size, so that the products do not overflow.
  const double speed = d.row(1).cwiseAbs().maxCoeff();
  const double unit = speed > 0 ? std::exp2(std::ilogb(speed)) : 1;
  const Eigen::Vector3d first = d.row(1) / unit, second = d.row(2) / unit;
  const Eigen::Vector3d turn = first.cross(second);
  return (in_plane ? turn.z() : turn.norm()) / std::pow(first.norm(), 3) / unit;
}

/// \param slope has the sign of the derivative of the curvature, \param turn that of the curvature.
CurvatureProfile profile(const BezierCurve& curve, const Polynomial& slope, const Polynomial& turn,
                         bool in_plane) {
  CurvatureProfile result;
  SignChanges extrema = signChanges(slope), inflections = signChanges(turn);
  for (const SignChange& change : extrema.changes) {
    result.extrema.push_back(
        {.parameters = change.interval,
         .maximum = !change.to_positive,
         .curvature_per_mm = curvatureAt(curve, change.interval.middle(), in_plane)});
  }
  for (const SignChange& change : inflections.changes)
    result.inflections.push_back(change.interval);
  result.undecided_extrema = std::move(extrema.undecided);
  result.undecided_inflections = std::move(inflections.undecided);
  return result;
}

}  // namespace

CurvatureProfile planarCurvatureProfile(const BezierCurve& curve) {
  requirePlane(curve);
  const CurvePolynomials motion = polynomialsOf(curve);
  const Polynomial &w = motion.weight, w1 = w.derivative();
  const Polynomial s = dot(motion.velocity, motion.velocity);
  requireMotion(curve, s);
  const Polynomial c = crossInPlane(motion.velocity, derivative(motion.velocity));
  const Polynomial slope =
      (2 * (w1 * c) + w * c.derivative()) * s - 1.5 * (w * (c * s.derivative()));
  return profile(curve, withStops(slope, w * (c * s), motion.stops), c, true);
}

CurvatureProfile spaceCurvatureProfile(const BezierCurve& curve) {
  requireDegree(curve);
  const CurvePolynomials motion = polynomialsOf(curve);
  const Polynomial &w = motion.weight, w1 = w.derivative();
  const Polynomial s = dot(motion.velocity, motion.velocity);
  requireMotion(curve, s);
  const PolynomialVector c = cross(motion.velocity, derivative(motion.velocity));
  const Polynomial q = dot(c, c);
  const Polynomial slope = (4 * (w1 * q) + w * q.derivative()) * s - 3 * (w * (q * s.derivative()));
  // The curvature is squared, and so is the factor of the speed.
  return profile(curve, withStops(slope, 2 * (w * (q * s)), motion.stops), q, false);
}

EndCurvature startCurvature(const BezierCurve& curve) {
  requirePlane(curve);
  const CurvePolynomials motion = polynomialsOf(curve);
  requireMotion(curve, dot(motion.velocity, motion.velocity));
  const Polynomial c = crossInPlane(motion.velocity, derivative(motion.velocity));
  const int zeros = zerosAtStart(c), stops = motion.stops.start;
  if (zeros > c.degree()) return {};
  const double turn = c.coefficients()[zeros];
  const bool finite_energy = 2 * zeros >= stops;
  if (zeros < stops)
    return {.curvature_per_mm = std::copysign(infinite, turn), .finite_energy = finite_energy};
  if (zeros > stops) return {};
  double binomial = 1;
  for (int i = 0; i < zeros; ++i) binomial *= static_cast<double>(c.degree() - i) / (i + 1);
  const double weight = motion.weight.coefficients()[0];
  const Eigen::Vector2d velocity(motion.velocity[0].coefficients()[0],
                                 motion.velocity[1].coefficients()[0]);
  return {.curvature_per_mm = weight * weight * binomial * turn / std::pow(velocity.norm(), 3) /
                              unitOf(curve.poles())};
}

EndCurvature endCurvature(const BezierCurve& curve) {
  EndCurvature result = startCurvature(curve.reversed());
  result.curvature_per_mm = -result.curvature_per_mm;
  return result;
}

}  // namespace seamwright
