// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <seamwright/core/planar/clothoid_spline.hpp>
#include <seamwright/core/planar/fair_clothoids.hpp>
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

GivenCurve runOf(const GivenCurve& given, const std::vector<Eigen::Index>& run, bool closed) {
  GivenCurve part;
  part.points = given.points(run, Eigen::indexing::all);
  part.rounding_mm = given.rounding_mm;
  part.gap_mm = given.gap_mm;
  part.record.closed = closed;
  return part;
}

}  // namespace seamwright::cli
