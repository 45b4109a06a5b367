// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <fmt/format.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GC_MakeArcOfCircle.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "match_pairs.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/blend/blend_surface.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>

namespace seamwright::test {
namespace {

using occ::BlendEnd;
using occ::blendSurface;
using occ::BlendSurfaceOptions;
using occ::BlendSurfaceReport;
using occ::extendSurface;
using occ::extendSurfaceTo;
using testing::HasSubstr;
using testing::ThrowsMessage;

BlendSurfaceOptions fine() {
  BlendSurfaceOptions options;
  options.tolerance.gap_mm = 1e-4;
  options.tolerance.angle_rad = 0.001 * degree;
  options.tolerance.curvature_rel = 1e-3;
  return options;
}

/// A trimmed face of each kind, moved to the left of a sheet, and their facing edges.
struct Pair {
  std::string name;
  TopoDS_Shape shape;
  int left = 0, right = 0;
};

std::vector<Pair> pairs() {
  std::vector<Pair> result;
  std::mt19937 generator(testSeed());
  for (const Trimmed& kind : trimmedKinds()) {
    const TopoDS_Face a = trimmedFace(kind.surface, kind.path, kind.into);
    const gp_Pnt2d middle = kind.path->Value(0.5);
    gp_Pnt at;
    gp_Vec u, v;
    kind.surface->D1(middle.X(), middle.Y(), at, u, v);
    // The sheet lies across the path, 25 mm away and a little higher; its side u = 0 faces it.
    gp_Trsf place, turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp::DZ()), std::numbers::pi / 2);
    place.SetTransformation(gp_Ax3(at.Translated(25 * v.Normalized()), u.Crossed(v), u), gp::XOY());
    gp_Trsf centre;
    centre.SetTranslation(gp_Vec(20, 0, 4));
    const TopoDS_Shape b = BRepBuilderAPI_Transform(wholeFace(sheet(generator, 9, 8, 5, 5)),
                                                    place * centre * turn, true);
    Pair pair{kind.name, loose(a, b)};
    pair.left = edgeNear(pair.shape, at);
    pair.right =
        edgeNear(pair.shape, at.Translated(25 * v.Normalized() + 4 * u.Crossed(v).Normalized()));
    result.push_back(pair);
  }
  return result;
}

TEST(BlendSurface, SidesAreMetAtEachOrderIndependently) {
  for (const Pair& pair : pairs())
    for (int m = 0; m <= 3; ++m)
      for (int n = 0; n <= 3; ++n) {
        const BlendSurfaceReport blend =
            blendSurface(pair.shape, {.side = {{pair.left}}, .order = m},
                         {.side = {{pair.right}}, .order = n}, fine());
        std::string figures;
        for (const occ::BlendSeam& seam : blend.seams)
          figures += occ::figuresText(seam.result) + "; ";
        EXPECT_EQ(blend.surface.degree_v, m + n + 1);
        EXPECT_EQ(blend.seams.size(), 2U) << pair.name;
        EXPECT_TRUE(blend.reached)
            << pair.name << " G" << m << " G" << n << " spans " << blend.spans << ": " << figures;
      }
}

/// A cylinder about the z axis without its ends.
TopoDS_Face tube(double radius, double from, double to) {
  return BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp::XOY(), radius), 0,
                                 2 * std::numbers::pi, from, to, 1e-7);
}

