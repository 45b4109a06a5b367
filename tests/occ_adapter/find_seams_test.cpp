// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>
#include <set>

#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::findSeams;
using occ::SeamGraph;
using occ::SeamKind;

/// Two boxes that share the face between them.
TopoDS_Shape gluedBoxes() {
  TopTools_ListOfShape arguments;
  arguments.Append(BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  arguments.Append(BRepPrimAPI_MakeBox(gp_Pnt(1, 0, 0), 1, 1, 1).Shape());
  BRepAlgoAPI_BuilderAlgo glue;
  glue.SetArguments(arguments);
  glue.Build();
  return glue.Shape();
}

TEST(FindSeams, AFaceAloneHasOpenEdges) {
  const SeamGraph graph = findSeams(BRepBuilderAPI_MakeFace(gp_Pln(), 0, 1, 0, 1).Shape());
  EXPECT_TRUE(graph.seams.empty());
  ASSERT_EQ(graph.open.size(), 4u);
  for (const occ::NonSeamEdge& edge : graph.open) EXPECT_EQ(edge.faces, std::vector<int>{1});
}

TEST(FindSeams, ABoxWithoutItsLid) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), TopAbs_FACE, faces);
  std::vector<TopoDS_Shape> five;
  for (int i = 1; i <= 5; ++i) five.push_back(faces(i));
  const SeamGraph graph = findSeams(compoundOf(five));
  EXPECT_EQ(graph.seams.size(), 8u);
  EXPECT_EQ(graph.open.size(), 4u);
  EXPECT_TRUE(graph.non_manifold.empty());
}

TEST(FindSeams, AFaceSharedByTwoSolidsCountsOnceAndItsEdgesAreNonManifold) {
  const TopoDS_Shape glued = gluedBoxes();
  ASSERT_EQ(occ::modelFromShape(glued).faceCount(), 11);
  const SeamGraph graph = findSeams(glued);
  EXPECT_EQ(graph.seams.size(), 16u);
  EXPECT_TRUE(graph.open.empty());
  ASSERT_EQ(graph.non_manifold.size(), 4u);
  for (const occ::NonSeamEdge& edge : graph.non_manifold)
    EXPECT_EQ(std::set<int>(edge.faces.begin(), edge.faces.end()).size(), 3u);
}

TEST(FindSeams, TwoInstancesOfAPartCountTwiceTheSameInstanceOnce) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  std::mt19937 random(testSeed());
  const TopoDS_Shape two = compoundOf({box, located(box, randomMotion(random))});
  EXPECT_EQ(occ::modelFromShape(two).faceCount(), 12);
  EXPECT_EQ(findSeams(two).seams.size(), 24u);
  EXPECT_EQ(findSeams(compoundOf({box, box})).seams.size(), 12u);
}

TEST(FindSeams, DegeneratedEdgesAreNeitherSeamsNorOpen) {
  const SeamGraph graph = findSeams(BRepPrimAPI_MakeSphere(3).Shape());
  ASSERT_EQ(graph.seams.size(), 1u);
  EXPECT_EQ(graph.seams[0].kind, SeamKind::Closed);
  EXPECT_EQ(graph.seams[0].sides[0].face, graph.seams[0].sides[1].face);
  EXPECT_NE(graph.seams[0].sides[0].edge.Orientation(), graph.seams[0].sides[1].edge.Orientation());
  EXPECT_TRUE(graph.open.empty());
}

TEST(FindSeams, EdgesInsideAFaceAreNoSeams) {
  for (const TopAbs_Orientation orientation : {TopAbs_INTERNAL, TopAbs_EXTERNAL}) {
    TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4);
    BRep_Builder builder;
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(gp_Pnt(1, 1, 0), gp_Pnt(3, 2, 0));
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    builder.Add(wire, edge.Oriented(orientation));
    builder.Add(face, wire);
    const SeamGraph graph = findSeams(face);
    EXPECT_TRUE(graph.seams.empty());
    EXPECT_EQ(graph.open.size(), 4u);
    EXPECT_TRUE(graph.non_manifold.empty());
  }
}

TEST(FindSeams, FreeEdgesAndVerticesAreIgnored) {
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(gp_Pnt(1, 1, 9), gp_Pnt(3, 2, 9));
  const SeamGraph graph = findSeams(compoundOf({edge, BRepPrimAPI_MakeBox(1, 1, 1).Shape()}));
  EXPECT_EQ(graph.seams.size(), 12u);
  EXPECT_TRUE(graph.open.empty());
}

TopoDS_Shape plateWithHole() {
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10, 10, 2).Shape(),
                         BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5, 5, -1), gp::DZ()), 2, 5).Shape())
      .Shape();
}

TEST(FindSeams, NumbersAreThoseOfTheMapsOfTheShape) {
  const TopoDS_Shape shape = plateWithHole();
  TopTools_IndexedMapOfShape faces, edges;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  TopTools_IndexedDataMapOfShapeListOfShape ancestors;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, ancestors);
  const SeamGraph graph = findSeams(shape);
  ASSERT_EQ(static_cast<int>(graph.seams.size()), edges.Extent());
  for (std::size_t i = 0; i < graph.seams.size(); ++i) {
    const occ::Seam& seam = graph.seams[i];
    EXPECT_EQ(seam.id, static_cast<int>(i) + 1);
    EXPECT_TRUE(i == 0 || graph.seams[i - 1].edges < seam.edges);
    std::multiset<int> expected, found = {seam.sides[0].face, seam.sides[1].face};
    for (const TopoDS_Shape& face : ancestors.FindFromKey(edges(seam.edges.front())))
      expected.insert(faces.FindIndex(face));
    EXPECT_EQ(found, expected);
    for (const occ::Coedge& side : seam.sides)
      EXPECT_TRUE(side.edge.IsSame(edges(seam.edges.front())));
  }
}

TEST(FindSeams, TheFaceLiesToTheLeftOfItsEdge) {
  for (const TopoDS_Shape& shape : {plateWithHole(), plateWithHole().Reversed(), gluedBoxes()})
    for (const occ::Seam& seam : findSeams(shape).seams)
      for (const occ::Coedge& side : seam.sides) {
        EXPECT_EQ(side.shape.Orientation(), TopAbs_FORWARD);
        double first = 0, last = 0;
        const auto path = BRep_Tool::CurveOnSurface(side.edge, side.shape, first, last);
        gp_Pnt2d at;
        gp_Vec2d along;
        path->D1(0.4 * first + 0.6 * last, at, along);
        if (side.edge.Orientation() == TopAbs_REVERSED) along.Reverse();
        const gp_Vec2d left = 1e-3 * gp_Vec2d(-along.Y(), along.X()).Normalized();
        BRepClass_FaceClassifier classifier(side.shape, at.Translated(left), 1e-9);
        EXPECT_EQ(classifier.State(), TopAbs_IN);
      }
}

}  // namespace
}  // namespace seamwright::test
