// SPDX-License-Identifier: LGPL-2.1-or-later
// Enclosures through the adapter: every kind of surface and curve, defects that sampling misses,
// and what can't be enclosed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Hyperbola.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <Geom2d_Parabola.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <ShapeExtend_CompositeSurface.hxx>
#include <TColGeom_HArray2OfSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::SeamResult;
using ::testing::HasSubstr;
using Surface = opencascade::handle<Geom_Surface>;
using Path = opencascade::handle<Geom2d_Curve>;

constexpr double pi = std::numbers::pi;
const ContinuityTolerance tolerance;

SeamResult onlySeam(const TopoDS_Shape& shape, const occ::AnalyzeOptions& options = {}) {
  const occ::Report report = analyzed(shape, options);
  EXPECT_EQ(report.seams.size(), 1u);
  return report.seams.at(0);
}

void expectCertain(const SeamResult& seam, Level level, SeamClass seam_class) {
  EXPECT_TRUE(seam.figures.certified) << seam.figures.uncertified;
  EXPECT_TRUE(seam.verdict.certain);
  EXPECT_EQ(seam.verdict.level, level);
  EXPECT_EQ(seam.verdict.seam_class, seam_class);
}

/// Two faces bounded by one and the same edge alone, of any pcurves; the face of a lies to its
/// left.
TopoDS_Shape alongEdge(const Surface& a, const Path& path_a, const Surface& b, const Path& path_b,
                       double first, double last, double edge_tolerance = 1e-6) {
  BRep_Builder builder;
  TopoDS_Face face_a, face_b;
  builder.MakeFace(face_a, a, 1e-7);
  builder.MakeFace(face_b, b, 1e-7);
  TopoDS_Edge edge;
  builder.MakeEdge(edge);
  builder.UpdateEdge(edge, path_a, face_a, edge_tolerance);
  builder.UpdateEdge(edge, path_b, face_b, edge_tolerance);
  builder.Range(edge, first, last);
  for (const bool at_end : {false, true}) {
    const gp_Pnt2d uv = path_a->Value(at_end ? last : first);
    TopoDS_Vertex vertex;
    builder.MakeVertex(vertex, a->Value(uv.X(), uv.Y()), edge_tolerance);
    builder.Add(edge, vertex.Oriented(at_end ? TopAbs_REVERSED : TopAbs_FORWARD));
  }
  BRepLib::BuildCurve3d(edge, edge_tolerance);
  const auto bound = [&](TopoDS_Face& face, const TopoDS_Shape& by) {
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    builder.Add(wire, by);
    builder.Add(face, wire);
  };
  bound(face_a, edge);
  bound(face_b, edge.Reversed());
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, face_a);
  builder.Add(both, face_b);
  return both;
}

/// A spline over knots of multiplicity one but for the ends, poles at the Greville points, moved by
/// \p pole.
Surface splineSheet(const std::vector<double>& knots_u, int degree_u,
                    const std::vector<double>& knots_v, int degree_v,
                    const std::function<gp_Pnt(int i, int j, double u, double v)>& pole) {
  const auto greville = [](const std::vector<double>& knots, int degree) {
    std::vector<double> flat(degree, knots.front());
    flat.insert(flat.end(), knots.begin(), knots.end());
    flat.insert(flat.end(), degree, knots.back());
    std::vector<double> points;
    for (std::size_t i = 0; i + degree + 1 < flat.size(); ++i) {
      double sum = 0;
      for (int k = 1; k <= degree; ++k) sum += flat[i + k];
      points.push_back(sum / degree);
    }
    return points;
  };
  const std::vector<double> u = greville(knots_u, degree_u), v = greville(knots_v, degree_v);
  NCollection_Array2<gp_Pnt> poles(1, static_cast<int>(u.size()), 1, static_cast<int>(v.size()));
  for (int i = 0; i < poles.ColLength(); ++i)
    for (int j = 0; j < poles.RowLength(); ++j) poles(i + 1, j + 1) = pole(i, j, u[i], v[j]);
  const auto count = [](const std::vector<double>& knots) {
    return static_cast<int>(knots.size());
  };
  NCollection_Array1<double> array_u(1, count(knots_u)), array_v(1, count(knots_v));
  NCollection_Array1<int> times_u(1, count(knots_u)), times_v(1, count(knots_v));
  for (int i = 1; i <= count(knots_u); ++i) {
    array_u(i) = knots_u[i - 1];
    times_u(i) = i == 1 || i == count(knots_u) ? degree_u + 1 : 1;
  }
  for (int i = 1; i <= count(knots_v); ++i) {
    array_v(i) = knots_v[i - 1];
    times_v(i) = i == 1 || i == count(knots_v) ? degree_v + 1 : 1;
  }
  return new Geom_BSplineSurface(poles, array_u, array_v, times_u, times_v, degree_u, degree_v);
}

