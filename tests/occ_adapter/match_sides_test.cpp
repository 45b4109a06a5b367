// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "match_pairs.hpp"
#include "shapes.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/match/match_sides.hpp>

namespace seamwright::test {
namespace {

using occ::matchSides;
using occ::SideMatch;
using occ::SideMatchOptions;
using occ::SideMatchReport;

/// A surface in closed form: signed distance, unit normal and normal curvature in a direction.
struct Analytic {
  std::function<double(const gp_Pnt&)> distance;
  std::function<gp_Vec(const gp_Pnt&)> normal;
  std::function<double(const gp_Pnt&, const gp_Vec&)> curvature;
  double largest_curvature = 0;
};

const Analytic plane_z = {[](const gp_Pnt& p) { return p.Z(); },
                          [](const gp_Pnt&) { return gp_Vec(0, 0, 1); },
                          [](const gp_Pnt&, const gp_Vec&) { return 0.0; }, 0};

/// Around the x axis.
Analytic cylinder(double r) {
  return {[r](const gp_Pnt& p) { return std::hypot(p.Y(), p.Z()) - r; },
          [](const gp_Pnt& p) { return gp_Vec(0, p.Y(), p.Z()).Normalized(); },
          [r](const gp_Pnt&, const gp_Vec& way) {
            return -(1 - way.X() * way.X() / way.SquareMagnitude()) / r;
          },
          1 / r};
}

Analytic sphere(double r) {
  return {[r](const gp_Pnt& p) { return gp_Vec(p.XYZ()).Magnitude() - r; },
          [](const gp_Pnt& p) { return gp_Vec(p.XYZ()).Normalized(); },
          [r](const gp_Pnt&, const gp_Vec&) { return -1 / r; }, 1 / r};
}

/// The graph z = 0.002 x^2 + 0.001 x y.
const Analytic bowl = {
    [](const gp_Pnt& p) { return p.Z() - 0.002 * p.X() * p.X() - 0.001 * p.X() * p.Y(); },
    [](const gp_Pnt& p) {
      return gp_Vec(-0.004 * p.X() - 0.001 * p.Y(), -0.001 * p.X(), 1).Normalized();
    },
    [](const gp_Pnt& p, const gp_Vec& way) {
      const double slope = std::hypot(0.004 * p.X() + 0.001 * p.Y(), 0.001 * p.X());
      return (0.004 * way.X() * way.X() + 0.002 * way.X() * way.Y()) / std::hypot(1, slope) /
             way.SquareMagnitude();
    },
    0.004};

/// Dense evaluation by OpenCASCADE of the moved face along a path of its parameters.
void expectJoins(const TopoDS_Face& moved, const std::function<gp_Pnt2d(double)>& path,
                 const Analytic& other, int order, const ContinuityTolerance& tolerance = {}) {
  const handle<Geom_Surface> surface = BRep_Tool::Surface(moved);
  double gap = 0, angle = 0, bend = 0;
  for (int k = 0; k <= 1000; ++k) {
    const gp_Pnt2d uv = path(k / 1000.0);
    gp_Pnt p;
    gp_Vec u, v, uu, vv, uv2;
    surface->D2(uv.X(), uv.Y(), p, u, v, uu, vv, uv2);
    gap = std::max(gap, std::abs(other.distance(p)));
    gp_Vec normal = u.Crossed(v).Normalized();
    if (normal.Dot(other.normal(p)) < 0) normal.Reverse();
    angle = std::max(angle, normal.Angle(other.normal(p)));
    for (int i = 0; i < 8; ++i) {
      const double a = std::cos(i * std::numbers::pi / 8), b = std::sin(i * std::numbers::pi / 8);
      const gp_Vec way = a * u.Normalized() + b * v.Normalized();
      const double du = a / u.Magnitude(), dv = b / v.Magnitude();
      const double own =
          normal.Dot(du * du * uu + 2 * du * dv * uv2 + dv * dv * vv) / way.SquareMagnitude();
      bend = std::max(bend, std::abs(own - other.curvature(p, way)));
    }
  }
  EXPECT_LE(gap, tolerance.gap_mm);
  if (order > 0) {
    EXPECT_LE(angle, tolerance.angle_rad);
  }
  if (order > 1) {
    EXPECT_LE(bend, std::max(tolerance.curvature_rel * other.largest_curvature,
                             1 / tolerance.flat_radius_mm));
  }
}

/// A spline whose poles are points (x, t) of a map, at Greville abscissae of [0, 1].
Spline mapped(const std::function<gp_Pnt(double, double)>& map, int count = 4) {
  const Spline flat = [&] {
    TColgp_Array2OfPnt poles(1, count, 1, count);
    return splineOf(poles, 3, 3);
  }();
  const auto place = [&](int i) {
    const TColStd_Array1OfReal& knots = flat->UKnotSequence();
    return (knots(i + 1) + knots(i + 2) + knots(i + 3)) / 3;
  };
  for (int i = 1; i <= count; ++i)
    for (int j = 1; j <= count; ++j) flat->SetPole(i, j, map(place(i), place(j)));
  return flat;
}

/// The number of the edge of a face whose middle is nearest to a point.
int edgeNear(const TopoDS_Shape& shape, int face_number, const gp_Pnt& point) {
  TopTools_IndexedMapOfShape all, own;
  TopExp::MapShapes(shape, TopAbs_EDGE, all);
  TopExp::MapShapes(face(shape, face_number), TopAbs_EDGE, own);
  int nearest = 0;
  double distance = 1e9;
  for (int e = 1; e <= own.Extent(); ++e) {
    const TopoDS_Edge edge = TopoDS::Edge(own(e));
    if (BRep_Tool::Degenerated(edge)) continue;
    const BRepAdaptor_Curve curve(edge);
    const double here =
        curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2).Distance(point);
    if (here < distance) {
      distance = here;
      nearest = all.FindIndex(edge);
    }
  }
  return nearest;
}

TopoDS_Edge edgeOf(const TopoDS_Shape& shape, int number) {
  TopTools_IndexedMapOfShape all;
  TopExp::MapShapes(shape, TopAbs_EDGE, all);
  return TopoDS::Edge(all(number));
}

TopoDS_Face faceOn(const handle<Geom_Surface>& surface, double u0, double u1, double v0,
                   double v1) {
  return BRepBuilderAPI_MakeFace(surface, u0, u1, v0, v1, 1e-7).Face();
}

/// A strip beside the line x = 0, y from 0 to 40: its rows leave the plane more and more.
Spline risingSheet(std::mt19937& generator, double slope, double noise_mm) {
  return mapped(
      [&](double s, double t) {
        return gp_Pnt(60 * s, 40 * t, slope * 60 * s + random(generator, noise_mm));
      },
      7);
}

TopoDS_Shape besidePlates(const Spline& sheet, const std::vector<double>& ends_y) {
  std::vector<TopoDS_Shape> faces = {wholeFace(sheet)};
  for (std::size_t k = 1; k < ends_y.size(); ++k)
    faces.push_back(plate(-30, 0, ends_y[k - 1], ends_y[k]));
  return compoundOf(faces);
}

void expectMatchedSides(const SideMatchReport& report, const TopoDS_Shape& given) {
  ASSERT_TRUE(report.matched) << report.text();
  EXPECT_TRUE(BRepCheck_Analyzer(report.shape).IsValid());
  for (const TopAbs_ShapeEnum kind : {TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
    TopTools_IndexedMapOfShape before, after;
    TopExp::MapShapes(given, kind, before);
    TopExp::MapShapes(report.shape, kind, after);
    EXPECT_EQ(before.Extent(), after.Extent());
  }
}

gp_Pnt2d alongV(double share) {
  return {0, share};
}

TEST(MatchSides, AChainOfPlanesInClosedForm) {
  std::mt19937 generator(testSeed());
  for (const int order : {0, 1, 2}) {
    const TopoDS_Shape model = besidePlates(risingSheet(generator, 0.03, 0.03), {0, 11, 27, 40});
    const SideMatchReport report =
        matchSides(model, 1, {{.side = {{edgeNear(model, 1, {0, 20, 0})}}, .order = order}});
    expectMatchedSides(report, model);
    EXPECT_EQ(report.seams.size(), 3);
    expectJoins(face(report.shape, 1), alongV, plane_z, order);
    for (int other = 2; other <= 4; ++other)
      EXPECT_EQ(BRep_Tool::Surface(face(report.shape, other)),
                BRep_Tool::Surface(face(model, other)));
  }
}

/// A face that ends at a knot of its surface, beyond which the curvature is another one.
TEST(MatchSides, AFaceThatEndsAtAKnotIsJudgedOnItsOwnSide) {
  constexpr double knot = 0.5;
  const Spline sheet = mapped(
      [](double s, double t) { return gp_Pnt(60 * s - 30, 40 * t, 0.02 * (60 * s - 30)); }, 7);
  sheet->InsertUKnot(knot, 3, 1e-9);
  for (int i = 1; i <= sheet->NbUPoles(); ++i)
    for (int j = 1; j <= sheet->NbVPoles(); ++j) {
      const gp_Pnt pole = sheet->Pole(i, j);
      // The row behind the knot stays: the tangent planes agree there.
      if (pole.X() > 6) sheet->SetPole(i, j, pole.Translated(gp_Vec(0, 0, 5)));
    }
  SideMatchOptions options;
  options.fairness = 100;
  for (const int order : {1, 2}) {
    const TopoDS_Shape model = compoundOf({faceOn(sheet, 0, knot, 0, 1), plate(0, 30, 0, 40)});
    const SideMatchReport report = matchSides(
        model, 1, {{.side = {{edgeNear(model, 1, {0, 20, 0})}}, .order = order}}, options);
    expectMatchedSides(report, model);
    expectJoins(
        face(report.shape, 1), [](double share) { return gp_Pnt2d(knot - 1e-9, share); }, plane_z,
        order);
  }
}

/// Two faces of a surface of revolution about the x axis, up to x = 0, and a spline behind them.
TEST(MatchSides, ChainsOfACylinderAndOfASphereInClosedForm) {
  std::mt19937 generator(testSeed());
  constexpr double r = 25;
  const gp_Ax3 axis(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0), gp_Dir(0, 0, 1));
  for (const bool round : {false, true})
    for (const int order : {1, 2}) {
      const double x0 = round ? 10 : 0, radius = std::sqrt(r * r - x0 * x0);
      const Spline sheet = mapped(
          [&](double s, double t) {
            const double angle = 0.8 * (t - 0.5), x = x0 + 12 * s;
            const double here = round ? std::sqrt(r * r - x * x) : r;
            return gp_Pnt(x, -(here + random(generator, 0.04)) * std::sin(angle),
                          (here + 0.4 * s) * std::cos(angle));
          },
          9);
      handle<Geom_Surface> surface;
      double v0 = -20, v1 = 0;
      if (round) {
        surface = new Geom_SphericalSurface(axis, r);
        v0 = 0;
        v1 = std::asin(x0 / r);
      } else {
        surface = new Geom_CylindricalSurface(axis, r);
      }
      const TopoDS_Shape model = compoundOf({wholeFace(sheet), faceOn(surface, -0.4, 0.1, v0, v1),
                                             faceOn(surface, 0.1, 0.4, v0, v1)});
      SideMatchOptions options;
      options.match_mm = 0.5;
      options.depth_mm = 9;
      const SideMatchReport report = matchSides(
          model, 1, {{.side = {{edgeNear(model, 1, {x0, 0, radius})}}, .order = order}}, options);
      expectMatchedSides(report, model);
      EXPECT_EQ(report.seams.size(), 2);
      expectJoins(face(report.shape, 1), alongV, round ? sphere(r) : cylinder(r), order);
    }
}

/// The largest distance of points of two surfaces of equal parameters in a rectangle.
double largestMove(const Spline& a, const Spline& b, double u0, double u1, double v0, double v1) {
  double largest = 0;
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 60; ++j) {
      const double u = u0 + (u1 - u0) * i / 60, v = v0 + (v1 - v0) * j / 60;
      largest = std::max(largest, a->Value(u, v).Distance(b->Value(u, v)));
    }
  return largest;
}

