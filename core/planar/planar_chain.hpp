// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

#include <seamwright/core/bspline/curve.hpp>
#include <seamwright/core/planar/arc.hpp>
#include <seamwright/core/planar/conic.hpp>
#include <seamwright/core/progress.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

/// Planar curves of several kinds end to end: an outline of lines, arcs, conics and splines.
namespace seamwright {

/// A curve of the plane in the form that is exact for its kind. A spline lies in the plane z = 0.
using ChainCurve = std::variant<PlanarArc, PlanarConic, BSplineCurve>;

/// Curves end to end. The end of a closed chain is its beginning.
struct PlanarChain {
  std::vector<ChainCurve> curves;
  bool closed = false;
};

Eigen::Vector2d startOf(const ChainCurve& curve);
Eigen::Vector2d endOf(const ChainCurve& curve);

/// The same points in the other direction.
///   (1) Reversing twice gives the curve, up to rounding.
ChainCurve reversed(const ChainCurve& curve);

/// The curve in Bézier form in the plane z = 0, exactly: arcs by planar.md P1.3. Spans of a spline
/// that are points are left out.
std::vector<BezierCurve> bezierCurves(const ChainCurve& curve);

/// The chain as one spline with the lengths of the control polygons as knots. The end of each curve
/// is replaced by the start of the next one, so the spline has no gaps.
///   (2) Points of the spline are points of the curves, except for the gaps that were closed.
/// \throws std::invalid_argument for an empty chain and for gaps above \p gap_mm, with the joint.
BezierSpline bezierSpline(const PlanarChain& chain, double gap_mm);

/// What describes the shape of a chain.
struct ChainFigures {
  double length_mm = 0;
  /// Integral of the squared curvature by arc length. It is infinite where poles at an end of a
  /// Bézier curve are equal and the curvature grows too fast there, as of a t^2 + b t^3.
  double energy_per_mm = 0;
  /// Local extrema of the curvature and changes of its sign along the chain, from corner to corner:
  /// where the tangent turns by more than 1e-3 rad, the curvature begins again. Jumps of the
  /// curvature between curves count; so does the joint that closes a chain. Differences below a
  /// billionth of the largest curvature, or of one over the length, do not.
  int extrema = 0, inflections = 0;
};

/// Length and energy of arcs are in closed form, those of other curves by Gauss' quadrature.
///   (3) A circle has the length 2 pi r, the energy 2 pi / r, no extremum and no inflection.
///   (4) An ellipse has 4 extrema.
///   (5) Those of a chain with corners are the sums of those of its parts between them.
/// \throws std::domain_error if a curve may stop inside of a span, as planarCurvatureProfile().
/// Throws Cancelled, see Progress; it is called before each curve and each span of a spline.
ChainFigures figuresOf(const PlanarChain& chain, const Progress& progress = {});

/// Local extrema and changes of sign of a sequence of curvatures. Differences and curvatures up to
/// \p negligible do not count.
struct SequenceTurns {
  int extrema = 0, inflections = 0;
};
SequenceTurns turnsOf(const std::vector<double>& curvatures_per_mm, bool closed,
                      double negligible_per_mm);

}  // namespace seamwright
