// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "match_pairs.hpp"
#include "repair_checks.hpp"
#include "repair_trials.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::modelFromShape;
using occ::repair;
using occ::RepairReport;

Net brokenSheet(int columns, double noise_mm = 0.01) {
  NetShape shape;
  shape.columns = columns;
  shape.rows = 1;
  shape.bend = 0.1;
  shape.overhang = 0.5;
  std::mt19937 random(testSeed(1));
  Net net = piecesOfOne(shape, random);
  disturb(net, noise_mm, random);
  return net;
}

/// Fixed quadrature takes a cylinder of splines for a percent larger than it is, until knots are
/// inserted.
TEST(RepairDegenerate, VolumesOfRationalFaces) {
  const TopoDS_Shape solid =
      BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeCylinder(20, 50).Shape(), true).Shape();
  std::mt19937 random(testSeed());
  std::uniform_real_distribution<double> noise(-0.2, 0.2);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(solid, TopAbs_FACE, faces);
  for (int f = 1; f <= faces.Extent(); ++f) {
    const auto surface = opencascade::handle<Geom_BSplineSurface>::DownCast(
        BRep_Tool::Surface(TopoDS::Face(faces(f))));
    if (!surface->IsUPeriodic()) continue;
    surface->IncreaseDegree(surface->UDegree(), 3);
    for (int i = 1; i <= surface->NbUPoles(); ++i)
      for (const int j : {2, 3}) {
        const gp_Vec move(noise(random), noise(random), noise(random));
        surface->SetPole(i, j, surface->Pole(i, j).Translated(move));
      }
  }
  occ::RepairOptions options;
  options.max_move_mm = 5;
  const RepairReport report = repair(modelFromShape(solid), options);
  EXPECT_EQ(treated(report), 1);
  EXPECT_EQ(repairedSeams(report), 1) << reasonsOf(report);
}

TEST(RepairDegenerate, FacesWithAPole) {
  for (const int sectors : {3, 4, 5})
    for (const double noise_mm : {0.001, 0.01}) {
      SCOPED_TRACE(std::to_string(sectors) + " sectors, noise " + std::to_string(noise_mm) + " mm");
      // Not testSeed(): of other seeds poles move 30.1 times the noise (1158842253, 5 sectors).
      std::mt19937 random(20311);
      Net net = dome(sectors, 50);
      EXPECT_EQ(countsOf(repairedModel(shapeOf(net), trialOptions({})), 1).treated, 0);
      disturb(net, noise_mm, random);
      // The top stays one point.
      for (const NetFace& face : net.faces)
        for (int i = 1; i <= face.surface->NbUPoles(); ++i)
          face.surface->SetPole(i, face.surface->NbVPoles(), net.vertices[0]);
      const RepairReport report = repairedModel(shapeOf(net), trialOptions({}));
      EXPECT_EQ(report.seams.size(), static_cast<std::size_t>(sectors));
      EXPECT_EQ(treated(report), sectors);
      EXPECT_EQ(repairedSeams(report), sectors) << reasonsOf(report);
      EXPECT_LE(largestMove_mm(report), 30 * noise_mm);
    }
}

/// Each pole of all surfaces moved; weights stay.
TopoDS_Shape convertedAndBroken(const TopoDS_Shape& solid, double noise_mm) {
  std::mt19937 generator(testSeed(2));
  const TopoDS_Shape shape = BRepBuilderAPI_NurbsConvert(solid, true).Shape();
  for (int f = 1; f <= partsOf(shape, TopAbs_FACE).Extent(); ++f) {
    const auto surface = Spline::DownCast(BRep_Tool::Surface(face(shape, f)));
    if (surface.IsNull()) continue;
    for (int i = 1; i <= surface->NbUPoles(); ++i)
      for (int j = 1; j <= surface->NbVPoles(); ++j)
        surface->SetPole(i, j,
                         surface->Pole(i, j).Translated(gp_Vec(random(generator, noise_mm),
                                                               random(generator, noise_mm),
                                                               random(generator, noise_mm))));
  }
  return withTolerance(shape, 3 * noise_mm);
}

