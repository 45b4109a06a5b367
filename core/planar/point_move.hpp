// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/planar/biarc_spline.hpp>

/// Not a public header.
namespace seamwright {

/// The point, or one on the way back to \p original that is certainly not further away than the
/// tolerance: rounding of large coordinates can exceed it.
inline Eigen::RowVector2d withinDistance(Eigen::RowVector2d point,
                                         const Eigen::RowVector2d& original, double tolerance_mm) {
  for (double back = 0x1p-50; (point - original).norm() > tolerance_mm && back < 1; back *= 2)
    point = original + (1 - back) * (point - original);
  return (point - original).norm() <= tolerance_mm ? point : original;
}

/// Unit vectors along which points move.
struct MoveNormals {
  PlanarPoints vectors;
  /// Whether neighbours of some point are so near that moves within the tolerance could fold the
  /// polygon.
  bool crowded = false;
};

/// The normal of the chord of the neighbours of each point, one to the left. The errors of crowded
/// points turn that chord, and moves along its normal would pass neighbours; there the normal is
/// that of a longer chord. At open ends chords begin or end at the point itself.
/// \pre three neighbours differ.
/// Source: docs/theory/planar.md P10.8.
MoveNormals moveNormals(const PlanarPoints& points, const Eigen::VectorXd& tolerances_mm,
                        bool closed);

/// \throws std::invalid_argument unless there is a tolerance for each point, at least 0 and finite.
void requireTolerances(const Eigen::VectorXd& tolerances_mm, Eigen::Index count);

}  // namespace seamwright
