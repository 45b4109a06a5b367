// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <Eigen/Geometry>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <gp_Ax3.hxx>
#include <numbers>

#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/fill/corner_reasons.hpp>
#include <seamwright/occ_adapter/fill/corner_tubes.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;
using opencascade::handle;
using std::numbers::pi;

/// The pcurve of a far end has this degree at most.
constexpr int most_wave_degree = 16;

/// The section of a cylinder by the plane at the far end: a circle or an ellipse, with the
/// parameter u - highest_u.
struct FarCut {
  gp_Ax2 axes;
  bool upright = true;
  double cosine = 1;     ///< cosine of the angle between the axis and the plane's normal
  double height = 0;     ///< v of the plane on the axis
  double swing = 0;      ///< the section has v = height + swing cos(u - highest_u)
  double highest_u = 0;  ///< in (-pi, pi]
};

FarCut farCut(const CornerEdge& corner_edge, const CornerStrip& strip) {
  const Vector3d& axis = corner_edge.axis;
  const bool along = corner_edge.end_normal.dot(axis) > 0;
  const Vector3d normal = along ? corner_edge.end_normal : Vector3d(-corner_edge.end_normal);
  FarCut cut;
  cut.cosine = normal.dot(axis);
  cut.height = normal.dot(strip.far_contacts[0] - strip.centre) / cut.cosine;
  const Vector3d lean = normal - cut.cosine * axis;
  const Vector3d x = -strip.to_edge, y = axis.cross(x);
  // Far above the rounding of unit vectors. So little lean moves a cut by 1e-12 of the radius.
  cut.upright = lean.norm() < 1e-12;
  if (!cut.upright) cut.highest_u = std::atan2(-lean.dot(y), -lean.dot(x));
  cut.swing = strip.radius_mm * lean.norm() / cut.cosine;
  const Vector3d across = std::cos(cut.highest_u) * x + std::sin(cut.highest_u) * y;
  const Vector3d major = across - normal.dot(across) / cut.cosine * axis;
  cut.axes =
      gp_Ax2(pointOf(strip.centre + cut.height * axis), directionOf(normal), directionOf(major));
  return cut;
}

/// Requires that the far cut is beyond the section. Its ends are, as ends of the contact lines,
/// so only its lowest point needs a test.
void requireBeyondSection(const CornerEdge& edge, const CornerStrip& strip, const FarCut& cut,
                          double first, double last) {
  const double lowest_u = cut.highest_u + pi;  // in [0, 2 pi], like the arc
  const double lowest = cut.height - cut.swing;
  if (lowest_u > first && lowest_u < last && !(lowest > 0))
    throw CornerRefused(corner_why::farEndCut(edge.number, strip.radius_mm, lowest));
}

/// The polynomial pcurve of v = height + swing cos(t) over u = t + highest_u, with an error of at
/// most half the tolerance.
handle<Geom2d_Curve> waveOf(const FarCut& cut, double sweep_rad, double first, double last,
                            double tolerance_mm) {
  int degree = 4;
  UnitArc arc = unitArc(sweep_rad, degree);
  while (arc.error * cut.swing > tolerance_mm / 2 && degree < most_wave_degree)
    arc = unitArc(sweep_rad, ++degree);
  const double middle = (first + last) / 2;
  const int count = static_cast<int>(arc.poles.rows());
  TColgp_Array1OfPnt2d poles(1, count);
  for (int k = 0; k < count; ++k) {
    const double t = first + (last - first) * k / (count - 1);
    const double cosine = std::cos(middle) * arc.poles(k, 0) - std::sin(middle) * arc.poles(k, 1);
    poles(k + 1) = gp_Pnt2d(t + cut.highest_u, cut.height + cut.swing * cosine);
  }
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = first;
  knots(2) = last;
  TColStd_Array1OfInteger multiplicities(1, 2);
  multiplicities.Init(count);
  return new Geom2d_BSplineCurve(poles, knots, multiplicities, count - 1);
}

TopoDS_Edge endOf(const CornerEdge& corner_edge, const CornerStrip& strip, const CornerTube& tube,
                  const EdgeMaker& maker) {
  const FarCut cut = farCut(corner_edge, strip);
  const double radius = strip.radius_mm;
  const std::size_t from = tube.u[1] > tube.u[0] ? 0 : 1;
  const double first = tube.u[from] - cut.highest_u, last = tube.u[1 - from] - cut.highest_u;
  requireBeyondSection(corner_edge, strip, cut, tube.u[from], tube.u[1 - from]);
  handle<Geom_Curve> curve;
  handle<Geom2d_Curve> path;
  if (cut.upright) {
    curve = new Geom_Circle(cut.axes, radius);
    path = new Geom2d_Line(gp_Pnt2d(0, cut.height), gp::DX2d());
  } else {
    curve = new Geom_Ellipse(cut.axes, radius / cut.cosine, radius);
    path = waveOf(cut, strip.sweep_rad, first, last, maker.tolerance_mm());
  }
  const TopoDS_Edge made = maker.edge(curve, first, last, tube.far[from], tube.far[1 - from]);
  maker.lay(made, path, tube.face);
  BRep_Builder().Range(made, first, last);
  return from == 0 ? made : TopoDS::Edge(made.Reversed());
}

}  // namespace

CornerTube cornerTube(const CornerEdge& corner_edge, const CornerStrip& strip,
                      const EdgeMaker& maker) {
  CornerTube tube;
  const gp_Ax3 axes(pointOf(strip.centre), directionOf(corner_edge.axis),
                    directionOf(-strip.to_edge));
  tube.surface = new Geom_CylindricalSurface(axes, strip.radius_mm);
  const bool rising =
      corner_edge.axis.cross(strip.to_edge).dot(strip.contacts[1] - strip.contacts[0]) > 0;
  const double half = (rising ? 0.5 : -0.5) * strip.sweep_rad;
  tube.u = {pi - half, pi + half};
  BRep_Builder().MakeFace(tube.face, tube.surface, maker.tolerance_mm());
  for (std::size_t side = 0; side < 2; ++side) {
    tube.near[side] = maker.vertex(strip.contacts[side]);
    tube.far[side] = maker.vertex(strip.far_contacts[side]);
    tube.contacts[side] = maker.line(tube.near[side], tube.far[side]);
    maker.lay(tube.contacts[side], new Geom2d_Line(gp_Pnt2d(tube.u[side], 0), gp::DY2d()),
              tube.face);
  }
  tube.end = endOf(corner_edge, strip, tube, maker);
  return tube;
}

}  // namespace seamwright::occ
