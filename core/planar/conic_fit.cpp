// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/conic_distance.hpp>
#include <seamwright/core/planar/conic_fit.hpp>
#include <seamwright/core/planar/conic_grading.hpp>
#include <seamwright/core/planar/conic_spline.hpp>
#include <seamwright/core/planar/fit_options.hpp>
#include <seamwright/core/planar/planar_curve.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// Where a segment needs shorter pieces, the curve turns back or has a cusp.
constexpr double shortest_span = 0x1p-12;

/// A curve with what conics have to know of its segments and joints.
struct ConicFitCurve {
  PlanarCurve curve;
  bool closed = false;
  std::vector<bool> cusps;    ///< the curve turns back before segment i: a cut made by turnBackAt()
  std::vector<bool> corners;  ///< before segment i
  std::vector<bool> lines;    ///< segments to be kept as lines
};

/// Rounding of poles.
double noiseOf_mm(const Poles& poles) {
  return 16 * machine_epsilon * poles.leftCols<2>().cwiseAbs().maxCoeff();
}

/// Whether a segment is a line up to rounding, or to a bulge that is far below the tolerance and
/// turns by less than anybody sees: conics would turn it into waves of rounding.
bool isStraight(const BezierCurve& segment, double tolerance_mm) {
  constexpr double least_bulge = 1e-9;
  const Poles poles = segment.poles();
  const Vector2d start = poles.row(0).head<2>(),
                 chord = poles.row(poles.rows() - 1).head<2>().transpose() - start;
  const double noise_mm = noiseOf_mm(poles), length_mm = chord.norm();
  if (!(length_mm > noise_mm)) return false;
  const double bulge_mm =
      std::max(noise_mm, std::min(tolerance_mm / small_part, least_bulge * length_mm));
  for (Eigen::Index i = 1; i + 1 < poles.rows(); ++i) {
    const Vector2d from = poles.row(i).head<2>().transpose() - start;
    if (std::abs(cross(chord / length_mm, from)) > bulge_mm) return false;
  }
  return true;
}

/// Towards the first pole that is not the start: the direction also where the curve stops.
Vector2d startDirection(const BezierCurve& segment) {
  const Poles poles = segment.poles();
  for (Eigen::Index i = 1; i < poles.rows(); ++i) {
    const Vector2d from = (poles.row(i) - poles.row(0)).head<2>();
    if (from.norm() > noiseOf_mm(poles)) return from;
  }
  return Vector2d::Zero();
}

Vector2d endDirection(const BezierCurve& segment) {
  return -startDirection(segment.reversed());
}

double chordOf_mm(const BezierCurve& segment) {
  return (segment.point(1) - segment.point(0)).norm();
}

/// Whether a kink is one of a smooth curve that was sampled, as far as the tolerance tells: an arc
/// through the ends of a side that turns by the angle is beside the side by an eighth of their
/// product.
bool isSampled(double turn_rad, double side_mm, const ConicFitOptions& options) {
  // A choice: the rest of the tolerance is for the conics.
  constexpr double share = 0.5;
  return turn_rad <= options.sampled_rad && side_mm * turn_rad / 8 <= share * options.tolerance_mm;
}

/// Finds corners, and the lines to be kept.
void findCorners(ConicFitCurve& of, const ConicFitOptions& options) {
  const int n = of.curve.count();
  std::vector<double> turns_rad;
  of.corners.clear();
  for (int i = 0; i < n; ++i) {
    const bool first = i == 0 && !of.closed;
    const BezierCurve &before = of.curve.segments[(i + n - 1) % n], &after = of.curve.segments[i];
    const double turn_rad =
        first ? 0 : std::abs(angleFromTo(endDirection(before), startDirection(after)));
    turns_rad.push_back(turn_rad);
    const bool smooth =
        turn_rad <= options.corner_rad ||
        isSampled(turn_rad, std::max(chordOf_mm(before), chordOf_mm(after)), options);
    of.corners.push_back(of.cusps[i] || !smooth);
  }
  // The sides of a polygon that samples a curve are no lines to be kept: it turns at their ends.
  constexpr double smooth_rad = 1e-6;
  const auto keeps = [&](int joint) {
    return turns_rad[joint % n] <= smooth_rad || of.corners[joint % n];
  };
  of.lines.clear();
  for (int i = 0; i < n; ++i)
    of.lines.push_back(isStraight(of.curve.segments[i], options.tolerance_mm) && keeps(i) &&
                       keeps(i + 1));
}

