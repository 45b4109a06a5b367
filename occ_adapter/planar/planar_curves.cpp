// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <Eigen/Geometry>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Hyperbola.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_Parabola.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomLib.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Ax22d.hxx>
#include <numbers>
#include <stdexcept>
#include <string>

#include <seamwright/core/bernstein/interval.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/convert/spline_curve.hpp>
#include <seamwright/occ_adapter/planar/planar_curves.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using opencascade::handle;

/// Centre and two half axes: a circle or conic is centre + f(u) x + g(u) y.
template <class Vector>
struct Axes {
  Vector centre, x, y;
};

/// A conic segment in any dimension.
template <class Vector>
struct ConicPiece {
  Vector start, corner, end;
  double weight = 1;
};

template <class Vector>
using ConicPieces = std::vector<ConicPiece<Vector>>;

int partsOf(double range, double longest) {
  // A range of so many longest parts, up to the rounding of its ends, needs no further one.
  constexpr double rounding = 1e-12;
  return std::max(1, static_cast<int>(std::ceil(range / longest - rounding)));
}

/// Cuts [first, last] into equal parts, and makes a piece of each.
template <class Vector, class Piece>
ConicPieces<Vector> pieces(const Interval& range, int parts, const Piece& piece) {
  ConicPieces<Vector> result;
  for (int i = 0; i < parts; ++i) {
    const auto at = [&](int k) {
      return k == parts ? range.upper : range.lower + range.width() * k / parts;
    };
    result.push_back(piece(at(i), at(i + 1)));
    if (i > 0) result[i].start = result[i - 1].end;
  }
  return result;
}

/// centre + x cos u + y sin u. The tangents of [u0, u1] meet at 1 / cos(half of the range).
template <class Vector>
ConicPieces<Vector> ellipsePieces(const Axes<Vector>& axes, const Interval& range) {
  const auto point = [&](double u, double factor) -> Vector {
    return axes.centre + factor * (std::cos(u) * axes.x + std::sin(u) * axes.y);
  };
  constexpr double longest = 2 * std::numbers::pi / 3;
  return pieces<Vector>(range, partsOf(range.width(), longest), [&](double u0, double u1) {
    const double weight = std::cos((u1 - u0) / 2);
    return ConicPiece<Vector>{point(u0, 1), point((u0 + u1) / 2, 1 / weight), point(u1, 1), weight};
  });
}

/// centre + x cosh u + y sinh u.
template <class Vector>
ConicPieces<Vector> hyperbolaPieces(const Axes<Vector>& axes, const Interval& range) {
  const auto point = [&](double u, double factor) -> Vector {
    return axes.centre + factor * (std::cosh(u) * axes.x + std::sinh(u) * axes.y);
  };
  constexpr double longest = 2;  // weights up to cosh 1
  return pieces<Vector>(range, partsOf(range.width(), longest), [&](double u0, double u1) {
    const double weight = std::cosh((u1 - u0) / 2);
    return ConicPiece<Vector>{point(u0, 1), point((u0 + u1) / 2, 1 / weight), point(u1, 1), weight};
  });
}

/// vertex + x u^2 + y u, with x = axis / (4 focal).
template <class Vector>
ConicPieces<Vector> parabolaPieces(const Axes<Vector>& axes, const Interval& range) {
  const auto blossom = [&](double u, double v) -> Vector {
    return axes.centre + u * v * axes.x + (u + v) / 2 * axes.y;
  };
  return pieces<Vector>(range, 1, [&](double u0, double u1) {
    return ConicPiece<Vector>{blossom(u0, u0), blossom(u0, u1), blossom(u1, u1), 1};
  });
}

template <class Piece>
ChainCurve planarConic(const Piece& piece) {
  return PlanarConic{piece.start, piece.corner, piece.end, piece.weight};
}

std::vector<ChainCurve> planarConics(const ConicPieces<Vector2d>& of) {
  std::vector<ChainCurve> result;
  for (const ConicPiece<Vector2d>& piece : of) result.push_back(planarConic(piece));
  return result;
}

/// Axes of one length that are orthogonal; y is x turned to the left or to the right.
std::vector<ChainCurve> circleArc(const Axes<Vector2d>& axes, const Interval& range) {
  const double radius = axes.x.norm(), side = cross(axes.x, axes.y) > 0 ? 1 : -1;
  const double quarter = side * std::numbers::pi / 2;
  return {PlanarArc{
      .start = axes.centre + std::cos(range.lower) * axes.x + std::sin(range.lower) * axes.y,
      .direction_rad = seamwright::directionOf(axes.x) + side * range.lower + quarter,
      .curvature_per_mm = side / radius,
      .length_mm = radius * range.width()}};
}

