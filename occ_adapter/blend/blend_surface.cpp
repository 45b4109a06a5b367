// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include <seamwright/core/blend/hermite_sheet.hpp>
#include <seamwright/core/bspline/collocation.hpp>
#include <seamwright/core/seam/measure.hpp>
#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/blend/blend_surface.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::occ {

namespace {

constexpr int degree_along = 5;
constexpr int most_order = 3;

struct ChosenEnd {
  HoleSide edges;
  std::shared_ptr<const SidePath> path;
  bool closed = false;
};

void requireEnd(const char* name, const BlendEnd& end) {
  if (end.order < 0 || end.order > most_order)
    throw std::invalid_argument(
        fmt::format("{}: order is {}: 0 to {} is possible", name, end.order, most_order));
  if (!(end.tension > 0) || !std::isfinite(end.tension))
    throw std::invalid_argument(
        fmt::format("{}: tension is {}: it must be positive and finite", name, end.tension));
}

ChosenEnd chosenEnd(const char* name, const TopoDS_Shape& model, const BlendEnd& end,
                    const BlendSurfaceOptions& options) {
  ChosenEnd result;
  try {
    result.edges = chosenSide(model, end.side, result.closed);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", name, error.what()));
  }
  result.path = std::make_shared<const SidePath>(
      result.edges, options.tolerance.gap_mm,
      end.order == most_order ? JetOrder::Third : JetOrder::Second);
  return result;
}

/// The sum of squared distances of points of equal shares.
double apart(const BlendSide& a, const BlendSide& b) {
  constexpr int samples = 16;
  double sum = 0;
  for (int i = 0; i <= samples; ++i) {
    const double share = static_cast<double>(i) / samples;
    sum += (a.at(share).point - b.at(share).point).squaredNorm();
  }
  return sum;
}

/// The end's side in the direction, and of a closed one from the beginning, nearest to the start's.
BlendSide facing(const BlendSide& start, const ChosenEnd& end) {
  const int begins = end.closed ? 64 : 1;
  std::optional<BlendSide> best;
  double least = 0;
  for (const bool reversed : {false, true})
    for (int i = 0; i < begins; ++i) {
      const BlendSide side(end.path, reversed, static_cast<double>(i) / begins);
      const double distance = apart(start, side);
      if (best && !(distance < least)) continue;
      best = side;
      least = distance;
    }
  return *best;
}

/// Both sides and what the surface does there.
struct Task {
  std::array<BlendSide, 2> sides;
  std::array<BlendEnd, 2> ends;
  SplineClosure closure = SplineClosure::Open;
  ContinuityTolerance tolerance;
};

/// The derivatives by the parameter across, of both ends, at a share of the sides.
std::array<CurveDerivatives, 2> derivativesAt(const Task& task, double share) {
  const bool after = share < 1;
  const std::array<SideSample, 2> at = {task.sides[0].at(share, after),
                                        task.sides[1].at(share, after)};
  const double distance_mm = (at[1].point - at[0].point).norm();
  if (!(distance_mm > task.tolerance.gap_mm))
    throw GeometryError(fmt::format("the sides touch: at the share {:.3g} they are {:.3g} mm apart",
                                    share, distance_mm));
  std::array<CurveDerivatives, 2> result;
  for (int k = 0; k < 2; ++k) {
    // Both ends run with the parameter: out of the face at the start, into it at the end.
    result[k] = continuation(at[k], k == 0 ? 1 : -1, task.ends[k].order);
    const double speed_mm = task.ends[k].tension * distance_mm;
    for (int order = 1; order <= task.ends[k].order; ++order)
      result[k].row(order) *= std::pow(speed_mm, order);
  }
  return result;
}

/// Inner knots by their multiplicity. At joints of edges derivatives along the side may jump. At
/// breaks within an edge the path is C^2 as a rule, so directions across it are C^1.
struct Knots {
  static constexpr int of_joint = degree_along, of_break = degree_along - 1, free = 1;
  std::map<double, int> multiplicities = {{0, degree_along + 1}, {1, degree_along + 1}};