TEST(MatchSides, TheChangeEndsAtTheDepth) {
  std::mt19937 generator(testSeed());
  const Spline sheet = risingSheet(generator, 0.02, 0);
  const TopoDS_Shape model = besidePlates(sheet, {0, 20, 40});
  for (const double depth_mm : {6.0, 20.0}) {
    SideMatchOptions options;
    options.depth_mm = depth_mm;
    options.fairness = 100;
    const SideMatchReport report =
        matchSides(model, 1, {{.side = {{edgeNear(model, 1, {0, 20, 0})}}}}, options);
    expectMatchedSides(report, model);
    const Spline after = Spline::DownCast(BRep_Tool::Surface(face(report.shape, 1)));
    // The sheet runs at 60 mm per unit of u, times the slope.
    const double end = depth_mm / (60 * std::hypot(1, 0.02));
    EXPECT_LT(largestMove(sheet, after, end + 1e-6, 1, 0, 1), 1e-10);
    EXPECT_GT(largestMove(sheet, after, 0, end, 0, 1), 0.002);
    EXPECT_LE(report.depth_mm, depth_mm * 1.001);
    EXPECT_GT(report.depth_mm, depth_mm / 2);
  }
}

TEST(MatchSides, APartOfASideJoinsAndTheRestStays) {
  std::mt19937 generator(testSeed());
  const Spline sheet = risingSheet(generator, 0.02, 0);
  SideMatchOptions options;
  options.depth_mm = 8;
  options.fairness = 100;
  // The plate is beside a part of the side; and a part of the side is chosen.
  for (const bool chosen : {false, true}) {
    const TopoDS_Shape model = besidePlates(sheet, {0, chosen ? 40.0 : 20.0});
    SideMatch side{.side = {{edgeNear(model, 1, {0, 20, 0})}}};
    if (chosen) side.to = 0.5;
    const SideMatchReport report = matchSides(model, 1, {side}, options);
    ASSERT_TRUE(report.matched) << report.text();
    const TopoDS_Face moved = face(report.shape, 1);
    const bool from_low = BRepAdaptor_Curve(edgeOf(model, side.side.edges[0])).Value(0).Y() < 20;
    const auto part = [&](double share) {
      return gp_Pnt2d(0, chosen && !from_low ? 1 - 0.5 * share : 0.5 * share);
    };
    expectJoins(moved, part, plane_z, 1);
    const Spline after = Spline::DownCast(BRep_Tool::Surface(moved));
    const double fade = 8.0 / 40 + 1e-3;
    if (part(1).Y() < 0.6 && part(0).Y() < 0.1)
      EXPECT_LT(largestMove(sheet, after, 0, 1, 0.5 + fade, 1), 1e-10);
    else
      EXPECT_LT(largestMove(sheet, after, 0, 1, 0, 0.5 - fade), 1e-10);
  }
}

