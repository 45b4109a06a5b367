// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <seamwright/core/angle.hpp>
#include <seamwright/occ_adapter/blend/blend_seams.hpp>
#include <seamwright/occ_adapter/blend/blend_sheet.hpp>
#include <seamwright/occ_adapter/blend/blend_surface.hpp>
#include <seamwright/occ_adapter/blend/extend_to.hpp>
#include <seamwright/occ_adapter/blend/lateral_boundary.hpp>
#include <seamwright/occ_adapter/blend/lateral_fit.hpp>
#include <seamwright/occ_adapter/blend/shared_corner.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/fill/self_contact.hpp>
#include <seamwright/occ_adapter/model/compound.hpp>
#include <seamwright/occ_adapter/model/coordinate_rounding.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>

namespace seamwright::occ {

namespace {

void requireEnd(const char* name, const BlendEnd& end) {
  if (end.order < 0 || end.order > most_blend_order)
    throw std::invalid_argument(
        fmt::format("{}: order is {}: 0 to {} is possible", name, end.order, most_blend_order));
  if (!(end.tension > 0) || !std::isfinite(end.tension))
    throw std::invalid_argument(
        fmt::format("{}: tension is {}: it must be positive and finite", name, end.tension));
}

ChosenEnd chosenEnd(const char* name, const TopoDS_Shape& model, const BlendEnd& end,
                    const BlendSurfaceOptions& options) {
  ChosenEnd result;
  result.end = end;
  result.end.side.name = name;
  try {
    result.edges = chosenSide(model, result.end.side, result.closed);
    result.path = smoothPath(result.edges, result.closed, options.tolerance.gap_mm,
                             end.order == most_blend_order ? JetOrder::Third : JetOrder::Second);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", name, error.what()));
  }
  return result;
}

/// \param corners whether the end meets the other side at its ends: there it is left at right
/// angles.
void setDirections(ChosenEnd& end, const LateralDirections& given = {},
                   const std::array<bool, 2>& corners = {}) {
  LateralDirections lateral = lateralDirections(end.edges, end.closed);
  for (const int at : {0, 1})
    if (corners[at]) lateral[at].reset();
  end.directions = std::make_shared<const SideDirections>(*end.path, end.closed, lateral, given);
}

/// The ends of a side at which it meets the other one.
std::array<bool, 2> cornersOf(const std::vector<SharedCorner>& shared, int k) {
  std::array<bool, 2> corners = {};
  for (const SharedCorner& corner : shared) corners[corner.of_sides[k]] = true;
  return corners;
}

/// \throws std::invalid_argument for an edge in both sides.
void requireTwoSides(const ChosenEnd& start, const ChosenEnd& end) {
  for (const int edge : start.end.side.edges)
    if (std::ranges::count(end.end.side.edges, edge) > 0)
      throw std::invalid_argument(fmt::format(
          "edge {} is in start and in end: a surface between two sides needs different edges",
          edge));
}

/// The free edges that go on where the chain of an open side ends.
std::vector<int> edgesBeside(const TopoDS_Shape& model, const ChosenEnd& end) {
  const auto touches = [](const Coedge& a, const Coedge& b) {
    TopoDS_Vertex of_a[2], of_b[2];
    TopExp::Vertices(a.edge, of_a[0], of_a[1]);
    TopExp::Vertices(b.edge, of_b[0], of_b[1]);
    for (const TopoDS_Vertex& one : of_a)
      for (const TopoDS_Vertex& other : of_b)
        if (!one.IsNull() && one.IsSame(other)) return true;
    return false;
  };
  const SeamGraph graph = findSeams(model);
  std::vector<int> result;
  for (std::size_t i = 0; i < graph.open.size(); ++i) {
    const int edge = graph.open[i].edge;
    if (std::ranges::count(end.end.side.edges, edge) > 0) continue;
    if (std::ranges::any_of(end.edges.edges, [&](const HoleEdge& of_end) {
          return touches(of_end.use, graph.open_uses[i]);
        }))
      result.push_back(edge);
  }
  return result;
}

std::string closingFault(const TopoDS_Shape& model, const ChosenEnd& closed,
                         const ChosenEnd& open) {
  const std::vector<int> beside = edgesBeside(model, open);
  return fmt::format(
      "{0} is closed (edge {2}), {1} is not (edge {3}): both must be closed, or both open; {4}",
      closed.end.side.name, open.end.side.name, fmt::join(closed.end.side.edges, ", "),
      fmt::join(open.end.side.edges, ", "),
      beside.empty() ? fmt::format("no free edge goes on at the {}", open.end.side.name)
                     : fmt::format("the {} goes on with edge {}", open.end.side.name,
                                   fmt::join(beside, " or ")));
}

/// How the end's side runs beside the start's.
struct Facing {
  bool reversed = false;
  double begin = 0;  ///< share of the path at which a closed side begins

