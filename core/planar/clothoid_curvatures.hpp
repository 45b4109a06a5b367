// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <seamwright/core/planar/biarc.hpp>
#include <seamwright/core/planar/clothoid.hpp>

/// Not a public header.
namespace seamwright {

/// The curvatures at both ends of a clothoid, and their derivatives by the directions there.
struct EndCurvatures {
  Eigen::Vector2d value_per_mm;
  Eigen::Matrix2d slope;  ///< row: end; column: direction at the start, at the end
};

/// \param piece clothoid() of ends with these angles. Source: docs/theory/planar.md P4.4.
EndCurvatures endCurvatures(const Clothoid& piece, const ChordAngles& angles);

}  // namespace seamwright
