// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

/// A polygon, and the positions of the inner poles of the direct G2 cubic Bézier spline on its
/// edges.
///
/// Edge e leads from vertex e to e + 1. A closed polygon has as many edges and segments as vertices
/// (>= 3). An open polygon with vertices 0..L (L >= 3) has segments on the edges 1..L - 2. There
/// the construction sets alpha[1] = 0 and omega[L - 2] = 1, and alpha and omega of edges without
/// segment are not read.
struct G2Polygon {
  Poles vertices;
  bool closed = false;
  std::vector<double> alpha;  ///< one per edge: share of the edge before the first inner pole
  std::vector<double> omega;  ///< one per edge: share before the second inner pole, alpha < omega
};

/// The cubic Bézier spline with inner poles on the edges of a polygon whose joints are G2 by
/// construction. With lambda = (omega_e - alpha_e) / (1 - omega_e), rho = alpha_f / (omega_f -
/// alpha_f) of the edges e, f before and after a vertex, the joint divides the inner poles beside
/// it in the ratio sqrt(lambda rho) : 1.
///
/// By its knots the spline is C1: the lengths of neighbouring segments have the ratio sqrt(lambda
/// rho), and the first length is 1. Knots are sums of lengths, so decreasing lengths lose digits,
/// and continuity() may find 0; the curve stays G2. (In a closed spline the product of the ratios
/// may differ from 1; then it is G2 and not C1 at its seam.) An open spline begins and ends at the
/// polygon's end points, along its first and last edge.
///
/// Identities (each has a test of its number):
///   (1) Every joint is G2, including the joint at the seam of a closed spline.
///   (2) Each segment lies in the hull of its four poles; the osculating plane at a joint is the
///       plane of the vertex and its neighbours.
///   (3) Affine images of the polygon give affine images of the curve.
/// \throws std::invalid_argument, with index and value, for too few vertices, wrong counts, numbers
/// that are not finite, alpha or omega out of order, an edge of length zero, and a vertex at which
/// the polygon folds back on itself so that the joint has no tangent.
/// Source: docs/theory/curves.md C5.1 to C5.3; [Boehm1985]; [Farin1982b].
BezierSpline directG2Spline(const G2Polygon& polygon);

/// A gamma-spline: the direct G2 spline with alpha and omega computed from the parameter lengths of
/// the segments and the shapes gamma. gamma = 1 gives the C2 B-spline. For gamma -> 0 the curve
/// approaches the polygon, for gamma -> infinity it moves away from it.
struct GammaPolygon {
  Poles vertices;
  bool closed = false;
  std::vector<double> lengths;  ///< one per segment, positive
  /// gamma[s] at the joint between segments s - 1 and s: as many as segments; gamma[0] is not read
  /// if the polygon is open.
  std::vector<double> gamma;
};

/// alpha and omega of the edges of a gamma-spline.
/// \throws std::invalid_argument, with index and value, for too few vertices, lengths or gamma that
/// are not positive, or wrong counts.
G2Polygon g2Polygon(const GammaPolygon& polygon);

/// The gamma-spline, C1 by its knots. The spacing of the knots is \p lengths, as far as knots can
/// represent it: a length after lengths 10^k times as large has k digits less.
/// Identities (each has a test of its number):
///   (4) At each joint X''(+) - X''(-) = nu X', nu = 2 (1 / l_{s-1} + 1 / l_s) (1 / gamma_s - 1).
///   (5) gamma = 1: the C2 cubic B-spline of the polygon with these knots.
///   (6) For gamma -> 0 the distance to the polygon goes to 0 with gamma. In an open spline this
///       excludes the first and the last segment, which approach the cubics with poles d_0, d_1,
///       d_2, d_2 and the mirror image.
/// \throws std::invalid_argument as g2Polygon() and directG2Spline() do, also for a gamma so small
/// (below about 1e-16) that alpha or omega round to 0 or 1.
/// Source: docs/theory/curves.md C5.4 (a printed omega differs); [Boehm1985].
BezierSpline gammaSpline(const GammaPolygon& polygon);

}  // namespace seamwright
