// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <vector>

/// Tests whether new faces run through each other or themselves. Not a public header.
namespace seamwright::occ {

/// Whether faces, each with a spline over its whole rectangle, intersect themselves or each other,
/// by the triangles of a grid of 64 x 64 cells on each face.
///
/// Triangles that share vertices only intersect where they fold back onto each other. Not found are
/// intersections that reach less deep than the triangles are away from the faces, and those within
/// 8 x 8 cells.
bool meetThemselves(const std::vector<TopoDS_Face>& faces);

}  // namespace seamwright::occ
