// SPDX-License-Identifier: LGPL-2.1-or-later
#include "dense_oracle.hpp"

#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SweptSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace seamwright::test {

namespace {

struct Local {
  gp_Pnt p;
  gp_Vec u, v, uu, uv, vv;
  gp_Vec normal;     ///< unit
  gp_Vec into_face;  ///< unit, in the tangent plane, square to the seam
  bool has_normal = false;
  double rounding_mm = 0;       ///< of a coordinate
  double normal_noise_rad = 0;  ///< see DenseValue
  double second_noise_per_mm = 0;
};

using Surface = opencascade::handle<Geom_Surface>;

/// Knot span around a parameter over the degree.
template <class Knot>
double stepOf(int degree, int first, int last, const Knot& knot, double parameter) {
  int span = first;
  while (span + 1 < last && knot(span + 1) <= parameter) ++span;
  return (knot(span + 1) - knot(span)) / degree;
}

double stepOf(const opencascade::handle<Geom_Curve>& curve, double parameter) {
  const auto spline = opencascade::handle<Geom_BSplineCurve>::DownCast(curve);
  if (spline.IsNull()) return 0.2;  // also a Bezier curve of some degree over 0..1
  return stepOf(
      spline->Degree(), 1, spline->NbKnots(), [&](int i) { return spline->Knot(i); }, parameter);
}

/// Steps over which the partials of a surface are differences, see DenseValue.
std::array<double, 2> stepsOf(const Surface& surface, double u, double v) {
  if (const auto trimmed = opencascade::handle<Geom_RectangularTrimmedSurface>::DownCast(surface);
      !trimmed.IsNull())
    return stepsOf(trimmed->BasisSurface(), u, v);
  if (const auto offset = opencascade::handle<Geom_OffsetSurface>::DownCast(surface);
      !offset.IsNull())
    return stepsOf(offset->BasisSurface(), u, v);
  if (const auto spline = opencascade::handle<Geom_BSplineSurface>::DownCast(surface);
      !spline.IsNull())
    return {
        stepOf(
            spline->UDegree(), 1, spline->NbUKnots(), [&](int i) { return spline->UKnot(i); }, u),
        stepOf(
            spline->VDegree(), 1, spline->NbVKnots(), [&](int i) { return spline->VKnot(i); }, v)};
  if (const auto bezier = opencascade::handle<Geom_BezierSurface>::DownCast(surface);
      !bezier.IsNull())
    return {1.0 / bezier->UDegree(), 1.0 / bezier->VDegree()};
  if (const auto swept = opencascade::handle<Geom_SweptSurface>::DownCast(surface);
      !swept.IsNull()) {
    if (surface->IsKind(STANDARD_TYPE(Geom_SurfaceOfLinearExtrusion)))
      return {stepOf(swept->BasisCurve(), u), 1};
    return {1, stepOf(swept->BasisCurve(), v)};
  }
  return {1, 1};
}

void addNoise(const Surface& surface, const gp_Pnt2d& uv, double sine, Local& at) {
  const double size = std::max({std::abs(at.p.X()), std::abs(at.p.Y()), std::abs(at.p.Z()), 1.0});
  at.rounding_mm = 64 * std::numeric_limits<double>::epsilon() * size;
  const std::array<double, 2> steps = stepsOf(surface, uv.X(), uv.Y());
  const std::array<double, 2> lengths = {steps[0] * at.u.Magnitude() * sine,
                                         steps[1] * at.v.Magnitude() * sine};
  for (const double length : lengths) {
    at.normal_noise_rad += at.rounding_mm / length;
    at.second_noise_per_mm += at.rounding_mm / (length * length);
  }
}

Local evaluate(const DenseSide& side, double s) {
  gp_Pnt2d uv;
  gp_Vec2d along;
  side.path->D1(side.first + s * (side.last - side.first), uv, along);
  Local at;
  side.surface->D2(uv.X(), uv.Y(), at.p, at.u, at.v, at.uu, at.vv, at.uv);
  const double lengths = at.u.Magnitude() * at.v.Magnitude();
  const gp_Vec cross = at.u.Crossed(at.v);
  // A collapsed side has partials of rounding size; parallel partials tell no plane either.
  at.has_normal =
      std::min(at.u.Magnitude(), at.v.Magnitude()) > 1e-7 && cross.Magnitude() > 1e-9 * lengths;
  if (!at.has_normal) return at;
  at.normal = cross.Normalized();
  addNoise(side.surface, uv, cross.Magnitude() / lengths, at);
  // A step to the left in the parameter plane, made square to the seam.
  gp_Vec2d left(-along.Y(), along.X());
  if (!side.face_on_left) left.Reverse();
  const gp_Vec step = left.X() * at.u + left.Y() * at.v;
  const gp_Vec seam = along.X() * at.u + along.Y() * at.v;
  at.into_face = step;
  if (seam.SquareMagnitude() > 0) at.into_face -= step.Dot(seam) / seam.SquareMagnitude() * seam;
  if (at.into_face.Magnitude() > 0) at.into_face.Normalize();
  return at;
}

/// Normal curvature in the direction d of the tangent plane: solve a X_u + b X_v = d, then
/// II(a, b) / I(a, b).
double normalCurvature(const Local& at, const gp_Vec& normal, const gp_Vec& d) {
  const double E = at.u.Dot(at.u), F = at.u.Dot(at.v), G = at.v.Dot(at.v);
  const double du = d.Dot(at.u), dv = d.Dot(at.v);
  const double determinant = E * G - F * F;
  const double a = (G * du - F * dv) / determinant, b = (E * dv - F * du) / determinant;
  const double second =
      a * a * normal.Dot(at.uu) + 2 * a * b * normal.Dot(at.uv) + b * b * normal.Dot(at.vv);
  return second / (E * a * a + 2 * F * a * b + G * b * b);
}

/// The turn about the line of both planes that takes normal m to normal n (Rodrigues), applied to
/// x.
gp_Vec turned(const gp_Vec& x, const gp_Vec& m, const gp_Vec& n) {
  const gp_Vec axis = m.Crossed(n);
  const double cosine = m.Dot(n);
  return cosine * x + axis.Crossed(x) + axis.Dot(x) / (1 + cosine) * axis;
}

/// Largest absolute value of a function of the form a + b cos 2w + c sin 2w, from its values at 0,
/// 45 and 90 degrees.
double largest(double at_0, double at_45, double at_90) {
  const double mean = 0.5 * (at_0 + at_90);
  return std::abs(mean) + std::hypot(0.5 * (at_0 - at_90), at_45 - mean);
}

void measureCurvature(const Local& a, const Local& b, double flat_radius_mm, DensePoint& point) {
  const gp_Vec m = a.normal.Dot(b.normal) < 0 ? b.normal.Reversed() : b.normal;
  const gp_Vec x = a.u.Normalized(), y = a.normal.Crossed(x);
  std::array<double, 3> ka{}, kb{};
  for (int k = 0; k < 3; ++k) {
    const double w = k * std::numbers::pi / 4;
    const gp_Vec d = std::cos(w) * x + std::sin(w) * y;
    ka[k] = normalCurvature(a, a.normal, d);
    kb[k] = normalCurvature(b, m, turned(d, a.normal, m));
  }
  const double difference = largest(ka[0] - kb[0], ka[1] - kb[1], ka[2] - kb[2]);
  const double norm_a = largest(ka[0], ka[1], ka[2]), norm_b = largest(kb[0], kb[1], kb[2]);
  point.norm_per_mm = std::max(norm_a, norm_b);
  const double turning = a.normal_noise_rad + b.normal_noise_rad;
  // |mean| + hypot of three values that are each off by one: 1 + sqrt(1 + 2^2).
  constexpr double of_largest = 3.3;
  const double noise = of_largest * (a.second_noise_per_mm + b.second_noise_per_mm +
                                     4 * point.norm_per_mm * turning);
  point.curvature_per_mm = {difference, noise};
  const double flat = 1 / flat_radius_mm;
  const bool both_flat = point.norm_per_mm < flat;
  point.curvature_rel.value = both_flat ? 0 : difference / point.norm_per_mm;
  const bool may_be_either = std::abs(point.norm_per_mm - flat) <= noise;
  point.curvature_rel.noise = may_be_either ? 1 : 3 * noise / point.norm_per_mm;
}

std::vector<DenseSide> usesOn(const TopoDS_Face& face, const TopoDS_Shape& edge) {
  std::vector<DenseSide> uses;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& use = TopoDS::Edge(it.Current());
    if (!use.IsSame(edge)) continue;
    if (use.Orientation() != TopAbs_FORWARD && use.Orientation() != TopAbs_REVERSED) continue;
    DenseSide side;
    side.surface = BRep_Tool::Surface(face);
    side.path = BRep_Tool::CurveOnSurface(use, face, side.first, side.last);
    side.face_on_left = use.Orientation() == TopAbs_FORWARD;
    if (!side.path.IsNull()) uses.push_back(side);
  }
  return uses;
}

}  // namespace

