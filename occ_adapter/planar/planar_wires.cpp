// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <stdexcept>

#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/curves/edge_chain.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/model/compound.hpp>
#include <seamwright/occ_adapter/planar/planar_curves.hpp>
#include <seamwright/occ_adapter/planar/planar_wires.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;
using opencascade::handle;

Poles hullOfChain(const EdgeChain& chain) {
  std::vector<Poles> hulls;
  Eigen::Index rows = 0;
  for (const auto& [edge, forward] : chain.edges) {
    hulls.push_back(hullOf(*edge.curve, edge.first, edge.last));
    rows += hulls.back().rows();
  }
  Poles result(rows, 3);
  rows = 0;
  for (const Poles& hull : hulls) {
    result.middleRows(rows, hull.rows()) = hull;
    rows += hull.rows();
  }
  return result;
}

double heightOver(const PlaneFrame& frame, const Poles& points) {
  return ((points.rowwise() - frame.origin.transpose()) * frame.normal()).cwiseAbs().maxCoeff();
}

/// An earlier plane if the points lie in it up to rounding, else the one that fits them.
FittedPlane planeOf(const Poles& points, const std::vector<PlanarWire>& earlier) {
  constexpr double rounding = 1e-12;
  const double size_mm = points.cwiseAbs().maxCoeff();
  for (const PlanarWire& wire : earlier) {
    const double height_mm = heightOver(wire.frame, points);
    if (height_mm <= rounding * size_mm) return {.frame = wire.frame, .distance_mm = height_mm};
  }
  return fitPlane(points);
}

void appendCurves(PlanarWire& wire, const SpaceEdge& edge, bool forward) {
  std::vector<ChainCurve> curves = planarCurves(*edge.curve, edge.first, edge.last, wire.frame);
  if (!forward) {
    std::ranges::reverse(curves);
    for (ChainCurve& curve : curves) curve = reversed(curve);
  }
  wire.chain.curves.insert(wire.chain.curves.end(), curves.begin(), curves.end());
  wire.edges.push_back(edge.number);
}

double largestGap(const PlanarChain& chain) {
  double gap_mm = 0;
  for (std::size_t i = 1; i < chain.curves.size(); ++i)
    gap_mm = std::max(gap_mm, (endOf(chain.curves[i - 1]) - startOf(chain.curves[i])).norm());
  if (chain.closed)
    gap_mm = std::max(gap_mm, (endOf(chain.curves.back()) - startOf(chain.curves.front())).norm());
  return gap_mm;
}

PlanarWire planarWire(const EdgeChain& chain, double flatness_mm,
                      const std::vector<PlanarWire>& earlier) {
  PlanarWire wire;
  const FittedPlane plane = planeOf(hullOfChain(chain), earlier);
  wire.frame = plane.frame;
  wire.height_mm = plane.distance_mm;
  wire.chain.closed = chain.closed;
  if (wire.height_mm > flatness_mm)
    throw GeometryError(
        fmt::format("not planar: {:.3g} mm from the nearest plane, more than {:.6g} mm",
                    wire.height_mm, flatness_mm));
  for (const auto& [edge, forward] : chain.edges) appendCurves(wire, edge, forward);
  wire.gap_mm = largestGap(wire.chain);
  return wire;
}

TopoDS_Vertex vertexAt(const Vector3d& point) {
  TopoDS_Vertex vertex;
  BRep_Builder().MakeVertex(vertex, pointOf(point), Precision::Confusion());
  return vertex;
}

/// The tolerance of the vertex grows to the distance of the point.
void cover(const TopoDS_Vertex& vertex, const gp_Pnt& point) {
  // The distance itself has a rounding.
  constexpr double rounding = 1 + 1e-12;
  BRep_Builder().UpdateVertex(vertex, rounding * BRep_Tool::Pnt(vertex).Distance(point));
}

TopoDS_Edge edgeBetween(const handle<Geom_Curve>& curve, const TopoDS_Vertex& start,
                        const TopoDS_Vertex& end) {
  const BRep_Builder builder;
  TopoDS_Edge edge;
  const double first = curve->FirstParameter(), last = curve->LastParameter();
  cover(start, curve->Value(first));
  cover(end, curve->Value(last));
  const auto trimmed = handle<Geom_TrimmedCurve>::DownCast(curve);
  builder.MakeEdge(edge, trimmed.IsNull() ? curve : trimmed->BasisCurve(), Precision::Confusion());
  builder.Add(edge, start.Oriented(TopAbs_FORWARD));
  builder.Add(edge, end.Oriented(TopAbs_REVERSED));
  builder.Range(edge, first, last);
  return edge;
}

}  // namespace

PlanarWireSearch findPlanarWires(const TopoDS_Shape& shape, const PlanarWireOptions& options) {
  PlanarWireSearch result;
  for (const EdgeChain& chain : edgeChains(shape, options.chains)) {
    const auto refuseChain = [&](const std::exception& error) {
      RefusedChain refused{.edges = {}, .reason = error.what()};
      for (const auto& [edge, forward] : chain.edges) refused.edges.push_back(edge.number);
      result.refused.push_back(std::move(refused));
    };
    try {
      result.wires.push_back(planarWire(chain, options.flatness_mm, result.wires));
    } catch (const GeometryError& error) {
      refuseChain(error);
    } catch (const std::invalid_argument& error) {  // numbers that core refuses
      refuseChain(error);
    } catch (const std::domain_error& error) {  // a kind of curve that core does not know
      refuseChain(error);
    }
  }
  return result;
}

std::vector<PlanarWire> planarWires(const TopoDS_Shape& shape, const PlanarWireOptions& options) {
  PlanarWireSearch found = findPlanarWires(shape, options);
  if (!found.refused.empty()) {
    const RefusedChain& first = found.refused.front();
    throw GeometryError(fmt::format("Edge{}: {}", first.edges.front(), first.reason));
  }
  return std::move(found.wires);
}

TopoDS_Wire wireOf(const PlanarChain& chain, const PlaneFrame& frame) {
  if (chain.curves.empty()) throw std::invalid_argument("a chain of curves is empty");
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  const TopoDS_Vertex first = vertexAt(frame.point(startOf(chain.curves.front())));
  TopoDS_Vertex start = first;
  for (std::size_t i = 0; i < chain.curves.size(); ++i) {
    const bool last = i + 1 == chain.curves.size();
    const TopoDS_Vertex end =
        last ? (chain.closed ? first : vertexAt(frame.point(endOf(chain.curves[i]))))
             : vertexAt(frame.point(startOf(chain.curves[i + 1])));
    builder.Add(wire, edgeBetween(toGeom(chain.curves[i], frame), start, end));
    start = end;
  }
  wire.Closed(chain.closed);
  return wire;
}

TopoDS_Shape wiresOf(const std::vector<PlanarWire>& wires) {
  std::vector<TopoDS_Shape> made;
  for (const PlanarWire& wire : wires) made.push_back(wireOf(wire.chain, wire.frame));
  return compoundOf(made);
}

}  // namespace seamwright::occ
