// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Hyperbola.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_Parabola.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopLoc_Location.hxx>
#include <cmath>
#include <stdexcept>

#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/convert/seam_side.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

using occ::vector;

Eigen::Vector3d vector(const gp_XY& xy) {
  return {xy.X(), xy.Y(), 0};
}

template <class Vector>
requires requires(const Vector& v) {
  v.XY();
}
Eigen::Vector3d vector(const Vector& v) {
  return vector(v.XY());
}

Frame frameOf(const gp_Ax3& position) {
  Frame frame;
  frame.origin = vector(position.Location());
  frame.axes << vector(position.XDirection()), vector(position.YDirection()),
      vector(position.Direction());
  return frame;
}

[[noreturn]] void refuse(const char* what, const handle<Standard_Transient>& object) {
  throw std::domain_error(std::string(what) + " of type " + object->DynamicType()->Name() +
                          " is not enclosed");
}

SplineDirection direction(int degree, const TColStd_Array1OfReal& knots, double period) {
  return {degree, {knots.begin(), knots.end()}, period};
}

/// Of a curve: core's evaluator is one of surfaces, and a curve is a surface with one row of poles.
SplineDirection constantDirection() {
  return {0, {0, 1}, 0};
}

template <class Curve>
CurveEvaluator splineCurve(const Curve& curve, SplineDirection direction) {
  std::vector<Eigen::Vector3d> poles;
  std::vector<double> weights;
  for (int i = 1; i <= curve.NbPoles(); ++i) {
    if constexpr (requires { curve.Pole(i).XYZ(); })
      poles.push_back(vector(curve.Pole(i)));
    else
      poles.push_back(vector(curve.Pole(i).XY()));
    if (curve.IsRational()) weights.push_back(curve.Weight(i));
  }
  return CurveEvaluator(std::make_shared<SplineEvaluator>(std::move(direction), constantDirection(),
                                                          std::move(poles), std::move(weights)));
}

std::vector<double> bezierKnots(int degree) {
  std::vector<double> knots(degree + 1, 0.0);
  knots.insert(knots.end(), degree + 1, 1.0);
  return knots;
}

/// The period is kept as a number, since core's evaluator needs clamped knots.
template <class BSpline>
CurveEvaluator bsplineCurve(handle<BSpline> curve) {
  double period = 0;
  if (curve->IsPeriodic()) {
    period = curve->Period();
    curve = handle<BSpline>::DownCast(curve->Copy());
    curve->SetNotPeriodic();
  }
  return splineCurve(*curve, direction(curve->Degree(), curve->KnotSequence(), period));
}

struct InParameterPlane {
  static constexpr const char* name = "a pcurve";
  using Curve = Geom2d_Curve;
  using Trimmed = Geom2d_TrimmedCurve;
  using Line = Geom2d_Line;
  using BSpline = Geom2d_BSplineCurve;
  using Bezier = Geom2d_BezierCurve;
  using Circle = Geom2d_Circle;
  using Ellipse = Geom2d_Ellipse;
  using Hyperbola = Geom2d_Hyperbola;
  using Parabola = Geom2d_Parabola;
};

struct InSpace {
  static constexpr const char* name = "a curve";
  using Curve = Geom_Curve;
  using Trimmed = Geom_TrimmedCurve;
  using Line = Geom_Line;
  using BSpline = Geom_BSplineCurve;
  using Bezier = Geom_BezierCurve;
  using Circle = Geom_Circle;
  using Ellipse = Geom_Ellipse;
  using Hyperbola = Geom_Hyperbola;
  using Parabola = Geom_Parabola;
};

/// Center and scaled axes of an ellipse or a hyperbola.
template <class Evaluator, class Conic>
Evaluator withRadii(const Conic& conic, double major, double minor) {
  const auto position = conic.Position();
  return {vector(position.Location()), major * vector(position.XDirection()),
          minor * vector(position.YDirection())};
}

/// A trimmed curve has the parameters of its basis, and the seam has its own range: trimming says
/// nothing more.
template <class Where>
CurveEvaluator curveEvaluator(const handle<typename Where::Curve>& curve) {
  if (const auto trimmed = handle<typename Where::Trimmed>::DownCast(curve); !trimmed.IsNull())
    return curveEvaluator<Where>(trimmed->BasisCurve());
  if (const auto line = handle<typename Where::Line>::DownCast(curve); !line.IsNull())
    return LineEvaluator{vector(line->Position().Location()), vector(line->Position().Direction())};
  if (const auto spline = handle<typename Where::BSpline>::DownCast(curve); !spline.IsNull())
    return bsplineCurve(spline);
  if (const auto bezier = handle<typename Where::Bezier>::DownCast(curve); !bezier.IsNull())
    return splineCurve(*bezier, {bezier->Degree(), bezierKnots(bezier->Degree()), 0});
  if (const auto circle = handle<typename Where::Circle>::DownCast(curve); !circle.IsNull())
    return withRadii<EllipseEvaluator>(*circle, circle->Radius(), circle->Radius());
  if (const auto ellipse = handle<typename Where::Ellipse>::DownCast(curve); !ellipse.IsNull())
    return withRadii<EllipseEvaluator>(*ellipse, ellipse->MajorRadius(), ellipse->MinorRadius());
  if (const auto hyperbola = handle<typename Where::Hyperbola>::DownCast(curve);
      !hyperbola.IsNull())
    return withRadii<HyperbolaEvaluator>(*hyperbola, hyperbola->MajorRadius(),
                                         hyperbola->MinorRadius());
  if (const auto parabola = handle<typename Where::Parabola>::DownCast(curve); !parabola.IsNull())
    return ParabolaEvaluator{vector(parabola->Location()),
                             vector(parabola->Position().XDirection()) / (4 * parabola->Focal()),
                             vector(parabola->Position().YDirection())};
  refuse(Where::name, curve);
}