/// Lets a closed curve begin with another segment.
void beginAt(ConicFitCurve& of, int segment) {
  const auto turn = [&](auto& values) {
    std::rotate(values.begin(), values.begin() + segment, values.end());
  };
  turn(of.curve.segments), turn(of.curve.polynomials), turn(of.curve.origins);
  turn(of.cusps), turn(of.corners), turn(of.lines);
}

/// Divides a segment: the curve turns back at its parameter u.
void turnBackAt(ConicFitCurve& of, double u) {
  const int i = static_cast<int>(u);
  const auto [first, second] = of.curve.segments[i].split(u - i);
  const auto put = [&](int at, const BezierCurve& part) {
    of.curve.segments[at] = part;
    of.curve.polynomials[at] = curvePolynomials(part, part.poles().row(0));
    of.curve.origins[at] = part.poles().row(0).head<2>();
  };
  of.curve.segments.insert(of.curve.segments.begin() + i, first);
  of.curve.polynomials.insert(of.curve.polynomials.begin() + i, of.curve.polynomials[i]);
  of.curve.origins.insert(of.curve.origins.begin() + i, of.curve.origins[i]);
  put(i, first), put(i + 1, second);
  of.cusps.insert(of.cusps.begin() + i + 1, true);
}

/// A part of the curve between corners.
struct ConicRun {
  int begin = 0, end = 0;  ///< segments
  bool closed = false;
};

/// Two points divide each line: so three neighbours are on it, and conicSpline() keeps it.
void appendLine(const PlanarCurve& curve, int begin, int end, std::vector<ConicPoint>& points) {
  const Vector2d start = curve.point(begin);
  const Vector2d chord = curve.segments[end - 1].point(1).head<2>().transpose() - start.transpose();
  for (const double share : {0.0, 1.0 / 3, 2.0 / 3})
    points.push_back(
        {.u = begin + share * (end - begin), .point = start + share * chord, .line_after = true});
}

/// The ends of lines, and parts of the rest.
std::vector<ConicPoint> firstPoints(const ConicFitCurve& of, const ConicRun& run) {
  const PlanarCurve& curve = of.curve;
  std::vector<ConicPoint> points;
  for (int i = run.begin; i < run.end;) {
    int end = i + 1;
    while (end < run.end && of.lines[end] == of.lines[i]) ++end;
    if (of.lines[i]) {
      appendLine(curve, i, end, points);
    } else {
      // Four pieces of a closed run turn by a right angle each.
      const int parts = run.closed && end - i == run.end - run.begin ? 4 : 1;
      for (int k = 0; k < parts; ++k) {
        const double u = i + static_cast<double>(k) * (end - i) / parts;
        points.push_back({.u = u, .point = curve.point(u)});
      }
    }
    i = end;
  }
  const Vector2d last =
      run.closed ? points.front().point : Vector2d(curve.segments[run.end - 1].point(1).head<2>());
  points.push_back({.u = static_cast<double>(run.end), .point = last});
  return points;
}

/// The conics from one point to the next one.
struct ConicSpan {
  std::vector<PlanarConic> conics;
  std::vector<bool> g1;  ///< whether they begin at a joint that is not G2
};

/// Whether a conic turns by so little that its curvature is rounding, and may be anything.
bool turnsUnseen(const PlanarConic& conic) {
  constexpr double unseen_rad = 1e-7;
  return std::abs(conic.turn_rad()) <= unseen_rad;
}

/// Whether a conic has nearly all of its turn in one place. Conics between close points of a smooth
/// curve turn evenly.
bool hasKink(const PlanarConic& conic) {
  // A choice: a pair beside an inflection is far from it, a visible kink far above.
  constexpr double most_ratio = 100;
  double largest = 0;
  for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
    largest = std::max(largest, std::abs(conic.curvatureAt_per_mm(t)));
  return largest * (conic.end - conic.start).norm() > most_ratio * std::abs(conic.turn_rad());
}

