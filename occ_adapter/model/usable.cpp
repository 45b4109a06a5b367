// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRep_CurveRepresentation.hxx>
#include <BRep_GCurve.hxx>
#include <BRep_ListOfCurveRepresentation.hxx>
#include <BRep_ListOfPointRepresentation.hxx>
#include <BRep_PointRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_TVertex.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Line.hxx>
#include <GeomTools_Curve2dSet.hxx>
#include <GeomTools_CurveSet.hxx>
#include <GeomTools_SurfaceSet.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <sstream>
#include <string_view>

#include <seamwright/occ_adapter/model/not_finite.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

std::string faultyNumber(std::string_view what, double number) {
  return fmt::format("{} with the number {:.6g}", what, number);
}

/// The numbers of a position: origin and directions.
std::array<gp_XYZ, 4> numbersOf(const gp_Ax3& position) {
  return {position.Location().XYZ(), position.Direction().XYZ(), position.XDirection().XYZ(),
          position.YDirection().XYZ()};
}

std::array<gp_XYZ, 4> numbersOf(const gp_Ax2& position) {
  return {position.Location().XYZ(), position.Direction().XYZ(), position.XDirection().XYZ(),
          position.YDirection().XYZ()};
}

std::array<gp_XY, 3> numbersOf(const gp_Ax22d& position) {
  return {position.Location().XY(), position.XDirection().XY(), position.YDirection().XY()};
}

std::array<gp_XYZ, 2> numbersOf(const gp_Ax1& position) {
  return {position.Location().XYZ(), position.Direction().XYZ()};
}

std::array<gp_XY, 2> numbersOf(const gp_Ax2d& position) {
  return {position.Location().XY(), position.Direction().XY()};
}

gp_XYZ numbersOf(const gp_Pnt& point) {
  return point.XYZ();
}

gp_XY numbersOf(const gp_Pnt2d& point) {
  return point.XY();
}

/// The object as that type; null if it is of another type or of one that derives from it.
template <class Type, class Base>
const Type* exactly(const handle<Base>& object) {
  return object->IsInstance(STANDARD_TYPE(Type)) ? static_cast<const Type*>(object.get()) : nullptr;
}

/// The first fault of several, or nothing.
std::string firstFaultOf(std::initializer_list<std::string> faults) {
  for (const std::string& fault : faults)
    if (!fault.empty()) return fault;
  return {};
}

/// Looks for numbers that are not finite, or as large as a limit.
class FaultFinder {
 public:
  explicit FaultFinder(double too_large) : too_large_(too_large) {}

  /// What is wrong with numbers, or nothing.
  std::string faultOf(std::string_view what, std::initializer_list<double> numbers) const {
    for (const double number : numbers)
      if (!isUsableNumber(number)) return faultyNumber(what, number);
    return {};
  }

  std::string faultOf(std::string_view what, const gp_XYZ& point) const {
    return faultOf(what, {point.X(), point.Y(), point.Z()});
  }

  std::string faultOf(std::string_view what, const gp_XY& point) const {
    return faultOf(what, {point.X(), point.Y()});
  }

  /// Of a position and other numbers.
  template <class Vector, std::size_t Count>
  std::string faultOf(std::string_view what, const std::array<Vector, Count>& position,
                      std::initializer_list<double> numbers = {}) const {
    for (const Vector& vector : position)
      if (std::string fault = faultOf(what, vector); !fault.empty()) return fault;
    return faultOf(what, numbers);
  }

  std::string faultOf(const TopLoc_Location& location) const {
    if (location.IsIdentity()) return {};
    const gp_Trsf motion = location.Transformation();
    for (int row = 1; row <= 3; ++row)
      for (int column = 1; column <= 4; ++column)
        if (const double number = motion.Value(row, column); !isUsableNumber(number))
          return faultyNumber("a location", number);
    return {};
  }

