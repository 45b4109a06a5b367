// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_OffsetCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Circ.hxx>
#include <numbers>

#include <seamwright/occ_adapter/curves/space_spline.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/model/write.hpp>

#include "files.hpp"

namespace seamwright::test {
namespace {

using occ::SpaceSpline;
using opencascade::handle;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

handle<Geom_BezierCurve> bezier(const std::vector<gp_Pnt>& poles) {
  TColgp_Array1OfPnt array(1, static_cast<int>(poles.size()));
  std::ranges::copy(poles, array.begin());
  return new Geom_BezierCurve(array);
}

TopoDS_Compound compoundOf(const std::vector<TopoDS_Shape>& shapes) {
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
  return compound;
}

/// A line, a quarter circle and a cubic of space end to end, the cubic against its direction.
TopoDS_Compound lineArcAndCubic() {
  const gp_Circ circle(gp_Ax2(gp_Pnt(4, 2, 0), gp::DZ(), gp_Dir(0, -1, 0)), 2);
  return compoundOf({BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(4, 0, 0)).Shape(),
                     BRepBuilderAPI_MakeEdge(circle, 0, std::numbers::pi / 2).Shape(),
                     BRepBuilderAPI_MakeEdge(bezier({gp_Pnt(5, 9, 4), gp_Pnt(5, 7, 4),
                                                     gp_Pnt(6, 5, 2), gp_Pnt(6, 2, 0)}))
                         .Shape()});
}

/// The largest distance of samples of the spline from the shape.
double distanceFrom(const BezierSpline& spline, const TopoDS_Shape& shape) {
  double distance = 0;
  for (int i = 0; i < spline.segments(); ++i)
    for (int k = 0; k <= 8; ++k) {
      const Eigen::Vector3d p = segment(spline, i).point(k / 8.0);
      const TopoDS_Shape vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), p.z()));
      distance = std::max(distance, BRepExtrema_DistShapeShape(vertex, shape).Value());
    }
  return distance;
}

/// A C1 spline of cubics with a corner between the second and the third.
BezierSpline splineWithCorner() {
  Poles a(4, 3), b(4, 3), c(4, 3);
  a << 0, 0, 0, 1, 1, 0, 2, 2, 1, 3, 2, 1;
  b << 3, 2, 1, 5, 2, 1, 6, 1, 2, 7, 0, 2;
  c << 7, 0, 2, 7, -1, 3, 6, -2, 3, 5, -2, 3;
  return bezierSpline({BezierCurve(a), BezierCurve(b), BezierCurve(c)}, {0, 1, 2, 3});
}

TEST(SpaceSplines, Identity1PointsAreThoseOfTheEdges) {
  const TopoDS_Compound edges = lineArcAndCubic();
  const std::vector<SpaceSpline> splines = occ::spaceSplines(edges);
  ASSERT_THAT(splines, SizeIs(1));
  EXPECT_THAT(splines[0].edges, ElementsAre(1, 2, 3));
  EXPECT_FALSE(splines[0].spline.closed);
  EXPECT_LT(splines[0].gap_mm, 1e-14);
  EXPECT_EQ(splines[0].spline.degree, 3);
  EXPECT_LT(distanceFrom(splines[0].spline, edges), 1e-12);
  const int segments = splines[0].spline.segments();
  EXPECT_LT((segment(splines[0].spline, segments - 1).point(1) - Eigen::Vector3d(5, 9, 4)).norm(),
            1e-14);
}

TEST(SpaceSplines, Identity1ACircleIsClosed) {
  const TopoDS_Shape circle = BRepBuilderAPI_MakeEdge(gp_Circ(gp::XOY(), 3));
  const std::vector<SpaceSpline> splines = occ::spaceSplines(circle);
  ASSERT_THAT(splines, SizeIs(1));
  EXPECT_TRUE(splines[0].spline.closed);
  for (int i = 0; i < splines[0].spline.segments(); ++i)
    for (const double t : {0.0, 0.3, 0.9})
      EXPECT_NEAR(segment(splines[0].spline, i).point(t).norm(), 3, 1e-14);
}

TEST(SpaceSplines, Identity2AWireComesBack) {
  const BezierSpline spline = splineWithCorner();
  const TopoDS_Wire wire = occ::wireOf(spline);
  EXPECT_TRUE(BRepCheck_Analyzer(wire).IsValid());
  const std::vector<SpaceSpline> back = occ::spaceSplines(wire);
  ASSERT_THAT(back, SizeIs(1));
  EXPECT_EQ(back[0].spline.segments(), 3);
  EXPECT_LT((back[0].spline.poles - spline.poles).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(SpaceSplines, SmoothSegmentsAreOneEdgeAndACornerIsAVertex) {
  const TopoDS_Wire wire = occ::wireOf(splineWithCorner());
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(wire, TopAbs_EDGE, edges);
  ASSERT_EQ(edges.Extent(), 2);
  double first = 0, last = 0;
  const auto curve =
      handle<Geom_BSplineCurve>::DownCast(BRep_Tool::Curve(TopoDS::Edge(edges(1)), first, last));
  ASSERT_FALSE(curve.IsNull());
  EXPECT_TRUE(curve->IsCN(1));
}

TEST(SpaceSplines, FilesHoldWiresInTheirOrder) {
  const Folder folder;
  std::vector<BezierSpline> splines;
  for (const double z : {5.0, -1.0, 3.0}) {
    splines.push_back(splineWithCorner());
    splines.back().poles.col(2).setConstant(z);
  }
  for (const char* name : {"wires.step", "wires.brep", "wires.bin"}) {
    occ::Model model;
    model.shape = occ::wiresOf(splines);
    model.length_unit = "mm";
    occ::writeModel(model, folder / name);
    const occ::Model read = occ::readModel(folder / name, {}, occ::Needed::Edges);
    std::vector<double> heights;
    for (TopExp_Explorer wire(read.shape, TopAbs_WIRE); wire.More(); wire.Next()) {
      TopTools_IndexedMapOfShape edges, vertices;
      TopExp::MapShapes(wire.Current(), TopAbs_EDGE, edges);
      TopExp::MapShapes(wire.Current(), TopAbs_VERTEX, vertices);
      EXPECT_EQ(edges.Extent(), 2) << name;
      EXPECT_EQ(vertices.Extent(), 3) << name;
      heights.push_back(BRep_Tool::Pnt(TopoDS::Vertex(vertices(1))).Z());
    }
    EXPECT_THAT(heights,
                testing::ElementsAre(testing::DoubleNear(5, 1e-12), testing::DoubleNear(-1, 1e-12),
                                     testing::DoubleNear(3, 1e-12)))
        << name;
    EXPECT_FALSE(TopExp_Explorer(read.shape, TopAbs_EDGE, TopAbs_WIRE).More()) << name;
  }
}

TEST(SpaceSplines, AnOffsetCurveIsRefusedByItsName) {
  const handle<Geom_Curve> base =
      bezier({gp_Pnt(0, 0, 0), gp_Pnt(1, 2, 0), gp_Pnt(3, 2, 0), gp_Pnt(4, 0, 0)});
  const TopoDS_Shape edge =
      BRepBuilderAPI_MakeEdge(new Geom_OffsetCurve(base, 0.1, gp::DZ())).Shape();
  try {
    occ::spaceSplines(edge);
    FAIL() << "accepted";
  } catch (const occ::GeometryError& error) {
    EXPECT_THAT(error.what(), HasSubstr("Edge1: Geom_OffsetCurve"));
  }
}

}  // namespace
}  // namespace seamwright::test
