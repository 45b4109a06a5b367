// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <seamwright/core/planar/arc_distance.hpp>
#include <seamwright/core/planar/arc_run.hpp>
#include <seamwright/core/planar/free_arcs.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// The largest turn of one arc. It leaves room below 2 pi, where ends meet and chords vanish.
constexpr double most_turn_rad = 1.5 * std::numbers::pi;

/// Upper bound of the distance between an arc and a part of the curve that begins and ends beside
/// its ends; nothing if it is above the tolerance.
std::optional<double> distanceBetween(const PlanarCurve& curve, const CurvePart& range,
                                      const PlanarArc& arc, double tolerance_mm) {
  double distance_mm = 0, advance_mm = 0;
  for (int i = static_cast<int>(range.begin); i < curve.count() && i < range.end; ++i) {
    const Interval domain = {std::max(range.begin - i, 0.0), std::min(range.end - i, 1.0)};
    if (!(domain.width() > 0)) continue;
    const std::optional<AlongCircle> along = besideArc(
        {.polynomials = curve.polynomials[i], .origin = curve.origins[i], .domain = domain}, arc,
        tolerance_mm, advance_mm);
    if (!along) return std::nullopt;
    distance_mm = std::max(distance_mm, along->distance_mm);
    advance_mm += along->advance_mm;
  }
  // Where one ends before the other, the rest is that far from the end.
  distance_mm += std::abs(advance_mm - arc.length_mm);
  return distance_mm <= tolerance_mm ? std::optional(distance_mm) : std::nullopt;
}

/// Where the curve crosses the normal of the arcs at their joint.
double crossingOf(const PlanarCurve& curve, const CurvePart& range, const PlanarArc& second) {
  double u0 = range.begin, u1 = range.end;
  const Vector2d tangent = unitVector(second.direction_rad);
  for (int i = 0; i < std::numeric_limits<double>::digits; ++i) {
    const double middle = 0.5 * (u0 + u1);
    const double ahead = (curve.at(middle).point - second.start).dot(tangent);
    (ahead < 0 ? u0 : u1) = middle;
  }
  return 0.5 * (u0 + u1);
}

}  // namespace

std::optional<FittedPart> fittedPart(const PlanarCurve& curve, const CurvePart& range,
                                     const HermiteEnds& ends, double tolerance_mm) {
  if (ends.start == ends.end) return std::nullopt;
  const PlanarArc whole = arcThrough(ends.start, ends.start_direction_rad, ends.end);
  // An angle that rounding causes in the tangents of a curve.
  constexpr double same_direction_rad = 1e-10;
  const double off_rad = wrapped(whole.endDirection_rad() - ends.end_direction_rad);
  if (std::abs(off_rad) <= same_direction_rad && std::abs(whole.sweep_rad()) <= most_turn_rad) {
    if (const auto distance_mm = distanceBetween(curve, range, whole, tolerance_mm))
      return FittedPart{.arcs = {whole}, .distance_mm = *distance_mm};
  }
  const ChordAngles angles = chordAngles(ends);
  if (std::abs(angles.alpha_rad + angles.beta_rad) > most_turn_rad) return std::nullopt;
  const Biarc pair = biarc(ends);
  const double joint = crossingOf(curve, range, pair.second);
  const auto first = distanceBetween(curve, {range.begin, joint}, pair.first, tolerance_mm);
  if (!first) return std::nullopt;
  const auto second = distanceBetween(curve, {joint, range.end}, pair.second, tolerance_mm);
  if (!second) return std::nullopt;
  return FittedPart{.arcs = {pair.first, pair.second}, .distance_mm = std::max(*first, *second)};
}

