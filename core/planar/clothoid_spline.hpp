// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/planar/biarc_spline.hpp>
#include <seamwright/core/planar/clothoid.hpp>
#include <seamwright/core/progress.hpp>

namespace seamwright {

/// What holds at an open end: a direction, or else a curvature; 0 is a natural end.
struct ClothoidEnd {
  std::optional<double> direction_rad = {};
  double curvature_per_mm = 0;
  /// Instead of a curvature: the piece at the end is an arc, so the curvature there is free. It
  /// needs at least 3 points.
  bool arc = false;
};

struct ClothoidSplineOptions {
  bool closed = false;               ///< a piece joins the last point with the first one
  ClothoidEnd start = {}, end = {};  ///< of an open curve
};

struct ClothoidSpline {
  std::vector<Clothoid> pieces;  ///< one for each segment of the polygon
  std::vector<double> directions_rad;
  bool closed = false;
  int steps = 0;                     ///< Newton steps
  double curvature_jump_per_mm = 0;  ///< the largest that is left: rounding
};

/// The spline of clothoids through points that is G2: position, tangent and curvature are
/// continuous, so the curvature is a continuous function of the arc length, linear between the
/// points. Identities (each has a test of its number):
///   (1) Neighbours agree in position, tangent and curvature; the end conditions hold.
///   (2) Points of a circle, with ends of this circle, give the circle.
///   (3) Reversed points give the reversed spline; rigid motion and scaling move it along.
///   (4) Points of a circle, with arcs at the ends, give the circle.
/// The directions are found by Newton's method from TangentRule::LinearEnergy, with exact
/// derivatives, in O(n) for each step.
/// \throws std::invalid_argument as tangentsAt() does, and for a curvature that is not finite.
/// Throws std::domain_error as tangentsAt() and clothoid() do, and if the steps do not converge,
/// with the curvature jump that is left: then points have to be inserted. Throws Cancelled, see
/// Progress; it is called before each step.
/// Source: docs/theory/planar.md P4.4.
ClothoidSpline clothoidSpline(const PlanarPoints& points, const ClothoidSplineOptions& options = {},
                              const Progress& progress = {});

}  // namespace seamwright
