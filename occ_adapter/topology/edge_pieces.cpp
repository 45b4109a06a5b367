// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>

#include <seamwright/occ_adapter/topology/edge_pieces.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// Where a piece belongs to an interval: the interval's index and side.
struct IntervalSide {
  int interval = 0, side = 0;
};

/// By edge and piece.
using IntervalSides = std::map<std::pair<int, int>, IntervalSide>;

IntervalSides sidesByPiece(const std::vector<SewnInterval>& intervals) {
  IntervalSides sides;
  for (std::size_t k = 0; k < intervals.size(); ++k)
    for (const int side : {0, 1})
      sides[{intervals[k].edges[side], intervals[k].pieces[side]}] = {
          .interval = static_cast<int>(k), .side = side};
  return sides;
}

EdgePiece commonPiece(const CommonEdge& common, int interval, bool reversed) {
  EdgePiece piece;
  piece.interval = interval;
  piece.edge = TopoDS::Edge(common.edge.Oriented(reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
  piece.tolerance_mm = common.tolerance_mm;
  for (const int end : {0, 1}) {
    const bool at_first = (end == 0) != reversed;
    piece.curve_ends[end].push_back(common.curve->Value(at_first ? common.first : common.last));
    for (const EdgeSide& beside : common.sides)
      piece.image_ends[end].push_back(beside.at(at_first ? 0 : points_of_an_edge - 1));
  }
  return piece;
}

double within(double first, double last, double share) {
  return first + share * (last - first);
}

/// A piece between two parameters of an edge, with the curves of that edge.
EdgePiece ownPiece(const ShapeParts& parts, int edge, const ParameterRange& range) {
  const BRep_Builder builder;
  const TopoDS_Edge old = parts.edge(edge);
  EdgePiece piece;
  piece.edge = TopoDS::Edge(old.EmptyCopied());
  if (parts.unusable.hasEdge(edge)) return piece;  // the positions of its ends are not known
  piece.tolerance_mm = BRep_Tool::Tolerance(old);
  const bool is_part = range[0] > 0 || range[1] < 1;
  double first = 0, last = 0;
  const handle<Geom_Curve> curve = BRep_Tool::Curve(old, first, last);
  if (is_part)
    builder.Range(piece.edge, within(first, last, range[0]), within(first, last, range[1]), true);
  for (const int end : {0, 1})
    if (!curve.IsNull())
      piece.curve_ends[end].push_back(curve->Value(within(first, last, range[end])));
  for (const TopoDS_Shape& beside : parts.faces_of_edge.FindFromKey(parts.edges(edge))) {
    if (parts.unusable.hasFace(parts.faces.FindIndex(beside))) continue;
    const TopoDS_Face face = TopoDS::Face(beside.Oriented(TopAbs_FORWARD));
    const PlanarPath path = pathOf(old, face);
    if (path.curve.IsNull()) continue;
    const PlacedSurface placed = surfaceOf(face);
    if (is_part && hasStoredPath(old, face))
      builder.Range(piece.edge, placed.surface, placed.location,
                    within(path.first, path.last, range[0]),
                    within(path.first, path.last, range[1]));
    for (const int end : {0, 1})
      piece.image_ends[end].push_back(
          placed.at(path.curve->Value(within(path.first, path.last, range[end]))));
  }
  return piece;
}

}  // namespace

EdgePieces edgePieces(const ShapeParts& parts, const JoinedNodes& joined,
                      const std::vector<SewnInterval>& intervals,
                      const std::vector<CommonEdge>& common) {
  const EdgeNodes& nodes = joined.nodes;
  const IntervalSides sides = sidesByPiece(intervals);
  const auto is_corner = [&joined](int node) {
    return joined.corners.count(joined.nodes.of(node)) > 0;
  };
  EdgePieces pieces;
  for (int edge = 1; edge <= parts.edges.Extent(); ++edge) {
    if (!nodes.isCut(edge) && !is_corner(nodes.at(edge, 0)) && !is_corner(nodes.at(edge, 1)))
      continue;
    for (int k = 0; k < nodes.piecesOf(edge); ++k) {
      const auto sewn = sides.find({edge, k});
      EdgePiece piece;
      if (sewn == sides.end()) {
        piece = ownPiece(parts, edge, nodes.rangeOf(edge, k));
      } else {
        const auto [interval, side] = sewn->second;
        piece =
            commonPiece(common[interval], interval, side == 1 && intervals[interval].reversed());
      }
      piece.nodes = {nodes.at(edge, k), nodes.at(edge, k + 1)};
      pieces[edge].push_back(std::move(piece));
    }
  }
  return pieces;
}

}  // namespace seamwright::occ
