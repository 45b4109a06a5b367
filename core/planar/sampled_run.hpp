// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/planar/planar_curve.hpp>

/// A smooth part of a curve as samples, as dense as its arcs need. Not a public header.
namespace seamwright {

struct SampledRun {
  std::vector<Eigen::Vector2d> points;
  std::vector<double> parameters;  ///< of the curve
  std::vector<double> lengths_mm;  ///< along the polygon of the points
  /// How many samples up to each one turn to the left and to the right.
  std::vector<int> left, right;
  std::vector<double> scales_mm;  ///< the length of a free arc around each sample
  int free_arcs = 0;              ///< freeArcEnds() of the samples

  int last() const { return static_cast<int>(points.size()) - 1; }
};

/// A part of a curve by its parameters.
struct CurvePart {
  double begin = 0, end = 0;
};

/// Samples of one arc. A choice: twice as many save few arcs.
inline constexpr int arc_samples = 32;

/// \param density samples of a free arc.
SampledRun sampledRun(const PlanarCurve& curve, const CurvePart& part, double tolerance_mm,
                      int density);

}  // namespace seamwright
