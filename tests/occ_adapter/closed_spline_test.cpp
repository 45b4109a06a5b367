// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <GeomConvert_ApproxSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <algorithm>
#include <numbers>

#include "match_pairs.hpp"

#include <seamwright/occ_adapter/convert/closed_spline.hpp>

namespace seamwright::test {
namespace {

using occ::Direction;
using occ::endsAtItself;
using occ::makeClamped;
using occ::makePeriodic;
using std::numbers::pi;

constexpr double near_mm = 1e-6;
constexpr std::array<double, 4> all_round = {0, 2 * pi, 0, 2 * pi};

Spline torus(const std::array<double, 4>& range) {
  const handle<Geom_Surface> part = new Geom_RectangularTrimmedSurface(
      new Geom_ToroidalSurface(gp_Ax3(), 20, 6), range[0], range[1], range[2], range[3]);
  return GeomConvert_ApproxSurface(part, 1e-5, GeomAbs_C2, GeomAbs_C2, 8, 8, 200, 0).Surface();
}

double largestDistance(const Geom_Surface& a, const Geom_Surface& b,
                       const std::array<double, 4>& range) {
  double largest = 0;
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 60; ++j) {
      const double u = range[0] + (range[1] - range[0]) * i / 60,
                   v = range[2] + (range[3] - range[2]) * j / 60;
      largest = std::max(largest, a.Value(u, v).Distance(b.Value(u, v)));
    }
  return largest;
}

TEST(ClosedSpline, ATorusIsPeriodicBothWays) {
  const Spline given = torus(all_round), spline = Spline::DownCast(given->Copy());
  for (const Direction direction : {Direction::U, Direction::V}) {
    ASSERT_TRUE(endsAtItself(*spline, direction, near_mm));
    makePeriodic(*spline, direction, near_mm);
    EXPECT_FALSE(endsAtItself(*spline, direction, near_mm));
  }
  EXPECT_TRUE(spline->IsUPeriodic() && spline->IsVPeriodic());
  EXPECT_GE(std::min(spline->Continuity(), GeomAbs_C2), GeomAbs_C2);
  EXPECT_LE(largestDistance(*given, *spline, all_round), 2 * near_mm);
  const Spline periodic = Spline::DownCast(spline->Copy());
  makeClamped(*spline);
  EXPECT_EQ(spline->UMultiplicity(1), spline->UDegree() + 1);
  EXPECT_EQ(spline->VMultiplicity(spline->NbVKnots()), spline->VDegree() + 1);
  std::array<double, 4> range{};
  spline->Bounds(range[0], range[1], range[2], range[3]);
  for (int k = 0; k < 4; ++k) EXPECT_DOUBLE_EQ(range[k], all_round[k]);
  EXPECT_LE(largestDistance(*periodic, *spline, all_round), 1e-12);
}

TEST(ClosedSpline, OpenSurfacesAndSinglePointsDoNotEndAtThemselves) {
  const Spline half = torus({0, pi, 0, 2 * pi});
  EXPECT_FALSE(endsAtItself(*half, Direction::U, near_mm));
  EXPECT_TRUE(endsAtItself(*half, Direction::V, near_mm));
  Spline open = torus(all_round);
  open->SetPole(open->NbUPoles(), 3,
                open->Pole(open->NbUPoles(), 3).Translated(gp_Vec(0, 0, 2 * near_mm)));
  EXPECT_FALSE(endsAtItself(*open, Direction::U, near_mm));
  EXPECT_TRUE(endsAtItself(*open, Direction::U, 3 * near_mm));
  // A spindle whose tips are one point.
  const Spline spindle = torus(all_round);
  for (int i = 1; i <= spindle->NbUPoles(); ++i)
    for (const int j : {1, spindle->NbVPoles()}) spindle->SetPole(i, j, gp_Pnt(1, 2, 3));
  EXPECT_FALSE(endsAtItself(*spindle, Direction::V, near_mm));
}

/// What meets itself at an angle keeps it.
TEST(ClosedSpline, ACreaseStays) {
  TColgp_Array2OfPnt poles(1, 4, 1, 2);
  const std::array<gp_Pnt, 4> drop = {gp_Pnt(0, 0, 0), gp_Pnt(20, 15, 0), gp_Pnt(20, -15, 0),
                                      gp_Pnt(0, 0, 0)};
  for (int i = 0; i < 4; ++i) {
    poles(i + 1, 1) = drop[i];
    poles(i + 1, 2) = drop[i].Translated(gp_Vec(0, 0, 10));
  }
  const Spline given = splineOf(poles, 3, 1), spline = Spline::DownCast(given->Copy());
  std::array<double, 4> range{};
  given->Bounds(range[0], range[1], range[2], range[3]);
  ASSERT_TRUE(endsAtItself(*spline, Direction::U, near_mm));
  makePeriodic(*spline, Direction::U, near_mm);
  EXPECT_EQ(spline->UMultiplicity(1), 3);
  makeClamped(*spline);
  EXPECT_LE(largestDistance(*given, *spline, range), 1e-13);
  EXPECT_EQ(spline->NbUPoles(), 4);
}

}  // namespace
}  // namespace seamwright::test
