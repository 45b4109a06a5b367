// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers that can't be computed with, in files of each format and in shapes from memory: an error
// in one line, or a note and the rest of the model; never a crash, and an end soon.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <chrono>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <regex>

#include <seamwright/occ_adapter/fill/fill.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/repair/repair.hpp>

#include "files.hpp"
#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::Model;
using occ::ModelErrc;
using occ::readModel;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

TopoDS_Shape roundedBox() {
  const TopoDS_Shape sharp = box();
  BRepFilletAPI_MakeFillet fillet(sharp);
  fillet.Add(2, TopoDS::Edge(partsOf(sharp, TopAbs_EDGE)(1)));
  return fillet.Shape();
}

/// Every number of each line that describes a curve or a surface replaced.
std::string withNumbersOfGeometry(const std::string& brep, const std::string& number) {
  std::istringstream lines(brep);
  std::string result;
  bool geometry = false;
  static const std::regex heading("(Curve2ds|Curves|Surfaces) [0-9]+");
  static const std::regex other_heading("[A-Z][A-Za-z0-9]+ [0-9]+");
  static const std::regex numbers(" -?[0-9.e+-]+");
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, heading))
      geometry = true;
    else if (std::regex_match(line, other_heading))
      geometry = false;
    else if (geometry)
      line = std::regex_replace(line, numbers, " " + number);
    result += line + "\n";
  }
  return result;
}

TEST(UnusableNumbers, AFileOfThemIsAnErrorInOneLine) {
  const Folder folder;
  for (const TopoDS_Shape& shape : {box(), BRepPrimAPI_MakeCylinder(3, 8).Shape()})
    for (const char* number : {"inf", "nan", "1e300"}) {
      SCOPED_TRACE(number);
      writeBrep(shape, folder / "shape.brep");
      setContent(folder / "shape.brep",
                 withNumbersOfGeometry(contentOf(folder / "shape.brep"), number));
      const occ::ModelError error = errorOf(folder / "shape.brep");
      EXPECT_EQ(error.code(), ModelErrc::Malformed) << error.what();
      EXPECT_THAT(std::string(error.what()), Not(HasSubstr("\n")));
    }
}

TEST(UnusableNumbers, AFileThatHasOneKeepsItsOtherFaces) {
  const Folder folder;
  writeBrep(box(), folder / "box.brep");
  // A box has its corners at 0, 10, 20, 30: one of eight vertices ends three edges.
  setContent(folder / "box.brep",
             replaced(contentOf(folder / "box.brep"), "\n0 0 30\n", "\n0 nan 30\n"));
  const Model model = readModel(folder / "box.brep");
  ASSERT_EQ(model.notes.size(), 1u);
  EXPECT_THAT(model.notes[0], HasSubstr("3 edges hold numbers"));
  EXPECT_THAT(model.notes[0], HasSubstr("a vertex with the number nan"));
  const occ::Report report = occ::analyze(model);
  EXPECT_EQ(report.model.notes, model.notes);
  ASSERT_EQ(report.seams.size(), 12u);
  EXPECT_EQ(std::ranges::count_if(report.seams,
                                  [](const occ::SeamResult& seam) {
                                    return seam.note.find("not measured: edge") !=
                                           std::string::npos;
                                  }),
            3);
}

using Damage = std::function<void(const TopoDS_Shape&)>;

/// Gives the circles of the edges a radius.
Damage circlesOf(double radius) {
  return [radius](const TopoDS_Shape& shape) {
    for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next()) {
      double first = 0, last = 0;
      const auto curve = BRep_Tool::Curve(TopoDS::Edge(it.Current()), first, last);
      if (const auto circle = opencascade::handle<Geom_Circle>::DownCast(curve); !circle.IsNull())
        circle->SetRadius(radius);
    }
  };
}

Damage cylindersOf(double radius) {
  return [radius](const TopoDS_Shape& shape) {
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
      if (const auto surface = opencascade::handle<Geom_CylindricalSurface>::DownCast(
              BRep_Tool::Surface(TopoDS::Face(it.Current())));
          !surface.IsNull())
        surface->SetRadius(radius);
  };
}

