// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include <seamwright/core/planar/arc_distance.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

/// A planar curve that is being fitted. Not a public header.
namespace seamwright {

/// Point, direction and change of the curvature of a curve at a parameter.
struct CurveFrame {
  Eigen::Vector2d point;
  double direction_rad = 0;
  /// Change of the curvature by arc length; 0 at an end at which the segment stops.
  double curvature_slope_per_mm2 = 0;
};

/// \param index of the segment, for messages.
/// \throws std::domain_error where the curve stops, except at an end with stoppedEnds().
CurveFrame frameAt(const BezierCurve& segment, double t, int index);

/// A curve of N segments with the parameter u from 0 to N; segment i runs from i to i + 1.
struct PlanarCurve {
  std::vector<BezierCurve> segments;
  std::vector<CurvePolynomials> polynomials;
  std::vector<Eigen::Vector2d> origins;

  int count() const { return static_cast<int>(segments.size()); }
  int segmentAt(double u) const { return std::min(static_cast<int>(u), count() - 1); }
  CurveFrame startOf(int i) const { return frameAt(segments[i], 0, i); }
  CurveFrame endOf(int i) const { return frameAt(segments[i], 1, i); }
  CurveFrame at(double u) const {
    const int i = segmentAt(u);
    return frameAt(segments[i], u - i, i);
  }
  Eigen::Vector2d point(double u) const {
    const int i = segmentAt(u);
    return segments[i].point(u - i).head<2>();
  }
  /// \throws std::domain_error where the curve stops.
  double direction_rad(int segment, double t) const {
    return frameAt(segments[segment], t, segment).direction_rad;
  }
};

/// \throws std::invalid_argument for a pole outside of the plane z = 0.
PlanarCurve planarCurve(const BezierSpline& spline);

/// alongCircle() of the curve over a range of its parameter.
std::optional<AlongCircle> alongCircle(const PlanarCurve& curve, const Interval& range,
                                       const PlanarArc& arc, double tolerance_mm);

}  // namespace seamwright