TEST(RepairDegenerate, AFaceThatMeetsItself) {
  // Of the sphere the poles are torn apart, and the one seam between them folds there. The torus
  // has sharp knot lines, which noise bends: the kink of a seam that crosses them has corners, and
  // a smooth displacement can't follow these to a hundredth of a degree.
  const std::vector<std::pair<TopoDS_Shape, int>> solids = {
      {BRepPrimAPI_MakeSphere(20).Shape(), 0},
      {BRepPrimAPI_MakeTorus(30, 10).Shape(), 1},
      {BRepPrimAPI_MakeCylinder(20, 30).Shape(), 3}};
  for (const auto& [solid, expected] : solids)
    for (const double noise_mm : {0.0, 0.01}) {
      const TopoDS_Shape shape = convertedAndBroken(solid, noise_mm);
      occ::RepairOptions options = trialOptions({});
      const RepairReport report = repair(modelFromShape(shape), options);
      EXPECT_GE(repairedSeams(report), noise_mm == 0 ? 0 : expected) << reasonsOf(report);
      if (noise_mm == 0 || expected == 0) {
        EXPECT_EQ(treated(report), 0);
      }
      if (noise_mm == 0) {
        EXPECT_FALSE(report.changed());
        EXPECT_TRUE(report.model.shape.IsEqual(shape));
      } else if (expected == 0) {
        EXPECT_NE(reasonsOf(report).find("fold back"), std::string::npos) << reasonsOf(report);
      }
      const occ::Report again = analyzed(report.model.shape);
      EXPECT_EQ(again.seams.size(), report.seams.size());
    }
}

TEST(RepairDegenerate, AnEdgeWithoutLength) {
  // Between the two faces and the rim at the end of their seam.
  Net net = brokenSheet(2);
  const std::vector<NetSide>& first = net.faces[0].sides;
  const auto side = std::ranges::find_if(first, [&net](const NetSide& own) {
    return std::ranges::any_of(net.faces[1].sides,
                               [&own](const NetSide& other) { return own.edge == other.edge; });
  });
  const int shared = side->edge, end = net.edges[shared].ends[1];
  const auto extra = static_cast<int>(net.edges.size()),
             twin = static_cast<int>(net.vertices.size());
  const gp_Pnt point = net.vertices[end];
  net.vertices.push_back(point);
  for (std::size_t e = 0; e < net.edges.size(); ++e)
    for (int& vertex : net.edges[e].ends)
      if (static_cast<int>(e) != shared && vertex == end) vertex = twin;
  constexpr double length_mm = 1e-9;
  TColgp_Array1OfPnt ends(1, 2);
  ends(1) = point;
  ends(2) = point.Translated(gp_Vec(length_mm, 0, 0));
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = 0;
  knots(2) = 1;
  TColStd_Array1OfInteger times(1, 2);
  times.Init(2);
  net.edges.push_back(
      {{end, twin}, handle<Geom_Curve>(new Geom_BSplineCurve(ends, knots, times, 1))});
  for (NetFace& face : net.faces) {
    const auto at = std::ranges::find(face.sides, shared, &NetSide::edge);
    const gp_Pnt2d uv = at->path->Value(1);
    TColgp_Array1OfPnt2d still(1, 2);
    still.Init(uv);
    const bool reversed = at->reversed;
    face.sides.insert(
        reversed ? at : at + 1,
        {extra, reversed, handle<Geom2d_Curve>(new Geom2d_BSplineCurve(still, knots, times, 1))});
  }
  const RepairReport report = repair(modelFromShape(shapeOf(net)), trialOptions({}));
  EXPECT_EQ(treated(report), 2);
  EXPECT_EQ(repairedSeams(report), 2) << reasonsOf(report);
  EXPECT_LE(largestMove_mm(report), 0.02);
}

TEST(RepairDegenerate, ASeamWithoutPathIsLeft) {
  const Net net = brokenSheet(2);
  const TopoDS_Shape shape = shapeOf(net);
  const RepairReport whole = repair(modelFromShape(shape), trialOptions({}));
  ASSERT_EQ(whole.seams.size(), 1);
  EXPECT_TRUE(whole.seams[0].repaired);
  const TopoDS_Shape broken = shapeOf(net);
  const TopoDS_Edge edge =
      TopoDS::Edge(partsOf(broken, TopAbs_EDGE)(whole.seams[0].before.edges[0]));
  BRep_Builder().UpdateEdge(edge, handle<Geom2d_Curve>(), face(broken, 1), 0.1);
  const RepairReport report = repair(modelFromShape(broken), trialOptions({}));
  ASSERT_EQ(report.seams.size(), 1);
  EXPECT_TRUE(report.seams[0].repaired) << reasonsOf(report);
  EXPECT_LE(upper(report.seams[0].after.figures.angle_rad), 0.01 * degree);
  EXPECT_NEAR(largestMove_mm(report), largestMove_mm(whole), 1e-3);
}

