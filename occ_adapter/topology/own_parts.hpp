// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <map>

/// Faces, edges and vertices that stand in one part of an assembly several times; not a public
/// header.
namespace seamwright::occ {

/// The shape with a face, an edge or a vertex of its own wherever one stands in several places of
/// one part of an assembly (what compounds hold), as both ends of a prism do: the same parts in the
/// same order, orientations and locations. What stands in several such parts stays, as instances of
/// one solid do. The shape itself where there is nothing to part.
TopoDS_Shape withOwnParts(const TopoDS_Shape& shape);

/// A copy in which every face, edge and vertex is its own in every place: same order, orientations
/// and locations. Surfaces and curves are shared.
TopoDS_Shape ownCopyOf(const TopoDS_Shape& shape);

/// In how many places each thing in the shape stands, itself included.
std::map<const TopoDS_TShape*, int> instancesIn(const TopoDS_Shape& shape);

}  // namespace seamwright::occ