namespace {

/// A part with the parameter and direction at which the next one begins.
struct FittedStep {
  FittedPart part;
  double end = 0;
  double end_direction_rad = 0;
};

/// Arcs from a point of the run to the point at u1.
std::optional<FittedStep> stepTo(const PlanarCurve& curve, const SmoothRun& run, double u0,
                                 double direction_rad, double u1, double tolerance_mm) {
  const Vector2d start = curve.at(u0).point;
  if (u1 >= run.range.end) {
    const HermiteEnds ends = {.start = start,
                              .start_direction_rad = direction_rad,
                              .end = run.ends.end.point,
                              .end_direction_rad = *run.ends.end.direction_rad};
    std::optional<FittedPart> part = fittedPart(curve, {u0, run.range.end}, ends, tolerance_mm);
    if (!part) return std::nullopt;
    return FittedStep{.part = std::move(*part),
                      .end = run.range.end,
                      .end_direction_rad = *run.ends.end.direction_rad};
  }
  const CurveFrame frame = curve.at(u1);
  // docs/theory/planar.md P9.2: the ideal chain is rotated by k' l^2 / 12 where it crosses the
  // curve, l being the length of an arc, and by not more than 10.4 of its tolerances over l.
  const double arc_mm = (frame.point - start).norm() / 2;
  if (!(arc_mm > 0)) return std::nullopt;
  const double most_rad = 10.4 * tolerance_mm / arc_mm;
  const double ideal_rad =
      std::clamp(-frame.curvature_slope_per_mm2 * arc_mm * arc_mm / 12, -most_rad, most_rad);
  for (const double rotation_rad : {ideal_rad, 0.0}) {
    const HermiteEnds ends = {.start = start,
                              .start_direction_rad = direction_rad,
                              .end = frame.point,
                              .end_direction_rad = frame.direction_rad + rotation_rad};
    std::optional<FittedPart> part = fittedPart(curve, {u0, u1}, ends, tolerance_mm);
    if (part)
      return FittedStep{
          .part = std::move(*part), .end = u1, .end_direction_rad = ends.end_direction_rad};
  }
  return std::nullopt;
}

/// The longest step that is found by doubling and halving its length.
FittedStep longestStep(const PlanarCurve& curve, const SmoothRun& run, double u0,
                       double direction_rad, double guess, double tolerance_mm) {
  const auto attempt = [&](double u1) {
    return stepTo(curve, run, u0, direction_rad, u1, tolerance_mm);
  };
  if (auto whole = attempt(run.range.end)) return *whole;
  std::optional<FittedStep> best;
  double reach = std::min(guess, (run.range.end - u0) / 2), fails = run.range.end - u0;
  while (!(best = attempt(u0 + reach))) {
    fails = reach;
    reach /= 2;
    // A share of a segment: below it the chord is a billionth of the curve, and rounding disturbs
    // its direction.
    constexpr double shortest = 0x1p-30;
    if (reach < shortest) {
      const Vector2d point = curve.point(u0);
      throw std::domain_error(
          fmt::format("no arc keeps the tolerance {:.6g} mm at ({:.6g}, {:.6g}): the curve turns "
                      "back there, or the tolerance is below its rounding",
                      tolerance_mm, point.x(), point.y()));
    }
  }
  while (2 * reach < fails) {
    auto longer = attempt(u0 + 2 * reach);
    if (!longer) {
      fails = 2 * reach;
      break;
    }
    best = std::move(longer);
    reach *= 2;
  }
  // The last digits of the length save no arc.
  constexpr double resolution = 1.0 / 128;
  while (fails - reach > resolution * reach) {
    const double middle = 0.5 * (reach + fails);
    if (auto longer = attempt(u0 + middle)) {
      best = std::move(longer);
      reach = middle;
    } else {
      fails = middle;
    }
  }
  return *best;
}

}  // namespace

std::optional<FittedPart> proven(const PlanarCurve& curve, double begin, const PlacedArcs& placed,
                                 double tolerance_mm) {
  FittedPart part{.arcs = placed.arcs};
  for (std::size_t i = 0; i < placed.arcs.size(); ++i) {
    const CurvePart& range = placed.ends[i];
    const double end =
        range.begin < range.end ? crossingOf(curve, range, placed.arcs[i + 1]) : range.end;
    const auto distance_mm = distanceBetween(curve, {begin, end}, placed.arcs[i], tolerance_mm);
    if (!distance_mm) return std::nullopt;
    part.distance_mm = std::max(part.distance_mm, *distance_mm);
    begin = end;
  }
  return part;
}

FittedPart greedyArcs(const PlanarCurve& curve, const SmoothRun& run, double tolerance_mm,
                      const Progress& progress) {
  FittedPart result;
  double u = run.range.begin, direction_rad = *run.ends.begin.direction_rad, guess = 1;
  while (u < run.range.end) {
    checkProgress(progress, u / curve.count());
    const FittedStep step = longestStep(curve, run, u, direction_rad, guess, tolerance_mm);
    result.append(step.part);
    guess = step.end - u;
    u = step.end;
    direction_rad = step.end_direction_rad;
  }
  return result;
}

