// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <seamwright/core/planar/plane_frame.hpp>
#include <seamwright/core/planar/point_corners.hpp>
#include <seamwright/core/spline/nu_spline.hpp>
#include <seamwright/core/spline/polynomial_spline.hpp>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/curves/space_spline.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/plugin/cli/key_curves.hpp>
#include <seamwright/plugin/cli/point_file.hpp>
#include <seamwright/plugin/cli/rounding.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

/// The C2 cubic spline through the points.
BezierSpline splineThrough(const Poles& points, bool closed) {
  NuSplineData data;
  data.points = points;
  if (closed) {
    data.points.conservativeResize(points.rows() + 1, 3);
    data.points.bottomRows<1>() = points.topRows<1>();
    data.ends = SplineEnds::Periodic;
  }
  data.knots = knotsOf(data.points);
  data.nu.assign(data.knots.size(), 0);
  return nuSpline(data).curve;
}

/// Corners of points in a plane; points in space have none.
std::vector<Eigen::Index> cornersOf(const PointFile& file, bool closed, double flat_mm) {
  constexpr Eigen::Index least_points = 3;
  if (file.points.rows() < least_points) return {};
  const FittedPlane plane = fitPlane(file.points);
  if (plane.distance_mm > flat_mm) return {};
  return pointCorners(coordinatesIn(plane.frame, file.points),
                      {.closed = closed, .error_mm = file.rounding_mm});
}

/// The derivative at the first of three points of the parabola through them.
Eigen::Vector3d startOfParabola(const Poles& points, double first_step, double second_step) {
  const Eigen::Vector3d first = (points.row(1) - points.row(0)).transpose() / first_step,
                        second = (points.row(2) - points.row(1)).transpose() / second_step;
  return first - first_step * (second - first) / (first_step + second_step);
}

/// The C2 cubic spline through the points of one side of a corner. It begins and ends as parabolas
/// through three points: a corner says nothing about the curvature beside it.
BezierSpline splineBeside(const Poles& points) {
  NuSplineData data;
  data.points = points;
  data.knots = knotsOf(points);
  data.nu.assign(data.knots.size(), 0);
  const std::size_t last = data.knots.size() - 1;
  if (last >= 2) {
    const auto step = [&](std::size_t i) { return data.knots[i + 1] - data.knots[i]; };
    data.ends = SplineEnds::Clamped;
    data.start_derivative = startOfParabola(points.topRows<3>(), step(0), step(1));
    data.end_derivative = -startOfParabola(points.bottomRows<3>().colwise().reverse(),
                                           step(last - 1), step(last - 2));
  }
  return nuSpline(data).curve;
}

/// The spline through the points, with corners at some of them. It begins at the first point.
BezierSpline splineThrough(const Poles& points, const std::vector<Eigen::Index>& corners,
                           bool closed) {
  if (corners.empty()) return splineThrough(points, closed);
  std::vector<BezierCurve> pieces;
  std::vector<double> steps;
  for (const std::vector<Eigen::Index>& run : runsBetween(points.rows(), corners, closed)) {
    const BezierSpline part = splineBeside(points(run, Eigen::indexing::all));
    for (int i = 0; i < part.segments(); ++i) {
      pieces.push_back(segment(part, i));
      steps.push_back(part.knots[i + 1] - part.knots[i]);
    }
  }
  // The runs of a closed curve begin at its first corner.
  const std::size_t count = pieces.size(),
                    first = closed ? count - static_cast<std::size_t>(corners.front()) : 0;
  std::vector<BezierCurve> in_order;
  std::vector<double> knots{0};
  for (std::size_t k = 0; k < count; ++k) {
    in_order.push_back(pieces[(first + k) % count]);
    knots.push_back(knots.back() + steps[(first + k) % count]);
  }
  return bezierSpline(in_order, knots, closed);
}

/// The mean angle by which the polygon of the points turns.
double meanTurn(const Poles& points, bool closed) {
  const Eigen::Index count = points.rows(), first = closed ? 0 : 1, last = count - first;
  double sum_rad = 0;
  for (Eigen::Index i = first; i < last; ++i) {
    const Eigen::RowVector3d arriving = points.row(i) - points.row((i + count - 1) % count),
                             leaving = points.row((i + 1) % count) - points.row(i);
    sum_rad += std::atan2(arriving.cross(leaving).norm(), arriving.dot(leaving));
  }
  return last > first ? sum_rad / static_cast<double>(last - first) : 0;
}

occ::ModelFacts pointFacts(const std::string& path) {
  occ::ModelFacts facts;
  facts.path = path;
  facts.format = "points";
  facts.length_unit = "mm (assumed)";
  return facts;
}

/// The lines and arcs of which the points are samples, or the spline through them.
KeyCurve keyCurve(const PointFile& file, const BlendArguments& arguments) {
  KeyCurve result;
  result.points = file.points.rows();
  result.sampled = sampledCurve(file, arguments.closed);
  if (result.sampled) {
    const PolynomialSpline polynomial =
        polynomialSpline(result.sampled->spline, arguments.order, arguments.tolerance_mm);
    result.corners = result.sampled->corners;
    result.curve = polynomial.spline;
    result.polynomial_mm = polynomial.distance_mm;
    return result;
  }
  const std::vector<Eigen::Index> corners =
      cornersOf(file, arguments.closed, arguments.tolerance_mm);
  for (const Eigen::Index corner : corners) result.corners.push_back(corner + 1);
  if (corners.empty()) result.turn_rad = meanTurn(file.points, arguments.closed);
  result.curve = splineThrough(file.points, corners, arguments.closed);
  return result;
}

