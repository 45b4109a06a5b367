// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/blend/spline_blend.hpp>
#include <vector>

/// Blends with the arguments that they are made of, so that they can be pickled.
namespace seamwright::python {

struct KeyedJointBlend {
  KeyedJointBlend(JointFrame first_frame, JointFrame second_frame, const JointBlendOptions& given)
      : first(std::move(first_frame)),
        second(std::move(second_frame)),
        options(given),
        blend(first, second, options) {}

  JointFrame first, second;
  JointBlendOptions options;
  JointBlend blend;
};

struct KeyedSplineBlend {
  KeyedSplineBlend(std::vector<BezierSpline> key_curves, std::vector<double> at,
                   const SplineBlendOptions& given)
      : keys(std::move(key_curves)),
        omegas(std::move(at)),
        options(given),
        blend(keys, omegas, options) {}

  std::vector<BezierSpline> keys;
  std::vector<double> omegas;
  SplineBlendOptions options;
  SplineBlend blend;
};

}  // namespace seamwright::python