std::optional<FittedPart> fewArcsBeside(const PlanarCurve& curve, const SmoothRun& run,
                                        const SampledRun& sampled, double tolerance_mm,
                                        const Progress& progress) {
  // The samples miss the largest distance by about half a percent of the tolerance; where the curve
  // waves by more, denser ones are needed.
  struct Attempt {
    double share = 0;
    int density = 1;
  };
  for (const auto& [share, density] :
       {Attempt{0.99, 1}, Attempt{0.97, 1}, Attempt{0.95, 2}, Attempt{0.9, 4}}) {
    const ArcSearchOptions options{.tolerance_mm = share * tolerance_mm,
                                   .most_turn_rad = most_turn_rad};
    const SampledRun samples =
        density == 1 ? sampled : sampledRun(curve, run.range, tolerance_mm, density * arc_samples);
    const auto arcs = fewArcs(samples, run.ends, options, progress);
    if (!arcs) return std::nullopt;
    if (auto part = proven(curve, run.range.begin, *arcs, tolerance_mm)) return part;
  }
  return std::nullopt;
}

std::optional<FittedPart> lineBeside(const PlanarCurve& curve, const SmoothRun& run,
                                     double tolerance_mm) {
  const RunEnd &begin = run.ends.begin, &end = run.ends.end;
  if (begin.direction_rad || end.direction_rad || begin.point == end.point) return std::nullopt;
  const Vector2d chord = end.point - begin.point;
  const PlanarArc line{
      .start = begin.point, .direction_rad = directionOf(chord), .length_mm = chord.norm()};
  const auto distance_mm = distanceBetween(curve, run.range, line, tolerance_mm);
  if (!distance_mm) return std::nullopt;
  return FittedPart{.arcs = {line}, .distance_mm = *distance_mm};
}

std::optional<FittedPart> circleBeside(const PlanarCurve& curve, const SampledRun& sampled,
                                       double tolerance_mm) {
  const std::vector<Vector2d> points(sampled.points.begin(), sampled.points.end() - 1);
  ArcStart start = nearestCircle(points, points.front());
  if (start.curvature_per_mm == 0) return std::nullopt;
  double twice_area = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    twice_area += cross(points[i - 1] - points.front(), points[i] - points.front());
  if (twice_area * start.curvature_per_mm < 0) {
    start.direction_rad = wrapped(start.direction_rad + std::numbers::pi);
    start.curvature_per_mm = -start.curvature_per_mm;
  }
  const PlanarArc circle{.start = start.point,
                         .direction_rad = start.direction_rad,
                         .curvature_per_mm = start.curvature_per_mm,
                         .length_mm = 2 * std::numbers::pi / std::abs(start.curvature_per_mm)};
  const CurvePart range{.begin = 0, .end = static_cast<double>(curve.count())};
  const auto distance_mm = distanceBetween(curve, range, circle, tolerance_mm);
  if (!distance_mm) return std::nullopt;
  return FittedPart{.arcs = {circle}, .distance_mm = *distance_mm};
}

namespace {

struct RunHalves {
  SmoothRun first, second;
};

/// They meet on the curve and have its direction there.
RunHalves halvesOf(const PlanarCurve& curve, const SmoothRun& run, const SampledRun& sampled) {
  const double middle = sampled.parameters[sampled.last() / 2];
  const CurveFrame frame = curve.at(middle);
  const RunEnd joint{.point = frame.point, .direction_rad = frame.direction_rad};
  return {.first = {.range = {.begin = run.range.begin, .end = middle},
                    .ends = {.begin = run.ends.begin, .end = joint}},
          .second = {.range = {.begin = middle, .end = run.range.end},
                     .ends = {.begin = joint, .end = run.ends.end}}};
}

FittedPart arcsOfHalves(const PlanarCurve& curve, const SmoothRun& run, const SampledRun& sampled,
                        double tolerance_mm, const Progress& progress, int halvings) {
  // Choices: each half costs about one arc, and each halving a search.
  constexpr int least_free_arcs = 8, most_halvings = 5;
  if (sampled.free_arcs < least_free_arcs || halvings == most_halvings)
    return greedyArcs(curve, run, tolerance_mm, progress);
  const RunHalves halves = halvesOf(curve, run, sampled);
  FittedPart result;
  for (const SmoothRun& half : {halves.first, halves.second}) {
    const SampledRun samples = sampledRun(curve, half.range, tolerance_mm, arc_samples);
    const auto part = fewArcsBeside(curve, half, samples, tolerance_mm, progress);
    result.append(part ? *part
                       : arcsOfHalves(curve, half, samples, tolerance_mm, progress, halvings + 1));
  }
  return result;
}

}  // namespace

FittedPart arcsOfHalves(const PlanarCurve& curve, const SmoothRun& run, const SampledRun& sampled,
                        double tolerance_mm, const Progress& progress) {
  return arcsOfHalves(curve, run, sampled, tolerance_mm, progress, 0);
}

}  // namespace seamwright
