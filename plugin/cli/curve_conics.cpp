// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <seamwright/core/planar/conic_fit.hpp>
#include <seamwright/core/planar/conic_spline.hpp>
#include <seamwright/core/planar/point_corners.hpp>
#include <seamwright/plugin/cli/curve_conics.hpp>
#include <seamwright/plugin/cli/curve_figures.hpp>
#include <seamwright/plugin/cli/faired_points.hpp>
#include <seamwright/plugin/cli/smooth_curve.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

using report::CurveFigures;

void noteJoints(report::CurveRecord& record, std::size_t g1_joints) {
  if (g1_joints > 0)
    record.notes.push_back(fmt::format(
        "{} joint{} G1 only: the curvature changes its sign there, or a line is beside it",
        g1_joints, g1_joints == 1 ? " is" : "s are"));
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
    const GivenCurve part = runOf(given, run, closed && corners.empty());
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

}  // namespace

MadeCurve madeConics(const GivenCurve& given, const CurveTask& task) {
  return given.points.rows() > 0 ? conicsOfPoints(given, task) : conicsNearCurve(given, task);
}

}  // namespace seamwright::cli
