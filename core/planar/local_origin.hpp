// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <seamwright/core/planar/biarc_spline.hpp>
#include <seamwright/core/planar/planar_chain.hpp>

/// Curves far from the origin, whose coordinates have more rounding than their shape needs.
namespace seamwright {

/// A point from which the coordinates of the points can be counted without rounding: x - origin is
/// exact for each of them. An axis along which the points are less than 1024 times as far from 0 as
/// they are apart keeps its 0, so near curves stay as they are.
///   (1) (x - origin) + origin = x, bitwise.
/// Source: docs/theory/planar.md P14.1.
Eigen::Vector2d localOrigin(const PlanarPoints& points);

/// The same for the ends of curves and the poles of splines. Poles of rational splines are rounded.
Eigen::Vector2d localOrigin(const PlanarChain& chain);

/// The chain moved by a vector.
PlanarChain moved(const PlanarChain& chain, const Eigen::Vector2d& by);

/// How far a point near the local origin is at most from its sum with it: half of the last digit in
/// both axes. 0 for the origin 0.
double roundingAt_mm(const Eigen::Vector2d& origin);

}  // namespace seamwright
