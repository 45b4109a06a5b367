// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <filesystem>
#include <numbers>

#include "dense_oracle.hpp"
#include "files.hpp"
#include "grids.hpp"
#include "repair_checks.hpp"
#include "shapes.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/repair/repair.hpp>

/// What kept repairs of models from succeeding, each cause alone.
namespace seamwright::test {
namespace {

using occ::RepairOptions;
using occ::RepairReport;
using opencascade::handle;

constexpr double pi = std::numbers::pi;

/// A spline through points of the path over the same range, each moved by \p aside across it and \p
/// ahead along it, which vanish at both ends.
handle<Geom2d_Curve> strayed(const handle<Geom2d_Curve>& path, double first, double last,
                             double aside, double ahead) {
  constexpr int points = 33;
  const handle<TColgp_HArray1OfPnt2d> through = new TColgp_HArray1OfPnt2d(1, points);
  const handle<TColStd_HArray1OfReal> parameters = new TColStd_HArray1OfReal(1, points);
  for (int k = 0; k < points; ++k) {
    const double share = static_cast<double>(k) / (points - 1), t = first + (last - first) * share;
    gp_Pnt2d p;
    gp_Vec2d d;
    path->D1(t, p, d);
    d.Normalize();
    const double wave = k == 0 || k == points - 1 ? 0 : std::sin(2 * pi * share);
    p.Translate(wave * (ahead * d + aside * gp_Vec2d(-d.Y(), d.X())));
    through->SetValue(k + 1, p);
    parameters->SetValue(k + 1, t);
  }
  Geom2dAPI_Interpolate interpolation(through, parameters, false, 1e-9);
  interpolation.Perform();
  return handle<Geom2d_Curve>(interpolation.Curve());
}

/// Its path on one of its faces led astray. \param edge from 1.
void leadAstray(const TopoDS_Shape& shape, int edge, double aside, double ahead) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  const TopoDS_Edge changed = TopoDS::Edge(faces.FindKey(edge));
  const TopoDS_Face face = TopoDS::Face(faces(edge).First());
  double first = 0, last = 0;
  const handle<Geom2d_Curve> path = BRep_Tool::CurveOnSurface(changed, face, first, last);
  BRep_Builder().UpdateEdge(changed, strayed(path, first, last, aside, ahead), face, 0.3);
}

/// The shape as splines, with an edge that strays.
TopoDS_Shape withStrayPath(const TopoDS_Shape& shape, int edge, double aside, double ahead) {
  TopoDS_Shape splines = BRepBuilderAPI_NurbsConvert(shape, true).Shape();
  leadAstray(splines, edge, aside, ahead);
  return splines;
}

const occ::SeamRepair& seamOf(const RepairReport& report, int edge) {
  return *std::ranges::find(report.seams, edge,
                            [](const occ::SeamRepair& seam) { return seam.before.edges[0]; });
}

/// By plain evaluation.
double gap_mm(const TopoDS_Shape& shape, const occ::SeamRepair& seam) {
  const auto sides = denseSides(shape, seam.after.edges[0], seam.after.faces);
  return sides ? denseMaxima(*sides, 1001, {}).gap_mm.value : 1;
}

void expectNewPath(const TopoDS_Shape& shape, int edge) {
  const RepairReport report = repairedModel(shape, {});
  const occ::SeamRepair& seam = seamOf(report, edge);
  EXPECT_EQ(seam.before.verdict.seam_class, SeamClass::Defect);
  EXPECT_TRUE(seam.repaired) << seam.reason.text;
  EXPECT_TRUE(report.after.passed());
  EXPECT_TRUE(report.moves.empty());
  ASSERT_EQ(report.edge_moves.size(), 1);
  EXPECT_EQ(report.edge_moves[0].edge, edge);
  EXPECT_GT(gap_mm(shape, seam), 0.02);
  EXPECT_LT(gap_mm(report.model.shape, seam), 0.0025);
}

TEST(RepairCauses, SharpEdgesWithAStrayPathStaySharpAndMeet) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(20, 30, 40).Shape();
  for (const int edge : {1, 4, 7, 12})
    for (const double aside : {0.05, -0.2}) {
      SCOPED_TRACE("edge " + std::to_string(edge) + ", " + std::to_string(aside) + " mm aside");
      const TopoDS_Shape shape = withStrayPath(box, edge, aside, 0.05);
      expectNewPath(shape, edge);
      const RepairReport report = repairedModel(shape, {});
      EXPECT_EQ(seamOf(report, edge).after.verdict.seam_class, SeamClass::Crease);
      std::mt19937 random(testSeed());
      expectNewPath(transformed(shape, randomMotion(random)), edge);
    }
}

TEST(RepairCauses, EdgesBetweenFacesWithoutPolesGetNewPathsToo) {
  for (const int edge : {1, 4, 7, 12}) {
    SCOPED_TRACE("edge " + std::to_string(edge));
    const TopoDS_Shape planes = BRepPrimAPI_MakeBox(20, 30, 40).Shape();
    leadAstray(planes, edge, 0.1, 0.05);
    expectNewPath(planes, edge);
  }
  // The circle between a cylinder and its lid.
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(10, 20).Shape();
  leadAstray(cylinder, 1, 0.1, 0);
  expectNewPath(cylinder, 1);
}

