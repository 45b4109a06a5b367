// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc_fit.hpp>
#include <seamwright/core/planar/arc_run.hpp>
#include <seamwright/core/planar/fit_options.hpp>
#include <seamwright/core/planar/free_arcs.hpp>
#include <seamwright/core/planar/planar_curve.hpp>
#include <seamwright/core/planar/tangent_chain.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// The segment as one arc, if it is one up to rounding.
std::optional<FittedPart> exactArc(const PlanarCurve& curve, int i, double tolerance_mm) {
  const CurveFrame start = curve.startOf(i), end = curve.endOf(i);
  // Half of the tolerance is left to arcs that are joined.
  const double noise_mm =
      std::min(64 * curve.segments[i].noise() + 1e-9 * tolerance_mm, tolerance_mm / 2);
  std::optional<FittedPart> part = fittedPart(curve, {double(i), double(i + 1)},
                                              {.start = start.point,
                                               .start_direction_rad = start.direction_rad,
                                               .end = end.point,
                                               .end_direction_rad = end.direction_rad},
                                              noise_mm);
  if (!part || part->arcs.size() != 1) return std::nullopt;
  // Rounding bends a line that is not parallel to an axis.
  PlanarArc& arc = part->arcs.front();
  const double sagitta_mm = std::abs(arc.curvature_per_mm) * arc.length_mm * arc.length_mm / 8;
  if (arc.curvature_per_mm != 0 && sagitta_mm <= noise_mm) {
    const Vector2d chord = end.point - start.point;
    arc = {.start = start.point,
           .direction_rad = std::atan2(chord.y(), chord.x()),
           .curvature_per_mm = 0,
           .length_mm = chord.norm()};
    part->distance_mm += sagitta_mm;
  }
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
  to.append(part);
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

/// A curve with what its segments and joints are.
struct CurveLayout {
  PlanarCurve curve;
  bool closed = false;
  std::vector<double> turns_rad;  ///< at the joints 0 to N; an open end has none
  std::vector<std::optional<FittedPart>> exact;
  std::vector<bool> is_corner;  ///< of the joints
  std::vector<bool> is_kept;    ///< segments that stay the arcs and lines that they are

  int count() const { return curve.count(); }
  bool isLine(int segment) const {
    return exact[segment] && exact[segment]->arcs.front().curvature_per_mm == 0;
  }
  double length_mm(int segment) const { return exact[segment]->arcs.front().length_mm; }
  /// The segments before and after a joint; -1 at an open end.
  int before(int joint) const { return joint > 0 ? joint - 1 : closed ? count() - 1 : -1; }
  int after(int joint) const { return joint < count() ? joint : closed ? 0 : -1; }
};

/// Segments that are arcs and lines; neighbours on one circle are one piece.
struct ExactPieces {
  std::vector<double> lengths_mm;  ///< of the piece of each segment; 0 for other curves
  std::vector<int> begins, ends;   ///< the joints at which its piece begins and ends
};

ExactPieces exactPieces(const CurveLayout& layout, double tolerance_mm) {
  const int n = layout.count();
  ExactPieces pieces;
  FittedPart first, last;
  for (int i = 0; i < n;) {
    last = {};
    int end = i;
    while (end < n && layout.exact[end]) {
      appendExact(last, *layout.exact[end], false, tolerance_mm);
      if (last.arcs.size() > 1) break;
      ++end;
    }
    if (i == 0) first = last;
    end = std::max(end, i + 1);
    pieces.lengths_mm.resize(end, last.arcs.empty() ? 0 : last.arcs.front().length_mm);
    pieces.begins.resize(end, i);
    pieces.ends.resize(end, end);
    i = end;
  }
  if (!layout.closed || first.arcs.empty() || last.arcs.empty() || pieces.ends[0] == n)
    return pieces;
  // The piece that passes the point where a closed curve begins.
  FittedPart whole{.arcs = {last.arcs.front()}};
  appendExact(whole, {.arcs = {first.arcs.front()}}, false, tolerance_mm);
  if (whole.arcs.size() > 1) return pieces;
  const int begin = pieces.begins.back(), end = pieces.ends.front();
  for (int i = 0; i < n; ++i) {
    if (i >= end && i < begin) continue;
    pieces.lengths_mm[i] = whole.arcs.front().length_mm;
    pieces.begins[i] = begin;
    pieces.ends[i] = end;
  }
  return pieces;
}

/// Whether a smooth curve within the tolerance explains a joint of two sides of a polygon: a circle
/// midway between the corner and the middle of the shorter side.
bool isSample(const CurveLayout& layout, const ExactPieces& pieces, int joint,
              double tolerance_mm) {
  const int before = layout.before(joint), after = layout.after(joint);
  if (before < 0 || after < 0 || !layout.isLine(before) || !layout.isLine(after)) return false;
  const double shorter_mm = std::min(pieces.lengths_mm[before], pieces.lengths_mm[after]);
  const double off_mm = shorter_mm / 4 * std::tan(std::abs(layout.turns_rad[joint]) / 4);
  return off_mm <= tolerance_mm;
}

/// Points of the curve from a joint on, as far as there is no corner, up to a length.
std::vector<Vector2d> pointsFrom(const CurveLayout& layout, int joint, bool forward,
                                 double length_mm) {
  std::vector<Vector2d> points;
  const int begin = joint;
  double walked_mm = 0;
  while (walked_mm < length_mm && !layout.is_corner[joint]) {
    const int i = forward ? layout.after(joint) : layout.before(joint);
    if (i < 0) break;
    const BezierCurve& segment = layout.curve.segments[i];
    Vector2d last = segment.point(forward ? 0 : 1).head<2>();
    // Of a segment: enough to tell it from an arc.
    constexpr int steps = 8;
    for (int k = 1; k <= steps && walked_mm < length_mm; ++k) {
      const double t = static_cast<double>(forward ? k : steps - k) / steps;
      points.emplace_back(segment.point(t).head<2>());
      walked_mm += (points.back() - last).norm();
      last = points.back();
    }
    joint = forward ? i + 1 : i;
    if (joint == begin) break;
  }
  return points;
}

/// Whether an arc or line is more than a sample of a smooth curve: with half as much on both sides
/// it is not near one arc.
bool staysExact(const CurveLayout& layout, const ExactPieces& pieces, int segment,
                double tolerance_mm) {
  const int begin = pieces.begins[segment], end = pieces.ends[segment];
  if (begin == 0 && end == layout.count()) return true;
  const double half_mm = pieces.lengths_mm[segment] / 2;
  std::vector<Vector2d> points = pointsFrom(layout, begin, false, half_mm);
  std::ranges::reverse(points);
  const auto beyond = static_cast<std::ptrdiff_t>(points.size());
  for (const Vector2d& point : pointsFrom(layout, end, true, half_mm)) points.push_back(point);
  if (points.empty()) return true;
  const std::vector<Vector2d> inside = pointsFrom(
      layout, begin, true, pieces.lengths_mm[segment] * (1 - std::sqrt(machine_epsilon)));
  points.insert(points.begin() + beyond, inside.begin(), inside.end());
  return freeArcEnds(points, tolerance_mm).size() > 1;
}

/// Corners, and the segments that stay.
void classify(CurveLayout& layout, const ArcFitOptions& options) {
  const int n = layout.count();
  const double tolerance_mm = options.tolerance_mm;
  const ExactPieces pieces = exactPieces(layout, tolerance_mm);
  const auto isKink = [&](int joint) {
    return std::abs(layout.turns_rad[joint]) > options.corner_rad;
  };
  layout.is_corner.assign(n + 1, false);
  for (int joint = 0; joint <= n; ++joint)
    layout.is_corner[joint] = isKink(joint) && !isSample(layout, pieces, joint, tolerance_mm);
  layout.is_kept.assign(n, false);
  for (int i = 0; i < n; ++i) {
    const bool same = i > 0 && pieces.begins[i] == pieces.begins[i - 1];
    layout.is_kept[i] = same ? layout.is_kept[i - 1]
                             : layout.exact[i] && staysExact(layout, pieces, i, tolerance_mm);
  }
  // A kink between two pieces that stay is a corner.
  for (int joint = 0; joint <= n; ++joint) {
    const int before = layout.before(joint), after = layout.after(joint);
    if (before >= 0 && after >= 0 && layout.is_kept[before] && layout.is_kept[after])
      layout.is_corner[joint] = isKink(joint);
  }
}

CurveLayout layoutOf(const BezierSpline& spline, const ArcFitOptions& options,
                     const Progress& progress) {
  CurveLayout layout;
  layout.curve = planarCurve(spline);
  layout.closed = spline.closed;
  const PlanarCurve& curve = layout.curve;
  const int n = curve.count();
  layout.turns_rad.assign(n + 1, 0.0);
  for (int i = 1; i < n; ++i) layout.turns_rad[i] = turnAt(curve.endOf(i - 1), curve.startOf(i));
  if (spline.closed)
    layout.turns_rad[0] = layout.turns_rad[n] = turnAt(curve.endOf(n - 1), curve.startOf(0));
  for (int i = 0; i < n; ++i) {
    checkProgress(progress, 0);
    layout.exact.push_back(exactArc(curve, i, options.tolerance_mm));
  }
  classify(layout, options);
  return layout;
}

/// The direction of arcs at an end of segments that do not stay; any at an end of a polygon.
std::optional<double> directionAt(const CurveLayout& layout, int joint, bool at_begin) {
  const int inside = at_begin ? joint : joint - 1;
  const int beside = at_begin ? layout.before(joint) : layout.after(joint);
  const bool is_end = beside < 0 || layout.is_corner[joint];
  if (is_end && layout.isLine(inside)) return std::nullopt;
  const double direction_rad = at_begin ? layout.curve.startOf(inside).direction_rad
                                        : layout.curve.endOf(inside).direction_rad;
  if (is_end) return direction_rad;
  // At a smooth joint both sides share the mean of their directions. Arcs that stay keep theirs.
  const double turn_rad = layout.turns_rad[joint] * (layout.is_kept[beside] ? 1 : 0.5);
  return direction_rad + (at_begin ? -turn_rad : turn_rad);
}

/// Where the arcs of a closed curve without corners begin: on the circle near the samples around
/// its first point. The samples can wave within the tolerance.
RunEnd closedEnd(const SampledRun& sampled) {
  const int last = sampled.last();
  const double away_mm = sampled.scales_mm.front() / 4;
  const auto indexAt = [&](double length_mm) {
    const auto found = std::ranges::lower_bound(sampled.lengths_mm, length_mm);
    return std::min(static_cast<int>(found - sampled.lengths_mm.begin()), last);
  };
  std::vector<Vector2d> around;
  for (int i = indexAt(sampled.lengths_mm.back() - away_mm); i < last; ++i)
    around.push_back(sampled.points[i]);
  for (int i = 0; i <= indexAt(away_mm); ++i) around.push_back(sampled.points[i]);
  const ArcStart start = nearestCircle(around, sampled.points.front());
  return {.point = start.point, .direction_rad = start.direction_rad};
}

bool isSmoothKink(const CurveLayout& layout, int joint, double corner_rad) {
  return !layout.is_corner[joint] && std::abs(layout.turns_rad[joint]) > corner_rad;
}

/// Arcs near segments that do not stay; nothing if they have kinks and no smooth chain is found.
std::optional<FittedPart> fittedRun(const CurveLayout& layout, const CurvePart& range,
                                    const ArcFitOptions& options, const Progress& progress) {
  const int begin = static_cast<int>(range.begin), end = static_cast<int>(range.end);
  const SampledRun sampled = sampledRun(layout.curve, range, options.tolerance_mm, arc_samples);
  const SmoothRun run{.range = range,
                      .ends = {.begin = {.point = sampled.points.front(),
                                         .direction_rad = directionAt(layout, begin, true)},
                               .end = {.point = sampled.points.back(),
                                       .direction_rad = directionAt(layout, end, false)}}};
  if (auto line = lineBeside(layout.curve, run, options.tolerance_mm)) return line;
  SmoothRun searched = run;
  if (layout.closed && end - begin == layout.count() && !layout.is_corner.front()) {
    if (auto circle = circleBeside(layout.curve, sampled, options.tolerance_mm)) return circle;
    searched.ends.begin = searched.ends.end = closedEnd(sampled);
  }
  if (auto part = fewArcsBeside(layout.curve, searched, sampled, options.tolerance_mm, progress))
    return part;
  // Also at its ends: no short arc makes up for the direction of a neighbour.
  for (int joint = begin; joint <= end; ++joint)
    if (isSmoothKink(layout, joint, options.corner_rad)) return std::nullopt;
  // Where any direction will do, that of the curve.
  SmoothRun directed = run;
  RunEnds& ends = directed.ends;
  if (!ends.begin.direction_rad)
    ends.begin.direction_rad = layout.curve.startOf(begin).direction_rad;
  if (!ends.end.direction_rad) ends.end.direction_rad = layout.curve.endOf(end - 1).direction_rad;
  return arcsOfHalves(layout.curve, directed, sampled, options.tolerance_mm, progress);
}

/// The arcs and lines that a part is, if it is without kinks.
std::optional<FittedPart> exactRun(const CurveLayout& layout, const CurvePart& range,
                                   const ArcFitOptions& options) {
  FittedPart part;
  const int begin = static_cast<int>(range.begin), end = static_cast<int>(range.end);
  for (int i = begin; i < end; ++i) {
    if (!layout.exact[i]) return std::nullopt;
    const bool can_turn = i == begin && layout.is_corner[begin];
    if (!can_turn && std::abs(layout.turns_rad[i]) > options.corner_rad) return std::nullopt;
    appendExact(part, *layout.exact[i], i == begin, options.tolerance_mm);
  }
  if (!layout.is_corner[end] && std::abs(layout.turns_rad[end]) > options.corner_rad)
    return std::nullopt;
  return part;
}

/// The lines and arcs of which the vertices of a closed polygon without corners are samples, up to
/// the rounding of their digits.
std::optional<FittedPart> sampledPieces(const CurveLayout& layout, std::size_t fewer_than,
                                        double tolerance_mm) {
  SampledPolygon polygon{.vertices = {}, .closed = layout.closed};
  for (int i = 0; i < layout.count(); ++i) {
    if (!layout.isLine(i)) return std::nullopt;
    polygon.vertices.push_back(layout.curve.startOf(i).point);
  }
  std::optional<FittedPart> best;
  for (const double share : noise_shares) {
    if (best) fewer_than = best->arcs.size();
    const double noise_mm = share * tolerance_mm;
    const auto chain = tangentChain(
        polygon,
        {.noise_mm = noise_mm, .line_mm = noise_mm, .fewer_than = static_cast<int>(fewer_than)});
    if (!chain) continue;
    if (auto part = proven(layout.curve, polygon.begin, *chain, tolerance_mm)) best = part;
  }
  return best;
}

/// Makes the fit of a part of a polygon easier: it may turn at kinks where it begins and ends, then
/// at one in its middle, or at all. Sides with such kinks at both ends stay.
void relax(CurveLayout& layout, const CurvePart& range, double corner_rad, bool at_all) {
  const int begin = static_cast<int>(range.begin), end = static_cast<int>(range.end);
  std::vector<int> corners;
  for (const int joint : {begin, end})
    if (isSmoothKink(layout, joint, corner_rad)) corners.push_back(joint);
  if (at_all) {
    for (int joint = begin + 1; joint < end; ++joint)
      if (isSmoothKink(layout, joint, corner_rad)) corners.push_back(joint);
  } else if (corners.empty()) {
    int middle = begin;
    for (int joint = begin + 1; joint < end; ++joint)
      if (isSmoothKink(layout, joint, corner_rad) &&
          std::abs(2 * joint - begin - end) < std::abs(2 * middle - begin - end))
        middle = joint;
    corners.push_back(middle);
  }
  for (const int joint : corners) layout.is_corner[joint] = true;
  const bool closes = layout.closed && (layout.is_corner.front() || layout.is_corner.back());
  if (closes) layout.is_corner.front() = layout.is_corner.back() = true;
}

/// Of all chains from corner to corner. Arcs at an end with a given direction are those that have
/// it; the others are of any kind.
int leastArcs(const CurveLayout& layout, const CurvePart& range, double tolerance_mm) {
  const int begin = static_cast<int>(range.begin), end = static_cast<int>(range.end);
  std::vector<Vector2d> points = sampledRun(layout.curve, range, tolerance_mm, arc_samples).points;
  int at_ends = 0;
  for (const bool at_begin : {true, false}) {
    const int joint = at_begin ? begin : end;
    const bool is_end =
        layout.before(joint) < 0 || layout.after(joint) < 0 || layout.is_corner[joint];
    const auto direction_rad = directionAt(layout, joint, at_begin);
    if (is_end && direction_rad && !points.empty()) {
      const ArcStart start{.point = points.front(),
                           .direction_rad = *direction_rad + (at_begin ? 0 : std::numbers::pi)};
      points.erase(points.begin(), points.begin() + pointsBeside(points, start, tolerance_mm));
      ++at_ends;
    }
    std::ranges::reverse(points);
  }
  return at_ends + static_cast<int>(freeArcEnds(points, tolerance_mm).size());
}

/// The arc that passes the point where a closed curve begins becomes the first one.
void joinAtBegin(FittedPart& fitted, double tolerance_mm) {
  if (fitted.arcs.size() < 2) return;
  FittedPart whole{.arcs = {fitted.arcs.back()}};
  appendExact(whole, {.arcs = {fitted.arcs.front()}}, false, tolerance_mm);
  if (whole.arcs.size() > 1) return;
  fitted.arcs.front() = whole.arcs.front();
  fitted.arcs.pop_back();
  fitted.distance_mm += whole.distance_mm;
}

int leastArcs(const CurveLayout& layout, double tolerance_mm) {
  const int n = layout.count();
  int least = 0;
  for (int i = 0; i < n;) {
    int end = i + 1;
    while (end < n && !layout.is_corner[end]) ++end;
    least += leastArcs(layout, {double(i), double(end)}, tolerance_mm);
    i = end;
  }
  // A chain can pass the point where a closed curve begins.
  return std::max(1, layout.closed && !layout.is_corner[0] ? least - 1 : least);
}

}  // namespace

