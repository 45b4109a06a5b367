// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc_clothoids.hpp>
#include <seamwright/core/planar/arc_fit.hpp>
#include <seamwright/core/planar/clothoid_fit.hpp>
#include <seamwright/core/planar/clothoid_spline.hpp>
#include <seamwright/core/planar/fair_clothoids.hpp>
#include <seamwright/core/planar/fit_options.hpp>
#include <seamwright/core/planar/planar_curve.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// The circle through three points, as an arc that begins at the first one. It is a line if they
/// are on one.
PlanarArc circleThrough(const Vector2d& start, const Vector2d& middle, const Vector2d& end) {
  const Vector2d chord = end - start;
  const double turn_rad = angleFromTo(middle - start, end - middle);
  return arcThrough(start, directionOf(chord) - turn_rad, end);
}

std::optional<double> ofClothoid(const Clothoid& clothoid, const PlanarArc& arc,
                                 double tolerance_mm) {
  // The quintic form costs little of the tolerance.
  constexpr double share = 1e-3;
  const SplineWithin quintics = bezierSpline({clothoid}, share * tolerance_mm, false, 0);
  const PlanarCurve curve = planarCurve(quintics.curve);
  const auto along = alongCircle(curve, {0, static_cast<double>(curve.count())}, arc,
                                 tolerance_mm - quintics.distance_mm);
  if (!along) return std::nullopt;
  return along->distance_mm + quintics.distance_mm;
}

/// Upper bound of the distance of a clothoid from the part of the curve between the same points.
std::optional<double> clothoidDistance(const PlanarCurve& curve, const Interval& range,
                                       const Clothoid& clothoid, double tolerance_mm) {
  const Vector2d start = curve.point(range.lower), middle = curve.point(range.middle()),
                 end = curve.point(range.upper);
  if (start == middle || middle == end || start == end) return std::nullopt;
  const PlanarArc arc = circleThrough(start, middle, end);
  const auto first = alongCircle(curve, range, arc, tolerance_mm);
  if (!first) return std::nullopt;
  const auto second = ofClothoid(clothoid, arc, tolerance_mm);
  if (!second) return std::nullopt;
  // The spline meets the points up to rounding of its length.
  const double rounding_mm = (clothoid.start - start).norm() + (clothoid.end() - end).norm();
  const double sum_mm = first->distance_mm + *second + rounding_mm;
  return sum_mm <= tolerance_mm ? std::optional(sum_mm) : std::nullopt;
}

/// A part of the curve between corners.
struct ClothoidRun {
  int begin = 0, end = 0;  ///< segments
  bool closed = false;
};

struct FittedRun {
  std::vector<Clothoid> pieces;
  double distance_mm = 0;
};

std::optional<ClothoidSpline> splineThrough(const PlanarCurve& curve, const ClothoidRun& run,
                                            const std::vector<double>& parameters,
                                            const Progress& progress) {
  const std::size_t count = parameters.size() - (run.closed ? 1 : 0);
  PlanarPoints points(static_cast<Eigen::Index>(count), 2);
  for (std::size_t i = 0; i < count; ++i)
    points.row(static_cast<Eigen::Index>(i)) = curve.point(parameters[i]).transpose();
  for (Eigen::Index i = 1; i < points.rows(); ++i)
    if (points.row(i) == points.row(i - 1)) return std::nullopt;
  ClothoidSplineOptions options{.closed = run.closed, .start = {}, .end = {}};
  if (!run.closed) {
    options.start.direction_rad = curve.direction_rad(run.begin, 0);
    options.end.direction_rad = curve.direction_rad(run.end - 1, 1);
  }
  try {
    return clothoidSpline(points, options, progress);
  } catch (const std::domain_error&) {  // points are too far apart for the turn between them
    return std::nullopt;
  }
}

[[noreturn]] void refuseTurnBack(const Vector2d& point, double tolerance_mm) {
  throw std::domain_error(
      fmt::format("no clothoids keep the tolerance {:.6g} mm at ({:.6g}, {:.6g}): the curve turns "
                  "back there, or the tolerance is below its rounding",
                  tolerance_mm, point.x(), point.y()));
}

FittedRun splineRun(const PlanarCurve& curve, const ClothoidRun& run, double tolerance_mm,
                    const Progress& progress) {
  // Four pieces of a closed run turn by a right angle each.
  const int first_pieces = run.closed ? 4 : 1;
  std::vector<double> parameters;
  for (int i = 0; i <= first_pieces; ++i)
    parameters.push_back(run.begin + static_cast<double>(i) * (run.end - run.begin) / first_pieces);
  constexpr double shortest = 0x1p-20;
  for (int round = 0;; ++round) {
    const Progress of_round = partOf(progress, shareAfter(round), shareAfter(round));
    const std::optional<ClothoidSpline> spline = splineThrough(curve, run, parameters, of_round);
    FittedRun result;
    std::vector<double> finer = {parameters.front()};
    for (std::size_t i = 0; i + 1 < parameters.size(); ++i) {
      checkProgress(of_round, 0);
      const Interval range = {parameters[i], parameters[i + 1]};
      std::optional<double> distance_mm;
      if (spline) distance_mm = clothoidDistance(curve, range, spline->pieces[i], tolerance_mm);
      if (distance_mm) {
        result.distance_mm = std::max(result.distance_mm, *distance_mm);
      } else {
        if (range.width() < shortest) refuseTurnBack(curve.point(range.lower), tolerance_mm);
        finer.push_back(range.middle());
      }
      finer.push_back(range.upper);
    }
    if (finer.size() == parameters.size()) {
      result.pieces = spline->pieces;
      return result;
    }
    parameters = std::move(finer);
  }
}

