// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <cmath>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/parameters.hpp>
#include <string>

namespace seamwright::python {

Parameters::Parameters(const char* name, const py::object& value) {
  constexpr const char* kind = "a number or an array of numbers";
  const bool is_text = PyUnicode_Check(value.ptr()) || PyBytes_Check(value.ptr());
  if (py::hasattr(value, "__len__") && !is_text && !isNumber(value)) {
    values_ = arrayOf(name, value);
  } else {
    values_ = Array(Shape{});
    *values_.mutable_data() = argument<double>(name, value, kind);
  }
  for (py::ssize_t i = 0; i < values_.size(); ++i)
    if (!std::isfinite(values_.data()[i]))
      throw py::value_error(std::string(name) + (isSingle() ? " is " : " has the value ") +
                            shown(py::float_(values_.data()[i])) + ": it must be finite");
}

ParameterPairs::ParameterPairs(const char* first_name, const py::object& first_value,
                               const char* second_name, const py::object& second_value)
    : first(first_name, first_value), second(second_name, second_value) {
  if (first.shape() == second.shape()) return;
  try {
    const py::object broadcast = py::module_::import("numpy").attr("broadcast_arrays");
    const py::list pair = broadcast(first.values(), second.values());
    first = Parameters(arrayOf(first_name, pair[0]));
    second = Parameters(arrayOf(second_name, pair[1]));
  } catch (const py::error_already_set&) {
    throw py::value_error(std::string(first_name) + " has shape " + shapeText(first.values()) +
                          ", " + second_name + " " + shapeText(second.values()) +
                          ": they do not broadcast to one shape");
  }
}

int derivativeOrder(const py::object& order, int most) {
  const int number = wholeNumber("order", order);
  if (number < 0)
    throw py::value_error("order " + std::to_string(number) + ": it must not be negative");
  if (number > most)
    throw py::value_error("order " + std::to_string(number) + ": it must be within " +
                          std::to_string(most));
  return number;
}

}  // namespace seamwright::python
