// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc_distance.hpp>
#include <seamwright/core/planar/arc_fit.hpp>
#include <seamwright/core/planar/biarc.hpp>
#include <seamwright/core/planar/fit_options.hpp>
#include <seamwright/core/planar/planar_curve.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// The largest turn of one arc. It leaves room below 2 pi, where ends meet and chords vanish.
constexpr double most_turn_rad = 1.5 * std::numbers::pi;

/// Arcs beside a part of the curve.
struct FittedPart {
  std::vector<PlanarArc> arcs;
  double distance_mm = 0;
};

/// Upper bound of the distance between an arc and the part of the curve from u0 to u1; nothing if
/// it is above the tolerance or if the part does not run along the arc.
std::optional<double> distanceBetween(const PlanarCurve& curve, double u0, double u1,
                                      const PlanarArc& arc, double tolerance_mm) {
  double distance_mm = 0, advance_mm = 0;
  for (int i = static_cast<int>(u0); i < curve.count() && i < u1; ++i) {
    const Interval domain = {std::max(u0 - i, 0.0), std::min(u1 - i, 1.0)};
    if (!(domain.width() > 0)) continue;
    const std::optional<AlongCircle> along = alongCircle(
        {.polynomials = curve.polynomials[i], .origin = curve.origins[i], .domain = domain}, arc,
        tolerance_mm);
    if (!along) return std::nullopt;
    distance_mm = std::max(distance_mm, along->distance_mm);
    advance_mm += along->advance_mm;
  }
  // Where one ends before the other, the rest is that far from the end.
  distance_mm += std::abs(advance_mm - arc.length_mm);
  return distance_mm <= tolerance_mm ? std::optional(distance_mm) : std::nullopt;
}

/// Where the curve crosses the normal of the arcs at their joint.
double crossingOf(const PlanarCurve& curve, double u0, double u1, const PlanarArc& second) {
  const Vector2d tangent = unitVector(second.direction_rad);
  for (int i = 0; i < std::numeric_limits<double>::digits; ++i) {
    const double middle = 0.5 * (u0 + u1);
    const double ahead = (curve.at(middle).point - second.start).dot(tangent);
    (ahead < 0 ? u0 : u1) = middle;
  }
  return 0.5 * (u0 + u1);
}

/// One arc or two between points of the curve, with these directions there.
std::optional<FittedPart> fittedPart(const PlanarCurve& curve, double u0, double u1,
                                     const HermiteEnds& ends, double tolerance_mm) {
  if (ends.start == ends.end) return std::nullopt;
  const PlanarArc whole = arcThrough(ends.start, ends.start_direction_rad, ends.end);
  // An angle that rounding causes in the tangents of a curve.
  constexpr double same_direction_rad = 1e-10;
  const double off_rad = wrapped(whole.endDirection_rad() - ends.end_direction_rad);
  if (std::abs(off_rad) <= same_direction_rad && std::abs(whole.sweep_rad()) <= most_turn_rad) {
    if (const auto distance_mm = distanceBetween(curve, u0, u1, whole, tolerance_mm))
      return FittedPart{.arcs = {whole}, .distance_mm = *distance_mm};
  }
  const ChordAngles angles = chordAngles(ends);
  if (std::abs(angles.alpha_rad + angles.beta_rad) > most_turn_rad) return std::nullopt;
  const Biarc pair = biarc(ends);
  const double joint = crossingOf(curve, u0, u1, pair.second);
  const auto first = distanceBetween(curve, u0, joint, pair.first, tolerance_mm);
  if (!first) return std::nullopt;
  const auto second = distanceBetween(curve, joint, u1, pair.second, tolerance_mm);
  if (!second) return std::nullopt;
  return FittedPart{.arcs = {pair.first, pair.second}, .distance_mm = std::max(*first, *second)};
}

