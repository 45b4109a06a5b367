// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/seam/seam_side.hpp>
#include <seamwright/core/seam/survey.hpp>

namespace seamwright {

struct EncloseOptions {
  /// Part of the seam that is enclosed; the rest counts as without tangent plane, and is left out.
  Interval range = {0, 1};
  /// Work limit: pieces beyond those that knots ask for, before the enclosures are left as they
  /// are.
  int max_pieces = 1000;
  int max_knot_cuts = 30'000;  ///< work limit: cuts where the sides cross knot lines
  bool figures =
      true;  ///< false: stop as soon as the verdict is certain, however wide the enclosures
};

/// Encloses the largest gap, tangent-plane angle and curvature difference along a seam.
///
/// The seam is cut into pieces. On each piece points, normals and curvature tensors of both sides
/// are enclosed by polynomials with a radius (ChebyshevModel); differences are formed before the
/// ranges are taken. A norm is convex, so its largest value over a piece is at most its largest
/// value over the control polygon plus the radius; the lower bounds are values at points. Pieces
/// are cut further until every figure is known to max(1 % of the figure, a hundredth of its
/// tolerance), or the pieces are at the limit: then the enclosures are wider, but as true.
///
/// Figures are those of measurePair() and relativeDifference(), over all points where both sides
/// have a tangent plane, but for what \p angle_left_out and \p curvature_left_out list. A piece
/// shorter than 2^-30 of the seam, in parameter and in length, that holds a point without one is
/// left out by both and named in
/// \p degenerate. The curvature also leaves out what lies within 2^-20 of the seam of such a point,
/// and of a boundary of a spline all of whose poles are one point, where the tangent plane may be
/// known: there curvature may be as large as one likes. What is left out is bounded separately;
/// outside \p range nothing is known but the gap. Where the parameters cross a knot line, both
/// sides of the line count; along a knot line the side of the face counts. A knot line is met to
/// 2^-46 of the parameter, or to the rounding of the path where that is more (at most 2^-36 of its
/// parameters).
///
/// \p certified is false, and \p uncertified says why, if no finite bound was found on some piece.
/// \p points is the number of pieces.
///
/// The enclosure is of the surfaces given by the numbers of the evaluators, exact but for rounding,
/// which is inside the radius. Identities (each has a test of its number):
///   (1) No value of measurePair() along the seam is above the upper bounds, in what is left out
///       not above those given with it; the lower bounds are reached.
///   (2) Swapping the sides, reversing the seam, and rigid motion change the verdict nowhere, the
///       bounds within their widths.
///   (3) Of an exact G1 (G2) join the upper bound of the angle (curvature) is rounding only.
///
/// \throws std::invalid_argument for an invalid tolerance.
/// Source: docs/theory/enclosures.md E3.1 to E3.5, E5.1, E5.2; docs/theory/surfaces.md S1.5.
SeamFigures encloseSeam(const SeamSide& a, const SeamSide& b, const ContinuityTolerance& tolerance,
                        const EncloseOptions& options = {});

}  // namespace seamwright
