// SPDX-License-Identifier: LGPL-2.1-or-later
// Models written and read back: the same numbers, names, colours, layers and verdicts; changed geometry in place; and a
// target that is the old file or the new one, whatever happens.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <limits>
#include <random>
#include <regex>
#include <thread>

#include <seamwright/occ_adapter/model/real_text.hpp>
#include <seamwright/occ_adapter/model/write.hpp>

#include "files.hpp"
#include "shapes.hpp"

namespace seamwright::test {
namespace {

namespace fs = std::filesystem;
using occ::Model;
using occ::ModelErrc;
using occ::readModel;
using occ::writeModel;
using occ::WriteReport;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Spline = opencascade::handle<Geom_BSplineSurface>;

TopTools_IndexedMapOfShape partsOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return map;
}

/// The surface of a face, without the face's placement: shared with the face.
Spline splineOf(const TopoDS_Shape& shape, int face) {
  TopLoc_Location placement;
  return Spline::DownCast(BRep_Tool::Surface(TopoDS::Face(partsOf(shape, TopAbs_FACE)(face)), placement));
}

/// Poles, weights and knots.
std::vector<double> numbersOf(const Spline& spline) {
  std::vector<double> numbers;
  for (int i = 1; i <= spline->NbUPoles(); ++i)
    for (int k = 1; k <= spline->NbVPoles(); ++k) {
      const gp_Pnt pole = spline->Pole(i, k);
      numbers.insert(numbers.end(), {pole.X(), pole.Y(), pole.Z(), spline->Weight(i, k)});
    }
  for (int i = 1; i <= spline->NbUKnots(); ++i) numbers.push_back(spline->UKnot(i));
  for (int i = 1; i <= spline->NbVKnots(); ++i) numbers.push_back(spline->VKnot(i));
  return numbers;
}

TopoDS_Shape box() {
  return BRepPrimAPI_MakeBox(10, 20, 30).Shape();
}

TopoDS_Shape roundedBox() {
  const TopoDS_Shape block = box();
  BRepFilletAPI_MakeFillet rounding(block);
  const TopTools_IndexedMapOfShape edges = partsOf(block, TopAbs_EDGE);
  for (int i = 1; i <= edges.Extent(); ++i) rounding.Add(2, TopoDS::Edge(edges(i)));
  return rounding.Shape();
}

/// The box with B-spline faces.
TopoDS_Shape splineBox() {
  return BRepBuilderAPI_NurbsConvert(box(), true).Shape();
}

TopoDS_Shape copied(const TopoDS_Shape& shape) {
  return BRepBuilderAPI_Copy(shape, true).Shape();
}

Model written(const Model& model, const fs::path& path, const occ::WriteOptions& options = {}) {
  writeModel(model, path, options);
  return readModel(path);
}

occ::ModelError errorOfWriting(const Model& model, const fs::path& path,
                               const occ::WriteOptions& options = {}) {
  try {
    writeModel(model, path, options);
  } catch (const occ::ModelError& error) {
    EXPECT_THAT(error.what(), HasSubstr(path.string()));
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error;
  }
  throw std::runtime_error(path.string() + " was written");
}

std::string attributesOf(const Model& model) {
  std::ostringstream text;
  for (const occ::ShapeAttribute& a : model.attributes) {
    text << a.kind << ' ' << a.index << " '" << a.name << "'";
    if (a.color)
      for (const double share : *a.color) text << ' ' << std::lround(share * 1e6);
    for (const std::string& layer : a.layers) text << " on " << layer;
    text << '\n';
  }
  return text.str();
}

int occurrences(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Level, class and figures of every seam; figures within \p noise of their size.
void expectSameSeams(const Model& a, const Model& b, double noise) {
  const occ::Report one = occ::analyze(a), other = occ::analyze(b);
  ASSERT_EQ(one.seams.size(), other.seams.size());
  for (std::size_t i = 0; i < one.seams.size(); ++i) {
    const occ::SeamResult &x = one.seams[i], &y = other.seams[i];
    SCOPED_TRACE(describe(x) + " / " + describe(y));
    EXPECT_EQ(x.verdict.level, y.verdict.level);
    EXPECT_EQ(x.verdict.seam_class, y.verdict.seam_class);
    EXPECT_NEAR(x.length_mm, y.length_mm, noise * (1 + x.length_mm));
  }
}

void expectSameModel(const Model& a, const Model& b, double noise = 1e-6) {
  for (const TopAbs_ShapeEnum kind : {TopAbs_SOLID, TopAbs_SHELL, TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX})
    EXPECT_EQ(partsOf(a.shape, kind).Extent(), partsOf(b.shape, kind).Extent()) << kind;
  EXPECT_EQ(attributesOf(a), attributesOf(b));
  EXPECT_EQ(a.length_unit, b.length_unit);
  expectSameSeams(a, b, noise);
}

/// Length, level and class of the seams, whatever their numbers: what a shape from memory is written with.
std::vector<std::tuple<long, Level, SeamClass>> seamsInAnyOrder(const Model& model) {
  std::vector<std::tuple<long, Level, SeamClass>> seams;
  for (const occ::SeamResult& seam : occ::analyze(model).seams)
    seams.emplace_back(std::lround(seam.length_mm * 1e6), seam.verdict.level, seam.verdict.seam_class);
  std::sort(seams.begin(), seams.end());
  return seams;
}

// ---- The same numbers -------------------------------------------------------------------------------------------

/// A wavy face whose poles have every bit set at random.
TopoDS_Shape wavyFace(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> wave(-0.1, 0.1);
  TColgp_Array2OfPnt poles(1, 6, 1, 5);
  for (int i = 1; i <= 6; ++i)
    for (int k = 1; k <= 5; ++k)
      poles(i, k) = gp_Pnt(size * (i + wave(random)), size * (k + wave(random)), size * wave(random));
  TColStd_Array1OfReal u(1, 4), v(1, 2);
  u(1) = 0, u(2) = 1.0 / 3, u(3) = 0.7, u(4) = 1;
  v(1) = 0, v(2) = 1;
  TColStd_Array1OfInteger mu(1, 4), mv(1, 2);
  mu(1) = mu(4) = 4, mu(2) = mu(3) = 1, mv(1) = mv(2) = 5;
  return BRepBuilderAPI_MakeFace(new Geom_BSplineSurface(poles, u, v, mu, mv, 3, 4), 1e-7).Shape();
}

TEST(Write, PolesComeBackToTheBit) {
  const Folder folder;
  std::mt19937 random(1);
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
  std::mt19937 random(1);
  const TopoDS_Shape face = wavyFace(random, 37);
  writeStep(face, folder / "a.step");
  EXPECT_NE(numbersOf(splineOf(readModel(folder / "a.step").shape, 1)), numbersOf(splineOf(face, 1)));
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
  std::mt19937_64 random(7);
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
  std::mt19937 random(2);
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
           {"AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }", "AP242_MANAGED"},
           {"AP203_CONFIGURATION_CONTROLLED_3D_DESIGN_OF_MECHANICAL_PARTS_AND_ASSEMBLIES_MIM_LF",
            "AUTOMOTIVE"}}) {
    setContent(folder / "b.step", std::regex_replace(text, schema, "FILE_SCHEMA(('" + old + "'));"));
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
    text =
        std::regex_replace(text, std::regex(R"((UNCERTAINTY_MEASURE_WITH_UNIT\()LENGTH_MEASURE\([^)]*\),)"),
                           "$1LENGTH_MEASURE(0.0025),");
    setContent(folder / "b.step", text);
    writeModel(readModel(folder / "b.step"), folder / "c.step", {.overwrite = true});
    const std::string kept = contentOf(folder / "c.step");
    EXPECT_THAT(kept, HasSubstr("'Ada L''Isle'"));
    EXPECT_NEAR(statedAccuracy(folder / "c.step"), 0.0025, 1e-12) << unit;
  }
  writeStep(box(), folder / "mm.step", "MM");
}

