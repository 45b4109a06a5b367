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
#include <Geom_Plane.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopLoc_Datum3D.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <limits>
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
  for (const TopAbs_ShapeEnum kind :
       {TopAbs_SOLID, TopAbs_SHELL, TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
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

std::string recordOf(const gp_Trsf& placement) {
  std::ostringstream bytes;
  BinTools_OStream out(bytes);
  record(out, placement);
  return bytes.str();
}

/// The placements of two sides told by the same steps: OpenCASCADE tells steps apart by identity,
/// and a journey makes new ones. Steps with one transformation are one, also where a file has them
/// twice.
class Steps {
 public:
  /// Notes what the steps of the shape that is changed in place come back as.
  void note(TopLoc_Location into, TopLoc_Location unchanged) {
    for (; !into.IsIdentity() && !unchanged.IsIdentity();
         into = into.NextLocation(), unchanged = unchanged.NextLocation()) {
      const auto step =
          steps_.emplace(recordOf(unchanged.FirstDatum()->Transformation()), into.FirstDatum());
      own_.emplace(into.FirstDatum().get(), step.first->second);
    }
  }

  /// Of the shape that is changed in place.
  TopLoc_Location own(const TopLoc_Location& location) const {
    return inSteps(location, [this](const Step& step) {
      const auto found = own_.find(step.get());
      return found == own_.end() ? step : found->second;
    });
  }

  /// Of what came back.
  TopLoc_Location translated(const TopLoc_Location& location) const {
    return inSteps(location, [this](const Step& step) {
      const auto found = steps_.find(recordOf(step->Transformation()));
      return found == steps_.end() ? step : found->second;
    });
  }

 private:
  using Step = opencascade::handle<TopLoc_Datum3D>;

  template <class Chosen>
  static TopLoc_Location inSteps(TopLoc_Location location, const Chosen& chosen) {
    TopLoc_Location result;
    for (; !location.IsIdentity(); location = location.NextLocation())
      result =
          result * TopLoc_Location(chosen(location.FirstDatum())).Powered(location.FirstPower());
    return result;
  }

  std::map<std::string, Step> steps_;  ///< by what comes back
  std::map<const TopLoc_Datum3D*, Step> own_;
};

void record(BinTools_OStream& out, TopLoc_Location location) {
  for (; !location.IsIdentity(); location = location.NextLocation()) {
    out << location.FirstPower();
    record(out, location.FirstDatum()->Transformation());
  }
  out << 0;  // no power of a step
}

/// A part and where it stands in the coordinates of the part that is changed in place.
struct Placed {
  TopoDS_Shape shape;
  TopLoc_Location frame;
};

/// The surfaces of one side, numbered by the first face that has them: edges name surfaces so.
class SurfaceNumbers {
 public:
  void add(const Surface& surface, int face) { numbers_.emplace(surface.get(), face); }

  void record(BinTools_OStream& out, const Surface& surface) const {
    const auto found = numbers_.find(surface.get());
    out << (found == numbers_.end() ? -1 : found->second);
    if (found == numbers_.end() && !surface.IsNull())
      BinTools_SurfaceSet::WriteSurface(surface, out);
  }

 private:
  std::map<const Geom_Surface*, int> numbers_;
};

/// Polygons belong to a picture of the shape, not to it; that two faces meet at least without a gap
/// is said of any edge.
bool isGeometry(const BRep_CurveRepresentation& representation) {
  return representation.IsCurve3D() || representation.IsCurveOnSurface() ||
         (representation.IsRegularity() && representation.Continuity() > GeomAbs_C0);
}

/// A parameter curve on a plane is the curve itself, and may be missing.
bool isImplied(const BRep_CurveRepresentation& representation) {
  return representation.IsCurveOnSurface() && !representation.Surface().IsNull() &&
         representation.Surface()->IsKind(STANDARD_TYPE(Geom_Plane));
}

/// Bytes that are the same for faces and edges with the same geometry in the same place.
class Recorder {
 public:
  Recorder(const Steps& steps, const SurfaceNumbers& numbers) : steps_(steps), numbers_(numbers) {}

  std::string operator()(const Placed& part) const {
    std::ostringstream bytes;
    BinTools_OStream out(bytes);
    switch (part.shape.ShapeType()) {
      case TopAbs_FACE:
        face(out, *contentOf<BRep_TFace>(part.shape), part.frame);
        break;
      default:
        edge(out, *contentOf<BRep_TEdge>(part.shape), part.frame);
    }
    return std::move(bytes).str();
  }

 private:
  void place(BinTools_OStream& out, const TopLoc_Location& frame,
             const TopLoc_Location& location) const {
    record(out, frame * steps_.translated(location));
  }

  void face(BinTools_OStream& out, const BRep_TFace& face, const TopLoc_Location& frame) const {
    if (!face.Surface().IsNull()) BinTools_SurfaceSet::WriteSurface(face.Surface(), out);
    place(out, frame, face.Location());
  }

  /// The order of its representations says nothing.
  void edge(BinTools_OStream& out, const BRep_TEdge& edge, const TopLoc_Location& frame) const {
    out << edge.Tolerance() << edge.SameParameter() << edge.SameRange() << edge.Degenerated();
    std::multiset<std::string> all;
    for (const Representation& representation : edge.Curves())
      if (isGeometry(*representation) && !isImplied(*representation))
        all.insert(recordOf(*representation, frame));
    for (const std::string& one : all)
      for (const char byte : one) out << static_cast<Standard_Byte>(byte);
  }

  std::string recordOf(const BRep_CurveRepresentation& representation,
                       const TopLoc_Location& frame) const {
    std::ostringstream bytes;
    BinTools_OStream out(bytes);
    out << static_cast<int>(representation.IsCurve3D() + 2 * representation.IsCurveOnSurface() +
                            4 * representation.IsCurveOnClosedSurface() +
                            8 * representation.IsRegularity());
    place(out, frame, representation.Location());
    if (const auto* curve = dynamic_cast<const BRep_GCurve*>(&representation))
      out << curve->First() << curve->Last();
    if (representation.IsCurve3D() && !representation.Curve3D().IsNull())
      BinTools_CurveSet::WriteCurve(representation.Curve3D(), out);
    if (representation.IsCurveOnSurface()) {
      numbers_.record(out, representation.Surface());
      BinTools_Curve2dSet::WriteCurve2d(representation.PCurve(), out);
    }
    if (representation.IsCurveOnClosedSurface())
      BinTools_Curve2dSet::WriteCurve2d(representation.PCurve2(), out);
    if (representation.IsRegularity()) {
      numbers_.record(out, representation.Surface());
      numbers_.record(out, representation.Surface2());
      place(out, frame, representation.Location2());
      out << static_cast<int>(representation.Continuity());
    }
    return std::move(bytes).str();
  }

  const Steps& steps_;
  const SurfaceNumbers& numbers_;
};

gp_Pnt pointOf(const Placed& vertex) {
  const gp_Pnt point = contentOf<BRep_TVertex>(vertex.shape)->Pnt();
  return vertex.frame.IsIdentity() ? point : point.Transformed(vertex.frame.Transformation());
}

/// Whether the points are the same. Where one was placed by its coordinates instead of by a
/// placement, as OpenCASCADE's modifications do, those were rounded on the way there and back.
bool samePoint(const Placed& a, const Placed& b) {
  const gp_Pnt p = pointOf(a), q = pointOf(b);
  if (a.frame.IsIdentity() && b.frame.IsIdentity()) return p.Distance(q) == 0;
  double reach = p.XYZ().Modulus();
  for (const Placed& vertex : {a, b})
    reach += 2 * vertex.frame.Transformation().TranslationPart().Modulus();
  return p.Distance(q) <= 16 * std::numeric_limits<double>::epsilon() * reach;
}

bool sameVertex(const Placed& a, const Placed& b) {
  return samePoint(a, b) && contentOf<BRep_TVertex>(a.shape)->Tolerance() ==
                                contentOf<BRep_TVertex>(b.shape)->Tolerance();
}

/// One face, edge or vertex in its three states.
struct Part {
  TopoDS_Shape into;  ///< to be changed in place
  Placed unchanged;   ///< what it would have come back as
  Placed changed;     ///< what it came back as
  std::vector<Placed>
      elsewhere;  ///< what it came back as in further places, where those are not shared
};

class Carrier {
 public:
  Carrier(const TopoDS_Shape& changed, const TopoDS_Shape& into) : root_(changed) {
    const TopoDS_Shape unchanged = throughBinary(throughBinary(into));
    noteSteps(into, unchanged);
    same_graph_ = sameExtents(changed, into) && pair(into, unchanged, changed);
  }

  bool sameGraph() const { return same_graph_; }

  Carried carry() {
    for (int i = 0; i < static_cast<int>(faces_.size()); ++i) number(faces_[i], i);
    requireLikeInstances();
    chooseSurfaces();
    Carried count;
    for (const Part& face : faces_) count.faces += carryFace(face);
    count.largest_tolerance_mm = std::max(largestNewTolerance<BRep_TEdge>(edges_),
                                          largestNewTolerance<BRep_TVertex>(vertices_));
    for (const Part& edge : edges_) count.edges += carryEdge(edge);
    for (const Part& vertex : vertices_) count.vertices += carryVertex(vertex);
    return count;
  }

 private:
  void noteSteps(const TopoDS_Shape& into, const TopoDS_Shape& unchanged) {
    steps_.note(into.Location(), unchanged.Location());
    if (!noted_.insert(into.TShape().get()).second) return;
    if (into.ShapeType() == TopAbs_FACE)
      steps_.note(contentOf<BRep_TFace>(into)->Location(),
                  contentOf<BRep_TFace>(unchanged)->Location());
    TopoDS_Iterator a(into, false, false), b(unchanged, false, false);
    for (; a.More() && b.More(); a.Next(), b.Next()) noteSteps(a.Value(), b.Value());
  }

  /// Walks the three graphs side by side, placements added up. \returns whether they are the same.
  bool pair(const TopoDS_Shape& into, const TopoDS_Shape& unchanged, const TopoDS_Shape& changed) {
    if (into.ShapeType() != changed.ShapeType() || into.Orientation() != changed.Orientation())
      return false;
    const Placed placed{
        changed, steps_.own(into.Location()).Inverted() * steps_.translated(changed.Location())};
    // Two parts that became one are another graph: the shape was sewn.
    const auto origin =
        origins_.emplace(changed.TShape().get(), Origin{into.TShape().get(), placed.frame});
    if (origin.first->second.shape != into.TShape().get()) return false;
    if (!origin.second && origin.first->second.frame == placed.frame) return true;
    takeDown(into, unchanged, placed);
    TopoDS_Iterator a(into, false), b(unchanged, false), c(changed, false);
    for (; a.More() && c.More(); a.Next(), b.Next(), c.Next())
      if (!pair(a.Value(), b.Value(), c.Value())) return false;
    return a.More() == c.More();
  }

  void takeDown(const TopoDS_Shape& into, const TopoDS_Shape& unchanged, const Placed& changed) {
    std::vector<Part>* const parts = into.ShapeType() == TopAbs_FACE     ? &faces_
                                     : into.ShapeType() == TopAbs_EDGE   ? &edges_
                                     : into.ShapeType() == TopAbs_VERTEX ? &vertices_
                                                                         : nullptr;
    if (parts == nullptr) return;
    const auto place = places_.emplace(into.TShape().get(), parts->size());
    if (place.second)
      parts->push_back({into, {unchanged, {}}, changed, {}});
    else
      (*parts)[place.first->second].elsewhere.push_back(changed);
  }

  void number(const Part& face, int i) {
    unchanged_numbers_.add(contentOf<BRep_TFace>(face.unchanged.shape)->Surface(), i);
    changed_numbers_.add(contentOf<BRep_TFace>(face.changed.shape)->Surface(), i);
    for (const Placed& other : face.elsewhere)
      changed_numbers_.add(contentOf<BRep_TFace>(other.shape)->Surface(), i);
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
        "has one part in several places, changed unlike in each, which its structure can't hold: " +
            unlike + "; change all places alike or write it afresh");
  }

  /// "3 and 9, 4 and 10": numbers of parts that were one and are unlike now.
  std::string unlikeNumbers(const std::vector<Part>& parts, TopAbs_ShapeEnum kind) const {
    TopTools_IndexedMapOfShape map;
    std::map<const void*, int> first;
    std::string text;
    for (const Part& part : parts) {
      if (part.elsewhere.empty()) continue;
      for (const Placed& other : part.elsewhere) {
        if (kind == TopAbs_VERTEX ? sameVertex(part.changed, other)
                                  : changed_record_(part.changed) == changed_record_(other))
          continue;
        if (first.empty()) {
          TopExp::MapShapes(root_, kind, map);
          for (int i = 1; i <= map.Extent(); ++i) first.emplace(map(i).TShape().get(), i);
        }
        text += (text.empty() ? "" : ", ") +
                std::to_string(first.at(part.changed.shape.TShape().get())) + " and " +
                std::to_string(first.at(other.shape.TShape().get()));
      }
    }
    return text;
  }

  /// Decides for each surface that came back whether it is new or the one that was there.
  void chooseSurfaces() {
    std::map<const Geom_Surface*, const Geom_Surface*> taken;
    for (const Part& face : faces_) {
      const Surface changed = contentOf<BRep_TFace>(face.changed.shape)->Surface();
      const Surface into = contentOf<BRep_TFace>(face.into)->Surface();
      // A surface that several faces had in common and have no longer is new to each but the first.
      if (unchanged_record_(face.unchanged) == changed_record_(face.changed) &&
          taken.emplace(into.get(), changed.get()).first->second == changed.get())
        kept_.emplace(changed.get(), into);
      else
        new_.insert(changed.get());
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

  template <class Content>
  static double largestNewTolerance(const std::vector<Part>& parts) {
    double largest = 0;
    for (const Part& part : parts) {
      const double now = contentOf<Content>(part.changed.shape)->Tolerance();
      if (now > contentOf<Content>(part.into)->Tolerance()) largest = std::max(largest, now);
    }
    return largest;
  }

  bool carryFace(const Part& part) const {
    const opencascade::handle<BRep_TFace> into = contentOf<BRep_TFace>(part.into),
                                          changed = contentOf<BRep_TFace>(part.changed.shape);
    into->Tolerance(changed->Tolerance());
    into->NaturalRestriction(changed->NaturalRestriction());
    if (!isNew(changed->Surface())) return false;
    into->Surface(changed->Surface());
    into->Location(part.changed.frame * steps_.translated(changed->Location()));
    into->Triangulation(opencascade::handle<Poly_Triangulation>());
    return true;
  }

  bool carryEdge(const Part& part) const {
    const opencascade::handle<BRep_TEdge> into = contentOf<BRep_TEdge>(part.into),
                                          changed = contentOf<BRep_TEdge>(part.changed.shape);
    const bool differs = unchanged_record_(part.unchanged) != changed_record_(part.changed);
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
      if (isGeometry(*representation))
        into->ChangeCurves().Append(repointed(representation, part.changed.frame));
    return differs;
  }

  bool carryVertex(const Part& part) const {
    const opencascade::handle<BRep_TVertex> into = contentOf<BRep_TVertex>(part.into),
                                            changed = contentOf<BRep_TVertex>(part.changed.shape);
    if (sameVertex(part.unchanged, part.changed)) return false;
    if (!samePoint(part.unchanged, part.changed)) into->Pnt(pointOf(part.changed));
    into->Tolerance(changed->Tolerance());
    return true;
  }

  /// A copy that names the surfaces and placements of the shape that is changed in place.
  Representation repointed(const Representation& old, const TopLoc_Location& frame) const {
    const TopLoc_Location location = frame * steps_.translated(old->Location());
    opencascade::handle<BRep_GCurve> curve;
    if (old->IsCurve3D())
      curve = new BRep_Curve3D(old->Curve3D(), location);
    else if (old->IsCurveOnClosedSurface())
      curve = new BRep_CurveOnClosedSurface(old->PCurve(), old->PCurve2(), chosen(old->Surface()),
                                            location, old->Continuity());
    else if (old->IsCurveOnSurface())
      curve = new BRep_CurveOnSurface(old->PCurve(), chosen(old->Surface()), location);
    else
      return new BRep_CurveOn2Surfaces(chosen(old->Surface()), chosen(old->Surface2()), location,
                                       frame * steps_.translated(old->Location2()),
                                       old->Continuity());
    const auto range = opencascade::handle<BRep_GCurve>::DownCast(old);
    curve->SetRange(range->First(), range->Last());
    return curve;
  }

  /// What a part that came back was, and where it stood when it was met first.
  struct Origin {
    const void* shape;
    TopLoc_Location frame;
  };

  TopoDS_Shape root_;
  bool same_graph_ = false;
  Steps steps_;
  std::set<const void*> noted_;
  std::map<const void*, Origin> origins_;
  std::vector<Part> faces_, edges_, vertices_;
  std::map<const void*, std::size_t> places_;  ///< where each part that was stands in its list
  SurfaceNumbers unchanged_numbers_, changed_numbers_;
  Recorder unchanged_record_{steps_, unchanged_numbers_}, changed_record_{steps_, changed_numbers_};
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
