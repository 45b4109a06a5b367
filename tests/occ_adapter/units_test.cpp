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

TEST(Units, CubesOfOtherPrograms) {
  const auto inch = furtherModel("small/cube-units_cube-in.step"),
             metre = furtherModel("small/cube-units_cube-m.step");
  if (inch.empty() || metre.empty()) GTEST_SKIP() << "the models are not there";
  const std::multiset<long> a = edgeLengths(occ::readModel(inch)),
                            b = edgeLengths(occ::readModel(metre));
  EXPECT_EQ(a.size(), 12u);
  EXPECT_EQ(std::set<long>(a.begin(), a.end()).size(), 1u);
  EXPECT_EQ(std::set<long>(b.begin(), b.end()).size(), 1u);
}

/// The text of a STEP file of a box in mm with its length unit replaced.
std::string withUnit(const Folder& folder, const std::string& unit) {
  writeStep(box(), folder / "box.step");
  return replaced(contentOf(folder / "box.step"), "SI_UNIT(.MILLI.,.METRE.)", unit);
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
