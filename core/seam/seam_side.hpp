// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <vector>

#include <seamwright/core/enclosure/surface.hpp>

namespace seamwright {

/// One side of a seam: a surface along a path of its parameter plane.
struct SeamSide {
  CurveEvaluator path;
  std::shared_ptr<const SurfaceEvaluator> surface;
  /// The path's parameter as a piecewise linear function of the place on the seam: t[i] at s[i]; s
  /// increases from 0 to 1, t increases or decreases.
  std::vector<double> s = {0, 1};
  std::vector<double> t = {0, 1};
  /// The face lies to the left of the path in the sense of s, in the parameter plane.
  bool face_on_left = true;
};

}  // namespace seamwright
