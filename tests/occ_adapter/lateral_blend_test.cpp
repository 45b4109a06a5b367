// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GC_MakeArcOfCircle.hxx>
#include <GC_MakeSegment.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <cmath>
#include <functional>
#include <gp_Elips.hxx>
#include <gp_Pln.hxx>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "match_pairs.hpp"
#include "strict_blend.hpp"

#include <seamwright/occ_adapter/blend/blend_surface.hpp>

namespace seamwright::test {
namespace {

using occ::BlendEnd;
using occ::blendSurface;
using occ::BlendSurfaceOptions;
using occ::BlendSurfaceReport;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Two faces and the curves of lateral boundaries beside them.
struct Gap {
  TopoDS_Shape shape;
  int start = 0, end = 0;
  std::vector<int> lateral = {};
  std::vector<TopoDS_Edge> curves = {};
};

Gap gapOf(const std::vector<TopoDS_Shape>& faces, const std::vector<TopoDS_Edge>& curves,
          const gp_Pnt& start, const gp_Pnt& end) {
  std::vector<TopoDS_Shape> parts = faces;
  parts.insert(parts.end(), curves.begin(), curves.end());
  Gap gap{compoundOf(parts)};
  gap.start = edgeNear(gap.shape, start);
  gap.end = edgeNear(gap.shape, end);
  const TopTools_IndexedMapOfShape edges = partsOf(gap.shape, TopAbs_EDGE);
  for (const TopoDS_Edge& curve : curves) gap.lateral.push_back(edges.FindIndex(curve));
  gap.curves = curves;
  return gap;
}

BlendSurfaceReport blended(const Gap& gap, int m, int n, BlendSurfaceOptions options = strictly(),
                           int order = 0) {
  options.lateral.edges = gap.lateral;
  options.lateral.order = order;
  return blendSurface(gap.shape, {.side = {{gap.start}}, .order = m},
                      {.side = {{gap.end}}, .order = n}, options);
}

std::string figuresOf(const BlendSurfaceReport& blend) {
  std::string text;
  for (const occ::BlendSeam& seam : blend.seams)
    text +=
        occ::figuresText(seam.result) + " of face " + std::to_string(seam.result.faces[0]) + "; ";
  for (const occ::BlendLateralReport& lateral : blend.laterals)
    text += "distance " + std::to_string(lateral.distance_mm) + " " + lateral.reason + "; ";
  for (const occ::BlendEndReport& end : blend.ends) text += end.reason;
  return text + std::to_string(blend.surface.countU()) + " x " +
         std::to_string(blend.surface.countV());
}

/// The largest distance of densely placed points of the boundaries u = 0 and u = 1 from the nearest
/// of the edges, by OpenCASCADE.
double farthest(const BlendSurfaceReport& blend, const std::vector<TopoDS_Edge>& curves,
                const std::vector<double>& boundaries) {
  double largest = 0;
  for (const double u : boundaries)
    for (int i = 0; i <= 150; ++i) {
      const Eigen::Vector3d p = jet(blend.surface, u, i / 150.0).p;
      double least = HUGE_VAL;
      for (const TopoDS_Edge& curve : curves)
        least = std::min(least, BRepExtrema_DistShapeShape(
                                    BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), p.z())), curve)
                                    .Value());
      largest = std::max(largest, least);
    }
  return largest;
}

TopoDS_Edge arc(const gp_Pnt& from, const gp_Pnt& through, const gp_Pnt& to) {
  return BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(from, through, to).Value());
}

TopoDS_Face rectangleOf(const gp_Pnt& corner, const gp_Vec& u, const gp_Vec& v) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const gp_Pnt& at :
       {corner, corner.Translated(u), corner.Translated(u + v), corner.Translated(v)})
    polygon.Add(at);
  polygon.Close();
  return BRepBuilderAPI_MakeFace(polygon.Wire(), true).Face();
}

