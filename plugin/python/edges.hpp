// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bezier/patch_edge.hpp>
#include <seamwright/plugin/python/arguments.hpp>

/// Edges from their names.
namespace seamwright::python {

inline PatchEdge patchEdgeOf(const char* argument_name, const py::object& value) {
  if (const auto edge = patchEdgeFromName(argument<std::string>(argument_name, value, "a name")))
    return *edge;
  throw py::value_error(std::string(argument_name) + " " + shown(value) +
                        ": known of a patch are u0, u1, v0 and v1");
}

inline TriangleEdge triangleEdgeOf(const char* argument_name, const py::object& value) {
  if (const auto edge = triangleEdgeFromName(argument<std::string>(argument_name, value, "a name")))
    return *edge;
  throw py::value_error(std::string(argument_name) + " " + shown(value) +
                        ": known of a triangle are l0, l1 and l2");
}

}  // namespace seamwright::python
