// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bspline/curve.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <variant>
#include <vector>

/// Arguments that are curves of any class.
namespace seamwright::python {

using Curve = std::variant<BezierCurve, BSplineCurve, BezierSpline>;

/// A curve, or the curve of a result that has one. \throws TypeError that names the argument.
Curve curveOf(const std::string& name, const py::object& value);

/// A curve of any class as a spline. A BezierCurve has the parameter 0..1.
BezierSpline bezierSplineOf(const std::string& name, const py::object& value);

/// Curves of any class as splines. \throws ValueError that names the argument, or its item.
std::vector<BezierSpline> bezierSplinesOf(const std::string& name, const py::object& value);

/// A curve of any class as a BSplineCurve: exactly, with the fewest knots.
BSplineCurve bsplineCurveOf(const std::string& name, const py::object& value);

/// A curve as a BezierCurve. \throws ValueError for a spline of several segments.
BezierCurve bezierCurveOf(const std::string& name, const py::object& value);

/// The Bézier segments of a curve with their intervals in its parameter.
class CurveSegments {
 public:
  explicit CurveSegments(const Curve& curve);

  /// A segment with the parameter 0..1.
  struct Part {
    BezierCurve curve;
    double start = 0;   ///< parameter of the whole curve at 0
    double length = 0;  ///< of the interval

    double local(double t) const { return (t - start) / length; }
    double whole(double s) const { return start + length * s; }
  };

  const std::vector<Part>& parts() const { return parts_; }
  double start() const { return parts_.front().start; }
  double end() const { return end_; }
  /// The segment at the parameter; at a knot the one after it.
  const Part& at(double t) const;
  /// All poles, as those of one Bézier curve.
  Poles poles() const;

 private:
  std::vector<Part> parts_;
  double end_ = 1;
};

}  // namespace seamwright::python
