// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <Bnd_Box.hxx>
#include <IntCurvesFace_Intersector.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <gp_Lin.hxx>
#include <memory>
#include <vector>

#include <seamwright/occ_adapter/repair/passed_faces.hpp>

namespace seamwright::occ {

namespace {

struct Way {
  gp_Pnt from, to;

  Bnd_Box box() const {
    Bnd_Box box;
    box.Add(from);
    box.Add(to);
    return box;
  }
};

/// Straight paths, from old to new positions, of points inside a face, as far as they are long
/// enough.
std::vector<Way> waysOf(const TopoDS_Face& before, const TopoDS_Face& after, double least_mm) {
  // In each direction: as many as the iso-lines on which a face is judged.
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
      const Way way{from.Value(u, v), to.Value(u, v)};
      if (way.from.Distance(way.to) > least_mm && inside.Perform(gp_Pnt2d(u, v)) != TopAbs_OUT)
        ways.push_back(way);
    }
  return ways;
}

/// Another face, as it was and as it is.
class Other {
 public:
  Other(const TopoDS_Face& before, const TopoDS_Face& after)
      : surfaces_{BRepAdaptor_Surface(before), BRepAdaptor_Surface(after)} {
    BRepBndLib::Add(before, box_, false);
    BRepBndLib::Add(after, box_, false);
    const bool moved = !after.IsPartner(before);
    crossers_.push_back(
        std::make_unique<IntCurvesFace_Intersector>(before, Precision::Confusion()));
    if (moved)
      crossers_.push_back(
          std::make_unique<IntCurvesFace_Intersector>(after, Precision::Confusion()));
  }

  bool isPassed(const Way& way) {
    if (box_.IsOut(way.box())) return false;
    const gp_Vec along(way.from, way.to);
    return std::ranges::any_of(crossers_, [&](const auto& crosser) {
      crosser->Perform(gp_Lin(way.from, gp_Dir(along)), 0, along.Magnitude());
      if (!crosser->IsDone()) return false;
      for (int k = 1; k <= crosser->NbPnt(); ++k) {
        const double u = crosser->UParameter(k), v = crosser->VParameter(k);
        if (side(surfaces_[0], u, v, way.from) * side(surfaces_[1], u, v, way.to) < 0) return true;
      }
      return false;
    });
  }

 private:
  static double side(const BRepAdaptor_Surface& surface, double u, double v, const gp_Pnt& point) {
    gp_Pnt on;
    gp_Vec du, dv;
    surface.D1(u, v, on, du, dv);
    return gp_Vec(on, point).Dot(du.Crossed(dv));
  }

  std::array<BRepAdaptor_Surface, 2> surfaces_;
  Bnd_Box box_;
  std::vector<std::unique_ptr<IntCurvesFace_Intersector>> crossers_;
};

}  // namespace

PassedFaces::PassedFaces(const TopoDS_Shape& before, std::set<std::pair<int, int>> beside_seams,
                         double touch_mm)
    : beside_seams_(std::move(beside_seams)), touch_mm_(touch_mm) {
  TopExp::MapShapes(before, TopAbs_FACE, faces_);
  TopExp::MapShapesAndUniqueAncestors(before, TopAbs_VERTEX, TopAbs_FACE, faces_of_vertex_);
}

std::map<int, int> PassedFaces::in(const TopoDS_Shape& after, const std::set<int>& moved) {
  TopTools_IndexedMapOfShape now;
  TopExp::MapShapes(after, TopAbs_FACE, now);
  std::vector<Bnd_Box> boxes(static_cast<std::size_t>(faces_.Extent()) + 1);
  for (int face = 1; face <= faces_.Extent(); ++face) {
    BRepBndLib::Add(faces_(face), boxes[face], false);
    BRepBndLib::Add(now(face), boxes[face], false);
  }
  std::map<int, int> passed;
  std::map<int, Other> others;
  for (const int face : moved) try {
      const std::vector<Way> ways =
          waysOf(TopoDS::Face(faces_(face)), TopoDS::Face(now(face)), touch_mm_);
      if (ways.empty()) continue;
      Bnd_Box all;
      for (const Way& way : ways) all.Add(way.box());
      const std::set<int> around = facesAround(face);
      for (int other = 1; other <= faces_.Extent() && passed.count(face) == 0; ++other) {
        if (boxes[other].IsOut(all) || around.count(other) > 0) continue;
        Other& there =
            others.try_emplace(other, TopoDS::Face(faces_(other)), TopoDS::Face(now(other)))
                .first->second;
        const bool passes =
            std::ranges::any_of(ways, [&](const Way& way) { return there.isPassed(way); });
        if (passes && !touched(face, other)) passed[face] = other;
      }
    } catch (const Standard_Failure&) {
      // If OpenCASCADE can't decide, that is no reason to leave a seam unrepaired.
      continue;
    }
  return passed;
}

/// The face itself and all faces that share a vertex or a seam with it.
std::set<int> PassedFaces::facesAround(int face) const {
  std::set<int> around = {face};
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(faces_(face), TopAbs_VERTEX, vertices);
  for (int vertex = 1; vertex <= vertices.Extent(); ++vertex)
    for (const TopoDS_Shape& other : faces_of_vertex_.FindFromKey(vertices(vertex)))
      around.insert(faces_.FindIndex(other));
  for (const auto& [a, b] : beside_seams_)
    if (a == face || b == face) around.insert({a, b});
  return around;
}

bool PassedFaces::touched(int face, int other) {
  const auto [known, is_new] = touched_.try_emplace(std::minmax(face, other), false);
  if (is_new) {
    const BRepExtrema_DistShapeShape distance(faces_(face), faces_(other));
    known->second = distance.IsDone() && distance.Value() <= touch_mm_;
  }
  return known->second;
}

}  // namespace seamwright::occ