std::optional<std::array<DenseSide, 2>> denseSides(const TopoDS_Shape& shape, int edge,
                                                   const std::array<int, 2>& faces) {
  TopTools_IndexedMapOfShape face_map, edge_map;
  TopExp::MapShapes(shape, TopAbs_FACE, face_map);
  TopExp::MapShapes(shape, TopAbs_EDGE, edge_map);
  const auto face = [&](int number) {
    return TopoDS::Face(face_map(number).Oriented(TopAbs_FORWARD));
  };
  std::vector<DenseSide> sides = usesOn(face(faces[0]), edge_map(edge));
  if (faces[0] != faces[1])
    for (const DenseSide& side : usesOn(face(faces[1]), edge_map(edge))) sides.push_back(side);
  if (sides.size() != 2) return std::nullopt;
  return std::array<DenseSide, 2>{sides[0], sides[1]};
}

DensePoint densePoint(const std::array<DenseSide, 2>& sides, double s, double flat_radius_mm) {
  const Local a = evaluate(sides[0], s), b = evaluate(sides[1], s);
  DensePoint point;
  point.gap_mm = {a.p.Distance(b.p), a.rounding_mm + b.rounding_mm + 1e-13};
  point.partials = {a.u.Magnitude(), a.v.Magnitude(), b.u.Magnitude(), b.v.Magnitude()};
  if (!a.has_normal || !b.has_normal) return point;
  point.angle_rad = {
      std::atan2(a.normal.Crossed(b.normal).Magnitude(), std::abs(a.normal.Dot(b.normal))),
      a.normal_noise_rad + b.normal_noise_rad};
  point.fold = a.into_face.Dot(b.into_face) > 0;
  measureCurvature(a, b, flat_radius_mm, point);
  return point;
}

