// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <map>

/// Separates faces, edges and vertices that occur several times in one part of an assembly. Not a
/// public header.
namespace seamwright::occ {

/// Copies each face, edge or vertex that occurs several times in one part of an assembly (in what
/// compounds hold), so that each occurrence is a part of its own. Both ends of a prism may be such
/// a face. The result has the same parts in the same order, with the same orientations and
/// locations. Faces, edges and vertices that occur in several such parts stay shared, as instances
/// of one solid do. The shape itself is returned if there is nothing to separate.
TopoDS_Shape withOwnParts(const TopoDS_Shape& shape);

/// A copy in which every occurrence of a face, edge or vertex is a part of its own, with the same
/// order, orientations and locations. Surfaces and curves are shared.
TopoDS_Shape ownCopyOf(const TopoDS_Shape& shape);

/// How many times each part occurs in the shape, the shape itself included.
std::map<const TopoDS_TShape*, int> instancesIn(const TopoDS_Shape& shape);

}  // namespace seamwright::occ