TEST(MatchSides, TwoSidesJoinAtTheirCommonCorner) {
  std::mt19937 generator(testSeed());
  const Spline sheet = mapped(
      [&](double s, double t) {
        return gp_Pnt(60 * s, 40 * t, 0.6 * s * t + random(generator, 0.03));
      },
      7);
  for (const int order : {1, 2}) {
    const TopoDS_Shape model =
        compoundOf({wholeFace(sheet), plate(-30, 0, 0, 40), plate(0, 60, -30, 0)});
    const SideMatchReport report = matchSides(
        model, 1,
        {{.side = {.edges = {edgeNear(model, 1, {0, 20, 0})}, .name = "left"}, .order = order},
         {.side = {.edges = {edgeNear(model, 1, {30, 0, 0})}, .name = "front"}, .order = order}});
    expectMatchedSides(report, model);
    expectJoins(face(report.shape, 1), alongV, plane_z, order);
    expectJoins(
        face(report.shape, 1), [](double share) { return gp_Pnt2d(share, 0); }, plane_z, order);
  }
}

/// A tube of splines behind a whole cylinder, closed along a knot line or periodic.
TEST(MatchSides, ClosedLoopsInClosedForm) {
  constexpr double r = 25;
  const gp_Ax3 axis(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0), gp_Dir(0, 0, 1));
  const handle<Geom_Surface> cylindrical = new Geom_CylindricalSurface(axis, r);
  const double all = 2 * std::numbers::pi;
  for (const bool periodic : {false, true}) {
    const handle<Geom_Surface> part =
        new Geom_RectangularTrimmedSurface(cylindrical, 0.0, all, 0.0, 40.0);
    const Spline tube = GeomConvert::SurfaceToBSplineSurface(part);
    if (!periodic) tube->SetUNotPeriodic();
    tube->IncreaseDegree(tube->UDegree(), 3);
    const int columns = tube->NbUPoles();
    for (int i = 1; i <= columns; ++i)
      for (int j = 1; j <= tube->NbVPoles(); ++j) {
        const gp_Pnt pole = tube->Pole(i, j);
        const double flare = 1 + 0.02 * pole.X() / 40;
        tube->SetPole(i, j, gp_Pnt(pole.X(), flare * pole.Y(), flare * pole.Z()));
      }
    const TopoDS_Shape model =
        compoundOf({faceOn(tube, 0, all, 0, 40), faceOn(cylindrical, 0, all, -30, 0)});
    for (const int order : {1, 2}) {
      const SideMatchReport report =
          matchSides(model, 1, {{.side = {{edgeNear(model, 1, {0, 0, -r})}}, .order = order}});
      expectMatchedSides(report, model);
      expectJoins(
          face(report.shape, 1), [all](double share) { return gp_Pnt2d(all * share, 0); },
          cylinder(r), order);
      const handle<Geom_Surface> after = BRep_Tool::Surface(face(report.shape, 1));
      for (double v = 0; v <= 40; ++v) {
        gp_Pnt p, q;
        gp_Vec pu, pv, qu, qv;
        after->D1(0, v, p, pu, pv);
        after->D1(all, v, q, qu, qv);
        EXPECT_LT(p.Distance(q), 1e-5) << "a thousandth of the gap: the tube stays closed";
        EXPECT_LT(pu.Angle(qu), 1e-5);
      }
    }
  }
}

