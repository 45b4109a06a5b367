// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
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

/// The runs of points from corner to corner. \param corners as of pointCorners().
std::vector<GivenCurve> runsOf(const GivenCurve& given, const std::vector<Eigen::Index>& corners);

/// The figures of the biarcs through each run.
report::CurveFigures biarcFigures(const GivenCurve& given,
                                  const std::vector<Eigen::Index>& corners);

/// A spline within a distance of clothoids.
SmoothCurve splineOf(const std::vector<Clothoid>& pieces, bool closed, double tolerance_mm);

/// A spline from corner to corner of clothoids; a closed curve begins at the first corner. \param
/// corners ascending: the pieces that begin at them.
SmoothCurve splinesBetween(std::vector<Clothoid> pieces, std::vector<std::ptrdiff_t> corners,
                           bool closed, double tolerance_mm);

/// Rounding of the ends of arcs and of coordinates in the plane.
double gapOf(const GivenCurve& given, const PlanarChain& chain);

/// The figures of a curve of several runs.
void addFigures(report::CurveFigures& sum, const report::CurveFigures& part);

/// One run of the points of a curve. \param closed whether the run is.
GivenCurve runOf(const GivenCurve& given, const std::vector<Eigen::Index>& run, bool closed);

}  // namespace seamwright::cli
