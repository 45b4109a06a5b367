// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <BRepBuilderAPI_Transform.hxx>
#include <Eigen/Geometry>
#include <Geom_BezierSurface.hxx>
#include <Geom_Plane.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "match_pairs.hpp"
#include "strict_blend.hpp"
#include "support/random.hpp"

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/blend/blend_surface.hpp>

namespace seamwright::test {
namespace {

using occ::blendSurface;
using occ::BlendSurfaceOptions;
using occ::BlendSurfaceReport;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// The graph z = a x^2 + b x y + c y^2 over a square of 80 mm about the origin.
struct Bowl {
  double a = 0.01, b = 0.006, c = -0.004;

  double at(double x, double y) const { return a * x * x + b * x * y + c * y * y; }
  handle<Geom_Surface> surface() const {
    TColgp_Array2OfPnt poles(1, 3, 1, 3);
    constexpr double half = 40;
    // The polar form of z, which gives poles of degree 2 by 2.
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double x = half * (i - 1), y = half * (j - 1);
        const double xx = i == 1 ? -half * half : half * half,
                     yy = j == 1 ? -half * half : half * half;
        poles(i + 1, j + 1) = gp_Pnt(x, y, a * xx + b * x * y + c * yy);
      }
    return new Geom_BezierSurface(poles);
  }
};

/// Two parts of a surface over a square of 80 mm, left and right of a gap that opens at the origin
/// by an angle. Straight sides of 15 mm.
struct Opening {
  TopoDS_Shape shape;
  int start = 0, end = 0;
};

gp_Pnt2d parameters(double x, double y) {
  return {0.5 + x / 80, 0.5 + y / 80};
}

Opening opening(const handle<Geom_Surface>& surface, double angle_rad) {
  const auto ray = [](double angle, double share) {
    return parameters(15 * share * std::cos(angle), 15 * share * std::sin(angle));
  };
  const auto path = [&](double angle) {
    return curvedPath({ray(angle, 0), ray(angle, 0.3), ray(angle, 0.7), ray(angle, 1)});
  };
  const gp_Vec2d below(0, -0.1), beside(-0.1 * std::sin(angle_rad), 0.1 * std::cos(angle_rad));
  Opening result{
      loose(trimmedFace(surface, path(0), below), trimmedFace(surface, path(angle_rad), beside))};
  const auto middle = [&](double angle) {
    const gp_Pnt2d uv = ray(angle, 0.5);
    return surface->Value(uv.X(), uv.Y());
  };
  result.start = edgeNear(result.shape, middle(0));
  result.end = edgeNear(result.shape, middle(angle_rad));
  return result;
}

double largestCurvature(const BSplineSurface& surface, double u, double v) {
  const SurfaceJet there = jet(surface, u, v);
  return curvatureTensor(there, there.u.cross(there.v).normalized()).norm();
}

TEST(MeetingBlend, ClosesAGapThatOpensAtAVertex) {
  const Bowl bowl;
  for (const double degrees : {40.0, 90.0, 130.0})
    for (int order = 1; order <= 2; ++order) {
      const Opening gap = opening(bowl.surface(), degrees * degree);
      const BlendSurfaceReport blend =
          blendSurface(gap.shape, {.side = {{gap.start}}, .order = order},
                       {.side = {{gap.end}}, .order = order}, strictly());
      EXPECT_TRUE(blend.reached) << degrees << " G" << order << " spans " << blend.spans;
      EXPECT_FALSE(blend.fold);
      // One point of the one lateral boundary, and near it the surface is as curved as the faces.
      for (const double v : {0.0, 0.3, 1.0}) EXPECT_LT(jet(blend.surface, 0, v).p.norm(), 1e-7);
      for (const double u : {0.003, 0.03, 0.3})
        for (const double v : {0.1, 0.3, 0.5, 0.8}) {
          const Eigen::Vector3d p = jet(blend.surface, u, v).p;
          const double distance2 = p.head<2>().squaredNorm();
          EXPECT_LT(std::abs(p.z() - bowl.at(p.x(), p.y())), 0.01 * distance2);
          EXPECT_LT(largestCurvature(blend.surface, u, v), 0.15);
        }
    }
}

TEST(MeetingBlend, SidesMayMeetAtBothEnds) {
  const handle<Geom_Surface> plane = new Geom_Plane(gp::XOY());
  const auto path = [](double rise) {
    return curvedPath({{0, 0}, {7, rise}, {14, rise}, {21, 0}});
  };
  const TopoDS_Shape model = loose(trimmedFace(plane, path(-4), gp_Vec2d(0, -10)),
                                   trimmedFace(plane, path(4), gp_Vec2d(0, 10)));
  const double top = path(4)->Value(0.5).Y();
  const int start = edgeNear(model, gp_Pnt(10.5, -top, 0)),
            end = edgeNear(model, gp_Pnt(10.5, top, 0));
  const BlendSurfaceReport blend =
      blendSurface(model, {.side = {{start}}}, {.side = {{end}}}, strictly());
  EXPECT_TRUE(blend.reached);
  EXPECT_FALSE(blend.fold);
  for (int i = 0; i <= 10; ++i)
    for (int j = 0; j <= 10; ++j)
      EXPECT_LT(std::abs(jet(blend.surface, i / 10.0, j / 10.0).p.z()), 1e-12);
}

TEST(MeetingBlend, OfFacesWithDifferentTangentPlanesIsG1Only) {
  const Opening flat = opening(Bowl{0, 0, 0}.surface(), 90 * degree);
  // The second face turns about its side by 20 degrees, so the planes differ by that.
  gp_Trsf turn;
  turn.SetRotation(gp::OY(), 20 * degree);
  const TopTools_IndexedMapOfShape faces = partsOf(flat.shape, TopAbs_FACE);
  const TopoDS_Shape model =
      loose(faces(1), BRepBuilderAPI_Transform(faces(2), turn, true).Shape());
  const auto blended = [&](int order) {
    return blendSurface(model, {.side = {{flat.start}}, .order = order},
                        {.side = {{flat.end}}, .order = order}, strictly());
  };
  EXPECT_TRUE(blended(1).reached);
  EXPECT_THAT([&] { blended(2); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("(20 degrees): no surface has")));
}

TEST(MeetingBlend, AnOpeningThatIsTooWideOrTooNarrowIsRefused) {
  for (const int degrees : {3, 178}) {
    const Opening gap = opening(Bowl{0, 0, 0}.surface(), degrees * degree);
    const occ::BlendEnd start{.side = {{gap.start}}}, end{.side = {{gap.end}}};
    EXPECT_THAT(
        [&] { blendSurface(gap.shape, start, end); },
        ThrowsMessage<std::invalid_argument>(HasSubstr(std::to_string(degrees) + " degrees")));
  }
}

/// Of the tensor of curvature at neighbouring samples, the largest difference.
double largestStep(const BSplineSurface& surface, double v, double from, double to, int steps) {
  double largest = 0;
  Eigen::Matrix3d last = Eigen::Matrix3d::Zero();
  for (int i = 0; i <= steps; ++i) {
    const SurfaceJet there = jet(surface, from + (to - from) * i / steps, v);
    const Eigen::Matrix3d curvature = curvatureTensor(there, there.u.cross(there.v).normalized());
    if (i > 0) largest = std::max(largest, (curvature - last).norm());
    last = curvature;
  }
  return largest;
}

TEST(BlendSurface, IsC2InsideWithFewKnotsWhereTheSidesHaveKnotsNearOneAnother) {
  std::mt19937 generator(testSeed());
  const Spline first = sheet(generator, 7, 6, 3, 3), second = sheet(generator, 7, 6, 3, 3);
  gp_Trsf shift;
  shift.SetTranslation(gp_Vec(85, 0, 8));
  const TopoDS_Shape model =
      loose(wholeFace(first), BRepBuilderAPI_Transform(wholeFace(second), shift, true).Shape());
  const int left = edgeNear(model, gp_Pnt(60, 20, 0)), right = edgeNear(model, gp_Pnt(85, 20, 8));
  const BlendSurfaceReport blend =
      blendSurface(model, {.side = {{left}}}, {.side = {{right}}}, BlendSurfaceOptions());
  EXPECT_TRUE(blend.reached);
  EXPECT_LE(blend.surface.countU(), 60);
  const std::vector<double>& knots = blend.surface.knots_u;
  for (std::size_t i = 6; i + 6 < knots.size(); ++i) {
    EXPECT_GT(knots[i + 3], knots[i]) << "more than three knots in one place";
    if (knots[i + 1] == knots[i]) continue;
    EXPECT_GT(knots[i + 1] - knots[i], 1e-3);
    // Dense beside a knot, curvature changes no faster than it does everywhere.
    for (const double v : {0.0, 0.5, 1.0}) {
      const double around = largestStep(blend.surface, v, knots[i] - 0.01, knots[i] + 0.01, 10);
      EXPECT_LT(largestStep(blend.surface, v, knots[i] - 1e-4, knots[i] + 1e-4, 40), around);
    }
  }
}

/// Two sheets side by side, the second one 25 mm away, with one pole of the first one moved.
TopoDS_Shape sheets(std::uint32_t seed, const gp_Vec& move) {
  std::mt19937 generator(seed);
  const Spline first = sheet(generator, 9, 8, 5, 5), second = sheet(generator, 9, 8, 5, 5);
  const int column = 2 + static_cast<int>(generator() % 5);
  first->SetPole(9, column, first->Pole(9, column).Translated(move));
  gp_Trsf shift;
  shift.SetTranslation(gp_Vec(85, 0, 8));
  return loose(wholeFace(first), BRepBuilderAPI_Transform(wholeFace(second), shift, true).Shape());
}

TEST(BlendSurface, MovesByNoMoreThanAFewTimesWhatAPoleMoves) {
  std::mt19937 generator(testSeed());
  constexpr double moved_mm = 1e-6;
  for (int order = 1; order <= 3; ++order) {
    const auto seed = static_cast<std::uint32_t>(generator());
    const gp_Vec move = moved_mm * gp_Dir(random(generator), random(generator), random(generator));
    const TopoDS_Shape one = sheets(seed, gp_Vec()), other = sheets(seed, move);
    const auto blended = [&](const TopoDS_Shape& shape) {
      const int left = edgeNear(shape, gp_Pnt(60, 20, 0)),
                right = edgeNear(shape, gp_Pnt(85, 20, 8));
      return blendSurface(shape, {.side = {{left}}, .order = order},
                          {.side = {{right}}, .order = order}, strictly());
    };
    const BlendSurfaceReport before = blended(one), after = blended(other);
    EXPECT_TRUE(before.reached);
    double most_mm = 0;
    for (int i = 0; i <= 40; ++i)
      for (int j = 0; j <= 10; ++j)
        most_mm = std::max(most_mm, (jet(before.surface, i / 40.0, j / 10.0).p -
                                     jet(after.surface, i / 40.0, j / 10.0).p)
                                        .norm());
    EXPECT_GT(most_mm, 0);
    EXPECT_LT(most_mm, 50 * moved_mm) << "G" << order << " seed " << seed;
  }
}

}  // namespace
}  // namespace seamwright::test
