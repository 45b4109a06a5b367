// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <seamwright/plugin/python/results.hpp>

namespace py = pybind11;

namespace seamwright::python {

namespace {

py::object classOf(const char* name) {
  return py::module_::import("seamwright.results").attr(name);
}

}  // namespace

py::object resultOf(const char* name, const py::object& items) {
  return classOf(name)(items);
}

py::list resultsOf(const char* name, const py::object& list) {
  const py::object type = classOf(name);
  py::list results;
  for (const py::handle item : list)
    results.append(item.is_none() ? py::object(py::none()) : type(item));
  return results;
}

py::object stackedResults(const char* name, const py::list& results,
                          const std::vector<py::ssize_t>& shape) {
  return classOf(name).attr("_stacked")(results, py::tuple(py::cast(shape)));
}

py::object itemOrSelf(const py::object& value, const char* item) {
  if (!py::isinstance(value, classOf("Result"))) return value;
  const auto items = py::reinterpret_borrow<py::dict>(value);
  return items.contains(item) ? py::object(items[item]) : value;
}

}  // namespace seamwright::python
