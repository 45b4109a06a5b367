// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/planar/arc.hpp>
#include <seamwright/plugin/cli/curve_methods.hpp>
#include <vector>

/// The curves that the methods start from.
namespace seamwright::cli {

PlanarChain chainOf(const std::vector<PlanarArc>& arcs, bool closed);

/// The curve that is approximated, and its distance from the one that was asked for.
struct SmoothCurve {
  PlanarChain chain;
  double distance_mm = 0;
  report::CurveFigures figures = {};
};

SmoothCurve biarcsThrough(const GivenCurve& given);

/// A spline within a distance of clothoids.
SmoothCurve splineOf(const std::vector<Clothoid>& pieces, bool closed, double tolerance_mm);

/// Rounding of the ends of arcs and of coordinates in the plane.
double gapOf(const GivenCurve& given, const PlanarChain& chain);

/// The figures of a curve of several runs.
void addFigures(report::CurveFigures& sum, const report::CurveFigures& part);

/// One run of the points of a curve. \param closed whether the run is.
GivenCurve runOf(const GivenCurve& given, const std::vector<Eigen::Index>& run, bool closed);

}  // namespace seamwright::cli
