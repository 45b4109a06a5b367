// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <seamwright/core/fair/matrix_curve.hpp>
#include <seamwright/plugin/python/curves.hpp>
#include <seamwright/plugin/python/results.hpp>

namespace seamwright::python {

Curve curveOf(const std::string& name, const py::object& value) {
  const py::object curve = itemOrSelf(value, "curve");
  if (py::isinstance<BezierCurve>(curve)) return curve.cast<const BezierCurve&>();
  if (py::isinstance<BSplineCurve>(curve)) return curve.cast<const BSplineCurve&>();
  if (py::isinstance<BezierSpline>(curve)) return curve.cast<const BezierSpline&>();
  if (py::isinstance<MatrixCurve>(curve)) return bsplineCurve(curve.cast<const MatrixCurve&>());
  throw py::type_error(
      name + " is " + shown(value) +
      ": a BezierCurve, a BSplineCurve, a BezierSpline or a MatrixCurve is needed");
}

BezierCurve bezierCurveOf(const std::string& name, const py::object& value) {
  const CurveSegments segments(curveOf(name, value));
  if (segments.parts().size() == 1) return segments.parts().front().curve;
  throw py::value_error(name + " is a spline of " + std::to_string(segments.parts().size()) +
                        " segments: a curve of one segment is needed");
}

BezierSpline bezierSplineOf(const std::string& name, const py::object& value) {
  const Curve curve = curveOf(name, value);
  if (const auto* bezier = std::get_if<BezierCurve>(&curve)) return bezierSpline({*bezier}, {0, 1});
  if (const auto* bspline = std::get_if<BSplineCurve>(&curve)) return bezierSpline(*bspline);
  return std::get<BezierSpline>(curve);
}

std::vector<BezierSpline> bezierSplinesOf(const std::string& name, const py::object& value) {
  if (!isSequence(value))
    throw py::value_error(name + " is " + shown(value) + ": a sequence of curves is needed");
  std::vector<BezierSpline> splines;
  for (const py::handle item : value)
    splines.push_back(bezierSplineOf(name + "[" + std::to_string(splines.size()) + "]",
                                     py::reinterpret_borrow<py::object>(item)));
  return splines;
}

BSplineCurve bsplineCurveOf(const std::string& name, const py::object& value) {
  const Curve curve = curveOf(name, value);
  if (const auto* bezier = std::get_if<BezierCurve>(&curve)) return splineCurve(*bezier);
  if (const auto* spline = std::get_if<BezierSpline>(&curve))
    return bsplineCurve(*spline, continuity(*spline));
  return std::get<BSplineCurve>(curve);
}

CurveSegments::CurveSegments(const Curve& curve) {
  if (const auto* bezier = std::get_if<BezierCurve>(&curve)) {
    parts_.push_back({*bezier, 0, 1});
    return;
  }
  const auto* bspline = std::get_if<BSplineCurve>(&curve);
  const BezierSpline spline = bspline ? bezierSpline(*bspline) : std::get<BezierSpline>(curve);
  for (int i = 0; i < spline.segments(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    parts_.push_back({segment(spline, i), spline.knots[k], spline.knots[k + 1] - spline.knots[k]});
  }
  end_ = spline.knots.back();
}

const CurveSegments::Part& CurveSegments::at(double t) const {
  const auto after = std::ranges::upper_bound(parts_, t, {}, &Part::start);
  return after == parts_.begin() ? *after : *std::prev(after);
}

Poles CurveSegments::poles() const {
  Eigen::Index count = 0;
  for (const Part& part : parts_) count += part.curve.degree() + 1;
  Poles all(count, 3);
  Eigen::Index row = 0;
  for (const Part& part : parts_) {
    all.middleRows(row, part.curve.degree() + 1) = part.curve.poles();
    row += part.curve.degree() + 1;
  }
  return all;
}

}  // namespace seamwright::python
