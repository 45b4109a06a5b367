// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/planar/clothoid.hpp>
#include <seamwright/core/progress.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

struct ClothoidFitOptions {
  double tolerance_mm = 0.01;
  /// A joint at which the tangent turns by more is a corner, and stays one.
  double corner_rad = 1e-3;
};

/// Clothoids near a curve.
struct ClothoidFit {
  std::vector<Clothoid> pieces;
  std::vector<int> corners;  ///< pieces that begin at a corner of the curve; ends do not count
  bool closed = false;
  /// Upper bound of the distance in both directions, as that of ArcFit.
  double distance_mm = 0;
};

/// A curve in the plane z = 0 as clothoids that join G2 between its corners. Lines and arcs stay
/// lines and arcs with a clothoid between neighbours, see clothoidsNear(). Other parts from corner
/// to corner are clothoids near arcs of fitArcs(), or clothoidSpline() through points of the curve,
/// which are added where the distance is not yet proven; the result with fewer extrema and
/// inflections is taken. At ends and corners it has the tangents of the curve. Identities (each has
/// a test of its number):
///   (1) distance_mm <= tolerance_mm, and points of a dense sample are not further, in both
///       directions.
///   (2) Corners are kept; a closed curve gives a closed chain.
///   (3) A chain of lines and arcs gets one clothoid for each joint, and no extrema or inflections.
/// Of a spline the distance of a piece is the sum of two: that of the curve and that of the
/// clothoid from the circle through the ends of the piece and a point of the curve between. So it
/// is an upper bound that is larger than the distance itself; and so is the sum of the distances of
/// the curve and the clothoids from arcs.
/// \throws std::invalid_argument if the curve is not valid, a pole is outside of the plane, the
/// tolerance is not positive and finite, or the corner angle is not in (0, pi). Throws
/// std::domain_error if the curve stops, and if neither arcs nor pieces of 2^-20 of a segment keep
/// the tolerance. Throws Cancelled, see Progress; it is called before each clothoid. Source:
/// docs/theory/planar.md P4.4, P4.6, P9.1.
ClothoidFit fitClothoids(const BezierSpline& curve, const ClothoidFitOptions& options = {},
                         const Progress& progress = {});

}  // namespace seamwright
