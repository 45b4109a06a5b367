// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <seamwright/occ_adapter/analyze/report.hpp>

/// The state of a pickled report: all its values in one list, in the order of the members.
namespace seamwright::python {

pybind11::list stateOf(occ::Report report);

/// \throws ValueError if the list was written by a version with other members.
occ::Report reportFrom(const pybind11::list& state);

}  // namespace seamwright::python