TEST(BlendSurface, RingsAreClosedSmoothly) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp::DZ()), 1.1);
  const TopoDS_Shape upper = BRepBuilderAPI_Transform(tube(12, 40, 60), turn, true);
  const TopoDS_Shape model = loose(tube(20, 0, 20), upper);
  const int low = edgeNear(model, gp_Pnt(-20, 0, 20));
  const int high = edgeNear(model, gp_Pnt(-12 * std::cos(1.1), -12 * std::sin(1.1), 40));
  const BlendSurfaceReport blend =
      blendSurface(model, {.side = {{low}}}, {.side = {{high}}}, fine());
  EXPECT_TRUE(blend.reached);
  // A surface of revolution: every iso-curve u is a circle about the axis.
  for (int i = 0; i <= 10; ++i) {
    const double radius = jet(blend.surface, 0, i / 10.0).p.head<2>().norm();
    for (int k = 0; k <= 40; ++k)
      EXPECT_NEAR(jet(blend.surface, k / 40.0, i / 10.0).p.head<2>().norm(), radius, 1e-4);
  }
  // It is not twisted: lines u = const lie in planes through the axis.
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d from = jet(blend.surface, k / 8.0, 0).p,
                          to = jet(blend.surface, k / 8.0, 1).p;
    EXPECT_LT(std::abs(from.x() * to.y() - from.y() * to.x()) / (20 * 12), 1e-4);
  }
  const SurfaceJet begin = jet(blend.surface, 0, 0.5), end = jet(blend.surface, 1, 0.5);
  EXPECT_LT((begin.u - end.u).norm(), 1e-7 * begin.u.norm());
  EXPECT_LT((begin.uu - end.uu).norm(), 1e-5 * begin.uu.norm());
}

/// A part of a cylinder about the z axis as a spline that goes on beyond it, with a knot line at
/// its begin but for rounding.
TopoDS_Face splinePart(double radius, double from, double to) {
  const opencascade::handle<Geom_Surface> wider = new Geom_RectangularTrimmedSurface(
      new Geom_CylindricalSurface(gp::XOY(), radius), from - 0.1, to + 0.1, 0.0, 20.0);
  const opencascade::handle<Geom_BSplineSurface> spline =
      GeomConvert::SurfaceToBSplineSurface(wider);
  const auto parameterOf = [&](double angle) {
    const gp_Pnt at(radius * std::cos(angle), radius * std::sin(angle), 0);
    return GeomAPI_ProjectPointOnCurve(at, spline->VIso(0)).LowerDistanceParameter();
  };
  const double begin = parameterOf(from);
  spline->InsertUKnot(begin, 1, 0);
  return BRepBuilderAPI_MakeFace(spline, begin - 4e-16, parameterOf(to), 0, 20, 1e-7);
}

TEST(BlendSurface, AKnotLineAtTheBeginOfARingIsNoCorner) {
  const double pi = std::numbers::pi;
  BRepBuilderAPI_Sewing halves;
  halves.Add(splinePart(20, 0.2, pi));
  halves.Add(splinePart(20, pi, 2 * pi + 0.2));
  halves.Perform();
  const TopoDS_Shape model = loose(halves.SewedShape(), tube(12, 40, 60));
  const BlendSurfaceReport blend =
      blendSurface(model,
                   {.side = {{edgeNear(model, gp_Pnt(20 * std::cos(1), 20 * std::sin(1), 20)),
                              edgeNear(model, gp_Pnt(0, -20, 20))}}},
                   {.side = {{edgeNear(model, gp_Pnt(-12, 0, 40))}}}, fine());
  EXPECT_TRUE(blend.reached);
}

TEST(BlendSurface, ChainsOfEdgesAreOneSide) {
  // Two faces of a box, and a plane opposite of them: the edge beside both is two edges.
  const TopoDS_Shape model =
      loose(joined({new Geom_Plane(gp::XOY()), rectangle(0, 30, 0, 20)},
                   {new Geom_Plane(gp::XOY()), beginningWith(2, rectangle(0, 30, -25, 0))}),
            BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(50, 0, 10), gp_Dir(-1, 0, 2)), -20, 20, -25, 20)
                .Face());
  const int one = edgeNear(model, gp_Pnt(30, 10, 0)), two = edgeNear(model, gp_Pnt(30, -12.5, 0));
  ASSERT_NE(one, two);
  const int far = edgeNear(model, gp_Pnt(35, 0, 2));
  const BlendSurfaceReport blend =
      blendSurface(model, {.side = {{two, one}}}, {.side = {{far}}}, fine());
  EXPECT_TRUE(blend.reached);
  EXPECT_EQ(blend.seams.size(), 3U);
}

