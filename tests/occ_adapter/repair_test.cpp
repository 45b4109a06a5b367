// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "grids.hpp"
#include "match_pairs.hpp"
#include "repair_checks.hpp"
#include "repair_trials.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/repair/repair.hpp>

namespace seamwright::test {
namespace {

using occ::modelFromShape;
using occ::repair;
using occ::RepairOptions;
using occ::RepairReport;

/// Noise on the poles of up to so many rows beside the inner seams.
void disturbSeams(const Patches& patches, std::mt19937& generator, int rows, double noise_mm) {
  for (std::size_t i = 0; i < patches.size(); ++i)
    for (std::size_t j = 0; j < patches[i].size(); ++j) {
      const Spline& patch = patches[i][j];
      const int nu = patch->NbUPoles(), nv = patch->NbVPoles();
      for (int k = 1; k <= nu; ++k)
        for (int l = 1; l <= nv; ++l) {
          const bool near = (i > 0 && k <= rows) || (i + 1 < patches.size() && k > nu - rows) ||
                            (j > 0 && l <= rows) || (j + 1 < patches[i].size() && l > nv - rows);
          if (!near) continue;
          patch->SetPole(k, l,
                         patch->Pole(k, l).Translated(gp_Vec(random(generator, noise_mm),
                                                             random(generator, noise_mm),
                                                             random(generator, noise_mm))));
        }
    }
}

TopoDS_Shape disturbedGrid(std::mt19937& generator, int count_u, int count_v, double noise_mm,
                           int rows = 2) {
  const auto cuts = [](int count) {
    std::vector<double> at;
    for (int k = 0; k <= count; ++k) at.push_back(static_cast<double>(k) / count);
    return at;
  };
  const Patches patches = cutUp(sheet(generator, 9, 8, 3, 3), cuts(count_u), cuts(count_v));
  disturbSeams(patches, generator, rows, noise_mm);
  return gridOf(patches);
}

/// To tolerances of 0.1 micrometres and 0.001 degrees. Noise of 0.05 mm breaks the seam by more
/// than two degrees; a fair move of the faces is then larger than usually allowed.
TEST(Repair, TwoSheetsAreJoined) {
  for (const int order : {1, 2})
    for (const double noise_mm : {0.001, 0.01, order == 1 ? 0.05 : 0.02})
      for (unsigned seed = 1; seed <= 3; ++seed) {
        std::mt19937 generator(testSeed(seed));
        const TopoDS_Shape shape = disturbedGrid(generator, 2, 1, noise_mm);
        SCOPED_TRACE("order " + std::to_string(order) + ", noise " + std::to_string(noise_mm) +
                     " mm, seed " + std::to_string(seed));
        RepairOptions options = strictRepair(order);
        options.max_move_mm = 1;
        const RepairReport report = repairedModel(shape, options);
        EXPECT_EQ(treated(report), 1);
        EXPECT_EQ(repairedSeams(report), 1) << reasonsOf(report);
        EXPECT_LE(largestMove_mm(report), 20 * noise_mm);
        const RepairReport again = repairedModel(report.model.shape, options);
        EXPECT_FALSE(again.changed());
      }
}

TEST(Repair, GridsAreJoined) {
  for (const double noise_mm : {0.001, 0.01, 0.05})
    for (unsigned seed = 1; seed <= 2; ++seed) {
      std::mt19937 generator(testSeed(seed));
      const TopoDS_Shape shape = disturbedGrid(generator, 2, 2, noise_mm);
      SCOPED_TRACE("noise " + std::to_string(noise_mm) + " mm, seed " + std::to_string(seed));
      RepairOptions options = strictRepair(1);
      options.max_move_mm = 1;
      const RepairReport report = repairedModel(shape, options);
      EXPECT_EQ(treated(report), 4);
      EXPECT_EQ(repairedSeams(report), 4) << reasonsOf(report);
      EXPECT_LE(largestMove_mm(report), 20 * noise_mm);
    }
}

/// Where a fair move is larger than allowed what is promised holds all the same.
TEST(Repair, WhatIsBrokenBeyondTheMovesAllowedIsNoWorseAfter) {
  for (const int count_v : {1, 2})
    for (unsigned seed = 1; seed <= 2; ++seed) {
      std::mt19937 generator(testSeed(seed));
      SCOPED_TRACE(std::to_string(count_v) + " rows, seed " + std::to_string(seed));
      const RepairReport report =
          repairedModel(disturbedGrid(generator, 2, count_v, 0.1), strictRepair(1));
      EXPECT_EQ(treated(report), count_v == 1 ? 1 : 4);
    }
}

TEST(Repair, AFixedFaceStays) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::mt19937 generator(testSeed(seed));
    RepairOptions options = strictRepair(1);
    options.fixed_faces = {1};
    const RepairReport report = repairedModel(disturbedGrid(generator, 2, 1, 0.01), options);
    EXPECT_EQ(repairedSeams(report), 1);
    ASSERT_EQ(report.moves.size(), 1);
    EXPECT_EQ(report.moves[0].face, 2);
    options.fixed_faces = {2, 1};
    const RepairReport none = repairedModel(disturbedGrid(generator, 2, 1, 0.01), options);
    EXPECT_FALSE(none.changed());
    EXPECT_EQ(treated(none), 0);
    EXPECT_EQ(none.seams[0].reason.text, "face 1 is fixed; face 2 is fixed");
  }
}

