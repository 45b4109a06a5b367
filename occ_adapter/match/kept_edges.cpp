// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <set>

#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/convert/pcurve.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/match/kept_edges.hpp>
#include <seamwright/occ_adapter/repair/slide.hpp>

namespace seamwright::occ {

namespace {

bool isMatchedIn(const SideJoin& join, int edge) {
  return std::ranges::any_of(join.pieces, [edge](const SidePiece& piece) {
    return std::ranges::count(piece.seam.edges, edge) > 0;
  });
}

bool moves(const SideJoin& join, int face) {
  return face == join.face ||
         (join.options.average && std::ranges::any_of(join.pieces, [face](const SidePiece& piece) {
            return piece.seam.sides[1].face == face;
          }));
}

/// An edge that the mover shares with a face that is not matched there.
struct SharedEdge {
  int edge = 0;
  Coedge own, other;
  bool slides = false;  ///< on the other face, which stays and goes on on both sides of the edge
};

std::vector<SharedEdge> sharedEdges(const SideJoin& join, const Mover& mover,
                                    const SeamGraph& graph) {
  std::vector<SharedEdge> shared;
  for (const Seam& seam : graph.seams) {
    if (seam.kind != SeamKind::Shared || isMatchedIn(join, seam.edges[0]) ||
        seam.sides[0].face == seam.sides[1].face)
      continue;
    for (const int k : {0, 1}) {
      if (seam.sides[k].face != mover.number) continue;
      SharedEdge edge{seam.edges[0], seam.sides[k], seam.sides[1 - k]};
      edge.slides = !moves(join, edge.other.face) &&
                    StayingSurface(edge.other.shape)
                        .surrounds(pcurveOf(edge.other.edge, edge.other.shape,
                                            join.options.tolerance.gap_mm));
      shared.push_back(std::move(edge));
    }
  }
  return shared;
}

/// Points along an edge, with its length as the sum of their shares.
void addPoints(const SharedEdge& edge, double gap_mm, std::vector<KeptPoint>& points) {
  // A choice: a bend that is shorter than a sixteenth of an edge is near the seam, or small.
  constexpr int count = 64;
  const FaceStrip strip(edge.own, pcurveOf(edge.own.edge, edge.own.shape, gap_mm)),
      other(edge.other, pcurveOf(edge.other.edge, edge.other.shape, gap_mm));
  for (int k = 0; k <= count; ++k) {
    const double s = static_cast<double>(k) / count;
    const gp_Pnt2d uv = strip.parametersAt(s);
    KeptPoint point{{uv.X(), uv.Y()}, strip.trace(s).d.norm() / (count + 1), {}};
    // Other edges end at the ends.
    if (edge.slides && k > 0 && k < count) {
      const SidePoint there = other.at(s);
      point.normal = unitNormal(there.jet, there.noise);
    }
    points.push_back(point);
  }
}

}  // namespace

std::vector<Coedge> otherEdges(const SideJoin& join, const Mover& mover, const SeamGraph& graph) {
  std::vector<Coedge> others;
  std::set<int> seen;
  const auto add = [&](int edge, const Coedge& use) {
    if (use.face == mover.number && !isMatchedIn(join, edge) && seen.insert(edge).second)
      others.push_back(use);
  };
  for (const Seam& seam : graph.seams)
    if (seam.kind == SeamKind::Shared)
      for (const Coedge& use : seam.sides) add(seam.edges[0], use);
  for (std::size_t i = 0; i < graph.open_uses.size(); ++i)
    add(graph.open[i].edge, graph.open_uses[i]);
  return others;
}

KeptEdges keptEdges(const SideJoin& join, const Mover& mover, const SeamGraph& graph) {
  KeptEdges kept;
  for (const SharedEdge& edge : sharedEdges(join, mover, graph))
    addPoints(edge, join.options.tolerance.gap_mm, kept.points);
  double length_mm = 0;
  for (const KeptPoint& point : kept.points) length_mm += point.share;
  for (KeptPoint& point : kept.points) point.share /= length_mm;
  return kept;
}

double strayOf_mm(const KeptEdges& kept, const Geom_BSplineSurface& before,
                  const Geom_BSplineSurface& after) {
  double stray_mm = 0;
  for (const KeptPoint& point : kept.points) {
    const Eigen::Vector3d move = vector(after.Value(point.uv[0], point.uv[1])) -
                                 vector(before.Value(point.uv[0], point.uv[1]));
    stray_mm = std::max(stray_mm, point.normal ? std::abs(point.normal->dot(move)) : move.norm());
  }
  return stray_mm;
}

std::vector<PathChange> slidPaths(const SideJoin& join, const Mover& mover, const SeamGraph& graph,
                                  const opencascade::handle<Geom_BSplineSurface>& after) {
  std::vector<PathChange> paths;
  for (const SharedEdge& edge : sharedEdges(join, mover, graph)) {
    if (!edge.slides) continue;
    if (auto path = slidPath(edge.edge, edge.other, edge.own, after, join.options.tolerance.gap_mm))
      paths.push_back(*std::move(path));
  }
  return paths;
}

}  // namespace seamwright::occ
