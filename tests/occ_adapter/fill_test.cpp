// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces taken out of solids and sheets, and what fills the holes. What is expected is known of the
// shapes; angles along new edges are measured by OpenCASCADE's evaluation at many points, not by
// the analysis that the fill used.
#include <gmock/gmock.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <gp_Pln.hxx>
#include <numbers>
#include <set>

#include "files.hpp"
#include "fill_checks.hpp"
#include "shapes.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/fill/fill.hpp>

namespace seamwright::test {
namespace {

using occ::FillHoleOptions;
using occ::FillHoleReport;
using occ::Hole;
using occ::modelFromShape;
using occ::replaceFace;
using testing::HasSubstr;

double volume_mm3(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

/// A box of 40 by 30 by 20 with its edges at the origin rounded; the last of its faces are the
/// three fillets and the corner.
TopoDS_Shape suitcase(const std::array<double, 3>& radii) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(40, 30, 20).Shape();
  const TopTools_IndexedMapOfShape edges = partsOf(box, TopAbs_EDGE);
  BRepFilletAPI_MakeFillet fillet(box);
  std::size_t k = 0;
  for (int e = 1; e <= edges.Extent(); ++e)
    for (TopExp_Explorer vertex(edges(e), TopAbs_VERTEX); vertex.More(); vertex.Next())
      if (BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current())).Distance(gp_Pnt()) < 1e-9)
        fillet.Add(radii.at(k++), TopoDS::Edge(edges(e)));
  fillet.Build();
  return fillet.Shape();
}

/// The face whose centre of mass is nearest to a point.
int faceNear(const TopoDS_Shape& shape, const gp_Pnt& point) {
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE);
  int nearest = 0;
  double least = HUGE_VAL;
  for (int face = 1; face <= faces.Extent(); ++face) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(faces(face), properties);
    const double distance = properties.CentreOfMass().Distance(point);
    if (distance < least) least = distance, nearest = face;
  }
  return nearest;
}

int cornerFace(const TopoDS_Shape& suitcase) {
  return faceNear(suitcase, gp_Pnt());
}

/// z = 0.02 x^2 - 0.01 x y + 0.004 y^3 - 0.003 x^2 y over [x, x + 3] by [y, y + 3], exactly.
double heightAt(double x, double y) {
  return 0.02 * x * x - 0.01 * x * y + 0.004 * y * y * y - 0.003 * x * x * y;
}

/// Polar form of the monomial t^power in degree 3 at a, a or b, ... : k arguments are b.
double polar(int power, int k, double a, double b) {
  std::array<double, 3> at = {a, a, a};
  for (int i = 0; i < k; ++i) at[i] = b;
  switch (power) {
    case 0:
      return 1;
    case 1:
      return (at[0] + at[1] + at[2]) / 3;
    case 2:
      return (at[0] * at[1] + at[1] * at[2] + at[0] * at[2]) / 3;
    default:
      return at[0] * at[1] * at[2];
  }
}

opencascade::handle<Geom_BezierSurface> graphPatch(double x, double y) {
  constexpr double size = 3;
  TColgp_Array2OfPnt poles(1, 4, 1, 4);
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; j <= 3; ++j) {
      const auto px = [&](int power) { return polar(power, i, x, x + size); };
      const auto py = [&](int power) { return polar(power, j, y, y + size); };
      poles(i + 1, j + 1) =
          gp_Pnt(px(1), py(1),
                 0.02 * px(2) - 0.01 * px(1) * py(1) + 0.004 * py(3) - 0.003 * px(2) * py(1));
    }
  return new Geom_BezierSurface(poles);
}

/// Nine patches of that graph, sewn.
TopoDS_Shape sheet() {
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      sewing.Add(BRepBuilderAPI_MakeFace(graphPatch(3 * i - 4.5, 3 * j - 4.5), 1e-7).Face());
  sewing.Perform();
  return sewing.SewedShape();
}

TEST(FindHoles, ABoxWithoutAFaceHasOneOfFourSides) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(40, 30, 20).Shape();
  const occ::Holes found = occ::findHoles(without(box, {1}));
  ASSERT_EQ(found.holes.size(), 1U);
  const Hole& hole = found.holes.front();
  EXPECT_TRUE(hole.has_corners);
  EXPECT_TRUE(hole.longest);
  EXPECT_NEAR(hole.length_mm, 2 * (30 + 20), 1e-9);
  std::vector<double> lengths;
  for (const occ::HoleSide& side : hole.sides) lengths.push_back(side.length_mm);
  EXPECT_THAT(lengths, testing::UnorderedElementsAre(
                           testing::DoubleNear(30, 1e-9), testing::DoubleNear(30, 1e-9),
                           testing::DoubleNear(20, 1e-9), testing::DoubleNear(20, 1e-9)));
  EXPECT_THAT(found.notes, testing::IsEmpty());
  EXPECT_THAT(occ::findHoles(box).holes, testing::IsEmpty());
}

