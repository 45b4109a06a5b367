// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <seamwright/core/spline/beta_spline.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/poles.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <string>
#include <vector>

namespace seamwright::python {

namespace {

SplineEnds endsOf(const py::object& value) {
  const auto name = argument<std::string>("ends", value, "a name");
  if (name == "natural") return SplineEnds::Natural;
  if (name == "clamped") return SplineEnds::Clamped;
  if (name == "periodic") return SplineEnds::Periodic;
  throw py::value_error("ends is " + shown(value) +
                        ": known are 'natural', 'clamped' and 'periodic'");
}

/// The vector \p value; it must be given with clamped ends and only with them.
Eigen::Vector3d derivativeOf(const char* name, const py::object& value, SplineEnds ends) {
  if (value.is_none() != (ends != SplineEnds::Clamped))
    throw py::value_error(std::string(name) + " is " + shown(value) +
                          ": it is needed with clamped ends, and has no meaning with others");
  if (value.is_none()) return Eigen::Vector3d::Zero();
  return vectorOf(name, value);
}

/// The nu of a natural end; 0 for None. Other ends have no nu.
double endNuOf(const char* name, const py::object& value, SplineEnds ends) {
  if (value.is_none()) return 0;
  if (ends != SplineEnds::Natural)
    throw py::value_error(std::string(name) + " is " + shown(value) +
                          ": it has no meaning but with natural ends");
  return numberOf(name, value);
}

Poles pointsOf(const py::object& points) {
  return rowsOf("points", points, "(count, 3)");
}

template <class Spline>
py::object resultOfSpline(const Spline& spline) {
  py::dict dict;
  dict["curve"] = spline.curve;
  dict["derivatives"] = spline.derivatives;
  dict["stationary"] = spline.stationary;
  return resultOf("InterpolatingSpline", dict);
}

py::object nuOf(const py::object& points, const py::object& knots, const py::object& nu,
                const py::object& ends, const py::object& start_derivative,
                const py::object& end_derivative) {
  NuSplineData data;
  data.points = pointsOf(points);
  data.ends = endsOf(ends);
  data.knots = knots.is_none() ? knotsOf(data.points) : listOf("knots", knots);
  data.nu = each("nu", nu, data.points.rows());
  data.start_derivative = derivativeOf("start_derivative", start_derivative, data.ends);
  data.end_derivative = derivativeOf("end_derivative", end_derivative, data.ends);
  return resultOfSpline([&] {
    const py::gil_scoped_release release;
    return nuSpline(data);
  }());
}

py::object betaOf(const py::object& points, const py::object& bias, const py::object& tension,
                  const py::object& ends, const py::object& start_nu, const py::object& end_nu,
                  const py::object& start_derivative, const py::object& end_derivative) {
  BetaSplineData data;
  data.points = pointsOf(points);
  data.ends = endsOf(ends);
  data.bias = each("bias", bias, data.points.rows());
  data.tension = each("tension", tension, data.points.rows());
  data.start_nu = endNuOf("start_nu", start_nu, data.ends);
  data.end_nu = endNuOf("end_nu", end_nu, data.ends);
  data.start_derivative = derivativeOf("start_derivative", start_derivative, data.ends);
  data.end_derivative = derivativeOf("end_derivative", end_derivative, data.ends);
  return resultOfSpline([&] {
    const py::gil_scoped_release release;
    return betaSpline(data);
  }());
}

std::vector<double> splineKnots(const py::object& points, const py::object& exponent) {
  return knotsOf(pointsOf(points), numberOf("exponent", exponent));
}

}  // namespace

void bindNuSpline(py::module_& module) {
  module.def("nu_spline", &nuOf, py::arg("points"), py::arg("knots") = py::none(), py::kw_only(),
             py::arg("nu") = 0.0, py::arg("ends") = "natural",
             py::arg("start_derivative") = py::none(), py::arg("end_derivative") = py::none(),
             R"(Nielson's nu-spline through points (count, 3) in mm: an InterpolatingSpline.

It is cubic, C1, with X''(+) - X''(-) = nu X' at each point. knots: one a point, None:
spline_knots(points). nu: a number or one a point. ends: 'natural', 'clamped', with
start_derivative and end_derivative (3,) by the parameter, or 'periodic' (the last point is the
first). ValueError for bad arguments, and where the equations are singular.)");
  module.def(
      "beta_spline", &betaOf, py::arg("points"), py::arg("bias") = 1.0, py::arg("tension") = 0.0,
      py::kw_only(), py::arg("ends") = "natural", py::arg("start_nu") = py::none(),
      py::arg("end_nu") = py::none(), py::arg("start_derivative") = py::none(),
      py::arg("end_derivative") = py::none(),
      R"(The interpolating beta-spline through points (count, 3) in mm: an InterpolatingSpline.

Each segment runs over an interval of length 1. At each joint X'(-) = bias X'(+), X''(-) = bias^2
X''(+) + tension X'(+). bias, tension: a number or one a point. It tightens for tension to minus
infinity. Ends as for nu_spline; natural ones have X'' = start_nu X' and X'' = -end_nu X', 0 for
None.)");
  module.def("spline_knots", &splineKnots, py::arg("points"), py::arg("exponent") = 0.5,
             "Knots that grow by the distance of neighbours to that exponent: 0 uniform, 1/2 "
             "centripetal, 1 chord length. points: (count, 3).");
}

}  // namespace seamwright::python
