// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <array>
#include <seamwright/core/bernstein/polynomial.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/parameters.hpp>

namespace seamwright::python {

namespace {

using Polynomial = BernsteinPolynomial;

py::tuple pairOf(const Interval& interval) {
  return py::make_tuple(interval.lower, interval.upper);
}

Polynomial makePolynomial(const py::object& coefficients, const py::object& padding) {
  return Polynomial(numbersOf("coefficients", coefficients), numberOf("padding", padding));
}

/// (lower, upper): two numbers, or two arrays.
py::tuple boundsAt(const Polynomial& polynomial, const py::object& t) {
  const Parameters at("t", t);
  if (at.isSingle()) return pairOf(polynomial.evaluate(at[0]));
  Array lower(at.shape()), upper(at.shape());
  for (py::ssize_t i = 0; i < at.size(); ++i) {
    const Interval interval = polynomial.evaluate(at[i]);
    lower.mutable_data()[i] = interval.lower;
    upper.mutable_data()[i] = interval.upper;
  }
  return py::make_tuple(lower, upper);
}

Polynomial restrictedTo(const Polynomial& polynomial, const py::object& lower,
                        const py::object& upper) {
  return polynomial.restricted({numberOf("lower", lower), numberOf("upper", upper)});
}

py::tuple rangeOf(const Polynomial& polynomial, const py::object& tolerance) {
  const std::optional<double> width = optionalNumber("tolerance", tolerance);
  return pairOf(width ? polynomial.range(*width) : polynomial.range());
}

/// The product with a number; NotImplemented for anything else, so that Python tries the other
/// operand.
py::object multipliedBy(const Polynomial& polynomial, const py::object& factor) {
  if (!isNumber(factor)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
  return py::cast(numberOf("factor", factor) * polynomial);
}

template <class Class>
void bindOperators(Class& type) {
  type.def(-py::self)
      .def(py::self + py::self)
      .def(py::self - py::self)
      .def(py::self * py::self)
      .def("__mul__", &multipliedBy, py::is_operator())
      .def("__rmul__", &multipliedBy, py::is_operator())
      .def(py::self == py::self)
      .attr("__hash__") = py::none();
  // Without it an array of numpy on the left would multiply element by element.
  type.attr("__array_ufunc__") = py::none();
}

}  // namespace

void bindBernstein(py::module_& module) {
  py::class_<Polynomial> type(
      module, "BernsteinPolynomial", py::module_local(),
      "A polynomial on [0, 1] by its Bernstein coefficients, each known to within padding; "
      "padding grows with rounding, so the true polynomial stays inside.");
  type.def(py::init(&makePolynomial), py::arg("coefficients"), py::arg("padding") = 0.0)
      .def_property_readonly("degree", &Polynomial::degree, "The number of coefficients minus 1.")
      .def_property_readonly("coefficients", &Polynomial::coefficients, "(degree+1,).")
      .def_property_readonly(
          "padding", &Polynomial::padding,
          "No true coefficient, and so no true value on [0, 1], is further from the stored one.")
      .def("evaluate", &boundsAt, py::arg("t"),
           "(lower, upper) around the value at t in [0, 1]; two arrays for an array.")
      .def("derivative", &Polynomial::derivative, "The derivative by t, one degree lower.")
      .def(
          "elevated",
          [](const Polynomial& p, const py::object& by) {
            return p.elevated(wholeNumber("by", by));
          },
          py::arg("by"), "The same polynomial written in a higher degree.")
      .def(
          "split",
          [](const Polynomial& p, const py::object& t) { return p.split(numberOf("t", t)); },
          py::arg("t"), "The pieces over [0, t] and [t, 1].")
      .def("restricted", &restrictedTo, py::arg("lower"), py::arg("upper"),
           "The piece over [lower, upper].")
      .def("range", &rangeOf, py::arg("tolerance") = py::none(),
           "(lower, upper) around all values: the hull of the coefficients, or subdivided until it "
           "is too wide by at most the tolerance.")
      .def(py::pickle(
          [](const Polynomial& p) { return py::make_tuple(p.coefficients(), p.padding()); },
          [](const py::tuple& state) {
            return Polynomial(state[0].cast<Eigen::VectorXd>(), state[1].cast<double>());
          }))
      .def("__repr__", [](const Polynomial& p) {
        return "<BernsteinPolynomial of degree " + std::to_string(p.degree()) + ">";
      });
  bindOperators(type);
}

}  // namespace seamwright::python
