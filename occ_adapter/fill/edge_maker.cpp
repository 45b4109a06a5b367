// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Line.hxx>

#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/fill/edge_maker.hpp>

namespace seamwright::occ {

using Eigen::Vector3d;
using opencascade::handle;

Vector3d pointAt(const TopoDS_Vertex& vertex) {
  return vector(BRep_Tool::Pnt(vertex));
}

TopoDS_Vertex EdgeMaker::vertex(const Vector3d& p) const {
  TopoDS_Vertex made;
  BRep_Builder().MakeVertex(made, pointOf(p), tolerance_mm_);
  return made;
}

TopoDS_Edge EdgeMaker::edge(const handle<Geom_Curve>& curve, double first, double last,
                            const TopoDS_Vertex& from, const TopoDS_Vertex& to) const {
  TopoDS_Edge made;
  BRep_Builder().MakeEdge(made, curve, tolerance_mm_);
  BRep_Builder().Add(made, from.Oriented(TopAbs_FORWARD));
  BRep_Builder().Add(made, to.Oriented(TopAbs_REVERSED));
  BRep_Builder().Range(made, first, last);
  return made;
}

TopoDS_Edge EdgeMaker::line(const TopoDS_Vertex& from, const TopoDS_Vertex& to) const {
  const Vector3d run = pointAt(to) - pointAt(from);
  return edge(new Geom_Line(pointOf(pointAt(from)), directionOf(run)), 0, run.norm(), from, to);
}

void EdgeMaker::lay(const TopoDS_Edge& edge, const handle<Geom2d_Curve>& path,
                    const TopoDS_Face& face) const {
  BRep_Builder().UpdateEdge(edge, path, face, tolerance_mm_);
}

}  // namespace seamwright::occ
