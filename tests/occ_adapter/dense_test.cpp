// SPDX-License-Identifier: LGPL-2.1-or-later
// Every seam of real models against plain evaluation at thousands of points.
#include <gtest/gtest.h>

#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <filesystem>

#include <seamwright/occ_adapter/model/read.hpp>

#include "dense_oracle.hpp"
#include "shapes.hpp"

namespace seamwright::test {
namespace {

namespace fs = std::filesystem;
using occ::SeamResult;

/// The figure is a value that occurs where it is said to, and no dense point exceeds it by more than 1 % or by what the
/// survey leaves open, a hundredth of the tolerance.
void expectFigure(const char* what, const std::optional<Figure>& figure, double dense_maximum,
                  double dense_there, double left_open, double noise) {
  SCOPED_TRACE(what);
  ASSERT_TRUE(figure);
  EXPECT_GE(figure->lower, dense_maximum - std::max(0.01 * dense_maximum, left_open) - noise);
  EXPECT_NEAR(figure->lower, dense_there, 1e-6 * dense_there + noise);
  EXPECT_FALSE(figure->upper && *figure->upper < dense_maximum - noise);
}

/// The level by the same rules, from the dense figures; nothing where one lies within 2 % of its limit.
std::optional<Level> levelOf(const DenseMaxima& dense, const ContinuityTolerance& tolerance) {
  const auto near_limit = [](double value, double limit) { return std::abs(value - limit) < 0.02 * limit; };
  if (near_limit(dense.gap_mm, tolerance.gap_mm)) return std::nullopt;
  if (dense.gap_mm > tolerance.gap_mm) return Level::None;
  if (!dense.angle_rad) return Level::G0;
  if (near_limit(*dense.angle_rad, tolerance.angle_rad)) return std::nullopt;
  if (*dense.angle_rad > tolerance.angle_rad || dense.fold) return Level::G0;
  if (near_limit(dense.curvature_rel, tolerance.curvature_rel)) return std::nullopt;
  return dense.curvature_rel > tolerance.curvature_rel ? Level::G1 : Level::G2;
}

/// The class that follows from the figures for the level G1; nothing where a limit is near.
std::optional<SeamClass> classOf(const DenseMaxima& dense, const ContinuityTolerance& tolerance) {
  const auto level = levelOf(dense, tolerance);
  if (!level || !dense.angle_rad ||
      std::abs(*dense.angle_rad - tolerance.crease_rad) < 0.02 * tolerance.crease_rad)
    return std::nullopt;
  if (*level == Level::None) return SeamClass::Defect;
  if (*level >= Level::G1) return SeamClass::Smooth;
  if (!dense.fold && *dense.angle_rad < tolerance.crease_rad) return SeamClass::Defect;
  if (dense.below_crease_share > 0.2 && dense.below_crease_share < 0.8) return std::nullopt;
  return dense.below_crease_share > 0.5 ? SeamClass::Defect : SeamClass::Crease;
}

/// Rounding of coordinates of that size, as it shows in the figures.
struct Noise {
  double gap_mm = 1e-9;
  double angle_rad = 3e-8;
  double curvature_per_mm = 1e-6;
  double curvature_rel = 1e-5;
};

void expectAgrees(const SeamResult& seam, const std::array<DenseSide, 2>& sides,
                  const ContinuityTolerance& tolerance, int points) {
  SCOPED_TRACE(describe(seam));
  const DenseMaxima dense = denseMaxima(sides, points, tolerance);
  const auto there = [&](const Figure& figure) {
    return densePoint(sides, figure.at, tolerance.flat_radius_mm);
  };
  const Noise noise;
  ASSERT_TRUE(seam.figures.gap_mm);
  expectFigure("gap", seam.figures.gap_mm, dense.gap_mm, there(*seam.figures.gap_mm).gap_mm,
               0.01 * tolerance.gap_mm, noise.gap_mm);
  ASSERT_EQ(seam.figures.angle_rad.has_value(), dense.angle_rad.has_value());
  if (!dense.angle_rad) return;
  const double angle_there = there(*seam.figures.angle_rad).angle_rad.value_or(-1);
  expectFigure("angle", seam.figures.angle_rad, *dense.angle_rad, angle_there, 0.01 * tolerance.angle_rad,
               noise.angle_rad);
  if (*dense.angle_rad > 1.01 * tolerance.crease_rad) {
    EXPECT_FALSE(seam.figures.curvature_per_mm);
  } else if (seam.figures.curvature_per_mm) {
    // Towards poles curvature magnifies the rounding of the evaluation, which differs with OpenCASCADE's caches.
    constexpr double magnified = 2e-4;
    const double per_mm = there(*seam.figures.curvature_per_mm).curvature_per_mm;
    expectFigure("curvature", seam.figures.curvature_per_mm, dense.curvature_per_mm, per_mm,
                 0.01 * tolerance.curvature_rel * dense.norm_per_mm,
                 noise.curvature_per_mm + magnified * per_mm);
    const double relative = there(*seam.figures.curvature_rel).curvature_rel;
    expectFigure("relative curvature", seam.figures.curvature_rel, dense.curvature_rel, relative,
                 0.01 * tolerance.curvature_rel, noise.curvature_rel + magnified * relative);
  } else {
    EXPECT_TRUE(dense.fold || *dense.angle_rad > 0.99 * tolerance.crease_rad);
  }
  const auto level = levelOf(dense, tolerance);
  EXPECT_EQ(name(seam.verdict.level), name(level.value_or(seam.verdict.level)));
  const auto seam_class = classOf(dense, tolerance);
  EXPECT_EQ(name(seam.verdict.seam_class), name(seam_class.value_or(seam.verdict.seam_class)));
}

void compareAllSeams(const occ::Model& model, int points) {
  const occ::Report report = occ::analyze(model);
  ASSERT_FALSE(report.seams.empty());
  int compared = 0;
  for (const SeamResult& seam : report.seams) {
    if (seam.note.find("rebuilt") != std::string::npos) continue;  // another path than the stored one
    const auto sides = denseSides(model.shape, seam.edges.at(0), seam.faces);
    if (!sides) continue;
    ++compared;
    expectAgrees(seam, *sides, report.tolerance, points);
  }
  EXPECT_GE(2 * compared, static_cast<int>(report.seams.size()));
  std::printf("%d of %zu seams compared\n", compared, report.seams.size());
}

struct File {
  const char* name;
  const char* path;
  int points;
};

void PrintTo(const File& file, std::ostream* out) {
  *out << file.path;
}

class DenseFiles : public ::testing::TestWithParam<File> {};

TEST_P(DenseFiles, EveryFigureAndLevel) {
  const fs::path given = GetParam().path;
  const fs::path path = given.is_absolute() ? given : fs::path(SEAMWRIGHT_TEST_MODELS) / given;
  if (!fs::exists(path)) GTEST_SKIP() << path << " is not installed";
  compareAllSeams(occ::readModel(path), GetParam().points);
}

#define OCCT_DATA "/usr/share/opencascade/data/"
INSTANTIATE_TEST_SUITE_P(Installed, DenseFiles,
                         ::testing::Values(File{"linkrods", OCCT_DATA "step/linkrods.step", 2001},
                                           File{"screw", OCCT_DATA "step/screw.step", 20001},
                                           File{"hammer", OCCT_DATA "occ/hammer.brep", 2001},
                                           File{"shell1", OCCT_DATA "occ/shell1.brep", 2001},
                                           File{"Bottom", OCCT_DATA "occ/Bottom.brep", 2001}),
                         [](const auto& file) { return std::string(file.param.name); });

INSTANTIATE_TEST_SUITE_P(Models, DenseFiles,
                         ::testing::Values(File{"NIST_1", "small/NIST_MBE_PMI_1.stp", 2001},
                                           File{"NIST_5", "freeform/NIST_MBE_PMI_5.stp", 2001},
                                           File{"NIST_11", "small/NIST_MBE_PMI_11.stp", 20001},
                                           File{"nozzle", "small/nozzle.stp", 20001},
                                           File{"rounded_cube", "small/rounded-cube_rounded-cube.step",
                                                20001},
                                           File{"bottle", "freeform/bottle.brep", 2001},
                                           File{"blendsolid", "freeform/blendsolid_test.step", 2001},
                                           File{"s60", "freeform/s60.step", 2001},
                                           File{"Silk_01", "freeform/Silk_Demo_01_sewn.step", 2001},
                                           File{"Silk_02", "freeform/Silk_Demo_02_sewn.step", 2001}),
                         [](const auto& file) { return std::string(file.param.name); });

TEST(DenseOracle, KnowsClosedForms) {
  const auto measured = [](const TopoDS_Shape& shape) {
    const SeamResult seam = analyzed(shape).seams.at(0);
    return denseMaxima(denseSides(shape, seam.edges[0], seam.faces).value(), 501, {});
  };
  const DenseMaxima tangent = measured(planeAndCylinder(4, 9));
  EXPECT_NEAR(tangent.curvature_per_mm, 0.25, 1e-12);
  EXPECT_EQ(tangent.curvature_rel, 1);
  EXPECT_FALSE(tangent.fold);
  EXPECT_TRUE(measured(foldedPlanes()).fold);
  const DenseMaxima crossed = measured(crossedCylinders(10));
  EXPECT_NEAR(crossed.curvature_per_mm, 0.1, 1e-7);
  EXPECT_NEAR(*crossed.angle_rad, 6e-4 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(measured(sphereAndTorus(10, 9.999)).curvature_per_mm, 1 / 9.999 - 0.1, 1e-12);
}

TEST(DenseOracle, AgreesOnARoundedBox) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(20, 30, 40).Shape();
  BRepFilletAPI_MakeFillet rounded(box);
  for (TopExp_Explorer it(box, TopAbs_EDGE); it.More(); it.Next()) rounded.Add(2, TopoDS::Edge(it.Current()));
  compareAllSeams(occ::modelFromShape(rounded.Shape()), 2001);
}

}  // namespace
}  // namespace seamwright::test