TEST(MatchSides, AveragedSidesMeetInTheMiddle) {
  std::mt19937 generator(testSeed());
  const Spline left =
      mapped([](double s, double t) { return gp_Pnt(-60 + 60 * s, 40 * t, 0.02 * 60 * (s - 1)); });
  const Spline right =
      mapped([](double s, double t) { return gp_Pnt(60 * s, 40 * t, -0.02 * 60 * s); });
  const TopoDS_Shape model = compoundOf({wholeFace(left), wholeFace(right)});
  SideMatchOptions options;
  options.average = true;
  for (const int order : {1, 2}) {
    const SideMatchReport report = matchSides(
        model, 2, {{.side = {{edgeNear(model, 2, {0, 20, 0})}}, .order = order}}, options);
    expectMatchedSides(report, model);
    ASSERT_EQ(report.moves.size(), 2);
    // By symmetry the mean plane is that of z = 0.
    expectJoins(face(report.shape, 2), alongV, plane_z, order);
    expectJoins(
        face(report.shape, 1), [](double share) { return gp_Pnt2d(1, share); }, plane_z, order);
  }
}

/// Each neighbour takes its own way to the mean, so that the edges between them part.
TEST(MatchSides, AveragedNeighboursThatJoinOneAnotherAreNotMovedApart) {
  const auto leftBetween = [](double low, double high) {
    return wholeFace(mapped([=](double s, double t) {
      return gp_Pnt(-60 + 60 * s, low + (high - low) * t, 0.02 * 60 * (s - 1));
    }));
  };
  const Spline right = mapped([](double s, double t) {
    return gp_Pnt(60 * s, 40 * t, -24 * t * s * (1 + s) + 0.08 * t * t);
  });
  const TopoDS_Shape model = compoundOf({leftBetween(0, 6), leftBetween(6, 40), wholeFace(right)});
  const std::vector<SideMatch> side = {{.side = {{edgeNear(model, 3, {0, 20, 0})}}, .order = 2}};
  SideMatchOptions options;
  expectMatchedSides(matchSides(model, 3, side, options), model);
  options.average = true;
  const SideMatchReport report = matchSides(model, 3, side, options);
  EXPECT_FALSE(report.matched);
  EXPECT_EQ(report.code(), "neighbours_apart") << report.text();
  EXPECT_EQ(report.remedy(), "let one face move instead of both");
  EXPECT_TRUE(report.shape.IsSame(model));
}

