// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Curve3D.hxx>
#include <BRep_CurveOn2Surfaces.hxx>
#include <BRep_CurveOnClosedSurface.hxx>
#include <BRep_CurveOnSurface.hxx>
#include <BRep_ListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_TFace.hxx>
#include <BRep_TVertex.hxx>
#include <BinTools.hxx>
#include <BinTools_Curve2dSet.hxx>
#include <BinTools_CurveSet.hxx>
#include <BinTools_OStream.hxx>
#include <BinTools_SurfaceSet.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopLoc_Datum3D.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Iterator.hxx>
#include <map>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include <seamwright/occ_adapter/model/carry.hpp>
#include <seamwright/occ_adapter/model/model.hpp>

namespace seamwright::occ {

namespace {

using Surface = opencascade::handle<Geom_Surface>;
using Representation = opencascade::handle<BRep_CurveRepresentation>;

template <class T>
opencascade::handle<T> contentOf(const TopoDS_Shape& shape) {
  return opencascade::handle<T>::DownCast(shape.TShape());
}

TopoDS_Shape throughBinary(const TopoDS_Shape& shape) {
  std::stringstream stream;
  BinTools::Write(shape, stream);
  TopoDS_Shape copy;
  BinTools::Read(copy, stream);
  return copy;
}

bool sameExtents(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  for (const TopAbs_ShapeEnum kind : {TopAbs_SOLID, TopAbs_SHELL, TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
    TopTools_IndexedMapOfShape in_a, in_b;
    TopExp::MapShapes(a, kind, in_a);
    TopExp::MapShapes(b, kind, in_b);
    if (in_a.Extent() != in_b.Extent()) return false;
  }
  return true;
}

void record(BinTools_OStream& out, const gp_Trsf& placement) {
  out << placement.ScaleFactor();
  for (int i = 1; i <= 3; ++i)
    for (int k = 1; k <= 4; ++k) out << placement.Value(i, k);
}

void record(BinTools_OStream& out, TopLoc_Location location) {
  for (; !location.IsIdentity(); location = location.NextLocation()) {
    out << location.FirstPower();
    record(out, location.FirstDatum()->Transformation());
  }
  out << 0;  // no power of a datum
}

/// Bytes that are the same for the same placement made of the same number of steps.
std::string recordOf(const TopLoc_Location& location) {
  std::ostringstream bytes;
  BinTools_OStream out(bytes);
  record(out, location);
  return bytes.str();
}

/// The surfaces of one side, numbered by the first face that has them: edges name surfaces so.
class SurfaceNumbers {
 public:
  void add(const Surface& surface, int face) { numbers_.emplace(surface.get(), face); }

  void record(BinTools_OStream& out, const Surface& surface) const {
    const auto found = numbers_.find(surface.get());
    out << (found == numbers_.end() ? -1 : found->second);
    if (found == numbers_.end() && !surface.IsNull()) BinTools_SurfaceSet::WriteSurface(surface, out);
  }

 private:
  std::map<const Geom_Surface*, int> numbers_;
};

/// Bytes that are the same for the same surface in the same place.
std::string recordOf(const BRep_TFace& face) {
  std::ostringstream bytes;
  BinTools_OStream out(bytes);
  if (!face.Surface().IsNull()) BinTools_SurfaceSet::WriteSurface(face.Surface(), out);
  record(out, face.Location());
  return bytes.str();
}

std::string recordOf(const BRep_TVertex& vertex) {
  std::ostringstream bytes;
  BinTools_OStream out(bytes);
  out << vertex.Pnt() << vertex.Tolerance();
  return bytes.str();
}

/// Polygons belong to a picture of the shape, not to it.
bool isGeometry(const BRep_CurveRepresentation& representation) {
  return representation.IsCurve3D() || representation.IsCurveOnSurface() || representation.IsRegularity();
}

void record(BinTools_OStream& out, const BRep_CurveRepresentation& representation,
            const SurfaceNumbers& numbers) {
  out << static_cast<int>(representation.IsCurve3D() + 2 * representation.IsCurveOnSurface() +
                          4 * representation.IsCurveOnClosedSurface() + 8 * representation.IsRegularity());
  record(out, representation.Location());
  if (const auto* curve = dynamic_cast<const BRep_GCurve*>(&representation))
    out << curve->First() << curve->Last();
  if (representation.IsCurve3D() && !representation.Curve3D().IsNull())
    BinTools_CurveSet::WriteCurve(representation.Curve3D(), out);
  if (representation.IsCurveOnSurface()) {
    numbers.record(out, representation.Surface());
    BinTools_Curve2dSet::WriteCurve2d(representation.PCurve(), out);
  }
  if (representation.IsCurveOnClosedSurface())
    BinTools_Curve2dSet::WriteCurve2d(representation.PCurve2(), out);
  if (representation.IsRegularity()) {
    numbers.record(out, representation.Surface());
    numbers.record(out, representation.Surface2());
    record(out, representation.Location2());
    out << static_cast<int>(representation.Continuity());
  }
}

std::string recordOf(const BRep_TEdge& edge, const SurfaceNumbers& numbers) {
  std::ostringstream bytes;
  BinTools_OStream out(bytes);
  out << edge.Tolerance() << edge.SameParameter() << edge.SameRange() << edge.Degenerated();
  for (const Representation& representation : edge.Curves())
    if (isGeometry(*representation)) record(out, *representation, numbers);
  return bytes.str();
}

/// One face, edge or vertex in its three states.
struct Part {
  TopoDS_Shape into;       ///< to be changed in place
  TopoDS_Shape unchanged;  ///< what it would have come back as
  TopoDS_Shape changed;    ///< what it came back as
  std::vector<TopoDS_Shape>
      elsewhere;  ///< what it came back as in further places, where those are not shared
};

class Carrier {
 public:
  Carrier(const TopoDS_Shape& changed, const TopoDS_Shape& into) : root_(changed) {
    same_graph_ = sameExtents(changed, into) && pair(into, throughBinary(throughBinary(into)), changed);
  }

  bool sameGraph() const { return same_graph_; }

  Carried carry() {
    for (int i = 0; i < static_cast<int>(faces_.size()); ++i) number(faces_[i], i);
    requireLikeInstances();
    chooseSurfaces();
    Carried count;
    for (const Part& face : faces_) count.faces += carryFace(face);
    for (const Part& edge : edges_) count.edges += carryEdge(edge);
    for (const Part& vertex : vertices_) count.vertices += carryVertex(vertex);
    return count;
  }

 private:
  /// Walks the three graphs side by side. \returns whether they are the same.
  bool pair(const TopoDS_Shape& into, const TopoDS_Shape& unchanged, const TopoDS_Shape& changed) {
    if (into.ShapeType() != changed.ShapeType() || into.Orientation() != changed.Orientation() ||
        recordOf(unchanged.Location()) != recordOf(changed.Location()))
      return false;
    noteDatums(into.Location(), changed.Location());
    // Two parts that became one are another graph: the shape was sewn.
    const auto origin = origins_.emplace(changed.TShape().get(), into.TShape().get());
    if (origin.first->second != into.TShape().get()) return false;
    if (!origin.second) return true;
    takeDown(into, unchanged, changed);
    TopoDS_Iterator a(into, false, false), b(unchanged, false, false), c(changed, false, false);
    for (; a.More() && c.More(); a.Next(), b.Next(), c.Next())
      if (!pair(a.Value(), b.Value(), c.Value())) return false;
    return a.More() == c.More();
  }

  void takeDown(const TopoDS_Shape& into, const TopoDS_Shape& unchanged, const TopoDS_Shape& changed) {
    std::vector<Part>* const parts = into.ShapeType() == TopAbs_FACE     ? &faces_
                                     : into.ShapeType() == TopAbs_EDGE   ? &edges_
                                     : into.ShapeType() == TopAbs_VERTEX ? &vertices_
                                                                         : nullptr;
    if (parts == nullptr) return;
    const auto place = places_.emplace(into.TShape().get(), parts->size());
    if (place.second)
      parts->push_back({into, unchanged, changed, {}});
    else
      (*parts)[place.first->second].elsewhere.push_back(changed);
  }

  void noteDatums(TopLoc_Location into, TopLoc_Location changed) {
    for (; !into.IsIdentity() && !changed.IsIdentity();
         into = into.NextLocation(), changed = changed.NextLocation())
      datums_.emplace(changed.FirstDatum().get(), into.FirstDatum());
  }

  /// The same placement told by the steps of the shape that is changed in place: OpenCASCADE tells steps by identity.
  TopLoc_Location translated(TopLoc_Location location) const {
    TopLoc_Location result;
    for (; !location.IsIdentity(); location = location.NextLocation()) {
      const auto found = datums_.find(location.FirstDatum().get());
      const TopLoc_Location step(found == datums_.end() ? location.FirstDatum() : found->second);
      result = result * step.Powered(location.FirstPower());
    }
    return result;
  }

  void number(const Part& face, int i) {
    unchanged_numbers_.add(contentOf<BRep_TFace>(face.unchanged)->Surface(), i);
    changed_numbers_.add(contentOf<BRep_TFace>(face.changed)->Surface(), i);
    for (const TopoDS_Shape& other : face.elsewhere)
      changed_numbers_.add(contentOf<BRep_TFace>(other)->Surface(), i);
  }

  std::string changedRecord(const TopoDS_Shape& shape) const {
    if (shape.ShapeType() == TopAbs_FACE) return recordOf(*contentOf<BRep_TFace>(shape));
    if (shape.ShapeType() == TopAbs_EDGE) return recordOf(*contentOf<BRep_TEdge>(shape), changed_numbers_);
    return recordOf(*contentOf<BRep_TVertex>(shape));
  }

  void requireLikeInstances() const {
    std::string unlike;
    for (const auto& [parts, kind, name] :
         {std::tuple(&faces_, TopAbs_FACE, "faces "), std::tuple(&edges_, TopAbs_EDGE, "edges "),
          std::tuple(&vertices_, TopAbs_VERTEX, "vertices ")}) {
      const std::string numbers = unlikeNumbers(*parts, kind);
      if (!numbers.empty()) unlike += (unlike.empty() ? "" : "; ") + (name + numbers);
    }
    if (unlike.empty()) return;
    throw ModelError(
        ModelErrc::UnlikeInstances, {},
        "has one part in several places, changed unlike in each, which its structure can't hold: " + unlike +
            "; change all places alike or write it afresh");
  }

  /// "3 and 9, 4 and 10": numbers of parts that were one and are unlike now.
  std::string unlikeNumbers(const std::vector<Part>& parts, TopAbs_ShapeEnum kind) const {
    TopTools_IndexedMapOfShape map;
    std::map<const void*, int> first;
    std::string text;
    for (const Part& part : parts) {
      if (part.elsewhere.empty()) continue;
      const std::string bytes = changedRecord(part.changed);
      for (const TopoDS_Shape& other : part.elsewhere) {
        if (changedRecord(other) == bytes) continue;
        if (first.empty()) {
          TopExp::MapShapes(root_, kind, map);
          for (int i = 1; i <= map.Extent(); ++i) first.emplace(map(i).TShape().get(), i);
        }
        text += (text.empty() ? "" : ", ") + std::to_string(first.at(part.changed.TShape().get())) + " and " +
                std::to_string(first.at(other.TShape().get()));
      }
    }
    return text;
  }

  /// Decides for each surface that came back whether it is new or the one that was there.
  void chooseSurfaces() {
    std::map<const Geom_Surface*, const Geom_Surface*> taken;
    for (const Part& face : faces_) {
      const opencascade::handle<BRep_TFace> into = contentOf<BRep_TFace>(face.into),
                                            changed = contentOf<BRep_TFace>(face.changed);
      if (recordOf(*contentOf<BRep_TFace>(face.unchanged)) == recordOf(*changed)) {
        noteDatums(into->Location(), changed->Location());
        // A surface that several faces had in common and have no longer is new to each but the first.
        if (taken.emplace(into->Surface().get(), changed->Surface().get()).first->second ==
            changed->Surface().get()) {
          kept_.emplace(changed->Surface().get(), into->Surface());
          continue;
        }
      }
      new_.insert(changed->Surface().get());
    }
  }

  bool isNew(const Surface& surface) const { return new_.count(surface.get()) > 0; }

  Surface chosen(const Surface& surface) const {
    const auto kept = kept_.find(surface.get());
    return isNew(surface) || kept == kept_.end() ? surface : kept->second;
  }

  bool namesNewSurface(const BRep_CurveRepresentation& representation) const {
    return (representation.IsCurveOnSurface() && isNew(representation.Surface())) ||
           (representation.IsRegularity() &&
            (isNew(representation.Surface()) || isNew(representation.Surface2())));
  }

  bool carryFace(const Part& part) const {
    const opencascade::handle<BRep_TFace> into = contentOf<BRep_TFace>(part.into),
                                          changed = contentOf<BRep_TFace>(part.changed);
    into->Tolerance(changed->Tolerance());
    into->NaturalRestriction(changed->NaturalRestriction());
    if (!isNew(changed->Surface())) return false;
    into->Surface(changed->Surface());
    into->Location(translated(changed->Location()));
    into->Triangulation(opencascade::handle<Poly_Triangulation>());
    return true;
  }

  bool carryEdge(const Part& part) const {
    const opencascade::handle<BRep_TEdge> into = contentOf<BRep_TEdge>(part.into),
                                          changed = contentOf<BRep_TEdge>(part.changed);
    const bool differs = recordOf(*contentOf<BRep_TEdge>(part.unchanged), unchanged_numbers_) !=
                         recordOf(*changed, changed_numbers_);
    bool moved = differs;
    for (const Representation& representation : changed->Curves())
      moved = moved || namesNewSurface(*representation);
    if (!moved) return false;
    into->Tolerance(changed->Tolerance());
    into->SameParameter(changed->SameParameter());
    into->SameRange(changed->SameRange());
    into->Degenerated(changed->Degenerated());
    into->ChangeCurves().Clear();
    for (const Representation& representation : changed->Curves())
      if (isGeometry(*representation)) into->ChangeCurves().Append(repointed(representation));
    return differs;
  }

  bool carryVertex(const Part& part) const {
    const opencascade::handle<BRep_TVertex> into = contentOf<BRep_TVertex>(part.into),
                                            changed = contentOf<BRep_TVertex>(part.changed);
    if (recordOf(*contentOf<BRep_TVertex>(part.unchanged)) == recordOf(*changed)) return false;
    into->Pnt(changed->Pnt());
    into->Tolerance(changed->Tolerance());
    return true;
  }

  /// A copy that names the surfaces and placements of the shape that is changed in place.
  Representation repointed(const Representation& old) const {
    const TopLoc_Location location = translated(old->Location());
    opencascade::handle<BRep_GCurve> curve;
    if (old->IsCurve3D())
      curve = new BRep_Curve3D(old->Curve3D(), location);
    else if (old->IsCurveOnClosedSurface())
      curve = new BRep_CurveOnClosedSurface(old->PCurve(), old->PCurve2(), chosen(old->Surface()), location,
                                            old->Continuity());
    else if (old->IsCurveOnSurface())
      curve = new BRep_CurveOnSurface(old->PCurve(), chosen(old->Surface()), location);
    else
      return new BRep_CurveOn2Surfaces(chosen(old->Surface()), chosen(old->Surface2()), location,
                                       translated(old->Location2()), old->Continuity());
    const auto range = opencascade::handle<BRep_GCurve>::DownCast(old);
    curve->SetRange(range->First(), range->Last());
    return curve;
  }

  TopoDS_Shape root_;
  bool same_graph_ = false;
  std::vector<Part> faces_, edges_, vertices_;
  std::map<const void*, const void*> origins_;  ///< what each part that came back was
  std::map<const void*, std::size_t> places_;   ///< where each part that was stands in its list
  std::map<const void*, opencascade::handle<TopLoc_Datum3D>> datums_;
  SurfaceNumbers unchanged_numbers_, changed_numbers_;
  std::set<const Geom_Surface*> new_;
  std::map<const Geom_Surface*, Surface> kept_;  ///< surfaces that came back as they went
};

}  // namespace

std::optional<Carried> carryGeometry(const TopoDS_Shape& changed, const TopoDS_Shape& into) {
  Carrier carrier(changed, into);
  if (!carrier.sameGraph()) return std::nullopt;
  return carrier.carry();
}

}  // namespace seamwright::occ