TEST(UnusableNumbers, ShapesFromMemoryAreAnalysedWithoutThem) {
  for (const double number : {infinity, no_number, 1e300})
    for (const Damage& damage : {circlesOf(number), cylindersOf(number)}) {
      SCOPED_TRACE(number);
      const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(3, 8).Shape();
      damage(shape);
      const Model model = occ::modelFromShape(shape);
      ASSERT_EQ(model.notes.size(), 1u);
      const occ::Report report = occ::analyze(model, {.tolerance = {}, .match_mm = 0.1});
      EXPECT_EQ(report.seams.size(), 3u);
      EXPECT_FALSE(report.passed());
      for (const occ::SeamResult& seam : report.seams)
        EXPECT_EQ(seam.figures.gap_mm.has_value(), seam.note.empty()) << describe(seam);
      EXPECT_LT(report.analyze_s, 5);
    }
}

TEST(UnusableNumbers, AShapeOfThemIsRefused) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeSphere(3).Shape();
  const TopoDS_Face face = TopoDS::Face(TopExp_Explorer(shape, TopAbs_FACE).Current());
  gp_Trsf far;
  far.SetTranslation(gp_Vec(infinity, 0, 0));
  EXPECT_THROW(occ::modelFromShape(located(face, far)), occ::ModelError);
}

TEST(UnusableNumbers, AreNotRepairedAndNotFilled) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(3, 8).Shape();
  circlesOf(infinity)(shape);
  const Model model = occ::modelFromShape(shape);
  const occ::RepairReport repaired = occ::repair(model);
  EXPECT_FALSE(repaired.changed());
  EXPECT_TRUE(repaired.model.shape.IsSame(shape));
  EXPECT_EQ(repaired.before.model.notes, model.notes);
  const auto told = std::ranges::count_if(repaired.seams, [](const occ::SeamRepair& seam) {
    return seam.reason.text.find("the number inf") != std::string::npos;
  });
  EXPECT_EQ(told, 2) << "both circles";
  const occ::FillHoleReport filled = occ::replaceFace(model, 2);
  EXPECT_FALSE(filled.filled);
  EXPECT_THAT(textOf(filled.reason), HasSubstr("the number inf"));
  EXPECT_TRUE(filled.model.shape.IsSame(shape));
}

TEST(UnusableNumbers, SoundShapesHaveNone) {
  // A sphere has edges without a curve, at its poles.
  for (const TopoDS_Shape& shape :
       {box(), BRepPrimAPI_MakeSphere(3).Shape(), planeAndCylinder(3, 10),
        BRepBuilderAPI_NurbsConvert(box(), true).Shape()})
    EXPECT_TRUE(occ::UnusableParts(shape).empty()) << occ::UnusableParts(shape).note();
}

/// A number of a text replaced by one of \p by, chosen by \p random.
std::string withOneNumber(const std::string& text, std::size_t start, const std::regex& number,
                          const std::vector<std::string>& by, std::mt19937& random) {
  std::vector<std::pair<std::size_t, std::size_t>> spans;
  for (std::sregex_iterator
           it(text.begin() + static_cast<std::ptrdiff_t>(start), text.end(), number),
       end;
       it != end; ++it)
    spans.emplace_back(start + static_cast<std::size_t>(it->position(1)), it->length(1));
  const auto [at, length] =
      spans.at(std::uniform_int_distribution<std::size_t>(0, spans.size() - 1)(random));
  std::string value = by[std::uniform_int_distribution<std::size_t>(0, by.size() - 1)(random)];
  return std::string(text).replace(at, length, value);
}

/// One of the numbers of eight bytes that have a plausible size.
std::string withOneDouble(std::string bytes, std::mt19937& random) {
  const std::vector<double> by = {infinity, -infinity, no_number, 1e300, 1e99, -0.0, 5e-324, -1};
  std::uniform_int_distribution<std::size_t> position(100, bytes.size() - sizeof(double));
  for (;;) {
    const std::size_t at = position(random);
    double value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    if (!(std::abs(value) > 1e-9 && std::abs(value) < 1e6)) continue;
    value = by[std::uniform_int_distribution<std::size_t>(0, by.size() - 1)(random)];
    std::memcpy(bytes.data() + at, &value, sizeof value);
    return bytes;
  }
}