/// The side runs along a curve inside of the parameter rectangle.
TEST(MatchSides, ATrimmedSideInClosedForm) {
  // Poles of a bowl in Bernstein form: those of s^2 are 0, 0, 1/3, 1.
  const auto bowlWith = [](double rise) {
    return mapped([rise](double s, double t) {
      const double square = s * (3 * s - 1) / 2;
      return gp_Pnt(60 * s, 40 * t,
                    0.002 * 3600 * square + 0.001 * 2400 * s * t + rise * (s - 0.4));
    });
  };
  const Spline flat = bowlWith(0), risen = bowlWith(0.6);
  const handle<Geom2d_BSplineCurve> path = curvedPath(
      {gp_Pnt2d(0.4, 0.1), gp_Pnt2d(0.43, 0.35), gp_Pnt2d(0.39, 0.6), gp_Pnt2d(0.41, 0.9)});
  const TopoDS_Shape model =
      loose(trimmedFace(flat, path, gp_Vec2d(-0.3, 0)), trimmedFace(risen, path, gp_Vec2d(0.5, 0)));
  const gp_Pnt2d middle = path->Value(0.5);
  for (const int order : {1, 2}) {
    const SideMatchReport report = matchSides(
        model, 2,
        {{.side = {{edgeNear(model, 2, flat->Value(middle.X(), middle.Y()))}}, .order = order}});
    expectMatchedSides(report, model);
    expectJoins(
        face(report.shape, 2), [&](double share) { return path->Value(share); }, bowl, order);
    FaceMatchOptions options;
    options.order = order;
    EXPECT_TRUE(matchFaces(model, 1, 2, options).matched);
  }
}

