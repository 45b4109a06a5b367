// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <set>

#include "files.hpp"
#include "match_pairs.hpp"
#include "repair_checks.hpp"
#include "repair_trials.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/model/write.hpp>

namespace seamwright::test {
namespace {

/// All numbers of the model's geometry.
std::vector<double> numbersOf(const TopoDS_Shape& shape) {
  std::vector<double> numbers;
  const auto add = [&numbers](const gp_Pnt& point) {
    for (int c = 1; c <= 3; ++c) numbers.push_back(point.Coord(c));
  };
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE),
                                   edges = partsOf(shape, TopAbs_EDGE),
                                   vertices = partsOf(shape, TopAbs_VERTEX);
  for (int f = 1; f <= faces.Extent(); ++f) {
    const auto surface = Spline::DownCast(BRep_Tool::Surface(TopoDS::Face(faces(f))));
    if (surface.IsNull()) continue;
    for (int i = 1; i <= surface->NbUPoles(); ++i)
      for (int j = 1; j <= surface->NbVPoles(); ++j) {
        add(surface->Pole(i, j));
        numbers.push_back(surface->Weight(i, j));
      }
    for (const double knot : surface->UKnotSequence()) numbers.push_back(knot);
    for (const double knot : surface->VKnotSequence()) numbers.push_back(knot);
  }
  for (int e = 1; e <= edges.Extent(); ++e) {
    double first = 0, last = 0;
    const handle<Geom_Curve> curve = BRep_Tool::Curve(TopoDS::Edge(edges(e)), first, last);
    numbers.push_back(first);
    numbers.push_back(last);
    const auto spline = handle<Geom_BSplineCurve>::DownCast(curve);
    for (int i = 1; !spline.IsNull() && i <= spline->NbPoles(); ++i) add(spline->Pole(i));
  }
  for (int v = 1; v <= vertices.Extent(); ++v) add(BRep_Tool::Pnt(TopoDS::Vertex(vertices(v))));
  return numbers;
}

std::set<const void*> surfacesOf(const TopoDS_Shape& shape) {
  std::set<const void*> surfaces;
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE);
  for (int f = 1; f <= faces.Extent(); ++f)
    surfaces.insert(BRep_Tool::Surface(TopoDS::Face(faces(f))).get());
  return surfaces;
}

TEST(RepairShare, AModelWithoutDefectsComesBackItself) {
  for (const NetKind& kind : netKinds())
    for (const int order : {1, 2}) {
      SCOPED_TRACE(kind.name);
      const RepairTrial trial{kind.name, 0, 3, order};
      const TopoDS_Shape shape = brokenModel(trial);
      const occ::RepairReport report = repairedModel(shape, trialOptions(trial));
      EXPECT_TRUE(report.model.shape.IsEqual(shape));
      EXPECT_FALSE(report.changed());
      EXPECT_EQ(surfacesOf(report.model.shape), surfacesOf(shape));
    }
}

TEST(RepairShare, AndIsWrittenNumberByNumber) {
  const Folder folder;
  for (const std::string name : {"blob 6", "trimmed bricks", "ring"})
    for (const std::string ending : {".step", ".bin", ".brep"}) {
      SCOPED_TRACE(name + ending);
      const TopoDS_Shape shape = brokenModel({name, 0});
      occ::writeModel(occ::modelFromShape(shape), folder / (name + ending), {.overwrite = true});
      const occ::Model model = occ::readModel(folder / (name + ending));
      const occ::RepairReport report = repair(model);
      EXPECT_FALSE(report.changed());
      occ::writeModel(report.model, folder / (name + "_after" + ending), {.overwrite = true});
      const std::vector<double> before = numbersOf(model.shape);
      EXPECT_GT(before.size(), 1000);
      EXPECT_EQ(numbersOf(occ::readModel(folder / (name + "_after" + ending)).shape), before);
    }
}

TEST(RepairShare, FacesFarFromADefectAreShared) {
  std::mt19937 random(testSeed());
  Net net = netKind("trimmed bricks").make(random);
  Net broken = net;
  for (NetFace& face : broken.faces) face.surface = Spline::DownCast(face.surface->Copy());
  disturb(broken, 0.01, random);
  // Only the first face keeps its noise.
  for (std::size_t f = 1; f < net.faces.size(); ++f) broken.faces[f] = net.faces[f];
  const TopoDS_Shape shape = shapeOf(broken);
  const occ::RepairReport report = repairedModel(shape, trialOptions({}));
  EXPECT_GT(repairedSeams(report), 0);
  EXPECT_EQ(repairedSeams(report), treated(report)) << reasonsOf(report);
  const std::set<const void*> before = surfacesOf(shape);
  int shared = 0;
  for (const void* surface : surfacesOf(report.model.shape))
    shared += before.count(surface) > 0 ? 1 : 0;
  EXPECT_EQ(shared, static_cast<int>(before.size() - report.moves.size()));
  EXPECT_GT(shared, 0);
}

}  // namespace
}  // namespace seamwright::test