std::vector<double> evenly(double first, double last, int spans) {
  std::vector<double> knots;
  for (int i = 0; i <= spans; ++i) knots.push_back(first + i * (last - first) / spans);
  return knots;
}

Surface flatPlane() {
  return new Geom_Plane(gp::XOY());
}

/// The sheet z = h N(x) over |x|, |y| < 12 with N the cubic B-spline over four knot spans that end
/// at x = 10, cut along the circle of radius 10 from the plane z = 0. The circle is inside N for
/// less than a sixteenth of its length.
TopoDS_Shape hiddenBump(int spans, double h) {
  const double span = 24.0 / spans;
  const int pole = static_cast<int>(std::round(22 / span)) - 1;  // N ends at knot number pole + 1
  const Surface sheet =
      splineSheet(evenly(-12, 12, spans), 3, {-12, 12}, 1,
                  [&](int i, int, double u, double v) { return gp_Pnt(u, v, i == pole ? h : 0); });
  const Path circle = new Geom2d_Circle(gp_Ax2d(gp::Origin2d(), gp::DX2d()), 10);
  return alongEdge(sheet, circle, flatPlane(), circle, pi / 8, pi / 8 + 2 * pi, h + 1e-6);
}

TEST(Certified, ABumpThatThePathEntersAndLeavesBetweenSamples) {
  // Of the cubic B-spline over spans of length d the largest value is 2/3 and the steepest slope 2
  // / (3 d).
  for (const int spans : {120, 480}) {
    const double h = 0.004, span = 24.0 / spans;
    const SeamResult seam = onlySeam(hiddenBump(spans, h));
    SCOPED_TRACE(describe(seam));
    expectEncloses(seam.figures.gap_mm, 2 * h / 3, tolerance.gap_mm, 1e-9);
    expectEncloses(seam.figures.angle_rad, std::atan(2 * h / (3 * span)), tolerance.angle_rad,
                   1e-9);
    expectCertain(seam, Level::G0, SeamClass::Defect);
  }
}

TEST(Certified, WithoutTheBumpItIsSmooth) {
  expectCertain(onlySeam(hiddenBump(480, 0)), Level::G2, SeamClass::Smooth);
}

TEST(Certified, ABumpNarrowerThanAThousandthOfTheSeam) {
  // Along v 100 mm, with four spans of 0.02 mm; at u = 0 the slope across is that of pole row 1
  // over a third of the width.
  std::vector<double> knots = {0, 30};
  for (int i = 1; i <= 8; ++i) knots.push_back(30 + 0.02 * i);
  knots.push_back(100);
  const double tilt = 2 * degree, spacing = 2;
  const int middle = 6;  // pole whose four spans are 30.02 .. 30.10
  const Surface sheet = splineSheet({0, 1}, 3, knots, 3, [&](int i, int j, double u, double v) {
    return gp_Pnt(3 * spacing * u, v, i == 1 && j == middle ? std::tan(tilt) * spacing * 1.5 : 0);
  });
  const SeamResult seam =
      onlySeam(joined({sheet, beginningWith(3, rectangle(0, 1, 0, 100))},
                      {flatPlane(), beginningWith(1, rectangle(-6, 0, 0, 100))}));
  SCOPED_TRACE(describe(seam));
  expectEncloses(seam.figures.angle_rad, tilt, tolerance.angle_rad, 1e-9);
  expectCertain(seam, Level::G0, SeamClass::Defect);
}

