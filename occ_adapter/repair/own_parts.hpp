// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>

/// Faces, edges and vertices that stand in one part of an assembly several times; not a public header.
namespace seamwright::occ {

/// The shape with a face, an edge or a vertex of its own wherever one stands in several places of one part of an assembly (what compounds hold),
/// as both ends of a prism do: the same parts in the same order, orientations and locations. What stands in several such parts stays, as
/// instances of one solid do. The shape itself where there is nothing to part.
TopoDS_Shape withOwnParts(const TopoDS_Shape& shape);

}  // namespace seamwright::occ