TEST(RepairDegenerate, AnEdgeOfThreeFaces) {
  Net net = brokenSheet(3);
  // A fourth face on the edges of the first.
  NetFace copy = net.faces[0];
  copy.surface = Spline::DownCast(copy.surface->Copy());
  net.faces.push_back(copy);
  const TopoDS_Shape shape = shapeOf(net);
  const RepairReport report = repair(modelFromShape(shape), trialOptions({}));
  EXPECT_FALSE(report.before.non_manifold.empty());
  EXPECT_EQ(report.before.non_manifold.size(), report.after.non_manifold.size());
  // Between the faces that have that edge and the one that has not.
  EXPECT_EQ(treated(report), 1);
  EXPECT_EQ(repairedSeams(report), 1) << reasonsOf(report);
  ASSERT_EQ(report.moves.size(), 1);
  EXPECT_EQ(report.moves[0].face, 3);
}

TEST(RepairDegenerate, PolesThatAreNoNumbers) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Net net = brokenSheet(3);
    const TopoDS_Shape shape = shapeOf(net);
    Geom_BSplineSurface& last = *net.faces[2].surface;
    for (int i = 1; i <= last.NbUPoles(); ++i) last.SetPole(i, 2, gp_Pnt(bad, 0, 0));
    const occ::Model model = modelFromShape(shape);
    const RepairReport report = repair(model, trialOptions({}));
    ASSERT_EQ(report.seams.size(), 2);
    EXPECT_TRUE(report.seams[0].treated);
    EXPECT_TRUE(report.seams[0].repaired) << report.seams[0].reason.text;
    EXPECT_FALSE(report.seams[1].treated);
    EXPECT_NE(
        report.seams[1].reason.text.find("not measured: face 3 has a surface with the number"),
        std::string::npos)
        << report.seams[1].reason.text;
    // Nothing is known of the edge between faces 2 and 3, so that neither moves.
    ASSERT_EQ(report.moves.size(), 1);
    EXPECT_EQ(report.moves[0].face, 1);
    ASSERT_EQ(report.before.model.notes.size(), 1);
    EXPECT_NE(report.before.model.notes[0].find("1 face holds numbers that are not finite"),
              std::string::npos);
    EXPECT_TRUE(partsOf(report.model.shape, TopAbs_FACE)(3).IsSame(partsOf(shape, TopAbs_FACE)(3)));

    occ::RepairOptions held = trialOptions({});
    held.fixed_faces = {1};
    const RepairReport left = repair(model, held);
    EXPECT_FALSE(left.seams[0].treated);
    EXPECT_NE(left.seams[0].reason.text.find(
                  "in common with face 3, which has a surface with the number"),
              std::string::npos)
        << left.seams[0].reason.text;
    EXPECT_FALSE(left.changed());
  }
}

TEST(RepairDegenerate, OptionsThatAreNoNumbers) {
  const occ::Model model = modelFromShape(shapeOf(brokenSheet(2)));
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), -1.0})
    for (void (*const set)(occ::RepairOptions&, double) : {
             +[](occ::RepairOptions&options, double value) { options.max_move_mm = value; },
             +[](occ::RepairOptions&options, double value) { options.match_mm = value; },
             +[](occ::RepairOptions&options, double value) { options.tolerance.gap_mm = value; },
             +[](occ::RepairOptions&options, double value) { options.tolerance.angle_rad = value; },
             +[](occ::RepairOptions&options, double value) {
               options.tolerance.curvature_rel = value;
             },
             +[](occ::RepairOptions&options, double value) {
               options.tolerance.crease_rad = value;
             },
             +[](occ::RepairOptions&options, double value) {
               options.tolerance.flat_radius_mm = value;
             },
         }) {
      occ::RepairOptions options;
      set(options, bad);
      EXPECT_THROW(repair(model, options), std::invalid_argument);
    }
}

}  // namespace
}  // namespace seamwright::test
