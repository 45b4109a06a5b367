// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <optional>
#include <set>
#include <utility>

/// Tests whether new faces run into others. Not a public header.
namespace seamwright::occ {

/// Finds two faces of a shape, at least one of them new, that touch or intersect, by OpenCASCADE's
/// distance and section; nothing if there are none.
///
/// For faces that share edges or vertices, only points count that are further from these than a
/// hundredth of the new face's extent. Such points are sought where edges of the given face lie on
/// the new face, at nine points of each edge, and, if there is a single new face, where both faces
/// intersect, unless \p with_sections is false.
///
/// Not tested are new faces that share vertices (patches of one fill), faces that can't be computed
/// with (UnusableParts), and faces that have an edge without a curve in space.
/// \param fresh numbers of the new faces, from 1, in the order of TopExp::MapShapes.
std::optional<std::pair<int, int>> touchingFaces(const TopoDS_Shape& shape,
                                                 const std::set<int>& fresh,
                                                 bool with_sections = true);

}  // namespace seamwright::occ
