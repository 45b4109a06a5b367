// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <stdexcept>

#include <seamwright/core/fair/curvature_profile.hpp>
#include <seamwright/core/fair/profile_sum.hpp>

namespace seamwright {

namespace {

/// Has the sign of the derivative of the curvature (of its square in space) by the parameter, from
/// the derivatives up to order 3.
double slopeOfCurvature(const CurveDerivatives& at, bool planar) {
  const Eigen::RowVector3d first = at.row(1), second = at.row(2), third = at.row(3);
  const Eigen::RowVector3d turn = first.cross(second), change = first.cross(third);
  const double square = first.squaredNorm(), along = first.dot(second);
  if (planar) return change.z() * square - 3 * along * turn.z();
  return turn.dot(change) * square - 3 * along * turn.squaredNorm();
}

}  // namespace

void ProfileSum::add(const BezierCurve& segment) {
  try {
    const CurvatureProfile profile =
        planar ? planarCurvatureProfile(segment) : spaceCurvatureProfile(segment);
    extrema += static_cast<int>(profile.extrema.size());
    inflections += static_cast<int>(profile.inflections.size());
    if (!profile.undecided_extrema.empty() || !profile.undecided_inflections.empty()) ++undecided;
  } catch (const std::domain_error&) {
    ++undecided;  // it may stop: the curvature has no certain sign
  }
  const double slope = slopeOfCurvature(segment.derivatives(0, 3), planar);
  if (last_slope * slope < 0) ++extrema_at_joints;
  last_slope = slopeOfCurvature(segment.derivatives(1, 3), planar);
}

}  // namespace seamwright
