// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hole_corners.hpp"

#include <BRepAdaptor_Surface.hxx>
#include <BRepLProp_SLProps.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Geom2d_Curve.hxx>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace seamwright {
namespace {

using Eigen::Matrix2d, Eigen::Vector2d, Eigen::Vector3d;

Vector3d vector(const gp_Vec& v) {
  return {v.X(), v.Y(), v.Z()};
}

/// A neighbour at one end of its edge.
struct End {
  Vector3d along;  ///< derivative of the edge in the direction of the hole's boundary
  Vector3d up;     ///< unit normal, the hole is to the left of the edge; zero without a normal
  Vector3d u, v, uu, uv, vv;  ///< partial derivatives of the face
  bool has_form = false;      ///< whether u and v span the tangent plane

  /// The second fundamental form of the parts of \p a and \p b in the tangent plane.
  double form(const Vector3d& a, const Vector3d& b) const {
    Eigen::Matrix<double, 3, 2> plane;
    plane << u, v;
    const Vector2d s = plane.colPivHouseholderQr().solve(a),
                   t = plane.colPivHouseholderQr().solve(b);
    return up.dot(s(0) * t(0) * uu + (s(0) * t(1) + s(1) * t(0)) * uv + s(1) * t(1) * vv);
  }
};

End endOf(const occ::HoleEdge& edge, bool last) {
  double first_parameter = 0, last_parameter = 0;
  const opencascade::handle<Geom2d_Curve> path =
      BRep_Tool::CurveOnSurface(edge.use.edge, edge.use.shape, first_parameter, last_parameter);
  gp_Pnt2d at;
  gp_Vec2d by;
  path->D1(last == edge.reversed ? first_parameter : last_parameter, at, by);
  BRepLProp_SLProps face(BRepAdaptor_Surface(edge.use.shape), at.X(), at.Y(), 2, 1e-7);
  End end{{},
          Vector3d::Zero(),
          vector(face.D1U()),
          vector(face.D1V()),
          vector(face.D2U()),
          vector(face.DUV()),
          vector(face.D2V())};
  end.along = (edge.reversed ? -1 : 1) * (by.X() * end.u + by.Y() * end.v);
  end.has_form = end.u.cross(end.v).norm() > 1e-9 * end.u.norm() * end.v.norm();
  if (end.has_form) {
    end.up = end.u.cross(end.v).normalized();
  } else {
    // The face is degenerate here; its normal has a limit along the edge.
    constexpr double beside = 1e-4;
    const bool at_first = last == edge.reversed;
    const double range = last_parameter - first_parameter;
    path->D0(at_first ? first_parameter + beside * range : last_parameter - beside * range, at);
    face.SetParameters(at.X(), at.Y());
    end.up = vector(face.D1U()).cross(vector(face.D1V())).normalized();
  }
  const bool face_on_left = (edge.use.edge.Orientation() == TopAbs_FORWARD) != edge.reversed;
  if (face_on_left) end.up = -end.up;
  return end;
}

double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double norm(const Matrix2d& form) {
  return Eigen::SelfAdjointEigenSolver<Matrix2d>(form, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .cwiseAbs()
      .maxCoeff();
}

/// The largest difference between the curvature of a surface tangent to both neighbours and the
/// curvature of either of them, relative to the larger of the two.
std::optional<double> curvatureAsked(const End& in, const End& out) {
  constexpr double least_sine = 0.05, flat_per_mm = 1e-6;
  const Vector3d up = (in.up + out.up).normalized();
  const Vector3d x = (in.along - in.along.dot(up) * up).normalized(), y = up.cross(x);
  const Vector3d a = x, b = (out.along - out.along.dot(up) * up).normalized();
  if (!in.has_form || !out.has_form || std::abs(a.cross(b).dot(up)) < least_sine)
    return std::nullopt;
  const auto formOf = [&](const End& end) {
    Matrix2d form;
    form << end.form(x, x), end.form(x, y), end.form(x, y), end.form(y, y);
    return form;
  };
  Matrix2d sides, by_sides;
  sides << a.dot(x), b.dot(x), a.dot(y), b.dot(y);
  const double mixed = (in.form(a, b) + out.form(a, b)) / 2;
  by_sides << in.form(a, a), mixed, mixed, out.form(b, b);
  const Matrix2d fill = sides.inverse().transpose() * by_sides * sides.inverse();
  double most = 0;
  for (const Matrix2d& of : {formOf(in), formOf(out)}) {
    const double largest = std::max(norm(fill), norm(of));
    if (largest > flat_per_mm) most = std::max(most, norm(fill - of) / largest);
  }
  return most;
}

}  // namespace

CornerBounds cornerBounds(const occ::Hole& hole) {
  std::vector<occ::HoleEdge> edges;
  for (const occ::HoleSide& side : hole.sides)
    edges.insert(edges.end(), side.edges.begin(), side.edges.end());
  CornerBounds bounds;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const End in = endOf(edges[(k + edges.size() - 1) % edges.size()], true),
              out = endOf(edges[k], false);
    bounds.angle_rad = std::max(bounds.angle_rad, angleBetween(in.up, out.up) / 2);
    const std::optional<double> asked = curvatureAsked(in, out);
    if (asked) bounds.curvature_rel = std::max(bounds.curvature_rel, *asked);
  }
  return bounds;
}

}  // namespace seamwright
