// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include <seamwright/core/blend/hermite_sheet.hpp>
#include <seamwright/core/bspline/collocation.hpp>
#include <seamwright/core/linear/gauss_rule.hpp>
#include <seamwright/core/seam/measure.hpp>
#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/blend/blend_side.hpp>
#include <seamwright/occ_adapter/blend/blend_surface.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/model/compound.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
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
    result.path = smoothPath(result.edges, result.closed, options.tolerance.gap_mm,
                             end.order == most_order ? JetOrder::Third : JetOrder::Second);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", name, error.what()));
  }
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

/// How a side runs and, if it is closed, the share of its path at which it begins.
struct Facing {
  bool reversed = false;
  double begin = 0;
  double distance = HUGE_VAL;  ///< apart() from the other side

  BlendSide side(const ChosenEnd& end) const { return {end.path, reversed, begin}; }
};

/// The end's side in the direction, and of a closed one from the beginning, nearest to the start's.
BlendSide facing(const BlendSide& start, const ChosenEnd& end) {
  const auto facingAt = [&](bool reversed, double begin) {
    Facing result{.reversed = reversed, .begin = begin - std::floor(begin)};
    result.distance = apart(start, result.side(end));
    return result;
  };
  const int begins = end.closed ? 64 : 1;
  Facing best;
  for (const bool reversed : {false, true})
    for (int i = 0; i < begins; ++i)
      if (const Facing next = facingAt(reversed, static_cast<double>(i) / begins);
          next.distance < best.distance)
        best = next;
  // Of the turn: a twist that nobody sees.
  constexpr double least_step = 1e-6;
  for (double step = 0.5 / begins; end.closed && step > least_step;) {
    const Facing before = facingAt(best.reversed, best.begin - step),
                 after = facingAt(best.reversed, best.begin + step),
                 nearer = before.distance < after.distance ? before : after;
    if (nearer.distance < best.distance)
      best = nearer;
    else
      step /= 2;
  }
  return best.side(end);
}

/// The sides, one or two, and what the surface does there.
struct Task {
  std::vector<BlendSide> sides;
  std::vector<BlendEnd> ends;
  double length_mm = 0;  ///< of an extension, which has one side
  SplineClosure closure = SplineClosure::Open;
  ContinuityTolerance tolerance;

  int count() const { return static_cast<int>(sides.size()); }
};

/// The parameter up to which a curve, given by its derivatives at 0, has the length.
double parameterAtLength(const CurveDerivatives& derivatives, double length_mm) {
  static const GaussRule rule = gaussRule(12);
  const auto lengthTo = [&](double t) {
    double sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      Eigen::RowVector3d slope = Eigen::RowVector3d::Zero();
      double power = 1;
      for (Eigen::Index k = 1; k < derivatives.rows(); ++k) {
        slope += power * derivatives.row(k);
        power *= rule.nodes[i] * t / static_cast<double>(k);
      }
      sum += rule.weights[i] * slope.norm();
    }
    return t * sum;
  };
  // The speed is least at 0, where it is 1: the other derivatives are normal to the first one.
  double low = 0, high = length_mm;
  constexpr int halvings = 60;  // more than a double has digits
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (lengthTo(middle) < length_mm ? low : high) = middle;
  }
  return high;
}

/// The distance of the sides, which is the speed of the surface across for a tension of 1.
double distanceAt(const Task& task, const std::vector<SideSample>& at, double share) {
  const double distance_mm = (at[1].point - at[0].point).norm();
  if (!(distance_mm > task.tolerance.gap_mm))
    throw GeometryError(fmt::format(
        "at the share {:.3g} of their lengths the sides are {:.3g} mm apart: that is no "
        "more than the gap tolerance of {:.3g} mm",
        share, distance_mm, task.tolerance.gap_mm));
  return distance_mm;
}