// ---- Names, colours, layers, instances ----------------------------------------------------------------------------

/// Two blocks of one part and a rod, with names, colours and layers, in an assembly.
void writeAssembly(const fs::path& path) {
  const opencascade::handle<TDocStd_Document> document = new TDocStd_Document("BinXCAF");
  const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const auto colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
  const auto layers = XCAFDoc_DocumentTool::LayerTool(document->Main());
  const TopoDS_Shape block = splineBox(), rod = BRepPrimAPI_MakeCylinder(2, 9).Shape();
  const TDF_Label part = shapes->AddShape(block, false), other = shapes->AddShape(rod, false);
  TDataStd_Name::Set(part, TCollection_ExtendedString("Bl\u00f6ck", true));
  TDataStd_Name::Set(other, "rod");
  colors->SetColor(part, Quantity_Color(0.25, 0.5, 0.75, Quantity_TOC_RGB), XCAFDoc_ColorSurf);
  const TDF_Label lid = shapes->AddSubShape(part, partsOf(block, TopAbs_FACE)(3));
  colors->SetColor(lid, Quantity_Color(1, 0, 0, Quantity_TOC_RGB), XCAFDoc_ColorSurf);
  layers->SetLayer(part, "Karosserie");
  layers->SetLayer(lid, "Deckel");
  const TDF_Label assembly = shapes->NewShape();
  TDataStd_Name::Set(assembly, "whole");
  for (const double x : {0.0, 50.0}) {
    gp_Trsf away, turn;
    away.SetTranslation(gp_Vec(x, 0, 7));
    turn.SetRotation(gp_Ax1(gp_Pnt(), gp_Dir(1, 2, 3)), 0.3 + x);
    shapes->AddComponent(assembly, part, TopLoc_Location(away * turn));
  }
  shapes->AddComponent(assembly, other, TopLoc_Location());
  shapes->UpdateAssemblies();
  STEPCAFControl_Writer writer;
  writer.SetNameMode(true);
  writer.SetColorMode(true);
  writer.SetLayerMode(true);
  if (!writer.Transfer(document, STEPControl_AsIs) || writer.Write(path.c_str()) != IFSelect_RetDone)
    throw std::runtime_error("not written");
}

