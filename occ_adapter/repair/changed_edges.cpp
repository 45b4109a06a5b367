// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <BRep_CurveRepresentation.hxx>
#include <BRep_ListIteratorOfListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <exception>

#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/repair/changed_edges.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// Whether the image of the edge on any face moves.
bool isEdgeMoved(const ChangedGeometry& geometry, int edge, const std::vector<int>& faces) {
  for (const int face : faces) {
    if (geometry.hasNewPath(edge, face)) return true;
    if (!geometry.changes(face)) continue;
    const PlacedSurface before = geometry.surfaceBefore(face), after = geometry.surfaceAfter(face);
    for (const PlanarPath& path : geometry.pathsAfter(edge, face))
      if (largestDistance_mm(before, after, path) > geometry.near_mm()) return true;
  }
  return false;
}

void setPath(const std::vector<PlanarPath>& paths, const PlacedSurface& on, TopoDS_Edge& placed) {
  const BRep_Builder builder;
  if (paths.size() == 2)
    builder.UpdateEdge(placed, paths[0].curve, paths[1].curve, on.surface, on.location, 0);
  else
    builder.UpdateEdge(placed, paths[0].curve, on.surface, on.location, 0);
  builder.Range(placed, on.surface, on.location, paths[0].first, paths[0].last);
}

/// Takes over what the old edge states about the continuity of two faces.
void setContinuity(const ChangedGeometry& geometry, const TopoDS_Edge& old, int a, int b,
                   TopoDS_Edge& placed) {
  const TopoDS_Face face_a = geometry.parts().face(a), face_b = geometry.parts().face(b);
  if (a == b && !BRep_Tool::IsClosed(old, face_a)) return;
  if (!BRep_Tool::HasContinuity(old, face_a, face_b)) return;
  const PlacedSurface on_a = geometry.storedAfter(a), on_b = geometry.storedAfter(b);
  BRep_Builder().Continuity(placed, on_a.surface, on_b.surface, on_a.location, on_b.location,
                            BRep_Tool::Continuity(old, face_a, face_b));
}

/// Removes the pcurve on the old surface unless another face beside the edge lies on that surface
/// and stays.
void forgetOldSurface(const ChangedGeometry& geometry, int face, const std::vector<int>& faces,
                      const TopoDS_Edge& placed) {
  const PlacedSurface old = geometry.surfaceBefore(face);
  for (const int other : faces) {
    if (geometry.changes(other)) continue;
    const PlacedSurface beside = geometry.surfaceBefore(other);
    if (beside.surface == old.surface && beside.location == old.location) return;
  }
  const TopLoc_Location in_edge = old.location.Predivided(placed.Location());
  // BRep_Builder removes pcurves, but not what an edge states about continuity.
  BRep_ListOfCurveRepresentation& all =
      handle<BRep_TEdge>::DownCast(placed.TShape())->ChangeCurves();
  for (BRep_ListIteratorOfListOfCurveRepresentation it(all); it.More();) {
    const handle<BRep_CurveRepresentation>& one = it.Value();
    const bool is_of_it =
        one->IsCurveOnSurface(old.surface, in_edge) ||
        (one->IsRegularity() && ((one->Surface() == old.surface && one->Location() == in_edge) ||
                                 (one->Surface2() == old.surface && one->Location2() == in_edge)));
    if (is_of_it)
      all.Remove(it);
    else
      it.Next();
  }
}

/// Stores pcurves on new surfaces, new pcurves, and pcurves that were implied by a curve in space
/// that moves.
void setPaths(const ChangedGeometry& geometry, int edge, const std::vector<int>& faces, bool moved,
              TopoDS_Edge& placed) {
  const TopoDS_Edge old = geometry.parts().edge(edge);
  for (const int face : faces) {
    const bool is_new = geometry.changes(face) || geometry.hasNewPath(edge, face);
    if (is_new || (moved && !hasStoredPath(old, geometry.parts().face(face))))
      setPath(geometry.pathsAfter(edge, face), geometry.storedAfter(face), placed);
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i; j < faces.size(); ++j)
      if (geometry.changes(faces[i]) || geometry.changes(faces[j]))
        setContinuity(geometry, old, faces[i], faces[j], placed);
  for (const int face : faces)
    if (geometry.changes(face)) forgetOldSurface(geometry, face, faces, placed);
}

/// Rebuilds the curve in space if the edge moved, and measures the tolerance.
void setCurve(const TopoDS_Edge& old, double near_mm, ChangedEdge& edge) {
  double first = 0, last = 0;
  edge.curve = BRep_Tool::Curve(old, first, last);
  edge.moved = edge.moved || edge.curve.IsNull();
  const handle<BRep_TEdge> part = handle<BRep_TEdge>::DownCast(edge.bare.TShape());
  if (edge.moved) {
    const BRep_Builder builder;
    edge.curve = meanImage(edge.sides, edge.first, edge.last, near_mm);
    builder.UpdateEdge(edge.bare,
                       handle<Geom_Curve>::DownCast(edge.curve->Transformed(outOf(old.Location()))),
                       TopLoc_Location(), 0);
    builder.Range(edge.bare, edge.first, edge.last, true);
    const bool one_range = std::ranges::all_of(edge.sides, [&edge](const EdgeSide& side) {
      return side.path.first == edge.first && side.path.last == edge.last;
    });
    if (one_range) part->SameRange(true);
    if (one_range) part->SameParameter(true);
  }
  const double measured = largestDistance_mm(edge.sides, *edge.curve, edge.first, edge.last);
  if (edge.moved)
    edge.tolerance_mm = std::max(Precision::Confusion(), between_points * measured);
  else if (measured > edge.tolerance_mm)
    edge.tolerance_mm = between_points * measured;
  part->Tolerance(edge.tolerance_mm);
}

ChangedEdge changedEdge(const ChangedGeometry& geometry, int number) {
  const TopoDS_Edge old = geometry.parts().edge(number);
  const std::vector<int> faces = geometry.parts().facesOfEdge(number);
  ChangedEdge edge;
  edge.sides = geometry.sidesAfter(number);
  edge.tolerance_mm = BRep_Tool::Tolerance(old);
  edge.moved = isEdgeMoved(geometry, number, faces);
  TopoDS_Edge placed = TopoDS::Edge(old.EmptyCopied());
  setPaths(geometry, number, faces, edge.moved, placed);
  edge.bare = TopoDS::Edge(bare(placed));
  BRep_Tool::Range(old, edge.first, edge.last);
  if (!BRep_Tool::Degenerated(old)) setCurve(old, geometry.near_mm(), edge);
  return edge;
}

}  // namespace

std::map<int, ChangedEdge> changedEdges(const ChangedGeometry& geometry, int jobs) {
  const std::set<int> all = geometry.edges();
  const std::vector<int> numbers(all.begin(), all.end());
  for (const int number : numbers) geometry.parts().edges().requireOnce(number);
  std::vector<ChangedEdge> edges(numbers.size());
  std::vector<std::exception_ptr> errors(numbers.size());
  // Safe on several threads: each call writes only data that no other call reads.
  const auto change = [&](std::size_t k) {
    try {
      edges[k] = changedEdge(geometry, numbers[k]);
    } catch (...) {
      errors[k] = std::current_exception();
    }
  };
  runParallel(numbers.size(), jobs, change, {});
  std::map<int, ChangedEdge> changed;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    // The error of the first edge is thrown, whichever thread was faster.
    if (errors[k]) std::rethrow_exception(errors[k]);
    changed[numbers[k]] = std::move(edges[k]);
  }
  return changed;
}

}  // namespace seamwright::occ
