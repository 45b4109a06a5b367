// SPDX-License-Identifier: LGPL-2.1-or-later
// Models written and read back: the same numbers and verdicts, and changed geometry in place.
#include <gmock/gmock.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <bit>
#include <cmath>
#include <iomanip>
#include <limits>
#include <random>
#include <regex>

#include <seamwright/occ_adapter/model/real_text.hpp>

#include "files.hpp"
#include "repair_trials.hpp"
#include "shapes.hpp"
#include "support/random.hpp"
#include "written.hpp"

namespace seamwright::test {
namespace {

namespace fs = std::filesystem;
using occ::Model;
using occ::readModel;
using occ::writeModel;
using occ::WriteReport;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Length, level and class of the seams, whatever their numbers: what a shape from memory is
/// written with.
std::vector<std::tuple<long, Level, SeamClass>> seamsInAnyOrder(const Model& model) {
  std::vector<std::tuple<long, Level, SeamClass>> seams;
  for (const occ::SeamResult& seam : occ::analyze(model).seams)
    seams.emplace_back(std::lround(seam.length_mm * 1e6), seam.verdict.level,
                       seam.verdict.seam_class);
  std::sort(seams.begin(), seams.end());
  return seams;
}

// ---- The same numbers

/// A wavy face whose poles have every bit set at random.
TopoDS_Shape wavyFace(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> wave(-0.1, 0.1);
  TColgp_Array2OfPnt poles(1, 6, 1, 5);
  for (int i = 1; i <= 6; ++i)
    for (int k = 1; k <= 5; ++k)
      poles(i, k) =
          gp_Pnt(size * (i + wave(random)), size * (k + wave(random)), size * wave(random));
  TColStd_Array1OfReal u(1, 4), v(1, 2);
  u(1) = 0, u(2) = 1.0 / 3, u(3) = 0.7, u(4) = 1;
  v(1) = 0, v(2) = 1;
  TColStd_Array1OfInteger mu(1, 4), mv(1, 2);
  mu(1) = mu(4) = 4, mu(2) = mu(3) = 1, mv(1) = mv(2) = 5;
  return BRepBuilderAPI_MakeFace(new Geom_BSplineSurface(poles, u, v, mu, mv, 3, 4), 1e-7).Shape();
}

TEST(Write, PolesComeBackToTheBit) {
  const Folder folder;
  std::mt19937 random(testSeed());
  for (const double size : {1e-2, 37.0}) {
    const TopoDS_Shape face = wavyFace(random, size);
    const std::vector<double> numbers = numbersOf(splineOf(face, 1));
    for (const char* name : {"a.step", "a.brep", "a.bin", "a.igs"}) {
      const Model back = written(occ::modelFromShape(face), folder / name, {.overwrite = true});
      EXPECT_EQ(numbersOf(splineOf(back.shape, 1)), numbers) << name << ' ' << size;
    }
  }
}

/// The test above can fail: OpenCASCADE's own writer rounds.
TEST(Write, OpenCascadeItselfRounds) {
  const Folder folder;
  std::mt19937 random(testSeed());
  const TopoDS_Shape face = wavyFace(random, 37);
  writeStep(face, folder / "a.step");
  EXPECT_NE(numbersOf(splineOf(readModel(folder / "a.step").shape, 1)),
            numbersOf(splineOf(face, 1)));
}

TEST(Write, RealsAreSpelledInTheFewestDigits) {
  for (const auto& [old, now] : std::vector<std::pair<std::string, std::string>>{
           {"(1.0000000000000000E+00)", "(1.)"},
           {"(-1.0000000000000001E-01)", "(-0.1)"},
           {"(0.000000000000000E+00,-0.000000000000000E+00)", "(0.,-0.)"},
           {"(1.0000000000000000E+30)", "(1.E+30)"},
           {"#12=A1('1.0000000000000000E+00 it''s 2.5000000000000000E+00',#3,4);",
            "#12=A1('1.0000000000000000E+00 it''s 2.5000000000000000E+00',#3,4);"},
           {"(3,12.5,.E1.,E2.)", "(3,12.5,.E1.,E2.)"},
           {"(1,\n    2,'a\n  b');\n", "(1,2,'a\n  b');\n"}})
    EXPECT_EQ(occ::withShortestReals(old), now);
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 20000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    std::ostringstream text;
    text << '(' << std::scientific << std::uppercase << std::setprecision(16) << value << ')';
    const std::string spelled = occ::withShortestReals(text.str());
    EXPECT_EQ(std::strtod(spelled.c_str() + 1, nullptr), value) << spelled;
    EXPECT_LE(spelled.size(), text.str().size() + 1);
    EXPECT_THAT(spelled, HasSubstr("."));
  }
}

TEST(Write, AnUnchangedFileKeepsEveryNumberInItsGenerations) {
  const Folder folder;
  std::mt19937 random(testSeed());
  for (const char* unit : {"MM", "M", "INCH", "FT"}) {
    writeStep(wavyFace(random, 20), folder / "0.step", unit);
    const Model first = readModel(folder / "0.step");
    const WriteReport report = writeModel(first, folder / "1.step", {.overwrite = true});
    EXPECT_TRUE(report.followed_source);
    EXPECT_EQ(report.changed_faces + report.changed_edges + report.changed_vertices, 0);
    const Model second = readModel(folder / "1.step");
    const std::vector<double> a = numbersOf(splineOf(first.shape, 1)),
                              b = numbersOf(splineOf(second.shape, 1));
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
      if (std::string(unit) == "MM")
        EXPECT_EQ(a[i], b[i]) << i;
      else
        EXPECT_NEAR(a[i], b[i], 2 * std::nextafter(std::abs(a[i]), 1e300) - 2 * std::abs(a[i]))
            << unit << ' ' << i;
    expectSameModel(first, second, 1e-9);
  }
  writeStep(box(), folder / "mm.step", "MM");
}

TEST(Write, SchemaIsKept) {
  const Folder folder;
  writeStep(box(), folder / "a.step");
  const std::string text = contentOf(folder / "a.step");
  const std::regex schema(R"(FILE_SCHEMA[^;]*;)");
  for (const auto& [old, kept] : std::vector<std::pair<std::string, std::string>>{
           {"CONFIG_CONTROL_DESIGN", "CONFIG_CONTROL_DESIGN"},
           {"AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }", "AUTOMOTIVE_DESIGN"},
           {"AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }",
            "AP242_MANAGED"},
           {"AP203_CONFIGURATION_CONTROLLED_3D_DESIGN_OF_MECHANICAL_PARTS_AND_ASSEMBLIES_MIM_LF",
            "AUTOMOTIVE"}}) {
    setContent(folder / "b.step",
               std::regex_replace(text, schema, "FILE_SCHEMA(('" + old + "'));"));
    const WriteReport report =
        writeModel(readModel(folder / "b.step"), folder / "c.step", {.overwrite = true});
    EXPECT_THAT(contentOf(folder / "c.step"), HasSubstr("FILE_SCHEMA(('" + kept)) << old;
    EXPECT_EQ(report.notes.empty(), kept != "AUTOMOTIVE") << old;
  }
}

/// In the file's unit; NaN if it states none.
double statedAccuracy(const fs::path& path) {
  const std::string text = contentOf(path);
  const std::regex pattern(R"(UNCERTAINTY_MEASURE_WITH_UNIT\(LENGTH_MEASURE\(([^)]*)\))");
  std::smatch accuracy;
  return std::regex_search(text, accuracy, pattern) ? std::stod(accuracy[1])
                                                    : std::numeric_limits<double>::quiet_NaN();
}

TEST(Write, HeaderTextsAndAccuracyAreKept) {
  const Folder folder;
  for (const char* unit : {"MM", "INCH"}) {
    writeStep(box(), folder / "a.step", unit);
    std::string text = replaced(contentOf(folder / "a.step"), "'Author'", "'Ada L''Isle'");
    text = std::regex_replace(
        text, std::regex(R"((UNCERTAINTY_MEASURE_WITH_UNIT\()LENGTH_MEASURE\([^)]*\),)"),
        "$1LENGTH_MEASURE(0.0025),");
    setContent(folder / "b.step", text);
    writeModel(readModel(folder / "b.step"), folder / "c.step", {.overwrite = true});
    const std::string kept = contentOf(folder / "c.step");
    EXPECT_THAT(kept, HasSubstr("'Ada L''Isle'"));
    EXPECT_NEAR(statedAccuracy(folder / "c.step"), 0.0025, 1e-12) << unit;
  }
  writeStep(box(), folder / "mm.step", "MM");
}

// ---- Changed geometry

TEST(Write, MovedPolesAreWrittenAndTheRestStays) {
  const Folder folder;
  writeStep(splineBox(), folder / "box.step");
  const Model model = readModel(folder / "box.step");
  std::mt19937 random(testSeed());
  std::uniform_int_distribution<int> face(1, 6);
  for (int round = 0; round < 6; ++round) {
    Model changed = model;
    changed.shape = copied(model.shape);
    const int moved = face(random);
    bend(changed.shape, moved);
    const WriteReport report = writeModel(changed, folder / "out.step", {.overwrite = true});
    EXPECT_TRUE(report.followed_source);
    EXPECT_EQ(report.changed_faces, 1);
    const Model back = readModel(folder / "out.step");
    for (int i = 1; i <= 6; ++i) {
      EXPECT_EQ(numbersOf(splineOf(back.shape, i)), numbersOf(splineOf(changed.shape, i))) << i;
      EXPECT_EQ(numbersOf(splineOf(back.shape, i)) == numbersOf(splineOf(model.shape, i)),
                i != moved)
          << i;
    }
    expectSameModel(changed, back, 1e-6);
  }
}

TEST(Write, AChangeOfTheLastBitIsAChange) {
  const Folder folder;
  writeStep(splineBox(), folder / "box.step");
  Model changed = readModel(folder / "box.step");
  changed.shape = copied(changed.shape);
  const Spline spline = splineOf(changed.shape, 4);
  const gp_Pnt pole = spline->Pole(1, 1);
  spline->SetPole(1, 1, gp_Pnt(std::nextafter(pole.X(), 1e9), pole.Y(), pole.Z()));
  EXPECT_EQ(writeModel(changed, folder / "out.step").changed_faces, 1);
}

TEST(Write, ACopyIsNoChange) {
  const Folder folder;
  for (const TopoDS_Shape& shape : {splineBox(), roundedBox()}) {
    writeStep(shape, folder / "box.step");
    Model same = readModel(folder / "box.step");
    same.shape = copied(same.shape);
    const WriteReport report = writeModel(same, folder / "out.step", {.overwrite = true});
    EXPECT_EQ(report.changed_faces, 0);
    EXPECT_EQ(report.changed_edges, 0);
    EXPECT_EQ(report.changed_vertices, 0);
  }
}

TEST(Write, MovedPointsAndTolerancesAreWritten) {
  const Folder folder;
  writeBrep(splineBox(), folder / "unused.brep");
  writeStep(splineBox(), folder / "box.step");
  Model changed = readModel(folder / "box.step");
  changed.shape = copied(changed.shape);
  BRep_Builder builder;
  builder.UpdateVertex(TopoDS::Vertex(partsOf(changed.shape, TopAbs_VERTEX)(1)),
                       gp_Pnt(0.001, 0.002, 29.997), 0.01);
  builder.UpdateEdge(TopoDS::Edge(partsOf(changed.shape, TopAbs_EDGE)(1)), 0.005);
  const WriteReport report = writeModel(changed, folder / "out.step");
  EXPECT_EQ(report.changed_faces, 0);
  EXPECT_EQ(report.changed_edges, 1);
  EXPECT_EQ(report.changed_vertices, 1);
  const Model back = readModel(folder / "out.step");
  const gp_Pnt point = BRep_Tool::Pnt(TopoDS::Vertex(partsOf(back.shape, TopAbs_VERTEX)(1)));
  EXPECT_EQ(point.Distance(gp_Pnt(0.001, 0.002, 29.997)), 0);
  EXPECT_NEAR(statedAccuracy(folder / "out.step"), 0.01, 1e-15);
}

TEST(Write, ParameterCurvesAreWritten) {
  const Folder folder;
  const Model back = written(occ::modelFromShape(splineBox()), folder / "a.step");
  EXPECT_EQ(occurrences(contentOf(folder / "a.step"), "PCURVE("), 24);
  expectSameSeams(occ::modelFromShape(splineBox()), back, 1e-6);
}

TEST(Write, ASewnModelIsWrittenAfreshWithItsAttributes) {
  const Folder folder;
  TopoDS_Compound loose;
  BRep_Builder().MakeCompound(loose);
  const TopoDS_Shape block = splineBox();
  const TopTools_IndexedMapOfShape faces = partsOf(block, TopAbs_FACE);
  for (int i = 1; i <= 6; ++i) BRep_Builder().Add(loose, copied(faces(i)));
  writeStep(loose, folder / "loose.step", "INCH");
  Model model = readModel(folder / "loose.step");
  EXPECT_EQ(model.edgeCount(), 24);
  BRepBuilderAPI_Sewing sewing(1e-6);
  sewing.Add(model.shape);
  sewing.Perform();
  model.shape = sewing.SewedShape();
  model.attributes = {{TopAbs_FACE, 2, "", std::array{1.0, 0.0, 0.0}, {"skin"}}};
  const WriteReport report = writeModel(model, folder / "sewn.step");
  EXPECT_FALSE(report.followed_source);
  ASSERT_EQ(report.notes.size(), 1u);
  EXPECT_THAT(report.notes[0], HasSubstr("afresh"));
  const Model back = readModel(folder / "sewn.step");
  EXPECT_EQ(back.edgeCount(), 12);
  EXPECT_EQ(back.length_unit, "INCH");
  EXPECT_THAT(attributesOf(back), HasSubstr("4 2 '' 1000000 0 0 on skin"));
  model.attributes[0].index = 7;
  EXPECT_THAT(errorOfWriting(model, folder / "bad.step").what(), HasSubstr("part 7"));
  writeStep(box(), folder / "mm.step", "MM");
}

TEST(Write, LooseFacesThatShareEdgesStillDo) {
  const Folder folder;
  TopoDS_Compound loose;
  BRep_Builder().MakeCompound(loose);
  const TopoDS_Shape block = splineBox();
  const TopTools_IndexedMapOfShape faces = partsOf(block, TopAbs_FACE);
  std::mt19937 random(testSeed());
  for (int i = 1; i <= 6; ++i) BRep_Builder().Add(loose, faces(i));
  BRep_Builder().Add(loose, wavyFace(random, 3));
  gp_Trsf motion = randomMotion(random);
  motion.SetScaleFactor(1);
  Model model = occ::modelFromShape(loose.Located(TopLoc_Location(motion)));
  model.attributes = {{TopAbs_COMPOUND, 1, "skin", std::nullopt, {}},
                      {TopAbs_FACE, 7, "", std::array{1.0, 0.0, 0.0}, {}}};
  for (const char* name : {"a.step", "a.igs"}) {
    const Model back = written(model, folder / name);
    EXPECT_EQ(back.faceCount(), 7) << name;
    EXPECT_EQ(back.edgeCount(), 12 + 4) << name;
    EXPECT_EQ(seamsInAnyOrder(back), seamsInAnyOrder(model)) << name;
    EXPECT_THAT(attributesOf(back), HasSubstr("4 7 '' 1000000 0 0")) << name;
  }
  EXPECT_THAT(attributesOf(readModel(folder / "a.step")), HasSubstr("'skin'"));
}

TEST(Write, NamedSolidsFromMemoryBecomeAnAssembly) {
  const Folder folder;
  TopoDS_Compound pair;
  BRep_Builder().MakeCompound(pair);
  gp_Trsf away;
  away.SetTranslation(gp_Vec(100, 0, 0));
  BRep_Builder().Add(pair, box());
  BRep_Builder().Add(pair, BRepPrimAPI_MakeCylinder(2, 9).Shape().Located(TopLoc_Location(away)));
  Model model = occ::modelFromShape(pair);
  model.attributes = {{TopAbs_SOLID, 1, "block", std::nullopt, {}},
                      {TopAbs_SOLID, 2, "rod", std::array{0.0, 1.0, 0.0}, {"loose"}}};
  const Model back = written(model, folder / "pair.step");
  EXPECT_THAT(attributesOf(back), HasSubstr("2 1 'block'"));
  EXPECT_THAT(attributesOf(back), HasSubstr("2 2 'rod' 0 1000000 0 on loose"));
  expectSameSeams(model, back, 1e-9);
}

TEST(Write, EveryFormatGivesTheSameSeams) {
  const Folder folder;
  const Model model = occ::modelFromShape(roundedBox());
  for (const char* name : {"a.step", "a.STP", "a.igs", "a.iges", "a.brep", "a.brp", "a.bin"}) {
    SCOPED_TRACE(name);
    const Model back = written(model, folder / name);
    EXPECT_EQ(back.format, occ::name(occ::targetFormat(name)));
    EXPECT_EQ(seamsInAnyOrder(back), seamsInAnyOrder(model));
  }
}

/// Written and read without a change.
void expectComesBack(const fs::path& path) {
  const Folder folder;
  const Model model = readModel(path);
  const WriteReport report = writeModel(model, folder / "out.step");
  EXPECT_TRUE(report.followed_source);
  EXPECT_EQ(report.changed_faces + report.changed_edges + report.changed_vertices, 0);
  EXPECT_THAT(report.notes, IsEmpty());
  expectSameModel(model, readModel(folder / "out.step"), 1e-6);
}

TEST(Write, FilesOfOtherProgramsComeBack) {
  for (const char* name : {"step/screw.step", "step/linkrods.step"}) {
    SCOPED_TRACE(name);
    expectComesBack(occtModel(name));
  }
}

TEST(Write, SheetsAndSolidsOfSplinesComeBackInTheirUnit) {
  const Folder folder;
  for (const char* kind : {"sheet", "blob 6", "trimmed bricks", "refitted quads"})
    for (const char* unit : {"MM", "INCH", "M"}) {
      SCOPED_TRACE(testing::Message() << kind << " in " << unit);
      writeStep(brokenModel({kind, 0.01, testSeed()}), folder / "model.step", unit);
      expectComesBack(folder / "model.step");
    }
  writeStep(box(), folder / "model.step", "MM");  // the unit is static
}

}  // namespace
}  // namespace seamwright::test