class Assembly : public ::testing::Test {
 protected:
  Assembly() {
    writeAssembly(folder_ / "whole.step");
    model_ = readModel(folder_ / "whole.step");
  }

  void expectStructure(const fs::path& path) const {
    const std::string old = contentOf(folder_ / "whole.step"), now = contentOf(path);
    for (const char* entity : {"NEXT_ASSEMBLY_USAGE_OCCURRENCE(", "= PRODUCT(", "MANIFOLD_SOLID_BREP(",
                               "ADVANCED_FACE(", "PRESENTATION_LAYER_ASSIGNMENT("})
      EXPECT_EQ(occurrences(now, entity), occurrences(old, entity)) << entity;
  }

  const Folder folder_;
  Model model_;
};

TEST_F(Assembly, LayersAreRead) {
  const std::string attributes = attributesOf(model_);
  EXPECT_THAT(attributes, HasSubstr("on Karosserie"));
  EXPECT_THAT(attributes, HasSubstr("on Deckel"));
  EXPECT_THAT(attributes, HasSubstr("Bl\u00f6ck"));
}

TEST_F(Assembly, ComesBackAsItWas) {
  const Model back = written(model_, folder_ / "back.step");
  expectSameModel(model_, back, 1e-9);
  expectStructure(folder_ / "back.step");
  expectSameModel(model_, written(back, folder_ / "again.step"), 1e-9);
}

/// Lifts the middle of the first spline face of a solid.
void bend(const TopoDS_Shape& shape, int face) {
  const Spline spline = splineOf(shape, face);
  spline->IncreaseDegree(3, 3);
  spline->SetPole(2, 2, spline->Pole(2, 2).Translated(gp_Vec(0.125, 0.25, 0.5)));
}

TEST_F(Assembly, APartChangedInAllItsPlacesStaysOnePart) {
  Model changed = model_;
  changed.shape = copied(model_.shape);
  ASSERT_EQ(partsOf(changed.shape, TopAbs_FACE).Extent(), 6 + 6 + 3);
  bend(changed.shape, 2);
  bend(changed.shape, 8);
  const std::vector<double> numbers = numbersOf(splineOf(changed.shape, 2));
  const WriteReport report = writeModel(changed, folder_ / "bent.step");
  EXPECT_TRUE(report.followed_source);
  EXPECT_EQ(report.changed_faces, 1);
  EXPECT_EQ(report.changed_edges, 0) << "the faces' edges lie where they lay";
  EXPECT_EQ(report.changed_vertices, 0);
  const Model back = readModel(folder_ / "bent.step");
  expectStructure(folder_ / "bent.step");
  expectSameModel(changed, back, 1e-6);
  for (const int face : {2, 8}) EXPECT_EQ(numbersOf(splineOf(back.shape, face)), numbers) << face;
}

