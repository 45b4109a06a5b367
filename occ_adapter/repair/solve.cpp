// SPDX-License-Identifier: LGPL-2.1-or-later
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include <seamwright/occ_adapter/repair/solve.hpp>

namespace seamwright::occ {

namespace {

std::vector<TopoDS_Shape> endsOf(const Seam& seam) {
  std::vector<TopoDS_Shape> ends;
  for (const Coedge& side : seam.sides) {
    ends.push_back(TopExp::FirstVertex(side.edge));
    ends.push_back(TopExp::LastVertex(side.edge));
  }
  return ends;
}

}  // namespace

TurnsAtEnds::TurnsAtEnds(const RepairTask& task) {
  for (std::size_t i = 0; i < task.seams.size(); ++i) {
    const auto& angle = task.before[i].figures.angle_rad;
    if (!task.isTreated(i) || task.sharp[i] || !angle) continue;
    for (const TopoDS_Shape& vertex : endsOf(task.seams[i])) {
      double& turn_rad = turns_rad_[vertices_.Add(vertex)];
      turn_rad = std::max(turn_rad, angle->upper.value_or(angle->lower));
    }
  }
}

double TurnsAtEnds::at_rad(const Seam& seam) const {
  double most = 0;
  for (const TopoDS_Shape& vertex : endsOf(seam))
    if (const auto turn = turns_rad_.find(vertices_.FindIndex(vertex)); turn != turns_rad_.end())
      most = std::max(most, turn->second);
  return most;
}

FacesAtVertices::FacesAtVertices(const TopoDS_Shape& shape) {
  TopExp::MapShapes(shape, TopAbs_FACE, faces_);
  TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_VERTEX, TopAbs_FACE, faces_of_vertex_);
}

std::set<int> FacesAtVertices::of(const Seam& seam) const {
  std::set<int> faces = {seam.sides[0].face, seam.sides[1].face};
  for (const TopoDS_Shape& vertex : endsOf(seam))
    if (faces_of_vertex_.Contains(vertex))
      for (const TopoDS_Shape& face : faces_of_vertex_.FindFromKey(vertex))
        faces.insert(faces_.FindIndex(face));
  return faces;
}

bool isFold(const SeamResult& seam, const ContinuityTolerance& tolerance) {
  if (seam.verdict.seam_class == SeamClass::Crease) return true;
  const auto& angle = seam.figures.angle_rad;
  return seam.verdict.seam_class == SeamClass::Defect &&
         !(angle && angle->lower < tolerance.crease_rad);
}

std::vector<Seam> seamsIn(const TopoDS_Shape& shape, std::vector<Seam> seams) {
  TopTools_IndexedMapOfShape faces, edges;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (Seam& seam : seams)
    for (const int which : {0, 1}) {
      Coedge& side = seam.sides[which];
      const int edge = which == 0 ? seam.edges.front() : seam.edges.back();
      side.shape = TopoDS::Face(faces(side.face).Oriented(TopAbs_FORWARD));
      side.edge = TopoDS::Edge(edges(edge).Oriented(side.edge.Orientation()));
    }
  return seams;
}

}  // namespace seamwright::occ