/// Pieces of the cylinder of radius r about the line x = 0, z = -r, made in every way: u = u0 is
/// its top line z = 0, from where it rolls away to x > 0 as u grows to u1; v from 0 to 5 mm along
/// y.
struct Rolling {
  std::string what;
  Surface surface;
  double u0, u1;
  double v0 = 0, v1 = 5;
};

std::vector<Rolling> rollingSurfaces(double r) {
  const gp_Ax3 frame(gp_Pnt(0, 0, -r), gp::DY(), gp::DZ());
  const Surface cylinder = new Geom_CylindricalSurface(frame, r);
  const Surface half = new Geom_CylindricalSurface(frame, r / 2);
  const Surface wide = new Geom_CylindricalSurface(frame, 2 * r);
  const opencascade::handle<Geom_Curve> circle = new Geom_Circle(frame.Ax2(), r);
  const opencascade::handle<Geom_Curve> line = new Geom_Line(gp::Origin(), gp::DY());
  NCollection_Array1<gp_Pnt> two(1, 2);
  two(1) = gp::Origin();
  two(2) = gp_Pnt(0, 5, 0);
  const opencascade::handle<Geom_Curve> chord = new Geom_BezierCurve(two);
  const Surface trimmed = new Geom_RectangularTrimmedSurface(cylinder, 0.0, 1.2, 0.0, 5.0);
  const Surface spline = GeomConvert::SurfaceToBSplineSurface(trimmed);
  const Surface half_spline = GeomConvert::SurfaceToBSplineSurface(
      new Geom_RectangularTrimmedSurface(half, 0.0, 1.2, 0.0, 5.0));
  const Surface periodic = GeomConvert::SurfaceToBSplineSurface(
      new Geom_RectangularTrimmedSurface(cylinder, 0.0, 5.0, false));
  EXPECT_TRUE(periodic->IsUPeriodic());
  NCollection_Array2<gp_Pnt> poles(1, 3, 1, 2);
  NCollection_Array2<double> weights(1, 3, 1, 2);
  const double x[] = {0, r, r}, z[] = {0, 0, -r}, weight[] = {1, std::sqrt(0.5), 1};
  for (int i = 1; i <= poles.ColLength(); ++i)
    for (int j = 1; j <= poles.RowLength(); ++j) {
      poles(i, j) = gp_Pnt(x[i - 1], 5 * (j - 1), z[i - 1]);
      weights(i, j) = weight[i - 1];
    }
  return {
      {"cylinder", cylinder, 0, 1},
      {"trimmed", trimmed, 0, 1},
      {"offset outward", new Geom_OffsetSurface(half, r / 2), 0, 1},
      {"offset inward", new Geom_OffsetSurface(wide, -r), 0, 1},
      {"offset of a spline", new Geom_OffsetSurface(half_spline, r / 2), 0, 1},
      {"extruded circle", new Geom_SurfaceOfLinearExtrusion(circle, gp::DY()), 0, 1},
      {"extruded arc",
       new Geom_SurfaceOfLinearExtrusion(new Geom_TrimmedCurve(circle, 0, 2), gp::DY()), 0, 1},
      {"turned line", new Geom_SurfaceOfRevolution(line, gp_Ax1(frame.Location(), gp::DY())), 0, 1},
      {"turned Bezier curve",
       new Geom_SurfaceOfRevolution(chord, gp_Ax1(frame.Location(), gp::DY())), 0, 1, 0, 1},
      {"rational B-spline", spline, 0, 1},
      {"periodic B-spline", periodic, 0, 1},
      {"periodic B-spline, two periods on", periodic, 4 * pi, 4 * pi + 1},
      {"rational Bezier", new Geom_BezierSurface(poles, weights), 0, 1, 0, 1}};
}

