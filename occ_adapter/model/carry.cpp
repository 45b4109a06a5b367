// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

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
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
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

/// Expresses the placements of the shape that was read back by the elementary placements (steps) of
/// the shape that is changed in place. OpenCASCADE compares steps by identity, and reading makes
/// new ones, so they are compared by transformation. Steps with equal transformations count as one,
/// even if the file has them twice.
class Steps {
 public:
  /// Notes what the steps of the shape that is changed in place become when they are read back.
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

/// Bytes that are the same for faces and edges with the same geometry at the same location.
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
  void addLocation(BinTools_OStream& out, const TopLoc_Location& frame,
                   const TopLoc_Location& location) const {
    record(out, frame * steps_.translated(location));
  }

  void face(BinTools_OStream& out, const BRep_TFace& face, const TopLoc_Location& frame) const {
    if (!face.Surface().IsNull()) BinTools_SurfaceSet::WriteSurface(face.Surface(), out);
    addLocation(out, frame, face.Location());
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
    addLocation(out, frame, representation.Location());
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
      addLocation(out, frame, representation.Location2());
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
  // Each placement is some multiplications and additions for a coordinate, there and back.
  return p.Distance(q) <= 16 * std::numeric_limits<double>::epsilon() * reach;
}

bool sameVertex(const Placed& a, const Placed& b) {
  return samePoint(a, b) && contentOf<BRep_TVertex>(a.shape)->Tolerance() ==
                                contentOf<BRep_TVertex>(b.shape)->Tolerance();
}

/// One face, edge or vertex in its three states.
struct Part {
  TopoDS_Shape into;  ///< to be changed in place
  Placed unchanged;   ///< as it is read back if nothing is changed
  Placed changed;     ///< as it was read back
  std::vector<Placed>
      elsewhere;  ///< as it was read back at further locations, where those are not shared
};

/// The faces, edges and vertices of three graphs that are the same, side by side.
struct PairedParts {
  Steps steps;
  std::vector<Part> faces, edges, vertices;
};

/// Walks three shapes side by side: the one that is changed in place, the one that is read back if
/// nothing is changed, and the one that was read back.
class GraphWalk {
 public:
  /// \returns nothing if the graphs differ.
  std::optional<PairedParts> paired(const TopoDS_Shape& into, const TopoDS_Shape& unchanged,
                                    const TopoDS_Shape& changed) {
    noteSteps(into, unchanged);
    if (!sameExtents(changed, into) || !pair(into, unchanged, changed)) return std::nullopt;
    return std::move(parts_);
  }

 private:
  void noteSteps(const TopoDS_Shape& into, const TopoDS_Shape& unchanged) {
    parts_.steps.note(into.Location(), unchanged.Location());
    if (!noted_.insert(into.TShape().get()).second) return;
    if (into.ShapeType() == TopAbs_FACE)
      parts_.steps.note(contentOf<BRep_TFace>(into)->Location(),
                        contentOf<BRep_TFace>(unchanged)->Location());
    TopoDS_Iterator a(into, false, false), b(unchanged, false, false);
    for (; a.More() && b.More(); a.Next(), b.Next()) noteSteps(a.Value(), b.Value());
  }

  /// Walks the three graphs side by side, placements added up. \returns whether they are the same.
  bool pair(const TopoDS_Shape& into, const TopoDS_Shape& unchanged, const TopoDS_Shape& changed) {
    if (into.ShapeType() != changed.ShapeType() || into.Orientation() != changed.Orientation())
      return false;
    const Placed placed{changed, parts_.steps.own(into.Location()).Inverted() *
                                     parts_.steps.translated(changed.Location())};
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
    std::vector<Part>* const parts = into.ShapeType() == TopAbs_FACE     ? &parts_.faces
                                     : into.ShapeType() == TopAbs_EDGE   ? &parts_.edges
                                     : into.ShapeType() == TopAbs_VERTEX ? &parts_.vertices
                                                                         : nullptr;
    if (parts == nullptr) return;
    const auto [index, is_new] = indices_.emplace(into.TShape().get(), parts->size());
    if (is_new)
      parts->push_back({into, {unchanged, {}}, changed, {}});
    else
      (*parts)[index->second].elsewhere.push_back(changed);
  }

  /// What a part that came back was, and where it stood when it was met first.
  struct Origin {
    const void* shape;
    TopLoc_Location frame;
  };

