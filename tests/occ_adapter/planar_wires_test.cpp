// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <numbers>

#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/occ_adapter/planar/planar_wires.hpp>

#include "files.hpp"

namespace seamwright::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using occ::PlanarWire;
using std::numbers::pi;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TopoDS_Wire rectangle(double x, double y, double dx, double dy) {
  BRepBuilderAPI_MakePolygon polygon(gp_Pnt(x, y, 0), gp_Pnt(x + dx, y, 0),
                                     gp_Pnt(x + dx, y + dy, 0), gp_Pnt(x, y + dy, 0), true);
  return polygon.Wire();
}

TopoDS_Wire loopOf(const TopoDS_Edge& edge) {
  return TopoDS::Wire(BRepBuilderAPI_MakeWire(edge).Wire().Reversed());
}

/// A rectangle with a round and an elliptic hole, somewhere in space.
TopoDS_Shape plateWithHoles() {
  const gp_Ax2 at(gp_Pnt(20, 20, 0), gp::DZ()), beside(gp_Pnt(60, 20, 0), gp::DZ());
  BRepBuilderAPI_MakeFace face(gp_Pln(gp::XOY()), rectangle(0, 0, 100, 40));
  face.Add(loopOf(BRepBuilderAPI_MakeEdge(gp_Circ(at, 8))));
  face.Add(loopOf(BRepBuilderAPI_MakeEdge(gp_Elips(beside, 9, 5))));
  gp_Trsf move;
  move.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 2, 2)), 0.7);
  return BRepBuilderAPI_Transform(face.Face(), move).Shape();
}

/// The largest distance of samples of a chain, placed in its plane, from a shape.
double distanceFrom(const PlanarWire& wire, const TopoDS_Shape& shape) {
  double distance = 0;
  for (const ChainCurve& curve : wire.chain.curves)
    for (const BezierCurve& segment : bezierCurves(curve))
      for (int i = 0; i <= 8; ++i) {
        const Vector3d p = wire.frame.point(segment.point(i / 8.0).head<2>());
        const TopoDS_Shape vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), p.z()));
        distance = std::max(distance, BRepExtrema_DistShapeShape(vertex, shape).Value());
      }
  return distance;
}

TopoDS_Shape edgesOf(const TopoDS_Shape& shape, const std::vector<int>& numbers) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, TopAbs_EDGE, map);
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const int number : numbers) builder.Add(compound, map(number));
  return compound;
}

TEST(PlanarWires, Identity1AFaceWithHolesHasALoopForEach) {
  const TopoDS_Shape plate = plateWithHoles();
  const std::vector<PlanarWire> wires = occ::planarWires(plate);
  ASSERT_THAT(wires, SizeIs(3));
  for (const PlanarWire& wire : wires) {
    EXPECT_TRUE(wire.chain.closed);
    EXPECT_LT(wire.height_mm, 1e-12);
    EXPECT_LT(wire.gap_mm, 1e-12);
    EXPECT_LT(distanceFrom(wire, edgesOf(plate, wire.edges)), 1e-9);
    EXPECT_EQ(wire.frame.origin, wires.front().frame.origin);
    EXPECT_EQ(wire.frame.x, wires.front().frame.x);
  }
  EXPECT_THAT(wires[0].edges, SizeIs(4));
  EXPECT_NEAR(figuresOf(wires[0].chain).length_mm, 280, 1e-10);
  EXPECT_NEAR(figuresOf(wires[1].chain).length_mm, 16 * pi, 1e-10);
  EXPECT_EQ(figuresOf(wires[2].chain).extrema, 4);
}

TEST(PlanarWires, Identity2WiresComeBack) {
  const std::vector<PlanarWire> wires = occ::planarWires(plateWithHoles());
  const TopoDS_Shape made = occ::wiresOf(wires);
  EXPECT_TRUE(BRepCheck_Analyzer(made).IsValid());
  const std::vector<PlanarWire> back = occ::planarWires(made);
  ASSERT_THAT(back, SizeIs(3));
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_TRUE(back[i].chain.closed);
    EXPECT_EQ(back[i].chain.curves.size(), wires[i].chain.curves.size());
    EXPECT_NEAR(figuresOf(back[i].chain).length_mm, figuresOf(wires[i].chain).length_mm, 1e-10);
    EXPECT_LT(distanceFrom(back[i], made), 1e-9);
    EXPECT_LT(distanceFrom(wires[i], made), 1e-9);
  }
}

TEST(PlanarWires, AllVerticesOfALoopAreShared) {
  const TopoDS_Wire wire = occ::wireOf(occ::planarWires(plateWithHoles())[0].chain, PlaneFrame());
  TopTools_IndexedMapOfShape vertices, edges;
  TopExp::MapShapes(wire, TopAbs_VERTEX, vertices);
  TopExp::MapShapes(wire, TopAbs_EDGE, edges);
  EXPECT_EQ(vertices.Extent(), 4);
  EXPECT_EQ(edges.Extent(), 4);
  EXPECT_TRUE(wire.Closed());
}

