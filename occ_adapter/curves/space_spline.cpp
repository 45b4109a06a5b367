// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Conic.hxx>
#include <Geom_Line.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/convert/spline_curve.hpp>
#include <seamwright/occ_adapter/curves/space_spline.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/model/compound.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

const Geom_Curve& basisOf(const Geom_Curve& curve) {
  const auto* trimmed = dynamic_cast<const Geom_TrimmedCurve*>(&curve);
  return trimmed ? *trimmed->BasisCurve() : curve;
}

/// The curve of an edge in its own direction.
BSplineCurve splineOf(const SpaceEdge& edge) {
  const Geom_Curve& basis = basisOf(*edge.curve);
  if (dynamic_cast<const Geom_Line*>(&basis)) {
    Poles ends(2, 3);
    ends << edge.ends[0].transpose(), edge.ends[1].transpose();
    return splineCurve(BezierCurve(ends));
  }
  const handle<Geom_Curve> part = new Geom_TrimmedCurve(edge.curve, edge.first, edge.last);
  return coreCurve(dynamic_cast<const Geom_Conic*>(&basis) ? *GeomConvert::CurveToBSplineCurve(part)
                                                           : *part);
}

/// The segments of the edges along the chain.
std::vector<BezierCurve> segmentsOf(const EdgeChain& chain) {
  std::vector<BezierCurve> segments;
  for (const auto& [edge, forward] : chain.edges) {
    const BezierSpline spline = bezierSpline(splineOf(edge));
    for (int i = 0; i < spline.segments(); ++i)
      segments.push_back(forward ? segment(spline, i)
                                 : segment(spline, spline.segments() - 1 - i).reversed());
  }
  return segments;
}

double gapBetween(const BezierCurve& a, const BezierCurve& b) {
  return (a.point(1) - b.point(0)).norm();
}

SpaceSpline spaceSpline(const EdgeChain& chain) {
  const std::vector<BezierCurve> segments = segmentsOf(chain);
  SpaceSpline result;
  for (const auto& [edge, forward] : chain.edges) result.edges.push_back(edge.number);
  for (std::size_t i = 1; i < segments.size(); ++i)
    result.gap_mm = std::max(result.gap_mm, gapBetween(segments[i - 1], segments[i]));
  if (chain.closed)
    result.gap_mm = std::max(result.gap_mm, gapBetween(segments.back(), segments.front()));
  // Segments without a length are left out, and their gaps add.
  result.spline = splineOverLengths(segments, chain.closed, 2 * result.gap_mm);
  return result;
}

/// Two segments over lengths for which their derivatives by the parameter agree, if the tangents
/// do. \returns the length of the second one for the length 1 of the first one; 0 if the tangents
/// differ.
double smoothRatio(const BezierSpline& spline, int joint) {
  const BezierCurve left = segment(spline, joint - 1), right = segment(spline, joint);
  const double before = left.derivatives(1, 1).row(1).norm(),
               after = right.derivatives(0, 1).row(1).norm(), ratio = after / before;
  if (!(ratio > 0) || !std::isfinite(ratio)) return 0;
  const BezierSpline pair = bezierSpline({left, right}, {0, 1, 1 + ratio});
  return continuity(pair) >= 1 ? ratio : 0;
}

/// Segments first .. last - 1 with the knots that make their first derivatives agree.
BezierSpline runOf(const BezierSpline& spline, int first, const std::vector<double>& ratios) {
  BezierSpline run;
  run.degree = spline.degree;
  run.knots = {0, 1};
  double length = 1;
  for (const double ratio : ratios) {
    length *= ratio;
    run.knots.push_back(run.knots.back() + length);
  }
  run.poles = spline.poles.middleRows(static_cast<Eigen::Index>(first) * spline.degree,
                                      run.segments() * spline.degree + 1);
  return run;
}

std::vector<BezierSpline> smoothRuns(const BezierSpline& spline) {
  std::vector<BezierSpline> runs;
  int first = 0;
  std::vector<double> ratios;
  for (int i = 1; i <= spline.segments(); ++i) {
    const double ratio = i < spline.segments() ? smoothRatio(spline, i) : 0;
    if (ratio > 0) {
      ratios.push_back(ratio);
      continue;
    }
    runs.push_back(runOf(spline, first, ratios));
    first = i;
    ratios.clear();
  }
  return runs;
}

TopoDS_Vertex vertexAt(const gp_Pnt& point) {
  TopoDS_Vertex vertex;
  BRep_Builder().MakeVertex(vertex, point, Precision::Confusion());
  return vertex;
}

TopoDS_Edge edgeOf(const handle<Geom_BSplineCurve>& curve, const TopoDS_Vertex& start,
                   const TopoDS_Vertex& end) {
  const BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge, curve, Precision::Confusion());
  builder.Add(edge, start.Oriented(TopAbs_FORWARD));
  builder.Add(edge, end.Oriented(TopAbs_REVERSED));
  builder.Range(edge, curve->FirstParameter(), curve->LastParameter());
  return edge;
}

}  // namespace

std::vector<SpaceSpline> spaceSplines(const TopoDS_Shape& shape, const EdgeChainOptions& options) {
  std::vector<SpaceSpline> splines;
  for (const EdgeChain& chain : edgeChains(shape, options)) {
    const auto refused = [&](const std::exception& error) {
      return GeometryError(fmt::format("{}: {}", namesOf(chain), error.what()));
    };
    try {
      splines.push_back(spaceSpline(chain));
    } catch (const std::invalid_argument& error) {  // numbers that core refuses
      throw refused(error);
    } catch (const std::domain_error& error) {  // a kind of curve without poles
      throw refused(error);
    }
  }
  return splines;
}

TopoDS_Wire wireOf(const BezierSpline& spline) {
  requireValid(spline);
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  const std::vector<BezierSpline> runs = smoothRuns(spline);
  TopoDS_Vertex first, start;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const handle<Geom_BSplineCurve> curve = toBSplineCurve(runs[i]);
    if (i == 0) first = start = vertexAt(curve->StartPoint());
    const bool back = spline.closed && i + 1 == runs.size();
    const TopoDS_Vertex end = back ? first : vertexAt(curve->EndPoint());
    builder.Add(wire, edgeOf(curve, start, end));
    start = end;
  }
  wire.Closed(spline.closed);
  return wire;
}

TopoDS_Shape wiresOf(const std::vector<BezierSpline>& splines) {
  std::vector<TopoDS_Shape> wires;
  for (const BezierSpline& spline : splines) wires.push_back(wireOf(spline));
  return compoundOf(wires);
}

}  // namespace seamwright::occ
