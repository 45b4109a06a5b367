// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/plugin/python/poles.hpp>

namespace py = pybind11;

namespace seamwright::python {

namespace {

/// Whether an argument is named in the plural: "poles", but not "cross".
bool isPlural(const std::string& name) {
  return name.ends_with('s') && !name.ends_with("ss");
}

}  // namespace

std::string shapeText(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i)
    text += (i ? ", " : "") + std::to_string(array.shape(i));
  return text + ")";
}

Array arrayOf(const std::string& name, const py::handle& value) {
  const auto refuse = [&](const std::string& why) {
    PyErr_Clear();
    throw py::value_error(name + (isPlural(name) ? " are " : " is ") +
                          py::cast<std::string>(py::repr(value)) + ": " + why +
                          "an array of real numbers is needed");
  };
  const auto array = py::array::ensure(py::reinterpret_borrow<py::object>(value));
  if (!array) refuse("");
  const std::string kind(1, array.dtype().kind());
  if (std::string("iufO").find(kind) == std::string::npos)
    refuse("numbers of " + py::cast<std::string>(py::str(array.dtype())) + ", but ");
  const auto numbers = Array::ensure(array);
  if (!numbers) refuse("");
  return numbers;
}

Poles polesOf(const std::string& name, const Array& array, py::ssize_t dimensions,
              const char* wanted) {
  if (array.ndim() != dimensions || array.shape(dimensions - 1) != 3)
    throw py::value_error(name + (isPlural(name) ? " have shape " : " has shape ") +
                          shapeText(array) + ": " + wanted + " is needed");
  return Eigen::Map<const Poles>(array.data(), array.size() / 3, 3);
}

Poles rowsOf(const std::string& name, const py::handle& value, const char* wanted) {
  return polesOf(name, arrayOf(name, value), 2, wanted);
}

Eigen::VectorXd weightsOf(const py::object& weights, const Array& poles) {
  if (weights.is_none()) return Eigen::VectorXd::Ones(poles.size() / 3);
  const Array numbers = arrayOf("weights", weights);
  bool same = numbers.ndim() == poles.ndim() - 1;
  for (py::ssize_t i = 0; same && i < numbers.ndim(); ++i)
    same = numbers.shape(i) == poles.shape(i);
  if (!same)
    throw py::value_error("weights have shape " + shapeText(numbers) + ", poles " +
                          shapeText(poles) + ": one weight for each pole is needed");
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), numbers.size());
}

Array homogeneousArray(const HomogeneousPoles& poles) {
  Array state({poles.rows(), Eigen::Index{4}});
  Eigen::Map<HomogeneousPoles>(state.mutable_data(), poles.rows(), 4) = poles;
  return state;
}

HomogeneousPoles homogeneousRows(const Array& state) {
  if (state.ndim() != 2 || state.shape(1) != 4)
    throw py::value_error("state has shape " + shapeText(state) + ": (n, 4) is needed");
  return Eigen::Map<const HomogeneousPoles>(state.data(), state.shape(0), 4);
}

}  // namespace seamwright::python