/// The derivatives by the parameter across, of each end, at a share of the sides.
std::vector<CurveDerivatives> derivativesAt(const Task& task, double share) {
  std::vector<SideSample> at;
  for (const BlendSide& side : task.sides) at.push_back(side.at(share, share < 1));
  std::vector<CurveDerivatives> result;
  for (int k = 0; k < task.count(); ++k) {
    // Both ends run with the parameter: out of the face at the start, into it at the end.
    result.push_back(continuation(at[k], k == 0 ? 1 : -1, task.ends[k].order));
    const double speed_mm = task.count() < 2 ? parameterAtLength(result[k], task.length_mm)
                                             : task.ends[k].tension * distanceAt(task, at, share);
    for (int order = 1; order <= task.ends[k].order; ++order)
      result[k].row(order) *= std::pow(speed_mm, order);
    if (!result[k].allFinite())
      throw GeometryError(
          fmt::format("at the share {:.3g} of side {} the face has no tangent plane, or the {} is "
                      "too large",
                      share, k + 1, task.count() < 2 ? "length" : "tension"));
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
  const std::vector<double>& parameters = interpolation.parameters();
  std::vector<Eigen::MatrixXd> values;
  for (const BlendEnd& end : task.ends) values.emplace_back(parameters.size(), 3 * (end.order + 1));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::vector<CurveDerivatives> derivatives = derivativesAt(task, parameters[i]);
    for (int k = 0; k < task.count(); ++k)
      values[k].row(static_cast<Eigen::Index>(i)) = derivatives[k].reshaped<Eigen::RowMajor>();
  }
  std::vector<SheetRibbon> ribbons;
  for (int k = 0; k < task.count(); ++k) {
    const Eigen::MatrixXd poles = interpolation.poles(values[k]);
    ribbons.push_back({.degree = degree_along, .knots = knots, .derivatives = {}});
    for (int order = 0; order <= task.ends[k].order; ++order)
      ribbons[k].derivatives.emplace_back(poles.middleCols(3 * order, 3));
  }
  return task.count() < 2 ? taylorSheet(ribbons[0]) : hermiteSheet(ribbons[0], ribbons[1]);
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

/// The middles of spans in which a seam is beyond that share of its tolerance.
std::vector<double> middlesOfPoorSpans(const Task& task, const BSplineSurface& sheet,
                                       const Knots& knots, double share_of_tolerance) {
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
      for (int k = 0; k < task.count(); ++k)
        excess = std::max(excess, excessAt(task, sheet, k, start + (i + 0.5) / samples * length));
    if (excess > share_of_tolerance) result.push_back(start + 0.5 * length);
  }
  return result;
}

/// The faces beside the new one, and the new one last.
struct Neighbourhood {
  TopoDS_Compound shape;
  std::vector<int> faces;  ///< numbers in the model
};

Neighbourhood around(const std::vector<ChosenEnd>& ends, const TopoDS_Face& face) {
  Neighbourhood result;
  std::vector<TopoDS_Shape> parts;
  for (const ChosenEnd& end : ends)
    for (const HoleEdge& edge : end.edges.edges) {
      if (std::ranges::count(result.faces, edge.use.face) > 0) continue;
      parts.push_back(edge.use.shape);
      result.faces.push_back(edge.use.face);
    }
  parts.push_back(face);
  result.shape = compoundOf(parts);
  return result;
}

bool isOf(const ChosenEnd& end, const Coedge& use) {
  return std::ranges::any_of(end.edges.edges,
                             [&](const HoleEdge& edge) { return edge.use.edge.IsSame(use.edge); });
}

/// The number of the end that a coedge belongs to, or that of ends if to none.
std::size_t endOf(const std::vector<ChosenEnd>& ends, const Coedge& use) {
  std::size_t k = 0;
  while (k < ends.size() && !isOf(ends[k], use)) ++k;
  return k;
}