TEST(ExtendSurface, SidesAreContinuedAtEachOrder) {
  for (const Pair& pair : pairs())
    for (int order = 1; order <= 3; ++order)
      for (const int edge : {pair.left, pair.right}) {
        const BlendSurfaceReport longer =
            extendSurface(pair.shape, {.side = {{edge}}, .order = order}, 5, fine());
        std::string figures;
        for (const occ::BlendSeam& seam : longer.seams)
          figures += occ::figuresText(seam.result) + "; ";
        EXPECT_TRUE(longer.reached) << pair.name << " G" << order << " edge " << edge << " spans "
                                    << longer.spans << ": " << figures;
        EXPECT_EQ(longer.surface.degree_v, order);
      }
}

TEST(ExtendSurface, OfACylinderHasTheLengthAndStaysNearTheCylinder) {
  constexpr double radius = 50;
  const TopoDS_Shape model =
      BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp::XOY(), radius), 0, 1, 0, 30, 1e-7);
  const int edge = edgeNear(model, gp_Pnt(radius * std::cos(1), radius * std::sin(1), 15));
  for (const double length : {1.0, 10.0, 60.0}) {
    const BlendSurfaceReport longer =
        extendSurface(model, {.side = {{edge}}, .order = 3}, length, fine());
    EXPECT_TRUE(longer.reached);
    for (int i = 0; i <= 10; ++i) {
      double sum = 0;
      Eigen::Vector3d before = jet(longer.surface, i / 10.0, 0).p;
      constexpr int steps = 1000;
      for (int k = 1; k <= steps; ++k) {
        const Eigen::Vector3d p = jet(longer.surface, i / 10.0, k / double{steps}).p;
        sum += (p - before).norm();
        before = p;
        // A circle and the parabola with its curvature part by the fourth order.
        const double x = sum / radius;
        EXPECT_NEAR(p.head<2>().norm(), radius, radius * std::pow(x, 4) / 8 + 1e-4);
      }
      EXPECT_NEAR(sum, length, 1e-4 * length);
    }
  }
}

/// A plane face between y = 0 and a line of arcs of radius 5 that turn to either side: its
/// curvature jumps.
TopoDS_Shape wavyFace(int arcs) {
  BRepBuilderAPI_MakeWire wire;
  const auto line = [&](double x0, double y0, double x1, double y1) {
    wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(x0, y0, 0), gp_Pnt(x1, y1, 0)));
  };
  const double radius = 5, chord = radius * std::sqrt(2.0), height = radius * (1 - std::sqrt(0.5));
  for (int i = 0; i < arcs; ++i) {
    const double up = i % 2 == 0 ? 1 : -1;
    wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(gp_Pnt(i * chord, 0, 0),
                                                        gp_Pnt((i + 0.5) * chord, up * height, 0),
                                                        gp_Pnt((i + 1) * chord, 0, 0))
                                         .Value()));
  }
  line(arcs * chord, 0, arcs * chord, -20);
  line(arcs * chord, -20, 0, -20);
  line(0, -20, 0, 0);
  return BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), wire.Wire()).Face();
}

std::vector<int> edgesAbove(const TopoDS_Shape& shape, double y) {
  const TopTools_IndexedMapOfShape edges = partsOf(shape, TopAbs_EDGE);
  std::vector<int> result;
  for (int i = 1; i <= edges.Extent(); ++i) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(edges(i)));
    if (curve.Value(curve.FirstParameter()).Y() > y && curve.Value(curve.LastParameter()).Y() > y)
      result.push_back(i);
  }
  return result;
}

TEST(ExtendSurface, WhereTheCurvatureOfTheSideJumps) {
  const TopoDS_Shape model = wavyFace(3);
  const std::vector<int> side = edgesAbove(model, -1);
  ASSERT_EQ(side.size(), 3U);
  for (int order = 1; order <= 3; ++order) {
    const BlendSurfaceReport longer =
        extendSurface(model, {.side = {side}, .order = order}, 2, fine());
    EXPECT_TRUE(longer.reached) << order;
    // It is the plane.
    for (int i = 0; i <= 50; ++i)
      for (const double v : {0.3, 1.0})
        EXPECT_NEAR(jet(longer.surface, i / 50.0, v).p.z(), 0, 1e-9);
    EXPECT_FALSE(longer.fold);
  }
}

TopoDS_Face planeFace(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const gp_Pnt& corner : corners) polygon.Add(corner);
  polygon.Close();
  return BRepBuilderAPI_MakeFace(polygon.Wire(), true).Face();
}

