// SPDX-License-Identifier: LGPL-2.1-or-later
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <seamwright/occ_adapter/repair/solve.hpp>

namespace seamwright::occ {

std::vector<Seam> seamsIn(const TopoDS_Shape& shape, std::vector<Seam> seams) {
  TopTools_IndexedMapOfShape faces, edges;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (Seam& seam : seams)
    for (const int which : {0, 1}) {
      FaceUse& side = seam.sides[which];
      const int edge = which == 0 ? seam.edges.front() : seam.edges.back();
      side.shape = TopoDS::Face(faces(side.face).Oriented(TopAbs_FORWARD));
      side.edge = TopoDS::Edge(edges(edge).Oriented(side.edge.Orientation()));
    }
  return seams;
}

}  // namespace seamwright::occ
