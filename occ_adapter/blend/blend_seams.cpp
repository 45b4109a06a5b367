// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include <seamwright/core/bspline/surface_jets.hpp>
#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/blend/blend_seams.hpp>
#include <seamwright/occ_adapter/blend/blend_sheet.hpp>
#include <seamwright/occ_adapter/blend/lateral_fit.hpp>
#include <seamwright/occ_adapter/model/compound.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::occ {

namespace {

/// The faces of one boundary, and the new one last.
struct Neighbourhood {
  TopoDS_Compound shape;
  std::vector<int> faces;  ///< numbers in the model
};

Neighbourhood around(const HoleSide& side, const TopoDS_Face& face) {
  Neighbourhood result;
  std::vector<TopoDS_Shape> parts;
  for (const HoleEdge& edge : side.edges) {
    if (std::ranges::count(result.faces, edge.use.face) > 0) continue;
    parts.push_back(edge.use.shape);
    result.faces.push_back(edge.use.face);
  }
  parts.push_back(face);
  result.shape = compoundOf(parts);
  return result;
}

bool isOf(const HoleSide& side, const Coedge& use) {
  return std::ranges::any_of(side.edges,
                             [&](const HoleEdge& edge) { return edge.use.edge.IsSame(use.edge); });
}

/// A boundary of a new face: where a parameter, u or v, is 0 or 1.
struct BlendBoundary {
  int parameter = 0;  ///< 0: u, 1: v
  int value = 0;
};

/// Whether an edge of a new face lies on its boundary.
bool isAt(const Coedge& use, const BlendBoundary& boundary) {
  double first = 0, last = 0;
  const opencascade::handle<Geom2d_Curve> path =
      BRep_Tool::CurveOnSurface(use.edge, use.shape, first, last);
  constexpr double near = 1e-6;  // far from the other boundaries
  const auto is_there = [&](double at) {
    return std::abs(path->Value(at).Coord(1 + boundary.parameter) - boundary.value) < near;
  };
  return !path.IsNull() && is_there(first) && is_there(0.5 * (first + last)) && is_there(last);
}

/// The seams of the new edges at a boundary with the edges there, and with no others.
SeamGraph seamsAt(const HoleSide& side, const BlendBoundary& boundary,
                  const Neighbourhood& around_it, const MatchOptions& options) {
  SeamGraph graph = findSeams(around_it.shape);
  graph.seams.clear();
  const int made = static_cast<int>(around_it.faces.size()) + 1;
  SeamGraph result;
  for (std::size_t i = 0; i < graph.open.size(); ++i) {
    const Coedge& use = graph.open_uses[i];
    if (use.face == made ? !isAt(use, boundary) : !isOf(side, use)) continue;
    result.open.push_back(graph.open[i]);
    result.open_uses.push_back(use);
  }
  matchFreeEdges(options, result);
  return result;
}

/// The largest distance between a side and the boundary of the sheet that was made on it.
double farthest_mm(const BlendSide& side, const BSplineSurface& sheet, std::size_t k) {
  constexpr int samples = 256;
  const SurfaceJets jets(sheet);
  double largest = 0;
  for (int i = 0; i <= samples; ++i) {
    const double share = static_cast<double>(i) / samples;
    const Eigen::Vector3d made = jets.at(share, static_cast<double>(k), 0).p;
    largest = std::max(largest, (side.at(share, i < samples).point - made).norm());
  }
  return largest;
}

/// Why seams do not cover a side; empty if they do.
std::string reasonOf(double covered_mm, double length_mm, double match_mm,
                     const std::function<double()>& apart_mm) {
  // A seam may end a little before the side does.
  constexpr double most_of_it = 0.98;
  if (covered_mm >= most_of_it * length_mm) return "";
  const std::string apart =
      fmt::format("the new edge is up to {:.3g} mm from the side, a seam at most {:.3g} mm",
                  apart_mm(), match_mm);
  if (covered_mm == 0) return "no seam: " + apart;
  return fmt::format("seams cover {:.4g} of {:.4g} mm: {}", covered_mm, length_mm, apart);
}

/// Whether there are tangent planes, but for ends, where boundaries of the model's faces collapse.
bool isRegular(const SeamFigures& figures) {
  constexpr double end = 1e-5;  // more than rounding makes of a pole
  return std::ranges::all_of(figures.degenerate, [](const DegeneratePoint& point) {
    return point.at < end || point.at > 1 - end;
  });
}

BlendEndReport unmeasured(const ChosenEnd& chosen) {
  BlendEndReport result;
  result.name = chosen.end.side.name;
  result.length_mm = chosen.path->length_mm();
  result.level = static_cast<Level>(static_cast<int>(Level::G0) + chosen.end.order);
  for (const HoleEdge& edge : chosen.edges.edges) {
    result.edges.push_back(edge.edge);
    if (std::ranges::count(result.faces, edge.use.face) == 0) result.faces.push_back(edge.use.face);
  }
  return result;
}

/// The seams of a boundary with faces of the model.
struct BoundarySeams {
  std::vector<BlendSeam> seams;
  double covered_mm = 0;
  bool reached = true;  ///< all certainly have the level
};

BoundarySeams measured(const TopoDS_Shape& model, const HoleSide& side,
                       const BlendBoundary& boundary, const TopoDS_Face& face, Level level,
                       const ContinuityTolerance& tolerance) {
  BoundarySeams found;
  const double match_mm = 2 * tolerance.gap_mm;
  const TopTools_IndexedMapOfShape edges = partsOf(model, TopAbs_EDGE);
  const Neighbourhood around_it = around(side, face);
  const int made = static_cast<int>(around_it.faces.size()) + 1;
  const SeamGraph graph = seamsAt(
      side, boundary, around_it, {.match_mm = match_mm, .gap_mm = tolerance.gap_mm, .cubic = true});
  for (const Seam& seam : graph.seams) {
    const int other = seam.sides[0].face == made ? 1 : 0;
    if (seam.sides[1 - other].face != made || seam.sides[other].face == made) continue;
    Seam named = seam;
    named.sides[other].face = around_it.faces[seam.sides[other].face - 1];
    named.sides[1 - other].face = 0;
    SeamResult result =
        measureSeam(named, {.tolerance = tolerance, .level = level, .match_mm = match_mm});
    found.reached = found.reached && result.verdict.level >= level && result.verdict.certain &&
                    isRegular(result.figures);
    found.covered_mm += result.length_mm;
    result.faces = {named.sides[other].face, 0};
    result.edges = {edges.FindIndex(seam.sides[other].edge)};
    found.seams.push_back({.result = std::move(result), .level = level});
  }
  return found;
}

BlendLateralReport unmeasuredLateral(const ChosenLateral& chosen) {
  BlendLateralReport result;
  result.edges = chosen.edges;
  result.length_mm = chosen.curve->length_mm();
  result.level = static_cast<Level>(static_cast<int>(Level::G0) + chosen.order);
  for (const HoleEdge& edge : chosen.uses.edges)
    if (std::ranges::count(result.faces, edge.use.face) == 0) result.faces.push_back(edge.use.face);
  return result;
}

void measureLateral(const TopoDS_Shape& model, const ChosenLateral& chosen,
                    const BlendLateral& lateral, const ContinuityTolerance& tolerance,
                    BlendSurfaceReport& report) {
  BlendLateralReport result = unmeasuredLateral(chosen);
  result.distance_mm = farthestFromCurve_mm(lateral, report.surface);
  if (!(result.distance_mm <= tolerance.gap_mm))
    result.reason = fmt::format("the new edge is up to {:.3g} mm from the curve, beyond {:.3g} mm",
                                result.distance_mm, tolerance.gap_mm);
  if (!chosen.uses.edges.empty()) {
    BoundarySeams found =
        measured(model, chosen.uses, {0, lateral.side == LateralSide::First ? 0 : 1}, report.face,
                 result.level, tolerance);
    result.covered_mm = found.covered_mm;
    report.reached = report.reached && found.reached;
    std::ranges::move(found.seams, std::back_inserter(report.seams));
    if (result.reason.empty())
      result.reason = reasonOf(result.covered_mm, chosen.beside->length_mm(), 2 * tolerance.gap_mm,
                               [&] { return result.distance_mm; });
  }
  report.reached = report.reached && result.reason.empty();
  report.laterals.push_back(std::move(result));
}

}  // namespace

