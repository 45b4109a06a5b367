// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <seamwright/core/planar/arc_fit.hpp>
#include <seamwright/core/planar/clothoid_fit.hpp>
#include <seamwright/core/planar/clothoid_spline.hpp>
#include <seamwright/core/planar/conic_fit.hpp>
#include <seamwright/core/planar/conic_spline.hpp>
#include <seamwright/core/planar/fair_clothoids.hpp>
#include <seamwright/core/planar/fair_points.hpp>
#include <seamwright/core/planar/point_corners.hpp>
#include <seamwright/core/planar/tangent_chain.hpp>
#include <seamwright/plugin/cli/curve_figures.hpp>
#include <seamwright/plugin/cli/curve_methods.hpp>
#include <seamwright/plugin/cli/fair_splines.hpp>
#include <seamwright/plugin/cli/local_curve.hpp>
#include <seamwright/plugin/cli/point_curves.hpp>
#include <seamwright/plugin/cli/rounding.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

using report::CurveFigures;

PlanarChain chainOf(const std::vector<PlanarArc>& arcs, bool closed) {
  return {.curves = {arcs.begin(), arcs.end()}, .closed = closed};
}

/// The curve that is approximated, and its distance from the one that was asked for.
struct SmoothCurve {
  PlanarChain chain;
  double distance_mm = 0;
  CurveFigures figures = {};
};

SmoothCurve biarcsThrough(const GivenCurve& given) {
  const bool closed = given.record.closed;
  SmoothCurve curve{chainOf(biarcsOf(given.points, closed).arcs, closed)};
  curve.figures = figuresFrom(figuresOf(curve.chain));
  return curve;
}

/// A spline within a distance of clothoids.
SmoothCurve splineOf(const std::vector<Clothoid>& pieces, bool closed, double tolerance_mm) {
  double size_mm = 1;
  for (const Clothoid& piece : pieces) size_mm = std::max(size_mm, piece.start.norm());
  const SplineWithin spline = bezierSpline(pieces, tolerance_mm, closed, 1e-9 * size_mm);
  return {
      .chain = {.curves = {bsplineCurve(spline.curve, continuity(spline.curve))}, .closed = closed},
      .distance_mm = spline.distance_mm,
      .figures = figuresFrom(figuresOf(pieces, closed))};
}

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

