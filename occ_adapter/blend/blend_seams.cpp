// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>

#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/blend/blend_seams.hpp>
#include <seamwright/occ_adapter/blend/blend_sheet.hpp>
#include <seamwright/occ_adapter/model/compound.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::occ {

namespace {

/// The faces of one end, and the new one last.
struct Neighbourhood {
  TopoDS_Compound shape;
  std::vector<int> faces;  ///< numbers in the model
};

Neighbourhood around(const ChosenEnd& end, const TopoDS_Face& face) {
  Neighbourhood result;
  std::vector<TopoDS_Shape> parts;
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

/// Whether an edge of a new face lies on its boundary v = 0 or v = 1.
bool isAtEnd(const Coedge& use, std::size_t k) {
  double first = 0, last = 0;
  const opencascade::handle<Geom2d_Curve> path =
      BRep_Tool::CurveOnSurface(use.edge, use.shape, first, last);
  constexpr double near = 1e-6;  // far from the other boundary, and from lines across
  const auto is_there = [&](double at) {
    return std::abs(path->Value(at).Y() - static_cast<double>(k)) < near;
  };
  return !path.IsNull() && is_there(first) && is_there(0.5 * (first + last)) && is_there(last);
}

/// The seams of the new edges at an end with the edges of that end, and with no others.
SeamGraph seamsAt(const ChosenEnd& end, std::size_t k, const Neighbourhood& around_it,
                  const MatchOptions& options) {
  SeamGraph graph = findSeams(around_it.shape);
  graph.seams.clear();
  const int made = static_cast<int>(around_it.faces.size()) + 1;
  SeamGraph result;
  for (std::size_t i = 0; i < graph.open.size(); ++i) {
    const Coedge& use = graph.open_uses[i];
    if (use.face == made ? !isAtEnd(use, k) : !isOf(end, use)) continue;
    result.open.push_back(graph.open[i]);
    result.open_uses.push_back(use);
  }
  matchFreeEdges(options, result);
  return result;
}

/// The largest distance between a side and the boundary of the sheet that was made on it.
double farthest_mm(const BlendSide& side, const BSplineSurface& sheet, std::size_t k) {
  constexpr int samples = 256;
  double largest = 0;
  for (int i = 0; i <= samples; ++i) {
    const double share = static_cast<double>(i) / samples;
    const Eigen::Vector3d made = jet(sheet, share, static_cast<double>(k)).p;
    largest = std::max(largest, (side.at(share, i < samples).point - made).norm());
  }
  return largest;
}

/// Why seams do not cover a side; empty if they do.
std::string reasonOf(const BlendEndReport& end, double match_mm, double apart_mm) {
  // A seam may end a little before the side does.
  constexpr double most_of_it = 0.98;
  if (end.covered_mm >= most_of_it * end.length_mm) return "";
  const std::string apart =
      fmt::format("the new edge is up to {:.3g} mm from the side, a seam at most {:.3g} mm",
                  apart_mm, match_mm);
  if (end.covered_mm == 0) return "no seam: " + apart;
  return fmt::format("seams cover {:.4g} of {:.4g} mm: {}", end.covered_mm, end.length_mm, apart);
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

}  // namespace

void measureBlend(const TopoDS_Shape& model, const std::vector<ChosenEnd>& ends,
                  const BlendTask& task, BlendSurfaceReport& report) {
  const ContinuityTolerance& tolerance = task.tolerance;
  const double match_mm = 2 * tolerance.gap_mm;
  const TopTools_IndexedMapOfShape edges = partsOf(model, TopAbs_EDGE);
  report.seams.clear();
  report.ends.clear();
  report.fold = foldOf(report.surface);
  // A blend that folds still joins its sides; an extension that does is no continuation.
  report.reached = task.count() == 2 || !report.fold;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const Neighbourhood around_it = around(ends[k], report.face);
    const int made = static_cast<int>(around_it.faces.size()) + 1;
    BlendEndReport end = unmeasured(ends[k]);
    const SeamGraph graph =
        seamsAt(ends[k], k, around_it, {.match_mm = match_mm, .gap_mm = tolerance.gap_mm});
    for (const Seam& seam : graph.seams) {
      const int other = seam.sides[0].face == made ? 1 : 0;
      if (seam.sides[1 - other].face != made || seam.sides[other].face == made) continue;
      Seam named = seam;
      named.sides[other].face = around_it.faces[seam.sides[other].face - 1];
      named.sides[1 - other].face = 0;
      SeamResult result =
          measureSeam(named, {.tolerance = tolerance, .level = end.level, .match_mm = match_mm});
      report.reached = report.reached && result.verdict.level >= end.level &&
                       result.verdict.certain && isRegular(result.figures);
      end.covered_mm += result.length_mm;
      result.faces = {named.sides[other].face, 0};
      result.edges = {edges.FindIndex(seam.sides[other].edge)};
      report.seams.push_back({.result = std::move(result), .level = end.level});
    }
    end.reason = reasonOf(end, match_mm, farthest_mm(task.sides[k], report.surface, k));
    report.reached = report.reached && end.reason.empty();
    report.ends.push_back(std::move(end));
  }
}

}  // namespace seamwright::occ
