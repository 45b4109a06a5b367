// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/spiral_ends.hpp>

namespace seamwright {

namespace {

/// Bound of the rounding of alpha, beta and their sum, as chordAngles() computes them. The
/// direction of the chord has 3 machine_epsilon (differences of coordinates, arc tangent), each
/// difference of directions half of one per radian, and the multiple of 2 pi half of one per
/// radian: 7 for each angle and 14 for the sum, which has 2 of its own.
double angleRounding(const HermiteEnds& ends) {
  return machine_epsilon *
         (16 + std::abs(ends.start_direction_rad) + std::abs(ends.end_direction_rad));
}

/// curvature times half of the chord less a sine; the chord has 2 roundings, the sine, the product
/// and the difference one each.
SignedFigure excess(double curvature_per_mm, double half_chord_mm, double sine,
                    double angle_rounding) {
  const double turn = curvature_per_mm * half_chord_mm;
  return {.value = turn - sine,
          .rounding = angle_rounding + 4 * machine_epsilon * (std::abs(turn) + 1)};
}

/// The squared sine changes by its sine times the change of the turn, up to a square.
SignedFigure separationOf(const SignedFigure& start, const SignedFigure& end,
                          const SignedFigure& turn_rad) {
  const double product = start.value * end.value;
  const double sine = std::sin(turn_rad.value / 2), square = sine * sine;
  const double inherited = std::abs(start.value) * end.rounding +
                           std::abs(end.value) * start.rounding + start.rounding * end.rounding +
                           std::abs(sine) * turn_rad.rounding +
                           turn_rad.rounding * turn_rad.rounding;
  return {.value = product + square,
          .rounding = inherited + 4 * machine_epsilon * (std::abs(product) + square)};
}

/// \param side 1 for rising, -1 for falling curvature.
SpiralKind kindOnSide(const SpiralCertificate& found, int side) {
  const int start = side * found.start_excess.sign(), end = side * found.end_excess.sign();
  const int separation = found.separation.sign();
  if (start > 0 || end < 0 || separation > 0) return SpiralKind::Nothing;
  if (start == 0 || end == 0) return SpiralKind::Undecided;
  if (separation == 0) return SpiralKind::Biarc;
  return side > 0 ? SpiralKind::Rising : SpiralKind::Falling;
}

SpiralKind kindOf(const SpiralCertificate& found) {
  if (found.turn_rad.sign() != 0) return kindOnSide(found, found.turn_rad.sign());
  const int start = found.start_excess.sign(), end = found.end_excess.sign();
  if (start == 0 && end == 0) return SpiralKind::Arc;
  return start * end > 0 ? SpiralKind::Nothing : SpiralKind::Undecided;
}

}  // namespace

SpiralCertificate spiralCertificate(const CurvedEnds& ends) {
  const ChordAngles angles = chordAngles(ends.ends);
  const double half_mm = angles.chord_mm / 2;
  if (!std::isfinite(ends.start_curvature_per_mm * half_mm) ||
      !std::isfinite(ends.end_curvature_per_mm * half_mm))
    refuse(fmt::format(
        "the curvatures {} and {} per mm and their products with the chord of {} mm must be finite",
        ends.start_curvature_per_mm, ends.end_curvature_per_mm, angles.chord_mm));
  const double rounding = angleRounding(ends.ends);
  SpiralCertificate found{.start_angle_rad = -angles.alpha_rad, .end_angle_rad = angles.beta_rad};
  found.turn_rad = {.value = angles.beta_rad - angles.alpha_rad, .rounding = rounding};
  found.start_excess =
      excess(ends.start_curvature_per_mm, half_mm, std::sin(angles.alpha_rad), rounding);
  found.end_excess =
      excess(ends.end_curvature_per_mm, half_mm, std::sin(angles.beta_rad), rounding);
  found.separation = separationOf(found.start_excess, found.end_excess, found.turn_rad);
  found.kind = kindOf(found);
  return found;
}

double turnThrough_rad(const HermiteEnds& ends, const Eigen::Vector2d& point) {
  chordAngles(ends);
  if (!point.allFinite() || point == ends.start || point == ends.end)
    refuse(fmt::format("the point ({}, {}) must be finite and differ from both ends", point.x(),
                       point.y()));
  return angleFromTo(point - ends.start, ends.end - point);
}

Interval bilens_rad(const HermiteEnds& ends) {
  const ChordAngles angles = chordAngles(ends);
  return {std::min(angles.alpha_rad, angles.beta_rad), std::max(angles.alpha_rad, angles.beta_rad)};
}

}  // namespace seamwright