  /// OpenCASCADE writes each kind of curve and surface as its numbers, nested ones too.
  template <class Print>
  std::string faultInText(std::string_view what, const Print& print) const {
    std::ostringstream stream;
    try {
      print(stream);
    } catch (const Standard_Failure&) {
      return {};  // of a kind that it does not write
    }
    const std::string_view text = stream.view();
    constexpr std::string_view between = " \n";
    for (std::size_t begin = 0, end = 0;
         (begin = text.find_first_not_of(between, end)) != text.npos;) {
      end = std::min(text.find_first_of(between, begin), text.size());
      double number = 0;
      const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, number);
      if (error == std::errc() && !isUsableNumber(number)) return faultyNumber(what, number);
    }
    return {};
  }

  std::string faultOf(std::string_view what, const Geom_BSplineSurface& spline) const {
    for (const TColStd_Array1OfReal* knots : {&spline.UKnots(), &spline.VKnots()})
      for (const double knot : *knots)
        if (!isUsableNumber(knot)) return faultyNumber(what, knot);
    for (int i = 1; i <= spline.NbUPoles(); ++i)
      for (int j = 1; j <= spline.NbVPoles(); ++j) {
        const gp_XYZ& pole = spline.Poles().Value(i, j).XYZ();
        for (const double number : {pole.X(), pole.Y(), pole.Z(), spline.Weight(i, j)})
          if (!isUsableNumber(number)) return faultyNumber(what, number);
      }
    return {};
  }

  template <class Spline>
  std::string faultOfSplineCurve(std::string_view what, const Spline& spline) const {
    for (int i = 1; i <= spline.NbPoles(); ++i) {
      std::string fault = faultOf(what, numbersOf(spline.Pole(i)));
      if (fault.empty()) fault = faultOf(what, {spline.Weight(i)});
      if (!fault.empty()) return fault;
    }
    for (const double knot : spline.Knots())
      if (!isUsableNumber(knot)) return faultyNumber(what, knot);
    return {};
  }

  // The kinds that most curves and surfaces are of are examined without writing them.

  std::string faultOf(const handle<Geom_Surface>& surface) const {
    if (surface.IsNull()) return {};
    constexpr std::string_view what = "a surface";
    if (const auto* spline = exactly<Geom_BSplineSurface>(surface)) return faultOf(what, *spline);
    if (const auto* plane = exactly<Geom_Plane>(surface))
      return faultOf(what, numbersOf(plane->Position()));
    if (const auto* cylinder = exactly<Geom_CylindricalSurface>(surface))
      return faultOf(what, numbersOf(cylinder->Position()), {cylinder->Radius()});
    if (const auto* cone = exactly<Geom_ConicalSurface>(surface))
      return faultOf(what, numbersOf(cone->Position()), {cone->RefRadius(), cone->SemiAngle()});
    if (const auto* sphere = exactly<Geom_SphericalSurface>(surface))
      return faultOf(what, numbersOf(sphere->Position()), {sphere->Radius()});
    if (const auto* torus = exactly<Geom_ToroidalSurface>(surface))
      return faultOf(what, numbersOf(torus->Position()),
                     {torus->MajorRadius(), torus->MinorRadius()});
    return faultInText(what, [&surface](std::ostream& stream) {
      GeomTools_SurfaceSet::PrintSurface(surface, stream, true);
    });
  }

  std::string faultOf(const handle<Geom_Curve>& curve) const {
    if (curve.IsNull()) return {};
    constexpr std::string_view what = "a curve";
    if (const auto* line = exactly<Geom_Line>(curve))
      return faultOf(what, numbersOf(line->Position()));
    if (const auto* circle = exactly<Geom_Circle>(curve))
      return faultOf(what, numbersOf(circle->Position()), {circle->Radius()});
    if (const auto* spline = exactly<Geom_BSplineCurve>(curve))
      return faultOfSplineCurve(what, *spline);
    return faultInText(what, [&curve](std::ostream& stream) {
      GeomTools_CurveSet::PrintCurve(curve, stream, true);
    });
  }

  std::string faultOf(const handle<Geom2d_Curve>& curve) const {
    if (curve.IsNull()) return {};
    constexpr std::string_view what = "a path on a face";
    if (const auto* line = exactly<Geom2d_Line>(curve))
      return faultOf(what, numbersOf(line->Position()));
    if (const auto* circle = exactly<Geom2d_Circle>(curve))
      return faultOf(what, numbersOf(circle->Position()), {circle->Radius()});
    if (const auto* spline = exactly<Geom2d_BSplineCurve>(curve))
      return faultOfSplineCurve(what, *spline);
    return faultInText(what, [&curve](std::ostream& stream) {
      GeomTools_Curve2dSet::PrintCurve2d(curve, stream, true);
    });
  }

  /// Without a curve the range means nothing: at the pole of a sphere an edge has a path on the
  /// face alone.
  template <class Curve>
  std::string faultOf(const BRep_GCurve& owner, const handle<Curve>& curve) const {
    return curve.IsNull()
               ? std::string()
               : firstFaultOf({faultOf("a range", {owner.First(), owner.Last()}), faultOf(curve)});
  }

  std::string faultOf(const handle<BRep_CurveRepresentation>& representation) const {
    const auto owner = handle<BRep_GCurve>::DownCast(representation);
    if (owner.IsNull()) return {};
    std::string fault = faultOf(owner->Location());
    if (fault.empty() && owner->IsCurve3D()) fault = faultOf(*owner, owner->Curve3D());
    if (fault.empty() && owner->IsCurveOnSurface()) fault = faultOf(*owner, owner->PCurve());
    if (fault.empty() && owner->IsCurveOnClosedSurface()) fault = faultOf(*owner, owner->PCurve2());
    return fault;
  }

  std::string faultOf(const TopoDS_Vertex& vertex) const {
    const auto body = handle<BRep_TVertex>::DownCast(vertex.TShape());
    if (body.IsNull()) return {};
    std::string fault =
        firstFaultOf({faultOf(vertex.Location()), faultOf("a vertex", body->Pnt().XYZ()),
                      faultOf("a tolerance of a vertex", {body->Tolerance()})});
    for (BRep_ListIteratorOfListOfPointRepresentation it(body->Points());
         fault.empty() && it.More(); it.Next())
      fault = firstFaultOf({faultOf(it.Value()->Location()),
                            faultOf("a parameter of a vertex", {it.Value()->Parameter()})});
    return fault;
  }

  std::string faultOf(const TopoDS_Edge& edge) const {
    const auto body = handle<BRep_TEdge>::DownCast(edge.TShape());
    if (body.IsNull()) return {};
    std::string fault =
        firstFaultOf({faultOf(edge.Location()), faultOf("a tolerance", {body->Tolerance()})});
    for (BRep_ListIteratorOfListOfCurveRepresentation it(body->Curves());
         fault.empty() && it.More(); it.Next())
      fault = faultOf(it.Value());
    for (TopExp_Explorer it(edge, TopAbs_VERTEX); fault.empty() && it.More(); it.Next())
      fault = faultOf(TopoDS::Vertex(it.Current()));
    return fault;
  }

  std::string faultOf(const TopoDS_Face& face) const {
    TopLoc_Location location;
    const handle<Geom_Surface> surface = BRep_Tool::Surface(face, location);
    return firstFaultOf({faultOf(location), faultOf("a tolerance", {BRep_Tool::Tolerance(face)}),
                         faultOf(surface)});
  }

 private:
  bool isUsableNumber(double number) const {
    return std::isfinite(number) && std::abs(number) < too_large_;
  }

  double too_large_;
};