TEST(Certified, EveryKindOfSurfaceThatRollsOffAPlane) {
  const double r = 8;
  for (const Rolling& rolling : rollingSurfaces(r)) {
    const TopoDS_Shape shape =
        joined({rolling.surface,
                beginningWith(3, rectangle(rolling.u0, rolling.u1, rolling.v0, rolling.v1))},
               {flatPlane(), beginningWith(1, rectangle(-4, 0, 0, 5))});
    const SeamResult seam = onlySeam(shape);
    SCOPED_TRACE(rolling.what + ": " + describe(seam));
    expectEncloses(seam.figures.gap_mm, 0, tolerance.gap_mm, 1e-9);
    expectEncloses(seam.figures.angle_rad, 0, tolerance.angle_rad, 1e-9);
    expectEncloses(seam.figures.curvature_per_mm, 1 / r, tolerance.curvature_rel / r, 1e-9);
    expectEncloses(seam.figures.curvature_rel, 1, tolerance.curvature_rel, 1e-9);
    expectCertain(seam, Level::G1, SeamClass::Smooth);
  }
}

/// Surfaces that touch the sphere of radius r along its parallel of that latitude, and what their
/// curvature differs by: along the parallel it is that of the sphere (Meusnier), along the meridian
/// their own.
TEST(Certified, ConeTorusAndTurnedCurvesThatTouchASphere) {
  const double r = 10, latitude = 0.5, tube = 4;
  const Surface sphere = new Geom_SphericalSurface(gp_Ax3(gp::XOY()), r);
  const opencascade::handle<Geom_Curve> meridian =
      new Geom_Circle(gp_Ax2(gp::Origin(), -gp::DY(), gp::DX()), r);
  const Surface turned = new Geom_SurfaceOfRevolution(meridian, gp::OZ());
  // The cone narrows upward; its reference circle is the parallel, v runs along the rulings.
  const gp_Ax3 at_parallel(gp_Pnt(0, 0, r * std::sin(latitude)), gp::DZ(), gp::DX());
  const Surface cone = new Geom_ConicalSurface(at_parallel, -latitude, r * std::cos(latitude));
  const gp_Ax3 at_tube(gp_Pnt(0, 0, (r - tube) * std::sin(latitude)), gp::DZ(), gp::DX());
  const Surface torus = new Geom_ToroidalSurface(at_tube, (r - tube) * std::cos(latitude), tube);
  struct Case {
    Surface below, above;
    double v, difference, relative;
  };
  const double of_torus = 1 / tube - 1 / r;
  for (const Case& c : {Case{sphere, cone, 0, 1 / r, 1}, Case{turned, cone, 0, 1 / r, 1},
                        Case{sphere, torus, latitude, of_torus, of_torus * tube},
                        Case{turned, torus, latitude, of_torus, of_torus * tube},
                        Case{turned, sphere, latitude, 0, 0}}) {
    const SeamResult seam =
        onlySeam(joined({c.below, beginningWith(2, rectangle(0.2, 1.7, 0.1, latitude))},
                        {c.above, rectangle(0.2, 1.7, c.v, c.v + 0.3)}));
    SCOPED_TRACE(std::string(c.below->DynamicType()->Name()) + c.above->DynamicType()->Name() +
                 describe(seam));
    expectEncloses(seam.figures.gap_mm, 0, tolerance.gap_mm, 1e-9);
    expectEncloses(seam.figures.angle_rad, 0, tolerance.angle_rad, 1e-9);
    expectEncloses(seam.figures.curvature_per_mm, c.difference, tolerance.curvature_rel / tube,
                   1e-9);
    expectEncloses(seam.figures.curvature_rel, c.relative, tolerance.curvature_rel, 1e-9);
    expectCertain(seam, c.difference > 0 ? Level::G1 : Level::G2, SeamClass::Smooth);
  }
}

