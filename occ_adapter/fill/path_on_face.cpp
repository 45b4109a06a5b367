// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <cmath>

#include <seamwright/core/linear/dense.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/fill/corner_reasons.hpp>
#include <seamwright/occ_adapter/fill/path_on_face.hpp>

namespace seamwright::occ {

using Eigen::Vector3d;
using opencascade::handle;

namespace {

/// The parameter, moved by whole periods to be nearest to another. \param period 0: not periodic.
double beside(double parameter, double other, double period) {
  return period > 0 ? parameter + period * std::round((other - parameter) / period) : parameter;
}

/// The direction in the parameter plane that belongs to a tangent vector.
gp_Vec2d tangentIn(const BRepAdaptor_Surface& surface, const gp_Pnt2d& at, const Vector3d& run) {
  gp_Pnt point;
  gp_Vec u, v;
  surface.D1(at.X(), at.Y(), point, u, v);
  Eigen::MatrixXd partials(3, 2);
  partials << vector(u), vector(v);
  const Eigen::Vector2d direction = linear::PivotedQr(partials).solve(run);
  return {direction(0), direction(1)};
}

}  // namespace

handle<Geom2d_Curve> pathOnFace(const TopoDS_Face& face, const BezierCurve& curve,
                                const gp_Pnt2d& from, const gp_Pnt2d& to) {
  // Points of the interpolating spline. A choice: the seams are measured in the end.
  constexpr int count = 33;
  const BRepAdaptor_Surface surface(face, false);
  ShapeAnalysis_Surface nearest(BRep_Tool::Surface(face));
  const handle<TColgp_HArray1OfPnt2d> path = new TColgp_HArray1OfPnt2d(1, count);
  const handle<TColStd_HArray1OfReal> parameters = new TColStd_HArray1OfReal(1, count);
  path->SetValue(1, from);
  for (int k = 0; k < count; ++k) parameters->SetValue(k + 1, static_cast<double>(k) / (count - 1));
  for (int k = 1; k + 1 < count; ++k) {
    const Vector3d p = curve.point(parameters->Value(k + 1));
    const gp_Pnt2d before = path->Value(k);
    const gp_Pnt2d at = nearest.NextValueOfUV(before, pointOf(p), 1e-9);
    path->SetValue(k + 1,
                   {beside(at.X(), before.X(), surface.IsUPeriodic() ? surface.UPeriod() : 0),
                    beside(at.Y(), before.Y(), surface.IsVPeriodic() ? surface.VPeriod() : 0)});
  }
  path->SetValue(count, to);
  Geom2dAPI_Interpolate fit(path, parameters, false, Precision::PConfusion());
  fit.Load(tangentIn(surface, from, curve.jet(0).d1), tangentIn(surface, to, curve.jet(1).d1),
           false);
  fit.Perform();
  if (!fit.IsDone()) throw CornerRefused(corner_why::noPath());
  return handle<Geom2d_Curve>(fit.Curve());
}

}  // namespace seamwright::occ