std::vector<ChainCurve> lineSegment(const Vector2d& point, const Vector2d& direction,
                                    const Interval& range) {
  return {PlanarArc{.start = point + range.lower * direction,
                    .direction_rad = seamwright::directionOf(direction),
                    .curvature_per_mm = 0,
                    .length_mm = range.width() * direction.norm()}};
}

Interval requireRange(double first, double last) {
  if (!std::isfinite(first) || !std::isfinite(last) || !(first < last))
    throw std::invalid_argument("the range from " + std::to_string(first) + " to " +
                                std::to_string(last) + " has no length or no end");
  if (Precision::IsInfinite(first) || Precision::IsInfinite(last))
    throw std::domain_error("the curve is infinite: trim it");
  return {first, last};
}

Vector2d vector2d(const gp_XY& xy) {
  return {xy.X(), xy.Y()};
}

Axes<Vector2d> axesOf(const Geom2d_Conic& conic, double x_mm, double y_mm) {
  const gp_Ax22d position = conic.Position();
  return {vector2d(position.Location().XY()), x_mm * vector2d(position.XDirection().XY()),
          y_mm * vector2d(position.YDirection().XY())};
}

Axes<Vector3d> axesOf(const Geom_Conic& conic, double x_mm, double y_mm) {
  const gp_Ax2 position = conic.Position();
  return {vector(position.Location()), x_mm * vector(position.XDirection()),
          y_mm * vector(position.YDirection())};
}

/// The plane z = 0 as a curve of space; its poles are those of the plane, bitwise.
handle<Geom_Curve> inSpace(const Geom2d_Curve& curve) {
  const handle<Geom2d_Curve> copy = handle<Geom2d_Curve>::DownCast(curve.Copy());
  return GeomLib::To3d(gp_Ax2(gp::Origin(), gp::DZ(), gp::DX()), copy);
}

ConicPieces<Vector3d> conicPieces(const Geom_Curve& curve, const Interval& range) {
  if (const auto* circle = dynamic_cast<const Geom_Circle*>(&curve))
    return ellipsePieces(axesOf(*circle, circle->Radius(), circle->Radius()), range);
  if (const auto* ellipse = dynamic_cast<const Geom_Ellipse*>(&curve))
    return ellipsePieces(axesOf(*ellipse, ellipse->MajorRadius(), ellipse->MinorRadius()), range);
  if (const auto* hyperbola = dynamic_cast<const Geom_Hyperbola*>(&curve))
    return hyperbolaPieces(axesOf(*hyperbola, hyperbola->MajorRadius(), hyperbola->MinorRadius()),
                           range);
  if (const auto* parabola = dynamic_cast<const Geom_Parabola*>(&curve))
    return parabolaPieces(axesOf(*parabola, 1 / (4 * parabola->Focal()), 1), range);
  return {};
}

BSplineCurve splineOver(const Geom_Curve& curve, const Interval& range) {
  const handle<Geom_Curve> copy = handle<Geom_Curve>::DownCast(curve.Copy());
  const bool whole = curve.FirstParameter() == range.lower && curve.LastParameter() == range.upper;
  if (whole) return coreCurve(curve);
  return coreCurve(
      *handle<Geom_TrimmedCurve>(new Geom_TrimmedCurve(copy, range.lower, range.upper)));
}

void requireParallel(const Geom_Curve& curve, const PlaneFrame& frame) {
  const auto* conic = dynamic_cast<const Geom_Conic*>(&curve);
  if (!conic) return;
  // The projection is then of the same kind up to 1e-12.
  constexpr double parallel = 1e-6;
  const Vector3d axis = vector(conic->Position().Direction());
  const double off = axis.cross(frame.normal()).norm();
  if (off > parallel)
    throw std::domain_error(std::string(curve.DynamicType()->Name()) +
                            " is in another plane: its axis is " + std::to_string(off) +
                            " rad off the normal");
}

BSplineCurve inPlane(BSplineCurve spline, const PlaneFrame& frame) {
  for (Eigen::Index i = 0; i < spline.poles.rows(); ++i) {
    const double w = spline.poles(i, 3);
    const Vector3d pole = w == 1 ? Vector3d(spline.poles.row(i).head<3>())
                                 : Vector3d(spline.poles.row(i).head<3>() / w);
    const Vector2d p = frame.coordinates(pole);
    spline.poles.row(i) << w * p.x(), w * p.y(), 0, w;
  }
  return spline;
}

