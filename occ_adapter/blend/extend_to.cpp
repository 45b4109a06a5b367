// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <BOPAlgo_Splitter.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <IntCurvesFace_Intersector.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include <seamwright/occ_adapter/blend/extend_to.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>

namespace seamwright::occ {

namespace {

constexpr int lines = 64;  // across a sheet: a choice

double lineShare(int i) {
  return static_cast<double>(i) / lines;
}

/// The smallest parameter of a line across at which it meets the target.
std::optional<double> meetingOf(const opencascade::handle<Geom_Curve>& line,
                                IntCurvesFace_Intersector& target) {
  target.Perform(new GeomAdaptor_Curve(line), 0, 1);
  std::optional<double> first;
  for (int i = 1; target.IsDone() && i <= target.NbPnt(); ++i)
    if (!first || target.WParameter(i) < *first) first = target.WParameter(i);
  return first;
}

double lengthOfLine(const BSplineSurface& sheet, double u, double to) {
  constexpr int steps = 64;  // chords: the length is used to make the sheet a little longer
  double length_mm = 0;
  Eigen::Vector3d last = jet(sheet, u, 0).p;
  for (int i = 1; i <= steps; ++i) {
    const Eigen::Vector3d next = jet(sheet, u, to * i / steps).p;
    length_mm += (next - last).norm();
    last = next;
  }
  return length_mm;
}

/// Whether a path of an edge has a coordinate near a value at its ends and its middle.
bool runsAlong(const TopoDS_Edge& edge, const TopoDS_Face& face, int coordinate, double value) {
  double first = 0, last = 0;
  const opencascade::handle<Geom2d_Curve> path = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (path.IsNull()) return false;
  constexpr double near = 1e-6;  // of the range of the parameters of a sheet
  return std::ranges::all_of(std::vector{first, 0.5 * (first + last), last}, [&](double at) {
    const gp_Pnt2d uv = path->Value(at);
    return std::abs((coordinate == 0 ? uv.X() : uv.Y()) - value) < near;
  });
}

bool hasEdgeAlong(const TopoDS_Face& face, int coordinate, double value) {
  for (TopExp_Explorer at(face, TopAbs_EDGE); at.More(); at.Next())
    if (runsAlong(TopoDS::Edge(at.Current()), face, coordinate, value)) return true;
  return false;
}

}  // namespace

double farthestOf(const SidePath& path, const ExtensionTarget& target) {
  Bnd_Box box;
  BRepBndLib::Add(target.face, box);
  double farthest_mm = 0;
  const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
  for (int i = 0; i <= lines; ++i) {
    const Eigen::Vector3d p = path.atShare(lineShare(i), i < lines).point;
    const Eigen::Vector3d reach =
        (vector(low) - p).cwiseAbs().cwiseMax((vector(high) - p).cwiseAbs());
    farthest_mm = std::max(farthest_mm, reach.norm());
  }
  return farthest_mm;
}

LineLengths lengthsTo(const BSplineSurface& sheet, const ExtensionTarget& target) {
  const opencascade::handle<Geom_BSplineSurface> surface = geomSurface(sheet);
  // A line may pass an edge of the target within its tolerance.
  IntCurvesFace_Intersector intersector(target.face, BRep_Tool::Tolerance(target.face));
  LineLengths result{HUGE_VAL, 0};
  for (int i = 0; i <= lines; ++i) {
    const double u = lineShare(i);
    const std::optional<double> meeting = meetingOf(surface->UIso(u), intersector);
    if (!meeting)
      throw GeometryError(fmt::format(
          "the line across at the share {:.3g} of the side, from ({:.6g}), does not meet face {} "
          "within {:.4g} mm",
          u, fmt::join(jet(sheet, u, 0).p, ", "), target.number, lengthOfLine(sheet, u, 1)));
    const double length_mm = lengthOfLine(sheet, u, *meeting);
    result.least_mm = std::min(result.least_mm, length_mm);
    result.most_mm = std::max(result.most_mm, length_mm);
  }
  return result;
}

TopoDS_Face trimmedBy(const BSplineSurface& sheet, const ExtensionTarget& target) {
  BOPAlgo_Splitter splitter;
  splitter.AddArgument(faceOf(sheet));
  splitter.AddTool(target.face);
  splitter.SetRunParallel(false);
  splitter.SetNonDestructive(true);
  splitter.Perform();
  std::vector<TopoDS_Face> parts;
  if (!splitter.HasErrors())
    for (TopExp_Explorer at(splitter.Shape(), TopAbs_FACE); at.More(); at.Next()) {
      const TopoDS_Face part = TopoDS::Face(at.Current());
      if (hasEdgeAlong(part, 1, 0) && !hasEdgeAlong(part, 1, 1)) parts.push_back(part);
    }
  if (parts.size() != 1)
    throw GeometryError(fmt::format(
        "face {} does not divide the extension into a part beside the side and one beyond",
        target.number));
  return parts[0];
}

double gapTo(const TopoDS_Face& trimmed, const ExtensionTarget& target) {
  constexpr int samples = 16;
  double largest_mm = 0;
  for (TopExp_Explorer at(trimmed, TopAbs_EDGE); at.More(); at.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(at.Current());
    if (runsAlong(edge, trimmed, 1, 0) || runsAlong(edge, trimmed, 0, 0) ||
        runsAlong(edge, trimmed, 0, 1))
      continue;
    double first = 0, last = 0;
    const opencascade::handle<Geom2d_Curve> path =
        BRep_Tool::CurveOnSurface(edge, trimmed, first, last);
    const opencascade::handle<Geom_Surface> surface = BRep_Tool::Surface(trimmed);
    for (int i = 0; i <= samples; ++i) {
      const gp_Pnt2d uv = path->Value(first + (last - first) * i / samples);
      BRepBuilderAPI_MakeVertex point(surface->Value(uv.X(), uv.Y()));
      const BRepExtrema_DistShapeShape distance(point.Vertex(), target.face);
      largest_mm = std::max(largest_mm, distance.IsDone() ? distance.Value() : HUGE_VAL);
    }
  }
  return largest_mm;
}

}  // namespace seamwright::occ
