// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

class TopoDS_Shape;

namespace seamwright::occ {

/// Requires a tolerance that rounding of the coordinates can't exceed, as the vertices tell it.
/// Between vertices faces reach a few times further at most. Vertices that can't be computed with
/// are left out, as are their seams (UnusableParts).
/// \param what "gap tolerance"
/// \throws std::invalid_argument with the least tolerance of this shape.
void requireAboveRounding(const char* what, double mm, const TopoDS_Shape& shape);

}  // namespace seamwright::occ
