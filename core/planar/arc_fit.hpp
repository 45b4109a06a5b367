// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/planar/arc.hpp>
#include <seamwright/core/progress.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

struct ArcFitOptions {
  double tolerance_mm = 0.01;
  /// A joint at which the tangent turns by more is a corner, and stays one.
  double corner_rad = 1e-3;
};

/// Arcs and lines near a curve.
struct ArcFit {
  std::vector<PlanarArc> arcs;
  std::vector<int> corners;  ///< arcs that begin at a corner of the curve; ends do not count
  bool closed = false;
  /// Upper bound of the distance in both directions: no point of the curve is further from the
  /// arcs, no point of the arcs is further from the curve.
  double distance_mm = 0;
  /// No chain of arcs with these corners that is within the tolerance has fewer, even if its arcs
  /// do not touch.
  int least_arcs = 0;
};

/// A curve in the plane z = 0 as a G1 chain of few arcs and lines within a tolerance. At its ends
/// and corners the chain has the point and tangent of the curve; elsewhere arcs end beside the
/// curve. Identities (each has a test of its number):
///   (1) distance_mm <= tolerance_mm, and points of a dense sample are not further, in both
///       directions.
///   (2) A chain of arcs and lines comes back with as many arcs, if each is more than a sample of a
///       smooth curve: with half its length on both sides it is not within the tolerance of one
///       arc.
///       So does a closed chain with an even number of arcs of which the vertices of a polygon are
///       samples up to the rounding of their digits. If the curve begins inside of an arc, this is
///       the first one of the chain, as a whole.
///   (3) Corners are kept; a closed curve gives a closed chain. A vertex of a polygon is a corner
///       only if no smooth curve within the tolerance explains it; beside such a vertex the
///       tangents at ends and corners are free.
///   (4) The chain is G1 between corners.
///   (5) There are at least least_arcs arcs, and for a curvature that is linear in the arc length
///   at
///       most 1.2 times those of an ideal G1 chain, plus 3.
/// If no chain is found by search, or its distance can't be proven, halves are searched. The
/// smallest parts have the greedy one: each pair of arcs reaches as far as the tolerance allows.
/// Then there are up to twice as many, and a chain can change the side to which it turns more often
/// than the curve does. A polygon gets corners where no smooth chain is found. \throws
/// std::invalid_argument if the curve is not valid, a pole is outside of the plane, the tolerance
/// is not positive and finite, or the corner angle is not in (0, pi). Throws std::domain_error if
/// the curve stops or turns back (with the parameter), or if the tolerance is too small for the
/// rounding of the curve. Throws Cancelled, see Progress; it is called before each pair of arcs.
/// Source: docs/theory/planar.md P9.1, P9.2.
ArcFit fitArcs(const BezierSpline& curve, const ArcFitOptions& options = {},
               const Progress& progress = {});

/// The chain at a distance to its left (below 0: to its right). The arc at a corner on the outside
/// is an arc around the corner.
///   (6) The points are at the given distance from those of the chain, exactly up to rounding.
/// \throws std::domain_error if an arc vanishes (its centre is reached), and at a corner whose
/// inside is offset: the pieces would cross there (with the arc's index).
std::vector<PlanarArc> offset(const ArcFit& fit, double distance_mm);

}  // namespace seamwright
