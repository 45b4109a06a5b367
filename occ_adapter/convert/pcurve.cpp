// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRep_CurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Extrema_GenLocateExtPS.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <ProjLib.hxx>
#include <ShapeConstruct_ProjectCurveOnSurface.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include <seamwright/occ_adapter/convert/pcurve.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>

namespace seamwright::occ {

namespace {

struct SpaceCurve {
  opencascade::handle<Geom_Curve> curve;
  double first = 0;
  double last = 0;
};

/// Where a pcurve is furthest from its edge.
struct Stray {
  double distance = 0;  ///< infinite if the pcurve leads to points that are not finite
  gp_Pnt2d uv;
  gp_Pnt on_edge;
};

/// Of 9 points the one where the image of the pcurve is furthest from the edge's curve.
Stray worstStray(const Pcurve& pcurve, const SpaceCurve& space,
                 const BRepAdaptor_Surface& surface) {
  Stray worst;
  for (int i = 0; i <= 8; ++i) {
    const double share = i / 8.0;
    const gp_Pnt2d uv = pcurve.curve->Value(pcurve.first + share * (pcurve.last - pcurve.first));
    const gp_Pnt on_edge = space.curve->Value(space.first + share * (space.last - space.first));
    const double distance = surface.Value(uv.X(), uv.Y()).Distance(on_edge);
    if (!std::isfinite(distance)) return {std::numeric_limits<double>::infinity(), uv, on_edge};
    if (distance >= worst.distance) worst = {distance, uv, on_edge};
  }
  return worst;
}

/// Whether the surface near the point of the pcurve comes closer to the edge than half the
/// distance. True also where no nearest point is found.
bool surfaceComesCloser(const Stray& stray, const BRepAdaptor_Surface& surface) {
  Extrema_GenLocateExtPS nearest(surface, Precision::PConfusion(), Precision::PConfusion());
  nearest.Perform(stray.on_edge, stray.uv.X(), stray.uv.Y(), false);
  return !nearest.IsDone() || std::sqrt(nearest.SquareDistance()) <= stray.distance / 2;
}

template <class Spline>
bool hasFinitePoles(const Spline& spline) {
  for (int i = 1; i <= spline->NbUPoles(); ++i)
    for (int j = 1; j <= spline->NbVPoles(); ++j) {
      const gp_XYZ pole = spline->Pole(i, j).XYZ();
      if (!std::isfinite(pole.X() + pole.Y() + pole.Z()) || !std::isfinite(spline->Weight(i, j)))
        return false;
    }
  return true;
}

/// False for a surface on which a search for the nearest point may run for minutes and find
/// nothing.
bool canBeSearched(const opencascade::handle<Geom_Surface>& surface) {
  if (const auto spline = opencascade::handle<Geom_BSplineSurface>::DownCast(surface);
      !spline.IsNull())
    return hasFinitePoles(spline);
  if (const auto bezier = opencascade::handle<Geom_BezierSurface>::DownCast(surface);
      !bezier.IsNull())
    return hasFinitePoles(bezier);
  return true;
}

/// The curve of the edge projected onto the surface; without a curve where that does not work.
Pcurve projected(const SpaceCurve& space, const TopoDS_Face& face) {
  const opencascade::handle<Geom_Surface> surface = BRep_Tool::Surface(face);
  Pcurve pcurve{nullptr, space.first, space.last, {}};
  if (!canBeSearched(surface)) return pcurve;
  ShapeConstruct_ProjectCurveOnSurface projector;
  projector.Init(surface, Precision::Confusion());
  opencascade::handle<Geom_Curve> curve = space.curve;
  projector.Perform(curve, space.first, space.last, pcurve.curve);
  return pcurve;
}

/// The stored pcurve if it is good or nothing better is to be had, else a new one.
Pcurve keptOrRebuilt(const Pcurve& stored, const SpaceCurve& space, const TopoDS_Edge& edge,
                     const TopoDS_Face& face, double gap_mm) {
  const BRepAdaptor_Surface surface(face, false);
  // Who reads STEP, which holds no tolerances, has measured them at other points.
  constexpr double estimate = 1.5;
  const double allowed = std::max(estimate * BRep_Tool::Tolerance(edge), gap_mm / 100);
  const Stray stray = worstStray(stored, space, surface);
  if (stray.distance <= allowed) return stored;
  // Which of the two pcurves of a closed face a projection would give is not known.
  if (BRep_Tool::IsClosed(edge, face)) return stored;
  // A little off is mostly a surface that lies a little off: one point shows that at less cost
  // than a projected curve.
  if (stray.distance <= 10 * allowed && !surfaceComesCloser(stray, surface)) return stored;
  Pcurve rebuilt = projected(space, face);
  if (rebuilt.curve.IsNull()) return stored;
  const double after = worstStray(rebuilt, space, surface).distance;
  if (!std::isfinite(after) || after > stray.distance / 2) return stored;
  rebuilt.note = fmt::format("its pcurve was {:.3g} mm off the edge and was rebuilt ({:.3g} mm)",
                             stray.distance, after);
  return rebuilt;
}

bool storesPcurve(const TopoDS_Edge& edge, const opencascade::handle<Geom_Surface>& surface,
                  const TopLoc_Location& location) {
  const auto shape = opencascade::handle<BRep_TEdge>::DownCast(edge.TShape());
  const TopLoc_Location on_edge = location.Predivided(edge.Location());
  return std::ranges::any_of(
      shape->Curves(), [&](const auto& each) { return each->IsCurveOnSurface(surface, on_edge); });
}

/// The projection of a line or a circle that is parallel to a plane; without a curve for others.
/// OpenCASCADE projects any curve, which takes some 20 times as long.
Pcurve onParallelPlane(const SpaceCurve& space, const gp_Pln& plane) {
  // A tilt scales lengths by 1 - tilt^2 / 2, which is 1 for this one.
  constexpr double negligible_tilt_rad = 1e-9;
  const gp_Dir& normal = plane.Axis().Direction();
  Pcurve pcurve{nullptr, space.first, space.last, {}};
  if (const auto line = opencascade::handle<Geom_Line>::DownCast(space.curve); !line.IsNull()) {
    if (line->Lin().Direction().IsNormal(normal, negligible_tilt_rad))
      pcurve.curve = new Geom2d_Line(ProjLib::Project(plane, line->Lin()));
  } else if (const auto circle = opencascade::handle<Geom_Circle>::DownCast(space.curve);
             !circle.IsNull()) {
    if (circle->Circ().Axis().Direction().IsParallel(normal, negligible_tilt_rad))
      pcurve.curve = new Geom2d_Circle(ProjLib::Project(plane, circle->Circ()));
  }
  return pcurve;
}

/// What onParallelPlane() finds where the face is on a plane and the edge stores no pcurve.
Pcurve onPlane(const SpaceCurve& space, const TopoDS_Edge& edge, const TopoDS_Face& face) {
  TopLoc_Location location;
  const auto& surface = BRep_Tool::Surface(face, location);
  const auto plane = opencascade::handle<Geom_Plane>::DownCast(surface);
  if (plane.IsNull() || space.curve.IsNull() || storesPcurve(edge, surface, location)) return {};
  return onParallelPlane(space, plane->Pln().Transformed(location.Transformation()));
}

Pcurve built(const SpaceCurve& space, const TopoDS_Face& face) {
  Pcurve pcurve = projected(space, face);
  if (pcurve.curve.IsNull()) throw GeometryError("the edge has no pcurve and none could be built");
  const double stray = worstStray(pcurve, space, BRepAdaptor_Surface(face, false)).distance;
  pcurve.note = fmt::format("its pcurve was missing and was built ({:.3g} mm)", stray);
  return pcurve;
}

}  // namespace

Pcurve pcurveOf(const TopoDS_Edge& edge, const TopoDS_Face& face, double gap_mm) {
  TopLoc_Location location;  // asked for so that a surface that is placed elsewhere is not copied
  if (BRep_Tool::Surface(face, location).IsNull())
    throw GeometryError("a face has no surface, only a mesh or nothing");
  SpaceCurve space;
  space.curve = BRep_Tool::Curve(edge, space.first, space.last);
  if (const Pcurve pcurve = onPlane(space, edge, face); !pcurve.curve.IsNull()) return pcurve;
  Pcurve stored;
  stored.curve = BRep_Tool::CurveOnSurface(edge, face, stored.first, stored.last);
  if (stored.curve.IsNull() && space.curve.IsNull())
    throw GeometryError("the edge has neither a curve in space nor a pcurve");
  if (space.curve.IsNull()) return stored;
  return stored.curve.IsNull() ? built(space, face)
                               : keptOrRebuilt(stored, space, edge, face, gap_mm);
}

}  // namespace seamwright::occ
