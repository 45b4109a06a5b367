// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <string>

namespace seamwright::occ {

/// The path of an edge in the parameter plane of a face.
struct Pcurve {
  opencascade::handle<Geom2d_Curve> curve;
  double first = 0;
  double last = 0;
  std::string note;  ///< not empty: what was wrong with the stored one
};

/// The pcurve of an edge on a face, rebuilt if necessary.
///
/// A stored pcurve is used if, at 9 points, it is within one and a half times the tolerance of the
/// edge of the edge's curve in space, or within a hundredth of \p gap_mm, which affects no verdict.
/// (OpenCASCADE's condition for a valid edge is the tolerance itself. But where a file holds no
/// tolerances, OpenCASCADE measures them at some points only.) If a pcurve is missing or strays
/// further, the curve in space is projected onto the surface. The projection replaces the stored
/// pcurve only if it at least halves the distance: otherwise the surface itself is away from the
/// edge, which is a gap of the model and not a fault of the pcurve. Edge and face are not changed.
///
/// \throws GeometryError if the face has no surface, or if there is no pcurve and none can be
/// built.
Pcurve pcurveOf(const TopoDS_Edge& edge, const TopoDS_Face& face, double gap_mm);

}  // namespace seamwright::occ
