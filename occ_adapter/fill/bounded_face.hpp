// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Face.hxx>
#include <optional>
#include <vector>

#include <seamwright/occ_adapter/fill/holes.hpp>

/// A face on a surface, bounded by the edges of a hole. Not a public header.
namespace seamwright::occ {

/// An edge of a hole as its curve in space and as its pcurve on the new surface.
struct BoundaryEdge {
  HoleEdge edge;
  opencascade::handle<Geom_Curve> curve;
  TopLoc_Location location;  ///< location of the curve
  opencascade::handle<Geom2d_Curve> on_surface;
  double first = 0, last = 0;
};

/// The edge with its curve in space, without a pcurve; nothing if it has no curve.
std::optional<BoundaryEdge> boundaryEdge(const HoleEdge& edge);

struct BoundedFace {
  TopoDS_Face face;
  double tolerance_mm = 0;  ///< largest distance from the pcurves to the curves in space
};

/// The face that is bounded by copies of the edges, in the order of the hole.
/// \param is_left the hole is to the left of its boundary in the parameter plane. \throws
/// Standard_Failure.
BoundedFace boundedFace(const opencascade::handle<Geom_Surface>& surface,
                        const std::vector<BoundaryEdge>& boundary, bool is_left);

}  // namespace seamwright::occ
