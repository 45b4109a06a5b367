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
  /// The parameter of the path as a function of the position s on the seam: t[i] at s[i], linear
  /// between. s rises from 0 to 1, t rises or falls. See piecewise_map.hpp for t that is cubic.
  std::vector<double> s = {0, 1};
  std::vector<double> t = {0, 1};
  /// In the parameter plane the face lies to the left of the path, in the direction of increasing
  /// s.
  bool face_on_left = true;
};

}  // namespace seamwright
