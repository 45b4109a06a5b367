// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>

#include <seamwright/core/bezier/curve.hpp>

/// The length that makes the defects of a joint dimensionless; not a public header.
namespace seamwright {

struct CurveExtent {
  double chord;     ///< distance of the end points
  double diagonal;  ///< of the box of poles

  /// The distance of the ends is at most 1e-12 of the size.
  bool closed() const { return chord <= 1e-12 * diagonal; }
};

inline CurveExtent extentOf(const Poles& poles, const Eigen::RowVector3d& first,
                            const Eigen::RowVector3d& last) {
  return {(last - first).stableNorm(),
          (poles.colwise().maxCoeff() - poles.colwise().minCoeff()).stableNorm()};
}

/// The extent of a curve that begins and ends at poles.
inline CurveExtent extentOf(const Poles& poles) {
  return extentOf(poles, poles.row(0), poles.bottomRows<1>());
}

/// BetaFit::length_mm if no length is given.
inline double jointLength(const CurveExtent& a, const CurveExtent& b) {
  if (!a.closed() && !b.closed()) return std::min(a.chord, b.chord);
  if (a.closed() && b.closed()) return std::min(a.diagonal, b.diagonal);
  return a.closed() ? b.chord : a.chord;
}

}  // namespace seamwright