TEST(ExtendSurface, GoesOnAlongTheLateralEdges) {
  for (const double slope : {-0.6, 0.0, 0.3, 0.9}) {
    const TopoDS_Shape model =
        planeFace({gp_Pnt(0, 0, 0), gp_Pnt(30, 0, 0), gp_Pnt(30 + 20 * slope, 20, 0),
                   gp_Pnt(20 * slope, 20, 0)});
    const int edge = edgeNear(model, gp_Pnt(15 + 20 * slope, 20, 0));
    const BlendSurfaceReport longer =
        extendSurface(model, {.side = {{edge}}, .order = 2}, 7, fine());
    EXPECT_TRUE(longer.reached);
    for (const double u : {0.0, 1.0}) {
      const Eigen::Vector3d along = jet(longer.surface, u, 1).p - jet(longer.surface, u, 0).p;
      EXPECT_NEAR(along.x() / along.y(), slope, 1e-9);
      EXPECT_NEAR(along.norm(), 7, 1e-9);
    }
  }
}

TEST(ExtendSurface, FoldsAreFound) {
  // A plane around a hole of radius 10: lines across meet at its centre.
  const gp_Ax2 axes;
  const TopoDS_Edge arc = BRepBuilderAPI_MakeEdge(gp_Circ(axes, 10), 0, std::numbers::pi / 2);
  BRepBuilderAPI_MakeWire wire(arc);
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 10, 0), gp_Pnt(0, 40, 0)));
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 40, 0), gp_Pnt(40, 0, 0)));
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(40, 0, 0), gp_Pnt(10, 0, 0)));
  const TopoDS_Shape model = BRepBuilderAPI_MakeFace(gp_Pln(axes), wire.Wire()).Face();
  const double half = 10 * std::sqrt(0.5);
  const int edge = edgeNear(model, gp_Pnt(half, half, 0));
  const BlendSurfaceReport shorter = extendSurface(model, {.side = {{edge}}}, 5, fine());
  EXPECT_TRUE(shorter.reached);
  const BlendSurfaceReport longer = extendSurface(model, {.side = {{edge}}}, 15, fine());
  EXPECT_FALSE(longer.reached);
  ASSERT_TRUE(longer.fold);
  EXPECT_NEAR(longer.fold->distance_mm, 10, 2);
}

/// The model with a big plane through a point, its last face.
TopoDS_Shape withPlane(const TopoDS_Shape& model, const gp_Pnt& point, const gp_Dir& normal) {
  return loose(model, BRepBuilderAPI_MakeFace(gp_Pln(point, normal), -200, 200, -200, 200).Face());
}

TEST(ExtendSurface, UpToAPlaneItHasTheLengthsOfTheLines) {
  const TopoDS_Shape strip =
      planeFace({gp_Pnt(0, 0, 0), gp_Pnt(30, 0, 0), gp_Pnt(30, 20, 0), gp_Pnt(0, 20, 0)});
  // y = 35 + x / 4 + z / 2.
  const TopoDS_Shape model = withPlane(strip, gp_Pnt(0, 35, 0), gp_Dir(-1, 4, -2));
  const int edge = edgeNear(model, gp_Pnt(15, 20, 0));
  for (int order = 1; order <= 3; ++order) {
    const BlendSurfaceReport longer =
        extendSurfaceTo(model, {.side = {{edge}}, .order = order}, 2, fine());
    EXPECT_TRUE(longer.reached);
    ASSERT_TRUE(longer.to);
    EXPECT_NEAR(longer.to->least_mm, 15, 1e-6);
    EXPECT_NEAR(longer.to->most_mm, 15 + 30 / 4.0, 1e-6);
    EXPECT_LT(longer.to->distance_mm, 1e-6);
    GProp_GProps area;
    BRepGProp::SurfaceProperties(longer.face, area);
    EXPECT_NEAR(area.Mass(), 30 * (15 + 30 / 8.0), 1e-6);
  }
}

