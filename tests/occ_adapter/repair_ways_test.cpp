// SPDX-License-Identifier: LGPL-2.1-or-later
// What several ways do to one face.
#include <gtest/gtest.h>

#include <BRep_Tool.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <iostream>

#include "match_pairs.hpp"
#include "repair_checks.hpp"
#include "repair_trials.hpp"

namespace seamwright::test {
namespace {

using occ::modelFromShape;
using occ::repair;
using occ::RepairReport;

/// The second of three faces is joined with the first in one way and with the third, which is rational, in another.
Net joinedInTwoWays() {
  NetShape shape;
  shape.columns = 3;
  shape.rows = 1;
  shape.bend = 0.1;
  std::mt19937 generator(20521);
  Net net = piecesOfOne(shape, generator);
  const auto disturbFace = [&](NetFace& face, double noise_mm) {
    Geom_BSplineSurface& surface = *face.surface;
    for (int i = 1; i <= surface.NbUPoles(); ++i)
      for (int j = 1; j <= surface.NbVPoles(); ++j)
        surface.SetPole(
            i, j,
            surface.Pole(i, j).Translated(gp_Vec(random(generator, noise_mm), random(generator, noise_mm),
                                                 random(generator, noise_mm))));
  };
  disturbFace(net.faces[0], 0.05);
  disturbFace(net.faces[2], 0.005);
  Geom_BSplineSurface& third = *net.faces[2].surface;
  for (int i = 1; i <= third.NbUPoles(); ++i)
    for (int j = 1; j <= third.NbVPoles(); ++j) third.SetWeight(i, j, 1 + 1e-3 * (i + j));
  return net;
}

TEST(RepairWays, MovesOfSeveralWaysAddUp) {
  const TopoDS_Shape shape = shapeOf(joinedInTwoWays());
  const RepairReport report = repair(modelFromShape(shape), trialOptions({}));
  ASSERT_EQ(repairedSeams(report), 2) << reasonsOf(report);
  const auto second = std::ranges::find(report.moves, 2, &occ::FaceMove::face);
  ASSERT_NE(second, report.moves.end());
  const auto surfaceOf = [](const TopoDS_Shape& of) {
    return Spline::DownCast(BRep_Tool::Surface(face(of, 2)));
  };
  const Spline before = surfaceOf(shape), after = surfaceOf(report.model.shape);
  std::array<double, 4> range{};
  before->Bounds(range[0], range[1], range[2], range[3]);
  double seen_mm = 0;
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 60; ++j) {
      const double u = range[0] + (range[1] - range[0]) * i / 60,
                   v = range[2] + (range[3] - range[2]) * j / 60;
      seen_mm = std::max(seen_mm, before->Value(u, v).Distance(after->Value(u, v)));
    }
  EXPECT_GE(second->largest_move_mm, seen_mm);
  std::cout << "MOVE " << second->largest_move_mm << " seen " << seen_mm << "\n";
  // Each way alone keeps within that.
  occ::RepairOptions less = trialOptions({});
  less.max_move_mm = 0.98 * second->largest_move_mm;
  const RepairReport limited = repair(modelFromShape(shape), less);
  EXPECT_LE(largestMove_mm(limited), less.max_move_mm);
}

}  // namespace
}  // namespace seamwright::test
