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

/// The curve from its first pole, in a unit of its size, so that products of many coordinates do
/// not overflow.
CurvePolynomials polynomialsOf(const BezierCurve& curve) {
  const Poles poles = curve.poles();
  const double extent = (poles.rowwise() - poles.row(0)).cwiseAbs().maxCoeff();
  return curvePolynomials(curve, poles.row(0), extent > 0 ? std::exp2(std::ilogb(extent)) : 1);
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

/// \param squared_speed of the curve, up to a positive factor.
void requireMotion(const Polynomial& squared_speed) {
  const SignChanges zeros = signChanges(squared_speed);
  if (zeros.undecided.empty() && zeros.changes.empty()) return;
  const Interval where =
      zeros.undecided.empty() ? zeros.changes.front().interval : zeros.undecided.front();
  throw std::domain_error(
      fmt::format("the curve may stop at the parameter {}: its speed is not certainly above 0",
                  where.middle()));
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
  requireDegree(curve);
  const HomogeneousPoles& poles = curve.homogeneousPoles();
  for (Eigen::Index i = 0; i < poles.rows(); ++i) {
    if (poles(i, 2) != 0)
      refuse(fmt::format("pole {} of the curve is outside of the plane z = 0, at z = {} mm", i,
                         poles(i, 2) / poles(i, 3)));
  }
  const CurvePolynomials motion = polynomialsOf(curve);
  const Polynomial &w = motion.weight, w1 = w.derivative();
  const Polynomial s = dot(motion.velocity, motion.velocity);
  requireMotion(s);
  const Polynomial c = crossInPlane(motion.velocity, derivative(motion.velocity));
  const Polynomial slope =
      (2 * (w1 * c) + w * c.derivative()) * s - 1.5 * (w * (c * s.derivative()));
  return profile(curve, slope, c, true);
}

CurvatureProfile spaceCurvatureProfile(const BezierCurve& curve) {
  requireDegree(curve);
  const CurvePolynomials motion = polynomialsOf(curve);
  const Polynomial &w = motion.weight, w1 = w.derivative();
  const Polynomial s = dot(motion.velocity, motion.velocity);
  requireMotion(s);
  const PolynomialVector c = cross(motion.velocity, derivative(motion.velocity));
  const Polynomial q = dot(c, c);
  const Polynomial slope = (4 * (w1 * q) + w * q.derivative()) * s - 3 * (w * (q * s.derivative()));
  return profile(curve, slope, q, false);
}

}  // namespace seamwright