TEST(PlanarWires, EdgesAreRunEndToEnd) {
  // Single edges in any order and direction, without common vertices.
  const std::array<gp_Pnt, 4> at = {gp_Pnt(0, 0, 5), gp_Pnt(4, 0, 5), gp_Pnt(4, 3, 5),
                                    gp_Pnt(-1, 3, 5)};
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  builder.Add(compound, BRepBuilderAPI_MakeEdge(at[2], at[1]).Edge());
  builder.Add(compound, BRepBuilderAPI_MakeEdge(at[0], at[1]).Edge());
  builder.Add(compound, BRepBuilderAPI_MakeEdge(at[2], at[3]).Edge());
  const std::vector<PlanarWire> wires = occ::planarWires(compound);
  ASSERT_THAT(wires, SizeIs(1));
  EXPECT_FALSE(wires[0].chain.closed);
  EXPECT_EQ(wires[0].frame.origin, Vector3d(0, 0, 5));
  EXPECT_LT(wires[0].gap_mm, 1e-14);
  const std::vector<int>& order = wires[0].edges;
  EXPECT_TRUE(order == std::vector<int>({2, 1, 3}) || order == std::vector<int>({3, 1, 2}));
}

TEST(PlanarWires, ChainsEndWhereMoreThanTwoMeet) {
  TopoDS_Compound star;
  const BRep_Builder builder;
  builder.MakeCompound(star);
  for (const gp_Pnt& end : {gp_Pnt(1, 0, 0), gp_Pnt(0, 1, 0), gp_Pnt(-1, -1, 0)})
    builder.Add(star, BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), end).Edge());
  EXPECT_THAT(occ::planarWires(star), SizeIs(3));
}

TEST(PlanarWires, OnlyFreeEdgesUnlessNamed) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape(),
                     cylinder = BRepPrimAPI_MakeCylinder(2, 5).Shape();
  EXPECT_THAT(occ::planarWires(box), IsEmpty());
  EXPECT_THAT(occ::planarWires(cylinder), IsEmpty());
  EXPECT_THAT(occ::planarWires(box, {.chains = {.edges = {}, .each_alone = true}}), SizeIs(12));
  const std::vector<PlanarWire> one = occ::planarWires(box, {.chains = {.edges = {3}}});
  ASSERT_THAT(one, SizeIs(1));
  EXPECT_THAT(one[0].edges, ElementsAre(3));
  EXPECT_THROW(occ::planarWires(box, {.chains = {.edges = {13}}}), std::invalid_argument);
}

TEST(PlanarWires, RefusesCurvesOutOfPlane) {
  TColgp_Array1OfPnt poles(1, 4);
  poles(1) = gp_Pnt(0, 0, 0);
  poles(2) = gp_Pnt(1, 1, 0);
  poles(3) = gp_Pnt(2, 0, 1);
  poles(4) = gp_Pnt(3, 1, 0);
  const TopoDS_Edge edge =
      BRepBuilderAPI_MakeEdge(opencascade::handle<Geom_Curve>(new Geom_BezierCurve(poles)));
  try {
    occ::planarWires(edge);
    FAIL();
  } catch (const occ::GeometryError& error) {
    EXPECT_THAT(error.what(), HasSubstr("Edge1: not planar: 0."));
    EXPECT_THAT(error.what(), HasSubstr("mm from the nearest plane, more than 0.001 mm"));
  }
  EXPECT_THAT(occ::planarWires(edge, {.flatness_mm = 1}), SizeIs(1));
}

TEST(PlanarWires, FilesOfCurvesAreReadAndWritten) {
  const Folder folder;
  for (const char* name : {"curves.step", "curves.igs", "curves.brep", "curves.bin"}) {
    occ::Model model;
    model.shape = occ::wiresOf(occ::planarWires(plateWithHoles()));
    model.length_unit = "mm (assumed)";
    occ::writeModel(model, folder / name);
    EXPECT_THROW(occ::readModel(folder / name), occ::ModelError) << name;
    const occ::Model read = occ::readModel(folder / name, {}, occ::Needed::Edges);
    const std::vector<PlanarWire> wires = occ::planarWires(read.shape);
    ASSERT_THAT(wires, SizeIs(3)) << name;
    double length_mm = 0;
    for (const PlanarWire& wire : wires) {
      EXPECT_TRUE(wire.chain.closed) << name;
      length_mm += figuresOf(wire.chain).length_mm;
    }
    const double ellipse_mm = figuresOf(occ::planarWires(plateWithHoles())[2].chain).length_mm;
    EXPECT_NEAR(length_mm, 280 + 16 * pi + ellipse_mm, 1e-9) << name;
  }
}

}  // namespace
}  // namespace seamwright::test