TEST(ExtendSurface, UpToACurvedFaceItEndsAtIt) {
  for (const Pair& pair : pairs()) {
    // Across the way from the left side to the right one, and further on than the sheet.
    const TopTools_IndexedMapOfShape edges = partsOf(pair.shape, TopAbs_EDGE);
    const BRepAdaptor_Curve left(TopoDS::Edge(edges(pair.left))),
        right(TopoDS::Edge(edges(pair.right)));
    const auto middle = [](const BRepAdaptor_Curve& curve) {
      return curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2);
    };
    const gp_Vec way(middle(left), middle(right));
    const gp_Ax3 axes(middle(left).Translated(-40 * way.Normalized()), gp_Dir(way),
                      gp_Vec(middle(left), left.Value(left.FirstParameter())).Crossed(way));
    const TopoDS_Face dome =
        BRepBuilderAPI_MakeFace(new Geom_SphericalSurface(axes, 55), 0, 2 * std::numbers::pi, 0,
                                std::numbers::pi / 2, 1e-7);
    const TopoDS_Shape model = loose(pair.shape, dome);
    for (int order = 1; order <= 2; ++order) {
      const BlendSurfaceReport longer =
          extendSurfaceTo(model, {.side = {{pair.left}}, .order = order}, 3, fine());
      EXPECT_TRUE(longer.reached) << pair.name;
      ASSERT_TRUE(longer.to);
      EXPECT_LT(longer.to->distance_mm, 1e-4) << pair.name;
      EXPECT_GT(longer.to->least_mm, 1);
      // The boundary of the trimmed face lies on the sphere, the side excepted.
      const TopTools_IndexedMapOfShape made = partsOf(longer.face, TopAbs_VERTEX);
      int on_sphere = 0;
      for (int i = 1; i <= made.Extent(); ++i)
        if (std::abs(BRep_Tool::Pnt(TopoDS::Vertex(made(i))).Distance(axes.Location()) - 55) < 1e-4)
          ++on_sphere;
      // A third one where the sphere closes.
      EXPECT_GE(on_sphere, 2) << pair.name;
    }
  }
}

TEST(ExtendSurface, AFaceThatIsNotMetIsRefusedWithTheLine) {
  const TopoDS_Shape strip =
      planeFace({gp_Pnt(0, 0, 0), gp_Pnt(30, 0, 0), gp_Pnt(30, 20, 0), gp_Pnt(0, 20, 0)});
  const TopoDS_Shape model = loose(
      strip, BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(20, 40, 0), gp::DY()), -10, 10, -10, 10).Face());
  const int edge = edgeNear(model, gp_Pnt(15, 20, 0));
  EXPECT_THAT([&] { extendSurfaceTo(model, {.side = {{edge}}}, 2); },
              ThrowsMessage<occ::GeometryError>(HasSubstr("does not meet face 2 within ")));
  EXPECT_THAT([&] { extendSurfaceTo(model, {.side = {{edge}}}, 3); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("face 3")));
}

TEST(ExtendSurface, ASideMayEndAtAPole) {
  const TopoDS_Shape model = BRepBuilderAPI_MakeFace(new Geom_SphericalSurface(gp::XOY(), 20), 0, 1,
                                                     0, std::numbers::pi / 2, 1e-7);
  const int edge = edgeNear(model, gp_Pnt(20 * std::sqrt(0.5), 0, 20 * std::sqrt(0.5)));
  const BlendSurfaceReport longer = extendSurface(model, {.side = {{edge}}, .order = 2}, 3, fine());
  EXPECT_EQ(longer.ends[0].reason, "");
  for (int i = 0; i <= 20; ++i) {
    const SurfaceJet there = jet(longer.surface, i / 20.0, 0);
    EXPECT_NEAR(there.p.norm(), 20, 1e-4);
    EXPECT_NEAR(std::abs(there.u.cross(there.v).normalized().dot(there.p)), 20, 1e-4);
  }
}

