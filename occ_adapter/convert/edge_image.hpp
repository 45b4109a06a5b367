// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <vector>

/// An edge as the surfaces beside it show it; not a public header.
namespace seamwright::occ {

constexpr int points_of_an_edge = 257;
/// What lies between the points may be off by more than what they show.
constexpr double between_points = 1.2;

/// A surface where it lies in space.
struct PlacedSurface {
  opencascade::handle<Geom_Surface> surface;
  TopLoc_Location location;
  gp_Pnt at(const gp_Pnt2d& uv) const {
    return surface->Value(uv.X(), uv.Y()).Transformed(location.Transformation());
  }
};

/// A path in a parameter plane.
struct PlanarPath {
  opencascade::handle<Geom2d_Curve> curve;
  double first = 0, last = 0;
  gp_Pnt2d at(int k) const {
    return curve->Value(first + (last - first) * k / (points_of_an_edge - 1));
  }
};

struct EdgeSide {
  PlacedSurface placed;
  PlanarPath path;
  gp_Pnt at(int k) const { return placed.at(path.at(k)); }
};

PlacedSurface surfaceOf(const TopoDS_Face& face);

/// Without a curve if the edge has no path on the face.
PlanarPath pathOf(const TopoDS_Edge& edge, const TopoDS_Face& face);
/// \throws std::runtime_error as pcurveOf().
PlanarPath pathOrBuilt(const TopoDS_Edge& edge, const TopoDS_Face& face, double gap_mm);

/// Of the images of a path on two surfaces, at points_of_an_edge points.
double largestDistance_mm(const PlacedSurface& a, const PlacedSurface& b, const PlanarPath& path);
/// Of the images of paths from a curve over [first, last], at points_of_an_edge points.
double largestDistance_mm(const std::vector<EdgeSide>& sides, const Geom_Curve& curve, double first,
                          double last);
/// Of an edge's curve from its image on the face, at equal parameters, whatever its tolerance says;
/// 0 without a curve.
/// \throws std::runtime_error as pcurveOf().
double distanceFromImage_mm(const TopoDS_Edge& edge, const TopoDS_Face& face, double gap_mm);

/// The mean of the images of the paths as a curve over [first, last]: exact where the paths are
/// parameter lines of polynomial splines, or one of a rational one, run along at constant speed;
/// else approximated.
/// \param near_mm how near an approximation keeps. \throws std::runtime_error where there is none.
opencascade::handle<Geom_Curve> meanImage(const std::vector<EdgeSide>& sides, double first,
                                          double last, double near_mm);

}  // namespace seamwright::occ