  BlendSide side(const ChosenEnd& end) const { return {end.path, end.directions, reversed, begin}; }
};

constexpr int facing_samples = 16;

/// The sum of squared distances of points of equal shares.
double apart(const BlendSide& a, const BlendSide& b) {
  double sum = 0;
  for (int i = 0; i <= facing_samples; ++i) {
    const double share = static_cast<double>(i) / facing_samples;
    sum += (a.at(share).point - b.at(share).point).squaredNorm();
  }
  return sum;
}

/// The angle by which the lines along a surface from a to b turn about those across: the tangent of
/// a is carried along the direction out of a, the straight line to b, and the direction into b.
double twistAt(const SideSample& a, const SideSample& b) {
  const Eigen::Vector3d across = (b.point - a.point).normalized(), into = b.beyond;
  const Eigen::Vector3d carried =
      Eigen::Quaterniond::FromTwoVectors(across, into) *
      (Eigen::Quaterniond::FromTwoVectors(-a.beyond, across) * a.derivative);
  return std::atan2(carried.cross(b.derivative).norm(), carried.dot(b.derivative));
}

/// The mean of the squared angles.
double twistBetween(const BlendSide& a, const BlendSide& b) {
  double sum = 0;
  for (int i = 0; i <= facing_samples; ++i) {
    const double share = static_cast<double>(i) / facing_samples;
    const double twist_rad =
        twistAt(a.at(share, i < facing_samples), b.at(share, i < facing_samples));
    sum += twist_rad * twist_rad;
  }
  return sum / (facing_samples + 1);
}

/// Whether tangents are carried to the other side by more than a right angle anywhere. The vertex
/// that sides share says how they run, and their angle may be that large.
bool isTwisted(const BlendTask& task) {
  if (task.count() < 2 || task.meets[0] || task.meets[1]) return false;
  for (int i = 0; i <= facing_samples; ++i) {
    const double share = static_cast<double>(i) / facing_samples;
    const bool after = i < facing_samples;
    if (twistAt(task.sides[0].at(share, after), task.sides[1].at(share, after)) >
        std::numbers::pi / 2)
      return true;
  }
  return false;
}

/// The beginning of a closed side that is nearest to the start's.
Facing nearestBegin(const BlendSide& start, const ChosenEnd& end, bool reversed) {
  Facing best{.reversed = reversed};
  if (!end.closed) return best;
  constexpr int begins = 64;
  double least = HUGE_VAL;
  const auto takeNearer = [&](double begin) {
    const Facing next{.reversed = reversed, .begin = begin - std::floor(begin)};
    const double distance = apart(start, next.side(end));
    if (distance >= least) return false;
    least = distance;
    best = next;
    return true;
  };
  for (int i = 0; i < begins; ++i) takeNearer(static_cast<double>(i) / begins);
  // Of the turn: a twist that nobody sees.
  constexpr double least_step = 1e-6;
  for (double step = 0.5 / begins; step > least_step;) {
    const double begin = best.begin;
    const bool before = takeNearer(begin - step), after = takeNearer(begin + step);
    if (!before && !after) step /= 2;
  }
  return best;
}

/// The end's side in the direction in which the surface is less twisted, or in the other one.
BlendSide facing(const BlendSide& start, const ChosenEnd& end, bool flip) {
  const BlendSide same = nearestBegin(start, end, false).side(end),
                  against = nearestBegin(start, end, true).side(end);
  const double twist = twistBetween(start, same), twist_against = twistBetween(start, against);
  // Sides across each other are as twisted in both directions, up to rounding.
  constexpr double rounding = 1e-9;
  const bool reversed = std::abs(twist - twist_against) <= rounding
                            ? apart(start, against) < apart(start, same)
                            : !(twist <= twist_against);
  return reversed != flip ? against : same;
}

/// The end's side so that these ends of both sides belong together.
BlendSide facingAt(const std::array<int, 2>& corners, const ChosenEnd& end, const char* joint,
                   bool flip) {
  if (flip)
    throw std::invalid_argument(fmt::format("flip: the {} in which direction the end runs", joint));
  return Facing{.reversed = corners[0] != corners[1]}.side(end);
}

/// The end's side beside the start's.
BlendSide facing(const BlendSide& start, const ChosenBlend& chosen,
                 const std::vector<SharedCorner>& shared, bool flip) {
  if (!chosen.laterals.empty())
    return facingAt(chosen.laterals[0].corners, chosen.ends[1], "lateral boundaries say", flip);
  if (!shared.empty())
    return facingAt(shared[0].of_sides, chosen.ends[1], "vertex that the sides share says", flip);
  return facing(start, chosen.ends[1], flip);
}

/// \throws std::invalid_argument for a lateral boundary where the sides meet.
void requireNoLateralAt(const std::vector<SharedCorner>& shared,
                        const std::vector<ChosenLateral>& laterals) {
  for (const ChosenLateral& lateral : laterals)
    for (const SharedCorner& corner : shared)
      if (lateral.corners[0] == corner.of_sides[0] || lateral.corners[1] == corner.of_sides[1])
        throw std::invalid_argument(
            fmt::format("lateral boundary of edge {}: start and end meet at one of its ends",
                        fmt::join(lateral.edges, ", ")));
}

/// A sheet, and the knots that it took.
struct SheetFit {
  RefinedSheet sheet;
  SheetKnots knots;
};

// Choices: what is worth being nearer than the tolerance; and poles along the sides of which a
// surface has few.
constexpr int more_spans_for_aims = 8, few_poles = 16;

/// What aims fall back to: an angle of no more than a tenth of the tolerance.
void weakenAims(BlendTask& task) {
  for (ContinuityTolerance& aim : task.aims) {
    if (aim.angle_rad < task.tolerance.angle_rad)
      aim.angle_rad = std::max(aim.angle_rad, 0.1 * task.tolerance.angle_rad);
    aim.curvature_rel = task.tolerance.curvature_rel;
  }
  task.has_near_aims = false;
}

/// The sheet near its aims, or nearly within the tolerance where these take too many spans.
RefinedSheet refined(BlendTask& task, double share, int max_spans, SheetKnots& knots,
                     const Progress& progress) {
  if (task.has_near_aims) {
    const SheetKnots before = knots;
    RefinedSheet sheet = refinedSheet(
        task, share, std::min(max_spans, knots.spans() + more_spans_for_aims), knots, progress);
    if (sheet.left_excess == 0) return sheet;
    weakenAims(task);
    knots = before;
  }
  return refinedSheet(task, share, max_spans, knots, progress);
}

/// A cubic sheet of fewer poles along the sides than that; nothing if it is not within its aims.
/// Knots of cubic splines, at which third derivatives jump, take one pole each of it, and several
/// of a quintic one.
std::optional<SheetFit> cubicFit(BlendTask task, double share, int max_spans, int below_poles,
                                 const Progress& progress) {
  task.degree = 3;
  SheetKnots knots(task);
  if (knots.poles() >= below_poles) return std::nullopt;
  RefinedSheet sheet = refinedSheet(task, share, max_spans, knots, progress, below_poles - 1);
  if (sheet.left_excess > 0) return std::nullopt;
  return SheetFit{std::move(sheet), std::move(knots)};
}

/// The fit with few poles: quintic ones near the aims; if these take too many, cubic ones; then
/// those within the tolerance.
SheetFit firstFit(BlendTask& task, double share, int max_spans, const Progress& progress) {
  SheetKnots knots(task);
  const bool had_near_aims = task.has_near_aims;
  BlendTask near_aims = task;
  RefinedSheet sheet = refined(task, share, max_spans, knots, progress);
  if (!task.mayBeCubic() || knots.poles() <= few_poles || sheet.left_excess > 0 ||
      task.has_near_aims)
    return {std::move(sheet), std::move(knots)};
  std::optional<SheetFit> cubic;
  if (had_near_aims) cubic = cubicFit(near_aims, share, max_spans, knots.poles(), progress);
  if (cubic) {
    task = near_aims;
  } else {
    cubic = cubicFit(task, share, max_spans, knots.poles(), progress);
  }
  if (!cubic) return {std::move(sheet), std::move(knots)};
  task.degree = 3;
  return std::move(*cubic);
}

/// Only blends that are twisted are tested: others seldom meet themselves but where they fold, and
/// the test takes longer than they do.
void noteContact(const BlendTask& task, BlendSurfaceReport& report) {
  if (!isTwisted(task) || !meetThemselves({report.face})) return;
  report.reached = false;
  std::string& reason = report.ends.back().reason;
  if (!reason.empty()) reason += "; ";
  reason += "the surface runs through itself: perhaps the end runs in the wrong direction (flip)";
}

/// The sheet with as many spans as its seams need, and its seams.
BlendSurfaceReport fitted(const TopoDS_Shape& model, const ChosenBlend& chosen, BlendTask task,
                          const BlendSurfaceOptions& options, const Progress& progress,
                          const ExtensionTarget* target = nullptr) {
  constexpr std::array<double, 3> shares = {0.5, 0.25, 0.125};
  auto [sheet, knots] = firstFit(task, shares[0], options.max_spans, progress);
  BlendSurfaceReport report;
  Eigen::Index poles = 0;
  // Seams are worst between the samples: then less is allowed at these.
  for (const double share : shares) {
    if (share < shares[0]) sheet = refined(task, share, options.max_spans, knots, progress);
    report.surface = fittedToLaterals(task, sheet.surface, share, options.max_spans, progress);
    report.spans = knots.spans();
    if (report.surface.poles.rows() == poles) break;
    poles = report.surface.poles.rows();
    report.face = target ? trimmedBy(report.surface, *target) : faceOf(report.surface);
    measureBlend(model, chosen, task, report);
    if (report.reached || knots.spans() >= options.max_spans) break;
  }
  noteContact(task, report);
  report.shape = compoundOf({model, report.face});
  return report;
}

/// Sides that are parameter lines are known up to rounding: there the fit is as near as
/// measurements of such seams show. Others are known to a tolerance. Empty if no side is one.
std::vector<ContinuityTolerance> aimsOf(const std::vector<ChosenEnd>& ends,
                                        const ContinuityTolerance& tolerance) {
  constexpr double angle_rad = 0.001 * radians_per_degree, curvature_rel = 1e-3;
  std::vector<ContinuityTolerance> aims(ends.size(), tolerance);
  bool has_any = false;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (!isAlongParameterLines(ends[k].edges)) continue;
    has_any = true;
    aims[k].angle_rad = std::min(tolerance.angle_rad, angle_rad);
    aims[k].curvature_rel = std::min(tolerance.curvature_rel, curvature_rel);
  }
  return has_any ? aims : std::vector<ContinuityTolerance>();
}

SplineClosure closureOf(const ChosenEnd& end) {
  // Where edges join the derivatives along the side may jump, so nothing has to be periodic.
  return end.closed && end.path->isOneEdge() ? SplineClosure::Periodic : SplineClosure::Open;
}

void requireTolerance(const TopoDS_Shape& model, const ContinuityTolerance& tolerance) {
  tolerance.validate();
  requireAboveRounding("gap tolerance", tolerance.gap_mm, model);
}

ChosenEnd chosenExtension(const TopoDS_Shape& model, const BlendEnd& side,
                          const BlendSurfaceOptions& options) {
  requireTolerance(model, options.tolerance);
  requireEnd("side", side);
  if (side.order < 1) throw std::invalid_argument("order is 0: an extension is G1, G2 or G3");
  ChosenEnd end = chosenEnd("side", model, side, options);
  setDirections(end);
  return end;
}

BlendTask extensionOf(const ChosenEnd& end, double length_mm, const BlendSurfaceOptions& options) {
  BlendTask task{.sides = {BlendSide(end.path, end.directions, false)},
                 .ends = {end.end},
                 .length_mm = length_mm,
                 .closure = closureOf(end),
                 .tolerance = options.tolerance,
                 .aims = aimsOf({end}, options.tolerance)};
  task.has_near_aims = !task.aims.empty();
  return task;
}

}  // namespace

