// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/seam/seam_side.hpp>
#include <seamwright/core/seam/survey.hpp>

namespace seamwright {

struct EncloseOptions {
  /// Part of the seam that is enclosed. The rest is left out of the figures and counts as having no
  /// tangent plane.
  Interval range = {0, 1};
  /// Work limit: the largest number of pieces beyond those that knots require. At the limit the
  /// enclosures stay as wide as they are.
  int max_pieces = 1000;
  int max_knot_cuts = 30'000;  ///< work limit: cuts where sides cross knot lines
  /// false: stop as soon as the verdict is certain, with enclosures of any width; the curvature may
  /// have no upper bound where the level is below G2. A seam of which something is left out has all
  /// figures.
  bool figures = true;
  bool curvature_change = false;  ///< also encloses the change of curvature, for level G3
};

/// Encloses the largest gap, tangent-plane angle and curvature difference along a seam; if asked
/// for also the largest difference of the change of curvature.
///
/// The seam is cut into pieces. On each piece polynomials with a radius (ChebyshevModel) enclose
/// the points, normals and curvature tensors of both sides. Differences are formed before ranges
/// are taken. A norm is convex, so its largest value over a piece is at most its largest value over
/// the control polygon plus the radius. The lower bounds are values at points. Pieces are cut
/// further until the bounds of every figure differ by no more than max(1 % of the figure, a
/// hundredth of its tolerance), or until the work limit is reached. At the limit the enclosures are
/// wider, but still proven.
///
/// The figures are those of measurePair(), relativeDifference() and relativeChange(), over all
/// points where both sides have a tangent plane, except for what \p angle_left_out and \p
/// curvature_left_out list:
///   - A piece that holds a point without tangent plane and is shorter than 2^-30 of the seam, in
///     parameter and in length, is left out of both figures. \p degenerate names it.
///   - The curvature also leaves out what lies within 2^-20 of the seam of such a point, because
///     curvature may grow without limit there. The distance is 2^-16 where no bound of the angle is
///     known up to a point at an end. The same holds near a boundary of a spline whose poles all
///     coincide, although the tangent plane may be known there.
///   - If the verdict would hang on it, the curvature also leaves out a piece shorter than 2^-30 of
///     the parameter that lies across knot lines, such as that between nearly coincident knots of
///     both sides at which their curvature jumps.
/// What is left out is bounded separately, except for the change of curvature. Outside \p range
/// only the gap is known.
///
/// Where the path crosses a knot line, both sides of the line count. Along a knot line, the side on
/// which the face lies counts. The path is on a knot line if it is within 2^-46 of the parameter,
/// or within the rounding of the path where that is larger (at most 2^-36 of its parameters).
///
/// \p certified is false if some piece has no finite bound; \p uncertified then says why. \p points
/// is the number of pieces.
///
/// The enclosure holds for the surfaces that the numbers of the evaluators give exactly; rounding
/// is inside the radius. Identities (each has a test of its number):
///   (1) No value of measurePair() along the seam exceeds the upper bounds; in what is left out, no
///       value exceeds the bounds given for it. The lower bounds are attained.
///   (2) Swapping the sides, reversing the seam and rigid motion never change the verdict, and
///       change the bounds only within their widths.
///   (3) For an exact G1 (G2, G3) join the upper bound of the angle (curvature, change of
///       curvature) is rounding only.
///
/// \throws std::invalid_argument for an invalid tolerance.
/// Source: docs/theory/enclosures.md E3.1 to E3.6, E5.1, E5.2; docs/theory/surfaces.md S1.5.
SeamFigures encloseSeam(const SeamSide& a, const SeamSide& b, const ContinuityTolerance& tolerance,
                        const EncloseOptions& options = {});

}  // namespace seamwright