TEST(FindHoles, OpposedFacesMakeTwo) {
  EXPECT_EQ(occ::findHoles(without(BRepPrimAPI_MakeBox(40, 30, 20).Shape(), {1, 2})).holes.size(),
            2U);
}

TEST(FindHoles, RimsOfACylinderAreSmooth) {
  TopoDS_Shape tube = BRepPrimAPI_MakeCylinder(5, 10).Shape();
  tube = without(tube, {2, 3});
  const occ::Holes found = occ::findHoles(tube);
  ASSERT_EQ(found.holes.size(), 2U);
  for (const Hole& hole : found.holes) {
    EXPECT_FALSE(hole.has_corners);
    EXPECT_NEAR(hole.length_mm, 10 * std::numbers::pi, 1e-6);
  }
}

TEST(FindHoles, ThreeFacesAroundAVertexLeaveOne) {
  const occ::Holes found =
      occ::findHoles(without(BRepPrimAPI_MakeBox(10, 10, 10).Shape(), {1, 3, 5}));
  ASSERT_EQ(found.holes.size(), 1U);
  EXPECT_EQ(found.holes.front().sides.size(), 6U);
  EXPECT_NEAR(found.holes.front().length_mm, 60, 1e-9);
}

TEST(FindHoles, RefusesBadOptions) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  EXPECT_THROW(occ::findHoles(box, {.corner_rad = 0}), std::invalid_argument);
  EXPECT_THROW(occ::findHoles(box, {.corner_rad = 4}), std::invalid_argument);
  EXPECT_THROW(occ::findHoles(box, {.gap_mm = std::nan("")}), std::invalid_argument);
}

TEST(Fill, OfACubeIsFlatAndHasPositionAlone) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(40, 30, 20).Shape();
  for (int face = 1; face <= 6; ++face) {
    const FillHoleReport refused = replaceFace(modelFromShape(box), face);
    EXPECT_FALSE(refused.filled);
    EXPECT_THAT(textOf(refused.reason), HasSubstr("90 degrees"));
    EXPECT_TRUE(refused.model.shape.IsSame(box));
    EXPECT_TRUE(std::ranges::all_of(
        refused.sides, [](const occ::FilledSide& side) { return side.position_only; }));

    const FillHoleReport filled = replaceFace(modelFromShape(box), face, {.target = Level::G0});
    ASSERT_TRUE(filled.filled) << textOf(filled.reason);
    EXPECT_EQ(filled.model.shape.ShapeType(), TopAbs_SOLID);
    EXPECT_NEAR(volume_mm3(filled.model.shape), 40 * 30 * 20, 1e-6);
    EXPECT_EQ(filled.faces.size(), 1U);
    EXPECT_TRUE(BRepCheck_Analyzer(filled.model.shape).IsValid());

    const FillHoleReport patches =
        replaceFace(modelFromShape(box), face, {.target = Level::G0, .continue_surface = false});
    ASSERT_TRUE(patches.filled) << textOf(patches.reason);
    EXPECT_NEAR(volume_mm3(patches.model.shape), 40 * 30 * 20, 1e-6);
    EXPECT_EQ(patches.faces.size(), 4U);
  }
}

TEST(Fill, OfASuitcaseCornerIsNearlyTheSphere) {
  const TopoDS_Shape shape = suitcase({5, 5, 5});
  const FillHoleReport report = replaceFace(modelFromShape(shape), cornerFace(shape));
  ASSERT_TRUE(report.filled) << textOf(report.reason);
  EXPECT_TRUE(report.reached);
  ASSERT_EQ(report.faces.size(), 3U);
  EXPECT_EQ(report.inner.size(), 3U);
  EXPECT_EQ(report.outer.size(), 6U);
  EXPECT_EQ(partsOf(report.model.shape, TopAbs_SOLID).Extent(), 1);
  EXPECT_TRUE(BRepCheck_Analyzer(report.model.shape).IsValid());
  // Sections of three edges of 35, 25 and 15 mm, and what the octant of a ball leaves of a cube;
  // the fill stays inside.
  const double quarter_mm2 = (1 - std::numbers::pi / 4) * 25;
  const double closed_mm3 =
      40 * 30 * 20 - quarter_mm2 * (35 + 25 + 15) - (1 - std::numbers::pi / 6) * 125;
  EXPECT_NEAR(volume_mm3(report.model.shape), closed_mm3 - 1.1, 1.1);
  const double angle = largestAngle_rad(report.model.shape, report.faces);
  EXPECT_LT(angle, 0.001 * degree);
  ASSERT_TRUE(report.largestAngle_rad().has_value());
  EXPECT_LE(angle, *report.largestAngle_rad() * 1.0001);
  for (const int face : report.faces) {
    const BRepAdaptor_Surface surface(TopoDS::Face(partsOf(report.model.shape, TopAbs_FACE)(face)));
    for (int i = 0; i <= 10; ++i)
      for (int j = 0; j <= 10; ++j)
        EXPECT_NEAR(surface.Value(i / 10.0, j / 10.0).Distance(gp_Pnt(5, 5, 5)), 5, 0.2);
  }
}

