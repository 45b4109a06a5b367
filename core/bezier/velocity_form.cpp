// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/velocity_form.hpp>

namespace seamwright {

namespace {

/// The homogeneous poles as Bernstein forms, in units that keep the numbers moderate.
struct HomogeneousForm {
  VectorForm a;
  BernsteinPolynomial w;
  double unit_mm;
};

BernsteinPolynomial constantForm(double value) {
  return BernsteinPolynomial(Eigen::VectorXd::Constant(1, value));
}

VectorForm zeroForm() {
  return {constantForm(0), constantForm(0), constantForm(0)};
}

HomogeneousForm homogeneousForm(const BezierCurve& curve) {
  const HomogeneousPoles& poles = curve.homogeneousPoles();
  const int of_weights = bernstein::scaleExponent(poles.col(3).maxCoeff());
  const int of_poles = bernstein::scaleExponent(curve.poles().cwiseAbs().maxCoeff());
  const auto form = [&](int column, int exponent) {
    return BernsteinPolynomial(bernstein::scaledBy<Eigen::VectorXd>(poles.col(column), -exponent));
  };
  const int exponent = of_weights + of_poles;
  return {{form(0, exponent), form(1, exponent), form(2, exponent)},
          form(3, of_weights),
          std::ldexp(1, of_poles)};
}

/// The form relative to the first pole, which keeps products small.
HomogeneousForm aboutFirstPole(HomogeneousForm form) {
  for (BernsteinPolynomial& a : form.a)
    a = a - (a.coefficients()(0) / form.w.coefficients()(0)) * form.w;
  return form;
}

/// The form of the coefficients from \p first on, \p drop fewer than p has.
BernsteinPolynomial part(const BernsteinPolynomial& p, int first, int drop) {
  return BernsteinPolynomial(p.coefficients().segment(first, p.degree() + 1 - drop), p.padding());
}

VectorForm part(const VectorForm& form, int first, int drop) {
  return {part(form[0], first, drop), part(form[1], first, drop), part(form[2], first, drop)};
}

VectorForm operator+(const VectorForm& a, const VectorForm& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

VectorForm operator*(const BernsteinPolynomial& factor, const VectorForm& form) {
  return {factor * form[0], factor * form[1], factor * form[2]};
}

VectorForm cross(const VectorForm& a, const VectorForm& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The coefficients, one per column.
Eigen::Matrix3Xd coefficients(const VectorForm& form) {
  Eigen::Matrix3Xd result(3, form[0].degree() + 1);
  for (int i = 0; i < 3; ++i) result.row(i) = form[i].coefficients().transpose();
  return result;
}

}  // namespace

VelocityForm velocityForm(const BezierCurve& curve) {
  const int n = curve.degree();
  const HomogeneousForm h = homogeneousForm(curve);
  const BernsteinPolynomial weight = constantForm(h.w.coefficients()(0));
  const double least_weight = h.w.coefficients().minCoeff();
  if (n == 0) return {zeroForm(), weight, least_weight, h.unit_mm};
  if (!curve.isRational())
    return {{h.a[0].derivative(), h.a[1].derivative(), h.a[2].derivative()},
            weight,
            least_weight,
            h.unit_mm};
  const HomogeneousForm g = aboutFirstPole(h);
  const auto component = [&](const BernsteinPolynomial& a) {
    return static_cast<double>(n) *
           (part(a, 1, 1) * part(g.w, 0, 1) - part(a, 0, 1) * part(g.w, 1, 1));
  };
  return {{component(g.a[0]), component(g.a[1]), component(g.a[2])},
          g.w * g.w,
          std::nextafter(least_weight * least_weight, 0.0),
          h.unit_mm};
}

VectorForm curvatureForm(const BezierCurve& curve) {
  if (curve.degree() < 2) return zeroForm();
  if (!curve.isRational()) {
    // The velocity is (1 - t) V_0 + t V_1, so X' x X'' is V_0 x V_1 times its degree.
    const VectorForm velocity = velocityForm(curve).velocity;
    return cross(part(velocity, 0, 1), part(velocity, 1, 1));
  }
  const HomogeneousForm h = aboutFirstPole(homogeneousForm(curve));
  const VectorForm a0 = part(h.a, 0, 2), a1 = part(h.a, 1, 2), a2 = part(h.a, 2, 2);
  return part(h.w, 0, 2) * cross(a1, a2) + part(h.w, 1, 2) * cross(a2, a0) +
         part(h.w, 2, 2) * cross(a0, a1);
}

std::pair<VectorForm, VectorForm> halves(const VectorForm& form) {
  const auto x = form[0].split(0.5), y = form[1].split(0.5), z = form[2].split(0.5);
  return {{x.first, y.first, z.first}, {x.second, y.second, z.second}};
}

std::pair<VelocityForm, VelocityForm> VelocityForm::halves() const {
  const auto [left, right] = seamwright::halves(velocity);
  const auto [left_divisor, right_divisor] = divisor.split(0.5);
  return {{left, left_divisor, least_divisor, unit_mm},
          {right, right_divisor, least_divisor, unit_mm}};
}

Interval VelocityForm::divisorRange() const {
  const Interval range = divisor.range();
  return {std::max(range.lower, least_divisor), range.upper};
}

VelocityForm VelocityForm::restricted(const Interval& domain) const {
  return {{velocity[0].restricted(domain), velocity[1].restricted(domain),
           velocity[2].restricted(domain)},
          divisor.restricted(domain),
          least_divisor,
          unit_mm};
}

double padding(const VectorForm& form) {
  return rounding::sumUp(form[0].padding(), form[1].padding(), form[2].padding());
}

double largestNorm(const VectorForm& form) {
  return coefficients(form).colwise().stableNorm().maxCoeff();
}

double lowerNorm(const VectorForm& form) {
  const Eigen::Matrix3Xd c = coefficients(form);
  const Eigen::Vector3d mean = c.rowwise().mean();
  const double length = mean.stableNorm();
  if (!(length > 0)) return 0;
  // The direction is a unit vector within 4 units of rounding; the products are off by as many
  // units of the largest coefficient.
  const double least = ((mean / length).transpose() * c).minCoeff();
  const double error = rounding::sumUp(padding(form), 8 * rounding::kUnit * largestNorm(form));
  return std::max(0.0, least - rounding::up(error));
}

BernsteinPolynomial squaredNorm(const VectorForm& form) {
  return form[0] * form[0] + form[1] * form[1] + form[2] * form[2];
}

}  // namespace seamwright