TEST(Repair, JoinsSplinesToAnalyticFaces) {
  std::mt19937 generator(testSeed());
  for (const Trimmed& kind : trimmedKinds()) {
    SCOPED_TRACE(kind.name);
    const Spline strip = stripBeside(kind.surface, kind.path, kind.away, 15, generator, 0.01);
    const TopoDS_Shape shape =
        loose(trimmedFace(kind.surface, kind.path, kind.into), wholeFace(strip));
    RepairOptions options;
    options.match_mm = 0.5;
    options.sew = false;
    options.tolerance.gap_mm = 0.001;
    const RepairReport report = repairedModel(shape, options);
    EXPECT_EQ(treated(report), 1);
    EXPECT_EQ(repairedSeams(report), 1) << reasonsOf(report);
    ASSERT_EQ(report.moves.size(), 1);
    EXPECT_EQ(report.moves[0].face, 2);
  }
}

TEST(Repair, OnlyPickedEdgesAreTreated) {
  std::mt19937 generator(testSeed());
  const TopoDS_Shape shape = disturbedGrid(generator, 3, 1, 0.01);
  const RepairReport all = repairedModel(shape, strictRepair(1));
  ASSERT_EQ(all.seams.size(), 2);
  EXPECT_EQ(repairedSeams(all), 2) << reasonsOf(all);
  RepairOptions options = strictRepair(1);
  options.edges = all.seams[1].before.edges;
  const RepairReport one = repairedModel(shape, options);
  EXPECT_FALSE(one.seams[0].treated);
  ASSERT_TRUE(one.seams[1].repaired) << one.seams[1].reason.text;
  EXPECT_NE(one.moves.front().face, 1);
  const RepairReport again = repairedModel(one.model.shape, options);
  EXPECT_FALSE(again.changed());
  EXPECT_EQ(again.seams[1].reason.text, "it already reaches the target");
}

TEST(Repair, NoMoveIsLargerThanAllowed) {
  std::mt19937 generator(testSeed());
  RepairOptions options = strictRepair(1);
  options.max_move_mm = 1e-4;
  const TopoDS_Shape shape = disturbedGrid(generator, 2, 2, 0.01);
  const RepairReport report = repairedModel(shape, options);
  EXPECT_EQ(treated(report), 4);
  EXPECT_EQ(repairedSeams(report), 0);
  EXPECT_TRUE(report.model.shape.IsEqual(shape));
  for (const occ::SeamRepair& seam : report.seams) EXPECT_FALSE(seam.reason.empty());
}

TEST(Repair, TimeLimitKeepsWhatWasRepaired) {
  std::mt19937 generator(testSeed());
  RepairOptions options = strictRepair(1);
  const TopoDS_Shape shape = disturbedGrid(generator, 2, 2, 0.01);
  options.max_time_s = 1e-9;
  const RepairReport none = repairedModel(shape, options);
  EXPECT_EQ(treated(none), 4);
  EXPECT_TRUE(none.model.shape.IsEqual(shape));
  for (const occ::SeamRepair& seam : none.seams)
    EXPECT_EQ(seam.reason.text, "the time limit was reached first");
  options.max_time_s = 1e9;
  EXPECT_EQ(repairedSeams(repairedModel(shape, options)), 4);
}

/// Where a repair moves a face furthest along its normal: by how much, the face and its parameters.
struct Furthest {
  double move_mm = 0;
  int face = 0;
  gp_Pnt2d uv;
};

double normalMove_mm(const handle<Geom_Surface>& from, const handle<Geom_Surface>& to, double u,
                     double v) {
  gp_Pnt p;
  gp_Vec du, dv;
  from->D1(u, v, p, du, dv);
  return gp_Vec(p, to->Value(u, v)).Dot(du.Crossed(dv).Normalized());
}