TEST(MatchSides, AWavyFaceIsRefusedWithItsFigures) {
  std::mt19937 generator(testSeed());
  const TopoDS_Shape model = besidePlates(risingSheet(generator, 0.1, 0), {0, 40});
  const SideMatch side{.side = {{edgeNear(model, 1, {0, 20, 0})}}, .order = 2};
  SideMatchOptions options;
  options.depth_mm = 1;
  const SideMatchReport refused = matchSides(model, 1, {side}, options);
  EXPECT_FALSE(refused.matched);
  EXPECT_EQ(refused.code(), "less_fair") << refused.text();
  EXPECT_NE(refused.remedy().find("depth"), std::string::npos);
  ASSERT_EQ(refused.moves.size(), 1);
  ASSERT_TRUE(refused.moves[0].surface);
  EXPECT_GT(refused.moves[0].surface->after.variation_per_mm,
            10 * refused.moves[0].surface->before.variation_per_mm);
  EXPECT_TRUE(refused.shape.IsSame(model));
}

TEST(MatchSides, APlaneIsConvertedOnlyIfAllowed) {
  const Spline sheet = mapped(
      [](double s, double t) { return gp_Pnt(-60 + 60 * s, 40 * t, 0.3 * s * (1 - s) * t); });
  const TopoDS_Shape model = compoundOf({plate(0, 60, 0, 40), wholeFace(sheet)});
  const SideMatch side{.side = {{edgeNear(model, 1, {0, 20, 0})}}};
  SideMatchOptions options;
  const SideMatchReport refused = matchSides(model, 1, {side}, options);
  EXPECT_EQ(refused.code(), "face_without_poles");
  EXPECT_NE(refused.remedy().find("convert"), std::string::npos);
  options.convert = true;
  options.fairness = 100;
  const SideMatchReport report = matchSides(model, 1, {side}, options);
  expectMatchedSides(report, model);
  EXPECT_NE(report.text().find("became a spline"), std::string::npos) << report.text();
}

TEST(MatchSides, AFaceOfAPartWithTwoInstancesIsRefusedWithARemedy) {
  std::mt19937 generator(testSeed());
  const TopoDS_Shape part = besidePlates(risingSheet(generator, 0.03, 0), {0, 40});
  gp_Trsf away;
  away.SetTranslation(gp_Vec(0, 0, 200));
  const TopoDS_Shape model = compoundOf({part, part.Moved(TopLoc_Location(away))});
  const SideMatchReport report =
      matchSides(model, 1, {{.side = {{edgeNear(model, 1, {0, 20, 0})}}}});
  EXPECT_FALSE(report.matched);
  EXPECT_EQ(report.code(), "face_instances");
  EXPECT_EQ(report.remedy(), "match the part alone, and place it again");
  EXPECT_TRUE(report.shape.IsSame(model));
  EXPECT_TRUE(matchSides(part, 1, {{.side = {{edgeNear(part, 1, {0, 20, 0})}}}}).matched);
}

TEST(MatchSides, BadArgumentsAreNamed) {
  std::mt19937 generator(testSeed());
  const TopoDS_Shape model = besidePlates(risingSheet(generator, 0.03, 0), {0, 40});
  const SideMatch side{.side = {{edgeNear(model, 1, {0, 20, 0})}}};
  EXPECT_THROW(matchSides(model, 9, {side}), std::invalid_argument);
  EXPECT_THROW(matchSides(model, 1, {}), std::invalid_argument);
  SideMatch part = side;
  part.from = 0.8;
  part.to = 0.2;
  EXPECT_THROW(matchSides(model, 1, {part}), std::invalid_argument);
  SideMatchOptions options;
  options.depth_mm = -1;
  EXPECT_THROW(matchSides(model, 1, {side}, options), std::invalid_argument);
  SideMatch away = side;
  away.side.edges = {edgeNear(model, 1, {60, 20, 0})};
  EXPECT_EQ(matchSides(model, 1, {away}).code(), "side_is_free");
}

}  // namespace
}  // namespace seamwright::test
