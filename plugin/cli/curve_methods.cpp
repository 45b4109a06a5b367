// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <seamwright/core/planar/clothoid_fit.hpp>
#include <seamwright/core/planar/fair_clothoids.hpp>
#include <seamwright/core/planar/fair_points.hpp>
#include <seamwright/core/planar/point_corners.hpp>
#include <seamwright/core/planar/sampled_chain.hpp>
#include <seamwright/plugin/cli/curve_arcs.hpp>
#include <seamwright/plugin/cli/curve_conics.hpp>
#include <seamwright/plugin/cli/curve_figures.hpp>
#include <seamwright/plugin/cli/curve_methods.hpp>
#include <seamwright/plugin/cli/fair_splines.hpp>
#include <seamwright/plugin/cli/faired_points.hpp>
#include <seamwright/plugin/cli/local_curve.hpp>
#include <seamwright/plugin/cli/point_curves.hpp>
#include <seamwright/plugin/cli/rounding.hpp>
#include <seamwright/plugin/cli/smooth_curve.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

/// Splines through clothoids for a model file, and the figures.
void takeClothoids(MadeCurve& made, std::vector<Clothoid> pieces,
                   const std::vector<std::ptrdiff_t>& corners, double tolerance_mm) {
  double length_mm = 0;
  for (const Clothoid& piece : pieces) length_mm += piece.length_mm;
  // A tenth of the tolerance is left to the spline; without a tolerance a billionth of the length.
  const double spline_mm = tolerance_mm > 0 ? 0.1 * tolerance_mm : 1e-9 * length_mm;
  SmoothCurve splines = splinesBetween(pieces, corners, made.record.closed, spline_mm);
  made.chain = std::move(splines.chain);
  made.chain_distance_mm = splines.distance_mm;
  made.record.after = splines.figures;
  made.record.pieces = static_cast<int>(pieces.size());
  made.record.corners = static_cast<int>(corners.size());
  made.clothoids = std::move(pieces);
}

/// A path stops at a corner, so it is named.
void noteCorners(report::CurveRecord& record, const GivenCurve& given,
                 const std::vector<Eigen::Index>& corners) {
  if (corners.empty()) return;
  record.with_reservations = true;
  std::vector<int> lines;
  for (const Eigen::Index i : corners) lines.push_back(given.lines[static_cast<std::size_t>(i)]);
  record.notes.push_back(fmt::format(
      "{} in line{} {}: the tangent jumps there, and the curvature is continuous elsewhere only",
      lines.size() == 1 ? "a corner" : fmt::format("{} corners", lines.size()),
      lines.size() == 1 ? "" : "s", fmt::join(lines, ", ")));
}

/// Clothoids from corner to corner of the points.
MadeCurve clothoidsThrough(const GivenCurve& given, const CurveTask& task) {
  constexpr Eigen::Index least_points = 3;
  MadeCurve made{.record = given.record};
  std::vector<Eigen::Index> corners;
  if (given.points.rows() >= least_points)
    corners = pointCorners(given.points,
                           {.closed = given.record.closed, .error_mm = pointError_mm(given, task)});
  const std::vector<GivenCurve> runs = runsOf(given, corners);
  const auto whole = static_cast<double>(runs.size());
  std::vector<Clothoid> pieces;
  std::vector<std::ptrdiff_t> begins;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto done = static_cast<double>(i);
    if (i > 0 || runs.size() == corners.size()) begins.push_back(std::ssize(pieces));
    const ClothoidSpline spline =
        clothoidsOf(runs[i].points, runs[i].record.closed,
                    partOf(task.progress, done / whole, (done + 1) / whole));
    pieces.insert(pieces.end(), spline.pieces.begin(), spline.pieces.end());
  }
  made.record.distance_mm = 0;
  made.record.before = biarcFigures(given, corners);
  takeClothoids(made, std::move(pieces), begins, task.tolerance_mm);
  noteCorners(made.record, given, corners);
  return made;
}

