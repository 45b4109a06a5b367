// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Geom_Surface.hxx>
#include <algorithm>
#include <array>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/fill/fill_form.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;

/// Samples along a side, and in each direction of a face.
constexpr int side_samples = 16;

std::vector<Vector3d> normalsOf(const TopoDS_Face& face) {
  const auto surface = BRep_Tool::Surface(face);
  std::array<double, 4> range{};
  surface->Bounds(range[0], range[1], range[2], range[3]);
  std::vector<Vector3d> normals;
  for (int i = 0; i < side_samples; ++i)
    for (int j = 0; j < side_samples; ++j) {
      gp_Pnt point;
      gp_Vec u, v;
      surface->D1(range[0] + (i + 0.5) / side_samples * (range[1] - range[0]),
                  range[2] + (j + 0.5) / side_samples * (range[3] - range[2]), point, u, v);
      normals.push_back(vector(u.Crossed(v)));
    }
  return normals;
}

bool isMixed(const std::vector<Vector3d>& normals, const Vector3d& up) {
  const auto isUp = [&up](const Vector3d& normal) { return normal.dot(up) > 0; };
  return std::ranges::any_of(normals, isUp) && !std::ranges::all_of(normals, isUp);
}

}  // namespace

double reachOf(const BSplineSurface& surface, const std::vector<FittedSide>& sides) {
  Eigen::AlignedBox3d box;
  for (const FittedSide& side : sides) {
    const Poles poles = side.side.edge.poles();
    for (Eigen::Index k = 0; k < poles.rows(); ++k) box.extend(poles.row(k).transpose());
  }
  double farthest_mm = 0;
  for (Eigen::Index k = 0; k < surface.poles.rows(); ++k) {
    const Eigen::Vector4d pole = surface.poles.row(k);
    farthest_mm = std::max(farthest_mm, (pole.head<3>() / pole[3] - box.center()).norm());
  }
  return farthest_mm / (0.5 * box.diagonal().norm());
}

bool turnsBack(const std::vector<TopoDS_Face>& faces, const std::vector<FittedSide>& sides) {
  Vector3d area = Vector3d::Zero();
  std::vector<Vector3d> around;
  for (const FittedSide& side : sides) {
    if (!side.side.cross) return false;
    const BezierCurve cross(*side.side.cross);
    for (int k = 0; k < side_samples; ++k) {
      const double t = static_cast<double>(k) / side_samples,
                   next = static_cast<double>(k + 1) / side_samples;
      const Vector3d here = side.side.edge.point(t), there = side.side.edge.point(next);
      area += here.cross(there);
      around.push_back((there - here).cross(cross.point(t + 0.5 / side_samples)));
    }
  }
  if (isMixed(around, area)) return false;
  std::vector<Vector3d> normals;
  for (const TopoDS_Face& face : faces)
    for (const Vector3d& normal : normalsOf(face)) normals.push_back(normal);
  return isMixed(normals, area);
}

}  // namespace seamwright::occ
