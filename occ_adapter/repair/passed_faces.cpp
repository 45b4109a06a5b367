// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <Bnd_Box.hxx>
#include <IntCurvesFace_Intersector.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <gp_Lin.hxx>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <seamwright/occ_adapter/repair/passed_faces.hpp>

namespace seamwright::occ {

namespace {

using Way = std::pair<gp_Pnt, gp_Pnt>;

/// Ways of points inside a face that are long enough.
std::vector<Way> waysOf(const TopoDS_Face& before, const TopoDS_Face& after, double least_mm) {
  constexpr int points = 32;
  std::array<double, 4> range{};
  BRepTools::UVBounds(before, range[0], range[1], range[2], range[3]);
  const BRepAdaptor_Surface from(before), to(after);
  const BRepTopAdaptor_FClass2d inside(before, Precision::PConfusion());
  std::vector<Way> ways;
  for (int i = 0; i < points; ++i)
    for (int j = 0; j < points; ++j) {
      const double u = range[0] + static_cast<double>(i) / (points - 1) * (range[1] - range[0]),
                   v = range[2] + static_cast<double>(j) / (points - 1) * (range[3] - range[2]);
      const Way way(from.Value(u, v), to.Value(u, v));
      if (way.first.Distance(way.second) > least_mm && inside.Perform(gp_Pnt2d(u, v)) != TopAbs_OUT)
        ways.push_back(way);
    }
  return ways;
}

Bnd_Box boxOf(const Way& way) {
  Bnd_Box box;
  box.Add(way.first);
  box.Add(way.second);
  return box;
}

/// The faces of a shape, each made ready for lines when the first one comes near.
class CrossedFaces {
 public:
  CrossedFaces(const TopTools_IndexedMapOfShape& before, const TopTools_IndexedMapOfShape& faces,
               double touch_mm)
      : before_(before),
        faces_(faces),
        touch_mm_(touch_mm),
        crossers_(static_cast<std::size_t>(faces.Extent()) + 1) {
    boxes_.emplace_back();
    for (int face = 1; face <= faces.Extent(); ++face)
      BRepBndLib::Add(faces(face), boxes_.emplace_back(), false);
  }

  /// One that a way of a face crosses, but for some.
  std::optional<int> crossed(int own, const std::vector<Way>& ways, const std::set<int>& but) {
    Bnd_Box all;
    for (const Way& way : ways) all.Add(boxOf(way));
    for (int face = 1; face <= faces_.Extent(); ++face)
      if (!boxes_[face].IsOut(all) && but.count(face) == 0 && crosses(ways, face) && !touched(own, face))
        return face;
    return {};
  }

 private:
  bool crosses(const std::vector<Way>& ways, int face) {
    return std::ranges::any_of(ways, [&](const Way& way) {
      if (boxes_[face].IsOut(boxOf(way))) return false;
      auto& crosser = crossers_[face];
      if (!crosser)
        crosser =
            std::make_unique<IntCurvesFace_Intersector>(TopoDS::Face(faces_(face)), Precision::Confusion());
      const gp_Vec along(way.first, way.second);
      crosser->Perform(gp_Lin(way.first, gp_Dir(along)), 0, along.Magnitude());
      return crosser->IsDone() && crosser->NbPnt() > 0;
    });
  }

  bool touched(int face, int other) const {
    const BRepExtrema_DistShapeShape distance(before_(face), before_(other));
    return distance.IsDone() && distance.Value() <= touch_mm_;
  }

  const TopTools_IndexedMapOfShape &before_, &faces_;
  double touch_mm_;
  std::vector<Bnd_Box> boxes_;  ///< by face
  std::vector<std::unique_ptr<IntCurvesFace_Intersector>> crossers_;
};

/// Those that share a vertex with a face, and itself.
std::set<int> facesAround(const TopoDS_Shape& face, const TopTools_IndexedMapOfShape& faces,
                          const TopTools_IndexedDataMapOfShapeListOfShape& faces_of_vertex) {
  std::set<int> around = {faces.FindIndex(face)};
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(face, TopAbs_VERTEX, vertices);
  for (int vertex = 1; vertex <= vertices.Extent(); ++vertex)
    for (const TopoDS_Shape& other : faces_of_vertex.FindFromKey(vertices(vertex)))
      around.insert(faces.FindIndex(other));
  return around;
}

}  // namespace

std::map<int, int> passedFaces(const TopoDS_Shape& before, const TopoDS_Shape& after,
                               const std::set<int>& moved, double least_mm, double touch_mm) {
  TopTools_IndexedMapOfShape were, are;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_vertex;
  TopExp::MapShapes(before, TopAbs_FACE, were);
  TopExp::MapShapes(after, TopAbs_FACE, are);
  TopExp::MapShapesAndUniqueAncestors(before, TopAbs_VERTEX, TopAbs_FACE, faces_of_vertex);
  std::map<int, int> passed;
  std::optional<CrossedFaces> others;
  for (const int face : moved) {
    const std::vector<Way> ways = waysOf(TopoDS::Face(were(face)), TopoDS::Face(are(face)), least_mm);
    if (ways.empty()) continue;
    if (!others) others.emplace(were, are, touch_mm);
    if (const auto other = others->crossed(face, ways, facesAround(were(face), were, faces_of_vertex)))
      passed.emplace(face, *other);
  }
  return passed;
}

}  // namespace seamwright::occ