/// A quarter of a cylinder is missing between two planes at right angles; its ends are the lateral
/// boundaries.
Gap rounding(double radius, int arcs = 2) {
  const auto end = [&](double x) {
    const double near = radius * (1 - std::sqrt(0.5));
    return arc(gp_Pnt(x, 0, 0), gp_Pnt(x, radius - near, near), gp_Pnt(x, radius, radius));
  };
  std::vector<TopoDS_Edge> curves = {end(0)};
  if (arcs == 2) curves.push_back(end(40));
  return gapOf({rectangleOf(gp_Pnt(0, -20, 0), gp_Vec(40, 0, 0), gp_Vec(0, 20, 0)),
                rectangleOf(gp_Pnt(0, radius, radius), gp_Vec(40, 0, 0), gp_Vec(0, 0, 25))},
               curves, gp_Pnt(20, 0, 0), gp_Pnt(20, radius, radius));
}

TEST(LateralBlend, BetweenPlanesAlongArcsThatTouchThem) {
  for (const double radius : {4.0, 15.0})
    for (const int arcs : {1, 2}) {
      const Gap gap = rounding(radius, arcs);
      const BlendSurfaceReport blend = blended(gap, 1, 1);
      EXPECT_TRUE(blend.reached) << figuresOf(blend);
      ASSERT_EQ(blend.laterals.size(), static_cast<std::size_t>(arcs));
      EXPECT_LT(blend.laterals[0].distance_mm, 1e-4);
      EXPECT_NEAR(blend.laterals[0].length_mm, radius * std::numbers::pi / 2, 1e-9);
      const double first = jet(blend.surface, 0, 0).p.x() < 1 ? 0 : 1;
      EXPECT_LT(farthest(blend, {gap.curves[0]}, {first}), 1e-4);
      if (arcs == 2) {
        EXPECT_LT(farthest(blend, {gap.curves[1]}, {1 - first}), 1e-4);
      }
    }
}

TEST(LateralBlend, APlaneStaysAPlaneBetweenArcsInIt) {
  // Arcs in the plane, at up to 60 degrees from the right angles to the sides.
  for (const double height : {-4.0, 2.0, 8.0}) {
    const Gap gap = gapOf({rectangleOf(gp_Pnt(0, -20, 0), gp_Vec(40, 0, 0), gp_Vec(0, 20, 0)),
                           rectangleOf(gp_Pnt(0, 30, 0), gp_Vec(40, 0, 0), gp_Vec(0, 25, 0))},
                          {arc(gp_Pnt(0, 0, 0), gp_Pnt(-height, 15, 0), gp_Pnt(0, 30, 0)),
                           arc(gp_Pnt(40, 0, 0), gp_Pnt(40 + height, 15, 0), gp_Pnt(40, 30, 0))},
                          gp_Pnt(20, 0, 0), gp_Pnt(20, 30, 0));
    for (int m = 0; m <= 3; ++m)
      for (int n = m; n <= 3; ++n) {
        const BlendSurfaceReport blend = blended(gap, m, n);
        EXPECT_TRUE(blend.reached) << height << " G" << m << " G" << n << ": " << figuresOf(blend);
        EXPECT_LT(farthest(blend, gap.curves, {0, 1}), 1e-4);
        EXPECT_FALSE(blend.fold);
        for (int i = 0; i <= 20; ++i)
          for (int k = 0; k <= 20; ++k)
            EXPECT_NEAR(jet(blend.surface, i / 20.0, k / 20.0).p.z(), 0, 1e-9);
      }
  }
}

constexpr double cylinder_radius = 30;

/// The part of the ellipse in which the plane z = low + slope x cuts the cylinder, over its angles.
TopoDS_Edge ellipseOnCylinder(double low, double slope, double from, double to) {
  const gp_Ax2 axes(gp_Pnt(0, 0, low), gp_Dir(-slope, 0, 1), gp_Dir(1, 0, slope));
  return BRepBuilderAPI_MakeEdge(
      new Geom_Ellipse(gp_Elips(axes, cylinder_radius * std::hypot(1, slope), cylinder_radius)),
      from, to);
}

/// Two parts of a cylinder and sections of it between them: the parts end at lines along the axis,
/// or at sections themselves.
Gap cylinderGap(double slope) {
  const double from = 0.6, to = 1.7;
  const auto part = [&](double first, double last) {
    // The corners lie on the sections, so the side runs from one section to the other.
    const auto height = [&](double angle) { return slope * cylinder_radius * std::cos(angle); };
    const handle<Geom_Surface> cylinder = new Geom_CylindricalSurface(gp::XOY(), cylinder_radius);
    const double at = std::abs(first - to) < 1e-9 ? first : last;
    return BRepBuilderAPI_MakeFace(cylinder, first, last, height(at), 40 + height(at), 1e-7).Face();
  };
  const auto point = [&](double angle) {
    return gp_Pnt(cylinder_radius * std::cos(angle), cylinder_radius * std::sin(angle),
                  20 + slope * cylinder_radius * std::cos(angle));
  };
  return gapOf({part(from - 0.5, from), part(to, to + 0.5)},
               {ellipseOnCylinder(0, slope, from, to), ellipseOnCylinder(40, slope, from, to)},
               point(from), point(to));
}