TEST(Fill, OfACornerOfThreeRadiiIsSmooth) {
  const TopoDS_Shape shape = suitcase({3, 5, 7});
  const FillHoleReport report = replaceFace(modelFromShape(shape), cornerFace(shape));
  ASSERT_TRUE(report.filled) << textOf(report.reason);
  EXPECT_EQ(report.faces.size(), 4U);
  EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), 0.01 * degree);
  EXPECT_NEAR(volume_mm3(report.model.shape), volume_mm3(shape), 1.8);
}

/// A right triangle with legs of 8 and 6, extruded by 5: both ends are two instances of one face.
TopoDS_Shape prism() {
  BRepBuilderAPI_MakePolygon triangle(gp_Pnt(0, 0, 0), gp_Pnt(8, 0, 0), gp_Pnt(0, 6, 0), true);
  TopoDS_Shape shape =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(triangle.Wire()).Shape(), gp_Vec(0, 0, 5))
          .Shape();
  gp_Trsf turn, shift;
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0.5)), 0.7);
  shift.SetTranslation(gp_Vec(10, -20, 30));
  return shape.Moved(shift * turn);
}

constexpr double prism_mm3 = 120;

TEST(Fill, OfEachFaceOfAPrismClosesIt) {
  const TopoDS_Shape shape = prism();
  std::set<const TopoDS_TShape*> apart;
  const TopTools_IndexedMapOfShape given = partsOf(shape, TopAbs_FACE);
  for (int face = 1; face <= given.Extent(); ++face) apart.insert(given(face).TShape().get());
  ASSERT_LT(apart.size(), 5U);
  for (int face = 1; face <= 5; ++face) {
    SCOPED_TRACE(face);
    const FillHoleReport report = replaceFace(modelFromShape(shape), face, {.target = Level::G0});
    ASSERT_TRUE(report.filled) << textOf(report.reason);
    EXPECT_EQ(report.model.shape.ShapeType(), TopAbs_SOLID);
    EXPECT_TRUE(BRepCheck_Analyzer(report.model.shape).IsValid());
    EXPECT_NEAR(volume_mm3(report.model.shape), prism_mm3, 1e-3);
  }
}

TEST(Fill, OfAnOpenPrismClosesIt) {
  for (int face = 1; face <= 3; ++face) {
    SCOPED_TRACE(face);
    const TopoDS_Shape open = without(prism(), {face});
    const occ::Model model = modelFromShape(open);
    const std::vector<Hole> holes = occ::findHoles(open).holes;
    ASSERT_EQ(holes.size(), 1U);
    const FillHoleReport report = occ::fillHole(model, holes.front(), {.target = Level::G0});
    ASSERT_TRUE(report.filled) << textOf(report.reason);
    EXPECT_NEAR(std::abs(volume_mm3(report.model.shape)), prism_mm3, 1e-3);
    const FillHoleReport missed = occ::fillHole(model, holes.front());
    EXPECT_FALSE(missed.filled);
    EXPECT_TRUE(missed.model.shape.IsSame(open));
  }
}

TEST(Fill, OfAPatchOfASplineSheetIsExactAlongItsSides) {
  const TopoDS_Shape shape = sheet();
  const FillHoleReport report = replaceFace(modelFromShape(shape), faceNear(shape, gp_Pnt()));
  ASSERT_TRUE(report.filled) << textOf(report.reason);
  EXPECT_EQ(report.model.shape.ShapeType(), TopAbs_SHELL);
  EXPECT_TRUE(BRepCheck_Analyzer(report.model.shape).IsValid());
  for (const occ::FilledSide& side : report.sides) {
    EXPECT_EQ(side.edge_degree, 3);
    EXPECT_LT(side.gap_mm, 1e-12);
    EXPECT_LT(side.angle_rad, 1e-10);
  }
  EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), 1e-7);
  for (const int face : report.faces) {
    const BRepAdaptor_Surface surface(TopoDS::Face(partsOf(report.model.shape, TopAbs_FACE)(face)));
    for (int i = 0; i <= 10; ++i)
      for (int j = 0; j <= 10; ++j) {
        const gp_Pnt point = surface.Value(i / 10.0, j / 10.0);
        EXPECT_NEAR(point.Z(), heightAt(point.X(), point.Y()), 2e-3);
      }
  }
}

