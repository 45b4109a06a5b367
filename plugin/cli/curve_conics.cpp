// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <seamwright/core/planar/conic_fit.hpp>
#include <seamwright/core/planar/conic_spline.hpp>
#include <seamwright/core/planar/point_corners.hpp>
#include <seamwright/plugin/cli/curve_conics.hpp>
#include <seamwright/plugin/cli/curve_figures.hpp>
#include <seamwright/plugin/cli/faired_points.hpp>
#include <seamwright/plugin/cli/rounding.hpp>
#include <seamwright/plugin/cli/smooth_curve.hpp>
#include <stdexcept>
#include <utility>

namespace seamwright::cli {

namespace {

using report::CurveFigures;

int turnsOf(const CurveFigures& figures) {
  return figures.extrema + figures.inflections;
}

void noteJoints(report::CurveRecord& record, std::size_t g1_joints) {
  if (g1_joints == 0) return;
  record.with_reservations = true;
  record.notes.push_back(fmt::format(
      "{} joint{} G1 only: the curvature changes its sign there, or a line is beside it", g1_joints,
      g1_joints == 1 ? " is" : "s are"));
}

void noteCornersBetweenLines(report::CurveRecord& record, std::size_t corners) {
  if (corners == 0) return;
  record.with_reservations = true;
  record.notes.push_back(fmt::format("{} corner{}: there are points on a line on both sides",
                                     corners, corners == 1 ? "" : "s"));
}

/// Points and their corners.
struct CorneredPoints {
  const GivenCurve& given;
  double error_mm = 0;  ///< by which points may be off
  std::vector<Eigen::Index> corners;