TEST(Certified, EveryKindOfPathInTwoPlanes) {
  // Plane b is turned by the angle about the x axis: the planes share that line alone, so a path
  // over both is apart by 2 |y| sin(angle / 2).
  const double angle = 30 * degree;
  const Surface plane = flatPlane();
  const Surface tilted =
      new Geom_Plane(gp_Ax3(gp::Origin(), gp_Dir(0, -std::sin(angle), std::cos(angle)), gp::DX()));
  const gp_Ax2d axis(gp::Origin2d(), gp::DX2d());
  NCollection_Array1<gp_Pnt2d> poles(1, 3);
  poles(1) = gp_Pnt2d(0, 0);
  poles(2) = gp_Pnt2d(1, 0.01);
  poles(3) = gp_Pnt2d(2, 0);
  struct Case {
    Path path;
    double first, last, largest_y;
  };
  const double small = 0.005;  // so that the gap is within tolerance
  for (const Case& c :
       {Case{new Geom2d_Line(gp::Origin2d(), gp::DX2d()), -3, 4, 0},
        Case{new Geom2d_Circle(axis, small), 0, 2 * pi, small},
        Case{new Geom2d_Ellipse(axis, 3, small), 0, 2 * pi, small},
        Case{new Geom2d_Parabola(axis, 2), -small, small, small},
        Case{new Geom2d_Hyperbola(axis, 3, small), -std::asinh(1), std::asinh(1), small},
        Case{new Geom2d_BezierCurve(poles), 0, 1, small}}) {
    const SeamResult seam =
        onlySeam(alongEdge(plane, c.path, tilted, c.path, c.first, c.last, 0.01));
    SCOPED_TRACE(std::string(c.path->DynamicType()->Name()) + describe(seam));
    expectEncloses(seam.figures.gap_mm, 2 * c.largest_y * std::sin(angle / 2), tolerance.gap_mm,
                   1e-9);
    expectEncloses(seam.figures.angle_rad, angle, tolerance.angle_rad, 1e-9);
    expectCertain(seam, Level::G0, SeamClass::Crease);
  }
}

void expectSampled(const TopoDS_Shape& shape, const std::string& reason) {
  const SeamResult seam = onlySeam(shape);
  SCOPED_TRACE(describe(seam));
  EXPECT_FALSE(seam.figures.certified);
  EXPECT_FALSE(seam.verdict.certain);
  EXPECT_THAT(seam.figures.uncertified, HasSubstr(reason));
  ASSERT_TRUE(seam.figures.gap_mm && seam.figures.angle_rad);
  EXPECT_FALSE(seam.figures.gap_mm->upper || seam.figures.angle_rad->upper);
  EXPECT_EQ(seam.verdict.level, Level::G2);
}

TEST(Certified, KindsThatAreNotEnclosedAreSampledAndSaySo) {
  const gp_Ax2d axis(gp::Origin2d(), gp::DX2d());
  const Path offset = new Geom2d_OffsetCurve(new Geom2d_Circle(axis, 3), 0.5);
  expectSampled(alongEdge(flatPlane(), offset, flatPlane(), offset, 0, 2), "Geom2d_OffsetCurve");
  const Surface patch = new Geom_RectangularTrimmedSurface(flatPlane(), 0.0, 1.0, 0.0, 1.0);
  const opencascade::handle<TColGeom_HArray2OfSurface> patches =
      new TColGeom_HArray2OfSurface(1, 1, 1, 1);
  patches->SetValue(1, 1, patch);
  const opencascade::handle<ShapeExtend_CompositeSurface> composite =
      new ShapeExtend_CompositeSurface();
  ASSERT_TRUE(composite->Init(patches));
  const Path line = new Geom2d_Line(gp_Pnt2d(0, 0.5), gp::DX2d());
  expectSampled(alongEdge(Surface(composite.get()), line, flatPlane(), line, 0, 1),
                "ShapeExtend_CompositeSurface");
}

TEST(Certified, APoleThatIsNotFiniteIsSaid) {
  const auto sheet = opencascade::handle<Geom_BSplineSurface>::DownCast(splineSheet(
      {0, 1, 2, 3}, 3, {0, 1}, 1, [](int, int, double u, double v) { return gp_Pnt(u, v, 0); }));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  sheet->SetPole(6, 2, gp_Pnt(nan, nan, nan));  // far from the seam's part of the surface
  const Path line = new Geom2d_Line(gp_Pnt2d(0, 0), gp::DX2d());
  const SeamResult seam =
      onlySeam(alongEdge(Surface(sheet.get()), line, flatPlane(), line, 0, 0.9));
  EXPECT_FALSE(seam.figures.certified || seam.verdict.certain);
  EXPECT_THAT(seam.figures.uncertified, HasSubstr("not finite"));
}