TEST(BlendSurface, TheEndRunsWhereTheSurfaceIsLessTwisted) {
  // The second plane has its edges in the other order, and is turned about the way across.
  const TopoDS_Shape model = loose(
      planeFace({gp_Pnt(0, 0, 0), gp_Pnt(20, 0, 0), gp_Pnt(20, 30, 0), gp_Pnt(0, 30, 0)}),
      planeFace({gp_Pnt(60, 28, 9), gp_Pnt(60, 3, -9), gp_Pnt(90, 3, -9), gp_Pnt(90, 28, 9)}));
  const BlendEnd left{.side = {{edgeNear(model, gp_Pnt(20, 15, 0))}}},
      right{.side = {{edgeNear(model, gp_Pnt(60, 15.5, 0))}}};
  BlendSurfaceOptions options = fine();
  const auto isCrossed = [](const BlendSurfaceReport& blend) {
    const auto y = [&](double u, double v) { return jet(blend.surface, u, v).p.y(); };
    return (y(1, 0) - y(0, 0)) * (y(1, 1) - y(0, 1)) < 0;
  };
  EXPECT_FALSE(isCrossed(blendSurface(model, left, right, options)));
  EXPECT_FALSE(isCrossed(blendSurface(model, right, left, options)));
  options.flip = true;
  EXPECT_TRUE(isCrossed(blendSurface(model, left, right, options)));
}

TEST(BlendSurface, OneThatRunsThroughItselfIsNotReached) {
  const auto pipe = [](const gp_Pnt& from, const gp_Dir& along) {
    return BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(from, along), 5), 0,
                                   2 * std::numbers::pi, 0, 20, 1e-7)
        .Face();
  };
  // Both begin at the plane x = 0 and go away from it; the second one is turned.
  const TopoDS_Shape model =
      loose(pipe(gp_Pnt(0, 0, 0), -gp::DX()), pipe(gp_Pnt(30, 4, 0), gp_Dir(1, 0.2, 0.1)));
  const auto rim = [&](const gp_Pnt& center) {
    const TopTools_IndexedMapOfShape edges = partsOf(model, TopAbs_EDGE);
    for (int i = 1; i <= edges.Extent(); ++i) {
      const BRepAdaptor_Curve curve(TopoDS::Edge(edges(i)));
      if (curve.GetType() == GeomAbs_Circle && curve.Circle().Location().Distance(center) < 1e-6)
        return i;
    }
    return 0;
  };
  const BlendEnd start{.side = {{rim(gp_Pnt(0, 0, 0))}}}, end{.side = {{rim(gp_Pnt(30, 4, 0))}}};
  BlendSurfaceOptions options;
  const BlendSurfaceReport plain = blendSurface(model, start, end, options);
  EXPECT_TRUE(plain.reached);
  EXPECT_EQ(plain.ends[1].reason, "");
  options.flip = true;
  const BlendSurfaceReport flipped = blendSurface(model, start, end, options);
  EXPECT_FALSE(flipped.reached);
  EXPECT_THAT(flipped.ends[1].reason, HasSubstr("the surface runs through itself"));
}

TEST(BlendSurface, ASideThatNoSeamCoversHasAReason) {
  BlendSurfaceOptions coarse = fine();
  coarse.tolerance.gap_mm = 1e-9;
  coarse.max_spans = 1;
  const Pair pair = pairs()[1];
  const BlendSurfaceReport blend =
      blendSurface(pair.shape, {.side = {{pair.left}}}, {.side = {{pair.right}}}, coarse);
  EXPECT_FALSE(blend.reached);
  ASSERT_EQ(blend.ends.size(), 2U);
  EXPECT_EQ(blend.ends[0].edges, std::vector{pair.left});
  EXPECT_LT(blend.ends[0].covered_mm, blend.ends[0].length_mm);
  EXPECT_THAT(blend.ends[0].reason, HasSubstr("the new edge is up to "));
}

TEST(BlendSurface, SmallChangesOfTheModelChangeTheSurfaceLittle) {
  std::mt19937 generator(testSeed());
  for (const Pair& pair : pairs()) {
    // A turn and a shift of the one face, of about 1e-6 mm.
    gp_Trsf move;
    move.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(random(generator), random(generator), 1)),
                     1e-8);
    const TopTools_IndexedMapOfShape faces = partsOf(pair.shape, TopAbs_FACE);
    const TopoDS_Shape moved =
        loose(faces(1), BRepBuilderAPI_Transform(faces(2), move, true).Shape());
    const BlendEnd left{.side = {{pair.left}}}, right{.side = {{pair.right}}};
    const BlendSurfaceReport one = blendSurface(pair.shape, left, right, fine()),
                             other = blendSurface(moved, left, right, fine());
    for (int i = 0; i <= 20; ++i)
      for (int j = 0; j <= 10; ++j)
        EXPECT_LT(
            (jet(one.surface, i / 20.0, j / 10.0).p - jet(other.surface, i / 20.0, j / 10.0).p)
                .norm(),
            1e-4)
            << pair.name;
  }
}

