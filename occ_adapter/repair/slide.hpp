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

/// Lets edges slide on a face that stays while the face on their other side moves. Not a public
/// header.
namespace seamwright::occ {

/// The surface of a face that stays, with the foot of a point on it.
class StayingSurface {
 public:
  explicit StayingSurface(const TopoDS_Face& face) : surface_(face, false) {}

  /// The foot of \p point on the surface, by at most ten Gauss-Newton steps from \p start. They
  /// converge where the point is nearer than the radii of curvature.
  gp_Pnt2d nearest(const gp_Pnt& point, const gp_Pnt2d& start) const;
  /// Clamps \p uv to the parameter range in directions that are not periodic, because feet may lie
  /// a little beyond the side of a surface.
  gp_Pnt2d within(const gp_Pnt2d& uv) const;
  gp_Pnt at(const gp_Pnt2d& uv) const { return surface_.Value(uv.X(), uv.Y()); }
  /// Jet up to second order. \throws Standard_Failure.
  SurfaceJet jet(const gp_Pnt2d& uv) const;

  /// Whether there is surface on both sides of the pcurve: it keeps a distance from the ends of the
  /// parameter ranges.
  bool surrounds(const Pcurve& path) const;

 private:
  BRepAdaptor_Surface surface_;
};

/// The new pcurve, on a face that stays, of an edge whose other face has a new surface. It is the
/// foot of the new boundary on the surface that stays. Its ends keep their positions because other
/// edges end there. The move of the boundary at an end fades over a quarter of the edge.
/// \param moved new surface, in the frame of the shape.
/// \returns nothing if the old pcurve is within a fiftieth of the gap tolerance, or if no new
/// pcurve can be interpolated to this accuracy.
/// \throws GeometryError as pcurveOf(); Standard_Failure.
std::optional<PathChange> slidPath(int edge, const Coedge& stays, const Coedge& moves,
                                   const opencascade::handle<Geom_Surface>& moved, double gap_mm);

}  // namespace seamwright::occ