TEST_F(Assembly, APlaceChangedAloneIsAnErrorWithItsFaces) {
  TopoDS_Compound compound;
  BRep_Builder().MakeCompound(compound);
  const TopTools_IndexedMapOfShape solids = partsOf(model_.shape, TopAbs_SOLID);
  ASSERT_EQ(solids.Extent(), 3);
  // The shape of the file is a compound of its parts in their places.
  ASSERT_EQ(model_.shape.ShapeType(), TopAbs_COMPOUND);
  for (int i = 1; i <= 3; ++i) {
    TopoDS_Shape solid = solids(i);
    if (i == 2) {
      solid = copied(solid.Located(TopLoc_Location())).Located(solid.Location());
      bend(solid, 2);
    }
    BRep_Builder().Add(compound, solid);
  }
  Model changed = model_;
  changed.shape = compound.Oriented(model_.shape.Orientation());
  const occ::ModelError error = errorOfWriting(changed, folder_ / "odd.step");
  EXPECT_EQ(error.code(), ModelErrc::UnlikeInstances);
  EXPECT_THAT(error.what(), HasSubstr("faces 2 and 8"));
  EXPECT_FALSE(fs::exists(folder_ / "odd.step"));
  const WriteReport report = writeModel(changed, folder_ / "odd.step", {.afresh = true});
  EXPECT_FALSE(report.followed_source);
  const Model back = readModel(folder_ / "odd.step");
  expectSameSeams(changed, back, 1e-6);
  EXPECT_THAT(attributesOf(back), HasSubstr("Bl\u00f6ck"));
  EXPECT_THAT(attributesOf(back), HasSubstr("on Deckel"));
}

TEST_F(Assembly, APlaceCopiedButAlikeIsNoChange) {
  Model same = model_;
  same.shape = copied(model_.shape);
  const WriteReport report = writeModel(same, folder_ / "same.step");
  EXPECT_TRUE(report.followed_source);
  EXPECT_EQ(report.changed_faces + report.changed_edges + report.changed_vertices, 0);
  expectStructure(folder_ / "same.step");
}

// ---- Changed geometry ---------------------------------------------------------------------------------------------

