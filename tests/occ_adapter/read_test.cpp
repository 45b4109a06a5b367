// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that can be read: formats told by content, names and colours, and what comes back equals
// what went in.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <GProp_GProps.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <sstream>

#include <seamwright/occ_adapter/model/format.hpp>

#include "broken_files.hpp"
#include "files.hpp"
#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::Format;
using occ::Model;
using occ::readModel;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

double areaOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.Mass();
}

constexpr double box_area = 2 * (10 * 20 + 20 * 30 + 30 * 10);

void writeFreeCadBinary(const TopoDS_Shape& shape, const std::filesystem::path& path) {
  std::ostringstream bytes;
  occ::writeBinaryShape(shape, bytes);
  setContent(path, bytes.str());
}

struct Kind {
  const char* name;
  Format format;
  void (*write)(const TopoDS_Shape&, const std::filesystem::path&);
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      {"STEP", Format::Step,
       [](const TopoDS_Shape& s, const std::filesystem::path& p) { writeStep(s, p); }},
      {"IGES", Format::Iges,
       [](const TopoDS_Shape& s, const std::filesystem::path& p) { writeIges(s, p); }},
      {"BREP", Format::BrepText, writeBrep},
      {"binary BREP", Format::BrepBinary, writeBinaryBrep},
      {"binary BREP", Format::BrepBinary, writeFreeCadBinary}};
  return all;
}

TEST(Read, EveryFormatUnderEveryName) {
  const Folder folder;
  for (const Kind& kind : kinds())
    for (const char* name :
         {"a.step", "a.stp", "a.iges", "a.igs", "a.brep", "a.brp", "a.bin", "a"}) {
      SCOPED_TRACE(std::string(kind.name) + " as " + name);
      kind.write(box(), folder / name);
      EXPECT_EQ(occ::detectFormat(folder / name), kind.format);
      const Model model = readModel(folder / name);
      EXPECT_EQ(model.format, kind.name);
      EXPECT_EQ(model.path, (folder / name).string());
      EXPECT_EQ(model.faceCount(), 6);
      EXPECT_EQ(model.edgeCount(), 12);
      EXPECT_NEAR(areaOf(model.shape), box_area, 1e-9 * box_area);
      EXPECT_THAT(model.notes, IsEmpty());
    }
}

TEST(Read, LocationsAndOrientationsComeThrough) {
  const Folder folder;
  std::mt19937 random(testSeed());
  const TopoDS_Shape moved = located(BRepPrimAPI_MakeCylinder(3, 8).Shape(), randomMotion(random));
  for (const Kind& kind : kinds()) {
    SCOPED_TRACE(kind.name);
    kind.write(moved, folder / "moved");
    const Model model = readModel(folder / "moved");
    GProp_GProps expected, found;
    BRepGProp::VolumeProperties(moved, expected);
    BRepGProp::VolumeProperties(model.shape, found);
    EXPECT_NEAR(found.Mass(), expected.Mass(), 1e-6);
    EXPECT_LT(found.CentreOfMass().Distance(expected.CentreOfMass()), 1e-6);
  }
}

TEST(Read, BinaryShapesAreExactInEveryBit) {
  // Of B-splines; axes of planes and cylinders OpenCASCADE makes unit vectors once more, which may
  // move their last bit.
  std::mt19937 random(testSeed());
  const TopoDS_Shape turned =
      transformed(BRepPrimAPI_MakeCylinder(3, 8).Shape(), randomMotion(random));
  const TopoDS_Shape shape = BRepBuilderAPI_NurbsConvert(turned, true).Shape().Reversed();
  std::stringstream once, twice;
  occ::writeBinaryShape(shape, once);
  const TopoDS_Shape back = occ::readBinaryShape(once);
  occ::writeBinaryShape(back, twice);
  EXPECT_EQ(once.str(), twice.str());
  EXPECT_EQ(back.Orientation(), shape.Orientation());
}

TEST(Read, BinaryShapesKeepTheirLocation) {
  std::mt19937 random(testSeed());
  const TopoDS_Shape shape = located(box(), randomMotion(random));
  std::stringstream bytes;
  occ::writeBinaryShape(shape, bytes);
  const gp_Trsf before = shape.Location().Transformation();
  const gp_Trsf after = occ::readBinaryShape(bytes).Location().Transformation();
  // OpenCASCADE makes the matrix orthogonal once more when it reads it.
  for (int row = 1; row <= 3; ++row)
    for (int column = 1; column <= 4; ++column)
      EXPECT_NEAR(after.Value(row, column), before.Value(row, column), column == 4 ? 1e-13 : 1e-15);
}