TEST(BlendSurface, CornersOfASideAreRefused) {
  const TopoDS_Shape model =
      loose(BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), 0, 10, 0, 10).Face(),
            BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 5), gp::DZ()), -2, 12, -2, 12).Face());
  const auto edgesOf = [&](double low, double high, double z) {
    const double middle = (low + high) / 2;
    return std::vector<int>{
        edgeNear(model, gp_Pnt(middle, low, z)), edgeNear(model, gp_Pnt(high, middle, z)),
        edgeNear(model, gp_Pnt(middle, high, z)), edgeNear(model, gp_Pnt(low, middle, z))};
  };
  const std::vector<int> inner = edgesOf(0, 10, 0), outer = edgesOf(-2, 12, 5);
  const auto refused =
      ThrowsMessage<std::invalid_argument>(HasSubstr("has a corner of 90 degrees"));
  EXPECT_THAT([&] { extendSurface(model, {.side = {{inner[0], inner[1]}}}, 3); }, refused);
  EXPECT_THAT([&] { extendSurface(model, {.side = {inner}}, 3); }, refused);
  EXPECT_THAT([&] { blendSurface(model, {.side = {inner}}, {.side = {outer}}); }, refused);
}

TEST(BlendSurface, BadInputIsRefused) {
  const Pair pair = pairs()[0];
  const BlendEnd left{.side = {{pair.left}}}, right{.side = {{pair.right}}};
  const auto refused = [](const std::string& text) {
    return ThrowsMessage<std::invalid_argument>(HasSubstr(text));
  };
  BlendEnd none = left, unknown = left, order = left, tension = left;
  none.side.edges.clear();
  unknown.side.edges = {999};
  order.order = 4;
  tension.tension = -1;
  EXPECT_THAT([&] { blendSurface(pair.shape, none, right); },
              refused("start: a side needs an edge"));
  EXPECT_THAT([&] { blendSurface(pair.shape, left, unknown); }, refused("999"));
  EXPECT_THAT([&] { blendSurface(pair.shape, order, right); }, refused("order is 4"));
  EXPECT_THAT([&] { blendSurface(pair.shape, left, tension); }, refused("end: tension is -1"));
  EXPECT_THAT([&] { blendSurface(pair.shape, left, left); },
              refused("is in start and in end: a surface between two sides needs different edges"));
  EXPECT_THAT([&] { extendSurface(pair.shape, left, std::nan("")); }, refused("length_mm is nan"));
  const BlendEnd twice{.side = {{pair.left, pair.left}}};
  EXPECT_THAT([&] { extendSurface(pair.shape, twice, 5); },
              refused("side: edge " + std::to_string(pair.left) + " is given twice"));
}

TEST(BlendSurface, AnOpenSideBesideAClosedOneIsRefusedWithTheEdgesThatGoOn) {
  const TopoDS_Shape model =
      loose(tube(20, 0, 20), planeFace({gp_Pnt(0, 0, 50), gp_Pnt(9, 0, 50), gp_Pnt(9, 9, 50)}));
  const int ring = edgeNear(model, gp_Pnt(-20, 0, 20)), line = edgeNear(model, gp_Pnt(4.5, 0, 50));
  const int second = edgeNear(model, gp_Pnt(9, 4.5, 50)),
            third = edgeNear(model, gp_Pnt(4.5, 4.5, 50));
  const std::string text = fmt::format(
      "start is closed (edge {}), end is not (edge {}): both must be closed, or both "
      "open; the end goes on with edge {} or {}",
      ring, line, std::min(second, third), std::max(second, third));
  EXPECT_THAT([&] { blendSurface(model, {.side = {{ring}}}, {.side = {{line}}}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
}

}  // namespace
}  // namespace seamwright::test
