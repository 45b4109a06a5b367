// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Section.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>
#include <cmath>
#include <gp_Pnt.hxx>
#include <map>
#include <vector>

#include <seamwright/occ_adapter/fill/clearance.hpp>
#include <seamwright/occ_adapter/model/edge_curves.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>

namespace seamwright::occ {

namespace {

/// The edges and vertices that two faces share; null if there are none.
TopoDS_Shape commonOf(const TopoDS_Shape& one, const TopoDS_Shape& other) {
  const BRep_Builder builder;
  TopoDS_Compound common;
  for (const TopAbs_ShapeEnum type : {TopAbs_EDGE, TopAbs_VERTEX}) {
    const TopTools_IndexedMapOfShape some = partsOf(one, type), others = partsOf(other, type);
    for (int k = 1; k <= others.Extent(); ++k) {
      if (!some.Contains(others(k))) continue;
      if (common.IsNull()) builder.MakeCompound(common);
      builder.Add(common, others(k));
    }
  }
  return common;
}

double distance(const TopoDS_Shape& one, const TopoDS_Shape& other) {
  const BRepExtrema_DistShapeShape found(one, other);
  return found.IsDone() ? found.Value() : HUGE_VAL;
}

/// A tight box around the face. It is costly, so loose boxes are tested first.
Bnd_Box tightBox(const TopoDS_Shape& face) {
  Bnd_Box box;
  BRepBndLib::AddOptimal(face, box, false, false);
  box.Enlarge(Precision::Confusion());
  return box;
}

/// Finds points of edges that lie on a face, away from the parts that the face shares with the face
/// of these edges.
class Clearance {
 public:
  Clearance(const TopoDS_Shape& face, const Bnd_Box& box, const TopoDS_Shape& common)
      : face_(face), common_(common), box_(box), near_mm_(std::sqrt(box_.SquareExtent()) / 100) {}

  bool isOn(const TopoDS_Shape& edges) const {
    // A choice: it finds edges of which an eighth, by the parameter, lies on the face.
    constexpr int steps = 8;
    for (TopExp_Explorer edge(edges, TopAbs_EDGE); edge.More(); edge.Next()) {
      const TopoDS_Edge& one = TopoDS::Edge(edge.Current());
      if (BRep_Tool::Degenerated(one)) continue;
      const BRepAdaptor_Curve curve(one);
      const double first = curve.FirstParameter(), last = curve.LastParameter();
      for (int k = 0; k <= steps; ++k)
        if (isAt(curve.Value(first + k * (last - first) / steps))) return true;
    }
    return false;
  }

 private:
  bool isAt(const gp_Pnt& point) const {
    if (box_.IsOut(point)) return false;
    const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex(point);
    return distance(vertex, common_) > near_mm_ &&
           distance(vertex, face_) <= Precision::Confusion();
  }

  const TopoDS_Shape& face_;
  const TopoDS_Shape& common_;
  Bnd_Box box_;
  double near_mm_;
};

/// Edges along which two faces intersect or touch.
TopoDS_Shape sectionOf(const TopoDS_Shape& one, const TopoDS_Shape& other) {
  BRepAlgoAPI_Section section(one, other, false);
  section.Build();
  return section.IsDone() ? section.Shape() : TopoDS_Compound();
}

/// Whether two faces meet. The section is needed too, because OpenCASCADE may miss the zero
/// distance of faces that intersect.
bool meet(const TopoDS_Shape& one, const TopoDS_Shape& other) {
  return distance(one, other) <= Precision::Confusion() ||
         TopExp_Explorer(sectionOf(one, other), TopAbs_EDGE).More();
}

/// Whether two faces meet further from what they share than a hundredth of the first one's extent.
/// \param box of the first face. \param with_section also test the interior of both faces, not only
/// edges of the other one.
bool meetElsewhere(const TopoDS_Shape& one, const Bnd_Box& box, const TopoDS_Shape& other,
                   const TopoDS_Shape& common, bool with_section) {
  const Clearance contact(one, box, common);
  return contact.isOn(other) || (with_section && contact.isOn(sectionOf(one, other)));
}

}  // namespace

std::optional<std::pair<int, int>> touchingFaces(const TopoDS_Shape& shape,
                                                 const std::set<int>& fresh, bool with_sections) {
  with_sections = with_sections && fresh.size() == 1;
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE);
  std::vector<Bnd_Box> boxes(static_cast<std::size_t>(faces.Extent()) + 1);
  const UnusableParts unusable(shape);
  // The boxes of faces that are not tested stay void, so that nothing meets them.
  for (int f = 1; f <= faces.Extent(); ++f)
    if (unusable.whyLeftOut(f).empty() && allEdgesHaveCurves(faces(f)))
      BRepBndLib::Add(faces(f), boxes[f], false);
  std::map<int, Bnd_Box> tight;
  const auto tightOf = [&](int face) -> const Bnd_Box& {
    const auto found = tight.find(face);
    return found != tight.end() ? found->second
                                : tight.emplace(face, tightBox(faces(face))).first->second;
  };
  for (const int a : fresh)
    for (int b = 1; b <= faces.Extent(); ++b) {
      if (b == a || (b < a && fresh.count(b) > 0) || boxes[a].IsOut(boxes[b])) continue;
      const TopoDS_Shape common = commonOf(faces(a), faces(b));
      if (!common.IsNull() && fresh.count(b) > 0) continue;
      if (tightOf(a).IsOut(tightOf(b))) continue;
      if (common.IsNull() ? meet(faces(a), faces(b))
                          : meetElsewhere(faces(a), tightOf(a), faces(b), common, with_sections))
        return std::pair{a, b};
    }
  return std::nullopt;
}

}  // namespace seamwright::occ