/// In IGES a value takes the place of as many characters.
std::string withOneIgesNumber(const std::string& text, std::mt19937& random) {
  const std::vector<std::string> by = {"inf", "nan", "1E300", "1E999", "-0.", "5E-324", "-1."};
  static const std::regex number(",(-?[0-9]+\\.[0-9E+-]*)(?=[,;])");
  for (;;) {
    std::string value = by[std::uniform_int_distribution<std::size_t>(0, by.size() - 1)(random)];
    const std::size_t start = text.find("D      1");
    std::string changed =
        withOneNumber(text, start, number, {value + std::string(80, '#')}, random);
    const std::size_t mark = changed.find('#');
    const std::size_t length = text.size() - (changed.size() - value.size() - 80);
    if (value.size() > length) continue;
    return changed.replace(mark, 80, std::string(length - value.size(), ' '));
  }
}

/// Reads and analyses. \returns whether there was a report
bool survives(const std::filesystem::path& path) {
  try {
    const Model model = readModel(path);
    const occ::Report report = occ::analyze(model, {.tolerance = {}, .match_mm = 0.1});
    return true;
  } catch (const occ::ModelError& error) {
    EXPECT_THAT(std::string(error.what()), Not(HasSubstr("\n")));
  } catch (
      const std::invalid_argument& error) {  // coordinates so large that a tolerance is rounding
    EXPECT_THAT(error.what(), HasSubstr("rounding"));
  }
  return false;
}

TEST(UnusableNumbers, OneInAnyPlaceOfAnyFormatIsSurvived) {
  const Environment time("SEAMWRIGHT_READER_SECONDS",
                         "2");  // some make OpenCASCADE search without an end
  const std::vector<std::string> by = {"inf",    "nan", "1e300", "1e99", "-0",
                                       "5e-324", "0",   "-1",    "7",    "999999999"};
  const std::vector<std::string> step_by = {"inf", "nan",     "1.E300", "1.E999",
                                            "-0.", "5.E-324", "0.",     "-1."};
  static const std::regex brep_number("[ \n](-?[0-9]+(\\.[0-9]+)?(e[+-]?[0-9]+)?)(?=[ \n])");
  static const std::regex step_number("[(,](-?[0-9]+\\.[0-9]*(E[+-]?[0-9]+)?)(?=[,)])");
  const Folder folder;
  std::mt19937 random(testSeed());
  int whole = 0, files = 0;
  for (const TopoDS_Shape& shape :
       {roundedBox(), BRepBuilderAPI_NurbsConvert(roundedBox(), true).Shape()}) {
    writeBrep(shape, folder / "shape.brep");
    writeBinaryBrep(shape, folder / "shape.bin");
    writeStep(shape, folder / "shape.step");
    writeIges(shape, folder / "shape.igs");
    const std::string brep = contentOf(folder / "shape.brep"),
                      binary = contentOf(folder / "shape.bin"),
                      step = contentOf(folder / "shape.step"),
                      iges = contentOf(folder / "shape.igs");
    for (int i = 0; i < 5; ++i) {
      const std::vector<std::string> contents = {
          withOneNumber(brep, brep.find("Locations"), brep_number, by, random),
          withOneDouble(binary, random),
          withOneNumber(step, step.find("DATA;"), step_number, step_by, random),
          withOneIgesNumber(iges, random)};
      for (const std::string& content : contents) {
        SCOPED_TRACE("file " + std::to_string(files++));
        setContent(folder / "changed", content);
        const auto start = std::chrono::steady_clock::now();
        whole += survives(folder / "changed");
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
      }
    }
  }
  EXPECT_GT(whole, files / 4);
}

}  // namespace
}  // namespace seamwright::test
