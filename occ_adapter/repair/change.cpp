// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <BRep_CurveRepresentation.hxx>
#include <BRep_ListIteratorOfListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <exception>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/convert/edge_image.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/repair/change.hpp>
#include <seamwright/occ_adapter/topology/own_parts.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// The part without location and orientation, which all its instances share.
TopoDS_Shape bare(const TopoDS_Shape& shape) {
  return shape.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD);
}

/// The parts of one kind, numbered in the order of TopExp::MapShapes.
class Parts {
 public:
  Parts(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    TopExp::MapShapes(shape, kind, parts_);
    for (int i = 1; i <= count(); ++i) ++instances_[parts_(i).TShape().get()];
  }
  int count() const { return parts_.Extent(); }
  const TopoDS_Shape& operator()(int number) const { return parts_(number); }
  int number(const TopoDS_Shape& part) const { return parts_.FindIndex(part); }

  void requireOnce(int number, const char* kind) const {
    const int instances = instances_.at(parts_(number).TShape().get());
    if (instances == 1) return;
    throw std::invalid_argument(std::string(kind) + " " + std::to_string(number) +
                                " stands in the shape " + std::to_string(instances) +
                                " times: parts with several instances stay");
  }

 private:
  TopTools_IndexedMapOfShape parts_;
  std::map<const TopoDS_TShape*, int> instances_;
};

gp_Trsf outOf(const TopLoc_Location& location) {
  return location.Inverted().Transformation();
}

/// An edge beside a face that changes, with its geometry after the change, in the frame of the
/// shape.
struct NewEdge {
  TopoDS_Edge bare;                       ///< new part, without location and orientation
  std::vector<EdgeSide> sides;            ///< after the change
  opencascade::handle<Geom_Curve> curve;  ///< null for a degenerated edge
  double first = 0, last = 0;
  double tolerance_mm = 0;
  bool moved = false;
};