std::optional<std::vector<ConicSpan>> spansThrough(const std::vector<ConicPoint>& points,
                                                   bool closed, PairEffort effort,
                                                   const Progress& progress) {
  const auto count = static_cast<Eigen::Index>(points.size()) - (closed ? 1 : 0);
  PlanarPoints rows(count, 2);
  for (Eigen::Index i = 0; i < count; ++i)
    rows.row(i) = points[static_cast<std::size_t>(i)].point.transpose();
  for (Eigen::Index i = closed ? 0 : 1; i < count; ++i)
    if (rows.row(i) == rows.row(i > 0 ? i - 1 : count - 1)) return std::nullopt;
  ConicSpline spline;
  try {
    spline = conicSpline(rows, closed, progress, effort);
  } catch (const std::domain_error&) {  // points are too far apart for the turn between them
    return std::nullopt;
  }
  const auto has = [](const std::vector<int>& joints, int i) {
    return std::ranges::find(joints, i) != joints.end();
  };
  std::vector<ConicSpan> spans(1);
  bool after_unseen = false;
  for (int i = 0; i < static_cast<int>(spline.conics.size()); ++i) {
    PlanarConic conic = spline.conics[static_cast<std::size_t>(i)];
    const bool unseen = turnsUnseen(conic) && conic.weight != 1;
    if (unseen)
      conic = {.start = conic.start, .corner = (conic.start + conic.end) / 2, .end = conic.end};
    spans.back().g1.push_back(has(spline.g1_joints, i) || has(spline.corners, i) || unseen ||
                              after_unseen);
    after_unseen = unseen;
    spans.back().conics.push_back(conic);
    if (conic.end == points[spans.size()].point && spans.size() + 1 < points.size())
      spans.emplace_back();
  }
  return spans.size() + 1 == points.size() ? std::optional(spans) : std::nullopt;
}

std::vector<CurvePiece> piecesBetween(const PlanarCurve& curve, double u0, double u1) {
  std::vector<CurvePiece> pieces;
  for (int i = static_cast<int>(u0); i < curve.count() && i < u1; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Interval domain = {std::max(u0 - i, 0.0), std::min(u1 - i, 1.0)};
    if (domain.width() > 0)
      pieces.push_back(
          {.polynomials = curve.polynomials[k], .origin = curve.origins[k], .domain = domain});
  }
  return pieces;
}

/// Appends the conics of a run. The spans of a line become one line.
void appendSpans(const std::vector<ConicPoint>& points, const std::vector<ConicSpan>& spans,
                 ConicFit& result) {
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const bool longer =
        i > 0 && points[i].line_after && points[i - 1].line_after && !spans[i].g1.front();
    if (longer) {
      PlanarConic& line = result.conics.back();
      line.end = spans[i].conics.back().end;
      line.corner = (line.start + line.end) / 2;
      continue;
    }
    for (std::size_t k = 0; k < spans[i].conics.size(); ++k) {
      if (spans[i].g1[k]) result.g1_joints.push_back(static_cast<int>(result.conics.size()));
      result.conics.push_back(spans[i].conics[k]);
    }
  }
}

/// The box of the poles of a run.
double extentOf_mm(const PlanarCurve& curve, const ConicRun& run) {
  Eigen::AlignedBox2d box;
  for (int i = run.begin; i < run.end; ++i) {
    const Poles poles = curve.segments[i].poles();
    for (Eigen::Index k = 0; k < poles.rows(); ++k) box.extend(Vector2d(poles.row(k).head<2>()));
  }
  return box.diagonal().norm();
}

