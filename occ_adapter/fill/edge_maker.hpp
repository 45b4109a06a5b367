// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include <Eigen/Core>

/// Not a public header.
namespace seamwright::occ {

/// Makes vertices and edges with one tolerance.
class EdgeMaker {
 public:
  explicit EdgeMaker(double tolerance_mm) : tolerance_mm_(tolerance_mm) {}

  double tolerance_mm() const { return tolerance_mm_; }
  TopoDS_Vertex vertex(const Eigen::Vector3d& point) const;
  TopoDS_Edge edge(const opencascade::handle<Geom_Curve>& curve, double first, double last,
                   const TopoDS_Vertex& from, const TopoDS_Vertex& to) const;
  TopoDS_Edge line(const TopoDS_Vertex& from, const TopoDS_Vertex& to) const;
  /// Gives the edge a pcurve on the face.
  void lay(const TopoDS_Edge& edge, const opencascade::handle<Geom2d_Curve>& path,
           const TopoDS_Face& face) const;

 private:
  double tolerance_mm_;
};

/// The point of a vertex.
Eigen::Vector3d pointAt(const TopoDS_Vertex& vertex);

}  // namespace seamwright::occ
