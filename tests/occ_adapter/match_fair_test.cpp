// SPDX-License-Identifier: LGPL-2.1-or-later
// How a face moves that has to meet its neighbour: as the profile of least energy, and without
// gaps to its other neighbours.
#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <cmath>

#include "match_pairs.hpp"

#include <seamwright/occ_adapter/match/match_sides.hpp>

namespace seamwright::test {
namespace {

using occ::matchSides;
using occ::SideMatchOptions;
using occ::SideMatchReport;

TopoDS_Face polygonFace(const std::vector<gp_Pnt>& points) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& point : points) wire.Add(point);
  wire.Close();
  return BRepBuilderAPI_MakeFace(wire.Wire(), true);
}

/// A level plate, x < 0, and one that rises behind it, both 40 mm wide. \param walls vertical faces
/// at both sides of the second one.
TopoDS_Shape kinkedPlates(double length_mm, double rise, bool walls) {
  constexpr double width_mm = 40, deep_mm = -20;
  const double top_mm = rise * length_mm;
  BRepBuilderAPI_Sewing sewing(1e-6);
  sewing.Add(polygonFace({{-30, 0, 0}, {0, 0, 0}, {0, width_mm, 0}, {-30, width_mm, 0}}));
  sewing.Add(polygonFace(
      {{0, 0, 0}, {length_mm, 0, top_mm}, {length_mm, width_mm, top_mm}, {0, width_mm, 0}}));
  for (const double y : {0.0, width_mm})
    if (walls)
      sewing.Add(polygonFace(
          {{0, y, 0}, {length_mm, y, top_mm}, {length_mm, y, deep_mm}, {0, y, deep_mm}}));
  sewing.Perform();
  return sewing.SewedShape();
}

/// The number of the face that contains a point.
int faceAt(const TopoDS_Shape& shape, const gp_Pnt& point) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for (int number = 1; number <= faces.Extent(); ++number) {
    const gp_Pln plane = BRepAdaptor_Surface(TopoDS::Face(faces(number))).Plane();
    if (plane.Distance(point) < 1e-6) return number;
  }
  return 0;
}

SideMatchReport matchedPlates(const TopoDS_Shape& plates, double length_mm, double rise,
                              std::optional<double> depth_mm) {
  SideMatchOptions options;
  options.convert = true;
  options.depth_mm = depth_mm;
  options.fairness = 3;  // so that a narrow change is fair too
  return matchSides(plates, faceAt(plates, {length_mm / 2, 20, rise * length_mm / 2}),
                    {{.side = {{edgeNear(plates, {0, 20, 0})}}, .order = 1}}, options);
}

// R1: the largest move is 4 angle depth / 27, at a third of the depth.
TEST(MatchFair, TheMoveIsTheProfileOfLeastEnergy) {
  for (const double rise : {0.004, 0.02, 0.06})
    for (const double depth_mm : {15.0, 30.0, 60.0}) {
      constexpr double length_mm = 80;
      const TopoDS_Shape plates = kinkedPlates(length_mm, rise, false);
      const SideMatchReport report = matchedPlates(plates, length_mm, rise, depth_mm);
      ASSERT_TRUE(report.matched) << rise << " " << depth_mm << ": " << report.text();
      ASSERT_EQ(report.moves.size(), 1u);
      const double angle_rad = std::atan(rise), expected_mm = 4 * angle_rad * report.depth_mm / 27;
      EXPECT_NEAR(report.moves.front().surface->normal_move_mm, expected_mm, 0.1 * expected_mm)
          << rise << " " << depth_mm;
    }
}

// With fewer points of integration in a span than the degree, waves would seem not to bend, and the
// face would be refused as less fair.
TEST(MatchFair, FacesOfHighDegreeGetNoWaves) {
  constexpr double length_mm = 80, width_mm = 40, rise = 0.02, depth_mm = 40;
  for (const int degree : {3, 5, 8}) {
    TColgp_Array2OfPnt poles(1, degree + 1, 1, 6);
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; j <= 5; ++j)
        poles(i + 1, j + 1) =
            gp_Pnt(length_mm * i / degree, width_mm * j / 5, rise * length_mm * i / degree);
    BRepBuilderAPI_Sewing sewing(1e-6);
    sewing.Add(polygonFace({{-30, 0, 0}, {0, 0, 0}, {0, width_mm, 0}, {-30, width_mm, 0}}));
    sewing.Add(wholeFace(splineOf(poles, degree, 5)));
    sewing.Perform();
    const TopoDS_Shape plates = sewing.SewedShape();
    const int plane = BRepAdaptor_Surface(face(plates, 1)).GetType() == GeomAbs_Plane ? 1 : 2;
    SideMatchOptions options;
    options.depth_mm = depth_mm;
    const SideMatchReport report = matchSides(
        plates, 3 - plane, {{.side = {{edgeNear(plates, {0, 20, 0})}}, .order = 1}}, options);
    EXPECT_TRUE(report.matched) << degree << ": " << report.text();
  }
}

// Without the walls' edges sliding they would be 4 angle depth / 27 = 0.09 mm and more away.
TEST(MatchFair, EdgesSlideOnWallsThatStay) {
  for (const double rise : {0.02, 0.06, 0.12}) {
    constexpr double length_mm = 60;
    const TopoDS_Shape plates = kinkedPlates(length_mm, rise, true);
    const SideMatchReport report = matchedPlates(plates, length_mm, rise, 30.0);
    ASSERT_TRUE(report.matched) << rise << ": " << report.text();
    EXPECT_GT(report.moves.front().surface->normal_move_mm, 0.8 * 4 * rise * report.depth_mm / 27);
    TopTools_IndexedMapOfShape faces, edges;
    TopExp::MapShapes(report.shape, TopAbs_FACE, faces);
    TopExp::MapShapes(report.shape, TopAbs_EDGE, edges);
    int planes = 0;
    for (int i = 1; i <= faces.Extent(); ++i)
      if (!handle<Geom_Plane>::DownCast(BRep_Tool::Surface(TopoDS::Face(faces(i)))).IsNull())
        ++planes;
    EXPECT_EQ(planes, 3) << "the walls and the neighbour stay planes";
    for (int i = 1; i <= edges.Extent(); ++i)
      EXPECT_LE(BRep_Tool::Tolerance(TopoDS::Edge(edges(i))), ContinuityTolerance{}.gap_mm);
    expectTolerancesHold(report.shape);
  }
}

}  // namespace
}  // namespace seamwright::test
