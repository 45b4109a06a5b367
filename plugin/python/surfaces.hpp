// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/eigen.h>

#include <optional>
#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/core/join/condition/seam_parameter.hpp>
#include <seamwright/plugin/python/arguments.hpp>

/// Surfaces as arguments, and what results say of their seams.
namespace seamwright::python {

/// A BezierPatch or a BSplineSurface.
inline BSplineSurface splineSurfaceOf(const char* argument_name, const py::object& value) {
  if (py::isinstance<BezierPatch>(value)) return splineSurface(value.cast<const BezierPatch&>());
  return objectOf<BSplineSurface>(argument_name, value, "a BezierPatch or a BSplineSurface");
}

/// None, or the map of the parameter of side "a" or "b".
inline py::object parameterDict(const std::optional<SeamParameter>& parameter, bool of_a) {
  if (!parameter) return py::none();
  py::dict dict;
  dict["of"] = of_a ? "a" : "b";
  dict["numerator"] = parameter->numerator;
  dict["denominator"] = parameter->denominator;
  return dict;
}

}  // namespace seamwright::python
