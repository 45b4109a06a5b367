// SPDX-License-Identifier: LGPL-2.1-or-later
// Every seam of models against plain evaluation at thousands of points.
#include <gtest/gtest.h>

#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

#include <seamwright/occ_adapter/model/read.hpp>

#include "dense_oracle.hpp"
#include "files.hpp"
#include "repair_trials.hpp"
#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::SeamResult;

/// The largest values just before, at and just after a parameter: on a knot line both sides count.
template <class Value>
DenseValue largestAround(double at, const Value& value_at) {
  DenseValue largest = value_at(at);
  for (const double beside : {1e-9, 1e-6, 1e-4})
    for (const double s : {std::max(0.0, at - beside), std::min(1.0, at + beside)})
      if (const DenseValue value = value_at(s); value.value > largest.value) largest = value;
  return largest;
}

/// No dense point exceeds the upper bound, and the lower bound is reached where it is said to.
/// Without an upper bound no dense point exceeds the lower one by more than 1 % or by what a survey
/// leaves open, a hundredth of the tolerance.
void expectFigure(const char* what, const std::optional<Figure>& figure, const DenseValue& dense,
                  const DenseValue& there, double left_open) {
  SCOPED_TRACE(what);
  ASSERT_TRUE(figure);
  if (figure->upper)
    EXPECT_LE(dense.sure(), *figure->upper) << "noise " << dense.noise;
  else
    EXPECT_GE(figure->lower, dense.sure() - std::max(0.01 * dense.value, left_open));
  // At a jump the points beside the parameter may miss the value, but the whole seam reaches it to
  // 1 %.
  const double reached =
      std::max(there.value * (1 + 1e-6) + there.noise, 1.01 * dense.value + dense.noise);
  EXPECT_LE(figure->lower, reached) << "at " << figure->at << " it is " << there.value;
}

/// The level by the same rules, from the dense figures; nothing where one lies within 2 % of its
/// limit.
std::optional<Level> levelOf(const DenseMaxima& dense, const ContinuityTolerance& tolerance) {
  const auto near_limit = [](double value, double limit) {
    return std::abs(value - limit) < 0.02 * limit;
  };
  if (near_limit(dense.gap_mm.value, tolerance.gap_mm)) return std::nullopt;
  if (dense.gap_mm.value > tolerance.gap_mm) return Level::None;
  if (!dense.angle_rad) return Level::G0;
  if (near_limit(dense.angle_rad->value, tolerance.angle_rad)) return std::nullopt;
  if (dense.angle_rad->value > tolerance.angle_rad || dense.fold) return Level::G0;
  if (near_limit(dense.curvature_rel.value, tolerance.curvature_rel)) return std::nullopt;
  return dense.curvature_rel.value > tolerance.curvature_rel ? Level::G1 : Level::G2;
}

/// The class that follows from the figures for the level G1; nothing where a limit is near.
std::optional<SeamClass> classOf(const DenseMaxima& dense, const ContinuityTolerance& tolerance) {
  const auto level = levelOf(dense, tolerance);
  if (!level || !dense.angle_rad ||
      std::abs(dense.angle_rad->value - tolerance.crease_rad) < 0.02 * tolerance.crease_rad)
    return std::nullopt;
  if (*level == Level::None) return SeamClass::Defect;
  if (*level >= Level::G1) return SeamClass::Smooth;
  if (!dense.fold && dense.angle_rad->value < tolerance.crease_rad) return SeamClass::Defect;
  if (dense.below_crease_share > 0.2 && dense.below_crease_share < 0.8) return std::nullopt;
  return dense.below_crease_share > 0.5 ? SeamClass::Defect : SeamClass::Crease;
}

void expectAgrees(const SeamResult& seam, const std::array<DenseSide, 2>& sides,
                  const ContinuityTolerance& tolerance, int points) {
  SCOPED_TRACE(describe(seam));
  const SeamFigures& figures = seam.figures;
  const DenseMaxima dense = denseMaxima(sides, points, tolerance);
  const auto around = [&](const Figure& figure, const auto& value_of) {
    return largestAround(figure.at, [&](double s) {
      return value_of(densePoint(sides, s, tolerance.flat_radius_mm));
    });
  };
  ASSERT_TRUE(figures.gap_mm);
  expectFigure("gap", figures.gap_mm, dense.gap_mm,
               around(*figures.gap_mm, [](const DensePoint& point) { return point.gap_mm; }),
               0.01 * tolerance.gap_mm);
  ASSERT_EQ(figures.angle_rad.has_value(), dense.angle_rad.has_value());
  if (!dense.angle_rad) return;
  expectFigure(
      "angle", figures.angle_rad, *dense.angle_rad,
      around(*figures.angle_rad,
             [](const DensePoint& point) { return point.angle_rad.value_or(DenseValue()); }),
      0.01 * tolerance.angle_rad);
  if (dense.angle_rad->value > 1.01 * tolerance.crease_rad) {
    EXPECT_FALSE(figures.curvature_per_mm);
  } else if (figures.fold_at) {
    EXPECT_TRUE(dense.fold) << "where the faces fold curvature decides nothing";
  } else if (figures.curvature_per_mm) {
    expectFigure("curvature", figures.curvature_per_mm, dense.curvature_per_mm,
                 around(*figures.curvature_per_mm,
                        [](const DensePoint& point) { return point.curvature_per_mm; }),
                 0.01 * tolerance.curvature_rel * dense.norm_per_mm);
    expectFigure(
        "relative curvature", figures.curvature_rel, dense.curvature_rel,
        around(*figures.curvature_rel, [](const DensePoint& point) { return point.curvature_rel; }),
        0.01 * tolerance.curvature_rel);
  } else {
    EXPECT_TRUE(dense.fold || dense.angle_rad->value > 0.99 * tolerance.crease_rad);
  }
  if (!seam.verdict.certain) return;
  const auto level = levelOf(dense, tolerance);
  EXPECT_EQ(name(seam.verdict.level), name(level.value_or(seam.verdict.level)));
  const auto seam_class = classOf(dense, tolerance);
  EXPECT_EQ(name(seam.verdict.seam_class), name(seam_class.value_or(seam.verdict.seam_class)));
}