/// Precision::IsInfinite() takes this for infinite.
FaultFinder unusableNumbers() {
  return FaultFinder(0.5 * Precision::Infinite());
}

template <class Part>
std::map<int, std::string> faultsOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind,
                                    const Part& (*cast)(const TopoDS_Shape&),
                                    const FaultFinder& search) {
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(shape, kind, parts);
  std::map<int, std::string> faults;
  for (int i = 1; i <= parts.Extent(); ++i)
    if (std::string fault = search.faultOf(cast(parts(i))); !fault.empty())
      faults.emplace(i, std::move(fault));
  return faults;
}

const TopoDS_Face& asFace(const TopoDS_Shape& shape) {
  return TopoDS::Face(shape);
}

const TopoDS_Edge& asEdge(const TopoDS_Shape& shape) {
  return TopoDS::Edge(shape);
}

std::string countedParts(std::size_t count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

UnusableParts::UnusableParts(const TopoDS_Shape& shape)
    : faces_(faultsOf(shape, TopAbs_FACE, asFace, unusableNumbers())),
      edges_(faultsOf(shape, TopAbs_EDGE, asEdge, unusableNumbers())) {
  if (edges_.empty()) return;
  TopTools_IndexedMapOfShape faces, edges;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int f = 1; f <= faces.Extent(); ++f)
    for (TopExp_Explorer it(faces(f), TopAbs_EDGE); it.More(); it.Next())
      if (const int edge = edges.FindIndex(it.Current()); hasEdge(edge))
        edge_of_face_.emplace(f, edge);
}

