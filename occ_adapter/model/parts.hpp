// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <string_view>

/// The parts of a shape by number. Not a public header.
namespace seamwright::occ {

/// The parts of a kind, each once, numbered from 1 in the order of TopExp::MapShapes.
inline TopTools_IndexedMapOfShape partsOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(shape, kind, parts);
  return parts;
}

/// \param singular, plural name of the kind: "vertex", "vertices".
/// \throws std::invalid_argument with the valid numbers unless \p number is 1 to \p count.
void requirePart(std::string_view singular, std::string_view plural, int number, int count);

inline void requireFace(int number, int count) {
  requirePart("face", "faces", number, count);
}
inline void requireEdge(int number, int count) {
  requirePart("edge", "edges", number, count);
}

}  // namespace seamwright::occ
