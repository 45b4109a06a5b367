// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <vector>

#include "repair_checks.hpp"

/// What fills of holes are checked by.
namespace seamwright::test {

TopoDS_Shape without(const TopoDS_Shape& shape, const std::vector<int>& faces);
/// The largest angle along all edges of the faces, each between two, at 101 points of each.
double largestAngle_rad(const TopoDS_Shape& shape, const std::vector<int>& faces);

}  // namespace seamwright::test
