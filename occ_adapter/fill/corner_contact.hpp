// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Core>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include <seamwright/occ_adapter/convert/points.hpp>

/// The contact line of an edge's fillet with a face. Not a public header.
namespace seamwright::occ {

/// The edge between a band and a face, directed outward from the ball.
class Contact {
 public:
  Contact(const TopoDS_Edge& edge, const TopoDS_Face& band, const TopoDS_Face& face,
          const TopoDS_Vertex& near)
      : edge_(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD))), curve_(edge_), face_(face) {
    on_band_ = BRep_Tool::CurveOnSurface(edge_, band, first_, last_);
    on_face_ = BRep_Tool::CurveOnSurface(edge_, face, first_, last_);
    near_first_ = TopExp::FirstVertex(edge_).IsSame(near);
  }

  const TopoDS_Edge& edge() const { return edge_; }
  const TopoDS_Face& face() const { return face_; }
  bool nearFirst() const { return near_first_; }

  /// The curve's parameter at a share, in [0, 1], of the edge's parameter range from the ball.
  double at(double share) const {
    return near_first_ ? first_ + share * (last_ - first_) : last_ - share * (last_ - first_);
  }
  Eigen::Vector3d point(double share) const { return vector(curve_.Value(at(share)).XYZ()); }
  gp_Pnt2d onBand(double share) const { return on_band_->Value(at(share)); }
  gp_Pnt2d onFace(double share) const { return on_face_->Value(at(share)); }
  /// Unit tangent towards the ball.
  Eigen::Vector3d inward(double share) const {
    gp_Pnt point;
    gp_Vec run;
    curve_.D1(at(share), point, run);
    return (near_first_ ? -1 : 1) * vector(run).normalized();
  }

 private:
  TopoDS_Edge edge_;
  BRepAdaptor_Curve curve_;
  TopoDS_Face face_;
  opencascade::handle<Geom2d_Curve> on_band_, on_face_;
  double first_ = 0, last_ = 0;
  bool near_first_ = true;
};

}  // namespace seamwright::occ
