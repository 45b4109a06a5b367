// SPDX-License-Identifier: LGPL-2.1-or-later
// Bounds next to points where an edge of a surface collapses: samples at 1e-2 to 1e-12 of the seam
// from both ends.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/convert/seam_strips.hpp>

#include "exact_seam.hpp"
#include "files.hpp"
#include "shapes.hpp"

namespace seamwright::test {
namespace {

using occ::AnalyzeOptions;
using occ::Seam;
using occ::SeamResult;
using ::testing::HasSubstr;

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Of the seam: nearer to a point without tangent plane a point is taken for it, by length as by
/// parameter. A little more, as edges do not run at constant speed.
constexpr double at_pole = 0x1p-29;

bool holds(const LeftOut& left_out, double s) {
  return std::ranges::any_of(left_out.intervals,
                             [&](const Interval& interval) { return interval.contains(s); });
}

double upperOf(const std::optional<Figure>& figure) {
  return figure ? figure->upper.value_or(infinite) : infinite;
}

/// A parameter of the seam and how far it is from the nearer end.
struct Sample {
  double s = 0;
  double from_end = 0;
};

/// What may be there: the figure's bound, or that of what it leaves out.
double allowed(const std::optional<Figure>& figure, const LeftOut& left_out, const Sample& sample) {
  if (!holds(left_out, sample.s)) return upperOf(figure);
  return sample.from_end < at_pole ? infinite : left_out.upper.value_or(infinite);
}

struct Samples {
  int seams = 0;
  int count = 0;
};

/// A little above: what is rounded where the sample is taken.
double above(double bound) {
  return bound * (1 + 1e-6) + 1e-12;
}

void expectWithin(const ExactMeasure& exact, const SeamFigures& figures, const Sample& sample) {
  EXPECT_LE(exact.angle_rad, above(allowed(figures.angle_rad, figures.angle_left_out, sample)));
  if (!figures.curvature_rel) return;
  EXPECT_LE(exact.curvature_rel,
            above(allowed(figures.curvature_rel, figures.curvature_left_out, sample)));
  if (!holds(figures.curvature_left_out, sample.s)) {
    EXPECT_LE(exact.curvature_per_mm, above(upperOf(figures.curvature_per_mm)));
  }
}

/// The first derivatives of OpenCASCADE, which are off by their rounding.
void expectAngleWithin(const PairMeasure& pair, const SeamFigures& figures, const Sample& sample,
                       double rounding_rad) {
  if (!pair.angle_rad) return;
  EXPECT_LE(*pair.angle_rad,
            allowed(figures.angle_rad, figures.angle_left_out, sample) * (1 + 1e-6) + rounding_rad);
}

/// Looks at the seams with a collapsed edge.
Samples expectBoundsHold(const TopoDS_Shape& shape) {
  Samples samples;
  AnalyzeOptions options;
  for (const Seam& seam : occ::findSeams(shape).seams) {
    const auto collapses = [](const occ::Coedge& use) {
      return use.pole_tolerance_mm != std::array<double, 2>{};
    };
    if (std::ranges::none_of(seam.sides, collapses)) continue;
    const SeamResult result = occ::measureSeam(seam, options);
    std::array<occ::Pcurve, 2> pcurves;
    for (const int i : {0, 1})
      pcurves[i] = occ::pcurveOf(seam.sides[i].edge, seam.sides[i].shape, options.tolerance.gap_mm);
    const occ::SeamStrips strips(seam, pcurves);
    ++samples.seams;
    for (double digits = 2; digits <= 12; digits += 0.25)
      for (const bool at_end : {false, true}) {
        const double x = std::pow(10, -digits);
        const double s = at_end ? 1 - x : x;
        SCOPED_TRACE(testing::Message()
                     << describe(result) << " at " << (at_end ? "1 - " : "") << x);
        if (const auto exact = exactMeasure(seam, pcurves, s, options.tolerance.flat_radius_mm))
          expectWithin(*exact, result.figures, {s, x});
        else
          expectAngleWithin(strips.measureAt(s), result.figures, {s, x}, 1e-11 / x);
        ++samples.count;
      }
  }
  return samples;
}

// --- generated

TopoDS_Shape turnedSpline() {
  TColgp_Array1OfPnt poles(1, 4);
  poles(1) = gp_Pnt(0, 0, 10);
  poles(2) = gp_Pnt(4, 0, 10);
  poles(3) = gp_Pnt(8, 0, 6);
  poles(4) = gp_Pnt(7, 0, 0);
  const opencascade::handle<Geom_Curve> curve = new Geom_BezierCurve(poles);
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeEdge(curve).Edge(), gp::OZ()).Shape();
}

/// The fan x = v, y = side u v, z = rise(v) u v over u in [0, 1]; all of v = 0 is the origin but
/// for \p scatter. The angle to the plane z = 0 along u = 0 is atan(slope (1 - v / width)), up to v
/// = width, and 0 beyond.
TopoDS_Face fan(double side, double slope, double width, double scatter = 0) {
  const std::array<double, 5> v = {0, width / 2, width, (1 + width) / 2, 1};
  TColgp_Array2OfPnt poles(1, 2, 1, 5);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 5; ++j) {
      const double z = j == 0 ? scatter : j == 1 ? slope * width / 2 : 0;
      poles(i + 1, j + 1) = gp_Pnt(v[j], i * side * v[j], i * z);
    }
  TColStd_Array1OfReal knots_u(1, 2), knots_v(1, 3);
  TColStd_Array1OfInteger times_u(1, 2), times_v(1, 3);
  knots_u(1) = knots_v(1) = 0;
  knots_u(2) = knots_v(3) = 1;
  knots_v(2) = width;
  times_u(1) = times_u(2) = 2;
  times_v(1) = times_v(3) = 3;
  times_v(2) = 2;
  const opencascade::handle<Geom_Surface> surface =
      new Geom_BSplineSurface(poles, knots_u, knots_v, times_u, times_v, 1, 2);
  return BRepBuilderAPI_MakeFace(surface, 1e-6).Face();
}