  PairedParts parts_;
  std::set<const void*> noted_;
  std::map<const void*, Origin> origins_;
  std::map<const void*, std::size_t> indices_;  ///< of each part that was, in its list
};

/// How faces number their surfaces, as they were and as they came back.
struct Numbering {
  SurfaceNumbers unchanged, changed;
};

Numbering numbered(const std::vector<Part>& faces) {
  Numbering numbers;
  for (int i = 0; i < static_cast<int>(faces.size()); ++i) {
    const Part& face = faces[i];
    numbers.unchanged.add(contentOf<BRep_TFace>(face.unchanged.shape)->Surface(), i);
    numbers.changed.add(contentOf<BRep_TFace>(face.changed.shape)->Surface(), i);
    for (const Placed& other : face.elsewhere)
      numbers.changed.add(contentOf<BRep_TFace>(other.shape)->Surface(), i);
  }
  return numbers;
}

/// "3 and 9, 4 and 10": numbers of parts of a kind that were one and are unlike now.
std::string unlikeNumbers(const std::vector<Part>& parts, TopAbs_ShapeEnum kind,
                          const TopoDS_Shape& changed, const Recorder& record) {
  if (std::ranges::all_of(parts, [](const Part& part) { return part.elsewhere.empty(); }))
    return {};
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(changed, kind, map);
  // A number is that of the first part with the content, whatever its placement.
  std::map<const void*, int> first;
  for (int i = 1; i <= map.Extent(); ++i) first.emplace(map(i).TShape().get(), i);
  const auto numberOf = [&](const Placed& part) { return first.at(part.shape.TShape().get()); };
  std::vector<std::string> pairs;
  for (const Part& part : parts)
    for (const Placed& other : part.elsewhere) {
      const bool is_like = kind == TopAbs_VERTEX ? sameVertex(part.changed, other)
                                                 : record(part.changed) == record(other);
      if (!is_like)
        pairs.push_back(fmt::format("{} and {}", numberOf(part.changed), numberOf(other)));
    }
  return fmt::format("{}", fmt::join(pairs, ", "));
}

void requireLikeInstances(const PairedParts& parts, const TopoDS_Shape& changed,
                          const Recorder& record) {
  std::vector<std::string> unlike;
  for (const auto& [of_kind, kind, name] :
       {std::tuple(&parts.faces, TopAbs_FACE, "faces"),
        std::tuple(&parts.edges, TopAbs_EDGE, "edges"),
        std::tuple(&parts.vertices, TopAbs_VERTEX, "vertices")}) {
    const std::string numbers = unlikeNumbers(*of_kind, kind, changed, record);
    if (!numbers.empty()) unlike.push_back(fmt::format("{} {}", name, numbers));
  }
  if (unlike.empty()) return;
  throw ModelError(
      ModelErrc::UnlikeInstances, {},
      fmt::format("has several instances of a part that were changed differently, which its "
                  "structure can't hold: {}; change all instances alike, or set afresh to write a "
                  "new structure",
                  fmt::join(unlike, "; ")));
}

/// Which surfaces that came back are new, and which are those that were there.
class ChosenSurfaces {
 public:
  ChosenSurfaces(const std::vector<Part>& faces, const Recorder& unchanged_record,
                 const Recorder& changed_record) {
    std::map<const Geom_Surface*, const Geom_Surface*> taken;
    for (const Part& face : faces) {
      const Surface changed = contentOf<BRep_TFace>(face.changed.shape)->Surface();
      const Surface into = contentOf<BRep_TFace>(face.into)->Surface();
      // A surface that several faces had in common and have no longer is new to each but the first.
      if (unchanged_record(face.unchanged) == changed_record(face.changed) &&
          taken.emplace(into.get(), changed.get()).first->second == changed.get())
        kept_.emplace(changed.get(), into);
      else
        new_.insert(changed.get());
    }
  }

  bool isNew(const Surface& surface) const { return new_.count(surface.get()) > 0; }

  /// The surface that was there, or a new one itself.
  Surface chosen(const Surface& surface) const {
    const auto kept = kept_.find(surface.get());
    return isNew(surface) || kept == kept_.end() ? surface : kept->second;
  }

  bool hasNewSurface(const BRep_CurveRepresentation& representation) const {
    return (representation.IsCurveOnSurface() && isNew(representation.Surface())) ||
           (representation.IsRegularity() &&
            (isNew(representation.Surface()) || isNew(representation.Surface2())));
  }

