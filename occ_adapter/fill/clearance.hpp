// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <optional>
#include <set>
#include <utility>

/// Whether new faces run into others; not a public header.
namespace seamwright::occ {

/// Two faces of a shape, at least one of them new, that share no vertex and yet touch, by OpenCASCADE's distance; nothing: all keep clear.
/// Faces that share a vertex are not looked at. \param fresh numbers of the new faces, from 1, order of TopExp::MapShapes.
std::optional<std::pair<int, int>> touchingFaces(const TopoDS_Shape& shape, const std::set<int>& fresh);

}  // namespace seamwright::occ
