// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/spline/alpha_curve.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

/// Alpha-curves end to end, each with a shape of its own. Neighbours have the same pole between
/// them, bit by bit.
struct AlphaSpline {
  std::vector<AlphaCurve> segments;
  std::vector<double> knots;  ///< segments + 1, increasing: the common parameter
  bool closed = false;
};

/// How the segments of a spline are shaped and joined. Joint j is between the segments j and j + 1;
/// of a closed spline the last joint is between its end and its beginning.
struct AlphaSplineShape {
  int order = 2;                ///< of every joint: 1, 2 or 3
  std::vector<double> a;        ///< one a segment, 1e-6 to 1; their number is that of the segments
  std::vector<double> lengths;  ///< one a segment, in the common parameter; empty: all 1
  std::vector<double> beta1;    ///< one a joint; empty: all 1
  std::vector<double> beta2;    ///< one a joint; empty: all 0. With order 3 it must be empty
  bool closed = false;
};

/// The spline of a control polygon. With n segments its poles are
///   order 1 P_0, then P_1 and P_2 of each segment, then P_3 of the last one: 2 n + 2; closed 2 n,
///                without the first and the last. A joint lies on the line from P_2 to the next P_1
///                and divides it in the ratio 1 : first.
///   order 2, 3 P_0, then D_0 .. D_n, then P_3 of the last one: n + 3; closed D_0 .. D_(n-1), n.
///   The poles
///                P_1, P_2 of segment i lie on D_i D_(i+1) and divide it in the ratio mu : 1 :
///                lambda, with
///                  mu = (1 + first) / (second - first - third),   lambda = third mu
///                of the joints at D_i and at D_(i+1); at the ends of an open spline 0. Joints as
///                above.
/// first, second, third are the factors of alphaJoinPoles(): Q_1 = P_3 + first (P_3 - P_2),
/// Q_2 = P_3 + second (P_3 - P_2) + third (P_1 - P_3).
///
/// So the poles lie on the polygon and in its order, which alpha-curves follow as their own: the
/// spline is in the hull, and no plane meets it more often than the polygon. This needs second >
/// first + third. With beta2 = 0 that holds for shapes above 1/2, with order 3 for shapes above
/// 2/3, and for smaller ones beside larger; in general for any beta2 that is large enough. Joints
/// of other shapes have no such polygon: alphaChain().
///
/// Identities (each has a test of its number):
///   (1) Every joint is G^order with beta1, beta2 (with order 3 beta2, beta3 of C8.5); C^order
///       for 1 and 0.
///   (2) Affine maps of the polygon map the spline.
///   (3) The polygon run backwards, with shapes and lengths backwards and 1 / beta1, beta2 /
///       beta1^3, is the spline run backwards.
///   (4) A pole of the polygon moves at most four segments (order 1: two).
///   (5) No plane meets the spline more often than the polygon.
/// \throws std::invalid_argument for poles not finite, counts that do not fit, less than one
/// segment (closed: two, with order 2 or 3 three), numbers out of range, joints with second <=
/// first + third, and joints without tangent; with the index and the value.
/// Source: docs/theory/curves.md C8.4 to C8.6; [TuYanXu2022] (the joins).
AlphaSpline alphaSpline(const Poles& polygon, const AlphaSplineShape& shape);

/// A segment of a chain: its join with the segment before, and the poles that the join leaves free.
struct AlphaLink {
  AlphaCurveJoin join;  ///< length is not read: it is that of the segment before
  Poles free_poles;     ///< P_2 and P_3, with order 2 or 3 only P_3
};

/// The chain that begins with \p first, over [0, length], and goes on link by link: for any shapes.
/// A pole moves all that follows; with order 2 or 3 the factors multiply up along the chain, so
/// long ones swing out.
///   (6) A spline taken apart into its first segment and links is that chain, but for rounding.
/// \throws std::invalid_argument as alphaJoinPoles(), with the index of the link.
AlphaSpline alphaChain(const AlphaCurve& first, double length, const std::vector<AlphaLink>& links);

/// The same curve in Bézier segments of degree 5, exactly.
BezierSpline bezierSpline(const AlphaSpline& spline);

}  // namespace seamwright