TopoDS_Shape sewn(const TopoDS_Face& a, const TopoDS_Face& b) {
  BRepBuilderAPI_Sewing sewing(1e-5);
  sewing.Add(a);
  sewing.Add(b);
  sewing.Perform();
  return sewing.SewedShape();
}

SeamResult onlySeamOf(const TopoDS_Shape& shape, const AnalyzeOptions& options = {}) {
  const occ::SeamGraph graph = occ::findSeams(shape);
  EXPECT_EQ(graph.seams.size(), 1u);
  const auto& tolerances = graph.seams.at(0).sides[0].pole_tolerance_mm;
  EXPECT_GT(tolerances[0] + tolerances[1], 0) << "no edge collapses";
  return occ::measureSeam(graph.seams.at(0), options);
}

TEST(CollapsedEdges, BoundsHoldOnGeneratedFaces) {
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(5, 0, 12).Shape();
  const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(10).Shape();
  const auto spline = [](const TopoDS_Shape& shape) {
    return BRepBuilderAPI_NurbsConvert(shape, true).Shape();
  };
  for (const TopoDS_Shape& shape :
       {cone, spline(cone), sphere, spline(sphere), turnedSpline(), spline(turnedSpline()),
        sewn(fan(-1, 0, 0.25), fan(1, 0.01, 0.25)), sewn(fan(-1, 0, 1e-5), fan(1, 0.01, 1e-5)),
        sewn(fan(-1, 0, 0.25), fan(1, 0.01, 0.25, 1e-9))})
    EXPECT_GE(expectBoundsHold(shape).count, 80);
}

TEST(CollapsedEdges, AnAngleThatOnlyThePointShowsIsFound) {
  const double slope = std::tan(1 * degree);
  for (const double width : {0.1, 1e-3, 1e-5, 1e-6, 1e-8, 1e-9}) {
    SCOPED_TRACE(width);
    const SeamResult seam = onlySeamOf(sewn(fan(-1, 0, width), fan(1, slope, width)));
    ASSERT_TRUE(seam.figures.angle_rad && seam.figures.angle_rad->upper) << describe(seam);
    EXPECT_GE(*seam.figures.angle_rad->upper, degree * (1 - 1e-9));
    EXPECT_GE(seam.figures.angle_rad->lower, 0.99 * degree);
    EXPECT_TRUE(seam.figures.angle_left_out.intervals.empty());
    EXPECT_EQ(seam.verdict.level, Level::G0);
    EXPECT_TRUE(seam.verdict.certain) << describe(seam);
  }
}

