// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <optional>
#include <seamwright/core/bernstein/polynomial.hpp>
#include <seamwright/plugin/python/bindings.hpp>

namespace py = pybind11;

namespace seamwright::python {

namespace {

py::tuple pairOf(const Interval& interval) {
  return py::make_tuple(interval.lower, interval.upper);
}

}  // namespace

void bindBernstein(py::module_& module) {
  using Polynomial = BernsteinPolynomial;
  py::class_<Polynomial>(
      module, "BernsteinPolynomial", py::module_local(),
      "A polynomial on [0, 1] by its Bernstein coefficients, each known to within padding; "
      "padding grows with rounding, so the true polynomial stays inside.")
      .def(py::init<Eigen::VectorXd, double>(), py::arg("coefficients"), py::arg("padding") = 0.0)
      .def_property_readonly("degree", &Polynomial::degree)
      .def_property_readonly("coefficients", &Polynomial::coefficients)
      .def_property_readonly("padding", &Polynomial::padding)
      .def(
          "evaluate", [](const Polynomial& p, double t) { return pairOf(p.evaluate(t)); },
          py::arg("t"), "(lower, upper) around the value at t.")
      .def("derivative", &Polynomial::derivative)
      .def("elevated", &Polynomial::elevated, py::arg("by"),
           "The same polynomial written in a higher degree.")
      .def("split", &Polynomial::split, py::arg("t"), "The pieces over [0, t] and [t, 1].")
      .def(
          "restricted",
          [](const Polynomial& p, double lower, double upper) {
            return p.restricted({lower, upper});
          },
          py::arg("lower"), py::arg("upper"), "The piece over [lower, upper].")
      .def(
          "range",
          [](const Polynomial& p, const std::optional<double>& tolerance) {
            return pairOf(tolerance ? p.range(*tolerance) : p.range());
          },
          py::arg("tolerance") = py::none(),
          "(lower, upper) around all values: the hull of the coefficients, or subdivided until it "
          "is too "
          "wide "
          "by at most the tolerance.")
      .def(-py::self)
      .def(py::self + py::self)
      .def(py::self - py::self)
      .def(py::self * py::self)
      .def(double() * py::self)
      .def(
          "__mul__", [](const Polynomial& p, double factor) { return factor * p; },
          py::is_operator())
      .def(py::self == py::self)
      .attr("__hash__") = py::none();
}

}  // namespace seamwright::python
