// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges whose path on a face is missing or wrong, and edges that only look so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <numbers>
#include <random>
#include <sstream>

#include <seamwright/occ_adapter/convert/pcurve.hpp>

#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::SeamResult;
using ::testing::HasSubstr;
using ::testing::Not;

using Path = opencascade::handle<Geom2d_Curve>;

std::string textOf(const TopoDS_Shape& shape) {
  std::ostringstream text;
  BRepTools::Write(shape, text);
  return text.str();
}

struct Fixture {
  TopoDS_Shape shape = planeAndCylinder(10, 8);
  occ::Coedge cylinder = occ::findSeams(shape).seams.at(0).sides[1];
  TopoDS_Edge edge = TopoDS::Edge(cylinder.edge.Oriented(TopAbs_FORWARD));

  Path path() const {
    double first = 0, last = 0;
    return BRep_Tool::CurveOnSurface(edge, cylinder.shape, first, last);
  }
  void setPath(const Path& path) { BRep_Builder().UpdateEdge(edge, path, cylinder.shape, 1e-7); }

  /// The seam's result; the analysis must leave the shape as it is.
  SeamResult analyzedUnchanged() const {
    const std::string before = textOf(shape);
    const SeamResult seam = analyzed(shape).seams.at(0);
    EXPECT_EQ(textOf(shape), before);
    return seam;
  }
};

/// Tangent with the curvature of the cylinder: what the model is without its fault.
void expectAsDesigned(const SeamResult& seam) {
  SCOPED_TRACE(describe(seam));
  EXPECT_EQ(seam.verdict.level, Level::G1);
  EXPECT_EQ(seam.verdict.seam_class, SeamClass::Smooth);
  EXPECT_LT(seam.figures.gap_mm->lower, 1e-5);
  EXPECT_LT(angleDeg(seam), 1e-4);
  EXPECT_NEAR(curvature(seam), 0.1, 1e-6);
  EXPECT_NEAR(seam.length_mm, 8, 1e-6);
}

TEST(PcurveFaults, SoundOnesAreTakenAsTheyAre) {
  const Fixture model;
  const SeamResult seam = model.analyzedUnchanged();
  expectAsDesigned(seam);
  EXPECT_EQ(seam.note, "");
  const occ::Pcurve taken = occ::pcurveOf(model.edge, model.cylinder.shape, 0.01);
  EXPECT_EQ(taken.curve.get(), model.path().get());
}

TEST(PcurveOnPlane, IsThatOfOpenCascadeForLinesAndCirclesInAnyPlace) {
  // A plane needs no pcurves: OpenCASCADE projects the edge.
  std::mt19937_64 random(testSeed());
  std::uniform_real_distribution<double> number(-50, 50);
  const auto point = [&] { return gp_Pnt(number(random), number(random), number(random)); };
  const auto direction = [&] { return gp_Dir(number(random), number(random), number(random)); };
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const gp_Ax3 frame(point(), direction());
    gp_Ax2 of_circle(ElSLib::PlaneValue(number(random), number(random), frame),
                     i % 4 < 2 ? frame.Direction() : frame.Direction().Reversed(),
                     frame.XDirection().Rotated(frame.Axis(), number(random)));
    if (i % 5 == 4) of_circle.Rotate(gp_Ax1(of_circle.Location(), of_circle.XDirection()), 0.3);
    const gp_Pnt end = ElSLib::PlaneValue(number(random), number(random), frame);
    const TopoDS_Edge edge = i % 2 == 0
                                 ? BRepBuilderAPI_MakeEdge(gp_Circ(of_circle, 7), 0.5, 3).Edge()
                                 : BRepBuilderAPI_MakeEdge(of_circle.Location(), end).Edge();
    TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(frame)).Face();
    gp_Trsf placed;
    placed.SetRotation(gp_Ax1(point(), direction()), number(random));
    face.Location(TopLoc_Location(placed));
    const TopoDS_Edge moved = TopoDS::Edge(edge.Moved(TopLoc_Location(placed)));
    const occ::Pcurve found = occ::pcurveOf(moved, face, 0.01);
    double first = 0, last = 0;
    const Path expected = BRep_Tool::CurveOnSurface(moved, face, first, last);
    EXPECT_EQ(found.note, "");
    EXPECT_EQ(std::pair(found.first, found.last), std::pair(first, last));
    for (double share = 0; share <= 1; share += 0.125) {
      const double at = first + share * (last - first);
      EXPECT_LE(found.curve->Value(at).Distance(expected->Value(at)), 1e-11);
    }
  }
}

TEST(PcurveFaults, AMissingOneIsRebuiltInMemory) {
  Fixture model;
  model.setPath(Path());
  ASSERT_TRUE(model.path().IsNull());
  const SeamResult seam = model.analyzedUnchanged();
  expectAsDesigned(seam);
  EXPECT_THAT(seam.note, HasSubstr("missing"));
  EXPECT_TRUE(model.path().IsNull());
}

TEST(PcurveFaults, AShiftedOneIsRebuiltInMemory) {
  Fixture model;
  const Path shifted = Path::DownCast(model.path()->Copy());
  shifted->Translate(gp_Vec2d(0.3, 0));
  model.setPath(shifted);
  const SeamResult seam = model.analyzedUnchanged();
  expectAsDesigned(seam);
  EXPECT_THAT(seam.note, HasSubstr("off the edge"));
}

