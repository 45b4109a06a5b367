// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <optional>
#include <set>
#include <utility>

/// Whether new faces run into others; not a public header.
namespace seamwright::occ {

/// Two faces of a shape, at least one of them new, that touch or cross, by OpenCASCADE's distance
/// and section; nothing: all keep clear. Of faces that share edges or vertices only places count
/// that are further from these than a hundredth of the new one's extent: edges of a given face on
/// the new one, at nine places each; and, of a single new face, where both cross. New faces that
/// share vertices are patches of one fill and are not looked at, nor are faces that can't be
/// computed with (UnusableParts) or have an edge without a curve in space. \param fresh numbers of
/// the new faces, from 1, order of TopExp::MapShapes.
std::optional<std::pair<int, int>> touchingFaces(const TopoDS_Shape& shape,
                                                 const std::set<int>& fresh);

}  // namespace seamwright::occ
