// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/bspline/curve.hpp>
#include <seamwright/core/seam/curve_joint.hpp>

namespace seamwright {

/// Bézier segments of one degree end to end. Every spline of this library is built in this form.
///
/// Segment i runs over [knots[i], knots[i + 1]] and has the poles i degree .. (i + 1) degree:
/// neighbours share the pole between them, so gaps are impossible. Their smoothness depends on the
/// poles; measureJoints() measures it. Poles are homogeneous as in BezierCurve: for a polynomial
/// spline w = 1 for all poles.
struct BezierSpline {
  int degree = 0;
  std::vector<double> knots;  ///< segments + 1, increasing
  HomogeneousPoles poles;     ///< segments * degree + 1 rows
  bool closed = false;        ///< the end and the beginning are the same point, which is a joint

  int segments() const { return static_cast<int>(knots.size()) - 1; }

  bool operator==(const BezierSpline& other) const {
    return degree == other.degree && knots == other.knots && closed == other.closed &&
           poles.rows() == other.poles.rows() && poles == other.poles;
  }
};

/// Checks a spline. \throws std::invalid_argument, with index and value, if counts and knots do not
/// match, knots do not increase, a number is not finite, a weight is not positive, or a closed
/// spline does not end at its beginning. In a closed spline the last homogeneous pole is bitwise
/// the first one times the ratio of the two weights.
void requireValid(const BezierSpline& spline);

/// Segment i with the parameter 0..1. \throws std::invalid_argument for another i.
BezierCurve segment(const BezierSpline& spline, int i);

/// Joins segments, raised to the highest of their degrees. The homogeneous poles of each segment
/// are multiplied by a factor, so that its first weight equals the last weight of the previous
/// segment; this changes no point. The pole between two segments is taken from the later one;
/// poles beside it that were equal to the earlier one move along.
/// \param knots one more than segments.
/// \throws std::invalid_argument for no segments, knots that requireValid() refuses, and ends that
/// are further apart than \p gap_mm, with the index of the joint (the index of its knot) and the
/// distance.
BezierSpline bezierSpline(const std::vector<BezierCurve>& segments,
                          const std::vector<double>& knots, bool closed = false, double gap_mm = 0);

/// The same over the lengths of the segments' control polygons: the knots are their sums from 0.
/// Segments whose polygon has no length are left out.
/// \throws std::invalid_argument as bezierSpline(), and if no segment is left.
BezierSpline splineOverLengths(const std::vector<BezierCurve>& segments, bool closed = false,
                               double gap_mm = 0);

/// Point and derivatives by the spline's parameter, (order + 1) by 3. At a knot they belong to the
/// segment after it; at the end and beyond the ends, to the outermost segment. The time is O(log
/// segments + order^2). Values beyond the range of a double are infinite.
/// \throws std::invalid_argument if counts do not match, for a parameter that is not finite, and
/// for a negative order.
CurveDerivatives derivatives(const BezierSpline& spline, double t, int order);

/// The joints at knots[1] .. knots[segments - 1], and for a closed spline as the last one the joint
/// of its end with its beginning. The time is O(segments).
std::vector<CurveJoint> measureJoints(const BezierSpline& spline, int order);

/// The order, up to degree - 1, up to which derivatives by the parameter agree at every inner knot
/// except for rounding. With \p around, the end and the beginning of a closed spline have to agree
/// too. Rounding means two things: a jump is at most what an error of 8 (degree + 4) eps, relative
/// to the poles beside the knot, causes; and the poles of the merged curve reproduce the segments
/// up to 4^order times that. For a rational spline the derivatives of the homogeneous curve have to
/// agree. The result is -1 for \p around if the spline is not closed, or if its first and last
/// weights differ.
/// \throws std::invalid_argument as requireValid() does, and for a degree above 25.
int continuity(const BezierSpline& spline, bool around = false);

/// The same curve with inner knots of multiplicity degree - order: the fewest knots if derivatives
/// by the parameter agree up to \p order at every inner knot. It is exact: poles are blossoms (for
/// C^1 the inner poles themselves), and nothing is fitted.
/// \param order 0 to degree - 1; at most continuity().
/// \throws std::invalid_argument for another order, a degree above 25, and for a derivative that
/// jumps by more than continuity() allows, with the knot's index, the order, the jump and its bound
/// of rounding; or with the index of the segment that is not reproduced.
/// Source: docs/theory/curves.md C10.1, C10.2; [Ramshaw1989].
BSplineCurve bsplineCurve(const BezierSpline& spline, int order);

/// The Bézier segments of a B-spline curve, with its knots. Knots are inserted until their
/// multiplicity is the degree.
BezierSpline bezierSpline(const BSplineCurve& curve, bool closed = false);

}  // namespace seamwright