TEST(LateralBlend, OnACylinderSectionsFitUpToThirdOrder) {
  for (const double slope : {0.0, 0.5, -0.8}) {
    const Gap gap = cylinderGap(slope);
    for (int m = 1; m <= 3; ++m) {
      const BlendSurfaceReport blend = blended(gap, m, 3);
      EXPECT_TRUE(blend.reached) << slope << " G" << m << ": " << figuresOf(blend);
      EXPECT_LT(farthest(blend, gap.curves, {0, 1}), 1e-4);
    }
  }
}

/// A sphere of radius 50 without a part between meridians and parallels.
Gap sphereHole() {
  const handle<Geom_Surface> sphere = new Geom_SphericalSurface(gp::XOY(), 50);
  const TopoDS_Face whole = BRepBuilderAPI_MakeFace(sphere, -0.4, 1.2, -0.2, 1.1, 1e-7).Face();
  BRepBuilderAPI_MakeFace with_hole(whole);
  const TopoDS_Face hole = BRepBuilderAPI_MakeFace(sphere, 0, 0.8, 0.2, 0.7, 1e-7).Face();
  with_hole.Add(TopoDS::Wire(partsOf(hole, TopAbs_WIRE)(1).Reversed()));
  Gap gap{with_hole.Face()};
  const auto at = [&](double u, double v) { return edgeNear(gap.shape, sphere->Value(u, v)); };
  gap.start = at(0, 0.45);
  gap.end = at(0.8, 0.45);
  gap.lateral = {at(0.4, 0.2), at(0.4, 0.7)};
  const TopTools_IndexedMapOfShape edges = partsOf(gap.shape, TopAbs_EDGE);
  for (const int edge : gap.lateral) gap.curves.push_back(TopoDS::Edge(edges(edge)));
  return gap;
}

TEST(LateralBlend, AHoleOfASphereIsClosedSmoothlyOnAllSides) {
  const Gap gap = sphereHole();
  for (int m = 1; m <= 3; ++m)
    for (int n = 1; n <= 3; ++n) {
      const BlendSurfaceReport blend = blended(gap, m, n, strictly(), 1);
      EXPECT_TRUE(blend.reached) << m << n << ": " << figuresOf(blend);
      EXPECT_EQ(blend.seams.size(), 4U);
      EXPECT_LT(farthest(blend, gap.curves, {0, 1}), 1e-4);
      for (const double u : {0.0, 1.0})
        for (int i = 0; i <= 200; ++i) {
          const SurfaceJet there = jet(blend.surface, u, i / 200.0);
          const double angle = std::atan2(there.u.cross(there.v).cross(there.p).norm(),
                                          std::abs(there.u.cross(there.v).dot(there.p)));
          EXPECT_LT(angle, 0.001 * degree) << u << " " << i;
        }
      for (int i = 0; i <= 10; ++i)
        for (int k = 0; k <= 10; ++k)
          EXPECT_NEAR(jet(blend.surface, i / 10.0, k / 10.0).p.norm(), 50, 0.5);
      // Sewn by OpenCASCADE, the whole model is as smooth.
      BRepBuilderAPI_Sewing sewing(1e-3);
      sewing.Add(blend.shape);
      sewing.Perform();
      occ::AnalyzeOptions asked;
      asked.tolerance = strictly().tolerance;
      const occ::Report report = analyzed(sewing.SewedShape(), asked);
      EXPECT_EQ(report.seams.size(), 4U);
      for (const occ::SeamResult& seam : report.seams)
        EXPECT_GE(seam.verdict.level, Level::G1) << describe(seam);
    }
}

