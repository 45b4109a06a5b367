// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <optional>
#include <vector>

#include <seamwright/core/numeric.hpp>

/// Curvature of faces, for reports. Not a public header.
namespace seamwright::occ {

/// How faces bend, at points of a grid inside of them.
struct Bends {
  double largest_per_mm = 0;      ///< normal curvature
  Interval mean_per_mm = {0, 0};  ///< mean curvature towards the normals of the faces, and 0
};

/// Nothing if there are no points inside, or OpenCASCADE can't evaluate them.
std::optional<Bends> bendsOf(const std::vector<TopoDS_Shape>& faces);

/// The largest normal curvature of a face at points along one of its edges; nothing if OpenCASCADE
/// can't evaluate it.
std::optional<double> largestCurvatureAlong_per_mm(const TopoDS_Edge& edge,
                                                   const TopoDS_Face& face);

}  // namespace seamwright::occ
