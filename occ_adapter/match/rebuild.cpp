// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <vector>

#include <seamwright/occ_adapter/convert/edge_image.hpp>
#include <seamwright/occ_adapter/match/rebuild.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// The new edge. Its vertices stand for the old ones at its ends.
struct NewSeam {
  TopoDS_Edge edge;
  TopTools_DataMapOfShapeShape vertices;  ///< by the old ones of both faces

  bool endsAt(const TopoDS_Vertex& vertex) const {
    return vertex.IsSame(TopExp::FirstVertex(edge)) || vertex.IsSame(TopExp::LastVertex(edge));
  }
};

NewSeam newSeam(const SeamPlan& plan) {
  const BRep_Builder builder;
  NewSeam seam;
  builder.MakeEdge(seam.edge, plan.curve, Precision::Confusion());
  builder.Range(seam.edge, plan.first, plan.last);
  std::array<TopoDS_Vertex, 2> ends;
  for (const int end : {0, 1})
    builder.MakeVertex(ends[end], plan.curve->Value(end == 0 ? plan.first : plan.last),
                       Precision::Confusion());
  builder.Add(seam.edge, ends[0].Oriented(TopAbs_FORWARD));
  builder.Add(seam.edge, ends[1].Oriented(TopAbs_REVERSED));
  for (const FacePlan& face : plan.faces) {
    const TopoDS_Edge old = TopoDS::Edge(face.use.edge.Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex first = TopExp::FirstVertex(old), last = TopExp::LastVertex(old);
    seam.vertices.Bind(face.with_old_edge ? first : last, ends[0]);
    seam.vertices.Bind(face.with_old_edge ? last : first, ends[1]);
  }
  return seam;
}

/// Copies of faces, and those of their edges that have a new curve in space.
struct CopiedFaces {
  TopoDS_Shell shell;
  TopTools_IndexedMapOfShape moved_edges;
};

/// Copies faces with their new surfaces. An edge or a vertex of several faces is copied once.
class FaceCopier {
 public:
  FaceCopier(const SeamPlan& plan, const NewSeam& seam)
      : plan_(plan), seam_(seam.edge), vertices_(seam.vertices) {}

  CopiedFaces copied() {
    CopiedFaces copies;
    builder_.MakeShell(copies.shell);
    for (const FacePlan& face : plan_.faces) builder_.Add(copies.shell, copy(face));
    copies.moved_edges = moved_;
    return copies;
  }

 private:
  TopoDS_Face copy(const FacePlan& plan) {
    const TopoDS_Face old = TopoDS::Face(plan.face.Oriented(TopAbs_FORWARD));
    PlacedSurface placed = surfaceOf(old);
    if (!plan.surface.IsNull()) placed = {plan.surface, TopLoc_Location()};
    TopoDS_Face face;
    builder_.MakeFace(face, placed.surface, placed.location, BRep_Tool::Tolerance(old));
    for (TopoDS_Iterator wires(old); wires.More(); wires.Next())
      if (wires.Value().ShapeType() == TopAbs_WIRE)
        builder_.Add(face, copy(TopoDS::Wire(wires.Value()), plan, old, face));
    face.Orientation(plan.face.Orientation());
    return face;
  }

  TopoDS_Shape copy(const TopoDS_Wire& old, const FacePlan& plan, const TopoDS_Face& old_face,
                    const TopoDS_Face& face) {
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (TopoDS_Iterator edges(old.Oriented(TopAbs_FORWARD)); edges.More(); edges.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(edges.Value());
      const TopAbs_Orientation orientation = edge.Orientation();
      if (edge.IsSame(plan.use.edge)) {
        builder_.UpdateEdge(seam_, plan.path, face, Precision::Confusion());
        builder_.Range(seam_, face, plan_.first, plan_.last);
        builder_.Add(
            wire, seam_.Oriented(plan.with_old_edge ? orientation : TopAbs::Reverse(orientation)));
      } else {
        builder_.Add(wire, copy(edge, plan, old_face, face).Oriented(orientation));
      }
    }
    wire.Closed(old.Closed());
    return wire.Oriented(old.Orientation());
  }

  TopoDS_Edge copy(const TopoDS_Edge& any, const FacePlan& plan, const TopoDS_Face& old_face,
                   const TopoDS_Face& face) {
    const TopoDS_Edge old = TopoDS::Edge(any.Oriented(TopAbs_FORWARD));
    TopoDS_Edge edge = isNew(old) ? begin(old) : TopoDS::Edge(edges_.Find(old));
    if (pathOf(edge, face).curve.IsNull()) addPaths(old, old_face, face, edge);
    if (!BRep_Tool::Degenerated(old)) addCurve(old, old_face, plan, face, edge);
    return edge;
  }

  bool isNew(const TopoDS_Edge& old) const { return !edges_.IsBound(old); }

  TopoDS_Edge begin(const TopoDS_Edge& old) {
    TopoDS_Edge edge;
    builder_.MakeEdge(edge);
    double first = 0, last = 0;
    BRep_Tool::Range(old, first, last);
    builder_.UpdateEdge(edge, BRep_Tool::Tolerance(old));
    for (TopoDS_Iterator it(old); it.More(); it.Next())
      if (it.Value().Orientation() == TopAbs_FORWARD || it.Value().Orientation() == TopAbs_REVERSED)
        builder_.Add(edge, vertex(it.Value()).Oriented(it.Value().Orientation()));
    builder_.Degenerated(edge, BRep_Tool::Degenerated(old));
    builder_.Range(edge, first, last);
    edges_.Bind(old, edge);
    return edge;
  }

  TopoDS_Shape vertex(const TopoDS_Shape& old) {
    if (!vertices_.IsBound(old)) {
      TopoDS_Vertex vertex;
      const TopoDS_Vertex& as_was = TopoDS::Vertex(old);
      builder_.MakeVertex(vertex, BRep_Tool::Pnt(as_was), BRep_Tool::Tolerance(as_was));
      vertices_.Bind(old, vertex);
    }
    return vertices_.Find(old);
  }

  void addPaths(const TopoDS_Edge& old, const TopoDS_Face& old_face, const TopoDS_Face& face,
                TopoDS_Edge& edge) {
    const double tolerance = BRep_Tool::Tolerance(old);
    const PlanarPath path = pathOrBuilt(old, old_face, plan_.gap_mm);
    if (BRep_Tool::IsClosed(old, old_face))
      builder_.UpdateEdge(edge, path.curve, pathOf(TopoDS::Edge(old.Reversed()), old_face).curve,
                          face, tolerance);
    else
      builder_.UpdateEdge(edge, path.curve, face, tolerance);
    builder_.Range(edge, face, path.first, path.last);
  }

  /// The old curve in space, or the image of the path where the surface moved below it.
  void addCurve(const TopoDS_Edge& old, const TopoDS_Face& old_face, const FacePlan& plan,
                const TopoDS_Face& face, TopoDS_Edge& edge) {
    const PlanarPath path = pathOf(edge, face);
    // A surface whose rows were refined differs by rounding from what it was. The edge's tolerance
    // covers that, and its curve can stay.
    const double noise_mm = BRep_Tool::Tolerance(old) / 100;
    const bool moved = !plan.surface.IsNull() &&
                       largestDistance_mm(surfaceOf(old_face), surfaceOf(face), path) > noise_mm;
    TopLoc_Location location;
    double first = 0, last = 0;
    const handle<Geom_Curve> as_was = BRep_Tool::Curve(old, location, first, last);
    if (moved || as_was.IsNull()) {
      setImage(path, face, edge);
      moved_.Add(edge);
    } else if (BRep_Tool::Curve(edge, first, last).IsNull()) {
      builder_.UpdateEdge(edge, as_was, location, BRep_Tool::Tolerance(old));
    }
  }

  void setImage(const PlanarPath& path, const TopoDS_Face& face, TopoDS_Edge& edge) {
    const handle<Geom_Curve> image =
        // A thousandth of the gap: the image of an edge adds nothing to what a seam is judged by.
        meanImage({{surfaceOf(face), path}}, path.first, path.last, plan_.gap_mm / 1000);
    builder_.UpdateEdge(edge, image, TopLoc_Location(), Precision::Confusion());
  }

  const SeamPlan& plan_;
  BRep_Builder builder_;
  TopoDS_Edge seam_;
  TopTools_DataMapOfShapeShape vertices_, edges_;  ///< copies by the old ones
  TopTools_IndexedMapOfShape moved_;
};

/// The path on each face of an edge; two where a face meets itself.
std::vector<EdgeSide> sidesOf(const TopoDS_Edge& edge, const TopoDS_Shell& shell) {
  std::vector<EdgeSide> sides;
  for (TopoDS_Iterator faces(shell); faces.More(); faces.Next()) {
    const TopoDS_Face face = TopoDS::Face(faces.Value().Oriented(TopAbs_FORWARD));
    const PlanarPath path = pathOf(edge, face);
    if (path.curve.IsNull()) continue;
    // Faces on one surface find each other's paths.
    TopTools_IndexedMapOfShape own;
    TopExp::MapShapes(face, TopAbs_EDGE, own);
    if (!own.Contains(edge)) continue;
    sides.push_back({surfaceOf(face), path});
    if (BRep_Tool::IsClosed(edge, face))
      sides.push_back({surfaceOf(face), pathOf(TopoDS::Edge(edge.Reversed()), face)});
  }
  return sides;
}

void fitEdge(const TopoDS_Edge& edge, const TopoDS_Shell& shell) {
  const BRep_Builder builder;
  builder.SameRange(edge, true);
  builder.SameParameter(edge, true);
  if (BRep_Tool::Degenerated(edge)) return;
  double first = 0, last = 0;
  const handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
  const double largest = largestDistance_mm(sidesOf(edge, shell), *curve, first, last);
  builder.UpdateEdge(edge, std::max(Precision::Confusion(), between_points * largest));
}

std::array<TopoDS_Vertex, 2> endsOf(const TopoDS_Edge& edge) {
  return {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)};
}

