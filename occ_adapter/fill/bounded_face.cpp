// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>

#include <seamwright/occ_adapter/fill/bounded_face.hpp>

namespace seamwright::occ {

namespace {

/// A copy of the vertex at which the hole reaches the edge.
TopoDS_Vertex vertexBefore(const HoleEdge& edge) {
  const TopoDS_Edge given_edge = TopoDS::Edge(edge.use.edge.Oriented(TopAbs_FORWARD));
  const TopoDS_Vertex given =
      edge.reversed ? TopExp::LastVertex(given_edge) : TopExp::FirstVertex(given_edge);
  TopoDS_Vertex vertex;
  const BRep_Builder builder;
  builder.MakeVertex(vertex, BRep_Tool::Pnt(given), BRep_Tool::Tolerance(given));
  return vertex;
}

TopoDS_Edge edgeOn(const TopoDS_Face& face, const BoundaryEdge& path, TopoDS_Vertex begin,
                   TopoDS_Vertex end) {
  if (path.edge.reversed) std::swap(begin, end);
  const BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge, path.curve, path.location, Precision::Confusion());
  builder.UpdateEdge(edge, path.on_surface, face, Precision::Confusion());
  builder.Range(edge, path.first, path.last);
  builder.Add(edge, begin.Oriented(TopAbs_FORWARD));
  builder.Add(edge, end.Oriented(TopAbs_REVERSED));
  BRepLib::SameParameter(edge, Precision::Confusion());
  return edge;
}

}  // namespace

std::optional<BoundaryEdge> boundaryEdge(const HoleEdge& edge) {
  BoundaryEdge result;
  result.edge = edge;
  result.curve = BRep_Tool::Curve(edge.use.edge, result.location, result.first, result.last);
  if (result.curve.IsNull()) return std::nullopt;
  return result;
}

BoundedFace boundedFace(const opencascade::handle<Geom_Surface>& surface,
                        const std::vector<BoundaryEdge>& boundary, bool is_left) {
  const BRep_Builder builder;
  BoundedFace result;
  builder.MakeFace(result.face, surface, Precision::Confusion());
  std::vector<TopoDS_Vertex> vertices;
  for (const BoundaryEdge& path : boundary) vertices.push_back(vertexBefore(path.edge));
  std::vector<TopoDS_Edge> edges;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    edges.push_back(
        edgeOn(result.face, boundary[k], vertices[k], vertices[(k + 1) % vertices.size()]));
    result.tolerance_mm = std::max(result.tolerance_mm, BRep_Tool::Tolerance(edges.back()));
  }
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const std::size_t i = is_left ? k : edges.size() - 1 - k;
    builder.Add(wire, edges[i].Oriented(boundary[i].edge.reversed == is_left ? TopAbs_REVERSED
                                                                             : TopAbs_FORWARD));
  }
  wire.Closed(true);
  builder.Add(result.face, wire);
  BRepTools::Update(result.face);
  return result;
}

}  // namespace seamwright::occ