  void add(double at, int multiplicity) {
    // Sums of lengths round by less, and splines over shorter spans have no digits left.
    constexpr double same = 1e-6;
    const auto after = multiplicities.lower_bound(at);
    for (const auto& near : {after, std::prev(after)})
      if (near != multiplicities.end() && std::abs(near->first - at) <= same) {
        near->second = std::max(near->second, multiplicity);
        return;
      }
    multiplicities[at] = multiplicity;
  }
  int spans() const { return static_cast<int>(multiplicities.size()) - 1; }
  std::vector<double> flat() const {
    std::vector<double> result;
    for (const auto& [at, multiplicity] : multiplicities)
      result.insert(result.end(), multiplicity, at);
    return result;
  }
};

BSplineSurface sheetOver(const Task& task, const std::vector<double>& knots) {
  const GrevilleInterpolation interpolation(degree_along, knots, task.closure);
  const auto count = static_cast<Eigen::Index>(interpolation.parameters().size());
  std::array<Eigen::MatrixXd, 2> values;
  for (int k = 0; k < 2; ++k) values[k].resize(count, 3 * (task.ends[k].order + 1));
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto derivatives = derivativesAt(task, interpolation.parameters()[i]);
    for (int k = 0; k < 2; ++k) values[k].row(i) = derivatives[k].reshaped<Eigen::RowMajor>();
  }
  std::array<SheetRibbon, 2> ribbons;
  for (int k = 0; k < 2; ++k) {
    const Eigen::MatrixXd poles = interpolation.poles(values[k]);
    ribbons[k] = {.degree = degree_along, .knots = knots, .derivatives = {}};
    for (int order = 0; order <= task.ends[k].order; ++order)
      ribbons[k].derivatives.emplace_back(poles.middleCols(3 * order, 3));
  }
  return hermiteSheet(ribbons[0], ribbons[1]);
}

/// The largest figure at a point of an end over its tolerance.
double excessAt(const Task& task, const BSplineSurface& sheet, int k, double share) {
  const SideSample sample = task.sides[k].at(share);
  const bool third = task.ends[k].order == most_order;
  const SidePoint of_face{sample.jet, {}, sample.derivative, true, third},
      of_sheet{jet(sheet, share, k), {}, sample.derivative, true, third};
  const PairMeasure figures = measurePair(of_face, of_sheet);
  const ContinuityTolerance& tolerance = task.tolerance;
  double excess = figures.gap_mm.value_or(HUGE_VAL) / tolerance.gap_mm;
  if (task.ends[k].order > 0)
    excess = std::max(excess, figures.angle_rad.value_or(HUGE_VAL) / tolerance.angle_rad);
  if (task.ends[k].order > 1 && figures.curvature)
    excess = std::max(excess, relativeDifference(*figures.curvature, tolerance.flat_radius_mm) /
                                  tolerance.curvature_rel);
  if (task.ends[k].order > 2 && figures.curvature && figures.curvature_change)
    excess = std::max(excess, relativeChange(*figures.curvature_change, *figures.curvature,
                                             tolerance.flat_radius_mm) /
                                  tolerance.curvature_rel);
  return excess;
}

/// The middles of spans in which a seam is beyond half of its tolerance.
std::vector<double> middlesOfPoorSpans(const Task& task, const BSplineSurface& sheet,
                                       const Knots& knots) {
  constexpr int samples = 4;
  // Where a derivative of the face jumps no spline is near enough. Second differences over shorter
  // spans have fewer than half of the digits.
  constexpr double shortest = 1.0 / 512;
  std::vector<double> result;
  const std::map<double, int>& at = knots.multiplicities;
  for (auto from = at.begin(), to = std::next(from); to != at.end(); from = to++) {
    const double start = from->first, length = to->first - start;
    if (length < shortest) continue;
    double excess = 0;
    for (int i = 0; i < samples; ++i)
      for (int k = 0; k < 2; ++k)
        excess = std::max(excess, excessAt(task, sheet, k, start + (i + 0.5) / samples * length));
    if (excess > 0.5) result.push_back(start + 0.5 * length);
  }
  return result;
}

/// The faces beside the new one, and the new one last.
struct Neighbourhood {
  TopoDS_Compound shape;
  std::vector<int> faces;  ///< numbers in the model
};

Neighbourhood around(const std::array<ChosenEnd, 2>& ends, const TopoDS_Face& face) {
  Neighbourhood result;
  BRep_Builder builder;
  builder.MakeCompound(result.shape);
  for (const ChosenEnd& end : ends)
    for (const HoleEdge& edge : end.edges.edges) {
      if (std::ranges::count(result.faces, edge.use.face) > 0) continue;
      builder.Add(result.shape, edge.use.shape);
      result.faces.push_back(edge.use.face);
    }
  builder.Add(result.shape, face);
  return result;
}