/// Rounding of the ends of arcs and of coordinates in the plane.
double gapOf(const GivenCurve& given, const PlanarChain& chain) {
  double size_mm = 0;
  for (const ChainCurve& curve : chain.curves)
    size_mm = std::max(
        {size_mm, startOf(curve).cwiseAbs().maxCoeff(), endOf(curve).cwiseAbs().maxCoeff()});
  return given.gap_mm + 1e-12 * (1 + size_mm);
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

CurveWithArcs arcsOf(const GivenCurve& given, const CurveTask& task) {
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

/// The chain of lines and arcs of which the points of a closed curve are samples; nothing if it
/// does not have fewer than so many.
std::optional<CurveWithArcs> arcsSampledBy(const GivenCurve& given, double tolerance_mm,
                                           std::size_t fewer_than) {
  if (!given.record.closed || given.points.rows() == 0 || tolerance_mm == 0) return std::nullopt;
  std::vector<Eigen::Vector2d> points;
  for (const auto& point : given.points.rowwise()) points.emplace_back(point.transpose());
  const auto sampled = sampledChain(points, tolerance_mm);
  if (!sampled || sampled->arcs.size() >= fewer_than) return std::nullopt;
  CurveWithArcs result{.curve = {.chain = chainOf(sampled->arcs, true)}, .fit = {}};
  result.curve.figures = figuresFrom(figuresOf(result.curve.chain));
  result.fit = {.arcs = sampled->arcs, .corners = {}, .closed = true};
  result.fit.distance_mm = sampled->distance_mm;
  return result;
}

MadeCurve madeArcs(const GivenCurve& given, const CurveTask& task) {
  MadeCurve made{.record = given.record};
  CurveWithArcs near = arcsOf(given, task);
  if (auto sampled = arcsSampledBy(given, task.tolerance_mm, near.fit.arcs.size())) {
    near = *std::move(sampled);
    made.record.notes.emplace_back(
        "the points are samples of these lines and arcs: the distance is that of the points");
  }
  const auto& [curve, fit] = near;
  made.chain = chainOf(fit.arcs, fit.closed);
  made.record.pieces = static_cast<int>(fit.arcs.size());
  made.record.lines = linesIn(fit.arcs);
  made.record.corners = static_cast<int>(fit.corners.size());
  made.record.distance_mm = fit.distance_mm;
  made.record.before = curve.figures;
  made.record.after = figuresFrom(figuresOf(made.chain));
  return made;
}

/// Spline through clothoids for a model file, and the figures.
void takeClothoids(MadeCurve& made, std::vector<Clothoid> pieces, double tolerance_mm) {
  const bool closed = made.record.closed;
  made.record.after = figuresFrom(figuresOf(pieces, closed));
  // A tenth of the tolerance is left to the spline; without a tolerance a billionth of the length.
  const double spline_mm =
      tolerance_mm > 0 ? 0.1 * tolerance_mm : 1e-9 * made.record.after.length_mm;
  SmoothCurve spline = splineOf(pieces, closed, spline_mm);
  made.chain = std::move(spline.chain);
  made.chain_distance_mm = spline.distance_mm;
  made.record.pieces = static_cast<int>(pieces.size());
  made.clothoids = std::move(pieces);
}

MadeCurve madeClothoids(const GivenCurve& given, const CurveTask& task) {
  MadeCurve made{.record = given.record};
  if (given.points.rows() > 0) {
    made.record.distance_mm = 0;
    made.record.before = biarcsThrough(given).figures;
    takeClothoids(made, clothoidsOf(given.points, given.record.closed, task.progress).pieces,
                  task.tolerance_mm);
    return made;
  }
  const ClothoidFit fit = fitClothoids(bezierSpline(given.chain, gapOf(given, given.chain)),
                                       {.tolerance_mm = task.tolerance_mm}, task.progress);
  made.record.corners = static_cast<int>(fit.corners.size());
  made.record.distance_mm = fit.distance_mm;
  made.record.before = figuresFrom(figuresOf(given.chain, partOf(task.progress, 1, 1)));
  takeClothoids(made, fit.pieces, task.tolerance_mm);
  return made;
}

void noteJoints(report::CurveRecord& record, std::size_t g1_joints) {
  if (g1_joints > 0)
    record.notes.push_back(fmt::format(
        "{} joint{} G1 only: the curvature changes its sign there, or a line is beside it",
        g1_joints, g1_joints == 1 ? " is" : "s are"));
}

void addFigures(CurveFigures& sum, const CurveFigures& part) {
  sum.length_mm += part.length_mm;
  sum.energy_per_mm = sum.energy_per_mm.value_or(0) + part.energy_per_mm.value_or(0);
  sum.extrema += part.extrema;
  sum.inflections += part.inflections;
}

/// Of conics through points; nothing if a conic has a kink.
std::optional<CurveFigures> figuresThrough(const PlanarChain& conics) {
  try {
    return figuresFrom(figuresOf(conics));
  } catch (const std::domain_error&) {  // of a conic with a kink
    return std::nullopt;
  }
}

/// Conics from corner to corner of the points; nothing if one has a kink.
std::optional<MadeCurve> conicsThrough(const GivenCurve& given, const Progress& progress) {
  const bool closed = given.record.closed;
  const std::vector<Eigen::Index> corners =
      given.points.rows() < 3
          ? std::vector<Eigen::Index>{}
          : pointCorners(given.points, {.closed = closed, .error_mm = given.rounding_mm});
  MadeCurve made{.record = given.record};
  made.chain.closed = closed;
  std::size_t g1_joints = 0, between_lines = 0;
  double done = 0;
  for (const std::vector<Eigen::Index>& run : runsBetween(given.points.rows(), corners, closed)) {
    const double end = std::min(
        1.0, done + static_cast<double>(run.size()) / static_cast<double>(given.points.rows()));
    GivenCurve part;
    part.points = given.points(run, Eigen::indexing::all);
    part.record.closed = closed && corners.empty();
    const ConicSpline spline =
        conicSpline(part.points, part.record.closed, partOf(progress, done, end));
    done = end;
    made.chain.curves.insert(made.chain.curves.end(), spline.conics.begin(), spline.conics.end());
    g1_joints += spline.g1_joints.size();
    between_lines += spline.corners.size();
    addFigures(made.record.before, biarcsThrough(part).figures);
  }
  made.record.pieces = static_cast<int>(made.chain.curves.size());
  made.record.corners = static_cast<int>(corners.size() + between_lines);
  made.record.distance_mm = 0;
  const std::optional<CurveFigures> after = figuresThrough(made.chain);
  if (!after) return std::nullopt;
  made.record.after = *after;
  noteJoints(made.record, g1_joints);
  if (between_lines > 0)
    made.record.notes.push_back(fmt::format("{} corner{}: there are points on a line on both sides",
                                            between_lines, between_lines == 1 ? "" : "s"));
  return made;
}

CurveFigures withVariation(const ClothoidFigures& figures) {
  CurveFigures result = figuresFrom(figures);
  result.variation_per_mm3 = figures.variation_per_mm3;
  return result;
}

/// A spline from corner to corner.
void takeRuns(MadeCurve& made, const FairedClothoids& faired, double tolerance_mm) {
  // As for takeClothoids().
  const double spline_mm = tolerance_mm > 0 ? 0.1 * tolerance_mm : 1e-9 * faired.after.length_mm;
  const bool closed = made.record.closed;
  std::vector<Clothoid> pieces = faired.pieces;
  std::vector<std::ptrdiff_t> cuts(faired.corners.begin(), faired.corners.end());
  if (closed && !cuts.empty()) {  // a closed curve begins at a corner
    const std::ptrdiff_t first = cuts.front();
    std::rotate(pieces.begin(), pieces.begin() + first, pieces.end());
    for (std::ptrdiff_t& cut : cuts) cut -= first;
  } else {
    cuts.insert(cuts.begin(), 0);
  }
  cuts.push_back(std::ssize(pieces));
  made.chain.closed = closed;
  for (std::size_t k = 1; k < cuts.size(); ++k) {
    const std::vector<Clothoid> run(pieces.begin() + cuts[k - 1], pieces.begin() + cuts[k]);
    SmoothCurve spline = splineOf(run, closed && faired.corners.empty(), spline_mm);
    made.chain.curves.push_back(std::move(spline.chain.curves.front()));
    made.chain_distance_mm = std::max(made.chain_distance_mm, spline.distance_mm);
  }
  made.clothoids = faired.pieces;
}

/// What the points let expect and the curve does not keep.
void noteTurns(report::CurveRecord& record, const FairedClothoids& faired) {
  const int more = faired.after.inflections - faired.point_inflections;
  if (more > 0)
    record.notes.push_back(
        fmt::format("{} more inflection{} than the circles through three faired points", more,
                    more == 1 ? "" : "s"));
}

Eigen::VectorXd tolerancesOf(const GivenCurve& given, const CurveTask& task) {
  if (given.tolerances_mm.size() > 0) return given.tolerances_mm;
  return Eigen::VectorXd::Constant(given.points.rows(), task.tolerance_mm);
}

/// The middle one of those above 0, so that few points with large ones do not hide corners.
double middleOf(const Eigen::VectorXd& tolerances_mm) {
  std::vector<double> sorted;
  for (const double tolerance_mm : tolerances_mm)
    if (tolerance_mm > 0) sorted.push_back(tolerance_mm);
  if (sorted.empty()) return 0;
  const auto middle = sorted.begin() + std::ssize(sorted) / 2;
  std::ranges::nth_element(sorted, middle);
  return *middle;
}

/// The points to be made fair: without those that repeat a neighbour.
struct PointsToFair {
  GivenCurve curve;
  Eigen::VectorXd tolerances_mm;
  std::vector<PointTwin> twins = {};
  std::vector<Eigen::Index> kept = {};
};

/// A point that stands for another one moves by less, so that the other one is within its
/// tolerance.
PointsToFair pointsToFair(const GivenCurve& given, const CurveTask& task) {
  PointsToFair result{.curve = given, .tolerances_mm = tolerancesOf(given, task)};
  result.twins = pointTwins(given.points, result.tolerances_mm, given.record.closed);
  if (result.twins.empty()) return result;
  Eigen::VectorXd& tolerances_mm = result.tolerances_mm;
  std::vector<bool> left_out(static_cast<std::size_t>(given.points.rows()));
  for (const PointTwin& twin : result.twins) {
    const double gap_mm = (given.points.row(twin.left_out) - given.points.row(twin.kept)).norm();
    left_out[static_cast<std::size_t>(twin.left_out)] = true;
    tolerances_mm(twin.kept) =
        std::min(tolerances_mm(twin.kept), tolerances_mm(twin.left_out) - gap_mm);
  }
  for (Eigen::Index i = 0; i < given.points.rows(); ++i)
    if (!left_out[static_cast<std::size_t>(i)]) result.kept.push_back(i);
  const PlanarPoints points = given.points(result.kept, Eigen::indexing::all);
  const Eigen::VectorXd tolerances = tolerances_mm(result.kept);
  result.curve.points = points;
  result.tolerances_mm = tolerances;
  result.curve.lines.clear();
  for (const Eigen::Index i : result.kept)
    result.curve.lines.push_back(given.lines[static_cast<std::size_t>(i)]);
  return result;
}

/// The largest distance of a point that was left out from the one that stands for it.
double leftOutWithin_mm(const GivenCurve& given, const PointsToFair& part,
                        const PlanarPoints& faired) {
  double largest_mm = 0;
  for (const PointTwin& twin : part.twins) {
    const auto at = std::ranges::lower_bound(part.kept, twin.kept) - part.kept.begin();
    largest_mm = std::max(largest_mm, (faired.row(at) - given.points.row(twin.left_out)).norm());
  }
  return largest_mm;
}

void noteTwins(report::CurveRecord& record, const GivenCurve& given, const PointsToFair& part) {
  if (!part.twins.empty()) {
    const auto lineOf = [&](Eigen::Index i) { return given.lines[static_cast<std::size_t>(i)]; };
    const PointTwin& first = part.twins.front();
    const double gap_mm = (given.points.row(first.left_out) - given.points.row(first.kept)).norm();
    const std::string more =
        part.twins.size() == 1 ? "" : fmt::format(", and {} more", part.twins.size() - 1);
    record.notes.push_back(
        fmt::format("left out: the point of line {}, {:.3g} mm from that of line {}{}",
                    lineOf(first.left_out), gap_mm, lineOf(first.kept), more));
  }
  if (const std::string crowded = crowdedPoints(part.curve); !crowded.empty())
    record.notes.push_back(crowded);
}

MadeCurve madeFairPoints(const GivenCurve& given, const CurveTask& task) {
  const bool closed = given.record.closed;
  const PointsToFair part = pointsToFair(given, task);
  const PlanarPoints& points = part.curve.points;
  constexpr Eigen::Index least_points = 3;
  if (points.rows() < least_points && !part.twins.empty())
    throw std::domain_error(
        fmt::format("{} of the {} points repeat their neighbours: at least {} "
                    "others are needed",
                    part.twins.size(), given.points.rows(), least_points));
  // Points are off by their rounding, also where the tolerance is smaller.
  const double error_mm = std::max(middleOf(tolerancesOf(given, task)), given.rounding_mm);
  const FairedClothoids faired =
      fairClothoids(points, part.tolerances_mm,
                    {.closed = closed,
                     .corners = pointCorners(points, {.closed = closed, .error_mm = error_mm}),
                     .ends_fixed = !given.free_ends},
                    task.progress);
  MadeCurve made{.record = given.record};
  made.points = faired.points;
  takeRuns(made, faired, task.tolerance_mm);
  made.record.pieces = static_cast<int>(faired.points.rows());
  made.record.corners = static_cast<int>(faired.corners.size());
  made.record.moved_mm = faired.moved_mm;
  made.record.distance_mm = std::max(faired.moved_mm, leftOutWithin_mm(given, part, faired.points));
  made.record.after = withVariation(faired.after);
  if (faired.before) {
    made.record.before = withVariation(*faired.before);
  } else {
    made.record.before = biarcsThrough(part.curve).figures;
    made.record.notes.push_back(
        "no clothoids pass through the points as read: the figures before are those of biarcs");
  }
  noteTwins(made.record, given, part);
  noteTurns(made.record, faired);
  return made;
}

/// Conics through points of a curve.
void takeConics(MadeCurve& made, const PlanarChain& chain, double gap_mm, const CurveTask& task) {
  const ConicFit fit =
      fitConics(bezierSpline(chain, gap_mm), {.tolerance_mm = task.tolerance_mm}, task.progress);
  made.chain = {.curves = {fit.conics.begin(), fit.conics.end()}, .closed = fit.closed};
  made.record.pieces = static_cast<int>(fit.conics.size());
  made.record.corners = static_cast<int>(fit.corners.size());
  made.record.distance_mm = fit.distance_mm;
  noteJoints(made.record, fit.g1_joints.size());
  made.record.after = figuresFrom(figuresOf(made.chain, partOf(task.progress, 1, 1)));
}

MadeCurve conicsNearCurve(const GivenCurve& given, const CurveTask& task) {
  MadeCurve made{.record = given.record};
  takeConics(made, given.chain, gapOf(given, given.chain), task);
  made.record.before = figuresFrom(figuresOf(given.chain, partOf(task.progress, 1, 1)));
  return made;
}

/// Conics near the clothoids through points made fair; nothing if there are no such clothoids.
std::optional<MadeCurve> conicsNearPoints(const GivenCurve& given, const CurveTask& task) {
  // Choices: halves of the tolerance for the moves of points and for the conics.
  constexpr double moves = 0.5, fairing_share = 0.5;
  CurveTask fairing = task;
  fairing.tolerance_mm *= moves;
  fairing.progress = partOf(task.progress, 0, fairing_share);
  MadeCurve made{.record = given.record};
  try {
    made = madeFairPoints(given, fairing);
  } catch (const std::domain_error&) {  // the points are too few for their turns
    return std::nullopt;
  }
  const double off_mm = *made.record.distance_mm + made.chain_distance_mm;
  CurveTask fitting = task;
  fitting.tolerance_mm -= off_mm;
  fitting.progress = partOf(task.progress, fairing_share, 1);
  made.record.notes = given.record.notes;
  made.points.resize(0, 2);
  made.clothoids.clear();
  made.record.moved_mm.reset();
  const PlanarChain chain = std::move(made.chain);
  made.chain_distance_mm = 0;
  takeConics(made, chain, gapOf(given, chain), fitting);
  *made.record.distance_mm += off_mm;
  made.record.before = biarcsThrough(given).figures;
  return made;
}

int turnsOf(const CurveFigures& figures) {
  return figures.extrema + figures.inflections;
}

/// Conics through the points, or near them if these have fewer extrema and inflections.
MadeCurve conicsOfPoints(const GivenCurve& given, const CurveTask& task) {
  constexpr double through_share = 0.1;
  std::optional<MadeCurve> through = conicsThrough(given, partOf(task.progress, 0, through_share));
  std::optional<MadeCurve> near;
  if (task.tolerance_mm > 0 && given.points.rows() >= 3) {
    CurveTask rest = task;
    rest.progress = partOf(task.progress, through_share, 1);
    near = conicsNearPoints(given, rest);
  }
  if (near && (!through || turnsOf(near->record.after) < turnsOf(through->record.after)))
    return *std::move(near);
  if (!through)
    throw std::domain_error(fmt::format(
        "the points wave so much that a conic through them has a kink: give more than {:.3g} mm "
        "as --tolerance",
        task.tolerance_mm));
  return *std::move(through);
}

MadeCurve madeConics(const GivenCurve& given, const CurveTask& task) {
  return given.points.rows() > 0 ? conicsOfPoints(given, task) : conicsNearCurve(given, task);
}

MadeCurve madeFair(const GivenCurve& given, const CurveTask& task) {
  return given.points.rows() > 0 ? madeFairPoints(given, task) : madeFairSplines(given, task);
}

/// Extrema and inflections that the work added. Returns whether there are some.
bool noteAdded(report::CurveRecord& record) {
  const auto note = [&](int added, const char* one, const char* more) {
    if (added > 0)
      record.notes.push_back(fmt::format("{} more {} than before", added, added == 1 ? one : more));
    return added > 0;
  };
  const bool extrema = note(record.after.extrema - record.before.extrema,
                            "extremum of the curvature", "extrema of the curvature");
  const bool inflections =
      note(record.after.inflections - record.before.inflections, "inflection", "inflections");
  return extrema || inflections;
}

/// Curves through points have the extrema of the curvature that rounding of the points made.
void noteRounding(report::CurveRecord& record, const GivenCurve& given, double tolerance_mm) {
  constexpr Eigen::Index least_points = 3;
  if (given.rounding_mm == 0 || given.points.rows() < least_points) return;
  const PointFairness certain = fairnessOf(given.points, record.closed, given.rounding_mm);
  const auto extrema = static_cast<int>(certain.extrema.size());
  if (extrema < record.before.extrema)
    record.notes.push_back(fmt::format(
        "the points, rounded by up to {:.2g} mm, certainly have only {} of the {} extrema before{}",
        given.rounding_mm, extrema, record.before.extrema,
        tolerance_mm < given.rounding_mm ? ": give a larger --tolerance" : ""));
}

MadeCurve madeBy(const std::string& method, const GivenCurve& given, const CurveTask& task) {
  if (method == "arcs") return madeArcs(given, task);
  if (method == "clothoid") return madeClothoids(given, task);
  if (method == "conic") return madeConics(given, task);
  return madeFair(given, task);
}

/// A method may fail because two points are far nearer to each other than the others.
MadeCurve madeOf(const std::string& method, const GivenCurve& given, const CurveTask& task) {
  try {
    return madeBy(method, given, task);
  } catch (const std::domain_error&) {
    const std::string crowded = given.points.rows() > 0 ? crowdedPoints(given) : "";
    if (crowded.empty()) throw;
    throw std::domain_error(crowded);
  }
}

}  // namespace

const std::vector<std::string>& curveMethods() {
  static const std::vector<std::string> names = {"arcs", "clothoid", "conic", "fair"};
  return names;
}

MadeCurve madeCurve(const std::string& method, const GivenCurve& given, const CurveTask& task) {
  checkProgress(task.progress, 0);
  if (given.points.rows() == 0 && method != "fair" && !(task.tolerance_mm > 0))
    throw std::invalid_argument("--tolerance is 0 mm: curves of a model need more");
  requireSize(given);
  const LocalCurve local = localCurve(given);
  requireAboveRounding(task.tolerance_mm, local.given);
  MadeCurve made = madeOf(method, local.given, taskOf(local, task));
  if (!local.origin.isZero(0)) moveBack(made, local);
  const bool has_notes = made.record.notes != given.record.notes, added = noteAdded(made.record);
  // Arcs have jumps of the curvature, which nobody takes for a fair curve.
  made.record.with_reservations |= method != "arcs" && (added || (method == "conic" && has_notes));
  noteRounding(made.record, local.given, task.tolerance_mm);
  return made;
}

}  // namespace seamwright::cli
