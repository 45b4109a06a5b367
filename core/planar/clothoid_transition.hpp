// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/planar/arc.hpp>
#include <seamwright/core/planar/clothoid.hpp>

namespace seamwright {

/// A clothoid from one circle (or line) to another one.
struct ClothoidTransition {
  Clothoid clothoid;
  double leaves_mm = 0;   ///< arc length from the start of the first arc to where it is left
  double arrives_mm = 0;  ///< from the start of the second arc; below 0: before its start
};

/// The clothoid that leaves the circle of one arc and ends on that of another one, with the
/// position, direction and curvature of both. It changes over near the end of the first arc and the
/// start of the second one; both circles continue beyond the ends of the arcs. There is one if the
/// circle of the larger curvature lies strictly inside of the other one (on the left of a line that
/// turns left), or if both lie outside of each other and turn to different sides: gaps of
/// (k1 - k0) L^2 / 24 for a length L, to first order. Identities (each has a test of its number):
///   (1) The ends are on both circles, with their directions and curvatures.
///   (2) From a line to a circle of the radius R the circle is shifted by Y - R (1 - cos t) with
///       t = L / (2 R), Y = L (t / 3 - t^3 / 42 + t^5 / 1320 - ...).
///   (3) Reversed arcs give the reversed clothoid; rigid motion and scaling move it along.
/// \throws std::invalid_argument for numbers that are not finite. Throws std::domain_error if both
/// curvatures are equal, and if there is no such clothoid or it turns by more than half a circle.
/// Source: docs/theory/planar.md P4.5.
ClothoidTransition clothoidTransition(const PlanarArc& from, const PlanarArc& to);

}  // namespace seamwright