bool isOf(const ChosenEnd& end, const Coedge& use) {
  return std::ranges::any_of(end.edges.edges,
                             [&](const HoleEdge& edge) { return edge.use.edge.IsSame(use.edge); });
}

void measureSeams(const TopoDS_Shape& model, const std::array<ChosenEnd, 2>& ends, const Task& task,
                  BlendSurfaceReport& report) {
  const Neighbourhood around_it = around(ends, report.face);
  const int made = static_cast<int>(around_it.faces.size()) + 1;
  SeamGraph graph = findSeams(around_it.shape);
  matchFreeEdges({.match_mm = 2 * task.tolerance.gap_mm, .gap_mm = task.tolerance.gap_mm}, graph);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(model, TopAbs_EDGE, edges);
  report.reached = true;
  std::array<double, 2> covered_mm{};
  for (const Seam& seam : graph.seams) {
    if (seam.kind != SeamKind::Matched) continue;
    const int other = seam.sides[0].face == made ? 1 : 0;
    if (seam.sides[1 - other].face != made || seam.sides[other].face == made) continue;
    const int k = isOf(ends[0], seam.sides[other]) ? 0 : isOf(ends[1], seam.sides[other]) ? 1 : 2;
    if (k == 2) continue;
    const auto level = static_cast<Level>(static_cast<int>(Level::G0) + task.ends[k].order);
    SeamResult result = measureSeam(seam, {.tolerance = task.tolerance, .level = level});
    report.reached = report.reached && result.verdict.level >= level &&
                     (result.verdict.certain || level == Level::G3);
    covered_mm[k] += result.length_mm;
    result.faces = {around_it.faces[seam.sides[other].face - 1], 0};
    result.edges = {edges.FindIndex(seam.sides[other].edge)};
    report.seams.push_back(std::move(result));
  }
  for (int k = 0; k < 2; ++k) {
    // A seam may end a little before the side does.
    constexpr double most_of_it = 0.98;
    if (covered_mm[k] < most_of_it * ends[k].path->length_mm()) report.reached = false;
  }
}

Task taskOf(const std::array<ChosenEnd, 2>& ends, const BlendEnd& start, const BlendEnd& end,
            const BlendSurfaceOptions& options) {
  const BlendSide first(ends[0].path, false);
  return {.sides = {first, facing(first, ends[1])},
          .ends = {start, end},
          .closure = ends[0].closed && ends[0].path->isOneEdge() ? SplineClosure::Periodic
                                                                 : SplineClosure::Open,
          .tolerance = options.tolerance};
}

Knots firstKnots(const Task& task) {
  Knots knots;
  for (const BlendSide& side : task.sides) {
    for (const double at : side.joints()) knots.add(at, Knots::of_joint);
    for (const double at : side.breaks()) knots.add(at, Knots::of_break);
  }
  // A side with fewer spans meets its tolerance by chance only.
  constexpr int first_spans = 4;
  for (int i = 1; i < first_spans; ++i)
    knots.add(static_cast<double>(i) / first_spans, Knots::free);
  return knots;
}

}  // namespace

BlendSurfaceReport blendSurface(const TopoDS_Shape& model, const BlendEnd& start,
                                const BlendEnd& end, const BlendSurfaceOptions& options,
                                const Progress& progress) {
  options.tolerance.validate();
  requireEnd("start", start);
  requireEnd("end", end);
  const std::array<ChosenEnd, 2> ends = {chosenEnd("start", model, start, options),
                                         chosenEnd("end", model, end, options)};
  if (ends[0].closed != ends[1].closed)
    throw std::invalid_argument(
        fmt::format("one side is closed, the {} is not", ends[0].closed ? "end" : "start"));
  const Task task = taskOf(ends, start, end, options);
  Knots knots = firstKnots(task);
  BlendSurfaceReport report;
  for (int round = 0;; ++round) {
    checkProgress(progress, shareAfter(round));
    report.surface = sheetOver(task, knots.flat());
    const std::vector<double> middles = middlesOfPoorSpans(task, report.surface, knots);
    const int before = knots.spans();
    if (before + static_cast<int>(middles.size()) > options.max_spans) break;
    for (const double at : middles) knots.add(at, Knots::free);
    if (knots.spans() == before) break;
  }
  report.spans = knots.spans();
  report.face = faceOf(report.surface);
  measureSeams(model, ends, task, report);
  return report;
}

}  // namespace seamwright::occ