/// Largest relative difference of the curvature tensor at a boundary from that of a sphere.
double fromSphere(const BSplineSurface& surface, double u, double radius) {
  double largest = 0;
  for (int i = 0; i <= 200; ++i) {
    const SurfaceJet there = jet(surface, u, i / 200.0);
    const Eigen::Vector3d out = there.p.normalized(), a = there.u,
                          b = there.v - there.v.dot(a) / a.squaredNorm() * a;
    // The second fundamental form of unit vectors along u and at right angles to it.
    const double share = there.v.dot(a) / a.squaredNorm();
    const double aa = there.uu.dot(out) / a.squaredNorm(),
                 ab = (there.uv - share * there.uu).dot(out) / a.norm() / b.norm(),
                 bb = (there.vv - 2 * share * there.uv + share * share * there.uu).dot(out) /
                      b.squaredNorm();
    for (const double difference : {aa + 1 / radius, ab, bb + 1 / radius})
      largest = std::max(largest, radius * std::abs(difference));
  }
  return largest;
}

TEST(LateralBlend, EachBoundaryHasItsOwnOrderUpToCurvature) {
  const Gap gap = sphereHole();
  for (int m = 1; m <= 3; ++m)
    for (const std::array<int, 2>& orders :
         {std::array{2, 2}, std::array{0, 2}, std::array{2, 1}}) {
      BlendSurfaceOptions options = strictly();
      for (const int k : {0, 1}) options.lateral.orders[gap.lateral[k]] = orders[k];
      const BlendSurfaceReport blend = blended(gap, m, 2, options);
      EXPECT_TRUE(blend.reached) << m << orders[0] << orders[1] << ": " << figuresOf(blend);
      EXPECT_LT(farthest(blend, gap.curves, {0, 1}), 1e-4);
      ASSERT_EQ(blend.laterals.size(), 2U);
      for (const double u : {0.0, 1.0}) {
        const occ::BlendLateralReport& lateral = blend.laterals[u < 0.5 ? 0 : 1];
        const int order = orders[lateral.edges[0] == gap.lateral[0] ? 0 : 1];
        EXPECT_EQ(lateral.level, static_cast<Level>(static_cast<int>(Level::G0) + order));
        if (order == 2) {
          EXPECT_LT(fromSphere(blend.surface, u, 50), 3e-3);
        }
      }
    }
}

/// Two planes beside z = c x y (30 - y), x <= 0, whose tangent plane is theirs at the corners. But
/// its twist there is 30 c, that of the planes 0.
Gap twistedBeside(double c) {
  TColgp_Array2OfPnt poles(1, 2, 1, 3);
  for (int i = 1; i <= 2; ++i)
    for (int k = 1; k <= 3; ++k) {
      const double x = 10.0 * (i - 2);
      poles(i, k) = gp_Pnt(x, 15.0 * (k - 1), k == 2 ? c * x * 450 : 0);
    }
  Gap gap = gapOf({rectangleOf(gp_Pnt(0, -20, 0), gp_Vec(40, 0, 0), gp_Vec(0, 20, 0)),
                   rectangleOf(gp_Pnt(0, 30, 0), gp_Vec(40, 0, 0), gp_Vec(0, 25, 0)),
                   BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7).Face()},
                  {}, gp_Pnt(20, 0, 0), gp_Pnt(20, 30, 0));
  gap.lateral = {edgeNear(gap.shape, gp_Pnt(0, 15, 0))};
  return gap;
}

TEST(LateralBlend, TwistsThatDifferAreMetWithinTheAngle) {
  for (const double c : {1e-4, 1e-3}) {
    const Gap gap = twistedBeside(c);
    for (int m = 1; m <= 2; ++m) {
      BlendSurfaceOptions options = strictly();
      options.tolerance.angle_rad = 0.05 * degree;
      const BlendSurfaceReport blend = blended(gap, m, m, options, 1);
      EXPECT_TRUE(blend.reached) << c << " G" << m << ": " << figuresOf(blend);
      const double u = std::abs(jet(blend.surface, 0, 0).p.x()) < 1 ? 0 : 1;
      for (int i = 0; i <= 2000; ++i) {
        const SurfaceJet there = jet(blend.surface, u, i / 2000.0);
        const double y = there.p.y();
        const Eigen::Vector3d normal = there.u.cross(there.v), wanted(-c * y * (30 - y), 0, 1);
        EXPECT_LT(std::atan2(normal.cross(wanted).norm(), std::abs(normal.dot(wanted))),
                  options.tolerance.angle_rad)
            << i;
      }
    }
  }
}

