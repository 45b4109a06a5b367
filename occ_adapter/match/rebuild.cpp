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

class Rebuilder {
 public:
  explicit Rebuilder(const SeamPlan& plan) : plan_(plan) {}

  RebuiltPair run() {
    makeSeam();
    TopoDS_Shell shell;
    builder_.MakeShell(shell);
    for (const FacePlan& face : plan_.faces) builder_.Add(shell, copy(face));
    setTolerances(shell);
    return {shell, seam_};
  }

 private:
  /// The seam's vertices stand for the old ones at its ends.
  void makeSeam() {
    builder_.MakeEdge(seam_, plan_.curve, Precision::Confusion());
    builder_.Range(seam_, plan_.first, plan_.last);
    std::array<TopoDS_Vertex, 2> ends;
    for (const int end : {0, 1})
      builder_.MakeVertex(ends[end], plan_.curve->Value(end == 0 ? plan_.first : plan_.last),
                          Precision::Confusion());
    builder_.Add(seam_, ends[0].Oriented(TopAbs_FORWARD));
    builder_.Add(seam_, ends[1].Oriented(TopAbs_REVERSED));
    for (const FacePlan& face : plan_.faces) {
      const TopoDS_Edge old = TopoDS::Edge(face.use.edge.Oriented(TopAbs_FORWARD));
      const TopoDS_Vertex first = TopExp::FirstVertex(old), last = TopExp::LastVertex(old);
      vertices_.Bind(face.with_old_edge ? first : last, ends[0]);
      vertices_.Bind(face.with_old_edge ? last : first, ends[1]);
    }
  }

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
        meanImage({{surfaceOf(face), path}}, path.first, path.last, plan_.gap_mm / 1000);
    builder_.UpdateEdge(edge, image, TopLoc_Location(), Precision::Confusion());
  }

  void setTolerances(const TopoDS_Shell& shell) {
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shell, TopAbs_EDGE, edges);
    std::vector<TopoDS_Edge> all;
    for (int e = 1; e <= edges.Extent(); ++e)
      all.push_back(TopoDS::Edge(edges(e).Oriented(TopAbs_FORWARD)));
    for (const TopoDS_Edge& edge : all) setTolerance(edge, shell);
    for (const TopoDS_Edge& edge : all) placeVertices(edge);
    for (const TopoDS_Edge& edge : all) fitVertices(edge, shell);
  }

  /// The path on a face, and the other one where the face meets itself.
  static std::vector<EdgeSide> sidesOf(const TopoDS_Edge& edge, const TopoDS_Shell& shell) {
    std::vector<EdgeSide> sides;
    for (TopoDS_Iterator faces(shell); faces.More(); faces.Next()) {
      const TopoDS_Face face = TopoDS::Face(faces.Value().Oriented(TopAbs_FORWARD));
      const PlanarPath path = pathOf(edge, face);
      if (path.curve.IsNull()) continue;
      TopTools_IndexedMapOfShape own;
      TopExp::MapShapes(face, TopAbs_EDGE, own);
      if (!own.Contains(edge)) continue;
      sides.push_back({surfaceOf(face), path});
      if (BRep_Tool::IsClosed(edge, face))
        sides.push_back({surfaceOf(face), pathOf(TopoDS::Edge(edge.Reversed()), face)});
    }
    return sides;
  }

  void setTolerance(const TopoDS_Edge& edge, const TopoDS_Shell& shell) {
    builder_.SameRange(edge, true);
    builder_.SameParameter(edge, true);
    if (BRep_Tool::Degenerated(edge)) return;
    double first = 0, last = 0;
    const handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
    const double largest = largestDistance_mm(sidesOf(edge, shell), *curve, first, last);
    builder_.UpdateEdge(edge, std::max(Precision::Confusion(), between_points * largest));
  }

  static std::array<TopoDS_Vertex, 2> endsOf(const TopoDS_Edge& edge) {
    return {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)};
  }

  /// A vertex where a moved edge ends moves there.
  void placeVertices(const TopoDS_Edge& edge) {
    if (!moved_.Contains(edge)) return;
    double first = 0, last = 0;
    const handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
    for (const int end : {0, 1}) {
      const TopoDS_Vertex vertex = endsOf(edge)[end];
      if (vertex.IsNull() || placed_.Contains(vertex) || isSeamEnd(vertex)) continue;
      builder_.UpdateVertex(vertex, curve->Value(end == 0 ? first : last),
                            BRep_Tool::Tolerance(edge));
      placed_.Add(vertex);
    }
  }

  void fitVertices(const TopoDS_Edge& edge, const TopoDS_Shell& shell) {
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
        reach = std::max(reach, 1.001 * point.Distance(BRep_Tool::Pnt(vertex)));
      builder_.UpdateVertex(vertex, reach);
    }
  }

  bool isSeamEnd(const TopoDS_Vertex& vertex) const {
    return vertex.IsSame(TopExp::FirstVertex(seam_)) || vertex.IsSame(TopExp::LastVertex(seam_));
  }

  const SeamPlan& plan_;
  BRep_Builder builder_;
  TopoDS_Edge seam_;
  TopTools_DataMapOfShapeShape vertices_, edges_;
  TopTools_IndexedMapOfShape moved_, placed_;
};

}  // namespace

RebuiltPair rebuild(const SeamPlan& plan) {
  return Rebuilder(plan).run();
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