void measureBlend(const TopoDS_Shape& model, const ChosenBlend& chosen, const BlendTask& task,
                  BlendSurfaceReport& report) {
  report.seams.clear();
  report.ends.clear();
  report.laterals.clear();
  report.fold = foldOf(report.surface);
  // A blend that folds still joins its sides; an extension that does is no continuation.
  report.reached = task.count() == 2 || !report.fold;
  for (int k = 0; k < task.count(); ++k) {
    BlendEndReport end = unmeasured(chosen.ends[k]);
    BoundarySeams found =
        measured(model, chosen.ends[k].edges, {1, k}, report.face, end.level, task.tolerance);
    end.covered_mm = found.covered_mm;
    std::ranges::move(found.seams, std::back_inserter(report.seams));
    end.reason = reasonOf(end.covered_mm, end.length_mm, 2 * task.tolerance.gap_mm,
                          [&] { return farthest_mm(task.sides[k], report.surface, k); });
    end.reached = found.reached && end.reason.empty();
    report.reached = report.reached && end.reached;
    report.ends.push_back(std::move(end));
  }
  for (std::size_t i = 0; i < task.laterals.size(); ++i)
    measureLateral(model, chosen.laterals[i], task.laterals[i], task.tolerance, report);
}

}  // namespace seamwright::occ
