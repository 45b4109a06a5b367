// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <Eigen/Geometry>
#include <GeomLProp_SLProps.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <stdexcept>

#include "match_pairs.hpp"

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/blend/side_ribbon.hpp>

namespace seamwright::test {
namespace {

using occ::SideRibbon;
using occ::sideRibbon;

occ::BlendSurfaceOptions fine() {
  occ::BlendSurfaceOptions options;
  options.tolerance.gap_mm = 1e-5;
  options.tolerance.angle_rad = 1e-5;
  options.tolerance.curvature_rel = 1e-4;
  return options;
}

TEST(SideRibbon, OfACylinderIsTheParabolaOfTheCircleInside) {
  constexpr double radius = 50, depth = 20;
  const TopoDS_Shape model =
      BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp::XOY(), radius), 0, 1, 0, 30, 1e-7);
  const int edge = edgeNear(model, gp_Pnt(radius * std::cos(1), radius * std::sin(1), 15));
  for (int order = 1; order <= 3; ++order) {
    const SideRibbon ribbon = sideRibbon(model, {.side = {{edge}}, .order = order}, depth, fine());
    EXPECT_TRUE(ribbon.reached);
    EXPECT_EQ(ribbon.seams.size(), 1U);
    EXPECT_EQ(ribbon.surface.degree_v, order);
    for (const double u : {0.0, 0.3, 1.0})
      for (const double v : {0.0, 0.5, 1.0}) {
        const Eigen::Vector3d p = jet(ribbon.surface, u, v).p;
        const double inside = p.x() * std::sin(1) - p.y() * std::cos(1),
                     below = radius - p.x() * std::cos(1) - p.y() * std::sin(1);
        EXPECT_NEAR(below, order == 1 ? 0 : inside * inside / (2 * radius), 1e-4);
        // The lines across have the length, and are bent.
        const double wanted = (1 - v) * depth;
        EXPECT_LE(inside, wanted + 1e-4);
        EXPECT_GE(inside, wanted * (1 - depth * depth / (5 * radius * radius)) - 1e-4);
      }
  }
}

TEST(SideRibbon, HasTheCurvatureOfATrimmedFaceAtTheSide) {
  for (const Trimmed& kind : trimmedKinds()) {
    const TopoDS_Face face = trimmedFace(kind.surface, kind.path, kind.into);
    const gp_Pnt2d middle = kind.path->Value(0.5);
    const int edge = edgeNear(face, kind.surface->Value(middle.X(), middle.Y()));
    const SideRibbon ribbon = sideRibbon(face, {.side = {{edge}}, .order = 2}, 3, fine());
    EXPECT_TRUE(ribbon.reached) << kind.name;
    for (const double t : {0.1, 0.5, 0.8}) {
      const gp_Pnt2d uv = kind.path->Value(t);
      GeomLProp_SLProps props(kind.surface, uv.X(), uv.Y(), 2, 1e-9);
      const Eigen::Vector3d at(props.Value().X(), props.Value().Y(), props.Value().Z()),
          normal(props.Normal().X(), props.Normal().Y(), props.Normal().Z());
      // The point of the ribbon's side that is nearest.
      double best = HUGE_VAL, share = 0;
      for (int i = 0; i <= 20000; ++i) {
        const double u = i / 20000.0;
        const double distance = (jet(ribbon.surface, u, 1).p - at).norm();
        if (distance < best) best = distance, share = u;
      }
      const SurfaceJet of_ribbon = jet(ribbon.surface, share, 1);
      const Eigen::Vector3d its_normal = of_ribbon.u.cross(of_ribbon.v).normalized();
      EXPECT_LT(its_normal.cross(normal).norm(), 2e-4) << kind.name;
      const Eigen::Matrix3d tensor =
          curvatureTensor(of_ribbon, its_normal.dot(normal) > 0 ? its_normal : -its_normal);
      const double sum = props.MaxCurvature() + props.MinCurvature();
      EXPECT_NEAR(tensor.trace(), sum,
                  1e-3 * (1e-3 + std::abs(props.MaxCurvature()) + std::abs(props.MinCurvature())))
          << kind.name;
    }
  }
}

TEST(SideRibbon, TurnsOverBeyondTheCentreOfADisc) {
  // Between circles of radius 2 and 30. The ribbon of the outer one meets itself in the centre;
  // that of the inner one can be as deep as one likes.
  BRepBuilderAPI_MakeFace disc(
      gp_Pln(gp::XOY()), BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(gp::XOY(), 30))));
  disc.Add(TopoDS::Wire(
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(gp::XOY(), 2))).Wire().Reversed()));
  const TopoDS_Shape model = disc.Face();
  const int outer = edgeNear(model, gp_Pnt(-30, 0, 0)), inner = edgeNear(model, gp_Pnt(-2, 0, 0));
  ASSERT_NE(outer, inner);
  for (const double depth : {1.0, 5.0, 20.0})
    EXPECT_TRUE(sideRibbon(model, {.side = {{inner}}}, depth, fine()).reached) << depth;
  EXPECT_TRUE(sideRibbon(model, {.side = {{outer}}}, 25, fine()).reached);
  const SideRibbon deep = sideRibbon(model, {.side = {{outer}}}, 45, fine());
  EXPECT_FALSE(deep.reached);
  EXPECT_THAT(deep.side.reason, testing::HasSubstr("turns over"));
}

TEST(SideRibbon, BadDepthsAndSidesAreRefused) {
  const TopoDS_Shape model =
      BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp::XOY(), 5), 0, 1, 0, 30, 1e-7);
  for (const double depth : {0.0, -1.0, HUGE_VAL, std::nan("")})
    EXPECT_THAT([&] { sideRibbon(model, {.side = {{1}}}, depth); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("depth_mm")))
        << depth;
  EXPECT_THROW(sideRibbon(model, {.side = {{99}}}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright::test