  CorneredPoints(const GivenCurve& curve, const CurveTask& task)
      : given(curve), error_mm(pointError_mm(curve, task)) {
    constexpr Eigen::Index least_points = 3;
    if (given.points.rows() >= least_points)
      corners = pointCorners(given.points, {.closed = closed(), .error_mm = error_mm});
  }
  bool closed() const { return given.record.closed; }
  std::vector<GivenCurve> runs() const { return runsOf(given, corners); }
  CurveFigures figures() const { return biarcFigures(given, corners); }
};

/// \throws std::domain_error if a conic has a kink.
CurveFigures figuresThrough(const PlanarChain& conics, double tolerance_mm) {
  try {
    return figuresFrom(figuresOf(conics));
  } catch (const std::domain_error&) {
    throw std::domain_error(fmt::format(
        "the points wave so much that a conic through them has a kink: give more than {:.3g} mm "
        "as --tolerance",
        tolerance_mm));
  }
}

/// Conics from corner to corner of the points.
MadeCurve conicsThrough(const CorneredPoints& points, const CurveTask& task) {
  const GivenCurve& given = points.given;
  MadeCurve made{.record = given.record};
  made.chain.closed = points.closed();
  std::size_t g1_joints = 0, between_lines = 0;
  double done = 0;
  for (const GivenCurve& run : points.runs()) {
    const double end = std::min(1.0, done + static_cast<double>(run.points.rows()) /
                                                static_cast<double>(given.points.rows()));
    const ConicSpline spline =
        conicSpline(run.points, run.record.closed, partOf(task.progress, done, end));
    done = end;
    made.chain.curves.insert(made.chain.curves.end(), spline.conics.begin(), spline.conics.end());
    g1_joints += spline.g1_joints.size();
    between_lines += spline.corners.size();
  }
  made.record.pieces = static_cast<int>(made.chain.curves.size());
  made.record.corners = static_cast<int>(points.corners.size() + between_lines);
  made.record.distance_mm = 0;
  made.record.before = points.figures();
  made.record.after = figuresThrough(made.chain, task.tolerance_mm);
  noteJoints(made.record, g1_joints);
  noteCornersBetweenLines(made.record, between_lines);
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

/// Parts of the tolerance that are tried: conics nearer to a curve can have fewer waves. A choice
/// that bounds the time.
constexpr std::array<double, 5> tolerance_shares = {1, 0.5, 0.2, 0.1, 0.05};

/// Whether conics wave so much more than others that those of smaller tolerances will too.
bool followsErrors(const report::CurveRecord& one, const report::CurveRecord& other) {
  constexpr int times = 2;
  return turnsOf(one.after) > times * turnsOf(other.after) + 1;
}

/// Whether conics have fewer extrema and inflections, or as many and fewer pieces.
bool isSimpler(const report::CurveRecord& one, const report::CurveRecord& other) {
  return std::pair(turnsOf(one.after), one.pieces) < std::pair(turnsOf(other.after), other.pieces);
}

/// Smaller parts of the tolerance are tried where conics have more extrema and inflections than the
/// curve.
MadeCurve conicsNearCurve(const GivenCurve& given, const CurveTask& task) {
  const double gap_mm = gapOf(given, given.chain);
  const CurveFigures before = figuresFrom(figuresOf(given.chain, partOf(task.progress, 0, 0)));
  std::optional<MadeCurve> best;
  for (std::size_t i = 0; i < tolerance_shares.size(); ++i) {
    const double done = static_cast<double>(i) / tolerance_shares.size();
    const CurveTask part{.tolerance_mm = tolerance_shares[i] * task.tolerance_mm,
                         .progress = partOf(task.progress, done, done)};
    MadeCurve made{.record = given.record};
    made.record.before = before;
    try {
      requireAboveRounding(part.tolerance_mm, given);
      takeConics(made, given.chain, gap_mm, part);
    } catch (const std::domain_error&) {  // the part is too small
      if (!best) throw;
      continue;
    }
    if (best && followsErrors(made.record, best->record)) break;
    if (!best || isSimpler(made.record, best->record)) best = std::move(made);
    if (turnsOf(best->record.after) <= turnsOf(before)) break;
  }
  return *std::move(best);
}

/// A part of the tolerance, and the share of it for moves of points; the rest is for the conics.
struct ToleranceUse {
  double part = 1, moves = 0.5;
};

/// Conics, and the extrema and inflections of the clothoids they are near.
struct NearFair {
  MadeCurve made;
  int fair_turns = 0;
};

/// Conics near the clothoids through points made fair.
NearFair conicsNearFair(const CorneredPoints& points, const CurveTask& task, double moves) {
  constexpr double fairing_share = 0.5;
  const GivenCurve& given = points.given;
  const CurveTask fairing{.tolerance_mm = moves * task.tolerance_mm,
                          .progress = partOf(task.progress, 0, fairing_share)};
  const MadeCurve faired = madeFairPoints(given, fairing, points.error_mm);
  const double off_mm = *faired.record.distance_mm + faired.chain_distance_mm;
  const CurveTask fitting{.tolerance_mm = task.tolerance_mm - off_mm,
                          .progress = partOf(task.progress, fairing_share, 1)};
  requireAboveRounding(fitting.tolerance_mm, given);
  MadeCurve made{.record = given.record};
  for (std::string& note : twinNotes(given, fairing)) made.record.notes.push_back(std::move(note));
  made.record.before = points.figures();
  takeConics(made, faired.chain, gapOf(given, faired.chain), fitting);
  *made.record.distance_mm += off_mm;
  return {.made = std::move(made), .fair_turns = turnsOf(faired.record.after)};
}

/// The simplest conics near the points; nothing if there are none.
std::optional<MadeCurve> conicsNearPoints(const CorneredPoints& points, const CurveTask& task) {
  // Points that wave by nearly the tolerance need most of it for moves.
  std::vector<ToleranceUse> uses = {{.part = 1, .moves = 0.8}};
  for (const double share : tolerance_shares) uses.push_back({.part = share});
  std::optional<MadeCurve> best;
  int fewest_turns = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const auto whole = static_cast<double>(uses.size()), done = static_cast<double>(i);
    const CurveTask part{.tolerance_mm = uses[i].part * task.tolerance_mm,
                         .progress = partOf(task.progress, done / whole, (done + 1) / whole)};
    try {
      auto [made, fair_turns] = conicsNearFair(points, part, uses[i].moves);
      fewest_turns = std::min(fewest_turns, fair_turns);
      if (best && followsErrors(made.record, best->record)) break;
      if (!best || isSimpler(made.record, best->record)) best = std::move(made);
      // Points that move less are no fairer.
      if (i > 0 && turnsOf(best->record.after) <= fewest_turns) break;
    } catch (const std::domain_error&) {  // the points are too few for their turns
      continue;
    }
  }
  return best;
}

/// Conics through the points, or near them if these have fewer extrema and inflections.
MadeCurve conicsOfPoints(const GivenCurve& given, const CurveTask& task) {
  constexpr double through_share = 0.1;
  constexpr Eigen::Index least_points = 3;
  const CorneredPoints points(given, task);
  std::optional<MadeCurve> through;
  std::string reason;
  try {
    through = conicsThrough(points, {.tolerance_mm = task.tolerance_mm,
                                     .progress = partOf(task.progress, 0, through_share)});
  } catch (const std::domain_error& error) {
    reason = error.what();
  }
  if (task.tolerance_mm > 0 && given.points.rows() >= least_points) {
    std::optional<MadeCurve> near = conicsNearPoints(
        points,
        {.tolerance_mm = task.tolerance_mm, .progress = partOf(task.progress, through_share, 1)});
    if (near && (!through || turnsOf(near->record.after) < turnsOf(through->record.after)))
      return *std::move(near);
  }
  if (!through) throw std::domain_error(reason);
  return *std::move(through);
}

}  // namespace

MadeCurve madeConics(const GivenCurve& given, const CurveTask& task) {
  return given.points.rows() > 0 ? conicsOfPoints(given, task) : conicsNearCurve(given, task);
}

}  // namespace seamwright::cli
