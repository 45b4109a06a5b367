// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/fair/fair_curve.hpp>

/// Not a public header.
namespace seamwright {

struct FairestMoves {
  Poles moves;  ///< of all poles of the curve
  int steps = 0;
  /// Whether the energy has the precision of the method, or that which rounding allows.
  bool converged = false;
};

/// The moves x of the poles c of a curve for which the energy of c + x is least, up to a
/// millionth, while no Bézier pole of the spline x is further than the tolerance from 0. Held poles
/// do not move. So that they are unique, the squared distance has 2^-40 of the weight of the
/// energy, both divided by their sizes for a single pole.
///
/// A primal-dual interior-point method that starts without a move. A step costs O(poles). The moves
/// are always within the tolerance, up to rounding.
/// \pre the curve is valid and polynomial, its degree is 2 or more, the tolerance is positive and
/// finite, and a pole is free.
/// Throws Cancelled, see Progress; it is called before each step.
/// Source: docs/theory/planar.md P11.4.
FairestMoves fairestMoves(const BSplineCurve& curve, double tolerance_mm, HeldEnds ends,
                          const Progress& progress);

}  // namespace seamwright
