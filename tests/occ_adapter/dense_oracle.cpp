// SPDX-License-Identifier: LGPL-2.1-or-later
#include "dense_oracle.hpp"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace seamwright::test {

namespace {

struct Local {
  gp_Pnt p;
  gp_Vec u, v, uu, uv, vv;
  gp_Vec normal;     ///< unit
  gp_Vec into_face;  ///< unit, in the tangent plane, square to the seam
  bool has_normal = false;
};

Local evaluate(const DenseSide& side, double s) {
  gp_Pnt2d uv;
  gp_Vec2d along;
  side.path->D1(side.first + s * (side.last - side.first), uv, along);
  Local at;
  side.surface->D2(uv.X(), uv.Y(), at.p, at.u, at.v, at.uu, at.vv, at.uv);
  const double lengths = at.u.Magnitude() * at.v.Magnitude();
  const gp_Vec cross = at.u.Crossed(at.v);
  // A collapsed side has partials of rounding size; parallel partials tell no plane either.
  at.has_normal = std::min(at.u.Magnitude(), at.v.Magnitude()) > 1e-7 && cross.Magnitude() > 1e-9 * lengths;
  if (!at.has_normal) return at;
  at.normal = cross.Normalized();
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

/// Normal curvature in the direction d of the tangent plane: solve a X_u + b X_v = d, then II(a, b) / I(a, b).
double normalCurvature(const Local& at, const gp_Vec& normal, const gp_Vec& d) {
  const double E = at.u.Dot(at.u), F = at.u.Dot(at.v), G = at.v.Dot(at.v);
  const double du = d.Dot(at.u), dv = d.Dot(at.v);
  const double determinant = E * G - F * F;
  const double a = (G * du - F * dv) / determinant, b = (E * dv - F * du) / determinant;
  const double second = a * a * normal.Dot(at.uu) + 2 * a * b * normal.Dot(at.uv) + b * b * normal.Dot(at.vv);
  return second / (E * a * a + 2 * F * a * b + G * b * b);
}

/// The turn about the line of both planes that takes normal m to normal n (Rodrigues), applied to x.
gp_Vec turned(const gp_Vec& x, const gp_Vec& m, const gp_Vec& n) {
  const gp_Vec axis = m.Crossed(n);
  const double cosine = m.Dot(n);
  return cosine * x + axis.Crossed(x) + axis.Dot(x) / (1 + cosine) * axis;
}

/// Largest absolute value of a function of the form a + b cos 2w + c sin 2w, from its values at 0, 45 and 90 degrees.
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
  point.curvature_per_mm = largest(ka[0] - kb[0], ka[1] - kb[1], ka[2] - kb[2]);
  const double norm_a = largest(ka[0], ka[1], ka[2]), norm_b = largest(kb[0], kb[1], kb[2]);
  point.norm_per_mm = std::max(norm_a, norm_b);
  const bool flat_a = norm_a < 1 / flat_radius_mm, flat_b = norm_b < 1 / flat_radius_mm;
  if (flat_a && flat_b)
    point.curvature_rel = 0;
  else
    point.curvature_rel = flat_a || flat_b ? 1 : point.curvature_per_mm / std::max(norm_a, norm_b);
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
  const auto face = [&](int number) { return TopoDS::Face(face_map(number).Oriented(TopAbs_FORWARD)); };
  std::vector<DenseSide> sides = usesOn(face(faces[0]), edge_map(edge));
  if (faces[0] != faces[1])
    for (const DenseSide& side : usesOn(face(faces[1]), edge_map(edge))) sides.push_back(side);
  if (sides.size() != 2) return std::nullopt;
  return std::array<DenseSide, 2>{sides[0], sides[1]};
}

DensePoint densePoint(const std::array<DenseSide, 2>& sides, double s, double flat_radius_mm) {
  const Local a = evaluate(sides[0], s), b = evaluate(sides[1], s);
  DensePoint point;
  point.gap_mm = a.p.Distance(b.p);
  point.partials = {a.u.Magnitude(), a.v.Magnitude(), b.u.Magnitude(), b.v.Magnitude()};
  if (!a.has_normal || !b.has_normal) return point;
  point.angle_rad = std::atan2(a.normal.Crossed(b.normal).Magnitude(), std::abs(a.normal.Dot(b.normal)));
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

void takeCurvature(const DensePoint& point, DenseMaxima& maxima) {
  maxima.fold = maxima.fold || point.fold;
  if (point.fold) return;
  maxima.curvature_per_mm = std::max(maxima.curvature_per_mm, point.curvature_per_mm);
  maxima.norm_per_mm = std::max(maxima.norm_per_mm, point.norm_per_mm);
  maxima.curvature_rel = std::max(maxima.curvature_rel, point.curvature_rel);
}

}  // namespace

DenseMaxima denseMaxima(const std::array<DenseSide, 2>& sides, int count,
                        const ContinuityTolerance& tolerance) {
  std::vector<DensePoint> points;
  for (int k = 0; k < count; ++k)
    points.push_back(densePoint(sides, static_cast<double>(k) / (count - 1), tolerance.flat_radius_mm));
  const std::array<double, 4> longest = longestPartials(points);
  DenseMaxima maxima;
  for (const DensePoint& point : points) {
    maxima.gap_mm = std::max(maxima.gap_mm, point.gap_mm);
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
    maxima.angle_rad = std::max(maxima.angle_rad.value_or(0), *point.angle_rad);
    if (*point.angle_rad <= tolerance.crease_rad) maxima.below_crease_share += 1.0 / count;
    if (*point.angle_rad <= tolerance.crease_rad) takeCurvature(point, maxima);
  }
  return maxima;
}

}  // namespace seamwright::test