 private:
  std::set<const Geom_Surface*> new_;
  std::map<const Geom_Surface*, Surface> kept_;  ///< surfaces that came back as they went
};

/// Of the parts that have a larger one now.
template <class Content>
double largestNewTolerance(const std::vector<Part>& parts) {
  double largest = 0;
  for (const Part& part : parts) {
    const double now = contentOf<Content>(part.changed.shape)->Tolerance();
    if (now > contentOf<Content>(part.into)->Tolerance()) largest = std::max(largest, now);
  }
  return largest;
}

/// A copy that names the surfaces and placements of the shape that is changed in place.
Representation repointed(const Representation& old, const TopLoc_Location& frame,
                         const Steps& steps, const ChosenSurfaces& surfaces) {
  const TopLoc_Location location = frame * steps.translated(old->Location());
  opencascade::handle<BRep_GCurve> curve;
  if (old->IsCurve3D())
    curve = new BRep_Curve3D(old->Curve3D(), location);
  else if (old->IsCurveOnClosedSurface())
    curve =
        new BRep_CurveOnClosedSurface(old->PCurve(), old->PCurve2(),
                                      surfaces.chosen(old->Surface()), location, old->Continuity());
  else if (old->IsCurveOnSurface())
    curve = new BRep_CurveOnSurface(old->PCurve(), surfaces.chosen(old->Surface()), location);
  else
    return new BRep_CurveOn2Surfaces(surfaces.chosen(old->Surface()),
                                     surfaces.chosen(old->Surface2()), location,
                                     frame * steps.translated(old->Location2()), old->Continuity());
  const auto range = opencascade::handle<BRep_GCurve>::DownCast(old);
  curve->SetRange(range->First(), range->Last());
  return curve;
}

/// \returns whether the face got another surface.
bool carryFace(const Part& part, const Steps& steps, const ChosenSurfaces& surfaces) {
  const opencascade::handle<BRep_TFace> into = contentOf<BRep_TFace>(part.into),
                                        changed = contentOf<BRep_TFace>(part.changed.shape);
  into->Tolerance(changed->Tolerance());
  into->NaturalRestriction(changed->NaturalRestriction());
  if (!surfaces.isNew(changed->Surface())) return false;
  into->Surface(changed->Surface());
  into->Location(part.changed.frame * steps.translated(changed->Location()));
  into->Triangulation(opencascade::handle<Poly_Triangulation>());
  return true;
}

/// Gives an edge its curves again, also where only a surface that it names is another one.
void carryEdge(const Part& part, const Steps& steps, const ChosenSurfaces& surfaces) {
  const opencascade::handle<BRep_TEdge> into = contentOf<BRep_TEdge>(part.into),
                                        changed = contentOf<BRep_TEdge>(part.changed.shape);
  into->Tolerance(changed->Tolerance());
  into->SameParameter(changed->SameParameter());
  into->SameRange(changed->SameRange());
  into->Degenerated(changed->Degenerated());
  into->ChangeCurves().Clear();
  for (const Representation& representation : changed->Curves())
    if (isGeometry(*representation))
      into->ChangeCurves().Append(repointed(representation, part.changed.frame, steps, surfaces));
}

bool hasNewSurface(const Part& edge, const ChosenSurfaces& surfaces) {
  const BRep_ListOfCurveRepresentation& curves =
      contentOf<BRep_TEdge>(edge.changed.shape)->Curves();
  return std::any_of(curves.begin(), curves.end(), [&](const Representation& representation) {
    return surfaces.hasNewSurface(*representation);
  });
}

/// \returns whether the vertex got another point or tolerance.
bool carryVertex(const Part& part) {
  const opencascade::handle<BRep_TVertex> into = contentOf<BRep_TVertex>(part.into),
                                          changed = contentOf<BRep_TVertex>(part.changed.shape);
  if (sameVertex(part.unchanged, part.changed)) return false;
  if (!samePoint(part.unchanged, part.changed)) into->Pnt(pointOf(part.changed));
  into->Tolerance(changed->Tolerance());
  return true;
}

}  // namespace

std::optional<Carried> carryGeometry(const TopoDS_Shape& changed, const TopoDS_Shape& into) {
  // The shape as it comes back if nothing is changed: the round trip rounds the axes of placements.
  const TopoDS_Shape unchanged = throughBinary(throughBinary(into));
  const std::optional<PairedParts> parts = GraphWalk().paired(into, unchanged, changed);
  if (!parts) return std::nullopt;
  const Numbering numbers = numbered(parts->faces);
  const Recorder unchanged_record(parts->steps, numbers.unchanged),
      changed_record(parts->steps, numbers.changed);
  requireLikeInstances(*parts, changed, changed_record);
  const ChosenSurfaces surfaces(parts->faces, unchanged_record, changed_record);
  Carried count;
  for (const Part& face : parts->faces) count.faces += carryFace(face, parts->steps, surfaces);
  count.largest_tolerance_mm = std::max(largestNewTolerance<BRep_TEdge>(parts->edges),
                                        largestNewTolerance<BRep_TVertex>(parts->vertices));
  for (const Part& edge : parts->edges) {
    const bool differs = unchanged_record(edge.unchanged) != changed_record(edge.changed);
    if (differs || hasNewSurface(edge, surfaces)) carryEdge(edge, parts->steps, surfaces);
    count.edges += differs;
  }
  for (const Part& vertex : parts->vertices) count.vertices += carryVertex(vertex);
  return count;
}

}  // namespace seamwright::occ
