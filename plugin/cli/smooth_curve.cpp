// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <seamwright/core/planar/clothoid_spline.hpp>
#include <seamwright/core/planar/fair_clothoids.hpp>
#include <seamwright/core/planar/point_corners.hpp>
#include <seamwright/plugin/cli/curve_figures.hpp>
#include <seamwright/plugin/cli/point_curves.hpp>
#include <seamwright/plugin/cli/smooth_curve.hpp>

namespace seamwright::cli {

PlanarChain chainOf(const std::vector<PlanarArc>& arcs, bool closed) {
  return {.curves = {arcs.begin(), arcs.end()}, .closed = closed};
}

SmoothCurve biarcsThrough(const GivenCurve& given) {
  const bool closed = given.record.closed;
  SmoothCurve curve{chainOf(biarcsOf(given.points, closed).arcs, closed)};
  curve.figures = figuresFrom(figuresOf(curve.chain));
  return curve;
}

SmoothCurve splineOf(const std::vector<Clothoid>& pieces, bool closed, double tolerance_mm) {
  double size_mm = 1;
  for (const Clothoid& piece : pieces) size_mm = std::max(size_mm, piece.start.norm());
  const SplineWithin spline = bezierSpline(pieces, tolerance_mm, closed, 1e-9 * size_mm);
  return {
      .chain = {.curves = {bsplineCurve(spline.curve, continuity(spline.curve))}, .closed = closed},
      .distance_mm = spline.distance_mm,
      .figures = figuresFrom(figuresOf(pieces, closed))};
}

SmoothCurve splinesBetween(std::vector<Clothoid> pieces, std::vector<std::ptrdiff_t> corners,
                           bool closed, double tolerance_mm) {
  const bool ring = closed && corners.empty();
  if (closed && !corners.empty()) {
    const std::ptrdiff_t first = corners.front();
    std::rotate(pieces.begin(), pieces.begin() + first, pieces.end());
    for (std::ptrdiff_t& corner : corners) corner -= first;
  } else {
    corners.insert(corners.begin(), 0);
  }
  corners.push_back(std::ssize(pieces));
  SmoothCurve result;
  result.chain.closed = closed;
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const std::vector<Clothoid> run(pieces.begin() + corners[k - 1], pieces.begin() + corners[k]);
    SmoothCurve spline = splineOf(run, ring, tolerance_mm);
    result.chain.curves.push_back(std::move(spline.chain.curves.front()));
    result.distance_mm = std::max(result.distance_mm, spline.distance_mm);
    addFigures(result.figures, spline.figures);
  }
  return result;
}

double gapOf(const GivenCurve& given, const PlanarChain& chain) {
  double size_mm = 0;
  for (const ChainCurve& curve : chain.curves)
    size_mm = std::max(
        {size_mm, startOf(curve).cwiseAbs().maxCoeff(), endOf(curve).cwiseAbs().maxCoeff()});
  return given.gap_mm + 1e-12 * (1 + size_mm);
}

void addFigures(report::CurveFigures& sum, const report::CurveFigures& part) {
  sum.length_mm += part.length_mm;
  sum.energy_per_mm = sum.energy_per_mm.value_or(0) + part.energy_per_mm.value_or(0);
  sum.extrema += part.extrema;
  sum.inflections += part.inflections;
}

std::vector<GivenCurve> runsOf(const GivenCurve& given, const std::vector<Eigen::Index>& corners) {
  const bool closed = given.record.closed;
  std::vector<GivenCurve> runs;
  for (const auto& run : runsBetween(given.points.rows(), corners, closed))
    runs.push_back(runOf(given, run, closed && corners.empty()));
  return runs;
}

report::CurveFigures biarcFigures(const GivenCurve& given,
                                  const std::vector<Eigen::Index>& corners) {
  report::CurveFigures sum;
  for (const GivenCurve& run : runsOf(given, corners)) addFigures(sum, biarcsThrough(run).figures);
  return sum;
}

GivenCurve runOf(const GivenCurve& given, const std::vector<Eigen::Index>& run, bool closed) {
  GivenCurve part;
  part.points = given.points(run, Eigen::indexing::all);
  part.rounding_mm = given.rounding_mm;
  part.gap_mm = given.gap_mm;
  part.record.closed = closed;
  return part;
}

}  // namespace seamwright::cli