std::string UnusableParts::describeFace(int face) const {
  return fmt::format("face {} has {}", face, faces_.at(face));
}

std::string UnusableParts::describeEdge(int edge) const {
  return fmt::format("edge {} has {}", edge, edges_.at(edge));
}

std::string UnusableParts::whyLeftOut(int face) const {
  if (hasFace(face)) return "has " + faces_.at(face);
  const auto edge = edge_of_face_.find(face);
  if (edge == edge_of_face_.end()) return {};
  return fmt::format("has edge {}, which has {}", edge->second, edges_.at(edge->second));
}

std::string UnusableParts::note() const {
  if (empty()) return {};
  const std::string first =
      faces_.empty() ? describeEdge(edges_.begin()->first) : describeFace(faces_.begin()->first);
  std::string counts;
  if (!faces_.empty()) counts = countedParts(faces_.size(), "face");
  if (!edges_.empty())
    counts += (counts.empty() ? "" : " and ") + countedParts(edges_.size(), "edge");
  const bool is_one = faces_.size() + edges_.size() == 1;
  return counts + (is_one ? " holds" : " hold") +
         " numbers that are not finite or too large (1e100 and more): " + first;
}

bool isUsable(const TopoDS_Face& face) {
  return unusableNumbers().faultOf(face).empty();
}

bool isUsable(const TopoDS_Edge& edge) {
  return unusableNumbers().faultOf(edge).empty();
}

std::string whyNotFinite(const TopoDS_Shape& shape) {
  const FaultFinder search(std::numeric_limits<double>::infinity());
  const std::map<int, std::string> faces = faultsOf(shape, TopAbs_FACE, asFace, search);
  if (!faces.empty())
    return fmt::format("face {} has {}", faces.begin()->first, faces.begin()->second);
  const std::map<int, std::string> edges = faultsOf(shape, TopAbs_EDGE, asEdge, search);
  if (edges.empty()) return {};
  return fmt::format("edge {} has {}", edges.begin()->first, edges.begin()->second);
}

void noteUnusableParts(Model& model) {
  const UnusableParts unusable(model.shape);
  if (unusable.empty()) return;
  if (unusable.faceCount() > 0 && unusable.faceCount() == model.faceCount())
    throw ModelError(ModelErrc::Malformed, model.path,
                     "has no face with finite numbers: " + unusable.note());
  model.notes.push_back(unusable.note() +
                        "; they stay as they are, and their seams are not measured");
}

void requireUsable(const TopoDS_Shape& shape, const std::filesystem::path& path,
                   const std::string& deed) {
  const UnusableParts unusable(shape);
  if (unusable.empty()) return;
  throw ModelError(ModelErrc::Malformed, path,
                   "can't be " + deed + ": " + unusable.note() + "; remove or remake these parts");
}

}  // namespace seamwright::occ
