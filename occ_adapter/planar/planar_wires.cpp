// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <stdexcept>

#include <seamwright/core/disjoint_sets.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/planar/planar_curves.hpp>
#include <seamwright/occ_adapter/planar/planar_wires.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;
using opencascade::handle;

/// An edge in the direction of its curve.
struct SpaceEdge {
  int number = 0;
  handle<Geom_Curve> curve;
  double first = 0, last = 0;
  std::array<Vector3d, 2> ends;
  double tolerance_mm = 0;
};

/// Ends that are this near meet, whatever the tolerances of their vertices: files of single curves
/// have none that tell.
constexpr double meeting_mm = 1e-6;

SpaceEdge spaceEdge(const TopoDS_Edge& edge, int number) {
  if (!isUsable(edge))
    throw GeometryError(
        fmt::format("Edge{} has numbers that are not finite, or 1e100 and more", number));
  SpaceEdge result;
  result.number = number;
  result.curve = BRep_Tool::Curve(edge, result.first, result.last);
  if (result.curve.IsNull())
    throw GeometryError(fmt::format("Edge{} has no curve in space", number));
  if (Precision::IsInfinite(result.first) || Precision::IsInfinite(result.last))
    throw GeometryError(fmt::format("Edge{} is infinite", number));
  result.ends = {vector(result.curve->Value(result.first)),
                 vector(result.curve->Value(result.last))};
  result.tolerance_mm = meeting_mm;
  TopoDS_Vertex first, last;
  TopExp::Vertices(edge, first, last);
  for (const TopoDS_Vertex& vertex : {first, last})
    if (!vertex.IsNull())
      result.tolerance_mm = std::max(result.tolerance_mm, BRep_Tool::Tolerance(vertex));
  return result;
}

bool isFree(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces) {
  if (BRep_Tool::Degenerated(edge) || faces.Extent() > 1) return false;
  return faces.IsEmpty() || !BRep_Tool::IsClosed(edge, TopoDS::Face(faces.First()));
}

std::vector<SpaceEdge> chosenEdges(const TopoDS_Shape& shape, const PlanarWireOptions& options) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  const auto edge = [&](int number) {
    return TopoDS::Edge(edges(number).Oriented(TopAbs_FORWARD));
  };
  std::vector<SpaceEdge> result;
  if (options.edges.empty()) {
    for (int i = 1; i <= edges.Extent(); ++i) {
      const bool alone = options.each_alone && !BRep_Tool::Degenerated(edge(i));
      if (alone || isFree(edge(i), faces.FindFromKey(edges(i))))
        result.push_back(spaceEdge(edge(i), i));
    }
    return result;
  }
  std::vector<int> numbers = options.edges;
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  for (const int number : numbers) {
    requireEdge(number, edges.Extent());
    result.push_back(spaceEdge(edge(number), number));
  }
  return result;
}

/// End \p side of edge \p edge, in the order of their first coordinates.
struct EdgeEnd {
  int edge = 0, side = 0;
};

/// The node of each end: ends that meet have the same one.
class EndNodes {
 public:
  explicit EndNodes(const std::vector<SpaceEdge>& edges)
      : sets_(2 * static_cast<int>(edges.size())) {
    std::vector<EdgeEnd> ends;
    double reach_mm = 0;
    for (int i = 0; i < static_cast<int>(edges.size()); ++i) {
      for (const int side : {0, 1}) ends.push_back({i, side});
      reach_mm = std::max(reach_mm, edges[i].tolerance_mm);
    }
    const auto at = [&](const EdgeEnd& end) -> const Vector3d& {
      return edges[end.edge].ends[end.side];
    };
    std::ranges::sort(ends, {}, [&](const EdgeEnd& end) { return at(end).x(); });
    for (std::size_t i = 0; i < ends.size(); ++i)
      for (std::size_t j = i + 1; j < ends.size(); ++j) {
        if (at(ends[j]).x() - at(ends[i]).x() > reach_mm) break;
        const double near_mm =
            std::max(edges[ends[i].edge].tolerance_mm, edges[ends[j].edge].tolerance_mm);
        if ((at(ends[j]) - at(ends[i])).norm() <= near_mm)
          sets_.unite(index(ends[i]), index(ends[j]));
      }
    for (const EdgeEnd& end : ends) ends_[node(end)].push_back(end);
  }

  int node(const EdgeEnd& end) { return sets_.of(index(end)); }
  /// The other end at a node where two ends meet.
  std::optional<EdgeEnd> partner(const EdgeEnd& end) {
    const std::vector<EdgeEnd>& here = ends_[node(end)];
    if (here.size() != 2) return std::nullopt;
    return here[0].edge == end.edge && here[0].side == end.side ? here[1] : here[0];
  }

