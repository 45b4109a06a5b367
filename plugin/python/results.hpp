// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

/// Results as instances of the classes in seamwright/results.py.
namespace seamwright::python {

/// An instance of the class \p name with these items.
pybind11::object resultOf(const char* name, const pybind11::object& items);

/// An instance of the class for each dict of a list; None stays None.
pybind11::list resultsOf(const char* name, const pybind11::object& list);

/// One result whose items are arrays of that shape, from a result for each of its elements.
pybind11::object stackedResults(const char* name, const pybind11::list& results,
                                const std::vector<pybind11::ssize_t>& shape);

/// The item of a result that has it; any other value as it is. So a result may be passed where one
/// of its values is needed.
pybind11::object itemOrSelf(const pybind11::object& value, const char* item);

}  // namespace seamwright::python