TEST(CollapsedEdges, OfSmoothFacesVerdictsAreCertainUpToThePoint) {
  const TopoDS_Shape flat = sewn(fan(-1, 0, 0.25), fan(1, 0, 0.25));
  const TopoDS_Shape dome = BRepBuilderAPI_NurbsConvert(turnedSpline(), true).Shape();
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(5, 0, 12).Shape();
  for (const TopoDS_Shape& shape : {flat, dome, cone})
    for (const Seam& seam : occ::findSeams(shape).seams) {
      if (seam.sides[0].pole_tolerance_mm == std::array<double, 2>{}) continue;
      const SeamResult result = occ::measureSeam(seam, {});
      SCOPED_TRACE(testing::Message()
                   << describe(result) << ", left out up to "
                   << result.figures.curvature_left_out.upper.value_or(infinite));
      EXPECT_EQ(result.verdict.level, Level::G2);
      EXPECT_TRUE(result.verdict.certain);
      ASSERT_EQ(result.figures.curvature_left_out.intervals.size(), 1u);
      const Interval& interval = result.figures.curvature_left_out.intervals.front();
      EXPECT_LE(interval.width(), 0x1p-20);
      EXPECT_GT(interval.width(), 0x1p-24);
      EXPECT_TRUE(interval.lower == 0 || interval.upper == 1);
    }
}

TEST(CollapsedEdges, TheWayToThePointTakesFewPieces) {
  // Halving would take twenty times two pieces from the middle to 2^-20 of the seam, and from there
  // as many up to where rounding ends.
  const TopoDS_Shape dome = BRepBuilderAPI_NurbsConvert(turnedSpline(), true).Shape();
  std::vector<TopoDS_Shape> shapes = {dome};
  for (const double scatter : {0.0, 1e-12, 1e-9})
    shapes.push_back(sewn(fan(-1, 0.01, 0.25), fan(1, 0, 0.25, scatter)));
  for (const TopoDS_Shape& shape : shapes)
    for (const Seam& seam : occ::findSeams(shape).seams) {
      const SeamResult result = occ::measureSeam(seam, {});
      EXPECT_LE(result.figures.points, 45) << describe(result);
    }
}

TEST(CollapsedEdges, ScatteredPolesLeaveOutAnIntervalThatCountsIfItIsLongerThanTheGapAccepted) {
  AnalyzeOptions options;
  options.tolerance.angle_rad =
      0.2 * degree;  // where the interval ends the scatter still turns the plane by 1 / 500
  for (const double scatter : {1e-12, 1e-9, 1e-8}) {
    SCOPED_TRACE(scatter);
    const TopoDS_Shape shape = sewn(fan(-1, 0, 0.25), fan(1, 0, 0.25, scatter));
    options.tolerance.gap_mm = 300 * scatter;
    const SeamResult seam = onlySeamOf(shape, options);
    EXPECT_GE(seam.verdict.level, Level::G1);
    EXPECT_FALSE(seam.verdict.certain) << "the angle next to the point is a matter of the scatter";
    options.tolerance.gap_mm = 800 * scatter + 4e-7;
    const SeamResult point = onlySeamOf(shape, options);
    EXPECT_GE(point.verdict.level, Level::G1);
    EXPECT_TRUE(point.verdict.certain) << describe(point);
    ASSERT_EQ(seam.figures.angle_left_out.intervals.size(), 1u);
    const Interval& interval = seam.figures.angle_left_out.intervals.front();
    EXPECT_GE(interval.width(), 400 * scatter);
    EXPECT_LE(interval.width(), 600 * scatter + 2e-7);
    EXPECT_GE(seam.figures.curvature_left_out.intervals.at(0).width(), interval.width());
  }
  const SeamResult sharp = onlySeamOf(sewn(fan(-1, 0, 0.25), fan(1, 0.01, 0.25, 1e-9)));
  EXPECT_EQ(sharp.verdict.level, Level::G0);
  EXPECT_TRUE(sharp.verdict.certain) << "nothing next to the point makes the rest smooth";
}

TEST(CollapsedEdges, BoundsHoldOnModels) {
  for (const char* name : {"occ/shell1.brep", "occ/Bottom.brep", "occ/CrankArm.brep",
                           "occ/Top.brep", "occ/Motor-c.brep", "occ/bottle.brep"}) {
    SCOPED_TRACE(name);
    EXPECT_GT(expectBoundsHold(occ::readModel(occtModel(name)).shape).seams, 0);
  }
}

}  // namespace
}  // namespace seamwright::test