MadeCurve madeClothoids(const GivenCurve& given, const CurveTask& task) {
  if (given.points.rows() > 0) return clothoidsThrough(given, task);
  MadeCurve made{.record = given.record};
  const ClothoidFit fit = fitClothoids(bezierSpline(given.chain, gapOf(given, given.chain)),
                                       {.tolerance_mm = task.tolerance_mm}, task.progress);
  made.record.distance_mm = fit.distance_mm;
  made.record.before = figuresFrom(figuresOf(given.chain, partOf(task.progress, 1, 1)));
  takeClothoids(made, fit.pieces, {fit.corners.begin(), fit.corners.end()}, task.tolerance_mm);
  return made;
}

MadeCurve madeFair(const GivenCurve& given, const CurveTask& task) {
  return given.points.rows() > 0 ? madeFairPoints(given, task, pointError_mm(given, task))
                                 : madeFairSplines(given, task);
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
/// \param moves_points whether a larger tolerance helps.
void noteRounding(report::CurveRecord& record, const GivenCurve& given, double tolerance_mm,
                  bool moves_points) {
  constexpr Eigen::Index least_points = 3;
  if (given.rounding_mm == 0 || given.points.rows() < least_points || given.polygon) return;
  const PointFairness certain = fairnessOf(given.points, record.closed, given.rounding_mm);
  const auto extrema = static_cast<int>(certain.extrema.size());
  if (extrema < record.before.extrema)
    record.notes.push_back(fmt::format(
        "{} of the {} extrema before can come from the rounding of the points, by up "
        "to {:.2g} mm{}",
        record.before.extrema - extrema, record.before.extrema, given.rounding_mm,
        moves_points && tolerance_mm < given.rounding_mm ? "; give a larger --tolerance" : ""));
}

/// Samples of lines and arcs, such as a slot: their extrema are no errors. Returns whether they
/// are.
bool noteSampled(report::CurveRecord& record, const GivenCurve& given) {
  constexpr int least_extrema = 4;
  constexpr Eigen::Index points_of_a_piece = 8;
  const auto most_arcs = static_cast<int>(given.points.rows() / points_of_a_piece);
  if (record.after.extrema < least_extrema || most_arcs < 2) return false;
  const double size_mm =
      (given.points.colwise().maxCoeff() - given.points.colwise().minCoeff()).norm();
  const double error_mm = std::max(given.rounding_mm, 1e-9 * size_mm);
  const auto chain = sampledChain(
      given.points, {.closed = record.closed, .tolerance_mm = error_mm, .most_arcs = most_arcs});
  if (!chain || chain->arcs.size() < 2) return false;
  record.notes.push_back(fmt::format(
      "the points are samples of {} lines and arcs: the curvature jumps where these meet, and a "
      "curve with continuous curvature has extrema there; the method arcs gives them",
      chain->arcs.size()));
  return true;
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

/// Far from the origin, messages have the coordinates of the local curve.
MadeCurve madeLocally(const std::string& method, const LocalCurve& local, const CurveTask& task) {
  try {
    return madeOf(method, local.given, taskOf(local, task));
  } catch (const std::domain_error& error) {
    if (local.origin.isZero(0)) throw;
    throw std::domain_error(fmt::format("{} (coordinates from ({:.15g}, {:.15g}))", error.what(),
                                        local.origin.x(), local.origin.y()));
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
  MadeCurve made = madeLocally(method, local, task);
  if (!local.origin.isZero(0)) moveBack(made, local);
  const bool added = noteAdded(made.record);
  // Arcs have jumps of the curvature, which nobody takes for a fair curve.
  made.record.with_reservations |= method != "arcs" && added;
  noteRounding(made.record, local.given, task.tolerance_mm, method != "clothoid");
  if (method != "arcs") made.record.with_reservations |= noteSampled(made.record, local.given);
  return made;
}

}  // namespace seamwright::cli
