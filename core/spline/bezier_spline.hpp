// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/bspline/curve.hpp>
#include <seamwright/core/seam/curve_joint.hpp>

namespace seamwright {

/// Bézier segments of one degree end to end: what every spline of this library is made as.
///
/// Segment i runs over [knots[i], knots[i + 1]] and has the poles i degree .. (i + 1) degree:
/// neighbours share the pole between them, so gaps cannot be. How smoothly they meet is in the
/// poles; measureJoints() says it. Homogeneous, as BezierCurve: a polynomial spline has w = 1
/// throughout.
struct BezierSpline {
  int degree = 0;
  std::vector<double> knots;  ///< segments + 1, increasing
  HomogeneousPoles poles;     ///< segments degree + 1 rows
  bool closed = false;        ///< the end and the beginning are one point, and a joint

  int segments() const { return static_cast<int>(knots.size()) - 1; }

  bool operator==(const BezierSpline& other) const {
    return degree == other.degree && knots == other.knots && closed == other.closed &&
           poles.rows() == other.poles.rows() && poles == other.poles;
  }
};

/// \throws std::invalid_argument if counts and knots do not fit, knots do not increase, a number is
/// not finite, a weight is not positive, or a closed spline does not end where it begins: its last
/// homogeneous pole is the first one times the ratio of the two weights, bit by bit; with the index
/// and the value.
void requireValid(const BezierSpline& spline);

/// Segment i with the parameter 0..1. \throws std::invalid_argument for another i.
BezierCurve segment(const BezierSpline& spline, int i);

/// Joins segments, raised to the highest of their degrees; the homogeneous poles of each are
/// multiplied by what makes its first weight the last one of the segment before, which changes no
/// point. The pole between two is that of the later one. \param knots one more than segments.
/// \throws std::invalid_argument for no segments, knots as requireValid(), and where ends are
/// further apart than
/// \p gap_mm, with the index of the joint (that of its knot) and the distance.
BezierSpline bezierSpline(const std::vector<BezierCurve>& segments,
                          const std::vector<double>& knots, bool closed = false, double gap_mm = 0);

/// Point and derivatives by the spline's own parameter, (order + 1) by 3. At a knot those of the
/// segment after it; at the end and beyond, those of the outermost segment. O(log segments +
/// order^2). Beyond what a double holds they are infinite.
/// \throws std::invalid_argument if counts do not fit, for a parameter that is not finite and a
/// negative order.
CurveDerivatives derivatives(const BezierSpline& spline, double t, int order);

/// The joints at knots[1] .. knots[segments - 1], and of a closed spline that of its end with its
/// beginning last. O(segments).
std::vector<CurveJoint> measureJoints(const BezierSpline& spline, int order);

/// The order, up to degree - 1, to which derivatives by the parameter agree at every inner knot
/// (and, \p around, from the end of a closed spline to its beginning) but for rounding: a jump is
/// at most what 8 (degree + 4) eps, relative to the poles beside the knot, makes of it, and poles
/// of the merged curve give the segments back to 4^order times that. Of a rational spline it is the
/// derivatives of the homogeneous curve that must agree. -1 for
/// \p around of a spline that is not closed, or one whose first and last weight differ.
/// \throws std::invalid_argument as requireValid(), and for a degree above 25.
int continuity(const BezierSpline& spline, bool around = false);

/// The same curve with the fewest knots for which derivatives by the parameter agree up to \p order
/// at every inner knot: multiplicity degree - order. Exact: poles are blossoms (for C^1 the inner
/// poles themselves), nothing is fitted.
/// \param order 0 to degree - 1; at most continuity().
/// \throws std::invalid_argument for another order, a degree above 25, and where a derivative jumps
/// by more than continuity() allows, with the knot's index, the order, the jump and what rounding
/// makes of it; or with the index of the segment that is not given back.
/// Source: docs/theory/curves.md C10.1, C10.2; [Ramshaw1989].
BSplineCurve bsplineCurve(const BezierSpline& spline, int order);

/// The Bézier segments of a B-spline curve (knots inserted until they are as many as the degree),
/// with its knots.
BezierSpline bezierSpline(const BSplineCurve& curve, bool closed = false);

}  // namespace seamwright
