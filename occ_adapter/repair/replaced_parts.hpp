// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopoDS_Shape.hxx>

/// Replaces parts of a shape. Not a public header.
namespace seamwright::occ {

/// A shape in which parts are replaced, with the same order, orientations and locations. Parts
/// without new parts are shared with the given shape.
/// \param new_parts by old part, both without location and orientation (bare()). A new part is
/// empty; it gets the children of the old one, replaced, and its flags.
TopoDS_Shape withReplacedParts(const TopoDS_Shape& shape,
                               const TopTools_DataMapOfShapeShape& new_parts);

}  // namespace seamwright::occ
