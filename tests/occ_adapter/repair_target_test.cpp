// SPDX-License-Identifier: LGPL-2.1-or-later
// Seams that can't have the curvature asked for.
#include <gtest/gtest.h>

#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>

#include "grids.hpp"
#include "match_pairs.hpp"
#include "repair_checks.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::RepairOptions;
using occ::RepairReport;
using occ::SeamRepair;

constexpr double width = 20, bend_per_mm = 0.02, across_per_mm = 0.01;

/// x from x0 to x0 + 20, y from y0 to y0 + 20: z = bend x^2 / 2 + 0.01 y^2 / 2 + twist x y.
Spline quarter(double x0, double y0, double bend, double twist) {
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  const auto ordinates = [](double from, double second) {
    const double to = from + width;
    return std::array<double, 3>{second * from * from / 2, second * from * to / 2,
                                 second * to * to / 2};
  };
  const std::array<double, 3> of_x = ordinates(x0, bend), of_y = ordinates(y0, across_per_mm);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double x = x0 + width * i / 2, y = y0 + width * j / 2;
      poles(i + 1, j + 1) = gp_Pnt(x, y, of_x[i] + of_y[j] + twist * x * y);
    }
  Spline surface = splineOf(poles, 2, 2);
  surface->IncreaseDegree(5, 5);
  return surface;
}

/// Four quarters about the origin, faces 3 and 4 with another curvature, and face 4 twisted, so it
/// meets faces 2 and 3 at small angles. If faces 1 and 3 stay, face 2 has face 1's curvature along
/// x at the origin and face 4 has face 3's, since the edges there lie on faces that stay. So faces
/// 2 and 4 can share one tangent plane along their edge, but not one curvature.
TopoDS_Shape quarters(double twist_per_mm) {
  return gridOf({{quarter(-width, -width, 0, 0), quarter(-width, 0, 0, 0)},
                 {quarter(0, -width, bend_per_mm, 0), quarter(0, 0, bend_per_mm, twist_per_mm)}});
}

/// Beside them two sheets that can have what is asked for.
TopoDS_Shape quartersAndSheets(double twist_per_mm) {
  std::mt19937 generator(testSeed(1));
  const BRep_Builder builder;
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, quarters(twist_per_mm));
  gp_Trsf away;
  away.SetTranslation(gp_Vec(200, 0, 0));
  builder.Add(both, joinedSheets(disturbedSheets(generator, 0.01)).Moved(away));
  return both;
}

RepairOptions lowerOnesStay(int order) {
  RepairOptions options = strictRepair(order);
  options.fixed_faces = {1, 3};
  return options;
}

bool isBetween(const SeamRepair& seam, int a, int b) {
  return seam.before.faces == std::array<int, 2>{a, b} ||
         seam.before.faces == std::array<int, 2>{b, a};
}

TEST(RepairTarget, WhatCannotHaveOneCurvatureGetsOneTangentPlane) {
  for (const double twist_per_mm : {1e-4, -5e-4}) {
    SCOPED_TRACE(twist_per_mm);
    const RepairReport report = repairedModel(quartersAndSheets(twist_per_mm), lowerOnesStay(2));
    int to_g1 = 0, to_g2 = 0;
    for (const SeamRepair& seam : report.seams) {
      SCOPED_TRACE(describe(seam.after) + ": " + seam.reason.text);
      if (isBetween(seam, 2, 4)) {
        ++to_g1;
        EXPECT_EQ(seam.before.verdict.level, Level::G0);
        EXPECT_EQ(seam.after.verdict.level, Level::G1);
        EXPECT_EQ(seam.after.verdict.seam_class, SeamClass::Defect);
        EXPECT_TRUE(seam.treated);
        EXPECT_FALSE(seam.repaired);
        EXPECT_EQ(seam.reason.text.rfind("G1 reached; G2: ", 0), 0);
        EXPECT_GT(seam.reason.text.size(), std::string("G1 reached; G2: ").size());
      } else if (isBetween(seam, 3, 4) || isBetween(seam, 5, 6)) {
        ++to_g2;
        EXPECT_TRUE(seam.repaired);
        EXPECT_GE(seam.after.verdict.level, Level::G2);
        EXPECT_TRUE(seam.reason.empty());
      } else {
        EXPECT_GE(seam.after.verdict.level, std::min(seam.before.verdict.level, Level::G2));
        EXPECT_EQ(seam.reason.text.find("G1 reached"), std::string::npos);
      }
    }
    EXPECT_EQ(to_g1, 1);
    EXPECT_EQ(to_g2, 2);
  }
}

/// With the first target out of reach the second one is met as it is without the first, by moves of
/// the same size.
TEST(RepairTarget, TheTangentPlaneIsAsGoodAsAskedForAlone) {
  const RepairReport both = repairedModel(quarters(1e-4), lowerOnesStay(2)),
                     alone = repairedModel(quarters(1e-4), lowerOnesStay(1));
  EXPECT_EQ(repairedSeams(alone), 2) << reasonsOf(alone);
  for (std::size_t i = 0; i < both.seams.size(); ++i)
    if (alone.seams[i].repaired) {
      EXPECT_GE(both.seams[i].after.verdict.level, Level::G1) << both.seams[i].reason.text;
    }
  EXPECT_LE(largestMove_mm(both), 2 * largestMove_mm(alone));
}

TEST(RepairTarget, BothReasonsAreToldWhereNeitherIsReached) {
  RepairOptions options = lowerOnesStay(2);
  options.max_move_mm = 1e-6;
  const RepairReport report = repairedModel(quarters(5e-4), options);
  EXPECT_FALSE(report.changed());
  int told = 0;
  for (const SeamRepair& seam : report.seams) {
    if (seam.before.verdict.level != Level::G0) continue;
    const std::size_t second = seam.reason.text.find("; G1: ");
    ASSERT_NE(second, std::string::npos) << seam.reason.text;
    EXPECT_GT(second, 0);
    EXPECT_GT(seam.reason.text.size(), second + 6);
    ++told;
  }
  EXPECT_EQ(told, 2);
}

}  // namespace
}  // namespace seamwright::test