handle<Geom2d_Curve> arcCurve(const PlanarArc& arc) {
  if (!(arc.length_mm > 0))
    throw std::invalid_argument(fmt::format("an arc has the length {:.6g} mm", arc.length_mm));
  const Vector2d tangent = unitVector(arc.direction_rad);
  const gp_Dir2d direction(tangent.x(), tangent.y());
  const double k = arc.curvature_per_mm;
  if (k == 0) {
    const handle<Geom2d_Curve> line =
        new Geom2d_Line(gp_Pnt2d(arc.start.x(), arc.start.y()), direction);
    return new Geom2d_TrimmedCurve(line, 0, arc.length_mm);
  }
  // As for the ends of a sum of arcs, a full turn may be missed by its rounding.
  constexpr double full_turn = 2 * std::numbers::pi * (1 - 1e-12);
  const Vector2d to_centre = Vector2d(-tangent.y(), tangent.x()) / k;
  const Vector2d centre = arc.start + to_centre;
  const gp_Ax22d axes(gp_Pnt2d(centre.x(), centre.y()), gp_Dir2d(-to_centre.x(), -to_centre.y()),
                      k > 0);
  const handle<Geom2d_Curve> circle = new Geom2d_Circle(axes, 1 / std::abs(k));
  const double sweep = std::abs(arc.sweep_rad());
  if (sweep >= full_turn) return circle;
  return new Geom2d_TrimmedCurve(circle, 0, sweep);
}

handle<Geom2d_Curve> splineCurve2d(const BSplineCurve& spline) {
  const handle<Geom_BSplineCurve> curve = toBSplineCurve(spline);
  TColgp_Array1OfPnt2d poles(1, curve->NbPoles());
  TColStd_Array1OfReal weights(1, curve->NbPoles());
  for (int i = 1; i <= curve->NbPoles(); ++i) {
    poles(i) = gp_Pnt2d(curve->Pole(i).X(), curve->Pole(i).Y());
    weights(i) = curve->Weight(i);
  }
  return new Geom2d_BSplineCurve(poles, weights, curve->Knots(), curve->Multiplicities(),
                                 curve->Degree());
}

/// An arc whose centre is too far away, as a spline that needs no centre.
bool needsSpline(const PlanarArc& arc) {
  constexpr double most_lengths = 1e5;
  return arc.curvature_per_mm != 0 &&
         1 / std::abs(arc.curvature_per_mm) > most_lengths * arc.length_mm;
}

BSplineCurve splineForm(const ChainCurve& curve) {
  if (const auto* spline = std::get_if<BSplineCurve>(&curve)) return *spline;
  return splineCurve(bezierCurves(curve).front());
}

}  // namespace

std::vector<ChainCurve> planarCurves(const Geom2d_Curve& curve, double first, double last) {
  if (const auto* trimmed = dynamic_cast<const Geom2d_TrimmedCurve*>(&curve))
    return planarCurves(*trimmed->BasisCurve(), first, last);
  const Interval range = requireRange(first, last);
  if (const auto* line = dynamic_cast<const Geom2d_Line*>(&curve))
    return lineSegment(vector2d(line->Location().XY()), vector2d(line->Direction().XY()), range);
  if (const auto* circle = dynamic_cast<const Geom2d_Circle*>(&curve))
    return circleArc(axesOf(*circle, circle->Radius(), circle->Radius()), range);
  if (const auto* ellipse = dynamic_cast<const Geom2d_Ellipse*>(&curve))
    return planarConics(
        ellipsePieces(axesOf(*ellipse, ellipse->MajorRadius(), ellipse->MinorRadius()), range));
  if (const auto* hyperbola = dynamic_cast<const Geom2d_Hyperbola*>(&curve))
    return planarConics(hyperbolaPieces(
        axesOf(*hyperbola, hyperbola->MajorRadius(), hyperbola->MinorRadius()), range));
  if (const auto* parabola = dynamic_cast<const Geom2d_Parabola*>(&curve))
    return planarConics(parabolaPieces(axesOf(*parabola, 1 / (4 * parabola->Focal()), 1), range));
  if (!dynamic_cast<const Geom2d_BSplineCurve*>(&curve) &&
      !dynamic_cast<const Geom2d_BezierCurve*>(&curve))
    throw std::domain_error(std::string(curve.DynamicType()->Name()) +
                            " is not a line, conic or spline");
  return {inPlane(splineOver(*inSpace(curve), range), PlaneFrame())};
}

