// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/biarc.hpp>

namespace seamwright {

namespace {

using std::numbers::pi;

/// sin(x s) / sin(s): the chord of the first arc over the chord of the ends. For small s both sines
/// are replaced by their series, which is x (1 + s^2 (1 - x^2) / 6) with an error below s^4 / 100.
double chordShare(double x, double s) {
  // Here the error of the series is less than 1e-18, below rounding. Beyond it the quotient of
  // sines has only its own rounding.
  constexpr double series_limit_rad = 1e-4;
  if (std::abs(s) < series_limit_rad) return x * (1 + s * s * (1 - x * x) / 6);
  return std::sin(x * s) / std::sin(s);
}

bool isCShape(const ChordAngles& angles) {
  return angles.alpha_rad * angles.beta_rad > 0;
}

}  // namespace

ChordAngles chordAngles(const HermiteEnds& ends) {
  const Eigen::Vector2d chord = ends.end - ends.start;
  const double chord_mm = chord.norm();
  if (!std::isfinite(chord_mm) || !std::isfinite(ends.start_direction_rad) ||
      !std::isfinite(ends.end_direction_rad))
    refuse(fmt::format("ends are not finite: ({}, {}), {} rad, ({}, {}), {} rad", ends.start.x(),
                       ends.start.y(), ends.start_direction_rad, ends.end.x(), ends.end.y(),
                       ends.end_direction_rad));
  if (!(chord_mm > 0))
    refuse(fmt::format("both ends are the point ({}, {})", ends.end.x(), ends.end.y()));
  const double direction_rad = directionOf(chord);
  return {.chord_mm = chord_mm,
          .chord_direction_rad = direction_rad,
          .alpha_rad = wrapped(direction_rad - ends.start_direction_rad),
          .beta_rad = wrapped(ends.end_direction_rad - direction_rad)};
}

Biarc biarc(const HermiteEnds& ends, double x) {
  if (!(x > 0 && x < 1)) refuse(fmt::format("x is {}: it must be between 0 and 1", x));
  const ChordAngles angles = chordAngles(ends);
  const double sigma = (angles.alpha_rad + angles.beta_rad) / 2;
  // The chords grow with 1 / sin(sigma). At this margin they are 1e9 times the chord of the ends:
  // points keep some six digits.
  constexpr double least_margin_rad = 1e-9;
  if (std::abs(sigma) > pi - least_margin_rad)
    throw std::domain_error(fmt::format(
        "both tangents point against the chord: alpha {} rad, beta {} rad; no biarc joins them",
        angles.alpha_rad, angles.beta_rad));
  const double first_turn = angles.alpha_rad - angles.beta_rad + 2 * x * sigma;
  const double second_turn = 2 * sigma - first_turn;
  const double first_chord_mm = angles.chord_mm * chordShare(x, sigma);
  const double second_chord_mm = angles.chord_mm * chordShare(1 - x, sigma);
  const auto arc = [](const Eigen::Vector2d& start, double direction_rad, double turn,
                      double chord_mm) {
    return PlanarArc{.start = start,
                     .direction_rad = direction_rad,
                     .curvature_per_mm = 2 * std::sin(turn / 2) / chord_mm,
                     .length_mm = chord_mm / sinc(turn / 2)};
  };
  const PlanarArc first = arc(ends.start, ends.start_direction_rad, first_turn, first_chord_mm);
  const Eigen::Vector2d joint =
      ends.start + first_chord_mm * unitVector(ends.start_direction_rad + first_turn / 2);
  return {first, arc(joint, ends.start_direction_rad + first_turn, second_turn, second_chord_mm)};
}

std::optional<double> biarcParameter(const HermiteEnds& ends, BiarcRule rule) {
  const ChordAngles angles = chordAngles(ends);
  const double alpha = angles.alpha_rad, beta = angles.beta_rad, sum = alpha + beta;
  const bool c_shape = isCShape(angles);
  switch (rule) {
    case BiarcRule::Default:
      return c_shape ? beta / sum : 0.5;
    case BiarcRule::EqualChords:
      return 0.5;
    case BiarcRule::Parallel:
      if (!c_shape) return std::nullopt;
      return beta / sum;
    case BiarcRule::LeastRadiusDifference: {
      const double x = (3 * beta - alpha) / (2 * sum);
      if (!c_shape || !(x > 0 && x < 1)) return std::nullopt;
      return x;
    }
    case BiarcRule::LeastCurvature:
      if (!c_shape || alpha == beta) return 0.5;
      // The arc at the end with the smaller angle is straight.
      return std::abs(beta) < std::abs(alpha) ? 2 * beta / sum : (beta - alpha) / sum;
  }
  return std::nullopt;
}

Biarc biarc(const HermiteEnds& ends, BiarcRule rule) {
  const std::optional<double> x = biarcParameter(ends, rule);
  if (!x) {
    const ChordAngles angles = chordAngles(ends);
    throw std::domain_error(
        fmt::format("the rule does not apply to the ends: alpha {} rad, beta {} rad",
                    angles.alpha_rad, angles.beta_rad));
  }
  return biarc(ends, *x);
}

}  // namespace seamwright
