// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/occ_adapter/blend/blend_surface.hpp>

/// Not a public header.
namespace seamwright::occ {

/// How a lateral boundary is run through: the polynomial s(v) from 0 to 1, the share of its length,
/// of degree m + n + 1 for the orders m and n of the ends. Its first derivative at an end of an
/// order above 0 is the tension; the higher ones, up to the order, vanish.
class LateralPace {
 public:
  /// \throws std::invalid_argument where it turns back, with the tensions.
  LateralPace(const BlendEnd& start, const BlendEnd& end);

  double shareAt(double v) const { return curve_.point(v).x(); }
  double parameterOf(double share) const;
  /// From 0 at the start to 1 at the end; the derivatives up to the orders vanish.
  double closing(double v) const { return curve_.point(v).y(); }

 private:
  BezierCurve curve_;  ///< share and closing as coordinates
};

}  // namespace seamwright::occ