TEST(FindHoles, TheRimOfASheetIsTheLongest) {
  const TopoDS_Shape shape = sheet();
  const occ::Holes found = occ::findHoles(without(shape, {faceNear(shape, gp_Pnt())}));
  ASSERT_EQ(found.holes.size(), 2U);
  const bool first = found.holes[0].longest;
  EXPECT_NE(first, found.holes[1].longest);
  EXPECT_GT(found.holes[first ? 0 : 1].length_mm, 2 * found.holes[first ? 1 : 0].length_mm);
  for (const Hole& hole : found.holes) EXPECT_EQ(hole.sides.size(), 4U);
}

TEST(FindHoles, HolesThatTouchInAVertexAreTwo) {
  const TopoDS_Shape shape = sheet();
  const std::vector<int> diagonal = {faceNear(shape, gp_Pnt()), faceNear(shape, gp_Pnt(3, 3, 0))};
  const occ::Holes found = occ::findHoles(without(shape, diagonal));
  EXPECT_THAT(found.notes, testing::IsEmpty());
  ASSERT_EQ(found.holes.size(), 2U);
  std::vector<std::size_t> counts;
  for (const Hole& hole : found.holes) {
    counts.push_back(0);
    for (const occ::HoleSide& side : hole.sides) counts.back() += side.edges.size();
  }
  EXPECT_THAT(counts, testing::UnorderedElementsAre(4U, 12U));
}

TEST(Fill, MovesAndScalesWithTheModel) {
  std::mt19937 random(testSeed());
  const TopoDS_Shape shape = suitcase({3, 4, 5});
  const FillHoleReport plain = replaceFace(modelFromShape(shape), cornerFace(shape));
  ASSERT_TRUE(plain.filled) << textOf(plain.reason);
  for (int turn = 0; turn < 3; ++turn) {
    const FillHoleReport moved =
        replaceFace(modelFromShape(transformed(shape, randomMotion(random))), cornerFace(shape));
    ASSERT_TRUE(moved.filled) << textOf(moved.reason);
    EXPECT_NEAR(*moved.largestAngle_rad(), *plain.largestAngle_rad(),
                1e-3 * *plain.largestAngle_rad() + 1e-7);
  }
}

TEST(Fill, OfFacesOfAShellOfSplinesIsSmooth) {
  std::ifstream stream(occtModel("occ/shell1.brep"));
  const TopoDS_Shape shell = occ::readTextShape(stream);
  for (const int face : {8, 11, 64, 99}) {
    const FillHoleReport report = replaceFace(modelFromShape(shell), face);
    ASSERT_TRUE(report.filled) << "face " << face << ": " << textOf(report.reason);
    EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), 0.002 * degree)
        << "face " << face;
    EXPECT_EQ(report.model.faceCount(),
              modelFromShape(shell).faceCount() - 1 + static_cast<int>(report.faces.size()));
  }
}

/// Neighbours bend back and forth, and corners lie out of their tangent planes by more than a fit
/// is to miss: fields across the sides that nearly vanish at corners would make faces that fold.
TEST(Fill, OfLongHolesInAShellOfSplinesIsRegular) {
  std::ifstream stream(occtModel("occ/shell1.brep"));
  const occ::Model shell = modelFromShape(occ::readTextShape(stream));
  for (const int face : {50, 74, 77}) {
    const FillHoleReport report = replaceFace(shell, face);
    ASSERT_TRUE(report.filled && report.reached)
        << "face " << face << ": " << textOf(report.reason);
    EXPECT_TRUE(report.regular) << "face " << face;
    EXPECT_LT(report.reach, 1.6) << "face " << face;
    EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), 0.01 * degree) << "face " << face;
    for (const occ::FilledSide& side : report.sides)
      EXPECT_LE(side.cross_degree, 4) << "face " << face;
  }
}

