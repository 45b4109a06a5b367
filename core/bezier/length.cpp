// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <stdexcept>
#include <string>
#include <vector>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/length.hpp>
#include <seamwright/core/bezier/velocity_form.hpp>

namespace seamwright {

namespace {

constexpr int nodes = 7;
/// Gauss' nodes on [0, 1] are (1 +- x) / 2.
constexpr std::array<double, nodes> legendre_roots = {
    -0.94910791234275852453, -0.74153118559939443986, -0.40584515137739716691, 0,
    0.40584515137739716691,  0.74153118559939443986,  0.94910791234275852453};

double node(int i) {
  return 0.5 * (1 + legendre_roots[i]);
}

/// From values at the nodes to the Bernstein coefficients of the polynomial through them.
Eigen::Matrix<double, nodes, nodes> interpolation() {
  Eigen::Matrix<double, nodes, nodes> values;
  const Eigen::VectorXd& binomials = bernstein::binomials(nodes - 1);
  for (int i = 0; i < nodes; ++i)
    for (int j = 0; j < nodes; ++j)
      values(i, j) = binomials(j) * std::pow(node(i), j) * std::pow(1 - node(i), nodes - 1 - j);
  return values.inverse();
}

/// \pre not negative; rounded downwards, to 0 at least.
double down(double x) {
  return std::max(0.0, std::nextafter(x, 0.0));
}

/// The integral of the speed over a piece, its parameter from 0 to 1.
struct Estimate {
  Interval bracket;
  double value = 0;
  double rounding = 0;  ///< what of the bracket's width no halving takes away
};

Interval meet(const Interval& a, const Interval& b) {
  return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

/// |integral of the velocity| <= length <= integral of its control polygon's norm, both over the divisor: for
/// polynomial curves chord and polygon. The value is Gravesen's.
Estimate chordAndPolygon(const VelocityForm& form) {
  const int m = form.velocity[0].degree();
  Eigen::Matrix3Xd c(3, m + 1);
  for (int i = 0; i < 3; ++i) c.row(i) = form.velocity[i].coefficients().transpose();
  const double chord = c.rowwise().mean().stableNorm(), polygon = c.colwise().stableNorm().mean();
  const double off =
      rounding::sumUp(padding(form.velocity), rounding::productUp(rounding::gamma(m + 8), polygon));
  const Interval divisor = form.divisor.range();
  const double least = std::max(divisor.lower, form.divisor.coefficients().minCoeff() * 0x1p-10);
  Estimate result;
  result.bracket = {down(down(std::max(0.0, chord - off)) / divisor.upper),
                    rounding::up(rounding::sumUp(polygon, off) / least)};
  result.rounding = 2 * off / least;
  const double estimate = (2 * chord / (m + 2) + m * polygon / (m + 2)) / form.divisor.range().middle();
  result.value = std::clamp(estimate, result.bracket.lower, result.bracket.upper);
  return result;
}

/// Speed at the nodes, rounded.
Eigen::Matrix<double, nodes, 1> speeds(const VelocityForm& form) {
  Eigen::Matrix<double, nodes, 1> values;
  for (int i = 0; i < nodes; ++i) {
    const bernstein::Step step = bernstein::Step::at(node(i));
    Eigen::Vector3d velocity;
    for (int k = 0; k < 3; ++k) velocity(k) = bernstein::collapsed(form.velocity[k].coefficients(), step)(0);
    values(i) = velocity.norm() / bernstein::collapsed(form.divisor.coefficients(), step)(0);
  }
  return values;
}

/// Gauss' quadrature with its remainder: the polynomial g through the speeds at the nodes has their quadrature
/// for integral. With v the velocity, d the divisor,
///
///   |v| / d - g = (v.v - (g d)^2) / ((|v| + g d) d),
///
/// and all that is on the right has Bernstein forms. Whatever rounding did to g is seen there.
/// Nothing where |v| + g d has no positive lower bound.
std::optional<Interval> quadrature(const VelocityForm& form) {
  static const Eigen::Matrix<double, nodes, nodes> to_bernstein = interpolation();
  const double least_speed = lowerNorm(form.velocity), least_divisor = form.divisor.range().lower;
  if (!(least_speed > 0 && least_divisor > 0)) return std::nullopt;
  const BernsteinPolynomial g(to_bernstein * speeds(form));
  const BernsteinPolynomial guess = g * form.divisor;
  const double least_guess = guess.range().lower;
  if (!(least_guess > 0)) return std::nullopt;
  const Interval residual = (squaredNorm(form.velocity) - guess * guess).range();
  const double denominator = down(down(least_speed + least_guess) * least_divisor);
  if (!(denominator > 0)) return std::nullopt;
  const double integral = g.coefficients().mean();
  const double rounding = rounding::productUp(rounding::gamma(nodes + 2), g.coefficients().cwiseAbs().mean());
  const double below = rounding::sumUp(rounding, rounding::up(std::max(0.0, -residual.lower) / denominator));
  const double above = rounding::sumUp(rounding, rounding::up(std::max(0.0, residual.upper) / denominator));
  return Interval{down(std::max(0.0, integral - below)), rounding::up(integral + above)};
}

Estimate estimate(const VelocityForm& form) {
  Estimate result = chordAndPolygon(form);
  const std::optional<Interval> sharp = quadrature(form);
  if (!sharp) return result;
  result.bracket = meet(result.bracket, *sharp);
  result.value = result.bracket.middle();
  return result;
}

/// Over [first, last] of the curve's parameter, in its units.
struct Piece {
  VelocityForm form;
  double share;  ///< of the parameter range
  Estimate estimate;

  Piece(VelocityForm f, double s) : form(std::move(f)), share(s), estimate(seamwright::estimate(form)) {}
  double width() const { return share * estimate.bracket.width(); }
  bool operator<(const Piece& other) const { return width() < other.width(); }
};

}  // namespace
}  // namespace seamwright