/// Moves vertices to the ends of moved edges. The first edge decides; those of the seam are where
/// they should be.
void moveVertices(const TopTools_IndexedMapOfShape& moved_edges, const NewSeam& seam,
                  const std::vector<TopoDS_Edge>& edges) {
  const BRep_Builder builder;
  TopTools_IndexedMapOfShape placed;
  for (const TopoDS_Edge& edge : edges) {
    if (!moved_edges.Contains(edge)) continue;
    double first = 0, last = 0;
    const handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
    for (const int end : {0, 1}) {
      const TopoDS_Vertex vertex = endsOf(edge)[end];
      if (vertex.IsNull() || placed.Contains(vertex) || seam.endsAt(vertex)) continue;
      builder.UpdateVertex(vertex, curve->Value(end == 0 ? first : last),
                           BRep_Tool::Tolerance(edge));
      placed.Add(vertex);
    }
  }
}

/// Raises the tolerances of an edge's vertices to what the ends of its curves need.
void fitVertices(const TopoDS_Edge& edge, const TopoDS_Shell& shell) {
  // OpenCASCADE's checks compare without slack, and the distance is rounded.
  constexpr double slack = 1.001;
  const BRep_Builder builder;
  for (const int end : {0, 1}) {
    const TopoDS_Vertex vertex = endsOf(edge)[end];
    if (vertex.IsNull()) continue;
    std::vector<gp_Pnt> points;
    double first = 0, last = 0;
    const handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
    if (!curve.IsNull()) points.push_back(curve->Value(end == 0 ? first : last));
    for (const EdgeSide& side : sidesOf(edge, shell))
      points.push_back(side.at(end == 0 ? 0 : points_of_an_edge - 1));
    double reach = BRep_Tool::Tolerance(edge);
    for (const gp_Pnt& point : points)
      reach = std::max(reach, slack * point.Distance(BRep_Tool::Pnt(vertex)));
    builder.UpdateVertex(vertex, reach);
  }
}