TEST(Read, TextShapesKeepTheirFaces) {
  std::stringstream text;
  occ::writeTextShape(box(), text);
  const TopoDS_Shape back = occ::readTextShape(text);
  EXPECT_EQ(occ::modelFromShape(back).faceCount(), 6);
  EXPECT_NEAR(areaOf(back), box_area, 1e-9);
}

TEST(Read, StreamsWithoutAShapeGiveANullShape) {
  for (const char* content : {"", "nonsense", "Open CASCADE Topology V3 (c)\n"}) {
    std::istringstream stream(content);
    try {
      EXPECT_TRUE(occ::readBinaryShape(stream).IsNull());
    } catch (const std::exception&) {
    } catch (...) {  // OpenCASCADE's own failure is not a std::exception
    }
  }
}

constexpr const char* block_name = "Bl\u00f6ck";

/// Two parts with names and colours, one of them twice, one face with a colour of its own.
void writeColoured(const std::filesystem::path& path) {
  const opencascade::handle<TDocStd_Document> document = new TDocStd_Document("BinXCAF");
  const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const auto colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
  const TopoDS_Shape block = box();
  const TDF_Label label = shapes->AddShape(block, false);
  TDataStd_Name::Set(label, TCollection_ExtendedString(block_name, true));
  colors->SetColor(label, Quantity_Color(0.25, 0.5, 0.75, Quantity_TOC_RGB), XCAFDoc_ColorSurf);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(block, TopAbs_FACE, faces);
  const TDF_Label face = shapes->AddSubShape(label, faces(3));
  TDataStd_Name::Set(face, "lid");
  colors->SetColor(face, Quantity_Color(1, 0, 0, Quantity_TOC_RGB), XCAFDoc_ColorSurf);
  const TDF_Label rod = shapes->AddShape(BRepPrimAPI_MakeCylinder(2, 9).Shape(), false);
  TDataStd_Name::Set(rod, "rod");
  STEPCAFControl_Writer writer;
  writer.SetNameMode(true);
  writer.SetColorMode(true);
  if (!writer.Transfer(document, STEPControl_AsIs) ||
      writer.Write(path.c_str()) != IFSelect_RetDone)
    throw std::runtime_error("not written");
}

const occ::ShapeAttribute* find(const Model& model, TopAbs_ShapeEnum kind,
                                const std::string& name) {
  const auto it = std::find_if(model.attributes.begin(), model.attributes.end(),
                               [&](const auto& a) { return a.kind == kind && a.name == name; });
  return it == model.attributes.end() ? nullptr : &*it;
}

std::string attributesOf(const Model& model) {
  std::ostringstream text;
  for (const occ::ShapeAttribute& a : model.attributes)
    text << a.kind << ' ' << a.index << " '" << a.name << "' " << (a.color ? "coloured\n" : "\n");
  return text.str();
}

TEST(Read, NamesAndColoursOfAStepFile) {
  const Folder folder;
  writeColoured(folder / "parts.step");
  const Model model = readModel(folder / "parts.step");
  SCOPED_TRACE(attributesOf(model));
  EXPECT_EQ(model.faceCount(), 6 + 3);
  const occ::ShapeAttribute* block = find(model, TopAbs_SOLID, block_name);
  ASSERT_NE(block, nullptr);
  ASSERT_TRUE(block->color);
  EXPECT_NEAR((*block->color)[0], 0.25, 1e-3);
  EXPECT_NEAR((*block->color)[1], 0.5, 1e-3);
  EXPECT_NEAR((*block->color)[2], 0.75, 1e-3);
  EXPECT_NE(find(model, TopAbs_SOLID, "rod"), nullptr);
  const auto red =
      std::find_if(model.attributes.begin(), model.attributes.end(), [](const auto& a) {
        return a.kind == TopAbs_FACE && a.color && (*a.color)[0] > 0.99 && (*a.color)[1] < 0.01;
      });
  ASSERT_NE(red, model.attributes.end());
  EXPECT_EQ(red->index, 3) << "numbered as the faces of the shape";
}

TEST(Read, ProgressRisesAndCanStop) {
  const Folder folder;
  writeStep(box(), folder / "box.step");
  double last = 0;
  readModel(folder / "box.step", [&](double share) {
    EXPECT_GE(share, last);
    EXPECT_LE(share, 1);
    last = share;
    return true;
  });
  EXPECT_THROW(readModel(folder / "box.step", [](double) { return false; }), occ::Cancelled);
}

TEST(Read, AFileThatLosesAFaceSaysSo) {
  const Folder folder;
  std::mt19937 random(testSeed());
  const std::string sound = blobStep(random);
  for (const std::string& step : {withDanglingReference(sound), withWrongDegree(sound)}) {
    setContent(folder / "lost.step", step);
    const Model model = readModel(folder / "lost.step");
    EXPECT_EQ(model.faceCount(), 5);
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_THAT(model.notes[0], HasSubstr("6 faces"));
    EXPECT_THAT(model.notes[0], HasSubstr("1 of them"));
  }
}

