// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>

#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/occ_adapter/fill/side_path.hpp>

/// Extensions up to a face. Not a public header.
namespace seamwright::occ {

/// The face that an extension ends at.
struct ExtensionTarget {
  TopoDS_Face face;
  int number = 0;
};

/// How long the lines across an extension are, from v = 0 to the target.
struct LineLengths {
  double least_mm = 0, most_mm = 0;
};

/// An upper bound of the distance from points of a path to those of the target.
double farthestOf(const SidePath& path, const ExtensionTarget& target);

/// \throws GeometryError for a line that does not meet the target, with its place and length.
LineLengths lengthsTo(const BSplineSurface& sheet, const ExtensionTarget& target);

/// The part of the sheet between v = 0 and the target, divided by OpenCASCADE.
/// \throws GeometryError if the target does not divide the sheet.
TopoDS_Face trimmedBy(const BSplineSurface& sheet, const ExtensionTarget& target);

/// The largest distance from the target to the edges of a trimmed face that the target made: those
/// that run neither along v = 0 nor along u = 0 or 1.
double gapTo(const TopoDS_Face& trimmed, const ExtensionTarget& target);

}  // namespace seamwright::occ