void addPoints(KeyCurves& result, const std::string& path, const EdgeList& edges,
               const BlendArguments& arguments) {
  const bool closed = arguments.closed;
  if (edges.isGiven())
    throw std::runtime_error(path +
                             ": is a file of points, which has no edges: --edge is for models");
  PointFile file = readPoints(path);
  requireCurve(file, path, closed);
  KeyCurve curve = keyCurve(file, arguments);
  curve.input = result.facts.size();
  result.curves.push_back(std::move(curve));
  result.facts.push_back(pointFacts(path));
  if (const std::string note = closed ? "" : endsNote(file); !note.empty())
    file.notes.push_back(note);
  if (!file.tolerances_mm.empty())
    file.notes.emplace_back("tolerances of points are for the method fair");
  result.notes.push_back(std::move(file.notes));
}

/// The curves of a model; \p only_input: all of them, else one.
void addModel(KeyCurves& result, const std::string& path, const EdgeList& edges,
              const BlendArguments& arguments) {
  const occ::Model model = readUnderBar(path, occ::Needed::Edges);
  const bool only_input = arguments.inputs.size() == 1;
  std::vector<occ::SpaceSpline> splines =
      occ::spaceSplines(model.shape, {.edges = edges.numbers, .each_alone = edges.all});
  if (splines.empty())
    throw std::runtime_error(path +
                             ": has no free edges: name edges with --edge, or take --edge all");
  if (!only_input && splines.size() > 1)
    throw std::runtime_error(fmt::format(
        "{}: has {} curves, and one of each file is blended: name its edges with --edge", path,
        splines.size()));
  for (const occ::SpaceSpline& spline : splines) {
    const PolynomialSpline polynomial =
        polynomialSpline(spline.spline, arguments.order, arguments.tolerance_mm);
    result.curves.push_back({.input = result.facts.size(),
                             .edges = spline.edges,
                             .curve = polynomial.spline,
                             .gap_mm = spline.gap_mm,
                             .polynomial_mm = polynomial.distance_mm});
  }
  result.facts.push_back(occ::factsOf(model));
  result.notes.push_back(model.notes);
}

/// The largest size of each coordinate.
Eigen::Vector3d largestOf(const BezierSpline& curve) {
  return curve.poles.leftCols<3>().cwiseAbs().colwise().maxCoeff().transpose();
}

/// The edges of each file. Files of points take no list, unless none of the files is a model.
std::vector<EdgeList> edgesOfInputs(const BlendArguments& arguments) {
  std::vector<EdgeList> lists(arguments.inputs.size());
  if (arguments.edges.empty()) return lists;
  const auto models = static_cast<std::size_t>(
      std::ranges::count_if(arguments.inputs, [](const auto& path) { return !isPointFile(path); }));
  if (models == 0) lists.front() = arguments.edges.front();
  if (models == 0) return lists;
  if (arguments.edges.size() != models)
    throw std::runtime_error(
        fmt::format("--edge is given {} times for {} models: give it for none, or once for each in "
                    "their order",
                    arguments.edges.size(), models));
  auto next = arguments.edges.begin();
  for (std::size_t i = 0; i < lists.size(); ++i)
    if (!isPointFile(arguments.inputs[i])) lists[i] = *next++;
  return lists;
}

/// \throws std::runtime_error if some key curves are closed and others are not.
void requireAllClosedOrOpen(const KeyCurves& input, const BlendArguments& arguments) {
  const bool first_closed = input.curves.front().curve.closed;
  for (std::size_t i = 1; i < input.curves.size(); ++i) {
    if (input.curves[i].curve.closed == first_closed) continue;
    const auto name = [&](std::size_t k) {
      return fmt::format("key curve {} ({})", k + 1, arguments.inputs[input.curves[k].input]);
    };
    const bool has_points = std::ranges::any_of(
        input.curves, [](const KeyCurve& key) { return key.points > 0 && !key.curve.closed; });
    throw std::runtime_error(fmt::format(
        "{}: {} is {}, and {} is {}: all are open or all are closed{}",
        arguments.inputs[input.curves[i].input], name(i), first_closed ? "open" : "closed", name(0),
        first_closed ? "closed" : "open", has_points ? "; --closed closes points" : ""));
  }
}

}  // namespace

KeyCurves keyCurves(const BlendArguments& arguments) {
  const std::vector<EdgeList> edges_of_inputs = edgesOfInputs(arguments);
  KeyCurves result;
  for (std::size_t i = 0; i < arguments.inputs.size(); ++i) {
    const std::string& path = arguments.inputs[i];
    const EdgeList& edges = edges_of_inputs[i];
    try {
      if (isPointFile(path))
        addPoints(result, path, edges, arguments);
      else
        addModel(result, path, edges, arguments);
      for (const KeyCurve& key : result.curves)
        requireAboveRounding(arguments.tolerance_mm, largestOf(key.curve));
    } catch (const occ::GeometryError& error) {
      throw std::runtime_error(path + ": " + error.what());
    } catch (
        const std::invalid_argument& error) {  // a number without an edge, a spline without end
      throw std::runtime_error(path + ": " + error.what());
    } catch (const std::domain_error& error) {  // a curve that no polynomial comes near
      throw std::runtime_error(path + ": " + error.what());
    }
  }
  if (result.curves.size() < 2)
    throw std::runtime_error(
        fmt::format("{}: has one curve, and a blend needs two or more", arguments.inputs.front()));
  requireAllClosedOrOpen(result, arguments);
  return result;
}

}  // namespace seamwright::cli