TEST(Certified, PolesAreNamedAndTheRestIsCertified) {
  const TopoDS_Shape sphere =
      BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeSphere(10).Shape(), true).Shape();
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(5, 0, 12).Shape();
  const TopoDS_Shape cone_spline = BRepBuilderAPI_NurbsConvert(cone, true).Shape();
  int closed = 0;
  for (const TopoDS_Shape& shape : {sphere, cone, cone_spline})
    for (const SeamResult& seam : analyzed(shape).seams) {
      if (seam.kind != occ::SeamKind::Closed) continue;
      ++closed;
      SCOPED_TRACE(describe(seam));
      EXPECT_THAT(seam.note, HasSubstr("vanishing normal on face 1 at "));
      EXPECT_NEAR(seam.figures.plane_share, 1, 0x1p-28)
          << "the surface has a tangent plane up to the pole";
      expectCertain(seam, Level::G2, SeamClass::Smooth);
    }
  EXPECT_GT(closed, 2);
}

TEST(Certified, MoreKnotsThanTheWorkLimitEndsWithAReason) {
  const int spans = 31'000;
  const Surface sheet =
      splineSheet({0, 1}, 1, evenly(0, spans, spans), 3,
                  [](int, int, double u, double v) { return gp_Pnt(u, 0.01 * v, 0); });
  const SeamResult seam =
      onlySeam(joined({sheet, beginningWith(3, rectangle(0, 1, 0, spans))},
                      {flatPlane(), beginningWith(1, rectangle(-1, 0, 0, 0.01 * spans))}));
  SCOPED_TRACE(describe(seam));
  EXPECT_FALSE(seam.figures.certified || seam.verdict.certain);
  EXPECT_THAT(seam.figures.uncertified, HasSubstr("pieces"));
  EXPECT_EQ(seam.verdict.level, Level::G2) << "as sampled";
}

TEST(Certified, PathsThatRunAtDifferentSpeedsAreApart) {
  // The same line with y = L t on one side, y = L t^2 on the other: at equal parameters L (t - t^2)
  // apart, L
  // / 4 at most.
  const double length = 8;
  NCollection_Array1<gp_Pnt2d> poles(1, 3);
  poles(1) = gp_Pnt2d(0, 0);
  poles(2) = gp_Pnt2d(0, 0);
  poles(3) = gp_Pnt2d(0, length);
  const Path slow = new Geom2d_BezierCurve(poles);
  poles(2) = gp_Pnt2d(0, length / 2);
  const Path even = new Geom2d_BezierCurve(poles);
  const SeamResult seam = onlySeam(alongEdge(flatPlane(), even, flatPlane(), slow, 0, 1, length));
  SCOPED_TRACE(describe(seam));
  expectEncloses(seam.figures.gap_mm, length / 4, tolerance.gap_mm, 1e-9);
  expectCertain(seam, Level::None, SeamClass::Defect);
}

void expectOverlap(const std::optional<Figure>& a, const std::optional<Figure>& b, double factor,
                   double noise) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  ASSERT_TRUE(a->upper && b->upper);
  EXPECT_LE(a->lower, *b->upper * factor + noise);
  EXPECT_LE(b->lower * factor, *a->upper + noise);
}