/// A run that is far smaller than the tolerance, where its own shape is rounding: a line from end
/// to end. One that comes back goes to its middle first.
bool appendSmall(const PlanarCurve& curve, const ConicRun& run, double tolerance_mm,
                 ConicFit& result) {
  const double extent_mm = extentOf_mm(curve, run);
  if (!(small_part * extent_mm <= tolerance_mm)) return false;
  const Vector2d start = curve.point(run.begin),
                 end = curve.segments[run.end - 1].point(1).head<2>(),
                 middle = curve.point((run.begin + run.end) / 2.0);
  std::vector<Vector2d> points = {start, end};
  if (start == end) points.insert(points.begin() + 1, middle);
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i - 1] == points[i]) continue;
    if (i > 1) result.corners.push_back(static_cast<int>(result.conics.size()));
    result.conics.push_back(
        {.start = points[i - 1], .corner = (points[i - 1] + points[i]) / 2, .end = points[i]});
  }
  result.distance_mm = std::max(result.distance_mm, extent_mm);
  return true;
}

/// Where the curve is slowest between two parameters of one segment, if it nearly stops there. The
/// ends of the segment do not count: they are ends of conics anyway.
std::optional<double> stopWithin(const PlanarCurve& curve, double from, double to) {
  const int i = curve.segmentAt((from + to) / 2);
  const BezierCurve& segment = curve.segments[i];
  const auto speed = [&](double t) { return segment.derivatives(t, 1).row(1).head<2>().norm(); };
  double low = std::max(from - (to - from) - i, 0.0), high = std::min(to + (to - from) - i, 1.0);
  // A ternary search: near a cusp the square of the speed is a parabola.
  constexpr int steps = 120;
  for (int step = 0; step < steps; ++step) {
    const double third = (high - low) / 3;
    if (speed(low + third) < speed(high - third))
      high -= third;
    else
      low += third;
  }
  const double t = (low + high) / 2;
  // Within 2^-12 of a cusp the speed is about this share of the mean one.
  constexpr double slow = 0x1p-8, end_part = 0x1p-13;
  double length_mm = 0;
  const Poles poles = segment.poles();
  for (Eigen::Index k = 1; k < poles.rows(); ++k)
    length_mm += (poles.row(k) - poles.row(k - 1)).norm();
  if (t < end_part || t > 1 - end_part || !(speed(t) <= slow * length_mm)) return std::nullopt;
  return i + t;
}

/// Points between which spans are halved. Spans whose distance is not proven, and without spans
/// those beside the sharpest turns.
std::vector<bool> sharpSpans(const std::vector<ConicPoint>& points) {
  std::vector<bool> sharp(points.size(), false);
  // A choice: pairs of conics turn by less than this.
  constexpr double sharp_rad = 1.5;
  bool any = false;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vector2d in = points[i].point - points[i - 1].point,
                   out = points[i + 1].point - points[i].point;
    if (in.squaredNorm() > 0 && out.squaredNorm() > 0 && std::abs(angleFromTo(in, out)) < sharp_rad)
      continue;
    any = sharp[i - 1] = sharp[i] = true;
  }
  if (!any) sharp.assign(points.size(), true);
  return sharp;
}

/// The distance of a point from a conic to first order; from its chord if it is flat.
double distanceAbout_mm(const PlanarConic& conic, const Vector2d& point) {
  const Vector2d chord = conic.end - conic.start, leg = conic.corner - conic.start,
                 from = point - conic.start;
  const double area = cross(leg, chord);
  if (std::abs(area) <= 16 * machine_epsilon * chord.squaredNorm())
    return std::abs(cross(chord.normalized(), from));
  // docs/theory/planar.md P9.3: f = b1^2 - 4 w^2 b0 b2.
  const double b1 = cross(from, chord) / area, b2 = cross(leg, from) / area, b0 = 1 - b1 - b2;
  const Vector2d slope1 = Vector2d(chord.y(), -chord.x()) / area,
                 slope2 = Vector2d(-leg.y(), leg.x()) / area;
  const double factor = 4 * conic.weight * conic.weight;
  const Vector2d slope = 2 * b1 * slope1 - factor * (b0 * slope2 - b2 * (slope1 + slope2));
  return std::abs(b1 * b1 - factor * b0 * b2) / slope.norm();
}