/// The lines of an IGES file with a parameter of the first entity of a type changed; parameters
/// count from 1.
std::string igesWithParameter(const std::string& iges, int type, int parameter,
                              const std::string& value) {
  std::vector<std::string> lines;
  std::istringstream text(iges);
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  const std::string start = std::to_string(type) + ",";
  for (std::string& line : lines) {
    if (line.size() < 80 || line[72] != 'P' || !line.starts_with(start)) continue;
    std::size_t begin = 0;
    for (int i = 0; i < parameter; ++i) begin = line.find(',', begin) + 1;
    const std::size_t end = line.find_first_of(",;", begin);
    std::string data = line.substr(0, begin) + value + line.substr(end, 64 - end);
    data.resize(64, ' ');
    line.replace(0, 64, data);
    std::string all;
    for (const std::string& each : lines) all += each + "\n";
    return all;
  }
  throw std::runtime_error("no entity of type " + std::to_string(type));
}

TEST(Read, AnIgesFileThatLosesAFaceSaysSo) {
  const Folder folder;
  struct Damage {
    int mode;  // of OpenCASCADE's writer: 0 trimmed surfaces, 1 solids with faces
    int type, parameter;
    const char* value;
    int named, lost;
  };
  const std::vector<Damage> damages = {
      {0, 144, 1, "0", 6, 1},      // a trimmed surface without its surface
      {0, 108, 3, "1E300", 6, 1},  // a plane far away
      {0, 108, 1, "x", 6, 1},      // a plane without a number
      {1, 510, 1, "0", 6 + 1, 1},  // a face without its surface, which then stands alone
  };
  for (const Damage& damage : damages) {
    SCOPED_TRACE(std::to_string(damage.type) + " " + damage.value);
    writeIges(box(), folder / "box.igs", "MM", damage.mode);
    EXPECT_THAT(readModel(folder / "box.igs").notes, IsEmpty());
    setContent(folder / "box.igs", igesWithParameter(contentOf(folder / "box.igs"), damage.type,
                                                     damage.parameter, damage.value));
    const Model model = readModel(folder / "box.igs");
    EXPECT_EQ(model.faceCount(), damage.named - damage.lost);
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_EQ(model.notes[0], "the file names " + std::to_string(damage.named) + " faces, " +
                                  std::to_string(damage.lost) + " of them could not be made");
  }
}

TEST(Read, SoundIgesFilesLoseNoFaces) {
  const Folder folder;
  const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(3, 8).Shape();
  for (const TopoDS_Shape& each : {shape, BRepBuilderAPI_NurbsConvert(shape, true).Shape()})
    for (const int mode : {0, 1}) {
      writeIges(each, folder / "sound.igs", "MM", mode);
      const Model model = readModel(folder / "sound.igs");
      EXPECT_EQ(model.faceCount(), 3);
      EXPECT_THAT(model.notes, IsEmpty());
    }
}

TEST(Read, ACoordinateThatIsNoNumberCostsItsOwnSeams) {
  const Folder folder;
  std::mt19937 random(testSeed());
  const std::string sound = blobStep(random);
  setContent(folder / "sound.step", sound);
  setContent(folder / "broken.step", withoutANumber(sound));
  const occ::Report broken = occ::analyze(readModel(folder / "broken.step")),
                    whole = occ::analyze(readModel(folder / "sound.step"));
  ASSERT_EQ(broken.seams.size(), whole.seams.size());
  std::size_t unlike = 0;
  for (std::size_t i = 0; i < whole.seams.size(); ++i) {
    const occ::SeamResult &a = broken.seams[i], &b = whole.seams[i];
    if (a.verdict.level == b.verdict.level) continue;
    ++unlike;
    EXPECT_FALSE(a.note.empty()) << describe(a);
  }
  EXPECT_GT(unlike, 0u);
  EXPECT_LE(unlike, 1u) << "the coordinate is that of one edge";
}

TEST(Read, BrokenFilesNeverCrash) {
  const Folder folder;
  std::mt19937 random(testSeed());
  int were_read = 0, refused = 0;
  for (const std::filesystem::path& path : brokenFiles(folder, random)) {
    try {
      const occ::Report report = occ::analyze(readModel(path));
      EXPECT_GT(report.model.faces, 0) << path;
      ++were_read;
    } catch (const occ::ModelError& error) {
      EXPECT_THAT(error.what(), HasSubstr(path.string()));
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      ++refused;
    }
  }
  EXPECT_GE(were_read, 3);
  EXPECT_GE(refused, 5);
}

}  // namespace
}  // namespace seamwright::test
