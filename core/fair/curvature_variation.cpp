// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include <seamwright/core/fair/curvature_variation.hpp>
#include <seamwright/core/fair/profile_sum.hpp>
#include <seamwright/core/linear/gauss_rule.hpp>
#include <seamwright/core/numeric.hpp>

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

void requireNoPoint(const BezierCurve& piece, int index) {
  const Poles poles = piece.poles();
  if ((poles.rowwise() - poles.row(0)).isZero(0))
    refuse(fmt::format("segment {} is the point ({}, {}, {}), which has no curvature", index,
                       poles(0, 0), poles(0, 1), poles(0, 2)));
}

}  // namespace

CurvatureVariation variationOf(const BezierSpline& spline) {
  requireValid(spline);
  ProfileSum profiles{.planar = (spline.poles.col(2).array() == 0).all()};
  const GaussRule gauss = gaussRule(8);
  CurvatureVariation result;
  for (int i = 0; i < spline.segments(); ++i) {
    const BezierCurve piece = segment(spline, i);
    requireNoPoint(piece, i);
    for (std::size_t k = 0; k < gauss.nodes.size(); ++k)
      result.energy_per_mm3 +=
          gauss.weights[k] * variationDensity(piece.derivatives(gauss.nodes[k], 3));
    profiles.add(piece);
  }
  result.extrema = profiles.extrema;
  result.extrema_at_joints = profiles.extrema_at_joints;
  result.inflections = profiles.inflections;
  result.undecided_segments = profiles.undecided;
  return result;
}

}  // namespace seamwright
