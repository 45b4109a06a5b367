// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/fair/curvature_variation.hpp>
#include <seamwright/core/fair/profile_sum.hpp>
#include <seamwright/core/fair/variation_quadrature.hpp>

namespace seamwright {

CurvatureVariation variationOf(const BezierSpline& spline) {
  requireValid(spline);
  ProfileSum profiles{.planar = (spline.poles.col(2).array() == 0).all()};
  CurvatureVariation result;
  for (int i = 0; i < spline.segments(); ++i) {
    const BezierCurve piece = segment(spline, i);
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
