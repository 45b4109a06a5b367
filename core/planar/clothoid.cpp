// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/clothoid.hpp>
#include <seamwright/core/planar/clothoid_phase.hpp>
#include <seamwright/core/planar/hermite_quintic.hpp>

namespace seamwright {

namespace {

using std::numbers::pi;

/// A start value for Newton's method, fitted to the solution over all ends. [BertolazziFrego2015]
double guess(const Phase& phase) {
  const double f0 = phase.start, f1 = phase.start + phase.change;
  const double x = f0 / pi, y = f1 / pi, xy = x * y, squares = x * x + y * y;
  return (f0 + f1) * (2.989696028701907 + 0.716228953608281 * xy - 0.458969738821509 * xy * xy +
                      (-0.502821153340377 + 0.261062141752652 * xy) * squares -
                      0.045854475238709 * squares * squares);
}

/// The error of the quintic of a piece, from a bound of the sixth derivative by arc length.
double errorBound_mm(const Clothoid& piece) {
  const double k = std::max(std::abs(piece.curvature_per_mm),
                            std::abs(piece.curvatureAt_per_mm(piece.length_mm)));
  const double slope = std::abs(piece.curvature_slope_per_mm2);
  const double sixth = std::pow(k, 5) + 10 * std::pow(k, 3) * slope + 15 * k * slope * slope;
  return sixth * std::pow(piece.length_mm, 6) * hermite_quintic_error;
}

Clothoid pieceOf(const Clothoid& whole, int i, int count) {
  const double s_mm = whole.length_mm * i / count;
  return {.start = whole.point(s_mm),
          .direction_rad = whole.directionAt_rad(s_mm),
          .curvature_per_mm = whole.curvatureAt_per_mm(s_mm),
          .curvature_slope_per_mm2 = whole.curvature_slope_per_mm2,
          .length_mm = whole.length_mm / count};
}

double largestBound_mm(const Clothoid& whole, int count) {
  // The curvature is linear, so the largest |k| is in the first or in the last piece.
  return std::max(errorBound_mm(pieceOf(whole, 0, count)),
                  errorBound_mm(pieceOf(whole, count - 1, count)));
}

int piecesWithin(const Clothoid& whole, double tolerance_mm) {
  // A choice that bounds memory: a segment has some 200 bytes.
  constexpr int most = 100'000;
  const double ratio = errorBound_mm(whole) / tolerance_mm;
  int count = ratio > 1 ? static_cast<int>(std::min<double>(most, std::pow(ratio, 1.0 / 6))) : 1;
  count = std::max(1, count / 2);
  while (count <= most && largestBound_mm(whole, count) > tolerance_mm) ++count;
  if (count > most)
    throw std::domain_error(
        fmt::format("a clothoid of {} mm needs more than {} segments for a "
                    "tolerance of {} mm",
                    whole.length_mm, most, tolerance_mm));
  return count;
}

PlanarJet jetAt(const Clothoid& curve, double s_mm) {
  const double direction_rad = curve.directionAt_rad(s_mm);
  return {.point = curve.point(s_mm),
          .first = unitVector(direction_rad),
          .second = curve.curvatureAt_per_mm(s_mm) * unitVector(direction_rad + pi / 2)};
}

}  // namespace

const GaussRule& phaseRule() {
  static const GaussRule rule = gaussRule(phase_nodes);
  return rule;
}

PhaseEnd Phase::end(double a) const {
  const Eigen::Array4d sums = integral(
      [&](double t) {
        const double c = std::cos(at(a, t)), s = std::sin(at(a, t)), by_a = t * t - t;
        return Eigen::Array4d(s, by_a * c, c, -by_a * s);
      },
      turn(a));
  return {.height = sums(0), .height_slope = sums(1), .width = sums(2), .width_slope = sums(3)};
}

PhaseRoot rootOf(const Phase& phase) {
  // No end needs |a| > 17, and no more than four steps were seen; the bound of 20 steps keeps a
  // failure from being silent.
  constexpr int most_steps = 20;
  constexpr double largest = 20;
  const double size = std::abs(phase.start) + std::abs(phase.start + phase.change);
  PhaseRoot root{.a = guess(phase)};
  while (root.steps < most_steps && std::abs(root.a) <= largest) {
    const PhaseEnd end = phase.end(root.a);
    const double change = end.height / end.height_slope;
    root.a -= change;
    ++root.steps;
    // The second derivatives by a are at most the integral of (t^2 - t)^2, 1/30. So the step leaves
    // an error of change^2 / (60 |height_slope|), and less than a rounding in the width below.
    root.width = end.width - change * end.width_slope;
    if (change * change <= 60 * std::abs(end.height_slope) * machine_epsilon * size) return root;
  }
  throw std::domain_error(fmt::format(
      "no clothoid was found for tangents at {:.6g} and {:.6g} degrees",
      phase.start * degrees_per_radian, (phase.start + phase.change) * degrees_per_radian));
}

Eigen::Vector2d Clothoid::point(double s_mm) const {
  const double turn_rad =
      std::abs(curvature_per_mm * s_mm) + std::abs(curvature_slope_per_mm2) * s_mm * s_mm / 2;
  return start +
         s_mm * integral([&](double t) { return unitVector(directionAt_rad(t * s_mm)); }, turn_rad);
}

Clothoid reversed(const Clothoid& clothoid) {
  return {.start = clothoid.end(),
          .direction_rad = wrapped(clothoid.directionAt_rad(clothoid.length_mm) + pi),
          .curvature_per_mm = -clothoid.curvatureAt_per_mm(clothoid.length_mm),
          .curvature_slope_per_mm2 = clothoid.curvature_slope_per_mm2,
          .length_mm = clothoid.length_mm};
}

Clothoid clothoid(const HermiteEnds& ends) {
  const ChordAngles angles = chordAngles(ends);
  const double f0 = -angles.alpha_rad, f1 = angles.beta_rad;
  const Phase phase{.start = f0, .change = f1 - f0};
  const PhaseRoot root = rootOf(phase);
  // The width is a mean of cosines, with a rounding of some 1e-16: at this limit the length has
  // eight digits.
  constexpr double least_width = 1e-8;
  if (!(root.width > least_width))
    throw std::domain_error(
        fmt::format("both tangents point against the chord from ({:.6g}, {:.6g}) to ({:.6g}, "
                    "{:.6g}), by the angles {:.6g} and {:.6g} degrees: the clothoid would be "
                    "more than 1e8 times as long as the chord",
                    ends.start.x(), ends.start.y(), ends.end.x(), ends.end.y(),
                    angles.alpha_rad * degrees_per_radian, angles.beta_rad * degrees_per_radian));
  const double length_mm = angles.chord_mm / root.width;
  return {.start = ends.start,
          .direction_rad = ends.start_direction_rad,
          .curvature_per_mm = (phase.change - root.a) / length_mm,
          .curvature_slope_per_mm2 = 2 * root.a / (length_mm * length_mm),
          .length_mm = length_mm};
}

SplineWithin bezierSpline(const std::vector<Clothoid>& chain, double tolerance_mm, bool closed,
                          double gap_mm) {
  if (!(tolerance_mm > 0 && std::isfinite(tolerance_mm)))
    refuse(fmt::format("the tolerance is {} mm: it must be positive and finite", tolerance_mm));
  std::vector<BezierCurve> segments;
  std::vector<double> knots = {0};
  SplineWithin result;
  for (const Clothoid& whole : chain) {
    const int count = piecesWithin(whole, tolerance_mm);
    const double before_mm = knots.back();
    PlanarJet from = jetAt(whole, 0);
    for (int i = 0; i < count; ++i) {
      const PlanarJet to = jetAt(whole, whole.length_mm * (i + 1) / count);
      segments.push_back(hermiteQuintic(from, to, whole.length_mm / count));
      knots.push_back(before_mm + whole.length_mm * (i + 1) / count);
      from = to;
    }
    result.distance_mm = std::max(result.distance_mm, largestBound_mm(whole, count));
  }
  result.curve = bezierSpline(segments, knots, closed, gap_mm);
  return result;
}

}  // namespace seamwright