template <class Surface>
std::unique_ptr<SurfaceEvaluator> splineSurface(const Surface& surface, SplineDirection u,
                                                SplineDirection v) {
  std::vector<Eigen::Vector3d> poles;
  std::vector<double> weights;
  const bool rational = surface.IsURational() || surface.IsVRational();
  poles.reserve(static_cast<std::size_t>(surface.NbUPoles()) * surface.NbVPoles());
  for (int i = 1; i <= surface.NbUPoles(); ++i)
    for (int j = 1; j <= surface.NbVPoles(); ++j) {
      poles.push_back(vector(surface.Pole(i, j)));
      if (rational) weights.push_back(surface.Weight(i, j));
    }
  return splineEvaluator(std::make_shared<SplineEvaluator>(std::move(u), std::move(v),
                                                           std::move(poles), std::move(weights)));
}

std::unique_ptr<SurfaceEvaluator> bsplineSurface(handle<Geom_BSplineSurface> surface) {
  const double period_u = surface->IsUPeriodic() ? surface->UPeriod() : 0;
  const double period_v = surface->IsVPeriodic() ? surface->VPeriod() : 0;
  if (period_u != 0 || period_v != 0) {
    surface = handle<Geom_BSplineSurface>::DownCast(surface->Copy());
    if (period_u != 0) surface->SetUNotPeriodic();
    if (period_v != 0) surface->SetVNotPeriodic();
  }
  return splineSurface(*surface, direction(surface->UDegree(), surface->UKnotSequence(), period_u),
                       direction(surface->VDegree(), surface->VKnotSequence(), period_v));
}

std::unique_ptr<SurfaceEvaluator> revolution(const Geom_SurfaceOfRevolution& surface) {
  return revolutionEvaluator(frameOf(gp_Ax3(surface.Location(), surface.Direction())),
                             curveEvaluator<InSpace>(surface.BasisCurve()));
}

std::unique_ptr<SurfaceEvaluator> surfaceEvaluator(const handle<Geom_Surface>& surface) {
  if (const auto trimmed = handle<Geom_RectangularTrimmedSurface>::DownCast(surface);
      !trimmed.IsNull())
    return surfaceEvaluator(trimmed->BasisSurface());
  if (const auto plane = handle<Geom_Plane>::DownCast(surface); !plane.IsNull())
    return planeEvaluator(frameOf(plane->Position()));
  if (const auto cylinder = handle<Geom_CylindricalSurface>::DownCast(surface); !cylinder.IsNull())
    return cylinderEvaluator(frameOf(cylinder->Position()), cylinder->Radius());
  if (const auto spline = handle<Geom_BSplineSurface>::DownCast(surface); !spline.IsNull())
    return bsplineSurface(spline);
  if (const auto cone = handle<Geom_ConicalSurface>::DownCast(surface); !cone.IsNull())
    return coneEvaluator(frameOf(cone->Position()), cone->RefRadius(), cone->SemiAngle());
  if (const auto torus = handle<Geom_ToroidalSurface>::DownCast(surface); !torus.IsNull())
    return torusEvaluator(frameOf(torus->Position()), torus->MajorRadius(), torus->MinorRadius());
  if (const auto sphere = handle<Geom_SphericalSurface>::DownCast(surface); !sphere.IsNull())
    return sphereEvaluator(frameOf(sphere->Position()), sphere->Radius());
  if (const auto bezier = handle<Geom_BezierSurface>::DownCast(surface); !bezier.IsNull())
    return splineSurface(*bezier, {bezier->UDegree(), bezierKnots(bezier->UDegree()), 0},
                         {bezier->VDegree(), bezierKnots(bezier->VDegree()), 0});
  if (const auto extrusion = handle<Geom_SurfaceOfLinearExtrusion>::DownCast(surface);
      !extrusion.IsNull())
    return extrusionEvaluator(curveEvaluator<InSpace>(extrusion->BasisCurve()),
                              vector(extrusion->Direction()));
  if (const auto turned = handle<Geom_SurfaceOfRevolution>::DownCast(surface); !turned.IsNull())
    return revolution(*turned);
  if (const auto offset = handle<Geom_OffsetSurface>::DownCast(surface); !offset.IsNull())
    return offsetEvaluator(surfaceEvaluator(offset->BasisSurface()), offset->Offset());
  refuse("a surface", surface);
}

Placement placementOf(const gp_Trsf& trsf) {
  Placement placement;
  placement.scale = trsf.ScaleFactor();
  const gp_Mat matrix = trsf.HVectorialPart();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) placement.orthogonal(i, j) = matrix(i + 1, j + 1);
  placement.translation = vector(trsf.TranslationPart());
  return placement;
}

}  // namespace

SeamSide seamSide(const Coedge& use, const Pcurve& pcurve) {
  TopLoc_Location location;
  const handle<Geom_Surface> surface = BRep_Tool::Surface(use.shape, location);
  std::unique_ptr<SurfaceEvaluator> evaluator = surfaceEvaluator(surface);
  if (!location.IsIdentity())
    evaluator = placedEvaluator(std::move(evaluator), placementOf(location.Transformation()));
  return {curveEvaluator<InParameterPlane>(pcurve.curve),
          std::move(evaluator),
          {0, 1},
          {pcurve.first, pcurve.last},
          use.edge.Orientation() == TopAbs_FORWARD};
}

}  // namespace seamwright::occ