BezierSpline splineOf(const BezierSpline& curve, const ClothoidRun& run) {
  const int count = run.end - run.begin;
  return {.degree = curve.degree,
          .knots = {curve.knots.begin() + run.begin, curve.knots.begin() + run.end + 1},
          .poles = curve.poles.middleRows(run.begin * curve.degree, count * curve.degree + 1),
          .closed = run.closed};
}

/// Clothoids near arcs near the run.
struct TransitionRun {
  FittedRun fitted;
  /// The arcs are the run itself, up to a small share of the tolerance.
  bool of_arcs = false;
};

std::optional<TransitionRun> transitionRun(const BezierSpline& run,
                                           const ClothoidFitOptions& options,
                                           const Progress& progress) {
  // Choices: transitions move arcs near a curve by less than the curve is away from them.
  constexpr double share = 0.55, small_share = 1e-3;
  try {
    const ArcFit fit = fitArcs(
        run, {.tolerance_mm = share * options.tolerance_mm, .corner_rad = options.corner_rad},
        partOf(progress, 0, 0.5));
    ArcClothoids found = clothoidsNear(fit.arcs, fit.closed, options.tolerance_mm - fit.distance_mm,
                                       partOf(progress, 0.5, 1));
    return TransitionRun{.fitted = {.pieces = std::move(found.pieces),
                                    .distance_mm = found.distance_mm + fit.distance_mm},
                         .of_arcs = fit.distance_mm <= small_share * options.tolerance_mm};
  } catch (const std::domain_error&) {  // a spline through points may still be possible
    return std::nullopt;
  }
}

int turnsIn(const FittedRun& fitted, bool closed) {
  const ClothoidFigures figures = figuresOf(fitted.pieces, closed);
  return figures.extrema + figures.inflections;
}

/// Transitions where the run is a chain of arcs and lines; else these or the spline through points,
/// whichever has fewer extrema and inflections.
FittedRun fitClothoidRun(const BezierSpline& spline, const PlanarCurve& curve,
                         const ClothoidRun& run, const ClothoidFitOptions& options,
                         const Progress& progress) {
  std::optional<TransitionRun> near_arcs =
      transitionRun(splineOf(spline, run), options, partOf(progress, 0, 0.5));
  if (near_arcs && near_arcs->of_arcs) return std::move(near_arcs->fitted);
  try {
    FittedRun through_points =
        splineRun(curve, run, options.tolerance_mm, partOf(progress, 0.5, 1));
    if (!near_arcs || turnsIn(through_points, run.closed) <= turnsIn(near_arcs->fitted, run.closed))
      return through_points;
  } catch (const std::domain_error&) {
    if (!near_arcs) throw;
  }
  return std::move(near_arcs->fitted);
}

}  // namespace

ClothoidFit fitClothoids(const BezierSpline& spline, const ClothoidFitOptions& options,
                         const Progress& progress) {
  requireValid(spline);
  requireFitOptions(options.tolerance_mm, options.corner_rad);
  const PlanarCurve curve = planarCurve(spline);
  const int n = curve.count();
  const auto isCorner = [&](int joint) {
    const double turn_rad =
        curve.direction_rad(joint % n, 0) - curve.direction_rad((joint + n - 1) % n, 1);
    return std::abs(wrapped(turn_rad)) > options.corner_rad;
  };
  ClothoidFit result = {.pieces = {}, .corners = {}, .closed = spline.closed};
  std::vector<int> cuts;
  for (int joint = 1; joint < n; ++joint)
    if (isCorner(joint)) cuts.push_back(joint);
  const bool smooth = cuts.empty() && spline.closed && !isCorner(0);
  cuts.insert(cuts.begin(), 0);
  cuts.push_back(n);
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    // A closed curve without a corner at its beginning gets none: both runs there have its tangent.
    if (i > 1 || (spline.closed && !smooth && isCorner(0)))
      result.corners.push_back(static_cast<int>(result.pieces.size()));
    const double whole = n;
    const FittedRun fitted =
        fitClothoidRun(spline, curve, {.begin = cuts[i - 1], .end = cuts[i], .closed = smooth},
                       options, partOf(progress, cuts[i - 1] / whole, cuts[i] / whole));
    result.pieces.insert(result.pieces.end(), fitted.pieces.begin(), fitted.pieces.end());
    result.distance_mm = std::max(result.distance_mm, fitted.distance_mm);
  }
  return result;
}

}  // namespace seamwright
