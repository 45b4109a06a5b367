// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <seamwright/core/fair/curvature_variation.hpp>
#include <seamwright/core/fair/profile_sum.hpp>
#include <seamwright/core/fair/variation_quadrature.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

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
  CurvatureVariation result;
  for (int i = 0; i < spline.segments(); ++i) {
    const BezierCurve piece = segment(spline, i);
    requireNoPoint(piece, i);
    result.energy_per_mm3 += variationOf(piece).energy_per_mm3;
    profiles.add(piece);
  }
  result.extrema = profiles.extrema;
  result.extrema_at_joints = profiles.extrema_at_joints;
  result.inflections = profiles.inflections;
  result.undecided_segments = profiles.undecided;
  return result;
}

}  // namespace seamwright
