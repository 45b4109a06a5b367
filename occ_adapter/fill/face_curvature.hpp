// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <optional>
#include <vector>

/// Curvature of faces, for reports. Not a public header.
namespace seamwright::occ {

/// The largest normal curvature at points of a grid inside of the faces; nothing if there are no
/// such points, or OpenCASCADE can't evaluate them.
std::optional<double> largestCurvature_per_mm(const std::vector<TopoDS_Shape>& faces);

}  // namespace seamwright::occ