/// \param scale of lengths. \param noise_rad by which rounding of the moved poles turns normals.
void expectSameSeam(const SeamResult& seam, const SeamResult& moved, double scale,
                    double noise_rad) {
  SCOPED_TRACE(describe(seam) + "\n" + describe(moved));
  EXPECT_EQ(seam.verdict.level, moved.verdict.level);
  EXPECT_EQ(seam.verdict.seam_class, moved.verdict.seam_class);
  EXPECT_EQ(seam.verdict.certain, moved.verdict.certain);
  expectOverlap(seam.figures.gap_mm, moved.figures.gap_mm, 1 / scale, noise_rad);
  expectOverlap(seam.figures.angle_rad, moved.figures.angle_rad, 1, noise_rad);
  expectOverlap(seam.figures.curvature_per_mm, moved.figures.curvature_per_mm, scale,
                100 * noise_rad);
  expectOverlap(seam.figures.curvature_rel, moved.figures.curvature_rel, 1, 1e4 * noise_rad);
}

TEST(Certified, TheSameUnderMotionScaleMirrorSwapAndReversal) {
  std::mt19937 random(testSeed());
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Surface wavy =
      splineSheet(evenly(0, 6, 6), 3, evenly(0, 10, 10), 3, [&](int i, int, double u, double v) {
        return gp_Pnt(u, v, i == 1 ? 0.02 * uniform(random) : 0.01 * i * i);
      });
  const TopoDS_Shape wavy_seam = joined({wavy, beginningWith(3, rectangle(0, 6, 0, 10))},
                                        {flatPlane(), beginningWith(1, rectangle(-4, 0, 0, 10))});
  for (const TopoDS_Shape& shape :
       {wavy_seam, hiddenBump(120, 0.004), crossedCylinders(10), sphereAndTorus(10, 9),
        planeAndCylinder(10, 5), foldedPlanes()}) {
    const SeamResult seam = onlySeam(shape);
    EXPECT_TRUE(seam.verdict.certain) << describe(seam);
    const auto expect_same = [&](const TopoDS_Shape& moved, double scale, double noise_rad) {
      expectSameSeam(seam, onlySeam(moved), scale, noise_rad);
    };
    for (int trial = 0; trial < 5; ++trial) {
      const gp_Trsf motion = randomMotion(random);
      gp_Trsf far, mirror;
      far.SetTranslation(gp_Vec(1e5, -1e5, 1e5));
      mirror.SetMirror(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(1, 2, -0.5)));
      expect_same(transformed(shape, motion), 1, 1e-9);
      expect_same(located(shape, motion), 1, 1e-9);
      expect_same(transformed(shape, far * motion), 1, 1e-7);
      expect_same(located(shape, far * motion), 1, 1e-7);
      expect_same(transformed(shape, mirror * motion), 1, 1e-9);
      expect_same(located(shape, mirror * motion), 1, 1e-9);
    }
    expect_same(facesSwappedAndReversed(shape), 1, 1e-9);
    expect_same(shape.Reversed(), 1, 1e-9);
    gp_Trsf larger;  // not so large that the gap leaves its tolerance
    larger.SetScale(gp_Pnt(1, 2, 3), 1.5);
    const SeamResult scaled = onlySeam(transformed(shape, larger));
    EXPECT_EQ(seam.verdict.seam_class, scaled.verdict.seam_class);
    expectSameSeam(seam, scaled, 1.5, 1e-9);
  }
}

}  // namespace

TEST(Certified, AFaceThatMeetsItselfWithOnePcurveIsNotCertain) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(5, 10).Shape();
  for (TopExp_Explorer faces(cylinder, TopAbs_FACE); faces.More(); faces.Next())
    for (TopExp_Explorer edges(faces.Current(), TopAbs_EDGE); edges.More(); edges.Next()) {
      const TopoDS_Face face = TopoDS::Face(faces.Current());
      const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
      double first = 0, last = 0;
      if (BRep_Tool::IsClosed(edge, face))
        BRep_Builder().UpdateEdge(edge, BRep_Tool::CurveOnSurface(edge, face, first, last), face,
                                  1e-7);
    }
  const occ::Report report = analyzed(cylinder);
  const auto closed = std::ranges::find(report.seams, occ::SeamKind::Closed, &SeamResult::kind);
  ASSERT_NE(closed, report.seams.end());
  EXPECT_FALSE(closed->verdict.certain);
  EXPECT_THAT(closed->figures.uncertified, HasSubstr("one pcurve"));
}

}  // namespace seamwright::test
