// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>

/// A shape whose parts have numbers. Not a public header.
namespace seamwright::occ {

/// The faces, edges and vertices of a shape, numbered from 1 in the order of TopExp::MapShapes.
struct ShapeParts {
  explicit ShapeParts(const TopoDS_Shape& of)
      : shape(of),
        faces(partsOf(of, TopAbs_FACE)),
        edges(partsOf(of, TopAbs_EDGE)),
        vertices(partsOf(of, TopAbs_VERTEX)),
        unusable(of) {
    TopExp::MapShapesAndUniqueAncestors(of, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
  }

  TopoDS_Face face(int number) const { return TopoDS::Face(faces(number)); }
  /// In the direction of its curve.
  TopoDS_Edge edge(int number) const {
    return TopoDS::Edge(edges(number).Oriented(TopAbs_FORWARD));
  }
  TopoDS_Vertex vertex(int number) const { return TopoDS::Vertex(vertices(number)); }

  TopoDS_Shape shape;
  TopTools_IndexedMapOfShape faces, edges, vertices;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
  UnusableParts unusable;
};

}  // namespace seamwright::occ
