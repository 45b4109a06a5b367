// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/stl.h>

#include <seamwright/core/seam/curve_joint.hpp>
#include <seamwright/plugin/python/results.hpp>

namespace seamwright::python {

/// A CurveJoint of seamwright/results.py.
inline pybind11::object jointResult(const CurveJoint& joint, const ContinuityTolerance& tolerance) {
  pybind11::dict dict;
  dict["gap_mm"] = joint.gap_mm;
  dict["angle_rad"] = joint.angle_rad;
  dict["differences"] = joint.differences;
  dict["sizes"] = joint.sizes;
  dict["order_reached"] = orderReached(joint, tolerance);
  return resultOf("CurveJoint", dict);
}

}  // namespace seamwright::python
