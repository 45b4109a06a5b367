// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>
#include <seamwright/occ_adapter/progress.hpp>
#include <string>

/// What the calls on models share.
namespace seamwright::python {

namespace py = pybind11;

/// Calls a Python callable from a thread without the GIL; also lets Ctrl-C through. The callable has to outlive it.
occ::Progress progressOf(const py::object& callable);

/// Dicts, lists, numbers, texts and None.
py::object plainObject(const nlohmann::ordered_json& json);

/// Text that quotes the name of a file, which may hold any byte; what is no UTF-8 is replaced.
py::str readable(const std::string& text);

}  // namespace seamwright::python