ArcFit fitArcs(const BezierSpline& spline, const ArcFitOptions& options, const Progress& progress) {
  requireValid(spline);
  requireFitOptions(options.tolerance_mm, options.corner_rad);
  requireAboveNoise(spline, options.tolerance_mm);
  CurveLayout layout = layoutOf(spline, options, progress);
  const int n = layout.count();
  const bool is_smooth = layout.closed && std::ranges::count(layout.is_corner, true) == 0;
  FittedPart fitted;
  ArcFit result = {.arcs = {}, .corners = {}, .closed = spline.closed};
  // Searches of the whole curve. A choice: enough for 200 corners that are found by halving.
  constexpr int most_searches = 16;
  double searched = 0;
  for (int i = 0; i < n;) {
    if (layout.is_kept[i]) {
      if (layout.is_corner[i]) result.corners.push_back(static_cast<int>(fitted.arcs.size()));
      appendExact(fitted, *layout.exact[i], layout.is_corner[i], options.tolerance_mm);
      ++i;
      continue;
    }
    int end = i + 1;
    while (end < n && !layout.is_kept[end] && !layout.is_corner[end]) ++end;
    const CurvePart range{.begin = double(i), .end = double(end)};
    const auto exact = exactRun(layout, range, options);
    auto part = fittedRun(layout, range, options, partOf(progress, range.begin / n, range.end / n));
    if (exact && (!part || exact->arcs.size() <= part->arcs.size())) part = exact;
    searched += (range.end - range.begin) / n;
    if (!part) {
      relax(layout, range, options.corner_rad, searched > most_searches);
      continue;
    }
    if (layout.is_corner[i]) result.corners.push_back(static_cast<int>(fitted.arcs.size()));
    fitted.append(*part);
    i = end;
  }
  // The last part can make a corner of the point where a closed curve begins.
  if (layout.closed && layout.is_corner.front() &&
      (result.corners.empty() || result.corners.front() != 0))
    result.corners.insert(result.corners.begin(), 0);
  if (is_smooth)
    if (auto pieces = sampledPieces(layout, fitted.arcs.size(), options.tolerance_mm)) {
      fitted = std::move(*pieces);
      result.corners.clear();
      layout.is_corner.assign(layout.is_corner.size(), false);
    }
  if (layout.closed && !layout.is_corner.front()) joinAtBegin(fitted, options.tolerance_mm);
  result.least_arcs = leastArcs(layout, options.tolerance_mm);
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
