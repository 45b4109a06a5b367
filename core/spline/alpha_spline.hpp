// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/spline/alpha_curve.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

/// Alpha-curves end to end, each with a separate shape. Neighbours share the pole between them
/// bitwise.
struct AlphaSpline {
  std::vector<AlphaCurve> segments;
  std::vector<double> knots;  ///< segments + 1, increasing: the common parameter
  bool closed = false;
};

/// How the segments of a spline are shaped and joined. Joint j is between the segments j and j + 1.
/// The last joint of a closed spline is between its end and its beginning.
struct AlphaSplineShape {
  int order = 2;  ///< of every joint: 1, 2 or 3
  /// One per segment, 1e-6 to 1; their number is the number of segments.
  std::vector<double> a;
  std::vector<double> lengths;  ///< one per segment, in the common parameter; empty: all 1
  std::vector<double> beta1;    ///< one per joint; empty: all 1
  std::vector<double> beta2;    ///< one per joint; empty: all 0. With order 3 it must be empty
  bool closed = false;
};

/// The spline of a control polygon. With n segments its poles are
///   order 1     P_0, then P_1 and P_2 of each segment, then P_3 of the last one: 2 n + 2 poles.
///               Closed: 2 n, without the first and the last. A joint lies on the line from P_2 to
///               the next P_1 and divides it in the ratio 1 : first.
///   order 2, 3  P_0, then D_0 .. D_n, then P_3 of the last segment: n + 3 poles.
///               Closed: D_0 .. D_(n-1), n poles. The poles P_1, P_2 of segment i lie on
///               D_i D_(i+1) and divide it in the ratio mu : 1 : lambda, with
///                 mu = (1 + first) / (second - first - third),   lambda = third mu
///               of the joints at D_i and at D_(i+1); both are 0 at the ends of an open spline.
///               Joints lie as for order 1.
/// first, second, third are the factors of alphaJoinPoles(): Q_1 = P_3 + first (P_3 - P_2),
/// Q_2 = P_3 + second (P_3 - P_2) + third (P_1 - P_3).
///
/// So the poles lie on the polygon in its order, and they form the polygons of the alpha-curves.
/// Therefore the spline is in the hull, and no plane meets it more often than the polygon. This
/// needs second > first + third. With beta2 = 0 that holds for shapes above 1/2, with order 3 for
/// shapes above 2/3, and also for smaller shapes next to larger ones. In general it holds for any
/// sufficiently large beta2. Joints of other shapes have no such polygon; use alphaChain() for
/// them.
///
/// Identities (each has a test of its number):
///   (1) Every joint is G^order with beta1, beta2 (for order 3 with beta2, beta3 of C8.5), and
///       C^order for beta1 = 1, beta2 = 0.
///   (2) Affine maps of the polygon map the spline.
///   (3) The reversed polygon, with reversed shapes and lengths and with 1 / beta1, beta2 /
///       beta1^3, gives the reversed spline.
///   (4) A pole of the polygon influences at most four segments (order 1: two).
///   (5) No plane meets the spline more often than the polygon.
/// \throws std::invalid_argument, with index and value, for poles that are not finite, counts that
/// do not match, fewer segments than one (closed: two, with order 2 or 3 three), numbers out of
/// range, joints with second <= first + third, and joints without tangent.
/// Source: docs/theory/curves.md C8.4 to C8.6; [TuYanXu2022] (the joins).
AlphaSpline alphaSpline(const Poles& polygon, const AlphaSplineShape& shape);

/// A segment of a chain: its join with the previous segment, and its free poles.
struct AlphaLink {
  AlphaCurveJoin join;  ///< its length is not read: the length of the previous segment is used
  Poles free_poles;     ///< P_2 and P_3; for order 2 or 3 only P_3
};

/// The chain that begins with \p first, over [0, length], and continues link by link. It exists for
/// any shapes. A pole influences all segments after it. For order 2 or 3 the factors multiply along
/// the chain, so long chains oscillate with growing size.
///   (6) A spline that is split into its first segment and links gives the same chain up to
///       rounding.
/// \throws std::invalid_argument as alphaJoinPoles() does, with the index of the link.
AlphaSpline alphaChain(const AlphaCurve& first, double length, const std::vector<AlphaLink>& links);

/// The same curve in Bézier segments of degree 5, exactly.
BezierSpline bezierSpline(const AlphaSpline& spline);

}  // namespace seamwright
