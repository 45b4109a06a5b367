// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/hermite_quintic.hpp>
#include <seamwright/core/planar/spiral.hpp>

namespace seamwright {

namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

constexpr Complex i_unit(0, 1);

Complex turnedBy(double angle_rad) {
  return std::polar(1.0, angle_rad);
}

Eigen::Vector2d vectorOf(const Complex& z) {
  return {z.real(), z.imag()};
}

/// Euler arcs of total length 1 whose first tangent has the angle \p start against the chord and
/// whose last one has \p start + \p change.
struct EulerArcs {
  int count = 0;
  double start = 0, change = 0;

  /// \param x difference of the curvatures of neighbours.
  double curvature(double x, int j) const { return change + x * (j - (count - 1) / 2.0); }
  double direction(double x, int j) const {
    return start + (j * change + x * j * (j - count) / 2.0) / count;
  }
  Complex end(double x) const {
    Complex sum = 0;
    for (int j = 0; j < count; ++j) {
      const double half = curvature(x, j) / (2 * count);
      sum += sinc(half) * turnedBy(direction(x, j) + half);
    }
    return sum / static_cast<double>(count);
  }
  /// The derivative of the end by x.
  Complex endSlope(double x) const {
    Complex sum = 0;
    for (int j = 0; j < count; ++j) {
      const double half = curvature(x, j) / (2 * count);
      const double half_slope = (j - (count - 1) / 2.0) / (2 * count);
      const double direction_slope = j * (j - count) / (2.0 * count);
      sum += (sincSlope(half) * half_slope + i_unit * sinc(half) * (direction_slope + half_slope)) *
             turnedBy(direction(x, j) + half);
    }
    return sum / static_cast<double>(count);
  }
};

/// The root of the height of the end, by Newton's method.
double differenceOf(const EulerArcs& arcs, double x) {
  // Newton's method doubles the digits, so it ends long before unless there is no root.
  constexpr int most_steps = 50;
  // Some roundings of x. If steps stay above it, the height decides: it is a sum of numbers below 1
  // over their count, with some hundred roundings.
  constexpr double smallest_step = 1e-15;
  for (int step = 0; step < most_steps; ++step) {
    const double change = arcs.end(x).imag() / arcs.endSlope(x).imag();
    x -= change;
    if (!std::isfinite(x)) break;
    if (std::abs(change) <= smallest_step * (1 + std::abs(x))) return x;
  }
  if (std::isfinite(x) && std::abs(arcs.end(x).imag()) < 1e-13) return x;
  throw std::domain_error(fmt::format("no {} Euler arcs join tangents at {} rad and {} rad",
                                      arcs.count, arcs.start, arcs.start + arcs.change));
}

/// C-shaped ends with positive angles; those that turn to the right are mirrored.
struct CShape {
  ChordAngles angles;
  double alpha = 0, beta = 0;  ///< above 0
  double side = 1;             ///< -1: turns to the right