Furthest furthestMove(const TopoDS_Shape& before, const TopoDS_Shape& after, int faces) {
  constexpr int points = 60;
  Furthest furthest;
  for (int number = 1; number <= faces; ++number) {
    const handle<Geom_Surface> from = BRep_Tool::Surface(face(before, number)),
                               to = BRep_Tool::Surface(face(after, number));
    std::array<double, 4> range{};
    from->Bounds(range[0], range[1], range[2], range[3]);
    for (int i = 0; i <= points; ++i)
      for (int j = 0; j <= points; ++j) {
        const double u = range[0] + (range[1] - range[0]) * i / points,
                     v = range[2] + (range[3] - range[2]) * j / points;
        const double move_mm = std::abs(normalMove_mm(from, to, u, v));
        if (move_mm > furthest.move_mm) furthest = {move_mm, number, gp_Pnt2d(u, v)};
      }
  }
  return furthest;
}

/// Half way between two surfaces, around parameters.
TopoDS_Face wallBetween(const handle<Geom_Surface>& from, const handle<Geom_Surface>& to,
                        const gp_Pnt2d& uv) {
  constexpr int points = 8;
  constexpr double reach = 0.1;
  std::array<double, 4> range{};
  from->Bounds(range[0], range[1], range[2], range[3]);
  const auto parameter = [](double at, double first, double last, int k) {
    const double step = reach * (last - first);
    return std::clamp(at, first + step, last - step) + step * (2.0 * (k - 1) / (points - 1) - 1);
  };
  TColgp_Array2OfPnt half(1, points, 1, points);
  for (int i = 1; i <= points; ++i)
    for (int j = 1; j <= points; ++j) {
      const double u = parameter(uv.X(), range[0], range[1], i),
                   v = parameter(uv.Y(), range[2], range[3], j);
      half(i, j) = (from->Value(u, v).XYZ() + to->Value(u, v).XYZ()) / 2;
    }
  return BRepBuilderAPI_MakeFace(GeomAPI_PointsToBSplineSurface(half).Surface(), 1e-7).Face();
}

/// A wall stands in the way of the point that would move furthest.
TEST(Repair, NoFaceMovesThroughAnother) {
  RepairOptions options;
  options.max_move_mm = 5;
  int in_the_way = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 generator(testSeed(seed));
    const TopoDS_Shape sheets = disturbedGrid(generator, 2, 1, 0.1);
    const RepairReport free = repairedModel(sheets, options);
    if (repairedSeams(free) == 0) continue;
    const Furthest furthest = furthestMove(sheets, free.model.shape, 2);
    const handle<Geom_Surface> from = BRep_Tool::Surface(face(sheets, furthest.face)),
                               to = BRep_Tool::Surface(face(free.model.shape, furthest.face));
    TopoDS_Compound both;
    const BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, sheets);
    builder.Add(both, wallBetween(from, to, furthest.uv));
    const RepairReport report = repairedModel(both, options);
    if (reasonsOf(report).find("it would pass through face 3") == std::string::npos) continue;
    ++in_the_way;
    const handle<Geom_Surface> now = BRep_Tool::Surface(face(report.model.shape, furthest.face));
    EXPECT_LT(std::abs(normalMove_mm(from, now, furthest.uv.X(), furthest.uv.Y())),
              furthest.move_mm / 2);
  }
  EXPECT_GT(in_the_way, 0);
}

TEST(Repair, AModelWithoutDefectsIsShared) {
  std::mt19937 generator(testSeed());
  for (const TopoDS_Shape& shape :
       {disturbedGrid(generator, 2, 2, 0), TopoDS_Shape(BRepPrimAPI_MakeBox(1, 2, 3).Shape())}) {
    const RepairReport report = repairedModel(shape, {});
    EXPECT_TRUE(report.model.shape.IsEqual(shape));
    EXPECT_FALSE(report.changed());
    EXPECT_EQ(treated(report), 0);
  }
}

TEST(Repair, RigidMotionChangesNothing) {
  constexpr double noise_mm = 0.01;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::mt19937 generator(testSeed(seed));
    const TopoDS_Shape shape = disturbedGrid(generator, 2, 2, noise_mm);
    const RepairReport here = repairedModel(shape, strictRepair(1));
    const RepairReport there =
        repairedModel(transformed(shape, randomMotion(generator)), strictRepair(1));
    EXPECT_EQ(repairedSeams(here), repairedSeams(there));
    ASSERT_EQ(here.moves.size(), there.moves.size());
    for (std::size_t i = 0; i < here.moves.size(); ++i)
      EXPECT_NEAR(here.moves[i].largest_move_mm, there.moves[i].largest_move_mm, noise_mm / 10);
  }
}

