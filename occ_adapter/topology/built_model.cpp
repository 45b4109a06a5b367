// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>
#include <cmath>
#include <stdexcept>

#include <seamwright/occ_adapter/convert/bezier_surface.hpp>
#include <seamwright/occ_adapter/convert/natural_face.hpp>
#include <seamwright/occ_adapter/convert/spline_curve.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/convert/surface_kind.hpp>
#include <seamwright/occ_adapter/model/compound.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/topology/built_model.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

TopoDS_Vertex vertexFor(const gp_Pnt& point, double tolerance_mm) {
  TopoDS_Vertex vertex;
  BRep_Builder().MakeVertex(vertex, point, tolerance_mm);
  return vertex;
}

/// \param closed_mm the ends become one vertex if they are no further apart.
template <class Curve>
TopoDS_Edge edgeOn(const handle<Curve>& curve, double closed_mm) {
  double extent_mm = 0;
  for (int i = 2; i <= curve->NbPoles(); ++i)
    extent_mm = std::max(extent_mm, curve->Pole(i).Distance(curve->Pole(1)));
  if (extent_mm <= closed_mm)
    throw std::invalid_argument(fmt::format(
        "all poles are within {:.3g} mm of the first one: the edge would have no length",
        closed_mm));
  const double first = curve->FirstParameter(), last = curve->LastParameter();
  const gp_Pnt begin = curve->Pole(1), end = curve->Pole(curve->NbPoles());
  const bool closed = begin.Distance(end) <= closed_mm;
  // The distance itself has a rounding.
  constexpr double rounding = 1 + 1e-12;
  const double reach_mm = closed ? rounding * begin.Distance(end) : 0;
  const TopoDS_Vertex start = vertexFor(begin, std::max(Precision::Confusion(), reach_mm));
  const TopoDS_Vertex stop = closed ? start : vertexFor(end, Precision::Confusion());
  const BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge, curve, Precision::Confusion());
  builder.Add(edge, start.Oriented(TopAbs_FORWARD));
  builder.Add(edge, stop.Oriented(TopAbs_REVERSED));
  builder.Range(edge, first, last);
  return edge;
}

/// The file formats keep the order of shells, but put loose faces after them.
TopoDS_Shell shellOf(const TopoDS_Face& face) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  builder.Add(shell, face);
  return shell;
}

/// Shells and edges of items.
struct ShapeMaker {
  double tolerance_mm;

  TopoDS_Shape operator()(const BezierPatch& patch) const {
    return shellOf(naturalFace(toBezierSurface(patch), tolerance_mm));
  }
  TopoDS_Shape operator()(const BezierTriangle& triangle) const {
    return toShell(triangle, tolerance_mm);
  }
  TopoDS_Shape operator()(const BSplineSurface& surface) const {
    return shellOf(faceOf(surface, tolerance_mm));
  }
  TopoDS_Shape operator()(const BezierCurve& curve) const {
    return edgeOn(toBezierCurve(curve), tolerance_mm);
  }
  TopoDS_Shape operator()(const BSplineCurve& curve) const {
    return edgeOn(toBSplineCurve(curve), tolerance_mm);
  }
  TopoDS_Shape operator()(const BezierSpline& spline) const {
    return edgeOn(toBSplineCurve(spline), tolerance_mm);
  }
};

TopoDS_Shape shapeOf(const BuiltItem& item, std::size_t index, double tolerance_mm) {
  try {
    return std::visit(ShapeMaker{tolerance_mm}, item.geometry);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument((item.label.empty() ? fmt::format("item {}", index) : item.label) +
                                ": " + error.what());
  }
}

/// Names the faces of a shape, or the edge that it is.
void nameParts(const TopoDS_Shape& part, const std::string& name, Model& model) {
  const TopAbs_ShapeEnum kind = part.ShapeType() == TopAbs_EDGE ? TopAbs_EDGE : TopAbs_FACE;
  const TopTools_IndexedMapOfShape numbers = partsOf(model.shape, kind);
  for (TopExp_Explorer it(part, kind); it.More(); it.Next()) {
    ShapeAttribute attribute;
    attribute.kind = kind;
    attribute.index = numbers.FindIndex(it.Current());
    attribute.name = name;
    model.attributes.push_back(std::move(attribute));
  }
}

}  // namespace

Model builtModel(const std::vector<BuiltItem>& items, double tolerance_mm) {
  if (!(tolerance_mm > 0) || !std::isfinite(tolerance_mm))
    throw std::invalid_argument(
        fmt::format("tolerance is {:.6g} mm: it must be positive and finite", tolerance_mm));
  if (items.empty()) throw std::invalid_argument("no surfaces and no curves: one is needed");
  std::vector<TopoDS_Shape> parts;
  for (std::size_t i = 0; i < items.size(); ++i)
    parts.push_back(shapeOf(items[i], i, tolerance_mm));
  Model model;
  model.shape = compoundOf(parts);
  model.format = "memory";
  model.length_unit = "mm (assumed)";
  if (model.faceCount() > 0) noteUnusableParts(model);
  for (std::size_t i = 0; i < items.size(); ++i)
    if (!items[i].name.empty()) nameParts(parts[i], items[i].name, model);
  return model;
}

BSplineSurface faceSurface(const Model& model, int face) {
  const TopTools_IndexedMapOfShape faces = partsOf(model.shape, TopAbs_FACE);
  requireFace(face, faces.Extent());
  const TopoDS_Face& shape = TopoDS::Face(faces(face));
  TopLoc_Location location;
  const handle<Geom_Surface> surface = BRep_Tool::Surface(shape, location);
  const handle<Geom_BSplineSurface> spline =
      surface.IsNull() ? handle<Geom_BSplineSurface>() : clampedSpline(surface, location);
  if (spline.IsNull())
    throw std::domain_error(fmt::format("Face{} has {}: it must have a Bezier or B-spline surface",
                                        face, surface.IsNull() ? "no surface" : kindOf(shape)));
  return coreSurface(*spline);
}

BSplineCurve edgeCurve(const Model& model, int edge) {
  const TopTools_IndexedMapOfShape edges = partsOf(model.shape, TopAbs_EDGE);
  requireEdge(edge, edges.Extent());
  TopLoc_Location location;
  double first = 0, last = 0;
  const handle<Geom_Curve> curve =
      BRep_Tool::Curve(TopoDS::Edge(edges(edge)), location, first, last);
  if (curve.IsNull())
    throw std::domain_error(fmt::format("Edge{} has no curve: it is a point of a surface", edge));
  const handle<Geom_Curve> placed =
      location.IsIdentity()
          ? curve
          : handle<Geom_Curve>::DownCast(curve->Transformed(location.Transformation()));
  const bool whole = first == placed->FirstParameter() && last == placed->LastParameter();
  try {
    return whole ? coreCurve(*placed) : coreCurve(Geom_TrimmedCurve(placed, first, last));
  } catch (const std::domain_error& error) {
    throw std::domain_error(fmt::format("Edge{}: {}", edge, error.what()));
  }
}

}  // namespace seamwright::occ