TEST(RepairCauses, AnEdgeThatRunsAtTwoSpeedsGetsANewPath) {
  // Both paths are the same line in space: only their speed differs.
  const TopoDS_Shape shape = withStrayPath(BRepPrimAPI_MakeBox(20, 30, 40).Shape(), 3, 0, 0.1);
  expectNewPath(shape, 3);
  EXPECT_LT(repairedModel(shape, {}).edge_moves.at(0).largest_move_mm, 1e-6);
  RepairOptions near;
  near.max_move_mm = 0.001;
  EXPECT_TRUE(seamOf(repairedModel(shape, near), 3).repaired);
}

TEST(RepairCauses, NoEdgeMovesFurtherThanItStrayed) {
  TopoDS_Shape box = BRepPrimAPI_MakeBox(20, 30, 40).Shape();
  leadAstray(box, 1, 0.1, 0);
  const RepairReport report = repairedModel(box, {});
  ASSERT_EQ(report.edge_moves.size(), 1);
  EXPECT_LT(report.edge_moves[0].largest_move_mm, 0.101);
  EXPECT_GT(report.edge_moves[0].largest_move_mm, 0.09);
}

TEST(RepairCauses, NoEdgeIsLedFurtherThanAllowedOrOnAFixedFace) {
  const TopoDS_Shape shape = withStrayPath(BRepPrimAPI_MakeBox(20, 30, 40).Shape(), 1, 0.2, 0);
  RepairOptions near;
  near.max_move_mm = 0.01;
  RepairOptions fixed;
  fixed.fixed_faces = {1, 2, 3, 4, 5, 6};
  for (const RepairOptions& options : {near, fixed}) {
    const RepairReport report = repairedModel(shape, options);
    EXPECT_TRUE(report.model.shape.IsEqual(shape));
    EXPECT_FALSE(seamOf(report, 1).repaired);
    EXPECT_FALSE(seamOf(report, 1).reason.empty());
  }
}

struct OcctModel {
  const char* name;
  int treated, most_left;
};

class RepairOfModels : public testing::TestWithParam<OcctModel> {};

TEST_P(RepairOfModels, LeavesFewDefects) {
  const RepairReport report = repair(occ::readModel(occtModel(GetParam().name)));
  EXPECT_EQ(std::ranges::count(report.seams, true, &occ::SeamRepair::treated), GetParam().treated);
  const auto isLeft = [](const occ::SeamRepair& seam) { return seam.treated && !seam.repaired; };
  EXPECT_LE(std::ranges::count_if(report.seams, isLeft), GetParam().most_left) << reasonsOf(report);
}

// Faces with poles and flat ones; edges of which the paths alone are apart.
INSTANTIATE_TEST_SUITE_P(Occt, RepairOfModels,
                         testing::Values(OcctModel{"occ/hammer.brep", 38, 3},
                                         OcctModel{"occ/CrankArm.brep", 4, 0}));

/// Part of a cylinder of radius 20 about the x axis, x from x0 to x0 + 10: through its points at
/// every degree of 30, with degree 1 or 3.
handle<Geom_BSplineSurface> barrelStave(double x0_mm, int degree) {
  constexpr int points = 31;
  constexpr double radius_mm = 20, length_mm = 10, step_rad = std::numbers::pi / 180;
  TColgp_Array1OfPnt row(1, points);
  for (int k = 0; k < points; ++k)
    row(k + 1) =
        gp_Pnt(x0_mm, radius_mm * std::sin(k * step_rad), radius_mm * std::cos(k * step_rad));
  const opencascade::handle<Geom_BSplineCurve> curve =
      degree == 1 ? GeomAPI_PointsToBSpline(row, 1, 1, GeomAbs_C0, 1e-9).Curve()
                  : GeomAPI_PointsToBSpline(row, 3, 3, GeomAbs_C2, 1e-6).Curve();
  TColgp_Array2OfPnt poles(1, 2, 1, curve->NbPoles());
  for (int j = 1; j <= curve->NbPoles(); ++j) {
    poles(1, j) = curve->Pole(j);
    poles(2, j) = curve->Pole(j).Translated(gp_Vec(length_mm, 0, 0));
  }
  TColStd_Array1OfReal ends(1, 2);
  ends(1) = 0;
  ends(2) = 1;
  TColStd_Array1OfInteger twice(1, 2);
  twice.Init(2);
  return new Geom_BSplineSurface(poles, ends, curve->Knots(), twice, curve->Multiplicities(), 1,
                                 curve->Degree());
}

/// Facets of one degree beside a smooth surface: half a degree is wrong everywhere, and the gap is
/// a thousandth of a millimetre.
TEST(RepairCauses, KinksOfASurfaceAreToldAndLeft) {
  const RepairReport report =
      repairedModel(gridOf({{barrelStave(0, 1)}, {barrelStave(10, 3)}}), {});
  ASSERT_EQ(report.seams.size(), 1);
  EXPECT_FALSE(report.seams[0].treated);
  EXPECT_THAT(report.seams[0].reason.text,
              testing::AllOf(testing::HasSubstr("the surface of face 1 has a kink of 1"),
                             testing::HasSubstr("no smooth move takes that out")));
  EXPECT_FALSE(report.changed());
}

}  // namespace
}  // namespace seamwright::test