double volume_mm3(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

TEST(Repair, ASolidStaysClosed) {
  const RepairTrial trial{"blob 24", 0.01, testSeed()};
  const occ::Model model = modelFromShape(brokenModel(trial));
  const RepairReport report = repair(model, trialOptions(trial));
  EXPECT_EQ(treated(report), 48);
  EXPECT_EQ(repairedSeams(report), 48) << reasonsOf(report);
  EXPECT_TRUE(report.after.passed());
  EXPECT_TRUE(BRepCheck_Analyzer(report.model.shape).IsValid());
  const TopTools_IndexedMapOfShape shells = partsOf(report.model.shape, TopAbs_SHELL);
  ASSERT_GE(shells.Extent(), 1);
  for (int s = 1; s <= shells.Extent(); ++s) EXPECT_TRUE(BRep_Tool::IsClosed(shells(s)));
  GProp_GProps area;
  BRepGProp::SurfaceProperties(model.shape, area);
  EXPECT_NEAR(volume_mm3(report.model.shape), volume_mm3(model.shape),
              area.Mass() * largestMove_mm(report));
  for (std::size_t i = 0; i < report.seams.size(); ++i) {
    const occ::SeamRepair& seam = report.seams[i];
    EXPECT_GE(seam.after.verdict.level, std::min(seam.before.verdict.level, Level::G1))
        << describe(seam.after);
  }
}

TEST(Repair, ThreadsChangeNothing) {
  std::mt19937 generator(testSeed());
  for (const TopoDS_Shape& shape :
       {disturbedGrid(generator, 3, 2, 0.1), brokenModel({"trimmed bricks", 0.02, testSeed(1)})}) {
    const occ::Model model = modelFromShape(shape);
    RepairOptions one, four;
    one.jobs = 1;
    four.jobs = 4;
    const RepairReport alone = repair(model, one), together = repair(model, four);
    EXPECT_TRUE(alone.changed());
    EXPECT_EQ(bytesOf(alone.model.shape), bytesOf(together.model.shape));
    EXPECT_EQ(reasonsOf(alone), reasonsOf(together));
    ASSERT_EQ(alone.moves.size(), together.moves.size());
    for (std::size_t i = 0; i < alone.moves.size(); ++i)
      EXPECT_EQ(alone.moves[i].largest_move_mm, together.moves[i].largest_move_mm);
  }
}

TEST(Repair, RefusesBadOptions) {
  std::mt19937 generator(testSeed());
  const occ::Model model = modelFromShape(disturbedGrid(generator, 2, 1, 0.01));
  const auto refused = [&model](const RepairOptions& options, const std::string& text) {
    try {
      repair(model, options);
      ADD_FAILURE() << text;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  RepairOptions options;
  options.order = 3;
  refused(options, "order is 3");
  options = {};
  options.max_move_mm = -0.1;
  refused(options, "-0.1 mm");
  options.max_move_mm = 0;
  refused(options, "0 mm");
  options.max_move_mm = nan;
  refused(options, "nan");
  options = {};
  options.max_time_s = 0;
  refused(options, "time limit is 0 s");
  options.max_time_s = nan;
  refused(options, "nan s");
  options = {};
  options.tolerance.gap_mm = nan;
  refused(options, "nan");
  options = {};
  options.match_mm = -1;
  refused(options, "-1");
  options = {};
  options.jobs = -2;
  refused(options, "-2");
  options = {};
  options.edges = {0};
  refused(options, "edge 0");
  options.edges = {1, 8};
  refused(options, "edge 8: the model has edges 1 to 7");
  options.edges = {1};
  refused(options, "edge 1 is not a seam");
  options = {};
  options.fixed_faces = {3};
  refused(options, "face 3: the model has faces 1 to 2");
}

TEST(Repair, StopsWhereItIsAskedTo) {
  std::mt19937 generator(testSeed());
  const occ::Model model = modelFromShape(disturbedGrid(generator, 2, 2, 0.01));
  std::vector<double> shares;
  const auto note = [&shares](double share) {
    shares.push_back(share);
    return true;
  };
  repair(model, strictRepair(1), note);
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_EQ(shares.back(), 1);
  EXPECT_GE(shares.front(), 0);
  for (const double stop : {0.0, 0.1, 0.3, 0.5, 0.7}) {
    if (stop >= shares[shares.size() - 2]) {
      EXPECT_GT(stop, 0) << "progress is told while the repair runs";
      continue;
    }
    EXPECT_THROW(repair(model, strictRepair(1), [stop](double share) { return share < stop; }),
                 occ::Cancelled)
        << stop;
  }
}

}  // namespace
}  // namespace seamwright::test