/// The largest distance of samples of the curve from the conics between two points.
double sampledDistance_mm(const PlanarCurve& curve, const ConicPoint& from, const ConicPoint& to,
                          const std::vector<PlanarConic>& conics) {
  constexpr int samples = 8;
  const Vector2d along = to.point - from.point;
  double largest_mm = 0;
  for (int i = 0; i < samples; ++i) {
    const Vector2d point = curve.point(std::lerp(from.u, to.u, (i + 0.5) / samples));
    const auto beside = std::ranges::find_if(
        conics, [&](const PlanarConic& conic) { return along.dot(point - conic.end) <= 0; });
    largest_mm = std::max(
        largest_mm, distanceAbout_mm(beside == conics.end() ? conics.back() : *beside, point));
  }
  if (!std::isfinite(largest_mm)) return infinite;
  return largest_mm;
}

/// What a round of the fit finds.
struct ConicRound {
  std::vector<double> distances_mm;  ///< for each span; infinite where it is to be halved
  bool sampled = false;              ///< of samples: one is above the tolerance
};

ConicRound measured(const ConicFitCurve& of, const std::vector<ConicPoint>& points,
                    const std::vector<ConicSpan>& spans, double tolerance_mm, PairEffort effort,
                    const Progress& progress) {
  ConicRound round;
  for (std::size_t i = 0; i < spans.size(); ++i)
    round.distances_mm.push_back(
        sampledDistance_mm(of.curve, points[i], points[i + 1], spans[i].conics));
  round.sampled = std::ranges::any_of(
      round.distances_mm, [&](double distance_mm) { return distance_mm > tolerance_mm; });
  if (round.sampled || effort == PairEffort::Draft) return round;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    checkProgress(progress, 0);
    const bool divisible = points[i + 1].u - points[i].u >= shortest_span;
    if (divisible && std::ranges::any_of(spans[i].conics, &hasKink)) {
      round.distances_mm[i] = infinite;
      continue;
    }
    round.distances_mm[i] =
        distanceFromConics(piecesBetween(of.curve, points[i].u, points[i + 1].u), spans[i].conics,
                           tolerance_mm)
            .value_or(infinite);
  }
  return round;
}

/// Far more points than a tolerance above rounding needs: the error falls with the fourth power of
/// their number.
/// \throws std::domain_error otherwise.
void requireFewRounds(int round, const std::vector<ConicPoint>& points, const ConicRun& run,
                      double tolerance_mm) {
  constexpr int most_rounds = 64;
  constexpr std::size_t most_points = 4096, most_points_per_segment = 16;
  const std::size_t most =
      most_points + most_points_per_segment * static_cast<std::size_t>(run.end - run.begin);
  if (round < most_rounds && points.size() <= most) return;
  const Vector2d &start = points.front().point, &end = points.back().point;
  throw std::domain_error(fmt::format(
      "no conics keep the tolerance {:.6g} mm from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}): {} points "
      "after {} rounds do not suffice",
      tolerance_mm, start.x(), start.y(), end.x(), end.y(), points.size(), round));
}

/// Takes more points where conics are too far away, until none is. Returns where the curve turns
/// back, if it does; then nothing is appended.
std::optional<double> fitConicRun(const ConicFitCurve& of, const ConicRun& run, double tolerance_mm,
                                  const Progress& progress, ConicFit& result) {
  std::vector<ConicPoint> points = firstPoints(of, run);
  // A choice: where the order does not tell after these, as where the curvature jumps, halving
  // does.
  constexpr int most_regradings = 10;
  // The lengths are found with drafts.
  PairEffort effort = PairEffort::Draft;
  for (int round = 0;; ++round) {
    requireFewRounds(round, points, run, tolerance_mm);
    const Progress of_round = partOf(progress, shareAfter(round), shareAfter(round));
    const auto spans = spansThrough(points, run.closed, effort, of_round);
    if (!spans && appendSmall(of.curve, run, tolerance_mm, result)) return std::nullopt;
    const ConicRound found =
        spans ? measured(of, points, *spans, tolerance_mm, effort, of_round) : ConicRound{};
    if (found.sampled && round < most_regradings) {
      points = regraded(of.curve, points, found.distances_mm, tolerance_mm);
      continue;
    }
    if (spans && effort == PairEffort::Draft) {
      effort = PairEffort::Full;
      continue;
    }
    const std::vector<bool> sharp = spans ? std::vector<bool>{} : sharpSpans(points);
    std::vector<ConicPoint> finer;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const ConicPoint &from = points[i], &to = points[i + 1];
      finer.push_back(from);
      if (spans ? found.distances_mm[i] <= tolerance_mm : from.line_after || !sharp[i]) continue;
      if (to.u - from.u < shortest_span) {
        if (const auto stop = stopWithin(of.curve, from.u, to.u)) return stop;
        throw std::domain_error(
            fmt::format("no conics keep the tolerance {:.6g} mm at ({:.6g}, {:.6g}): the curve "
                        "turns back there, or the tolerance is below its rounding",
                        tolerance_mm, from.point.x(), from.point.y()));
      }
      const double middle = (from.u + to.u) / 2;
      finer.push_back({.u = middle, .point = of.curve.point(middle)});
    }
    finer.push_back(points.back());
    if (finer.size() == points.size()) {
      if (!spans)
        throw std::domain_error(fmt::format(
            "no conics pass through the lines from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g})",
            points.front().point.x(), points.front().point.y(), points.back().point.x(),
            points.back().point.y()));
      appendSpans(points, *spans, result);
      result.distance_mm = std::max(result.distance_mm, std::ranges::max(found.distances_mm));
      return std::nullopt;
    }
    points = std::move(finer);
  }
}

