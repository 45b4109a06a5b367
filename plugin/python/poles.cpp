// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/plugin/python/poles.hpp>
#include <string>

namespace py = pybind11;

namespace seamwright::python {

namespace {

std::string shapeText(const Array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i)
    text += (i ? ", " : "") + std::to_string(array.shape(i));
  return text + ")";
}

}  // namespace

Array arrayOf(const py::handle& value) {
  const auto refuse = [&](const std::string& why) {
    PyErr_Clear();
    throw py::value_error("poles, weights or points are " + py::cast<std::string>(py::repr(value)) +
                          ": " + why + "an array of real numbers is needed");
  };
  const auto array = py::array::ensure(py::reinterpret_borrow<py::object>(value));
  if (!array) refuse("");
  const std::string kind(1, array.dtype().kind());
  if (std::string("iufO").find(kind) == std::string::npos)
    refuse("numbers of " + py::cast<std::string>(py::str(array.dtype())) + ", but ");
  const auto numbers =
      py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!numbers) refuse("");
  return Array(numbers);
}

Poles polesOf(const Array& array, py::ssize_t dimensions, const char* wanted) {
  if (array.ndim() != dimensions || array.shape(dimensions - 1) != 3)
    throw py::value_error("poles have shape " + shapeText(array) + ": " + wanted + " is needed");
  return Eigen::Map<const Poles>(array.data(), array.size() / 3, 3);
}

Eigen::VectorXd weightsOf(const Array& weights, const Array& poles) {
  bool same = weights.ndim() == poles.ndim() - 1;
  for (py::ssize_t i = 0; same && i < weights.ndim(); ++i)
    same = weights.shape(i) == poles.shape(i);
  if (!same)
    throw py::value_error("weights have shape " + shapeText(weights) + ", poles " +
                          shapeText(poles) + ": one weight for each pole is needed");
  return Eigen::Map<const Eigen::VectorXd>(weights.data(), weights.size());
}

}  // namespace seamwright::python
