// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

/// A polygon and, on its edges, where the inner poles of the direct G2 cubic Bézier spline lie.
///
/// Edge e leads from vertex e to e + 1. Closed: as many edges and segments as vertices (>= 3). Open
/// with vertices 0..L (L >= 3): segments on edges 1..L - 2; alpha[1] = 0 and omega[L - 2] = 1 are
/// set by the construction, alpha and omega of edges without segment are not read.
struct G2Polygon {
  Poles vertices;
  bool closed = false;
  std::vector<double> alpha;  ///< one an edge: share of the edge before the first inner pole
  std::vector<double> omega;  ///< one an edge: share before the second, alpha < omega
};

/// The cubic Bézier spline with inner poles on the edges of a polygon whose joints are G2 by
/// construction: with lambda = (omega_e - alpha_e) / (1 - omega_e), rho = alpha_f / (omega_f -
/// alpha_f) of the edges e, f before and after a vertex, the joint divides the inner poles beside
/// it in the ratio sqrt(lambda rho) : 1.
///
/// Knots are those in which it is C1: the lengths of neighbours are as sqrt(lambda rho); the first
/// is 1. They add the lengths up, so lengths that shrink lose digits in them and continuity() may
/// find 0; the curve is G2 all the same. (Round a closed one the ratios need not multiply to 1:
/// then it is G2 and not C1 at its seam.) An open one begins and ends in the polygon's end points,
/// along its first and last edge.
///
/// Identities (each has a test of its number):
///   (1) Every joint is G2, that of a closed one included.
///   (2) Each segment lies in the hull of its four poles; the osculating plane at a joint is that
///       of the vertex and its neighbours.
///   (3) Affine images of the polygon give affine images of the curve.
/// \throws std::invalid_argument for too few vertices, wrong counts, numbers that are not finite,
/// alpha or omega out of order, an edge of no length, and a vertex where the polygon folds back on
/// itself so that the joint has no tangent; with index and value.
/// Source: docs/theory/curves.md C5.1 to C5.3; [Boehm1985]; [Farin1982b].
BezierSpline directG2Spline(const G2Polygon& polygon);

/// A gamma-spline: the direct G2 spline with alpha, omega from lengths of the segments in the
/// parameter and shapes gamma. gamma = 1 is the C2 B-spline; gamma -> 0 runs into the polygon,
/// gamma -> infinity away from it.
struct GammaPolygon {
  Poles vertices;
  bool closed = false;
  std::vector<double> lengths;  ///< one a segment, positive
  /// gamma[s] at the joint between segments s - 1 and s: as many as segments; gamma[0] is not read
  /// where open.
  std::vector<double> gamma;
};

/// alpha and omega of the edges of a gamma-spline.
/// \throws std::invalid_argument for too few vertices, lengths or gamma not positive, or wrong
/// counts; with index and value.
G2Polygon g2Polygon(const GammaPolygon& polygon);

/// The gamma-spline, C1 in its knots, whose spacing is \p lengths as far as knots hold it: one
/// after lengths 10^k times as large has k digits less. Identities (each has a test of its number):
///   (4) At each joint X''(+) - X''(-) = nu X', nu = 2 (1 / l_{s-1} + 1 / l_s) (1 / gamma_s - 1).
///   (5) gamma = 1: the C2 cubic B-spline of the polygon with these knots.
///   (6) gamma -> 0: the distance to the polygon goes to 0 with gamma. Of an open one, all segments
///       but the first and the last do so; these go to the cubics with poles d_0, d_1, d_2, d_2 and
///       their mirror image.
/// \throws std::invalid_argument as g2Polygon() and directG2Spline(): also for gamma so small
/// (below about 1e-16) that alpha or omega round to 0 or 1.
/// Source: docs/theory/curves.md C5.4 (a printed omega differs); [Boehm1985].
BezierSpline gammaSpline(const GammaPolygon& polygon);

}  // namespace seamwright
