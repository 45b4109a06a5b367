// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <utility>

#include <seamwright/core/seam/patch_side.hpp>

namespace seamwright {

namespace {

SplineDirection oneSpan(int degree) {
  SplineDirection direction{degree, std::vector<double>(2 * (degree + 1), 0.0)};
  std::fill(direction.knots.begin() + degree + 1, direction.knots.end(), 1.0);
  return direction;
}

std::shared_ptr<const SurfaceEvaluator> evaluatorOf(const BezierPatch& patch) {
  const Poles rows = patch.poles();
  std::vector<Eigen::Vector3d> poles;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) poles.emplace_back(rows.row(i));
  const Eigen::VectorXd w = patch.weights();
  std::vector<double> weights;
  if (patch.isRational()) weights.assign(w.begin(), w.end());
  return splineEvaluator(std::make_shared<SplineEvaluator>(
      oneSpan(patch.degreeU()), oneSpan(patch.degreeV()), std::move(poles), std::move(weights)));
}

LineEvaluator lineAlong(PatchEdge edge) {
  const bool along_v = edge == PatchEdge::U0 || edge == PatchEdge::U1;
  const bool at_end = edge == PatchEdge::U1 || edge == PatchEdge::V1;
  const Eigen::Vector3d along = along_v ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
  const Eigen::Vector3d across = along_v ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  return {(at_end ? 1.0 : 0.0) * across, along};
}

}  // namespace

SeamSide seamSide(const BezierPatch& patch, PatchEdge edge, bool reversed) {
  SeamSide side{lineAlong(edge), evaluatorOf(patch)};
  const bool inside_on_left = edge == PatchEdge::U1 || edge == PatchEdge::V0;
  side.face_on_left = inside_on_left != reversed;
  if (reversed) side.t = {1, 0};
  return side;
}

}  // namespace seamwright