  double turn() const { return alpha + beta; }
};

CShape cShapeOf(const HermiteEnds& ends) {
  const ChordAngles angles = chordAngles(ends);
  const CShape shape{.angles = angles,
                     .alpha = std::abs(angles.alpha_rad),
                     .beta = std::abs(angles.beta_rad),
                     .side = angles.alpha_rad < 0 ? -1.0 : 1.0};
  if (!(angles.alpha_rad * angles.beta_rad > 0))
    throw std::domain_error(fmt::format(
        "a logarithmic spiral turns to one side: from the first tangent to the chord it is {} rad, "
        "from the chord to the last tangent {} rad; clothoids and arcs join such ends",
        angles.alpha_rad, angles.beta_rad));
  // The turn is a sum of angles up to pi, each with some roundings of 4e-16. A half circle must
  // pass.
  constexpr double rounding_rad = 1e-12;
  if (shape.turn() > pi + rounding_rad)
    throw std::domain_error(
        fmt::format("the tangent turns by {} rad, more than pi: insert a point", shape.turn()));
  return shape;
}

/// The largest logarithm of the ratio of the radii at the ends: that of 1e12. A choice: beyond it
/// the small end has fewer than four digits in the coordinates of the large one.
constexpr double largest_growth = 27.6;

/// The root of an increasing function of the logarithm of the ratio of the radii at the ends,
/// between bounds that double from [-1, 1]. Bisection keeps the bracket, the secant through its
/// ends is tried first.
template <class Function>
double increasingRoot(const Function& f) {
  double low = -1, high = 1;
  while (f(low) > 0 && low > -largest_growth) low = std::max(2 * low, -largest_growth);
  while (f(high) < 0 && high < largest_growth) high = std::min(2 * high, largest_growth);
  double f_low = f(low), f_high = f(high);
  if (f_low > 0 || f_high < 0)
    throw std::domain_error(
        fmt::format("the radii at the ends differ by more than e^{}", largest_growth));
  // Half of the steps are halvings, and 100 of these reduce any bracket by 2^-100: more than the
  // digits of a double, unless the root is 0.
  constexpr int most_steps = 200;
  for (int step = 0; step < most_steps && high - low > 4 * machine_epsilon * std::abs(low);
       ++step) {
    // Each second step halves the bracket, so that a secant near one end cannot stall.
    const double secant = low - f_low * (high - low) / (f_high - f_low);
    const bool takes_secant = step % 2 == 0 && secant > low && secant < high;
    const double middle = takes_secant ? secant : low + (high - low) / 2;
    const double value = f(middle);
    (value < 0 ? low : high) = middle;
    (value < 0 ? f_low : f_high) = value;
    if (value == 0) return middle;
  }
  return std::abs(f_low) < std::abs(f_high) ? low : high;
}

/// (e^z - 1) / z.
Complex exponentialQuotient(const Complex& z) {
  if (std::abs(z) < machine_epsilon) return 1;
  const double growth = std::expm1(z.real()), half = std::sin(z.imag() / 2);
  const Complex numerator(growth * std::cos(z.imag()) - 2 * half * half,
                          (growth + 1) * std::sin(z.imag()));
  return numerator / z;
}

/// sum of rho^j e^(i j theta), j < count, times e^(-x (count - 1)) if x > 0, with rho = e^x.
Complex chordSum(double x, double theta, int count) {
  Complex sum = 0;
  for (int j = 0; j < count; ++j) {
    const double power = x > 0 ? x * (j - count + 1) : x * j;
    sum += std::exp(power) * turnedBy(j * theta);
  }
  return sum;
}

}  // namespace

std::vector<PlanarArc> eulerArcs(const HermiteEnds& ends, int count) {
  if (count < 1) refuse(fmt::format("{} arcs: at least 1 is needed", count));
  const ChordAngles angles = chordAngles(ends);
  const EulerArcs arcs{
      .count = count, .start = -angles.alpha_rad, .change = angles.alpha_rad + angles.beta_rad};
  double x = 0;
  if (count > 1) {
    const Clothoid limit = clothoid(ends);
    const double slope = limit.curvature_slope_per_mm2 * limit.length_mm * limit.length_mm;
    x = differenceOf(arcs, slope * count / (static_cast<double>(count) * count - 1));
  }
  const Complex end = arcs.end(x);
  // That of the height, see differenceOf().
  constexpr double rounding = 1e-13;
  if (!(end.real() > 0) || std::abs(end.imag()) > rounding)
    throw std::domain_error(fmt::format("no {} Euler arcs join alpha {} rad and beta {} rad", count,
                                        angles.alpha_rad, angles.beta_rad));
  const double length_mm = angles.chord_mm / end.real();
  std::vector<PlanarArc> result;
  Eigen::Vector2d at = ends.start;
  for (int j = 0; j < count; ++j) {
    result.push_back({.start = at,
                      .direction_rad = angles.chord_direction_rad + arcs.direction(x, j),
                      .curvature_per_mm = arcs.curvature(x, j) / length_mm,
                      .length_mm = length_mm / count});
    at = result.back().end();
  }
  return result;
}

Eigen::Vector2d LogSpiral::point(double u_rad) const {
  const double side = radius_mm < 0 ? -1 : 1;
  const Complex rate(growth, side);
  const Complex moved =
      std::abs(radius_mm) * u_rad * turnedBy(direction_rad) * exponentialQuotient(rate * u_rad);
  return start + vectorOf(moved);
}

double LogSpiral::radiusAt_mm(double u_rad) const {
  return radius_mm * std::exp(growth * u_rad);
}

double LogSpiral::directionAt_rad(double u_rad) const {
  return direction_rad + (radius_mm < 0 ? -u_rad : u_rad);
}

double LogSpiral::length_mm() const {
  return std::abs(radius_mm) * turn_rad * exponentialQuotient(Complex(growth * turn_rad)).real();
}

Eigen::Vector2d LogSpiral::pole() const {
  const Complex rate(growth, radius_mm < 0 ? -1 : 1);
  return start - vectorOf(std::abs(radius_mm) * turnedBy(direction_rad) / rate);
}