/// \param uncertified number of seams that may be without certificate.
void compareAllSeams(const occ::Model& model, int points, int uncertified = 0) {
  const occ::Report report = occ::analyze(model);
  ASSERT_FALSE(report.seams.empty());
  int compared = 0;
  for (const SeamResult& seam : report.seams) {
    if (seam.note.find("rebuilt") != std::string::npos)
      continue;  // another path than the stored one
    const auto sides = denseSides(model.shape, seam.edges.at(0), seam.faces);
    if (!sides) continue;
    ++compared;
    expectAgrees(seam, *sides, report.tolerance, points);
  }
  EXPECT_GE(2 * compared, static_cast<int>(report.seams.size()));
  const auto certified = std::ranges::count_if(
      report.seams, [](const SeamResult& seam) { return seam.figures.certified; });
  const auto certain = std::ranges::count_if(
      report.seams, [](const SeamResult& seam) { return seam.verdict.certain; });
  std::printf("%zu seams: %d compared, %td certified, %td with a certain verdict\n",
              report.seams.size(), compared, certified, certain);
  EXPECT_GE(certified, static_cast<std::ptrdiff_t>(report.seams.size()) - uncertified);
}

struct File {
  const char* name;
  const char* path;
  int points;
  int uncertified = 0;  ///< seams that can't be certified: fillets whose contact line has cusps
};

void PrintTo(const File& file, std::ostream* out) {
  *out << file.path;
}

class DenseFiles : public ::testing::TestWithParam<File> {};

TEST_P(DenseFiles, EveryFigureAndLevel) {
  compareAllSeams(occ::readModel(occtModel(GetParam().path)), GetParam().points,
                  GetParam().uncertified);
}

INSTANTIATE_TEST_SUITE_P(Occt, DenseFiles,
                         ::testing::Values(File{"linkrods", "step/linkrods.step", 2001},
                                           File{"screw", "step/screw.step", 20001},
                                           File{"hammer", "occ/hammer.brep", 2001},
                                           File{"bottle", "occ/bottle.brep", 2001},
                                           File{"shell1", "occ/shell1.brep", 2001},
                                           File{"Bottom", "occ/Bottom.brep", 2001},
                                           File{"Top", "occ/Top.brep", 2001, 2},
                                           File{"Motor_c", "occ/Motor-c.brep", 2001},
                                           File{"Pump_Nut", "occ/Pump_Nut.brep", 2001}),
                         [](const auto& file) { return std::string(file.param.name); });

class DenseNets : public ::testing::TestWithParam<std::string> {};

/// With smooth seams, with small defects and with defects of some tolerances.
TEST_P(DenseNets, EveryFigureAndLevel) {
  for (const double noise_mm : {0.0, 0.001, 0.02}) {
    SCOPED_TRACE(noise_mm);
    compareAllSeams(occ::modelFromShape(brokenModel({GetParam(), noise_mm, testSeed()})), 501);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, DenseNets,
                         ::testing::Values("sheet", "blob 6", "mixed sheet", "trimmed bricks",
                                           "trimmed triangles", "refitted quads"),
                         [](const auto& kind) {
                           std::string name = kind.param;
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

TEST(DenseOracle, KnowsClosedForms) {
  const auto measured = [](const TopoDS_Shape& shape) {
    const SeamResult seam = analyzed(shape).seams.at(0);
    return denseMaxima(denseSides(shape, seam.edges[0], seam.faces).value(), 501, {});
  };
  const DenseMaxima tangent = measured(planeAndCylinder(4, 9));
  EXPECT_NEAR(tangent.curvature_per_mm.value, 0.25, 1e-12);
  EXPECT_EQ(tangent.curvature_rel.value, 1);
  EXPECT_FALSE(tangent.fold);
  EXPECT_TRUE(measured(foldedPlanes()).fold);
  const DenseMaxima crossed = measured(crossedCylinders(10));
  EXPECT_NEAR(crossed.curvature_per_mm.value, 0.1, 1e-7);
  EXPECT_NEAR(crossed.angle_rad->value, 6e-4 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(measured(sphereAndTorus(10, 9.999)).curvature_per_mm.value, 1 / 9.999 - 0.1, 1e-12);
}

TEST(DenseOracle, AgreesOnARoundedBox) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(20, 30, 40).Shape();
  BRepFilletAPI_MakeFillet rounded(box);
  for (TopExp_Explorer it(box, TopAbs_EDGE); it.More(); it.Next())
    rounded.Add(2, TopoDS::Edge(it.Current()));
  compareAllSeams(occ::modelFromShape(rounded.Shape()), 2001);
}

}  // namespace
}  // namespace seamwright::test
