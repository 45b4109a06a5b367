// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/// Functions that change one end of a curve; not a public header.
namespace seamwright::occ {

/// Of the distance from an end: 1 for the value, the slope or the second derivative there and 0 for the others, with their derivatives.
struct Blends {
  double value = 0, slope = 0, bend = 0;
  double d_value = 0, d_slope = 0, d_bend = 0;
  /// Likewise for value and slope, the second derivative being whatever moves least.
  double brief_value = 0, brief_slope = 0;
};

/// Sums of the first three quintic B-splines over knots that far apart, the end one of all multiplicity, the brief ones of the first two: what
/// a spline with these knots can do by a move of its first poles. Zero from three spans on, the brief ones from two.
/// \pre span > 0, distance >= 0
Blends blendsAt(double distance, double span);

}  // namespace seamwright::occ
