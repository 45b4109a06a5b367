// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/stl.h>

#include <seamwright/core/seam/curve_joint.hpp>

namespace seamwright::python {

inline pybind11::dict jointDict(const CurveJoint& joint, const ContinuityTolerance& tolerance) {
  pybind11::dict dict;
  dict["gap_mm"] = joint.gap_mm;
  dict["angle_rad"] = joint.angle_rad;
  dict["differences"] = joint.differences;
  dict["sizes"] = joint.sizes;
  dict["order_reached"] = orderReached(joint, tolerance);
  return dict;
}

}  // namespace seamwright::python