class Changer {
 public:
  Changer(const TopoDS_Shape& shape, const std::vector<FaceChange>& changes, double gap_mm,
          const std::vector<PathChange>& paths, int jobs)
      : shape_(shape),
        faces_(shape, TopAbs_FACE),
        edges_(shape, TopAbs_EDGE),
        vertices_(shape, TopAbs_VERTEX),
        near_mm_(gap_mm / 1000),
        gap_mm_(gap_mm),
        jobs_(jobs) {
    TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edge_);
    TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_VERTEX, TopAbs_EDGE, edges_of_vertex_);
    for (const FaceChange& change : changes) add(change);
    for (const PathChange& change : paths) new_paths_[{change.edge, change.face}] = change.path;
  }

  TopoDS_Shape run() {
    std::set<int> edges, vertices;
    for (const auto& [face, surface] : surfaces_) {
      changeFace(face, surface);
      addParts(faces_(face), edges_, edges);
    }
    for (const auto& [edge_and_face, path] : new_paths_) edges.insert(edge_and_face.first);
    changeEdges(edges);
    for (const int edge : edges) addParts(edges_(edge), vertices_, vertices);
    for (const int vertex : vertices) changeVertex(vertex);
    TopoDS_Shape changed = rebuilt(bare(shape_));
    changed.Location(shape_.Location(), false);
    return changed.Oriented(shape_.Orientation());
  }

 private:
  void add(const FaceChange& change) {
    if (change.face < 1 || change.face > faces_.count())
      throw std::invalid_argument("face " + std::to_string(change.face) +
                                  ": the shape has faces 1 to " + std::to_string(faces_.count()));
    if (change.surface.IsNull())
      throw std::invalid_argument("face " + std::to_string(change.face) + " is given no surface");
    if (!surfaces_.emplace(change.face, change.surface).second)
      throw std::invalid_argument("face " + std::to_string(change.face) + " is given twice");
    faces_.requireOnce(change.face, "face");
  }

  static void addParts(const TopoDS_Shape& of, const Parts& parts, std::set<int>& numbers) {
    TopTools_IndexedMapOfShape own;
    TopExp::MapShapes(of, parts(1).ShapeType(), own);
    for (int i = 1; i <= own.Extent(); ++i) numbers.insert(parts.number(own(i)));
  }

  TopoDS_Face face(int number) const {
    return TopoDS::Face(faces_(number).Oriented(TopAbs_FORWARD));
  }
  bool changes(int face) const { return surfaces_.count(face) > 0; }

  PlacedSurface surfaceAfter(int number) const {
    const auto found = surfaces_.find(number);
    if (found != surfaces_.end()) return {found->second, TopLoc_Location()};
    return surfaceOf(face(number));
  }

  void changeFace(int number, const handle<Geom_Surface>& surface) {
    const PlacedSurface old = surfaceOf(face(number));
    const auto own = handle<Geom_Surface>::DownCast(surface->Transformed(outOf(old.location)));
    TopoDS_Face changed = TopoDS::Face(face(number).EmptyCopied());
    builder_.UpdateFace(changed, own, old.location, BRep_Tool::Tolerance(changed));
    stored_[number] = {own, old.location};
    new_parts_.Bind(bare(faces_(number)), bare(changed));
  }

  std::vector<int> facesOf(int edge) const {
    std::vector<int> numbers;
    for (const TopoDS_Shape& beside : faces_of_edge_.FindFromKey(edges_(edge)))
      numbers.push_back(faces_.number(beside));
    return numbers;
  }

  /// The pcurve of an edge on a face; two if the face meets itself there.
  std::vector<PlanarPath> pathsOf(const TopoDS_Edge& edge, int number) const {
    std::vector<PlanarPath> paths = {pathOrBuilt(edge, face(number), gap_mm_)};
    if (const auto changed = new_paths_.find({edges_.number(edge), number});
        changed != new_paths_.end())
      paths.front().curve = changed->second;
    if (BRep_Tool::IsClosed(edge, face(number)))
      paths.push_back(pathOf(TopoDS::Edge(edge.Reversed()), face(number)));
    return paths;
  }

  std::vector<EdgeSide> sidesAfter(const TopoDS_Edge& edge, const std::vector<int>& faces) const {
    std::vector<EdgeSide> sides;
    for (const int number : faces)
      for (const PlanarPath& path : pathsOf(edge, number))
        sides.push_back({surfaceAfter(number), path});
    return sides;
  }

  TopoDS_Edge edge(int number) const {
    return TopoDS::Edge(edges_(number).Oriented(TopAbs_FORWARD));
  }

  void changeEdges(const std::set<int>& all) {
    const std::vector<int> numbers(all.begin(), all.end());
    for (const int number : numbers) edges_.requireOnce(number, "edge");
    std::vector<NewEdge> edges(numbers.size());
    std::vector<std::exception_ptr> errors(numbers.size());
    // Safe on several threads: each call writes only data that no other call reads.
    const auto change = [&](std::size_t k) {
      try {
        edges[k] = changed(numbers[k]);
      } catch (...) {
        errors[k] = std::current_exception();
      }
    };
    runParallel(numbers.size(), jobs_, change, {});
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (errors[k]) std::rethrow_exception(errors[k]);
      new_parts_.Bind(bare(edges_(numbers[k])), edges[k].bare);
      new_edges_[numbers[k]] = std::move(edges[k]);
    }
  }

  NewEdge changed(int number) const {
    const TopoDS_Edge old = edge(number);
    const std::vector<int> faces = facesOf(number);
    NewEdge edge;
    edge.sides = sidesAfter(old, faces);
    edge.tolerance_mm = BRep_Tool::Tolerance(old);
    edge.moved = isMoved(old, faces);
    TopoDS_Edge placed = TopoDS::Edge(old.EmptyCopied());
    setPaths(old, faces, edge.moved, placed);
    edge.bare = TopoDS::Edge(bare(placed));
    BRep_Tool::Range(old, edge.first, edge.last);
    if (!BRep_Tool::Degenerated(old)) setCurve(old, edge);
    return edge;
  }

  bool isMoved(const TopoDS_Edge& edge, const std::vector<int>& faces) const {
    for (const int number : faces) {
      if (hasNewPath(edge, number)) return true;
      if (changes(number))
        for (const PlanarPath& path : pathsOf(edge, number))
          if (largestDistance_mm(surfaceOf(face(number)), surfaceAfter(number), path) > near_mm_)
            return true;
    }
    return false;
  }

  /// Stores pcurves that were implied by the curve in space, where that curve moves.
  void setPaths(const TopoDS_Edge& old, const std::vector<int>& faces, bool moved,
                TopoDS_Edge& placed) const {
    for (const int number : faces)
      if (changes(number))
        setPath(old, number, stored_.at(number), placed);
      else if (hasNewPath(old, number) || (moved && !hasStoredPath(old, number)))
        setPath(old, number, surfaceOf(face(number)), placed);
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (std::size_t j = i; j < faces.size(); ++j)
        if (changes(faces[i]) || changes(faces[j])) setContinuity(old, faces[i], faces[j], placed);
    for (const int number : faces)
      if (changes(number)) forgetOldSurface(number, faces, placed);
  }

  bool hasNewPath(const TopoDS_Edge& edge, int number) const {
    return new_paths_.count({edges_.number(edge), number}) > 0;
  }

  bool hasStoredPath(const TopoDS_Edge& edge, int number) const {
    double first = 0, last = 0;
    bool is_stored = false;
    const handle<Geom2d_Curve> path =
        BRep_Tool::CurveOnSurface(edge, face(number), first, last, &is_stored);
    return !path.IsNull() && is_stored;
  }

  void setPath(const TopoDS_Edge& old, int number, const PlacedSurface& on,
               TopoDS_Edge& placed) const {
    const std::vector<PlanarPath> paths = pathsOf(old, number);
    if (paths.size() == 2)
      builder_.UpdateEdge(placed, paths[0].curve, paths[1].curve, on.surface, on.location, 0);
    else
      builder_.UpdateEdge(placed, paths[0].curve, on.surface, on.location, 0);
    builder_.Range(placed, on.surface, on.location, paths[0].first, paths[0].last);
  }

  PlacedSurface storedAfter(int number) const {
    return changes(number) ? stored_.at(number) : surfaceOf(face(number));
  }

  void setContinuity(const TopoDS_Edge& old, int a, int b, TopoDS_Edge& placed) const {
    if (a == b && !BRep_Tool::IsClosed(old, face(a))) return;
    if (!BRep_Tool::HasContinuity(old, face(a), face(b))) return;
    const PlacedSurface on_a = storedAfter(a), on_b = storedAfter(b);
    builder_.Continuity(placed, on_a.surface, on_b.surface, on_a.location, on_b.location,
                        BRep_Tool::Continuity(old, face(a), face(b)));
  }

  /// Removes the pcurve on the old surface unless another face beside the edge lies on that surface
  /// and stays.
  void forgetOldSurface(int number, const std::vector<int>& faces,
                        const TopoDS_Edge& placed) const {
    const PlacedSurface old = surfaceOf(face(number));
    for (const int other : faces) {
      if (changes(other)) continue;
      const PlacedSurface beside = surfaceOf(face(other));
      if (beside.surface == old.surface && beside.location == old.location) return;
    }
    const TopLoc_Location in_edge = old.location.Predivided(placed.Location());
    BRep_ListOfCurveRepresentation& all =
        handle<BRep_TEdge>::DownCast(placed.TShape())->ChangeCurves();
    for (BRep_ListIteratorOfListOfCurveRepresentation it(all); it.More();) {
      const handle<BRep_CurveRepresentation>& one = it.Value();
      const bool is_of_it = one->IsCurveOnSurface(old.surface, in_edge) ||
                            (one->IsRegularity() &&
                             ((one->Surface() == old.surface && one->Location() == in_edge) ||
                              (one->Surface2() == old.surface && one->Location2() == in_edge)));
      if (is_of_it)
        all.Remove(it);
      else
        it.Next();
    }
  }

  void setCurve(const TopoDS_Edge& old, NewEdge& edge) const {
    double first = 0, last = 0;
    edge.curve = BRep_Tool::Curve(old, first, last);
    edge.moved = edge.moved || edge.curve.IsNull();
    const handle<BRep_TEdge> part = handle<BRep_TEdge>::DownCast(edge.bare.TShape());
    if (edge.moved) {
      edge.curve = meanImage(edge.sides, edge.first, edge.last, near_mm_);
      builder_.UpdateEdge(
          edge.bare, handle<Geom_Curve>::DownCast(edge.curve->Transformed(outOf(old.Location()))),
          TopLoc_Location(), 0);
      builder_.Range(edge.bare, edge.first, edge.last, true);
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

  /// The ends, at a vertex, of edge curves and of their images on faces, with the tolerance that
  /// the edges themselves require of the vertex.
  struct Ends {
    std::vector<gp_Pnt> curves, images;
    double tolerance_mm = 0;
    bool any_moved = false, any_stays = false;
  };

  Ends endsAt(const TopoDS_Vertex& vertex) const {
    Ends ends;
    for (const TopoDS_Shape& beside : edges_of_vertex_.FindFromKey(vertex)) {
      const int number = edges_.number(beside);
      const TopoDS_Edge old = edge(number);
      const auto changed = new_edges_.find(number);
      if (changed == new_edges_.end() && !isUsable(old))
        continue;  // no edge of known position ends here
      const NewEdge edge = changed == new_edges_.end() ? asItIs(old, number) : changed->second;
      ends.tolerance_mm = std::max(ends.tolerance_mm, edge.tolerance_mm);
      ends.any_moved = ends.any_moved || edge.moved;
      ends.any_stays = ends.any_stays || (!edge.moved && !edge.curve.IsNull());
      for (const bool at_first : {true, false}) {
        const TopoDS_Vertex end = at_first ? TopExp::FirstVertex(old) : TopExp::LastVertex(old);
        if (!vertex.IsSame(end)) continue;
        if (!edge.curve.IsNull())
          ends.curves.push_back(edge.curve->Value(at_first ? edge.first : edge.last));
        for (const EdgeSide& side : edge.sides)
          ends.images.push_back(side.at(at_first ? 0 : points_of_an_edge - 1));
      }
    }
    return ends;
  }

  NewEdge asItIs(const TopoDS_Edge& edge, int number) const {
    NewEdge same;
    same.curve = BRep_Tool::Curve(edge, same.first, same.last);
    for (const int beside : facesOf(number))
      if (const PlanarPath path = pathOf(edge, face(beside));
          !path.curve.IsNull() && isUsable(face(beside)))
        same.sides.push_back({surfaceOf(face(beside)), path});
    same.tolerance_mm = BRep_Tool::Tolerance(edge);
    return same;
  }

  void changeVertex(int number) {
    const TopoDS_Vertex old = TopoDS::Vertex(vertices_(number).Oriented(TopAbs_FORWARD));
    const Ends ends = endsAt(old);
    const std::vector<gp_Pnt>& of_place = ends.curves.empty() ? ends.images : ends.curves;
    if (of_place.empty()) return;
    gp_Pnt place = BRep_Tool::Pnt(old);
    // Readers of files trim edges at their vertices. So a vertex moves only if no edge that stays
    // ends there; otherwise the edge that stays would differ in the file.
    if (ends.any_moved && !ends.any_stays) {
      gp_XYZ sum;
      for (const gp_Pnt& end : of_place) sum += end.XYZ();
      place = gp_Pnt(sum / static_cast<double>(of_place.size()));
    }
    // Margin: rounding must not leave an end outside of the tolerance.
    constexpr double rounding = 1.001;
    double reach = std::max(Precision::Confusion(), ends.tolerance_mm);
    for (const std::vector<gp_Pnt>* points : {&ends.curves, &ends.images})
      for (const gp_Pnt& end : *points) reach = std::max(reach, rounding * end.Distance(place));
    if (!ends.any_moved && reach <= BRep_Tool::Tolerance(old)) return;
    vertices_.requireOnce(number, "vertex");
    TopoDS_Vertex vertex;
    builder_.MakeVertex(vertex, place.Transformed(outOf(old.Location())), reach);
    new_parts_.Bind(bare(old), vertex);
  }

  /// The part itself, or a copy if any of its parts is new.
  TopoDS_Shape rebuilt(const TopoDS_Shape& part) {
    if (done_.IsBound(part)) return done_.Find(part);
    std::vector<TopoDS_Shape> children;
    const bool is_new = new_parts_.IsBound(part);
    bool any_new = is_new;
    for (TopoDS_Iterator it(part, false, false); it.More(); it.Next()) {
      TopoDS_Shape child = rebuilt(bare(it.Value()));
      any_new = any_new || !child.IsPartner(it.Value());
      child.Location(it.Value().Location(), false);
      children.push_back(child.Oriented(it.Value().Orientation()));
    }
    TopoDS_Shape copy = part;
    if (any_new) {
      copy = is_new ? new_parts_.Find(part) : part.EmptyCopied();
      for (const TopoDS_Shape& child : children) builder_.Add(copy, child);
      copy.Closed(part.Closed());
      copy.Convex(part.Convex());
      copy.Infinite(part.Infinite());
      copy.Orientable(part.Orientable());
    }
    done_.Bind(part, copy);
    return copy;
  }

  const TopoDS_Shape& shape_;
  Parts faces_, edges_, vertices_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge_, edges_of_vertex_;
  double near_mm_, gap_mm_;
  int jobs_;
  BRep_Builder builder_;
  std::map<int, handle<Geom_Surface>> surfaces_;  ///< by face, in the frame of the shape
  std::map<std::pair<int, int>, handle<Geom2d_Curve>> new_paths_;  ///< by edge and face
  std::map<int, PlacedSurface> stored_;  ///< the same surfaces, as stored in the faces
  std::map<int, NewEdge> new_edges_;
  TopTools_DataMapOfShapeShape new_parts_, done_;
};

}  // namespace

TopoDS_Shape withChanges(const TopoDS_Shape& shape, const std::vector<FaceChange>& changes,
                         double gap_mm, const std::vector<PathChange>& paths, int jobs) {
  if (changes.empty() && paths.empty()) return shape;
  const TopoDS_Shape own = withOwnParts(shape);
  return Changer(own, changes, gap_mm, paths, jobs).run();
}

}  // namespace seamwright::occ