std::vector<ChainCurve> planarCurves(const Geom2d_Curve& curve) {
  return planarCurves(curve, curve.FirstParameter(), curve.LastParameter());
}

std::vector<ChainCurve> planarCurves(const Geom_Curve& curve, double first, double last,
                                     const PlaneFrame& frame) {
  if (const auto* trimmed = dynamic_cast<const Geom_TrimmedCurve*>(&curve))
    return planarCurves(*trimmed->BasisCurve(), first, last, frame);
  const Interval range = requireRange(first, last);
  requireParallel(curve, frame);
  if (const auto* line = dynamic_cast<const Geom_Line*>(&curve))
    return lineSegment(frame.coordinates(vector(line->Position().Location())),
                       frame.directionCoordinates(vector(line->Position().Direction())), range);
  if (const auto* circle = dynamic_cast<const Geom_Circle*>(&curve)) {
    const Axes<Vector3d> axes = axesOf(*circle, circle->Radius(), circle->Radius());
    return circleArc({frame.coordinates(axes.centre), frame.directionCoordinates(axes.x),
                      frame.directionCoordinates(axes.y)},
                     range);
  }
  std::vector<ChainCurve> result;
  for (const ConicPiece<Vector3d>& piece : conicPieces(curve, range))
    result.emplace_back(PlanarConic{frame.coordinates(piece.start), frame.coordinates(piece.corner),
                                    frame.coordinates(piece.end), piece.weight});
  if (!result.empty()) return result;
  return {inPlane(splineOver(curve, range), frame)};
}

Poles hullOf(const Geom_Curve& curve, double first, double last) {
  if (const auto* trimmed = dynamic_cast<const Geom_TrimmedCurve*>(&curve))
    return hullOf(*trimmed->BasisCurve(), first, last);
  const Interval range = requireRange(first, last);
  if (dynamic_cast<const Geom_Line*>(&curve)) {
    Poles ends(2, 3);
    ends << vector(curve.Value(first)).transpose(), vector(curve.Value(last)).transpose();
    return ends;
  }
  if (const ConicPieces<Vector3d> conics = conicPieces(curve, range); !conics.empty()) {
    Poles points(static_cast<Eigen::Index>(3 * conics.size()), 3);
    Eigen::Index row = 0;
    for (const ConicPiece<Vector3d>& piece : conics)
      for (const Vector3d& point : {piece.start, piece.corner, piece.end})
        points.row(row++) = point.transpose();
    return points;
  }
  const BSplineCurve spline = splineOver(curve, range);
  return spline.poles.leftCols<3>().array().colwise() / spline.poles.col(3).array();
}

double heightOf(const Geom_Curve& curve, double first, double last, const PlaneFrame& frame) {
  const Poles hull = hullOf(curve, first, last);
  double height_mm = 0;
  for (Eigen::Index i = 0; i < hull.rows(); ++i)
    height_mm = std::max(height_mm, std::abs(frame.height_mm(hull.row(i).transpose())));
  return height_mm;
}

handle<Geom2d_Curve> toGeom2d(const ChainCurve& curve) {
  if (const auto* arc = std::get_if<PlanarArc>(&curve); arc && !needsSpline(*arc))
    return arcCurve(*arc);
  return splineCurve2d(splineForm(curve));
}

handle<Geom_Curve> toGeom(const ChainCurve& curve, const PlaneFrame& frame) {
  if (const auto* arc = std::get_if<PlanarArc>(&curve); arc && !needsSpline(*arc)) {
    const gp_Ax2 axes(pointOf(frame.origin), directionOf(frame.normal()), directionOf(frame.x));
    return GeomLib::To3d(axes, arcCurve(*arc));
  }
  BSplineCurve spline = splineForm(curve);
  for (Eigen::Index i = 0; i < spline.poles.rows(); ++i) {
    const double w = spline.poles(i, 3);
    const Vector3d pole = frame.point(spline.poles.row(i).head<2>().transpose() / w);
    spline.poles.row(i) << w * pole.x(), w * pole.y(), w * pole.z(), w;
  }
  return toBSplineCurve(spline);
}

}  // namespace seamwright::occ
