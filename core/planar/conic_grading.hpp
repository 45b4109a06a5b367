// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/planar/planar_curve.hpp>

/// How many conics lie near a curve, and how long each is; not a public header.
namespace seamwright {

/// A point of the curve through which the conics pass.
struct ConicPoint {
  double u = 0;
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  bool line_after = false;  ///< up to the next point
};

/// The points that an error of the fourth order asks for. Lengths change gradually from span to
/// span. Lines and their ends stay. \param distances_mm of the conics of each span from the curve
/// Source: docs/theory/planar.md P7.5.
std::vector<ConicPoint> regraded(const PlanarCurve& curve, const std::vector<ConicPoint>& points,
                                 const std::vector<double>& distances_mm, double tolerance_mm);

}  // namespace seamwright
