// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepAdaptor_Surface.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <optional>

#include <seamwright/core/differential/jet.hpp>
#include <seamwright/occ_adapter/convert/pcurve.hpp>
#include <seamwright/occ_adapter/repair/change.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

/// Edges that run elsewhere on a face that stays, as the face on their other side moves; not a
/// public header.
namespace seamwright::occ {

/// The surface of a face, and the point of it beside another point.
class StayingSurface {
 public:
  explicit StayingSurface(const TopoDS_Face& face) : surface_(face, false) {}

  /// The foot of \p point on the surface, by ten steps of Gauss and Newton from \p start at most:
  /// they converge where the point is nearer than the radii of curvature.
  gp_Pnt2d nearest(const gp_Pnt& point, const gp_Pnt2d& start) const;
  /// Within the ends of the parameters, where these are not periodic: feet may lie a little beyond
  /// the side of a surface.
  gp_Pnt2d within(const gp_Pnt2d& uv) const;
  gp_Pnt at(const gp_Pnt2d& uv) const { return surface_.Value(uv.X(), uv.Y()); }
  /// Up to second order. \throws Standard_Failure.
  SurfaceJet jet(const gp_Pnt2d& uv) const;

  /// There is surface on both sides of the path: it keeps away from the ends of the parameters.
  bool surrounds(const Pcurve& path) const;

 private:
  BRepAdaptor_Surface surface_;
};

/// The path on a face that stays of an edge whose other face has another surface now: the foot of
/// the new boundary on the surface that stays. The ends keep their places, as other edges end
/// there; what the boundary moved by at an end fades over a quarter of the edge.
/// \param moved in the frame of the shape. \returns nothing where the old path is within a fiftieth
/// of the gap tolerance, or no new one can be interpolated to as much. \throws std::runtime_error
/// as pcurveOf(); Standard_Failure.
std::optional<PathChange> slidPath(int edge, const Coedge& stays, const Coedge& moves,
                                   const opencascade::handle<Geom_Surface>& moved, double gap_mm);

}  // namespace seamwright::occ