TEST(LateralBlend, PositionAloneLeavesTheOtherFiguresFree) {
  const Gap gap = sphereHole();
  const BlendSurfaceReport blend = blended(gap, 2, 2);
  EXPECT_TRUE(blend.reached) << figuresOf(blend);
  ASSERT_EQ(blend.laterals.size(), 2U);
  EXPECT_EQ(blend.laterals[0].faces, std::vector{1});
  EXPECT_EQ(blend.laterals[0].level, Level::G0);
  EXPECT_GT(blend.laterals[0].covered_mm, 0.98 * blend.laterals[0].length_mm);
}

TEST(LateralBlend, ACurveOfSeveralEdgesMayHaveTangentJoints) {
  // A line, a quarter of a circle, and a line.
  const double radius = 12;
  const auto curve = [&](double x) {
    const double near = radius * (1 - std::sqrt(0.5));
    return std::vector<TopoDS_Edge>{
        BRepBuilderAPI_MakeEdge(gp_Pnt(x, -8, 0), gp_Pnt(x, 0, 0)),
        arc(gp_Pnt(x, 0, 0), gp_Pnt(x, radius - near, near), gp_Pnt(x, radius, radius)),
        BRepBuilderAPI_MakeEdge(gp_Pnt(x, radius, radius), gp_Pnt(x, radius, radius + 5))};
  };
  std::vector<TopoDS_Edge> curves = curve(40);
  const std::vector<TopoDS_Edge> other = curve(0);
  curves.insert(curves.begin() + 1, other.begin(), other.end());
  const Gap gap =
      gapOf({rectangleOf(gp_Pnt(0, -20, 0), gp_Vec(40, 0, 0), gp_Vec(0, 12, 0)),
             rectangleOf(gp_Pnt(0, radius, radius + 5), gp_Vec(40, 0, 0), gp_Vec(0, 0, 25))},
            curves, gp_Pnt(20, -8, 0), gp_Pnt(20, radius, radius + 5));
  for (int m = 1; m <= 3; ++m) {
    const BlendSurfaceReport blend = blended(gap, m, m);
    EXPECT_TRUE(blend.reached) << m << ": " << figuresOf(blend);
    EXPECT_LT(farthest(blend, gap.curves, {0, 1}), 1e-4);
    ASSERT_EQ(blend.laterals.size(), 2U);
    EXPECT_EQ(blend.laterals[0].edges.size(), 3U);
  }
}

TEST(LateralBlend, TheSidesKeepTheirFiguresWhateverTheCurve) {
  // With other speeds at the sides the surface would run far from the arcs.
  const Gap gap = rounding(15);
  BlendSurfaceOptions options = strictly();
  options.lateral.edges = gap.lateral;
  for (const double tension : {0.3, 1.0, 2.0}) {
    const BlendSurfaceReport blend =
        blendSurface(gap.shape, {.side = {{gap.start}}, .order = 1, .tension = tension},
                     {.side = {{gap.end}}, .order = 1}, options);
    EXPECT_TRUE(blend.reached) << tension << ": " << figuresOf(blend);
    EXPECT_LT(farthest(blend, gap.curves, {0, 1}), 1e-4);
  }
  // The speed across at the corner is the tension times the length of the arc.
  const BlendSurfaceReport blend =
      blendSurface(gap.shape, {.side = {{gap.start}}, .order = 1, .tension = 0.5},
                   {.side = {{gap.end}}, .order = 1}, options);
  EXPECT_NEAR(jet(blend.surface, 0, 0).v.norm(), 0.5 * 15 * std::numbers::pi / 2, 1e-6);
}

TEST(LateralBlend, ReversedEdgesAndSidesMakeTheSameSurface) {
  const Gap gap = rounding(15);
  const auto lateral = [&](bool swapped) {
    Gap of = gap;
    if (swapped) std::swap(of.start, of.end);
    return blended(of, 1, 1);
  };
  const BlendSurfaceReport one = lateral(false), other = lateral(true);
  const bool flipped = (jet(one.surface, 0, 0).p - jet(other.surface, 0, 1).p).norm() > 1;
  for (int i = 0; i <= 10; ++i)
    for (int k = 0; k <= 10; ++k)
      EXPECT_LT((jet(one.surface, i / 10.0, k / 10.0).p -
                 jet(other.surface, flipped ? 1 - i / 10.0 : i / 10.0, 1 - k / 10.0).p)
                    .norm(),
                1e-4);
}