void measureSeams(const TopoDS_Shape& model, const std::vector<ChosenEnd>& ends, const Task& task,
                  BlendSurfaceReport& report) {
  const Neighbourhood around_it = around(ends, report.face);
  const int made = static_cast<int>(around_it.faces.size()) + 1;
  SeamGraph graph = findSeams(around_it.shape);
  const double match_mm = 2 * task.tolerance.gap_mm;
  matchFreeEdges({.match_mm = match_mm, .gap_mm = task.tolerance.gap_mm}, graph);
  const TopTools_IndexedMapOfShape edges = partsOf(model, TopAbs_EDGE);
  report.reached = true;
  std::vector<double> covered_mm(ends.size(), 0);
  for (const Seam& seam : graph.seams) {
    const int other = seam.sides[0].face == made ? 1 : 0;
    if (seam.sides[1 - other].face != made || seam.sides[other].face == made) continue;
    const std::size_t k = endOf(ends, seam.sides[other]);
    if (k == ends.size()) continue;
    const auto level = static_cast<Level>(static_cast<int>(Level::G0) + task.ends[k].order);
    Seam named = seam;
    named.sides[other].face = around_it.faces[seam.sides[other].face - 1];
    named.sides[1 - other].face = 0;
    SeamResult result =
        measureSeam(named, {.tolerance = task.tolerance, .level = level, .match_mm = match_mm});
    report.reached = report.reached && result.verdict.level >= level && result.verdict.certain &&
                     result.figures.degenerate.empty();
    covered_mm[k] += result.length_mm;
    result.faces = {named.sides[other].face, 0};
    result.edges = {edges.FindIndex(seam.sides[other].edge)};
    report.seams.push_back({.result = std::move(result), .level = level});
  }
  for (std::size_t k = 0; k < ends.size(); ++k) {
    // A seam may end a little before the side does.
    constexpr double most_of_it = 0.98;
    if (covered_mm[k] < most_of_it * ends[k].path->length_mm()) report.reached = false;
  }
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

/// Halves spans until no sample is beyond that share of the tolerance, or no span can be halved.
BSplineSurface refined(const Task& task, double share_of_tolerance, int max_spans, Knots& knots,
                       const Progress& progress) {
  for (int round = 0;; ++round) {
    checkProgress(progress, shareAfter(round));
    BSplineSurface sheet = sheetOver(task, knots.flat());
    const std::vector<double> middles = middlesOfPoorSpans(task, sheet, knots, share_of_tolerance);
    const int before = knots.spans();
    if (before + static_cast<int>(middles.size()) > max_spans) return sheet;
    for (const double at : middles) knots.add(at, Knots::free);
    if (knots.spans() == before) return sheet;
  }
}

/// The sheet with as many spans as its seams need, and its seams.
BlendSurfaceReport fitted(const TopoDS_Shape& model, const std::vector<ChosenEnd>& ends,
                          const Task& task, const BlendSurfaceOptions& options,
                          const Progress& progress) {
  Knots knots = firstKnots(task);
  BlendSurfaceReport report;
  // Seams are worst between the samples: then less is allowed at these.
  for (const double share : {0.5, 0.25, 0.125}) {
    const int before = report.spans;
    report.surface = refined(task, share, options.max_spans, knots, progress);
    report.spans = knots.spans();
    if (report.spans == before) break;
    report.face = faceOf(report.surface);
    report.seams.clear();
    measureSeams(model, ends, task, report);
    if (report.reached) break;
  }
  report.shape = compoundOf({model, report.face});
  return report;
}

SplineClosure closureOf(const ChosenEnd& end) {
  // Where edges join the derivatives along the side may jump, so nothing has to be periodic.
  return end.closed && end.path->isOneEdge() ? SplineClosure::Periodic : SplineClosure::Open;
}

}  // namespace

BlendSurfaceReport blendSurface(const TopoDS_Shape& model, const BlendEnd& start,
                                const BlendEnd& end, const BlendSurfaceOptions& options,
                                const Progress& progress) {
  options.tolerance.validate();
  requireEnd("start", start);
  requireEnd("end", end);
  const std::vector<ChosenEnd> ends = {chosenEnd("start", model, start, options),
                                       chosenEnd("end", model, end, options)};
  if (ends[0].closed != ends[1].closed)
    throw std::invalid_argument(
        fmt::format("one side is closed, the {} is not", ends[0].closed ? "end" : "start"));
  const BlendSide first(ends[0].path, false);
  const Task task{.sides = {first, facing(first, ends[1])},
                  .ends = {start, end},
                  .closure = closureOf(ends[0]),
                  .tolerance = options.tolerance};
  return fitted(model, ends, task, options, progress);
}

BlendSurfaceReport extendSurface(const TopoDS_Shape& model, const BlendEnd& side, double length_mm,
                                 const BlendSurfaceOptions& options, const Progress& progress) {
  options.tolerance.validate();
  requireEnd("side", side);
  if (side.order < 1) throw std::invalid_argument("order is 0: an extension is G1, G2 or G3");
  if (!(length_mm > 0) || !std::isfinite(length_mm))
    throw std::invalid_argument(
        fmt::format("length_mm is {}: it must be positive and finite", length_mm));
  const std::vector<ChosenEnd> ends = {chosenEnd("side", model, side, options)};
  BlendEnd end = side;
  end.tension = 1;
  const Task task{.sides = {BlendSide(ends[0].path, false)},
                  .ends = {end},
                  .length_mm = length_mm,
                  .closure = closureOf(ends[0]),
                  .tolerance = options.tolerance};
  return fitted(model, ends, task, options, progress);
}

}  // namespace seamwright::occ
