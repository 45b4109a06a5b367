// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Tool.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <cmath>
#include <gp_Pln.hxx>
#include <numbers>
#include <stdexcept>

#include "match_pairs.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/blend/blend_surface.hpp>

namespace seamwright::test {
namespace {

using occ::BlendEnd;
using occ::blendSurface;
using occ::BlendSurfaceOptions;
using occ::BlendSurfaceReport;
using occ::extendSurface;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// The number of the edge whose middle is nearest to a point.
int edgeNear(const TopoDS_Shape& shape, const gp_Pnt& point) {
  const TopTools_IndexedMapOfShape edges = partsOf(shape, TopAbs_EDGE);
  int nearest = 0;
  double least = HUGE_VAL;
  for (int i = 1; i <= edges.Extent(); ++i) {
    double first = 0, last = 0;
    const handle<Geom_Curve> curve = BRep_Tool::Curve(TopoDS::Edge(edges(i)), first, last);
    if (curve.IsNull()) continue;
    const double distance = curve->Value((first + last) / 2).Distance(point);
    if (distance < least) {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

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
  const auto refused = [](const char* text) {
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
  EXPECT_THAT(
      [&] { blendSurface(pair.shape, left, left); },
      testing::ThrowsMessage<std::exception>(HasSubstr("no more than the gap tolerance of")));
  EXPECT_THAT([&] { extendSurface(pair.shape, left, std::nan("")); }, refused("length_mm is nan"));
}

}  // namespace
}  // namespace seamwright::test
