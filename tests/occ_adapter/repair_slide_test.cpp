// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges slide on planes that stay, where the face beside them moves.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "repair_checks.hpp"
#include "shapes.hpp"

namespace seamwright::test {
namespace {

using occ::RepairOptions;
using occ::RepairReport;

constexpr double length_mm = 20, degree = std::numbers::pi / 180;

TopoDS_Face planar(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const gp_Pnt& corner : corners) polygon.Add(corner);
  polygon.Close();
  return BRepBuilderAPI_MakeFace(polygon.Wire(), true).Face();
}

/// The top of a block: a plane, and a spline that falls from it at an angle; around the spline
/// three walls. Faces: plane, spline, walls.
TopoDS_Shape block(double angle_rad) {
  const double low_mm = -length_mm * std::tan(angle_rad), depth_mm = -10;
  TColgp_Array2OfPnt poles(1, 2, 1, 2);
  for (const int i : {0, 1})
    for (const int j : {0, 1})
      poles(i + 1, j + 1) = gp_Pnt(length_mm * i, length_mm * j, low_mm * i);
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = 0;
  knots(2) = 1;
  TColStd_Array1OfInteger multiplicities(1, 2);
  multiplicities.Init(2);
  const opencascade::handle<Geom_BSplineSurface> spline =
      new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, 1, 1);
  BRepBuilderAPI_Sewing sewing(1e-6);
  sewing.Add(
      planar({{-length_mm, 0, 0}, {0, 0, 0}, {0, length_mm, 0}, {-length_mm, length_mm, 0}}));
  sewing.Add(BRepBuilderAPI_MakeFace(spline, Precision::Confusion()).Face());
  for (const double y : {0.0, length_mm})
    sewing.Add(
        planar({{0, y, 0}, {length_mm, y, low_mm}, {length_mm, y, depth_mm}, {0, y, depth_mm}}));
  sewing.Add(planar({{length_mm, 0, low_mm},
                     {length_mm, length_mm, low_mm},
                     {length_mm, length_mm, depth_mm},
                     {length_mm, 0, depth_mm}}));
  sewing.Perform();
  return sewing.SewedShape();
}

bool isPlane(const TopoDS_Face& face) {
  return !opencascade::handle<Geom_Plane>::DownCast(BRep_Tool::Surface(face)).IsNull();
}

std::vector<int> planesOf(const TopoDS_Shape& shape) {
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE);
  std::vector<int> planes;
  for (int f = 1; f <= faces.Extent(); ++f)
    if (isPlane(TopoDS::Face(faces(f)))) planes.push_back(f);
  return planes;
}

/// By OpenCASCADE: the largest distance of an edge's curve from its image on a face.
double largestDistance_mm(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  constexpr int samples = 200;
  double first = 0, last = 0;
  const auto curve = BRep_Tool::Curve(edge, first, last);
  const auto path = BRep_Tool::CurveOnSurface(edge, face, first, last);
  const auto surface = BRep_Tool::Surface(face);
  double largest_mm = 0;
  for (int k = 0; k <= samples; ++k) {
    const double t = first + (last - first) * k / samples;
    const gp_Pnt2d uv = path->Value(t);
    largest_mm = std::max(largest_mm, curve->Value(t).Distance(surface->Value(uv.X(), uv.Y())));
  }
  return largest_mm;
}

TEST(RepairSlide, EdgesFollowTheFaceThatMoves) {
  for (const double angle_deg : {1.0, -0.6}) {
    SCOPED_TRACE(angle_deg);
    const TopoDS_Shape shape = block(angle_deg * degree);
    const RepairReport report = repairedModel(shape, {});
    EXPECT_EQ(repairedSeams(report), 1) << reasonsOf(report);
    ASSERT_EQ(report.moves.size(), 1);
    // The least bending: 4/27 of angle and length.
    const double expected_mm = 4.0 / 27 * std::abs(angle_deg) * degree * length_mm;
    EXPECT_GT(report.moves[0].surface->move_mm.lower, 0.5 * expected_mm);
    EXPECT_LT(report.moves[0].largest_move_mm, 2 * expected_mm);
    // Along both walls at its sides, further than the gap tolerance.
    ASSERT_GE(report.edge_moves.size(), 2);
    int far = 0;
    for (const occ::EdgeMove& move : report.edge_moves) far += move.largest_move_mm > 0.01 ? 1 : 0;
    EXPECT_GE(far, 2);
    TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
    TopExp::MapShapesAndAncestors(report.model.shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
    for (int e = 1; e <= faces_of_edge.Extent(); ++e)
      for (const TopoDS_Shape& face : faces_of_edge(e))
        EXPECT_LT(largestDistance_mm(TopoDS::Edge(faces_of_edge.FindKey(e)), TopoDS::Face(face)),
                  0.006);
  }
}

TEST(RepairSlide, PlanesStay) {
  const TopoDS_Shape shape = block(degree);
  const RepairReport report = repairedModel(shape, {});
  EXPECT_EQ(repairedSeams(report), 1) << reasonsOf(report);
  EXPECT_FALSE(report.edge_moves.empty());
  const TopoDS_Shape after = report.model.shape;
  const TopTools_IndexedMapOfShape before_faces = partsOf(shape, TopAbs_FACE),
                                   faces = partsOf(after, TopAbs_FACE);
  const std::vector<int> planes = planesOf(shape);
  ASSERT_EQ(planes.size(), 4);
  for (const int f : planes)
    EXPECT_EQ(BRep_Tool::Surface(TopoDS::Face(faces(f))),
              BRep_Tool::Surface(TopoDS::Face(before_faces(f))));
}

TEST(RepairSlide, NotOnFacesThatAreFixed) {
  const TopoDS_Shape shape = block(degree);
  RepairOptions options;
  options.fixed_faces = planesOf(shape);
  const RepairReport report = repairedModel(shape, options);
  EXPECT_EQ(repairedSeams(report), 0);
  EXPECT_TRUE(report.edge_moves.empty());
  EXPECT_FALSE(reasonsOf(report).empty());
}

TEST(RepairSlide, SmallAnglesMoveEdgesByLessThanTheGapTolerance) {
  const RepairReport report = repairedModel(block(0.12 * degree), {});
  EXPECT_EQ(repairedSeams(report), 1) << reasonsOf(report);
  for (const occ::EdgeMove& move : report.edge_moves) EXPECT_LT(move.largest_move_mm, 0.01);
}

}  // namespace
}  // namespace seamwright::test