BlendSurfaceReport blendSurface(const TopoDS_Shape& model, const BlendEnd& start,
                                const BlendEnd& end, const BlendSurfaceOptions& options,
                                const Progress& progress) {
  requireTolerance(model, options.tolerance);
  requireEnd("start", start);
  requireEnd("end", end);
  ChosenBlend chosen{
      {chosenEnd("start", model, start, options), chosenEnd("end", model, end, options)}};
  std::vector<ChosenEnd>& ends = chosen.ends;
  requireTwoSides(ends[0], ends[1]);
  if (ends[0].closed != ends[1].closed)
    throw std::invalid_argument(closingFault(model, ends[0].closed ? ends[0] : ends[1],
                                             ends[0].closed ? ends[1] : ends[0]));
  const std::vector<SharedCorner> shared = sharedCorners(ends, options.tolerance);
  chosen.laterals = chosenLaterals(model, options, ends);
  requireNoLateralAt(shared, chosen.laterals);
  for (const int k : {0, 1})
    setDirections(ends[k], directionsOf(chosen.laterals, ends, k), cornersOf(shared, k));
  const BlendSide first(ends[0].path, ends[0].directions, false);
  BlendTask task{.sides = {first, facing(first, chosen, shared, options.flip)},
                 .ends = {ends[0].end, ends[1].end},
                 .closure = closureOf(ends[0]),
                 .tolerance = options.tolerance,
                 .aims = aimsOf(ends, options.tolerance)};
  for (const SharedCorner& corner : shared) task.meets[corner.of_sides[0]] = true;
  task.laterals = lateralsOf(chosen.laterals, ends, task.sides, options.tolerance);
  task.has_near_aims = !task.aims.empty();
  return fitted(model, chosen, task, options, progress);
}

