// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

/// The parts of a shape by number. Not a public header.
namespace seamwright::occ {

/// The parts of a kind, each once, numbered from 1 in the order of TopExp::MapShapes.
inline TopTools_IndexedMapOfShape partsOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(shape, kind, parts);
  return parts;
}

}  // namespace seamwright::occ