TEST(Write, MovedPolesAreWrittenAndTheRestStays) {
  const Folder folder;
  writeStep(splineBox(), folder / "box.step");
  const Model model = readModel(folder / "box.step");
  std::mt19937 random(3);
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
      EXPECT_EQ(numbersOf(splineOf(back.shape, i)) == numbersOf(splineOf(model.shape, i)), i != moved) << i;
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
  builder.UpdateVertex(TopoDS::Vertex(partsOf(changed.shape, TopAbs_VERTEX)(1)), gp_Pnt(0.001, 0.002, 29.997),
                       0.01);
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
  std::mt19937 random(8);
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

TEST(Write, RealFilesComeBack) {
  for (const char* name :
       {"small/NIST_MBE_PMI_11.stp", "small/nozzle.stp", "small/screw.step", "small/cube-units_cube-in.step",
        "small/cube-units_cube-m.step", "small/rounded-cube_rounded-cube.step",
        "freeform/Silk_Demo_02_sewn.step", "freeform/s60.step"}) {
    const fs::path path = furtherModel(name);
    if (path.empty()) GTEST_SKIP() << name << " is not there";
    SCOPED_TRACE(name);
    const Folder folder;
    const Model model = readModel(path);
    const WriteReport report = writeModel(model, folder / "out.step");
    EXPECT_TRUE(report.followed_source);
    EXPECT_EQ(report.changed_faces + report.changed_edges + report.changed_vertices, 0);
    EXPECT_THAT(report.notes, IsEmpty());
    expectSameModel(model, readModel(folder / "out.step"), 1e-6);
  }
}

// ---- Refusals -----------------------------------------------------------------------------------------------------

int entriesOf(const fs::path& folder) {
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

class Refusal : public ::testing::Test {
 protected:
  Refusal() {
    writeStep(box(), folder_ / "box.step");
    model_ = readModel(folder_ / "box.step");
    source_ = contentOf(folder_ / "box.step");
    setContent(folder_ / "old.step", "old");
  }
  /// Nothing but the two files, as they were.
  void expectUntouched() const {
    EXPECT_EQ(entriesOf(folder_ / ""), 2);
    EXPECT_EQ(contentOf(folder_ / "box.step"), source_);
    EXPECT_EQ(contentOf(folder_ / "old.step"), "old");
  }

  std::string script(const fs::path& path, const std::string& commands) {
    setContent(path, "#!/bin/sh\n" + commands + "\n");
    chmod(path.c_str(), 0755);
    return path.string();
  }

  const Folder folder_;
  Model model_;
  std::string source_;
};

TEST_F(Refusal, UnknownExtension) {
  for (const char* name : {"a.stl", "a", "a.step.bak", ".step", "a."})
    EXPECT_EQ(errorOfWriting(model_, folder_ / name).code(), ModelErrc::UnknownTarget) << name;
  expectUntouched();
}

TEST_F(Refusal, FilesThatAreThere) {
  EXPECT_EQ(errorOfWriting(model_, folder_ / "old.step").code(), ModelErrc::TargetExists);
  EXPECT_EQ(errorOfWriting(model_, folder_ / "box.step").code(), ModelErrc::TargetExists);
  EXPECT_EQ(errorOfWriting(model_, folder_ / "box.step", {.overwrite = true}).code(), ModelErrc::TargetExists)
      << "the source needs a word of its own";
  fs::create_symlink("box.step", folder_ / "link.step");
  EXPECT_EQ(errorOfWriting(model_, folder_ / "link.step", {.overwrite = true}).code(),
            ModelErrc::TargetExists);
  fs::remove(folder_ / "link.step");
  fs::create_hard_link(folder_ / "box.step", folder_ / "hard.step");
  EXPECT_EQ(errorOfWriting(model_, folder_ / "hard.step", {.overwrite = true}).code(),
            ModelErrc::TargetExists);
  fs::remove(folder_ / "hard.step");
  expectUntouched();
}

TEST_F(Refusal, AllowedOverwrites) {
  chmod((folder_ / "old.step").c_str(), 0640);
  fs::create_symlink("old.step", folder_ / "link.step");
  writeModel(model_, folder_ / "link.step", {.overwrite = true});
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.step"));
  EXPECT_EQ(readModel(folder_ / "old.step").faceCount(), 6);
  EXPECT_EQ(static_cast<unsigned>(fs::status(folder_ / "old.step").permissions()), 0640u);
  writeModel(model_, folder_ / "box.step", {.overwrite_source = true});
  EXPECT_EQ(readModel(folder_ / "box.step").faceCount(), 6);
  EXPECT_NE(contentOf(folder_ / "box.step"), source_);
  EXPECT_EQ(entriesOf(folder_ / ""), 3);
}

TEST_F(Refusal, FoldersThatCantBeWrittenTo) {
  EXPECT_EQ(errorOfWriting(model_, folder_ / "none/a.step").code(), ModelErrc::NotWritable);
  fs::create_directory(folder_ / "dir.step");
  EXPECT_EQ(errorOfWriting(model_, folder_ / "dir.step", {.overwrite = true}).code(), ModelErrc::NotAFile);
  fs::remove(folder_ / "dir.step");
  expectUntouched();
  if (geteuid() == 0) GTEST_SKIP() << "nothing is closed to the superuser";
  fs::permissions(folder_ / "", fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_EQ(errorOfWriting(model_, folder_ / "a.step").code(), ModelErrc::NotWritable);
  fs::permissions(folder_ / "", fs::perms::owner_all);
  expectUntouched();
}

TEST_F(Refusal, ASourceThatIsGone) {
  Model gone = model_;
  gone.path = (folder_ / "gone.step").string();
  const occ::ModelError error = errorOfWriting(gone, folder_ / "a.step");
  EXPECT_THAT(error.what(), HasSubstr("gone.step"));
  expectUntouched();
  EXPECT_EQ(written(gone, folder_ / "a.step", {.afresh = true}).faceCount(), 6);
}

/// A file that may not grow any more stands for a full disk: write() fails half-way.
TEST_F(Refusal, NoRoom) {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  for (const char* name : {"a.brep", "old.step"}) {
    const rlimit little{1000, before.rlim_max};
    const Model bare = occ::modelFromShape(box());
    setrlimit(RLIMIT_FSIZE, &little);
    const occ::ModelError error = errorOfWriting(bare, folder_ / name, {.overwrite = true});
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_TRUE(error.code() == ModelErrc::NotWritable || error.code() == ModelErrc::NotWritten)
        << error.what();
    expectUntouched();
  }
  ::signal(SIGXFSZ, handler);
}

TEST_F(Refusal, TheWritingProcessFails) {
  const fs::path program = folder_ / "writer";
  for (const char* commands :
       {"exit 0", "exit 3", "kill -SEGV $$", "kill -XCPU $$", "cat > /dev/null; kill -KILL $$",
        R"(printf 'B\377\377\0\0\0\0\0\0half' >&3)", R"(printf 'S\001\0\0\0\0\0\0\0x' >&3)",
        R"(printf 'R\002\0\0\0\0\0\0\0{}' >&3)", R"(printf 'garbage' >&3)"}) {
    SCOPED_TRACE(commands);
    const Environment reader("SEAMWRIGHT_READER", script(program, commands));
    const occ::ModelError error = errorOfWriting(model_, folder_ / "old.step", {.overwrite = true});
    EXPECT_EQ(error.code(), ModelErrc::ReaderDied);
    EXPECT_THAT(error.what(), HasSubstr("can't be written"));
    fs::remove(program);
    expectUntouched();
  }
}

TEST_F(Refusal, CancelledAtEveryMoment) {
  int calls = 0;
  writeModel(model_, folder_ / "a.step", {}, [&](double share) {
    EXPECT_GE(share, 0);
    EXPECT_LE(share, 1);
    ++calls;
    return true;
  });
  fs::remove(folder_ / "a.step");
  ASSERT_GE(calls, 2);
  for (int stop = 1; stop <= calls; ++stop) {
    int call = 0;
    bool stopped = false;
    try {
      writeModel(model_, folder_ / "old.step", {.overwrite = true}, [&](double) {
        stopped = ++call == stop;
        return !stopped;
      });
    } catch (const occ::Cancelled&) {
      EXPECT_TRUE(stopped);
    }
    if (!stopped) break;  // it was done sooner this time
    expectUntouched();
  }
}

/// Kills a writing process at random moments, thirty times over two contents: the file is always one of the two, whole.
TEST_F(Refusal, KilledAtAnyMoment) {
  const Model one = occ::modelFromShape(box()), other = occ::modelFromShape(roundedBox());
  const fs::path target = folder_ / "target.brep";
  std::string contents[2];
  for (const int i : {0, 1}) {
    writeModel(i == 0 ? one : other, target, {.overwrite = true});
    contents[i] = contentOf(target);
  }
  std::mt19937 random(4);
  std::uniform_int_distribution<int> microseconds(0, 15000);
  int seen[2] = {0, 0};
  for (int round = 0; round < 60; ++round) {
    const pid_t writer = fork();
    if (writer == 0) {
      for (int i = round;; ++i) writeModel(i % 2 == 0 ? one : other, target, {.overwrite = true});
    }
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
    kill(writer, SIGKILL);
    waitpid(writer, nullptr, 0);
    const std::string found = contentOf(target);
    ASSERT_TRUE(found == contents[0] || found == contents[1]) << round << ": " << found.size() << " bytes";
    ++seen[found == contents[1]];
  }
  EXPECT_GT(seen[0], 0);
  EXPECT_GT(seen[1], 0);
  for (const auto& entry : fs::directory_iterator(folder_ / ""))
    EXPECT_TRUE(entry.path().extension() != ".part" ||
                entry.path().filename().string().starts_with(".target.brep."));
}

}  // namespace
}  // namespace seamwright::test