/// The parts of the curve between corners. A closed curve begins at the first corner.
std::vector<ConicRun> runsOf(ConicFitCurve& of) {
  const int n = of.curve.count();
  if (of.closed) {
    const auto first = std::ranges::find(of.corners, true);
    if (first == of.corners.end()) return {{.begin = 0, .end = n, .closed = true}};
    beginAt(of, static_cast<int>(first - of.corners.begin()));
  }
  std::vector<ConicRun> runs = {{.begin = 0, .end = n}};
  for (int joint = 1; joint < n; ++joint) {
    if (!of.corners[joint]) continue;
    runs.back().end = joint;
    runs.push_back({.begin = joint, .end = n});
  }
  return runs;
}

/// Fits all runs. Returns where the curve turns back within a segment, if it does.
std::optional<double> fitAllRuns(ConicFitCurve& of, const ConicFitOptions& options,
                                 const Progress& progress, ConicFit& result) {
  result = {.conics = {}, .corners = {}, .g1_joints = {}, .closed = of.closed};
  const std::vector<ConicRun> runs = runsOf(of);
  const double whole = of.curve.count();
  for (const ConicRun& run : runs) {
    const bool after_corner = &run != &runs.front() || (of.closed && !run.closed);
    const auto begin = static_cast<int>(result.conics.size());
    const auto stop = fitConicRun(of, run, options.tolerance_mm,
                                  partOf(progress, run.begin / whole, run.end / whole), result);
    if (stop) return stop;
    if (after_corner && begin < static_cast<int>(result.conics.size()))
      result.corners.push_back(begin);
  }
  std::ranges::sort(result.corners);
  return std::nullopt;
}

}  // namespace

ConicFit fitConics(const BezierSpline& spline, const ConicFitOptions& options,
                   const Progress& progress) {
  requireValid(spline);
  requireFitOptions(options.tolerance_mm, options.corner_rad);
  ConicFitCurve of{.curve = planarCurve(spline),
                   .closed = spline.closed,
                   .cusps = std::vector<bool>(static_cast<std::size_t>(spline.segments()), false),
                   .corners = {},
                   .lines = {}};
  ConicFit result;
  // A polynomial of degree n stops at n - 1 places at most.
  const int most_cuts = of.curve.count() * spline.degree;
  for (int cut = 0;; ++cut) {
    findCorners(of, options);
    const auto stop = fitAllRuns(of, options, progress, result);
    if (!stop) break;
    if (cut == most_cuts)
      throw std::domain_error(fmt::format("the curve turns back more than {} times", most_cuts));
    turnBackAt(of, *stop);
  }
  if (result.conics.empty())
    throw std::domain_error(
        fmt::format("the curve is a point ({}, {})", of.curve.point(0).x(), of.curve.point(0).y()));
  return result;
}

}  // namespace seamwright
