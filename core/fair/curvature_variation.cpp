// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <stdexcept>

#include <seamwright/core/fair/curvature_profile.hpp>
#include <seamwright/core/fair/curvature_variation.hpp>
#include <seamwright/core/fair/spline_energy.hpp>

namespace seamwright {

namespace {

/// |d(k N)/ds|^2 across the tangent, by arc length, times the speed.
/// Source: docs/theory/planar.md P13.4.
double variationDensity(const CurveDerivatives& at) {
  const Eigen::RowVector3d first = at.row(1), second = at.row(2), third = at.row(3);
  const double square = first.squaredNorm();
  const Eigen::RowVector3d change = third - 3 * first.dot(second) / square * second;
  const Eigen::RowVector3d across = change - first.dot(change) / square * first;
  return across.squaredNorm() / (square * square * std::sqrt(square));
}

/// Has the sign of the derivative of the curvature (of its square in space) by the parameter.
double slopeOfCurvature(const CurveDerivatives& at, bool planar) {
  const Eigen::RowVector3d first = at.row(1), second = at.row(2), third = at.row(3);
  const Eigen::RowVector3d turn = first.cross(second), change = first.cross(third);
  const double square = first.squaredNorm(), along = first.dot(second);
  if (planar) return change.z() * square - 3 * along * turn.z();
  return turn.dot(change) * square - 3 * along * turn.squaredNorm();
}

void addProfile(CurvatureVariation& sum, const BezierCurve& segment, bool planar) {
  try {
    const CurvatureProfile profile =
        planar ? planarCurvatureProfile(segment) : spaceCurvatureProfile(segment);
    sum.extrema += static_cast<int>(profile.extrema.size());
    sum.inflections += static_cast<int>(profile.inflections.size());
    if (!profile.undecided_extrema.empty() || !profile.undecided_inflections.empty())
      ++sum.undecided_segments;
  } catch (const std::domain_error&) {
    ++sum.undecided_segments;  // it may stop: the curvature has no certain sign
  }
}

}  // namespace

CurvatureVariation variationOf(const BezierSpline& spline) {
  requireValid(spline);
  const bool planar = (spline.poles.col(2).array() == 0).all();
  const GaussNodes gauss = gaussNodes(8);
  CurvatureVariation result;
  double before = 0;
  for (int i = 0; i < spline.segments(); ++i) {
    const BezierCurve piece = segment(spline, i);
    for (Eigen::Index k = 0; k < gauss.nodes.size(); ++k)
      result.energy_per_mm3 +=
          gauss.weights(k) / 2 * variationDensity(piece.derivatives((1 + gauss.nodes(k)) / 2, 3));
    addProfile(result, piece, planar);
    const double after = slopeOfCurvature(piece.derivatives(0, 3), planar);
    if (before * after < 0) ++result.extrema_at_joints;
    before = slopeOfCurvature(piece.derivatives(1, 3), planar);
  }
  return result;
}

}  // namespace seamwright