/// A smooth part of the curve with the directions its arcs have at its ends.
struct SmoothRun {
  double begin = 0, end = 0;
  double begin_direction_rad = 0, end_direction_rad = 0;
};

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
  if (u1 >= run.end) {
    const int last = static_cast<int>(std::ceil(run.end)) - 1;
    const HermiteEnds ends = {.start = start,
                              .start_direction_rad = direction_rad,
                              .end = curve.endOf(last).point,
                              .end_direction_rad = run.end_direction_rad};
    std::optional<FittedPart> part = fittedPart(curve, u0, run.end, ends, tolerance_mm);
    if (!part) return std::nullopt;
    return FittedStep{
        .part = std::move(*part), .end = run.end, .end_direction_rad = run.end_direction_rad};
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
    std::optional<FittedPart> part = fittedPart(curve, u0, u1, ends, tolerance_mm);
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
  if (auto whole = attempt(run.end)) return *whole;
  std::optional<FittedStep> best;
  double reach = std::min(guess, (run.end - u0) / 2), fails = run.end - u0;
  while (!(best = attempt(u0 + reach))) {
    fails = reach;
    reach /= 2;
    // A share of a segment: below it the chord is a billionth of the curve, and rounding disturbs
    // its direction.
    constexpr double shortest = 0x1p-30;
    if (reach < shortest) {
      throw std::domain_error(fmt::format(
          "no arc keeps the tolerance {} mm at the parameter {} (segments count by 1): the curve"
          " turns back there, or the tolerance is below its rounding",
          tolerance_mm, u0));
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

void append(FittedPart& to, const FittedPart& part) {
  to.arcs.insert(to.arcs.end(), part.arcs.begin(), part.arcs.end());
  to.distance_mm = std::max(to.distance_mm, part.distance_mm);
}

FittedPart fitRun(const PlanarCurve& curve, const SmoothRun& run, double tolerance_mm,
                  const Progress& progress) {
  FittedPart result;
  double u = run.begin, direction_rad = run.begin_direction_rad, guess = 1;
  while (u < run.end) {
    checkProgress(progress, u / curve.count());
    const FittedStep step = longestStep(curve, run, u, direction_rad, guess, tolerance_mm);
    append(result, step.part);
    guess = step.end - u;
    u = step.end;
    direction_rad = step.end_direction_rad;
  }
  return result;
}

/// The segment as one arc, if it is one up to rounding.
std::optional<FittedPart> exactArc(const PlanarCurve& curve, int i, double tolerance_mm) {
  const CurveFrame start = curve.startOf(i), end = curve.endOf(i);
  const double noise_mm = 64 * curve.segments[i].noise() + 1e-9 * tolerance_mm;
  std::optional<FittedPart> part = fittedPart(curve, i, i + 1,
                                              {.start = start.point,
                                               .start_direction_rad = start.direction_rad,
                                               .end = end.point,
                                               .end_direction_rad = end.direction_rad},
                                              noise_mm);
  if (!part || part->arcs.size() != 1) return std::nullopt;
  return part;
}

/// Appends the arc of a segment, or lengthens the last arc if both are of one circle.
void appendExact(FittedPart& to, const FittedPart& part, bool at_corner, double tolerance_mm) {
  const PlanarArc& next = part.arcs.front();
  if (!to.arcs.empty() && !at_corner) {
    PlanarArc longer = to.arcs.back();
    longer.length_mm += next.length_mm;
    const double off_mm = (longer.end() - next.end()).norm();
    // A millionth of the tolerance is negligible. A full turn may be exceeded by the rounding of
    // the sum of angles.
    constexpr double same_circle = 1e-6, full_turn_rad = 2 * std::numbers::pi * (1 + 1e-12);
    if (off_mm <= same_circle * tolerance_mm && std::abs(longer.sweep_rad()) <= full_turn_rad) {
      to.arcs.back() = longer;
      to.distance_mm = std::max(to.distance_mm, part.distance_mm + off_mm);
      return;
    }
  }
  append(to, part);
}

double turnAt(const CurveFrame& before, const CurveFrame& after) {
  return wrapped(after.direction_rad - before.direction_rad);
}

/// With a tolerance near the rounding that alongCircle() adds to each bound, pieces become ever
/// shorter before one is refused.
void requireAboveNoise(const BezierSpline& spline, double tolerance_mm) {
  double size_mm = 0;
  for (const auto& pole : spline.poles.rowwise())
    size_mm = std::max(size_mm, pole.head<2>().cwiseAbs().maxCoeff() / pole(3));
  // Two points and their distance, and an eighth of the tolerance at most.
  const double noise_mm = 8 * 3 * machine_epsilon * size_mm;
  if (tolerance_mm < noise_mm)
    throw std::domain_error(fmt::format(
        "the tolerance {:.3g} mm is below {:.3g} mm, the rounding of coordinates of {:.3g} mm",
        tolerance_mm, noise_mm, size_mm));
}

}  // namespace

ArcFit fitArcs(const BezierSpline& spline, const ArcFitOptions& options, const Progress& progress) {
  requireValid(spline);
  requireFitOptions(options.tolerance_mm, options.corner_rad);
  requireAboveNoise(spline, options.tolerance_mm);
  const PlanarCurve curve = planarCurve(spline);
  const int n = curve.count();
  // Turns at the joints 0 to n; an open end has none.
  std::vector<double> turns_rad(n + 1, 0.0);
  for (int i = 1; i < n; ++i) turns_rad[i] = turnAt(curve.endOf(i - 1), curve.startOf(i));
  if (spline.closed) turns_rad[0] = turns_rad[n] = turnAt(curve.endOf(n - 1), curve.startOf(0));
  const auto isCorner = [&](int joint) { return std::abs(turns_rad[joint]) > options.corner_rad; };
  std::vector<std::optional<FittedPart>> exact;
  for (int i = 0; i < n; ++i) {
    checkProgress(progress, 0);
    exact.push_back(exactArc(curve, i, options.tolerance_mm));
  }

  FittedPart fitted;
  ArcFit result = {.arcs = {}, .corners = {}, .closed = spline.closed};
  for (int i = 0; i < n;) {
    if (isCorner(i) && (i > 0 || spline.closed))
      result.corners.push_back(static_cast<int>(fitted.arcs.size()));
    if (exact[i]) {
      appendExact(fitted, *exact[i], isCorner(i), options.tolerance_mm);
      ++i;
      continue;
    }
    int end = i + 1;
    while (end < n && !exact[end] && !isCorner(end)) ++end;
    // At a smooth joint both sides share the mean of their directions. Exact arcs keep theirs.
    const auto share = [&](int joint, bool beside_exact) {
      return isCorner(joint) || beside_exact ? 0 : turns_rad[joint] / 2;
    };
    const SmoothRun run = {.begin = static_cast<double>(i),
                           .end = static_cast<double>(end),
                           .begin_direction_rad = curve.startOf(i).direction_rad -
                                                  share(i, i > 0 && exact[i - 1].has_value()),
                           .end_direction_rad = curve.endOf(end - 1).direction_rad +
                                                share(end, end < n && exact[end].has_value())};
    append(fitted, fitRun(curve, run, options.tolerance_mm, progress));
    i = end;
  }
  result.arcs = std::move(fitted.arcs);
  result.distance_mm = fitted.distance_mm;
  return result;
}

std::vector<PlanarArc> offset(const ArcFit& fit, double distance_mm) {
  if (distance_mm == 0) return fit.arcs;
  std::vector<PlanarArc> result;
  for (std::size_t i = 0; i < fit.arcs.size(); ++i) {
    const bool corner = std::ranges::find(fit.corners, static_cast<int>(i)) != fit.corners.end();
    if (corner) {
      const PlanarArc& before = fit.arcs[i == 0 ? fit.arcs.size() - 1 : i - 1];
      const double turn_rad = wrapped(fit.arcs[i].direction_rad - before.endDirection_rad());
      if (turn_rad * distance_mm > 0) {
        throw std::domain_error(fmt::format(
            "the offset by {} mm is on the inside of the corner before arc {}, which turns by {}"
            " rad: the pieces would cross",
            distance_mm, i, turn_rad));
      }
      // Around the corner: from the normal of the arc before to that of the arc after.
      const double radius_mm = std::abs(distance_mm);
      const double start_rad = before.endDirection_rad();
      result.push_back(
          {.start = fit.arcs[i].start + distance_mm * unitVector(start_rad + std::numbers::pi / 2),
           .direction_rad = start_rad,
           .curvature_per_mm = -1 / distance_mm,
           .length_mm = radius_mm * std::abs(turn_rad)});
    }
    result.push_back(offset(fit.arcs[i], distance_mm));
  }
  return result;
}

}  // namespace seamwright
