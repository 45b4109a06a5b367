// SPDX-License-Identifier: LGPL-2.1-or-later
// Lengths are in mm whatever the unit of the file; a unit that is not understood is an error and no
// guess.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "files.hpp"
#include "shapes.hpp"

namespace seamwright::test {
namespace {

using occ::ModelErrc;
using ::testing::HasSubstr;

/// Lengths of the edges, to a millionth of a mm.
std::multiset<long> edgeLengths(const occ::Model& model) {
  std::multiset<long> lengths;
  for (const occ::SeamResult& seam : occ::analyze(model).seams)
    lengths.insert(std::lround(seam.length_mm * 1e6));
  return lengths;
}

const std::multiset<long>& boxLengths() {
  static const std::multiset<long> lengths = {10000000, 10000000, 10000000, 10000000,
                                              20000000, 20000000, 20000000, 20000000,
                                              30000000, 30000000, 30000000, 30000000};
  return lengths;
}

TEST(Units, TheSameBoxInEveryUnitOfStep) {
  const Folder folder;
  for (const char* unit : {"MM", "INCH", "M", "CM", "FT", "UM"}) {
    writeStep(box(), folder / "box.step", unit);
    const occ::Model model = occ::readModel(folder / "box.step");
    EXPECT_EQ(edgeLengths(model), boxLengths()) << unit << " " << model.length_unit;
  }
  writeStep(box(), folder / "box.step", "MM");
}

TEST(Units, TheSameBoxInEveryUnitOfIges) {
  const Folder folder;
  for (const char* unit : {"MM", "INCH", "M", "CM", "FT"}) {
    writeIges(box(), folder / "box.igs", unit);
    const occ::Model model = occ::readModel(folder / "box.igs");
    EXPECT_EQ(edgeLengths(model), boxLengths()) << unit;
    EXPECT_THAT(model.length_unit, ::testing::Not(::testing::IsEmpty()));
  }
}

TEST(Units, TheUnitOfTheFileIsTold) {
  const Folder folder;
  writeStep(box(), folder / "inch.step", "INCH");
  EXPECT_EQ(occ::readModel(folder / "inch.step").length_unit, "INCH");
  writeStep(box(), folder / "m.step", "M");
  EXPECT_EQ(occ::readModel(folder / "m.step").length_unit, "metre");
  writeStep(box(), folder / "mm.step", "MM");
  EXPECT_EQ(occ::readModel(folder / "mm.step").length_unit, "millimetre");
  writeBrep(box(), folder / "box.brep");
  EXPECT_THAT(occ::readModel(folder / "box.brep").length_unit, HasSubstr("assumed"));
}

/// The text of a STEP file of a box in mm with its length unit replaced.
std::string withUnit(const Folder& folder, const std::string& unit) {
  writeStep(box(), folder / "box.step");
  return replaced(contentOf(folder / "box.step"), "SI_UNIT(.MILLI.,.METRE.)", unit);
}

/// Other programs than OpenCASCADE state units so: SI units with prefix or none, and units that are
/// a multiple of another one, under any name.
TEST(Units, OfOtherProgramsScaleTheModel) {
  const Folder folder;
  struct Case {
    const char* unit;
    double mm;
  };
  for (const Case& each : {Case{"SI_UNIT($,.METRE.)", 1000}, Case{"SI_UNIT(.CENTI.,.METRE.)", 10},
                           Case{"SI_UNIT(.MICRO.,.METRE.)", 0.001}}) {
    setContent(folder / "box.step", withUnit(folder, each.unit));
    std::multiset<long> expected;
    for (const long length : boxLengths())
      expected.insert(std::lround(static_cast<double>(length) * each.mm));
    EXPECT_EQ(edgeLengths(occ::readModel(folder / "box.step")), expected) << each.unit;
  }
  for (const char* name : {"INCH", "inch", "Zoll"}) {
    const std::string multiple = std::string("CONVERSION_BASED_UNIT('") + name + "',#99998)";
    std::string text = withUnit(folder, multiple);
    const std::regex old(R"(\(\s*LENGTH_UNIT\(\)\s*NAMED_UNIT\(\*\)\s*CONVERSION[^)]*\)\s*\))");
    ASSERT_TRUE(std::regex_search(text, old));
    text = std::regex_replace(text, old, "( " + multiple + " LENGTH_UNIT() NAMED_UNIT(#99997) )");
    text = replaced(
        text, "ENDSEC;\nEND-ISO",
        "#99996 = ( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) );\n"
        "#99997 = DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n"
        "#99998 = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#99996);\nENDSEC;\nEND-ISO");
    setContent(folder / "inch.step", text);
    std::multiset<long> expected;
    for (const long length : boxLengths()) expected.insert(length / 10 * 254);
    EXPECT_EQ(edgeLengths(occ::readModel(folder / "inch.step")), expected) << name;
  }
}

TEST(Units, StepUnitsThatAreNotUnderstood) {
  const Folder folder;
  for (const char* unit :
       {"SI_UNIT($,.GRAM.)", "SI_UNIT(.MILLI.,.SECOND.)", "SI_UNIT(.MILLI.,.FURLONG.)"}) {
    setContent(folder / "odd.step", withUnit(folder, unit));
    const occ::ModelError error = errorOf(folder / "odd.step");
    EXPECT_EQ(error.code(), ModelErrc::UnknownUnits) << unit << ": " << error.what();
    EXPECT_THAT(error.what(), HasSubstr("unit"));
  }
}

TEST(Units, StepWithoutALengthUnit) {
  const Folder folder;
  writeStep(box(), folder / "box.step");
  std::string text = contentOf(folder / "box.step");
  const std::regex entity(R"(#\d+\s*=\s*\(\s*LENGTH_UNIT\(\)[^;]*;)");
  ASSERT_TRUE(std::regex_search(text, entity));
  text = std::regex_replace(text, entity, "");
  setContent(folder / "none.step", text);
  EXPECT_EQ(errorOf(folder / "none.step").code(), ModelErrc::UnknownUnits);
}

TEST(Units, AUnitThatNobodyUsesIsNoUnitOfTheModel) {
  const Folder folder;
  std::string text = withUnit(folder, "SI_UNIT($,.GRAM.)");
  text = replaced(
      text, "ENDSEC;\nEND-ISO",
      "#99999 = ( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) );\nENDSEC;\nEND-ISO");
  setContent(folder / "stray.step", text);
  EXPECT_EQ(errorOf(folder / "stray.step").code(), ModelErrc::UnknownUnits);
}

/// The global section with unit flag \p flag and name \p name, lines and the T record left as they
/// are in length.
std::string igesWithUnit(const std::string& text, const std::string& flag_and_name) {
  // OpenCASCADE writes ",2,2HMM," for millimetres; the replacement is padded to the same length.
  const std::string old = ",2,2HMM,";
  if (flag_and_name.size() != old.size()) throw std::runtime_error("the record would shift");
  return replaced(text, old, flag_and_name);
}

TEST(Units, IgesUnitFlagsThatAreNotDefined) {
  const Folder folder;
  writeIges(box(), folder / "box.igs");
  const std::string text = contentOf(folder / "box.igs");
  for (const char* unit : {",99,1HX,", ",3,2HZZ,", ",0,2HQQ,", ",-1,1HX,"}) {
    setContent(folder / "odd.igs", igesWithUnit(text, unit));
    const occ::ModelError error = errorOf(folder / "odd.igs");
    EXPECT_EQ(error.code(), ModelErrc::UnknownUnits) << unit << ": " << error.what();
  }
}

}  // namespace
}  // namespace seamwright::test