TEST(PcurveFaults, AToleranceIsAnEstimate) {
  constexpr double tolerance_mm = 0.01;
  for (const double shift_mm : {0.014, 0.016}) {
    Fixture model;
    const Path shifted = Path::DownCast(model.path()->Copy());
    shifted->Translate(gp_Vec2d(shift_mm / 10, 0));  // of the angle, radius 10
    model.setPath(shifted);
    BRep_Builder().UpdateEdge(model.edge, tolerance_mm);
    const bool is_kept = shift_mm < 1.5 * tolerance_mm;
    EXPECT_EQ(model.analyzedUnchanged().note.empty(), is_kept) << shift_mm;
  }
}

TEST(PcurveFaults, ReparametrisedWithSameParameterFalse) {
  Fixture model;
  // The same line run at another pace: t (0.4 + 0.6 t).
  NCollection_Array1<gp_Pnt2d> poles(1, 3);
  const gp_Pnt2d p = model.path()->Value(0), q = model.path()->Value(1);
  const auto between = [&](double t) { return gp_Pnt2d(p.XY() + t * (q.XY() - p.XY())); };
  poles(1) = p;
  poles(2) = between(0.2);
  poles(3) = q;
  NCollection_Array1<double> knots(1, 2);
  knots(1) = 0;
  knots(2) = 1;
  NCollection_Array1<int> multiplicities(1, 2);
  multiplicities.Init(3);
  model.setPath(new Geom2d_BSplineCurve(poles, knots, multiplicities, 2));
  BRep_Builder().SameParameter(model.edge, false);
  BRep_Builder().SameRange(model.edge, false);
  expectAsDesigned(model.analyzedUnchanged());
}

TEST(PcurveFaults, WithoutACurveInSpaceThePathsAreUsed) {
  Fixture model;
  BRep_Builder().UpdateEdge(model.edge, opencascade::handle<Geom_Curve>(), 1e-7);
  double first = 0, last = 0;
  ASSERT_TRUE(BRep_Tool::Curve(model.edge, first, last).IsNull());
  expectAsDesigned(model.analyzedUnchanged());
}

TEST(PcurveFaults, WithNeitherCurveTheSeamHasANoteAndTheOthersFigures) {
  Fixture model;
  model.setPath(Path());
  BRep_Builder().UpdateEdge(model.edge, opencascade::handle<Geom_Curve>(), 1e-7);
  const SeamResult seam = model.analyzedUnchanged();
  EXPECT_THAT(seam.note, HasSubstr("not measured"));
  EXPECT_EQ(seam.verdict.level, Level::None);
  EXPECT_EQ(seam.verdict.seam_class, SeamClass::Defect);
  EXPECT_FALSE(seam.figures.gap_mm || seam.figures.angle_rad);
}

TEST(PcurveFaults, ATrueGapIsAGapOfTheModel) {
  for (const double gap : {0.02, 0.5, 3.0}) {
    // The cylinder ends above the plane; the edge lies on the plane, its path on the cylinder is
    // sound.
    const opencascade::handle<Geom_Surface> plane = new Geom_Plane(gp::XOY());
    const opencascade::handle<Geom_Surface> cylinder =
        new Geom_CylindricalSurface(gp_Ax3(gp_Pnt(0, 0, gap - 10), gp::DY(), gp::DZ()), 10);
    const TopoDS_Shape shape =
        joined({plane, beginningWith(1, rectangle(-8, 0, 0, 8))},
               {cylinder, beginningWith(3, rectangle(0, std::numbers::pi / 2, 0, 8))});
    const SeamResult seam = analyzed(shape).seams.at(0);
    SCOPED_TRACE(describe(seam));
    EXPECT_NEAR(seam.figures.gap_mm->lower, gap, 1e-9);
    EXPECT_EQ(seam.verdict.level, Level::None);
    EXPECT_EQ(seam.verdict.seam_class, SeamClass::Defect);
    EXPECT_THAT(seam.note, Not(HasSubstr("rebuilt")));
  }
}

TEST(PcurveFaults, ATruePartialGapIsFoundAtItsFullHeight) {
  // A sheet that leaves the edge towards one end: 0 at the start, 0.4 mm at the end.
  const gp_Dir along(0, 8, 0.4);
  const opencascade::handle<Geom_Surface> sheet =
      new Geom_Plane(gp_Ax3(gp::Origin(), gp::DX().Crossed(along), gp::DX()));
  const double length = std::hypot(8, 0.4);
  const opencascade::handle<Geom_Surface> plane = new Geom_Plane(gp::XOY());
  const TopoDS_Shape shape = joined({plane, beginningWith(1, rectangle(-8, 0, 0, 8))},
                                    {sheet, beginningWith(3, rectangle(0, 5, 0, length))});
  const SeamResult seam = analyzed(shape).seams.at(0);
  EXPECT_NEAR(seam.figures.gap_mm->lower, 0.4, 1e-9) << describe(seam);
}

}  // namespace
}  // namespace seamwright::test