/// At a corner the curvature across a side is that of the next side's edge: no fill that is tangent
/// to both has a smaller jump there. The bounds are that jump, computed from both neighbours, and a
/// tenth.
TEST(Fill, HasJumpsOfCurvatureLittleLargerThanTheCornersAskFor) {
  std::ifstream stream(occtModel("occ/shell1.brep"));
  const occ::Model shell = modelFromShape(occ::readTextShape(stream));
  struct Case {
    int face;
    Level target;
    double at_corners;
  };
  for (const Case& one : {Case{11, Level::G1, 1.0},
                          {18, Level::G1, 0.275},
                          {16, Level::G2, 0.455},
                          {75, Level::G2, 0.153},
                          {89, Level::G2, 0.227},
                          {98, Level::G2, 0.349}}) {
    SCOPED_TRACE(one.face);
    const FillHoleReport report =
        replaceFace(shell, one.face, {.target = one.target, .keep_anyway = true});
    ASSERT_TRUE(report.largestCurvature_rel().has_value());
    EXPECT_LT(*report.largestCurvature_rel(), 1.1 * one.at_corners);
    if (one.target == Level::G2)
      for (const occ::SeamResult& seam : report.inner)
        EXPECT_LT(*seam.figures.curvature_rel->upper, 1e-6);
    EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), 0.005 * degree);
  }
}

/// The first two have planes that differ at corners by more than half the tolerance, the third a
/// side of two edges.
TEST(Fill, OfHolesWhoseNeighboursDisagreeALittleIsWithinTheTolerance) {
  std::ifstream stream(occtModel("occ/shell1.brep"));
  const occ::Model shell = modelFromShape(occ::readTextShape(stream));
  for (const auto& [face, within_deg] : {std::pair{36, 0.0045}, {41, 0.004}, {78, 0.01}}) {
    const FillHoleReport report = replaceFace(shell, face);
    ASSERT_TRUE(report.filled && report.reached)
        << "face " << face << ": " << textOf(report.reason);
    EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), within_deg * degree)
        << "face " << face;
  }
}

/// Seen from above, the plane's normals point upward all around; those of the fill would not.
TEST(Fill, AroundASharpReflexCornerIsOneFaceWithoutAFold) {
  BRepBuilderAPI_MakePolygon dart;
  for (const auto& [x, y] : {std::pair{-8., -8.}, {0., 0.}, {8., -8.}, {0., 8.}})
    dart.Add(gp_Pnt(x, y, 0));
  dart.Close();
  BRepBuilderAPI_MakeFace around(gp_Pln(gp::XOY()), -30, 30, -30, 30);
  const TopoDS_Face inside = BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), dart.Wire());
  const TopoDS_Shape holed = BRepAlgoAPI_Cut(around.Face(), inside).Shape();
  const occ::Model model = modelFromShape(holed);
  int tried = 0;
  for (const Hole& hole : occ::findHoles(holed).holes) {
    if (hole.longest) continue;
    ++tried;
    const FillHoleReport report = occ::fillHole(model, hole, {.continue_surface = false});
    EXPECT_TRUE(report.filled && report.reached) << textOf(report.reason);
    EXPECT_TRUE(report.regular);
    EXPECT_EQ(report.faces.size(), 1U);
    EXPECT_LT(largestAngle_rad(report.model.shape, report.faces), 0.01 * degree);
  }
  EXPECT_GT(tried, 0);
}

TEST(Fill, OfAllThereIsIsRefused) {
  EXPECT_THAT(textOf(replaceFace(modelFromShape(BRepPrimAPI_MakeSphere(5).Shape()), 1).reason),
              HasSubstr("the only one"));
}

TEST(Fill, RefusesWhatTheModelDoesNotHave) {
  const occ::Model box = modelFromShape(BRepPrimAPI_MakeBox(10, 20, 30).Shape());
  for (const int face : {0, -1, 7})
    EXPECT_THAT([&] { replaceFace(box, face); }, testing::ThrowsMessage<std::invalid_argument>(
                                                     HasSubstr("face " + std::to_string(face))));
  const occ::Model other = modelFromShape(without(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), {1}));
  const Hole hole = occ::findHoles(other.shape).holes.front();
  EXPECT_THROW(occ::fillHole(box, hole), std::invalid_argument);
  FillHoleOptions options;
  options.most_degree = 12;
  EXPECT_THROW(replaceFace(box, 1, options), std::invalid_argument);
  EXPECT_THROW(replaceFace(box, 1, {.target = Level::G3}), std::invalid_argument);
  EXPECT_THROW(replaceFace(box, 1, {.tolerance = {.gap_mm = std::nan("")}}), std::invalid_argument);
  EXPECT_THROW(replaceFace(box, 1, {}, [](double) { return false; }), occ::Cancelled);
}

}  // namespace
}  // namespace seamwright::test
