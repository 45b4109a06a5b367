// SPDX-License-Identifier: LGPL-2.1-or-later
#include <memory>
#include <utility>
#include <vector>

#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/seam/bspline_side.hpp>

namespace seamwright {

SeamSide seamSide(const BSplineSurface& surface, PatchEdge edge, bool reversed) {
  requireValid(surface);
  const Poles affine = affinePoles(surface.poles);
  std::vector<Eigen::Vector3d> poles;
  for (Eigen::Index i = 0; i < affine.rows(); ++i) poles.emplace_back(affine.row(i));
  std::vector<double> weights;
  if (isRational(surface.poles))
    for (Eigen::Index i = 0; i < affine.rows(); ++i) weights.push_back(surface.poles(i, 3));
  const auto spline = std::make_shared<SplineEvaluator>(
      SplineDirection{surface.degree_u, surface.knots_u},
      SplineDirection{surface.degree_v, surface.knots_v}, std::move(poles), std::move(weights));
  const bool at_end = edge == PatchEdge::U1 || edge == PatchEdge::V1;
  const bool along_v = along(edge) == SurfaceDirection::V;
  const std::vector<double>& run = along_v ? surface.knots_v : surface.knots_u;
  const std::vector<double>& fixed = along_v ? surface.knots_u : surface.knots_v;
  const double across = at_end ? fixed.back() : fixed.front();
  const Eigen::Vector3d origin =
      along_v ? Eigen::Vector3d(across, 0, 0) : Eigen::Vector3d(0, across, 0);
  const Eigen::Vector3d sense = along_v ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
  SeamSide side{LineEvaluator{origin, sense}, splineEvaluator(spline)};
  side.t = {run.front(), run.back()};
  if (reversed) std::swap(side.t[0], side.t[1]);
  side.face_on_left = (edge == PatchEdge::U1 || edge == PatchEdge::V0) != reversed;
  return side;
}

}  // namespace seamwright