/// Moves vertices and sets tolerances. Each step is done for all edges before the next one, since a
/// vertex needs the tolerances of all its edges.
void fitTolerances(const CopiedFaces& copies, const NewSeam& seam) {
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(copies.shell, TopAbs_EDGE, parts);
  std::vector<TopoDS_Edge> edges;
  for (int e = 1; e <= parts.Extent(); ++e)
    edges.push_back(TopoDS::Edge(parts(e).Oriented(TopAbs_FORWARD)));
  for (const TopoDS_Edge& edge : edges) fitEdge(edge, copies.shell);
  moveVertices(copies.moved_edges, seam, edges);
  for (const TopoDS_Edge& edge : edges) fitVertices(edge, copies.shell);
}

}  // namespace

RebuiltPair rebuild(const SeamPlan& plan) {
  const NewSeam seam = newSeam(plan);
  const CopiedFaces copies = FaceCopier(plan, seam).copied();
  fitTolerances(copies, seam);
  return {copies.shell, seam.edge};
}

double largestSideMove_mm(const FacePlan& plan, double gap_mm) {
  if (plan.surface.IsNull()) return 0;
  const TopoDS_Face face = TopoDS::Face(plan.face.Oriented(TopAbs_FORWARD));
  const PlacedSurface before = surfaceOf(face), after{plan.surface, TopLoc_Location()};
  TopTools_IndexedMapOfShape seam_ends;
  TopExp::MapShapes(plan.use.edge, TopAbs_VERTEX, seam_ends);
  double largest = 0;
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
    if (edge.IsSame(plan.use.edge)) continue;
    const bool ends_at_seam = seam_ends.Contains(TopExp::FirstVertex(edge)) ||
                              seam_ends.Contains(TopExp::LastVertex(edge));
    if (ends_at_seam)
      largest =
          std::max(largest, largestDistance_mm(before, after, pathOrBuilt(edge, face, gap_mm)));
  }
  return largest;
}

}  // namespace seamwright::occ
