// SPDX-License-Identifier: LGPL-2.1-or-later
// The same model turned, moved, scaled, mirrored, located, with its faces in another order: the
// same figures.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <gp_Ax2.hxx>
#include <optional>

#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::SeamResult;

/// A model all of whose seams have these figures, lengths in mm.
struct Known {
  std::string what;
  TopoDS_Shape shape;
  double angle_deg;
  double angle_error_deg;
  std::optional<double> curvature_per_mm;
  std::optional<double> curvature_rel;
  double norm_per_mm;  ///< larger curvature norm of the sides
  Level level;
  SeamClass seam_class;
};

std::vector<Known> knownModels() {
  const auto smooth = SeamClass::Smooth;
  return {
      {"box",
       BRepPrimAPI_MakeBox(3, 4, 5).Shape(),
       90,
       1e-9,
       {},
       {},
       0,
       Level::G0,
       SeamClass::Crease},
      {"torus", BRepPrimAPI_MakeTorus(9, 2).Shape(), 0, 1e-9, 0.0, 0.0, 0.5, Level::G2, smooth},
      {"plane and cylinder", planeAndCylinder(10, 5), 0, 1e-9, 0.1, 1.0, 0.1, Level::G1, smooth},
      // At the ends of the seam the normals are turned by 6e-4 rad each, about axes at right
      // angles.
      {"crossed cylinders", crossedCylinders(10), 6e-4 * std::sqrt(2.0) / degree, 1e-8, 0.1, 1.0,
       0.1, Level::G1, smooth},
      {"spheres 10 and 9.999", sphereAndTorus(10, 9.999), 0, 1e-9, 1 / 9.999 - 0.1,
       9.999 * (1 / 9.999 - 0.1), 0.1, Level::G2, smooth},
      {"fold", foldedPlanes(), 0, 1e-9, {}, {}, 0, Level::G0, SeamClass::Crease},
  };
}

void expectKnown(const Known& known, const TopoDS_Shape& shape, double scale) {
  SCOPED_TRACE(known.what);
  const occ::Report report = analyzed(shape);
  ASSERT_EQ(report.seams.size(), analyzed(known.shape).seams.size());
  for (const SeamResult& seam : report.seams) {
    SCOPED_TRACE(describe(seam));
    const ContinuityTolerance& tolerance = report.tolerance;
    expectEncloses(seam.figures.angle_rad, known.angle_deg * degree, tolerance.angle_rad,
                   known.angle_error_deg * degree);
    ASSERT_EQ(seam.figures.curvature_per_mm.has_value(), known.curvature_per_mm.has_value());
    if (known.curvature_per_mm) {
      expectEncloses(seam.figures.curvature_per_mm, *known.curvature_per_mm / scale,
                     tolerance.curvature_rel * known.norm_per_mm / scale, 1e-8 / scale);
      expectEncloses(seam.figures.curvature_rel, *known.curvature_rel, tolerance.curvature_rel,
                     1e-6);
    }
    expectEncloses(seam.figures.gap_mm, 0, tolerance.gap_mm, 1e-9 * scale);
    EXPECT_TRUE(seam.figures.certified);
    EXPECT_TRUE(seam.verdict.certain);
    EXPECT_EQ(seam.verdict.level, known.level);
    EXPECT_EQ(seam.verdict.seam_class, known.seam_class);
  }
}

gp_Trsf mirror(std::mt19937& random) {
  gp_Trsf trsf;
  trsf.SetMirror(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(1, 2, -0.5)));
  return randomMotion(random) * trsf;
}

gp_Trsf scaling(std::mt19937& random, double factor) {
  gp_Trsf trsf;
  trsf.SetScaleFactor(factor);
  return randomMotion(random) * trsf;
}

TEST(Placement, FiguresAreKnownWhereTheModelWasMade) {
  for (const Known& known : knownModels()) expectKnown(known, known.shape, 1);
}

TEST(Placement, RigidMotionsChangeNoFigure) {
  std::mt19937 random(testSeed());
  for (const Known& known : knownModels())
    for (int trial = 0; trial < 25; ++trial) {
      const gp_Trsf motion = randomMotion(random);
      expectKnown(known, transformed(known.shape, motion), 1);
      expectKnown(known, located(known.shape, motion), 1);
    }
}

TEST(Placement, MirrorsChangeNoFigure) {
  std::mt19937 random(testSeed());
  for (const Known& known : knownModels())
    for (int trial = 0; trial < 10; ++trial) {
      const gp_Trsf motion = mirror(random);
      expectKnown(known, transformed(known.shape, motion), 1);
      expectKnown(known, located(known.shape, motion), 1);
    }
}

TEST(Placement, ScalesChangeCurvatureByTheirInverse) {
  std::mt19937 random(testSeed());
  for (const Known& known : knownModels())
    for (const double factor : {0.2, 3.0, 50.0}) {
      const gp_Trsf motion = scaling(random, factor);
      expectKnown(known, transformed(known.shape, motion), factor);
      expectKnown(known, located(known.shape, motion), factor);
    }
}

TEST(Placement, LocationsOnLocationsChangeNoFigure) {
  std::mt19937 random(testSeed());
  for (const Known& known : knownModels()) {
    TopoDS_Shape shape = known.shape;
    for (int k = 0; k < 4; ++k)
      shape = located(shape, k % 2 ? mirror(random) : randomMotion(random));
    expectKnown(known, shape, 1);
  }
}

TEST(Placement, FacesSwappedAndReversed) {
  std::mt19937 random(testSeed());
  for (const Known& known : knownModels()) {
    expectKnown(known, facesSwappedAndReversed(known.shape), 1);
    expectKnown(known, known.shape.Reversed(), 1);
    expectKnown(known, facesSwappedAndReversed(located(known.shape, mirror(random))), 1);
  }
}

TEST(Placement, CrossedCylindersFailG2AtEveryTurnOfTheScene) {
  occ::AnalyzeOptions options;
  options.level = Level::G2;
  const TopoDS_Shape crossed = crossedCylinders(10);
  for (int turn = 0; turn < 360; turn += 10) {
    gp_Trsf trsf;
    trsf.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 2, 3)), turn * degree);
    const SeamResult seam = analyzed(transformed(crossed, trsf), options).seams.at(0);
    SCOPED_TRACE(describe(seam));
    EXPECT_EQ(seam.verdict.level, Level::G1);
    EXPECT_EQ(seam.verdict.seam_class, SeamClass::Defect);
    expectEncloses(seam.figures.curvature_per_mm, 0.1, options.tolerance.curvature_rel * 0.1, 1e-7);
  }
}

TEST(Placement, NearlyEqualRadiiAreToldApartByATighterTolerance) {
  occ::AnalyzeOptions options;
  options.level = Level::G2;
  options.tolerance.curvature_rel = 0.5e-4;
  const SeamResult apart = analyzed(sphereAndTorus(10, 9.999), options).seams.at(0);
  EXPECT_EQ(apart.verdict.seam_class, SeamClass::Defect) << describe(apart);
  options.tolerance.curvature_rel = 2e-4;
  EXPECT_EQ(analyzed(sphereAndTorus(10, 9.999), options).seams.at(0).verdict.seam_class,
            SeamClass::Smooth);
}

}  // namespace
}  // namespace seamwright::test