BlendSurfaceReport extendSurface(const TopoDS_Shape& model, const BlendEnd& side, double length_mm,
                                 const BlendSurfaceOptions& options, const Progress& progress) {
  if (!(length_mm > 0) || !std::isfinite(length_mm))
    throw std::invalid_argument(
        fmt::format("length_mm is {}: it must be positive and finite", length_mm));
  const ChosenEnd end = chosenExtension(model, side, options);
  return fitted(model, {{end}}, extensionOf(end, length_mm, options), options, progress);
}

BlendSurfaceReport extendSurfaceTo(const TopoDS_Shape& model, const BlendEnd& side, int face,
                                   const BlendSurfaceOptions& options, const Progress& progress) {
  const TopTools_IndexedMapOfShape faces = partsOf(model, TopAbs_FACE);
  requireFace(face, faces.Extent());
  const ExtensionTarget target{TopoDS::Face(faces(face)), face};
  const ChosenEnd end = chosenExtension(model, side, options);
  // Lines that bend are longer than straight ones.
  constexpr double longer = 1.5;
  const double most_mm = longer * farthestOf(*end.path, target);
  const LineLengths lengths = lengthsTo(firstSheet(extensionOf(end, most_mm, options)), target);
  // Beyond the face, so that it divides the sheet: the lines between those that were looked at may
  // be longer.
  constexpr double beyond = 1.05;
  const BlendTask task = extensionOf(end, beyond * lengths.most_mm, options);
  BlendSurfaceReport report = fitted(model, {{end}}, task, options, progress, &target);
  report.to = ExtensionEnd{face, lengths.least_mm, lengths.most_mm, gapTo(report.face, target)};
  return report;
}

}  // namespace seamwright::occ
