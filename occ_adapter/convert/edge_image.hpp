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

/// The images of an edge on the surfaces beside it. Not a public header.
namespace seamwright::occ {

/// Samples at which the distance of images is measured.
constexpr int points_of_an_edge = 257;
/// Between the samples the distance may be larger; tolerances are the sampled distance times this.
constexpr double between_points = 1.2;

/// A surface with its location in space.
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

/// The surface that the face stores, with the location of the face; it is not copied.
PlacedSurface surfaceOf(const TopoDS_Face& face);

/// Whether the edge stores its pcurve on the face. On a plane it may be implied by the curve in
/// space and its range.
bool hasStoredPath(const TopoDS_Edge& edge, const TopoDS_Face& face);
/// The pcurve of an edge on a face; without a curve if the edge has none there.
PlanarPath pathOf(const TopoDS_Edge& edge, const TopoDS_Face& face);
/// The same, rebuilt where pcurveOf() rebuilds it. \throws GeometryError as pcurveOf().
PlanarPath pathOrBuilt(const TopoDS_Edge& edge, const TopoDS_Face& face, double gap_mm);

/// Largest distance between the images of a path on two surfaces, at points_of_an_edge points.
double largestDistance_mm(const PlacedSurface& a, const PlacedSurface& b, const PlanarPath& path);
/// Largest distance of the images of paths from a curve over [first, last], at the same points.
double largestDistance_mm(const std::vector<EdgeSide>& sides, const Geom_Curve& curve, double first,
                          double last);
/// Largest distance of an edge's curve from its image on the face, at equal parameters and
/// regardless of its tolerance; 0 without a curve.
/// \throws GeometryError as pcurveOf().
double distanceFromImage_mm(const TopoDS_Edge& edge, const TopoDS_Face& face, double gap_mm);

/// The mean of the images of the paths as a curve over [first, last]. It is exact if the paths run
/// at constant speed along parameter lines of polynomial splines, or if there is one path, along
/// one of a rational spline; otherwise it is approximated.
/// \param near_mm accuracy of an approximation. \throws GeometryError if there is none.
opencascade::handle<Geom_Curve> meanImage(const std::vector<EdgeSide>& sides, double first,
                                          double last, double near_mm);

}  // namespace seamwright::occ