namespace {

std::array<double, 4> longestPartials(const std::vector<DensePoint>& points) {
  std::array<double, 4> longest{};
  for (const DensePoint& point : points)
    for (std::size_t i = 0; i < 4; ++i) longest[i] = std::max(longest[i], point.partials[i]);
  return longest;
}

void take(const DenseValue& value, DenseValue& largest) {
  if (value.sure() > largest.sure()) largest = value;
}

void takeCurvature(const DensePoint& point, DenseMaxima& maxima) {
  maxima.fold = maxima.fold || point.fold;
  if (point.fold) return;
  take(point.curvature_per_mm, maxima.curvature_per_mm);
  maxima.norm_per_mm = std::max(maxima.norm_per_mm, point.norm_per_mm);
  take(point.curvature_rel, maxima.curvature_rel);
}

}  // namespace

DenseMaxima denseMaxima(const std::array<DenseSide, 2>& sides, int count,
                        const ContinuityTolerance& tolerance) {
  std::vector<DensePoint> points;
  for (int k = 0; k < count; ++k)
    points.push_back(
        densePoint(sides, static_cast<double>(k) / (count - 1), tolerance.flat_radius_mm));
  const std::array<double, 4> longest = longestPartials(points);
  DenseMaxima maxima;
  for (const DensePoint& point : points) {
    take(point.gap_mm, maxima.gap_mm);
    const auto shorter_than = [&](double share) {
      for (std::size_t i = 0; i < 4; ++i)
        if (point.partials[i] <= share * longest[i]) return true;
      return false;
    };
    // Near a pole a short partial has the direction that the scatter of the poles gives it.
    if (!point.angle_rad || shorter_than(0.01)) {
      ++maxima.points_without_normal;
      continue;
    }
    if (!maxima.angle_rad) maxima.angle_rad = DenseValue();
    take(*point.angle_rad, *maxima.angle_rad);
    if (point.angle_rad->value > tolerance.crease_rad) continue;
    maxima.below_crease_share += 1.0 / count;
    takeCurvature(point, maxima);
  }
  return maxima;
}

}  // namespace seamwright::test
