// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <seamwright/core/planar/fair_clothoids.hpp>
#include <seamwright/core/planar/point_corners.hpp>
#include <seamwright/plugin/cli/curve_figures.hpp>
#include <seamwright/plugin/cli/faired_points.hpp>
#include <seamwright/plugin/cli/point_curves.hpp>
#include <seamwright/plugin/cli/smooth_curve.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

using report::CurveFigures;

CurveFigures withVariation(const ClothoidFigures& figures) {
  CurveFigures result = figuresFrom(figures);
  result.variation_per_mm3 = figures.variation_per_mm3;
  return result;
}

/// A spline from corner to corner.
void takeRuns(MadeCurve& made, const FairedClothoids& faired, double tolerance_mm) {
  // As for takeClothoids().
  const double spline_mm = tolerance_mm > 0 ? 0.1 * tolerance_mm : 1e-9 * faired.after.length_mm;
  SmoothCurve splines = splinesBetween(
      faired.pieces, {faired.corners.begin(), faired.corners.end()}, made.record.closed, spline_mm);
  made.chain = std::move(splines.chain);
  made.chain_distance_mm = splines.distance_mm;
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

std::vector<std::string> twinNotes(const GivenCurve& given, const PointsToFair& part) {
  std::vector<std::string> notes;
  if (!part.twins.empty()) {
    const auto lineOf = [&](Eigen::Index i) { return given.lines[static_cast<std::size_t>(i)]; };
    const PointTwin& first = part.twins.front();
    const double gap_mm = (given.points.row(first.left_out) - given.points.row(first.kept)).norm();
    const std::string more =
        part.twins.size() == 1 ? "" : fmt::format(", and {} more", part.twins.size() - 1);
    notes.push_back(fmt::format("left out: the point of line {}, {:.3g} mm from that of line {}{}",
                                lineOf(first.left_out), gap_mm, lineOf(first.kept), more));
  }
  if (std::string crowded = crowdedPoints(part.curve); !crowded.empty())
    notes.push_back(std::move(crowded));
  return notes;
}

}  // namespace

double pointError_mm(const GivenCurve& given, const CurveTask& task) {
  return std::max(middleOf(tolerancesOf(given, task)), given.rounding_mm);
}

std::vector<std::string> twinNotes(const GivenCurve& given, const CurveTask& task) {
  return twinNotes(given, pointsToFair(given, task));
}

MadeCurve madeFairPoints(const GivenCurve& given, const CurveTask& task, double error_mm) {
  const bool closed = given.record.closed;
  const PointsToFair part = pointsToFair(given, task);
  const PlanarPoints& points = part.curve.points;
  constexpr Eigen::Index least_points = 3;
  if (points.rows() < least_points && !part.twins.empty())
    throw std::domain_error(
        fmt::format("{} of the {} points repeat their neighbours: at least {} "
                    "others are needed",
                    part.twins.size(), given.points.rows(), least_points));
  if (points.rows() < least_points)
    throw std::invalid_argument(
        fmt::format("{} points: nothing can be made fair between them; at least {} are needed",
                    points.rows(), least_points));
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
    made.record.before = biarcFigures(part.curve, faired.corners);
    made.record.notes.push_back(
        "no clothoids pass through the points as read: the figures before are those of biarcs");
  }
  for (std::string& note : twinNotes(given, part)) made.record.notes.push_back(std::move(note));
  noteTurns(made.record, faired);
  return made;
}

}  // namespace seamwright::cli
