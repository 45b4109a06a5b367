// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <seamwright/core/angle.hpp>
#include <seamwright/core/planar/arc_fit.hpp>
#include <seamwright/core/planar/point_corners.hpp>
#include <seamwright/core/planar/sampled_chain.hpp>
#include <seamwright/plugin/cli/curve_arcs.hpp>
#include <seamwright/plugin/cli/curve_figures.hpp>
#include <seamwright/plugin/cli/point_curves.hpp>
#include <seamwright/plugin/cli/smooth_curve.hpp>
#include <stdexcept>
#include <string>

namespace seamwright::cli {

namespace {

/// That of the model; of points with a tolerance the clothoids through them, which are smoother
/// than biarcs, so that fewer arcs are near; of points without one the biarcs through them.
SmoothCurve curveOf(const GivenCurve& given, double tolerance_mm, const Progress& progress) {
  if (given.points.rows() == 0)
    return {.chain = given.chain, .figures = figuresFrom(figuresOf(given.chain, progress))};
  if (tolerance_mm == 0 || given.points.rows() < 3) return biarcsThrough(given);
  constexpr double share = 0.05;
  const bool closed = given.record.closed;
  try {
    return splineOf(clothoidsOf(given.points, closed, progress).pieces, closed,
                    share * tolerance_mm);
  } catch (const std::domain_error&) {  // the points are too few for their turns
    return biarcsThrough(given);
  }
}

/// Whether the polygon of the points samples a curve: circles with the turns at its corners are
/// nearer to its sides than half the tolerance. At least 3/4 of the width are left to the arcs
/// then, so that by P9.2 at most a tenth more are needed.
bool isDense(const GivenCurve& given, double tolerance_mm) {
  constexpr double share = 0.5;
  const Eigen::Index n = given.points.rows();
  const bool closed = given.record.closed;
  if (n < 3 || tolerance_mm == 0) return false;
  const auto at = [&](Eigen::Index i) -> Eigen::Vector2d { return given.points.row((i + n) % n); };
  for (Eigen::Index i = closed ? 0 : 1; i < (closed ? n : n - 1); ++i) {
    const Eigen::Vector2d before = at(i) - at(i - 1), after = at(i + 1) - at(i);
    const double turn_rad = std::abs(angleFromTo(before, after));
    const double sagitta_mm = std::min(before.norm(), after.norm()) / 2 * std::tan(turn_rad / 4);
    if (sagitta_mm > share * tolerance_mm) return false;
  }
  return true;
}

/// The figures are those of the biarcs.
SmoothCurve polygonOf(const GivenCurve& given) {
  const Eigen::Index n = given.points.rows();
  std::vector<PlanarArc> sides;
  for (Eigen::Index i = 0; i < (given.record.closed ? n : n - 1); ++i) {
    const Eigen::Vector2d start = given.points.row(i), end = given.points.row((i + 1) % n);
    sides.push_back({.start = start,
                     .direction_rad = directionOf(end - start),
                     .length_mm = (end - start).norm()});
  }
  return {.chain = chainOf(sides, given.record.closed), .figures = biarcsThrough(given).figures};
}

int linesIn(const std::vector<PlanarArc>& arcs) {
  return static_cast<int>(std::ranges::count(arcs, 0.0, &PlanarArc::curvature_per_mm));
}

/// Arcs near the curve; with a tolerance of 0 the biarcs through points themselves.
ArcFit arcsNear(const GivenCurve& given, const SmoothCurve& curve, double tolerance_mm,
                const Progress& progress) {
  if (given.points.rows() > 0 && tolerance_mm == 0) {
    ArcFit fit{.arcs = {}, .corners = {}, .closed = curve.chain.closed};
    for (const ChainCurve& arc : curve.chain.curves) fit.arcs.push_back(std::get<PlanarArc>(arc));
    return fit;
  }
  ArcFit fit = fitArcs(bezierSpline(curve.chain, gapOf(given, curve.chain)),
                       {.tolerance_mm = tolerance_mm - curve.distance_mm}, progress);
  fit.distance_mm += curve.distance_mm;
  return fit;
}

/// The curve with the fewer arcs.
struct CurveWithArcs {
  SmoothCurve curve;
  ArcFit fit;
};

/// Of a curve without corners.
CurveWithArcs smoothArcs(const GivenCurve& given, const CurveTask& task) {
  if (isDense(given, task.tolerance_mm)) {
    SmoothCurve polygon = polygonOf(given);
    ArcFit fit = arcsNear(given, polygon, task.tolerance_mm, task.progress);
    if (fit.arcs.size() > 1) return {.curve = std::move(polygon), .fit = std::move(fit)};
    // Points of a circle: the arc through them is nearer than that along the polygon.
    SmoothCurve biarcs = biarcsThrough(given);
    ArcFit through = arcsNear(given, biarcs, task.tolerance_mm, task.progress);
    if (through.arcs.size() == 1) return {.curve = std::move(biarcs), .fit = std::move(through)};
    return {.curve = std::move(polygon), .fit = std::move(fit)};
  }
  // Choices of shares: the clothoids take about a tenth of the time, two chains of arcs the rest.
  constexpr double curve_share = 0.1, first_share = 0.55;
  SmoothCurve curve = curveOf(given, task.tolerance_mm, partOf(task.progress, 0, curve_share));
  ArcFit fit =
      arcsNear(given, curve, task.tolerance_mm, partOf(task.progress, curve_share, first_share));
  if (given.points.rows() > 0 && task.tolerance_mm > 0) {
    // Points of a circle or a line are on one arc, which biarcs find.
    SmoothCurve biarcs = biarcsThrough(given);
    ArcFit other =
        arcsNear(given, biarcs, task.tolerance_mm, partOf(task.progress, first_share, 1));
    if (other.arcs.size() < fit.arcs.size()) {
      curve = std::move(biarcs);
      fit = std::move(other);
    }
  }
  return {.curve = std::move(curve), .fit = std::move(fit)};
}

/// From corner to corner of the points.
CurveWithArcs arcsBetween(const GivenCurve& given, const std::vector<Eigen::Index>& corners,
                          const CurveTask& task) {
  const bool closed = given.record.closed;
  const auto points = static_cast<double>(given.points.rows());
  CurveWithArcs result;
  result.fit.closed = closed;
  double done = 0;
  for (const std::vector<Eigen::Index>& run : runsBetween(given.points.rows(), corners, closed)) {
    CurveTask part = task;
    const double end = std::min(1.0, done + static_cast<double>(run.size()) / points);
    part.progress = partOf(task.progress, done, end);
    CurveWithArcs near = smoothArcs(runOf(given, run, false), part);
    std::vector<PlanarArc>& arcs = result.fit.arcs;
    if (done > 0 || closed) result.fit.corners.push_back(static_cast<int>(arcs.size()));
    for (const int corner : near.fit.corners)
      result.fit.corners.push_back(static_cast<int>(arcs.size()) + corner);
    arcs.insert(arcs.end(), near.fit.arcs.begin(), near.fit.arcs.end());
    result.fit.distance_mm = std::max(result.fit.distance_mm, near.fit.distance_mm);
    addFigures(result.curve.figures, near.curve.figures);
    done = end;
  }
  return result;
}

CurveWithArcs arcsOf(const GivenCurve& given, const CurveTask& task) {
  constexpr Eigen::Index least_points = 3;
  if (given.points.rows() < least_points) return smoothArcs(given, task);
  const double error_mm = std::max(task.tolerance_mm, given.rounding_mm);
  const std::vector<Eigen::Index> corners =
      pointCorners(given.points, {.closed = given.record.closed, .error_mm = error_mm});
  return corners.empty() ? smoothArcs(given, task) : arcsBetween(given, corners, task);
}

/// The lines and arcs of which the points are samples; nothing if the other ones are fewer, or as
/// many with more lines, or with as many and not much further from the points.
std::optional<CurveWithArcs> arcsSampledBy(const GivenCurve& given, double tolerance_mm,
                                           const ArcFit& other) {
  if (given.points.rows() == 0 || tolerance_mm == 0) return std::nullopt;
  const bool closed = given.record.closed;
  const auto sampled =
      sampledChain(given.points, {.closed = closed,
                                  .tolerance_mm = tolerance_mm,
                                  .most_arcs = static_cast<int>(other.arcs.size())});
  if (!sampled) return std::nullopt;
  constexpr double much = 0.1;  // of the tolerance
  const int more_lines = linesIn(sampled->arcs) - linesIn(other.arcs);
  const bool is_nearer = sampled->distance_mm + much * tolerance_mm < other.distance_mm;
  if (sampled->arcs.size() == other.arcs.size() &&
      (more_lines < 0 || (more_lines == 0 && !is_nearer)))
    return std::nullopt;
  CurveWithArcs result{.curve = {.chain = chainOf(sampled->arcs, closed)}, .fit = {}};
  result.curve.figures = figuresFrom(figuresOf(result.curve.chain));
  result.fit = {.arcs = sampled->arcs, .corners = sampled->corners, .closed = closed};
  result.fit.distance_mm = sampled->distance_mm;
  return result;
}

const char* samplesNote(const ArcFit& sampled, double tolerance_mm) {
  constexpr double of_exact_points = 0.1;
  if (sampled.distance_mm <= of_exact_points * tolerance_mm)
    return "the points are samples of these lines and arcs: the distance is that of the points";
  return "the points are near these lines and arcs, with errors up to the distance; if they are "
         "exact "
         "points of another curve, give a smaller --tolerance";
}

/// Lines from point to point.
CurveWithArcs linesOf(const GivenCurve& given) {
  CurveWithArcs result{.curve = polygonOf(given), .fit = {}};
  result.curve.figures = figuresFrom(figuresOf(result.curve.chain));
  ArcFit& fit = result.fit;
  fit.closed = given.record.closed;
  for (const ChainCurve& side : result.curve.chain.curves)
    fit.arcs.push_back(std::get<PlanarArc>(side));
  const double straight_rad = ArcFitOptions{}.corner_rad;
  for (std::size_t i = fit.closed ? 0 : 1; i < fit.arcs.size(); ++i) {
    const PlanarArc& before = fit.arcs[(i + fit.arcs.size() - 1) % fit.arcs.size()];
    const double turn_rad = wrapped(fit.arcs[i].direction_rad - before.direction_rad);
    if (std::abs(turn_rad) > straight_rad) fit.corners.push_back(static_cast<int>(i));
  }
  return result;
}

/// What to say if arcs pass through points that can be corners as well; empty otherwise.
std::string cornersNote(const GivenCurve& given, double tolerance_mm) {
  const Eigen::Index n = given.points.rows();
  const bool closed = given.record.closed;
  const Eigen::Index turning = closed ? n : n - 2;
  if (turning < 2) return "";
  double turns_rad = 0;
  for (Eigen::Index i = closed ? 0 : 1; i < (closed ? n : n - 1); ++i) {
    const Eigen::Vector2d before = given.points.row(i) - given.points.row((i + n - 1) % n),
                          after = given.points.row((i + 1) % n) - given.points.row(i);
    // Errors turn points that are nearer.
    constexpr double errors_away = 4;
    if (std::min(before.norm(), after.norm()) > errors_away * tolerance_mm)
      turns_rad += std::abs(angleFromTo(before, after));
  }
  const double mean_deg = turns_rad / static_cast<double>(turning) / radians_per_degree;
  // A choice: ten points of a circle turn by 36 degrees.
  constexpr double least_deg = 35;
  if (mean_deg < least_deg) return "";
  return fmt::format(
      "the points turn by {:.0f} degrees on average: they count as samples of a curve; if they are "
      "corners, give --polygon",
      mean_deg);
}

}  // namespace

MadeCurve madeArcs(const GivenCurve& given, const CurveTask& task) {
  MadeCurve made{.record = given.record};
  CurveWithArcs near = given.polygon ? linesOf(given) : arcsOf(given, task);
  auto sampled = given.polygon ? std::nullopt : arcsSampledBy(given, task.tolerance_mm, near.fit);
  if (sampled) {
    near = *std::move(sampled);
    made.record.notes.emplace_back(samplesNote(near.fit, task.tolerance_mm));
  }
  const auto& [curve, fit] = near;
  made.chain = chainOf(fit.arcs, fit.closed);
  made.record.pieces = static_cast<int>(fit.arcs.size());
  made.record.lines = linesIn(fit.arcs);
  if (made.record.lines < made.record.pieces)
    if (const std::string note = cornersNote(given, task.tolerance_mm); !note.empty())
      made.record.notes.push_back(note);
  made.record.corners = static_cast<int>(fit.corners.size());
  made.record.distance_mm = fit.distance_mm;
  made.record.before = curve.figures;
  made.record.after = figuresFrom(figuresOf(made.chain));
  return made;
}

}  // namespace seamwright::cli