LogSpiral logSpiral(const HermiteEnds& ends) {
  const CShape shape = cShapeOf(ends);
  const double turn = shape.turn();
  // The angle of the chord against the start tangent grows with the growth of the radius.
  const auto chord = [turn](double growth) {
    return exponentialQuotient(Complex(growth, 1) * turn) * std::exp(-std::max(0.0, growth * turn));
  };
  const double growth =
      increasingRoot([&](double x) { return std::arg(chord(x / turn)) - shape.alpha; }) / turn;
  const double chord_per_radius = turn * std::abs(exponentialQuotient(Complex(growth, 1) * turn));
  return {.start = ends.start,
          .direction_rad = ends.start_direction_rad,
          .radius_mm = shape.side * shape.angles.chord_mm / chord_per_radius,
          .growth = growth,
          .turn_rad = turn};
}

int leastLogArcs(const HermiteEnds& ends) {
  const CShape shape = cShapeOf(ends);
  const double share = shape.turn() / (2 * std::min(shape.alpha, shape.beta));
  // A choice that keeps the number an int and the arcs within memory: each has 40 bytes.
  constexpr double most = 1e6;
  if (!(share < most))
    throw std::domain_error(
        fmt::format("alpha {} rad and beta {} rad differ too much: more than "
                    "1e6 arcs would be needed",
                    shape.angles.alpha_rad, shape.angles.beta_rad));
  return static_cast<int>(std::floor(share)) + 1;
}

std::vector<PlanarArc> logArcs(const HermiteEnds& ends, int count) {
  const CShape shape = cShapeOf(ends);
  if (const int least = leastLogArcs(ends); count < least)
    throw std::domain_error(fmt::format("{} arcs: alpha {} rad and beta {} rad need at least {}",
                                        count, shape.angles.alpha_rad, shape.angles.beta_rad,
                                        least));
  const double sweep = shape.turn() / count;
  const int steps = std::max(1, count - 1);
  const auto angle = [&](double growth) {
    return std::arg(chordSum(growth / steps, sweep, count)) - (shape.alpha - sweep / 2);
  };
  const double x = count == 1 ? 0 : increasingRoot(angle) / steps;
  // For growing radii the sum is taken from the last arc.
  const double sum = std::abs(chordSum(x, sweep, count));
  const double reference_mm = shape.angles.chord_mm / sum / (2 * std::sin(sweep / 2));
  std::vector<PlanarArc> result;
  Eigen::Vector2d at = ends.start;
  for (int j = 0; j < count; ++j) {
    const double radius_mm = reference_mm * std::exp(x > 0 ? x * (j - count + 1) : x * j);
    result.push_back({.start = at,
                      .direction_rad = ends.start_direction_rad + shape.side * j * sweep,
                      .curvature_per_mm = shape.side / radius_mm,
                      .length_mm = radius_mm * sweep});
    at = result.back().end();
  }
  return result;
}

SplineWithin bezierSpline(const LogSpiral& spiral, double tolerance_mm) {
  if (!(tolerance_mm > 0 && std::isfinite(tolerance_mm)))
    refuse(fmt::format("the tolerance is {} mm: it must be positive and finite", tolerance_mm));
  // The sixth derivative by the turn is the first one times (growth + i)^5.
  const double largest_radius_mm =
      std::max(std::abs(spiral.radius_mm), std::abs(spiral.radiusAt_mm(spiral.turn_rad)));
  const double sixth_mm = largest_radius_mm * std::pow(1 + spiral.growth * spiral.growth, 2.5);
  const auto bound_mm = [&](double count) {
    return sixth_mm * std::pow(spiral.turn_rad / count, 6) * hermite_quintic_error;
  };
  // A choice that bounds memory, as for clothoids.
  constexpr double most = 100'000;
  const double count = std::max(1.0, std::ceil(std::pow(bound_mm(1) / tolerance_mm, 1.0 / 6)));
  if (!(count <= most))
    throw std::domain_error(fmt::format(
        "the spiral needs more than {} segments for a tolerance of {} mm", most, tolerance_mm));
  const Complex rate(spiral.growth, spiral.radius_mm < 0 ? -1 : 1);
  const auto jet = [&](double u_rad) {
    const Complex first =
        std::abs(spiral.radius_mm) * turnedBy(spiral.direction_rad) * std::exp(rate * u_rad);
    return PlanarJet{
        .point = spiral.point(u_rad), .first = vectorOf(first), .second = vectorOf(rate * first)};
  };
  std::vector<BezierCurve> segments;
  std::vector<double> knots = {0};
  PlanarJet from = jet(0);
  for (int i = 0; i < static_cast<int>(count); ++i) {
    knots.push_back(spiral.turn_rad * (i + 1) / count);
    const PlanarJet to = jet(knots.back());
    segments.push_back(hermiteQuintic(from, to, spiral.turn_rad / count));
    from = to;
  }
  return {.curve = bezierSpline(segments, knots), .distance_mm = bound_mm(count)};
}

}  // namespace seamwright