 private:
  static int index(const EdgeEnd& end) { return 2 * end.edge + end.side; }

  DisjointSets sets_;
  std::map<int, std::vector<EdgeEnd>> ends_;
};

/// An edge as it is run through.
struct Step {
  int edge = 0;
  bool forward = true;
};

struct EdgeChain {
  std::vector<Step> steps;
  bool closed = false;
};

/// From an edge on, until the chain ends or comes back.
EdgeChain walk(EndNodes& nodes, Step start) {
  EdgeChain chain;
  for (Step step = start;;) {
    chain.steps.push_back(step);
    const std::optional<EdgeEnd> next = nodes.partner({step.edge, step.forward ? 1 : 0});
    if (!next) return chain;
    step = {next->edge, next->side == 0};
    if (step.edge == start.edge) {
      chain.closed = true;
      return chain;
    }
  }
}

std::vector<EdgeChain> chainsOf(const std::vector<SpaceEdge>& edges, bool each_alone) {
  std::vector<EdgeChain> chains;
  const int count = static_cast<int>(edges.size());
  if (each_alone) {
    for (int i = 0; i < count; ++i) {
      const double gap_mm = (edges[i].ends[0] - edges[i].ends[1]).norm();
      chains.push_back({{{i, true}}, gap_mm <= edges[i].tolerance_mm});
    }
    return chains;
  }
  EndNodes nodes(edges);
  std::vector<bool> used(edges.size(), false);
  for (int i = 0; i < count; ++i) {
    if (used[i]) continue;
    EdgeChain chain = walk(nodes, {i, true});
    if (!chain.closed) {  // back to its other end, and from there along all of it
      const Step back = walk(nodes, {i, false}).steps.back();
      chain = walk(nodes, {back.edge, !back.forward});
    }
    for (const Step& step : chain.steps) used[step.edge] = true;
    chains.push_back(std::move(chain));
  }
  return chains;
}

std::string namesOf(const std::vector<int>& edges) {
  constexpr std::size_t shown = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, edges.size()); ++i)
    text += fmt::format("{}Edge{}", i == 0 ? "" : ", ", edges[i]);
  if (edges.size() > shown) text += fmt::format(" and {} more", edges.size() - shown);
  return text + (edges.size() == 1 ? " is" : " are");
}

Poles hullOfChain(const std::vector<SpaceEdge>& edges, const EdgeChain& chain) {
  std::vector<Poles> hulls;
  Eigen::Index rows = 0;
  for (const Step& step : chain.steps) {
    const SpaceEdge& edge = edges[step.edge];
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

PlanarWire planarWire(const std::vector<SpaceEdge>& edges, const EdgeChain& chain,
                      double flatness_mm, const std::vector<PlanarWire>& earlier) {
  PlanarWire wire;
  const FittedPlane plane = planeOf(hullOfChain(edges, chain), earlier);
  wire.frame = plane.frame;
  wire.height_mm = plane.distance_mm;
  wire.chain.closed = chain.closed;
  std::vector<int> numbers;
  for (const Step& step : chain.steps) numbers.push_back(edges[step.edge].number);
  if (wire.height_mm > flatness_mm)
    throw GeometryError(
        fmt::format("{} not planar: {:.3g} mm from the nearest plane, more than {:.6g} mm",
                    namesOf(numbers), wire.height_mm, flatness_mm));
  for (const Step& step : chain.steps) appendCurves(wire, edges[step.edge], step.forward);
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

std::vector<PlanarWire> planarWires(const TopoDS_Shape& shape, const PlanarWireOptions& options) {
  const std::vector<SpaceEdge> edges = chosenEdges(shape, options);
  std::vector<PlanarWire> wires;
  for (const EdgeChain& chain : chainsOf(edges, options.each_alone)) {
    const auto refused = [&](const std::exception& error) {
      return GeometryError(
          fmt::format("Edge{}: {}", edges[chain.steps.front().edge].number, error.what()));
    };
    try {
      wires.push_back(planarWire(edges, chain, options.flatness_mm, wires));
    } catch (const std::invalid_argument& error) {  // numbers that core refuses
      throw refused(error);
    } catch (const std::domain_error& error) {  // a kind of curve that core does not know
      throw refused(error);
    }
  }
  return wires;
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
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const PlanarWire& wire : wires) builder.Add(compound, wireOf(wire.chain, wire.frame));
  return compound;
}

}  // namespace seamwright::occ
