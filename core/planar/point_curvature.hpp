// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/planar/biarc_spline.hpp>

/// Curvature of planar points: how fair a sequence of points is before a curve is laid through it.
namespace seamwright {

/// The curvature at the points: that of the circle through a point and its neighbours, above 0
/// where the polygon turns to the left. Closed: one value for each point. Open: one for each point
/// between the ends, so value i belongs to point i + 1. Identities (each has a test of its number):
///   (1) Points of a circle of radius r, run counter-clockwise, have the curvature 1 / r.
///   (2) Reversed points have the opposite curvatures in reversed order; a rigid motion does not
///       change them, scaling by s divides them by s.
/// \throws std::invalid_argument for fewer than 3 points, numbers that are not finite, and two of
/// three neighbours that are equal, or apart by less than 2^-100 mm or more than 2^100 mm, some
/// 1e-30 and 1e30 (with the indices).
/// Source: docs/theory/planar.md P10.1.
Eigen::VectorXd pointCurvatures_per_mm(const PlanarPoints& points, bool closed = false);

/// Indices of the points whose curvature has another sign than that of both neighbours. Such a
/// point is most often a misread digit.
///   (3) A point moved across the chord of its neighbours on a convex curve is found.
/// \throws as pointCurvatures_per_mm() does. Source: docs/theory/planar.md P10.2.
std::vector<Eigen::Index> isolatedInflections(const PlanarPoints& points, bool closed = false);

/// How fair a sequence of points is.
struct PointFairness {
  /// Sum of the squared differences of curvature of neighbours, each divided by their distance. It
  /// approximates the integral of the squared derivative of the curvature by arc length.
  double energy_per_mm3 = 0;
  double rounding_per_mm3 = 0;  ///< energy that rounding of the coordinates can make
  /// Points where the curvature has a local extremum, and points before which it changes its sign.
  /// Differences that rounding of the coordinates can make do not count.
  std::vector<Eigen::Index> extrema, inflections;
};

///   (4) Points of a circle have no extremum and no inflection, also if they are rounded.
/// \param rounding_mm the largest distance of a point from where it is meant to be, for instance by
/// the digits of a file; 0: that of doubles. Bounds are of first order in it.
/// \throws as pointCurvatures_per_mm() does, and std::invalid_argument for a rounding that is
/// negative or not finite. Source: docs/theory/planar.md P10.1, P10.7.
PointFairness fairnessOf(const PlanarPoints& points, bool closed = false, double rounding_mm = 0);

}  // namespace seamwright