auto refused(const std::string& text, const std::string& figure = "") {
  return ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(text), HasSubstr(figure)));
}

TEST(LateralBlend, CurvesThatNoSuchSurfaceCanHaveAreRefusedWithFigures) {
  const Gap arcs = rounding(15);
  EXPECT_THAT([&] { blended(arcs, 2, 1); },
              refused("its normal curvature is ", "curvature_rel = 1, G2 allows 0.001"));
  const auto planes = [&](const gp_Pnt& from, const gp_Pnt& through, const gp_Pnt& to) {
    return gapOf({rectangleOf(gp_Pnt(0, -20, 0), gp_Vec(40, 0, 0), gp_Vec(0, 20, 0)),
                  rectangleOf(gp_Pnt(0, 30, 0), gp_Vec(40, 0, 0), gp_Vec(0, 25, 0))},
                 {arc(from, through, to)}, gp_Pnt(20, 0, 0), gp_Pnt(20, 30, 0));
  };
  EXPECT_THAT(
      [&] { blended(planes(gp_Pnt(0, 0.5, 0), gp_Pnt(-2, 15, 0), gp_Pnt(0, 30, 0)), 1, 1); },
      refused("does not run from an end of the start to an end of the end", "gap_mm = 0.5 "));
  // The arc begins at an angle of 2 atan(2 / 15) from its chord.
  const Gap above = planes(gp_Pnt(0, 0, 0), gp_Pnt(0, 15, 2), gp_Pnt(0, 30, 0));
  EXPECT_THAT([&] { blended(above, 1, 0); },
              refused("leaves the tangent plane of the start by angle_rad = 0.265"));
  EXPECT_TRUE(blended(above, 0, 0).reached);
  const Gap wide = planes(gp_Pnt(0, 0, 0), gp_Pnt(-30, 15, 0), gp_Pnt(0, 30, 0));
  EXPECT_THAT([&] { blended(wide, 1, 1); }, refused("it goes back over the face of the start"));
}

TEST(LateralBlend, BadChoicesAreRefused) {
  const Gap gap = rounding(15);
  const auto with = [&](const std::vector<int>& edges, int order = 0, double tension = 1,
                        bool flip = false, const std::vector<int>& faces = {}) {
    BlendSurfaceOptions options = strictly();
    options.flip = flip;
    options.lateral = {.edges = edges, .faces = faces, .order = order};
    return [=, &gap] {
      blendSurface(gap.shape, {.side = {{gap.start}}, .order = 1, .tension = tension},
                   {.side = {{gap.end}}, .order = 1, .tension = tension}, options);
    };
  };
  const int one = gap.lateral[0];
  EXPECT_THAT(with({one, one}),
              refused("lateral: edge " + std::to_string(one) + " is given twice"));
  EXPECT_THAT(with({gap.start}), refused("is in start and in lateral"));
  EXPECT_THAT(with({999}), refused("999"));
  EXPECT_THAT(with({one}, 3), refused("lateral order is 3: 0 to 2 are possible"));
  EXPECT_THAT(with({one}, 1), refused("bounds no face"));
  const Gap hole = sphereHole();
  const auto with_orders = [&](const std::map<int, int>& orders) {
    BlendSurfaceOptions options = strictly();
    options.lateral.orders = orders;
    return [=, &hole] { blended(hole, 1, 1, options); };
  };
  EXPECT_THAT(with_orders({{hole.lateral[0], 3}}), refused("lateral order is 3"));
  EXPECT_THAT(with_orders({{hole.start, 1}}),
              refused("lateral order: edge " + std::to_string(hole.start) + " is not in lateral"));
  EXPECT_THAT(with({}, 1), refused("need lateral edges"));
  EXPECT_THAT(with({}, 0, 1, false, {1}), refused("need lateral edges"));
  EXPECT_THAT(with({one}, 0, 1, false, {2}), refused("face 2 is beside none of the edges"));
  EXPECT_THAT(with({one}, 0, 3.5), refused("tensions 3.5 and 3.5 are too large"));
  EXPECT_THAT(with({one}, 0, 1, true), refused("flip: the lateral boundaries say"));
}

}  // namespace
}  // namespace seamwright::test
